"""What runs inside a worker of a Dask cluster: one of our worker processes for each thread.

A Dask worker has threads and is often a daemon of `multiprocessing`; judging forks, which such a
process should not or must not do. So below the Dask worker there is a fresh `forkserver`, from
which a worker process (`worker_pool`) is forked that builds the sandbox and judges; it is kept from
one notebook to the next. The kernel ends it when the thread that started it ends
(`die_with_parent`), which is right here, since no other thread ever uses it.

The coordinator calls `prepare`, `grade` and `end_run`; arguments and results are bytes of JSON.
"""

import asyncio
import hashlib
import json
import os
import platform
import subprocess
import sys
import threading
from dataclasses import asdict, replace
from importlib import metadata

from workbook.grading.pool import worker_pool
from workbook.grading.pool.fingerprint import fingerprint
from workbook.grading.pool.grader import Settings
from workbook.grading.sandbox.forkserver import Forkserver
from workbook.grading.sandbox.isolation import visible_parent
from workbook.grading.sandbox.limits import ProcessStartError, SandboxUnavailableError
from workbook.notebooks import exercises
from workbook.notebooks.dependencies import module_closure

#: Libraries whose version may decide whether an answer is right.
PACKAGES = ("numpy", "scipy", "sympy", "mpmath", "casadi", "control", "matplotlib", "ipython")
#: Seconds after which a worker process without work ends, if the Dask worker no longer ends it.
IDLE_SECONDS = 60
PRINT_VERSIONS = (
    "from workbook.grading.cluster.dask_worker import print_library_versions; "
    "print_library_versions()"
)


class UnfitWorkerError(RuntimeError):
    """This Dask worker cannot grade for that coordinator; the message gives the reason."""


# Called by the coordinator


def prepare(order):
    """Start this thread's worker process.

    Parameters
    ----------
    order : bytes
        JSON of {"run": its name, "library": `library_versions` there, "workers": how many there are
        on this machine, "settings": a `Settings` without the course}.

    Returns
    -------
    bytes
        JSON of {"refused": reason, "sandbox": whether for lack of one}, of {} if all is well.
    """
    try:
        _thread_worker(order)
    except (UnfitWorkerError, SandboxUnavailableError) as error:
        return _refusal(error)
    return b"{}"


def grade(order, task):
    """Grade a task by an order as of `prepare`.

    Returns
    -------
    bytes
        JSON of {"result": .., "limits": those it had here}, of a refusal as of `prepare`, or of {}
        if a process ended meanwhile.
    """
    try:
        worker = _thread_worker(order)
    except (UnfitWorkerError, SandboxUnavailableError) as error:
        return _refusal(error)
    result = worker.graded(task)
    if result is None:
        worker.stop()
    return json.dumps(
        {"result": result, "limits": asdict(worker.limits)} if result else {}
    ).encode()


async def end_run(run):
    """End all worker processes of a run, also during a notebook."""
    await asyncio.to_thread(_end_run, run)


def library_versions(problems):
    """Return all that a grade depends on besides the notebook, by part: versions and hashes.

    So it can be said which part differs between two machines.
    """
    parts = {"Python": ".".join(platform.python_version_tuple()[:2])}
    for name in PACKAGES:
        try:
            parts[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            parts[name] = None
    parts["workbook"] = _workbook_hash()
    for problem in problems:
        try:
            parts[f"problem {problem}"] = fingerprint(exercises.find(problem))
        except exercises.UnknownExercise:
            parts[f"problem {problem}"] = None
    return parts


def print_library_versions():
    """Print, in a fresh process, the versions for the problems on standard input, as JSON."""
    json.dump(library_versions(json.load(sys.stdin)), sys.stdout)


# Inside


_thread_local = threading.local()
_all: set = set()
_lock = threading.Lock()
#: Runs that have ended: a worker process of theirs that is still starting must not stay.
_ended_runs: set = set()


def _workbook_hash():
    closure = module_closure(f"import {__name__}")
    return hashlib.sha256(json.dumps(closure, sort_keys=True).encode()).hexdigest()


#: Of the files that this very process has loaded: the library on disk may change while it runs.
LOADED_HASH = _workbook_hash()


def _thread_worker(order):
    """Return this thread's worker process for a run, started if there is none or it has ended.

    Raises `UnfitWorkerError` and `SandboxUnavailableError`.
    """
    workers = _thread_local.__dict__.setdefault("workers", {})
    for run in [run for run, worker in workers.items() if not worker.alive()]:
        workers.pop(run).stop()
    order = json.loads(order)
    run = order["run"]
    if run not in workers:
        workers[run] = _ThreadWorker(**order)
    return workers[run]


class _ThreadWorker:
    """A worker process that one thread uses and another one may end."""

    def __init__(self, run, library, workers, settings):
        _require_same_library(library)
        settings = replace(
            Settings.from_plain(settings).fit_memory(workers), idle_seconds=IDLE_SECONDS
        )
        if not settings.trusting:
            _require_hidden_files()
        self.run, self.limits, self._in_use = run, settings.limits, threading.Lock()
        with _lock:
            if self.run in _ended_runs:
                raise UnfitWorkerError("the run has ended")
            self._forkserver, started = Forkserver.start([]), []
            try:
                worker_pool.start_workers(started, 1, settings, self._forkserver)
            except SandboxUnavailableError:
                self._forkserver.close()
                raise
            (self._worker,) = started
            _all.add(self)
        try:
            with self._in_use:
                self._worker.wait_until_ready()
        except BaseException:
            self.stop()
            raise

    def alive(self):
        """Return whether the worker process runs."""
        return self._worker.alive()

    def graded(self, task):
        """Return the result, or None if the worker process has died."""
        with self._in_use:
            if not self.alive():
                return None
            self._worker.send(task)
            return self._worker.receive_result()

    def stop(self):
        """End the worker process and its forkserver."""
        # A thread that waits for a result is woken first, since a pipe must not be closed under a
        # thread that reads from it.
        self._worker.terminate()
        if not self._in_use.acquire(timeout=5):
            self._worker.terminate(at_once=True)
            self._in_use.acquire()
        self._worker.stop()
        self._forkserver.close()
        self._in_use.release()
        with _lock:
            _all.discard(self)


def _end_run(run):
    with _lock:
        _ended_runs.add(run)
        workers = [worker for worker in _all if worker.run == run]
    for worker in workers:
        worker.stop()


def _refusal(error):
    no_sandbox = isinstance(error, SandboxUnavailableError) and not isinstance(
        error, ProcessStartError
    )
    return json.dumps({"refused": str(error), "sandbox": no_sandbox}).encode()


def _require_same_library(expected):
    """Raise `UnfitWorkerError` unless a fresh process finds the coordinator's library here."""
    if LOADED_HASH != expected["workbook"]:
        raise UnfitWorkerError(
            "its workbook is another one than here: install the same one there, and start the "
            "worker again"
        )
    versions = _library_versions_now(
        [name.removeprefix("problem ") for name in expected if name.startswith("problem ")]
    )
    for part, version in expected.items():
        if versions[part] == version:
            continue
        if part in ("Python", *PACKAGES):
            raise UnfitWorkerError(
                f"it has {part} {versions[part] or '(none)'}, and this machine {version or '(none)'}"
            )
        base, _, row = part.removeprefix("problem ").partition("~")
        if row and version is not None:  # variants are written on each machine
            raise UnfitWorkerError(
                f"its {part} is {'another one than here' if versions[part] else 'not there'}: run "
                f"`workbook variants {base}` in the checkout there"
            )
        raise UnfitWorkerError(
            f"its {part} is another one than here: install the same workbook there, and start the "
            "worker again"
        )


def _library_versions_now(problems):
    process = subprocess.run(
        [sys.executable, "-c", PRINT_VERSIONS],
        input=json.dumps(problems),
        capture_output=True,
        text=True,
        timeout=120,
    )
    if process.returncode != 0:
        raise UnfitWorkerError(
            f"it cannot load workbook: "
            f"{(process.stderr.strip().splitlines() or ['it ended without a word'])[-1][:200]}"
        )
    return json.loads(process.stdout)


def _require_hidden_files():
    """Raise `UnfitWorkerError` if notebooks could read Dask's key, or data that it spilled."""
    from distributed import get_worker  # loaded by now, since this runs in a Dask worker

    worker = get_worker()
    paths = [
        worker.local_directory,
        worker.security.tls_worker_key,
        worker.security.tls_worker_cert,
    ]
    for path in paths:
        if path and os.path.exists(path) and (visible := visible_parent(path)) is not None:
            raise UnfitWorkerError(
                f"it keeps {path} in {visible}, which every notebook can read: move it elsewhere"
            )
