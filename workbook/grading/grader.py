"""A bench grades one notebook after the other: its cells for a problem in, verdicts and remarks
out, all plain data."""

import os
from dataclasses import asdict, replace

from workbook.checks.contract.verdict import MISSING, Verdict
from workbook.grading.judging import Bounds, Judge, Judgement
from workbook.grading.preloading import ALWAYS, LIBRARIES, preload
from workbook.grading.sandbox import Limits, Sandbox, Trusting
from workbook.notebooks import exercises


def unreadable(exercise, trouble):
    """The `Judgement` on a notebook that could not be read."""
    verdict = Verdict(MISSING, f"no answer: {trouble}")
    return Judgement(
        dict.fromkeys(exercise.about["answers"], verdict), {}, (f"notebook: {trouble}",)
    )


class Bench:
    """A sandbox and a judge; `grade` takes one unit after the other. Use as a context manager.

    Notebooks find `modules` imported, and what `forkserver` has imported if one is given.
    """

    def __init__(
        self,
        limits=Limits(),
        bounds=Bounds(),
        trusting=False,
        forkserver=None,
        modules=(*ALWAYS, *LIBRARIES),
    ):
        self._sandbox = (Trusting if trusting else Sandbox)(
            limits, forkserver=forkserver, modules=modules
        )
        self._judge = Judge(bounds)
        self._ready = forkserver is not None  # this process was forked with all that judging needs

    def __enter__(self):
        self._sandbox.start()  # it loads its own while the judging children's is loaded here
        try:
            if not self._ready:
                preload(*ALWAYS, packages=["workbook.checks", "workbook.checks.research"])
            self._sandbox.__enter__()
        except BaseException:
            self._sandbox.__exit__()
            raise
        return self

    def __exit__(self, *error):
        # it holds what it was forked with, by which the sandbox's process would wait for more
        self._judge.end()
        self._sandbox.__exit__(*error)

    def grade(self, unit):
        """The judgement on a unit {"problem": .., "sources": [..]}, as plain data."""
        exercise = exercises.find(unit["problem"])
        self._sandbox.hand_in(
            unit["sources"], exercise.about["answers"], before=_lacking(exercise, unit["sources"])
        )
        self._judge.get_ready(exercise)  # while the notebook runs
        return as_plain(self._judge.of(exercise, self._sandbox.outcome()))


def _lacking(exercise, sources):
    """The data cells, unless the notebook begins with them: it may have lost, changed or moved its
    own.

    Cells that say how to get the library may stand before them, as they were handed out.
    """
    pristine, data = [], [source.strip() for _, source in exercise.code("data")]
    for _, source in exercise.cells:
        pristine.append(source.strip())
        if pristine[-len(data) :] == data:
            break
    given = [source.strip() for source in sources[: len(pristine)]]
    return [] if given == pristine or given[: len(data)] == data else data


def as_plain(judgement):
    """A `Judgement` as plain data, to send to another process; `from_plain` reads it."""
    return asdict(judgement)


def from_plain(given):
    verdicts = {name: Verdict(**verdict) for name, verdict in given["verdicts"].items()}
    return Judgement(
        verdicts, given["answers"], tuple(given["remarks"]), given["final"], given.get("hashes", {})
    )


def fitting(limits, count):
    """The same limits with no more memory than lets `count` lanes together leave half of this
    machine's free."""
    megabytes = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2**20
    return replace(
        limits, memory_megabytes=min(limits.memory_megabytes, max(256, megabytes // 2 // count))
    )


def settings(limits, bounds, trusting=False):
    """Limits as plain data, to send to another process; `from_settings` reads them."""
    return {"limits": asdict(limits), "bounds": asdict(bounds), "trusting": trusting}


def from_settings(given):
    return Limits(**given["limits"]), Bounds(**given["bounds"]), given["trusting"]
