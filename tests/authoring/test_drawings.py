"""The drawings of the statements: letters fit and do not overlap, symbols are in the text."""

import functools
import re
from itertools import combinations
from pathlib import Path

import pytest

from workbook.authoring import master_paths, read_master

pytestmark = pytest.mark.slow
ROOT = Path(__file__).resolve().parents[2]
#: Seen in the text: to read all masters would take every process of the tests seconds before its
#: first one.
DRAWN = [
    path
    for path in master_paths(ROOT / "solutions")
    if "\n:tags: [drawing" in path.read_text(encoding="utf-8")
]
read_cached = functools.cache(read_master)


def drawings(master):
    for source in master.code("drawing"):
        names = {}
        exec(source, names)
        yield names["d"]


def labels(drawing):
    """The texts of a drawing with their boxes on the sheet, in points."""
    figure = drawing._figure
    figure.draw_without_rendering()
    return [
        (text.get_text(), text.get_window_extent())
        for text in figure.axes[0].texts
        if text.get_text()
    ]


@pytest.fixture(params=DRAWN, ids=lambda path: f"{path.parent.name[2:]}.{int(path.stem[1:])}")
def master(request):
    return read_cached(request.param)


def test_texts_are_on_the_sheet_and_do_not_overlap(master):
    for drawing in drawings(master):
        texts, sheet = labels(drawing), drawing._figure.bbox
        assert texts
        for text, box in texts:
            assert box.x0 >= 0 and box.y0 >= 0 and box.x1 <= sheet.x1 and box.y1 <= sheet.y1, (
                f"{text} is cut off"
            )
        for (text, box), (other, its_box) in combinations(texts, 2):
            assert not box.overlaps(its_box), f"{text} is printed over {other}"


def test_drawings_are_legible_on_a_phone(master):
    """On 390 px the column has 314: of 4.6 inches, 442 px, letters of 13 points keep 9."""
    for drawing in drawings(master):
        assert drawing._figure.get_figwidth() <= 4.6


def test_every_symbol_is_in_the_statement(master):
    statement = "\n".join(cell.source for cell in master.cells if not cell.role)
    statement = without_spaces(statement[: statement.index("{solution-start}")])
    for drawing in drawings(master):
        for text, _ in labels(drawing):
            for formula in re.findall(r"\$(.+?)\$", text):
                for symbol in re.split(r"[=,()]", formula):
                    assert without_spaces(symbol) in statement, f"{symbol} is not in the statement"


def without_spaces(text):
    """Formulas without what does not change their meaning: spaces and braces."""
    return re.sub(r"\\[,;!]|[\s{}]", "", text)
