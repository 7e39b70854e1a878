"""Where the solver z3 is absent conditions have the same verdicts: cells decide, or samples agree."""

import re
import sys

import pytest
import sympy as sp
from case import check_named
from case_tables import CASES, LONG

from trajlib.pontryagin import Problem
from workbook import checks
from workbook.checks.references.optima.transfer_optima import Transfer
from workbook.checks.references.spectra import Spectrum
from workbook.systems import Controlled

pytestmark = pytest.mark.slow

CONDITIONS = [
    case
    for case in CASES
    if case.verdict in ("right", "wrong")
    and isinstance(case.answer, sp.logic.boolalg.Boolean)
    and check_named(case.check).__module__.split(".")[-2] not in LONG
]


@pytest.mark.parametrize("case", CONDITIONS, ids=lambda case: f"{case.check}: {case.note}")
def test_a_condition_has_the_same_verdict(case, monkeypatch):
    monkeypatch.setitem(sys.modules, "z3", None)
    verdict = check_named(case.check)(case.answer, *case.data, **dict(case.options))
    if "thinner than all floats" in case.note:  # and than all digits of the roots: sampled
        assert re.search(r"agrees at \d+ points$", verdict.message)
    else:
        assert verdict.status == case.verdict, verdict.message


@pytest.mark.parametrize(
    "case",
    [case for case in CASES if "irrational value left out" in case.note],
    ids=lambda case: f"{case.check}: {case.note}",
)
def test_an_irrational_value_left_out_is_found(case, monkeypatch):
    monkeypatch.setitem(sys.modules, "z3", None)
    verdict = check_named(case.check)(case.answer, *case.data, **dict(case.options))
    assert verdict.status == "wrong", verdict.message


@pytest.mark.parametrize(
    "claim, status, evidence",
    [
        ("k**2 < 8*k1**2", "right", "proved for all values"),
        ("k < 2.83*k1", "right", "to three digits, for all values"),
        ("k**2 < 7*k1**2", "wrong", "your condition does not hold"),
    ],
)
def test_an_angle_that_linear_equations_determine_is_eliminated(
    claim, status, evidence, monkeypatch
):
    """Gliding flight; with the half-angle tangent the projection would be too large."""
    monkeypatch.setitem(sys.modules, "z3", None)
    k, k1, g, v = sp.symbols("k k1 g v", positive=True)
    theta = sp.Symbol("theta", real=True)
    field = sp.Matrix([k1 * v - g * sp.cos(theta) / v, -k * v**2 - g * sp.sin(theta)])
    domain = {theta: sp.Interval.Lopen(-sp.pi, sp.pi), v: sp.Interval.open(0, sp.oo)}
    answer = sp.sympify(claim, {"k": k, "k1": k1})
    verdict = checks.equilibrium_condition(
        answer, field, [theta, v], [k, k1, g], domain, kind="focus"
    )
    assert verdict.status == status and verdict.message.endswith(evidence)


def test_a_root_next_to_the_axis_is_decided_exactly(monkeypatch):
    monkeypatch.setitem(sys.modules, "z3", None)
    e = sp.Symbol("epsilon", real=True)
    spectrum = Spectrum(sp.Matrix([[0, 1], [-1, e]]), [e], 0)
    at = [spectrum.is_unstable({e: sp.Rational(k, 5 * 10**6)}) for k in (-1, 0, 1)]
    assert at == [False, False, True]


@pytest.mark.parametrize("rate, expected", [("u - x1", "True"), ("u + x2", "Abs(x2) < 1")])
def test_a_start_far_away_can_reach_the_origin(rate, expected, monkeypatch):
    """Sampled directions suffice for limited times only; the modes decide for all starts."""
    monkeypatch.setitem(sys.modules, "z3", None)
    state = x1, x2 = sp.symbols("x1 x2", real=True)
    u = sp.Symbol("u", real=True)
    names = {"x1": x1, "x2": x2, "u": u}
    system = Controlled({x1: x2, x2: sp.sympify(rate, names)}, {u: (-1, 1)})
    problem = Problem(*system, {x1: None, x2: None}, [x1, x2])
    transfer = Transfer(problem, tuple(state))
    assert transfer.solvable({x1: sp.Integer(-(10**6)), x2: sp.Rational(3, 4)}) is True
    claim = sp.sympify(expected, names)
    assert checks.transferable_initial_states(claim, problem, list(state)).status == "right"
    too_wide = sp.sympify("Abs(x2) < 2", names)
    verdict = checks.transferable_initial_states(too_wide, problem, list(state))
    assert verdict.status == "wrong"
