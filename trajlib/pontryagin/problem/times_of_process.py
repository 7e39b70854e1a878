"""The times at which a process is asked for."""

import numpy as np


def times_of_process(t, duration):
    """Return times within a duration as an array, (N,); raise ValueError for others."""
    times = np.atleast_1d(np.asarray(t, dtype=float))
    if times.ndim != 1:
        raise ValueError(
            f"t: expected a number or a one-dimensional array, got shape {times.shape}"
        )
    slack = 1e-9 * duration
    if not np.all((times >= -slack) & (times <= duration + slack)):
        raise ValueError(f"t: expected times between 0 and the duration {duration:.6g}")
    return np.clip(times, 0, duration)
