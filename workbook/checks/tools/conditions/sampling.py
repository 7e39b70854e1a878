"""Comparison of a condition with its reference at samples, where it cannot be decided."""

import itertools
from contextlib import suppress
from fractions import Fraction

import numpy as np
import sympy as sp

from workbook.checks.tools.conditions.cell_search import points_of_cells
from workbook.checks.tools.conditions.evaluation import allowed, prepared, sign

#: Angles at which equations with trigonometric functions are tried: there they hold exactly, or
#: not.
TURNS = [k * sp.pi / 6 for k in range(-12, 13)]
#: The most cells of a claim that are tried.
MOST_CELLS = 60


def try_samples(readings, parameters, reference):
    """Return the first sample where all readings of a claim are wrong, and their number.

    Parameters
    ----------
    readings : list
        Readings of the claim.
    parameters : list of sympy.Symbol
        Its symbols.
    reference : ReferenceCondition
        Where the condition has to hold.

    Returns
    -------
    tuple
        ((values, what holds) or None, count).

    Notes
    -----
    Along lines on which one parameter varies, the points where the reference changes are found by
    bisection; it is evaluated there, on both sides, far out, and on and between all points where the
    claim or the reference can change. Points of the cells on which the claim does not change come
    first: values that it names are among them.
    """
    symbols = tuple(parameters)
    claims = [prepared(reading, symbols) for reading in readings]
    holds_at = reference.at or _holds_at(parameters, reference)
    cache = {}

    def at(values):
        point = tuple(values.values())
        if point not in cache:
            try:
                cache[point] = holds_at(values)
            except (ArithmeticError, NotImplementedError, sp.PolynomialError):
                if all(x.is_Rational for x in point):
                    raise
                cache[point] = None  # at this irrational point the reference is not computed
        return cache[point]

    case_conditions = [
        prepared(case.condition, symbols) for case, _ in reference.cases if not case.unknowns
    ]
    points = (
        reference.points()
        if reference.points
        else itertools.chain(
            itertools.islice(points_of_cells(readings[0], parameters), MOST_CELLS),
            (
                dict(zip(parameters, (*base[:varied], x, *base[varied + 1 :])))
                for base, varied in _lines(parameters)
                for x in _along(base, varied, parameters, [claims[0], *case_conditions], at)
            ),
        )
    )
    count = 0
    for values in points:
        holds = at(values)
        if holds is None:
            continue
        with suppress(ArithmeticError):  # numbers of too high a degree to be computed with
            if all(claim.holds(values[p] for p in parameters) != holds for claim in claims):
                return (values, holds), count + 1
            count += 1
    if not count:
        raise RuntimeError("no point was found to try this condition at")
    return None, count


def _holds_at(parameters, reference):
    if not reference.cases or any(case.unknowns for case, _ in reference.cases):
        raise RuntimeError("this condition could not be decided, and there is nothing to try")
    cases = [
        (prepared(case.condition, tuple(parameters)), holds) for case, holds in reference.cases
    ]
    return lambda values: next(
        (holds for case, holds in cases if case.holds(values.values())), None
    )


def _lines(parameters, count=8):
    """Yield pairs (a random point, which parameter varies)."""
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
    """Return values of one parameter at which to compare."""

    def point(x):
        return (*base[:varied], x, *base[varied + 1 :])

    def is_allowed(x):
        return allowed(parameters[varied], sign(x))

    # Far out only what is exact can be trusted.
    far_values = [1e3, 1e6] if len(conditions) > 1 else []
    sizes = [_rational_near(x, 1000) for x in [*np.geomspace(1 / 50, 40, 24), *far_values]]
    grid = sorted(x for size in sizes for x in (size, -size) if is_allowed(x))
    true, claimed = (
        _changes(lambda x: at(dict(zip(parameters, point(x)))), grid),
        _changes(lambda x: conditions[0].holds(point(x)), grid),
    )
    changes, roots = (
        [*true, *claimed],
        [_rational_near(x, 10**12) for c in conditions for x in c.borders(base, varied)],
    )
    # What bisection finds in the reference is one of these again, or a border that it locates less
    # precisely.
    exact = [*roots, *claimed]
    ordered = sorted(
        {*exact, *(x for x in true if all(abs(x - root) > abs(x) / 500 for root in exact))}
    )
    sides = [_rational_near(float(x) * (1 + e), 10**9) for x in changes for e in (1e-3, -1e-3)]
    between = [(x + y) / 2 for x, y in itertools.pairwise(ordered) if y - x > (1 + abs(x)) / 10**9]
    at_changes = [
        rational
        for x in {*roots, *changes}
        if abs(x - (rational := _rational_near(x, 5000))) < sp.Rational(1, 10**9)
    ]
    irrational = set().union(*(c.irrational_borders(base, varied) for c in conditions))
    outer_values = [ordered[0] - 1, ordered[-1] + 1] if ordered and far_values else []
    turns = TURNS if conditions[0].condition.atoms(sp.sin, sp.cos, sp.tan) else []
    return sorted(
        x
        for x in {
            *grid,
            *sides,
            *between,
            *at_changes,
            *irrational,
            *outer_values,
            *turns,
            sp.Integer(0),
        }
        if is_allowed(x)
    )


def on_borders(condition, symbols):
    """Yield points along lines where a condition changes and its terms are rational.

    They are tried where a condition stands for an equation.
    """
    for base, varied in _lines(symbols, 60):
        for x in condition.borders(base, varied):
            yield dict(zip(symbols, (*base[:varied], _rational_near(x, 5000), *base[varied + 1 :])))


def _changes(function, grid):
    """Return the arguments between neighbours of a grid where a function of few values changes."""
    changes, values = [], [function(x) for x in grid]
    for left, right, value, last in zip(grid, grid[1:], values, values[1:]):
        # A third value may lie between two others, so the search goes on from each change to the
        # next.
        while value != last and len(changes) < 40:
            inner, outer = left, right
            for _ in range(42):
                middle = (inner + outer) / 2
                inner, outer = (middle, outer) if function(middle) == value else (inner, middle)
            changes.append(inner)
            left = outer = outer + (outer - inner)
            value = function(left)
    return changes


def _rational_near(x, largest):
    fraction = Fraction(float(x)).limit_denominator(largest)
    return sp.Rational(fraction.numerator, fraction.denominator)
