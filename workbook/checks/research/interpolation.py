"""Formulas that agree with a table of motions.

The polynomial of the table is found here by its powers, from linear equations, and not by
fundamental polynomials.
"""

import math

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.verdict import judged
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.samples import in_every_case

SAMPLES, SEED = 8, 81


@judged(Expression("nodes"))
def interpolant_quantity(claim, quantity, motion, nodes, level, slope=None, places=None):
    """Check a quantity of the polynomial that agrees with a motion at all nodes.

    It is an expression in the variables of the nodes. In the quantity `level` stands for the
    polynomial and `slope` for its derivative by the first variable.
    """
    powers, places, names = (
        _powers(motion, nodes),
        places or {},
        [symbol for symbol in (level, slope) if symbol],
    )
    between = sp.And(
        *(sp.And(symbol >= min(axis), symbol <= max(axis)) for symbol, axis in nodes.items())
    )
    for values in in_every_case(_inside(nodes), claim, between):
        values = values | places
        interpolant_values = dict(
            zip(names, (_polynomial(powers, nodes, values, order) for order in (0, 1)))
        )
        true = complex(sp.sympify(quantity).subs(interpolant_values | values).evalf())
        yield SameValue(
            claim,
            true.real if abs(true.imag) < 1e-12 else math.nan,
            "the quantity, computed from the polynomial through the table,",
            values,
            abs(true) + max(map(abs, interpolant_values.values())),
        )
    return f"the polynomial through the table gives the same at {SAMPLES} places"


def _powers(motion, nodes):
    """Return the coefficients of the polynomial in powers of all variables."""
    grid = np.meshgrid(*([float(node) for node in axis] for axis in nodes.values()), indexing="ij")
    rows = np.stack([axis.ravel() for axis in grid], axis=1)
    exact = [sp.sympify(motion).subs(dict(zip(nodes, _exactly(nodes, row)))) for row in rows]
    coefficients = np.array([float(value) for value in exact]).reshape(grid[0].shape)
    for k, axis in enumerate(nodes.values()):
        vandermonde = np.vander([float(node) for node in axis], increasing=True)
        coefficients = np.moveaxis(
            np.linalg.solve(
                vandermonde, np.moveaxis(coefficients, k, 0).reshape(len(axis), -1)
            ).reshape(len(axis), *np.delete(coefficients.shape, k)),
            0,
            k,
        )
    return coefficients


def _exactly(nodes, row):
    """Return the exact nodes closest to a row of decimals."""
    return [
        min(axis, key=lambda node: abs(float(node) - point))
        for axis, point in zip(nodes.values(), row)
    ]


def _polynomial(powers, nodes, values, order):
    """Return the value of the polynomial, or of its derivative by the first variable."""
    coefficients = powers
    for k, symbol in reversed(list(enumerate(nodes))):
        row = np.array([float(values[symbol]) ** n for n in range(coefficients.shape[-1])])
        if k == 0 and order:
            row = np.array(
                [
                    n * float(values[symbol]) ** (n - 1) if n else 0.0
                    for n in range(coefficients.shape[-1])
                ]
            )
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
