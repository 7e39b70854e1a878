"""Worker processes that grade in WebAssembly, on every system: spawned, with pipes of bytes.

Each has a process of guests and one that judges, which end with it.
"""

import json
import multiprocessing
import signal
import sys
from contextlib import suppress
from multiprocessing import connection

from workbook import course
from workbook.grading.pool.grader import Grader, Task, to_plain
from workbook.grading.pool.judging import grader_failure
from workbook.grading.sandbox.limits import SandboxUnavailableError
from workbook.grading.sandbox.wasm import compiled, wasm_sandbox

SPAWN = multiprocessing.get_context("spawn")
#: Seconds that an idle process may take to end.
END_SECONDS = 2


def grade_all(tasks, count, settings, report):
    """Grade tasks in `count` worker processes; yield (key, result) in the order they are done.

    Parameters
    ----------
    tasks : iterable of Task
        The notebooks.
    count : int
        Number of worker processes.
    settings : Settings
        The same for all of them.
    report : callable
        Gets one line before something that takes long.

    Raises
    ------
    SandboxUnavailableError
        Before anything is graded, where guests do not start.
    """
    compiled.prepare(report)
    waiting, workers = iter(tasks), []
    with wasm_sandbox.guest_files() as root:
        try:
            workers += [Worker(settings, root) for _ in range(count)]
            for worker in workers:
                worker.wait_until_ready()
            busy = {
                w.pipe: (w, task) for w in workers if (task := w.send_next(waiting)) is not None
            }
            while busy:
                for pipe in connection.wait(busy):
                    worker, task = busy.pop(pipe)
                    result = worker.receive()
                    if result is None:
                        result = to_plain(grader_failure(task.names, "one of its processes ended"))
                        worker.stop()
                        workers.remove(worker)
                        workers.append(worker := Worker(settings, root))
                        worker.wait_until_ready()
                    following = worker.send_next(waiting)  # it runs while this result is stored
                    if following is not None:
                        busy[worker.pipe] = worker, following
                    yield task.key, result
        finally:
            for worker in workers:
                worker.pipe.close()  # an idle one ends
            for worker in workers:
                worker.stop()


class Worker:
    """The grader's end of one worker process."""

    def __init__(self, settings, root):
        self.pipe, other_end = SPAWN.Pipe()
        lifeline, self._lifeline = SPAWN.Pipe(duplex=False)
        self._process = SPAWN.Process(target=run, args=(other_end, lifeline, settings, root))
        self._process.start()
        other_end.close()
        lifeline.close()

    def wait_until_ready(self):
        """Wait for the greeting; raise `SandboxUnavailableError` if it says why there is none."""
        refused = (self.receive() or {"refused": "a grading process ended while it started"}).get(
            "refused"
        )
        if refused is not None:
            raise SandboxUnavailableError(refused)

    def send_next(self, waiting):
        """Send the next task of an iterator and return it; None if there is none."""
        task = next(waiting, None)
        if task is not None:
            with suppress(OSError):  # it has died, which `receive` shows
                self.pipe.send_bytes(task.to_json())
        return task

    def receive(self):
        """Return the next result; None if the process has died."""
        with suppress(EOFError, OSError):
            return json.loads(self.pipe.recv_bytes())

    def stop(self):
        """End the process."""
        self.pipe.close()
        self._process.join(END_SECONDS)
        self._process.kill()
        self._process.join()
        self._lifeline.close()


def run(pipe, lifeline, settings, root):
    """Grade the tasks that come in until the pipe closes, in a process of its own.

    A guest that runs meanwhile ends when the pipe `lifeline` closes, however the grader ended.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the grader, which ends this
    course.enter(settings.course)
    forks = sys.platform == "linux"  # elsewhere the process that judges imports what it needs
    with suppress(EOFError, OSError):
        try:
            with Grader(
                wasm_sandbox.WasmSandbox(root, settings.limits, lifeline),
                settings.bounds,
                has_checks=not forks,
            ) as grader:
                pipe.send_bytes(b'{"ready": true}')
                while True:
                    result = grader.grade(Task.from_json(pipe.recv_bytes()))
                    pipe.send_bytes(json.dumps(result).encode())
        except SandboxUnavailableError as error:
            pipe.send_bytes(json.dumps({"refused": str(error)}).encode())
