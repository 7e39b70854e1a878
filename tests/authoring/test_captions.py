"""Decimals in captions are executed: a cell of the page has them as data, or asserts them."""

import math
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted(
    path
    for pattern in ("book/ch[1-9]/*.md", "book/lectures/*.md", "solutions/ch*/p*.md")
    for path in ROOT.glob(pattern)
)
CELL = re.compile(r"^(`{3,})\{code-cell\}.*?^\1$", re.M | re.S)
#: A paragraph in italics after a cell.
CAPTION = re.compile(r"^`{3,}\n(\*(?!\*)(?:.+\n)*?.*\*)$(?=\n\n|\n*\Z)", re.M)
#: Labels of links and numbers of statements, equations and problems are no values.
REFERENCE = re.compile(
    r"\{problem\}`[^`]*`|\]\([^)]*\)|\(\d\.\d+\w?\)|\b(?:Theorem|Problem|Figure)s? [\d.]+(?: and [\d.]+)?",
    re.I,
)
DECIMAL = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.]*\d)")
#: Values of formulas that stand in the caption or the cell; they are computed here.
FORMULAS = {
    "solutions/ch1/p01.md": {"0.27": 2 - math.sqrt(3)},
    "solutions/ch2/p30.md": {"0.7": 1.4 / 2},
    "solutions/ch4/p02.md": {"0.8": 3 - 2.2},
    "solutions/ch5/p06.md": {"0.3": 3 / 10},
    "solutions/ch5/p20.md": {"1.571": math.pi / 2, "1.273": 4 / math.pi},
    "solutions/ch5/p27.md": {"0.63": 4 ** (-1 / 3)},
}


def unsupported(text):
    """Return the decimals in the captions of a page that no cell contains."""
    code = set(re.findall(r"\d+\.\d+", "\n".join(cell[0] for cell in CELL.finditer(text))))
    captions = (REFERENCE.sub("", caption[1]) for caption in CAPTION.finditer(text))
    return {number for caption in captions for number in DECIMAL.findall(caption)} - code


def test_decimals_in_captions_are_executed():
    found = {
        page.relative_to(ROOT).as_posix(): numbers
        for page in PAGES
        if (numbers := unsupported(page.read_text(encoding="utf-8")))
    }
    assert sum(len(CAPTION.findall(page.read_text(encoding="utf-8"))) for page in PAGES) > 400
    assert found == {page: set(values) for page, values in FORMULAS.items()}


@pytest.mark.parametrize("page", FORMULAS)
def test_values_of_formulas_are_right(page):
    for number, value in FORMULAS[page].items():
        assert f"{value:.{len(number.partition('.')[2])}f}" == number


def test_an_unsupported_decimal_is_recognised():
    page = "```{code-cell}\nx = 0.5\n```\n*By (5.25) from $0.5$ to $0.27$, see {problem}`5.2`.*\n"
    assert unsupported(page) == {"0.27"}
