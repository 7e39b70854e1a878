"""A message on a wrong answer names the property that fails, not only that something differs."""

import ast
import re
from pathlib import Path

import pytest
from case import check_named
from case_tables import CASES

import workbook.checks

ROOT = Path(workbook.checks.__file__).parent
#: Predicates that only say that something else is right.
VAGUE = re.compile(
    r"\b(is|be|are|give|gives|given|has|have|demands|shows|at|for|to|by|and) another (one\b(?! (gives|with))|"
    r"number|value|rate|state|time|matrix|influence|sign|rank|greatest)|"
    r"\bnot the one$|begins otherwise|not where it should|that was asked for|"
    r"not what your|not what the"
)
MODULES = sorted(ROOT.rglob("*.py"))


def texts(module):
    """Yield (line, string) of a module but for docstrings, with `#` for what f-strings insert."""
    tree = ast.parse(module.read_text(encoding="utf-8"))
    pieces = {
        id(part)
        for node in ast.walk(tree)
        if isinstance(node, ast.JoinedStr)
        for part in node.values
    }
    docstrings = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
        and node.body
        and isinstance(node.body[0], ast.Expr)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            parts = (p.value if isinstance(p, ast.Constant) else "#" for p in node.values)
            yield node.lineno, "".join(parts)
        elif (
            isinstance(node, ast.Constant)
            and isinstance(node.value, str)
            and id(node) not in pieces | docstrings
        ):
            yield node.lineno, node.value


def findings(pattern, modules):
    """Return "file:line: text" of the texts outside backticks in which a pattern is found."""
    return [
        f"{module.relative_to(ROOT).as_posix()}:{line}: {text}"
        for module in modules
        for line, text in texts(module)
        if pattern.search(re.sub(r"`[^`]*`", "", text))
    ]


def test_messages_name_the_property():
    assert len(MODULES) > 150
    assert findings(VAGUE, MODULES) == []


def test_code_in_messages_stands_between_backticks():
    """But hints on errors are printed outside of a report, and what typed code becomes is code."""
    modules = [path for path in MODULES if path.stem not in ("error_hints", "typed_code")]
    assert findings(re.compile(r"\b(sp|sympy|numpy)\.\w|[=!]= ?\w"), modules) == []


def test_a_finding_has_its_line():
    module = ROOT / "contract" / "error_hints.py"
    (one, *_) = findings(re.compile("="), [module])
    name, line, _ = one.split(":", maxsplit=2)
    assert (
        name == "contract/error_hints.py" and "=" in module.read_text().split("\n")[int(line) - 1]
    )


@pytest.mark.parametrize(
    "message",
    [
        "the intensity is another number than 3",
        "x changes at another rate than yours",
        "the steps lead to another state",
        "and another value is given",
    ],
)
def test_vague_messages_are_recognised(message):
    assert VAGUE.search(message)


#: What the message says on a wrong answer of the tables, by check and note.
PROPERTIES = {
    ("steady_covariance", "the other root"): "negative variance",
    ("steady_covariance", "the other moment"): "does not satisfy the Riccati equation",
    ("steady_covariance", "growth ignored, before"): "but the errors do not decay",
    ("steady_covariance", "growth ignored, after"): "but the errors do not decay",
    ("steady_covariance", "a root with which the errors grow"): "the errors do not decay",
    ("steady_covariance", "a matrix not symmetric"): "is not real and symmetric",
    ("riccati_equation", "the sign of the noise"): "do not contain the covariance",
    ("riccati_equation", "one more linear term"): "are linear in the covariance",
    ("riccati_equation", "the sign of the measurement"): "are quadratic in the covariance",
    ("cost_riccati_equation", "time turned round"): "are linear in S",
    ("filter_equation", "the wrong column"): "the innovation does not enter with the best gain",
    ("controller_equations", "its own control forgotten"): "where the innovation is zero",
}


@pytest.mark.parametrize("check, note", PROPERTIES)
def test_the_message_names_the_property_that_fails(check, note):
    (case,) = [case for case in CASES if (case.check, case.note) == (check, note)]
    verdict = check_named(check)(case.answer, *case.data, **dict(case.options))
    assert verdict.status == "wrong"
    assert PROPERTIES[check, note] in verdict.message, verdict.message
