"""Messages over a pipe: four bytes of length, then the message.

Of what the other side sends, only the bound on the length is relied on.
"""

import math
import os
import selectors
import struct
import time

from workbook.grading.sandbox.limits import MAX_MESSAGE


class FramingError(RuntimeError):
    """The pipe closed, a message was too long or late: "closed", "large" or "time"."""


def send(descriptor, message):
    """Write a whole message."""
    view = memoryview(struct.pack(">I", len(message)) + message)
    while view:
        view = view[os.write(descriptor, view) :]


def receive(descriptor, timeout=math.inf, check=None, interval=math.inf):
    """Return the next message.

    Parameters
    ----------
    descriptor : int
        The pipe's file descriptor.
    timeout : float
        Seconds to wait at most.
    check : callable, optional
        Called every `interval` seconds while waiting; it may raise to end that.
    interval : float
        Seconds between two calls of `check`.

    Raises
    ------
    FramingError
        At the end of the stream, for a message that is too long, or after `timeout`.
    """
    clock = _Clock(timeout, check, interval)
    (length,) = struct.unpack(">I", _read_exactly(descriptor, 4, clock))
    if length > MAX_MESSAGE:
        raise FramingError("large")
    return _read_exactly(descriptor, length, clock)


def readable(channels, timeout=None):
    """Return the channels that can be read or have ended, as soon as there are any.

    After `timeout` seconds there may be none. Channels are descriptors or have a `fileno`. `select`
    would take only the first 1024 descriptors, and a grader may be part of a program with any
    number of open files.
    """
    with selectors.PollSelector() as selector:
        for channel in channels:
            selector.register(channel, selectors.EVENT_READ)
        return [key.fileobj for key, _ in selector.select(timeout)]


class _Clock:
    """When to check and when to give up, whether or not bytes trickle in meanwhile."""

    def __init__(self, timeout, check, interval):
        now = time.monotonic()
        self.deadline, self.check, self.interval = now + timeout, check, interval
        self.next_check = now + interval

    def tick(self):
        """Return the seconds until the next check or the deadline; None for never."""
        now = time.monotonic()
        if now >= self.deadline:
            raise FramingError("time")
        if now >= self.next_check:
            self.check()
            self.next_check = now + self.interval
        wait = min(self.deadline, self.next_check) - now
        return None if wait == math.inf else wait


def _read_exactly(descriptor, count, clock):
    parts = []
    while count:
        wait = clock.tick()
        if readable([descriptor], wait):
            part = os.read(descriptor, min(count, 2**16))
            if not part:
                raise FramingError("closed")
            parts.append(part)
            count -= len(part)
    return b"".join(parts)
