"""Sample points for the conditions of the maximum principle, and zero sets of expressions."""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.tolerance import DECIMALS, in_decimals, perturbed
from workbook.checks.references.optima.units import sample_units
from workbook.checks.references.singular_arcs import hamiltonian, known_costates
from workbook.checks.tools.domains import endpoints, random_value
from workbook.checks.tools.numeric_functions import LONG, real_function
from workbook.checks.tools.samples import cached_points
from workbook.checks.tools.substitution import real_at, substituted
from workbook.checks.tools.values import summed_changes

#: Number of points at which an identity is compared, and of other controls with which a greatest
#: value is compared.
SAMPLES, RIVALS = 8, 41
#: Accuracy of points of singular arcs and of a claimed surface.
POINT_ACCURACY = 1e-7
#: Distance from a switching at which a control is compared, relative to the distance of the sample.
NEXT_TO = 1e-4


class ZeroSet:
    """The set of common zeros of several expressions in `symbols`.

    Its points are computed in `units`, those of the symbols that have others than one.
    """

    def __init__(self, claims, symbols, parameters, units=None):
        self._units = np.array([float((units or {}).get(s, 1)) for s in symbols])
        if (self._units != 1).any():
            put = {s: units[s] * s for s in symbols if s in units}
            claims = [e.subs(put, simultaneous=True) for e in claims]
        self._symbols, self._parameters, self._count = symbols, parameters, len(claims)
        self._claims = claims
        self._values = real_function([*symbols, *parameters], claims)
        self._slopes = real_function(
            [*symbols, *parameters], [sp.diff(e, s) for e in claims for s in symbols]
        )
        variants = perturbed(*claims) if in_decimals(*claims) else []
        self._largest_uncertainty = POINT_ACCURACY if variants == [] else DECIMALS
        self._perturbed = [
            [real_function([*symbols, *parameters], side) for side in sides]
            for sides in variants or ()
        ]

    def uncertainty(self, values):
        """Return the `distance` that a point may have because of the decimals."""
        if not self._perturbed:
            return self._largest_uncertainty
        numbers = self._numbers(values)
        residuals, slopes = self._values(*numbers), self._slopes(*numbers).reshape(self._count, -1)
        changes = summed_changes(
            residuals, ((side(*numbers) for side in sides) for sides in self._perturbed)
        )
        steps = changes / np.maximum(np.linalg.norm(slopes, axis=1), 1e-300)
        return float(
            np.fmin(
                self._largest_uncertainty,
                POINT_ACCURACY + steps.max() / (1 + np.linalg.norm(numbers[: len(self._symbols)])),
            )
        )

    def distance(self, values):
        """Return the distance of a point from the zeros, relative to its size, to first order.

        It is infinite where an expression is undefined.
        """
        numbers = self._numbers(values)
        residuals, slopes = self._values(*numbers), self._slopes(*numbers).reshape(self._count, -1)
        if not (np.isfinite(residuals).all() and np.isfinite(slopes).all()):
            return np.inf
        steps = [
            0.0 if r == 0 else abs(r) / max(np.linalg.norm(row), 1e-300)
            for r, row in zip(residuals, slopes)
        ]
        return max(steps) / (1 + np.linalg.norm(numbers[: len(self._symbols)]))

    def precise_distance(self, values):
        """Return the same distance by numbers of many digits and any size.

        It is slow: for points where large terms of an expression cancel, or where floats overflow.
        """
        numbers = self._numbers(values)
        point = {s: sp.Float(x, LONG) for s, x in zip((*self._symbols, *self._parameters), numbers)}
        steps = []
        for claim in self._claims:
            residual, *row = (
                e.xreplace(point).evalf(LONG) for e in (claim, *map(claim.diff, self._symbols))
            )
            length = sp.sqrt(sum(slope**2 for slope in row))
            steps.append(sp.S.Zero if residual == 0 else abs(residual) / length)
        distances = [real_at(step, {}) for step in steps]
        return (
            np.inf
            if None in distances
            else max(distances) / (1 + np.linalg.norm(numbers[: len(self._symbols)]))
        )

    def _numbers(self, values):
        return [
            *(float(values[s]) / unit for s, unit in zip(self._symbols, self._units)),
            *(float(values[s]) for s in self._parameters),
        ]

    def zero_near(self, values):
        """Return a zero close to a point, as a dict, or None."""
        numbers = self._numbers(values)
        point, parameter_values = np.split(np.array(numbers), [len(self._symbols)])
        for _ in range(80):  # at double zeros each step halves the distance
            residuals = self._values(*point, *parameter_values)
            slopes = self._slopes(*point, *parameter_values).reshape(self._count, -1)
            if not (np.isfinite(residuals).all() and np.isfinite(slopes).all()):
                return None
            step = np.linalg.lstsq(slopes, residuals, rcond=1e-12)[0]
            point = point - step
            if np.linalg.norm(step) <= 1e-12 * (1 + np.linalg.norm(point)):
                zero = values | dict(zip(self._symbols, self._units * point))
                return zero if self.distance(zero) < 1e-9 else None
        return None


def shares_of(symbols, generator):
    """Return random shares of the range of each symbol: its values lie all over its range."""
    return {
        s: (generator.permutation(SAMPLES) + generator.uniform(size=SAMPLES)) / SAMPLES
        for s in symbols
    }


@cached_points
def sample_points(problem, costates, domain, controls=True, use_known_costates=False):
    """Yield random values of all symbols, first with the controls on their bounds.

    With `use_known_costates` those that transversality determines have their values.
    """
    generator = np.random.default_rng(11)
    values = known_costates(problem, costates) if use_known_costates else {}
    symbols = [
        *problem.state,
        *costates,
        *problem.parameters,
        *(problem.control if controls else ()),
    ]
    units = sample_units(problem, costates, domain)
    shares = shares_of(symbols, generator)
    for k in range(SAMPLES):
        position = {
            s: random_value(generator, s, domain, shares[s][k], float(units.get(s, 1)))
            for s in symbols
        }
        if controls and k < 2:
            position |= {
                u: pair[k]
                for u, pair in zip(problem.control, control_bounds(problem, position))
                if np.isfinite(pair[k])
            }
        yield position | {psi: float(value.subs(position)) for psi, value in values.items()}


@cached_points
def points_near_switching(problem, costates, domain):
    """Yield points close to those where H does not depend on a control.

    There a smooth approximation of a jump differs from the jump.
    """
    symbols = [*costates, *problem.state]
    for slope in (sp.diff(hamiltonian(problem, costates), u) for u in problem.control):
        if slope.free_symbols & set(problem.control):
            continue
        units = sample_units(problem, costates, domain)
        zeros = ZeroSet([slope], symbols, list(problem.parameters), units)
        for values in itertools.islice(sample_points(problem, costates, domain, controls=False), 2):
            position = zeros.zero_near(values)
            if position is not None and is_in_domain(position, domain):
                yield {s: v + NEXT_TO * (values[s] - v) for s, v in position.items()}


def is_in_domain(values, domain):
    """Return whether values lie in the intervals of their symbols."""
    return all(low < values[s] < high for s in values for low, high in [endpoints(s, domain)])


def as_difference(part, symbols):
    if isinstance(part, sp.Or):  # where one of several vanishes their product does
        return sp.prod([as_difference(factor, symbols) for factor in part.args])
    if isinstance(part, sp.Eq):
        return coercion.as_expression(part.lhs, symbols) - coercion.as_expression(part.rhs, symbols)
    return coercion.as_expression(part, symbols)


def control_bounds(problem, values):
    return [
        tuple(
            float(substituted(b, values)) if b.is_finite is not False else np.inf * (1 if k else -1)
            for k, b in enumerate(pair)
        )
        for pair in problem.controls.values()
    ]
