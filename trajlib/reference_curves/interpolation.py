"""Interpolation by the tensor product of the fundamental polynomials of each axis.

    L_k(s) = prod_{q != k} (s - s_q)/(s_k - s_q)

How accurate this is depends on the Lebesgue constant of the nodes, max over s of sum_k |L_k(s)|:
the error of interpolation is at most 1 + Lambda times that of the best polynomial, and errors of
the table are multiplied by no more than Lambda. It grows like (2/pi) ln n for n Chebyshev nodes,
and like 2^n/(e n ln n) for n equispaced ones.
"""

import numpy as np

from trajlib.reference_curves.arguments import read_nodes

#: Points that are evaluated together: what fits into the cache.
POINTS = 4000


def chebyshev_nodes(c, d, n):
    """The n zeros of the Chebyshev polynomial of degree n, carried to [c, d], increasing: (2.12) of
    the paper.

    >>> chebyshev_nodes(-1, 1, 3).round(4).tolist()
    [-0.866, 0.0, 0.866]
    """
    if not (np.isfinite([c, d]).all() and c < d):
        raise ValueError(f"c, d: expected finite ends with c < d, got {c} and {d}")
    if n != int(n) or n < 1:
        raise ValueError(f"n: expected a number of nodes, one or more, got {n}")
    cosines = -np.cos(np.pi * (2 * np.arange(1, int(n) + 1) - 1) / (2 * int(n)))
    return (c + d) / 2 + (d - c) / 2 * np.where(np.abs(cosines) < 1e-16, 0, cosines)


def lebesgue_constant(nodes, low=None, high=None):
    """Greatest sum of |L_k(s)| over [low, high], the range of the nodes if left out: how much
    interpolation amplifies.

    Found on 50 places between neighbouring nodes, so it may be a thousandth too small.

    >>> round(lebesgue_constant(range(11)), 1), round(lebesgue_constant(chebyshev_nodes(0, 10, 11), 0, 10), 1)
    (29.9, 2.5)
    """
    nodes = read_nodes(nodes, "nodes")
    low, high = nodes[0] if low is None else low, nodes[-1] if high is None else high
    if nodes.size == 1:
        return 1.0
    stops = np.unique(np.concatenate([[low], nodes[(nodes > low) & (nodes < high)], [high]]))
    places = (stops[:-1, None] + np.diff(stops)[:, None] * np.arange(51) / 50).ravel()
    return float(np.abs(_fundamental(nodes)(places)).sum(axis=1).max())


class TensorInterpolant:
    """A table on a grid of nodes, interpolated along every axis by fundamental polynomials; made by
    ReferenceCurves."""

    def __init__(self, nodes, box, names, n, table):
        self.nodes, self.box, self.table, self._names, self._n = nodes, box, table, names, n
        self._bases = [_fundamental(axis) for axis in nodes]

    def __call__(self, t, x0, p=(), *, extrapolate=False):
        """The values at times, initial states and parameters: shape (components, ...)."""
        return self.derivative(t, x0, p, 0, extrapolate=extrapolate)

    def derivative(self, t, x0, p=(), order=1, *, extrapolate=False):
        """Their derivative of this order by time."""
        if order != int(order) or order < 0:
            raise ValueError(f"order: expected a whole number, zero or more, got {order}")
        if len(x0) != self._n or len(p) != len(self.nodes) - 1 - self._n:
            raise ValueError(
                f"x0, p: expected {self._n} components and {len(self.nodes) - 1 - self._n} "
                f"parameters, got {len(x0)} and {len(p)}"
            )
        places = np.broadcast_arrays(*(np.asarray(part, dtype=float) for part in (t, *x0, *p)))
        shape = places[0].shape
        places = [part.ravel() for part in places]
        self._look(places, extrapolate)
        parts = [
            self._at([part[k : k + POINTS] for part in places], int(order))
            for k in range(0, max(places[0].size, 1), POINTS)
        ]
        return np.concatenate(parts, axis=1).reshape(-1, *shape)

    def on_grid(self, axes, order=0, *, extrapolate=False):
        """The values at all places of a grid, given by its axes: shape (components, times, ...)."""
        axes = [np.asarray(axis, dtype=float) for axis in axes]
        if len(axes) != len(self.nodes) or any(axis.ndim != 1 for axis in axes):
            raise ValueError(
                f"axes: expected {len(self.nodes)} lists, for {', '.join(self._names)}, got "
                f"{len(axes)}"
            )
        self._look(axes, extrapolate)
        found = self.table
        for row in self._rows(axes, order):
            found = np.tensordot(found, row, axes=(1, 1))
        return found

    def _rows(self, places, order):
        """The fundamental polynomials of each axis at the places, shapes (places, nodes)."""
        return [
            basis.derivative(place, order) if j == 0 and order else basis(place)
            for j, (basis, place) in enumerate(zip(self._bases, places))
        ]

    def _at(self, places, order):
        *others, last = self._rows(places, order)
        # from the last axis to the first
        found = np.tensordot(self.table, last, axes=(-1, 1))
        for row in others[::-1]:
            found = np.einsum("...kp,pk->...p", found, row)
        return found

    def _look(self, places, extrapolate):
        for place, (low, high), name in zip(places, self.box, self._names):
            if not np.isfinite(place).all():
                raise ValueError(
                    f"{name}: expected finite numbers, got {place[~np.isfinite(place)][0]}"
                )
            slack = 1e-12 * max(high - low, abs(low), abs(high))
            outside = (place < low - slack) | (place > high + slack)
            if outside.any() and not extrapolate:
                raise ValueError(
                    f"{name}: {place[outside][0]:g} lies outside of its interval [{low:g}, "
                    f"{high:g}]; polynomials go astray quickly there. Give extrapolate=True to "
                    "have it all the same"
                )


def _fundamental(nodes):
    """All fundamental polynomials of these nodes: places -> (places, nodes)."""
    from scipy.interpolate import BarycentricInterpolator

    gaps = np.subtract.outer(nodes, nodes) * (4 / np.ptp(nodes) if nodes.size > 1 else 1)
    np.fill_diagonal(gaps, 1)
    # Ours are the same in every run; the class would multiply in random order.
    return BarycentricInterpolator(nodes, np.eye(nodes.size), wi=1 / gaps.prod(axis=1))
