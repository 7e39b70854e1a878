"""How long a call takes, for benchmarks that time a function against a peer in the same process;
and what a command takes of the clock and of the processors, with all processes that it starts."""

import ctypes
import os
import statistics
import subprocess
import time
from contextlib import suppress
from dataclasses import dataclass

PR_SET_CHILD_SUBREAPER = 36


def seconds(function, runs, clock=time.perf_counter):
    """The median of several runs of `function()`, in seconds of the clock, on the wall unless given."""
    taken = []
    for _ in range(runs):
        start = clock()
        function()
        taken.append(clock() - start)
    return statistics.median(taken)


@dataclass(frozen=True)
class Taken:
    """Seconds on the wall, and of the processors."""

    wall: float
    processor: float

    def __add__(self, other):
        return Taken(self.wall + other.wall, self.processor + other.processor)

    def __sub__(self, other):
        return Taken(self.wall - other.wall, self.processor - other.processor)

    def __mul__(self, number):
        return Taken(self.wall * number, self.processor * number)

    def __truediv__(self, other):
        """By a number, or the ratio to another one, each kind of seconds for itself."""
        if not isinstance(other, Taken):
            other = Taken(other, other)
        return Taken(self.wall / other.wall, self.processor / other.processor)


def run(command, **options):
    """Run a command to its end as `subprocess.run` does; returns what that returns, and what it has
    `Taken`.

    A process whose parent ended before it counts as well: it becomes a child of this one (on
    Linux).
    """
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    before, start = _of_children(), time.perf_counter()
    done = subprocess.run(command, **options)
    wall = time.perf_counter() - start
    with suppress(ChildProcessError):
        while True:
            os.wait()
    return done, Taken(wall, _of_children() - before)


def _of_children():
    used = os.times()
    return used.children_user + used.children_system
