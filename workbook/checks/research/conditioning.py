"""Condition numbers of systems of measurements, and bounds on the errors of their solutions."""

import math

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression, Expressions, Integer
from workbook.checks.contract.direction import directed
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.values import value_at


@judged(Expressions(length=lambda data: data["matrix"].rows))
def bound_violating_error(claim, matrix, state, factor):
    """Check a measurement error e that violates the bound mu |e| |x|/|Z| of |dx|.

    With it |dx| exceeds the bound at least `factor` times; Z = H x + e.
    """
    e = np.array([float(coercion.as_number(part)) for part in claim])
    H, x = np.array(matrix.tolist(), dtype=float), np.array([float(part) for part in state])
    if not np.abs(e).max() > 0:
        raise Wrong("without an error nothing is wrong: both sides are zero")
    values = np.linalg.svd(H, compute_uv=False)
    error_norm = np.linalg.norm(np.linalg.lstsq(H, e, rcond=None)[0])
    bound = (
        values[0] / values[-1] * np.linalg.norm(e) / np.linalg.norm(H @ x + e) * np.linalg.norm(x)
    )
    if not error_norm >= float(factor) * bound * (1 - 1e-9):
        raise Wrong(
            f"the estimate is wrong by {error_norm:.4g} and the printed bound is {bound:.4g}: it is "
            f"exceeded {error_norm / bound:.3g} times, not {float(factor):g} times"
        )
    return "the estimate is wrong by more than the printed bound, as many times as was asked"


@judged(Integer())
def greatest_row_count(n, m, mu, eps):
    """Check the greatest number n of rows with a condition number mu below the threshold mu*."""
    m, mu, eps = int(m), sp.Rational(mu), sp.Rational(eps)
    if n < m:
        raise Wrong(f"{n} rows are fewer than the {m} unknowns")

    def threshold(rows):
        return 1 / ((sp.sqrt(m) * (2 * m - 3) * (4 * rows + 27) + 11) * eps)

    for rows, is_below in ((n, True), (n + 1, False)):
        if bool(mu < threshold(rows)) != is_below:
            raise Wrong(
                directed(
                    f"{rows} rows are {'too many' if is_below else 'still not too many'} for the "
                    "threshold",
                    f"{n} is not the greatest number of rows for the threshold",
                )
            )
    return (
        "with this many rows the condition number is below the threshold, with one more it is not"
    )


@judged(Expression("delta"))
def nearly_dependent_condition_number(claim, delta):
    """Check the condition number of two columns along h and h + delta g.

    The columns have the length 1; h and g are perpendicular unit vectors.

    Can decide always: small and large errors are tried.

    Examples
    --------
    >>> e = sp.Symbol("delta", positive=True)
    >>> checks.research.nearly_dependent_condition_number((1 + sp.sqrt(1 + e**2))/e, e).status
    'right'
    >>> checks.research.nearly_dependent_condition_number(1/e, e).status
    'wrong'
    """
    for size in (1.0, 0.3, 0.04, 0.003, 2.5, 9.0):
        yield SameValue(claim, _condition_number(size), "the condition number", {delta: size})
    return "it is the ratio of the singular values, for small and large errors"


@judged(Expression("M"))
def dependence_hiding_error(claim, M):
    """Check the error of a column from which on the condition number is below M.

    The column is a multiple of another one.
    """
    for limit in (1.5, 4.0, 30.0, 1e3, 1e5):
        size = value_at(claim, {M: limit}, "the error")
        if size <= 0:
            raise Wrong(f"for M = {limit:g} your error {size:.4g} is not positive")
        number = _condition_number(size)
        if not abs(number - limit) <= 1e-6 * limit:
            raise Wrong(f"for M = {limit:g} your error gives the condition number {number:.6g}")
    return "with this error the condition number is just M, for small and large M"


def _condition_number(size):
    """Return the condition number of two columns of length 1, along h and h + size g."""
    columns = np.array([[1, 1 / math.hypot(1, size)], [0, size / math.hypot(1, size)]])
    values = np.linalg.svd(columns, compute_uv=False)
    return values[0] / values[-1]
