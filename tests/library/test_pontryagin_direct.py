"""Direct solutions: their order, multipliers and errors, and what follows from them as guesses."""

import sys

import numpy as np
import optimal_control_records
import pytest
import sympy as sp
from test_pontryagin_book_problems import BOOK_PROBLEMS

from trajlib.pontryagin import NotConverged, Problem

R = sp.Rational
x, v, m, u = sp.symbols("x v m u")
SCHEMES = ("runge-kutta", "trapezoidal", "hermite-simpson")
CART, REST, ONE = {x: v, v: u}, {x: 0, v: 0}, {u: (-1, 1)}
# x'' = -sin x + u with the least energy: nonlinear, without bounds.
SWING = Problem(
    {x: v, v: u - sp.sin(x)}, {u: None}, {x: 1, v: 0}, {x: 0, v: 0}, running=u**2, duration=2
)
SPEED_LIMIT = Problem(CART, ONE, REST, {x: 3, v: 0}, path=[v <= 1])


@pytest.fixture(scope="module")
def exact():
    return SWING.solve()


def error(process, extremal, name):
    values = getattr(extremal, name)(process.times)
    return np.max(
        np.abs(getattr(process, {"state": "states", "costate": "costates"}[name]).T - values)
    )


@pytest.mark.parametrize(("scheme", "state_order"), [*zip(SCHEMES, (2, 2, 4))])
def test_order_of_the_schemes(scheme, state_order, exact):
    """Halved steps; a constant control limits Runge-Kutta steps to order 2."""
    coarse, fine = (SWING.solve_direct(N, scheme, guess=exact) for N in (10, 20))
    ratio = error(coarse, exact, "state") / error(fine, exact, "state")
    assert np.log2(ratio) == pytest.approx(state_order, abs=0.3)
    assert np.log2(error(coarse, exact, "costate") / error(fine, exact, "costate")) > 1.7
    assert fine.cost == pytest.approx(exact.cost, rel=1e-2 if state_order == 2 else 1e-5)
    ends = [exact.costate(0), exact.costate(exact.duration)]
    for values, references in (
        ([p.terminal_multipliers for p in (coarse, fine)], exact.terminal_multipliers),
        ([p.costates[[0, -1]] for p in (coarse, fine)], ends),
    ):
        errors = [np.max(np.abs(np.subtract(value, references))) for value in values]
        assert errors[1] < errors[0] / 3 < 0.1


@pytest.mark.parametrize("scheme", SCHEMES)
def test_defects_are_those_of_an_integrator(scheme):
    from scipy.integrate import solve_ivp

    process = SWING.solve_direct(np.linspace(0, 1, 13) ** 1.3, scheme)
    k = 5
    begin, end = process.times[k : k + 2]
    run = solve_ivp(
        lambda t, y: [y[1], float(process.control(min(t, end - 1e-13))[0]) - np.sin(y[0])],
        (begin, end),
        process.states[k],
        rtol=1e-11,
        atol=1e-13,
        max_step=(end - begin) / 20,
    )
    assert process.defects[k] == pytest.approx(run.y[:, -1] - process.states[k + 1], abs=1e-9)
    assert process.state(process.times).T == pytest.approx(process.states, abs=1e-12)
    assert process.control(process.control_times).T == pytest.approx(process.controls, abs=1e-9)
    middle = run.sol if run.sol else np.interp((begin + end) / 2, run.t, run.y[0])
    assert process.state((begin + end) / 2)[0] == pytest.approx(middle, abs=1e-3)


def test_speed_limit():
    """eta = 1 on the boundary arc [1, 3] and psi1 = 1, by the maximum principle."""
    process = SPEED_LIMIT.solve_direct()
    assert process.cost == pytest.approx(4, abs=1e-6) and process.duration == process.times[-1]
    inside = (process.times > 1.1) & (process.times < 2.9)
    assert process.path_multipliers[inside, 0] == pytest.approx(1, abs=0.02)
    outside = (process.times < 0.9) | (process.times > 3.1)
    assert process.path_multipliers[outside, 0] == pytest.approx(0, abs=1e-5)
    assert process.costates[:, 0] == pytest.approx(1, abs=0.02)
    assert np.max(np.abs(process.defects)) < 1e-12 and process.path_violations < 1e-9
    # Quadratic controls between long steps pass the limit and are faster: this is shown.
    other = SPEED_LIMIT.solve_direct(np.linspace(0, 1, 41) ** 1.5, "hermite-simpson", guess=process)
    assert other.cost < 4 and other.path_violations > 1e-4
    largest = np.max(other.state(np.linspace(0, other.duration, 5000))[1]) - 1
    assert other.path_violations[0] == pytest.approx(largest, rel=0.05)


def test_units_and_maximum():
    """The same process in metres and kilometres; a maximum has the sign of the user."""
    low, high = (
        Problem(
            {x: v, v: k * u},
            {u: None},
            REST,
            {x: 3 * k, v: 0},
            running=u**2,
            duration=3,
            path=[v <= k * R(5, 4)],
        ).solve_direct()
        for k in (1, 10**5)
    )
    assert high.times == pytest.approx(low.times, rel=1e-6)
    assert high.states == pytest.approx(low.states * 10**5, rel=1e-5, abs=1e-2)
    assert high.costates * 10**5 == pytest.approx(low.costates, abs=1e-4)
    assert high.path_multipliers * 10**5 == pytest.approx(low.path_multipliers, abs=1e-3)
    assert high.terminal_multipliers[0] * 10**5 == pytest.approx(
        low.terminal_multipliers[0], rel=1e-4
    )
    highest = Problem(CART, {u: (-1, 1)}, REST, final=x, duration=2, maximise=True)
    assert highest.solve_direct().cost == pytest.approx(2, abs=1e-9)
    assert highest.solve_direct().costates[0] == pytest.approx([1, 2], abs=1e-7)


@pytest.mark.parametrize(
    "problem",
    [
        SPEED_LIMIT,
        SWING,
        Problem(CART, ONE, REST, {x: 1, v: 0}, running=sp.Abs(u), duration=3),
        Problem({x: u}, {u: (-1, x / 4)}, {x: 1}, {x: 2}, running=1 + u**2),
    ],
    ids=["constraint", "free control", "|u|", "bound of the state"],
)
def test_guess_of_solve_and_of_another_grid(problem):
    process = problem.solve_direct(40)
    extremal = problem.solve()
    assert process.cost == pytest.approx(extremal.cost, rel=2e-3)
    followed = problem.solve(guess=process)
    assert followed.cost == pytest.approx(extremal.cost, rel=1e-10)
    assert followed.optimality.starts <= 1
    for scheme in ("trapezoidal", "hermite-simpson"):
        other = problem.solve_direct(np.linspace(0, 1, 31) ** 1.2, scheme, guess=process)
        assert other.cost == pytest.approx(extremal.cost, rel=2e-2)
        assert other.problem is problem and other.controls.shape[1] == 1
    again = problem.solve_direct(60, guess=extremal)
    assert again.cost == pytest.approx(extremal.cost, rel=2e-3)


def test_angles_and_first_return():
    """A whole turn more of an angle, and the side from which the target is met."""
    disc = optimal_control_records.record("disc, shortest path")
    process = disc.problem.solve_direct(60, "hermite-simpson")
    assert process.cost == pytest.approx(disc.cost, rel=1e-5)
    assert (
        np.max(np.abs(np.diff(process.controls[:, 0]))) < 1
        and np.max(np.abs(process.defects)) < 1e-2
    )
    # An oscillator from rest, as far as possible when it next comes to rest.
    book = BOOK_PROBLEMS["5.24 b"]
    first = book.problem.solve_direct(60)
    for scheme in ("trapezoidal", "hermite-simpson"):
        assert book.problem.solve_direct(60, scheme, guess=first).cost == pytest.approx(
            -2, rel=1e-2
        )


def test_table_plot_and_programme(monkeypatch):
    process = SPEED_LIMIT.solve_direct(20, "trapezoidal")
    assert process.nlp["x"].numel() == 2 * 21 + 21 + 1
    assert process.nlp["g"].numel() == 2 * 20 + 2 + 2 + 19  # v is given at both ends
    assert repr(process).startswith("DirectProcess(cost=") and "20 intervals, trapezoidal" in repr(
        process
    )
    axes = process.plot()
    assert [ax.get_ylabel() for ax in axes] == ["state", "control", "costate"]
    assert len(axes[0].lines) == 4
    with pytest.raises(ValueError, match="axes: expected 3 Axes, got 1"):
        process.plot(axes[0])
    pandas = pytest.importorskip("pandas")
    table = process.to_dataframe()
    assert isinstance(table, pandas.DataFrame) and table.shape == (21, 6)
    assert (
        list(table.columns) == ["x", "v", "u", "psi1", "psi2", "eta1"] and table.index.name == "t"
    )
    assert table["v"].iloc[-1] == pytest.approx(0, abs=1e-9)
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match="to_dataframe: needs pandas"):
        process.to_dataframe()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"grid": 1}, "grid: expected at least 2 intervals, got 1"),
        ({"grid": [0, 0.5, 0.4, 1]}, "grid: expected a number of intervals, or increasing"),
        ({"grid": [0.1, 0.5, 1]}, "grid: expected a number of intervals, or increasing"),
        ({"scheme": "euler"}, "scheme: expected one of runge-kutta, .* got 'euler'"),
        ({"tolerance": 0}, "tolerance: expected a number between 0 and 1, got 0"),
        ({"guess": {m: 1}}, "guess: m is neither a state"),
    ],
)
def test_arguments(arguments, message):
    with pytest.raises(ValueError, match=message):
        SPEED_LIMIT.solve_direct(**arguments)


def test_what_has_no_direct_solution():
    infinite = Problem({x: u}, {u: None}, {x: 1}, running=x**2 + u**2, duration=sp.oo)
    with pytest.raises(ValueError, match="expected a finite horizon"):
        infinite.solve_direct()
    # The fastest motion over 3 takes 2 sqrt(3).
    short = Problem(CART, ONE, REST, {x: 3, v: 0}, running=u**2, duration=3)
    with pytest.raises(NotConverged, match="IPOPT found no solution on 20 intervals"):
        short.solve_direct(20, guess={"duration": 3})
