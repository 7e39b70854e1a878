"""What `solve` has tried: a log, and one line that shows its state while it computes.

The steps write to the log of the running `solve`, without passing it on; where none runs, to one
that nobody reads.
"""

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from shutil import get_terminal_size

# Seconds until the line is shown where it was not asked for; between two states of it.
DELAY, BETWEEN = 1.0, 0.1
# The events in the line. Lists of arcs may be long, and the end of the line is cut off.
SHOWN = ("start", "Newton", "arcs")


@dataclass(frozen=True)
class LogEntry:
    """One thing that was tried.

    Attributes
    ----------
    seconds : float
        Time since the beginning.
    event : str
        "step" (of `explain`), "start" (a starting guess), "grid" (a discrete solution on another
        grid), "arcs" (a list of arcs) or "Newton".
    text : str
        What was tried, and what came of it.
    value : float or None
        The cost of a discrete solution in the user's units; the largest relative residual of
        Newton's method. None where there is none.
    """

    seconds: float
    event: str
    text: str
    value: float | None = None

    def __str__(self):
        return f"{self.seconds:8.2f} s  {self.event:<6}  {self.text}"


@dataclass(eq=False)
class Log:
    """The entries of one `solve` in the order of time; shows itself as a table of text.

    Attributes
    ----------
    entries : list of LogEntry
        All of them; iterating over the log, or indexing it, gives the same.
    """

    entries: list[LogEntry] = field(default_factory=list)
    _begin: float = field(default_factory=time.monotonic)
    _state: dict[str, str] = field(default_factory=dict)
    _line: "_Line | None" = None

    def __iter__(self) -> Iterator[LogEntry]:
        return iter(self.entries)

    def __len__(self):
        return len(self.entries)

    def __getitem__(self, index):
        return self.entries[index]

    def __repr__(self):
        return "\n".join(map(str, self.entries)) or "nothing was tried"

    def note(self, event: str, text: str, value: float | None = None) -> None:
        """Append an entry.

        Parameters
        ----------
        event, text, value : str, str, float or None
            As in `LogEntry`.
        """
        self.entries.append(LogEntry(time.monotonic() - self._begin, event, text, value))

    def show(self, event: str, state: str) -> None:
        """Show the state of one kind of event in the line.

        Parameters
        ----------
        event, state : str
            One of SHOWN, and what the line has in place of its former state.
        """
        if self._line is None:
            return
        self._state[event] = state
        seconds = time.monotonic() - self._begin
        states = [self._state[kind] for kind in SHOWN if kind in self._state]
        self._line.write("; ".join([f"{seconds:.1f} s", *states]), seconds)


_log: ContextVar[Log | None] = ContextVar("log", default=None)


def current_log() -> Log:
    """Return the log of the running `solve`; a new one where none runs."""
    log = _log.get()
    return Log() if log is None else log


@contextmanager
def logged(progress: bool | None) -> Iterator[Log]:
    """Collect the entries of the block in a log.

    `progress`: whether they are shown; None: after DELAY where a person watches.
    """
    shown = _is_watched() if progress is None else progress
    log = Log(_line=_Line(DELAY if progress is None else 0.0) if shown else None)
    token = _log.set(log)
    try:
        yield log
    finally:
        _log.reset(token)
        if log._line is not None:
            log._line.clear()
            log._line = None


class _Line:
    """A line that is rewritten: on the standard error, or below the cell of a notebook."""

    def __init__(self, delay):
        self.delay, self.last, self.width, self.handle = delay, -BETWEEN, 0, None

    def write(self, text, seconds):
        """Rewrite the line, if the delay is over and the last time is not too near."""
        if seconds < self.delay or seconds < self.last + BETWEEN:
            return
        self.last = seconds
        self._put(text)

    def clear(self):
        """Remove the line."""
        if self.width or self.handle:
            self._put("")

    def _put(self, text):
        if _kernel() is None:
            # A line longer than the terminal would not be overwritten.
            text = text[: get_terminal_size().columns - 1]
            print(f"\r{text:<{self.width}}", end="" if text else "\r", file=sys.stderr, flush=True)
            self.width = len(text)
            return
        content = {"text/plain": text}
        if self.handle is None:
            from IPython.display import display

            self.handle = display(content, raw=True, display_id=True)
        else:
            self.handle.update(content, raw=True)


def _kernel():
    """Return the kernel of a notebook, or None."""
    module = sys.modules.get("IPython")
    shell = None if module is None else module.get_ipython()
    return getattr(shell, "kernel", None)


def _is_watched():
    """Check for a terminal, or a notebook that is not executed as a batch: these can ask a person."""
    kernel = _kernel()
    if kernel is not None:
        return bool(getattr(kernel, "_allow_stdin", False))
    return sys.stderr is not None and sys.stderr.isatty()
