"""Linear plants with a quadratic cost, solved by one linear solve, against other routes."""

import itertools
from dataclasses import replace

import mpmath
import numpy as np
import pytest
import sympy as sp

from trajlib.pontryagin import Infeasible, Problem, Unbounded

pytestmark = pytest.mark.slow
R = sp.Rational
x, y, z, u, v, s = sp.symbols("x y z u v s")


def chain(n, start=1, duration=1):
    """The least energy of a chain of n integrators from x1 = start to rest at zero."""
    states = sp.symbols(f"x1:{n + 1}")
    return Problem(
        {**dict(itertools.pairwise(states)), states[-1]: u},
        {u: None},
        {state: start if state == states[0] else 0 for state in states},
        list(states),
        running=u**2 / 2,
        duration=duration,
    )


def chain_energy(n, start=1, duration=1):
    """x1(0)^2 (W^-1)_11 / 2, W being the Gramian of the states reached from zero."""
    response = sp.Matrix([s ** (n - 1 - i) / sp.factorial(n - 1 - i) for i in range(n)])
    gramian = (response * response.T).applyfunc(lambda e: sp.integrate(e, (s, 0, duration)))
    free = sp.eye(n)[:, 0] * start
    return (free.T * gramian.LUsolve(free))[0] / 2


@pytest.mark.parametrize("start", [1, R(1, 100), 10**6, R(1, 10**9)])
@pytest.mark.parametrize("n", range(1, 9))
@pytest.mark.timeout(60)
def test_chain_of_integrators(n, start):
    extremal = chain(n, start).solve()
    assert extremal.cost == pytest.approx(float(chain_energy(n, start)), rel=1e-15)
    assert extremal.optimality.proved and extremal.certificate().holds(1e-11)
    assert extremal.state(0) == pytest.approx([float(start)] + [0] * (n - 1))


@pytest.mark.parametrize("duration", [R(1, 1000), 1000])
def test_chain_in_other_times(duration):
    extremal = chain(5, 1, duration).solve()
    assert extremal.cost == pytest.approx(float(chain_energy(5, 1, duration)), rel=1e-15)
    assert extremal.certificate().holds(1e-11)


FAST = {x: y, y: -100 * x + u}
CASES = {
    "affine plant, mixed terms": Problem(
        {x: y + 1, y: -x + u - 2},
        {u: None},
        {x: 1, y: 0},
        [x + y - 1],
        running=u**2 + x * u / 2 + x**2 + 3 * x - u + 4,
        final=y**2 - y,
        duration=2,
    ),
    "largest": Problem(
        {x: u}, {u: None}, {x: 1}, running=-(x**2) - u**2 + 1, duration=1, maximise=True
    ),
    "free initial state": Problem(
        {x: y, y: u + v},
        {u: None, v: None},
        {x: None, y: 1},
        [x - 1],
        running=u**2 + 2 * v**2 + u * v + x**2,
        duration=3,
    ),
    "unstable, long": Problem(
        {x: 2 * x + u}, {u: None}, {x: 1}, [x - 3], running=x**2 + u**2, duration=30
    ),
    "cost that is not convex": Problem(
        {x: y, y: u - x}, {u: None}, {x: 1, y: 0}, [y], running=u**2 - x**2 / 4, duration=1
    ),
    "oscillator": Problem(FAST, {u: None}, {x: 1, y: 0}, [x, y], running=u**2, duration=5),
    "decimals and roots": Problem(
        {x: sp.sqrt(2) * y, y: 0.1 * u - sp.pi * x},
        {u: None},
        {x: 0.3, y: 0},
        [x - y],
        running=u**2 + 0.7 * y**2,
        duration=1.7,
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_search_finds_the_same(name):
    """With a structure the problem is solved by transcription and Newton's method."""
    problem = CASES[name]
    extremal = problem.solve()
    searched = problem.solve([("interior",) * len(problem.control)])
    times = np.linspace(0, extremal.duration, 31)
    assert extremal.cost == pytest.approx(searched.cost, rel=1e-11)
    for values, others in (
        (extremal.state(times), searched.state(times)),
        (extremal.costate(times), searched.costate(times)),
        (extremal.control(times), searched.control(times)),
    ):
        assert values == pytest.approx(others, rel=1e-8, abs=1e-9 * np.max(np.abs(others)))
    assert extremal.terminal_multipliers == pytest.approx(searched.terminal_multipliers, rel=1e-8)
    assert extremal.certificate().holds(1e-11) and extremal.optimality.proved


def test_very_long_horizon():
    """Errors grow by e^2000 along the process; x = e^(-t) up to e^(-2000), and J = 1 + sqrt 2."""
    extremal = Problem(
        {x: x + u}, {u: None}, {x: 1}, [x], running=x**2 + u**2, duration=500
    ).solve()
    assert extremal.cost == pytest.approx(1 + np.sqrt(2), rel=1e-14)
    assert extremal.state(1.0) == pytest.approx([np.exp(-np.sqrt(2))], rel=1e-12)


def test_uncontrollable_states_on_their_target():
    """x - y is the same whatever the control, and zero at both ends."""
    plant = {x: -x + u, y: -y + u}
    extremal = Problem(plant, {u: None}, {x: 1, y: 1}, [x, y], running=u**2, duration=1).solve()
    # x(1) = e^-1 + int e^(s-1) u ds: the least norm is e^-2 / int e^(2s-2) ds.
    assert extremal.cost == pytest.approx(2 / (np.e**2 - 1), rel=1e-14)
    assert extremal.certificate().holds()
    with pytest.raises(Infeasible, match="does not depend on the control"):
        Problem(plant, {u: None}, {x: 1, y: R(1, 2)}, [x, y], running=u**2, duration=1).solve()


RESONANT = {"dynamics": {x: u}, "controls": {u: None}, "running": u**2 - x**2}
# x'' = -x: sin t, cos t or both keep the ends, and the second variation is zero along them.
CONJUGATE = {
    "both ends given": Problem(**RESONANT, initial={x: 1}, terminal=[x], duration=sp.pi),
    "beyond the first": Problem(**RESONANT, initial={x: 1}, terminal=[x], duration=2 * sp.pi),
    "free final state": Problem(**RESONANT, initial={x: 1}, duration=sp.pi / 2),
    "free initial state": Problem(
        **RESONANT, initial={x: None}, terminal=[x - 1], duration=sp.pi / 2
    ),
    "linear cost": Problem(
        **RESONANT | {"running": u**2 - x**2 + x}, initial={x: 0}, terminal=[x], duration=sp.pi
    ),
    "constant of the plant": Problem(
        **RESONANT | {"dynamics": {x: u + s, s: 0}, "running": u**2 - x**2 + s * x},
        initial={x: 0, s: 1},
        terminal=[x],
        duration=sp.pi,
    ),
    "terminal cost": Problem({x: u}, {u: None}, {x: 1}, running=u**2, final=-(x**2), duration=1),
    "other units": Problem(
        {x: 1000 * u},
        {u: None},
        {x: 10**6},
        [x],
        running=10**3 * (10**6 * u**2 - x**2),
        duration=sp.pi,
    ),
    "two states": Problem(
        {x: u, y: v},
        {u: None, v: None},
        {x: 1, y: 1},
        [x, y],
        running=u**2 + v**2 - x**2 + y**2,
        duration=sp.pi,
    ),
}


@pytest.mark.parametrize("name", CONJUGATE)
@pytest.mark.parametrize("maximise", [False, True])
@pytest.mark.timeout(60)
def test_conjugate_end_without_an_extremal(name, maximise):
    problem = CONJUGATE[name]
    if maximise:
        problem = replace(problem, running=-problem.running, final=-problem.final, maximise=True)
    with pytest.raises(Unbounded, match="conjugate point"):
        problem.solve()


def test_cost_falls_in_proportion_at_a_conjugate_end():
    """x = 1 - t/pi + c sin t has the cost of a straight line less 2 c, whatever c."""
    t, c = sp.symbols("t c", real=True)
    path = 1 - t / sp.pi + c * sp.sin(t)
    cost = sp.integrate(sp.expand(sp.diff(path, t) ** 2 - path**2), (t, 0, sp.pi))
    assert sp.simplify(cost - (1 / sp.pi - sp.pi / 3 - 2 * c)) == 0


@pytest.mark.parametrize("end, cost", [(-1, 0), (R(-1) - R(1, 10**90), 0)])
def test_conjugate_end_with_a_family_of_extremals(end, cost):
    """x = cos t + c sin t, all with the cost 0; an end that misses it by 1e-90 counts as this one."""
    extremal = Problem(**RESONANT, initial={x: 1}, terminal=[x - end], duration=sp.pi).solve()
    assert extremal.cost == pytest.approx(cost, abs=1e-10)
    assert extremal.optimality.kind == "extremal" and "is zero in" in extremal.optimality.reason


@pytest.mark.parametrize("duration", [R("3.14159"), np.pi, R("3.1416")])
def test_duration_next_to_a_conjugate_end(duration):
    """The cost is cot T; a second variation of about 1e-6 proves nothing."""
    extremal = Problem(**RESONANT, initial={x: 1}, terminal=[x], duration=duration).solve()
    with mpmath.workdps(40):
        cost = float(
            mpmath.cot(
                mpmath.mpf(sp.Rational(extremal.problem.duration).p) / extremal.problem.duration.q
            )
        )
    assert extremal.cost == pytest.approx(cost, rel=1e-12)
    assert not extremal.optimality.proved and extremal.certificate().holds()
    assert (extremal.optimality.kind == "locally minimal") <= bool(duration < np.pi)
    assert "the only one; a better process is not excluded" in str(extremal.optimality)


@pytest.mark.parametrize("duration", [1, R(31, 10), R(313, 100)])
def test_cost_that_is_not_convex_is_decided(duration):
    """J = int u^2 - x^2 from 1 to 0: x'' = -x, cot T, until the conjugate point T = pi."""
    extremal = Problem(
        {x: u}, {u: None}, {x: 1}, [x], running=u**2 - x**2, duration=duration
    ).solve()
    assert extremal.cost == pytest.approx(1 / np.tan(float(duration)), rel=1e-12)
    assert extremal.optimality.proved and extremal.certificate().holds(1e-11)


@pytest.mark.parametrize("sign", [1, -1])
def test_quadratic_cost_that_falls_without_bound(sign):
    problem = Problem(
        {x: u},
        {u: None},
        {x: 1},
        [x],
        running=sign * (u**2 - x**2),
        duration=R(32, 10),
        maximise=sign < 0,
    )
    with pytest.raises(Unbounded, match=r"without bound.* second variation is (negative|positive)"):
        problem.solve()


def test_chain_with_a_cost_that_is_not_convex():
    """The part of the cost that is not convex is small: J = J_0 - 1e-3 int x1^2 to first order."""
    states = sp.symbols("x1:5")
    problem = chain(4)
    problem = Problem(
        problem.dynamics,
        problem.controls,
        problem.initial,
        problem.terminal,
        running=u**2 / 2 - states[0] ** 2 / 1000,
        duration=1,
    )
    extremal = problem.solve()
    times = np.polynomial.legendre.leggauss(20)
    squares = chain(4).solve().state((1 + times[0]) / 2)[0] ** 2
    assert extremal.cost == pytest.approx(50400 - times[1] @ squares / 2000, rel=1e-12)
    assert extremal.optimality.proved and extremal.certificate().holds(1e-11)
