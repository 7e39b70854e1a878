"""Run a notebook's cells in a child process, and judge its answers in another.

The child that runs a student's cells returns bytes only (`workbook.checks.contract.encoding`). The
child that judges decodes them and runs data and check cells of the pristine exercise, but no code
of the student.
"""

import json
import multiprocessing
import os
import signal
import traceback
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from types import GeneratorType

from workbook.checks.contract import cell_watch
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.traversal import EncodingError
from workbook.checks.contract.verdict import UNCHECKED, Unusable, Verdict
from workbook.notebooks.cells import run_cells

CONTEXT = multiprocessing.get_context(
    "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
)

INTERRUPTS = {signal.SIGINT, signal.SIGTERM}


@dataclass(frozen=True)
class Run:
    """The result of running a notebook.

    Attributes
    ----------
    encoded : dict of bytes
        Encoded answers by name.
    unreadable : dict of str
        Messages on the other answers by name.
    errors : tuple of str
        A line for each cell that failed.
    notes : tuple of dict
        What `contract.cell_watch` listed: (stopped, overwritten).
    """

    encoded: dict
    unreadable: dict
    errors: tuple
    notes: tuple = ({}, {})


class TimeLimit(RuntimeError):
    """A child process did not finish within its time."""


class Child:
    """A child process that computes `function(*args)` from now on.

    It is forked where the system can fork, so that it starts with all modules of the parent.

    Parameters
    ----------
    function : callable
        The function; a generator function gives several results.
    *args
        Its arguments, which can be pickled; its results can be written as JSON.
    """

    def __init__(self, function, *args):
        self._receiver, sender = CONTEXT.Pipe(duplex=False)
        self._process = CONTEXT.Process(target=_serve, args=(sender, function, args), daemon=True)
        with _interrupts_blocked():
            self._process.start()
        sender.close()

    def result(self, timeout):
        """Return the next result.

        Parameters
        ----------
        timeout : float
            Seconds to wait for it.

        Raises
        ------
        TimeLimit
            If there is none in this time, or the child has reached its limit of processor time.
        RuntimeError
            If the function raised an error (with its traceback), or the child died.
        """
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
        """Kill the child and release its resources."""
        self._process.kill()
        self._process.join()
        self._process.close()
        self._receiver.close()


def in_child(function, *args, timeout):
    """Return the result of `function(*args)` in a `Child`, which is ended then."""
    child = Child(function, *args)
    try:
        return child.result(timeout)
    finally:
        child.end()


def run_notebook(sources, names, timeout=120, folder=None):
    """Run code cells as Jupyter would, magics included, and collect the answers.

    Parameters
    ----------
    sources : iterable of str
        The code cells; one that fails does not stop the others.
    names : iterable of str
        Names of the answers.
    timeout : float
        Seconds for all cells.
    folder : path_like, optional
        Working folder.

    Returns
    -------
    Run
        The answers and the errors.

    Raises
    ------
    TimeLimit
        If the cells take longer than `timeout`.
    """
    result = in_child(
        run_cells, list(sources), list(names), str(folder) if folder else None, timeout=timeout
    )
    return Run(
        {name: text.encode() for name, text in result["encoded"].items()},
        result["unreadable"],
        tuple(result["errors"]),
        (result["failed"], result["overwritten"]),
    )


def judge(cells, run, names, timeout=60):
    """Return the verdicts on a run by answer.

    Parameters
    ----------
    cells : iterable of (str, str)
        (role, source) of the pristine exercise's data and check cells, in order.
    run : Run
        The run.
    names : iterable of str
        Names of the answers.
    timeout : float
        Seconds for all checks.

    Returns
    -------
    dict of Verdict
        The verdicts by name.

    Raises
    ------
    TimeLimit
        If the checks take longer than `timeout`.
    """
    encoded = {name: data.decode() for name, data in run.encoded.items()}
    verdicts = in_child(
        judge_cells,
        list(cells),
        encoded,
        dict(run.unreadable),
        list(names),
        run.notes,
        timeout=timeout,
    )
    return {name: Verdict(*verdict) for name, verdict in verdicts.items()}


@contextmanager
def _interrupts_blocked():
    """Delay Ctrl-C and SIGTERM during a fork, where an exception of a signal handler is lost."""
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        yield
        return
    previous = signal.pthread_sigmask(signal.SIG_BLOCK, INTERRUPTS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, previous)


def _serve(sender, function, args):
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, INTERRUPTS)
    try:
        result = function(*args)
        for value in result if isinstance(result, GeneratorType) else [result]:
            sender.send_bytes(json.dumps(["done", value]).encode())
    except BaseException:  # SystemExit too
        sender.send_bytes(json.dumps(["error", traceback.format_exc(limit=-3)]).encode())
    sender.close()


def judge_cells(cells, encoded, unreadable, names, notes=({}, {})):
    """Judge encoded answers in this process, which is to be a child process.

    Returns
    -------
    dict
        [status, message, mistake] by name.
    """
    cell_watch.recall(*notes)
    return judge_answers(cells, lambda: decoded(encoded, unreadable, names), names)


def judge_answers(cells, answers, names, namespace=None):
    """Judge answers in this process, which is to be a child process.

    The values reach the check cells under the names of the answers only, so that they cannot
    replace other names, such as the data.

    Parameters
    ----------
    cells : iterable of (str, str)
        (role, source) of data and check cells, in order.
    answers : callable
        `answers()` returns the values by name, as `decoded` does; it is called before the first
        check cell.
    names : iterable of str
        Names of the answers.
    namespace : dict, optional
        The namespace after cells that have run before.

    Returns
    -------
    dict
        [status, message, mistake] by name.
    """
    os.environ.setdefault("MPLBACKEND", "Agg")
    from workbook.checks import collecting  # reads the names of all checks

    values, namespace = None, {"__name__": "exercise"} if namespace is None else namespace
    with collecting() as verdicts:
        for role, source in cells:
            if role != "check":
                run_cell((role, source), namespace)
                continue
            values = answers() if values is None else values
            namespace.update(values)
            # the answers of a check cell that fails stay unchecked
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
    """Execute a cell (role, source) in a namespace."""
    role, source = cell
    exec(compile(source, f"<{role} cell>", "exec"), namespace)


def decoded(encoded, unreadable, names):
    """Return the values of the answers by name: `...` if missing, `Unusable` if unreadable."""
    return {name: _decode(encoded.get(name), unreadable.get(name)) for name in names}


def _decode(text, unreadable):
    if text is None:
        return ... if unreadable is None else Unusable(unreadable)
    try:
        return decode(text.encode())
    except (EncodingError, UnicodeEncodeError) as error:
        return Unusable(str(error))
