"""Starting guesses for the transcription: found from the statement, or given by the user."""

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.problem.numeric import runge_kutta


def starting_guesses(numeric, intervals, side=None):
    """Yield guesses (duration, states (N+1, n), controls (N, k)), the likeliest first.

    First trajectories under constant controls, each until it comes closest to the target; then
    straight lines to the target with several durations.
    """
    drifts = sorted(
        (
            guess
            for u in _constant_controls(numeric)
            for guess in [_drift_guess(numeric, u, intervals, side)]
            if guess
        ),
        key=lambda guess: guess[0],
    )
    for _, guess in drifts[:1]:
        yield guess
    start, end = numeric.assumed_start, _nearest_target_point(numeric)
    line = start + np.linspace(0, 1, intervals + 1)[:, None] * (end - start)
    middle = np.tile(numeric.middle(), (intervals, 1))
    # Without a target the line would be one point.
    for duration in (
        [1.0, 5.0]
        if numeric.duration is None
        else [numeric.duration]
        if numeric.m or not drifts
        else []
    ):
        yield np.clip(duration, numeric.shortest, numeric.longest), line, middle
    for _, guess in drifts[1:3]:
        yield guess


def oscillating_guesses(numeric, intervals, duration, sign=1):
    """Return guesses with controls that oscillate between their bounds.

    Each control has a frequency of its own; with `sign` = -1 they begin at the other bounds.
    """
    result = []
    half = np.where(
        np.isfinite(numeric.upper - numeric.lower), (numeric.upper - numeric.lower) / 2, 1.0
    )
    inside = (np.arange(intervals) + 0.5) / intervals
    for pace in (1, 2, 3):
        controls = numeric.middle() + sign * 0.7 * half * np.stack(
            [np.cos(np.pi * (pace + j) * inside + 0.5 * (pace - 1 + j)) for j in range(numeric.k)],
            axis=1,
        )
        path, _ = runge_kutta(numeric).mapaccum(intervals)(
            numeric.assumed_start, controls.T, duration / intervals
        )
        states = np.vstack([numeric.assumed_start, path.full().T])
        if np.all(np.abs(np.nan_to_num(states, nan=np.inf)) < 1e6):
            result.append((duration, states, controls))
    return result


def random_guesses(numeric, intervals, duration):
    """Yield guesses without end, from random controls that change slowly (always the same ones).

    Controls between bounds reach them; the sizes of the others differ by a factor of thousand.
    """
    random, inside = np.random.default_rng(0), (np.arange(intervals) + 0.5) / intervals
    bounded = np.isfinite(numeric.upper - numeric.lower)
    start = numeric.assumed_start
    while True:
        waves = np.cos(np.pi * np.arange(4)[:, None] * inside) / (1 + np.arange(4)[:, None])
        shapes = random.standard_normal((numeric.k, 4)) @ waves
        sizes = np.where(bounded, (numeric.upper - numeric.lower) / 2, 10 ** random.uniform(-1, 2))
        controls = np.clip(numeric.middle() + sizes * shapes.T, numeric.lower, numeric.upper)
        length = duration if numeric.duration else duration * 2 ** random.uniform(-2, 2)
        length = np.clip(length, numeric.shortest, numeric.longest)
        path, _ = runge_kutta(numeric).mapaccum(intervals)(start, controls.T, length / intervals)
        states = np.vstack([start, path.full().T])
        if np.all(np.abs(np.nan_to_num(states, nan=np.inf)) < 1e6):
            yield length, states, controls


def target_sides(numeric):
    """Return the possible sides of the target before its end: [1], [-1], both, or [None].

    The side matters for `first_return`; and the fastest process does not pass the target, which
    excludes local minima.
    """
    problem = numeric.problem
    fastest = (
        problem.time_optimal
        and not problem.maximise
        and numeric.m == 1
        and not np.isnan(numeric.start).any()
    )
    if not problem.first_return and not fastest:
        return [None]
    if np.isnan(numeric.start).any():
        raise ValueError("first_return: expected a value for every state at t = 0")
    g = float(numeric.target_value(numeric.start)[0])
    if abs(g) > 1e-12:
        return [int(np.sign(g))]
    gradient = numeric.target_value(numeric.start)[1].full().ravel()
    field = ca.Function("field", [numeric.x, numeric.u], [numeric.field])
    slopes = {
        int(np.sign(gradient @ field(numeric.start, u).full().ravel()))
        for u in _constant_controls(numeric)
    } - {0}
    return sorted(slopes) or [-1, 1]


def _constant_controls(numeric):
    """Return the middle of the bounds, and this with one control after the other at its bounds."""
    middle = numeric.middle()
    controls = [middle]
    for i in range(numeric.k):
        for bound in (numeric.lower[i], numeric.upper[i]):
            if np.isfinite(bound):
                controls.append(np.where(np.arange(numeric.k) == i, bound, middle))
    return controls


def _drift_guess(numeric, u, intervals, side):
    """Return (distance, guess) for a constant control, until closest to the target or across it."""
    horizon = numeric.duration or min(numeric.longest, 10.0)
    path, _ = runge_kutta(numeric).mapaccum(400)(numeric.assumed_start, ca.DM(u), horizon / 400)
    states = np.vstack([numeric.assumed_start, path.full().T])
    times = np.linspace(0, horizon, 401)
    # Diverging trajectories leave the range of floating-point numbers: keep the part before.
    ok = np.all(np.abs(np.nan_to_num(states, nan=np.inf)) < 1e6, axis=1)
    states = states[: np.argmin(ok)] if not ok.all() else states
    if len(states) < 5 or (numeric.duration and len(states) < len(times)):
        return None
    last = len(states) - 1
    if numeric.duration is None and numeric.m:
        values = numeric.target_value.map(len(states))(states.T)[0].full().T
        distances = np.linalg.norm(values, axis=1)
        crossed = np.nonzero(values[2:, 0] * np.sign(side or values[2, 0]) <= 0)[0]
        if numeric.m == 1 and len(crossed):
            last = max(crossed[0] + 2, 4)
        elif side is None:
            last = max(int(np.argmin(distances)), 4)
        distance = distances[last]
    else:
        distance = 0.0
    grid = np.linspace(0, times[last], intervals + 1)
    sampled = np.stack(
        [np.interp(grid, times[: len(states)], column) for column in states.T], axis=1
    )
    return distance, (times[last], sampled, np.tile(u, (intervals, 1)))


def _nearest_target_point(numeric):
    """Return a point of the target near the initial state, by Gauss-Newton steps.

    Without terminal equations it is the initial state itself.
    """
    point = numeric.assumed_start
    for _ in range(20 if numeric.m else 0):
        value, slope = (v.full() for v in numeric.target_value(point))
        step = np.linalg.lstsq(slope, -value.ravel(), rcond=None)[0]
        if not np.all(np.isfinite(step)):
            return numeric.assumed_start
        point = point + step
    return point


def read_guess(numeric, guess):
    """Return the user's guess as (duration, states (M+1, n), controls (M, k)), or None.

    Raises TypeError or ValueError if it is not of that form.
    """
    if guess is None:
        return None
    problem, M = numeric.problem, 100
    if hasattr(guess, "costate"):
        times = np.linspace(0, guess.duration, M + 1)
        return guess.duration, guess.state(times).T, guess.control((times[1:] + times[:-1]) / 2).T
    if not isinstance(guess, dict):
        raise TypeError(f"guess: expected an Extremal, a DirectProcess or a dict, got {guess!r}")
    unknown = [
        key for key in guess if key != "duration" and key not in (*problem.state, *problem.control)
    ]
    if unknown:
        raise ValueError(f"guess: {unknown[0]} is neither a state, nor a control, nor 'duration'")
    duration = float(guess.get("duration", numeric.duration or 1.0))
    times = np.linspace(0, duration, M + 1)
    states = np.stack(
        [_sampled(guess.get(y, v), times, y) for y, v in zip(problem.state, numeric.assumed_start)],
        axis=1,
    )
    middles = (times[1:] + times[:-1]) / 2
    controls = np.stack(
        [_sampled(guess.get(u, v), middles, u) for u, v in zip(problem.control, numeric.middle())],
        axis=1,
    )
    return duration, states, controls


def _sampled(value, times, symbol):
    if callable(value):
        return np.array([float(value(t)) for t in times])
    values = np.atleast_1d(np.asarray(value, dtype=float))
    if values.ndim != 1 or not np.all(np.isfinite(values)):
        raise ValueError(f"guess: expected numbers for {symbol}, got {value!r}")
    return np.interp(np.linspace(0, 1, len(times)), np.linspace(0, 1, len(values)), values)
