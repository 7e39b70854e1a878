"""Direct solutions as an answer of their own, on any grid."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trajlib.pontryagin.direct.collocation import (
    SCHEMES,
    Discretised,
    control_points,
    solve_programme,
)
from trajlib.pontryagin.direct.guesses import read_guess, target_sides
from trajlib.pontryagin.direct.multistart import Multistart
from trajlib.pontryagin.direct.process import DirectProcess
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.indirect.steps import NATURAL_UNITS, REFORMULATIONS
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.scaling import Scaling
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.problem.time_limit import in_time


def solve_direct(
    problem: Statement,
    grid: int | Sequence[float] | np.ndarray = 80,
    scheme: str = "runge-kutta",
    tolerance: float = 1e-9,
    guess: DirectProcess | Extremal | dict | None = None,
    time_limit: float | None = None,
) -> DirectProcess:
    """Solve the nonlinear programme of a problem; called as `problem.solve_direct(...)`.

    Parameters
    ----------
    problem : Problem
        Without parameters, with a finite horizon.
    grid : int or array_like, shape (N+1,)
        Number of equal intervals, or the nodes as increasing fractions of the duration, from 0 to 1.
    scheme : str
        "runge-kutta" (controls constant on each interval, order 4), "trapezoidal" (linear, order 2)
        or "hermite-simpson" (quadratic, order 4).
    tolerance : float
        Of IPOPT, relative to the natural units of the problem.
    guess : DirectProcess, Extremal or dict, optional
        As for `solve`; an earlier solution may have another grid and scheme. By default the best
        discrete solution of the search of `solve`.
    time_limit : float, optional
        Seconds after which any step ends, as in `solve`.

    Returns
    -------
    DirectProcess
        States, controls, costates and multipliers, with the errors on a finer grid.

    Raises
    ------
    TypeError, ValueError
        If an argument is not of this form, or a parameter has no value.
    PontryaginError
        If no process is found; as for `solve`.

    Notes
    -----
    A local minimum of the discretised problem: neither the maximum condition nor the arcs are
    decided, and nothing is proved. `solve(guess=process)` goes on from it to an extremal. Sources:
    Betts, Practical Methods for Optimal Control, 2010; `direct.collocation`.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> energy = Problem({x: v, v: u}, {u: None}, {x: 0, v: 0}, {x: 1, v: 0}, running=u**2, duration=1)
    >>> process = energy.solve_direct(10, "hermite-simpson")
    >>> round(process.cost, 8), process.states.shape, process.controls.shape
    (12.0, (11, 2), (21, 1))
    """
    fractions = _read_grid(grid)
    if scheme not in SCHEMES:
        raise ValueError(f"scheme: expected one of {', '.join(SCHEMES)}, got {scheme!r}")
    if not 0 < float(tolerance) < 1:
        raise ValueError(f"tolerance: expected a number between 0 and 1, got {tolerance}")
    if problem.duration == np.inf:
        raise ValueError("duration: expected a finite horizon for a direct solution")
    return in_time(time_limit, _solve, problem, fractions, scheme, float(tolerance), guess)


def _read_grid(grid):
    """Return the nodes as fractions of the duration."""
    if isinstance(grid, (int, np.integer)) and not isinstance(grid, bool):
        if grid < 2:
            raise ValueError(f"grid: expected at least 2 intervals, got {grid}")
        return np.linspace(0, 1, int(grid) + 1)
    fractions = np.asarray(grid, dtype=float)
    if (
        fractions.ndim != 1
        or len(fractions) < 3
        or (fractions[0], fractions[-1]) != (0, 1)
        or not np.all(np.diff(fractions) > 0)
    ):
        raise ValueError(
            "grid: expected a number of intervals, or increasing fractions from 0 to 1, got "
            f"{grid!r}"
        )
    return fractions


def _solve(problem, fractions, scheme, tolerance, guess):
    for step in REFORMULATIONS:
        if step.applies(problem):
            other = step.reformulate(problem)
            inner = _solve(other.problem, fractions, scheme, tolerance, step.guess(other, guess))
            states = inner.state(inner.control_times)
            controls = step.controls(other, states, inner.controls.T).T
            return replace(inner, problem=problem, controls=controls, inner=inner)
    numeric, scaling = NumericProblem(problem), None
    points = control_points(scheme, fractions)
    start = _on_grid(guess, fractions, points) if hasattr(guess, "costate") else None
    read = read_guess(numeric, guess) if start is None else None
    if NATURAL_UNITS.applies(problem):
        scaling = NATURAL_UNITS.reformulate(problem)
        numeric = NumericProblem(scaling.problem, scaling)
        start, read = (NATURAL_UNITS.guess(scaling, part) for part in (start, read))
    side = None
    if start is None:
        if read is None:
            solution, side = Multistart(numeric).search().solutions[0]
            read = solution.duration, solution.states, solution.controls
        start = _interpolated(read, fractions, points)
    if guess is not None:
        side = _side(numeric, start[1])
    result = solve_programme(numeric, fractions, scheme, tolerance, start, side)
    return _process(problem, numeric, scaling, scheme, points, result)


def _side(numeric, states):
    """Return the possible side of the target on which most of the states are, or None."""
    sides = target_sides(numeric)
    if len(sides) == 1:
        return sides[0]
    values = numeric.target_value.map(len(states))(states.T)[0].full()
    return 1 if np.mean(values > 0) > 0.5 else -1


def _on_grid(process, fractions, points):
    """Return the values of a process on another grid."""
    T = process.duration
    return T, process.state(fractions * T).T, process.control(points * T).T


def _interpolated(guess, fractions, points):
    """Return (duration, states, controls) on a grid, from values at equal steps."""
    duration, states, controls = guess
    steps = np.linspace(0, 1, len(states))
    values = [np.interp(fractions, steps, column) for column in np.transpose(states)]
    index = np.minimum((points * len(controls)).astype(int), len(controls) - 1)
    return duration, np.stack(values, axis=1), controls[index]


def _process(problem, numeric, scaling: Scaling | None, scheme, points, result: Discretised):
    """Return the process in the user's units."""
    n, k, c = numeric.n, numeric.k, len(numeric.path_orders)
    states, controls, path = np.ones(n), np.ones(k), np.ones(c)
    terminal, time, cost = np.ones(len(result.terminal_multipliers)), 1.0, 1.0
    if scaling is not None:
        time, cost = float(scaling.time), float(scaling.cost)
        states, controls, path, terminal = (
            np.array(units, dtype=float)
            for units in (scaling.states, scaling.controls, scaling.path, scaling.terminal)
        )
    return DirectProcess(
        problem,
        scheme,
        result.times * time,
        result.states * states,
        result.costates * cost / states,
        points * result.times[-1] * time,
        result.controls * controls,
        result.path_multipliers * cost / (time * path),
        tuple(float(value) for value in result.terminal_multipliers * cost / terminal),
        float(numeric.user_cost(result.cost)),
        result.iterations,
        result.nlp,
    )
