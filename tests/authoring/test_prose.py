"""Letters of mathematics in sentences are set: a matrix is $A$, and not A."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted([*ROOT.glob("solutions/ch*/p*.md"), *ROOT.glob("book/**/*.md")])
#: Code, formulas, roles, addresses, and names with initials.
EXCLUDED = [
    re.compile(pattern, re.M | re.S)
    for pattern in (
        r"^(`{3,})(?:\{code-\w+\}|\{math\}|\{live\}|\w*$).*?^\1`*[ \t]*$",
        r"(`+).*?\1",
        r"\$\$.*?\$\$|\$[^$]*\$",
        r"\]\([^)]*\)|<[^>]*>",
        r"\b[A-Z]\.\s(?:[A-Z][a-z]?\.\s)*(?=[A-ZŁ])",
    )
]
#: A capital inside a sentence, also the one that is a word at its beginning; the last letters of
#: the alphabet.
LETTER = re.compile(r"(?<=[a-z] )[A-HJ-Z](?![\w'’&+/-])|(?<=[a-z] )[w-z](?![\w'’&/-])|\b[xyu]\d\b")
#: Spectra in 4.17, a condition, keys of the keyboard, a choice that the class of a lecturer has.
NAMES = {
    "solutions/ch4/p17.md": set("ABCDEF"),
    "book/ch5/example_circle.md": {"C"},
    "book/guides/lecturer.md": set("AB"),
}


def letters(text, name=""):
    """Yield (position, letter) of the letters of mathematics that are not set."""
    for pattern in EXCLUDED:
        text = pattern.sub(lambda match: re.sub("[^\n]", "¤", match[0]), text)
    for match in LETTER.finditer(text):
        if match[0] not in NAMES.get(name, ()):
            yield match.start(), match[0]


def test_letters_of_mathematics_are_typeset(lint):
    assert len(PAGES) > 300
    assert lint(letters, PAGES) == []


@pytest.mark.parametrize(
    "text, found",
    [
        ("the eigenvectors of A as rows", ["A"]),
        ("From x to y.", ["x", "y"]),
        ("the rate of x1", ["x1"]),
        ("of $A$ and `K`, of A. V. Kirgetov", []),
        ("It moves. A body falls; a vector I know", []),
    ],
)
def test_letters_of_mathematics_are_recognised(text, found):
    assert [letter for _, letter in letters(text)] == found
