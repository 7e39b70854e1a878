"""Messages over a pipe: four bytes of length, then the message. Nothing of it is trusted but the
length's bound."""

import math
import os
import selectors
import struct
import time

#: No message is longer: answers are bounded far below by their encoding.
LONGEST = 16 * 2**20


class Broken(RuntimeError):
    """The other side closed the pipe, sent too much, or nothing in time: the message is "closed",
    "large" or "time"."""


def send(descriptor, message):
    """Write a message whole."""
    view = memoryview(struct.pack(">I", len(message)) + message)
    while view:
        view = view[os.write(descriptor, view) :]


def receive(descriptor, timeout=math.inf, look=None, every=math.inf):
    """The next message; raises `Broken` at the end of the stream, for one too long, or after
    `timeout` seconds.

    `look` is called all `every` seconds of waiting, and may raise to end it.
    """
    clock = _Clock(timeout, look, every)
    (length,) = struct.unpack(">I", _exactly(descriptor, 4, clock))
    if length > LONGEST:
        raise Broken("large")
    return _exactly(descriptor, length, clock)


def readable(channels, timeout=None):
    """Those of `channels` (descriptors, or what has a `fileno`) that can be read or have ended:
    waits for the first, or `timeout` seconds.

    A grader may be part of a program with any number of open files, of which `select` takes the
    first 1024 alone.
    """
    with selectors.PollSelector() as selector:
        for channel in channels:
            selector.register(channel, selectors.EVENT_READ)
        return [key.fileobj for key, _ in selector.select(timeout)]


class _Clock:
    """When to look, and when to give up, whether or not bytes trickle in meanwhile."""

    def __init__(self, timeout, look, every):
        now = time.monotonic()
        self.deadline, self.look, self.every, self.next_look = (
            now + timeout,
            look,
            every,
            now + every,
        )

    def tick(self):
        """Seconds until there is something to do again; None for never."""
        now = time.monotonic()
        if now >= self.deadline:
            raise Broken("time")
        if now >= self.next_look:
            self.look()
            self.next_look = now + self.every
        wait = min(self.deadline, self.next_look) - now
        return None if wait == math.inf else wait


def _exactly(descriptor, count, clock):
    parts = []
    while count:
        wait = clock.tick()
        if readable([descriptor], wait):
            part = os.read(descriptor, min(count, 2**16))
            if not part:
                raise Broken("closed")
            parts.append(part)
            count -= len(part)
    return b"".join(parts)
