"""Analysis of solvability by singular values that are larger than their own errors.

Let A = W^{-1/2} Htilde D^{-1} and let the computed A be wrong by an unknown matrix whose norm is at
most delta. Singular values move by no more than delta, and rounding in their computation moves them
by no more than s_max/mu*. So each computed value above

    level = delta + s_max/mu*

belongs to a true one that is not zero: their number is a guaranteed rank. With delta = 0 all m
values are above the level if and only if mu < mu*, the condition of the paper.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trajlib._arguments.arrays import read_array
from trajlib._arguments.numbers import read_names, read_numeric_matrix
from trajlib._typing import ArrayLike
from trajlib.solvability import rounding
from trajlib.solvability.result import Solvability
from trajlib.solvability.variational import Linearisation
from trajlib.solvability.weights import Weights


def analyse(
    matrix: ArrayLike | Linearisation,
    W: ArrayLike | None = None,
    *,
    eps: float | None = None,
    scale: bool = True,
    matrix_error: ArrayLike | None = None,
    names: Sequence | None = None,
    units: Sequence | None = None,
) -> Solvability:
    """Return the analysis of the system Z = Htilde x + e before it is solved.

    Parameters
    ----------
    matrix : array_like or Linearisation, shape (n, m)
        Htilde, or a `Linearisation`, whose error estimates, names and units are then used.
    W : array_like, optional
        Covariance of e: n variances, a symmetric positive definite matrix (n, n), or k blocks (k,
        r, r) of its diagonal; unit variances if left out.
    eps : float, optional
        Relative precision of the floats.
    scale : bool
        Whether columns are scaled to norm 1.
    matrix_error : array_like, optional
        Bounds on the errors of the entries, an array like `matrix`, or a number relative to the
        largest entry of each column; left out, the matrix is exact.
    names, units : sequence of str, optional
        Names and units of the unknowns.

    Returns
    -------
    Solvability

    Raises
    ------
    ValueError
        If there are fewer measurements than unknowns, a column is zero, or arguments do not fit.

    Notes
    -----
    MATLAB: ``svd``, ``cond``, ``rank``.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.linspace(0, 1, 20)
    >>> print(analyse(np.stack([np.ones(20), t, 1 + t], axis=1), names=["a", "b", "c"]))      # doctest: +ELLIPSIS
    3 unknowns, 20 scalar measurements; ...
    Not shown to be solvable: 2 of 3 singular values are above ...
    Cannot be told from zero: c by 1 together with a by -1, b by -1.
    Determined by themselves: none of the unknowns.
    """
    if hasattr(matrix, "Phi"):
        names, units = names or matrix.names, units or matrix.units
        matrix_error = matrix.error if matrix_error is None else matrix_error
        matrix = matrix.matrix
    matrix = read_numeric_matrix(matrix, "matrix")
    n, m = matrix.shape
    names, units = read_names(names, m), read_names(units, m, "units")
    if m == 0:
        raise ValueError("matrix: it has no columns, so there is nothing to determine")
    if n < m:
        raise ValueError(
            f"matrix: {n} scalar measurements for {m} unknowns; in any case {m - n} "
            "combinations stay free. Take more measurements or fewer unknowns"
        )
    zero = [name for name, column in zip(names, matrix.T) if not column.any()]
    if zero:
        raise ValueError(
            f"matrix: the column of {', '.join(zero)} is zero: no measurement ever sees it. Leave "
            "it out, or measure something else"
        )
    eps = rounding.EPS if eps is None else float(eps)
    weights = Weights(W, n)
    weighted = weights.apply(matrix)
    # norms by columns of size 1, so that their squares neither overflow nor vanish
    largest = np.abs(weighted).max(axis=0)
    if not (np.isfinite(largest).all() and (largest > 0).all()):
        raise ValueError(
            "matrix: its weighted entries are too large or too small for machine numbers; change "
            "the units"
        )
    norms = largest * np.linalg.norm(weighted / largest, axis=0)
    entry_errors = _entry_errors(matrix_error, matrix)
    scaled = weighted / norms
    scaling = norms if scale else np.full(m, norms.max())
    errors = weights.apply_absolute(entry_errors) / scaling
    # reflections first: what follows is done with m x m matrices, and columns may be scaled before
    # or after
    triangle = np.linalg.qr(scaled, mode="r")
    values, directions = np.linalg.svd(triangle * (norms / scaling))[1:]
    return Solvability(
        n,
        m,
        eps,
        _condition(triangle * (norms / norms.max())),
        _condition(triangle),
        rounding.threshold(m, n, eps),
        values,
        directions.T,
        scaling,
        float(np.linalg.norm(errors)),
        names,
        units,
        weighted / scaling,
        weights,
        entry_errors,
    )


def _entry_errors(error, matrix):
    if error is None:
        return np.zeros_like(matrix)
    error = read_array(error, "matrix_error", "errors as numbers")
    if not (np.isfinite(error).all() and (error >= 0).all()):
        raise ValueError("matrix_error: expected finite numbers, zero or positive")
    if error.ndim == 0:
        return np.broadcast_to(error * np.abs(matrix).max(axis=0), matrix.shape)
    if error.shape != matrix.shape:
        raise ValueError(
            f"matrix_error: expected a number or an array of shape {matrix.shape}, got shape "
            f"{error.shape}"
        )
    return error


def _condition(matrix):
    values = np.linalg.svd(matrix, compute_uv=False)
    return float(values[0] / values[-1]) if values[-1] > 0 else np.inf
