"""Means, covariances and correlations of quantities linear or nonlinear in a random vector.

The `law` is either the covariance matrix of the vector, and the quantities are linear in it, or the
probabilities of all its values, {value: probability}, and the quantities may be any functions of
it.

No check here is declared by a reference: an answer may have several expressions.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Expressions, Matrix, Values
from workbook.checks.contract.tolerance import EXACT, agree, in_decimals
from workbook.checks.contract.verdict import judged
from workbook.checks.tools.comparisons import SameMembers, SameValue
from workbook.checks.tools.samples import general_values, in_every_case
from workbook.checks.tools.values import value_at
from workbook.checks.tools.wording import number_text


@judged(Expressions("parameters", length="quantities"))
def expectations(claims, quantities, vector, law, parameters=()):
    """Check the means of quantities under the law {value: probability}.

    Can decide when the law gives all values with their probabilities; parameters get sample
    values.

    Examples
    --------
    >>> x = sp.Symbol("x")
    >>> half = sp.Rational(1, 2)
    >>> checks.expectations([1, 2], [x, x**2], [x], {0: half, 2: half}).status
    'right'
    >>> checks.expectations([1, 1], [x, x**2], [x], {0: half, 2: half}).status
    'wrong'
    """
    for values in in_every_case(general_values(parameters), claims):
        for claim, quantity in zip(claims, quantities):
            mean, size = _mean(quantity, vector, law, values)
            yield SameValue(claim, mean, f"the mean of {quantity}", values, size)
    return "each is the sum over all values, each with its probability"


@judged(
    Matrix(
        "parameters",
        shape=lambda data: (len(_as_list(data["first"])), len(_as_list(data["second"]))),
    )
)
def covariance(claim, first, second, vector, law, parameters=()):
    """Check the covariance of two quantities.

    Of two lists of them it is the matrix of the covariances of each of the first with each of
    the second.

    Can decide when the quantities are linear and the law is a covariance matrix, or for any
    quantities when the law gives all values.

    Examples
    --------
    >>> x, y = sp.symbols("x y")
    >>> checks.covariance(7, x + y, 2*x, [x, y], sp.Matrix([[2, 1], [1, 5]])).status
    'wrong'
    >>> checks.covariance(6, x + y, 2*x, [x, y], sp.Matrix([[2, 1], [1, 5]])).status
    'right'
    """
    rows, columns = _as_list(first), _as_list(second)
    for values in in_every_case(general_values(parameters), claim):
        covariances, sizes = _covariances([*rows, *columns], vector, law, values)
        for i, j in np.ndindex(claim.shape):
            quantity = (
                f"the variance of {rows[i]}, the mean square of its deviation,"
                if rows[i] == columns[j]
                else f"the covariance of {rows[i]} and {columns[j]}, the mean product of their deviations,"
            )
            at = i, len(rows) + j
            yield SameValue(claim[i, j], covariances[at], quantity, values, sizes[at])
    return "it is the mean of the product of the deviations from the means"


@judged(Expression("parameters"))
def correlation(claim, first, second, vector, law, parameters=()):
    """Check the correlation coefficient of two quantities.

    Can decide when the quantities are linear and the law is a covariance matrix, or for any
    quantities when the law gives all values.

    Examples
    --------
    >>> x, y = sp.symbols("x y")
    >>> checks.correlation(1/sp.sqrt(10), x, y, [x, y], sp.Matrix([[2, 1], [1, 5]])).status
    'right'
    >>> checks.correlation(sp.Rational(1, 10), x, y, [x, y], sp.Matrix([[2, 1], [1, 5]])).status
    'wrong'
    """
    quotient = "the covariance divided by the product of the standard deviations"
    for values in in_every_case(general_values(parameters), claim):
        (first_variance, shared), (_, second_variance) = _covariances(
            [first, second], vector, law, values
        )[0]
        true = shared / np.sqrt(first_variance * second_variance)
        yield SameValue(claim, true, quotient, values)
    return f"it is {quotient}"


@judged(Values(expected="a list of angles"))
def uncorrelated(claims, first, second, vector, law, angle):
    """Check all angles at which two quantities, linear in the vector, are not correlated.

    The angles run from 0 to pi, without pi itself.

    Can decide when the quantities are linear and their covariance has finitely many zeros in the
    angle.

    Examples
    --------
    >>> x, y, a = sp.symbols("x y a", real=True)
    >>> turned = [x*sp.cos(a) + y*sp.sin(a), y*sp.cos(a) - x*sp.sin(a)]
    >>> checks.uncorrelated([0, sp.pi/2], *turned, [x, y], sp.diag(1, 3), a).status
    'right'
    >>> checks.uncorrelated([0], *turned, [x, y], sp.diag(1, 3), a).status
    'wrong'
    """
    rows = [sp.Matrix([quantity]).jacobian(vector) for quantity in (first, second)]
    cross_covariance = (rows[0] * sp.Matrix(law) * rows[1].T)[0]
    claimed = [(claim, value_at(claim, {}, "an angle")) for claim in claims]
    true = list(_zeros(cross_covariance, angle))

    def extra(member):
        value = complex(cross_covariance.subs(angle, member[1])).real
        return (
            f"at {number_text(member[1])} the covariance is {number_text(value)}"
            if abs(value) > EXACT
            else f"{number_text(member[1])} does not lie between 0 and pi"
        )

    yield SameMembers(
        claimed,
        true,
        lambda member, zero: agree(member[1], zero, member[0]),
        extra,
        lambda count, zeros: "there is another angle at which the covariance vanishes",
    )
    if in_decimals(*claims):
        precision = "to three digits"
    elif all(sp.simplify(cross_covariance.subs(angle, claim)) == 0 for claim in claims):
        precision = "proved"
    else:
        precision = "to the digits computed"
    return f"there the covariance vanishes, and nowhere else: {precision}"


@functools.lru_cache(maxsize=16)
def _zeros(expression, angle):
    """Return the angles from 0 to pi, without pi, at which an expression of the data vanishes.

    They are cached for all verdicts.
    """
    return tuple(
        float(zero) for zero in sp.solveset(expression, angle, sp.Interval.Ropen(0, sp.pi))
    )


def _as_list(quantities):
    return quantities if isinstance(quantities, list) else [quantities]


def _mean(quantity, vector, law, values):
    terms = []
    for value, probability in law.items():
        at = dict(zip(vector, value if isinstance(value, tuple) else (value,)))
        terms.append(complex(sp.sympify(probability * quantity.subs(at)).subs(values)).real)
    return sum(terms), sum(map(abs, terms))


def _covariances(quantities, vector, law, values):
    """Return the covariance matrix, and the size of the terms of each entry."""
    if not isinstance(law, dict):
        rows = np.array(sp.Matrix(quantities).jacobian(vector).subs(values), dtype=float)
        matrix = np.array(sp.Matrix(law).subs(values), dtype=float)
        return rows @ matrix @ rows.T, abs(rows) @ abs(matrix) @ abs(rows).T
    means = [_mean(sp.sympify(q), vector, law, values)[0] for q in quantities]
    pairs = [
        [_mean((q - a) * (r - b), vector, law, values) for r, b in zip(quantities, means)]
        for q, a in zip(quantities, means)
    ]
    return tuple(np.array([[pair[k] for pair in row] for row in pairs]) for k in (0, 1))
