"""Interrupts: raise a Ctrl-C again that came during a finalizer, where Python ignores it."""

import signal
import sys
import threading
from contextlib import contextmanager

#: Seconds until a lost interrupt comes again: finalizers are short.
REPEAT_SECONDS = 0.05


@contextmanager
def repeat_lost_interrupts():
    """Raise a `KeyboardInterrupt` again that Python ignored in `__del__` or a weakref callback.

    For the main thread, which Ctrl-C interrupts: soon after, at the latest at the end of the
    block.
    """
    previous_hook, main_thread, timers = sys.unraisablehook, threading.get_ident(), []

    def hook(unraisable):
        if not issubclass(unraisable.exc_type, KeyboardInterrupt):
            previous_hook(unraisable)
            return
        # A signal and not only a flag, since the thread may be waiting in the system by then.
        timers.append(threading.Timer(REPEAT_SECONDS, _interrupt, [main_thread]))
        timers[-1].start()

    sys.unraisablehook = hook
    try:
        yield
    finally:
        sys.unraisablehook = previous_hook
        pending = [timer for timer in timers if timer.is_alive()]
        for timer in pending:
            timer.cancel()
        if pending:
            raise KeyboardInterrupt


def _interrupt(thread):
    if sys.platform == "win32":
        signal.raise_signal(signal.SIGINT)
    else:
        signal.pthread_kill(thread, signal.SIGINT)
