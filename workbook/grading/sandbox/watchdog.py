"""Watchdog: enforce limits on all processes of a notebook together.

The kernel's own limits bind each process by itself. What a notebook's whole tree of processes uses
is summed up ten times a second: memory with shared pages counted once (PSS), processor time,
processes and threads, and sockets, whose buffers are memory of no process. Time in which none of
them wants to compute counts as computing: a notebook that sleeps is ended as soon as one that
computes. Wall time does not run while others have the processors, so a busy machine costs a
notebook nothing.
"""

import os
import signal
import time
from contextlib import suppress

from workbook.grading.sandbox import framing

#: Seconds between two checks.
INTERVAL = 0.1
#: Bytes handed over: a message on how the notebook ended must still fit.
MAX_ANSWERS = framing.MAX_MESSAGE - 100
#: Sent by the notebook's process when it is confined, before it runs anything of the notebook.
PREPARED = b"prepared"
PREPARE_SECONDS = 30.0
#: At a time; those that were closed with something unread in them count too.
MAX_SOCKETS = 100
#: The part of its time that a notebook may wait for a disk in addition. A process that forks by
#: `vfork` and lets the child sleep seems to wait for a disk as well.
DISK_SHARE = 0.25
CLOCK_TICKS, PAGE_BYTES = os.sysconf("SC_CLK_TCK"), os.sysconf("SC_PAGE_SIZE")


class LimitExceededError(RuntimeError):
    """The processes together exceed a limit: "time", "memory", "processes" or "sockets"."""


class Watchdog:
    """Watches the notebook whose processes descend from `ancestor`.

    First call `wait_until_prepared`, then send the notebook its request, then call
    `wait_for_answers`.

    Parameters
    ----------
    ancestor : int
        Pid of the process that forked the notebook's.
    results : int
        Descriptor on which the notebook's process hands over.
    limits : dict
        As of `limits.Limits`.
    proc : int
        Descriptor of the /proc in which `ancestor` has this pid.
    own_network : bool
        Whether the notebook has a network namespace of its own, whose sockets can be counted.
    wake : callable
        Sends SIGALRM to the process that runs the cells, if there is a way: this stops a cell that
        sleeps for half of the time left, as `cells` stops one that computes for so long.
    """

    def __init__(self, ancestor, results, limits, proc, own_network=True, wake=lambda: None):
        self._ancestor, self._results, self._limits = ancestor, results, limits
        self._proc, self._own_network, self._wake = proc, own_network, wake
        #: Seconds of computing, with time in which nothing wanted to compute, at the last check.
        self.seconds_used = 0.0

    def wait_until_prepared(self):
        """Wait until the notebook's process is confined, and note what preparing it used.

        This is not counted as the notebook's.
        """
        try:
            self._greeting = framing.receive(self._results, timeout=PREPARE_SECONDS)
        except framing.FramingError as error:
            self._greeting = f"not prepared ({error})".encode()
        processes = _descendants(self._ancestor, self._proc)
        self._sockets_before = _sockets(processes, self._proc)
        self._cpu_before = _cpu_seconds(processes)
        self._withheld_before = _withheld(processes, self._proc)

    def wait_for_answers(self):
        """Return (how it ended, message), both bytes.

        It ended "done", or by the limit "time", "memory", "processes", "sockets" or "large"; or it
        "died"; or "failed" if its process could not be prepared.
        """
        if self._greeting != PREPARED:
            return b"failed", self._greeting
        self._began = self._last_check = time.monotonic()
        self._idle = self._idle_in_a_row = self._at_disk = 0.0
        try:
            message = framing.receive(
                self._results,
                self._limits["wall_seconds"] + self._limits["withheld_seconds"],
                self._check,
                INTERVAL,
            )
            return (b"done", message) if len(message) <= MAX_ANSWERS else (b"large", b"")
        except LimitExceededError as limit:
            return str(limit).encode(), b""
        except framing.FramingError as error:
            return {"time": b"time", "large": b"large", "closed": b"died"}[str(error)], b""

    def _check(self):
        processes = _descendants(self._ancestor, self._proc)
        self.seconds_used = max(
            self.seconds_used, _cpu_seconds(processes) - self._cpu_before + self._idle
        )
        _check_sums(processes, self._limits, self._cpu_before - self._idle, self._proc)
        self._count_idle(processes)
        if (
            self._own_network
            and _sockets(processes, self._proc) > self._sockets_before + MAX_SOCKETS
        ):
            raise LimitExceededError("sockets")
        overtime = time.monotonic() - self._began - self._limits["wall_seconds"]
        if overtime > 0 and overtime > _withheld(processes, self._proc) - self._withheld_before:
            raise LimitExceededError("time")

    def _count_idle(self, processes):
        now = time.monotonic()
        # A longer gap between two checks, when this process itself waited for a busy machine, is
        # not counted as sleep.
        since, self._last_check = min(now - self._last_check, 2 * INTERVAL), now
        states = _states(processes, self._proc)
        if b"R" in states:
            self._idle_in_a_row = 0.0
            return
        if b"D" in states and self._at_disk < self._limits["cpu_seconds"] * DISK_SHARE:
            self._at_disk += since
            return
        self._idle += since
        self._idle_in_a_row += since
        used = _cpu_seconds(processes) - self._cpu_before + self._idle
        if self._idle_in_a_row > self._limits["cpu_seconds"] - used:
            # It has slept for half of what was left when it fell asleep.
            self._idle_in_a_row = 0.0
            self._wake()


def kill_descendants(proc):
    """Kill all descendants of this process, which orphans become children of."""
    while processes := _descendants(os.getpid(), proc):
        # Stopped first, so that none multiplies while the others are killed.
        for kind in (signal.SIGSTOP, signal.SIGKILL):
            for process in processes:
                with suppress(ProcessLookupError, PermissionError):
                    os.kill(process.pid, kind)
        with suppress(ChildProcessError):
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass


def _check_sums(processes, limits, cpu_before, proc):
    if _cpu_seconds(processes) - cpu_before > limits["cpu_seconds"]:
        raise LimitExceededError("time")
    if sum(process.threads for process in processes) > limits["processes"]:
        raise LimitExceededError("processes")
    bound = limits["memory_megabytes"] * 2**20
    # Resident memory is at hand, but counts shared pages many times: the exact sum is made only
    # where it matters. Twice, since pages of a process that ends meanwhile are shared by fewer,
    # and count more in those read after that.
    if sum(process.resident for process in processes) > bound and all(
        sum(_proportional_memory(process, proc) for process in processes) > bound for _ in range(2)
    ):
        raise LimitExceededError("memory")


def _states(processes, proc):
    """Return the states of all threads by the letters of /proc.

    R runs or waits for a processor, D waits for a disk. If R is among them, others may be missing.
    """
    states = {process.state for process in processes}
    for process in processes:
        if b"R" in states:
            break
        if process.threads > 1:
            states |= {
                _ProcessStat(process.pid, line).state
                for thread in _listed(f"{process.pid}/task", proc)
                if (line := _read(f"{process.pid}/task/{thread}/stat", proc))
            }
    return states


def _cpu_seconds(processes):
    return sum(process.cpu_seconds for process in processes)


def _withheld(processes, proc):
    """Return the longest time that a thread waited for a processor, in seconds; 0 if unknown.

    The longest, not the sum: threads that wait for each other must not gain by their number.
    """
    waits = (
        _read(f"{process.pid}/task/{thread}/schedstat", proc).split()
        for process in processes
        for thread in _listed(f"{process.pid}/task", proc)
    )
    return max((int(fields[1]) / 1e9 for fields in waits if len(fields) == 3), default=0.0)


def _sockets(processes, proc):
    """Return the number of sockets in the network namespace of the innermost process."""
    fields = (
        _read(f"{processes[-1].pid}/net/sockstat", proc).split(b"\n")[0].split()
        if processes
        else []
    )
    return int(fields[2]) if len(fields) == 3 else 0


class _ProcessStat:
    """The fields of /proc/<pid>/stat that are needed."""

    def __init__(self, pid, line):
        # The name, which the process itself chooses, is in brackets; after the last one there are
        # only numbers.
        fields = line.rpartition(b")")[2].split()
        self.pid, self.state = pid, fields[0]
        self.parent, self.threads = int(fields[1]), int(fields[17])
        # Its own and that of its children that have ended.
        self.cpu_seconds = sum(map(int, fields[11:15])) / CLOCK_TICKS
        self.resident = int(fields[21]) * PAGE_BYTES


def _descendants(ancestor, proc):
    processes = [
        process
        for name in os.listdir(proc)
        if name.isdigit() and (process := _process_stat(name, proc))
    ]
    children = {}
    for process in processes:
        children.setdefault(process.parent, []).append(process)
    descendants = list(children.get(ancestor, ()))
    for process in descendants:
        descendants += children.get(process.pid, ())
    return descendants


def _process_stat(pid, proc):
    line = _read(f"{pid}/stat", proc)
    return _ProcessStat(int(pid), line) if line else None


def _proportional_memory(process, proc):
    """Return the resident bytes with shared pages divided among their processes (PSS)."""
    for line in _read(f"{process.pid}/smaps_rollup", proc).split(b"\n"):
        if line.startswith(b"Pss:"):
            return int(line.split()[1]) * 1024
    # It is ending, and by now has nothing resident; or the kernel has no such file.
    now = _process_stat(str(process.pid), proc)
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
