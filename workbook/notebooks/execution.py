"""Run a notebook's cells in a child process and bring its answers home as data; judge answers in
another.

The child that runs a student's cells hands over bytes only (`workbook.checks.contract.encoding`).
The child that judges decodes them, runs data and check cells of the pristine exercise, and never
executes anything of the student's.
"""

import json
import multiprocessing
import os
import signal
import traceback
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from types import GeneratorType

from workbook.checks.contract.verdict import UNCHECKED, Unusable, Verdict
from workbook.notebooks.cells import run_cells

CONTEXT = multiprocessing.get_context(
    "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
)

DISTURBING = {signal.SIGINT, signal.SIGTERM}


@dataclass(frozen=True)
class Run:
    """What running a notebook gave: encoded answers by name, why others could not be read, and
    errors of cells."""

    encoded: dict
    unreadable: dict
    errors: tuple


class TimeLimit(RuntimeError):
    """The child did not finish within its time."""


class Child:
    """A child process that computes `function(*args)`, beginning now; what goes in and out must be
    plain data.

    A generator gives a result each time that it yields. The process is forked where the system can,
    so it starts with everything imported that the parent has.
    """

    def __init__(self, function, *args):
        self._receiver, sender = CONTEXT.Pipe(duplex=False)
        self._process = CONTEXT.Process(target=_serve, args=(sender, function, args), daemon=True)
        with _undisturbed():
            self._process.start()
        sender.close()

    def result(self, timeout):
        """Raises `TimeLimit` after `timeout` seconds, and `RuntimeError` with the child's last
        words if it dies."""
        try:
            if not self._receiver.poll(timeout):
                raise TimeLimit(f"no result after {timeout:g} s")
            kind, value = json.loads(self._receiver.recv_bytes())
        except EOFError:
            self._process.join()
            if self._process.exitcode == -signal.SIGXCPU:
                raise TimeLimit("no result within the limit of processor time") from None
            raise RuntimeError("the process ended without a result") from None
        if kind == "error":
            raise RuntimeError(value)
        return value

    def end(self):
        self._process.kill()
        self._process.join()
        self._process.close()
        self._receiver.close()


def in_child(function, *args, timeout):
    """The result of a `Child`, which ends with it."""
    child = Child(function, *args)
    try:
        return child.result(timeout)
    finally:
        child.end()


def run_notebook(sources, names, timeout=120, folder=None):
    """Run code cells as Jupyter would (magics included) and collect the answers `names`; returns a
    `Run`.

    A cell that fails does not stop the others: what can be answered is answered.
    """
    result = in_child(
        run_cells, list(sources), list(names), str(folder) if folder else None, timeout=timeout
    )
    return Run(
        {name: text.encode() for name, text in result["encoded"].items()},
        result["unreadable"],
        tuple(result["errors"]),
    )


def judge(cells, run, names, timeout=60):
    """The verdicts on a run: `cells` are (role, source) of the pristine exercise's data and check
    cells, in order."""
    encoded = {name: data.decode() for name, data in run.encoded.items()}
    found = in_child(
        judge_cells, list(cells), encoded, dict(run.unreadable), list(names), timeout=timeout
    )
    return {name: Verdict(*verdict) for name, verdict in found.items()}


@contextmanager
def _undisturbed():
    """Ctrl-C and the like wait: what a handler of signals raises in the midst of a fork is printed
    and lost."""
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, DISTURBING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(sender, function, args):
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, DISTURBING)
    try:
        found = function(*args)
        for answer in found if isinstance(found, GeneratorType) else [found]:
            sender.send_bytes(json.dumps(["done", answer]).encode())
    except BaseException:  # whatever happened is told, even SystemExit
        sender.send_bytes(json.dumps(["error", traceback.format_exc(limit=-3)]).encode())
    sender.close()


def judge_cells(cells, encoded, unreadable, names):
    """In this very process: {name: [status, message, mistake]} for encoded answers (for a child
    only)."""
    return judge_answers(cells, lambda: decoded(encoded, unreadable, names), names)


def judge_answers(cells, answers, names, namespace=None):
    """The same, where `answers()` gives them by name as `decoded` does; it is called when the first
    check is due. `namespace` is what cells before these have left.

    What was handed over reaches the check cells under the names of the answers alone: nothing else
    of theirs, such as the data, can be replaced by it.
    """
    os.environ.setdefault("MPLBACKEND", "Agg")
    from workbook.checks import collecting

    given, namespace = None, {"__name__": "exercise"} if namespace is None else namespace
    with collecting() as verdicts:
        for role, source in cells:
            if role != "check":
                run_cell((role, source), namespace)
                continue
            given = answers() if given is None else given
            namespace.update(given)
            # a check cell that fails leaves its own answers unchecked, and no others
            with suppress(Exception):
                run_cell((role, source), namespace)
    unchecked = Verdict(
        UNCHECKED, "no check cell could judge this answer; the fault is the check's, not yours"
    )
    return {
        name: [verdict.status, verdict.message, verdict.mistake]
        for name in names
        for verdict in [verdicts.get(name, unchecked)]
    }


def run_cell(cell, namespace):
    role, source = cell
    exec(compile(source, f"<{role} cell>", "exec"), namespace)


def decoded(encoded, unreadable, names):
    """{name: value} of the answers: the stub for one that is not there, `Unusable` for one that
    cannot be read."""
    return {name: _answer(encoded.get(name), unreadable.get(name)) for name in names}


def _answer(text, unreadable):
    from workbook.checks.contract.decoding import decode
    from workbook.checks.contract.traversal import EncodingError

    if text is None:
        return ... if unreadable is None else Unusable(unreadable)
    try:
        return decode(text.encode())
    except (EncodingError, UnicodeEncodeError) as error:
        return Unusable(str(error))
