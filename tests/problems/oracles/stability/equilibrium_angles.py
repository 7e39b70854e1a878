"""Oracles of program motions and stationary angles."""

import functools
import math

import numpy as np
import sympy as sp

from oracles.sameness import LOGIC, holds, same_condition


def same_angles(mutant, reference, field, state, parameters, integer):
    """True if two lists of families have the same angles, for several values of the parameters."""
    samples = [
        {p: -sp.Rational(j, 7) if p.is_negative else sp.Rational(j + 2, 3) for p in parameters}
        for j in (1, 2, 4)
    ]
    one, other = (tuple(map(sp.sympify, angles)) for angles in (mutant, reference))
    return all(
        _angles_near_zero(one, tuple(values.items()), integer)
        == _angles_near_zero(other, tuple(values.items()), integer)
        for values in samples
    )


@functools.lru_cache(maxsize=64)  # that of the reference is asked for with every mutant
def _angles_near_zero(angles, values, integer):
    """Angles within three turns, rounded; an angle that is not real is one of its own."""
    numbers = [
        complex(a.subs(dict(values)).subs(integer, j).evalf())
        for a in angles
        for j in range(-20, 21)
    ]
    return {
        "not real" if abs(x.imag) > 1e-9 else round(x.real, 6) + 0.0
        for x in numbers
        if abs(x) < 6 * math.pi
    }


def angle_condition(mutant, reference, field, state, parameters, angle):
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


ORACLES = {
    "equilibrium_angles": same_angles,
    "stable_equilibrium_angles": same_angles,
    "unstable_equilibrium_angles": same_angles,
    "stable_angle_condition": angle_condition,
    "saddle_angle_condition": angle_condition,
}
