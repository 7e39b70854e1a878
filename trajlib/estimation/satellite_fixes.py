"""Position fixes from ranges to satellites, without iteration (example 1).

2 r_s^T x = r_s^2 + x^2 - rho_s^2 is linear in x once the number X = x^2 is known. Least squares
give x = (u + X v)/2 with

    u = G^-1 sum r_s (r_s^2 - rho_s^2),    v = G^-1 sum r_s,    G = sum r_s r_s^T

and x^2 = X becomes v^2 X^2 + (2 u v - 4) X + u^2 = 0: two roots. With three satellites both
reproduce the ranges (the position and its mirror image in the plane of the satellites); with more
they differ in their residuals.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import any_floats, read_matrix, read_vector
from trajlib._numerical_rank import zero_level
from trajlib._typing import ArrayLike, Matrix, MatrixLike
from trajlib.estimation.exact_or_float import latex, tidy
from trajlib.estimation.fix_observability import row_differences
from trajlib.estimation.linear_fit import least_squares
from trajlib.structure import exact


@dataclass(frozen=True)
class SatelliteFix:
    """Positions that agree with measured ranges; true in an `if` if there is one.

    Attributes
    ----------
    roots : tuple of matrix
        Positions, none, one or two, the better first (columns; for floats flat arrays).
    residuals : tuple of matrix
        For each the S numbers rho'_s^2 - |r_s - x|^2.
    misfits : tuple of scalar
        Their sums of squares.
    reason : str
        Number of positions and their relation, in words.
    """

    roots: tuple
    residuals: tuple
    misfits: tuple
    reason: str

    def __bool__(self):
        return bool(self.roots)

    def nearest(self, guess: ArrayLike) -> Matrix:
        """Return the root nearest to a guess.

        Parameters
        ----------
        guess : array_like
            Approximate position, 3 numbers.

        Returns
        -------
        matrix

        Raises
        ------
        ValueError
            If there is no root.
        """
        if not self.roots:
            raise ValueError(f"roots: {self.reason}")
        target = read_vector(guess, "guess", 3, True)
        return min(
            self.roots,
            key=lambda x: np.linalg.norm(np.array(x.tolist(), dtype=float).reshape(-1) - target),
        )

    def _repr_latex_(self):
        roots = [sp.Matrix(x) if isinstance(x, np.ndarray) else x for x in self.roots]
        return (
            r"$\displaystyle \begin{gathered}"
            + r",\quad ".join(map(latex, roots))
            + rf" \\ \text{{({self.reason})}}\end{{gathered}}$"
        )


def satellite_fix(satellites: MatrixLike, squared_ranges: MatrixLike) -> SatelliteFix:
    """Return the positions that solve the range equations, with x^2 as a separate unknown.

    Parameters
    ----------
    satellites : matrix_like, shape (S, 3)
        Positions of the satellites by rows; exact or floats.
    squared_ranges : matrix_like
        Squares rho'_s^2 of the S measured ranges, in the unit of length squared.

    Returns
    -------
    SatelliteFix
        It has no roots where noise makes both complex.

    Raises
    ------
    ValueError
        If the vectors r_s lie in one plane with the origin, so that G is singular (choose another
        origin or more satellites).

    Notes
    -----
    The estimate minimises the residuals of the squares only for S = 3 or ranges without error;
    otherwise take it as the initial guess of `gauss_newton`. Source: example 1; in the printed
    quadratic equation a_1 lacks the factor 2 before its first term.

    Examples
    --------
    >>> fix = satellite_fix([[2, 0, 0], [0, 2, 0], [0, 0, 2]], [3, 3, 3])    # of (1, 1, 1) ...
    >>> fix.roots[0].T, fix.roots[1].T                                  # ... and its image in the satellites' plane
    (Matrix([[1/3, 1/3, 1/3]]), Matrix([[1, 1, 1]]))
    """
    floats = any_floats(satellites, squared_ranges)
    points = read_matrix(satellites, "satellites", None, 3, floats)
    squares = read_vector(squared_ranges, "squared_ranges", points.shape[0], floats)
    if any(square < 0 if floats else square.is_negative for square in squares):
        raise ValueError("squared_ranges: expected numbers that are not negative")
    lengths = (
        (points**2).sum(axis=1)
        if floats
        else sp.Matrix([points[k, :].dot(points[k, :]) for k in range(points.rows)])
    )
    if _is_coplanar(points):
        raise ValueError(
            "satellites: their vectors lie in one plane with the origin, so the squares of the "
            "ranges do not give x; choose the origin elsewhere, or measure to more satellites"
        )
    # Both by least squares on 2 r_s^T x = ..., for the data and for the coefficient of X.
    ones = np.ones(len(points)) if floats else sp.ones(points.rows, 1)
    u, v = (least_squares(points, right).estimate for right in (lengths - squares, ones))
    squared_norms = _quadratic(_dot(v, v), 2 * _dot(u, v) - 4, _dot(u, u))
    fixes = []
    for X in squared_norms:
        x = tidy((u + X * v) / 2)
        differences = row_differences(points, x)
        ranges = (
            (differences**2).sum(axis=1)
            if floats
            else sp.Matrix(
                [differences[k, :].dot(differences[k, :]) for k in range(differences.rows)]
            )
        )
        residuals = tidy(squares - ranges)
        fixes.append((x, residuals, _squared_norm(residuals)))
    numeric = not any(getattr(misfit, "free_symbols", ()) for _, _, misfit in fixes)
    if numeric:
        fixes.sort(key=lambda fix: float(fix[2]))
    reason = {
        0: "no position: the errors of the ranges make both roots complex",
        1: "one position",
        2: "two positions, the one with the smaller residuals first"
        if points.shape[0] > 3
        else "two positions, mirror images in the plane of the satellites, which three ranges do not tell apart",
    }
    if not fixes:
        return SatelliteFix((), (), (), reason[0])
    roots, residuals, misfits = (tuple(column) for column in zip(*fixes))
    return SatelliteFix(roots, residuals, misfits, reason[len(fixes)])


def _is_coplanar(points):
    if isinstance(points, np.ndarray):
        values = np.linalg.svd(points / np.linalg.norm(points, axis=1).max(), compute_uv=False)
        return len(points) < 3 or values[-1] <= zero_level(*points.shape) * values[0]
    return exact.rank(points) < 3


def _dot(u, v):
    return u @ v if isinstance(u, np.ndarray) else tidy(u.T * v)[0, 0]


def _squared_norm(residuals):
    return (
        float(residuals @ residuals)
        if isinstance(residuals, np.ndarray)
        else tidy(residuals.T * residuals)[0, 0]
    )


def _quadratic(a, b, c):
    """Return the real roots, in floats without cancellation; with symbols roots taken as real."""
    if a == 0:
        return [-c / b]
    discriminant = b * b - 4 * a * c
    if isinstance(a, sp.Basic):
        discriminant = sp.factor(discriminant)
        if discriminant.is_negative:
            return []
        root = sp.sqrt(discriminant)
        return [(-b - root) / (2 * a)] + ([(-b + root) / (2 * a)] if discriminant != 0 else [])
    if discriminant < 0:
        return []
    q = -(b + np.copysign(np.sqrt(discriminant), b)) / 2
    return [q / a, c / q] if q != 0 and discriminant > 0 else [-b / (2 * a)]
