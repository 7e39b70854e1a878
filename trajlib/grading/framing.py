"""Messages over a pipe: four bytes of length, then the message. Nothing of it is trusted but the length's bound."""

import os
import select
import struct
import time

#: No message is longer: answers are bounded far below by their encoding.
LONGEST = 16 * 2**20


class Broken(RuntimeError):
    """The other side closed the pipe, sent too much, or nothing in time."""


def send(descriptor, message):
    """Write a message whole."""
    view = memoryview(struct.pack(">I", len(message)) + message)
    while view:
        view = view[os.write(descriptor, view):]


def receive(descriptor, timeout=None):
    """The next message; raises `Broken` at the end of the stream, for one too long, or after `timeout` seconds."""
    deadline = None if timeout is None else time.monotonic() + timeout
    (length,) = struct.unpack(">I", _exactly(descriptor, 4, deadline))
    if length > LONGEST:
        raise Broken(f"a message of {length} bytes")
    return _exactly(descriptor, length, deadline)


def _exactly(descriptor, count, deadline):
    parts = []
    while count:
        if deadline is not None and not select.select([descriptor], [], [], max(0.0, deadline - time.monotonic()))[0]:
            raise Broken("time")
        part = os.read(descriptor, min(count, 2**16))
        if not part:
            raise Broken("closed")
        parts.append(part)
        count -= len(part)
    return b"".join(parts)
