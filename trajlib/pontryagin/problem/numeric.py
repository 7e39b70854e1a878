"""Problems in CasADi expressions, from which transcription and shooting begin."""

from copy import copy
from functools import cached_property

import numpy as np
import sympy as sp

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.problem.angle_relaxation import is_angle, relax_angles
from trajlib.pontryagin.problem.casadi_expressions import to_casadi
from trajlib.pontryagin.problem.derivation import conditions
from trajlib.pontryagin.problem.scaling import Scaling
from trajlib.pontryagin.problem.state_constraints import constraint_derivatives
from trajlib.pontryagin.problem.statement import Statement

# Values tried for a control in which H is not linear.
GRID = 41


class NumericProblem:
    """CasADi expressions (SX) of a problem without parameters.

    Attributes
    ----------
    x, psi, u : casadi.SX
        Symbols of length n, n, k; `multiplier` is lambda_0.
    field, density, final, target : casadi.SX
        f, f_0, phi_0 and phi_1, ..., phi_m; f_0 and phi_0 with the signs of a minimum.
    path : casadi.SX
        g_1, ..., with g <= 0 along the path; `path_orders` are their orders. `end_path`: those with
        g <= 0 at the end. The target includes those of the indices `end_constraints`.
    lower, upper : ndarray, shape (k,)
        Bounds of the controls.
    start : ndarray, shape (n,)
        Initial values, nan for a free one.
    duration : float or None
        The given duration; a free one lies between `shortest` and `longest`.
    affine, angles : list of bool
        Whether H is linear in a control; whether a control is an angle without bounds.
    scaling : Scaling or None
        From the user's units to those of the problem, where they differ.
    """

    # A free final time is bounded by default: from below since it would shrink to zero or beyond,
    # from above since a problem without a minimum would run away. In natural units of time.
    SHORTEST, LONGEST = 1e-6, 1e3

    def __init__(self, problem: Statement, scaling: Scaling | None = None):
        if problem.parameters:
            names = ", ".join(map(str, problem.parameters))
            raise ValueError(f"solve: no value for {names}; give values by problem.subs({{...}})")
        _refuse_kinks(problem)
        self.problem, self.scaling = problem, scaling
        switching = conditions(problem).switching
        # Whether H is linear in a control, so that a bound or a singular arc makes it largest.
        self.affine = [u in switching for u in problem.control]
        # Angles without bounds: a whole turn more changes nothing.
        self.angles = [is_angle(problem, u) for u in problem.control]
        self.n, self.k, self.m = len(problem.state), len(problem.control), len(problem.terminal)
        self.x, self.psi = ca.SX.sym("x", self.n), ca.SX.sym("psi", self.n)
        self.u, self.multiplier = ca.SX.sym("u", self.k), ca.SX.sym("lambda0")
        table = {s: self.x[i] for i, s in enumerate(problem.state)} | {
            s: self.u[i] for i, s in enumerate(problem.control)
        }
        sign = -1 if problem.maximise else 1
        translated = to_casadi(
            [*problem.field, sign * problem.running, sign * problem.final, *problem.terminal], table
        )
        self.field = ca.vertcat(*translated[: self.n])
        self.density, self.final = translated[self.n], translated[self.n + 1]
        self.target = ca.vertcat(*translated[self.n + 2 :])
        self.end_constraints: tuple[int, ...] = ()
        self.path = ca.vertcat(*to_casadi(problem.constraints, table))
        self.end_path = ca.vertcat(*to_casadi(problem.end_constraints, table))
        self.path_orders = [
            len(constraint_derivatives(problem, g)) - 1 for g in problem.constraints
        ]
        self.lower, self.upper = (
            np.array([_number(b[i]) for b in problem.controls.values()]) for i in (0, 1)
        )
        self.start = np.array(
            [np.nan if v is None else _number(v) for v in problem.initial.values()]
        )
        self.duration = None if problem.free_time else _number(problem.duration)
        low, high = (
            problem.duration
            if isinstance(problem.duration, tuple)
            else (self.SHORTEST, self.LONGEST)
        )
        self.shortest, self.longest = max(_number(low), self.SHORTEST), min(_number(high), 1e6)
        self.time_bounds_given = isinstance(problem.duration, tuple)

    @cached_property
    def assumed_start(self):
        """Initial values with 0 for a free one; with 1 where the problem is not defined at 0."""
        zero, one = (np.where(np.isnan(self.start), value, self.start) for value in (0.0, 1.0))
        values = ca.Function("values", [self.x, self.u], [self.field, self.density, self.path])
        defined = all(
            np.isfinite(part).all() for part in map(np.array, values(zero, self.middle()))
        )
        return zero if defined else one

    def cached(self, name, compute):
        """Return the result of `compute()`, kept under a name: a CasADi function is built once."""
        results = self.__dict__.setdefault("_cached", {})
        if name not in results:
            results[name] = compute()
        return results[name]

    @cached_property
    def hamiltonian(self):
        """H, with lambda_0."""
        return ca.dot(self.psi, self.field) - self.multiplier * self.density

    @cached_property
    def slopes(self):
        """dH/du, shape (k,)."""
        return ca.gradient(self.hamiltonian, self.u)

    @cached_property
    def adjoint(self):
        """-dH/dx, shape (n,)."""
        return -ca.gradient(self.hamiltonian, self.x)

    @cached_property
    def angle_relaxation(self):
        """The problem with discs for its angles, or None (see the module `angle_relaxation`)."""
        return relax_angles(self.problem)

    @cached_property
    def target_value(self):
        """Function of x: the terminal expressions and their Jacobian."""
        return ca.Function("target", [self.x], [self.target, ca.jacobian(self.target, self.x)])

    def with_end_constraints(self, constraints):
        """Return the same problem with inequalities as further terminal equations.

        `constraints`: indices into the path constraints followed by the terminal inequalities.
        """
        if not constraints:
            return self
        result = copy(self)
        for name in ("_cached", "target_value"):
            result.__dict__.pop(name, None)
        result.target = ca.vertcat(
            self.target, *(ca.vertcat(self.path, self.end_path)[j] for j in constraints)
        )
        result.m = self.m + len(constraints)
        result.end_constraints = tuple(constraints)
        return result

    @cached_property
    def path_value(self):
        """Function of x: the path constraints and their Jacobian."""
        return ca.Function("path", [self.x], [self.path, ca.jacobian(self.path, self.x)])

    @cached_property
    def final_value(self):
        """Function of x: phi_0."""
        return ca.Function("final", [self.x], [self.final])

    def concave(self, i, states, costates, controls):
        """Check whether H is strictly concave in control i at N points (rows), also at its bounds."""
        if self.affine[i]:
            return False
        trials = [controls.copy() for _ in range(3)]
        trials[0][:, i], trials[1][:, i] = self.lower[i], self.upper[i]
        return all(
            self.curvature(i, *point) < 0
            for trial in trials
            for point in zip(states, costates, trial)
        )

    def curvature(self, i, state, costate, controls, multiplier=1.0):
        """Return d2H/du_i2 at a point."""
        value = self.cached(
            f"curvature {i}",
            lambda: ca.Function(
                "curvature",
                [self.x, self.psi, self.u, self.multiplier],
                [ca.jacobian(self.slopes[i], self.u[i])],
            ),
        )
        return float(value(state, costate, controls, multiplier))

    def best_controls(self, states, costates, controls):
        """Return controls at N points (rows) that maximise H on a grid, and the growth of H, (N,).

        With lambda_0 = 1, the controls between two bounds in which H is not linear are changed one
        after the other; the others stay.
        """
        value = self.cached(
            "hamiltonian",
            lambda: ca.Function(
                "hamiltonian", [self.x, self.psi, self.u, self.multiplier], [self.hamiltonian]
            ),
        )

        def values(u, times):
            points = (np.tile(part, (times, 1)).T for part in (states, costates))
            return value.map(len(u))(*points, u.T, 1.0).full().reshape(times, -1)

        best, before, rows = controls.copy(), values(controls, 1)[0], np.arange(len(controls))
        largest = before
        for i in np.nonzero(~np.array(self.affine) & np.isfinite(self.upper - self.lower))[0]:
            trials = np.tile(best, (GRID + 1, 1, 1))
            trials[1:, :, i] = np.linspace(self.lower[i], self.upper[i], GRID)[:, None]
            H = values(trials.reshape(-1, self.k), GRID + 1)
            chosen = np.argmax(H, axis=0)
            best, largest = trials[chosen, rows], H[chosen, rows]
        return best, largest - before

    def user_cost(self, value):
        """Return a cost in the user's units, with the sign that it has in the statement."""
        value = -value if self.problem.maximise else value
        if self.scaling is None:
            return value
        return value * float(self.scaling.cost) + float(self.scaling.constant_cost)

    def user_time(self, value):
        """Return a time in the user's unit."""
        return value if self.scaling is None else value * float(self.scaling.time)

    def middle(self):
        """Return a control inside the bounds, (k,)."""
        low = np.where(
            np.isfinite(self.lower),
            self.lower,
            np.where(np.isfinite(self.upper), self.upper - 1, 0.0),
        )
        high = np.where(
            np.isfinite(self.upper),
            self.upper,
            np.where(np.isfinite(self.lower), self.lower + 1, 0.0),
        )
        return (low + high) / 2


def runge_kutta(numeric):
    """Return one classical Runge-Kutta step (x, u, h) -> (x after h, integral of f_0 over it)."""
    h = ca.SX.sym("h")
    rate = ca.Function("rate", [numeric.x, numeric.u], [numeric.field, numeric.density])
    x, u = numeric.x, numeric.u
    k1, c1 = rate(x, u)
    k2, c2 = rate(x + h / 2 * k1, u)
    k3, c3 = rate(x + h / 2 * k2, u)
    k4, c4 = rate(x + h * k3, u)
    return ca.Function(
        "step",
        [x, u, h],
        [x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), h / 6 * (c1 + 2 * c2 + 2 * c3 + c4)],
    )


def _refuse_kinks(problem):
    """Raise ValueError where H is not smooth in the controls, or has no derivative by a state."""
    kinks = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.Piecewise, sp.Heaviside)
    for e in (*problem.field, problem.running):
        for kink in e.atoms(*kinks):
            if kink.free_symbols & set(problem.control):
                raise ValueError(
                    f"solve: {kink} is not smooth in the control. Only Abs(u) of a single control "
                    "in the running cost is split here; otherwise split the control likewise: u = "
                    "p - q with the controls p, q >= 0, and p + q in place of Abs(u)."
                )
    for e in (*problem.field, problem.running, problem.final, *problem.terminal):
        for part in e.atoms(*kinks, sp.floor, sp.ceiling):
            for y in part.free_symbols & set(problem.state):
                if _has_derivative(part, y):
                    continue
                real = sp.Symbol(y.name, real=True)
                raise ValueError(
                    f"solve: {part} has no derivative for complex {y}; declare it as "
                    f'sp.Symbol("{y}", real=True)'
                    if _has_derivative(part.subs(y, real), real)
                    else f"solve: {part} jumps, and the conditions need its derivative; put a "
                    f"smooth function in its place, such as tanh({y}/epsilon) with a small epsilon"
                )


def _has_derivative(e, y):
    return not e.diff(y).has(sp.Derivative, sp.DiracDelta)


def _number(value):
    return float(sp.N(value))
