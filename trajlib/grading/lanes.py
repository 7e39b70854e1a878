"""Several benches side by side, a process each: units go in, results come back as they are done, both as JSON bytes."""

import json
import math
import os
import select
import signal
import subprocess
import sys
from contextlib import suppress

from trajlib.grading import framing, sandbox
from trajlib.grading.bench import Bench, as_plain, from_settings
from trajlib.grading.isolation import NoIsolation, NotStarted, end_with_parent
from trajlib.grading.judging import failed

START = "from trajlib.grading.lanes import work; work()"


class Ended(NotStarted):
    """A lane itself ended while it got ready."""


def grade_all(units, count, settings):
    """Grade units (dicts with "key", "problem", "sources", "names"); yields (key, result) in the order they are done.

    A lane that dies fails its unit, which is then to be graded again, and is replaced. Raises `NoIsolation` before
    anything is graded if a sandbox cannot be had. Close it (`contextlib.closing`) to end the lanes at once.
    """
    waiting = iter(units)
    lanes = [Lane(settings) for _ in range(count)]
    try:
        for number in range(count):
            lanes[number] = _ready(lanes[number], settings)
        busy = {lane: unit for lane in lanes if (unit := lane.take(waiting)) is not None}
        while busy:
            for lane in select.select(list(busy), [], [])[0]:
                unit = busy.pop(lane)
                result = lane.result()
                if result is None:
                    result = as_plain(failed(unit["names"], "one of its processes ended"))
                    lane.stop()
                    lanes[lanes.index(lane)] = lane = _ready(Lane(settings), settings)
                following = lane.take(waiting)  # it goes on while this result is stored
                if following is not None:
                    busy[lane] = following
                yield unit["key"], result
    finally:
        for lane in lanes:
            lane.stop()


def _ready(lane, settings):
    """The lane when it is ready, or one in its place if it ended before: killed, or out of memory."""
    for tries_left in range(sandbox.STARTS - 1, -1, -1):
        try:
            lane.greeted()
            return lane
        except Ended:
            lane.stop()
            if not tries_left:
                raise
            lane = Lane(settings)


class Lane:
    """The grader's end of one lane."""

    def __init__(self, settings):
        # A fresh process, in a session of its own: it inherits neither the grade store nor another lane's pipes, and
        # Ctrl-C reaches the grader alone.
        self._process = subprocess.Popen([sys.executable, "-c", START, str(os.getpid())], stdin=subprocess.PIPE,
                                         stdout=subprocess.PIPE, start_new_session=True)
        self.send(settings)

    def fileno(self):
        return self._process.stdout.fileno()

    def greeted(self):
        """Wait until it is ready. Raises `NoIsolation` or `NotStarted`."""
        try:
            said = json.loads(framing.receive(self.fileno()))
        except framing.Broken:
            raise Ended("a grading process was killed while it started: the machine may be out of memory;"
                        " the same command goes on from here") from None
        if "ready" not in said:
            raise (NotStarted if said["may start yet"] else NoIsolation)(said["refused"])

    def take(self, waiting):
        """Send the next unit, if there is one, and return it."""
        unit = next(waiting, None)
        if unit is not None:
            self.send(unit)
        return unit

    def send(self, message):
        with suppress(BrokenPipeError):  # it has died, which its other pipe will tell
            framing.send(self._process.stdin.fileno(), json.dumps(message).encode())

    def alive(self):
        return self._process.poll() is None

    def end(self, at_once=False):
        """Let it end, from whatever thread; the one that waits for a result gets None."""
        self._process.kill() if at_once else self._process.terminate()

    def result(self):
        """The result at hand; None if the lane has died."""
        with suppress(framing.Broken):
            return json.loads(framing.receive(self.fileno()))

    def stop(self):
        # What the lane has started ends with it (`end_with_parent`).
        self.end()
        try:
            self._process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._process.stdout.close()
        with suppress(OSError):
            self._process.stdin.close()


def work():
    """The lane's end: grade what comes in until nothing does, or not for as long as the settings say."""
    end_with_parent(int(sys.argv[1]))
    signal.signal(signal.SIGTERM, lambda *_: sys.exit())  # so that it tidies up
    # Results have a descriptor of their own: what a check might print does not come between them.
    results = os.dup(1)
    os.dup2(2, 1)
    with suppress(framing.Broken):
        settings = json.loads(framing.receive(0))
        limits, bounds, trusting = from_settings(settings)
        patience = settings.get("patience", math.inf)
        try:
            with Bench(limits, bounds, trusting) as bench:
                framing.send(results, b'{"ready": true}')
                while True:
                    framing.send(results, json.dumps(bench.grade(json.loads(framing.receive(0, patience)))).encode())
        except NoIsolation as error:
            said = {"refused": str(error), "may start yet": isinstance(error, NotStarted)}
            framing.send(results, json.dumps(said).encode())
    # From here on Python itself is tidying up, and would tell of an exit in the midst of it.
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
