"""Position fixes from ranges to satellites and from bearings, without iteration.

Ranges (example 1): 2 r_s^T x = r_s^2 + x^2 - rho_s^2 is linear in x once the number X = x^2 is
known. Least squares give x = (u + X v)/2 with

    u = G^-1 sum r_s (r_s^2 - rho_s^2),    v = G^-1 sum r_s,    G = sum r_s r_s^T

and x^2 = X becomes v^2 X^2 + (2 u v - 4) X + u^2 = 0: two roots. With three satellites both
reproduce the ranges (the position and its mirror image in the plane of the satellites); with more
they differ in their residuals.

Bearings (example 2): e_s x (x - r_s) = 0 is linear in x, the pseudo-measurement e_s x x = e_s x
r_s.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._typing import ArrayLike, Matrix, MatrixLike
from trajlib.estimation.arguments import in_floats, read_matrix, read_vector
from trajlib.estimation.exact_or_float import latex, tidy
from trajlib.estimation.linear_fit import least_squares
from trajlib.stability.systems import as_prose
from trajlib.structure import exact


@dataclass(frozen=True)
class FixTest:
    """Local observability of a position from measurements; true in an `if` if it is observable.

    With symbols all this holds for general values.

    Attributes
    ----------
    rank : int
        Rank of the equations for a small displacement, 3 if the position is observable.
    unobservable : matrix, shape (3, 3 - rank)
        Displacements, by columns, that change no measurement to first order.
    reason : str
        Verdict in words.
    """

    rank: int
    unobservable: Matrix
    reason: str

    def __bool__(self):
        return self.rank == 3

    def _repr_markdown_(self):
        return as_prose(self.reason)


def satellite_observability(position: MatrixLike, satellites: MatrixLike) -> FixTest:
    """Decide whether ranges from satellites determine a position locally.

    Parameters
    ----------
    position : matrix_like
        Position, 3 components; exact or floats.
    satellites : matrix_like, shape (S, 3)
        Positions of the satellites by rows, in the same units and axes.

    Returns
    -------
    FixTest

    Notes
    -----
    The Jacobian is regular if and only if the points x, r_1, ..., r_S do not lie in one plane.
    Source: problem 4.1, read for points; the vectors from the origin, as printed, do not decide it.

    Examples
    --------
    >>> flat = [[1, 0, 1], [0, 1, 1], [-1, 0, 1]]
    >>> bool(satellite_observability([0, 0, 1], flat)), bool(satellite_observability([0, 0, 0], flat))
    (False, True)
    """
    x, points = _read_positions(position, satellites, "satellites")
    return _fix_test(
        _row_differences(points, x),
        "the position and the satellites lie in one plane",
        "the position and the satellites do not lie in one plane",
    )


def bearing_observability(position: MatrixLike, observers: MatrixLike) -> FixTest:
    """Decide whether bearings from several observers determine the position of a fixed target.

    Parameters
    ----------
    position : matrix_like
        Position of the target, 3 components; exact or floats.
    observers : matrix_like, shape (S, 3)
        Positions of the observers by rows.

    Returns
    -------
    FixTest

    Raises
    ------
    ValueError
        If the target is at the position of an observer.

    Notes
    -----
    The position is observable if and only if the target and the observers do not lie on one line.
    Source: example 2 and problem 4.3 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> v, t = sp.symbols("v t", positive=True)
    >>> bool(bearing_observability([0, 0, 5], [[0, 0, 0], [v*t, 0, 0]]))    # uniform motion past the target
    True
    >>> bearing_observability([5, 0, 0], [[0, 0, 0], [v*t, 0, 0]]).unobservable.T   # and towards it
    Matrix([[1, 0, 0]])
    """
    x, observer_positions = _read_positions(position, observers, "observers")
    directions = _row_differences(observer_positions, x)
    for k in range(directions.shape[0]):
        if not any(directions[k, :]):
            raise ValueError(
                f"position: it is that of observer {k + 1}, from which it has no bearing"
            )
    cross_products = [_cross(-directions[k, :]) for k in range(directions.shape[0])]
    rows = (
        np.vstack(cross_products)
        if isinstance(directions, np.ndarray)
        else sp.Matrix.vstack(*cross_products)
    )
    return _fix_test(
        rows,
        "the target and the observers lie on one line",
        "the target and the observers do not lie on one line",
    )


def _read_positions(position, points, name):
    floats = in_floats(position, points)
    return read_vector(position, "position", 3, floats), read_matrix(points, name, None, 3, floats)


def _row_differences(points, x):
    return points - x if isinstance(points, np.ndarray) else points - sp.ones(points.rows, 1) * x.T


def _fix_test(rows, unobservable_reason, observable_reason):
    if isinstance(rows, np.ndarray):
        lengths = np.linalg.norm(rows, axis=1)
        _, values, Vt = np.linalg.svd(rows / np.where(lengths > 0, lengths, 1)[:, None])
        rank = int((values > max(rows.shape) * np.finfo(float).eps * values[0]).sum())
        unobservable = Vt[rank:].T
    else:
        unobservable = exact.null_columns(rows)
        rank = 3 - unobservable.cols
    restriction = (
        " for general values of the symbols"
        if not isinstance(rows, np.ndarray) and rows.free_symbols
        else ""
    )
    return FixTest(
        rank,
        unobservable,
        f"determined{restriction}: {observable_reason}"
        if rank == 3
        else f"not determined{restriction}: {unobservable_reason}",
    )


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
        target = np.array(guess, dtype=float).reshape(-1)
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
    floats = in_floats(satellites, squared_ranges)
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
        differences = _row_differences(points, x)
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
        return len(points) < 3 or values[-1] <= len(points) * np.finfo(float).eps * values[0]
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
    floats = in_floats(observers, directions)
    positions = read_matrix(observers, "observers", None, 3, floats)
    sights = read_matrix(directions, "directions", positions.shape[0], 3, floats)
    rows, right, units = [], [], []
    for k in range(positions.shape[0]):
        e, r = sights[k, :], positions[k, :]
        length = np.linalg.norm(e) if floats else sp.sqrt(e.dot(e))
        if length == 0:
            raise ValueError(f"directions: the direction of observer {k + 1} is zero")
        units.append(e / length)
        rows.append(_cross(e / length))
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


def _cross(e):
    """Return the matrix of x -> e x x."""
    e1, e2, e3 = e
    rows = [[0, -e3, e2], [e3, 0, -e1], [-e2, e1, 0]]
    return np.array(rows) if isinstance(e, np.ndarray) else sp.Matrix(rows)
