"""Curves of the phase plane on which the optimal control or the optimal cost changes."""

from dataclasses import dataclass

import numpy as np

from trajlib.pontryagin.planar_synthesis.value_function import GRID


@dataclass(frozen=True)
class Curve:
    """A curve of the phase plane; one that leaves the window ends one point outside of it.

    Attributes
    ----------
    points : ndarray, shape (N, 2)
        Points of the curve.
    times : ndarray, shape (N,)
        The time that an optimal process takes from each point.
    jump : float
        For borders: the greatest jump of the least cost across it.
    kind : str
        For switching curves "crossed" (second type), "followed" (first type: it is a trajectory) or
        "mixed"; for borders "abnormal" or "end of a family".
    optimal, arrives : bool
        For borders: whether the extremal is optimal everywhere, or at least next to the target.
    parameter : tuple of float
        For parts of the target: (from, to).
    controls : tuple
        For borders: u at the points.
    change : tuple
        For switching curves: the levels of the control before and after ("u-", "interior", "zero",
        "u+"; tuples for several controls).
    velocities : ndarray, shape (2, 2, N), or None
        For switching curves: the velocities before and after.
    """

    points: np.ndarray
    times: np.ndarray
    jump: float = 0.0
    kind: str = ""
    optimal: bool = True
    arrives: bool = True
    parameter: tuple = ()
    controls: tuple = ()
    change: tuple = ()
    velocities: np.ndarray | None = None

    def __repr__(self):
        begin, end = (tuple(float(round(v, 6)) for v in self.points[k]) for k in (0, -1))
        change = f", {self.change[0]} to {self.change[1]}" if self.change else ""
        return f"Curve(from {begin} to {end}{change}{', ' + self.kind if self.kind else ''})"


def crossing_angles(points, velocities):
    """Return the angles (radians, signed) from a curve to the velocities before and after it.

    They belong to the middles of its pieces; shape (2, N - 1).
    """
    tangent = np.diff(points, axis=0).T
    angles = []
    for v in velocities:
        v = (v[:, 1:] + v[:, :-1]) / 2
        angles.append(
            np.arcsin(
                np.clip(
                    (tangent[0] * v[1] - tangent[1] * v[0])
                    / (np.hypot(*tangent) * np.hypot(*v) + 1e-300),
                    -1,
                    1,
                )
            )
        )
    return np.array(angles)


def in_window(x, value_function):
    """Check which points (2, N) lie in the window."""
    size = GRID * value_function.square
    low, high = value_function.corner - 1e-9 * size, value_function.corner + (1 + 1e-9) * size
    return ((x >= low[:, None]) & (x <= high[:, None])).all(axis=0)


def consecutive_runs(index):
    """Split indices into runs of consecutive integers."""
    return np.split(index, np.flatnonzero(np.diff(index) > 1) + 1) if index.size else []
