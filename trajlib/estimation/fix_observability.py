"""Local observability of a position from ranges to satellites or from bearings."""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import any_floats, read_matrix, read_vector
from trajlib._numerical_rank import zero_level
from trajlib._typing import Matrix, MatrixLike
from trajlib.structure import exact
from trajlib.typesetting import escape_markdown


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
        return escape_markdown(self.reason)


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
        row_differences(points, x),
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
    directions = row_differences(observer_positions, x)
    for k in range(directions.shape[0]):
        if not any(directions[k, :]):
            raise ValueError(
                f"position: it is that of observer {k + 1}, from which it has no bearing"
            )
    cross_products = [cross_matrix(-directions[k, :]) for k in range(directions.shape[0])]
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
    floats = any_floats(position, points)
    return read_vector(position, "position", 3, floats), read_matrix(points, name, None, 3, floats)


def row_differences(points, x):
    return points - x if isinstance(points, np.ndarray) else points - sp.ones(points.rows, 1) * x.T


def cross_matrix(e):
    """Return the matrix of x -> e x x."""
    e1, e2, e3 = e
    rows = [[0, -e3, e2], [e3, 0, -e1], [-e2, e1, 0]]
    return np.array(rows) if isinstance(e, np.ndarray) else sp.Matrix(rows)


def _fix_test(rows, unobservable_reason, observable_reason):
    if isinstance(rows, np.ndarray):
        lengths = np.linalg.norm(rows, axis=1)
        _, values, Vt = np.linalg.svd(rows / np.where(lengths > 0, lengths, 1)[:, None])
        rank = int((values > zero_level(*rows.shape) * values[0]).sum())
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
