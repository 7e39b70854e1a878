"""From a discrete solution to one of less cost: by needle variations and away from saddles."""

import numpy as np

from trajlib.pontryagin.direct.transcription import (
    INTERVALS,
    Picture,
    Transcription,
    target_multipliers,
)
from trajlib.pontryagin.verification.second_variation import (
    ABNORMAL,
    of_picture,
    second_variation,
)

# What needles have to lower a cost by, as a share of it, to be tried.
NEEDLES = 1e-3


def descend(numeric, picture, side):
    """The picture, or a better one to which the cost falls from it: along the controls that make H
    largest, and from a saddle along its steepest direction.
    """
    for _ in range(4):
        if np.max(np.abs(picture.costates)) > ABNORMAL:
            return picture
        better = _with_needles(numeric, picture, side)
        if better is not None:
            picture = better
            continue
        variation = second_variation(
            numeric, of_picture(numeric, picture, target_multipliers(numeric, picture))
        )
        if variation.sign >= 0:
            return picture
        better = escaped(numeric, picture, variation, side)
        if better is None:
            return picture
        picture = better
    return picture


def _with_needles(numeric, picture, side):
    """A picture of less cost, found from the controls that make H largest in each interval; None if
    there is none.

    Stationary controls need not make H largest where it is not concave, and the integral of what is
    missing is by how much short changes of the control (needles) lower the cost to first order.
    """
    if not any(
        curved and bounded
        for curved, bounded in zip(
            ~np.array(numeric.affine), np.isfinite(numeric.upper - numeric.lower)
        )
    ):
        return None
    middles = (picture.states[1:] + picture.states[:-1]) / 2
    best, excess = numeric.best_controls(middles, picture.costates[1:], picture.controls)
    if not excess @ np.diff(picture.times) > NEEDLES * (NEEDLES + abs(picture.cost)):
        return None
    result = with_controls(numeric, picture, side, best)
    return (
        result if result and result.cost < picture.cost - 1e-9 * (1 + abs(picture.cost)) else None
    )


def with_controls(numeric, picture, side, controls):
    """The picture to which other controls lead, or None."""
    result = Transcription(numeric, len(controls), None, side).solve(
        (picture.duration, picture.states, controls)
    )
    return result if isinstance(result, Picture) else None


def escaped(numeric, picture, variation, side):
    """A picture of less cost, found along the least direction of the second variation; None if
    there is none."""
    programme, best = Transcription(numeric, len(picture.controls), None, side), None
    width = np.where(
        np.isfinite(numeric.upper - numeric.lower), (numeric.upper - numeric.lower) / 2, 1.0
    )
    length = np.max(
        np.abs(variation.controls) / width,
        initial=np.max(np.abs(variation.widths)) / np.min(np.diff(picture.times)),
    )
    for size in (0.3 / length, -0.3 / length):
        duration = picture.duration + size * float(variation.widths.sum())
        result = programme.solve(
            (
                max(duration, 0.1 * picture.duration),
                picture.states + size * variation.states,
                picture.controls + size * variation.controls,
            )
        )
        if isinstance(result, Picture) and result.cost < (best or picture).cost - 1e-9 * (
            1 + abs(picture.cost)
        ):
            best = result
    return best


def finer_picture(numeric, picture, side, factor):
    """The picture on a grid that is finer by a factor, or None."""
    programme = Transcription(numeric, factor * INTERVALS, side=side)
    result = programme.solve((picture.duration, picture.states, picture.controls))
    return result if isinstance(result, Picture) else None
