"""The theory can be read without the printed book: remarks on it are marks and folds.

On the pages of chapters 6 to 9 the sources are papers, whose printed figures are the subject.
"""

import re
from pathlib import Path

import pytest

BOOK = Path(__file__).resolve().parents[2] / "book"
PAGES = sorted([*BOOK.glob("ch[1-9].md"), *BOOK.glob("ch[1-9]/*.md")])
FOLD = re.compile(r"^:::\{fold\} Compared with the printed book\n.*?^:::$", re.M | re.S)
MARK = re.compile(r"\{printed\}`[^`]*`")
REMARK = re.compile(
    r"problem book|printed book|\b(?:our|the) (?:copy of the )?book(?:'s)?\b|\bin print\b|"
    r"\(added\)|\*added\*|^#+ Added|\*\(?Added|\[errata\]\(#",
    re.I | re.M,
)
#: Values that agree with those of a source are called "printed" there.
PRINTED = re.compile(r"\bprint(?:s|ed)?\b|misprint", re.I)
#: The page lists published values of test problems and says which of them are wrong.
ABOUT_PRINTS = {"test_problems.md"}


def remarks(text, papers=False):
    """Return what a page says of the printed book outside marks and folds."""
    text = MARK.sub("", FOLD.sub("", text))
    return REMARK.findall(text) + ([] if papers else PRINTED.findall(text))


def test_the_theory_does_not_speak_of_the_printed_book():
    found = {}
    for page in PAGES:
        papers = page.name in ABOUT_PRINTS or page.relative_to(BOOK).as_posix()[2] in "6789"
        if lines := remarks(page.read_text(encoding="utf-8"), papers):
            found[page.relative_to(BOOK).as_posix()] = lines
    assert len(PAGES) > 60
    assert found == {}


@pytest.mark.parametrize(
    "text, found",
    [
        ("The book prints $A(t)$.", ["The book", "prints"]),
        (":::{fold} Compared with the printed book\nThe book errs.\n:::\n", []),
        ("A {printed}`added` remark. {printed}`err-1-margin` It holds.", []),
        ("## Added: duality", ["## Added"]),
        ("see the [errata](#err-1-margin)", ["[errata](#"]),
        ("Material is added, and the notebook of the bookkeeper", []),
    ],
)
def test_remarks_are_recognised(text, found):
    assert remarks(text) == found
