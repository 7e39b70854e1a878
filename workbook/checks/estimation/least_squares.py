"""Estimates by least squares, which minimise the weighted sum of the squared residuals.

Measurements are [(quantity, measured value), ...], the quantities linear in the unknowns;
`deviations` are the standard deviations of their independent errors, 1 by default. A third entry,
(quantity, value, count), gives the number of measurements with this value.

No check here is declared by a reference: the deviations stand before the parameters in the data.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Expressions, Matrix
from workbook.checks.contract.direction import directed
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.tools.comparisons import SameEntries, SameValue
from workbook.checks.tools.samples import general_values, in_every_case
from workbook.checks.tools.values import numbers_at, uncertainty_at
from workbook.checks.tools.wording import number_text, where_text


@judged(Expressions("parameters", length=lambda data: len(data["unknowns"])))
def least_squares(claims, measured, unknowns, deviations=None, parameters=()):
    """Check the estimate of the unknowns, in their order.

    Can decide when the measured quantities are linear in the unknowns.

    Examples
    --------
    >>> a, b = sp.symbols("a b")
    >>> checks.least_squares([2, 1], [(a, 2), (a + b, 3)], [a, b]).status
    'right'
    >>> checks.least_squares([2.5], [(a, 1), (a, 3)], [a]).status
    'wrong'
    """
    for values in in_every_case(general_values(parameters), claims):
        rows, right_side = _weighted(measured, unknowns, deviations, values)
        true = np.linalg.lstsq(rows, right_side, rcond=None)[0]
        claimed = numbers_at(claims, values, unknowns)
        uncertain = [uncertainty_at(claim, values) for claim in claims]
        if not agree(claimed, true, claims, abs(true).max(), uncertain=uncertain).all():
            residuals = right_side - rows @ claimed.real
            slopes = rows.T @ residuals
            k = int(np.argmax(abs(slopes)))
            raise Wrong(
                "the weighted sum of the squared residuals is "
                f"{number_text(residuals @ residuals)} at your "
                f"estimate{where_text(values)}, and it falls when {unknowns[k]} alone is "
                + directed(f"made {'larger' if slopes[k] > 0 else 'smaller'}", "changed a little")
            )
    return "no other values have a smaller weighted sum of squared residuals"


@judged(Expression("parameters"))
def least_sum_of_squares(claim, measured, unknowns, deviations=None, parameters=()):
    """Check the least value of the weighted sum of the squared residuals.

    Can decide when the measured quantities are linear in the unknowns; parameters get sample
    values.

    Examples
    --------
    >>> a = sp.Symbol("a")
    >>> checks.least_sum_of_squares(2, [(a, 1), (a, 3)], [a]).status
    'right'
    >>> checks.least_sum_of_squares(4, [(a, 1), (a, 3)], [a]).status
    'wrong'
    """
    quantity = "the weighted sum of the squared residuals at the estimate"
    for values in in_every_case(general_values(parameters), claim):
        rows, right_side = _weighted(measured, unknowns, deviations, values)
        residuals = right_side - rows @ np.linalg.lstsq(rows, right_side, rcond=None)[0]
        yield SameValue(claim, residuals @ residuals, quantity, values, right_side @ right_side)
    return "it is the sum at the estimate"


@judged(Matrix("parameters", shape=lambda data: (len(data["unknowns"]),) * 2))
def error_covariance(claim, measured, unknowns, deviations=None, parameters=()):
    """Check the covariance matrix of the errors of the estimate.

    Can decide when the measured quantities are linear in the unknowns; parameters get sample
    values.

    Examples
    --------
    >>> a, b = sp.symbols("a b")
    >>> checks.error_covariance([[1, -1], [-1, 2]], [(a, 2), (a + b, 3)], [a, b]).status
    'right'
    >>> checks.error_covariance([[1, 0], [0, 1]], [(a, 2), (a + b, 3)], [a, b]).status
    'wrong'
    """
    for values in in_every_case(general_values(parameters), claim):
        rows, _ = _weighted(measured, unknowns, deviations, values)
        # Each estimate is a linear combination of the measurements, whose weighted errors are
        # independent with variance 1.
        pseudoinverse = np.linalg.pinv(rows)
        size = abs(pseudoinverse) @ abs(pseudoinverse).T

        def message(claimed, i, j):
            product = f"mean of the product of the errors of {unknowns[i]} and {unknowns[j]}"
            return (
                f"the entry ({i + 1}, {j + 1}) of your matrix is "
                f"{number_text(claimed[i, j])}{where_text(values)}; it is not the "
                + (f"variance of the error of {unknowns[i]}" if i == j else product)
            )

        yield SameEntries(claim, pseudoinverse @ pseudoinverse.T, message, values, size)
    return "these are the variances and covariances of the errors of the estimate"


def _weighted(measured, unknowns, deviations, values):
    """Return rows and right side of the linear equations, divided by the standard deviations."""
    quantities = sp.Matrix([quantity for quantity, *_ in measured])
    constant_terms = quantities.subs(dict.fromkeys(unknowns, 0))
    right_side = sp.Matrix([value for _, value, *_ in measured]) - constant_terms
    counts = [sp.sqrt(*count) if count else 1 for _, _, *count in measured]
    deviations = deviations or [1] * len(measured)
    scale = sp.diag(*[count / sp.sympify(s) for count, s in zip(counts, deviations)])
    rows, right_side = (
        np.array((scale * part).subs(values).evalf(30), dtype=float)
        for part in (quantities.jacobian(unknowns), right_side)
    )
    return rows, right_side[:, 0]
