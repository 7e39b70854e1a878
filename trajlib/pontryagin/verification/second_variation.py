"""The second variation: whether the cost can fall although all first-order conditions hold.

On an extremal the change of the cost is of second order in the admissible variations: controls
inside their bounds, times of jumps between the bounds, a free final time, free initial states. With
the controls constant on N intervals x_{k+1} = F(x_k, u_k, h_k), this is the quadratic form of the
Lagrange function

    lambda_0 (phi_0(x_N) + sum c(x_k, u_k, h_k)) + nu^T phi(x_N) - sum psi_{k+1}^T (F(x_k, u_k, h_k) - x_{k+1})

on the variations that stay on the target to first order, dx_{k+1} = F_x dx_k + F_u du_k + F_h dh_k,
d phi = 0. A negative eigenvalue is a direction in which the cost falls: the process is a saddle or
a maximum. Positive eigenvalues are necessary for a minimum: no conjugate point (interior arcs),
Kelley's sign (singular arcs), a minimum over the switching times (bang arcs). The eigenvalues refer
to the mean square of du over time.
"""

from dataclasses import dataclass, replace

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.problem.numeric import NumericProblem, runge_kutta

# Number of intervals into which an extremal is cut.
INTERVALS = 80
# Eigenvalues below this share of the largest one count as zero.
ROUNDING = 1e-7
# Errors of extrapolated eigenvalues are below this share of the largest one.
EXTRAPOLATED = 1e-5
# Costates beyond this are those of an abnormal extremal, on which the cost has no influence.
ABNORMAL = 1e7


@dataclass(frozen=True)
class Process:
    """A process on N intervals: its values, the quantities that vary, and the multipliers.

    Attributes
    ----------
    states, costates : ndarray, shape (N+1, n)
        At the ends of the intervals.
    controls, free : ndarray, shape (N, k)
        The controls, and whether they vary.
    widths : ndarray, shape (N,)
        Of the intervals.
    shifts : ndarray, shape (N, s)
        Derivatives of the widths by the s times that vary.
    multiplier : float
        lambda_0.
    terminal_multipliers : ndarray, shape (m,)
        Of the target.
    """

    states: np.ndarray
    costates: np.ndarray
    controls: np.ndarray
    free: np.ndarray
    widths: np.ndarray
    shifts: np.ndarray
    multiplier: float
    terminal_multipliers: np.ndarray


@dataclass(frozen=True)
class SecondVariation:
    """The least eigenvalue of the second variation, with its eigenvector.

    Attributes
    ----------
    least, largest : float
        The least eigenvalue and the largest absolute value of all; both infinite if nothing varies.
    states, controls, widths : ndarray or None
        Changes of (x, u, widths) along the least eigenvector.
    """

    least: float
    largest: float
    states: np.ndarray | None = None
    controls: np.ndarray | None = None
    widths: np.ndarray | None = None

    @property
    def sign(self) -> int:
        """1: positive on all variations; -1: negative on some; 0: not decided."""
        if self.least == np.inf:
            return 1
        return int(np.sign(self.least)) if abs(self.least) > ROUNDING * self.largest else 0


def second_variation(numeric: NumericProblem, process: Process) -> SecondVariation:
    """Return the second variation of a process."""
    n, k, N = numeric.n, numeric.k, len(process.widths)
    slopes, curvatures = _intervals(numeric)(
        process.states[:-1].T,
        process.controls.T,
        process.widths,
        process.costates[1:].T,
        process.multiplier,
    )
    slopes = slopes.full().reshape(n, N, n + k + 1)
    curvatures = curvatures.full().reshape(n + k + 1, N, n + k + 1)
    varied, weights = _varied(numeric, process)
    count = len(weights)
    if not count:
        return SecondVariation(np.inf, np.inf)
    change = np.zeros((N + 1, n, count))
    starts = np.nonzero(np.isnan(numeric.start))[0]
    change[0, starts, np.arange(len(starts))] = 1 / np.sqrt(weights[: len(starts)])
    variations = np.zeros((N, n + k + 1, count))
    variations[:, n:] = varied
    for i in range(N):
        variations[i, :n] = change[i]
        change[i + 1] = slopes[:, i] @ variations[i]
    form = np.einsum("iav,aib,ibw->vw", variations, curvatures, variations, optimize=True)
    end = _end(numeric)(process.states[-1], process.multiplier, process.terminal_multipliers)
    form += change[-1].T @ end[0].full() @ change[-1]
    tangents = _null_space(end[1].full() @ change[-1]) if numeric.m else np.eye(count)
    if not tangents.shape[1] or not np.isfinite(form).all():
        return SecondVariation(np.inf, np.inf)
    values, vectors = np.linalg.eigh(tangents.T @ form @ tangents)
    direction = tangents @ vectors[:, 0]
    along = variations @ direction
    # On few variations the eigenvalues may cancel: then rounding is measured by the form on all
    # variations.
    largest = max(float(np.max(np.abs(values))), 1e-6 * float(np.max(np.abs(form))))
    return SecondVariation(
        float(values[0]), largest, change @ direction, along[:, n : n + k], along[:, -1]
    )


def extremal_second_variation(
    numeric: NumericProblem, extremal, duration: float | None
) -> SecondVariation:
    """Return the second variation of an extremal; `duration` is None if it is free.

    Constant controls on N intervals shift eigenvalues by a multiple of 1/N^2, so that zero (a
    family of equally good processes, an inflection) shows as a small number of either sign: the
    value is extrapolated from N and 2N, where it is small from 2N and 4N as well; a least eigenvalue
    that is not clear of the difference of both is set to zero.
    On a singular arc the eigenvalues themselves fall like 1/N^2, and their sign decides.
    """
    variation = second_variation(numeric, process_of_extremal(numeric, extremal, duration))
    singular = any(
        "singular" in (kind if isinstance(kind, tuple) else (kind,)) for kind, _, _ in extremal.arcs
    )
    if singular or not abs(variation.least) < 1e-2 * variation.largest:
        return variation

    def least(factor):
        process = process_of_extremal(numeric, extremal, duration, factor * INTERVALS)
        return second_variation(numeric, process).least

    twice = least(2)
    limit, size = (4 * twice - variation.least) / 3, variation.largest
    if abs(limit) <= EXTRAPOLATED * size:
        before, limit = limit, (4 * least(4) - twice) / 3 if abs(limit) > ROUNDING * size else 0.0
        limit = limit if abs(limit) > 2 * abs(limit - before) else 0.0
    return replace(variation, least=limit)


def _varied(numeric, process):
    """Return derivatives of (u_k, h_k) by the variables, (N, k+1, V), and weights, (V,).

    The variables are the free initial states, the times and the controls.
    """
    N, k = process.free.shape
    first = int(np.isnan(numeric.start).sum())
    free_controls, instants = np.argwhere(process.free), process.shifts.shape[1]
    weights = np.concatenate([np.ones(first + instants), process.widths[free_controls[:, 0]]])
    varied = np.zeros((N, k + 1, len(weights)))
    varied[:, k, first : first + instants] = process.shifts
    columns = first + instants + np.arange(len(free_controls))
    varied[free_controls[:, 0], free_controls[:, 1], columns] = 1 / np.sqrt(weights[columns])
    return varied, weights


def _null_space(matrix):
    """Return an orthonormal basis of the null space in columns."""
    _, sizes, directions = np.linalg.svd(matrix)
    return directions[np.count_nonzero(sizes > 1e-10 * max(sizes[0], 1e-300)) :].T


def _intervals(numeric):
    """Return a function with F' and the second derivatives of the summand of each interval.

    Its arguments are (x, u, h, psi at the end, lambda_0), a column for each interval.
    """

    def build():
        h = ca.SX.sym("h")
        end, piece = runge_kutta(numeric)(numeric.x, numeric.u, h)
        arguments = ca.vertcat(numeric.x, numeric.u, h)
        curvature = ca.hessian(numeric.multiplier * piece - ca.dot(numeric.psi, end), arguments)[0]
        return ca.Function(
            "interval",
            [numeric.x, numeric.u, h, numeric.psi, numeric.multiplier],
            [ca.densify(ca.jacobian(end, arguments)), ca.densify(curvature)],
        )

    function = numeric.cached("second variation of an interval", build)
    return lambda x, u, h, psi, multiplier: function.map(x.shape[1])(
        x, u, ca.DM(h).T, psi, multiplier
    )


def _end(numeric):
    """Return a function with the Hessian at the end and the Jacobian of the target."""

    def build():
        nu = ca.SX.sym("nu", numeric.m)
        value = numeric.multiplier * numeric.final + (
            ca.dot(nu, numeric.target) if numeric.m else 0
        )
        slope = ca.jacobian(numeric.target, numeric.x) if numeric.m else ca.SX(0, numeric.n)
        return ca.Function(
            "end",
            [numeric.x, numeric.multiplier, nu],
            [ca.densify(ca.hessian(value, numeric.x)[0]), ca.densify(slope)],
        )

    return numeric.cached("second variation of the end", build)


def process_of_solution(numeric, solution, terminal_multipliers):
    """Return the process of a discrete solution; controls inside their bounds are free."""
    width = np.where(np.isfinite(numeric.upper - numeric.lower), numeric.upper - numeric.lower, 1.0)
    inside = (solution.controls > numeric.lower + 1e-4 * width) & (
        solution.controls < numeric.upper - 1e-4 * width
    )
    N = len(solution.controls)
    shifts = np.full((N, 1), 1 / N) if numeric.duration is None else np.zeros((N, 0))
    return Process(
        solution.states,
        solution.costates,
        solution.controls,
        inside,
        np.diff(solution.times),
        shifts,
        1.0,
        terminal_multipliers,
    )


def process_of_extremal(
    numeric: NumericProblem, extremal, duration: float | None, intervals: int = INTERVALS
) -> Process:
    """Return the process of an extremal, its arcs being cut into intervals.

    `duration`: None if it is free. The controls on interior and singular arcs vary, the times of
    jumps from bound to bound, and a free duration, which moves the end of the last arc.
    """
    k = numeric.k
    arcs = [
        ((kind,) if isinstance(kind, str) else kind, begin, end)
        for kind, begin, end in extremal.arcs
    ]
    counts = [
        int(np.ceil(max(6, intervals * (end - begin) / extremal.duration)))
        for _, begin, end in arcs
    ]
    bounds = {"u-": numeric.lower, "u+": numeric.upper}
    offsets = np.cumsum([0, *counts])
    parts = [
        begin + (end - begin) * np.arange(1, count + 1) / count
        for (_, begin, end), count in zip(arcs, counts)
    ]
    ends = np.concatenate([[0.0], *parts])
    widths = np.repeat(
        [(end - begin) / count for (_, begin, end), count in zip(arcs, counts)], counts
    )
    inside = [[kind in ("interior", "singular") for kind in kinds] for kinds, _, _ in arcs]
    free = np.repeat(inside, counts, axis=0)
    # The times that vary, each with the arcs before and after it (none after the end).
    instants = [
        index
        for index in range(len(arcs) - 1)
        if any(
            a in bounds and b in bounds and a != b
            for a, b in zip(arcs[index][0], arcs[index + 1][0])
        )
    ]
    instants += [len(arcs) - 1] * (duration is None)
    shifts = np.zeros((len(widths), len(instants)))
    for column, index in enumerate(instants):
        shifts[offsets[index] : offsets[index + 1], column] = 1 / counts[index]
        if index + 1 < len(arcs):
            shifts[offsets[index + 1] : offsets[index + 2], column] = -1 / counts[index + 1]
    controls = extremal.control((ends[1:] + ends[:-1]) / 2).T.reshape(-1, k)
    return Process(
        extremal.state(ends).T,
        extremal.costate(ends).T,
        controls,
        free,
        widths,
        shifts,
        extremal.multiplier,
        # Also of inequalities that are active at the end, which the variations keep.
        np.array(extremal._shot.terminal_multipliers),
    )
