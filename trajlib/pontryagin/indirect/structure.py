"""The arc structure of an extremal, detected in a discrete solution."""

import itertools

import numpy as np

from trajlib.pontryagin.direct.transcription import DirectSolution
from trajlib.pontryagin.indirect.contacts import (
    Contact,
    contact_structures,
    with_boundary_labels,
    with_touch_points,
)
from trajlib.pontryagin.problem.arcs import BOUNDARY, CONSTANT_ANGLES, KINDS, Arc
from trajlib.pontryagin.problem.numeric import NumericProblem

# Share of the distance between the bounds up to which a control counts as being at one of them, and
# the same for the bound alone: the distance that IPOPT leaves at an active bound.
NEAR, AT = 1e-3, 1e-6
# Sine of the angle to an axis, and share of the intervals, up to which an angle stays on that axis.
OFF_AXIS = 0.1


def candidate_structures(numeric, solution):
    """Yield the lists of arcs that a discrete solution may have, the likeliest first.

    Where an angle alternates along an axis, it may be constant on its arcs. A control that
    approaches its bound ever more slowly, as where psi has a multiple zero at the end, is near the
    bound long before: it may be on an interior arc to the end. Where a switching function is flat about
    a zero, switchings may be closer to one another than the grid shows.
    """
    contact_lists = contact_structures(numeric, solution)
    on_axis = any(stays_on_axis(numeric, solution, i) for i in range(numeric.k))
    structures = []
    options = ({"constant_angles": True},) * on_axis + ({}, {"tolerance": AT})
    options += ({"tolerance": AT, "more_switchings": True},) * any(numeric.affine)
    for contacts, option in itertools.product(contact_lists, options):
        arcs = detect_arcs(numeric, solution, **option, contacts=contacts)
        kinds = [(arc.kinds, arc.touch) for arc in arcs]
        if kinds not in structures:
            structures.append(kinds)
            yield arcs


def detect_arcs(
    numeric: NumericProblem,
    solution: DirectSolution,
    tolerance: float = NEAR,
    constant_angles: bool = False,
    more_switchings: bool = False,
    contacts: list[Contact] | None = None,
) -> list[Arc]:
    """Return the arcs of a discrete solution.

    `constant_angles`: an angle along one axis is taken to be constant but for jumps by half a turn.
    `more_switchings`: what would be a singular arc between bounds is a group of switchings.
    An interval belongs to a bound if its control is there to within `tolerance` of the distance
    between the bounds. `contacts`: with the boundaries of path constraints, by default the
    likeliest. One or two intervals between different bounds are a switching between the
    nodes.
    """
    N = len(solution.controls)
    columns = [
        _constant_angle_labels(solution.controls[:, i])
        if constant_angles and stays_on_axis(numeric, solution, i)
        else _labels(numeric, solution, i, tolerance)
        for i in range(numeric.k)
    ]
    if contacts is None:
        contacts = contact_structures(numeric, solution)[0]
    columns = with_boundary_labels(numeric, solution, columns, contacts)
    boundaries = [
        _runs(numeric, solution, i, column, more_switchings) for i, column in enumerate(columns)
    ]
    edges = sorted({0.0, float(N)} | {begin for runs in boundaries for _, begin, _ in runs})
    step = solution.duration / N
    arcs = []
    for begin, end in itertools.pairwise(edges):
        middle = (begin + end) / 2
        kinds = tuple(next(kind for kind, b, e in runs if b <= middle <= e) for runs in boundaries)
        arcs.append(Arc(kinds, begin * step, end * step))
    return with_touch_points(arcs, contacts)


def axis_of(angles):
    """Return the direction of the axis along which angles point in the mean."""
    return np.angle(np.mean(np.exp(2j * angles))) / 2


def stays_on_axis(numeric, solution, i):
    """Check whether a control is an angle that alternates along one axis nearly always."""
    angles = solution.controls[:, i]
    turned = np.cos(angles - axis_of(angles)) > 0
    off_axis = np.abs(np.sin(angles - axis_of(angles))) > OFF_AXIS
    return numeric.angles[i] and 0 < turned.sum() < len(turned) and off_axis.mean() < OFF_AXIS


def _constant_angle_labels(angles):
    ahead, back = CONSTANT_ANGLES
    return np.where(np.cos(angles - axis_of(angles)) > 0, ahead, back)


def _labels(numeric, solution, i, tolerance):
    """Return "u-", "u+" or "between" for each interval."""
    u, low, high = solution.controls[:, i], numeric.lower[i], numeric.upper[i]
    width = high - low if np.isfinite(high - low) else 1 + np.ptp(u)
    return np.where(
        u <= low + tolerance * width, "u-", np.where(u >= high - tolerance * width, "u+", "between")
    )


def _runs(numeric, solution, i, labels, more_switchings):
    """Return [(kind, begin, end)] in units of the intervals."""
    runs = _run_lengths(labels)
    between = "singular" if numeric.affine[i] else "interior"
    # Where H is concave in the control, it moves continuously from bound to bound; elsewhere it
    # jumps.
    bounded = np.isfinite([numeric.lower[i], numeric.upper[i]]).all()
    if numeric.affine[i]:
        runs = _without_ringing(runs)
        if more_switchings:
            runs = _with_more_switchings(numeric, solution, i, runs)
    result = []
    for index in range(len(runs)):
        label, begin, end = runs[index]
        if label != "between":
            result.append((label, float(begin), float(end)))
            continue
        beside = [r[0].startswith(BOUNDARY) for r in runs[max(index - 1, 0) : index + 2]]
        if numeric.affine[i] and end - begin <= 2 and any(beside):
            # The way to a boundary arc, or from it, inside of an interval.
            continue
        interval = slice(begin, end)
        if (
            bounded
            and end - begin <= 2
            and len(runs) > 1
            and not numeric.concave(
                i,
                solution.states[interval],
                solution.costates[begin + 1 : end + 1],
                solution.controls[interval],
            )
        ):
            # A switching inside the interval, located by the mean control.
            result, runs = _split(numeric, solution, i, result, runs, index)
            continue
        result.append((between, float(begin), float(end)))
    return _merged(_joined(result, len(solution.controls)))


def _joined(runs, count):
    """Return the runs with gaps between them closed halfway, from 0 to the number of intervals."""
    ends = [0.0, *((a[2] + b[1]) / 2 for a, b in itertools.pairwise(runs)), float(count)]
    return [(label, begin, end) for (label, _, _), begin, end in zip(runs, ends, ends[1:])]


def _without_ringing(runs):
    """Join single intervals at a bound within a singular arc to it: numerical ringing."""
    changed = list(runs)
    for index, (label, begin, end) in enumerate(runs):
        neighbours = [
            r
            for r in (
                runs[index - 1] if index else None,
                runs[index + 1] if index + 1 < len(runs) else None,
            )
            if r
        ]
        if (
            label != "between"
            and end - begin <= 2
            and len(neighbours) == 2
            and all(r[0] == "between" for r in neighbours)
            and max(r[2] - r[1] for r in neighbours) >= 3
        ):
            changed[index] = ("between", begin, end)
    return _merged(changed)


def _with_more_switchings(numeric, solution, i, runs):
    """Replace long runs between two bounds by three switchings, or by two at the same bound.

    They lie symmetrically about the one that the mean of the control asks for.
    """
    opposite, result = {"u-": "u+", "u+": "u-"}, []
    for index, (label, begin, end) in enumerate(runs):
        before, after = (runs[j][0] if 0 <= j < len(runs) else None for j in (index - 1, index + 1))
        if label != "between" or end - begin <= 2 or not {before, after} <= set(opposite):
            result.append((label, begin, end))
            continue
        share = _share_of(before, numeric, solution, i, begin, end)
        if before == after:
            edge = share * (end - begin) / 2
            ends, kinds = [begin, begin + edge, end - edge, end], [before, opposite[before], before]
        else:
            middle = begin + share * (end - begin)
            edge = min(middle - begin, end - middle) / 2
            ends = [begin, middle - edge, middle, middle + edge, end]
            kinds = [before, after, before, after]
        result += list(zip(kinds, ends, ends[1:]))
    return _merged(result)


def _share_of(bound, numeric, solution, i, begin, end):
    """Return the share of the intervals on which a control of the same mean is at this bound."""
    low, high = numeric.lower[i], numeric.upper[i]
    share = (np.mean(solution.controls[begin:end, i]) - low) / (high - low)
    return float(np.clip(share if bound == "u+" else 1 - share, 0.02, 0.98))


def _run_lengths(labels):
    edges = [0, *(np.nonzero(labels[1:] != labels[:-1])[0] + 1), len(labels)]
    return [(str(labels[b]), b, e) for b, e in itertools.pairwise(edges)]


def _merged(runs):
    result = []
    for label, begin, end in runs:
        if result and result[-1][0] == label:
            result[-1] = (label, result[-1][1], end)
        else:
            result.append((label, begin, end))
    return result


def _split(numeric, solution, i, result, runs, index):
    """Divide a short run between the bounds among its neighbours by the mean of the control.

    At the ends of the trajectory, or between two arcs at the same bound, the other bound gets a
    share: a short arc there is not visible otherwise. It shrinks to nothing later if it is not one.
    """
    _, begin, end = runs[index]
    value = {"u-": numeric.lower[i], "u+": numeric.upper[i]}
    before = result[-1][0] if result else None
    after = runs[index + 1][0] if index + 1 < len(runs) else None
    neighbour_bounds = [side for side in (before, after) if side in value]
    mean = solution.controls[begin:end, i].mean()
    opposite = {"u-": "u+", "u+": "u-"}[neighbour_bounds[0]]
    if len(neighbour_bounds) == 2 and before != after:
        cut = begin + (end - begin) * float(
            np.clip((mean - value[after]) / (value[before] - value[after]), 0, 1)
        )
        return [*result[:-1], (before, result[-1][1], cut)], [
            *runs[: index + 1],
            (after, cut, runs[index + 1][2]),
            *runs[index + 2 :],
        ]
    share = (end - begin) * float(
        np.clip(
            (mean - value[neighbour_bounds[0]]) / (value[opposite] - value[neighbour_bounds[0]]),
            0.02,
            1,
        )
    )
    if before is None:
        return [(opposite, begin, begin + share)], [
            *runs[: index + 1],
            (after, begin + share, runs[index + 1][2]),
            *runs[index + 2 :],
        ]
    first = end - share if after is None else (begin + end - share) / 2
    result = [*result[:-1], (before, result[-1][1], first), (opposite, first, first + share)]
    if after is not None:
        runs = [*runs[: index + 1], (after, first + share, runs[index + 1][2]), *runs[index + 2 :]]
    return result, runs


def read_structure(numeric: NumericProblem, structure) -> list[tuple[str, ...]]:
    """Return the user's arcs as a list of kinds, one tuple for each arc.

    Raises TypeError or ValueError if they are not of that form.
    """
    if isinstance(structure, str) or not hasattr(structure, "__iter__"):
        raise TypeError(
            "structure: expected a list of arcs such as ['u-', 'singular', 'u+'], got "
            f"{structure!r}"
        )
    result: list[tuple[str, ...]] = []
    for arc in structure:
        kinds = (arc,) if isinstance(arc, str) else tuple(arc)
        if len(kinds) != numeric.k or any(kind not in KINDS for kind in kinds):
            raise ValueError(
                f"structure: expected one of {', '.join(KINDS)} for each of {numeric.k} controls, "
                f"got {arc!r}"
            )
        for i, kind in enumerate(kinds):
            expected = {True: "singular", False: "interior"}[numeric.affine[i]]
            if kind in ("singular", "interior") and kind != expected:
                raise ValueError(
                    f"structure: H is {'' if numeric.affine[i] else 'not '}linear in "
                    f"{numeric.problem.control[i]}, "
                    f"so its arcs between the bounds are {expected}, not {kind}"
                )
        if result and result[-1] == kinds:
            raise ValueError(f"structure: two arcs {arc!r} in succession are one arc")
        result.append(kinds)
    if not result:
        raise ValueError("structure: expected at least one arc")
    return result
