"""What the workbook's site adds to Jupyter Book.

catalogue   the problems of the edition that is being built, from their front matter
pages       a problem's page: title, chips, download, answers and hints, labels that hold in both editions
listings    the list of all problems and the index by topic, so that no list is kept by hand
downloads   the students' notebooks and the wheel
boxes       statements; solutions, hints and code folded with the browser's own <details>
figures     pictures with their number, their caption and words for who cannot see them
printed     powers and products in what cells print
punctuation a comma stays with the formula before it
numbering   numbers of equations and theorems follow their labels
library     the pages of the library, from its docstrings (`docstrings`)
uses        links between the names of the library and the pages that use them
lectures    what only the notebook of a lecture shows
cases       the page of the checks, from the tables that are their tests
freshness   what makes a page outdated, beyond its own text
keeping     what is kept from one build to the next
offline     nothing is loaded from another host
"""

import gc

from workbook.grading.preloading import CONTAINERS
from workbook_site import (
    boxes,
    cases,
    catalogue,
    downloads,
    figures,
    freshness,
    keeping,
    lectures,
    library,
    listings,
    numbering,
    offline,
    pages,
    printed,
    punctuation,
    uses,
)


def setup(app):
    # trees of pages live on: to look for garbage in them takes a seventh of a build
    gc.set_threshold(CONTAINERS)
    for part in (
        catalogue,
        pages,
        listings,
        downloads,
        boxes,
        figures,
        printed,
        punctuation,
        numbering,
        uses,
        library,
        lectures,
        cases,
        freshness,
        keeping,
        offline,
    ):
        part.setup(app)
    return {
        "version": "1",
        "env_version": freshness.EXTENSION,
        "parallel_read_safe": True,
        "parallel_write_safe": True,
    }
