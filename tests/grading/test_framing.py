"""Messages over pipes arrive whole, or fail in a known way, always in time."""

import contextlib
import os
import resource
import struct
import threading
import time

import pytest

from workbook.grading.sandbox import framing


@pytest.fixture
def pipe():
    ends = os.pipe()
    yield ends
    for end in ends:
        with contextlib.suppress(OSError):
            os.close(end)


@pytest.mark.parametrize("message", [b"", b"x", bytes(range(256)) * 1000])
def test_a_message_arrives_whole(pipe, message):
    out, into = pipe
    writer = threading.Thread(target=framing.send, args=(into, message))
    writer.start()
    assert framing.receive(out, timeout=10) == message
    writer.join(timeout=30)


@pytest.mark.parametrize(
    "written, why",
    [
        (b"", "closed"),
        (b"\0\0", "closed"),
        (b"\0\0\0\5abc", "closed"),
        (b"\xff\xff\xff\xff", "large"),
        (struct.pack(">I", framing.MAX_MESSAGE + 1), "large"),
    ],
)
def test_a_broken_message_raises(pipe, written, why):
    out, into = pipe
    os.write(into, written)
    os.close(into)
    with pytest.raises(framing.FramingError, match=why):
        framing.receive(out, timeout=10)


def test_any_number_of_files_may_be_open(pipe):
    """Descriptors can be large in a program with many open files."""
    some, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    high = 2000
    resource.setrlimit(resource.RLIMIT_NOFILE, (max(some, high + 1), most))
    os.dup2(pipe[0], high)
    try:
        framing.send(pipe[1], b"x")
        assert framing.readable([high]) == [high] and framing.receive(high, timeout=10) == b"x"
        assert not framing.readable([high], 0)
    finally:
        os.close(high)
        resource.setrlimit(resource.RLIMIT_NOFILE, (some, most))


def test_waiting_is_bounded(pipe):
    with pytest.raises(framing.FramingError, match="time"):
        framing.receive(pipe[0], timeout=0.05)


def test_trickling_bytes_do_not_extend_the_timeout(pipe):
    out, into = pipe
    going_on = True

    def trickle():
        os.write(into, struct.pack(">I", 10**6))
        while going_on:
            os.write(into, b"x")
            time.sleep(0.001)

    writer, looks, began = threading.Thread(target=trickle), [], time.monotonic()
    writer.start()
    try:
        with pytest.raises(framing.FramingError, match="time"):
            framing.receive(out, timeout=0.3, check=lambda: looks.append(1), interval=0.02)
    finally:
        going_on = False
        writer.join(timeout=30)
    assert time.monotonic() - began < 3 and looks, "it is looked after all the time too"


def test_a_check_may_end_the_wait(pipe):
    def look():
        raise KeyError("enough")

    with pytest.raises(KeyError):
        framing.receive(pipe[0], timeout=10, check=look, interval=0.01)
