"""Every problem has the section of the problem book; references to it have one form."""

import re
from pathlib import Path

SOLUTIONS = Path(__file__).resolve().parents[2] / "solutions"
BOOK = SOLUTIONS.parent / "book"
#: The first problem of each section, as the book counts them.
FIRST = {
    1: (1, 14),
    2: (1, 3, 8, 16, 18, 28),
    3: (1, 9, 17),
    4: (5, 10, 15, 22, 33),
    5: (1, 14, 46, 63),
}
#: These stand in the text of the chapter, before its first section.
BEFORE_SECTIONS = {"4.1", "4.2", "4.3", "4.4"}
#: The numbers after the last one of a chapter are problems of our own.
LAST = {3: 26}


def test_sections_are_those_of_the_book(masters):
    wrong = {}
    for master in masters:
        chapter, number = map(int, master.number.split("."))
        if chapter in FIRST and master.number not in BEFORE_SECTIONS:
            section = f"§{chapter}.{sum(first <= number for first in FIRST[chapter])}"
            section = "added" if number > LAST.get(chapter, number) else section
            if master.section != section:
                wrong[master.number] = (master.section, section)
    assert not wrong


def test_references_do_not_repeat_the_word_problem(lint):
    """{problem}`5.57` is set as "problem 5.57"."""
    pages = [path for root in (SOLUTIONS, BOOK) for path in sorted(root.rglob("*.md"))]
    repeated = re.compile(r"[Pp]roblems? \{problem\}.*")
    assert len(pages) > 300
    assert lint(lambda text, _: ((m.start(), m[0]) for m in repeated.finditer(text)), pages) == []


def test_equations_are_numbered_by_letters(lint):
    """The label eq-5-34-meeting would be read as equation (5.34meeting)."""
    pages, label = sorted(SOLUTIONS.glob("ch*/p*.md")), re.compile(r"\beq-\d+-\d+-(\w+)")
    labels = lint(lambda text, _: ((m.start(), m[1]) for m in label.finditer(text)), pages)
    assert len(labels) > 100
    assert [found for found in labels if len(found.rpartition(" ")[2]) > 1] == []
