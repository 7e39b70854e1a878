"""Arrays of convex polygons by their support values on m fixed normals.

The normals are n_i = (sin, cos)(2 pi (i - 1)/m), i = 1 ... m, counted from the y axis clockwise as
headings are. A polygon is {p: n_i p <= rho_i}. Its values are tight if rho_i is the largest n_i p
over the polygon itself, for all i. Unions (their hulls), shifts and sums of tight values are tight.
The smaller values of two polygons need not be: the sides that no longer touch are moved in. By the
duality of linear programming the largest n_i p is

    min alpha rho_j + beta rho_k    over all j, k with n_i = alpha n_j + beta n_k, alpha, beta >= 0,

since a basic solution of the dual has two numbers that are not zero. By Farkas' lemma the polygon
is empty if and only if h(-n_l) + rho_l < 0 for some l, where h(-n_l) is the same minimum for the
direction -n_l.

An empty polygon has all values -inf, which is right for maxima, sums and minima. Rounding is always
outwards: the result of `intersect` contains the intersection.
"""

from __future__ import annotations

import numpy as np

from trajlib._arguments.arrays import read_array
from trajlib._arguments.numbers import read_points
from trajlib._typing import ArrayLike

EPS = float(np.finfo(float).eps)
#: Relative error of a computed alpha rho_j + beta rho_k, in units of EPS: four for a quotient of
#: sines, three for product and sum.
ROUNDINGS = 8


def normals(m):
    """Return the m unit normals, shape (m, 2); those along the axes are exact."""
    angle = 2 * np.pi * np.arange(m) / m
    n = np.stack([np.sin(angle), np.cos(angle)], axis=-1)
    return np.where(np.abs(n) < EPS, 0.0, n)


class SupportPolygons:
    """Array of convex polygons with sides on m fixed normals.

    Parameters
    ----------
    values : array_like, shape (..., m)
        Support values in the unit of the plane, m >= 3: n_i p <= values[..., i] on the normals n_i
        = (sin, cos)(2 pi i/m). They need not be tight, and are made so; polygons without a point
        become `empty`.

    Attributes
    ----------
    values : ndarray, shape (..., m)
        Tight support values.

    Raises
    ------
    ValueError
        If there are fewer than three normals or a value is nan or infinite.

    Notes
    -----
    MATLAB: ``polyshape``, for a single polygon. Source: sections 3.2 to 3.4 of the paper; (3.6) in
    the form of `trajlib.infosets.polygons`, which has no branches.

    Examples
    --------
    >>> square = SupportPolygons([1.0, 1.0, 1.0, 1.0])                    # |x| <= 1, |y| <= 1
    >>> both = square.intersect(square.shift([1.5, 0.0]))
    >>> round(float(both.area), 12), bool(square.intersect(square.shift([2.1, 0.0])).empty)
    (1.0, True)
    >>> square.hull(square.shift([1.5, 0.0])).values.tolist()
    [1.0, 2.5, 1.0, 1.0]
    """

    def __init__(self, values: np.ndarray) -> None:
        values = read_array(values, "values", "numbers")
        if values.ndim == 0 or values.shape[-1] < 3:
            raise ValueError(
                "values: expected shape (..., m) with m = 3 or more normals, got shape "
                f"{values.shape}"
            )
        if np.isnan(values).any() or (values == np.inf).any():
            raise ValueError(
                "values: expected finite numbers (or -inf for an empty polygon); a polygon is "
                "bounded"
            )
        self.values = tighten(values)

    @classmethod
    def of_tight(cls, values: ArrayLike) -> SupportPolygons:
        """Return polygons of values that are tight already, without computation.

        Parameters
        ----------
        values : array_like, shape (..., m)
            Tight values, such as those of shifts and hulls.

        Returns
        -------
        SupportPolygons
        """
        polygons = cls.__new__(cls)
        polygons.values = read_array(values, "values", "numbers")
        return polygons

    @classmethod
    def around(cls, points: ArrayLike, m: int) -> SupportPolygons:
        """Return the smallest polygons with m normals around points.

        Parameters
        ----------
        points : array_like, shape (..., count, 2)
            Points.
        m : int
            Number of normals.

        Returns
        -------
        SupportPolygons

        Examples
        --------
        >>> SupportPolygons.around([[0, 0], [2, 1]], m=4).values.tolist()
        [1.0, 2.0, 0.0, 0.0]
        """
        points = read_points(points, "points")
        if points.ndim < 2 or points.shape[-2] == 0:
            raise ValueError(
                f"points: expected shape (..., count, 2) with a point or more, got {points.shape}"
            )
        return cls.of_tight((points @ normals(m).T).max(axis=-2))

    @property
    def shape(self) -> tuple:
        """Shape of the array of polygons."""
        return self.values.shape[:-1]

    @property
    def m(self) -> int:
        """Number of normals."""
        return self.values.shape[-1]

    @property
    def empty(self) -> np.ndarray:
        """Whether a polygon has no point, an array of the shape of the polygons."""
        return np.isneginf(self.values[..., 0])

    def hull(self, other: SupportPolygons | ArrayLike | None = None) -> SupportPolygons:
        """Return the smallest polygons that contain two.

        Parameters
        ----------
        other : SupportPolygons or array_like, optional
            The other polygons, or their values; left out, one polygon around all of these is
            returned.

        Returns
        -------
        SupportPolygons
        """
        if other is None:
            return SupportPolygons.of_tight(self.values.reshape(-1, self.m).max(axis=0))
        return SupportPolygons.of_tight(np.maximum(self.values, self._values_of(other)))

    def shift(self, by: ArrayLike) -> SupportPolygons:
        """Return the polygons moved by vectors.

        Parameters
        ----------
        by : array_like, shape (..., 2)
            Vectors.

        Returns
        -------
        SupportPolygons
        """
        return SupportPolygons.of_tight(self.values + read_points(by, "by") @ normals(self.m).T)

    def intersect(self, other: SupportPolygons | ArrayLike) -> SupportPolygons:
        """Return polygons that contain the intersection, whatever the rounding.

        Parameters
        ----------
        other : SupportPolygons or array_like
            The other polygons, or their values.

        Returns
        -------
        SupportPolygons
            Touching polygons have a point in common.
        """
        values = np.minimum(self.values, self._values_of(other))
        unchanged = (values == self.values).all(axis=-1)
        result = values.copy()
        result[~unchanged] = tighten(values[~unchanged])
        return SupportPolygons.of_tight(result)

    @property
    def vertices(self) -> np.ndarray:
        """Corners of neighbouring sides, shape (..., m, 2), clockwise; nan for empty polygons.

        Some coincide, if a side has no length.
        """
        n, step = normals(self.m), 2 * np.pi / self.m
        values = np.where(self.empty[..., None], np.nan, self.values)
        next_values = np.roll(values, -1, axis=-1)
        # the point of side i that lies along (n_y, -n_x) from its foot
        along = (next_values - values * np.cos(step)) / np.sin(step)
        return values[..., None] * n + along[..., None] * np.stack([n[:, 1], -n[:, 0]], axis=-1)

    @property
    def area(self) -> np.ndarray:
        """Areas of the polygons, 0 for empty ones."""
        x, y = np.moveaxis(self.vertices - self.vertices[..., :1, :], -1, 0)
        doubled = np.sum(np.roll(x, -1, axis=-1) * y - x * np.roll(y, -1, axis=-1), axis=-1)
        return np.where(self.empty, 0.0, np.maximum(doubled, 0) / 2)

    def contains(self, points: ArrayLike) -> np.ndarray:
        """Return whether points lie in the polygons, by broadcasting.

        Parameters
        ----------
        points : array_like, shape (..., 2)
            Points.

        Returns
        -------
        ndarray
            Boolean; true within rounding of the boundary.
        """
        points = read_points(points, "points")
        slack = ROUNDINGS * EPS * np.abs(points).sum(axis=-1, keepdims=True)
        return (points @ normals(self.m).T <= self.values + slack).all(axis=-1)

    def __getitem__(self, key):
        if not self.shape:
            raise IndexError("a single polygon has no entries")
        return SupportPolygons.of_tight(self.values[key])

    def __repr__(self):
        count = int(np.prod(self.shape))
        empty = int(np.sum(self.empty))
        noun = "1 polygon" if not self.shape else f"{count} polygons of shape {self.shape}"
        return f"{noun} with {self.m} normals" + (f", {empty} empty" if empty else "")

    def _values_of(self, other):
        values = (
            other.values
            if isinstance(other, SupportPolygons)
            else read_array(other, "other", "polygons or their values")
        )
        if values.shape[-1:] != (self.m,):
            raise ValueError(
                f"other: expected polygons with {self.m} normals, got {values.shape[-1]}"
            )
        return values


def tighten(values):
    """Return tight values of {p: n_i p <= values_i}, all -inf where it is empty."""
    m = values.shape[-1]
    flat = values.reshape(-1, m)
    result = np.full_like(flat, -np.inf)
    # most empty ones are seen at once: two opposite sides have passed each other
    candidates = np.isfinite(flat).all(axis=-1)
    if m % 2 == 0:
        with np.errstate(invalid="ignore"):
            opposite = flat + np.roll(flat, m // 2, axis=-1)
            candidates &= (opposite >= -ROUNDINGS * EPS * 2 * np.abs(flat)).all(axis=-1)
    flat = flat[candidates]
    tight = np.minimum(flat, _support_values(flat, 0.0))
    opposite_values = (
        np.roll(tight, -(m // 2), axis=-1)
        if m % 2 == 0
        else np.roll(_support_values(flat, 0.5), -(m // 2), axis=-1)
    )
    slack = ROUNDINGS * EPS * (np.abs(tight) + np.abs(opposite_values))
    nonempty = (tight + opposite_values >= -slack).all(axis=-1)
    result[np.flatnonzero(candidates)[nonempty]] = tight[nonempty]
    return result.reshape(values.shape)


def _support_values(values, half):
    """Return the minimum of alpha rho_j + beta rho_k, rounded upwards.

    The directions have the angles (i + half) step.
    """
    m = values.shape[-1]
    step = 2 * np.pi / m
    thrice = np.concatenate([values, values, values], axis=-1)
    result = np.full_like(values, np.inf)
    for a in range(0 if half else 1, m):
        for b in range(1, m):
            if 2 * (a + b) >= m:
                break
            alpha, beta = (
                np.sin(part * step) / np.sin((a + b) * step) for part in (b - half, a + half)
            )
            left, right = alpha * thrice[:, m - a : 2 * m - a], beta * thrice[:, m + b : 2 * m + b]
            np.minimum(
                result, left + right + ROUNDINGS * EPS * (np.abs(left) + np.abs(right)), out=result
            )
    return result
