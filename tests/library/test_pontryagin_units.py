"""One problem in other numbers: other units of the cost, of length and time, another origin.

Each problem with a reference is stated anew with y = k Y + a, u = r U, t = tau t', J' = s J + b, and
is to have the same arcs and digits. `make test-units` runs all of them, `make test` a sample.
"""

import itertools
import os
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from optimal_control_records import CONSTRAINED, INTEGRATED, UNCONSTRAINED, record
from test_pontryagin_book_problems import BOOK_PROBLEMS
from test_pontryagin_extremals import RECORDS

from trajlib.pontryagin import Problem

pytestmark = pytest.mark.slow
R = sp.Rational
x, v, u = sp.symbols("x v u")
PROBLEMS = {
    **{name: (extremal.problem, 1e-11) for name, extremal in RECORDS.items()},
    **{name: (problem.problem, problem.accuracy) for name, problem in BOOK_PROBLEMS.items()},
}
# Their second route is computed where the problem is restated.
LITERATURE = [*UNCONSTRAINED, *CONSTRAINED, *INTEGRATED]
# The relative accuracy of costs.
ACCURACY = 1e-10
NUMBERS = {
    "nanojoules": {"cost": 10**9},
    "gigajoules": {"cost": R(1, 10**9)},
    "a constant cost": {"constant": 1000},
    "micrometres": {"length": R(1, 10**6)},
    "thousand kilometres": {"length": 10**6},
    "milliseconds": {"time": R(1, 1000)},
    "days": {"time": 86400},
    "all at once": {"length": R(1, 1000), "time": 3600, "cost": 10**5},
    "another origin": {"origin": 10},
}


def restated(problem, length=1, time=1, cost=1, constant=0, origin=0):
    """Return the problem for Y with y = length Y - origin, t = time t', J' = cost J + constant.

    Controls have the unit length/time, so that velocities keep their numbers.
    """
    table = {y: length * y - origin for y in problem.state}
    table |= {u: length / sp.sympify(time) * u for u in problem.control}

    def substituted(e):
        return sp.sympify(e).subs(table, simultaneous=True)

    unit, duration = length / sp.sympify(time), problem.duration
    if isinstance(duration, tuple):
        duration = tuple(d / time for d in duration)
    elif duration is not None:
        duration = duration / time
    return replace(
        problem,
        dynamics={y: substituted(f) * time / length for y, f in problem.dynamics.items()},
        controls={
            u: tuple(substituted(bound) / unit for bound in bounds)
            for u, bounds in problem.controls.items()
        },
        initial={
            y: None if v is None else (v + origin) / length for y, v in problem.initial.items()
        },
        terminal=[substituted(g) for g in problem.terminal],
        path=[sp.LessThan(substituted(g), 0, evaluate=False) for g in problem.constraints],
        terminal_inequalities=[
            sp.LessThan(substituted(g), 0, evaluate=False) for g in problem.end_constraints
        ],
        running=substituted(problem.running) * cost * time,
        final=substituted(problem.final) * cost + constant,
        duration=duration,
    )


# Two processes that mirror one another, or infinitely many, cost the same: either may be found.
EQUALLY_GOOD = {"5.47", "5.48", "away from zero", "two values in any order"}
# u = (t - 1)^4 is within rounding errors of its bound 0 for a while; x = t - t^2 just reaches 1/4, so
# that the jump at the touch point is zero.
TOUCHING = {"a bound that is touched", "Bryson-Denham 1/4"}


def validate(name, numbers):
    """Compare the extremals of a problem and of the same in other numbers."""
    problem, accuracy = PROBLEMS[name] if name in PROBLEMS else (record(name).problem, 1e-10)
    extremal, restated_extremal = problem.solve(), restated(problem, **numbers).solve()
    unit, constant = float(numbers.get("cost", 1)), float(numbers.get("constant", 0))
    time, length = float(numbers.get("time", 1)), float(numbers.get("length", 1))
    size = abs(extremal.cost) + (abs(constant) or 0.1) / unit
    cost = (restated_extremal.cost - constant) / unit
    assert cost == pytest.approx(extremal.cost, abs=max(accuracy, ACCURACY) * size)
    assert restated_extremal.certificate().holds()
    assert restated_extremal.optimality.kind == extremal.optimality.kind
    assert restated_extremal.multiplier == extremal.multiplier
    assert time * restated_extremal.duration == pytest.approx(extremal.duration, rel=1e-8)
    start = length * restated_extremal.state(0) - float(numbers.get("origin", 0))
    assert start == pytest.approx(extremal.state(0), rel=1e-7, abs=1e-7)
    if name in EQUALLY_GOOD | TOUCHING:
        return
    assert [arc[0] for arc in restated_extremal.arcs] == [arc[0] for arc in extremal.arcs]
    assert time * np.array(restated_extremal.switching_times) == pytest.approx(
        np.array(extremal.switching_times), rel=1e-8, abs=1e-8 * extremal.duration
    )


NAMES = [*LITERATURE, *PROBLEMS]
# Every second problem in one kind of numbers, each kind for every ninth of them; make test-units
# takes each problem in all kinds.
CASES = (
    list(itertools.product(NAMES, NUMBERS))
    if os.environ.get("WORKBOOK_ALL_PROBLEMS")
    else list(zip(NAMES[::2], itertools.cycle(NUMBERS)))
)


@pytest.mark.parametrize("name, kind", CASES)
def test_same_digits_in_other_numbers(name, kind):
    validate(name, NUMBERS[kind])


@pytest.mark.parametrize("power", range(-9, 10, 3))
def test_size_of_the_cost(power):
    """x' = u from 1/2 to zero, J = s int x^2."""
    extremal = Problem(
        {x: u}, {u: (-1, 1)}, {x: R(1, 2)}, running=R(10) ** power * x**2, duration=1
    ).solve()
    assert extremal.cost == pytest.approx(10.0**power / 24, rel=1e-13)
    assert extremal.switching_times == pytest.approx([0.5], rel=1e-9)
    assert extremal.optimality.proved and extremal.certificate().holds(1e-11)


@pytest.mark.parametrize("distance", [R(1, 10**9), R(1, 10**6), 10**6, 10**9])
def test_carriage_from_rest_to_rest(distance):
    extremal = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 0, v: 0}, [x - distance, v]).solve()
    assert extremal.duration == pytest.approx(2 * float(distance) ** 0.5, rel=1e-13)
    assert extremal.optimality.proved and extremal.certificate().holds(1e-11)


def test_a_cost_that_is_positive_is_not_the_time():
    """An integrand of real symbols may be positive without being a number."""
    x_real, u_real = sp.symbols("x u", real=True)
    extremal = Problem(
        {x_real: u_real}, {u_real: (-1, 1)}, {x_real: 1}, [x_real], running=1 + x_real**2
    ).solve()
    assert extremal.cost == pytest.approx(4 / 3, rel=1e-12)


@pytest.mark.parametrize("unit", [1, 1000])
def test_terminal_multipliers_are_those_of_the_costate(unit):
    """psi(T) + sum of lambda_i grad phi_i = 0, in the user's units."""
    plant, start = {x: v, v: u}, {x: 0, v: 0}
    problems = [
        Problem(
            plant, {u: (-unit, unit)}, start, [7 * x - 7 * unit, v / 3], running=1 + u**2 / unit**2
        ),
        Problem(
            plant,
            {u: None},
            start,
            [7 * x - 7 * unit],
            running=u**2 / unit**2,
            duration=1,
            terminal_inequalities=[5 * v <= unit],
        ),
    ]
    for problem, normals in zip(problems, ([[7, 0], [0, 1 / 3]], [[7, 0], [0, 5]])):
        extremal = problem.solve()
        multipliers = np.array(extremal.terminal_multipliers)
        assert np.abs(multipliers).min() > 1e-6
        assert extremal.costate(extremal.duration) == pytest.approx(
            -multipliers @ normals, rel=1e-9
        )


@pytest.mark.parametrize("unit", [1, 1000])
def test_times_are_those_of_the_process(unit):
    extremal = Problem({x: v, v: u}, {u: (-unit, unit)}, {x: 0, v: 0}, {x: unit, v: 0}).solve()
    end = extremal.duration
    functions = (extremal.state, extremal.costate, extremal.control, extremal.switching)
    for function in (*functions, extremal.hamiltonian, extremal.path_multiplier):
        assert np.allclose(function(end * (1 + 1e-12)), function(end))
        for t in (-1e-6 * end, (1 + 1e-6) * end, [0, 2 * end]):
            with pytest.raises(ValueError, match="t: expected times between 0 and the duration 2"):
                function(t)
