"""Oracles of conditions on equilibria."""

from random import Random

import numpy as np
import sympy as sp

from oracles.sameness import LOGIC, holds, same_condition


def condition(mutant, reference, field, state, parameters, domain=None, kind=None, angle=None):
    """By what is given: a condition on an angle, on parameters with a domain, or on all angles."""
    if angle is not None:
        return angle_condition(mutant, reference, angle)
    if kind in (None, "unique"):
        return planar_region(mutant, reference, field, state, parameters, domain)
    if domain is None:
        return kind_of_angles(mutant, reference, field, state, parameters)
    return planar_region(mutant, reference, field, state, parameters, domain)


def angle_condition(mutant, reference, angle):
    """As `same_condition`, at the multiples of an eighth of pi too, where equalities can hold."""
    if not isinstance(mutant, LOGIC):
        return False
    eighths = [sp.pi * j / 8 for j in range(16)]
    return all(
        mutant.subs(angle, x) == reference.subs(angle, x) for x in eighths
    ) and same_condition(mutant, reference)


def kind_of_angles(mutant, reference, field, state, parameters):
    """True if two conditions agree wherever there are stationary angles, at many values in general
    position."""
    symbols = sorted(set(mutant.free_symbols | reference.free_symbols), key=str)
    tests = [sp.lambdify(symbols, condition, modules="math") for condition in (mutant, reference)]
    random, angles = np.random.default_rng(17), np.linspace(0, 2 * np.pi, 120)
    sizes = random.uniform(0, 2, size=(len(parameters), 4000, 1))
    signs = [
        -1 if p.is_negative else 1 if p.is_positive else random.choice((-1, 1), size=(4000, 1))
        for p in parameters
    ]
    values = dict(zip(parameters, (sign * size for sign, size in zip(signs, sizes))))
    force = sp.lambdify([state[0], *parameters], field[1].subs(state[1], 0))(
        angles, *values.values()
    )
    at_rest = np.flatnonzero((force.min(axis=1) < 0) & (force.max(axis=1) > 0))
    points = np.column_stack([values[p] for p in symbols])[at_rest].tolist() if symbols else [[]]
    return all(holds(tests[0], point) == holds(tests[1], point) for point in points)


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


ORACLES = {"equilibrium_condition": condition}
