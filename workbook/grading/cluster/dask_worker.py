"""What runs inside a worker of a Dask cluster: a lane (`lanes`) for each of its threads, kept from
one notebook to the next.

A Dask worker has threads and is often a daemon of `multiprocessing`; judging forks, which such a
process should not or must not do. So below the worker there is a fresh process (`forkserver`) from
which the lane is forked that builds the sandbox and judges. The kernel ends it when the thread that
started it ends (`end_with_parent`), which is right here, since no other thread ever uses it.

The grader calls `ready`, `grade` and `end` by their names; what goes in and out is bytes of JSON.
"""

import asyncio
import hashlib
import json
import os
import platform
import subprocess
import sys
import threading
from importlib import metadata

from workbook.grading import grader, worker_pool
from workbook.grading.fingerprint import fingerprint
from workbook.grading.forkserver import Forkserver
from workbook.grading.isolation import NoIsolation, NotStarted, shown_through
from workbook.notebooks import exercises
from workbook.notebooks.dependencies import module_closure

#: Libraries whose version may decide whether an answer is right.
PACKAGES = ("numpy", "scipy", "sympy", "mpmath", "casadi", "control", "matplotlib", "ipython")
#: Seconds after which a lane without work ends, should nobody be there any more to end it.
PATIENCE = 60
TELL = "from workbook.grading.cluster.dask_worker import tell_library; tell_library()"


class Unfit(RuntimeError):
    """This worker cannot grade for that grader; the message says why."""


# Called by the grader


def ready(settings):
    """Start this thread's lane. Bytes of {"refused": why, "sandbox": whether for lack of one},
    empty if nothing is wrong."""
    try:
        _lane(settings)
    except (Unfit, NoIsolation) as error:
        return _refusal(error)
    return b"{}"


def grade(settings, unit):
    """Grade a unit. Bytes of {"result": .., "limits": those it had here}, of a refusal, or of {} if
    a process ended in the midst."""
    try:
        lane = _lane(settings)
    except (Unfit, NoIsolation) as error:
        return _refusal(error)
    result = lane.graded(json.loads(unit))
    if result is None:
        lane.stop()
    return json.dumps(
        {"result": result, "limits": lane.settings["limits"]} if result else {}
    ).encode()


async def end(run):
    """End all lanes of a run, also in the midst of a notebook."""
    await asyncio.to_thread(_end, run)


def library(problems):
    """All that a grade rests on besides the notebook, part by part, so that it can be said which
    one differs."""
    parts = {"Python": ".".join(platform.python_version_tuple()[:2])}
    for name in PACKAGES:
        try:
            parts[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            parts[name] = None
    parts["workbook"] = _workbook()
    for problem in problems:
        try:
            parts[f"problem {problem}"] = fingerprint(exercises.find(problem))
        except exercises.UnknownExercise:
            parts[f"problem {problem}"] = None
    return parts


def tell_library():
    """For a fresh process: the parts of the library here of the problems that come in, as JSON."""
    json.dump(library(json.load(sys.stdin)), sys.stdout)


# Inside


_mine = threading.local()
_all, _guard = set(), threading.Lock()
#: Runs that were told to end: a lane of theirs that is still getting ready must not stay.
_ended = set()


def _workbook():
    closure = module_closure(f"import {__name__}")
    return hashlib.sha256(json.dumps(closure, sort_keys=True).encode()).hexdigest()


#: Of the files that this very process has loaded: a worker may outlive the library that it was
#: started with.
LOADED = _workbook()


def _lane(settings):
    """This thread's lane for a run, started if there is none or it has ended. Raises `Unfit` and
    `NoIsolation`."""
    mine = _mine.__dict__.setdefault("lanes", {})
    for run in [run for run, lane in mine.items() if not lane.alive()]:
        mine.pop(run).stop()
    given = json.loads(settings)
    run = given["run"]
    if run not in mine:
        mine[run] = _Kept(given)
    return mine[run]


class _Kept:
    """A lane that its thread uses and another one may end."""

    def __init__(self, given):
        _compare(given["library"])
        if not given["trusting"]:
            _look_around()
        limits, bounds, trusting = grader.from_settings(given)
        self.settings = grader.settings(
            grader.fitting(limits, given["lanes"]), grader.fitting(bounds, given["lanes"]), trusting
        )
        self.run, self._using = given["run"], threading.Lock()
        with _guard:
            if self.run in _ended:
                raise Unfit("the run has ended")
            self._forkserver, mine = Forkserver.start([]), []
            try:
                worker_pool.begin(
                    mine,
                    1,
                    self.settings | {"patience": PATIENCE, "modules": worker_pool.modules(given)},
                    self._forkserver,
                )
            except NoIsolation:
                self._forkserver.close()
                raise
            (self._lane,) = mine
            _all.add(self)
        try:
            with self._using:
                self._lane.greeted()
        except BaseException:
            self.stop()
            raise

    def alive(self):
        return self._lane.alive()

    def graded(self, unit):
        """The result, or None if the lane has died."""
        with self._using:
            if not self.alive():
                return None
            self._lane.send(unit)
            return self._lane.result()

    def stop(self):
        # Whoever waits for a result is woken first, since a pipe must not be closed under a thread
        # that reads from it.
        self._lane.end()
        if not self._using.acquire(timeout=5):
            self._lane.end(at_once=True)
            self._using.acquire()
        self._lane.stop()
        self._forkserver.close()
        self._using.release()
        with _guard:
            _all.discard(self)


def _end(run):
    with _guard:
        _ended.add(run)
        mine = [lane for lane in _all if lane.run == run]
    for lane in mine:
        lane.stop()


def _refusal(error):
    lacks_sandbox = isinstance(error, NoIsolation) and not isinstance(error, NotStarted)
    return json.dumps({"refused": str(error), "sandbox": lacks_sandbox}).encode()


def _compare(expected):
    """Raise `Unfit` unless the library here, as a fresh process finds it, is that of the grader."""
    if LOADED != expected["workbook"]:
        raise Unfit(
            "its workbook is another one than here: install the same one there, and start the "
            "worker again"
        )
    here = _library_now(
        [name.removeprefix("problem ") for name in expected if name.startswith("problem ")]
    )
    for part, wanted in expected.items():
        if here[part] == wanted:
            continue
        if part in ("Python", *PACKAGES):
            raise Unfit(
                f"it has {part} {here[part] or '(none)'}, and this machine {wanted or '(none)'}"
            )
        raise Unfit(
            f"its {part} is another one than here: install the same workbook there, and start the "
            "worker again"
        )


def _library_now(problems):
    told = subprocess.run(
        [sys.executable, "-c", TELL],
        input=json.dumps(problems),
        capture_output=True,
        text=True,
        timeout=120,
    )
    if told.returncode != 0:
        raise Unfit(
            f"it cannot load workbook: "
            f"{(told.stderr.strip().splitlines() or ['it ended without a word'])[-1][:200]}"
        )
    return json.loads(told.stdout)


def _look_around():
    """Raise `Unfit` if notebooks could read what Dask keeps in files: its key, and data that it put
    aside."""
    from distributed import get_worker

    worker = get_worker()
    kept = [worker.local_directory, worker.security.tls_worker_key, worker.security.tls_worker_cert]
    for path in kept:
        if path and os.path.exists(path) and (shown := shown_through(path)) is not None:
            raise Unfit(
                f"it keeps {path} in {shown}, which every notebook can read: move it elsewhere"
            )
