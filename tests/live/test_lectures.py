"""The lectures of book/lectures/: the cells of their notebooks, which run without errors."""

import nbformat
import pytest

from workbook.live import find_presentation, lectures
from workbook.live.explorers.by_name import NAMES
from workbook.live.lecture_notebook import lecture_notebook
from workbook.live.magics import is_lecture_magic
from workbook.live.polls import options
from workbook.live.worked_problem import WorkedProblem
from workbook.notebooks import exercises
from workbook.notebooks.cells import run_cells
from workbook.notebooks.execution import in_child

pytestmark = pytest.mark.slow
SLUGS = [lecture.name for lecture in lectures()]


@pytest.mark.parametrize("slug", SLUGS)
def test_a_lecture_becomes_slides_with_valid_magics(slug):
    presentation = find_presentation(slug)
    notebook = nbformat.from_dict(lecture_notebook(presentation))
    nbformat.validate(notebook)
    kinds = [cell.metadata.slideshow.slide_type for cell in notebook.cells]
    assert kinds[0] == "slide" and kinds.count("slide") >= 6
    assert all(
        cell.source.startswith("#") for cell, kind in zip(notebook.cells, kinds) if kind == "slide"
    )
    called = [cell.source.split() for cell in notebook.cells if is_lecture_magic(cell.source)]
    assert {magic for magic, *_ in called} >= {"%mistake", "%hint", "%answer"}
    for magic, first, *rest in called:
        if magic == "%explore":
            assert first in NAMES
        else:
            (name,) = rest
            assert first in presentation.problems and name in exercises.find(first).about["answers"]
    texts = "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")
    assert "{live}" not in texts and "{problem}" not in texts and "```" not in texts


@pytest.mark.parametrize("slug", SLUGS)
def test_a_lecture_runs_from_top_to_bottom(slug):
    cells = [
        cell["source"]
        for cell in lecture_notebook(find_presentation(slug))["cells"]
        if cell["cell_type"] == "code"
    ]
    ran = in_child(
        run_cells, [cell for cell in cells if not is_lecture_magic(cell)], [], timeout=120
    )
    assert ran["errors"] == []


def test_polls_of_lectures_have_options():
    called = {
        tuple(cell["source"].split()[1:3])
        for slug in SLUGS
        for cell in lecture_notebook(find_presentation(slug))["cells"]
        if cell["source"].startswith("%poll")
    }
    assert called
    for number, name in called:
        assert len(options(WorkedProblem(number), name)) >= 3, (number, name)


def test_a_lecture_is_found_by_its_nearest_name():
    with pytest.raises(ValueError, match="did you mean limit-cycles"):
        find_presentation("limit-cycle")
