"""Interpolation by the tensor product of the fundamental polynomials of each axis.

    L_k(s) = prod_{q != k} (s - s_q)/(s_k - s_q)

How accurate this is depends on the Lebesgue constant of the nodes, max over s of sum_k |L_k(s)|:
the error of interpolation is at most 1 + Lambda times that of the best polynomial, and errors of
the table are multiplied by no more than Lambda. It grows like (2/pi) ln n for n Chebyshev nodes,
and like 2^n/(e n ln n) for n equispaced ones.
"""

from collections.abc import Sequence

import numpy as np

from trajlib._arguments.arrays import read_array
from trajlib._typing import ArrayLike
from trajlib.reference_curves.node_arguments import read_nodes

#: Points that are evaluated together: what fits into the cache.
POINTS = 4000


def chebyshev_nodes(c: float, d: float, n: int) -> np.ndarray:
    """Return the zeros of the Chebyshev polynomial of degree n, mapped to [c, d], increasing.

    Parameters
    ----------
    c, d : float
        Ends of the interval, c < d.
    n : int
        Number of nodes.

    Returns
    -------
    ndarray, shape (n,)

    Raises
    ------
    ValueError
        If the ends are not finite and increasing or n < 1.

    Notes
    -----
    Source: (2.12) of the paper.

    Examples
    --------
    >>> chebyshev_nodes(-1, 1, 3).round(4).tolist()
    [-0.866, 0.0, 0.866]
    """
    if not (np.isfinite([c, d]).all() and c < d):
        raise ValueError(f"c, d: expected finite ends with c < d, got {c} and {d}")
    if n != int(n) or n < 1:
        raise ValueError(f"n: expected a number of nodes, one or more, got {n}")
    cosines = -np.cos(np.pi * (2 * np.arange(1, int(n) + 1) - 1) / (2 * int(n)))
    return (c + d) / 2 + (d - c) / 2 * np.where(np.abs(cosines) < 1e-16, 0, cosines)


def lebesgue_constant(
    nodes: ArrayLike, low: float | None = None, high: float | None = None
) -> float:
    """Return the Lebesgue constant, the largest sum of |L_k(s)| over an interval.

    Parameters
    ----------
    nodes : array_like
        Increasing nodes.
    low, high : float, optional
        Interval; the range of the nodes if left out.

    Returns
    -------
    float
        Factor by which interpolation amplifies errors. It is found on 50 points between
        neighbouring nodes, so it may be too small by a thousandth.

    Raises
    ------
    ValueError
        If the nodes do not increase.

    Examples
    --------
    >>> round(lebesgue_constant(range(11)), 1), round(lebesgue_constant(chebyshev_nodes(0, 10, 11), 0, 10), 1)
    (29.9, 2.5)
    """
    nodes = read_nodes(nodes, "nodes")
    low, high = nodes[0] if low is None else low, nodes[-1] if high is None else high
    if nodes.size == 1:
        return 1.0
    ends = np.unique(np.concatenate([[low], nodes[(nodes > low) & (nodes < high)], [high]]))
    points = (ends[:-1, None] + np.diff(ends)[:, None] * np.arange(51) / 50).ravel()
    return float(np.abs(_fundamental(nodes)(points)).sum(axis=1).max())


class TensorInterpolant:
    """Table on a grid of nodes, interpolated along every axis by fundamental polynomials.

    Made by `ReferenceCurves`.

    Parameters
    ----------
    nodes : tuple of ndarray
        Nodes of each axis: time, initial states, parameters.
    box : tuple of tuple
        Interval (low, high) of each axis.
    names : list of str
        Name of each axis, for messages.
    n : int
        Number of components of the initial state.
    table : ndarray
        Values, shape (components, nodes of each axis...).
    """

    def __init__(self, nodes: tuple, box: tuple, names: list, n: int, table: np.ndarray) -> None:
        self.nodes, self.box, self.table, self._names, self._n = nodes, box, table, names, n
        self._bases = [_fundamental(axis) for axis in nodes]

    def __call__(
        self, t: ArrayLike, x0: Sequence, p: Sequence = (), *, extrapolate: bool = False
    ) -> np.ndarray:
        """Return the values at times, initial states and parameters.

        Parameters
        ----------
        t : array_like
            Times.
        x0 : sequence of array_like
            Components of the initial state. These, `t` and `p` are numbers or arrays that
            broadcast.
        p : sequence of array_like
            Parameters.
        extrapolate : bool
            Whether points outside the box are allowed; otherwise they are an error.

        Returns
        -------
        ndarray, shape (components, ...)
        """
        return self.derivative(t, x0, p, 0, extrapolate=extrapolate)

    def derivative(
        self,
        t: ArrayLike,
        x0: Sequence,
        p: Sequence = (),
        order: int = 1,
        *,
        extrapolate: bool = False,
    ) -> np.ndarray:
        """Return a time derivative of the values.

        Parameters
        ----------
        t, x0, p, extrapolate
            As in a call of the interpolant.
        order : int
            Order of the derivative.

        Returns
        -------
        ndarray, shape (components, ...)
        """
        if order != int(order) or order < 0:
            raise ValueError(f"order: expected a whole number, zero or more, got {order}")
        if len(x0) != self._n or len(p) != len(self.nodes) - 1 - self._n:
            raise ValueError(
                f"x0, p: expected {self._n} components and {len(self.nodes) - 1 - self._n} "
                f"parameters, got {len(x0)} and {len(p)}"
            )
        points = list(
            np.broadcast_arrays(
                *(
                    read_array(part, name, "numbers (of dates: seconds since the first)")
                    for part, name in zip((t, *x0, *p), self._names)
                )
            )
        )
        shape = points[0].shape
        points = [part.ravel() for part in points]
        self._check_inside(points, extrapolate)
        batches = [
            self._at([part[k : k + POINTS] for part in points], int(order))
            for k in range(0, max(points[0].size, 1), POINTS)
        ]
        return np.concatenate(batches, axis=1).reshape(-1, *shape)

    def on_grid(self, axes: Sequence, order: int = 0, *, extrapolate: bool = False) -> np.ndarray:
        """Return the values, or a time derivative, at all points of a grid.

        Parameters
        ----------
        axes : sequence of array_like
            Times, values for each component of the initial state and for each parameter.
        order : int
            Order of the derivative by time.
        extrapolate : bool
            Whether points outside the box are allowed.

        Returns
        -------
        ndarray, shape (components, times, ...)
        """
        points = [read_array(axis, "axes", "lists of numbers") for axis in axes]
        if len(points) != len(self.nodes) or any(axis.ndim != 1 for axis in points):
            raise ValueError(
                f"axes: expected {len(self.nodes)} lists, for {', '.join(self._names)}, got "
                f"{len(points)}"
            )
        self._check_inside(points, extrapolate)
        values = self.table
        for row in self._rows(points, order):
            values = np.tensordot(values, row, axes=(1, 1))
        return values

    def _rows(self, points, order):
        """Return the fundamental polynomials of each axis at the points, shapes (points, nodes)."""
        return [
            basis.derivative(axis_points, order) if j == 0 and order else basis(axis_points)
            for j, (basis, axis_points) in enumerate(zip(self._bases, points))
        ]

    def _at(self, points, order):
        *leading, last = self._rows(points, order)
        # from the last axis to the first
        values = np.tensordot(self.table, last, axes=(-1, 1))
        for row in leading[::-1]:
            values = np.einsum("...kp,pk->...p", values, row)
        return values

    def _check_inside(self, points, extrapolate):
        for values, (low, high), name in zip(points, self.box, self._names):
            if not np.isfinite(values).all():
                raise ValueError(
                    f"{name}: expected finite numbers, got {values[~np.isfinite(values)][0]}"
                )
            slack = 1e-12 * max(high - low, abs(low), abs(high))
            outside = (values < low - slack) | (values > high + slack)
            if outside.any() and not extrapolate:
                raise ValueError(
                    f"{name}: {values[outside][0]:g} lies outside of its interval [{low:g}, "
                    f"{high:g}]; polynomials go astray quickly there. Give extrapolate=True to "
                    "have it all the same"
                )


def _fundamental(nodes):
    """Return all fundamental polynomials of these nodes, points -> (points, nodes)."""
    from scipy.interpolate import BarycentricInterpolator

    gaps = np.subtract.outer(nodes, nodes) * (4 / np.ptp(nodes) if nodes.size > 1 else 1)
    np.fill_diagonal(gaps, 1)
    # Weights that are the same in every run; the class would multiply in random order.
    return BarycentricInterpolator(nodes, np.eye(nodes.size), wi=1 / gaps.prod(axis=1))
