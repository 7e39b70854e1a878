"""Multiple shooting over arcs: the boundary value problem for a given structure.

Unknown are the states, costates and interior controls at the beginning of each arc, the lengths of
the arcs, lambda_0 and the multipliers of the terminal equations. The equations:

    initial state; psi_i(0) = 0 for a free one                              state and costate continuous
    at a switching between bounds: the switching function is zero           (H the same on both sides where it is
    curved) where a singular arc begins: its switching function and the derivatives of orders 1 to 2q-1 are zero where
    an interior arc begins: dH/du = 0; where it meets a bound: its control is at the bound, or, where it jumps, H the
    same on both sides; where an angle jumps by half a turn: H the same on both sides, and the constant angle too;
    between two segments of one arc: equal lengths
    terminal equations, transversality, H = 0 or the given duration         c (lambda_0, psi(0)) = 1

The last one selects one of the proportional multipliers, and admits the abnormal case lambda_0 = 0.
Equations may be redundant (a singular arc from the start) and multipliers not unique, so Newton's
steps are least-squares steps.
"""

import itertools
from dataclasses import dataclass

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.indirect.flow import ArcFlow
from trajlib.pontryagin.problem.arcs import CONSTANT_ANGLES
from trajlib.pontryagin.problem.numeric import NumericProblem

# Size of cancelling terms up to which residuals are relative to them: the growth allowed on a
# segment.
CANCELLING = 1e3
# Share of the largest singular value of the Jacobian below which directions are left out where
# steps get short.
RANK = 1e-8
# Newton's method stops where the residual has not fallen to this share of itself within so many
# steps.
STAGNATION, PATIENCE = 0.9, 10


@dataclass
class ShootingSolution:
    """A trajectory over segments, one or (where errors would grow) several for an arc.

    Attributes
    ----------
    flows : list of ArcFlow
        One for each segment.
    starts : list of ndarray
        y = (x, psi, w) at the beginning of each segment.
    lengths : ndarray
        Of the segments; those of one arc are equal.
    multiplier : float
        lambda_0.
    terminal_multipliers : ndarray, shape (m,)
        Of the target.
    steps : list of int
        Of the integrator on each segment.
    residual : float
        The largest of the equations.
    uncertainty : float
        How far Newton's last step would still move the ends of the segments.
    """

    flows: list[ArcFlow]
    starts: list[np.ndarray]
    lengths: np.ndarray
    multiplier: float
    terminal_multipliers: np.ndarray
    steps: list[int]
    residual: float = np.inf
    uncertainty: float = np.inf


class ArcEquations:
    """The equations for one structure; `residual(z)` returns them with their Jacobian.

    Parameters
    ----------
    numeric : NumericProblem
        The problem.
    flows : list of ArcFlow
        One for each segment.
    steps : list of int
        Of the integrator on each segment.
    duration : float or None
        None for a free final time.
    weights : ndarray, shape (1+n,)
        c above.
    abnormal : bool, optional
        Whether lambda_0 is kept at zero.
    jumps : set of tuple, optional
        As `control_jumps` returns them.
    """

    def __init__(self, numeric, flows, steps, duration, weights, abnormal=False, jumps=()):
        self.numeric, self.flows, self.steps, self.duration = numeric, flows, list(steps), duration
        self.weights, self.abnormal, self.jumps = weights, abnormal, jumps
        offsets = np.cumsum([0] + [flow.size for flow in flows])
        self.blocks = [slice(a, b) for a, b in itertools.pairwise(offsets)]
        self.lengths = slice(offsets[-1], offsets[-1] + len(flows))
        self.multiplier = offsets[-1] + len(flows)
        self.count = self.multiplier + 1 + numeric.m
        x, psi, lam = numeric.x, numeric.psi, numeric.multiplier
        nu = ca.SX.sym("nu", numeric.m)
        end = [numeric.target] if numeric.m else []
        end.append(
            psi
            + lam * ca.gradient(numeric.final, x)
            + (ca.mtimes(ca.jacobian(numeric.target, x).T, nu) if numeric.m else 0)
        )
        self.terminal = ca.Function(
            "terminal",
            [x, psi, lam, nu],
            [ca.vertcat(*end), ca.jacobian(ca.vertcat(*end), ca.vertcat(x, psi, lam, nu))],
        )

    def pack(self, shot):
        """Return the unknowns z of a solution."""
        return np.concatenate(
            [*shot.starts, shot.lengths, [shot.multiplier], shot.terminal_multipliers]
        )

    def unpack(self, z, residual, uncertainty):
        """Return the solution of unknowns z."""
        return ShootingSolution(
            self.flows,
            [z[b] for b in self.blocks],
            z[self.lengths].copy(),
            float(z[self.multiplier]),
            z[self.multiplier + 1 :].copy(),
            list(self.steps),
            residual,
            uncertainty,
        )

    def residual(self, z):
        """Return all equations at z, and their Jacobian."""
        self.z, self.rows, self.jacobian = z, [], []
        n, numeric = self.numeric.n, self.numeric
        lam = z[self.multiplier]
        first = self.blocks[0].start
        for i in range(n):
            free = np.isnan(numeric.start[i])
            column = first + (n + i if free else i)
            self._add(z[column] - (0.0 if free else numeric.start[i]), {column: 1.0})
        self._entry(0, self.flows[0].functions["entry"])
        for index, flow in enumerate(self.flows):
            start, length = z[self.blocks[index]], z[self.lengths][index]
            end, by_start, by_lambda, by_length = flow.transition(
                start, lam, length, self.steps[index]
            )
            derivative = np.zeros((flow.size, self.count))
            derivative[:, self.blocks[index]] = by_start
            derivative[:, self.multiplier] = by_lambda
            derivative[:, self.lengths.start + index] = by_length
            if index + 1 < len(self.flows):
                self._junction(index, end, derivative)
            else:
                self._end(flow, end, derivative, lam)
        weights = {first + n + i: w for i, w in enumerate(self.weights[1:])} | {
            self.multiplier: self.weights[0]
        }
        self._add(sum(w * z[c] for c, w in weights.items()) - 1, weights)
        if self.abnormal:
            self._add(lam, {self.multiplier: 1.0})
        return np.array(self.rows), np.array(self.jacobian)

    def _add(self, value, row):
        """Append one equation; `row`: its derivatives, an array or {column: value}."""
        if isinstance(row, dict):
            full = np.zeros(self.count)
            for column, entry in row.items():
                full[column] = entry
            row = full
        self.rows.append(float(value))
        self.jacobian.append(row)

    def _at_start(self, index, function, components=None):
        """Append equations that a function of (y, lambda_0) vanishes at the beginning of an arc."""
        value, slope = (
            v.full() for v in function(self.z[self.blocks[index]], self.z[self.multiplier])
        )
        for i in range(len(value)) if components is None else components:
            row = np.zeros(self.count)
            row[self.blocks[index]], row[self.multiplier] = slope[i, :-1], slope[i, -1]
            self._add(value[i, 0], row)

    def _entry(self, index, function):
        if function.numel_out(0):
            self._at_start(index, function)

    def _junction(self, index, end, derivative):
        """Append the equations between two segments."""
        left, right = self.flows[index], self.flows[index + 1]
        block, n = self.blocks[index + 1], self.numeric.n
        same_arc = left.kinds == right.kinds
        for i in range(left.size if same_arc else 2 * n):
            row = derivative[i].copy()
            row[block.start + i] -= 1
            self._add(end[i] - self.z[block.start + i], row)
        if same_arc:
            first = self.lengths.start + index
            self._add(self.z[first] - self.z[first + 1], {first: 1.0, first + 1: -1.0})
            return
        self._entry(index + 1, right.functions["entry"])
        for j, (before, after) in enumerate(zip(left.kinds, right.kinds)):
            if before == after:
                continue
            bounds = {"u-": self.numeric.lower[j], "u+": self.numeric.upper[j]}
            if (index, j) in self.jumps:
                self._same_hamiltonian(index, end, derivative)
            elif before in bounds and after in bounds:
                if self.numeric.affine[j]:
                    self._at_start(index + 1, right.functions["slopes"], [j])
                else:
                    self._same_hamiltonian(index, end, derivative)
            elif before in CONSTANT_ANGLES and after in CONSTANT_ANGLES:
                self._same_hamiltonian(index, end, derivative)
                i, column = (
                    2 * n + left.interior.index(j),
                    block.start + 2 * n + right.interior.index(j),
                )
                row = derivative[i].copy()
                row[column] -= 1
                self._add(end[i] - self.z[column], row)
            elif before == "interior" and after in bounds:
                i = 2 * n + left.interior.index(j)
                self._add(end[i] - bounds[after], derivative[i])
            elif before in bounds and after == "interior":
                column = block.start + 2 * n + right.interior.index(j)
                self._add(self.z[column] - bounds[before], {column: 1.0})

    def _same_hamiltonian(self, index, end, derivative):
        """Append the equation that H is the same before and after a switching."""
        lam, block = self.z[self.multiplier], self.blocks[index + 1]
        before, by_end = (v.full() for v in self.flows[index].functions["hamiltonian"](end, lam))
        after, by_start = (
            v.full() for v in self.flows[index + 1].functions["hamiltonian"](self.z[block], lam)
        )
        row = -(by_end[0, :-1] @ derivative)
        row[self.multiplier] -= by_end[0, -1]
        row[block] += by_start[0, :-1]
        row[self.multiplier] += by_start[0, -1]
        self._add(after[0, 0] - before[0, 0], row)

    def _end(self, flow, end, derivative, lam):
        """Append the equations at the end: target, transversality, duration or H = 0."""
        n, m = self.numeric.n, self.numeric.m
        nu = self.z[self.multiplier + 1 :]
        value, slope = (v.full() for v in self.terminal(end[:n], end[n : 2 * n], lam, nu))
        for i in range(m + n):
            row = slope[i, : 2 * n] @ derivative[: 2 * n]
            row[self.multiplier] += slope[i, 2 * n]
            row[self.multiplier + 1 :] += slope[i, 2 * n + 1 :]
            self._add(value[i, 0], row)
        if self.duration is None:
            value, slope = (v.full() for v in flow.functions["hamiltonian"](end, lam))
            row = slope[0, :-1] @ derivative
            row[self.multiplier] += slope[0, -1]
            self._add(value[0, 0], row)
        else:
            row = np.zeros(self.count)
            row[self.lengths] = 1
            self._add(self.z[self.lengths].sum() - self.duration, row)


def control_jumps(numeric, shot):
    """Return {(index, j)} for controls j that jump to or from a bound after segment `index`.

    A control jumps between a bound and an interior arc where H is convex in it at the bound: there
    no stationary value that maximises H can come near.
    """
    result, n = set(), numeric.n
    for index, (left, right) in enumerate(zip(shot.flows, shot.flows[1:])):
        for j, kinds in enumerate(zip(left.kinds, right.kinds)):
            bound = {"u-": numeric.lower[j], "u+": numeric.upper[j]}.get(min(kinds, key=len))
            if "interior" in kinds and bound is not None:
                y = shot.starts[index + 1]
                controls = right.functions["control"](y, shot.multiplier).full().ravel()
                controls[j] = bound
                if numeric.curvature(j, y[:n], y[n : 2 * n], controls, shot.multiplier) > 0:
                    result.add((index, j))
    return result


def newton(equations, z, iterations=80):
    """Solve by damped least-squares Newton steps; the lengths of the arcs stay positive.

    Returns (z, largest residual, uncertainty of the lengths): each residual relative to the terms
    that cancel in its equation (at least to one, at most to CANCELLING), the uncertainty relative
    to the duration.
    """
    r, J = equations.residual(z)
    sizes = []
    for _ in range(iterations):
        sizes.append(np.linalg.norm(r))
        if not np.isfinite(J).all() or sizes[-1] > STAGNATION * max(
            sizes[-PATIENCE - 1 : -PATIENCE], default=np.inf
        ):
            break
        step = _least_squares(J, r, 1e-13)
        better = _shortened(equations, z, r, step, 1e-2)
        if not _rounded(z, sizes[-1]) and (
            better is None or np.linalg.norm(better[1]) > STAGNATION * sizes[-1]
        ):
            # Such a step may go along a family of solutions (a closed path may begin anywhere).
            across = _least_squares(J, r, RANK)
            if better is None or np.linalg.norm(across) < np.linalg.norm(step) / 2:
                truncated = _shortened(equations, z, r, across, 1e-7 if better is None else 1e-2)
                better = min(
                    filter(None, (better, truncated)),
                    key=lambda trial: np.linalg.norm(trial[1]),
                    default=None,
                )
        if better is None:
            break
        z, r, J = better
    if not np.isfinite(J).all():
        return z, np.inf, np.inf
    step = _least_squares(J, r, 1e-13)[equations.lengths]
    return (
        z,
        float(np.max(np.abs(r) / np.clip(np.abs(J) @ np.abs(z), 1.0, CANCELLING))),
        float(np.max(np.abs(step)) / np.sum(z[equations.lengths])),
    )


def _shortened(equations, z, r, step, shortest):
    """Return (z, r, J) after a step that lowers the residual, halved as needed, or None."""
    size = np.linalg.norm(r)
    lengths, change = z[equations.lengths], step[equations.lengths]
    shrinking = change < 0
    # An arc loses at most nine tenths of its length in one step.
    with np.errstate(over="ignore"):
        alpha = min(1.0, 0.9 * np.min(-lengths[shrinking] / change[shrinking], initial=np.inf))
    while alpha > shortest:
        trial = z + alpha * step
        r_trial, J_trial = equations.residual(trial)
        size_trial = np.linalg.norm(r_trial)
        if np.isfinite(size_trial) and size_trial < size * (1 - 1e-4 * alpha):
            return trial, r_trial, J_trial
        # Near rounding error only a full step can still help.
        if _rounded(z, size):
            break
        alpha /= 2
    return None


def _least_squares(J, r, rank):
    """Return the shortest step that minimises |J step + r|.

    Directions below the share `rank` of the largest singular value of J are left out. Where there
    are none, the step solves a square system without singular values, which take most of the time
    of long arcs with many segments.
    """
    count = len(r)
    if J.shape[1] == count:
        try:
            inverse = np.linalg.inv(J)
        except np.linalg.LinAlgError:
            inverse = np.full_like(J, np.inf)
        # The ratio of the singular values is at least 1/n of this one, by the norms.
        if 1 / (np.linalg.norm(J, 1) * np.linalg.norm(inverse, 1)) > count * rank:
            step = -inverse @ r
            return step - inverse @ (J @ step + r)
    return np.linalg.lstsq(J, -r, rcond=rank)[0]


def _rounded(z, size):
    """Check whether residuals of this size are near rounding error."""
    return size <= 1e-12 * (1 + np.linalg.norm(z))


def build_flows(numeric: NumericProblem, kinds, flow_cache: dict) -> list[ArcFlow]:
    """Return an `ArcFlow` for each arc; `flow_cache` keeps them between attempts."""
    for arc_kinds in kinds:
        if arc_kinds not in flow_cache:
            flow_cache[arc_kinds] = ArcFlow(numeric, arc_kinds)
    return [flow_cache[arc_kinds] for arc_kinds in kinds]
