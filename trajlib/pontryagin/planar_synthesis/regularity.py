"""The conditions of Boltyansky's regular synthesis, tested on a computed planar synthesis.

    A  finitely many cells: open regions, curves, points;
    B  in a cell the control is smooth; a curve is followed by the motion (first type) or crossed at an angle (second
    type); C  the target is met at a non-zero angle and with a non-zero velocity; D  a trajectory passes through
    finitely many cells and ends on the target; E  all trajectories satisfy the maximum principle; F  the time to the
    target is a continuous function of the initial state.

If all hold in a region that trajectories do not leave, all of them are optimal there. C and F are
those that fail in practice: F on barriers. The numbers belong to the window and the horizon of the
synthesis.
"""

import itertools
from dataclasses import dataclass

import numpy as np

from trajlib.pontryagin.planar_synthesis.curves import crossing_angles
from trajlib.typesetting import typeset

#: Side of the raster on which regions are counted.
RASTER = 240


@dataclass(frozen=True)
class Condition:
    """One condition of a regular synthesis.

    Attributes
    ----------
    letter : str
        "A" to "F".
    holds : bool
        Whether it holds in the window.
    value : float
        The number that decides.
    text : str
        The result in a sentence.
    """

    letter: str
    holds: bool
    value: float
    text: str


@dataclass(frozen=True)
class Regularity:
    """All conditions; `regularity["F"]` is one of them.

    Attributes
    ----------
    conditions : tuple of Condition
        A to F.
    """

    conditions: tuple[Condition, ...]

    @property
    def regular(self) -> bool:
        """Whether every condition holds."""
        return all(c.holds for c in self.conditions)

    def __getitem__(self, letter):
        for condition in self.conditions:
            if condition.letter == letter:
                return condition
        raise KeyError(
            f"{letter!r}: the conditions are {', '.join(c.letter for c in self.conditions)}"
        )

    def __str__(self):
        return "\n".join(
            f"{c.letter} {'holds' if c.holds else 'FAILS'}: {c.text}" for c in self.conditions
        )

    def _repr_markdown_(self):
        rows = [
            f"| {c.letter} | {'holds' if c.holds else '**fails**'} | {typeset(c.text)} |"
            for c in self.conditions
        ]
        return "\n".join(["| condition | verdict | what was found |", "|---|---|---|", *rows])


def regularity(synthesis) -> Regularity:
    """Test the conditions; see `Synthesis.regularity`."""
    return Regularity(
        (
            _cells(synthesis),
            _curves(synthesis),
            _arrival(synthesis),
            _passages(synthesis),
            _maximum(synthesis),
            _continuity(synthesis),
        )
    )


def _count(number, noun):
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _cells(synthesis):
    """Test condition A: count regions and curves, exclude singular points."""
    value_function = synthesis._value_function
    (left, right), (bottom, top) = synthesis.window
    X, Y = np.meshgrid(np.linspace(left, right, RASTER), np.linspace(bottom, top, RASTER))
    triangle = value_function.interpolated(np.array([X.ravel(), Y.ravel()]))[1]
    modes = value_function.modes(triangle).reshape(X.shape)
    walls = np.zeros(X.shape, bool)
    step = np.array([right - left, top - bottom]) / (RASTER - 1)
    curves = (
        synthesis.switching_curves
        + synthesis.dispersal_curves
        + [b for b in synthesis.borders if b.optimal]
    )
    for curve in curves + synthesis.reached:
        walls[tuple(_raster(curve.points, np.array([left, bottom]), step))] = True
    regions = _count_regions(modes, walls)
    points = 1 if not synthesis.reached else 0
    text = (
        f"{_count(regions, 'region')}, {_count(len(curves), 'curve')}"
        + (" and the target point" if points else "")
        + " in the window"
    )
    if any(d.free_symbols for d in synthesis.plant.singular) and _vanishes_inside(synthesis):
        return Condition(
            "A",
            False,
            regions,
            text + "; det(f1, [f0, f1]) vanishes somewhere in it, where extremals can be singular",
        )
    return Condition("A", True, regions, text)


def _count_regions(modes, walls):
    from scipy import ndimage

    walls = ndimage.binary_dilation(walls, structure=np.ones((3, 3)))
    count = 0
    for value in range(modes.max() + 1):
        labels, number = ndimage.label((modes == value) & ~walls)
        count += int((np.bincount(labels.ravel(), minlength=number + 1)[1:] > RASTER).sum())
    return count


def _raster(points, corner, step):
    """Return the rows and columns of the raster through which a polyline runs."""
    fine = [
        np.linspace(a, b, max(int(np.ceil(2 * np.max(np.abs(b - a) / step))), 2))
        for a, b in itertools.pairwise(points)
    ]
    index = np.round((np.vstack(fine) - corner) / step).astype(int)
    inside = ((index >= 0) & (index < RASTER)).all(axis=1)
    return index[inside, 1], index[inside, 0]


def _vanishes_inside(synthesis):
    (left, right), (bottom, top) = synthesis.window
    X, Y = np.meshgrid(np.linspace(left, right, 60), np.linspace(bottom, top, 60))
    values = synthesis.plant.singular_at(X.ravel(), Y.ravel())
    return bool(((values.min(axis=1) <= 0) & (values.max(axis=1) >= 0)).any())


def _curves(synthesis):
    """Test condition B by the smallest angle at which a crossed switching curve is crossed."""
    smallest, followed, mixed = np.inf, 0, []
    for curve in synthesis.switching_curves:
        if curve.kind == "followed":
            followed += 1
            continue
        angles = crossing_angles(curve.points, curve.velocities)
        angles = angles[:, np.hypot(*np.diff(curve.points, axis=0).T) > 1e-9]
        if not angles.size:
            continue
        smallest = min(smallest, np.abs(angles).min())
        if curve.kind == "mixed" or (angles[0] * angles[1] <= 0).any():
            mixed.append(curve)
    degrees = np.rad2deg(smallest) if np.isfinite(smallest) else np.nan
    smooth = "smooth" if synthesis.plant.has_interior else "constant"
    text = f"the control is {smooth} in every region; {followed} switching curves are followed (first type)"
    crossed = len(synthesis.switching_curves) - followed
    if crossed:
        text += f", {crossed} are crossed (second type), at {degrees:.3g} degrees or more"
    if mixed:
        text += f"; {len(mixed)} are neither throughout"
    return Condition("B", not mixed, float(degrees), text)


def _arrival(synthesis):
    """Test condition C: find where trajectories meet the target at the angle zero."""
    plant = synthesis.plant
    # Until when they are optimal does not matter here.
    tangent = [b for b in synthesis.borders if b.arrives and b.kind == "abnormal"]
    if not synthesis.reached:
        slow = min(
            np.hypot(*plant.velocity(fan.motion[0][:, moves], fan.mode[0, moves])).min()
            for fan in synthesis._value_function.fans
            if (moves := fan.last_step > 0).any()
        )
        return Condition(
            "C",
            slow > 0,
            float(slow),
            f"the point is reached with a velocity of {slow:.3g} or more",
        )
    if not tangent:
        return Condition(
            "C", True, np.nan, "optimal trajectories cross the target at a non-zero angle"
        )
    points = ", ".join(
        "({:.4g}, {:.4g})".format(*(np.round(b.points[0], 6) + 0.0)) for b in tangent
    )
    return Condition(
        "C",
        False,
        0.0,
        f"optimal trajectories end at the angle zero at {points}: there lambda_0 = 0",
    )


def _passages(synthesis):
    """Test condition D by the largest number of switchings."""
    largest = 0
    for fan in synthesis._value_function.fans:
        if fan.switchings.shape[1]:
            index = fan.switchings[0].astype(int)
            inside = synthesis._inside(fan.switchings[2:]) & (
                fan.switchings[1] <= fan.optimal_until[index]
            )
            largest = max(largest, int(np.bincount(index[inside], minlength=1).max()))
    return Condition(
        "D",
        True,
        largest,
        f"at most {_count(largest, 'switching')} on a trajectory in the window, then the target",
    )


def _maximum(synthesis):
    """Test condition E on the stored covectors: the signs of the surfaces, and H = 0."""
    worst, plant = 0.0, synthesis.plant
    for fan in synthesis._value_function.fans:
        k, j = np.nonzero(np.isfinite(fan.path[:, 0]) & (fan.mode >= 0) & (fan.last_step > 0))
        z, mode = fan.motion[k, :, j].T, fan.mode[k, j]
        v, cost_rate = plant.velocity(z, mode), plant.costs(z, mode)
        size = np.hypot(*z[2:4]) * (np.hypot(*v) + np.hypot(*z[:2]) + 1) + z[4] * (
            np.abs(cost_rate) + 1
        )
        against = -plant.surfaces(z) * plant.required_sign[mode].T
        energy = (z[2:4] * v).sum(axis=0) - z[4] * cost_rate
        worst = max(
            worst, np.max(against / size, initial=0), np.max(np.abs(energy) / size, initial=0)
        )
    return Condition(
        "E",
        bool(worst < 1e-7),
        float(worst),
        f"maximum condition and H = 0 up to {worst:.1e} along all extremals",
    )


def _continuity(synthesis):
    """Test condition F by the jumps of the cost across barriers."""
    barriers = synthesis.barriers
    if not barriers:
        return Condition(
            "F", True, 0.0, f"the {_cost_name(synthesis)} is continuous across all curves"
        )
    jump = max(b.jump for b in barriers)
    if np.isinf(jump):
        finite = [b.jump for b in barriers if np.isfinite(b.jump)]
        text = f"{len(barriers) - len(finite)} barriers border points from which the target is not reached"
        if finite:
            text += f"; across {len(finite)} others the {_cost_name(synthesis)} jumps by up to {max(finite):.3g}"
        return Condition("F", not finite, jump, text)
    return Condition(
        "F",
        False,
        float(jump),
        f"{len(barriers)} barriers; across them the {_cost_name(synthesis)} jumps by up to {jump:.3g}",
    )


def _cost_name(synthesis):
    if synthesis.plant.counts_time:
        return "least time"
    return "greatest value" if synthesis.problem.maximise else "least cost"
