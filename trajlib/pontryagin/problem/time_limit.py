"""A limit of the time of a computation, which ends any of its steps.

A second thread raises `OutOfTime` in the one that computes when the time is over, as Ctrl-C does:
between two instructions of Python, also within SymPy. A call of IPOPT ends between two of its
iterations by a callback; in `stopped_from_within` nothing is raised, since CasADi would report it as
an error of the callback.
"""

import ctypes
import math
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from trajlib.pontryagin.problem.errors import NotConverged, PontryaginError

# Seconds between attempts: an exception within a destructor is lost, and an import is not broken off.
REPEATED, BUSY = 1.0, 0.05

# The threads that end a call themselves.
_within: set[int] = set()
_lock = threading.Lock()
_times: ContextVar[tuple[float, float]] = ContextVar("times", default=(-math.inf, math.inf))


class OutOfTime(BaseException):
    """The time is over. Not an `Exception`, so that no handler for errors keeps it."""


def seconds_left() -> float:
    """Return the seconds until the time is over; infinity without a limit."""
    return max(_times.get()[1] - time.monotonic(), 0.0)


def half_is_over() -> bool:
    """Check whether half of the time is over."""
    begin, end = _times.get()
    return end < math.inf and time.monotonic() > (begin + end) / 2


def is_end_of_time(error: BaseException) -> bool:
    """Check whether an error within the block of `limited` comes from the end of the time.

    Code that keeps every exception, as some of CasADi's does, fails a little later with another.
    """
    if isinstance(error, Exception) and not isinstance(error, PontryaginError):
        return seconds_left() == 0
    return isinstance(error, OutOfTime)


@contextmanager
def stopped_from_within() -> Iterator[None]:
    """Leave it to the block to end when `seconds_left` is zero; then raise `OutOfTime` after it."""
    thread = threading.get_ident()
    with _lock:
        _within.add(thread)
    try:
        yield
    finally:
        with _lock:
            _within.discard(thread)
    if seconds_left() == 0:
        raise OutOfTime


@contextmanager
def limited(seconds: float | None) -> Iterator[None]:
    """Raise `OutOfTime` in the block after so many seconds; None: never."""
    # In a page of the site there are no threads, and no CasADi either.
    if seconds is None or sys.platform == "emscripten":
        yield
        return
    now, thread, finished = time.monotonic(), threading.get_ident(), threading.Event()
    watcher = threading.Thread(target=_end, args=(thread, finished, seconds), daemon=True)
    token = _times.set((now, now + seconds))
    try:
        watcher.start()
        yield
    except Exception as error:
        if is_end_of_time(error):
            raise OutOfTime from error
        raise
    finally:
        _stop(watcher, finished)
        _times.reset(token)


def in_time(seconds: float | None, compute: Callable, *arguments):
    """Return compute(*arguments); raise `NotConverged` when the time is over before."""
    if seconds is not None and not float(seconds) > 0:
        raise ValueError(f"time_limit: expected a positive number of seconds, got {seconds}")
    try:
        with limited(seconds):
            return compute(*arguments)
    except OutOfTime:
        raise NotConverged(
            "the time limit is over: it ended a step before or after the search for processes. "
            "Nothing is proved by that: allow more time."
        ) from None


def _stop(watcher, finished):
    """End the watcher, and drop what it has raised here and has not arrived yet."""
    while True:
        try:
            finished.set()
            watcher.join()
            _raise_in(threading.get_ident(), None)
            return
        except OutOfTime:
            continue


def _end(thread, finished, seconds):
    """Raise `OutOfTime` in a thread after some seconds, again and again until it has finished."""
    while not finished.wait(seconds):
        with _lock:
            busy = thread in _within or _imports(sys._current_frames().get(thread))
            if not busy:
                _raise_in(thread, OutOfTime)
        seconds = BUSY if busy else REPEATED


def _imports(frame):
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


def _raise_in(thread, exception):
    value = None if exception is None else ctypes.py_object(exception)
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), value)
