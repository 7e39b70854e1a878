"""Curves of the phase plane on which the optimal control or the optimal cost changes."""

from dataclasses import dataclass

import numpy as np

from trajlib.pontryagin.planar_synthesis.value_function import GRID


@dataclass(frozen=True)
class Curve:
    """A curve of the phase plane: `points`, shape (N, 2), with the time `times` that an optimal
    motion takes from each.

    Curves that leave the window end one point outside of it. `kind`: for switching curves "crossed"
    (second type), "followed" (first type: it is a trajectory) or "mixed"; for borders "abnormal" or
    "end of a family". For switching curves, `change`: the levels of the control before and after
    ("u-", "interior", "zero", "u+"; tuples for several controls), `velocities`: before and after,
    shape (2, 2, N). For borders, `jump`: the greatest jump of the least cost across it, `optimal`:
    whether the extremal is optimal all along, `arrives`: whether it is so at least next to the
    target, `controls`: u at the points. For parts of the target, `parameter`: from where to where.
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
    velocities: np.ndarray = None

    def __repr__(self):
        begin, end = (tuple(float(round(v, 6)) for v in self.points[k]) for k in (0, -1))
        change = f", {self.change[0]} to {self.change[1]}" if self.change else ""
        return f"Curve(from {begin} to {end}{change}{', ' + self.kind if self.kind else ''})"


def crossing_angles(points, velocities):
    """Angles (radians, signed) from a curve to the velocities before and after the switching, at
    the middles of its pieces; shape (2, N - 1)."""
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
    size = GRID * value_function.square
    low, high = value_function.corner - 1e-9 * size, value_function.corner + (1 + 1e-9) * size
    return ((x >= low[:, None]) & (x <= high[:, None])).all(axis=0)


def consecutive_runs(index):
    """Stretches of consecutive integers."""
    return np.split(index, np.flatnonzero(np.diff(index) > 1) + 1) if index.size else []
