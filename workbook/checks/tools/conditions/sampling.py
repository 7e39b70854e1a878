"""A condition against the truth at samples, for what is not polynomial, or too large to be
decided."""

import itertools
from fractions import Fraction

import numpy as np
import sympy as sp

from workbook.checks.tools.conditions.evaluation import allowed, prepared, sign

#: Angles at which equations with trigonometric functions are tried: there they hold exactly, or
#: not.
TURNS = [k * sp.pi / 6 for k in range(-12, 13)]


def try_samples(readings, parameters, truth):
    """(place, count): the first point of the samples where all readings are wrong, as (values, what
    holds), or None.

    Along lines on which one parameter varies, the places where the truth changes are found by
    bisection; it is asked there, on both sides, far out, and on and between all places where the
    claim or the truth can change.
    """
    symbols = tuple(parameters)
    claims = [prepared(reading, symbols) for reading in readings]
    truth_at = truth.at or _truth_at(parameters, truth)
    seen = {}

    def at(values):
        place = tuple(values.values())
        if place not in seen:
            seen[place] = truth_at(values)
        return seen[place]

    known = [prepared(case.condition, symbols) for case, _ in truth.cases if not case.unknowns]
    places = (
        truth.points()
        if truth.points
        else (
            dict(zip(parameters, (*base[:varied], x, *base[varied + 1 :])))
            for base, varied in _lines(parameters)
            for x in _along(base, varied, parameters, [claims[0], *known], at)
        )
    )
    count = 0
    for values in places:
        holds = at(values)
        if holds is None:
            continue
        count += 1
        if all(claim.holds(values[p] for p in parameters) != holds for claim in claims):
            return (values, holds), count
    if not count:
        raise RuntimeError("no point was found to try this condition at")
    return None, count


def _truth_at(parameters, truth):
    if not truth.cases or any(case.unknowns for case, _ in truth.cases):
        raise RuntimeError("this condition could not be decided, and there is nothing to try")
    cases = [(prepared(case.condition, tuple(parameters)), holds) for case, holds in truth.cases]
    return lambda values: next(
        (holds for case, holds in cases if case.holds(values.values())), None
    )


def _lines(parameters, count=8):
    """Pairs (a random place, which parameter varies)."""
    random = np.random.default_rng(12)
    for k in range(count if len(parameters) > 1 else 1):
        sizes = [sp.Rational(int(random.integers(1, 60)), 20) for _ in parameters]
        yield (
            tuple(
                size if allowed(p, 1) and (not allowed(p, -1) or random.integers(2)) else -size
                for p, size in zip(parameters, sizes)
            ),
            k % len(parameters),
        )


def _along(base, varied, parameters, conditions, at):
    """Values of one parameter at which to compare."""

    def place(x):
        return (*base[:varied], x, *base[varied + 1 :])

    def fits(x):
        return allowed(parameters[varied], sign(x))

    # Far out only what is exact can be trusted.
    far = [1e3, 1e6] if len(conditions) > 1 else []
    sizes = [_near(x, 1000) for x in [*np.geomspace(1 / 50, 40, 24), *far]]
    grid = sorted(x for size in sizes for x in (size, -size) if fits(x))
    true, claimed = (
        _changes(lambda x: at(dict(zip(parameters, place(x)))), grid),
        _changes(lambda x: conditions[0].holds(place(x)), grid),
    )
    changes, roots = (
        [*true, *claimed],
        [_near(x, 10**12) for c in conditions for x in c.borders(base, varied)],
    )
    # What bisection finds in the truth is one of these again, or a border that the truth knows less
    # well.
    exact = [*roots, *claimed]
    ordered = sorted(
        {*exact, *(x for x in true if all(abs(x - root) > abs(x) / 500 for root in exact))}
    )
    sides = [_near(float(x) * (1 + e), 10**9) for x in changes for e in (1e-3, -1e-3)]
    between = [(x + y) / 2 for x, y in itertools.pairwise(ordered) if y - x > (1 + abs(x)) / 10**9]
    on = [
        near
        for x in {*roots, *changes}
        if abs(x - (near := _near(x, 5000))) < sp.Rational(1, 10**9)
    ]
    beyond = [ordered[0] - 1, ordered[-1] + 1] if ordered and far else []
    turns = TURNS if conditions[0].condition.atoms(sp.sin, sp.cos, sp.tan) else []
    return sorted(
        x for x in {*grid, *sides, *between, *on, *beyond, *turns, sp.Integer(0)} if fits(x)
    )


def on_borders(condition, symbols):
    """Places along lines where a condition changes and its terms are rational: to be tried where it
    means an equation.
    """
    for base, varied in _lines(symbols, 60):
        for x in condition.borders(base, varied):
            yield dict(zip(symbols, (*base[:varied], _near(x, 5000), *base[varied + 1 :])))


def _changes(function, grid):
    """The places between neighbours of a grid where a function of few values changes, to ten
    digits."""
    found, values = [], [function(x) for x in grid]
    for left, right, value, last in zip(grid, grid[1:], values, values[1:]):
        # A third value may lie between two others, so the search goes on from each change to the
        # next.
        while value != last and len(found) < 40:
            inner, outer = left, right
            for _ in range(42):
                middle = (inner + outer) / 2
                inner, outer = (middle, outer) if function(middle) == value else (inner, middle)
            found.append(inner)
            left = outer = outer + (outer - inner)
            value = function(left)
    return found


def _near(x, largest):
    near = Fraction(float(x)).limit_denominator(largest)
    return sp.Rational(near.numerator, near.denominator)
