"""Exceptional values of parameters, at which an answer fails though it is right in general.

A denominator, a pivot or a determinant of it vanishes there, while the reference is what it is
elsewhere. All values are examined, exactly.
"""

import itertools

import mpmath
import sympy as sp

from workbook.checks.contract.verdict import Wrong
from workbook.checks.references.invariant_subspaces import maximal_minors
from workbook.checks.tools.conditions import compare, decide, exactly
from workbook.checks.tools.wording import values_text

#: Answers longer than this are tried at values in general position alone.
MOST_OPERATIONS = 600


def judge_everywhere(matrix, parameters, domain, undefined, dependent=None):
    """Raise `Wrong` if a matrix fails at some values of the parameters.

    Parameters
    ----------
    matrix : sympy.Matrix
        The answer.
    parameters : list of sympy.Symbol
        Its parameters.
    domain : callable
        `domain()` returns the condition on them; it is called only if the matrix holds a parameter.
    undefined, dependent : str
        Messages for values where the matrix is undefined and where its columns are dependent; without
        the latter dependent columns are accepted.
    """
    used = [p for p in parameters if matrix.has(p)]
    if not used or matrix.has(sp.nan, sp.zoo, sp.oo) or sp.count_ops(matrix) > MOST_OPERATIONS:
        return
    # As it is written: with (k**2 - 1)/(k - 1) in the point of k + 1 it has no value for k = 1.
    denominators = [sp.denom(sp.together(sp.nsimplify(entry, rational=True))) for entry in matrix]
    matrix = matrix.applyfunc(
        lambda entry: (
            sp.cancel(sp.nsimplify(entry, rational=True))
            if entry.is_rational_function(*used)
            else entry
        )
    )
    conditions = {undefined: sp.And(*(sp.Ne(part, 0) for part in denominators))}
    vanishing = [(undefined, sp.Mul(*set(denominators)))]
    if dependent:
        minors = list(maximal_minors(matrix))
        if not matrix.has(*_JUMPING):
            shared = set.intersection(
                *(set(sp.Mul.make_args(sp.factor(minor))) for minor in minors if minor != 0)
            )
            vanishing.append((dependent, sp.Mul(*shared)))
        conditions[dependent] = sp.Or(*(sp.Ne(sp.numer(sp.together(minor)), 0) for minor in minors))
    for failure, function in vanishing:
        if not (function.is_rational_function(*used) or function.has(*_JUMPING)):
            for values in _sign_changes(function, used):
                if domain().subs(values) == sp.true:
                    raise Wrong(
                        f"{failure} for a value near {values_text(values)}, where the answer is to "
                        "serve too"
                    )
    for failure, condition in conditions.items():
        if condition != sp.true:
            compare(
                condition,
                parameters,
                exactly(sp.true, domain()),
                lambda values, holds: (
                    f"{failure} for {values_text(values)}, where the answer has to hold too"
                ),
            )


def judge_where_generic(matrix, pair, undefined, dependent=None):
    """Raise `Wrong` if a matrix fails where no more states of a `Pair` are unobservable than in general."""
    judge_everywhere(matrix, pair.parameters, lambda: pair.generic_condition, undefined, dependent)


def judge_factors(expressions, variables, domain, failure):
    """Raise `Wrong` if nonzero expressions share a factor of other symbols that vanishes.

    Parameters
    ----------
    expressions : list of sympy.Expr
        The answer.
    variables : list of sympy.Symbol
        Its variables; the factor does not hold them.
    domain : dict or None
        Intervals of symbols.
    failure : str
        The message.
    """
    shared = [
        {power.as_base_exp()[0] for power in sp.Mul.make_args(sp.factor(e))}
        for e in expressions
        if e != 0 and sp.count_ops(e) <= MOST_OPERATIONS
    ]
    for factor in sorted(set.intersection(*shared) if shared else (), key=sp.default_sort_key):
        symbols = sorted(factor.free_symbols, key=str)
        if symbols and not factor.has(*variables):
            condition = sp.And(
                *(domain[s].as_relational(s) for s in symbols if domain and s in domain)
            )
            _, point = decide(sp.Ne(factor, 0), symbols, exactly(sp.true, condition))
            if point:
                raise Wrong(
                    f"{failure} for {values_text(point[0])}, where the answer has to hold too"
                )


def _sign_changes(function, symbols):
    """Yield points beside which a function that is no rational one goes through zero.

    One of its symbols runs, the others have general values. Between two signs a continuous function is
    zero; at a pole or a jump it does not become small.
    """
    general = dict(zip(symbols, map(sp.Rational, ("17/10", "23/10", "29/10", "31/10", "37/10"))))
    # Without powers: a square has a zero without a change of sign.
    factors = {factor.as_base_exp()[0] for factor in sp.Mul.make_args(sp.factor(function))}
    for factor, symbol in itertools.product(sorted(factors, key=sp.default_sort_key), symbols):
        value = sp.lambdify(
            symbol, factor.subs({s: v for s, v in general.items() if s != symbol}), "mpmath"
        )
        grid = itertools.pairwise(
            _HALF if symbol.is_nonnegative else [-x for x in _HALF[::-1]] + _HALF
        )
        # small numbers are shown first
        for left, right in sorted(grid, key=lambda ends: abs(ends[0])):
            root = _root(lambda x: value(mpmath.mpf(x)), left, right)
            if root is not None:
                yield general | {symbol: sp.Rational(round(root, 6))}


_HALF = [k / 8 + 0.01 for k in range(160)] + [20.01 * 1.3**k for k in range(20)]
#: Functions that jump: one may avoid a zero by a value of its own just there.
_JUMPING = (sp.Piecewise, sp.sign, sp.Heaviside, sp.floor, sp.ceiling)


def _root(value, left, right):
    """Return where a function changes its sign between two numbers, or None."""
    try:
        ends = value(left), value(right)
        if (
            not all(mpmath.isfinite(end) and mpmath.im(end) == 0 for end in ends)
            or ends[0] * ends[1] >= 0
        ):
            return None
        for _ in range(60):
            middle = (left + right) / 2
            at = value(middle)
            left, right = (left, middle) if at * ends[0] <= 0 else (middle, right)
    except (ValueError, TypeError, ZeroDivisionError, OverflowError, NameError):
        return None
    return middle if abs(at) <= 1e-9 * max(map(abs, ends)) else None
