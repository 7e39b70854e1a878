r"""The distance to the nearest unobservable pair: a proved bracket, not only an upper bound.

The distance of (A, H), in the 2-norm of a change of both, complex changes allowed, is the least
value of sigma(lambda) = sigma_min(A - lambda I; H) over all complex lambda (R. Eising, Systems &
Control Letters 4 (1984) 263-264). Every value of sigma is an upper bound; the lower one needs a
proof. Here it comes from

    sigma(lambda)^2 - |lambda - c|^2 = least eigenvalue of a Hermitian matrix that is linear in Re lambda, Im lambda,

which is concave. On a square with the centre c it is at least its least value at the corners, and
so

    sigma^2 >= min of sigma^2 over the corners - side^2/2    in the whole square.

A square that this does not settle is divided into four. As |(A - lambda I) v| >= |v*Av - lambda|
for |v| = 1, values below U lie within U of the field of values of A, which the eigenvalues of the
symmetric and of the skew part of A enclose in a rectangle; A is real, so that its upper half is
enough.

The squares that have to be looked at are those on which sigma is near its least value. They are few
where that is not small beside |A|, and where it belongs to a simple eigenvalue. About a multiple
one sigma is tiny on an area many times larger than its square: there the squares may be too many,
and the bracket stays wide.
"""

from dataclasses import dataclass

import numpy as np

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import MatrixLike
from trajlib.structure.floats import tolerance
from trajlib.structure.nearest import descend, smallest

_MOST_SQUARES, _AT_ONCE = 150_000, 1000


@dataclass(frozen=True)
class Distance:
    """A bracket of the distance to the nearest pair without the property.

    Attributes
    ----------
    lower, upper : float
        Proved bounds of the distance; rounding is allowed for.
    eigenvalue : complex
        The mode that is hidden in a pair at the distance `upper`.
    """

    lower: float
    upper: float
    eigenvalue: complex


@accepts_state_space(C="H")
def distance_to_unobservable(
    A: MatrixLike, H: MatrixLike | None = None, within: float = 0.01
) -> Distance:
    """Return a proved bracket of the smallest change that makes x' = Ax, z = Hx unobservable.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax; a StateSpace in place of it has its own `H`.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx.
    within : float, default 0.01
        The part of `upper` that may lie between the bounds.

    Returns
    -------
    Distance
        The bracket; where so narrow a one would take too many steps it is wider.

    Raises
    ------
    ValueError
        If shapes do not fit, for entries that are not real numbers, or for `within` outside (0, 1).

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    The size of a change is the 2-norm of (dA; dH), in the units given; complex changes
    are allowed, so real ones may have to be larger. MATLAB has no word for it.

    Examples
    --------
    >>> import numpy as np
    >>> found = distance_to_unobservable(np.array([[0.0, 1], [0, 0]]), np.array([[1.0, 0]]))
    >>> bool(found.lower <= np.sqrt(3)/2 <= found.upper), bool(found.upper < 1.02*found.lower)
    (True, True)
    """
    return _distance(*read_observed(A, H), within)


def distance_to_uncontrollable(
    A: MatrixLike, B: MatrixLike | None = None, within: float = 0.01
) -> Distance:
    """Return a proved bracket of the smallest change that makes x' = Ax + Bu uncontrollable.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; a StateSpace in place of it has its own `B`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    within : float, default 0.01
        The part of `upper` that may lie between the bounds.

    Returns
    -------
    Distance
        The bracket; where so narrow a one would take too many steps it is wider.

    Raises
    ------
    ValueError
        If shapes do not fit, for entries that are not real numbers, or for `within` outside (0, 1).

    Notes
    -----
    The size of a change is the 2-norm of (dA, dB), in the units given; complex changes are allowed,
    so real ones may have to be larger. MATLAB has no word for it.

    Examples
    --------
    >>> import numpy as np
    >>> found = distance_to_uncontrollable(np.array([[0.0, 1], [0, 0]]), np.array([[0.0], [1]]))
    >>> bool(found.lower <= np.sqrt(3)/2 <= found.upper)
    True
    """
    return _distance(*read_controlled(A, B), within)


def _distance(A, H, within):
    if not 0 < within < 1:
        raise ValueError(f"within: expected a number between 0 and 1, got {within}")
    try:
        A, H = np.array(A, dtype=float), np.array(H, dtype=float)
    except TypeError:
        raise ValueError(
            "A: expected real numbers; a distance with symbols in it is beyond the methods here"
        ) from None
    size = np.linalg.norm(np.vstack([A, H]), 2) or 1
    lower, upper, value = _bracket(A / size, H / size, within)
    return Distance(float(size * lower), float(size * upper), complex(size * value))


def _bracket(A, H, within):
    rounding = tolerance(len(A))
    upper, value, _ = min(
        (descend(A, H, start) for start in (*np.linalg.eigvals(A), np.trace(A) / len(A))),
        key=lambda minimum: minimum[0],
    )
    if upper <= rounding:
        return 0, upper + rounding, value
    left_end, side, columns, rows = _field_of_values(A, upper)
    squares = np.stack(
        np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij"), axis=-1
    ).reshape(-1, 2)
    decided_bound = upper
    while len(squares):
        corners = squares[:, None] + np.array([[0, 0], [0, 1], [1, 0], [1, 1]])
        points, index = np.unique(corners.reshape(-1, 2), axis=0, return_inverse=True)
        points = left_end + side * (points[:, 0] + 1j * points[:, 1])
        sigmas = _not_less_than(A, H, points, side)
        best = points[np.argmin(sigmas)]
        upper, value = min((upper, value), descend(A, H, best)[:2], key=lambda minimum: minimum[0])
        bounds = _least_in_squares(sigmas[index.reshape(-1, 4)], side)
        undecided = bounds < (1 - within) * upper
        decided_bound = min(decided_bound, bounds[~undecided].min(initial=decided_bound))
        if 4 * undecided.sum() > _MOST_SQUARES:
            return min(decided_bound, bounds.min()), upper + rounding, value
        quarters = 2 * squares[undecided][:, None] + np.array([[0, 0], [0, 1], [1, 0], [1, 1]])
        squares, side = quarters.reshape(-1, 2), side / 2
    return decided_bound, upper + rounding, value


def _least_in_squares(corners, side):
    """Return lower bounds of sigma in squares, a row with its values at the four corners for each."""
    return np.sqrt(np.maximum(corners.min(axis=1) ** 2 - side**2 / 2, 0))


def _field_of_values(A, reach):
    """Return squares that cover the field of values and all within `reach`, Im lambda >= 0.

    They are given by the left end, their side and their numbers in both directions.
    """
    real_range = np.linalg.eigvalsh((A + A.T) / 2)[[0, -1]] + [-reach, reach]
    height = np.linalg.eigvalsh((A - A.T) / 2j)[-1] + reach
    side = max(real_range[1] - real_range[0], height) / 8
    return (
        real_range[0],
        side,
        int((real_range[1] - real_range[0]) / side) + 1,
        int(height / side) + 1,
    )


def _not_less_than(A, H, points, side):
    """Return lower bounds of sigma at many points, rounding included.

    The eigenvalues of the square are fast but keep half of the digits, which is nothing beside a
    large `side`.
    """
    rounding = tolerance(len(A))
    if side < 1e-4:
        return np.array([max(smallest(A, H, point)[0] - rounding, 0) for point in points])
    least = []
    for batch in np.array_split(points, len(points) // _AT_ONCE + 1):
        pencils = A - batch[:, None, None] * np.eye(len(A))
        least.append(
            np.linalg.eigvalsh(pencils.conj().transpose(0, 2, 1) @ pencils + H.T @ H)[:, 0]
        )
    return np.sqrt(np.maximum(np.concatenate(least) - rounding, 0))
