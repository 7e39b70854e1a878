"""Grader: a sandbox and a judge that grade one notebook after the other.

A task has the code cells of a notebook; the result has verdicts and remarks, all plain data.
"""

import os
from dataclasses import asdict, replace

from workbook.checks.contract.verdict import MISSING, Verdict
from workbook.grading.pool import copying
from workbook.grading.pool.judging import Bounds, Judge, Judgement
from workbook.grading.sandbox.preloading import ALWAYS, LIBRARIES, preload
from workbook.grading.sandbox.sandbox import Limits, Sandbox, Unsandboxed
from workbook.notebooks import exercises


def unreadable_notebook(exercise, trouble):
    """Return the `Judgement` on a notebook that could not be read, for the reason `trouble`."""
    verdict = Verdict(MISSING, f"no answer: {trouble}")
    return Judgement(
        dict.fromkeys(exercise.about["answers"], verdict), {}, (f"notebook: {trouble}",)
    )


def with_text_cells(judgement, names):
    """Add a remark on each missing answer among the `names` that cells of text assign."""
    remarks = tuple(
        f"notebook: {name} stands in a cell of text, which is not run: make it a code cell again"
        for name in names
        if name in judgement.verdicts and judgement.verdicts[name].status == MISSING
    )
    return replace(judgement, remarks=judgement.remarks + remarks)


class Grader:
    """A sandbox and a judge that grade one task after the other; use it as a context manager.

    Parameters
    ----------
    limits : Limits
        Those of each notebook.
    bounds : Bounds
        Those of judging it.
    trusting : bool
        Whether notebooks run without a sandbox.
    forkserver : Forkserver, optional
        One from which the sandbox is forked; this process must then have all that judging needs.
    modules : sequence of str
        What notebooks find imported, besides what `forkserver` has imported.

    Raises
    ------
    SandboxUnavailableError
        On entering, where there is no sandbox.
    """

    def __init__(
        self,
        limits=Limits(),
        bounds=Bounds(),
        trusting=False,
        forkserver=None,
        modules=(*ALWAYS, *LIBRARIES),
    ):
        self._sandbox = (Unsandboxed if trusting else Sandbox)(
            limits, forkserver=forkserver, modules=modules
        )
        self._judge = Judge(bounds)
        self._has_checks = forkserver is not None

    def __enter__(self):
        self._sandbox.start()  # it imports what notebooks need while checks are imported here
        try:
            if not self._has_checks:
                preload(*ALWAYS, packages=["workbook.checks", "workbook.checks.research"])
            self._sandbox.__enter__()
        except BaseException:
            self._sandbox.__exit__()
            raise
        return self

    def __exit__(self, *error):
        # First: the judge's process inherited the sandbox's control socket, which must close.
        self._judge.end()
        self._sandbox.__exit__(*error)

    def grade(self, task):
        """Return the judgement, as plain data, on a task.

        It is {"problem": .., "direction": whether verdicts say it, "sources": [..], "other
        variants": names of the same problem with other numbers, on which wrong answers are judged
        once more}.
        """
        exercise = exercises.find(task["problem"])
        exercise = exercise if task["direction"] else exercises.in_homework(exercise)
        self._sandbox.start_run(
            task["sources"],
            exercise.about["answers"],
            before=_missing_data_cells(exercise, task["sources"]),
        )
        self._judge.prepare(exercise)  # while the notebook runs
        outcome = self._sandbox.finish_run()
        judgement = self._judge.judge(exercise, outcome)
        remarks = copying.remarks(judgement, task.get("other variants", ()), outcome, self._judge)
        return to_plain(replace(judgement, remarks=(*judgement.remarks, *remarks)))


def _missing_data_cells(exercise, sources):
    """Return the data cells unless the notebook begins with them.

    It may have lost, changed or moved its own. Cells that say how to get the library may stand
    before them, as they were handed out.
    """
    pristine, data = [], [source.strip() for _, source in exercise.code("data")]
    for _, source in exercise.cells:
        pristine.append(source.strip())
        if pristine[-len(data) :] == data:
            break
    first = [source.strip() for source in sources[: len(pristine)]]
    return [] if first == pristine or first[: len(data)] == data else data


def to_plain(judgement):
    """Return a `Judgement` as plain data, to send to another process."""
    return asdict(judgement)


def from_plain(data):
    """Return the `Judgement` that `to_plain` made plain data of."""
    verdicts = {name: Verdict(**verdict) for name, verdict in data["verdicts"].items()}
    return Judgement(
        verdicts, data["answers"], tuple(data["remarks"]), data["final"], data.get("hashes", {})
    )


def fit_memory(limits, count):
    """Return the limits with less memory, so that `count` workers leave half of the machine's."""
    megabytes = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2**20
    return replace(
        limits, memory_megabytes=min(limits.memory_megabytes, max(256, megabytes // 2 // count))
    )


def to_settings(limits, bounds, trusting=False):
    """Return limits and bounds as plain data, to send to another process."""
    return {"limits": asdict(limits), "bounds": asdict(bounds), "trusting": trusting}


def from_settings(settings):
    """Return (limits, bounds, trusting) of what `to_settings` made."""
    return Limits(**settings["limits"]), Bounds(**settings["bounds"]), settings["trusting"]
