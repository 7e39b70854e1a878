"""Conditions are decided, not sampled; what is called wrong was evaluated exactly; the rest is said
to be tried."""

import sys
from fractions import Fraction

import pytest
import sympy as sp

from workbook import checks
from workbook.checks.contract.verdict import Wrong
from workbook.checks.references.invariant_subspaces import (
    characteristic_coefficients,
    kernel,
    restricted,
    unobservable_subspace,
)
from workbook.checks.references.pairs import pair_of
from workbook.checks.references.spectra import Spectrum
from workbook.checks.tools.conditions import (
    Case,
    Condition,
    ReferenceCondition,
    compare,
    decision,
    decomposition,
    exactly,
)
from workbook.systems import Linear

x, y = sp.symbols("x y", real=True)
positive = sp.Symbol("p", positive=True)
ABOVE = exactly(sp.And(x > 0, x * y > 1))


def judged(claim, truth=ABOVE, parameters=(x, y)):
    """Return the verdict on a claim: how it agrees, or the point where it is wrong."""
    try:
        return compare(claim, list(parameters), truth, lambda values, holds: f"{holds} at {values}")
    except Wrong as reason:
        return str(reason)


@pytest.mark.parametrize(
    "claim",
    [
        sp.And(x > 0, x * y > 1),
        sp.And(y > 0, x > 1 / y),
        sp.And(x > 0, sp.sqrt(x) * sp.sqrt(y) > 1),
        sp.And(x + sp.Abs(x) > 0, sp.Max(x * y, 1) > 1),
        sp.ITE(x > 0, x * y > 1, sp.false),
        sp.Xor(x * y > 1, sp.And(x < 0, x * y > 1)),
        sp.And(x > 0, x * y > 1, x < sp.oo),
        sp.And(x > 0, x**2.0 * y > x),
        sp.And(x > 0, sp.pi * x * y > sp.pi),
    ],
)
def test_a_right_condition_in_any_form_is_proved(claim):
    assert judged(claim) == "proved for all values"


@pytest.mark.parametrize(
    "claim",
    [
        sp.And(x > 0, x * y >= 1),
        sp.And(x > 0, x * y > 1, sp.Ne(x, sp.pi)),
        sp.And(x > 0, x * y > 1, sp.Ne(x * x, 2)),
        sp.And(x > 0, x * y > 1, x**3 + y**3 < 10**12),
        sp.And(x > 0, x * y > 1.01),
        sp.And(x > 0, x * y >= 1.0),
        sp.And(x > 0, x * y > 1, sp.Or(sp.Ne(x**2, 2), sp.Ne(y**2, 3))),
        sp.Or(sp.And(x > 0, x * y > 1), sp.Eq((x**2 - 2) ** 2 + (y**2 - 3) ** 2, 0)),
    ],
)
def test_a_condition_that_errs_somewhere_is_refuted_there(claim):
    assert judged(claim).startswith(("True at", "False at"))


ONE_THIRD, TWO_ROOTS = exactly(sp.Ne(x, sp.Rational(1, 3))), exactly(sp.Ne(x**2 - 13 * x + 5, 0))
#: With one value of a second unknown for each x up to 8/3, and none behind.
REAL = ReferenceCondition(
    (Case(sp.Eq(y**2, 8 - 3 * x), (y,)),), (Case(sp.Ne(y**2, 8 - 3 * x), (y,), every=True),)
)


@pytest.mark.parametrize(
    "claim, truth",
    [
        (sp.And(x > 0, x * y > 1.004), ABOVE),
        (sp.And(x > 0, y > 1.0 / x), ABOVE),
        (x >= 2.667, exactly(3 * x >= 8)),
        (x >= 2.67, exactly(3 * x >= 8)),
        (x <= 2.667, REAL),
        (x <= 1.004, exactly(x <= 1)),
        (x <= 0.9996, exactly(x <= 1)),
        (sp.Or(x < 0.333, x > 0.333), ONE_THIRD),
        (sp.S.Reals - sp.FiniteSet(0.333), ONE_THIRD),
        (sp.Ne(x, 0.333), ONE_THIRD),
        (sp.Or(x < 0.397, sp.And(x > 0.397, x < 12.6), x > 12.6), TWO_ROOTS),
        (sp.S.Reals - sp.FiniteSet(0.397, 12.6), TWO_ROOTS),
        (sp.Interval(-1.41, 1.414), exactly(x**2 <= 2)),
        (0.667 * x + 0.143 * y > 1, exactly(14 * x + 3 * y > 21)),
        (x < 0.453, exactly(x**3 + 2 * x < 1)),
        (x < 3.14, exactly(x < sp.pi)),
    ],
)
def test_a_condition_with_decimals_is_right_to_three_digits(claim, truth):
    parameters = (x, y) if claim.has(y) else (x,)
    assert judged(claim, truth, parameters) == "to three digits, for all values"


@pytest.mark.parametrize(
    "claim, truth",
    [
        (x > 2.667, exactly(3 * x >= 8)),
        (x >= 2.66, exactly(3 * x >= 8)),
        (x >= sp.Rational(2667, 1000), exactly(3 * x >= 8)),
        (x < 2.667, REAL),
        (x < 1.004, exactly(x <= 1)),
        (x <= 0.996, exactly(x <= 1)),
        (sp.Ne(x, 0.33), ONE_THIRD),
        (sp.Or(x < 0.333, x > 0.334), ONE_THIRD),
        (sp.Or(x < 0.397, sp.And(x >= 0.397, x < 12.6), x > 12.6), TWO_ROOTS),
        (sp.S.Reals - sp.FiniteSet(0.397, 12.7), TWO_ROOTS),
        (sp.Interval.open(-1.41, 1.41), exactly(x**2 <= 2)),
        (0.67 * x + 0.143 * y > 1, exactly(14 * x + 3 * y > 21)),
        (x <= 0.453, exactly(x**3 + 2 * x < 1)),
    ],
)
def test_decimals_hide_no_border(claim, truth):
    parameters = (x, y) if claim.has(y) else (x,)
    assert judged(claim, truth, parameters).startswith(("True at", "False at"))


def test_a_set_stands_for_values_of_the_parameter_that_matters():
    truth = exactly(sp.Ne((x**2 + 1) * (3 * y - 1), 0))
    values = sp.S.Reals - sp.FiniteSet(0.333)
    assert judged(values, truth) == "to three digits, for all values"
    assert judged(sp.S.Reals - sp.FiniteSet(sp.Rational(1, 3)), truth) == "proved for all values"
    assert judged(sp.S.Reals - sp.FiniteSet(0.33), truth).startswith(("True at", "False at"))


def test_the_difference_that_is_told_is_one():
    points = []

    def told(values, holds):
        points.append((tuple(values.values()), holds))
        return ""

    claim = sp.And(x > 0, x * y > 1, sp.Or(sp.Ne(x**2, 2), sp.Ne(y**3, 5)))
    with pytest.raises(Wrong):
        compare(claim, [x, y], ABOVE, told)
    ((point, holds),) = points
    assert holds and sp.And(x > 0, x * y > 1).subs(dict(zip((x, y), point)))
    assert (
        sp.minimal_polynomial(point[0], x) == x**2 - 2
        and sp.minimal_polynomial(point[1], x) == x**3 - 5
    )


@pytest.mark.parametrize(
    "condition, high, low",
    [
        (sp.Ne(x, sp.sqrt(2)), False, True),
        (sp.Ne(x**2, 2), False, False),
        (sp.Ne(sp.Abs(x), sp.sqrt(2)), False, False),
        (x > 1, True, False),
        (x * sp.sqrt(2) >= 2, True, False),
        (sp.Eq(1 / (x**2 - 2), 1), False, False),
        (sp.Implies(x > 0, sp.Eq(x**2, 2)), True, True),
        (sp.Ne(x, sp.Rational(141, 100)), True, True),
        (sp.log(x) > 0, True, False),
        (sp.Eq(x**4, 2 * x**2), True, True),
    ],
)
def test_a_condition_at_the_roots_of_two(condition, high, low):
    claim = Condition(condition, [x])
    assert (claim.holds([sp.sqrt(2)]), claim.holds([-sp.sqrt(2)])) == (high, low)


def test_a_root_that_is_not_real_is_not_zero():
    assert judged(sp.Ne(sp.sqrt(3 - x), 0), exactly(sp.Ne(x, 3)), [x]).startswith("proved")
    assert judged(sp.Eq(sp.sqrt(3 - x), 0), exactly(sp.Eq(x, 3)), [x]).startswith("proved")
    assert judged(sp.Ne(sp.sqrt(3 - x), 0), exactly(x < 3), [x]).startswith("False at")


def test_a_false_difference_of_the_solver_is_never_told(monkeypatch):
    monkeypatch.setattr(decision._Question, "answer", lambda *_: (sp.Integer(2), sp.Integer(3)))
    assert judged(sp.And(x > 0, x * y > 1)).startswith("agrees at ")


@pytest.mark.parametrize("hindrance", ["no solver", "too few steps"])
def test_without_the_solver_cells_decide(hindrance, monkeypatch):
    if hindrance == "no solver":
        monkeypatch.setitem(sys.modules, "z3", None)
    else:
        monkeypatch.setattr(decision, "STEPS", 1)
        monkeypatch.setattr(decision, "TIMES_SIZE", 1)
    assert judged(sp.And(x > 0, x * y > 1)) == "proved for all values"
    assert judged(sp.And(x > 0, y > 0)).startswith("False at")
    assert judged(sp.And(x > 0, x * y >= 1)).startswith("False at")


def test_without_a_decision_the_verdict_says_so(monkeypatch):
    monkeypatch.setitem(sys.modules, "z3", None)
    monkeypatch.setattr(decomposition, "MOST_WORK", 0)
    told = judged(sp.And(x > 0, x * y > 1))
    assert told.startswith("agrees at ") and int(told.split()[2]) > 100
    assert judged(sp.And(x > 0, y > 0)).startswith("False at")
    assert judged(sp.And(x > 0, x * y >= 1)).startswith("False at")
    assert judged(sp.And(x > 0, x * y > 1.004)).endswith(" points to three digits")


def test_what_is_no_polynomial_is_tried():
    assert judged(sp.And(x > 0, sp.log(x * y) > 0)).startswith("agrees at ")
    assert judged(sp.And(x > 0, sp.log(x * y) > sp.Rational(1, 100))).startswith("True at")


def test_a_truth_that_says_nothing_anywhere_makes_no_verdict():
    with pytest.raises(RuntimeError):
        judged(x > 0, ReferenceCondition(at=lambda values: None))


def test_what_holds_for_every_value_of_an_unknown():
    """y^2 + x y + 1 > 0 for all y exactly if |x| < 2."""
    above = y**2 + x * y + 1 > 0
    truth = ReferenceCondition(
        (Case(above, (y,), every=True),),
        (Case(sp.Not(above), (y,)),),
        lambda values: bool(values[x] ** 2 < 4),
    )
    assert judged(sp.Abs(x) < 2, truth, [x]) == "proved for all values"
    assert judged(sp.Abs(x) <= 2, truth, [x]).startswith("False at {x: ")
    assert judged(sp.Abs(x) < 1, truth, [x]).startswith("True at {x: ")


def test_an_angle_is_a_point_of_the_circle():
    truth = exactly(sp.cos(2 * x) > 0)
    assert judged(sp.Abs(sp.tan(x)) < 1, truth, [x]) == "proved for all values"
    assert judged(sp.cos(x) ** 2 > sp.sin(x) ** 2, truth, [x]) == "proved for all values"
    assert judged(sp.cos(x) > sp.sin(x), truth, [x]).startswith(("True at", "False at"))
    assert "at" in judged(sp.Abs(x) < 1, truth, [x])  # an angle beside its sine is tried


def test_what_the_data_assume_of_a_symbol_holds():
    truth = exactly(positive**2 > 4)
    assert judged(positive > 2, truth, [positive]) == "proved for all values"


def test_what_a_system_hides_at_an_irrational_value():
    """z = 2 x x1 + 2 x2 loses an eigenvalue of [[0, 1], [2, 0]] exactly for x^2 = 2."""
    system = Linear([[0, 1], [2, 0]], H=[[2 * x, 2]])
    pair = pair_of(system.A, system.H, [x])
    assert [
        pair.dimension_at({x: value}) for value in (sp.sqrt(2), -sp.sqrt(2), sp.Rational(7, 5))
    ] == [1, 1, 0]
    assert checks.observable_parameters(sp.Ne(x**2, 2), system, [x]).status == "right"
    for wrong in (True, sp.Ne(x, sp.sqrt(2)), sp.And(sp.Ne(x**2, 2), sp.Ne(x, 1000))):
        assert checks.observable_parameters(wrong, system, [x]).status == "wrong"


def test_the_largest_invariant_subspace():
    A = [[Fraction(a) for a in row] for row in ([0, 1, 0], [1, 1, 1], [1, 0, 1])]
    (vector,) = unobservable_subspace(A, [[Fraction(0), Fraction(1), Fraction(0)]])
    assert vector[0] == -vector[2] and vector[1] == 0
    assert restricted(A, [vector]) == [[0]]
    assert characteristic_coefficients(A) == [1, -2, 0, 0]
    assert kernel([], 2) == [[1, 0], [0, 1]]


angle = sp.Symbol("alpha", real=True)
COSINE = sp.And(0 <= angle, angle < 2 * sp.pi, sp.cos(angle) < positive)


@pytest.mark.parametrize(
    "claim",
    [
        sp.cos(angle) < positive,
        sp.And(angle > sp.acos(positive), angle < 2 * sp.pi - sp.acos(positive)),
        sp.And(
            angle > sp.pi / 2 - sp.asin(positive), 2 * angle < 3 * sp.pi + 2 * sp.asin(positive)
        ),
        sp.And(sp.acos(positive) - angle < 0, -angle > -2 * sp.pi + sp.acos(positive)),
        sp.And(
            angle > sp.atan(sp.sqrt(1 - positive**2) / positive),
            angle + sp.acos(positive) < 2 * sp.pi,
        ),
        sp.Or(
            sp.And(angle > sp.acos(positive), angle <= sp.pi),
            sp.And(angle > sp.pi, sp.cos(angle) < positive),
        ),
    ],
)
def test_angles_are_compared_on_the_circle(claim):
    truth = ReferenceCondition(
        *(
            (Case(sp.And(0 <= angle, angle < 2 * sp.pi, positive < 1, part), angles=(angle,)),)
            for part in (COSINE, sp.Not(COSINE))
        )
    )
    assert judged(claim, truth, (angle, positive)) == "proved for all values"


@pytest.mark.parametrize(
    "claim",
    [
        angle > sp.acos(positive),
        sp.And(angle >= sp.acos(positive), angle < 2 * sp.pi - sp.acos(positive)),
        sp.And(angle > sp.acos(positive), angle < 6),
        sp.And(angle > sp.acos(positive), angle < sp.pi + sp.acos(positive)),
        sp.And(sp.cos(angle) < positive, angle < sp.Rational(157, 25)),
        sp.And(sp.cos(angle) < positive, sp.Ne(angle, 3)),
    ],
)
def test_a_condition_on_angles_that_errs_is_refuted(claim):
    truth = ReferenceCondition(
        *(
            (Case(sp.And(0 <= angle, angle < 2 * sp.pi, positive < 1, part), angles=(angle,)),)
            for part in (COSINE, sp.Not(COSINE))
        )
    )
    assert judged(claim, truth, (angle, positive)).startswith(("True at", "False at"))


@pytest.mark.timeout(100)
def test_a_question_with_large_polynomials_ends_soon():
    """Four lines of sight in space, by their Gram determinant: z3 alone takes minutes."""
    r = sp.symbols("r1:4", real=True)
    rows = sp.Matrix(
        [
            [a - one for a, one in zip(point, r)]
            for point in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (x, x, x))
        ]
    )
    gram = sp.expand((rows.T * rows).det())
    plane = sp.Ne((sum(r) - 1) ** 2 + (3 * x - 1) ** 2, 0)
    assert judged(plane, exactly(sp.Ne(gram, 0)), [*r, x]).startswith(("proved", "agrees"))
    assert judged(sp.Ne(sum(r), 1), exactly(sp.Ne(gram, 0)), [*r, x]).startswith("True at")
    large = sum((k + 1) * r[k % 3] ** (k % 7) * r[k % 2] for k in range(60)) ** 6
    assert judged(sp.Ne(large, 0), exactly(sp.Ne(large**2, 0)), r).startswith(("proved", "agrees"))


def test_a_sum_of_squares_vanishes_where_all_of_them_do():
    cross = exactly(sp.Or(sp.Ne(x, 1), sp.Ne(y, 2)))
    for claim in (
        sp.Ne((x - 1) ** 2 + 3 * (y - 2) ** 4, 0),
        sp.Not(sp.Eq((x - 1) ** 2 + (2 - y) ** 2, 0)),
    ):
        assert judged(claim, cross) == "proved for all values"
    assert judged(sp.Ne((x - 1) ** 2 - (y - 2) ** 2, 0), cross).startswith("True at")


def test_families_of_rest_points_are_decided():
    """A driven pendulum and a spring, with friction, in decimals and by one formula."""
    n = sp.Symbol("n", integer=True)
    k, d = sp.symbols("k d", positive=True)
    driven, spring = sp.Matrix([y, k - sp.sin(2 * x) - d * y]), sp.Matrix([y, x - k * x**3 - d * y])
    half, root = sp.asin(k) / 2, 1 / sp.sqrt(k)
    stable, unstable = "asymptotically stable", "unstable"
    for kind, claim, proved in (
        (stable, [half + sp.pi * n], True),
        (unstable, [sp.pi / 2 - half - sp.pi * n], True),
        (None, [half + sp.pi * n, half + sp.pi / 2 - 2 * half - sp.pi * n], True),
        (None, [(-1) ** n * half + sp.pi * n / 2], False),
    ):
        verdict = checks.equilibrium_values(claim, driven, [x, y], [k, d], (), n, kind)
        assert (verdict.status, "proved" in verdict.message) == ("right", proved), verdict
    for kind, claim, status, proved in (
        (None, [0, root, -root], "right", True),
        (stable, [root, -root], "right", True),
        (unstable, 0, "right", True),
        (None, [0, root, -1.0 * root], "right", False),
        (None, [0, root + sp.Max(0, k - 10**6), -root], "wrong", False),
    ):
        verdict = checks.equilibrium_values(claim, spring, [x, y], [k, d], kind=kind)
        assert (verdict.status, "proved" in verdict.message) == (status, proved), verdict


@pytest.mark.parametrize("margin, told", [(0, "exactly 0"), (1, "0")])
def test_a_root_on_the_imaginary_axis_is_told_without_rounding(margin, told):
    pendulum = Spectrum(sp.Matrix([[0, 1], [-x, -y]]), [x, y], margin)
    assert (
        pendulum.describe({x: sp.Integer(1), y: sp.Integer(0)})
        == f"the largest real part of a root is {told}"
    )


@pytest.mark.parametrize("no_z3", [False, True])
@pytest.mark.parametrize(
    ("claim", "border"),
    [(x > 1, x - 2), (x > 0, x - 2), (sp.true, x - 2), (sp.And(x > 2, y > -1), y), (x > 3, x - 2)],
)
def test_a_point_on_a_border_of_the_reference_is_named_only_where_there_is_no_other(
    claim, border, no_z3, monkeypatch
):
    """It would tell the right number: the region x > 2 is not to be read off "not stable at x = 2"."""
    if no_z3:
        monkeypatch.setitem(sys.modules, "z3", None)
    truth = exactly(sp.And(x > 2, y > 0) if y in border.free_symbols else x > 2)
    points = []
    with pytest.raises(Wrong):
        compare(claim, [x, y], truth, lambda values, holds: points.append(values) or "")
    assert border.xreplace(points[0]) != 0
    # the claim differs on its own border alone
    with pytest.raises(Wrong):
        compare(x >= 2, [x, y], exactly(x > 2), lambda values, holds: points.append(values) or "")
    assert points[-1][x] == 2
