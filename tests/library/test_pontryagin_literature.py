"""Hard problems of the literature, compared with independent references."""

import itertools
import time
from dataclasses import dataclass

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve

from trajlib.pontryagin import Infeasible, NotUnique, Problem

pytestmark = pytest.mark.slow
R = sp.Rational
x, y, v, w, t, c, k, u = sp.symbols("x y v w t c k u")
x1, x2, x3, x4, x5, x6, u1, u2, u3 = sp.symbols("x1:7 u1:4")
ONE, HALF = {u: (-1, 1)}, {u: (0, 1)}


@dataclass
class Case:
    """A problem with its least cost, switching times (None: not compared), seconds, and source.

    The cost may be a function that finds it; the seconds are the processor time that it may take.
    """

    problem: Problem
    cost: object
    times: list | None
    seconds: float
    source: str


def motion(rate, start, until):
    return solve_ivp(rate, (0, until), start, rtol=1e-12, atol=1e-14, method="DOP853").y[:, -1]


def chain_of_three():
    """psi_3 = s^3/6, s = 3 - t, and u = min(1, psi_3): int u^2/2 - psi_3 u."""
    s = 6 ** (1 / 3)
    return -(s**7) / 504 + (3 - s) / 2 - (81 - s**4) / 24


def ramsey():
    """k' = sqrt(k) - c, k from 1/10 to 1/10 in 10 units; the gain log(c) exp(-t/20).

    c' = c (1/(2 sqrt(k)) - 1/20).
    """

    def run(first):
        def rate(s, z):
            root = np.sqrt(z[0])
            return [root - z[1], z[1] * (1 / (2 * root) - 0.05), np.exp(-s / 20) * np.log(z[1])]

        def spent(s, z):
            return z[0] - 0.05

        spent.terminal = True
        return solve_ivp(
            rate, (0, 10), [0.1, first, 0], events=spent, rtol=1e-12, atol=1e-14, method="DOP853"
        )

    def left(first):
        done = run(first)
        return done.y[0, -1] - 0.1 if done.t[-1] == 10 else done.t[-1] - 10

    return run(brentq(left, 0.05, 0.2, xtol=1e-16, rtol=1e-15)).y[2, -1]


def arm():
    """Each joint turns at its bound, with one change or two, placed symmetrically.

    The moments of inertia come from the others.
    """

    def ends(z):
        T, first = z
        state = np.array([4.5, 0, np.pi / 4, 0, 0, 0])
        cuts = [0, T / 4, first, T / 2, T - first, 3 * T / 4, T]
        for begin, end in itertools.pairwise(cuts):
            middle = (begin + end) / 2
            pull = 1 if T / 4 < middle < 3 * T / 4 else -1
            swing = 1 if middle < T / 2 else -1
            lift = 1 if first < middle < T - first else -1

            def rate(s, q):
                inertia = ((5 - q[0]) ** 3 + q[0] ** 3) / 3
                return [*q[3:], pull / 5, swing / (inertia * np.sin(q[2]) ** 2), lift / inertia]

            state = motion(rate, state, end - begin)
        return state[[1, 2]] - [2 * np.pi / 3, np.pi / 4]

    return fsolve(ends, [9.1, 2.6], xtol=1e-13)[0]


def reach():
    inertia = ((5 - x1) ** 3 + x1**3) / 3
    return Problem(
        {
            x1: x4,
            x2: x5,
            x3: x6,
            x4: u1 / 5,
            x5: u2 / (inertia * sp.sin(x3) ** 2),
            x6: u3 / inertia,
        },
        {u1: (-1, 1), u2: (-1, 1), u3: (-1, 1)},
        {x1: R(9, 2), x2: 0, x3: sp.pi / 4, x4: 0, x5: 0, x6: 0},
        [x1 - R(9, 2), x2 - 2 * sp.pi / 3, x3 - sp.pi / 4, x4, x5, x6],
    )


CASES = {
    "a switching function with a threefold zero at the end": Case(
        Problem({x: v, v: w, w: u}, HALF, {x: 0, v: 0, w: 0}, running=u**2 / 2 - x, duration=3),
        chain_of_three,
        [3 - 6 ** (1 / 3)],
        3,
        "by hand",
    ),
    "a bound that is touched": Case(
        Problem({x: u, t: 1}, HALF, {x: 0, t: 0}, running=u**2 / 2 - u * (t - 1) ** 4, duration=2),
        -1 / 9,
        [],
        3,
        "u = (t - 1)^4",
    ),
    "Ramsey": Case(
        Problem(
            {k: sp.sqrt(k) - c, t: 1},
            {c: (R(1, 100), None)},
            {k: R(1, 10), t: 0},
            [k - R(1, 10)],
            running=sp.exp(-t / 20) * sp.log(c),
            duration=10,
            maximise=True,
        ),
        ramsey,
        [],
        3,
        "shooting",
    ),
    "robot arm": Case(reach(), arm, None, 5, "the arm of the collection COPS: two equations"),
}


@pytest.mark.parametrize("name", CASES)
def test_cost(name):
    case = CASES[name]
    start = time.process_time()
    extremal = case.problem.solve()
    assert time.process_time() - start < case.seconds
    cost = case.cost() if callable(case.cost) else case.cost
    assert extremal.cost == pytest.approx(cost, rel=1e-10)
    if case.times is not None:
        assert extremal.switching_times == pytest.approx(case.times, abs=1e-9)
    assert extremal.certificate().holds()


@pytest.mark.parametrize("duration, action", [(5, 0.85713996), (20, 0.68009388)])
def test_maier_stein(duration, action):
    """The most likely way out of a well of the Maier-Stein system, which bends off the axis.

    Least action of paths by the midpoint rule on up to 1600 intervals, extrapolated; Heymann and
    Vanden-Eijnden (2008) discuss the system.
    """
    extremal = Problem(
        {x: x - x**3 - 10 * x * y**2 + u1, y: -(1 + x**2) * y + u2},
        {u1: None, u2: None},
        {x: -1, y: 0},
        [x - 1, y],
        running=u1**2 + u2**2,
        duration=duration,
    ).solve()
    assert extremal.cost == pytest.approx(action, rel=2e-8)
    assert extremal.certificate().holds() and extremal.optimality.kind == "locally minimal"


def turn():
    """Four arcs with u = -1, 1, -1, 1 that end at rest at (1, 1), a right angle turned."""

    def ends(lengths):
        state = np.zeros(4)
        for length, pull in zip(lengths, (-1, 1, -1, 1)):
            state = motion(lambda s, q: [np.cos(q[2]), np.sin(q[2]), q[3], pull], state, length)
        return state - [1, 1, np.pi / 2, 0]

    return sum(fsolve(ends, [1.1, 3.1, 3.1, 1.1], xtol=1e-13))


def test_a_process_found_late_leads_to_better_ones():
    """Turning with a bounded angular acceleration, from rest to rest.

    Only the ladder of durations finds a process, one of 19.2 with idle loops, from which others are
    found, of 10.34, and then the best (SLSQP from random lengths of four to seven arcs found none
    better).
    """
    extremal = Problem(
        {x: sp.cos(v), y: sp.sin(v), v: w, w: u},
        ONE,
        {x: 0, y: 0, v: 0, w: 0},
        [x - 1, y - 1, v - sp.pi / 2, w],
    ).solve()
    assert extremal.cost == pytest.approx(turn(), rel=1e-10) and extremal.certificate().holds()
    assert extremal.optimality.processes > 1 and "a better process is not excluded" in str(
        extremal.optimality
    )


@pytest.mark.parametrize(
    "problem, error, message",
    [
        # Whoever brakes with u >= 0 from the speed -1 needs the fuel 1, however long it takes.
        (
            Problem({x1: x2, x2: u}, ONE, {x1: 1, x2: -1}, [x1, x2], running=sp.Abs(u)),
            NotUnique,
            "duration is left open.* cost the same, about 1,",
        ),
        (
            Problem(
                {x: u, y: v * x}, {u: (-1, 1), v: (-1, 1)}, {x: 0, y: 0}, [x + y - 1, x + y - 2]
            ),
            Infeasible,
            "contradict one another",
        ),
    ],
    ids=["fuel alone", "two ends at once"],
)
def test_reason_without_an_extremal(problem, error, message):
    with pytest.raises(error, match=message):
        problem.solve()
