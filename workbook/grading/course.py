"""Grade everything submitted for a course: find, run what has no result yet, store each result at
once."""

import fcntl
import os
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from workbook.grading import assignment as assignments
from workbook.grading import grader, isolation, matching, preloading, submissions, worker_pool
from workbook.grading.fingerprint import fingerprint
from workbook.grading.forkserver import Forkserver
from workbook.grading.judging import FINAL, NOT_FINAL, WITHIN_LIMITS, Bounds
from workbook.grading.sandbox import Limits
from workbook.grading.store import Store
from workbook.grading.submissions import Aside, Submission
from workbook.notebooks import exercises


class CourseError(assignments.BadInput):
    """The folders given cannot be graded, or not now; the message says why."""


@dataclass(frozen=True)
class Plan:
    """What a run is to do: notebooks still to be graded, how many have a result already, and each
    `Aside`."""

    pending: tuple
    known: int
    aside: tuple


def grade(
    submitted,
    out,
    assignment_folder=None,
    count=None,
    limits=Limits(),
    bounds=Bounds(),
    trusting=False,
    cluster=None,
    progress=lambda done, all: None,
):
    """Grade `submitted` into `out`/grades.sqlite; returns the assignments by name, the `Plan`, and
    how many the grader failed on.

    What has a result by the very same exercise and library is not graded again, so a killed run
    goes on where it stopped, and a changed exercise regrades only what it changed; so do other
    limits what met the former ones. Each result is stored as soon as it is there. With `trusting`
    there is no sandbox; with a `workbook.grading.cluster.coordinator.Cluster` its workers grade, not this
    machine.
    """
    out = Path(out)
    if out.resolve().is_relative_to(Path(submitted).resolve()):
        raise CourseError(
            f"{out} lies in {submitted}, where every folder is a student's: put it beside"
        )
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CourseError(f"{out} cannot be made: {error.strerror}") from None
    for folder in () if trusting else (submitted, out):
        if (shown := isolation.shown_through(folder)) is not None:
            raise CourseError(
                f"{folder} lies in {shown}, which every notebook can read: move it elsewhere"
            )
    with (
        _alone(out),
        _forkserver(out, cluster) as forkserver,
        Store(out / "grades.sqlite") as store,
    ):
        found = list(submissions.find(submitted))
        files = assignments.files(assignment_folder)
        known, alone = _homeworks(found, files)
        count = count or len(os.sched_getaffinity(0))
        if cluster is None:  # or else each worker sees what fits it
            limits, bounds = grader.fitting(limits, count), grader.fitting(bounds, count)
        with store.together():
            plan = _plan(*_by_attempt(found, known, alone, files), known, store, limits)
        progress(0, len(plan.pending))
        failed = 0
        with closing(
            _judgements(plan.pending, count, limits, bounds, trusting, cluster, forkserver)
        ) as judgements:
            for done, (unit, judgement, within) in enumerate(judgements, start=1):
                store.record(
                    unit["key"],
                    _as_graded(unit["exercise"], judgement.final, within),
                    judgement.verdicts,
                    judgement.answers,
                    judgement.remarks,
                    judgement.hashes,
                )
                failed += judgement.final == NOT_FINAL
                progress(done, len(plan.pending))
    return known, plan, failed


@contextmanager
def _alone(out):
    """Two graders at work on one folder would do everything twice. The lock ends with the process,
    however that ends."""
    try:
        file = open(out / ".grading", "w")
    except OSError as error:
        raise CourseError(f"{out} cannot be written to: {error.strerror}") from None
    with file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise CourseError(f"another workbook grade is at work on {out}") from None
        yield


@contextmanager
def _forkserver(out, cluster):
    """In a first run, where something is sure to be graded, it imports what all need while
    submissions are read."""
    if cluster is not None or (out / "grades.sqlite").exists():
        yield None
        return
    with closing(Forkserver.start(preloading.ALWAYS)) as forkserver:
        yield forkserver


def _judgements(pending, count, limits, bounds, trusting, cluster, forkserver=None):
    """(unit, its judgement, the limits it had) in the order they are done."""
    for unit in pending:
        if unit["trouble"]:
            yield unit, grader.unreadable(exercises.find(unit["problem"]), unit["trouble"]), limits
    by_key = {unit["key"]: unit for unit in pending if not unit["trouble"]}
    if not by_key:
        return
    modules = preloading.needed(
        {unit["problem"] for unit in by_key.values()},
        [source for unit in by_key.values() for source in unit["sources"]],
    )
    settings = grader.settings(limits, bounds, trusting) | {"modules": modules}
    if cluster is None:
        grading = worker_pool.grade_all(
            by_key.values(), min(count, len(by_key)), settings, forkserver
        )
    else:
        from workbook.grading.cluster.coordinator.coordinator import grade_all

        grading = grade_all(by_key.values(), settings, cluster)
    with closing(grading) as results:
        for key, result in results:
            yield (
                by_key[key],
                grader.from_plain(result),
                Limits(**result["limits"]) if "limits" in result else limits,
            )


def _as_graded(exercise, final, limits):
    """Under which name a result is stored: what it depends on besides the notebook."""
    return {FINAL: exercise, WITHIN_LIMITS: f"{exercise} within {limits}", NOT_FINAL: "failed"}[
        final
    ]


def _is_graded(versions, exercise, limits):
    """Whether what counts is by this very exercise (a later version of it may have been taken
    back), and would be no other now."""
    return (
        bool(versions)
        and versions[-1].split(" ")[0] == exercise
        and any(_as_graded(exercise, final, limits) in versions for final in (FINAL, WITHIN_LIMITS))
    )


def _plan(copies, aside, known, store, limits):
    """`copies` and `aside` as of `_by_attempt`; `known` are the homeworks by name."""
    prints, pending, noted, skipped = {}, {}, {}, 0
    for (student, name, problem, content), same in copies.items():
        if problem not in prints:
            prints[problem] = fingerprint(exercises.find(problem))
        # One file of several with the same content: the earliest, or where the last attempt counts
        # the latest.
        when = (max if known[name].attempt == "last" else min)(
            submission.submitted for submission in same
        )
        noted[store.note_attempt(student, name, problem, content, when)] = problem, same[0]
    beyond = {attempt for name in known for attempt in store.beyond(name, known[name].attempts)}
    for attempt, (problem, submission) in noted.items():
        if attempt in beyond:  # it cannot count, so nobody has to wait for it
            continue
        if _is_graded(store.versions(attempt), prints[problem], limits):
            skipped += 1
            continue
        exercise = exercises.find(problem)
        pending[attempt] = {
            "key": attempt,
            "problem": problem,
            "exercise": prints[problem],
            "trouble": submission.trouble,
            "sources": exercise.sources_to_run(submission.cells),
            "names": list(exercise.about["answers"]),
        }
    return Plan(tuple(pending.values()), skipped, tuple(aside))


def _by_attempt(found, known, alone, files):
    """({(student, homework, problem, content): its submissions}, everything left aside).

    `alone` says of (homework, problem) why its notebooks are left aside; `files` are those of the
    homeworks by name.
    """
    copies, aside = {}, []
    for one in found:
        if isinstance(one, Aside):
            aside.append(one if one.assignment in known else replace(one, assignment=""))
            continue
        if one.assignment not in known:
            aside.append(Aside(one.path, matching.no_homework(one, files), one.student))
            continue
        problem = matching.problem_for(one, known[one.assignment])
        if (one.assignment, one.problem) in alone:
            aside.append(
                Aside(one.path, alone[one.assignment, one.problem], one.student, one.assignment)
            )
        elif isinstance(problem, Aside):
            aside.append(problem)
        else:
            copies.setdefault((one.student, one.assignment, problem, one.content), []).append(one)
    return copies, aside


def _homeworks(found, files):
    """({name: homework}, why problems that no file asks for are left aside): each by its file, or
    else by what was handed in."""
    known, alone = {}, {}
    for name in sorted({one.assignment for one in found if one.assignment}):
        if name in files:
            known[name] = assignments.read(files[name])
        elif files:
            # it would be a homework of its own, and a silent zero in the one that was meant
            pass
        elif any(isinstance(one, Submission) and one.assignment == name for one in found):
            known[name], whys = matching.unwritten(name, found)
            alone |= {(name, problem): why for problem, why in whys.items()}
    return known, alone
