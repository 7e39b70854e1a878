"""The term of H of one control of a planar problem, and the levels that maximise it.

    H_j = (psi^T f_j - lambda_0 g) u - lambda_0 (k |u| + r u^2/2),   u_- <= u <= u_+

Where this is concave in u the maximum is at a bound, between the bounds (r > 0) or at the corner
u = 0 (k > 0); where it is convex, at a bound.
"""

from itertools import product

import sympy as sp


class Level:
    """A level of a control: its name as in `Extremal.arcs`, and its value, None if psi gives it."""

    def __init__(self, name, value=None):
        self.name, self.value = name, value


class ControlTerm:
    """The term of H of the control u; `cost` is f_0 of the problem with the sign of a minimum.

    Attributes
    ----------
    levels : list of Level
        In increasing order of u.
    singular : list of sympy.Expr
        They vanish where a switching function can vanish on an arc.
    open : bool
        Whether a switching function that vanishes once vanishes on the whole extremal, so that the
        control is open there (only with other controls).
    """

    def __init__(self, problem, cost, u):
        self.u, (self.low, self.high) = u, problem.controls[u]
        x, other_controls = sp.Matrix(problem.state), [v for v in problem.control if v != u]
        f = sp.Matrix(problem.field)
        self.input_field = f.diff(u)
        l1_weight = cost.coeff(sp.Abs(u)) if cost.has(sp.Abs(u)) else sp.Integer(0)
        smooth = sp.expand(cost - l1_weight * sp.Abs(u))
        linear, quadratic_weight = smooth.diff(u).subs(u, 0), sp.simplify(smooth.diff(u, 2))
        self._check(f, smooth, l1_weight, quadratic_weight, other_controls)
        if l1_weight != 0 and not self.low < 0 < self.high:  # |u| is u or -u
            linear, l1_weight = linear + (l1_weight if self.low >= 0 else -l1_weight), sp.Integer(0)
        self.linear, self.l1_weight, self.quadratic_weight = linear, l1_weight, quadratic_weight
        self.convex = (
            _sign(l1_weight, f"the factor of |{u}|") >= 0
            and _sign(quadratic_weight, f"the factor of {u}^2") >= 0
        )
        if not self.convex and max(_sign(l1_weight, ""), _sign(quadratic_weight, "")) > 0:
            raise ValueError(f"running: it is neither convex nor concave in {u}")
        self._make_levels()
        self._make_singular(problem, f, cost, x, other_controls)

    def surfaces(self, psi, lambda_0):
        """Return [(expression, its size)] between the levels, positive where the control is above."""
        return [
            (
                (psi.T * self.input_field)[0] - lambda_0 * shift,
                psi.norm() * self.input_field.norm() + lambda_0 * sp.Abs(shift),
            )
            for shift in self._shifts
        ]

    def between(self, psi, lambda_0):
        """Return {number of the level: value} for the levels between the bounds."""
        slope = (psi.T * self.input_field)[0] - lambda_0 * self.linear
        values = {}
        for i, level in enumerate(self.levels):
            if level.name == "interior":
                below = any(later.name == "zero" for later in self.levels[i:])
                corner = self.l1_weight if self.l1_weight == 0 or below else -self.l1_weight
                values[i] = (slope + lambda_0 * corner) / (lambda_0 * self.quadratic_weight)
        return values

    def _check(self, f, smooth, l1_weight, quadratic_weight, other_controls):
        u = self.u
        if any(sp.simplify(e) != 0 for e in f.diff(u, 2)) or any(
            sp.simplify(e) != 0 for v in other_controls for e in f.diff(u, v)
        ):
            raise ValueError(
                f"problem: the right-hand side is not affine in {', '.join(map(str, [u, *other_controls]))}"
            )
        if smooth.has(sp.Abs(u)) or l1_weight.has(u) or quadratic_weight.has(u):
            raise ValueError(
                f"running: expected a polynomial of at most the second degree in {u}, and a "
                f"multiple of |{u}|"
            )
        if any(sp.simplify(smooth.diff(u, v)) != 0 for v in other_controls):
            raise ValueError(
                f"running: a product of {u} with another control, so that the maximum condition "
                "does not tell the controls one by one"
            )
        if not (self.low.is_finite and self.high.is_finite and self.low < self.high):
            raise ValueError(
                f"problem: expected finite bounds {u}_- < {u}_+, got ({self.low}, {self.high})"
            )

    def _make_levels(self):
        low, high, g, k, r = self.low, self.high, self.linear, self.l1_weight, self.quadratic_weight
        bottom, top = Level("u-", float(low)), Level("u+", float(high))
        if not self.convex:
            # H(u_+) - H(u_-), divided by u_+ - u_-.
            self.levels = [bottom, top]
            self._shifts = [g + r * (low + high) / 2 + k * (abs(high) - abs(low)) / (high - low)]
            return
        middle, shifts = [], []
        if k != 0:
            middle, shifts = [Level("zero", 0.0)], [g - k, g + k]
        if r != 0:
            middle = (
                [Level("interior"), *middle, Level("interior")] if k != 0 else [Level("interior")]
            )
            shifts = [g - k + r * low, *shifts, g + k + r * high]
        self.levels, self._shifts = [bottom, *middle, top], shifts or [g]

    def _make_singular(self, problem, f, cost, x, other_controls):
        self.singular, self.open = [], False
        if self.quadratic_weight != 0 and self.convex:
            return
        parallel = True
        smooth_cost = cost - self.l1_weight * sp.Abs(self.u)
        for shift in self._shifts:
            extended_field = sp.Matrix([*self.input_field, shift])
            for values in product(*(problem.controls[v] for v in other_controls)):
                constants = {self.u: 0, **dict(zip(other_controls, values))}
                field = sp.Matrix([*f, smooth_cost]).subs(constants)
                bracket = (
                    extended_field.jacobian(x) * field[:2, :]
                    - field.jacobian(x) * extended_field[:2, :]
                )
                # Without running cost H = 0 means psi^T f = 0, and its third row is zero.
                rows = (
                    (extended_field, bracket)
                    if field[2] == shift == 0
                    else (field, extended_field, bracket)
                )
                det = sp.simplify(sp.Matrix.hstack(*rows)[: len(rows), :].det())
                parallel = parallel and all(
                    sp.simplify(e) == 0 for e in extended_field.cross(bracket)
                )
                if det not in self.singular:
                    self.singular.append(det)
        self.open = parallel and bool(other_controls)
        if self.open:
            self.levels.append(Level("open"))
            self.singular = []
        elif any(det == 0 for det in self.singular):
            raise ValueError(
                "problem: det(f1, [f0, f1]) vanishes everywhere, so extremals may be singular "
                "along their "
                "whole length; for a linear system: the pair (A, b) is not controllable"
            )


def _sign(expression, name):
    """Return the sign of a number. Raises ValueError if it is not known."""
    if expression == 0:
        return 0
    if expression.is_positive or expression.is_negative:
        return 1 if expression.is_positive else -1
    raise ValueError(f"running: expected {name} to have one sign, got {expression}")
