"""How long a call takes, for benchmarks that time a function against a peer in the same process."""

import statistics
import time


def seconds(function, runs):
    """The median of several runs of `function()`, in seconds on the wall."""
    taken = []
    for _ in range(runs):
        start = time.perf_counter()
        function()
        taken.append(time.perf_counter() - start)
    return statistics.median(taken)
