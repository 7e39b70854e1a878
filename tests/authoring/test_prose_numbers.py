"""Decimals in the prose of theory and solutions are executed: in a cell of the page, or as a formula here."""

import math
import re
import sys
import tomllib
from pathlib import Path

import pytest
from scipy import integrate, optimize

sys.path.insert(0, str(Path(__file__).parent))
from test_captions import CELL, REFERENCE, ROOT

PAGES = sorted(
    path
    for pattern in ("book/ch[1-5]/*.md", "solutions/ch[1-5]/p*.md")
    for path in ROOT.glob(pattern)
)
#: Numbers of two digits or more behind the point; shorter ones are often exact.
LONG = re.compile(r"(?<![\w.])\d+\.\d\d+(?![\w.]*\d)")
STATEMENT = re.compile(r"\{exercise-start\}.*?\{exercise-end\}", re.S)
#: Numbers of equations, definitions and problems, beside those of captions.
NUMBER_OF = re.compile(r"\\tag\{[^}]*\}|\{prf:\w+\} [\d.]+|T_\{[\d.]+\}|\[[\w\s]*\d\.\d+(?=\]\()")
ACCEPTED = tomllib.loads(Path(__file__).with_name("prose_numbers.toml").read_text(encoding="utf-8"))
#: In the place of a formula: the number is in the output of a cell, which a test of the built site compares.
PRINTED = "printed"
NAMES = vars(math) | {
    "root": optimize.brentq,
    "minimum": lambda f, a, b: optimize.minimize_scalar(f, bounds=(a, b)).fun,
    "integral": lambda f, a, b: integrate.quad(f, a, b)[0],
}


def unsupported(text):
    """Return the decimals in the prose of a page that are neither in a cell nor in the statement."""
    text = text.partition("\n---\n")[2] or text
    known = [match[0] for pattern in (CELL, STATEMENT) for match in pattern.finditer(text)]
    code = set(re.findall(r"\d+\.\d+", "\n".join(known)))
    prose = CELL.sub("", STATEMENT.sub("", text))
    return set(LONG.findall(REFERENCE.sub("", NUMBER_OF.sub("", prose)))) - code


def test_decimals_in_prose_are_executed():
    found = {
        page.relative_to(ROOT).as_posix(): numbers
        for page in PAGES
        if (numbers := unsupported(page.read_text(encoding="utf-8")))
    }
    assert found == {
        page: {name for name in numbers if name[0].isdigit()} for page, numbers in ACCEPTED.items()
    }


@pytest.mark.parametrize("page", ACCEPTED)
def test_formulas_have_these_values(page):
    names, numbers = dict(NAMES), ACCEPTED[page]
    for name in sorted(numbers, key=lambda name: (name[0].isdigit(), name == "w")):
        try:
            code = compile(numbers[name], name, "eval")
        except SyntaxError:  # a sentence
            continue
        if numbers[name] == PRINTED:
            continue
        value = eval(code, names)
        if name[0].isdigit():
            assert f"{value:.{len(name.partition('.')[2])}f}" == name, f"{name}: {value}"
        else:
            names[name] = value


def test_an_unsupported_decimal_is_recognised():
    page = (
        "Then $x = 0.25$ and $y = 0.125$ by [Problem 2.30](#ex-2-30), \\tag{5.11}\n"
        "```{code-cell}\ny = 0.125\n```\n"
    )
    assert unsupported(page) == {"0.25"}
