"""Residuals of a trajectory in each condition of the maximum principle.

Panels and Gaussian quadrature for the differential equations, direct comparison of H for the
maximum condition; SymPy and NumPy only, so that nothing is shared with the numerical solution.
"""

import itertools
from functools import cached_property, lru_cache

import numpy as np
import sympy as sp

from trajlib.pontryagin.problem.derivation import conditions
from trajlib.pontryagin.problem.singular import raw_derivatives

GAUSS = np.polynomial.legendre.leggauss(12)


class TrajectoryResiduals:
    """A trajectory on its panels: `times` (N,) and the values there, `edges` of the panels."""

    def __init__(
        self, problem, state, costate, control, duration, switching_times, multiplier, panels
    ):
        self.problem, self.multiplier = problem, float(multiplier)
        arc_ends = np.array([0.0, *sorted(float(t) for t in switching_times), float(duration)])
        if not np.all(np.diff(arc_ends) > 0):
            raise ValueError(
                f"certify: expected switching times between 0 and the duration {duration}, got "
                f"{list(switching_times)}"
            )
        self.arc_count = len(arc_ends) - 1
        self.edges = np.unique(
            np.concatenate([np.linspace(a, b, panels + 1) for a, b in itertools.pairwise(arc_ends)])
        )
        widths = np.diff(self.edges)
        self.times = (self.edges[:-1, None] + (1 + GAUSS[0]) / 2 * widths[:, None]).ravel()
        self.weights = widths[:, None] / 2 * GAUSS[1]
        n, k = len(problem.state), len(problem.control)
        self.y, self.psi, self.u = (
            sampled(f, self.times, rows, name)
            for f, rows, name in (
                (state, n, "state"),
                (costate, n, "costate"),
                (control, k, "control"),
            )
        )
        self.y_edges, self.psi_edges = (
            sampled(state, self.edges, n, "state"),
            sampled(costate, self.edges, n, "costate"),
        )
        # At the final time the control is that of the last arc.
        self.last_control = self.u[:, -1]
        derived = conditions(problem)
        self.derived, lam = derived, derived.multiplier
        symbols = [*problem.state, *derived.costate, *problem.control, lam]
        self.curved = [u for u in problem.control if u not in derived.switching]
        # One function for values needed once or twice, since compiling takes longer than calling
        # it.
        self._parts, expressions = {}, []
        for name, group in (
            ("field", problem.field),
            ("adjoint", derived.adjoint.values()),
            ("running", [problem.running]),
            ("slopes", [sp.diff(derived.hamiltonian, u) for u in self.curved]),
            ("curvatures", [sp.diff(derived.hamiltonian, u, 2) for u in self.curved]),
        ):
            self._parts[name] = slice(len(expressions), len(expressions) + len(group))
            expressions += group
        self._rates, self._hamiltonian = (
            compiled(tuple(symbols), tuple(expressions)),
            compiled(tuple(symbols), (derived.hamiltonian,)),
        )
        self.rates = self._at("field", self.y, self.psi, self.u)
        self.densities = self._at("running", self.y, self.psi, self.u)
        self.adjoint_rates = self._at("adjoint", self.y, self.psi, self.u)

    def _at(self, name, y, psi, u):
        return self._rates(*y, *psi, *u, self.multiplier)[self._parts[name]]

    def hamiltonian(self, y, psi, u):
        """Return H at points (columns)."""
        return self._hamiltonian(*y, *psi, *u, self.multiplier)[0]

    def defects(self):
        """Return the largest defects of the dynamics and of the adjoint system in integral form."""
        results = []
        for edges, rates in (
            (self.y_edges, self.rates),
            (self.psi_edges, self.adjoint_rates),
        ):
            integrals = np.sum(
                rates.reshape(len(edges), *self.weights.shape) * self.weights, axis=-1
            )
            results.append(
                float(np.max(np.abs(np.diff(edges) - integrals)) / (1 + np.max(np.abs(edges))))
            )
        return results

    def initial(self):
        """Return the largest error of the initial conditions and of a given duration."""
        fixed = [
            (i, float(v)) for i, v in enumerate(self.problem.initial.values()) if v is not None
        ]
        free = [i for i, v in enumerate(self.problem.initial.values()) if v is None]
        errors = [abs(self.y_edges[i, 0] - v) / (1 + abs(v)) for i, v in fixed]
        errors += [abs(self.psi_edges[i, 0]) / (1 + np.max(np.abs(self.psi_edges))) for i in free]
        duration = self.problem.duration
        if duration is not None and not isinstance(duration, tuple):
            errors.append(abs(self.edges[-1] - float(duration)) / (1 + float(duration)))
        return float(max(errors))

    @cached_property
    def _end_values(self):
        """The terminal equations at the end, the gradient of phi_0, and their gradients."""
        problem, state = self.problem, self.problem.state
        expressions = [
            *problem.terminal,
            *(sp.diff(problem.final, s) for s in state),
            *(sp.diff(g, s) for g in problem.terminal for s in state),
        ]
        return compiled(state, tuple(expressions))(*self.y_edges[:, -1:])[:, 0]

    def terminal(self):
        """Return the largest error of the terminal equations."""
        if not self.problem.terminal:
            return 0.0
        end = self.y_edges[:, -1]
        values = self._end_values[: len(self.problem.terminal)]
        return float(np.max(np.abs(values)) / (1 + np.max(np.abs(end))))

    @property
    def end_vector(self):
        """psi + lambda_0 grad phi_0 at the end, (n,)."""
        m, n = len(self.problem.terminal), len(self.problem.state)
        sign = -1 if self.problem.maximise else 1
        return self.psi_edges[:, -1] + sign * self.multiplier * self._end_values[m : m + n]

    @property
    def end_normals(self):
        """The gradients of the terminal equations at the end, (n, m)."""
        m, n = len(self.problem.terminal), len(self.problem.state)
        return self._end_values[m + n :].reshape(m, n).T

    def transversality(self):
        """Return the distance of psi + lambda_0 grad phi_0 from the normals of the target."""
        vector, normals = self.end_vector, self.end_normals
        if normals.shape[1]:
            vector = vector - normals @ np.linalg.lstsq(normals, vector, rcond=1e-12)[0]
        return float(np.max(np.abs(vector)) / (1 + np.max(np.abs(self.psi_edges))))

    def bound_violation(self):
        """Return the largest violation of the bounds on the controls."""
        worst = 0.0
        for values, (low, high) in zip(self.u, self.problem.controls.values()):
            low, high = float(low), float(high)
            worst = max(
                worst,
                float(
                    np.max(np.maximum(low - values, values - high)) / (1 + np.max(np.abs(values)))
                ),
            )
        return worst

    def excess(self):
        """Return max H - H at the times (N,), and max H at the final time."""
        y = np.column_stack([self.y, self.y_edges[:, -1]])
        psi = np.column_stack([self.psi, self.psi_edges[:, -1]])
        u = np.column_stack([self.u, self.last_control])
        H = self.hamiltonian(y, psi, u)
        best = H.copy()
        for _ in range(2 if len(u) > 1 else 1):
            u_best = u.copy()
            # Control after control; a second round where several controls act on one another.
            for j in range(len(u)):
                best, u_best = self._improved(y, psi, u_best, best, j)
            u = u_best
        return (best - H)[:-1], float(best[-1])

    def _improved(self, y, psi, u, best, j):
        """Maximise H over control j at all points; return the values of H and the controls."""
        low, high = (float(b) for b in self.problem.controls[self.problem.control[j]])
        linear = self.problem.control[j] in self.derived.switching
        candidates = _candidates(u[j], low, high, linear)
        if not linear:
            with np.errstate(all="ignore"):
                index = self.curved.index(self.problem.control[j])
                newton = (
                    u[j]
                    - (self._at("slopes", y, psi, u) / self._at("curvatures", y, psi, u))[index]
                )
            candidates.append(np.clip(np.where(np.isfinite(newton), newton, u[j]), low, high))
        for candidate in candidates:
            trial = u.copy()
            trial[j] = candidate
            value = self.hamiltonian(y, psi, trial)
            better = value > best
            best = np.where(better, value, best)
            u = np.where(better[None, :], trial, u)
        return best, u

    def passage(self):
        """Return how far the terminal equation changes its sign before the end, relatively."""
        if not self.problem.first_return:
            return 0.0
        values = compiled(self.problem.state, tuple(self.problem.terminal))(*self.y)[0]
        side = np.sign(values[np.argmax(np.abs(values))])
        largest = np.max(np.abs(values))
        return float(max(np.max(-side * values), 0.0) / largest) if largest > 0 else 0.0

    def kelley(self, arcs):
        """Return the largest (-1)^q b on the singular arcs; None without such arcs."""
        per_arc = len(self.times) // self.arc_count
        worst = None
        for index, kind in enumerate(arcs or []):
            for j, kind_of_control in enumerate([kind] if isinstance(kind, str) else kind):
                if kind_of_control != "singular":
                    continue
                u = self.problem.control[j]
                derivatives, highest = raw_derivatives(self.derived, u)
                if highest is None:
                    return np.inf
                b = (-1) ** (len(derivatives) // 2) * sp.diff(highest, u)
                symbols = [
                    *self.problem.state,
                    *self.derived.costate,
                    *self.problem.control,
                    self.derived.multiplier,
                ]
                part = slice(index * per_arc, (index + 1) * per_arc)
                values = compiled(tuple(symbols), (b,))(
                    *self.y[:, part], *self.psi[:, part], *self.u[:, part], self.multiplier
                )
                worst = max(float(np.max(values)), -np.inf if worst is None else worst)
        return worst


def _candidates(u, low, high, linear):
    """Return other values for one control: its bounds, and a grid where H is not linear in it."""
    candidates = [bound for bound in (low, high) if np.isfinite(bound)]
    if linear:
        # Without a bound on some side, H grows beyond every limit unless its slope is zero.
        return candidates + [u + 1] * (high == np.inf) + [u - 1] * (low == -np.inf)
    reach = 10 * (1 + np.max(np.abs(u)))
    grid = np.linspace(
        low if np.isfinite(low) else -reach, high if np.isfinite(high) else reach, 201
    )
    near = [np.clip(u + step, low, high) for step in (-1e-2, -1e-3, 1e-3, 1e-2)]
    return candidates + list(grid) + near


def sampled(function, times, rows, name):
    """Evaluate a function at the times. Raises ValueError if the shape is wrong."""
    values = np.asarray(function(times), dtype=float)
    if values.shape != (rows, len(times)):
        raise ValueError(
            f"certify: expected {name}(t) of shape ({rows}, {len(times)}) for {len(times)} times, "
            f"got {values.shape}"
        )
    return values


@lru_cache(maxsize=64)
def compiled(symbols, expressions):
    """Return a NumPy function of arrays with one row for each expression."""
    # The module itself, not its name, for which SymPy would import all names of NumPy, which takes
    # half a second.
    raw = sp.lambdify(list(symbols), list(expressions), [np], cse=True)

    def value(*arguments):
        shape = np.broadcast_shapes(*(np.shape(a) for a in arguments))
        return np.array(
            [np.broadcast_to(np.asarray(row, dtype=float), shape) for row in raw(*arguments)]
        )

    return value
