"""A message on a wrong answer names the property that fails, not only that something differs."""

import ast
import re
from pathlib import Path

import pytest
from test_cases import CASES, check_named

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
    """Return all strings of a module but its docstrings, with `#` for what f-strings insert."""
    tree = ast.parse(module.read_text())
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
            yield "".join(p.value if isinstance(p, ast.Constant) else "#" for p in node.values)
        elif (
            isinstance(node, ast.Constant)
            and isinstance(node.value, str)
            and id(node) not in pieces | docstrings
        ):
            yield node.value


@pytest.mark.parametrize("module", MODULES, ids=lambda path: str(path.relative_to(ROOT)))
def test_messages_name_the_property(module):
    assert not [text for text in texts(module) if VAGUE.search(text)]


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
