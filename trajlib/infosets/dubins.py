"""Exact reachable set of a vehicle with constant speed (Dubins car).

In units of the turning radius R = V^2/k and of the time R/V the only parameter is the angle T = t
k/V. The set of the positions reached exactly at the time t has the support function

    h(phi) = V times the integral of cos(max(|psi_0 - phi| - k s/V, 0)) from 0 to t

(`trajlib.infosets.turning`): turn towards phi, then go straight. The set itself is not convex.
Every position in it is reached with at most two switches, turn-straight-turn or turn-turn-turn; for
a given length a of the first turn the rest has a closed form, so that one equation in one unknown
decides. Its boundary consists of turn-straight motions outside and of turn-turn motions, the second
turn not shorter than the first, inside.
"""

from dataclasses import dataclass

import numpy as np

from trajlib._arguments.arrays import read_finite_array
from trajlib._arguments.numbers import read_number, read_points, read_positive
from trajlib._typing import ArrayLike
from trajlib.infosets.turning import angle_between, cosine_parts

#: First turns that are tried to begin with.
TRIED = 300
#: Points that are treated together.
BATCH = 400


@dataclass(frozen=True)
class DubinsReachable:
    """Positions that a vehicle of constant speed reaches at one time.

    Attributes
    ----------
    t : float
        Time.
    speed : float
        Speed V.
    k : float
        Largest lateral acceleration.
    heading : float
        Initial heading, from the y axis clockwise.
    position : tuple of float
        Initial position.
    """

    t: float
    speed: float
    k: float
    heading: float
    position: tuple

    @property
    def radius(self) -> float:
        """Radius R = V^2/k of the fastest turn."""
        return self.speed**2 / self.k

    @property
    def turn(self) -> float:
        """Angle of the fastest turn in the whole time, radians."""
        return self.t * self.k / self.speed

    def support(self, directions: ArrayLike) -> np.ndarray:
        """Return the support function, the largest n p over the set.

        Parameters
        ----------
        directions : array_like
            Angles phi of the normals n = (sin phi, cos phi).

        Returns
        -------
        ndarray
            Of the shape of `directions`.
        """
        phi = read_finite_array(directions, "directions", "angles as numbers")
        plus, minus = cosine_parts(angle_between(phi - self.heading), self.k / self.speed, self.t)
        x, y = self.position
        return x * np.sin(phi) + y * np.cos(phi) + self.speed * (plus - minus)

    def contains(self, points: ArrayLike, tolerance: float = 1e-6) -> np.ndarray:
        """Return whether points are reached at the time t.

        Parameters
        ----------
        points : array_like, shape (..., 2)
            Points.
        tolerance : float
            Distance from the boundary, in turning radii, within which either answer is possible.

        Returns
        -------
        ndarray, shape (...)
        """
        points = read_points(points, "points")
        local = self._to_units(points.reshape(-1, 2))
        reached = [
            _reached(part, self.turn, read_positive(tolerance, "tolerance", "turning radii"))
            for part in np.split(local, range(BATCH, len(local), BATCH))
        ]
        return np.concatenate(reached).reshape(points.shape[:-1])

    def boundary(self, count: int = 400) -> list:
        """Return the boundary as a list of curves.

        Parameters
        ----------
        count : int
            Number of points tried on each family of motions.

        Returns
        -------
        list of ndarray
            Arrays of shape (any, 2): the parts of the turn-straight and turn-turn motions with one
            side that is not reached.
        """
        T, curves = self.turn, []
        for ends, longest in ((_turn_straight, T), (_turn_turn, T / 2)):
            first = np.linspace(0, longest, count)
            for side in (1, -1):
                curve = ends(first, T) * [side, 1]
                along = np.gradient(curve, axis=0)
                size = np.linalg.norm(along, axis=1, keepdims=True)
                across = 1e-3 * along[:, ::-1] * [1, -1] / np.maximum(size, 1e-12)
                is_boundary = ~(
                    _reached(curve + across, T, 1e-9) & _reached(curve - across, T, 1e-9)
                )
                breaks = np.flatnonzero(np.diff(is_boundary.astype(int))) + 1
                curves += [
                    self._from_units(part)
                    for part, boundary_flags in zip(
                        np.split(curve, breaks), np.split(is_boundary, breaks)
                    )
                    if boundary_flags[0] and len(part) > 1
                ]
        return curves

    def _turned(self):
        c, s = np.cos(self.heading), np.sin(self.heading)
        return np.array([[c, -s], [s, c]])

    def _to_units(self, points):
        return (points - self.position) @ self._turned().T / self.radius

    def _from_units(self, points):
        return points * self.radius @ self._turned() + self.position


def dubins_reachable(
    t: float,
    *,
    speed: float = 1.0,
    k: float = 1.0,
    heading: float = 0.0,
    position: ArrayLike = (0.0, 0.0),
) -> DubinsReachable:
    """Return the exact set of positions that a vehicle of constant speed reaches at a time.

    Parameters
    ----------
    t : float
        Time, positive.
    speed : float
        Speed V > 0.
    k : float
        Largest lateral acceleration, so that |psi'| <= k/V.
    heading : float
        Initial heading, from the y axis clockwise.
    position : array_like, shape (2,)
        Initial position.

    Returns
    -------
    DubinsReachable

    Raises
    ------
    ValueError
        If arguments do not fit.

    Notes
    -----
    Source: section 6.3 of the paper; the boundary is due to Berdyshev. MATLAB has only
    ``dubinsConnection``.

    Examples
    --------
    >>> import numpy as np
    >>> reachable = dubins_reachable(np.pi)
    >>> reachable.contains([[0, np.pi], [2, 0], [0, 1]]).tolist()            # straight on, a half turn, too near
    [True, True, False]
    >>> reachable.support([0, np.pi]).round(6).tolist()
    [3.141593, 0.0]
    """
    start = read_points(position, "position")
    if start.shape != (2,):
        raise ValueError(f"position: expected a point (x, y), got shape {start.shape}")
    return DubinsReachable(
        read_positive(t, "t", "time"),
        read_positive(speed, "speed", "length/time"),
        read_positive(k, "k", "length/time^2"),
        read_number(heading, "heading"),
        tuple(start.tolist()),
    )


def _turn_straight(first, T):
    """Return ends of motions that turn right by `first` and then go straight.

    In units of R; the initial heading is upwards.
    """
    straight = T - first
    return np.stack(
        [1 - np.cos(first) + straight * np.sin(first), np.sin(first) + straight * np.cos(first)],
        axis=-1,
    )


def _turn_turn(first, T):
    """Return ends of motions that turn right by `first` and then left."""
    last = 2 * first - T
    return np.stack(
        [1 - 2 * np.cos(first) + np.cos(last), 2 * np.sin(first) - np.sin(last)], axis=-1
    )


def _reached(points, T, tolerance):
    """Return whether points (count, 2) are reached with the length T.

    In units of R; the initial heading is upwards.
    """
    # the mirror image: the first turn is left
    mirrored = np.concatenate([points, points * [-1, 1]])
    first = np.sort(
        np.column_stack(
            [np.tile(np.linspace(0, T, TRIED), (len(mirrored), 1)), _kinks(mirrored, T)]
        ),
        axis=1,
    )
    reached = np.zeros(len(mirrored), dtype=bool)
    # the remaining motion after the first turn, in the axes at its end
    c, s = np.cos(first), np.sin(first)
    x, y = mirrored[:, 0, None] - (1 - c), mirrored[:, 1, None] - s
    x, y = c * x - s * y, s * x + c * y
    remaining = T - first
    # straight, then a turn by an angle c to either side: x = +-(1 - cos c), y = remaining - c + sin c
    inside, turn = np.abs(x) <= 2, np.arccos(np.clip(1 - np.abs(x), -1, 1))
    for loops in 2 * np.pi * np.arange(int(T / (2 * np.pi)) + 1):
        gaps = [
            np.where(
                inside & (angle <= remaining + tolerance),
                y - (remaining - angle) - np.sin(angle),
                np.nan,
            )
            for angle in (loops + turn, loops + 2 * np.pi - turn)
        ]
        reached |= _vanishes(gaps, inside, tolerance)
    # a left turn by b, then a right one by c: the end is (-1, 0) and (2 - cos c, sin c) turned back
    # by b
    distance_squared = (x + 1) ** 2 + y**2
    inside, turn = (
        np.abs(5 - distance_squared) <= 4,
        np.arccos(np.clip((5 - distance_squared) / 4, -1, 1)),
    )
    gaps = []
    for angle in (turn, 2 * np.pi - turn):
        middle = np.arctan2(y, x + 1) - np.arctan2(np.sin(angle), 2 - np.cos(angle))
        excess = (middle + angle - remaining + np.pi) % (2 * np.pi) - np.pi
        gaps.append(np.where(inside & (angle <= remaining + tolerance), excess, np.nan))
    reached |= _vanishes(gaps, inside, tolerance)
    return reached[: len(points)] | reached[len(points) :]


def _kinks(points, T):
    """Return first turns to the right after which the last turn has no length, shape (count, 6).

    The point then lies straight ahead, or on the circle of the turn to the left. There the gaps
    below have kinks, and at the boundary they vanish there.
    """
    distance = np.hypot(points[:, 0] - 1, points[:, 1])
    bearing = np.arctan2(points[:, 0] - 1, points[:, 1])
    with np.errstate(invalid="ignore", divide="ignore"):
        ahead = bearing + np.arctan2(1, np.sqrt(distance**2 - 1))
        aside = np.arccos((distance**2 + 3) / (4 * distance))
    turns = np.stack([ahead, bearing + np.pi / 2 + aside, bearing + np.pi / 2 - aside], axis=-1) % (
        2 * np.pi
    )
    return np.clip(np.nan_to_num(np.concatenate([turns, turns + 2 * np.pi], axis=-1)), 0, T)


def _vanishes(gaps, inside, tolerance):
    """Return whether one of two branches has a zero along its last axis.

    Branches are nan where they are not defined. Where the last turn can no longer reach the
    point, at the ends of `inside`, the branches meet. Jumps by 2 pi are no zeros.
    """
    branch_ends = np.zeros_like(inside)
    branch_ends[:, 1:] |= inside[:, 1:] & ~inside[:, :-1]
    branch_ends[:, :-1] |= inside[:, :-1] & ~inside[:, 1:]
    with np.errstate(invalid="ignore"):
        has_zero = (
            branch_ends & (gaps[0] * gaps[1] <= 0) & (np.abs(gaps[0] - gaps[1]) < np.pi)
        ).any(axis=1)
        for gap in gaps:
            before, after = gap[:, :-1], gap[:, 1:]
            has_zero |= ((before * after <= 0) & (np.abs(before - after) < np.pi)).any(axis=1)
            has_zero |= (np.abs(gap) <= tolerance).any(axis=1)
    return has_zero
