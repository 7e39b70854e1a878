"""Grader: a sandbox and a judge that grade one notebook after the other.

A task has the code cells of a notebook; the result has verdicts and remarks, all plain data.
"""

import json
import math
from dataclasses import asdict, dataclass, field, replace

import psutil

from workbook.checks.contract.verdict import MISSING, Verdict
from workbook.course import current
from workbook.grading.pool import copying
from workbook.grading.pool.judging import Bounds, Judge, Judgement
from workbook.grading.sandbox.limits import Limits
from workbook.grading.sandbox.preloading import ALWAYS, LIBRARIES, preload
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


@dataclass(frozen=True)
class Task:
    """A notebook to be graded.

    Parameters
    ----------
    problem : str
        Its problem or variant.
    direction : bool
        Whether verdicts say in which direction a number is wrong.
    sources : sequence of str
        Its code cells.
    other_variants : sequence of str
        Names of the same problem with other numbers, on which wrong answers are judged once more.
    key : int
        What its result comes back with.
    names : sequence of str
        Names of the answers.
    """

    problem: str
    direction: bool
    sources: tuple
    other_variants: tuple = ()
    key: int = 0
    names: tuple = ()

    def to_json(self):
        """Return the parts that grading needs, as JSON bytes: none of them is about the student."""
        sent = ("problem", "direction", "sources", "other_variants")
        return json.dumps({part: getattr(self, part) for part in sent}).encode()

    @classmethod
    def from_json(cls, content):
        """Return the task that `to_json` made bytes of."""
        return cls(**json.loads(content))


class Grader:
    """A sandbox and a judge that grade one task after the other; use it as a context manager.

    Parameters
    ----------
    sandbox : Sandbox or WasmSandbox
        Where notebooks run; it is not yet entered.
    bounds : Bounds
        Those of judging a notebook.
    has_checks : bool
        Whether this process, or the one that it makes to judge, needs nothing to be imported first.

    Raises
    ------
    SandboxUnavailableError
        On entering, where there is no sandbox.
    """

    def __init__(self, sandbox, bounds=Bounds(), has_checks=False):
        self._sandbox, self._judge, self._has_checks = sandbox, Judge(bounds), has_checks

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
        """Return the judgement, as plain data, on a `Task`."""
        exercise = exercises.find(task.problem)
        exercise = exercise if task.direction else exercises.in_homework(exercise)
        self._sandbox.start_run(
            task.sources,
            exercise.about["answers"],
            before=_missing_data_cells(exercise, task.sources),
        )
        self._judge.prepare(exercise)  # while the notebook runs
        outcome, before = self._sandbox.finish_run(), self._judge.seconds_used
        judgement = self._judge.judge(exercise, outcome)
        remarks = copying.remarks(judgement, task.other_variants, outcome, self._judge)
        seconds = outcome.seconds + self._judge.seconds_used - before
        return to_plain(replace(judgement, remarks=(*judgement.remarks, *remarks), seconds=seconds))


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
        verdicts,
        data["answers"],
        tuple(data["remarks"]),
        data["final"],
        data.get("hashes", {}),
        data.get("seconds", 0.0),
    )


def _fit_memory(limits, count):
    megabytes = psutil.virtual_memory().total // 2**20
    return replace(
        limits, memory_megabytes=min(limits.memory_megabytes, max(256, megabytes // 2 // count))
    )


def _course_folder():
    course = current()
    return str(course.folder) if course else None


@dataclass(frozen=True)
class Settings:
    """What is the same for all notebooks of a run, sent to each process that grades.

    Parameters
    ----------
    limits, bounds : Limits, Bounds
        Those of running and of judging a notebook.
    trusting : bool
        Whether notebooks run without a sandbox.
    modules : dict
        What the forkserver imports, as of `preloading.modules_for`.
    idle_seconds : float
        How long a worker process waits for a task before it ends.
    course : str or None
        Folder of the course; by default that of this process.
    """

    limits: Limits = field(default_factory=Limits)
    bounds: Bounds = field(default_factory=Bounds)
    trusting: bool = False
    modules: dict = field(
        default_factory=lambda: {"notebooks": [*ALWAYS, *LIBRARIES], "checks": []}
    )
    idle_seconds: float = math.inf
    course: str | None = field(default_factory=_course_folder)

    def fit_memory(self, count):
        """Return the settings with less memory, so that `count` workers leave half of it."""
        return replace(
            self, limits=_fit_memory(self.limits, count), bounds=_fit_memory(self.bounds, count)
        )

    @classmethod
    def from_plain(cls, data):
        """Return the settings that `dataclasses.asdict` made plain data of."""
        parts = {"limits": Limits(**data["limits"]), "bounds": Bounds(**data["bounds"])}
        return cls(**data | parts)
