"""Oracles of equilibria by their values, families of them among these."""

from fractions import Fraction
from random import Random

import sympy as sp

from oracles.sameness import excluded


def same_family(mutant, reference, field, state, parameters=(), given=(), integer=None, kind=None):
    """True if two lists of expressions in an integer have the same members, whatever their order
    and counting."""
    random, left_out, compared = Random(12), excluded(given), 0
    while compared < 3:
        point = {
            p: Fraction(random.randint(1, 40), 12)
            * (1 if p.is_positive else -1 if p.is_negative else random.choice((-1, 1)))
            for p in parameters
        }
        if left_out(point):
            continue
        compared += 1
        values = {p: sp.Rational(x.numerator, x.denominator) for p, x in point.items()}
        one, other = (_family_members(answer, values, integer) for answer in (mutant, reference))
        if one != other:
            return False
    return True


def _family_members(answer, values, integer):
    """The members between -20 and 20, rounded."""
    numbers = {
        complex(sp.sympify(family).subs(values | ({} if integer is None else {integer: k})).evalf())
        for family in answer
        for k in (range(-40, 41) if integer is not None else (0,))
    }
    return {(round(x.real, 6) + 0.0, round(x.imag, 6) + 0.0) for x in numbers if abs(x) < 20}


ORACLES = {"equilibrium_values": same_family}
