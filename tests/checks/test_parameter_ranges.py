"""Parameters of optimal processes may come as a list, or the check says in a sentence what to write."""

import inspect

import pytest
import sympy as sp
from case import CHECKS, check_named
from test_cases import CASES

from trajlib.pontryagin import Problem
from workbook import checks
from workbook.checks.contract.shapes import COMMON, RANGES
from workbook.checks.contract.verdict import UnsuitableData

x1, x2, u = sp.symbols("x1 x2 u")
L, T, t = sp.symbols("L T t", positive=True)
FREE, BOUNDED = (
    Problem({x1: x2, x2: u}, {u: bounds}, {x1: 0, x2: 0}, [x1 - L, x2], u**2, duration=T)
    for bounds in ((-sp.oo, sp.oo), (-9, 9))
)
CONTROL = 6 * L / T**2 - 12 * L * t / T**3
SPEED = sp.integrate(CONTROL, t)


@pytest.mark.parametrize(
    "name, right, wrong, data",
    [
        ("optimal_control", CONTROL, CONTROL * 1.1, [t]),
        ("optimal_cost", 12 * L**2 / T**3, 12 * L / T**3, []),
        ("optimal_duration", T, L, []),
        ("optimal_range", L, T, [x1]),
        ("optimal_motion", [sp.integrate(SPEED, t), SPEED], [SPEED, SPEED], [t]),
        ("optimal_costate", [24 * L / T**3, 2 * CONTROL], [0, 2 * CONTROL], [t]),
    ],
)
def test_a_list_is_taken_where_controls_are_free(name, right, wrong, data):
    check = getattr(checks, name)
    assert check(right, FREE, *data, [L, T]).status == "right"
    assert check(wrong, FREE, *data, (L, T)).status == "wrong"
    with pytest.raises(UnsuitableData, match=r"`\{L: ..., T: ...\}` with an interval"):
        check(right, BOUNDED, *data, [L, T])


#: The first right answer of each check with ranges as its parameters.
WITH_RANGES = {
    case.check: case
    for case in reversed(CASES)
    if case.verdict == "right"
    and f"parameters : {RANGES}" in check_named(case.check).__doc__
    and any(isinstance(datum, dict) for datum in case.data)
}


@pytest.mark.parametrize("name", WITH_RANGES)
def test_a_list_is_refused_where_ranges_are_needed(name):
    case, check = WITH_RANGES[name], check_named(name)
    bound = inspect.signature(check).bind(case.answer, *case.data, **dict(case.options)).arguments
    listed = bound | {"parameters": [L, T]}
    with pytest.raises(UnsuitableData, match=r"^parameters: .*`\{L: ..., T: ...\}` with"):
        check(*listed.values())


def test_every_check_of_processes_says_what_its_parameters_are():
    described = {
        line.strip()
        for name in CHECKS
        for line in check_named(name).__doc__.splitlines()
        if ".pontryagin." in check_named(name).__module__
        and line.strip().startswith("parameters : ")
    }
    kinds = (RANGES, COMMON["parameters"], f"{COMMON['parameters']}, or {RANGES}")
    assert described == {f"parameters : {kind}" for kind in kinds} and len(WITH_RANGES) > 10
