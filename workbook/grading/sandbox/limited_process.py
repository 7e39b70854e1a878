"""Limited process: call our functions on what students wrote, within limits of time and memory.

A file can be built to explode when it is parsed. So no text of a student's is parsed in the process
that grades the class: a child does it, one file after the other, and is replaced when one ends it.
"""

import multiprocessing
import sys
import time
from contextlib import suppress

from workbook.notebooks.execution import CONTEXT, Child

#: Bytes: after larger contents the process is replaced, since it may keep memory that the next needs.
LARGE = 2**20
#: Of processor time for one call, and of memory beyond what the process has at first.
SECONDS, MEMORY = 20, 2 * 2**30


class LimitError(RuntimeError):
    """A call took more time or memory than allowed, or its process ended."""


class LimitedProcess:
    """A child process that calls some functions; use it as a context manager.

    Parameters
    ----------
    *functions
        Each takes bytes and returns what can be written as JSON.
    """

    def __init__(self, *functions):
        self._functions, self._child, self._sender = functions, None, None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._end()

    def call(self, function, content):
        """Return `function(content)`; raise `LimitError` if that takes more than allowed."""
        if self._child is None:
            receiver, self._sender = CONTEXT.Pipe(duplex=False)
            limits = (SECONDS, MEMORY)
            self._child = Child(_serve, receiver, self._sender, self._functions, limits)
            receiver.close()
        try:
            with suppress(OSError):  # it has died, which reading its result shows
                self._sender.send_bytes(str(self._functions.index(function)).encode())
                self._sender.send_bytes(content)
            result = self._child.result(timeout=6 * SECONDS)
        except RuntimeError as error:
            self._end()
            raise LimitError(str(error)) from None
        if len(content) > LARGE:
            self._end()
        return result

    def _end(self):
        if self._child is not None:
            self._sender.close()
            self._child.end()
            self._child = None


# In the child


def _serve(receiver, sender, functions, limits):
    """Call one function after the other until the pipe closes."""
    sender.close()  # or the pipe would not end when the parent closes its copy
    limit = _limits(*limits)
    with suppress(EOFError):
        while True:
            function = functions[int(receiver.recv_bytes())]
            limit()
            yield function(receiver.recv_bytes())


def _limits(seconds, memory):
    """Limit the memory, and return a function that allows some more seconds of processor time.

    Only Linux has such limits; elsewhere the parent's limit of time has to do.
    """
    if sys.platform != "linux":
        return lambda: None
    import resource  # Linux has it

    from workbook.grading.sandbox.system_calls import address_space_bytes, die_with_parent

    die_with_parent(multiprocessing.parent_process().pid)
    resource.setrlimit(resource.RLIMIT_AS, (address_space_bytes() + memory,) * 2)

    def allow():
        hard = resource.getrlimit(resource.RLIMIT_CPU)[1]
        resource.setrlimit(resource.RLIMIT_CPU, (int(time.process_time() + seconds) + 1, hard))

    return allow
