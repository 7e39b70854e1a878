"""The autograder that Gradescope runs for one submission.

It reads /autograder/submission, grades it, and writes /autograder/results/results.json. The policy
is that of assignment.toml: what lateness costs, a bonus, extensions and exemptions, by the time and
the address that Gradescope gives; which attempt at a problem counts, by the results of earlier
submissions. Points by hand are given at Gradescope.
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
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from workbook import course
from workbook.grading.course import assignment as assignments
from workbook.grading.course import matching, record, submissions
from workbook.grading.course.ledger import KNOWN, UNKNOWN
from workbook.grading.course.store import Attempt
from workbook.grading.gradescope.own_user import OwnUser
from workbook.grading.pool.grader import unreadable_notebook, with_text_cells
from workbook.grading.pool.judging import Bounds, judge
from workbook.grading.reports import exporting
from workbook.grading.reports.feedback import hints
from workbook.grading.reports.scores import NOT_FOUND, NOT_SUBMITTED, of_student
from workbook.grading.sandbox.limits import Limits
from workbook.grading.sandbox.sanitising import normalise_name, sanitise
from workbook.notebooks import exercises

#: The user that setup.sh makes.
USER = "workbook-student"
#: How the text of a test begins whose problem was not handed in.
NOT_TRIED = tuple(f"{v.status}: {v.message}" for v in (NOT_SUBMITTED, NOT_FOUND))
#: Gradescope ends an autograder after ten minutes by default.
SECONDS = 480
#: Of memory, so that a container of 3 GB holds a notebook, the grader and the judging.
MEGABYTES = 1024


@dataclass(frozen=True)
class HandIn:
    """What Gradescope says of a submission.

    Parameters
    ----------
    student : str
        The address, as assignment.toml has it; of a group, that of the member with the latest due
        date.
    submitted : float or None
        Its time in seconds since 1970; None if Gradescope does not say.
    earlier : list of dict
        The points by problem of each earlier submission that was graded, oldest first.
    """

    student: str
    submitted: float | None
    earlier: list


def main(root=Path("/autograder")):
    """Grade the submission below `root`."""
    began = time.monotonic()
    packed = root / "source" / "course"
    course.enter(packed if packed.is_dir() else None)
    homework = assignments.read(root / "source" / "assignment.toml").automatic
    hand_in = read_metadata(root / "submission_metadata.json", homework.policy)
    with tempfile.TemporaryDirectory() as scratch:
        matched, aside, remarks = _submitted(root / "submission", Path(scratch), homework)
        attempts = _graded(matched, homework, hand_in)
    # Which of several submissions counts is decided below.
    alone = dataclasses.replace(homework, attempt="best", attempts=None)
    score = of_student(hand_in.student, alone, attempts, {}, aside)
    hint_counts = {
        (answer.problem, answer.answer): len(hints(answer, exercises.find(answer.problem).about))
        for answer in score.answers
        if answer.problem in score.counted and homework.exam is None  # whose notebooks have none
    }
    remarks += [
        f"{problem}: {remark}"
        for problem, attempt in score.counted.items()
        for remark in attempt.remarks
    ]
    now = {p: sum(answer.points for answer in score.of_problem(p)) for p in score.counted}
    points, notes = counting_points(homework, hand_in.earlier, now)
    notes += policy_notes(homework, hand_in)
    text = exporting.gradescope_json(
        score, homework, hint_counts, [*notes, *remarks], points, time.monotonic() - began
    )
    record.put(root / "results" / "results.json", text)


def trial():
    """Run a notebook as the user of the students; end with an error if that user cannot run one."""
    cell = "import casadi, control, scipy, sympy\nfrom workbook import checks\nanswer = 1"
    with OwnUser(pwd.getpwnam(USER), _limits(1)[0]) as sandbox:
        outcome = sandbox.run([cell], ["answer"])
    if outcome.ended != "done" or "answer" not in json.loads(outcome.handed_over)["encoded"]:
        raise SystemExit(
            f"a notebook cannot be run as the user {USER}: {outcome.ended} "
            f"{outcome.handed_over[:1000].decode(errors='replace')}"
        )
    print(f"a notebook can be run as the user {USER}")


def read_metadata(path, policy):
    """Return the `HandIn` in the metadata that Gradescope writes, as far as they can be read."""
    try:
        about = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        about = {}
    named = {name.casefold(): name for name in policy.students}
    students, submitted, earlier = ["student"], None, []
    with suppress(ValueError, KeyError, TypeError, AttributeError):
        addresses = [normalise_name(user["email"]) for user in about["users"]]
        students = [named.get(address.casefold(), address) for address in addresses] or students
    with suppress(ValueError, KeyError, TypeError, AttributeError, OverflowError):
        submitted = datetime.fromisoformat(about["created_at"]).timestamp()
    with suppress(ValueError, KeyError, TypeError, AttributeError):
        earlier = [
            _points(submission["results"]["tests"])
            for submission in about["previous_submissions"]
            if (submission.get("results") or {}).get("tests")
        ]
    student = max(students, key=policy.due_of) if policy.due else students[0]
    return HandIn(student, submitted, earlier)


def _points(tests):
    """Return the points by problem in the results of a submission, of the problems it tried."""
    points = {}
    for test in tests:
        if not test["output"].startswith(NOT_TRIED):
            problem = test["name"].split()[0]
            points[problem] = points.get(problem, 0.0) + float(test["score"] or 0)
    return points


def counting_points(homework, earlier, now):
    """Return (points, sentences on them) by the rule of the assignment, problem by problem.

    Parameters
    ----------
    homework : Assignment
        With the rule.
    earlier : list of dict
        Points by problem of earlier submissions, oldest first.
    now : dict
        Those of this one.

    Returns
    -------
    tuple
        The sentences say nothing from which a verdict could be known that only the grades show.
    """
    points, notes = 0.0, []
    for problem in homework.problems:
        attempts = [tried[problem] for tried in [*earlier, now] if problem in tried]
        counting = attempts[: homework.attempts]
        if not counting:
            continue
        best = max(counting) if homework.attempt == "best" else counting[-1]
        points += best
        shown = "" if homework.kept_of(problem) else f": {best:g} points"
        if problem in now and len(counting) < len(attempts):
            notes.append(
                f"{problem}: this is attempt {len(attempts)}; the first {homework.attempts} "
                f"count{shown}."
            )
        elif shown and round(best - now.get(problem, 0.0), 3) > 0:  # earlier ones are rounded
            notes.append(f"{problem}: an earlier attempt of yours counts{shown}.")
    return points, notes


def policy_notes(homework, hand_in):
    """Return sentences on what the policy does to a submission."""
    policy, notes = homework.policy, []
    if hand_in.submitted is None and policy.due:
        notes.append("It is not known when you handed this in, so it is not late.")
    elif hand_in.submitted is not None:
        notes.append(policy.explanation(hand_in.student, hand_in.submitted))
    if exempt := sorted(homework.exempt_of(hand_in.student)):
        notes.append(f"Not asked of you: {', '.join(exempt)}; your other answers share its points.")
    return [note for note in notes if note]


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
    copies, aside = {}, []
    for entry in submissions.find(scratch):
        problem = (
            entry
            if isinstance(entry, submissions.LeftAside)
            else matching.problem_for(entry, homework)
        )
        if isinstance(problem, submissions.LeftAside):
            aside.append(problem)
        else:
            # By name, since Gradescope does not order the files of a submission.
            entry = dataclasses.replace(entry, submitted=0.0, rank=(entry.path,))
            copies.setdefault(("student", homework.name, problem, entry.content), []).append(entry)
    counting, others = matching.one_of_each_hand_in(copies)
    matched = [(problem, entries[0]) for (_, _, problem, _), entries in counting.items()]
    aside += others
    remarks = [f"left aside: {sanitise(Path(entry.path).name)}: {entry.reason}" for entry in aside]
    if not matched:
        remarks.append("There is no notebook of this homework in what you handed in.")
    return matched, aside, remarks


def _graded(matched, homework, hand_in):
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
                    hand_in.student,
                    "",
                    problem,
                    submission.content,
                    hand_in.submitted or 0.0,
                    None,
                    judgement.verdicts,
                    judgement.answers,
                    judgement.remarks,
                    timing=UNKNOWN if hand_in.submitted is None else KNOWN,
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
