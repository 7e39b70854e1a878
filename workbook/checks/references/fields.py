"""Vector fields of the data, made numeric: values, derivatives, motions.

Only fields of data cells come here, never an answer: they are compiled by `lambdify`.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData

#: Step of the complex-step derivative: no subtraction, so the result is exact to rounding (Squire
#: and Trapp, 1998).
STEP = 1e-30


@functools.lru_cache(maxsize=16)
def cached_field(field, state):
    """Return the `Field` of data given as tuples, the same for the same data."""
    return Field(field, state)


class Field:
    """The field `f(state)`, with values for its parameters."""

    def __init__(self, field, state, values=None):
        self.state = list(state)
        self.expressions = [sp.sympify(component).subs(values or {}) for component in field]
        foreign = set().union(*(e.free_symbols for e in self.expressions)) - set(self.state)
        if foreign:
            raise UnsuitableData(f"the field still contains {foreign}")
        self._function = sp.lambdify(self.state, self.expressions, "numpy")

    def __call__(self, point):
        """Return f at a point; nan where it is not defined."""
        with np.errstate(all="ignore"):
            return np.array(
                [
                    complex(value) if np.iscomplexobj(point) else value
                    for value in self._function(*point)
                ]
            )

    def velocity(self, _, point):
        """Return f at a real point and any time, for an integration, in Python's own fast numbers."""
        try:
            values = np.array(self._function(*point.tolist()))
        except (ZeroDivisionError, OverflowError):  # where NumPy's are infinite
            return self(point)
        return self(point) if np.iscomplexobj(values) else values  # and where they are nan

    def jacobian(self, point):
        """Return the matrix of partial derivatives at a point, by complex steps."""
        return np.array([self.derivative(point, axis) for axis in np.eye(len(self.state))]).T

    def derivative(self, point, direction):
        """Return the derivative of f at a point along a direction."""
        return (
            self(np.asarray(point, dtype=complex) + 1j * STEP * np.asarray(direction)).imag / STEP
        )

    def motion(self, start, duration, escape=1e3):
        """Return the state after `duration`, or None if the motion leaves a ball before."""
        path = self.path(start, duration, escape)
        return None if path.t[-1] < duration else path.y[:, -1]

    def path(self, start, duration, escape, times=None):
        """Return SciPy's solution, at its own times or those given, which ends outside a ball."""
        from scipy.integrate import solve_ivp

        def boundary(_, x):
            return escape - np.linalg.norm(x)

        boundary.terminal = True
        with np.errstate(all="ignore"):
            return solve_ivp(
                self.velocity,
                (0, duration),
                start,
                method="DOP853",
                rtol=1e-9,
                atol=1e-12,
                t_eval=times,
                events=boundary,
            )
