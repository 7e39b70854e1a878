"""Grade everything submitted for a course: find, run what has no result yet, store each result at once."""

import os
from dataclasses import dataclass
from pathlib import Path

from trajlib import exercises
from trajlib.checks.verdict import Verdict
from trajlib.grading import assignment as assignments
from trajlib.grading import lanes, submissions, units
from trajlib.grading.judging import Bounds
from trajlib.grading.sandbox import Limits
from trajlib.grading.store import Store


@dataclass(frozen=True)
class Plan:
    """What a run is to do: notebooks still to be graded, how many have a result already, and files left aside."""

    pending: tuple
    known: int
    aside: tuple


def grade(submitted, out, assignment_folder=None, count=None, limits=Limits(), bounds=Bounds(), progress=lambda done, all: None):
    """Grade `submitted` into `out`/grades.sqlite; returns the assignments by name and the `Plan` that was carried out.

    What has a result by the very same exercise and library is not graded again, so a killed run goes on where it
    stopped, and a changed exercise regrades only what it changed. Each result is stored before the next is asked for.
    """
    with Store(Path(out) / "grades.sqlite") as store:
        found = list(submissions.find(submitted))
        known = {name: _assignment(name, assignment_folder, found) for name in sorted({s.assignment for s in found})}
        plan = _plan(found, known, store)
        progress(0, len(plan.pending))
        by_key = {unit["key"]: unit for unit in plan.pending}
        ready = [unit for unit in plan.pending if unit["trouble"] == ""]
        done = 0
        for unit in plan.pending:
            if unit["trouble"]:
                verdicts, remarks = units.unreadable(exercises.find(unit["problem"]), unit["trouble"])
                store.record(unit["key"], unit["exercise"], verdicts, {}, remarks)
                done += 1
                progress(done, len(plan.pending))
        if ready:
            count = min(count or os.cpu_count() or 1, len(ready))
            for key, result in lanes.grade_all(ready, count, units.settings(limits, bounds)):
                verdicts = {name: Verdict(*verdict) for name, verdict in result["verdicts"].items()}
                store.record(key, by_key[key]["exercise"], verdicts, result["answers"], result["remarks"])
                done += 1
                progress(done, len(plan.pending))
    return known, plan


def _plan(found, known, store):
    prints, pending, skipped, aside = {}, [], 0, []
    for submission in found:
        homework = known[submission.assignment]
        problem = submission.problem if submission.problem in homework.problems else None
        if problem is None and len(homework.problems) == 1:
            problem = homework.problems[0]  # there is only one it can be
        if problem is None:
            aside.append((submission.path, submission.trouble or f"it does not say which problem of {homework.name} it is for"))
            continue
        exercise = exercises.find(problem)
        if problem not in prints:
            prints[problem] = units.fingerprint(exercise)
        attempt = store.note_attempt(submission.student, submission.assignment, problem, submission.content, submission.submitted)
        if store.is_graded(attempt, prints[problem]):
            skipped += 1
        else:
            pending.append({"key": attempt, "problem": problem, "exercise": prints[problem], "trouble": submission.trouble,
                            "sources": units.to_run(submission, exercise), "names": list(exercise.about["answers"])})
    return Plan(tuple(pending), skipped, tuple(aside))


def _assignment(name, folder, found):
    """The assignment's file if there is one, else what the notebooks themselves say."""
    path = Path(folder) / name / "assignment.toml" if folder else None
    if path is not None and path.exists():
        return assignments.read(path)
    here = {s.problem for s in found if s.assignment == name and s.problem}
    real = {exercise.number for exercise in exercises.read_all()}
    return assignments.of_problems(name, sorted(here & real, key=lambda number: [int(part) for part in number.split(".")]))
