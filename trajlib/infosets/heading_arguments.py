"""Reading of the arguments that all information sets share: headings and the mode."""

import numpy as np

from trajlib._arguments.arrays import read_array


def read_arc(value, name):
    """Return (low, width) of an arc of headings in radians.

    The full circle if None, a single heading if a number.
    """
    if value is None:
        return 0.0, 2 * np.pi
    ends = np.atleast_1d(read_array(value, name, "a heading or (low, high)"))
    if (
        ends.ndim != 1
        or ends.size > 2
        or not np.isfinite(ends).all()
        or not 0 <= ends[-1] - ends[0] <= 2 * np.pi
    ):
        raise ValueError(
            f"{name}: expected a heading or (low, high), low <= high <= low + 2 pi, in radians, "
            f"got {value!r}"
        )
    return float(ends[0]), float(ends[-1] - ends[0])


def read_mode(value):
    """Return one of the two modes."""
    if value not in ("guaranteed", "published"):
        raise ValueError(f'mode: expected "guaranteed" or "published", got {value!r}')
    return value
