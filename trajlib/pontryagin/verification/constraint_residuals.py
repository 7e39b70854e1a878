"""Residuals of a trajectory in the conditions for its path constraints, from the trajectory alone.

    g(y) <= 0,   psi' = -dH/dy + sum_j eta_j dg_j/dy,   psi(t+) - psi(t-) = sum_j nu_j dg_j/dy,
    eta_j >= 0,   nu_j >= 0,   both zero where g_j < 0

On an arc along which constraints are active, eta follows from the costate itself: its derivative at
the Gaussian points of a panel is that of the polynomial through its values there and at the edges.
What of psi' + dH/dy is no combination of the gradients remains as a defect of the adjoint system.
"""

from functools import cached_property

import numpy as np
import sympy as sp

from trajlib.pontryagin.verification.residuals import GAUSS, compiled, sampled

# Distance from the boundary, in units of the process, up to which a constraint is active.
ACTIVE = 1e-7
# Share of the duration by which one-sided limits are taken beside a switching time.
BESIDE = 1e-13
# Rounds in which the largest values of g between the samples are enclosed, and points of each.
ROUNDS, POINTS = 5, 9


class ConstraintResiduals:
    """The conditions of the path constraints for a trajectory on its panels.

    `values`: the `TrajectoryResiduals` of the trajectory; `state`, `costate`: functions of time.
    """

    def __init__(self, values, state, costate):
        self.values, self.state, self.costate = values, state, costate
        problem = values.problem
        self.count, self.n = len(problem.constraints), len(problem.state)
        gradients = [sp.diff(g, y) for g in problem.constraints for y in problem.state]
        self._function = compiled(problem.state, (*problem.constraints, *gradients, sp.Integer(0)))
        self.arc_ends = values.edges[:: (len(values.edges) - 1) // values.arc_count]
        self.panels = (len(values.edges) - 1) // values.arc_count

    def _evaluate(self, y):
        """Return g, (c, N), and its gradients, (c, n, N)."""
        rows = self._function(*y)
        return rows[: self.count], rows[self.count : -1].reshape(self.count, self.n, rows.shape[1])

    @cached_property
    def one_sided(self):
        """The costate at the beginnings and at the ends of the panels, (n, panels) each."""
        values, width = self.values, BESIDE * self.values.edges[-1]
        begins, ends = values.psi_edges[:, :-1].copy(), values.psi_edges[:, 1:].copy()
        inside = self.arc_ends[1:-1]
        if len(inside):
            after = sampled(self.costate, inside + width, self.n, "costate")
            begins[:, self.panels :: self.panels] = after
            before = sampled(self.costate, inside - width, self.n, "costate")
            ends[:, self.panels - 1 : -1 : self.panels] = before
        return begins, ends

    @cached_property
    def _active(self):
        """Whether a constraint is active along a whole arc, (arcs, c)."""
        arcs = self.values.arc_count
        g = self._evaluate(self.values.y)[0].reshape(
            self.count, arcs, len(self.values.times) // arcs
        )
        return np.all(np.abs(g) <= ACTIVE, axis=-1).T

    @cached_property
    def densities(self):
        """eta at the Gaussian points, (c, N): zero on arcs along which a constraint is inactive."""
        values, (begins, ends) = self.values, self.one_sided
        inside = values.psi.reshape(self.n, len(begins[0]), -1)
        nodes = np.concatenate([begins[:, :, None], inside, ends[:, :, None]], axis=-1)
        slopes = np.einsum("ipk,jk->ipj", nodes, _DIFFERENTIATION[1:-1])
        widths = np.diff(values.edges)
        slopes = (slopes * 2 / widths[None, :, None]).reshape(self.n, -1)
        excess = slopes - values.adjoint_rates
        gradients = self._evaluate(values.y)[1]
        result = np.zeros((self.count, excess.shape[1]))
        per_arc = excess.shape[1] // values.arc_count
        for arc, active in enumerate(self._active):
            indices = np.nonzero(active)[0]
            for k in range(arc * per_arc, (arc + 1) * per_arc) if len(indices) else []:
                normals = gradients[indices, :, k].T
                result[indices, k] = np.linalg.lstsq(normals, excess[:, k], rcond=1e-12)[0]
        return result

    def adjoint_defect(self):
        """Return the largest defect of the adjoint system with eta in integral form."""
        begins, ends = self.one_sided
        gradients = self._evaluate(self.values.y)[1]
        rates = self.values.adjoint_rates + np.einsum("ck,cik->ik", self.densities, gradients)
        weights = self.values.weights
        integrals = np.sum(rates.reshape(self.n, *weights.shape) * weights, axis=-1)
        return float(np.max(np.abs(ends - begins - integrals)) / self._size)

    @property
    def _size(self):
        return 1 + np.max(np.abs(self.values.psi_edges))

    @cached_property
    def _jumps(self):
        """The multipliers of all jumps and the largest part that no multiplier explains."""
        begins, ends = self.one_sided
        left = ends[:, self.panels - 1 : -1 : self.panels]
        right = begins[:, self.panels :: self.panels]
        multipliers, remainder = [], 0.0
        for before, after, y in zip(
            left.T, right.T, self.values.y_edges[:, self.panels : -1 : self.panels].T
        ):
            nu, defect = self._explained(after - before, y)
            multipliers += list(nu)
            remainder = max(remainder, defect)
        return multipliers, remainder / self._size

    def _explained(self, vector, y):
        """Return the multipliers of the gradients at y in a vector, and what remains of it."""
        g, gradients = self._evaluate(y[:, None])
        normals = gradients[np.abs(g[:, 0]) <= ACTIVE, :, 0].T
        if not normals.shape[1]:
            return [], float(np.max(np.abs(vector)))
        nu = np.linalg.lstsq(normals, vector, rcond=1e-12)[0]
        return nu, float(np.max(np.abs(vector - normals @ nu)))

    def jump_defect(self):
        """Return the largest part of a jump of the costate that is no multiple of an active dg/dy."""
        return float(self._jumps[1])

    def sign(self):
        """Return by how much eta >= 0 or nu >= 0 fails, relative to the costate."""
        gradients = np.linalg.norm(self._evaluate(self.values.y)[1], axis=1)
        duration = self.values.edges[-1]
        weighted = self.densities * gradients * duration
        least = min([0.0, *weighted.ravel(), *self._jumps[0], *self._end[0]])
        return float(-least / self._size)

    @cached_property
    def _end(self):
        """The multipliers of the active constraints at the end, and what transversality lacks."""
        from scipy.optimize import nnls

        vector, normals = self.values.end_vector, self.values.end_normals
        g, gradients = (
            np.concatenate(parts)
            for parts in zip(self._evaluate(self.values.y_edges[:, -1:]), self._end_inequalities)
        )
        active = np.abs(g[:, 0]) <= ACTIVE
        columns = np.column_stack([normals, -normals, -gradients[active, :, 0].T])
        if not columns.shape[1]:
            return [], float(np.max(np.abs(vector)))
        weights, _ = nnls(columns, vector)
        return weights[2 * normals.shape[1] :], float(np.max(np.abs(vector - columns @ weights)))

    @property
    def _end_inequalities(self):
        """The terminal inequalities at the end, (i, 1), and their gradients, (i, n, 1)."""
        problem, count = self.values.problem, len(self.values.problem.end_constraints)
        expressions = problem.end_constraints
        gradients = [sp.diff(g, y) for g in expressions for y in problem.state]
        end = self.values.y_edges[:, -1:]
        rows = (
            compiled(problem.state, (*expressions, *gradients))(*end) if count else np.zeros((0, 1))
        )
        return rows[:count], rows[count:].reshape(count, self.n, 1)

    def end_violation(self):
        """Return the largest g of the terminal inequalities at the end, or zero."""
        return float(np.max(self._end_inequalities[0], initial=0.0))

    def transversality(self):
        """Return the distance of psi + lambda_0 grad phi_0 from the cone of the target's normals."""
        return self._end[1] / self._size

    def violation(self):
        """Return the largest g along the trajectory, also between the samples, or zero."""
        edges = self.values.edges
        times = np.unique(np.concatenate([edges, self.values.times]))
        largest = 0.0
        for j in range(self.count):

            def g(t, j=j):
                y = sampled(self.state, np.clip(t, 0, edges[-1]).ravel(), self.n, "state")
                return self._evaluate(y)[0][j].reshape(np.shape(t))

            values = g(times)
            largest = max(largest, float(np.max(values)))
            # A maximum between samples is above all others only near the largest ones.
            peaks = np.nonzero((values[1:-1] >= values[:-2]) & (values[1:-1] >= values[2:]))[0] + 1
            peaks = peaks[np.argsort(values[peaks])[-16:]]
            low, high = times[peaks - 1], times[peaks + 1]
            for _ in range(ROUNDS if len(peaks) else 0):
                grid = low + (high - low) * np.linspace(0, 1, POINTS)[:, None]
                heights = g(grid)
                largest = max(largest, float(np.max(heights)))
                best = np.clip(np.argmax(heights, axis=0), 1, POINTS - 2)
                column = np.arange(len(peaks))
                low, high = grid[best - 1, column], grid[best + 1, column]
        return largest


def _differentiation():
    """Return the matrix that differentiates polynomials by values at -1, the Gaussian points, 1."""
    nodes = np.concatenate([[-1.0], GAUSS[0], [1.0]])
    differences = nodes[:, None] - nodes + np.eye(len(nodes))
    weights = 1 / np.prod(differences, axis=1)
    matrix = weights / weights[:, None] / differences
    np.fill_diagonal(matrix, 0.0)
    return matrix - np.diag(matrix.sum(axis=1))


_DIFFERENTIATION = _differentiation()
