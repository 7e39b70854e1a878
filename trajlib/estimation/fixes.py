"""Positions from ranges to satellites and from bearings, without iteration; examples 1 and 2 of the
chapter.

Ranges: 2 r_s^T x = r_s^2 + x^2 - rho_s^2 is linear in x once the number X = x^2 is known. Least
squares give x = (u + X v)/2 with

    u = G^-1 sum r_s (r_s^2 - rho_s^2),    v = G^-1 sum r_s,    G = sum r_s r_s^T

and x^2 = X becomes v^2 X^2 + (2 u v - 4) X + u^2 = 0: two roots. With three satellites both
reproduce the ranges (the position and its mirror image in the plane of the satellites); with more
the residuals tell them apart.

Bearings: e_s x (x - r_s) = 0 is linear in x, the pseudo-measurement e_s x x = e_s x r_s.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import any_floats, read_matrix, read_vector
from trajlib.estimation.exact_or_float import latex, tidy
from trajlib.estimation.linear_fit import least_squares
from trajlib.structure import exact
from trajlib.typesetting import escape_markdown


@dataclass(frozen=True)
class FixTest:
    """Whether measurements determine a position locally; true in an `if` if they do.

    `rank`: of the equations for a small displacement, 3 if they do; `unseen`: displacements, by
    columns, that change no measurement to first order (3 x 0 if there are none); `reason`: the
    verdict in words. With symbols all this is for general values.
    """

    rank: int
    unseen: object
    reason: str

    def __bool__(self):
        return self.rank == 3

    def _repr_markdown_(self):
        return escape_markdown(self.reason)


def satellite_observability(position, satellites):
    """Do the ranges from the satellites determine the position, at least locally?

    `position`: 3 numbers, `satellites`: S x 3, a row for each, in the same units and axes; exact or
    floats. Returns `FixTest`: they do, with a regular Jacobian, if and only if the points x, r_1,
    ..., r_S do not lie in one plane. Source: problem 4.1, read for points; the vectors from the
    origin, as printed, do not decide it.

    >>> flat = [[1, 0, 1], [0, 1, 1], [-1, 0, 1]]
    >>> bool(satellite_observability([0, 0, 1], flat)), bool(satellite_observability([0, 0, 0], flat))
    (False, True)
    """
    x, points = _read(position, satellites, "satellites")
    return _test(
        _differences(points, x),
        "the position and the satellites lie in one plane",
        "the position and the satellites do not lie in one plane",
    )


def bearing_observability(position, observers):
    """Do the bearings to a fixed target from the observers' places determine its position?

    `position`: 3 numbers, the target; `observers`: S x 3, a row for each place; exact or floats.
    Returns `FixTest`: they do if and only if the target and the places do not lie on one line.
    Raises ValueError if the target stands where an observer is. Source: example 2 and problem 4.3
    of the problem book.

    >>> import sympy as sp
    >>> v, t = sp.symbols("v t", positive=True)
    >>> bool(bearing_observability([0, 0, 5], [[0, 0, 0], [v*t, 0, 0]]))    # uniform motion past the target
    True
    >>> bearing_observability([5, 0, 0], [[0, 0, 0], [v*t, 0, 0]]).unseen.T   # and towards it
    Matrix([[1, 0, 0]])
    """
    x, places = _read(position, observers, "observers")
    toward = _differences(places, x)
    for k in range(toward.shape[0]):
        if not any(toward[k, :]):
            raise ValueError(
                f"position: it is the place of observer {k + 1}, from where it has no bearing"
            )
    blocks = [_cross(-toward[k, :]) for k in range(toward.shape[0])]
    rows = np.vstack(blocks) if isinstance(toward, np.ndarray) else sp.Matrix.vstack(*blocks)
    return _test(
        rows,
        "the target and the observers lie on one line",
        "the target and the observers do not lie on one line",
    )


def _read(position, points, name):
    floats = any_floats(position, points)
    return read_vector(position, "position", 3, floats), read_matrix(points, name, None, 3, floats)


def _differences(points, x):
    return points - x if isinstance(points, np.ndarray) else points - sp.ones(points.rows, 1) * x.T


def _test(rows, lost, kept):
    if isinstance(rows, np.ndarray):
        lengths = np.linalg.norm(rows, axis=1)
        _, values, Vt = np.linalg.svd(rows / np.where(lengths > 0, lengths, 1)[:, None])
        rank = int((values > max(rows.shape) * np.finfo(float).eps * values[0]).sum())
        unseen = Vt[rank:].T
    else:
        unseen = exact.null_columns(rows)
        rank = 3 - unseen.cols
    general = (
        " for general values of the symbols"
        if not isinstance(rows, np.ndarray) and rows.free_symbols
        else ""
    )
    return FixTest(
        rank,
        unseen,
        f"determined{general}: {kept}" if rank == 3 else f"not determined{general}: {lost}",
    )


@dataclass(frozen=True)
class SatelliteFix:
    """The positions that ranges leave; true in an `if` if there is one.

    `roots`: positions, none, one or two, the better first (as columns, for floats flat arrays);
    `residuals`: for each the S numbers rho'_s^2 - |r_s - x|^2; `misfits`: their sums of squares;
    `reason`: in words what there is.
    """

    roots: tuple
    residuals: tuple
    misfits: tuple
    reason: str

    def __bool__(self):
        return bool(self.roots)

    def nearest(self, guess):
        """The root that is nearest to a guess (3 numbers). Raises ValueError if there is none."""
        if not self.roots:
            raise ValueError(f"roots: {self.reason}")
        place = np.array(guess, dtype=float).reshape(-1)
        return min(
            self.roots,
            key=lambda x: np.linalg.norm(np.array(x.tolist(), dtype=float).reshape(-1) - place),
        )

    def _repr_latex_(self):
        shown = [sp.Matrix(x) if isinstance(x, np.ndarray) else x for x in self.roots]
        return (
            r"$\displaystyle \begin{gathered}"
            + r",\quad ".join(map(latex, shown))
            + rf" \\ \text{{({self.reason})}}\end{{gathered}}$"
        )


def satellite_fix(satellites, squared_ranges):
    """Both positions that solve the range equations by least squares with x^2 as an unknown of its
    own.

    `satellites`: S x 3, a row for each; `squared_ranges`: S numbers, the squares rho'_s^2 of the
    measured ranges (unit of length squared). Exact or floats. Returns `SatelliteFix`; it has no
    roots where noise makes both complex. The estimate minimises the residuals of the squares only
    for S = 3 or ranges without error: else take it as the start of `gauss_newton`. Raises
    ValueError if the vectors r_s lie in one plane with the origin, so that G is singular (put the
    origin elsewhere, or measure to more satellites). Source: example 1; in the printed quadratic
    equation a_1 lacks the factor 2 before its first term.

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
    if _in_a_plane(points):
        raise ValueError(
            "satellites: their vectors lie in one plane with the origin, so the squares of the "
            "ranges do not give x; choose the origin elsewhere, or measure to more satellites"
        )
    # Both by least squares on 2 r_s^T x = ..., once for the data and once for the share of X.
    ones = np.ones(len(points)) if floats else sp.ones(points.rows, 1)
    u, v = (least_squares(points, right).estimate for right in (lengths - squares, ones))
    found = _quadratic(_dot(v, v), 2 * _dot(u, v) - 4, _dot(u, u))
    fixes = []
    for X in found:
        x = tidy((u + X * v) / 2)
        gaps = _differences(points, x)
        ranges = (
            (gaps**2).sum(axis=1)
            if floats
            else sp.Matrix([gaps[k, :].dot(gaps[k, :]) for k in range(gaps.rows)])
        )
        residuals = tidy(squares - ranges)
        fixes.append((x, residuals, _square(residuals)))
    known = not any(getattr(misfit, "free_symbols", ()) for _, _, misfit in fixes)
    if known:
        fixes.sort(key=lambda fix: float(fix[2]))
    reason = {
        0: "no position: the errors of the ranges make both roots complex",
        1: "one position",
        2: "two positions, the one with the smaller residuals first"
        if points.shape[0] > 3
        else "two positions, mirror images in the plane of the satellites, which three ranges do not tell apart",
    }
    return (
        SatelliteFix(*(tuple(column) for column in zip(*fixes)), reason=reason[len(fixes)])
        if fixes
        else (SatelliteFix((), (), (), reason[0]))
    )


def _in_a_plane(points):
    if isinstance(points, np.ndarray):
        values = np.linalg.svd(points / np.linalg.norm(points, axis=1).max(), compute_uv=False)
        return len(points) < 3 or values[-1] <= len(points) * np.finfo(float).eps * values[0]
    return exact.rank(points) < 3


def _dot(u, v):
    return u @ v if isinstance(u, np.ndarray) else tidy(u.T * v)[0, 0]


def _square(residuals):
    return (
        float(residuals @ residuals)
        if isinstance(residuals, np.ndarray)
        else tidy(residuals.T * residuals)[0, 0]
    )


def _quadratic(a, b, c):
    """Real roots, in floats without loss of digits; those of a quadratic with symbols as if they
    were real."""
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
    """A position from bearings.

    `position`: 3 components; `residuals`: S x 3, e_s x (x - r_s), for exact directions 0; their
    length is the distance of x from the line of sight; `ahead`: for each bearing whether x lies
    ahead of the observer, not behind, which the cross product does not see (None where symbols
    leave it open).
    """

    position: object
    residuals: object
    ahead: tuple

    def _repr_latex_(self):
        shown = sp.Matrix(self.position) if isinstance(self.position, np.ndarray) else self.position
        return rf"$\displaystyle x = {latex(shown)}$"


def bearing_fix(observers, directions):
    """The point nearest to all lines of sight, in the sense of least squares, from
    pseudo-measurements.

    `observers`: S x 3, a row for each place; `directions`: S x 3, the directions to the target, of
    any length (they are made unit vectors). Exact or floats. The estimate is biased, since errors
    of the directions stand in H and in z and weigh with the distance: it is a start for
    `gauss_newton`. Returns `BearingFix`. Raises ValueError if all directions are parallel: then x
    is free along the line. Source: example 2 of the problem book.

    >>> fix = bearing_fix([[0, 0, 0], [4, 0, 0]], [[1, 1, 0], [-1, 1, 0]])
    >>> fix.position.T, fix.ahead
    (Matrix([[2, 2, 0]]), (True, True))
    """
    floats = any_floats(observers, directions)
    places = read_matrix(observers, "observers", None, 3, floats)
    toward = read_matrix(directions, "directions", places.shape[0], 3, floats)
    rows, right, units = [], [], []
    for k in range(places.shape[0]):
        e, r = toward[k, :], places[k, :]
        length = np.linalg.norm(e) if floats else sp.sqrt(e.dot(e))
        if length == 0:
            raise ValueError(f"directions: the direction of observer {k + 1} is zero")
        units.append(e / length)
        rows.append(_cross(e / length))
        right.append(rows[-1] @ r if floats else rows[-1] * r.T)
    joined = np.vstack if floats else (lambda blocks: sp.Matrix.vstack(*blocks))
    H, z = joined(rows), np.concatenate(right) if floats else joined(right)
    try:
        found = least_squares(H, z)
    except ValueError:
        raise ValueError(
            "directions: all of them are parallel, so the position is free along them; measure "
            "from a place off this line"
        ) from None
    x = found.estimate
    residuals = (
        -found.residuals.reshape(-1, 3)
        if floats
        else sp.Matrix(places.rows, 3, list(-found.residuals))
    )
    ahead = []
    for e, k in zip(units, range(places.shape[0])):
        along = e @ (x - places[k]) if floats else sp.simplify((x.T - places[k, :]).dot(e))
        sign = bool(along > 0) if floats else along.is_positive
        ahead.append(sign)
    return BearingFix(x, residuals, tuple(ahead))


def _cross(e):
    """The matrix of x -> e x x."""
    e1, e2, e3 = e
    rows = [[0, -e3, e2], [e3, 0, -e1], [-e2, e1, 0]]
    return np.array(rows) if isinstance(e, np.ndarray) else sp.Matrix(rows)
