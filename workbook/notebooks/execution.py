"""Run a notebook's cells in a child process, and judge its answers in another.

The child that runs a student's cells returns bytes only (`workbook.checks.contract.encoding`). The
child that judges decodes them and runs data and check cells of the pristine exercise, but no code
of the student.
"""

import json
import math
import multiprocessing
import os
import signal
import sys
import time
import traceback
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from types import GeneratorType

from workbook.checks.contract import cell_watch
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.traversal import EncodingError
from workbook.checks.contract.verdict import UNCHECKED, Unusable, Verdict
from workbook.notebooks.cells import run_cells

#: macOS can fork too, but its libraries may crash afterwards.
CONTEXT = multiprocessing.get_context("fork" if sys.platform == "linux" else "spawn")

#: Seconds between two looks at the memory of a child.
MEMORY_INTERVAL = 0.1
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
        What `contract.cell_watch` listed: (stopped, overwritten, meant).
    read : tuple of str
        The code that cells were taken for, where it is not what was typed.
    """

    encoded: dict
    unreadable: dict
    errors: tuple
    notes: tuple = ({}, {}, {})
    read: tuple = ()


class TimeLimit(RuntimeError):
    """A child process did not finish within its time."""


class EndedEarly(RuntimeError):
    """A child process ended without a result."""


class Child:
    """A child process that computes `function(*args)` from now on.

    It is forked on Linux, so that it starts with all modules of the parent.

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

    def result(self, timeout, memory=math.inf):
        """Return the next result.

        Parameters
        ----------
        timeout : float
            Seconds to wait for it.
        memory : float
            Bytes that the child may hold meanwhile: for systems that set no such limit themselves.

        Raises
        ------
        TimeLimit
            If there is none in this time, or the child has reached its limit of processor time.
        EndedEarly
            If the child ended without one, or held more memory.
        RuntimeError
            If the function raised an error (with its traceback).
        """
        try:
            if not self._wait(timeout, memory):
                raise TimeLimit(f"no result after {timeout:g} s")
            kind, value = json.loads(self._receiver.recv_bytes())
        except EOFError:
            self._process.join()
            code = self._process.exitcode
            if sys.platform != "win32" and code == -signal.SIGXCPU:
                raise TimeLimit("no result within the limit of processor time") from None
            raise EndedEarly(f"the process ended without a result, with exit code {code}") from None
        if kind == "error":
            raise RuntimeError(value)
        return value

    def _wait(self, timeout, memory):
        if memory == math.inf:
            return self._receiver.poll(timeout)
        import psutil  # Linux does without

        child, end = psutil.Process(self._process.pid), time.monotonic() + timeout
        while time.monotonic() < end:
            if self._receiver.poll(MEMORY_INTERVAL):
                return True
            with suppress(psutil.NoSuchProcess):  # reading its result shows that it has ended
                if child.memory_info().rss > memory:
                    raise EndedEarly(f"the process held more than {memory / 2**20:.0f} MB")
        return False

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
    EndedEarly
        If a cell ended the process.
    """
    result = in_child(
        run_cells, list(sources), list(names), str(folder) if folder else None, timeout=timeout
    )
    return Run(
        {name: text.encode() for name, text in result["encoded"].items()},
        result["unreadable"],
        tuple(result["errors"]),
        (result["failed"], result["overwritten"], result["meant"]),
        tuple(result["read"]),
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
    if sys.platform == "win32":
        yield
        return
    previous = signal.pthread_sigmask(signal.SIG_BLOCK, INTERRUPTS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, previous)


def _serve(sender, function, args):
    if sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_UNBLOCK, INTERRUPTS)
    try:
        result = function(*args)
        for value in result if isinstance(result, GeneratorType) else [result]:
            sender.send_bytes(json.dumps(["done", value]).encode())
    except BaseException:  # SystemExit too
        sender.send_bytes(json.dumps(["error", traceback.format_exc(limit=-3)]).encode())
    sender.close()


def judge_cells(cells, encoded, unreadable, names, notes=({}, {}, {})):
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
