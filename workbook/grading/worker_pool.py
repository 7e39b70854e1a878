"""Several benches side by side, a process each: units go in, results come back as they are done,
both as JSON bytes."""

import json
import math
import os
import signal
import sys
from contextlib import suppress

from workbook.grading import framing, sandbox
from workbook.grading.forkserver import Forkserver
from workbook.grading.grader import Bench, as_plain, from_settings
from workbook.grading.isolation import NoIsolation, NotStarted
from workbook.grading.judging import failed
from workbook.grading.preloading import ALWAYS, LIBRARIES


class Ended(NotStarted):
    """A lane itself ended while it got ready."""


def grade_all(units, count, settings, forkserver=None):
    """Grade units (dicts with "key", "problem", "sources", "names"); yields (key, result) in the
    order they are done.

    `forkserver` is one that has begun to import what they need, if there is one; it is closed in the
    end. A lane that dies fails its unit, which is then to be graded again, and is replaced; a
    forkserver that dies while lanes get ready is replaced with them. Raises `NoIsolation` before
    anything is graded if a sandbox cannot be had. Close it (`contextlib.closing`) to end the lanes
    at once.
    """
    waiting = iter(units)
    lanes, forkserver = [], forkserver or Forkserver.start([])
    try:
        for tries_left in range(sandbox.STARTS - 1, -1, -1):
            try:
                begin(lanes, count, settings, forkserver)
                for number in range(count):
                    lanes[number] = _ready(lanes[number], settings)
                break
            except NotStarted:
                if forkserver.alive() or not tries_left:
                    raise
                while lanes:
                    lanes.pop().stop()
                forkserver.close()
                forkserver = Forkserver.start([])
        busy = {lane: unit for lane in lanes if (unit := lane.take(waiting)) is not None}
        while busy:
            for lane in framing.readable(busy):
                unit = busy.pop(lane)
                result = lane.result()
                if result is None:
                    result = as_plain(failed(unit["names"], "one of its processes ended"))
                    lane.stop()
                    # then this is the first of its lanes that is found dead; the others follow
                    if not forkserver.alive():
                        forkserver.close()
                        forkserver = Forkserver.start(
                            [name for names in modules(settings).values() for name in names]
                        )
                    lanes[lanes.index(lane)] = lane = _ready(
                        Lane(settings, forkserver).begin(), settings
                    )
                following = lane.take(waiting)  # it goes on while this result is stored
                if following is not None:
                    busy[lane] = following
                yield unit["key"], result
    finally:
        for lane in lanes:
            lane.end()
        for lane in lanes:
            lane.stop()
        forkserver.close()


def modules(settings):
    """What the forkserver of lanes with these settings imports: for notebooks, and then for checks."""
    return settings.get("modules", {"notebooks": [*ALWAYS, *LIBRARIES], "checks": []})


def begin(lanes, count, settings, forkserver):
    """Begin `count` lanes from a forkserver, each added to the list `lanes` at once: whoever has the
    list can stop them.

    Where their sandboxes come from is forked before the forkserver imports what checks alone use.
    """
    forkserver.load(modules(settings)["notebooks"])
    lanes += [Lane(settings, forkserver) for _ in range(count)]
    forkserver.load(modules(settings)["checks"])
    for lane in lanes:
        lane.begin()


def _ready(lane, settings):
    """The lane when it is ready, or one in its place if it ended before: killed, or out of
    memory."""
    for tries_left in range(sandbox.STARTS - 1, -1, -1):
        try:
            lane.greeted()
            return lane
        except Ended:
            lane.stop()
            if not tries_left:
                raise
            lane = Lane(settings, lane.forkserver).begin()


class Lane:
    """The grader's end of one lane; the lane itself runs when it is told to `begin`."""

    def __init__(self, settings, forkserver):
        self.forkserver, self._settings = forkserver, settings
        self._number = self._code = self._requests = None
        self._bubblewrap = None if settings["trusting"] else forkserver.bubblewrap
        # a forkserver of its own, from which its sandboxes come
        self._sandboxes, self._control = forkserver.spawn_child()

    def begin(self):
        # It inherits neither the grade store nor another lane's pipes.
        (theirs, requests), (mine, results) = os.pipe(), os.pipe()
        try:
            self._number = self.forkserver.fork(
                "lane",
                [self._settings, self._bubblewrap],
                [theirs, results, None, self._control.fileno()],
            )
        finally:
            os.close(theirs)
            os.close(results)
            self._control.close()
        self._requests, self._results = requests, mine
        return self

    def fileno(self):
        return self._results

    def greeted(self):
        """Wait until it is ready. Raises `NoIsolation` or `NotStarted`."""
        try:
            said = json.loads(framing.receive(self.fileno()))
        except framing.Broken:
            raise Ended(
                "a grading process was killed while it started: the machine may be out of memory;"
                " the same command goes on from here"
            ) from None
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
            framing.send(self._requests, json.dumps(message).encode())

    def alive(self):
        if self._number is not None and self._code is None:
            with suppress(NotStarted):
                self._code = self.forkserver.ended(self._number)
                return self._code is None
        return False

    def end(self, at_once=False):
        """Let it end, from whatever thread; the one that waits for a result gets None."""
        if self.alive():
            os.kill(self._number, signal.SIGKILL if at_once else signal.SIGTERM)

    def result(self):
        """The result at hand; None if the lane has died."""
        with suppress(framing.Broken):
            return json.loads(framing.receive(self.fileno()))

    def stop(self):
        if self._requests is None:
            return
        # What the lane has started ends with it (`end_with_parent`), or with where its sandboxes
        # come from.
        self.end()
        with suppress(NotStarted):
            self._code = self.forkserver.end(self._number, within=5)
            self.forkserver.end(self._sandboxes)
        os.close(self._requests)
        os.close(self._results)
        self._requests = None


def _tidy_up(*_):
    # Once: a second exit in the midst of the first would leave things, and be told.
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    sys.exit()


def work(settings, bwrap):
    """The lane's end, in a process forked from a forkserver: grade what comes in until nothing does,
    or not for as long as the settings say."""
    forkserver = Forkserver.at(3, bwrap)
    signal.signal(signal.SIGTERM, _tidy_up)
    # Results have a descriptor of their own: what a check might print does not come between them.
    results = os.dup(1)
    os.dup2(2, 1)
    with suppress(framing.Broken):
        limits, bounds, trusting = from_settings(settings)
        patience = settings.get("patience", math.inf)
        try:
            with Bench(
                limits, bounds, trusting, forkserver, modules(settings)["notebooks"]
            ) as bench:
                framing.send(results, b'{"ready": true}')
                while True:
                    result = bench.grade(json.loads(framing.receive(0, patience)))
                    if not forkserver.alive():
                        # no further sandbox can be had: another lane takes the place of this one
                        return
                    framing.send(results, json.dumps(result).encode())
        except NoIsolation as error:
            if not forkserver.alive():
                return  # another lane takes the place of this one
            said = {"refused": str(error), "may start yet": isinstance(error, NotStarted)}
            framing.send(results, json.dumps(said).encode())
