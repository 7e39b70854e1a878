"""Reading of numbers, intervals and points, with errors that name the argument."""

import operator

import numpy as np


def read_positive(value, name, unit):
    """Return a positive finite number."""
    value = read_number(value, name)
    if value <= 0:
        raise ValueError(f"{name}: expected a positive number ({unit}), got {value:g}")
    return value


def read_number(value, name):
    """Return a finite number."""
    try:
        value = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected a number, got {value!r}") from None
    if not np.isfinite(value):
        raise ValueError(f"{name}: expected a finite number, got {value}")
    return value


def read_count(value, name, least):
    """Return an integer that is not below `least`."""
    try:
        value = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected a whole number, got {value!r}") from None
    if value < least:
        raise ValueError(f"{name}: expected {least} or more, got {value}")
    return value


def read_pair(value, name, meaning="(low, high)"):
    """Return two finite numbers, the first not above the second."""
    ends = _floats(value, name, meaning)
    if ends.shape != (2,) or not np.isfinite(ends).all() or ends[0] > ends[1]:
        raise ValueError(f"{name}: expected {meaning} with low <= high, got {value!r}")
    return float(ends[0]), float(ends[1])


def read_vectors(value, name, length=2):
    """Return finite numbers in an array of shape (..., length)."""
    value = _floats(value, name, f"numbers of shape (..., {length})")
    if value.ndim == 0 or value.shape[-1] != length:
        raise ValueError(f"{name}: expected shape (..., {length}), got {value.shape}")
    if not np.isfinite(value).all():
        raise ValueError(f"{name}: expected finite numbers")
    return value


def read_arc(value, name):
    """Return (low, width) of an arc of headings in radians.

    The full circle if None, a single heading if a number.
    """
    if value is None:
        return 0.0, 2 * np.pi
    ends = np.atleast_1d(_floats(value, name, "a heading or (low, high)"))
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


def _floats(value, name, expected):
    try:
        return np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected {expected}, got {value!r}") from None


def read_mode(value):
    """Return one of the two modes."""
    if value not in ("guaranteed", "published"):
        raise ValueError(f'mode: expected "guaranteed" or "published", got {value!r}')
    return value
