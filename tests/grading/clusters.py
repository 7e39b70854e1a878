"""Dask clusters of several processes on this machine, started by the commands of the guide."""

import os
import shutil
import socket
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from guide import steps
from test_nothing_lost import descendants, outliving

GUIDE = Path(__file__).resolve().parents[2] / "book" / "guides" / "grading.md"
#: (command, what it prints) of the guide's section.
COMMANDS = [
    (command, shown)
    for section, command, shown in steps(GUIDE.read_text(encoding="utf-8"))
    if section == "Larger than one machine"
]
CERTIFICATES = [
    "--tls-ca-file",
    "ca.pem",
    "--tls-cert",
    "grader.pem",
    "--tls-key",
    "grader-key.pem",
]


class LocalCluster:
    """A scheduler, and workers that come and go.

    The folder `here` has its certificates, if there are any.
    """

    def __init__(self, here, scheme="tls"):
        self.here, self.scheme, self._processes = here, scheme, []
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.address = f"{scheme}://127.0.0.1:{self.port}"

    def as_here(self, command):
        """Return a command of the guide with the address of this cluster."""
        command = command.replace("scheduler.example.org:8786", f"127.0.0.1:{self.port}")
        return command.replace("scheduler.example.org --port 8786", f"127.0.0.1 --port {self.port}")

    def start(self, command, **environment):
        """Start a process that does not end by itself, and return it."""
        log = open(self.here / f"log-{len(self._processes)}.txt", "wb")
        path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
        process = subprocess.Popen(
            [shutil.which("bash"), "-c", f"exec {self.as_here(command)}"],
            cwd=self.here,
            stdout=log,
            stderr=log,
            env=os.environ | {"PATH": path} | environment,
            start_new_session=True,
        )
        log.close()
        self._processes.append(process)
        return process

    def add_worker(self, options="--nworkers 1 --nthreads 1", log=None, **environment):
        known = (
            ""
            if self.scheme == "tcp"
            else "--tls-ca-file ca.pem --tls-cert worker.pem --tls-key worker-key.pem"
        )
        return self.wait_for(
            self.start(
                f"dask worker {self.address} {options} --no-dashboard {known}", **environment
            )
        )

    def wait_for(self, worker, number=1):
        """Return the process when its workers have found the scheduler."""
        log, give_up = self.here / f"log-{self._processes.index(worker)}.txt", time.monotonic() + 60
        while log.read_bytes().count(b"Registered to") < number:
            assert time.monotonic() < give_up and worker.poll() is None, log.read_text(
                errors="replace"
            )
            time.sleep(0.05)
        return worker

    def remove(self, process):
        process.terminate()
        process.wait(timeout=30)

    def grading_processes(self):
        """Return the processes below the workers that grade or run notebooks."""
        below = set().union(
            *(descendants(process.pid) for process in self._processes if process.poll() is None)
        )
        return {process_key for process_key in below if b"workbook" in command_of(process_key[0])}

    def workers(self):
        """Return the pids of the workers proper, below their nannies."""
        pids = [
            number
            for process in self._processes
            for number, _ in descendants(process.pid)
            if b"spawn_main" in command_of(number)
        ]
        return sorted(pids)

    def close(self):
        below = set().union(*(descendants(process.pid) for process in self._processes))
        for process in reversed(self._processes):
            process.kill()
            process.wait(timeout=30)
        for number, _ in below:
            if b"dask" in command_of(number) or b"spawn" in command_of(number):
                os.kill(number, 9)
        assert not outliving(below), "something outlives the workers"


def command_of(number):
    try:
        return Path(f"/proc/{number}/cmdline").read_bytes()
    except OSError:
        return b""


@contextmanager
def a_cluster(here, scheme="tls"):
    cluster = LocalCluster(here, scheme)
    try:
        yield cluster
    finally:
        cluster.close()
