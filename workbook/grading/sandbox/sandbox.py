"""The grader's side of the sandbox: run a notebook in it, get bytes and how it ended."""

import json
import os
import signal
import subprocess
import tempfile
from contextlib import suppress
from dataclasses import asdict, replace
from functools import partial

from workbook.grading.sandbox import framing, isolation, watchdog
from workbook.grading.sandbox.forked_worker import ForkedWorker, NotebookProcess
from workbook.grading.sandbox.forkserver import Forkserver
from workbook.grading.sandbox.limits import (
    Limits,
    Outcome,
    ProcessStartError,
    SandboxUnavailableError,
)
from workbook.grading.sandbox.notebook_worker import NOT_NESTED, READY
from workbook.grading.sandbox.preloading import ALWAYS, LIBRARIES

#: Seconds that a notebook worker may take to start, and how often it is started before giving up.
START_SECONDS, MAX_STARTS = 60.0, 3
#: Seconds that a process may take to end, on a busy machine, after it has closed its pipe.
END_SECONDS = 5.0

_ERRORS = (framing.FramingError, OSError, SandboxUnavailableError)


class Sandbox:
    """A notebook worker in a sandbox; use it as a context manager.

    `run` may be called again and again: each notebook finds an untouched machine. Where the system
    allows no namespaces inside a sandbox, each notebook gets a sandbox of its own ("single-use").

    Parameters
    ----------
    limits : Limits
        Those of each notebook.
    single_use : bool
        Whether each notebook gets a sandbox of its own from the start.
    forkserver : Forkserver, optional
        The one to fork from; by default one of its own.
    modules : sequence of str
        What notebooks find imported, besides what `forkserver` has imported.

    Raises
    ------
    SandboxUnavailableError
        On entering, where the machine offers no sandbox; also by the first `run` if it is not
        entered.
    """

    _own_network = True

    def __init__(
        self, limits=Limits(), single_use=False, forkserver=None, modules=(*ALWAYS, *LIBRARIES)
    ):
        self.limits, self._modules = limits, modules
        self._single_use, self._forkserver, self._own_forkserver = single_use, forkserver, None
        self._worker = self._proc = self._process = None
        self._greeted = False

    def __enter__(self):
        try:
            self.start()
            self._wait_for_greeting()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        self._stop()
        if self._own_forkserver is not None:
            self._own_forkserver.close()
            self._own_forkserver = None

    def run(self, sources, names, before=()):
        """Run code cells and collect answers, whatever the notebook does.

        Parameters
        ----------
        sources : sequence of str
            The notebook's code cells.
        names : sequence of str
            The answers to collect.
        before : sequence of str
            Cells to run first, not of the student.

        Returns
        -------
        Outcome
            How it ended, and the encoded answers.
        """
        self.start_run(sources, names, before)
        return self.finish_run()

    def start_run(self, sources, names, before=()):
        """Start what `run` does, without waiting for it."""
        self._request = json.dumps(
            {"sources": list(sources), "names": list(names), "before": list(before)}
        ).encode()
        self._begin()

    def finish_run(self):
        """Return the `Outcome` of the run that was started."""
        outcome = self._wait()
        if outcome.ended != "failed":
            return outcome
        # The machine was out of memory, or somebody killed our processes: this is not the
        # notebook's doing, so it is tried once more.
        self._begin()
        return self._wait()

    def _begin(self):
        self._start_error = None
        try:
            self.start()
            self._wait_for_greeting()
            if self._single_use:
                requests, results, ancestor = (
                    self._worker.stdin.fileno(),
                    self._worker.stdout.fileno(),
                    self._worker.pid,
                )
                self._proc, wake = os.open("/proc", os.O_RDONLY | os.O_DIRECTORY), lambda: None
            else:
                self._fork_process()
                requests, results = self._process.requests, self._process.results
                ancestor = self._worker_pid
                self._process.pid = self._worker.children.finish_fork()
                wake = partial(self._worker.children.wake, self._process.pid)
            self._watchdog = watchdog.Watchdog(
                ancestor, results, asdict(self.limits), self._proc, self._own_network, wake
            )
            self._watchdog.wait_until_prepared()
            framing.send(requests, self._request)
        except _ERRORS as error:
            self._start_error = error

    def _wait(self):
        try:
            if self._start_error is not None:
                raise self._start_error
            ended, message = self._watchdog.wait_for_answers()
            outcome = self._outcome(ended, self._exit_status() if ended == b"died" else message)
            outcome = replace(outcome, seconds=self._watchdog.seconds_used)
        except _ERRORS as error:
            outcome = Outcome("failed", str(error).encode())
        if self._single_use or outcome.ended == "failed":
            self._stop()
        # The next process is prepared while this outcome is judged.
        with suppress(SandboxUnavailableError, OSError):
            if self._single_use:
                self.start()
            elif self._worker is not None:
                self._leave_process()
                self._fork_process()
        return outcome

    def _fork_process(self):
        if self._process is None:
            self._process = NotebookProcess(self._worker.children)

    def _leave_process(self):
        process, self._process = self._process, None
        process.close()
        self._end_process(process.pid)

    def _end_process(self, pid):
        self._worker.children.forget(pid)

    def _outcome(self, ended, message):
        # The first process of a namespace cannot be killed from inside: this was the kernel, or
        # somebody on the machine.
        return (
            Outcome("failed", b"killed")
            if (ended, message) == (b"died", b"signal 9")
            else Outcome(ended.decode(), message)
        )

    def _exit_status(self):
        """Return "exit 3", "signal 11", or "silent" if it runs on but has closed its pipe."""
        if not self._single_use:
            code = self._worker.children.exit_code(self._process.pid, within=END_SECONDS)
            if code is None:
                return b"silent"
            return (f"signal {-code}" if code < 0 else f"exit {code}").encode()
        with suppress(subprocess.TimeoutExpired):
            code = self._worker.wait(timeout=END_SECONDS)
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
        """Start the notebook worker; entering, or the first run, waits for it."""
        if self._worker is None:
            self._worker, self._greeted = self._start_worker(), False

    def _wait_for_greeting(self, starts_left=MAX_STARTS - 1):
        if self._greeted:
            return
        try:
            greeting = framing.receive(self._worker.stdout.fileno(), START_SECONDS)
        except framing.FramingError as framing_error:
            error = self._why_not_started(str(framing_error))
            self._stop()
            if not (starts_left and isinstance(error, ProcessStartError)):
                raise error from None
            self.start()
            self._wait_for_greeting(starts_left - 1)
            return
        self._greeted = greeting == READY
        if self._greeted:
            if not self._single_use:
                self._worker_pid, self._proc = self._worker.children.receive_proc()
            return
        self._stop()
        if greeting != NOT_NESTED:
            raise SandboxUnavailableError(
                f"the sandbox does not start here: {greeting.decode(errors='replace')}"
            )
        self._single_use = True
        self.start()
        self._wait_for_greeting()

    def _why_not_started(self, framing_error):
        """Return the error to raise: an error of bubblewrap is final, others may be temporary."""
        if framing_error == "time":
            return ProcessStartError(
                f"the sandbox was not ready within {START_SECONDS:g} s, {MAX_STARTS} times: the"
                " machine is too slow or too busy; the same command goes on from here"
            )
        with suppress(subprocess.TimeoutExpired):
            self._worker.wait(timeout=END_SECONDS)
        code = self._worker.returncode
        signal_number = 9 if code is None else -code if code < 0 else max(code - 128, 0)
        if signal_number:
            return ProcessStartError(
                f"the process that runs notebooks was killed (signal {signal_number}) while it"
                f" started, {MAX_STARTS} times: the machine may be out of memory; the same command"
                " goes on from here"
            )
        lines = self._worker.stderr.read().decode(errors="replace").strip().split("\n")
        lines = [line for line in lines if line.startswith("bwrap: ")] or lines
        return SandboxUnavailableError(
            f"the sandbox does not start here: {lines[-1] or 'it ended without a word'}"
        )

    def _start_worker(self):
        if self._single_use:
            return isolation.spawn_sandboxed(
                self._forkserver.bubblewrap
                if self._forkserver is not None
                else isolation.find_bubblewrap(),
                asdict(self.limits),
                "from workbook.grading.sandbox import notebook_worker; "
                f"notebook_worker.run_once({asdict(self.limits)!r}, {list(self._modules)!r})",
            )
        forkserver = self._get_forkserver()
        return ForkedWorker(
            forkserver, "nested", asdict(self.limits), forkserver.bubblewrap, "/tmp"
        )

    def _get_forkserver(self):
        if self._forkserver is not None:
            return self._forkserver
        if self._own_forkserver is None or not self._own_forkserver.alive():
            self._own_forkserver = Forkserver.start(self._modules)
        return self._own_forkserver

    def _stop(self):
        if self._worker is not None:
            if isinstance(self._worker, ForkedWorker):
                self._worker.end()
            else:
                # Its whole group: while bubblewrap is starting, its inner process does not yet end
                # with the outer one.
                if self._worker.returncode is None:
                    with suppress(ProcessLookupError):
                        os.killpg(self._worker.pid, signal.SIGKILL)
                self._worker.wait()
            for pipe in (self._worker.stdin, self._worker.stdout, self._worker.stderr):
                pipe.close()
            self._worker = None
        if self._process is not None:
            self._process.close()
            self._process = None
        if self._proc is not None:
            os.close(self._proc)
            self._proc = None


class Unsandboxed(Sandbox):
    """No sandbox: notebooks run as the grader's own user, within limits.

    For students, or machines, that can be trusted.
    """

    _folder, _own_network = None, False

    def start(self):
        """Start the notebook worker, with a temporary folder for notebooks."""
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(
                prefix="workbook-", ignore_cleanup_errors=True
            )
        super().start()

    def __exit__(self, *_):
        super().__exit__()
        self._folder.cleanup()

    def _start_worker(self):
        return ForkedWorker(
            self._get_forkserver(), "trusted", asdict(self.limits), None, self._folder.name
        )

    def _outcome(self, ended, message):
        return Outcome(ended.decode(), message)

    def _end_process(self, pid):
        # Waits until all that is left of it has ended, which no namespace ensures here.
        self._worker.children.end(pid)
