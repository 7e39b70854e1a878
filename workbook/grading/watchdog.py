"""Wait for what a notebook hands over, and see to it that all its processes together keep within
its limits.

The kernel's own limits bind one process each. What a notebook's whole tree of processes uses is
summed up ten times a second: memory with what processes share counted once (PSS), processor time,
processes and threads, and sockets, whose buffers are memory of no process. Time in which none of
them wants to compute counts as if one did: a notebook that sleeps keeps its place no longer than
one that computes, while one that waits for a busy machine does. The clock on the wall stands still
for as long as others have the processors.
"""

import os
import signal
import time
from contextlib import suppress

from workbook.grading import framing

INTERVAL = 0.1
#: Of what is handed over: room is left for a word on how the notebook ended.
LARGEST = framing.LONGEST - 100
#: Said by the notebook's process when it is confined, before it runs anything of the notebook.
PREPARED = b"prepared"
PREPARATION = 30.0
#: At a time; those that were closed with something unread in them count too.
MOST_SOCKETS = 100
#: The part of its time that a notebook may wait for a disk besides. Who forks by `vfork` and lets
#: the child sleep seems to wait for one as well.
AT_DISK = 0.25
TICK, PAGE = os.sysconf("SC_CLK_TCK"), os.sysconf("SC_PAGE_SIZE")


class Exceeded(RuntimeError):
    """The processes together use more than they may; the message is the limit: time, memory,
    processes or sockets."""


class Watch:
    """Over the notebook that runs below the process `keeper` and hands over on `descriptor`.

    First wait until it is `prepared`, then give it its request, then wait for its `answers`. `proc`
    is a descriptor of the /proc in which `keeper` is to be found. `wake()` reaches the process that
    runs the cells, if there is a way to it: a cell that sleeps for half of the time left is stopped
    so, as `cells` does with one that computes.
    """

    def __init__(self, keeper, descriptor, limits, proc, own_network=True, wake=lambda: None):
        self._keeper, self._descriptor, self._limits = keeper, descriptor, limits
        self._proc, self._own_network, self._wake = proc, own_network, wake

    def prepared(self):
        """Wait until the notebook's process is confined, and note what getting ready took, which is
        not the notebook's."""
        try:
            self._said = framing.receive(self._descriptor, timeout=PREPARATION)
        except framing.Broken as broken:
            self._said = f"not prepared ({broken})".encode()
        before = _descendants(self._keeper, self._proc)
        self._sockets, self._seconds = _sockets(before, self._proc), _seconds(before)
        self._withheld = _withheld(before, self._proc)

    def answers(self):
        """(how it ended, message): "done", or the limit that ended it ("time", "memory",
        "processes", "sockets", "large"), or "died", or "failed" if its process could not be
        prepared."""
        if self._said != PREPARED:
            return b"failed", self._said
        self._begun = self._looked = time.monotonic()
        self._idle = self._idle_at_a_stretch = self._at_disk = 0.0
        try:
            message = framing.receive(
                self._descriptor,
                self._limits["wall_seconds"] + self._limits["withheld_seconds"],
                self._look,
                INTERVAL,
            )
            return (b"done", message) if len(message) <= LARGEST else (b"large", b"")
        except Exceeded as limit:
            return str(limit).encode(), b""
        except framing.Broken as broken:
            return {"time": b"time", "large": b"large", "closed": b"died"}[str(broken)], b""

    def _look(self):
        processes = _descendants(self._keeper, self._proc)
        _compare(processes, self._limits, self._seconds - self._idle, self._proc)
        self._count_idle(processes)
        if self._own_network and _sockets(processes, self._proc) > self._sockets + MOST_SOCKETS:
            raise Exceeded("sockets")
        late = time.monotonic() - self._begun - self._limits["wall_seconds"]
        if late > 0 and late > _withheld(processes, self._proc) - self._withheld:
            raise Exceeded("time")

    def _count_idle(self, processes):
        now = time.monotonic()
        # For what nobody looked at, since this process itself waited for a busy machine, it is not
        # held to have slept.
        since, self._looked = min(now - self._looked, 2 * INTERVAL), now
        states = _states(processes, self._proc)
        if b"R" in states:
            self._idle_at_a_stretch = 0.0
            return
        if b"D" in states and self._at_disk < self._limits["cpu_seconds"] * AT_DISK:
            self._at_disk += since
            return
        self._idle += since
        self._idle_at_a_stretch += since
        left = self._limits["cpu_seconds"] - (_seconds(processes) - self._seconds + self._idle)
        if self._idle_at_a_stretch > left:  # half of what was left when it fell asleep
            self._idle_at_a_stretch = 0.0
            self._wake()


def end_descendants(proc):
    """Kill whatever is left below this process, to which orphans come."""
    while left := _descendants(os.getpid(), proc):
        # Stopped first, so that none multiplies while the others are killed.
        for kind in (signal.SIGSTOP, signal.SIGKILL):
            for process in left:
                with suppress(ProcessLookupError, PermissionError):
                    os.kill(process.number, kind)
        with suppress(ChildProcessError):
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass


def _compare(processes, limits, seconds_before, proc):
    if _seconds(processes) - seconds_before > limits["cpu_seconds"]:
        raise Exceeded("time")
    if sum(one.threads for one in processes) > limits["processes"]:
        raise Exceeded("processes")
    bound = limits["memory_megabytes"] * 2**20
    # What each has resident is at hand, but counts shared pages many times: the exact sum is made
    # only when it matters. Twice, since what one of them leaves when it ends is shared by fewer,
    # and counts more in those read after that.
    if sum(one.resident for one in processes) > bound and all(
        sum(_share(one, proc) for one in processes) > bound for _ in range(2)
    ):
        raise Exceeded("memory")


def _states(processes, proc):
    """What all threads are doing, as the letters of /proc: R runs or waits for a processor, D waits
    for a disk."""
    found = {one.state for one in processes}
    for one in processes:
        if b"R" in found:  # that is all that anybody wants to know
            break
        if one.threads > 1:
            found |= {
                _Process(one.number, line).state
                for thread in _listed(f"{one.number}/task", proc)
                if (line := _read(f"{one.number}/task/{thread}/stat", proc))
            }
    return found


def _seconds(processes):
    return sum(one.seconds for one in processes)


def _withheld(processes, proc):
    """Seconds that the thread which has waited longest has waited for a processor; 0 where the
    kernel does not tell.

    The longest, not the sum: threads that wait for each other must not gain by their number.
    """
    waited = (
        _read(f"{one.number}/task/{thread}/schedstat", proc).split()
        for one in processes
        for thread in _listed(f"{one.number}/task", proc)
    )
    return max((int(fields[1]) / 1e9 for fields in waited if len(fields) == 3), default=0.0)


def _sockets(processes, proc):
    """How many there are in the network of the innermost process."""
    words = (
        _read(f"{processes[-1].number}/net/sockstat", proc).split(b"\n")[0].split()
        if processes
        else []
    )
    return int(words[2]) if len(words) == 3 else 0


class _Process:
    """A line of /proc/<number>/stat."""

    def __init__(self, number, line):
        # The name, which the process itself chooses, stands in brackets; after the last one there
        # are only numbers.
        fields = line.rpartition(b")")[2].split()
        self.number, self.state, self.parent, self.threads = (
            number,
            fields[0],
            int(fields[1]),
            int(fields[17]),
        )
        # its own and that of its children already gone
        self.seconds = sum(map(int, fields[11:15])) / TICK
        self.resident = int(fields[21]) * PAGE


def _descendants(ancestor, proc):
    found = [one for name in os.listdir(proc) if name.isdigit() and (one := _process(name, proc))]
    children = {}
    for one in found:
        children.setdefault(one.parent, []).append(one)
    below = list(children.get(ancestor, ()))
    for one in below:
        below += children.get(one.number, ())
    return below


def _process(name, proc):
    line = _read(f"{name}/stat", proc)
    return _Process(int(name), line) if line else None


def _share(process, proc):
    """Resident memory with shared pages divided among those who share them."""
    for line in _read(f"{process.number}/smaps_rollup", proc).split(b"\n"):
        if line.startswith(b"Pss:"):
            return int(line.split()[1]) * 1024
    # It is ending, and by now has nothing resident; or the kernel does not tell.
    now = _process(str(process.number), proc)
    return now.resident if now else 0


def _listed(path, proc):
    with suppress(OSError):
        folder = os.open(path, os.O_RDONLY | os.O_DIRECTORY, dir_fd=proc)
        try:
            return os.listdir(folder)
        finally:
            os.close(folder)
    return []


def _read(path, proc):
    def opener(name, flags):
        return os.open(name, flags, dir_fd=proc)

    with suppress(OSError), open(path, "rb", opener=opener) as file:  # the process may have ended
        return file.read()
    return b""
