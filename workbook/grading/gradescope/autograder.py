"""The autograder that Gradescope runs for one submission.

It reads /autograder/submission, grades it, and writes /autograder/results/results.json. Gradescope
keeps due dates itself; which attempt counts is decided by assignment.toml, from the scores of
earlier submissions.
"""

import dataclasses
import json
import os
import pwd
import shutil
import stat
import tempfile
import time
from contextlib import suppress
from pathlib import Path

from workbook.grading.course import assignment as assignments
from workbook.grading.course import matching, record, submissions
from workbook.grading.course.store import Attempt
from workbook.grading.gradescope.own_user import OwnUser
from workbook.grading.pool.grader import unreadable_notebook, with_text_cells
from workbook.grading.pool.judging import Bounds, judge
from workbook.grading.reports import exporting
from workbook.grading.reports.feedback import hints
from workbook.grading.reports.scores import of_student
from workbook.grading.sandbox.sandbox import Limits
from workbook.grading.sandbox.sanitising import sanitise
from workbook.notebooks import exercises

#: The user that setup.sh makes.
USER = "workbook-student"
#: Gradescope ends an autograder after ten minutes by default.
SECONDS = 480
#: Of memory, so that a container of 3 GB holds a notebook, the grader and the judging.
MEGABYTES = 1024


def main(root=Path("/autograder")):
    """Grade the submission below `root`."""
    began = time.monotonic()
    homework = assignments.read(root / "source" / "assignment.toml")
    earlier = _earlier(root / "submission_metadata.json")
    with tempfile.TemporaryDirectory() as scratch:
        matched, aside, remarks = _submitted(root / "submission", Path(scratch), homework)
        attempts = _graded(matched, homework)
    # All that was handed in at once is one attempt: of two notebooks for a problem the better one
    # counts.
    # Of what a lecturer grades by hand Gradescope knows nothing.
    points = {problem: homework.points[problem] for problem in homework.problems}
    score = of_student(
        "student",
        dataclasses.replace(
            homework, attempt="best", attempts=None, policy=assignments.NO_POLICY, points=points
        ),
        attempts,
        {},
        aside,
    )
    hint_counts = {
        (answer.problem, answer.answer): len(hints(answer, exercises.find(answer.problem).about))
        for answer in score.answers
        if answer.problem in score.counted
    }
    remarks += [
        f"{problem}: {remark}"
        for problem, attempt in score.counted.items()
        for remark in attempt.remarks
    ]
    points, notes = _counting_points(homework, earlier, score.points)
    text = exporting.gradescope_json(
        score, homework, hint_counts, [*notes, *remarks], points, time.monotonic() - began
    )
    record.put(root / "results" / "results.json", text)


def _earlier(path):
    """Return the points of earlier submissions, oldest first, on which the grader did not fail."""
    with suppress(OSError, ValueError, KeyError, TypeError, AttributeError):
        previous = json.loads(path.read_text(encoding="utf-8"))["previous_submissions"]
        return [
            float(submission["score"] or 0)
            for submission in previous
            if (submission.get("results") or {}).get("tests")
        ]
    return []


def _counting_points(homework, earlier, now):
    """Return (points, sentences on them) by the rule of the assignment."""
    counting = [*earlier, now][: homework.attempts]
    points = max(counting) if homework.attempt == "best" else counting[-1]
    if homework.attempts is not None and len(earlier) >= homework.attempts:
        return points, [
            f"This is attempt {len(earlier) + 1}; the first {homework.attempts} count. Your points "
            f"are {points:g}."
        ]
    return points, [
        f"An earlier attempt of yours was better and counts: {points:g} points."
    ] if points > now else []


def _submitted(folder, scratch, homework):
    """Return ((problem, submission) of each notebook, what was left aside, sentences on that)."""
    # As in a course's folder: student/assignment/notebook. The number keeps equal names from
    # different folders apart.
    for k, path in enumerate(
        sorted(path for path in folder.rglob("*") if path.suffix.lower() == ".ipynb")
    ):
        copy = scratch / "student" / f"{k:05d}" / path.name
        copy.parent.mkdir(parents=True)
        if stat.S_ISREG(path.lstat().st_mode):
            shutil.copy2(path, copy)
        else:
            copy.symlink_to("/nowhere")  # reported as a link, and not followed
    matched, aside = {}, []
    for entry in submissions.find(scratch):
        problem = (
            entry
            if isinstance(entry, submissions.LeftAside)
            else matching.problem_for(entry, homework)
        )
        if isinstance(problem, submissions.LeftAside):
            aside.append(problem)
        else:
            matched[problem, entry.content] = (problem, entry)
    remarks = [f"left aside: {sanitise(Path(entry.path).name)}: {entry.reason}" for entry in aside]
    if not matched:
        remarks.append("There is no notebook of this homework in what you handed in.")
    return list(matched.values()), aside, remarks


def _graded(matched, homework):
    """Run and judge each notebook; return an `Attempt` for each."""
    if os.getuid() != 0:
        raise SystemExit(
            "run_autograder has to run as root, so that it can run notebooks as another user"
        )
    _import_checks()
    limits, bounds = _limits(len(matched))
    attempts = []
    with OwnUser(pwd.getpwnam(USER), limits) as sandbox:
        for number, (problem, submission) in enumerate(matched):
            exercise = homework.exercise(problem)
            if submission.trouble:
                judgement = unreadable_notebook(exercise, submission.trouble)
            else:
                data = [source for _, source in exercise.code("data")]
                judgement = judge(
                    exercise,
                    sandbox.run(
                        exercise.sources_to_run(submission.cells),
                        exercise.about["answers"],
                        before=data,
                    ),
                    bounds,
                )
            judgement = with_text_cells(judgement, submission.names_in_text)
            attempts.append(
                Attempt(
                    number,
                    "student",
                    "",
                    problem,
                    submission.content,
                    submission.submitted,
                    None,
                    judgement.verdicts,
                    judgement.answers,
                    judgement.remarks,
                )
            )
    return attempts


def _limits(count):
    """Return the limits and bounds of each of `count` notebooks, so that all are done in time."""
    share = SECONDS / max(count, 1)
    wall = min(share / 2, 180)
    judging = min(share / 6, 60)
    return (
        Limits(
            cpu_seconds=min(wall, 60),
            wall_seconds=wall,
            withheld_seconds=0,
            memory_megabytes=MEGABYTES,
        ),
        Bounds(seconds=judging, answer_seconds=judging / 3),
    )


def _import_checks():
    """Import what judging needs, for all its forked children."""
    # before the fork, and not where only the settings are read
    import sympy  # noqa: F401

    from workbook import checks

    for package in (checks, checks.research):
        for name in package.__all__:
            getattr(package, name)


if __name__ == "__main__":
    main()
