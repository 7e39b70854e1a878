"""Multiple shooting over arcs: the boundary value problem for a given structure.

Unknown are the states, costates and interior controls at the beginning of each arc, the lengths of
the arcs, lambda_0 and the multipliers of the terminal equations. The equations:

    initial state; psi_i(0) = 0 for a free one                              state and costate continuous
    (psi jumps by nu dg/dx at a touch point g = g' = 0, and at the ends of boundary arcs of order two)
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
from dataclasses import dataclass, field

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.indirect.flow import ArcFlow
from trajlib.pontryagin.problem.arcs import CONSTANT_ANGLES
from trajlib.pontryagin.problem.numeric import NumericProblem


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
    jumps : ndarray
        The multipliers nu of the jumps of the costate, in the order of `costate_jumps`.
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
    jumps: np.ndarray = field(default_factory=lambda: np.zeros(0))
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
        self.targets = slice(self.multiplier + 1, self.multiplier + 1 + numeric.m)
        self.costate_jumps = costate_jumps(numeric, flows)
        self.count = self.targets.stop + len(self.costate_jumps)
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
            [*shot.starts, shot.lengths, [shot.multiplier], shot.terminal_multipliers, shot.jumps]
        )

    def unpack(self, z, residual, uncertainty):
        """Return the solution of unknowns z."""
        return ShootingSolution(
            self.flows,
            [z[b] for b in self.blocks],
            z[self.lengths].copy(),
            float(z[self.multiplier]),
            z[self.targets].copy(),
            list(self.steps),
            z[self.targets.stop :].copy(),
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
        same_arc = right.continues(left)
        jump, by_state, nu_column = self._costate_jump(index + 1, end)
        for i in range(left.size if same_arc else 2 * n):
            row = derivative[i].copy()
            row[block.start + i] -= 1
            value = end[i] - self.z[block.start + i]
            if nu_column is not None and n <= i < 2 * n:
                value += self.z[nu_column] * jump[i - n]
                row += self.z[nu_column] * by_state[i - n] @ derivative[:n]
                row[nu_column] += jump[i - n]
            self._add(value, row)
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

    def _costate_jump(self, index, end):
        """Return dg/dx with its derivatives, and the column of nu, for a jump before segment `index`.

        The column is None where the costate is continuous.
        """
        constraint = self.costate_jumps.get(index)
        if constraint is None:
            return None, None, None
        numeric = self.numeric
        function = numeric.cached(f"normal {constraint}", lambda: _normal(numeric, constraint))
        normal, by_state = (v.full() for v in function(end[: numeric.n]))
        column = self.targets.stop + list(self.costate_jumps).index(index)
        return normal.ravel(), by_state, column

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
        nu = self.z[self.targets]
        value, slope = (v.full() for v in self.terminal(end[:n], end[n : 2 * n], lam, nu))
        for i in range(m + n):
            row = slope[i, : 2 * n] @ derivative[: 2 * n]
            row[self.multiplier] += slope[i, 2 * n]
            row[self.targets] += slope[i, 2 * n + 1 :]
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


def costate_jumps(numeric, flows):
    """Return {index: constraint}: where the costate may jump, before segment `index`.

    At touch points, and where boundary arcs of an order above one begin and end.
    """
    result = {}
    for index, (left, right) in enumerate(itertools.pairwise(flows), 1):
        changed = left.boundary != right.boundary
        ends = [c for c in (right.boundary, left.boundary) if changed and c is not None]
        high = [c for c in ends if numeric.path_orders[c] > 1]
        if right.touch is not None:
            result[index] = right.touch
        elif high:
            result[index] = high[0]
    return result


def _normal(numeric, constraint):
    """Return the function x -> dg/dx and its Jacobian."""
    normal = ca.gradient(numeric.path[constraint], numeric.x)
    return ca.Function(
        "normal", [numeric.x], [ca.densify(normal), ca.densify(ca.jacobian(normal, numeric.x))]
    )


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


def arc_flow(numeric: NumericProblem, kinds, touch: int | None, flow_cache: dict) -> ArcFlow:
    """Return the `ArcFlow` of an arc; `flow_cache` keeps it between attempts."""
    if (kinds, touch) not in flow_cache:
        flow_cache[kinds, touch] = ArcFlow(numeric, kinds, touch)
    return flow_cache[kinds, touch]
