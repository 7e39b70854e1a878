"""Scalings of a problem: x'' = u with |u| <= 1 is the same if times are halved and positions quartered.

Then all that is asked of it is known at every scale as soon as it is known at one: next to a corner
of the answer as well as far out, where a smooth imitation such as tanh(1000 x) for the sign of x is
detected however steep it is. Each symbol has a weight w, and is multiplied by (a number)^w; the
weights solve linear equations, which the statement gives.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract.tolerance import DECIMALS, EXACT
from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.numeric_functions import multiprecision_function, real_function
from workbook.checks.tools.wording import NO_NUMBER, prefix_text

#: The numbers of which powers are taken: close to the corner, closer, and far out. Most roots of
#: them are rational.
SCALES = (sp.Rational(1, 2**6), sp.Rational(1, 2**18), sp.Rational(1, 2**36), sp.Integer(2**6))

#: What is a smaller part than this of the other numbers is zero.
ROUNDING = 1e-6
#: What stands for time and cost among the symbols that have weights.
TIME, COST = sp.Dummy("time"), sp.Dummy("cost")


def scales(problem, parameters):
    """Return the scalings of a problem: dicts from symbols to factors that leave it as it is.

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem; its symbols and the `parameters` are scaled, and `TIME` and `COST`.
    parameters : list of sympy.Symbol
        Its parameters.

    Returns
    -------
    list of dict
        Empty if only factors 1 leave it as it is.
    """
    stated = (
        *(tuple(table.items()) for table in (problem.dynamics, problem.controls, problem.initial)),
        tuple(problem.terminal),
        problem.running,
        problem.final,
        problem.duration,
    )
    return _scales(stated, tuple(parameters or ()))


@functools.lru_cache(maxsize=64)
def _scales(stated, parameters):
    dynamics, controls, initial, terminal, running, final, duration = stated
    symbols = [*(x for x, _ in dynamics), *(u for u, _ in controls), *parameters, TIME, COST]
    weights = _Weights(symbols)
    pairs = [
        *((f, w - weights[TIME]) for (_, f), w in zip(dynamics, map(weights.of, symbols))),
        *((bound, weights[u]) for u, pair in controls for bound in pair if bound is not None),
        *((value, weights[x]) for x, value in initial if value is not None),
        *((part, None) for part in terminal),
        (running, weights[COST] - weights[TIME]),
        (final, weights[COST]),
        *(
            (end, weights[TIME])
            for end in (duration if isinstance(duration, tuple) else (duration,))
            if end is not None
        ),
    ]
    try:
        for expression, weight in pairs:
            weights.equate(sp.sympify(expression), weight)
    except _Other:
        return []
    return [
        {s: scale**w for s, w in zip(weights, solution)}
        for solution in weights.solutions()
        for scale in SCALES
    ]


def judge_at_every_scale(claim, problem, parameters, points, weight, quantity):
    """Raise `Wrong` for an expression that does not scale with the problem.

    Parameters
    ----------
    claim : sympy.Expr
        The answer; its values have to change by the factor of the symbol `weight`.
    problem : pontryagin.Problem
        The problem.
    parameters : list of sympy.Symbol
        Its parameters.
    points : list of dict
        {symbol: number} each.
    weight : sympy.Symbol
        A symbol of the scalings.
    quantity : str
        The quantity, for the message.
    """
    factors_of_scales = scales(problem, parameters)
    if not factors_of_scales:
        return
    symbols = [s for s in points[0] if s in claim.free_symbols]
    has_decimal_exponent = any(
        power.exp.is_Float and not float(4 * power.exp).is_integer()
        for power in claim.atoms(sp.Pow)
    )
    function, multiprecision = (
        kind(symbols, [claim]) for kind in (real_function, multiprecision_function)
    )
    at = np.array([[float(point[s]) for s in symbols] for point in points])
    numbers = function(*at.T)[0]
    # An exponent in decimals has three digits: over many powers of ten they decide nothing.
    for factors in factors_of_scales[:: len(SCALES) if has_decimal_exponent else 1]:
        scaled_points = at * [float(factors[s]) for s in symbols]
        scaled_values, expected = function(*scaled_points.T)[0], numbers * float(factors[weight])
        for k in first_difference(
            scaled_values,
            expected,
            DECIMALS if has_decimal_exponent else EXACT,
            lambda k, scaled=scaled_points: multiprecision(*scaled[k])[0],
        ):
            raise Wrong(
                f"{prefix_text(dict(zip(symbols, at[k])))}your {quantity} is {numbers[k]:.6g}. In other "
                "units the problem is the same, but there your expression does not give "
                f"the same {quantity}: {prefix_text(dict(zip(symbols, scaled_points[k])))}it is "
                + (f"{scaled_values[k]:.6g}" if np.isfinite(scaled_values[k]) else NO_NUMBER)
            )


def first_difference(numbers, expected, share, recompute):
    """Return the index of the first wrong number, in a list, or an empty list.

    Parameters
    ----------
    numbers, expected : numpy.ndarray
        The numbers; those that floats could not compute are replaced by those of `recompute`.
    share : float
        The tolerance, relative to a number, and at least rounding relative to the largest.
    recompute : callable
        `recompute(k)` computes a number in more digits, as in `multiprecision_function`.
    """
    size = np.abs(expected)
    slack = share * np.maximum(size, ROUNDING * np.nanmax(size, initial=0))
    for k in np.flatnonzero(np.isfinite(expected) & ~(abs(numbers - expected) <= slack)):
        numbers[k] = recompute(k)
        if not abs(numbers[k] - expected[k]) <= slack[k]:
            return [k]
    return []


class _Other(Exception):
    """Raised for an expression of a kind that has no weight."""


class _Weights(dict):
    """Unknown weights of symbols, and the equations for them."""

    def __init__(self, symbols):
        super().__init__((s, sp.Dummy()) for s in symbols)
        self._equations = []

    def equate(self, expression, weight):
        """Demand that an expression has a weight; zero has every one."""
        if expression == 0 or expression.is_infinite:
            return
        expression_weight = self.of(expression)
        if weight is not None:
            self._equations.append(expression_weight - weight)

    def of(self, expression):
        """Return the weight of an expression in those of its symbols; terms of sums need equal ones."""
        if expression.is_number:
            return sp.S.Zero
        if expression in self:
            return self[expression]
        if isinstance(expression, sp.Mul):
            return sp.Add(*map(self.of, expression.args))
        if isinstance(expression, sp.Pow) and expression.exp.is_number:
            return expression.exp * self.of(expression.base)
        if isinstance(expression, sp.Abs):
            return self.of(expression.args[0])
        if not isinstance(expression, (sp.Add, sp.Function, sp.Pow)):
            raise _Other
        first, *other_weights = map(self.of, expression.args)
        self._equations += (
            [other_weight - first for other_weight in other_weights]
            if isinstance(expression, sp.Add)
            else [first, *other_weights]
        )
        return first if isinstance(expression, sp.Add) else sp.S.Zero

    def solutions(self):
        """Return independent lists of weights."""
        unknown = list(self.values())
        matrix = sp.Matrix([[equation.coeff(w) for w in unknown] for equation in self._equations])
        return [list(column) for column in matrix.nullspace()] if matrix else []
