"""What the workbook's site adds to Jupyter Book.

catalogue         the problems of the edition that is being built, from their front matter
problem_pages     a problem's page: title, chips, download, answers and hints, labels for both editions
listings          the list of all problems and the index by topic, made from the catalogue
chapter_map       a chapter's page and its sidebar: sections with a picture and their problems
downloads         the notebooks of students and tutorials, and the wheel
common_mistakes   wrong answers with their verdicts, folded after the checks of solved problems
answer_boxes      boxes for answers that are checked in the page
self_tests        questions inside the theory, with the same boxes
progress_page     the reader's own progress, "Where am I?"
routes            ways through the course as tables, and the map of the sections
folding           statements; solutions, hints and code folded with the browser's own <details>
figures           pictures with their number, their caption and alternative text
explorers         interactive figures: their script, once, on the pages that have one
cell_output       formulas typeset in what cells print
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
    answer_boxes,
    catalogue,
    cell_output,
    chapter_map,
    check_cases,
    common_mistakes,
    control_problems,
    downloads,
    errata,
    explorers,
    figures,
    folding,
    invalidation,
    lectures,
    library,
    listings,
    numbering,
    offline,
    printed_book,
    problem_pages,
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
    catalogue,
    problem_pages,
    listings,
    chapter_map,
    downloads,
    control_problems,
    common_mistakes,
    answer_boxes,
    self_tests,
    progress_page,
    routes,
    folding,
    figures,
    explorers,
    cell_output,
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
    for extension in EXTENSIONS:
        extension.setup(app)
    return {
        "version": "1",
        "env_version": invalidation.EXTENSION,
        "parallel_read_safe": True,
        "parallel_write_safe": True,
    }
