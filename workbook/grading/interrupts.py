"""Ctrl-C that is never lost: what is raised in the midst of a finalizer, Python prints and
forgets."""

import signal
import sys
import threading
from contextlib import contextmanager

#: Seconds until a lost one comes again: finalizers are short.
AGAIN = 0.05


@contextmanager
def ctrl_c_heeded():
    """A `KeyboardInterrupt` that Python ignores, as it must in `__del__` or a weak reference's
    callback, is raised again.

    For the main thread, which is the one that Ctrl-C interrupts: soon after, at the latest at the
    end of the block.
    """
    before, main, owed = sys.unraisablehook, threading.get_ident(), []

    def hook(ignored):
        if not issubclass(ignored.exc_type, KeyboardInterrupt):
            before(ignored)
            return
        # A signal and not only a flag, since the thread may be waiting in the system by then.
        owed.append(threading.Timer(AGAIN, signal.pthread_kill, (main, signal.SIGINT)))
        owed[-1].start()

    sys.unraisablehook = hook
    try:
        yield
    finally:
        sys.unraisablehook = before
        late = [timer for timer in owed if timer.is_alive()]
        for timer in late:
            timer.cancel()
        if late:
            raise KeyboardInterrupt
