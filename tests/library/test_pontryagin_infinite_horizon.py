"""Linear-quadratic problems with an infinite horizon, against closed forms and long horizons."""

import numpy as np
import pytest
import sympy as sp

from trajlib.pontryagin import PontryaginError, Problem, Unbounded

R = sp.Rational
x, y, u, v = sp.symbols("x y u v")
FREE, PLANE = {u: None}, {x: y, y: u}


@pytest.mark.parametrize(
    "problem, cost, control",
    [
        # S = 1 + sqrt(2) solves 2 S + 1 - S^2 = 0.
        (Problem({x: x + u}, FREE, {x: 1}, running=x**2 + u**2, duration=sp.oo), 1 + 2**0.5, -1 - 2**0.5),
        # S = [[sqrt 2, 1], [1, sqrt 2]].
        (Problem(PLANE, FREE, {x: 1, y: 0}, running=x**2 + u**2, duration=sp.oo), 2**0.5, -1),
        # Without terminal equations nothing has to be done; with them S = 2.
        (Problem({x: x + u}, FREE, {x: 1}, running=u**2, duration=sp.oo), 0, 0),
        (Problem({x: x + u}, FREE, {x: 1}, [x], running=u**2, duration=sp.oo), 2, -2),
        # An indefinite cost, and the same to be largest: -2 S - 3/4 - S^2 = 0, S = -1/2.
        (Problem({x: u - x}, FREE, {x: 1}, [x], running=u**2 - 3 * x**2 / 4, duration=sp.oo), -1 / 2, 1 / 2),
        (
            Problem({x: u - x}, FREE, {x: 1}, [x], running=3 * x**2 / 4 - u**2, duration=sp.oo, maximise=True),
            1 / 2,
            1 / 2,
        ),
        # A cross term: v = u + x gives x' = v - x with int v^2 + 3 x^2, S = 1.
        (Problem({x: u}, FREE, {x: 2}, running=u**2 + 2 * x * u + 4 * x**2, duration=sp.oo), 4, -4),
    ],
)  # fmt: skip
def test_closed_forms(problem, cost, control):
    extremal = problem.solve()
    assert extremal.cost == pytest.approx(cost, rel=1e-13, abs=1e-15)
    assert extremal.control(0)[0] == pytest.approx(control, rel=1e-13, abs=1e-15)
    assert extremal.optimality.proved and extremal.certificate().holds(1e-11)
    assert np.allclose(extremal.hamiltonian([0.0, 1.0]), 0, atol=1e-14)
    assert np.allclose(extremal.switching([0.0, 1.0]), 0, atol=1e-13)


def test_long_horizon_tends_to_the_infinite_one():
    """Two controls; the finite problem is solved without the Riccati equation."""
    statement = {
        "dynamics": {x: y + v, y: -x + u},
        "controls": {u: None, v: None},
        "initial": {x: 1, y: -2},
        "running": x**2 + 2 * y**2 + u**2 + 3 * v**2 + x * u,
    }
    infinite = Problem(**statement, duration=sp.oo).solve()
    finite = Problem(**statement, duration=30).solve()
    times = np.linspace(0, 5, 11)
    assert infinite.cost == pytest.approx(finite.cost, rel=1e-12)
    for values, others in (
        (infinite.state(times), finite.state(times)),
        (infinite.costate(times), finite.costate(times)),
        (infinite.control(times), finite.control(times)),
    ):
        assert np.allclose(values, others, atol=1e-10)


def test_units_of_time():
    """Fast and slow modes: rates of 1e3 and 1e-3."""
    extremal = Problem(
        {x: u - 1000 * x, y: v - y / 1000},
        {u: None, v: None},
        {x: 1, y: 1},
        running=x**2 + y**2 / 10**6 + u**2 + v**2,
        duration=sp.oo,
    ).solve()
    fast, slow = np.hypot(1000, 1) - 1000, (np.sqrt(2) - 1) / 1000
    assert extremal.cost == pytest.approx(fast + slow, rel=1e-12)
    assert extremal.certificate().holds(1e-10)


@pytest.mark.parametrize(
    "error, message, arguments",
    [
        (Unbounded, "no lower bound", {"terminal": [x, y], "running": u**2 - x**2 / 10}),
        (PontryaginError, "not stabilisable", {"dynamics": {x: x, y: u}}),
        (ValueError, "infinite horizon is provided", {"controls": {u: (-1, 1)}}),
        (ValueError, "infinite horizon is provided", {"running": x**2 + u**2 + x}),
        (ValueError, "infinite horizon is provided", {"running": x**2 - u**2}),
        (ValueError, "infinite horizon is provided", {"dynamics": {x: y, y: sp.sin(x) + u}}),
        (ValueError, "infinite horizon is provided", {"terminal": [x]}),
        (ValueError, "infinite horizon is provided", {"final": x**2}),
        (ValueError, "infinite horizon is provided", {"path": [y <= 1]}),
    ],
)
def test_problems_that_are_refused(error, message, arguments):
    statement = {
        "dynamics": PLANE,
        "controls": FREE,
        "initial": {x: 1, y: 0},
        "running": x**2 + u**2,
        "duration": sp.oo,
    }
    with pytest.raises(error, match=message):
        Problem(**statement | arguments).solve()


def test_extremal_is_shown():
    import matplotlib

    matplotlib.use("agg")
    problem = Problem(PLANE, FREE, {x: 1, y: 0}, running=x**2 + u**2, duration=sp.oo)
    extremal = problem.solve()
    assert len(extremal.plot()) == 4
    assert r"t_k = \infty" in extremal._repr_markdown_()
    assert r"as $t \to \infty$" in problem.conditions()._repr_markdown_()
    with pytest.raises(ValueError, match="expected finite times"):
        extremal.state(-1.0)
    with pytest.raises(ValueError, match="leave them out"):
        problem.solve(["interior"])
