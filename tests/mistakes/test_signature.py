"""Signatures: equal for the forms of an answer, different for other answers."""

import numpy as np
import pytest
import sympy as sp

from workbook.mistakes.signature import (
    MAX_BYTES,
    AnswerType,
    NoSignature,
    arcs_as_piecewise,
    signatures,
)

x, y, k, t = sp.symbols("x y k t", real=True)
m = sp.Symbol("m", positive=True)
PLANE = {"x": "", "y": ""}

EQUAL = [
    ("expression", (x + y) ** 2, sp.expand((x + y) ** 2)),
    ("expression", (x**2 - y**2) / (x - y), x + y),
    ("expression", x / 3, 0.3333333333333333 * x),
    ("expression", sp.sin(2 * x), 2 * sp.sin(x) * sp.cos(x)),
    ("expression", sp.Symbol("x") * y, x * sp.Symbol("y", complex=True)),
    ("expression", sp.sqrt(x), x**0.5),
    ("law", -sp.sign(x), sp.Piecewise((-1, x > 0), (1, True))),
    ("law", sp.Lambda((x,), 2 * x), 2 * x),
    ("number", sp.pi / 4, 0.785),
    ("number", sp.Integer(3), 3.0),
    ("number", sp.sqrt(2) + sp.I, np.sqrt(2) + 1j),
    ("vector", [1, x], sp.Matrix([1, x])),
    ("vector", [1.5, 2], np.array([[1.5, 2.0]])),
    ("matrix", sp.Matrix([[1, x], [0, 2]]), ((1, x), (0.0, 2.0))),
    ("set", [x, 1, y], {y, x, 1}),
    ("set", [1, 2], sp.FiniteSet(2, 1)),
    ("list of vector", [[1, x], [0, 1]], [(0, 1), sp.Matrix([1, x])]),
    ("list of vector basis", [[1, 0, 1], [0, 1, 0]], sp.Matrix([[1, 2], [3, 1], [1, 2]])),
    ("list of vector basis", [[x, 1]], [[-2 * x**2, -2 * x]]),
    ("dict basis", {-1: [[1, 2]]}, {-1.0: np.array([[2.0, 4.0]])}),
    ("equation", sp.Eq(x, y), sp.Eq(2 * y - 2 * x, 0)),
    ("condition", sp.And(x > 0, y > x), sp.Not(sp.Or(x <= 0, y <= x))),
    ("condition", sp.And(x > 0, y > x), [y - x > 0, x > 0]),
    ("condition", x >= sp.Rational(1, 5), sp.Symbol("x") >= 0.2),
    ("condition", x > 1, sp.Interval.open(1, sp.oo)),
    ("yes/no", False, "No"),
    ("choice", "stable focus", "Stable-Focus"),
    ("integer", 3, sp.Float(3.0)),
]
DIFFERENT = [
    ("expression", x**2, x * sp.Abs(x)),
    ("expression", x + y, x - y),
    ("expression", x, x + sp.Rational(1, 1000)),
    ("expression", sp.Piecewise((-1, t < 1), (x, True)), [[-1, 2], [x, 3]]),
    ("law", -sp.sign(x - y), -sp.sign(x - y - 2)),
    ("number", 2, 2.1),
    ("vector", [1, x], [x, 1]),
    ("matrix", sp.Matrix([[1, 2]]), sp.Matrix([1, 2])),
    ("set", [1, 2], [1, 2, 3]),
    ("list of vector basis", [[1, 0]], [[0, 1]]),
    ("list of vector basis", [[0, 0]], []),
    ("equation", sp.Eq(x, y), sp.Eq(x, -y)),
    ("condition", x * y > 1, x * y >= 1),
    ("condition", sp.Ne(x, 1), sp.true),
    ("condition", sp.And(x > 0, y > 0), sp.Or(x > 0, y > 0)),
    ("condition", x > -sp.Rational(3, 4), x > -sp.Rational(37, 50)),
    ("yes/no", True, False),
    ("integer", 1000, 1001),
]


def of(value, kind, symbols=PLANE):
    return list(signatures(value, AnswerType(kind, symbols)))


@pytest.mark.parametrize("kind, one, other", EQUAL)
def test_forms_of_an_answer_have_equal_signatures(kind, one, other):
    assert of(one, kind)[0] in of(other, kind) and of(other, kind)[0] in of(one, kind)


@pytest.mark.parametrize("kind, one, other", DIFFERENT)
def test_different_answers_have_different_signatures(kind, one, other):
    assert not set(of(one, kind)) & set(of(other, kind))


def test_a_flat_list_is_a_row_or_a_column():
    flat = [set(of(written, "matrix")) for written in ([x, 1], (x, 1), np.array([2.0, 1.0]))]
    for matrix in (sp.Matrix([[x, 1]]), sp.Matrix([x, 1])):
        assert of(matrix, "matrix")[0] in flat[0] & flat[1]
    assert of(sp.Matrix([[2, 1]]), "matrix")[0] in flat[2]
    assert of(sp.Matrix([[x, 1]]), "matrix")[0] not in of([[x], [1]], "matrix")


def test_arcs_have_the_signature_of_their_cases():
    for arcs, cases_of_arcs in (
        ([[-1, 1], [x, 2]], sp.Piecewise((-1, t < 1), (x, True))),
        (np.array([[-1, x], [1, 3]]), sp.sign(t - x)),
        ([[4, sp.pi / 4]], 4),
    ):
        assert of(cases_of_arcs, "expression")[0] in of(arcs, "expression")
        (cases,) = arcs_as_piecewise(arcs, "expression")
        assert (
            of(cases, "expression")[0]
            == of(cases_of_arcs, "expression")[0]
            != of(arcs, "expression")[0]
        )
    assert (
        arcs_as_piecewise([[1, 2], [3, 4]], "matrix")
        == arcs_as_piecewise(x, "expression")
        == arcs_as_piecewise(["a b"], "expression")
        == []
    )
    assert not set(of([[x, 1], [1, 2]], "expression")) & set(of([[x, 2], [1, 2]], "expression"))


def test_three_digits_are_enough():
    for number in np.geomspace(1e-3, 1e3, 400):
        assert of(float(number), "number")[0] in of(float(f"{number:.3g}"), "number"), number


def test_rounding_keeps_the_signature():
    for number in np.linspace(1, 2, 2000):
        moved = of(sp.Float(number) * (1 + sp.Float(1e-13)) * x, "expression")
        assert of(sp.Float(number) * x, "expression")[0] in moved, number


def test_assumptions_on_parameters_are_used():
    assert of(sp.Abs(m), "expression", {"m": "positive"}) == of(m, "expression", {"m": "positive"})
    assert of(sp.Abs(x), "expression") != of(x, "expression")


@pytest.mark.parametrize(
    "kind, value",
    [
        ("condition", x + y),
        ("condition", sp.Symbol("z") > 0),
        ("expression", [lambda: 1]),
        ("number", None),
        ("expression", sp.Integral(sp.exp(-(x**2)), (x, 0, 1))),
        ("set", x),
        ("yes/no", 17),
        ("matrix", 3),
        ("expression", [x] * MAX_BYTES),
    ],
)
def test_answers_without_values_have_no_signature(kind, value):
    with pytest.raises(NoSignature):
        of(value, kind)
