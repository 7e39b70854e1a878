"""Run a notebook's code cells as Jupyter would, and collect its answers, forgiving what students do
to notebooks.

Cells are moved, duplicated, split and deleted; some fail, some never end. A cell that fails does
not stop the others; one that failed for want of a later cell is tried again; an untouched stub
(`name = ...`) takes no answer back.
"""

import json
import os
import signal
import sys
import time
from contextlib import contextmanager, redirect_stderr, redirect_stdout

from workbook.checks.contract.error_hints import hint_for

#: Of all encoded answers together: far above any honest notebook, within one message of the
#: sandbox.
ROOM = 6 * 2**20


class TooLong(BaseException):
    """Raised in a cell that has used its time; not an `Exception`, so that the cell's own handlers
    let it pass."""


def run_cells(sources, names, folder=None, before=(), seconds=None):
    """In this very process: run the cells, then {"encoded", "unreadable", "errors", "stopped"} (for
    a child only).

    `before` are cells of ours that run first, in case the notebook lost or moved its own copies.
    With `seconds`, of computing and perhaps on the clock, a cell that takes half of what is left of
    them is stopped, and the next one runs; so is one at which the signal of an alarm comes.
    """
    # what a check cell raises: verdicts say it better
    from workbook.checks.contract.reporting import NotYet

    os.environ.setdefault("MPLBACKEND", "Agg")
    if folder:
        os.chdir(folder)
    sys.path.insert(0, "")  # what a cell wrote into the folder can be imported, as in Jupyter
    # What is printed is kept nowhere, so that endless output fills nothing.
    with (
        open(os.devnull, "w", encoding="utf-8", errors="replace") as nowhere,
        redirect_stdout(nowhere),
        redirect_stderr(nowhere),
    ):
        notebook = _Notebook(names, _Patience(seconds))
        for source in before:
            notebook.run(source)
        failed = {
            k: error
            for k, source in enumerate(sources, start=1)
            if (error := notebook.run(source)) is not None
        }
        _try_again(notebook, sources, failed)
        encoded, unreadable = notebook.encoded()
    errors = [
        f"code cell {k}: {_told(error)}"
        for k, error in failed.items()
        if not isinstance(error, (TooLong, NotYet))
    ]
    return {
        "encoded": encoded,
        "unreadable": unreadable,
        "errors": errors,
        "stopped": [k for k, error in failed.items() if isinstance(error, TooLong)],
    }


def prepare():
    """Start a shell now for the next `run_cells`, here or in a child forked from this process."""
    shell = _shell()
    shell.run_cell("pass", store_history=False)  # what the first cell would set up
    _prepared.append(shell)


#: Shells that have run nothing of anybody's.
_prepared = []


def _try_again(notebook, sources, failed):
    """Run failed cells once more while that brings answers still missing: what they need may have
    stood below them."""
    progress = True
    while progress and len(notebook.given) < len(notebook.names):
        progress = False
        for k, error in list(failed.items()):
            if not isinstance(error, TooLong) and notebook.run_for_missing(sources[k - 1]) is None:
                del failed[k]
                progress = True


class _Notebook:
    """A fresh shell that writes no history: nothing of one notebook is seen by the next."""

    def __init__(self, names, patience):
        self.names, self.given = names, {}
        self._patience, self._shell = patience, _prepared.pop() if _prepared else _shell()

    def run(self, source):
        """Run a cell and note the answers; returns its error or None."""
        try:
            with self._patience.for_one():
                outcome = self._shell.run_cell(source, store_history=False)
            error = outcome.error_before_exec or outcome.error_in_exec
        # what even the shell cannot run, such as text with half a character
        except BaseException as failure:
            error = failure
        for name in self.names:
            value = self._shell.user_ns.get(name, ...)
            if value is not ...:
                self.given[name] = value
            elif name in self.given:
                self._shell.user_ns[name] = self.given[name]
        return error

    def run_for_missing(self, source):
        """Run a cell again; answers given already stay as they are."""
        settled = dict(self.given)
        error = self.run(source)
        self.given |= settled
        return error

    def encoded(self):
        """(encoded answers, why others cannot be read), by name; an untouched stub is an answer
        too."""
        from workbook.checks.contract.encoding import encode
        from workbook.checks.contract.traversal import EncodingError

        encoded, unreadable, room = {}, {}, ROOM
        for name in self.names:
            if name not in self._shell.user_ns:
                continue
            try:
                with self._patience.for_one():
                    text = encode(self.given.get(name, ...)).decode()
            except EncodingError as error:
                unreadable[name] = str(error)
                continue
            except (TooLong, MemoryError):
                unreadable[name] = "reading this answer took more time or memory than allowed"
                continue
            room -= len(json.dumps(text))
            if room >= 0:
                encoded[name] = text
            else:
                unreadable[name] = (
                    f"the answers together take more than the {ROOM // 2**20} MB allowed"
                )
        return encoded, unreadable


class _Patience:
    """Stops a cell that takes half of the time left, of computing or (if that is bounded) on the
    clock, or that an alarm wakes; without `seconds` it never does."""

    def __init__(self, seconds):
        self._ends = [clock() + limit for clock, limit in zip(CLOCKS, seconds)] if seconds else []

    @contextmanager
    def for_one(self):
        kinds = TIMERS if self._ends else ()
        for _, kind in kinds:
            signal.signal(kind, _stop)
        for end, clock, (timer, _) in zip(self._ends, CLOCKS, TIMERS):
            signal.setitimer(timer, max((end - clock()) / 2, 0.01))
        try:
            yield
        finally:
            for timer, kind in kinds:
                signal.setitimer(timer, 0)
                # it may also come from whoever watches this process
                signal.signal(kind, signal.SIG_IGN)


CLOCKS = (time.process_time, time.monotonic)
TIMERS = ((signal.ITIMER_PROF, signal.SIGPROF), (signal.ITIMER_REAL, signal.SIGALRM))


def _stop(*_):
    raise TooLong


def _shell():
    from IPython.core.displayhook import DisplayHook
    from IPython.core.interactiveshell import InteractiveShell
    from traitlets import Any
    from traitlets.config import Config, Configurable

    class InlineBackend(Configurable):
        """Takes what `%config InlineBackend...` sets: no picture is shown here, and the real one
        loads Matplotlib."""

        figure_format, figure_formats, print_figure_kwargs, rc = (
            Any().tag(config=True) for _ in range(4)
        )
        close_figures = Any().tag(config=True)

    class Kept(DisplayHook):
        """The value of a cell's last line is kept as `_`, but made into no text: nobody reads it
        here."""

        def __call__(self, result=None):
            if result is not None:
                self.update_user_ns(result)

    class Shell(InteractiveShell):
        displayhook_class = Kept

        def enable_matplotlib(self, gui=None):
            """`%matplotlib inline` and its kin find no screen here, and need none."""
            return gui, "agg"

        def showtraceback(self, *args, **options):
            """Errors are told by their type and text: nobody reads a traceback here, and one may be
            built to be endless."""

        showsyntaxerror = showtraceback

        @contextmanager
        def _tee(self, channel):
            """IPython 9 keeps a copy of all that is printed, which endless output would turn into
            endless memory."""
            yield

    config = Config()
    config.HistoryManager.enabled = False
    shell = Shell(config=config, history_length=0, colors="nocolor")
    shell.configurables.append(InlineBackend(parent=shell))  # for `%config InlineBackend...`
    return shell


def _told(error):
    """An error in one line, whatever its class does when asked."""
    name = type.__dict__["__name__"].__get__(type(error))
    try:
        text = str(error)[:300]
    except BaseException:
        text = "(its text cannot be read)"
    said = hint_for(text)
    return f"{name}: {text}" + (". " + said.replace("\n", " ") if said else "")
