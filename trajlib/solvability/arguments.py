"""Reading what callers give, with errors that name the cause."""

import numpy as np


def read_times(times):
    """One or more increasing finite times."""
    times = np.asarray(times, dtype=float)
    if times.ndim != 1 or times.size == 0:
        raise ValueError(f"times: expected a list of times, got shape {times.shape}")
    if not np.isfinite(times).all():
        raise ValueError(f"times: entry {np.flatnonzero(~np.isfinite(times))[0]} is not finite")
    steps = np.diff(times)
    if (steps <= 0).any():
        k = int(np.flatnonzero(steps <= 0)[0])
        if steps[k] == 0:
            raise ValueError(
                f"times: {times[k]:g} is repeated; put the measurements of one moment into one "
                "function or matrix H"
            )
        raise ValueError(
            f"times: they must increase, but {times[k]:g} is followed by {times[k + 1]:g}; sort "
            "them, with their measurements"
        )
    return times


def read_matrix(matrix, name, dtype=float):
    """A two-dimensional array with finite entries."""
    matrix = np.asarray(matrix)
    try:
        matrix = matrix.astype(dtype)
    except (TypeError, ValueError):
        raise TypeError(
            f"{name}: expected a matrix of numbers, got entries such as {matrix.flat[0]!r}; "
            "substitute numbers first"
        ) from None
    if matrix.ndim != 2:
        raise ValueError(f"{name}: expected a matrix, got shape {matrix.shape}")
    if not np.isfinite(matrix).all():
        row, column = np.argwhere(~np.isfinite(matrix))[0]
        raise ValueError(f"{name}: the entry ({row}, {column}) is not finite")
    return matrix


def read_names(names, m, what="names"):
    """m words; x0, x1, ... if None."""
    if names is None:
        return tuple(f"x{j}" for j in range(m)) if what == "names" else ("",) * m
    names = tuple(str(name) for name in ([names] if isinstance(names, str) else names))
    if len(names) != m:
        raise ValueError(f"{what}: expected {m}, one for each unknown, got {len(names)}")
    return names
