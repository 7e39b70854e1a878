"""Position fixes from bearings, without iteration (example 2).

e_s x (x - r_s) = 0 is linear in x, the pseudo-measurement e_s x x = e_s x r_s.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import any_floats, read_matrix
from trajlib._typing import Matrix, MatrixLike
from trajlib.estimation.exact_or_float import latex
from trajlib.estimation.fix_observability import cross_matrix
from trajlib.estimation.linear_fit import least_squares


@dataclass(frozen=True)
class BearingFix:
    """Position from bearings.

    Attributes
    ----------
    position : matrix
        Position, 3 components.
    residuals : matrix, shape (S, 3)
        e_s x (x - r_s), zero for exact directions; their length is the distance of x from the line
        of sight.
    ahead : tuple of bool
        For each bearing whether x lies ahead of the observer, not behind, which the cross product
        does not distinguish; None where it depends on symbols.
    """

    position: Matrix
    residuals: Matrix
    ahead: tuple

    def _repr_latex_(self):
        position = (
            sp.Matrix(self.position) if isinstance(self.position, np.ndarray) else self.position
        )
        return rf"$\displaystyle x = {latex(position)}$"


def bearing_fix(observers: MatrixLike, directions: MatrixLike) -> BearingFix:
    """Return the point nearest to all lines of sight, by least squares on pseudo-measurements.

    Parameters
    ----------
    observers : matrix_like, shape (S, 3)
        Positions of the observers by rows; exact or floats.
    directions : matrix_like, shape (S, 3)
        Directions to the target by rows, of any length (they are normalised).

    Returns
    -------
    BearingFix

    Raises
    ------
    ValueError
        If all directions are parallel, so that x is free along the line.

    Notes
    -----
    The estimate is biased, since errors of the directions enter both H and z and are weighted by
    the distance: it is an initial guess for `gauss_newton`. Source: example 2 of the problem book.

    Examples
    --------
    >>> fix = bearing_fix([[0, 0, 0], [4, 0, 0]], [[1, 1, 0], [-1, 1, 0]])
    >>> fix.position.T, fix.ahead
    (Matrix([[2, 2, 0]]), (True, True))
    """
    floats = any_floats(observers, directions)
    positions = read_matrix(observers, "observers", None, 3, floats)
    sights = read_matrix(directions, "directions", positions.shape[0], 3, floats)
    rows, right, units = [], [], []
    for k in range(positions.shape[0]):
        e, r = sights[k, :], positions[k, :]
        length = np.linalg.norm(e) if floats else sp.sqrt(e.dot(e))
        if length == 0:
            raise ValueError(f"directions: the direction of observer {k + 1} is zero")
        units.append(e / length)
        rows.append(cross_matrix(e / length))
        right.append(rows[-1] @ r if floats else rows[-1] * r.T)
    join = np.vstack if floats else (lambda blocks: sp.Matrix.vstack(*blocks))
    H, z = join(rows), np.concatenate(right) if floats else join(right)
    try:
        fit = least_squares(H, z)
    except ValueError:
        raise ValueError(
            "directions: all of them are parallel, so the position is free along them; measure "
            "from a point off this line"
        ) from None
    x = fit.estimate
    residuals = (
        -fit.residuals.reshape(-1, 3)
        if floats
        else sp.Matrix(positions.rows, 3, list(-fit.residuals))
    )
    ahead = []
    for e, k in zip(units, range(positions.shape[0])):
        component = (
            e @ (x - positions[k]) if floats else sp.simplify((x.T - positions[k, :]).dot(e))
        )
        sign = bool(component > 0) if floats else component.is_positive
        ahead.append(sign)
    return BearingFix(x, residuals, tuple(ahead))
