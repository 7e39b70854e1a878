"""The grader's side of the sandbox: hand a notebook in, get bytes and how it ended."""

import json
import os
import signal
import socket
import subprocess
import tempfile
from contextlib import suppress
from dataclasses import asdict, dataclass
from functools import partial

from workbook.grading import framing, isolation, watchdog
from workbook.grading.forkserver import Forkserver
from workbook.grading.notebook_worker import NOT_NESTED
from workbook.grading.preloading import ALWAYS, LIBRARIES

#: Seconds that a worker may take to get ready, and how often it is started before that is given up.
STARTING, STARTS = 60.0, 3
#: Seconds that a process may take to end, on a busy machine, after it has closed its pipe.
ENDING = 5.0


@dataclass(frozen=True)
class Limits:
    """What one notebook may use, all its processes together: time of computing, memory, and the
    rest.

    Time in which nothing of the notebook wants to compute counts as computing. The clock on the
    wall allows three times as much, and what a busy machine withholds is added, up to
    `withheld_seconds`: it is not the student's fault.
    """

    cpu_seconds: float = 120
    wall_seconds: float = 360
    withheld_seconds: float = 3600
    memory_megabytes: int = 2048
    disk_megabytes: int = 64
    processes: int = 32

    @classmethod
    def of_time(cls, seconds):
        return cls(cpu_seconds=seconds, wall_seconds=3 * seconds)


@dataclass(frozen=True)
class Outcome:
    """How a notebook ended, and the bytes it handed over, not looked into.

    `ended` is "done"; a limit it met ("time", "memory", "processes", "sockets", "large"); "died",
    with the manner as the bytes; or "failed", when the sandbox itself did.
    """

    ended: str
    handed_over: bytes


class Sandbox:
    """A ready worker in a sandbox; `run` may be called again and again, each notebook sees an
    untouched machine.

    Raises `isolation.NoIsolation` where none can be had. Use as a context manager. Where the system
    allows no namespaces inside a sandbox, each notebook gets a sandbox of its own (`once`).
    Notebooks find `modules` imported, and what `forkserver` has imported if one is given.
    """

    _own_network = True

    def __init__(self, limits=Limits(), once=False, forkserver=None, modules=(*ALWAYS, *LIBRARIES)):
        self.limits, self._modules = limits, modules
        self._once, self._forkserver, self._own_forkserver = once, forkserver, None
        self._worker = self._proc = self._place = None
        self._greeted = False

    def __enter__(self):
        self.start()
        self._greet()
        return self

    def __exit__(self, *_):
        self._stop()
        if self._own_forkserver is not None:
            self._own_forkserver.close()
            self._own_forkserver = None

    def run(self, sources, names, before=()):
        """Run code cells, those of `before` first, and collect the answers `names`; returns an
        `Outcome`, whatever the notebook does."""
        self.hand_in(sources, names, before)
        return self.outcome()

    def hand_in(self, sources, names, before=()):
        """Let the notebook begin that `run` would run; it goes on until `outcome` is asked for."""
        self._request = json.dumps(
            {"sources": list(sources), "names": list(names), "before": list(before)}
        ).encode()
        self._begin()

    def outcome(self):
        """The `Outcome` of the notebook handed in."""
        outcome = self._end()
        if outcome.ended != "failed":
            return outcome
        # The machine was out of memory, or somebody ended our processes: not the notebook's doing,
        # so it is tried once more.
        self._begin()
        return self._end()

    def _begin(self):
        self._in_the_way = None
        try:
            self.start()
            self._greet()
            if self._once:
                requests, results, below = (
                    self._worker.stdin.fileno(),
                    self._worker.stdout.fileno(),
                    self._worker.pid,
                )
                self._proc, wake = os.open("/proc", os.O_RDONLY | os.O_DIRECTORY), lambda: None
            else:
                self._make_place()
                requests, results, below = self._place.requests, self._place.results, self._below
                self._place.number = self._worker.children.forked()
                wake = partial(self._worker.children.wake, self._place.number)
            self._watch = watchdog.Watch(
                below, results, asdict(self.limits), self._proc, self._own_network, wake
            )
            self._watch.prepared()
            framing.send(requests, self._request)
        except (framing.Broken, OSError, isolation.NoIsolation) as trouble:
            self._in_the_way = trouble

    def _end(self):
        try:
            if self._in_the_way is not None:
                raise self._in_the_way
            ended, message = self._watch.answers()
            outcome = self._told(ended, self._how_it_died() if ended == b"died" else message)
        except (framing.Broken, OSError, isolation.NoIsolation) as trouble:
            outcome = Outcome("failed", str(trouble).encode())
        if self._once or outcome.ended == "failed":
            self._stop()
        # the next one gets ready while this outcome is judged
        with suppress(isolation.NoIsolation, OSError):
            if self._once:
                self.start()
            elif self._worker is not None:
                self._leave_place()
                self._make_place()
        return outcome

    def _make_place(self):
        if self._place is None:
            self._place = _Place(self._worker.children)

    def _leave_place(self):
        place, self._place = self._place, None
        place.close()
        self._put_away(place.number)

    def _put_away(self, number):
        self._worker.children.forget(number)

    def _told(self, ended, message):
        # The first process of a namespace cannot be killed from inside: this was the kernel, or
        # somebody on the machine.
        return (
            Outcome("failed", b"killed")
            if (ended, message) == (b"died", b"signal 9")
            else Outcome(ended.decode(), message)
        )

    def _how_it_died(self):
        """ "exit 3", "signal 11", or "silent" if it lives on but has closed its pipe."""
        if not self._once:
            code = self._worker.children.ended(self._place.number, within=ENDING)
            return (
                b"silent"
                if code is None
                else f"signal {-code}".encode()
                if code < 0
                else f"exit {code}".encode()
            )
        with suppress(subprocess.TimeoutExpired):
            code = self._worker.wait(timeout=ENDING)
            # Bubblewrap's exit code is that of the process inside, or 128 and its signal.
            return (
                f"signal {code - 128}"
                if code > 128
                else f"signal {-code}"
                if code < 0
                else f"exit {code}"
            ).encode()
        return b"silent"

    def start(self):
        """Begin to get ready; entering, or the first run, waits for it."""
        if self._worker is None:
            self._worker, self._greeted = self._spawn(), False

    def _greet(self, starts_left=STARTS - 1):
        if self._greeted:
            return
        try:
            greeting = framing.receive(self._worker.stdout.fileno(), STARTING)
        except framing.Broken as broken:
            trouble = self._why_it_did_not_start(str(broken))
            self._stop()
            if not (starts_left and isinstance(trouble, isolation.NotStarted)):
                raise trouble from None
            self.start()
            self._greet(starts_left - 1)
            return
        self._greeted = greeting == b"ready"
        if self._greeted:
            if not self._once:
                self._below, self._proc = self._worker.children.place_in_proc()
            return
        self._stop()
        if greeting != NOT_NESTED:
            raise isolation.NoIsolation(
                f"the sandbox does not start here: {greeting.decode(errors='replace')}"
            )
        self._once = True
        self.start()
        self._greet()

    def _why_it_did_not_start(self, broken):
        """The error to raise: what bubblewrap itself says is the machine's affair, all else may go
        better next time."""
        if broken == "time":
            return isolation.NotStarted(
                f"the sandbox was not ready within {STARTING:g} s, {STARTS} times: the machine"
                " is too slow or too busy; the same command goes on from here"
            )
        with suppress(subprocess.TimeoutExpired):
            self._worker.wait(timeout=ENDING)
        code = self._worker.returncode
        signal_number = 9 if code is None else -code if code < 0 else max(code - 128, 0)
        if signal_number:
            return isolation.NotStarted(
                f"the process that runs notebooks was killed (signal {signal_number}) while it"
                f" started, {STARTS} times: the machine may be out of memory; the same command"
                " goes on from here"
            )
        said = self._worker.stderr.read().decode(errors="replace").strip().split("\n")
        said = [line for line in said if line.startswith("bwrap: ")] or said
        return isolation.NoIsolation(
            f"the sandbox does not start here: {said[-1] or 'it ended without a word'}"
        )

    def _spawn(self):
        if self._once:
            bwrap = (
                self._forkserver.bubblewrap
                if self._forkserver is not None
                else isolation.bubblewrap()
            )
            return isolation.spawn_once(bwrap, asdict(self.limits), self._modules)
        forkserver = self._forks()
        return Forked(forkserver, "nested", asdict(self.limits), forkserver.bubblewrap, "/tmp")

    def _forks(self):
        """The forkserver: the one that was given, or else one of its own."""
        if self._forkserver is not None:
            return self._forkserver
        if self._own_forkserver is None or not self._own_forkserver.alive():
            self._own_forkserver = Forkserver.start(self._modules)
        return self._own_forkserver

    def _stop(self):
        if self._worker is not None:
            if isinstance(self._worker, Forked):
                self._worker.end()
            else:
                # Its whole group: while bubblewrap is starting, its inner half does not yet end
                # with the outer one.
                if self._worker.returncode is None:
                    with suppress(ProcessLookupError):
                        os.killpg(self._worker.pid, signal.SIGKILL)
                self._worker.wait()
            for pipe in (self._worker.stdin, self._worker.stdout, self._worker.stderr):
                pipe.close()
            self._worker = None
        if self._place is not None:
            self._place.close()
            self._place = None
        if self._proc is not None:
            os.close(self._proc)
            self._proc = None


class _Place:
    """A process, begun, in which the next notebook is to run, and the pipes to it and from it."""

    def __init__(self, children):
        self.number = None
        (theirs, self.requests), (self.results, mine) = os.pipe(), os.pipe()
        try:
            children.begin_fork("notebook", [], [theirs, mine])
        finally:
            os.close(theirs)
            os.close(mine)

    def close(self):
        os.close(self.requests)
        os.close(self.results)


class Forked:
    """A worker forked from a forkserver, to be used like a `subprocess.Popen`; itself the forkserver of
    its `children`."""

    def __init__(self, forkserver, *given):
        self._forkserver, self.returncode = forkserver, None
        self.stdin, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.children = Forkserver(self.stdin)
        pipes = [os.pipe() for _ in range(2)]
        inside = [pipes[0][1], pipes[1][1]]
        try:
            with theirs:
                self.pid = forkserver.fork("worker", given, [theirs.fileno(), *inside])
        finally:
            for descriptor in inside:
                os.close(descriptor)
        self.stdout, self.stderr = (open(pipe[0], "rb", buffering=0) for pipe in pipes)

    def wait(self, timeout=None):
        if self.returncode is None:
            self.returncode = self._forkserver.ended(self.pid, 60 if timeout is None else timeout)
            if self.returncode is None and timeout is not None:
                raise subprocess.TimeoutExpired("worker", timeout)
        return self.returncode

    def end(self):
        """Let it end, which it does when nobody is there to ask, or kill it with its whole group;
        and forget it."""
        self.stdin.close()
        with suppress(isolation.NotStarted):
            self.returncode = self._forkserver.end(self.pid, within=1)


class Trusting(Sandbox):
    """No sandbox: notebooks run as the grader's own user, within limits. For students, or machines,
    that can be trusted."""

    _folder, _own_network = None, False

    def start(self):
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(
                prefix="workbook-", ignore_cleanup_errors=True
            )
        super().start()

    def __exit__(self, *_):
        super().__exit__()
        self._folder.cleanup()

    def _spawn(self):
        return Forked(self._forks(), "trusting", asdict(self.limits), None, self._folder.name)

    def _told(self, ended, message):
        return Outcome(ended.decode(), message)

    def _put_away(self, number):
        # with all that is left of it, which no namespace does here
        self._worker.children.end(number)
