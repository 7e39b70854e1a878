"""What the workbook's site adds to Jupyter Book and to `workbook.site`, the pages of its problems.

built_files       the wheel, the book as PDF and the packed site, to be downloaded
chapter_map       a chapter's page and its sidebar: sections with a picture and their problems
self_tests        questions inside the theory, with the same boxes
progress_page     the reader's own progress, "Where am I?"
routes            ways through the course as tables, and the map of the sections
punctuation       a comma stays with the formula before it
numbering         numbers of equations and theorems follow their labels
library           the pages of the library, by autodoc and numpydoc (`docstrings`)
uses              links between the names of the library and the pages that use them
tiles             pages with their titles and pictures, for the front page
printed_book      marks and folds with remarks on the printed book
lectures          blocks that only the notebook of a lecture shows
check_cases       answers that checks accept and reject, from the tables that are their tests
control_problems  test problems of optimal control, from the records that are their tests
search_index      the entries of the search, read by book/_static/search.js
invalidation      what makes a page outdated, beyond its own text
errata            entries on problems are cut in the student edition
slim_environment  less of each page is kept from one build to the next
offline           nothing is loaded from another host
"""

import gc

from workbook.grading.sandbox.preloading import GC_THRESHOLD
from workbook_site import (
    built_files,
    chapter_map,
    check_cases,
    control_problems,
    errata,
    invalidation,
    lectures,
    library,
    numbering,
    offline,
    printed_book,
    progress_page,
    punctuation,
    routes,
    search_index,
    self_tests,
    slim_environment,
    tiles,
    uses,
)

EXTENSIONS = (
    built_files,
    chapter_map,
    control_problems,
    self_tests,
    progress_page,
    routes,
    punctuation,
    numbering,
    uses,
    library,
    lectures,
    printed_book,
    tiles,
    check_cases,
    search_index,
    errata,
    invalidation,
    slim_environment,
    offline,
)


def setup(app):
    # document trees live on: garbage collection in them takes a seventh of a build
    gc.set_threshold(GC_THRESHOLD)
    app.setup_extension("workbook.site")
    for extension in EXTENSIONS:
        extension.setup(app)
    return {
        "version": "1",
        "env_version": invalidation.EXTENSION,
        "parallel_read_safe": True,
        "parallel_write_safe": True,
    }
