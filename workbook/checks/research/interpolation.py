"""Formulas that agree with a table of motions.

The polynomial of the table is found here by its powers, from linear equations, and not by
fundamental polynomials. Bounds of their errors are maxima in boxes.
"""

import functools
import itertools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.verdict import judged
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.samples import in_every_case, random_values

SAMPLES, SEED = 8, 81
#: Points of the grid on each side of a box in which a maximum is sought.
GRID = 25


@judged(Expression("nodes"))
def interpolant_quantity(claim, quantity, motion, nodes, level, slope=None, places=None):
    """Check a quantity of the polynomial that agrees with a motion at all nodes.

    It is an expression in the variables of the nodes. In the quantity `level` stands for the
    polynomial and `slope` for its derivative by the first variable.
    """
    powers = _powers(motion, nodes)
    places = places or {}
    names = [symbol for symbol in (level, slope) if symbol]
    between = sp.And(
        *(sp.And(symbol >= min(axis), symbol <= max(axis)) for symbol, axis in nodes.items())
    )
    for values in in_every_case(_inside(nodes), claim, between):
        values = values | places
        interpolant_values = dict(
            zip(names, (_polynomial(powers, nodes, values, order) for order in (0, 1)))
        )
        true = complex(sp.sympify(quantity).subs(interpolant_values | values).evalf())
        true, size = (true.real if abs(true.imag) < 1e-12 else math.nan), abs(true)
        size += max(map(abs, interpolant_values.values()))
        name = "the quantity, computed from the polynomial through the table,"
        yield SameValue(claim, true, name, values, size)
    return f"the polynomial through the table gives the same at {SAMPLES} points"


@judged(Expression(lambda data: _parameters(data["quantity"], data["box"])))
def greatest_magnitude(claim, quantity, box):
    """Check the greatest absolute value of a quantity in a box.

    The ends of the sides and the quantity may depend on further, positive symbols.

    Can decide when the quantity is continuous in the box; further symbols get sample values.

    Examples
    --------
    >>> t, h = sp.symbols("t h", positive=True)
    >>> checks.research.greatest_magnitude(h**2, t*(2*h - t), {t: (0, 2*h)}).status
    'right'
    >>> checks.research.greatest_magnitude(h, t*(2*h - t), {t: (0, 2*h)}).status
    'wrong'
    """
    for values in in_every_case(random_values(_parameters(quantity, box), SEED), claim):
        sides = [
            tuple(float(sp.sympify(end).subs(values)) for end in side) for side in box.values()
        ]
        function = sp.lambdify([list(box)], sp.Abs(sp.sympify(quantity).subs(values)))
        true = _greatest(function, sides)
        yield SameValue(claim, true, "the greatest absolute value", values, true)
    return "no absolute value in the given intervals is greater, and one is equal, for random values of the symbols"


def _parameters(quantity, box):
    """Return the symbols of a quantity and of the ends of a box, without its variables."""
    symbols = sp.Tuple(quantity, *(end for side in box.values() for end in side)).free_symbols
    return sorted(symbols - set(box), key=str)


def _greatest(function, sides):
    """Return the maximum of a function in a box: the best point of a grid, improved."""
    from scipy.optimize import minimize

    grid = itertools.product(*(np.linspace(*side, GRID) for side in sides))
    best = max(grid, key=function)
    improved = minimize(lambda point: -function(point), best, bounds=sides, tol=1e-13)
    return float(max(function(best), -improved.fun))


def _powers(motion, nodes):
    """Return the coefficients of the polynomial in powers of all variables."""
    rows = itertools.product(*nodes.values())
    values = [float(sp.sympify(motion).subs(dict(zip(nodes, row)))) for row in rows]
    coefficients = np.reshape(values, [*map(len, nodes.values())])
    for k, axis in enumerate(nodes.values()):
        vandermonde = np.vander([float(node) for node in axis], increasing=True)
        solve = functools.partial(np.linalg.solve, vandermonde)
        coefficients = np.apply_along_axis(solve, k, coefficients)
    return coefficients


def _polynomial(coefficients, nodes, values, order):
    """Return the value of the polynomial, or of its derivative by the first variable."""
    for k, symbol in reversed(list(enumerate(nodes))):
        powers = np.arange(coefficients.shape[-1])
        row = float(values[symbol]) ** powers
        if k == 0 and order:
            row = np.append(0, powers[1:] * row[:-1])
        coefficients = coefficients @ row
    return float(coefficients)


def _inside(nodes):
    """Yield random points between the nodes."""
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        yield {
            symbol: float(random.uniform(float(min(axis)), float(max(axis))))
            for symbol, axis in nodes.items()
        }
