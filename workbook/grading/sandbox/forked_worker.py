"""The grader's ends of a forked notebook worker and of the notebook processes that it forks."""

import os
import socket
import subprocess
from contextlib import suppress

from workbook.grading.sandbox.forkserver import NOTEBOOK_WORKER, Forkserver
from workbook.grading.sandbox.limits import ProcessStartError
from workbook.grading.sandbox.notebook_worker import NOTEBOOK


class NotebookProcess:
    """A process for the next notebook, and the pipes to and from it.

    A notebook worker forks it; its pid is known when the fork is finished.
    """

    def __init__(self, children):
        self.pid = None
        (requests_end, self.requests), (self.results, results_end) = os.pipe(), os.pipe()
        try:
            children.begin_fork(NOTEBOOK, [], [requests_end, results_end])
        finally:
            os.close(requests_end)
            os.close(results_end)

    def close(self):
        """Close the pipes."""
        os.close(self.requests)
        os.close(self.results)


class ForkedWorker:
    """A notebook worker forked from a forkserver, with the interface of a `subprocess.Popen`.

    It is itself the forkserver of its `children`.
    """

    def __init__(self, forkserver, *arguments):
        self._forkserver, self.returncode = forkserver, None
        self.stdin, worker_end = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.children = Forkserver(self.stdin)
        pipes = [os.pipe() for _ in range(2)]
        worker_ends = [pipes[0][1], pipes[1][1]]
        try:
            with worker_end:
                self.pid = forkserver.fork(
                    NOTEBOOK_WORKER, arguments, [worker_end.fileno(), *worker_ends]
                )
        finally:
            for descriptor in worker_ends:
                os.close(descriptor)
        self.stdout, self.stderr = (open(pipe[0], "rb", buffering=0) for pipe in pipes)

    def wait(self, timeout=None):
        """Return the exit code, as `subprocess.Popen.wait` does."""
        if self.returncode is None:
            self.returncode = self._forkserver.exit_code(
                self.pid, 60 if timeout is None else timeout
            )
            if self.returncode is None and timeout is not None:
                raise subprocess.TimeoutExpired("notebook worker", timeout)
        return self.returncode

    def end(self):
        """Close the control socket, at which it exits; kill it and its group if it does not."""
        self.stdin.close()
        with suppress(ProcessStartError):
            self.returncode = self._forkserver.end(self.pid, within=1)
