"""The arcs that the maximum condition requires along a given trajectory."""

from dataclasses import replace

import numpy as np

from trajlib.pontryagin.problem.arcs import Arc, arc_name

# Where the maximum condition is tested on a segment: densely at its ends, where a short arc may be
# missing.
FRACTIONS = np.concatenate(
    [
        [1e-5, 1e-4, 1e-3],
        (1 - np.cos(np.pi * np.arange(1, 32) / 32)) / 2,
        [1 - 1e-3, 1 - 1e-4, 1 - 1e-5],
    ]
)


def required_arcs(numeric, shot):
    """Return (description, arcs) that the maximum condition requires along the trajectory.

    The description is empty if they are those of the trajectory.
    """
    rows, lengths, touches, description = [], [], [], ""
    for flow, start, length, steps in zip(shot.flows, shot.starts, shot.lengths, shot.steps):
        # As many steps as the solution takes, so that short arcs are not lost in errors of integration.
        edges = np.append(0.0, FRACTIONS)
        parts = int(np.ceil(steps * np.diff(edges).max()))
        fractions = np.interp(
            np.arange(1, parts * len(FRACTIONS) + 1) / parts, range(len(edges)), edges
        )
        points = flow.nodes(
            np.append(start, 0.0), shot.multiplier, length, len(fractions), fractions
        )[parts::parts, :-1]
        slopes, controls = (
            flow.values(function, points.T, shot.multiplier) for function in ("slopes", "control")
        )
        columns = [
            _required_kinds(numeric, flow.kinds[j], j, slopes[j], controls[j], shot)
            for j in range(numeric.k)
        ]
        labels = list(zip(*columns))
        required = next((label for label in labels if label != flow.kinds), None)
        if required and not description:
            description = f"the arc {arc_name(flow.kinds)}, where {arc_name(required)} is wanted"
        rows += labels
        touches += [flow.touch] + [None] * (len(labels) - 1)
        edges = np.concatenate([[0.0], (FRACTIONS[1:] + FRACTIONS[:-1]) / 2, [1.0]])
        lengths += list(length * np.diff(edges))
    arcs, time = [], 0.0
    for label, length, touch in zip(rows, lengths, touches):
        if arcs and arcs[-1].kinds == label and touch is None:
            arcs[-1] = replace(arcs[-1], end=time + length)
        else:
            arcs.append(Arc(label, time, time + length, touch))
        time += length
    return description, arcs


def _required_kinds(numeric, kind, j, slopes, controls, shot):
    """Return the kind that maximises H at each point; the present one up to rounding."""
    low, high = numeric.lower[j], numeric.upper[j]
    margin = 1e-9 * (
        1 + max(np.max(np.abs(start[numeric.n : 2 * numeric.n])) for start in shot.starts)
    )
    if kind in ("u-", "u+"):
        inward = slopes > margin if kind == "u-" else slopes < -margin
        inner_kind = (
            ({"u-": "u+", "u+": "u-"}[kind] if np.isfinite([low, high]).all() else "singular")
            if numeric.affine[j]
            else "interior"
        )
        return [inner_kind if wrong else kind for wrong in inward]
    width = 1e-7 * (1 + np.max(np.abs(controls)))
    return ["u-" if u < low - width else "u+" if u > high + width else kind for u in controls]
