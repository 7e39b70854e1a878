"""Stationary angles of phi'' = f(phi, phi'), f of period 2 pi in phi, for values of the parameters.

All of them are found at once from the signs of f(phi, 0) on a grid; also where they cease to exist,
and where two of them meet. Equilibria of other fields are found by Newton's method: in `fields` for
a field with numbers, in `stationary_points` for one with parameters, for many values at once.
"""

import functools
import itertools
from fractions import Fraction

import numpy as np
import sympy as sp

from workbook.checks.tools.samples import in_every_case, sample_values

#: For how many sets of parameter values the stationary angles are kept: a verdict asks for a
#: thousand, mostly the same.
MOST_KEPT = 5000


@functools.lru_cache(maxsize=16)
def stationary_angles(field, state, parameters):
    """Return the `StationaryAngles` of the data, the same for the same data."""
    return StationaryAngles(field, state, parameters)


class StationaryAngles:
    """Stationary solutions of phi'' = f(phi, phi'), f of period 2 pi in phi."""

    GRID = np.linspace(0.0123, 0.0123 + 2 * np.pi, 361)

    def __init__(self, field, state, parameters):
        phi, rate = state
        if sp.simplify(field[0] - rate) != 0:
            raise RuntimeError("this is no equation of second order")
        self.parameters = list(parameters)
        force = sp.sympify(field[1])
        names = [phi, *self.parameters]
        at_rest = {rate: 0}
        self._force = sp.lambdify(names, force.subs(at_rest), "numpy")
        self._slope = sp.lambdify(names, sp.diff(force, phi).subs(at_rest), "numpy")
        self._curvature = sp.lambdify(names, sp.diff(force, phi, 2).subs(at_rest), "numpy")
        self._friction = sp.lambdify(names, sp.diff(force, rate).subs(at_rest), "numpy")
        self._slopes_at = {}

    def _numbers(self, values):
        return [float(values[p]) for p in self.parameters]

    def angles(self, values):
        """Return the simple stationary angles between 0 and 2 pi."""
        return self._zeros(self._force, self._slope, self._numbers(values))

    def force(self, values, phi):
        """Return f(phi, 0)."""
        return float(self._force(phi, *self._numbers(values)))

    def extremes(self, values):
        """Return the smallest and the largest value of f(phi, 0)."""
        numbers = self._numbers(values)
        turning = self._zeros(self._slope, self._curvature, numbers)
        heights = [float(self._force(phi, *numbers)) for phi in [*turning, 0.0]]
        return min(heights), max(heights)

    def exist(self, values):
        """Return whether there are stationary angles, up to rounding."""
        low, high = self.extremes(values)
        rounding = 1e-12 * (abs(low) + abs(high))
        return low <= rounding and high >= -rounding

    def slopes(self, values):
        """Return the `derivatives` at all stationary angles."""
        key = tuple(values[p] for p in self.parameters)
        if key not in self._slopes_at:
            if len(self._slopes_at) == MOST_KEPT:
                self._slopes_at.clear()
            self._slopes_at[key] = [self.derivatives(values, phi) for phi in self.angles(values)]
        return self._slopes_at[key]

    def derivatives(self, values, phi):
        """Return the derivatives of f at a stationary angle with respect to phi and phi'."""
        numbers = self._numbers(values)
        return float(self._slope(phi, *numbers)), float(self._friction(phi, *numbers))

    @functools.cached_property
    def samples(self):
        """Five sets of values of the parameters for which there are stationary angles."""
        samples = list(
            itertools.islice(
                (
                    values
                    for values in sample_values(self.parameters, 300)
                    if len(self.angles(values))
                ),
                5,
            )
        )
        if not samples:
            raise RuntimeError("no parameters with stationary angles were met")
        return samples

    def samples_for(self, claims):
        """Return the samples, and more for cases of an answer that these do not cover."""
        return [
            values for values in in_every_case(self.samples, claims) if len(self.angles(values))
        ]

    @functools.cached_property
    def edges(self):
        """The `border` from the first two samples."""
        return [pair for values in self.samples[:2] for pair in self.border(values)]

    def border(self, values):
        """Yield pairs (values close to the border of existence, values on it or None).

        They are found along each parameter from `values`.
        """
        for p in self.parameters:
            inside, outside = values[p], 64 * values[p]
            if self.exist(values | {p: outside}):
                continue
            for _ in range(60):
                middle = (inside + outside) / 2
                inside, outside = (
                    (middle, outside) if self.exist(values | {p: middle}) else (inside, middle)
                )
            edge = sp.Rational(*Fraction(float(inside)).limit_denominator(2000).as_integer_ratio())
            exact = (
                values | {p: edge}
                if abs(edge - inside) < 1e-9 and self.exist(values | {p: edge})
                else None
            )
            yield (
                values
                | {p: sp.Rational(*float(inside * (1 - sp.Rational(1, 10**3))).as_integer_ratio())},
                exact,
            )

    def double(self, values):
        """Return the angles where f and its slope vanish together."""
        numbers = self._numbers(values)
        size = max(map(abs, self.extremes(values)))
        return [
            phi
            for phi in self._zeros(self._slope, self._curvature, numbers)
            if abs(self._force(phi, *numbers)) < 1e-9 * size
        ]

    def _zeros(self, function, derivative, numbers):
        values = function(self.GRID, *numbers) + 0 * self.GRID
        k = np.flatnonzero(values[:-1] * values[1:] < 0)
        if not len(k):
            return np.array([])
        left, right = self.GRID[k], self.GRID[k + 1]
        phi = left - values[k] * (right - left) / (values[k + 1] - values[k])
        for _ in range(6):
            step = function(phi, *numbers) / derivative(phi, *numbers)
            phi = np.clip(phi - step, left, right)
        return np.mod(phi, 2 * np.pi)
