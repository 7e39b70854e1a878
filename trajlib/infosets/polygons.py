"""Convex polygons by their support values on m fixed normals, whole arrays of them at once.

The normals are n_i = (sin, cos)(2 pi (i - 1)/m), i = 1 ... m, counted from the y axis clockwise as
headings are. A polygon is {p: n_i p <= rho_i}. Its values are tight if rho_i is the greatest n_i p
over the polygon itself, for all i. Unions (their hulls), shifts and sums of tight values are tight.
The least values of two polygons need not be: the sides that no longer touch are moved in. By the
duality of linear programming the greatest n_i p is

    min alpha rho_j + beta rho_k    over all j, k with n_i = alpha n_j + beta n_k, alpha, beta >= 0,

since a basic solution of the dual has two numbers that are not zero. By Farkas' lemma the polygon
is empty if and only if h(-n_l) + rho_l < 0 for some l, where h(-n_l) is the same minimum for the
direction -n_l.

An empty polygon has all values -inf: then maxima, sums and minima do what they should. Rounding is
always outwards: what `intersect` returns contains the intersection.
"""

import numpy as np

from trajlib._arguments.numbers import read_points

EPS = float(np.finfo(float).eps)
#: Relative error of a computed alpha rho_j + beta rho_k, in units of EPS: four for a quotient of
#: sines, three for product and sum.
ROUNDINGS = 8


def normals(m):
    """The m unit normals, shape (m, 2); those along the axes are exact."""
    angle = 2 * np.pi * np.arange(m) / m
    n = np.stack([np.sin(angle), np.cos(angle)], axis=-1)
    return np.where(np.abs(n) < EPS, 0.0, n)


class SupportPolygons:
    """An array of convex polygons with sides on m fixed normals (MATLAB: polyshape; several at
    once).

    `values`: support values, shape (..., m), m >= 3, in the unit of the plane; n_i p <= values[...,
    i] on the normals n_i = (sin, cos)(2 pi i/m). They need not be tight, and are made so; polygons
    without a point become `empty`. Source: sections 3.2 to 3.4 of the paper; (3.6) in the form
    above, which has no branches.

    >>> square = SupportPolygons([1.0, 1.0, 1.0, 1.0])                    # |x| <= 1, |y| <= 1
    >>> both = square.intersect(square.shift([1.5, 0.0]))
    >>> round(float(both.area), 12), bool(square.intersect(square.shift([2.1, 0.0])).empty)
    (1.0, True)
    >>> square.hull(square.shift([1.5, 0.0])).values.tolist()
    [1.0, 2.5, 1.0, 1.0]
    """

    def __init__(self, values):
        values = np.array(values, dtype=float)
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
        self.values = tightened(values)

    @classmethod
    def of_tight(cls, values):
        """Polygons of values that are tight already, as those of shifts and hulls are; nothing is
        computed."""
        polygons = cls.__new__(cls)
        polygons.values = np.asarray(values, dtype=float)
        return polygons

    @classmethod
    def around(cls, points, m):
        """The least polygons with m normals around points of shape (..., count, 2).

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
    def shape(self):
        """Of the array of polygons."""
        return self.values.shape[:-1]

    @property
    def m(self):
        """The number of normals."""
        return self.values.shape[-1]

    @property
    def empty(self):
        """Which polygons have no point, an array of the shape of the polygons."""
        return np.isneginf(self.values[..., 0])

    def hull(self, other=None):
        """The least polygons around two: the greater values. Without `other`: one polygon around
        all of them."""
        if other is None:
            return SupportPolygons.of_tight(self.values.reshape(-1, self.m).max(axis=0))
        return SupportPolygons.of_tight(np.maximum(self.values, self._fitting(other)))

    def shift(self, by):
        """Moved by vectors of shape (..., 2)."""
        return SupportPolygons.of_tight(self.values + read_points(by, "by") @ normals(self.m).T)

    def intersect(self, other):
        """What two have in common; never less of it, whatever rounding does. Touching polygons have
        a point in common."""
        values = np.minimum(self.values, self._fitting(other))
        untouched = (values == self.values).all(axis=-1)
        result = values.copy()
        result[~untouched] = tightened(values[~untouched])
        return SupportPolygons.of_tight(result)

    @property
    def vertices(self):
        """The corners of neighbouring sides, shape (..., m, 2), clockwise; some coincide, if a side
        has no length. nan for the empty."""
        n, step = normals(self.m), 2 * np.pi / self.m
        mine = np.where(self.empty[..., None], np.nan, self.values)
        after = np.roll(mine, -1, axis=-1)
        # the point of side i that lies along (n_y, -n_x) from its foot
        along = (after - mine * np.cos(step)) / np.sin(step)
        return mine[..., None] * n + along[..., None] * np.stack([n[:, 1], -n[:, 0]], axis=-1)

    @property
    def area(self):
        """Their areas; 0 of the empty."""
        x, y = np.moveaxis(self.vertices - self.vertices[..., :1, :], -1, 0)
        twice = np.sum(np.roll(x, -1, axis=-1) * y - x * np.roll(y, -1, axis=-1), axis=-1)
        return np.where(self.empty, 0.0, np.maximum(twice, 0) / 2)

    def contains(self, points):
        """Whether points of shape (..., 2) lie in them, by broadcasting (rounding counts for the
        point)."""
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
        what = "1 polygon" if not self.shape else f"{count} polygons of shape {self.shape}"
        return f"{what} with {self.m} normals" + (f", {empty} empty" if empty else "")

    def _fitting(self, other):
        values = (
            other.values if isinstance(other, SupportPolygons) else np.asarray(other, dtype=float)
        )
        if values.shape[-1:] != (self.m,):
            raise ValueError(
                f"other: expected polygons with {self.m} normals, got {values.shape[-1]}"
            )
        return values


def tightened(values):
    """Tight values of {p: n_i p <= values_i}, all -inf where it is empty; an array of the same
    shape."""
    m = values.shape[-1]
    flat = values.reshape(-1, m)
    result = np.full_like(flat, -np.inf)
    # most empty ones are seen at once: two opposite sides have passed each other
    kept = np.isfinite(flat).all(axis=-1)
    if m % 2 == 0:
        with np.errstate(invalid="ignore"):
            opposite = flat + np.roll(flat, m // 2, axis=-1)
            kept &= (opposite >= -ROUNDINGS * EPS * 2 * np.abs(flat)).all(axis=-1)
    flat = flat[kept]
    tight = np.minimum(flat, _greatest(flat, 0.0))
    back = (
        np.roll(tight, -(m // 2), axis=-1)
        if m % 2 == 0
        else np.roll(_greatest(flat, 0.5), -(m // 2), axis=-1)
    )
    slack = ROUNDINGS * EPS * (np.abs(tight) + np.abs(back))
    there = (tight + back >= -slack).all(axis=-1)
    result[np.flatnonzero(kept)[there]] = tight[there]
    return result.reshape(values.shape)


def _greatest(values, half):
    """The minimum of alpha rho_j + beta rho_k for the directions of angle (i + half) step, rounded
    upwards."""
    m = values.shape[-1]
    step = 2 * np.pi / m
    thrice = np.concatenate([values, values, values], axis=-1)
    least = np.full_like(values, np.inf)
    for a in range(0 if half else 1, m):
        for b in range(1, m):
            if 2 * (a + b) >= m:
                break
            alpha, beta = (
                np.sin(part * step) / np.sin((a + b) * step) for part in (b - half, a + half)
            )
            left, right = alpha * thrice[:, m - a : 2 * m - a], beta * thrice[:, m + b : 2 * m + b]
            np.minimum(
                least, left + right + ROUNDINGS * EPS * (np.abs(left) + np.abs(right)), out=least
            )
    return least
