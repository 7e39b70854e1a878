"""A plane linear plant x' = Ax + bu by closed formulas: motions, and how far directions can be carried."""

import numpy as np
import sympy as sp


class Plant:
    """x' = Ax + bu in the plane, by closed formulas."""

    def __init__(self, field, state, control, bounds):
        field = sp.Matrix([sp.sympify(component) for component in field])
        A, b = field.jacobian(state), field.diff(control)
        if len(state) != 2 or (field - A * sp.Matrix(state) - b * control).applyfunc(sp.expand) != sp.zeros(2, 1):
            raise ValueError("the plant has to be linear in two state variables and the control")
        self.A, self.b = np.array(A, dtype=float), np.array(b, dtype=float).ravel()
        self.bounds = tuple(float(bound) for bound in bounds)
        self.mean, self.half = sum(self.bounds) / 2, (self.bounds[1] - self.bounds[0]) / 2
        self._trace, self._determinant = np.trace(self.A), self.A[0, 0] * self.A[1, 1] - self.A[0, 1] * self.A[1, 0]
        self._square = (self._trace / 2)**2 - self._determinant
        self._root = np.sqrt(abs(self._square))
        self._turned = self.A @ self.b - self._trace / 2 * self.b
        if abs(self._determinant) > 1e-12:
            self._inverse = np.linalg.inv(self.A)

    def exponential(self, s):
        """e^{As}, an array with two more axes than s."""
        s, centre = np.asarray(s, dtype=float), self._trace / 2
        even, odd = self._waves(s)
        growth = np.exp(centre * s)
        return (growth * even)[..., None, None] * np.eye(2) + (growth * odd)[..., None, None] * (self.A - centre * np.eye(2))

    def response(self, s):
        """(e^{As} b, its integral from 0 to s)."""
        s, centre = np.asarray(s, dtype=float)[..., None], self._trace / 2
        even, odd = self._waves(s)
        impulse = even * self.b + odd * self._turned
        if centre:
            impulse = impulse * np.exp(centre * s)
        if abs(self._determinant) > 1e-12:
            return impulse, (impulse - self.b) @ self._inverse.T
        if abs(self._trace) > 1e-12:
            second = (np.expm1(self._trace * s) / self._trace - s) / self._trace
        else:
            second = s**2 / 2
        return impulse, s * self.b + second * (self.A @ self.b)

    def _waves(self, s):
        """The functions e, o of time with e^{As} = e^{cs}(e E + o (A - cE)), where 2c is the trace of A."""
        if self._square > 1e-14:
            return np.cosh(self._root * s), np.sinh(self._root * s) / self._root
        if self._square < -1e-14:
            return np.cos(self._root * s), np.sin(self._root * s) / self._root
        return np.ones_like(s), s

    def move(self, x, u, s):
        """The states x after times s under constant controls u, each row its own."""
        return np.einsum("nij,nj->ni", self.exponential(s), x) + u[:, None] * self.response(s)[1]

    def extreme(self, p, T, sign, whole=None):
        """The integral over [0, T] of the least (sign -1) or largest (+1) value of p.e^{As}b u; rows of p and T.

        `whole` is the integral of e^{As}b, if it is known already.
        """
        whole = self.response(T)[1] if whole is None else whole
        zeros = self.zeros(p, T)
        inner = np.einsum("nci,ni->nc", self.response(zeros)[1], p)
        last = (whole * p).sum(axis=1)
        absolute = abs(inner[:, 0]) + abs(last - inner[:, -1])
        if inner.shape[1] > 1:
            absolute = absolute + abs(np.diff(inner, axis=1)).sum(axis=1)
        return self.mean * last + sign * self.half * absolute

    def farthest(self, p, T, sign):
        """The integral over [0, T] of e^{As}b u with the u for which p.e^{As}b u is least (sign -1) or largest (+1); rows of p and T.

        So the state farthest against p, or along it, that is reached from the origin in the time T.
        """
        ends = np.column_stack([np.zeros_like(T), self.zeros(p, T), T])
        parts = np.diff(self.response(ends)[1], axis=1)
        u = self.mean + sign * self.half * np.sign(np.einsum("nci,ni->nc", parts, p))
        return (u[..., None] * parts).sum(axis=1)

    def zeros(self, p, T):
        """The zeros of p.e^{As}b between 0 and T in order; rows are filled up with T."""
        start, other = p @ self.b, p @ self._turned
        with np.errstate(all="ignore"):
            if self._square < -1e-14:
                first = np.mod(np.arctan2(-self._root * start, other), np.pi) / self._root
                count = int(T.max(initial=0) * self._root / np.pi) + 1
                inner = first[:, None] + np.arange(count) * np.pi / self._root
            elif self._square > 1e-14:
                inner = np.arctanh(-self._root * start / other)[:, None] / self._root
            else:
                inner = (-start / other)[:, None]
        # Without a zero at positive times (nan or negative) the end stands in its place.
        return np.where(inner > 0, np.minimum(inner, T[:, None]), T[:, None])
