"""Information sets: convex polygons given by their sides.

A polygon {p: a_i p <= b_i} is judged by its corners, which are found where two sides meet and no
other is violated; whether it has a point at all by Farkas' lemma, over pairs and triples of sides.
Sides are not made tight. How far a vehicle comes is found by quadrature over its headings.
"""

import functools
import itertools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Expressions
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.conditions import compare, exactly
from workbook.checks.tools.samples import allowed_values, conjunction, in_every_case, random_values
from workbook.checks.tools.wording import values_text

#: By how much of its size a side may seem violated at a corner that lies on it.
ROUNDING = 1e-9
#: Number of durations and directions for which a distance is compared.
DISTANCES = 8


@judged(Expressions("bounds", length=lambda data: data["directions"].rows))
def support_values(claims, sides, bounds, directions):
    """Check the support function of {p: sides p <= bounds} in each direction.

    For the rows n it is the greatest n p over the set.

    Can decide when the polygon has corners, for random values of the symbols.

    Examples
    --------
    >>> b = sp.Symbol("b", positive=True)
    >>> square = sp.Matrix([[1, 0], [-1, 0], [0, 1], [0, -1]])
    >>> checks.research.support_values([2*b], square, [b]*4, sp.Matrix([[1, 1]])).status
    'right'
    >>> checks.research.support_values([b], square, [b]*4, sp.Matrix([[1, 1]])).status
    'wrong'
    """
    yield from _same_support(claims, sides, bounds, directions)
    return "they are the greatest over all corners, for random values of the symbols"


@judged(Expressions("points", "bounds", length=lambda data: data["directions"].rows))
def section_values(claims, points, directions, sides=None, bounds=()):
    """Check the support function of a section in each direction.

    The section is the smallest polygon with these normals around the points; with sides, the part
    of it where sides p <= bounds.
    """
    yield from _same_support(claims, *_cut_section(points, directions, sides, bounds), directions)
    return "they are the greatest over all corners, for random values of the symbols"


@judged
def common_point_exists(answer, sides, bounds):
    """Check the condition for {p: sides p <= bounds} to have a point.

    The symbols of the bounds have positive values.

    Can decide when the bounds are polynomials of positive symbols; elsewhere the condition is
    compared at points.

    Examples
    --------
    >>> a, b = sp.symbols("a b", positive=True)
    >>> checks.research.common_point_exists(a <= b, sp.Matrix([[1, 0], [-1, 0]]), [b, -a]).status
    'right'
    >>> checks.research.common_point_exists(a < b, sp.Matrix([[1, 0], [-1, 0]]), [b, -a]).status
    'wrong'
    """
    return _common_point_agreement(answer, sides, bounds)


@judged
def section_meets(answer, points, directions, sides, bounds):
    """Check the condition for a section to have a point with sides p <= bounds.

    The section is the smallest polygon with the normals `directions` around the points. The
    symbols have positive values.
    """
    return _common_point_agreement(answer, *_cut_section(points, directions, sides, bounds))


@judged(Expression("duration", "direction"))
def greatest_distance(claim, duration, direction, given, final=None):
    """Check how far a vehicle with the turning radius 1 comes in a direction.

    It starts at the origin with the heading 0 and the speed 1. With `final` its last heading is
    given. At each time the heading is the possible one that is nearest to the direction.

    Can decide when duration and direction have values that satisfy what is given; it is compared
    there.

    Examples
    --------
    >>> T = sp.Symbol("T", positive=True)
    >>> checks.research.greatest_distance(T, T, 0, [T < 3]).status
    'right'
    >>> checks.research.greatest_distance(T/2, T, 0, [T < 3]).status
    'wrong'
    """
    from scipy.integrate import quad

    symbols = _symbols([duration, direction])
    for values in in_every_case(
        allowed_values(symbols, given, DISTANCES), claim, conjunction(given)
    ):
        total, towards = (float(sp.sympify(part).subs(values)) for part in (duration, direction))

        def rate(s):
            turned = s if final is None else min(s, total - s + final)
            return math.cos(max(towards - turned, 0))

        last = total + (final or 0)
        kinks = [towards, last - towards, last / 2]
        true, _ = quad(rate, 0, total, points=[s for s in kinks if 0 < s < total])
        yield SameValue(claim, true, "the greatest distance", values, total)
    return "it is the distance with the best possible heading at each time"


def _same_support(claims, sides, bounds, directions):
    """Yield comparisons of the claims with the greatest values over all corners."""
    symbols = _symbols(bounds)
    for values in in_every_case(random_values(symbols, 91), sp.Matrix(claims)):
        corners = _corners(sides, bounds, values)
        reach = np.array(directions.tolist(), dtype=float) @ corners.T
        for k, claim in enumerate(claims):
            quantity = f"how far the polygon reaches in direction {k + 1}"
            yield SameValue(claim, reach[k].max(), quantity, values, np.abs(corners).max())


def _common_point_agreement(answer, sides, bounds):
    """Return the agreement of a condition with Farkas' lemma."""
    symbols = _symbols(bounds)
    domain = sp.And(*(symbol > 0 for symbol in symbols))

    def reason(values, holds):
        return f"for {values_text(values)} " + (
            "some point keeps all bounds, yet your condition fails"
            if holds
            else "no point keeps all bounds, yet your condition holds"
        )

    needed = _necessary(sides.as_immutable(), tuple(map(sp.sympify, bounds)))
    agreement = compare(answer, symbols, exactly(needed, domain), reason)
    return f"it agrees with the bounds on all pairs and triples of sides: {agreement}"


def _cut_section(points, directions, sides, bounds):
    """Return sides and bounds of the polygon around points, and those that cut it."""
    around = [
        sp.Max(*(sp.expand(directions.row(i).dot(sp.Matrix(point).T)) for point in points))
        for i in range(directions.rows)
    ]
    return (
        directions if sides is None else sp.Matrix.vstack(directions, sides),
        [*around, *bounds],
    )


def _symbols(bounds):
    return sorted(sp.Matrix(bounds).free_symbols, key=str)


def _corners(sides, bounds, values):
    """Return all corners at values of the symbols, of shape (count, 2)."""
    a = np.array(sides.tolist(), dtype=float)
    b = np.array([float(sp.sympify(bound).subs(values)) for bound in bounds])
    corners = []
    for i, j in itertools.combinations(range(len(b)), 2):
        pair = a[[i, j]]
        if abs(np.linalg.det(pair)) > ROUNDING:
            corner = np.linalg.solve(pair, b[[i, j]])
            if (a @ corner <= b + ROUNDING * (1 + np.abs(b).max())).all():
                corners.append(corner)
    if not corners:
        raise Wrong("for some values of the symbols the polygon has no corner")
    return np.array(corners)


@functools.lru_cache(maxsize=32)
def _necessary(sides, bounds):
    """Return the conditions of Farkas' lemma over pairs and triples of sides.

    sum lambda_i b_i >= 0 for all lambda >= 0 with sum lambda_i a_i = 0.
    """
    rows = [sides.row(i) for i in range(sides.rows)]
    cross_products = {
        (i, j): sp.simplify(rows[i][0] * rows[j][1] - rows[i][1] * rows[j][0])
        for i, j in itertools.combinations(range(len(rows)), 2)
    }
    conditions = [
        sp.simplify(rows[j].norm() * bounds[i] + rows[i].norm() * bounds[j]) >= 0
        for (i, j), cross_product in cross_products.items()
        if cross_product == 0 and rows[i].dot(rows[j]) < 0
    ]
    for i, j, k in itertools.combinations(range(len(rows)), 3):
        weights = [cross_products[j, k], -cross_products[i, k], cross_products[i, j]]
        signs = {sp.sign(weight) for weight in weights}
        if len(signs) == 1 and signs != {sp.S.Zero}:
            total = sum(abs(weight) * bounds[n] for weight, n in zip(weights, (i, j, k)))
            conditions.append(sp.simplify(total / abs(weights[0])) >= 0)
    return sp.And(*conditions)
