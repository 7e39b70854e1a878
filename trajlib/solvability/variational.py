"""Linearisation about a reference motion, by integrating it with its variational equations.

    x' = f(t, x),        Phi' = (df/dx) Phi,  Phi(t_s, t_s) = E,        H_i = (dh/dx)(t_i, x(t_i)).

The derivatives are CasADi's, exact to rounding. The integration is not exact, and its errors enter
the stacked matrix: they may give full rank to a matrix that does not have it. So every entry has an
estimate of its error.
"""

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from trajlib._arguments.arrays import read_finite_array
from trajlib._arguments.integration import Budget, read_method
from trajlib._arguments.numbers import read_names, read_number, read_seconds, read_times
from trajlib._typing import ArrayLike
from trajlib.solvability.transitions import stack

#: The error of each entry is found from a second integration whose tolerance is smaller by this
#: factor.
TIGHTER = 100
#: An entry of Phi is not resolved below the tolerance times this; unknowns should have units that
#: avoid such entries.
SMALLEST = 1e-12
#: A rate where f is not defined: no step that meets it is accepted.
_OUTSIDE = 1e100


@dataclass(frozen=True)
class Linearisation:
    """Reference motion with its variations at k times, the result of `linearise`.

    Attributes
    ----------
    times : ndarray, shape (k,)
        Times of the measurements.
    reference : float
        Reference time t_s.
    motion : ndarray, shape (k, m)
        States.
    predicted : ndarray, shape (k, r)
        Predicted measurements.
    H : ndarray, shape (k, r, m)
        Derivatives of the measurements by the state.
    Phi : ndarray, shape (k, m, m)
        Transition matrices.
    error : ndarray, shape (k r, m)
        Estimated errors of the entries of `matrix`.
    names, units : tuple of str
        Names and units of the unknowns.
    """

    times: np.ndarray
    reference: float
    motion: np.ndarray
    predicted: np.ndarray
    H: np.ndarray
    Phi: np.ndarray
    error: np.ndarray
    names: Sequence[str]
    units: Sequence[str]

    @property
    def matrix(self) -> np.ndarray:
        """Stacked matrix Htilde, shape (k r, m)."""
        return stack(self.H, self.Phi)


def linearise(
    f: Callable,
    h: Callable,
    state: ArrayLike,
    times: ArrayLike,
    *,
    reference: float | None = None,
    breaks: ArrayLike = (),
    rtol: float = 1e-10,
    method: str = "DOP853",
    max_evaluations: int = 50_000,
    names: Sequence | None = None,
    units: Sequence | None = None,
) -> Linearisation:
    """Return the linearisation of x' = f(t, x), z = h(t, x) about a motion.

    Parameters
    ----------
    f, h : callable
        Functions of the time and of a list of m components that return lists. They are called once,
        with CasADi symbols, so they may use NumPy and CasADi functions and operators, but no `if`
        on their arguments (use `casadi.if_else`).
    state : array_like, shape (m,)
        State of the motion at the time `reference`.
    times : array_like, shape (k,)
        Increasing times of the measurements; dates become seconds since the first of them.
    reference : float, optional
        Reference time, the first of the times if left out.
    breaks : array_like
        Times at which f jumps.
    rtol : float
        Relative tolerance of the integration. The result is 100 times more accurate; the difference
        is the estimate of its error.
    method : {"DOP853", "Radau"}
        Explicit or implicit method of integration. For stiff systems, whose fast motions die out
        long before the slow ones, the implicit one.
    max_evaluations : int
        Evaluations of f after which an integration is given up.
    names, units : sequence of str, optional
        Names and units of the unknowns.

    Returns
    -------
    Linearisation

    Raises
    ------
    ArithmeticError
        If max_evaluations are not enough.
    ValueError
        If f or h is not finite or cannot be called with CasADi symbols, the motion cannot be
        continued, or arguments do not fit.

    Examples
    --------
    >>> line = linearise(lambda t, x: [x[1], 0], lambda t, x: [x[0]**2], [3.0, 1.0], [0, 1, 2])
    >>> line.matrix.round(9).tolist(), line.predicted.ravel().round(9).tolist()
    ([[6.0, 0.0], [8.0, 8.0], [10.0, 20.0]], [9.0, 16.0, 25.0])
    """
    times = read_times(times)
    reference = float(times[0]) if reference is None else read_number(reference, "reference")
    state = read_finite_array(state, "state", "a list of numbers")
    if state.ndim != 1 or state.size == 0:
        raise ValueError(f"state: expected a list of numbers, got the shape {state.shape}")
    if not 0 < rtol < 1:
        raise ValueError(f"rtol: expected a relative tolerance such as 1e-10, got {rtol}")
    read_method(method)
    m = state.size
    names, units = read_names(names, m), read_names(units, m, "units")
    equations, measured = _compiled(f, h, m)
    start = np.concatenate([state, np.eye(m).ravel()])
    if not np.isfinite(equations[0](reference, start).full()).all():
        raise ValueError(
            f"f: it or its derivative is not finite at the start, t = {reference:g}, state "
            f"{state.tolist()}; does the motion begin outside the domain of f? (Functions of "
            "Python's module `math` make nan of CasADi symbols: use those of NumPy or CasADi)"
        )
    breaks = np.unique(read_seconds(breaks, "breaks"))

    def run(tolerance, absolute):
        flow = _Flow(equations, max(tolerance, 3e-14), absolute, Budget(max_evaluations, method))
        return _integrated(flow, start, reference, times, breaks)

    peaks = np.abs(run(1e-6, np.full(start.size, SMALLEST))).max(axis=0)
    absolute = rtol * np.maximum(peaks, SMALLEST)
    coarse, fine = run(rtol, absolute), run(rtol / TIGHTER, absolute / TIGHTER)
    (coarse_matrix, _, _, _), (matrix, motion, predicted, parts) = (
        _stacked(measured, times, values, m) for values in (coarse, fine)
    )
    error = np.abs(matrix - coarse_matrix) + 4 * np.finfo(float).eps * np.abs(matrix)
    H, Phi = parts
    return Linearisation(times, reference, motion, predicted, H, Phi, error, names, units)


def _compiled(f, h, m):
    """Return CasADi functions (t, [x, Phi]) -> rates and their derivative; (t, x) -> (h, dh/dx)."""
    import casadi as ca

    t, x, variations = ca.SX.sym("t"), ca.SX.sym("x", m), ca.SX.sym("Phi", m, m)
    # a list of scalars can be unpacked, sliced and multiplied by arrays
    components = np.empty(m, dtype=object)
    components[:] = [x[j] for j in range(m)]
    field, output = (
        _evaluated(function, t, components, name) for function, name in ((f, "f"), (h, "h"))
    )
    if field.numel() != m:
        raise ValueError(
            f"f: expected {m} rates, one for each component of the state, got {field.numel()}"
        )
    if output.numel() == 0:
        raise ValueError("h: it returns no measurement")
    rates = ca.jacobian(field, x) @ variations
    # Phi by rows, as NumPy stores it
    joined = ca.vertcat(x, ca.vec(variations.T))
    all_rates = ca.vertcat(field, ca.vec(rates.T))
    slopes = ca.jacobian(all_rates, joined)
    return (
        (
            ca.Function("rates", [t, joined], [all_rates]),
            ca.Function("slopes", [t, joined], [slopes]),
        ),
        ca.Function("measured", [t, x], [output, ca.jacobian(output, x)]),
    )


def _evaluated(function, t, components, name):
    import casadi as ca

    try:
        with warnings.catch_warnings():
            # CasADi's notice about NumPy functions of its symbols
            warnings.simplefilter("ignore", FutureWarning)
            value = function(t, components)
            entries = (
                [value]
                if isinstance(value, ca.SX) or np.ndim(value) == 0
                else list(np.ravel(np.asarray(value, dtype=object)))
            )
            return ca.vertcat(*entries) if entries else ca.SX(0, 1)
    except Exception as error:
        reason = f"{type(error).__name__}: {(str(error).splitlines() or [''])[-1]}"
        raise ValueError(
            f"{name}: it cannot be called with CasADi symbols ({reason}); it has to return a list, "
            "made of operators and of NumPy or CasADi functions, without an `if` on its arguments"
        ) from error


def _stacked(measured, times, values, m):
    motion, Phi = values[:, :m], values[:, m:].reshape(-1, m, m)
    outputs, slopes = measured.map(times.size)(times, motion.T)
    predicted = outputs.full().T
    H = slopes.full().reshape(-1, times.size, m).transpose(1, 0, 2)
    not_finite = ~np.isfinite(predicted).all(axis=1) | ~np.isfinite(H).all(axis=(1, 2))
    if not_finite.any():
        k = int(np.flatnonzero(not_finite)[0])
        raise ValueError(
            f"h: the measurement or its derivative is not finite at t = {times[k]:g}, where the "
            f"state is {motion[k].round(6).tolist()}"
        )
    return stack(H, Phi), motion, predicted, (H, Phi)


def _integrated(flow, start, reference, times, breaks):
    """Return states with variations at all times, in both directions from the reference time.

    The integration goes from break to break.
    """
    values = np.empty((times.size, start.size))
    values[times == reference] = start
    for sign in (1, -1):
        remaining = np.flatnonzero(sign * (times - reference) > 0)
        if remaining.size == 0:
            continue
        last = times[remaining[-1 if sign > 0 else 0]]
        inner = [b for b in breaks[::sign] if sign * (b - reference) > 0 and sign * (last - b) > 0]
        state, begin = start, reference
        for end in [*inner, last]:
            indices = remaining[
                (sign * (times[remaining] - begin) > 0) & (sign * (times[remaining] - end) <= 0)
            ][::sign]
            states = flow.leg(state, begin, end, np.append(times[indices], end))
            values[indices], state, begin = states[:-1], states[-1], end
    return values


@dataclass(frozen=True)
class _Flow:
    """Equations of the motion with its variations, and how they are integrated."""

    equations: tuple
    rtol: float
    atol: np.ndarray
    budget: Budget

    def leg(self, state, begin, end, times):
        """Return the states at some times from `begin` to `end`, in their order."""
        forward = 1 if end > begin else -1
        output_times = np.unique(times)[::forward]
        low, high = sorted((begin, end))
        # at a break the limit of f from this side
        within = np.nextafter(low, high), np.nextafter(high, low)
        if self.budget.method == "DOP853":
            states = self._solved(state, (begin, end), within, output_times)
        else:
            # Between the steps of an implicit method its states are known to the third order only.
            states = []
            for last in output_times:
                state = self._solved(state, (begin, last), within, [last])[0]
                states.append(state)
                begin = last
        return np.array(states)[np.searchsorted(forward * output_times, forward * times)]

    def _solved(self, state, span, within, output_times):
        from scipy.integrate import solve_ivp

        if span[0] == span[1]:
            return [state]
        begin, end = span
        furthest = 0.0

        def evaluated(function, t, y):
            values = function(min(max(t, within[0]), within[1]), y).full()
            # The method halves its step where a trial fails, but with nan it would never end.
            return np.nan_to_num(values, nan=_OUTSIDE, posinf=_OUTSIDE, neginf=-_OUTSIDE)

        def rate(t, y):
            nonlocal furthest
            self.budget.spend(t)
            furthest = max(furthest, (t - begin) / (end - begin))
            return evaluated(self.equations[0], t, y)[:, 0]

        implicit = {"jac": lambda t, y: evaluated(self.equations[1], t, y)}
        solution = solve_ivp(
            rate,
            span,
            state,
            method=self.budget.method,
            t_eval=output_times,
            rtol=self.rtol,
            atol=self.atol,
            **(implicit if self.budget.method == "Radau" else {}),
        )
        if not solution.success or not np.isfinite(solution.y).all():
            raise ValueError(
                f"f: the motion could not be continued beyond t = "
                f"{begin + (end - begin) * furthest:g} on the way to {end:g} "
                f"({solution.message}); does it leave the domain of f there?"
            )
        return solution.y.T
