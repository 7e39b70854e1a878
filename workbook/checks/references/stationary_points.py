"""Stationary points of fields that contain parameters, for many sets of values at once.

The reference is found from the field alone, for sample values of the parameters, by Newton's method
from many starts at once. An interval of length 2 pi makes a state variable an angle, for which
values modulo 2 pi are the same.
"""

import functools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract.tolerance import agree, half_unit, in_decimals
from workbook.checks.tools.domains import (
    endpoints,
    interval_of,
    lies_inside,
    random_value,
    simple_rational,
)
from workbook.checks.tools.samples import cases, in_every_case
from workbook.checks.tools.wording import sample_text

#: How many starts Newton's method gets.
STARTS = 48
#: For how many sets of parameter values a field's stationary points are kept: a verdict asks for
#: some thirty, mostly the same.
MOST_KEPT = 200
#: Closer to an open end of the domain than this, an equilibrium counts as lying on the end.
END = 1e-7


def stationary_points_of(field, state, parameters, domain):
    """Return the `StationaryPoints` of the data, the same for the same data."""
    return _cached_points(
        tuple(map(sp.sympify, field)),
        tuple(state),
        tuple(parameters),
        tuple(dict(domain or {}).items()),
    )


@functools.lru_cache(maxsize=16)
def _cached_points(field, state, parameters, domain):
    return StationaryPoints(field, state, parameters, dict(domain))


class StationaryPoints:
    """A field with parameters: its values, linearisation and stationary points."""

    def __init__(self, field, state, parameters, domain):
        self.state, self.parameters, self.domain = list(state), list(parameters), dict(domain or {})
        expressions = [sp.sympify(component) for component in field]
        foreign = set().union(*(e.free_symbols for e in expressions)) - {
            *self.state,
            *self.parameters,
        }
        if foreign:
            raise ValueError(f"the field still contains {foreign}")
        self.field = expressions
        self._square = len(expressions) == len(self.state)
        self._function = self._compiled(expressions)
        # The numerators have the same zeros inside the domain, and Newton's method converges
        # better on them.
        self._numerators = self._compiled(
            [sp.numer(sp.together(component)) for component in expressions]
        )
        self._angles = [
            x in self.domain and self.domain[x].measure == 2 * sp.pi for x in self.state
        ]
        self._intervals = [endpoints(x, self.domain) for x in self.state]
        random = np.random.default_rng(14)
        self._starts = np.array(
            [[random_value(random, x, self.domain) for x in self.state] for _ in range(STARTS)]
        ).T
        self._newton_results = {}

    def _compiled(self, expressions):
        slopes = (
            [sp.diff(component, x) for component in expressions for x in self.state]
            if self._square
            else []
        )
        return sp.lambdify([*self.state, *self.parameters], expressions + slopes, "numpy", cse=True)

    def __call__(self, point, numbers):
        """Return the field at points (state first) for parameter values that broadcast with them."""
        values = _evaluated(self._function, point, numbers)
        return values[: len(self.state)] if self._square else values

    def jacobian(self, point, numbers):
        """Return the partial derivatives, axes (component, variable, ...)."""
        values = _evaluated(self._function, point, numbers)[len(self.state) :]
        return values.reshape(len(self.state), len(self.state), *values.shape[1:])

    def newton(self, numbers, starts, steps):
        """Return results of Newton's method from many starts for every column of parameters.

        They are points (n, columns, starts) and which of them are stationary points in the domain.
        """
        key = (numbers.tobytes(), numbers.shape, starts, steps)
        if key not in self._newton_results:
            if len(self._newton_results) == MOST_KEPT:
                self._newton_results.clear()
            self._newton_results[key] = self._newton_from_starts(numbers, starts, steps)
        return self._newton_results[key]

    def _newton_from_starts(self, numbers, starts, steps):
        x = np.repeat(self._starts[:, None, :starts], numbers.shape[1], axis=1)
        fixed = numbers[:, :, None]
        for _ in range(steps):
            move = _newton(_evaluated(self._numerators, x, fixed))
            trial = x + np.where(np.isfinite(move), move, 0)
            for k, (low, high) in enumerate(self._intervals):
                if self._angles[k]:
                    trial[k] = x[k] + np.clip(trial[k] - x[k], -1, 1)
                else:
                    trial[k] = (
                        np.maximum(trial[k], low + (x[k] - low) / 4)
                        if low > -math.inf
                        else trial[k]
                    )
                    trial[k] = (
                        np.minimum(trial[k], high - (high - x[k]) / 4)
                        if high < math.inf
                        else trial[k]
                    )
            x = trial
        converged = np.all(
            abs(_newton(_evaluated(self._function, x, fixed))) < 1e-9 * (1 + abs(x)), axis=0
        )
        x = self.reduced(x)
        return x, converged & self.inside(x)

    def points(self, numbers):
        """Return the list of stationary points in the domain for every column of parameter values."""
        x, is_point = self.newton(numbers, starts=STARTS, steps=40)
        return [_distinct_columns(x[:, j, is_point[j]]) for j in range(x.shape[1])]

    def single_points(self, numbers):
        """Return the stationary point for every column of parameters, and whether it exists."""
        x, is_point = self.newton(numbers, starts=32, steps=40)
        first = np.take_along_axis(x, np.argmax(is_point, axis=1)[None, :, None], axis=2)
        if np.any(is_point & (abs(x - first) > 1e-5 * (1 + abs(first))).any(axis=0)):
            raise RuntimeError("there are several stationary points in the domain")
        return first[:, :, 0], is_point.any(axis=1)

    def reduced(self, points):
        """Return points with their angles in their intervals."""
        points = np.array(points, dtype=float)
        for k, (low, high) in enumerate(self._intervals):
            if self._angles[k]:
                # Rounding must not throw an angle from the closed end of its interval to the open
                # one.
                margin = END if self.domain[self.state[k]].left_open else -END
                points[k] = low + margin + (points[k] - low - margin) % (high - low)
        return points

    def inside(self, points):
        """Return which points lie in the domain, with their angles as they are."""
        result = np.ones(np.shape(points)[1:], dtype=bool)
        for k, (low, high) in enumerate(self._intervals):
            interval = interval_of(self.state[k], self.domain)
            result &= points[k] > low + (END if interval.left_open else -END)
            result &= points[k] < high - (END if interval.right_open else -END)
        return result

    def rounded_inside(self, position, written):
        """Move a position that decimals put just outside the domain back onto its border."""
        for k, (symbol, coordinate) in enumerate(zip(self.state, written)):
            low, high = endpoints(symbol, self.domain)
            for end in (
                (low, high) if in_decimals(coordinate) and not low <= position[k] <= high else ()
            ):
                if math.isfinite(end) and abs(position[k] - end) <= half_unit(end):
                    position[k] = end
        return position

    def is_same_point(self, point, reference, written, uncertain=None):
        """Return whether a claimed point is this stationary point.

        To three significant digits if it is written in decimals, which may change the coordinates by
        `uncertain`.
        """
        difference = point - reference
        size = max(np.abs(reference).max(), 1e-12)
        uncertain = [None] * len(reference) if uncertain is None else uncertain
        return all(
            agree(r + d, r, expression, size, uncertain=uncertainty_of_entry)
            for d, r, expression, uncertainty_of_entry in zip(
                difference, reference, written, uncertain
            )
        )

    def samples(self, claim=(), count=7, with_points=True, alone=True):
        """Yield triples (exact values, their floats, the stationary point).

        Parameters
        ----------
        claim : object
            The answer; samples are added for cases of it that the others do not cover.
        count : int
            The number of samples.
        with_points : bool
            Whether stationary points are computed.
        alone : bool
            Whether there has to be one; otherwise the third is the list of all points of the domain, and
            values without a point are taken, too.
        """
        candidates, numbers = self._candidates
        points_of_candidates = (
            self._points_of_candidates if with_points else [[None]] * len(candidates)
        )
        chosen = [k for k, stationary in enumerate(points_of_candidates) if stationary]
        if not chosen:
            raise RuntimeError(
                "no sample values of the parameters have a stationary point in the domain"
            )
        # Samples with the most points first: these are the ones where a point can be missed.
        richest = sorted(chosen, key=lambda k: -len(points_of_candidates[k]))[:count]
        without_points = [k for k, stationary in enumerate(points_of_candidates) if not stationary]
        samples = [
            (
                {
                    p: sp.Rational(x.numerator, x.denominator)
                    for p, x in zip(self.parameters, candidates[k])
                },
                numbers[:, k],
                points_of_candidates[k],
            )
            for k in (richest if alone else [*richest, *chosen[:count], *without_points[:count]])
        ]
        sampled_values = [values for values, *_ in samples]
        for values in (
            in_every_case(sampled_values, claim, self.domain_condition)[len(sampled_values) :]
            if cases(claim)
            else ()
        ):
            column = self.numbers(values)
            stationary = [] if column is None else self.points(column)[0] if with_points else [None]
            if column is not None and (stationary or not alone):
                samples.append((values, column[:, 0], stationary))
        for values, column, stationary in samples:
            if alone and len(stationary) > 1:
                raise RuntimeError(
                    f"{sample_text(values)}there are {len(stationary)} stationary points in the domain"
                )
            yield values, column, stationary[0] if alone else stationary

    @functools.cached_property
    def _candidates(self):
        """Candidate values of the parameters: rationals in rows, floats in columns."""
        count = 30 if self.parameters else 1
        # Multiples of irrational numbers are spread evenly, every few of them that follow one
        # another.
        shares = (
            np.outer(
                np.arange(1, count + 1),
                np.sqrt([2, 3, 5, 7, 11, 13, 17, 19])[: len(self.parameters)],
            )
            % 1
        )
        candidates = [
            [
                simple_rational(random_value(None, p, self.domain, share), p, self.domain)
                for p, share in zip(self.parameters, row)
            ]
            for row in shares
        ]
        return candidates, np.array(candidates, dtype=float).T.reshape(
            len(self.parameters), len(candidates)
        )

    @functools.cached_property
    def _points_of_candidates(self):
        return self.points(self._candidates[1])

    @functools.cached_property
    def domain_condition(self):
        """The condition of the domain on the parameters."""
        return sp.And(
            *(_interval_condition(p, interval_of(p, self.domain)) for p in self.parameters)
        )

    @functools.cached_property
    def at_rest(self):
        """The condition that a state lies in the domain and the right-hand sides vanish there."""
        return sp.And(
            *(_interval_condition(x, interval_of(x, self.domain)) for x in self.state),
            *(sp.Eq(component, 0) for component in self.field),
        )

    @functools.cached_property
    def invariants(self):
        """Trace, determinant and discriminant of the linearisation in the plane, as expressions."""
        matrix = sp.Matrix(self.field).jacobian(self.state)
        trace, determinant = sp.expand(matrix.trace()), sp.expand(matrix.det())
        return trace, determinant, sp.expand(trace**2 - 4 * determinant)

    def numbers(self, values):
        """Return values of the parameters as one column of floats, or None outside the domain."""
        if not all(lies_inside(float(x), p, self.domain) for p, x in values.items()):
            return None
        return np.array([[float(values[p])] for p in self.parameters])


def _interval_condition(symbol, interval):
    """Return the condition that a symbol lies in an interval; of an angle, by sine or cosine."""
    turns = {
        sp.Interval.Lopen(-sp.pi, sp.pi): sp.true,
        sp.Interval.open(0, sp.pi): sp.sin(symbol) > 0,
        sp.Interval.open(-sp.pi, 0): sp.sin(symbol) < 0,
        sp.Interval.open(-sp.pi / 2, sp.pi / 2): sp.cos(symbol) > 0,
    }
    return turns[interval] if interval in turns else interval.as_relational(symbol)


def _distinct_columns(points):
    """Return the columns of an array without those close to an earlier one: a list."""
    different = []
    while points.shape[1]:
        first = points[:, 0]
        different.append(first)
        points = points[
            :,
            ~(np.linalg.norm(points - first[:, None], axis=0) < 1e-6 * (1 + np.linalg.norm(first))),
        ]
    return different


def _evaluated(function, point, numbers):
    """Return values of compiled expressions at points and parameter values that broadcast."""
    with np.errstate(all="ignore"):
        values = function(*point, *numbers)
    result = np.empty(
        (len(values), *np.broadcast_shapes(*(np.shape(x) for x in (*point, *numbers))))
    )
    for k, value in enumerate(values):
        result[k] = value
    return result


def _newton(values):
    """Return the Newton step -J^-1 f from f and its derivatives, for one or two equations."""
    with np.errstate(all="ignore"):
        if len(values) == 2:
            return -values[:1] / values[1:]
        f, g, a, b, c, d = values
        return -np.stack([d * f - b * g, a * g - c * f]) / (a * d - b * c)
