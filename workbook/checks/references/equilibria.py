"""Equilibria of fields that contain parameters, for many sets of values at once.

They are found from the field alone, for sample values of the parameters, by Newton's method
from many starts at once. An interval of length 2 pi makes a state variable an angle, for which
values modulo 2 pi are the same.
"""

import functools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract.tolerance import agree, half_unit, in_decimals
from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.tools.domains import (
    endpoints,
    interval_of,
    lies_inside,
    random_value,
    simple_rational,
)
from workbook.checks.tools.samples import cases, conjunction, in_every_case
from workbook.checks.tools.wording import sample_text

#: How many starts and steps Newton's method gets.
STARTS, STEPS = 240, 40
#: How often a damped step is halved.
HALVINGS = 30
#: Real parts of eigenvalues closer to zero than this decide nothing.
CRITICAL = 1e-8
#: With fewer sample values of the parameters that satisfy what is given, more are tried.
LEAST_CANDIDATES = 7
#: For how many sets of parameter values a field's equilibria are kept: a verdict asks for some
#: thirty, mostly the same.
MOST_KEPT = 200
#: Closer to an open end of the domain than this, an equilibrium counts as lying on the end.
END = 1e-7


def equilibria_of(field, state, parameters=(), domain=None, given=()):
    """Return the `Equilibria` of the data, the same for the same data."""
    return _cached_equilibria(
        tuple(map(sp.sympify, field)),
        tuple(state),
        tuple(parameters),
        tuple(dict(domain or {}).items()),
        conjunction(given),
    )


@functools.lru_cache(maxsize=16)
def _cached_equilibria(field, state, parameters, domain, given):
    return Equilibria(field, state, parameters, dict(domain), given)


class Equilibria:
    """A field with parameters: its values, linearisation and equilibria in a domain.

    Parameters
    ----------
    field : list of sympy.Expr
        The right-hand sides.
    state, parameters : list of sympy.Symbol
        The symbols in them.
    domain : dict
        Intervals of these symbols.
    given : sympy condition
        What the parameters satisfy besides.
    """

    def __init__(self, field, state, parameters, domain, given=sp.true):
        self.state, self.parameters, self.domain = list(state), list(parameters), domain
        self.given = given
        expressions = [sp.sympify(component) for component in field]
        foreign = set().union(*(e.free_symbols for e in expressions)) - {
            *self.state,
            *self.parameters,
        }
        if foreign:
            raise UnsuitableData(f"the field still contains {foreign}")
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
            [[self._start(random, x, k) for x in self.state] for k in range(STARTS)]
        ).T
        self._newton_results = {}

    def _compiled(self, expressions):
        slopes = (
            [sp.diff(component, x) for component in expressions for x in self.state]
            if self._square
            else []
        )
        return sp.lambdify([*self.state, *self.parameters], expressions + slopes, "numpy", cse=True)

    def _start(self, random, x, k):
        """Return a random start of a state variable: at several scales, if it has no bounds."""
        if interval_of(x, self.domain) == sp.S.Reals:
            return random.normal(scale=(0.5, 2, 8)[k % 3])
        return random_value(random, x, self.domain)

    def __call__(self, point, numbers):
        """Return the field at points (state first) for parameter values that broadcast with them."""
        values = _evaluated(self._function, point, numbers)
        return values[: len(self.state)] if self._square else values

    def jacobian(self, point, numbers):
        """Return the partial derivatives, axes (component, variable, ...)."""
        values = _evaluated(self._function, point, numbers)[len(self.state) :]
        return values.reshape(len(self.state), len(self.state), *values.shape[1:])

    def newton(self, numbers):
        """Return results of Newton's method from all starts for every column of parameters.

        They are points (n, columns, starts) and which of them are equilibria in the domain.
        """
        key = numbers.tobytes(), numbers.shape
        if key not in self._newton_results:
            if len(self._newton_results) == MOST_KEPT:
                self._newton_results.clear()
            results = [self._newton_from(self._starts, numbers)]
            if not self.parameters:
                # Whole steps lead out of where a field such as log(a - x^2) is defined.
                results.append(self._newton_from(self._starts, numbers, damped=True))
            self._newton_results[key] = tuple(np.concatenate(p, axis=-1) for p in zip(*results))
        return self._newton_results[key]

    def _newton_from(self, starts, numbers, damped=False):
        """Return the results from some starts; `damped` steps do not increase the field."""
        x = np.repeat(starts[:, None, :], numbers.shape[1], axis=1)
        fixed = numbers[:, :, None]
        for _ in range(STEPS):
            values = _evaluated(self._numerators, x, fixed)
            move = _newton_step(values)
            move = np.where(np.isfinite(move), move, 0)
            for _ in range(HALVINGS if damped else 0):
                there = _evaluated(self._numerators, x + move, fixed)
                larger = ~(self._size(there) <= self._size(values) * (1 + 1e-9))
                if not larger.any():
                    break
                move = np.where(larger, move / 2, move)
            trial = x + move
            for k, (low, high) in enumerate(self._intervals):
                if self._angles[k]:
                    trial[k] = x[k] + np.clip(trial[k] - x[k], -1, 1)
                    continue
                if low > -math.inf:
                    trial[k] = np.maximum(trial[k], low + (x[k] - low) / 4)
                if high < math.inf:
                    trial[k] = np.minimum(trial[k], high - (high - x[k]) / 4)
            x = trial
        moves = _newton_step(_evaluated(self._function, x, fixed))
        x, converged = self.reduced(x), np.all(abs(moves) < 1e-9 * (1 + abs(x)), axis=0)
        return x, converged & self.inside(x)

    def _size(self, values):
        return np.linalg.norm(values[: len(self.state)], axis=0)

    def points(self, numbers):
        """Return the list of equilibria in the domain for every column of parameter values."""
        x, is_point = self.newton(numbers)
        return [_distinct_columns(x[:, j, is_point[j]]) for j in range(x.shape[1])]

    def exist(self, numbers):
        """Return whether there is an equilibrium in the domain for one column of parameters."""
        return bool(self.newton(numbers)[1].any())

    def refined(self, position, numbers):
        """Return the equilibrium that Newton's method reaches from a point, or None."""
        x, is_point = self._newton_from(position[:, None], numbers[:, None])
        return x[:, 0, 0] if is_point.item() else None

    def growth(self, point, numbers):
        """Return the largest real part of an eigenvalue of the linearisation at an equilibrium."""
        growth = max(np.linalg.eigvals(self.jacobian(point, numbers)).real)
        if abs(growth) < CRITICAL:
            raise RuntimeError("the linearisation does not decide here")
        return growth

    def of_kind(self, kind, points, numbers):
        """Return the points where the linearisation proves a stability; None stands for all."""
        if kind is None:
            return points
        sign = {"asymptotically stable": -1, "unstable": 1}[kind]
        return [
            point
            for point in points
            if sign * max(np.linalg.eigvals(self.jacobian(point, numbers)).real) > CRITICAL
        ]

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
        """Return whether a claimed point is this equilibrium.

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
        """Yield triples (exact values, their floats, the equilibrium).

        Parameters
        ----------
        claim : object
            The answer; samples are added for cases of it that the others do not cover.
        count : int
            The number of samples.
        with_points : bool
            Whether equilibria are computed.
        alone : bool
            Whether there has to be one; otherwise the third is the list of all points of the domain, and
            values without a point are taken, too.
        """
        candidates, numbers = self._candidates
        found = self._points_of_candidates if with_points else [[None]] * len(candidates)
        chosen = [k for k, points in enumerate(found) if points]
        if not chosen and (alone or self.parameters):
            raise RuntimeError(
                "no sample values of the parameters have an equilibrium in the domain"
            )
        # Samples with the most points first: these are the ones where a point can be missed.
        order = sorted(chosen, key=lambda k: -len(found[k]))[:count]
        if not alone:
            order += [*chosen[:count], *[k for k, points in enumerate(found) if not points][:count]]
            order = list(dict.fromkeys(order))
        samples = [(candidates[k], numbers[:, k], found[k]) for k in order]
        sampled = [values for values, *_ in samples]
        further = (
            in_every_case(sampled, claim, self.domain_condition)[len(sampled) :]
            if cases(claim)
            else ()
        )
        for values in further:
            column = self.numbers(values)
            if column is not None:
                points = self.points(column)[0] if with_points else [None]
                if points or not alone:
                    samples.append((values, column[:, 0], points))
        for values, column, points in samples:
            if alone and len(points) > 1:
                raise RuntimeError(
                    f"{sample_text(values)}there are {len(points)} equilibria in the domain"
                )
            yield values, column, points[0] if alone else points

    @functools.cached_property
    def _candidates(self):
        """Candidate values of the parameters: dicts of rationals, and floats in columns."""
        for count in (30, 480) if self.parameters else (1,):
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
                {
                    p: sp.Rational(
                        *simple_rational(
                            random_value(None, p, self.domain, share), p, self.domain
                        ).as_integer_ratio()
                    )
                    for p, share in zip(self.parameters, row)
                }
                for row in shares
            ]
            candidates = [values for values in candidates if self._is_given(values)]
            if len(candidates) >= LEAST_CANDIDATES:
                break
        numbers = np.array([[float(values[p]) for values in candidates] for p in self.parameters])
        return candidates, numbers.reshape(len(self.parameters), len(candidates))

    @functools.cached_property
    def _points_of_candidates(self):
        return self.points(self._candidates[1])

    @functools.cached_property
    def domain_condition(self):
        """The condition of the domain, and what is given, on the parameters."""
        return sp.And(
            self.given,
            *(_interval_condition(p, interval_of(p, self.domain)) for p in self.parameters),
        )

    @functools.cached_property
    def _at_rest(self):
        """Values of state variables that are themselves right-hand sides, as rates are: zero."""
        return dict.fromkeys({f for f in self.field if f in self.state} - self.domain.keys(), 0)

    @property
    def unknowns(self):
        """The other state variables."""
        return tuple(x for x in self.state if x not in self._at_rest)

    @functools.cached_property
    def at_rest(self):
        """The condition on `unknowns` that they lie in the domain and the right-hand sides vanish."""
        return sp.And(
            *(_interval_condition(x, interval_of(x, self.domain)) for x in self.unknowns),
            *(sp.Eq(component.subs(self._at_rest), 0) for component in self.field),
        )

    @functools.cached_property
    def invariants(self):
        """Trace, determinant and discriminant of the linearisation in the plane, as expressions."""
        matrix = sp.Matrix(self.field).jacobian(self.state).subs(self._at_rest)
        trace, determinant = sp.expand(matrix.trace()), sp.expand(matrix.det())
        return trace, determinant, sp.expand(trace**2 - 4 * determinant)

    def numbers(self, values):
        """Return values of the parameters as one column of floats, or None outside the domain."""
        if not self._is_given(values) or not all(
            lies_inside(float(values[p]), p, self.domain) for p in self.parameters
        ):
            return None
        return np.array([[float(values[p])] for p in self.parameters])

    def _is_given(self, values):
        return self.given.subs(values) is sp.true


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


def _newton_step(values):
    """Return the Newton step -J^-1 f from f and its derivatives, in the first axis."""
    n = math.isqrt(len(values))  # of n (n + 1) values
    with np.errstate(all="ignore"):
        if n == 1:
            return -values[:1] / values[1:]
        if n == 2:
            f, g, a, b, c, d = values
            return -np.stack([d * f - b * g, a * g - c * f]) / (a * d - b * c)
        rates, slopes = values[:n], values[n:].reshape(n, n, *values.shape[1:])
        matrices = np.moveaxis(slopes, (0, 1), (-2, -1))
        regular = np.isfinite(matrices).all(axis=(-2, -1)) & (np.linalg.det(matrices) != 0)
        matrices = np.where(regular[..., None, None], matrices, np.nan)
        return -np.moveaxis(
            np.linalg.solve(matrices, np.moveaxis(rates, 0, -1)[..., None])[..., 0], -1, 0
        )
