"""Worker pool: processes that each grade one notebook after the other with a `Grader`.

A `grader.Task` goes in and its result comes back as it is done, both as JSON bytes.
"""

import json
import os
import signal
import sys
from contextlib import suppress
from dataclasses import asdict

from workbook import course
from workbook.grading.pool.grader import Grader, Settings, Task, to_plain
from workbook.grading.pool.judging import grader_failure
from workbook.grading.sandbox import framing, sandbox
from workbook.grading.sandbox.forkserver import WORKER_PROCESS, Forkserver
from workbook.grading.sandbox.limits import ProcessStartError, SandboxUnavailableError


class WorkerStartError(ProcessStartError):
    """A worker process ended while it started."""


def grade_all(tasks, count, settings, forkserver=None):
    """Grade tasks in `count` worker processes; yield (key, result) in the order they are done.

    A worker process that dies fails its task, which is then to be graded again, and is replaced; a
    forkserver that dies while worker processes start is replaced with them. Close the generator
    (`contextlib.closing`) to end them at once.

    Parameters
    ----------
    tasks : iterable of Task
        The notebooks.
    count : int
        Number of worker processes.
    settings : Settings
        The same for all of them.
    forkserver : Forkserver, optional
        One that has begun to import what they need; it is closed in the end.

    Raises
    ------
    SandboxUnavailableError
        Before anything is graded, where there is no sandbox.
    """
    waiting = iter(tasks)
    workers, forkserver = [], forkserver or Forkserver.start([])
    try:
        for starts_left in range(sandbox.MAX_STARTS - 1, -1, -1):
            try:
                start_workers(workers, count, settings, forkserver)
                for k in range(count):
                    workers[k] = _ready_worker(workers[k], settings)
                break
            except ProcessStartError:
                if forkserver.alive() or not starts_left:
                    raise
                while workers:
                    workers.pop().stop()
                forkserver.close()
                forkserver = Forkserver.start([])
        busy = {
            worker: task for worker in workers if (task := worker.send_next(waiting)) is not None
        }
        while busy:
            for worker in framing.readable(busy):
                task = busy.pop(worker)
                result = worker.receive_result()
                if result is None:
                    result = to_plain(grader_failure(task.names, "one of its processes ended"))
                    worker.stop()
                    # If it has died, this is the first of its worker processes to be noticed.
                    if not forkserver.alive():
                        forkserver.close()
                        forkserver = Forkserver.start(
                            [name for names in settings.modules.values() for name in names]
                        )
                    position = workers.index(worker)
                    worker = WorkerProcess(settings, forkserver).start()
                    workers[position] = worker = _ready_worker(worker, settings)
                following = worker.send_next(waiting)  # it runs while this result is stored
                if following is not None:
                    busy[worker] = following
                yield task.key, result
    finally:
        for worker in workers:
            worker.terminate()
        for worker in workers:
            worker.stop()
        forkserver.close()


def start_workers(workers, count, settings, forkserver):
    """Start `count` worker processes, each added to the list `workers` at once for its owner.

    The forkserver of their sandboxes is forked before this one imports what only checks use.
    """
    forkserver.load(settings.modules["notebooks"])
    workers += [WorkerProcess(settings, forkserver) for _ in range(count)]
    forkserver.load(settings.modules["checks"])
    for worker in workers:
        worker.start()


def _ready_worker(worker, settings):
    """Return the worker process when it is ready, or another if it was killed before that."""
    for starts_left in range(sandbox.MAX_STARTS - 1, -1, -1):
        try:
            worker.wait_until_ready()
            return worker
        except WorkerStartError:
            worker.stop()
            if not starts_left:
                raise
            worker = WorkerProcess(settings, worker.forkserver).start()


class WorkerProcess:
    """The grader's end of one worker process, which runs after `start`."""

    def __init__(self, settings, forkserver):
        self.forkserver, self._settings = forkserver, settings
        self._pid = self._exit_code = self._requests = None
        self._bubblewrap = None if settings.trusting else forkserver.bubblewrap
        # A forkserver of its own, from which its sandboxes are forked.
        self._sandbox_forkserver, self._control = forkserver.spawn_child()

    def start(self):
        """Fork the process and return this object."""
        # It inherits neither the grade store nor another worker's pipes.
        (requests_end, self._requests), (self._results, results_end) = os.pipe(), os.pipe()
        try:
            self._pid = self.forkserver.fork(
                WORKER_PROCESS,
                [asdict(self._settings), self._bubblewrap],
                [requests_end, results_end, None, self._control.fileno()],
            )
        finally:
            os.close(requests_end)
            os.close(results_end)
            self._control.close()
        return self

    def fileno(self):
        """Return the descriptor on which results come."""
        return self._results

    def wait_until_ready(self):
        """Wait for the greeting; raise `SandboxUnavailableError` or `ProcessStartError`."""
        try:
            greeting = json.loads(framing.receive(self.fileno()))
        except framing.FramingError:
            raise WorkerStartError(
                "a grading process was killed while it started: the machine may be out of memory;"
                " the same command goes on from here"
            ) from None
        if "ready" not in greeting:
            error = ProcessStartError if greeting["retry"] else SandboxUnavailableError
            raise error(greeting["refused"])

    def send_next(self, waiting):
        """Send the next task of an iterator and return it; None if there is none."""
        task = next(waiting, None)
        if task is not None:
            self.send(task.to_json())
        return task

    def send(self, task):
        """Send a task as the JSON bytes of one."""
        with suppress(BrokenPipeError):  # it has died, which `receive_result` shows
            framing.send(self._requests, task)

    def alive(self):
        """Return whether the process runs."""
        if self._pid is not None and self._exit_code is None:
            with suppress(ProcessStartError):
                self._exit_code = self.forkserver.exit_code(self._pid)
                return self._exit_code is None
        return False

    def terminate(self, at_once=False):
        """Signal it to end, from any thread; one that waits for a result gets None."""
        if self.alive():
            os.kill(self._pid, signal.SIGKILL if at_once else signal.SIGTERM)

    def receive_result(self):
        """Return the next result; None if the process has died."""
        with suppress(framing.FramingError):
            return json.loads(framing.receive(self.fileno()))

    def stop(self):
        """End the process, if it has been started, and close its pipes."""
        self._control.close()
        if self._requests is None:
            return
        # What it has started ends with it (`die_with_parent`) or with its sandbox forkserver.
        self.terminate()
        with suppress(ProcessStartError):
            if self._pid is not None:
                self._exit_code = self.forkserver.end(self._pid, within=5)
            self.forkserver.end(self._sandbox_forkserver)
        os.close(self._requests)
        os.close(self._results)
        self._requests = None


# In the worker process


def _exit_on_sigterm(*_):
    # Once: a second exit during the first would leave things open, and print an error.
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    sys.exit()


def run_worker(settings, bubblewrap):
    """Grade the tasks that come in until none does, or none for their `idle_seconds`.

    For a process forked from a forkserver, with requests on 0, results on 1, and on 3 the control
    socket of the forkserver that its sandboxes are forked from.
    """
    forkserver = Forkserver.attach(3, bubblewrap)
    signal.signal(signal.SIGTERM, _exit_on_sigterm)
    # Results have a descriptor of their own: what a check might print does not come between them.
    results = os.dup(1)
    os.dup2(2, 1)
    with suppress(framing.FramingError):
        settings = Settings.from_plain(settings)
        course.enter(settings.course)
        try:
            inside = (sandbox.Unsandboxed if settings.trusting else sandbox.Sandbox)(
                settings.limits, forkserver=forkserver, modules=settings.modules["notebooks"]
            )
            with Grader(inside, settings.bounds, has_checks=True) as grader:
                framing.send(results, b'{"ready": true}')
                while True:
                    result = grader.grade(Task.from_json(framing.receive(0, settings.idle_seconds)))
                    if not forkserver.alive():
                        # No further sandbox is available: another worker process replaces this one.
                        return
                    framing.send(results, json.dumps(result).encode())
        except SandboxUnavailableError as error:
            if not forkserver.alive():
                return  # another worker process replaces this one
            greeting = {"refused": str(error), "retry": isinstance(error, ProcessStartError)}
            framing.send(results, json.dumps(greeting).encode())
