"""What has no value is told so: infinite, undefined or enormous answers are never right, and never
left unchecked."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from case import check_named

from workbook import checks
from workbook.checks.contract.verdict import Invalid, Wrong
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import matrix_at, number_at, numbers_at, truth_at, value_at

x, y, t = sp.symbols("x y t", real=True)
UNDEFINED = sp.Add(sp.oo, -sp.oo, evaluate=False)
NEVER = sp.Piecewise((x, x > 10**9))
VALUELESS = [
    UNDEFINED,
    sp.Mul(0, sp.oo, evaluate=False),
    sp.Pow(0, -1, evaluate=False),
    sp.oo,
    -sp.oo,
    sp.I * sp.oo,
    sp.nan,
    sp.log(0, evaluate=False),
    NEVER,
    x + UNDEFINED,
    1 / sp.Add(x, -x, evaluate=False),
    sp.sinh(sp.cosh(100 + x**2)),
]
HUGE = sp.Integer(10) ** 200


def cases(name):
    path = Path(__file__).parent / "cases" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(f"data_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("claim", VALUELESS, ids=str)
def test_no_number_leaves_that_is_not_finite(claim):
    values = {x: sp.Rational(3, 7)}
    for read in (number_at, lambda claim, values: value_at(claim, values, "the height")):
        with pytest.raises(
            Wrong,
            match="(undefined|infinite|larger than 1e.50) at x = 0.429, where it should have a "
            "value",
        ):
            read(claim, values)
    assert real_at(claim, values) is None
    assert np.isnan(real_function([x], [claim])(0.43)).all()
    assert np.isnan(real_function([x], [claim])(np.array([0.43, 1.0]))).all()


def test_the_entry_is_named():
    with pytest.raises(
        Wrong, match=r"the entry \(2, 1\) of your matrix is undefined at x = 2, where"
    ):
        matrix_at(sp.ImmutableMatrix([[x, 1], [NEVER, 2]]), {x: 2})
    with pytest.raises(Wrong, match="your component 2 is infinite; it should"):
        numbers_at([sp.Integer(1), sp.oo], {})
    with pytest.raises(Wrong, match="your x' is undefined at"):
        numbers_at([NEVER], {x: 1}, ["x'"])


def test_what_has_a_value_is_read():
    assert number_at(x + sp.I, {x: 1}) == 1 + 1j and value_at(sp.sqrt(x), {x: 4}, "it") == 2
    assert matrix_at(sp.Matrix([[x, 1], [0, 2]]), {x: 3}).tolist() == [[3, 1], [0, 2]]
    assert value_at(sp.Piecewise((x, x < sp.oo), (1 / x, True)), {x: 2}, "it") == 2
    assert number_at(sp.Piecewise((1, sp.sqrt(x) > 1), (0, True)), {x: 4}) == 1
    # one case is not asked where it is undefined
    quotient = real_function([x], [sp.Piecewise((sp.sin(x) / x, sp.Ne(x, 0)), (1, True))])
    assert quotient(0.0)[0] == 1 and quotient(np.array([0.0, 1.0]))[0, 1] == pytest.approx(
        math.sin(1)
    )
    assert np.isnan(real_function([x], [sp.sqrt(x)])(-1.0)[0])
    for claim in (sp.AccumBounds(0, 1), x + y):
        with pytest.raises(Invalid, match="number"):
            number_at(claim, {x: 1})


def test_a_condition_with_an_undefined_term_does_not_hold():
    assert truth_at(NEVER > 0, {x: 1}) is False and truth_at(x > 0, {x: 1}) is True
    z = sp.Symbol("z")
    assert truth_at(z ** sp.Rational(1, 2) > 0, {z: -1}) is False
    assert truth_at(sp.Integral(z, (z, 0, 2)) > z, {z: 1}) is True  # bound in the integral


LAW = cases("pontryagin/syntheses")
MOVE, SEEN, SOLVED = map(
    cases, ("pontryagin/transfers", "structure/observability", "research/conditioning")
)
SPLINE, PLANE = cases("research/reconstruction"), cases("stability/phase_plane")
LINES, FLAT = cases("stability/critical"), cases("stability/linearisation")
LISTS, POINT = cases("stability/equilibrium_values"), cases("stability/equilibria")
VARIED = cases("pontryagin/functionals")
STRIP = sp.Piecewise((LAW.TO_ORIGIN, sp.Abs(LAW.x1 - sp.Rational(1, 2)) > sp.Rational(1, 25)))
SIDES = LAW.x1 + LAW.x2 * sp.Abs(LAW.x2) / 2
PUSH = sp.Piecewise((-1, MOVE.t < 1), (1, MOVE.t > 1))
LATE = sp.Piecewise((-1, MOVE.t < 1), (1, MOVE.t > sp.Rational(21, 20)))


@pytest.mark.parametrize(
    "check, answer, data, verdict, said",
    [
        ("time_optimal_law", STRIP, LAW.ORIGIN, "wrong", "no real number"),
        (
            "time_optimal_law",
            sp.Piecewise((-1, SIDES > 0), (1, SIDES < 0)),
            LAW.ORIGIN,
            "right",
            "shortest",
        ),
        (
            "time_optimal_law",
            sp.Piecewise((LAW.TO_ORIGIN, LAW.x2 < 9), (sp.oo, True)),
            LAW.ORIGIN,
            "wrong",
            "no real number",
        ),
        ("optimal_control", PUSH, (MOVE.REST, MOVE.t), "right", "admissible"),
        ("optimal_control", LATE, (MOVE.REST, MOVE.t), "wrong", "your control is no real number"),
        (
            "optimal_control",
            [(-1, 1), (1, sp.oo)],
            (MOVE.REST, MOVE.t),
            "wrong",
            "the end of your arc number 2",
        ),
        ("unobservable_states", [HUGE, HUGE, HUGE, HUGE], SEEN.PLATFORM, "wrong", "larger than"),
        (
            "unobservable_states",
            [0, 10**9, 0, 10**9 * SEEN.g],
            SEEN.PLATFORM,
            "right",
            "z stays zero",
        ),
        ("research.bound_violating_error", [0, 0, HUGE], SOLVED.BOUND, "invalid", "below 1e+50"),
        ("research.multiple_eigenvalues", HUGE, SPLINE.MULTIPLE, "invalid", "below 1e+50"),
        (
            "unbounded_motion",
            [HUGE * LINES.t**2, HUGE],
            (*LINES.DRIFT, LINES.t),
            "wrong",
            "larger than 1e+50",
        ),
        (
            "linearisation",
            [[0, 1], [-HUGE, -HUGE]],
            FLAT.BOTTOM,
            "wrong",
            "the entry (2, 1) of your matrix",
        ),
        ("equilibrium_values", [sp.pi * LISTS.n, HUGE], LISTS.PENDULUM, "wrong", "larger than"),
        ("equilibrium_values", [sp.pi * LISTS.n, sp.oo], LISTS.PENDULUM, "wrong", "infinite"),
        ("equilibrium_values", [HUGE**2], LISTS.PENDULUM, "wrong", "larger than 1e+50"),
        ("time_optimal_law", HUGE**2, LAW.ORIGIN, "wrong", "too large to be computed with"),
        ("minimal_time", HUGE**2, LAW.ORIGIN, "wrong", "too large to be computed with"),
        ("optimal_motion", HUGE**2 * MOVE.t, (MOVE.REST, MOVE.t), "wrong", "too large"),
        ("optimal_control", [(HUGE, HUGE**2)], (MOVE.REST, MOVE.t), "wrong", "too large"),
        ("extremum_motion", HUGE**2 * VARIED.t, (VARIED.GROWTH,), "wrong", "too large"),
        ("extremum_motion", 1 + HUGE * VARIED.t, (VARIED.GROWTH,), "wrong", "too large"),
        ("extremum_value", HUGE**2, (VARIED.GROWTH,), "wrong", "too large to be computed with"),
        ("equilibrium_value", HUGE**2, (POINT.P, *POINT.ROCKET), "wrong", "too large"),
        (
            "first_integral",
            PLANE.k1 * PLANE.v**3 / 3 - PLANE.g * PLANE.v * sp.cos(PLANE.theta) + sp.oo,
            PLANE.NO_DRAG,
            "wrong",
            "no real number",
        ),
        (
            "first_integral",
            PLANE.k1 * PLANE.v**3 / 3
            - PLANE.g * PLANE.v * sp.cos(PLANE.theta)
            + sp.log(sp.Abs(PLANE.v) - PLANE.v),
            PLANE.NO_DRAG,
            "wrong",
            "no real number",
        ),
    ],
)
def test_answers_that_are_undefined_where_it_matters(check, answer, data, verdict, said):
    found = check_named(check)(answer, *data)
    assert (found.status, said in found.message) == (verdict, True), found


@pytest.mark.parametrize(
    "answer",
    [
        sp.Eq(x > 0, sp.true),
        sp.Ne(x > 0, sp.false),
        sp.And(x < 1, sp.Eq(x > 0, True)),
        sp.Eq(x > 0, y > 0),
    ],
)
def test_an_equation_between_conditions_is_no_condition(answer):
    found = checks.stability_region(answer, sp.Symbol("s") ** 2 + sp.Symbol("s") + x + y, [x, y])
    assert found.status == "invalid" and "write the condition itself" in found.message
    found = checks.stability_region(
        sp.Gt(x + y, UNDEFINED, evaluate=False),
        sp.Symbol("s") ** 2 + sp.Symbol("s") + x + y,
        [x, y],
    )
    assert found.status == "invalid" and "undefined value" in found.message
