"""A plane linear plant x' = Ax + bu by closed formulas: motions, and support functions."""

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData


class Plant:
    """x' = Ax + bu in the plane, by closed formulas."""

    def __init__(self, field, state, control, bounds):
        field = sp.Matrix([sp.sympify(component) for component in field])
        A, b = field.jacobian(state), field.diff(control)
        if len(state) != 2 or (field - A * sp.Matrix(state) - b * control).applyfunc(
            sp.expand
        ) != sp.zeros(2, 1):
            raise UnsuitableData(
                "the plant has to be linear in two state variables and the control"
            )
        self.A, self.b = np.array(A, dtype=float), np.array(b, dtype=float).ravel()
        self.bounds = tuple(float(bound) for bound in bounds)
        self.mean, self.half = sum(self.bounds) / 2, (self.bounds[1] - self.bounds[0]) / 2
        self._trace = np.trace(self.A)
        self._determinant = self.A[0, 0] * self.A[1, 1] - self.A[0, 1] * self.A[1, 0]
        self._square = (self._trace / 2) ** 2 - self._determinant
        self._root = np.sqrt(abs(self._square))
        self._deviator_input = self.A @ self.b - self._trace / 2 * self.b
        self._deviator = self.A - self._trace / 2 * np.eye(2)
        #: Where A has an inverse, the integral of e^{As}b is found with it.
        self._inverse = np.linalg.inv(self.A) if abs(self._determinant) > 1e-12 else None
        integral_vectors = (
            (self.b, self.A @ self.b)
            if self._inverse is None
            else (self._inverse @ self.b, self._inverse @ self._deviator_input)
        )
        self._vectors = np.column_stack([self.b, self._deviator_input, *integral_vectors])

    def exponential(self, s):
        """Return e^{As}, an array with two more axes than s."""
        s = np.asarray(s, dtype=float)
        even, odd = self._with_growth(*self._even_odd(s), s)
        return even[..., None, None] * np.eye(2) + odd[..., None, None] * self._deviator

    def response(self, s):
        """Return (e^{As} b, its integral from 0 to s)."""
        s = np.asarray(s, dtype=float)[..., None]
        even, odd = self._with_growth(*self._even_odd(s), s)
        impulse = even * self.b + odd * self._deviator_input
        if self._inverse is not None:
            return impulse, (impulse - self.b) @ self._inverse.T
        return impulse, s * self.b + self._integral_factor(s) * (self.A @ self.b)

    def _integral_factor(self, s):
        """Return the factor of Ab in the integral of e^{As}b if A has no inverse; that of b is s."""
        if abs(self._trace) > 1e-12:
            return (np.expm1(self._trace * s) / self._trace - s) / self._trace
        return s**2 / 2

    def _with_growth(self, even, odd, s):
        if not self._trace:
            return even, odd
        growth = np.exp(self._trace / 2 * s)
        return growth * even, growth * odd

    def _even_odd(self, s):
        """Return e, o of time with e^{As} = e^{cs}(e I + o (A - cI)); 2c is the trace of A."""
        if self._square > 1e-14:
            return np.cosh(self._root * s), np.sinh(self._root * s) / self._root
        if self._square < -1e-14:
            return np.cos(self._root * s), np.sin(self._root * s) / self._root
        return np.ones_like(s), s

    def free(self, x, s):
        """Return the states x after times s without control, each row its own."""
        s = s[:, None]
        return self._free_motion(x, *self._with_growth(*self._even_odd(s), s))

    def _free_motion(self, x, even, odd):
        return even * x + odd * (x @ self._deviator.T)

    def move(self, x, u, s):
        """Return the states x after times s under constant controls u, each row its own."""
        s = s[:, None]
        even, odd = self._with_growth(*self._even_odd(s), s)
        free = self._free_motion(x, even, odd)
        if self._inverse is not None:
            return free + u[:, None] * (
                (even * self.b + odd * self._deviator_input - self.b) @ self._inverse.T
            )
        return free + u[:, None] * (s * self.b + self._integral_factor(s) * (self.A @ self.b))

    def extreme(self, p, T, sign, integral=None):
        """Return the integral over [0, T] of the least (sign -1) or largest (+1) p.e^{As}b u.

        p and T have rows; `integral` is that of e^{As}b, if already computed.
        """
        # Thousands of times some hundred rows come here, so each row is reduced to numbers: p.b, p.(A
        # - cE)b and the two of `_integral`.
        start, deviator_term, *integral_terms = (p @ self._vectors).T
        zeros = self._zeros(start, deviator_term, T)
        last = (
            self._integral(T, *integral_terms)
            if integral is None
            else integral[:, 0] * p[:, 0] + integral[:, 1] * p[:, 1]
        )
        if zeros.shape[1] == 1:
            inner = self._integral(zeros[:, 0], *integral_terms)
            absolute = abs(inner) + abs(last - inner)
        else:
            inner = self._integral(zeros, *(part[:, None] for part in integral_terms))
            absolute = (
                abs(inner[:, 0])
                + abs(last - inner[:, -1])
                + abs(inner[:, 1:] - inner[:, :-1]).sum(axis=1)
            )
        return self.mean * last + sign * self.half * absolute

    def _integral(self, s, first, second):
        """Return p.(integral of e^{Ar}b from 0 to s), from columns of p @ self._vectors."""
        if self._inverse is None:
            return s * first + self._integral_factor(s) * second
        even, odd = self._with_growth(*self._even_odd(s), s)
        return even * first + odd * second - first

    def farthest(self, p, T, sign):
        """Return the integral over [0, T] of e^{As}b u with the u that makes p.e^{As}b u extreme.

        That is least (sign -1) or largest (+1): the state farthest against p, or along it, that is reached
        from the origin in the time T; rows of p and T.
        """
        ends = np.column_stack([np.zeros_like(T), self.zeros(p, T), T])
        parts = np.diff(self.response(ends)[1], axis=1)
        u = self.mean + sign * self.half * np.sign(np.einsum("nci,ni->nc", parts, p))
        return (u[..., None] * parts).sum(axis=1)

    def zeros(self, p, T):
        """Return the zeros of p.e^{As}b between 0 and T in order; rows are filled up with T."""
        return self._zeros(p @ self.b, p @ self._deviator_input, T)

    def first_zero(self, p, T):
        """Return the first zero of p.e^{As}b after s = 0, or T, and its sign until then."""
        start, deviator_term = p @ self.b, p @ self._deviator_input
        start[abs(start) < 1e-12] = 0
        return self._zeros(start, deviator_term, np.full(len(p), T)).min(axis=1), np.sign(
            np.where(start, start, deviator_term)
        )

    def _zeros(self, start, deviator_term, T):
        with np.errstate(all="ignore"):
            if self._square < -1e-14:
                first = np.mod(np.arctan2(-self._root * start, deviator_term), np.pi) / self._root
                count = int(T.max(initial=0) * self._root / np.pi) + 1
                inner = first[:, None] + np.arange(count) * np.pi / self._root
            elif self._square > 1e-14:
                inner = np.arctanh(-self._root * start / deviator_term)[:, None] / self._root
            else:
                inner = (-start / deviator_term)[:, None]
        # Without a zero at positive times (nan or negative) the end stands in its point.
        return np.where(inner > 0, np.minimum(inner, T[:, None]), T[:, None])
