"""No counter that the kernel keeps for a user passes a bit from one running notebook to another.

One notebook fills what is counted, another looks. Where nothing guards, the second sees it.
"""

import json
import os
import resource
import signal
import time

import pytest

from workbook.grading.sandbox import isolation
from workbook.grading.sandbox.limits import Limits
from workbook.grading.sandbox.preloading import ALWAYS
from workbook.grading.sandbox.sandbox import Sandbox
from workbook.notebooks.execution import Child

LIMITS = Limits(cpu_seconds=20, wall_seconds=100, memory_megabytes=600)
#: After the counter is full; the answer says from when to when.
HOLD = """
import time
begin = time.monotonic()
while time.monotonic() < begin + 6:
    sum(range(1000))
seen = [begin, time.monotonic()]
"""
FILL_AND_LOOK = {
    "descriptors in flight": (
        """
import socket
held = [socket.socketpair() for _ in range(4)]
for sender, _ in held:
    try:
        socket.send_fds(sender, [b"x"], [sender.fileno()] * 250)
    except OSError:
        pass
""",
        """
import socket
left, right = socket.socketpair()
try:
    socket.send_fds(left, [b"x"], [left.fileno()])
    seen = "sent"
except OSError as error:
    seen = str(error.errno)
""",
    ),
    "queued signals": (
        """
import ctypes, signal
libc = ctypes.CDLL(None, use_errno=True)
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGRTMIN])
import os
while libc.sigqueue(os.getpid(), int(signal.SIGRTMIN), None) == 0:
    pass
""",
        """
import ctypes, os, signal
libc = ctypes.CDLL(None, use_errno=True)
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGRTMIN])
seen = str(libc.sigqueue(os.getpid(), int(signal.SIGRTMIN), None))
""",
    ),
    "buffers of pipes": (
        """
import fcntl, os, time
held, filled = [], os.pipe()
for _ in range(3):
    if os.fork() == 0:
        try:
            while True:
                held.append(os.pipe())
                fcntl.fcntl(held[-1][0], fcntl.F_SETPIPE_SZ, 2**20)
        except OSError:
            pass
        try:
            while True:
                held.append(os.pipe())
        except OSError:
            pass
        os.write(filled[1], b"x")
        time.sleep(600)
for _ in range(3):
    os.read(filled[0], 1)
""",
        """
import fcntl, os
read, write = os.pipe()
seen = str(fcntl.fcntl(read, fcntl.F_GETPIPE_SZ))
""",
    ),
}


def _unguarded(source, user):
    """Run a cell as a user without rights, with the limits of a notebook's process, and hold."""
    if os.getuid() == 0:
        os.setgroups([])
        os.setresgid(user, user, user)
        os.setresuid(user, user, user)
    resource.setrlimit(resource.RLIMIT_NOFILE, (128, 128))
    os.setsid()
    namespace = {}
    exec(source, namespace)
    yield [namespace.get("seen"), os.getpid()]
    time.sleep(600)


def _unguarded_bits(fill, look, user):
    """Return what the second sees before the first has filled the counter, and after."""
    children, seen = [], []
    try:
        for source in (look, fill, look):
            children.append(Child(_unguarded, source, user))
            seen.append(children[-1].result(timeout=120))
    finally:
        for (_, pid), child in zip(seen, children):
            os.killpg(pid, signal.SIGKILL)
            child.end()
    return seen[0][0], seen[2][0]


def _sandboxed_bits(fill, look):
    """Return what the second sees before, and all that it sees while the first holds."""
    with Sandbox(LIMITS, modules=ALWAYS) as filling, Sandbox(LIMITS, modules=ALWAYS) as looking:
        before, seen = _seen(looking.run([look], ["seen"])), []
        filling.start_run([fill + HOLD], ["seen"])
        start = time.monotonic()
        while time.monotonic() < start + 9:
            begin, bit = time.monotonic(), _seen(looking.run([look], ["seen"]))
            seen.append((begin, time.monotonic(), bit))
        begin, end = _seen(filling.finish_run())
    return before, {bit for first, last, bit in seen if begin < first and last < end}


def _seen(outcome):
    assert outcome.ended == "done", outcome
    return json.loads(json.loads(outcome.handed_over)["encoded"]["seen"])


@pytest.mark.parametrize("counter", FILL_AND_LOOK)
def test_what_the_kernel_counts_by_user(counter):
    fill, look = FILL_AND_LOOK[counter]
    before, after = _unguarded_bits(fill, look, isolation.NOBODY)
    assert before != after, "unguarded, nothing is seen, so this would prove nothing"
    before, while_held = _sandboxed_bits(fill, look)
    assert while_held == {before}


def test_each_slot_has_a_user_of_its_own(monkeypatch):
    own = isolation.sandbox_user()
    assert own == isolation.FIRST_USER + os.getpid()
    monkeypatch.setattr(isolation, "FIRST_USER", 2**32)
    assert isolation.sandbox_user() == isolation.NOBODY, "no such user in this container"
