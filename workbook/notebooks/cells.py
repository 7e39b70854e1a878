"""Run a notebook's code cells as Jupyter would, and collect its answers.

Students move, duplicate, split and delete cells; some cells fail, some never end. A cell that fails
does not stop the others; one that failed because a later cell had not run is run again; an
untouched stub (`name = ...`) does not overwrite an answer.
"""

import json
import os
import signal
import sys
import time
from contextlib import contextmanager, redirect_stderr, redirect_stdout

from workbook.checks.contract import cell_watch, former_names
from workbook.checks.contract.check_cells import checked_names
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.error_hints import hint_for
from workbook.checks.contract.traversal import EncodingError
from workbook.checks.contract.typed_code import expression_in, read_typed

#: Bytes of all encoded answers together: more than any honest notebook needs, within one message of
#: the sandbox.
MAX_ANSWER_BYTES = 6 * 2**20


class CellTimeout(BaseException):
    """A cell has used its time; no `Exception`, so that the cell's own handlers do not catch it."""


def run_cells(sources, names, folder=None, before=(), seconds=None):
    """Run code cells in this process, which is to be a child process, and collect the answers.

    Parameters
    ----------
    sources : list of str
        The code cells.
    names : sequence of str
        Names of the answers.
    folder : str, optional
        Working folder.
    before : sequence of str
        Cells of ours that run first, in case the notebook lost or moved its own copies.
    seconds : sequence of float, optional
        Limits of computing time and, optionally, of elapsed time. A cell that takes half of the
        remaining time is stopped, as is one that receives an alarm signal; the next one runs.

    Returns
    -------
    dict
        "encoded": encoded answers by name; "unreadable": messages on other answers by name;
        "errors": a line for each failed cell; "read": the code that cells were taken for, where it is
        not what was typed; "stopped": numbers of stopped cells, from 1; "failed", "overwritten" and
        "meant": what `contract.cell_watch` listed of answers, the first and the last only of those
        without a value.
    """
    # loads what renders reports; the error of a check cell, which is no error of the notebook
    from workbook.checks.contract.reporting import NotYet

    os.environ.setdefault("MPLBACKEND", "Agg")
    if folder:
        os.chdir(folder)
    sys.path.insert(0, "")  # modules that a cell writes can be imported, as in Jupyter
    # output is discarded, since it may be endless
    with (
        open(os.devnull, "w", encoding="utf-8", errors="replace") as devnull,
        redirect_stdout(devnull),
        redirect_stderr(devnull),
    ):
        notebook = _Notebook(names, _CellTimer(seconds))
        for source in before:
            notebook.run(source)
        failed = {
            k: error
            for k, source in enumerate(sources, start=1)
            if (error := notebook.run(source)) is not None
        }
        _rerun_failed(notebook, sources, failed)
        encoded, unreadable = notebook.encoded()
    errors = [
        f"code cell {k}: {notebook.error_line(error, sources[k - 1])}"
        for k, error in failed.items()
        if not isinstance(error, (CellTimeout, NotYet))
    ]
    return {
        "encoded": encoded,
        "unreadable": unreadable,
        "errors": errors,
        "read": notebook.read,
        "stopped": [k for k, error in failed.items() if isinstance(error, CellTimeout)],
        "failed": {
            name: error
            for name, error in cell_watch.stopped.items()
            if name in names and name not in notebook.answers
        },
        "overwritten": {
            name: previous for name, previous in cell_watch.overwritten.items() if name in names
        },
        "meant": {
            name: typed for name, typed in cell_watch.meant.items() if name not in notebook.answers
        },
    }


def prepare():
    """Start a shell for the next `run_cells`, in this process or in a fork of it."""
    shell = _new_shell()
    shell.run_cell("pass", store_history=False)  # the first cell takes longer than later ones
    _prepared.append(shell)


#: Shells that have run no cell of a notebook.
_prepared: list = []


def _rerun_failed(notebook, sources, failed):
    """Run failed cells again while missing answers remain, since they may need later cells."""
    progress = True
    while progress and len(notebook.answers) < len(notebook.names):
        progress = False
        for k, error in list(failed.items()):
            if (
                not isinstance(error, CellTimeout)
                and notebook.run_for_missing(sources[k - 1]) is None
            ):
                del failed[k]
                progress = True


class _Notebook:
    """A fresh shell for one notebook, without a history."""

    def __init__(self, names, timer):
        self.names, self.answers, self.read = names, {}, []
        self._timer, self._shell = timer, _prepared.pop() if _prepared else _new_shell()

    def run(self, source):
        """Run a cell and store the answers; return its error or None."""
        names = self._shell.user_ns
        try:
            with self._timer.limit():
                if checked := checked_names(source):
                    self.read += cell_watch.take_expressions(names, checked)
                    cell_watch.note_slips(names, checked, self.names)
                cell_watch.before_cell(names, source)
                outcome = self._shell.run_cell(source, store_history=False)
                error = outcome.error_before_exec or outcome.error_in_exec
                read = read_typed(source)
                # an expression is read as an assignment, once its answer is known
                self.read += [read] if read != source and not expression_in(read) else []
                cell_watch.after_cell(names, read, error, outcome.result)
        # sources that IPython cannot run, such as text with a lone surrogate
        except BaseException as failure:
            error = failure
        former_names.adopt(names, self.names)
        for name in self.names:
            value = names.get(name, ...)
            if value is not ...:
                self.answers[name] = value
            elif name in self.answers:
                names[name] = self.answers[name]
        return error

    def run_for_missing(self, source):
        """Run a cell again without changing existing answers; return its error or None."""
        existing = dict(self.answers)
        error = self.run(source)
        self.answers |= existing
        return error

    def error_line(self, error, source):
        """Return an error in one line, also if its class overrides names and texts."""
        name = type.__dict__["__name__"].__get__(type(error))
        try:
            text = str(error)[:300]
        except BaseException:
            text = "(its text cannot be read)"
        hint = hint_for(text, source, self._shell.user_ns)
        return f"{name}: {text}" + (". " + hint.replace("\n", " ") if hint else "")

    def encoded(self):
        """Return encoded answers and messages on unreadable ones, by name; a stub is an answer."""
        encoded, unreadable, remaining = {}, {}, MAX_ANSWER_BYTES
        for name in self.names:
            if name not in self._shell.user_ns:
                continue
            try:
                with self._timer.limit():
                    text = encode(self.answers.get(name, ...)).decode()
            except EncodingError as error:
                unreadable[name] = str(error)
                continue
            except (CellTimeout, MemoryError):
                unreadable[name] = "reading this answer took more time or memory than allowed"
                continue
            remaining -= len(json.dumps(text))
            if remaining >= 0:
                encoded[name] = text
            else:
                unreadable[name] = (
                    f"the answers together take more than the {MAX_ANSWER_BYTES // 2**20} MB allowed"
                )
        return encoded, unreadable


class _CellTimer:
    """Stops a cell that takes half of the remaining time, or receives an alarm signal.

    Parameters
    ----------
    seconds : sequence of float, optional
        Limits of computing time and elapsed time; without it cells are never stopped.
    """

    def __init__(self, seconds):
        self._deadlines = (
            [clock() + limit for clock, limit in zip(CLOCKS, seconds)] if seconds else []
        )

    @contextmanager
    def limit(self):
        # Windows and WebAssembly have no such timers: there the parent ends the process, and all
        # cells with it
        if sys.platform == "win32" or sys.platform == "wasi" or not self._deadlines:
            yield
            return
        for _, signal_number in TIMERS:
            signal.signal(signal_number, _raise_timeout)
        for deadline, clock, (timer, _) in zip(self._deadlines, CLOCKS, TIMERS):
            signal.setitimer(timer, max((deadline - clock()) / 2, 0.01))
        try:
            yield
        finally:
            for timer, signal_number in TIMERS:
                signal.setitimer(timer, 0)
                # the watchdog of this process may send it too
                signal.signal(signal_number, signal.SIG_IGN)


CLOCKS = (time.process_time, time.monotonic)
if sys.platform != "win32" and sys.platform != "wasi":
    TIMERS = ((signal.ITIMER_PROF, signal.SIGPROF), (signal.ITIMER_REAL, signal.SIGALRM))


def _raise_timeout(*_):
    raise CellTimeout


def _new_shell():
    from IPython.core.displayhook import DisplayHook
    from IPython.core.interactiveshell import InteractiveShell
    from traitlets import Any
    from traitlets.config import Config, Configurable

    class InlineBackend(Configurable):
        """Stand-in for `%config InlineBackend...`; the real one loads Matplotlib."""

        figure_format, figure_formats, print_figure_kwargs, rc = (
            Any().tag(config=True) for _ in range(4)
        )
        close_figures = Any().tag(config=True)

    class SilentDisplayHook(DisplayHook):
        """Stores the value of a cell's last line as `_` and displays nothing."""

        def __call__(self, result=None):
            if result is not None:
                self.update_user_ns(result)
                self.fill_exec_result(result)

    class Shell(InteractiveShell):
        displayhook_class = SilentDisplayHook

        def enable_matplotlib(self, gui=None):
            """Accept `%matplotlib inline` and the like without a display."""
            return gui, "agg"

        def showtraceback(self, *args, **options):
            """Format no traceback, which nobody reads and which may be endless."""

        showsyntaxerror = showtraceback

        @contextmanager
        def _tee(self, channel):
            """Keep no copy of the output (IPython 9), which may be endless."""
            yield

    config = Config()
    config.HistoryManager.enabled = False
    shell = Shell(config=config, history_length=0, colors="nocolor")
    cell_watch.read_typed_cells(shell)
    shell.configurables.append(InlineBackend(parent=shell))  # for `%config InlineBackend...`
    return shell
