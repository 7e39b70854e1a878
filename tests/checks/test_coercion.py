"""Answers are read generously in form and strictly in kind."""

import numpy as np
import pytest
import sympy as sp

from workbook.checks.contract import coercion, condition_coercion
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.members import members
from workbook.checks.contract.verdict import Invalid

x, y = sp.symbols("x y", real=True)
plain = sp.Symbol("x")


@pytest.mark.parametrize(
    "answer",
    [
        3,
        3.0,
        np.float64(3),
        np.int32(3),
        sp.Integer(3),
        sp.Float(3),
        sp.Rational(6, 2),
        np.array(3),
        3 + 0j,
    ],
)
def test_whole_numbers(answer):
    assert coercion.as_integer(answer) == 3 and float(coercion.as_number(answer)) == 3


@pytest.mark.parametrize(
    "answer", [3.5, "3", None, True, sp.I, sp.oo, float("nan"), x, [3, 4], lambda: 3]
)
def test_no_whole_numbers(answer):
    with pytest.raises(Invalid):
        coercion.as_integer(answer)


@pytest.mark.parametrize(
    "answer",
    [
        [1, 2],
        (1, 2),
        np.array([1, 2]),
        np.array([[1], [2]]),
        np.array([[1, 2]]),
        sp.Matrix([1, 2]),
        sp.Matrix([[1, 2]]),
        sp.Tuple(1, 2),
        [[1], [2]],
        [[1, 2]],
        [1.0, sp.Integer(2)],
    ],
)
def test_vectors_in_any_form(answer):
    assert [int(v) for v in coercion.as_expressions(answer, length=2)] == [1, 2]


def test_casadi_numbers():
    casadi = pytest.importorskip("casadi")
    assert [int(v) for v in coercion.as_expressions(casadi.DM([1, 2]))] == [1, 2]
    assert coercion.as_matrix(casadi.DM([[1, 2], [3, 4]])) - sp.Matrix(
        [[1, 2], [3, 4]]
    ) == sp.zeros(2, 2)


@pytest.mark.parametrize(
    "answer",
    [[[1, 2], [3, 4]], np.array([[1, 2], [3, 4]]), sp.Matrix([[1, 2], [3, 4]]), ((1, 2), (3, 4))],
)
def test_matrices_in_any_form(answer):
    assert coercion.as_matrix(answer, shape=(2, 2)) == sp.Matrix([[1, 2], [3, 4]])


@pytest.mark.parametrize(
    "answer, said",
    [
        ([[1, 2], [3]], "lengths"),
        (np.zeros((2, 2, 2)), "3 axes"),
        ([[1, 2]], "shape"),
        (5, "matrix"),
        ("A", "matrix"),
    ],
)
def test_no_matrices(answer, said):
    with pytest.raises(Invalid, match=said):
        coercion.as_matrix(answer, shape=(2, 2))


def test_a_matrix_of_another_shape_is_refused_before_its_entries_are_read():
    """Of 40,000 entries that would take more than a second; the symbol q would be refused first."""
    for answer in (np.full((200, 200), sp.Symbol("q")), [[sp.Symbol("q")] * 3] * 2):
        with pytest.raises(Invalid, match="of shape"):
            coercion.as_matrix(answer, [x], (2, 1), (1, 2))
    assert coercion.as_matrix([[1, 2]], [x], (2, 1), (1, 2)).shape == (1, 2)


def test_symbols_match_by_name():
    assert coercion.as_expression(plain**2, [x]) == x**2
    with pytest.raises(Invalid, match="q"):
        coercion.as_expression(sp.Symbol("q") * x, [x])
    with pytest.raises(Invalid, match="f"):
        coercion.as_expression(sp.Function("f")(x), [x])


@pytest.mark.parametrize(
    "answer, condition",
    [
        (plain > 0, x > 0),
        ([plain > 0, y < 1], sp.And(x > 0, y < 1)),
        (True, sp.true),
        (np.bool_(False), sp.false),
        ({plain > 0, y < 1}, sp.And(x > 0, y < 1)),
        (frozenset({plain > 0}), x > 0),
        (sp.Tuple(plain > 0, y < 1), sp.And(x > 0, y < 1)),
        (sp.FiniteSet(plain > 0, y < 1), sp.And(x > 0, y < 1)),
        (sp.S.EmptySet, sp.false),
        (sp.ConditionSet((plain, y), plain > y, sp.S.Reals**2), x > y),
    ],
)
def test_conditions(answer, condition):
    assert condition_coercion.as_condition(answer, [x, y]) == condition


@pytest.mark.parametrize(
    "answer, said",
    [
        (sp.sqrt(-1 - plain**2) > 0, "not real"),
        ([sp.sqrt(-1 - plain**2) > 0], "not real"),
        (sp.DiracDelta(plain) > 0, "contains DiracDelta"),
        (sp.gamma(plain) > 0, "contains gamma"),
        (sp.Derivative(sp.Abs(plain), plain) > 0, "contains Derivative"),
        (sp.Integral(plain, plain) > 0, "an integral without limits"),
        (sp.ImageSet(sp.Lambda(plain, plain**2), sp.S.Integers), "expected a condition or a set"),
        (sp.Eq(sp.Matrix([plain]), sp.Matrix([1])), "compares numbers, not matrices"),
        ("x", "expected a condition"),
    ],
)
def test_no_conditions(answer, said):
    for symbols in ([x], [x, y]):
        with pytest.raises(Invalid, match=said):
            condition_coercion.as_condition(answer, symbols)


@pytest.mark.parametrize(
    "join", [sp.Xor, lambda p, q: sp.Implies(q, sp.Not(p)), lambda p, q: sp.ITE(p, q, sp.Not(q))]
)
def test_conditions_that_would_take_for_ever(join):
    """Conditions that are astronomically long when written with And and Or are refused."""
    few, many = x > 0, x > 0
    for k in range(1, 91):
        many = join(many, y > k)
        few = many if k == 2 else few
    assert condition_coercion.as_condition(few, [x, y]) == few
    if join is sp.Xor or many.has(sp.ITE):
        with pytest.raises(Invalid, match="give a simpler form"):
            condition_coercion.as_condition(many, [x, y])
    else:
        assert condition_coercion.as_condition(many, [x, y]) == many, (
            "written out it is no longer than as it stands"
        )


@pytest.mark.parametrize(
    "function",
    [
        sp.Lambda((x, y), x - y**2),
        sp.Lambda((y, x), x - y**2),
        sp.Lambda((plain, y), plain - y**2),
        sp.Lambda(sp.symbols("a b"), sp.Symbol("a") - sp.Symbol("b") ** 2),
        sp.Lambda(y, sp.Symbol("x") - y**2),
    ],
)
def test_a_lambda_is_its_value(function):
    assert coercion.as_expression(function, [x, y]) == x - y**2


@pytest.mark.parametrize(
    "function, said",
    [
        (sp.Lambda((x, y), x + y), "or `sp.Lambda` of x"),
        (sp.Lambda(x, sp.Matrix([x])), "with one as its value"),
        (sp.Lambda(((x, y), plain), x), "or `sp.Lambda` of"),
        (sp.Lambda(x, sp.Lambda(y, x)), "with a function in it"),
        (sp.Lambda(y, sp.Symbol("q") * y), "contains q"),
    ],
)
def test_no_functions(function, said):
    with pytest.raises(Invalid, match=said):
        coercion.as_expression(function, [x])


@pytest.mark.parametrize(
    "answer",
    [
        sp.Contains(plain, sp.Interval.open(0, 1)),
        sp.And(sp.Contains(plain, sp.Interval(0, 1)), sp.Ne(x, 0), sp.Ne(x, 1)),
        sp.Piecewise((sp.false, plain <= 0), (plain < 1, True)),
        sp.Piecewise((sp.true, sp.And(x > 0, x < 1))),
        sp.Not(sp.Contains(x, sp.Union(sp.Interval(-sp.oo, 0), sp.Interval(1, sp.oo)))),
    ],
)
def test_conditions_written_as_membership_and_as_cases(answer):
    condition = condition_coercion.as_condition(decode(encode(answer)), [x])
    assert [bool(condition.subs(x, value)) for value in (-1, 0, sp.Rational(1, 2), 1, 2)] == [
        0,
        0,
        1,
        0,
        0,
    ]


@pytest.mark.parametrize(
    "values",
    [
        [1, 2],
        (1, 2),
        {1, 2},
        np.array([1, 2]),
        np.array([[1.0], [2.0]]),
        sp.Matrix([1, 2]),
        sp.FiniteSet(1, 2),
    ],
)
def test_values_of_a_single_symbol(values):
    condition = condition_coercion.as_condition(values, [x])
    assert [bool(condition.subs(x, value)) for value in (0, 1, 2)] == [False, True, True]


@pytest.mark.parametrize(
    "answer",
    [
        sp.Piecewise((sp.true, x > 0), (1, True)),
        [1, x > 0],
        np.array([True, False]),
        sp.Eq(sp.Piecewise((sp.true, x > 0), (sp.false, True)), 1, evaluate=False),
        sp.Contains(x, sp.ImageSet(sp.Lambda(y, y**2), sp.S.Integers), evaluate=False),
    ],
)
def test_what_is_half_a_condition_is_none(answer):
    with pytest.raises(Invalid):
        condition_coercion.as_condition(answer, [x])


def test_values_that_are_none():
    with pytest.raises(Invalid, match="is undefined"):
        condition_coercion.as_condition(np.array([np.nan, 1.0, np.inf, 0.0]), [x])
    for integral in (
        sp.Integral(plain, plain),
        sp.Integral(plain, (plain, 1)),
        sp.Integral(plain, plain, (y, 0, 1)),
    ):
        with pytest.raises(Invalid, match="an integral without limits"):
            coercion.as_expression(integral, [x, y])
    assert coercion.as_expression(sp.Integral(plain, (plain, 0, 1)), [x]).doit() == sp.Rational(
        1, 2
    )


def test_cases_that_are_true_or_false_are_no_expression():
    with pytest.raises(Invalid, match="True or False"):
        coercion.as_expression(1 + sp.Piecewise((sp.true, x > 0), (sp.false, True)), [x])


def test_a_symbol_may_be_a_case():
    cases = sp.Piecewise((plain, x > 0), (y, True))
    assert coercion.as_expression(cases, [x, y]) == sp.Piecewise((x, x > 0), (y, True))
    with pytest.raises(Invalid):
        condition_coercion.as_condition(cases, [x, y])


def test_the_cardinal_sine_has_its_value_at_zero():
    assert coercion.as_expression(sp.sinc(plain), [x]).subs(x, 0) == 1


def test_intervals_of_a_single_symbol():
    assert condition_coercion.as_condition(sp.Interval.open(0, sp.oo), [x]).subs(x, 1) == sp.true
    assert (
        condition_coercion.as_condition(
            sp.Union(sp.Interval.open(-2, -1), sp.Interval(1, 2)), [x]
        ).subs(x, sp.Rational(3, 2))
        == sp.true
    )


@pytest.mark.parametrize(
    "word", ["asymptotically stable", "Asymptotically-Stable", " asymptotically_stable "]
)
def test_choices(word):
    assert coercion.as_choice(word, ["asymptotically stable", "stable"]) == "asymptotically stable"
    with pytest.raises(Invalid, match="one of"):
        coercion.as_choice("wobbly", ["stable"])


@pytest.mark.parametrize(
    "answer, value",
    [(True, True), ("yes", True), ("No", False), (np.bool_(True), True), (sp.false, False)],
)
def test_yes_and_no(answer, value):
    assert coercion.as_yes_no(answer) is value


@pytest.mark.parametrize(
    "answer, word",
    [
        (sp.eye(2), "got a matrix"),
        (np.zeros(2), "got an array"),
        (x, "an expression"),
        ({x: 1}, "got a dict"),
        ([], "got a list"),
        (2.5, "got a number"),
    ],
)
def test_what_came_instead_of_a_condition_is_told_in_a_word(answer, word):
    with pytest.raises(Invalid, match=word):
        condition_coercion.as_condition(answer, [x, y])


@pytest.mark.parametrize("values", [[sp.nan, 1], np.array([1, np.nan]), sp.Matrix([sp.zoo])])
def test_values_that_are_undefined_are_no_condition(values):
    with pytest.raises(Invalid, match="undefined"):
        condition_coercion.as_condition(values, [x])


TOO_LARGE = {
    "a tower of exp": sp.exp(sp.exp(sp.exp(sp.exp(x**99)))),
    "three of them": sp.exp(sp.exp(sp.exp(x))),
    "a tower of powers": x ** (x ** (x**99)),
    "x^x^x": x ** (x**x),
    "a large factorial": sp.factorial(10**6 * x),
    "a large gamma": sp.gamma(10**9 * x),
    "a large binomial": sp.binomial(10**6 * x, 10**5),
    "a large angle": sp.cos(10**1000 * x),
    "a large exponent": sp.exp(x**1000),
    "sinh": sp.sinh(sp.sinh(sp.sinh(x))),
    "under an integral": sp.Integral(sp.exp(sp.exp(y**3)), (y, 0, x**99)),
    "a long sum": sp.Sum(x / y, (y, 1, 10**9)),
    "Max of many": sp.Max(*[x + sp.sin(k * x) for k in range(9)]),
    "many cases": sp.Piecewise(*((k * x, x < k) for k in range(300)), (x, True)),
    "a high derivative": sp.Derivative(sp.exp(x**3) * sp.sin(x), (x, 60)),
}
LARGE_ENOUGH = [
    sp.exp(-sp.exp(-10 * x)),
    sp.exp(1 - sp.exp(-x)),
    x**x,
    2 ** (x**2),
    sp.exp(-(x**2) * y**2 / 2),
    x**4000,
    sp.factorial(x),
    sp.sin(x**9 * y),
    sp.tanh(1000 * sp.sinh(x)),
    sp.sin(sp.sin(sp.sin(x))),
    (1 + x**9) ** 900,
    sp.Integral(sp.exp(-(y**2)), (y, 0, x)),
    sp.Sum(x**y, (y, 0, sp.oo)),
    sp.Max(x, y, x + y),
]


@pytest.mark.parametrize("answer", TOO_LARGE.values(), ids=TOO_LARGE)
@pytest.mark.parametrize(
    "read",
    [
        coercion.as_expression,
        lambda e, s: coercion.as_matrix([[e, 1], [0, e]], s),
        lambda e, s: coercion.as_number(e),
        lambda e, s: coercion.as_expressions([1, e], s),
        lambda e, s: condition_coercion.as_condition(e > 1, s),
    ],
    ids=["expression", "matrix", "number", "list", "condition"],
)
def test_what_is_too_large_to_be_computed_with_is_invalid(read, answer):
    with pytest.raises(Invalid):
        read(answer, [x, y])


@pytest.mark.parametrize("answer", LARGE_ENOUGH, ids=str)
def test_what_can_be_computed_is_not_too_large(answer):
    assert coercion.as_expression(answer, [x, y]) == answer


@pytest.mark.parametrize("matrix", [np.zeros((200, 200)), sp.zeros(3, 3)])
def test_a_matrix_is_no_list_of_numbers(matrix):
    with pytest.raises(Invalid, match="got an? (array|matrix)"):
        condition_coercion.as_condition(matrix, [x])
    with pytest.raises(Invalid, match="a list"):
        members(matrix, "a list")
