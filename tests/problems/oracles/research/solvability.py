"""Oracles of what measurements determine, and how well."""

from fractions import Fraction
from random import Random

import sympy as sp

from oracles.sameness import LOGIC, holds, same_condition


def bound_violating_error(mutant, reference, matrix, state, factor):
    """True for every error for which |dx|^2 |H x + e|^2 >= factor^2 mu^2 |e|^2 |x|^2, in exact
    arithmetic."""
    if len(mutant) != matrix.rows:
        return False
    e, x = sp.Matrix(mutant).applyfunc(sp.nsimplify), sp.Matrix(state)
    change = (matrix.T * matrix).inv() * matrix.T * e
    squares = [abs(value) for value in (matrix.T * matrix).eigenvals()]
    left = change.dot(change) * (matrix * x + e).dot(matrix * x + e)
    right = sp.Integer(factor) ** 2 * max(squares) / min(squares) * e.dot(e) * x.dot(x)
    return e.dot(e) > 0 and bool(left >= right)


def stations_insufficient(mutant, reference, matrix, first, second):
    """As `same_condition`, at parallel directions and at those parallel in two components too,
    which chance does not meet."""
    if not isinstance(mutant, LOGIC) or not same_condition(mutant, reference):
        return False
    random, symbols = Random(18), [*first, *second]
    tests = [sp.lambdify(symbols, condition, modules="math") for condition in (mutant, reference)]

    def fraction(most, denominator):
        return Fraction(random.randint(1, most), denominator)

    for number in range(60):
        one = [random.choice((-1, 1)) * fraction(40, 7) for _ in first]
        factor = fraction(40, 9)
        other = [factor * part for part in one]
        if number % 4:
            other[number % 3] += fraction(9, 2)
        if holds(tests[0], [*one, *other]) != holds(tests[1], [*one, *other]):
            return False
    return True


ORACLES = {
    "research.bound_violating_error": bound_violating_error,
    "research.stations_insufficient": stations_insufficient,
}
