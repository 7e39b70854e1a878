"""What runs on Gradescope for one submission: read /autograder/submission, grade, write
/autograder/results/results.json.

Gradescope keeps due dates itself; which attempt counts is as assignment.toml says, from the scores
of earlier ones.
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

from workbook.grading import assignment as assignments
from workbook.grading import exporting, matching, record, submissions
from workbook.grading.feedback import hints
from workbook.grading.grader import unreadable
from workbook.grading.gradescope.own_user import OwnUser
from workbook.grading.judging import Bounds, judge
from workbook.grading.sandbox import Limits
from workbook.grading.sanitising import printable
from workbook.grading.scores import of_student
from workbook.grading.store import Attempt
from workbook.notebooks import exercises

#: The user that setup.sh makes.
USER = "workbook-student"
#: Gradescope ends an autograder after ten minutes unless it is told otherwise.
SECONDS = 480
#: Of memory, so that a container of 3 GB holds a notebook, the grader and the judging.
MEGABYTES = 1024


def main(root=Path("/autograder")):
    begun = time.monotonic()
    homework = assignments.read(root / "source" / "assignment.toml")
    earlier = _earlier(root / "submission_metadata.json")
    with tempfile.TemporaryDirectory() as scratch:
        found, aside, remarks = _submitted(root / "submission", Path(scratch), homework)
        attempts = _graded(found)
    # All that was handed in at once is one attempt: of two notebooks for a problem the better one
    # counts.
    score = of_student(
        "student",
        dataclasses.replace(homework, attempt="best", attempts=None, due=None),
        attempts,
        {},
        aside,
    )
    hinted = {
        (answer.problem, answer.answer): len(hints(answer, exercises.find(answer.problem).about))
        for answer in score.answers
        if answer.problem in score.counted
    }
    remarks += [
        f"{problem}: {remark}"
        for problem, attempt in score.counted.items()
        for remark in attempt.remarks
    ]
    points, said = _that_counts(homework, earlier, score.points)
    text = exporting.gradescope_json(
        score, hinted, [*said, *remarks], points, time.monotonic() - begun
    )
    record.put(root / "results" / "results.json", text)


def _earlier(path):
    """The points of earlier submissions, oldest first; one on which the grader failed is none."""
    with suppress(OSError, ValueError, KeyError, TypeError, AttributeError):
        previous = json.loads(path.read_text(encoding="utf-8"))["previous_submissions"]
        return [
            float(one["score"] or 0) for one in previous if (one.get("results") or {}).get("tests")
        ]
    return []


def _that_counts(homework, earlier, now):
    """(points, what is said of them) by the rule of the assignment."""
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
    """(submissions with the problem they are for, what was left aside, sentences on that), each
    notebook once."""
    # As in a course's folder: student/assignment/notebook. Names that meet, from different folders,
    # stay apart.
    for k, path in enumerate(
        sorted(path for path in folder.rglob("*") if path.suffix.lower() == ".ipynb")
    ):
        place = scratch / "student" / f"{k:05d}" / path.name
        place.parent.mkdir(parents=True)
        if stat.S_ISREG(path.lstat().st_mode):
            shutil.copy2(path, place)
        else:
            place.symlink_to("/nowhere")  # named as what it is, and not followed
    found, aside = {}, []
    for one in submissions.find(scratch):
        problem = one if isinstance(one, submissions.Aside) else matching.problem_for(one, homework)
        if isinstance(problem, submissions.Aside):
            aside.append(problem)
        else:
            found[problem, one.content] = (problem, one)
    remarks = [f"left aside: {printable(Path(one.path).name)}: {one.why}" for one in aside]
    if not found:
        remarks.append("There is no notebook of this homework in what you handed in.")
    return list(found.values()), aside, remarks


def _graded(found):
    """Run and judge each notebook; an `Attempt` for each."""
    if os.getuid() != 0:
        raise SystemExit(
            "run_autograder has to run as root, so that it can run notebooks as another user"
        )
    _make_ready()
    limits, bounds = _shares(len(found))
    attempts = []
    with OwnUser(pwd.getpwnam(USER), limits) as sandbox:
        for number, (problem, one) in enumerate(found):
            exercise = exercises.find(problem)
            if one.trouble:
                judgement = unreadable(exercise, one.trouble)
            else:
                data = [source for _, source in exercise.code("data")]
                judgement = judge(
                    exercise,
                    sandbox.run(
                        exercise.sources_to_run(one.cells), exercise.about["answers"], before=data
                    ),
                    bounds,
                )
            attempts.append(
                Attempt(
                    number,
                    "student",
                    "",
                    problem,
                    one.content,
                    one.submitted,
                    None,
                    judgement.verdicts,
                    judgement.answers,
                    judgement.remarks,
                )
            )
    return attempts


def _shares(count):
    """What each of `count` notebooks may take, so that all are done in time."""
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


def _make_ready():
    """Import what judging needs, once; its children inherit it."""
    import sympy  # noqa: F401

    from workbook import checks

    for name in checks.__all__:
        getattr(checks, name)


if __name__ == "__main__":
    main()
