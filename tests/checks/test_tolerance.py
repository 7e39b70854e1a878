"""Three significant digits mean the same in every check, and no number hides behind a larger
one."""

import numpy as np
import pytest
import sympy as sp

from workbook import checks
from workbook.checks.contract.tolerance import (
    EXACT,
    MOST_EVALUATED,
    agree,
    exact_values,
    in_decimals,
    relative_tolerance,
    rounds_to,
)
from workbook.checks.structure.dual_questions import roots_evidence
from workbook.checks.tools.values import uncertainty_at
from workbook.systems import Linear

k = sp.Symbol("k", positive=True)
x, v, r, t = sp.symbols("x v r t", real=True)


@pytest.mark.parametrize(
    "answer, value, right",
    [
        (0.385, 0.3849, True),
        (0.38, 0.3849, False),
        (3.49e-6, 3.4873e-6, True),
        (3.5e-6, 3.4873e-6, False),
        (-0.385, 0.3849, False),
        (1.0, 1, True),
        (0, 0, True),
        (1e-9, 0, False),
        (123456, 123111, True),
        (124000, 123111, False),
        (9.95, 9.99, False),
        (9.985, 9.99, True),
        (float("nan"), 1, False),
    ],
)
def test_three_significant_digits(answer, value, right):
    assert rounds_to(answer, value) is right
    assert agree(answer, value, sp.Float(answer)) is right or value == 0 == answer


@pytest.mark.parametrize(
    "decimal, low, high",
    [
        ("7.17", "7.165", "7.175"),
        ("-7.2", "-7.205", "-7.195"),
        ("0.667", "0.6665", "0.6675"),
        ("0.66667", "0.66617", "0.66717"),
        ("2.667", "2.662", "2.672"),
        ("1000", "999.5", "1005"),
        ("1.004", "1", "1.009"),
        ("9.99", "9.985", "9.995"),
        ("9.996", "9.991", "10.046"),
        ("0.0", "0", "0"),
    ],
)
def test_a_decimal_stands_for_the_numbers_that_it_is_right_for(decimal, low, high):
    ends = exact_values(sp.Float(decimal))
    assert ends == (sp.Rational(low), sp.Rational(high))
    for share in (sp.Rational(k, 8) for k in range(9)):
        assert rounds_to(sp.Float(decimal), float(ends[0] + share * (ends[1] - ends[0])))
    below, above = (end + side * abs(end) / 10**5 for end, side in zip(ends, (-1, 1)))
    assert decimal == "0.0" or not rounds_to(sp.Float(decimal), float(below))
    assert decimal == "0.0" or not rounds_to(sp.Float(decimal), float(above))


def test_exponents_of_ten_are_exact():
    for k in range(-30, 31):
        assert exact_values(sp.Float(f"2e{k}")) == tuple(
            sp.Rational(end) * sp.Integer(10) ** k for end in ("1.995", "2.005")
        )


@pytest.mark.parametrize(
    "written, decimals",
    [
        (sp.Float(0.5), True),
        ([k, 2.5 * k], True),
        (sp.Matrix([[1, 0.0]]), False),
        ([sp.Rational(1, 2), k], False),
        (x > 2.5, True),
        (sp.true, False),
    ],
)
def test_what_counts_as_decimals(written, decimals):
    assert in_decimals(written) is decimals
    assert (relative_tolerance(written) > EXACT) is decimals


def test_an_exact_number_has_to_be_right():
    assert not agree(0.3333, 1 / 3, sp.Rational(3333, 10000))
    assert agree(1 / 3, 1 / 3 + 1e-12, sp.Rational(1, 3))


@pytest.mark.parametrize(
    "answer, value, right",
    [
        (0.707 + 0.707j, (1 + 1j) / np.sqrt(2), True),
        (0.707 + 0.713j, (1 + 1j) / np.sqrt(2), False),
        (-1 + 0.71j, -1 + 1j / np.sqrt(2), False),
        (-1 + 0.707j, -1 + 1j / np.sqrt(2), True),
        (-1.2 + 0.7j, -1.2 + 1j / np.sqrt(2), False),
        (-1.2 - 0.707j, -1.2 - 1j / np.sqrt(2), True),
        (4e-6 + 2.0j, 2j, True),
        (1e-5 + 2.0j, 2j, False),
        (-3.0 + 0j, -3, True),
        (-3.0 + 1e-4j, -3, False),
        (100 + 0.12j, 100 + 0.123j, False),
    ],
)
def test_each_part_of_a_complex_number_has_its_own_digits(answer, value, right):
    assert agree(answer, value, sp.sympify(answer)) is right
    in_a_matrix = agree(np.array([[answer]]), [[value]], sp.Matrix([[sp.sympify(answer)]]))
    assert in_a_matrix.tolist() == [[right]]


def test_a_number_alone_has_the_digits_of_its_own_whatever_it_is_computed_from():
    assert not agree(0.0123, 0.0121, sp.Float(0.0123), size=100)
    assert agree(np.array([[0.0123]]), [[0.0121]], sp.Matrix([0.0123]), size=100).all()


def test_rounded_coefficients_of_an_expression_cost_their_share():
    # 1.11 k is 1.1149 k to three digits; at k = 8.9 the values, 9.879 and 9.923, differ by more
    # than half a unit.
    assert agree(1.11 * 8.9, 1.1149 * 8.9, 1.11 * k)
    assert not agree(9.879, 9.923, sp.Float(9.879))


def test_the_decimals_of_an_expression_leave_open_what_they_make_of_it():
    claim = 1 + 0.331 * k
    assert not agree(
        1 + 0.331 * 0.01, 1 + 0.01 / 3, claim, uncertain=uncertainty_at(claim, {k: 0.01})
    )
    assert agree(0.667 - 0.66, 0.0067, 0.667 - k, uncertain=uncertainty_at(0.667 - k, {k: 0.66}))
    assert uncertainty_at(x**0.5 + sp.Rational(1, 3) * x, {x: 4}) == 0  # nothing is rounded
    assert np.isnan(uncertainty_at(sp.Float(0.33), {}))  # a number has digits of its own
    assert np.isnan(
        uncertainty_at(sum(sp.Float(n + 0.5) * x**n for n in range(MOST_EVALUATED + 1)), {x: 1})
    )


# The same numbers in checks of all kinds: 9.985 is 9.99 within half a unit, 9.95 is not.
A = sp.Matrix([[sp.Rational(999, 100), 0], [0, 1]])
H = sp.Matrix([[0, 1]])
NUMBERS = [
    lambda number: checks.fixed_eigenvalues([number], Linear(A, H=H)),
    lambda number: checks.controllability_matrix([[1, number], [1, 1.0]], Linear(A, [1, 1])),
    lambda number: checks.equilibrium_value(number, x, [v, sp.Rational(999, 100) - x], [x, v], []),
    lambda number: checks.equilibrium_linearisation(
        [[0, 1], [-number, 0]], [v, -sp.Rational(999, 100) * x], [x, v], []
    ),
    lambda number: checks.equilibria([[number]], [sp.Rational(999, 100) - x], [x]),
    lambda number: checks.equilibrium_values([number], [v, sp.Rational(999, 100) - x], [x, v]),
    lambda number: checks.canonical_coordinate(
        [number, 0], Linear([[0, 1], [0, 0]], [0, sp.Rational(100, 999)])
    ),
]


@pytest.mark.parametrize("judge", NUMBERS)
@pytest.mark.parametrize("number, status", [(9.985, "right"), (9.95, "wrong")])
def test_every_check_counts_the_same_digits(judge, number, status):
    assert judge(number).status == status, judge(number).message


@pytest.mark.parametrize(
    "judge",
    [
        lambda one: checks.controllability_matrix(
            [[one, one], [100.0, 200.0]], Linear(sp.diag(1, 2), [1, 100])
        ),
        lambda one: checks.canonical_coordinate([one, 100.0], Linear([[0, 1], [0, 0]], [-100, 1])),
        lambda one: checks.canonical_change(
            [[one, 100.0], [-2, -100]], Linear(sp.diag(1, 2), H=[[1, 100]])
        ),
    ],
)
def test_no_entry_hides_behind_a_larger_one_of_its_row(judge):
    assert [judge(one).status for one in (1.0, 1.004, 1.4)] == ["right", "right", "wrong"]


def test_decimals_are_never_said_to_be_proved():
    y = sp.Symbol("y", real=True)
    field = [x * (1 - x**2 - y**2) - y, y * (1 - x**2 - y**2) + x]
    proved, rounded = (checks.limit_cycles([one], field, [x, y]) for one in (1, sp.Float(1)))
    assert proved.status == rounded.status == "right"
    assert proved.message.endswith("proved") and rounded.message.endswith("to three digits")
    assert roots_evidence([sp.Integer(1)], x, x - 1) == "proved"
    assert roots_evidence([sp.Float(1)], x, x - 1).startswith("to three digits")
