"""Several benches side by side, a process each: units go in, results come back as they are done,
both as JSON bytes."""

import json
import math
import os
import signal
import sys
from contextlib import suppress

from workbook.grading import framing, sandbox
from workbook.grading.bench import Bench, as_plain, from_settings
from workbook.grading.isolation import NoIsolation, NotStarted
from workbook.grading.judging import failed
from workbook.grading.nursery import Nursery
from workbook.grading.preloading import ALWAYS, LIBRARIES


class Ended(NotStarted):
    """A lane itself ended while it got ready."""


def grade_all(units, count, settings, nursery=None):
    """Grade units (dicts with "key", "problem", "sources", "names"); yields (key, result) in the
    order they are done.

    `nursery` is one that has begun to import what they need, if there is one; it is closed in the
    end. A lane that dies fails its unit, which is then to be graded again, and is replaced; a
    nursery that dies while lanes get ready is replaced with them. Raises `NoIsolation` before
    anything is graded if a sandbox cannot be had. Close it (`contextlib.closing`) to end the lanes
    at once.
    """
    waiting = iter(units)
    lanes, nursery = [], nursery or Nursery.start([])
    try:
        for tries_left in range(sandbox.STARTS - 1, -1, -1):
            try:
                begin(lanes, count, settings, nursery)
                for number in range(count):
                    lanes[number] = _ready(lanes[number], settings)
                break
            except NotStarted:
                if nursery.alive() or not tries_left:
                    raise
                while lanes:
                    lanes.pop().stop()
                nursery.close()
                nursery = Nursery.start([])
        busy = {lane: unit for lane in lanes if (unit := lane.take(waiting)) is not None}
        while busy:
            for lane in framing.readable(busy):
                unit = busy.pop(lane)
                result = lane.result()
                if result is None:
                    result = as_plain(failed(unit["names"], "one of its processes ended"))
                    lane.stop()
                    # then this is the first of its lanes that is found dead; the others follow
                    if not nursery.alive():
                        nursery.close()
                        nursery = Nursery.start(
                            [name for names in modules(settings).values() for name in names]
                        )
                    lanes[lanes.index(lane)] = lane = _ready(
                        Lane(settings, nursery).begin(), settings
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
        nursery.close()


def modules(settings):
    """What the nursery of lanes with these settings imports: for notebooks, and then for checks."""
    return settings.get("modules", {"notebooks": [*ALWAYS, *LIBRARIES], "checks": []})


def begin(lanes, count, settings, nursery):
    """Begin `count` lanes from a nursery, each added to the list `lanes` at once: whoever has the
    list can stop them.

    Where their sandboxes come from is forked before the nursery imports what checks alone use.
    """
    nursery.load(modules(settings)["notebooks"])
    lanes += [Lane(settings, nursery) for _ in range(count)]
    nursery.load(modules(settings)["checks"])
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
            lane = Lane(settings, lane.nursery).begin()


class Lane:
    """The grader's end of one lane; the lane itself runs when it is told to `begin`."""

    def __init__(self, settings, nursery):
        self.nursery, self._settings = nursery, settings
        self._number = self._code = self._requests = None
        self._bubblewrap = None if settings["trusting"] else nursery.bubblewrap
        # a nursery of its own, from which its sandboxes come
        self._sandboxes, self._control = nursery.divided()

    def begin(self):
        # It inherits neither the grade store nor another lane's pipes.
        (theirs, requests), (mine, results) = os.pipe(), os.pipe()
        try:
            self._number = self.nursery.fork(
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
                self._code = self.nursery.ended(self._number)
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
            self._code = self.nursery.end(self._number, within=5)
            self.nursery.end(self._sandboxes)
        os.close(self._requests)
        os.close(self._results)
        self._requests = None


def _tidy_up(*_):
    # Once: a second exit in the midst of the first would leave things, and be told.
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    sys.exit()


def work(settings, bwrap):
    """The lane's end, in a process forked from a nursery: grade what comes in until nothing does,
    or not for as long as the settings say."""
    nursery = Nursery.at(3, bwrap)
    signal.signal(signal.SIGTERM, _tidy_up)
    # Results have a descriptor of their own: what a check might print does not come between them.
    results = os.dup(1)
    os.dup2(2, 1)
    with suppress(framing.Broken):
        limits, bounds, trusting = from_settings(settings)
        patience = settings.get("patience", math.inf)
        try:
            with Bench(limits, bounds, trusting, nursery, modules(settings)["notebooks"]) as bench:
                framing.send(results, b'{"ready": true}')
                while True:
                    result = bench.grade(json.loads(framing.receive(0, patience)))
                    if not nursery.alive():
                        # no further sandbox can be had: another lane takes the place of this one
                        return
                    framing.send(results, json.dumps(result).encode())
        except NoIsolation as error:
            if not nursery.alive():
                return  # another lane takes the place of this one
            said = {"refused": str(error), "may start yet": isinstance(error, NotStarted)}
            framing.send(results, json.dumps(said).encode())
