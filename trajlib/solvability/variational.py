"""Linearisation about a reference motion: the equations of variation are integrated together with
the motion itself.

    x' = f(t, x),        Phi' = (df/dx) Phi,  Phi(t_s, t_s) = E,        H_i = (dh/dx)(t_i, x(t_i)).

The derivatives are CasADi's, exact to rounding. The integration is not exact, and what it does
wrong goes into the stacked matrix: a matrix without full rank gets it by errors of the integrator.
So every entry comes with an estimate of its error.
"""

import warnings
from dataclasses import dataclass

import numpy as np

from trajlib._arguments.numbers import read_names, read_times
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
    """A reference motion with its variations at k times; what `linearise` returns.

    `motion`: states, shape (k, m). `predicted`: what would be measured, shape (k, r). `H`: shape
    (k, r, m). `Phi`: shape (k, m, m). `error`: estimated errors of the entries of `matrix`, shape
    (k r, m). `names`, `units`: of the unknowns.
    """

    times: np.ndarray
    reference: float
    motion: np.ndarray
    predicted: np.ndarray
    H: np.ndarray
    Phi: np.ndarray
    error: np.ndarray
    names: tuple
    units: tuple

    @property
    def matrix(self):
        """The stacked matrix Htilde, shape (k r, m)."""
        return stack(self.H, self.Phi)


def linearise(f, h, state, times, *, reference=None, breaks=(), rtol=1e-10, names=None, units=None):
    """Linearise x' = f(t, x), z = h(t, x) about the motion through `state` at the time `reference`
    (the first time if left out).

    `f`, `h`: functions of the time and of a list of m components that return lists; they are called
    once, with CasADi symbols, so they may use NumPy and CasADi functions and operators, but no `if`
    on their arguments (use `casadi.if_else`). `times`: increasing times of the measurements.
    `breaks`: times at which f jumps. `rtol`: relative tolerance of the integration (the result is
    `TIGHTER` times tighter; what this changes is the estimate of its error). `names`, `units`:
    words for the unknowns.

    >>> line = linearise(lambda t, x: [x[1], 0], lambda t, x: [x[0]**2], [3.0, 1.0], [0, 1, 2])
    >>> line.matrix.round(9).tolist(), line.predicted.ravel().round(9).tolist()
    ([[6.0, 0.0], [8.0, 8.0], [10.0, 20.0]], [9.0, 16.0, 25.0])
    """
    times = read_times(times)
    reference = float(times[0] if reference is None else reference)
    state = np.asarray(state, dtype=float)
    if state.ndim != 1 or state.size == 0 or not np.isfinite(state).all():
        raise ValueError(f"state: expected a list of finite numbers, got {state}")
    if not np.isfinite(reference):
        raise ValueError(f"reference: expected a finite time, got {reference}")
    if not 0 < rtol < 1:
        raise ValueError(f"rtol: expected a relative tolerance such as 1e-10, got {rtol}")
    m = state.size
    names, units = read_names(names, m), read_names(units, m, "units")
    rates, measured = _compiled(f, h, m)
    start = np.concatenate([state, np.eye(m).ravel()])
    if not np.isfinite(rates(reference, start).full()).all():
        raise ValueError(
            f"f: it or its derivative is not finite at the start, t = {reference:g}, state "
            f"{state.tolist()}; does the motion begin outside the domain of f? (Functions of "
            "Python's module `math` make nan of CasADi symbols: use those of NumPy or CasADi)"
        )
    breaks = np.unique(np.asarray(breaks, dtype=float))

    def run(tolerance, absolute):
        return _integrated(rates, start, reference, times, breaks, max(tolerance, 3e-14), absolute)

    peaks = np.abs(run(1e-6, np.full(start.size, SMALLEST))).max(axis=0)
    absolute = rtol * np.maximum(peaks, SMALLEST)
    coarse, fine = run(rtol, absolute), run(rtol / TIGHTER, absolute / TIGHTER)
    (rough, _, _, _), (matrix, motion, predicted, parts) = (
        _stacked(measured, times, values, m) for values in (coarse, fine)
    )
    error = np.abs(matrix - rough) + 4 * np.finfo(float).eps * np.abs(matrix)
    return Linearisation(times, reference, motion, predicted, *parts, error, names, units)


def _compiled(f, h, m):
    """CasADi functions: (t, [x, Phi]) -> rates, and (t, x) -> (h, dh/dx)."""
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
    return (
        ca.Function("rates", [t, joined], [ca.vertcat(field, ca.vec(rates.T))]),
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
    bad = ~np.isfinite(predicted).all(axis=1) | ~np.isfinite(H).all(axis=(1, 2))
    if bad.any():
        k = int(np.flatnonzero(bad)[0])
        raise ValueError(
            f"h: the measurement or its derivative is not finite at t = {times[k]:g}, where the "
            f"state is {motion[k].round(6).tolist()}"
        )
    return stack(H, Phi), motion, predicted, (H, Phi)


def _integrated(rates, start, reference, times, breaks, rtol, atol):
    """States with variations at all times, forwards and backwards from the reference time, leg by
    leg between the breaks."""
    values = np.empty((times.size, start.size))
    values[times == reference] = start
    for sign in (1, -1):
        ahead = np.flatnonzero(sign * (times - reference) > 0)
        if ahead.size == 0:
            continue
        last = times[ahead[-1 if sign > 0 else 0]]
        inner = [b for b in breaks[::sign] if sign * (b - reference) > 0 and sign * (last - b) > 0]
        state, begin = start, reference
        for end in [*inner, last]:
            here = ahead[(sign * (times[ahead] - begin) > 0) & (sign * (times[ahead] - end) <= 0)][
                ::sign
            ]
            inside = _leg(rates, state, begin, end, np.append(times[here], end), rtol, atol)
            values[here], state, begin = inside[:-1], inside[-1], end
    return values


def _leg(rates, state, begin, end, at, rtol, atol):
    from scipy.integrate import solve_ivp

    low, high = sorted((begin, end))
    # at a break f is that of this side
    low, high = np.nextafter(low, high), np.nextafter(high, low)

    def rate(t, y):
        rate.share = max(rate.share, (t - begin) / (end - begin))
        # The method halves its step where a trial goes wrong, but nan would never let it end.
        return np.nan_to_num(
            rates(min(max(t, low), high), y).full()[:, 0],
            nan=_OUTSIDE,
            posinf=_OUTSIDE,
            neginf=-_OUTSIDE,
        )

    rate.share = 0.0
    asked = np.unique(at)[:: 1 if end > begin else -1]
    found = solve_ivp(
        rate, (begin, end), state, method="DOP853", t_eval=asked, rtol=rtol, atol=atol
    )
    if not found.success or not np.isfinite(found.y).all():
        reached = begin + (end - begin) * rate.share
        raise ValueError(
            f"f: the motion could not be continued beyond t = {reached:g} on the way to {end:g} "
            f"({found.message}); does it leave the domain of f there?"
        )
    return found.y.T[np.searchsorted(asked if end > begin else -asked, at if end > begin else -at)]
