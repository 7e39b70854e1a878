"""Several benches side by side, a process each: units go in, results come back as they are done."""

import multiprocessing
import signal
from multiprocessing.connection import wait

from trajlib.checks.verdict import UNCHECKED
from trajlib.grading.isolation import NoIsolation
from trajlib.grading.units import Bench, from_settings


def grade_all(units, count, settings):
    """Grade units (dicts with "key", "problem", "sources", "names"); yields (key, result) in the order they are done.

    A lane that dies costs its unit nothing but a verdict `unchecked` that names the grader, and is replaced. Raises
    `NoIsolation` before anything is graded if a sandbox cannot be had.
    """
    waiting = iter(units)
    lanes = [_Lane(settings) for _ in range(count)]
    try:
        for lane in lanes:
            lane.greeted()
        busy = {}
        for lane in lanes:
            _next(lane, waiting, busy)
        while busy:
            for channel in wait(list(busy)):
                lane, unit = busy.pop(channel)
                try:
                    result = channel.recv()
                except (EOFError, OSError):
                    result = {"verdicts": dict.fromkeys(unit["names"], [UNCHECKED, "the grader failed on this notebook; a lecturer has to look at it"]),
                              "answers": {}, "remarks": ["the grader's own process ended while it had this notebook"]}
                    lane.stop()
                    lanes[lanes.index(lane)] = lane = _Lane(settings)
                    lane.greeted()
                yield unit["key"], result
                _next(lane, waiting, busy)
    finally:
        for lane in lanes:
            lane.stop()


def _next(lane, waiting, busy):
    unit = next(waiting, None)
    if unit is not None:
        lane.channel.send(unit)
        busy[lane.channel] = lane, unit


class _Lane:
    def __init__(self, settings):
        # Not forked: a lane inherits neither the grade store nor another lane's pipes.
        context = multiprocessing.get_context("spawn")
        self.channel, theirs = context.Pipe()
        self._process = context.Process(target=_work, args=(theirs, settings))
        self._process.start()
        theirs.close()

    def greeted(self):
        try:
            said = self.channel.recv()
        except EOFError:
            said = "the lane ended without a word"
        if said != "ready":
            raise NoIsolation(said)

    def stop(self):
        self.channel.close()
        self._process.terminate()
        self._process.join()


def _work(channel, settings):
    # Ctrl-C is the parent's business: it stops the lanes when the result at hand is stored.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: (_ for _ in ()).throw(SystemExit))
    try:
        with Bench(*from_settings(settings)) as bench:
            channel.send("ready")
            while True:
                channel.send(bench.grade(channel.recv()))
    except NoIsolation as error:
        channel.send(str(error))
    except EOFError:
        pass
