"""One unit of work: a notebook's cells for a problem, in; verdicts and remarks, out. Both are plain data."""

import hashlib
import json
from dataclasses import asdict

from trajlib import exercises
from trajlib.checks.verdict import MISSING, Verdict
from trajlib.dependencies import module_closure
from trajlib.grading.judging import Bounds, judge
from trajlib.grading.sandbox import Limits, Sandbox


def fingerprint(exercise):
    """What a result depends on besides the notebook: the exercise's data and check cells and the library under them."""
    cells = exercise.code("data", "check")
    closure = module_closure("\n".join(source for _, source in cells))
    return hashlib.sha256(json.dumps([cells, closure], sort_keys=True).encode()).hexdigest()


def to_run(submission, exercise):
    """The sources to run: all code cells but the check cells that are as we handed them out."""
    ours = {source.strip() for _, source in exercise.code("check")}
    return [source for _, source in submission.cells if source.strip() not in ours]


def unreadable(exercise, trouble):
    """Verdicts on a notebook that could not be read."""
    return {name: Verdict(MISSING, f"no answer: {trouble}") for name in exercise.about["answers"]}, (trouble,)


class Bench:
    """A sandbox and a judge; `grade` takes one unit after the other. Use as a context manager."""

    def __init__(self, limits=Limits(), bounds=Bounds()):
        self._sandbox, self._bounds = Sandbox(limits), bounds

    def __enter__(self):
        # What the judging children need is imported once, here.
        import sympy  # noqa: F401

        from trajlib import checks
        for name in checks.__all__:
            getattr(checks, name)
        self._sandbox.__enter__()
        return self

    def __exit__(self, *error):
        self._sandbox.__exit__(*error)

    def grade(self, unit):
        """{"verdicts": {name: [status, message]}, "answers": {name: text}, "remarks": [...]} for {"problem": .., "sources": [..]}."""
        exercise = exercises.find(unit["problem"])
        outcome = self._sandbox.run(unit["sources"], exercise.about["answers"])
        judgement = judge(exercise, outcome, self._bounds)
        return {"verdicts": {name: [v.status, v.message] for name, v in judgement.verdicts.items()},
                "answers": judgement.answers, "remarks": list(judgement.remarks)}


def settings(limits, bounds):
    """Limits as plain data, to send to another process; `from_settings` reads them."""
    return {"limits": asdict(limits), "bounds": asdict(bounds)}


def from_settings(given):
    return Limits(**given["limits"]), Bounds(**given["bounds"])
