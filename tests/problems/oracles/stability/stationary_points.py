"""Oracles of planar portraits."""

from random import Random

import sympy as sp

from oracles.sameness import holds, same_condition, same_value, vanishes
from oracles.stability.equilibrium_angles import kind_of_angles


def first_integral(mutant, reference, field, state, *_):
    """True for every function of the state, not constant, whose derivative along the motions is
    identically zero."""
    rate = sum(sp.diff(mutant, x) * f for x, f in zip(state, field))
    return bool(mutant.free_symbols & set(state)) and vanishes(rate)


def planar_region(mutant, reference, field, state, parameters, domain=None):
    """As `same_condition`, for parameters inside their domain alone; small values are tried as well
    as large ones."""
    intervals = {
        p: (domain or {}).get(p, sp.Interval.open(0, sp.oo) if p.is_positive else sp.S.Reals)
        for p in parameters
    }

    def outside(point):
        return any(
            intervals[p].contains(sp.Rational(v.numerator, v.denominator)) == sp.false
            for p, v in point.items()
        )

    if not same_condition(mutant, reference, outside):
        return False
    symbols, random = sorted(intervals, key=str), Random(14)
    tests = [sp.lambdify(symbols, condition, modules="math") for condition in (mutant, reference)]
    points = (
        [
            10 ** random.uniform(-2, 1.5) * (1 if p.is_positive else random.choice((-1, 1)))
            for p in symbols
        ]
        for _ in range(4000)
    )
    ends = [(float(intervals[p].start), float(intervals[p].end)) for p in symbols]
    return all(
        holds(tests[0], point) == holds(tests[1], point)
        for point in points
        if all(low < x < high for x, (low, high) in zip(point, ends))
    )


def same_points(mutant, reference, field, state, parameters, domain=None, zeros=None):
    """The same value, whatever the order of several points."""
    several = isinstance(reference, (list, tuple)) and (
        len(state) == 1 or isinstance(reference[0], (list, tuple))
    )
    if several and isinstance(mutant, (list, tuple)) and len(mutant) != len(reference):
        return False  # a point is missing, or given twice
    return same_value(mutant, reference, "list of vector" if several else "")


def root_region(mutant, reference, field, state, parameters, domain=None):
    """As `planar_region`; without a domain the stationary angles of an equation are meant."""
    if domain is None:
        return kind_of_angles(mutant, reference, field, state, parameters)
    return planar_region(mutant, reference, field, state, parameters, domain)


ORACLES = {
    "stationary_points": same_points,
    "first_integral": first_integral,
    "focus_region": root_region,
    "node_region": root_region,
    "stationary_exists": planar_region,
}
