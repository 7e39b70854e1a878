"""Grade a course: find what was submitted, run what has no result, store each result."""

import fcntl
import os
from contextlib import closing, contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

from workbook.grading.course import assignment as assignments
from workbook.grading.course import copying, matching, numbers, student_folders, submissions
from workbook.grading.course.store import Store
from workbook.grading.course.submissions import LeftAside, Submission
from workbook.grading.pool import grader, worker_pool
from workbook.grading.pool.fingerprint import fingerprint
from workbook.grading.pool.judging import FINAL, NOT_FINAL, WITHIN_LIMITS, Bounds
from workbook.grading.sandbox import isolation, preloading
from workbook.grading.sandbox.forkserver import Forkserver
from workbook.grading.sandbox.sandbox import Limits
from workbook.notebooks import exercises


class CourseError(assignments.InputError):
    """The folders cannot be graded, or not now; the message gives the reason."""


@dataclass(frozen=True)
class Plan:
    """What a run is to do.

    Parameters
    ----------
    pending : tuple of dict
        The tasks: notebooks to be graded.
    graded_before : int
        How many notebooks have a result already.
    aside : tuple of LeftAside
        What is left aside.
    lines : dict
        The students' own lines of code: {homework: {student: set of lines}}.
    """

    pending: tuple
    graded_before: int
    aside: tuple
    lines: dict = field(default_factory=dict)


def grade(
    submitted,
    out,
    assignment_folder=None,
    count=None,
    limits=Limits(),
    bounds=Bounds(),
    trusting=False,
    cluster=None,
    progress=lambda done, total: None,
):
    """Grade `submitted` into `out`/grades.sqlite.

    What has a result by the very same exercise and library is not graded again, so a killed run
    continues where it stopped, and a changed exercise regrades only what it changed; other limits
    regrade what exceeded the former ones. Each result is stored as soon as it is there.

    Parameters
    ----------
    submitted, out : path
        Folders of submissions and of results.
    assignment_folder : path, optional
        Folder of the assignment files.
    count : int, optional
        Number of worker processes; by default that of the processors.
    limits, bounds : Limits, Bounds
        Those of running and of judging a notebook.
    trusting : bool
        Whether notebooks run without a sandbox.
    cluster : workbook.grading.cluster.coordinator.Cluster, optional
        Its workers grade, not this machine.
    progress : callable
        Called with the numbers of notebooks that are done and that are to be graded.

    Returns
    -------
    tuple
        The assignments by name, the `Plan`, and how many notebooks the grader failed on.

    Raises
    ------
    InputError
        If the folders or files cannot be used.
    SandboxUnavailableError
        If there is no sandbox.
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
        if (visible := isolation.visible_parent(folder)) is not None:
            raise CourseError(
                f"{folder} lies in {visible}, which every notebook can read: move it elsewhere"
            )
    with (
        _locked(out),
        _early_forkserver(out, cluster) as forkserver,
        Store(out / "grades.sqlite") as store,
    ):
        entries = list(submissions.find(submitted))
        files = assignments.files(assignment_folder)
        homeworks, aside_reasons = _homeworks(entries, files)
        count = count or len(os.sched_getaffinity(0))
        if cluster is None:  # else each worker of the cluster does so for its machine
            limits, bounds = grader.fit_memory(limits, count), grader.fit_memory(bounds, count)
        with store.transaction():
            copies, aside = _by_attempt(entries, homeworks, aside_reasons, files)
            plan = _plan(copies, aside, homeworks, store, limits)
        progress(0, len(plan.pending))
        failures = 0
        with closing(
            _judgements(plan.pending, count, limits, bounds, trusting, cluster, forkserver)
        ) as judgements:
            for done, (task, judgement, task_limits) in enumerate(judgements, start=1):
                judgement = grader.with_text_cells(judgement, task["names in text"])
                store.record(
                    task["key"],
                    _version(task["exercise"], judgement.final, task_limits),
                    judgement.verdicts,
                    judgement.answers,
                    judgement.remarks,
                    judgement.hashes,
                )
                failures += judgement.final == NOT_FINAL
                progress(done, len(plan.pending))
    return homeworks, plan, failures


@contextmanager
def _locked(out):
    """Lock the folder: two graders would do everything twice. The lock ends with the process."""
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
def _early_forkserver(out, cluster):
    """Start a forkserver while submissions are read, in a first run, which surely needs it."""
    if cluster is not None or (out / "grades.sqlite").exists():
        yield None
        return
    with closing(Forkserver.start(preloading.ALWAYS)) as forkserver:
        yield forkserver


def _judgements(pending, count, limits, bounds, trusting, cluster, forkserver=None):
    """Yield (task, its judgement, the limits that it had) in the order they are done."""
    for task in pending:
        if task["trouble"]:
            exercise = exercises.find(task["problem"])
            yield task, grader.unreadable_notebook(exercise, task["trouble"]), limits
    by_key = {task["key"]: task for task in pending if not task["trouble"]}
    if not by_key:
        return
    modules = preloading.modules_for(
        {task["problem"] for task in by_key.values()},
        [source for task in by_key.values() for source in task["sources"]],
    )
    settings = grader.to_settings(limits, bounds, trusting) | {"modules": modules}
    if cluster is None:
        grading = worker_pool.grade_all(
            by_key.values(), min(count, len(by_key)), settings, forkserver
        )
    else:
        grading = cluster.grade_all(by_key.values(), settings)
    with closing(grading) as results:
        for key, result in results:
            yield (
                by_key[key],
                grader.from_plain(result),
                Limits(**result["limits"]) if "limits" in result else limits,
            )


def _version(exercise, final, limits):
    """Return the name under which a result is stored: what it depends on besides the notebook."""
    return {FINAL: exercise, WITHIN_LIMITS: f"{exercise} within {limits}", NOT_FINAL: "failed"}[
        final
    ]


def _is_graded(versions, exercise, limits):
    """Return whether the newest result is by this very exercise, and would be the same now.

    A later version of the exercise may have been undone.
    """
    return (
        bool(versions)
        and versions[-1].split(" ")[0] == exercise
        and any(_version(exercise, final, limits) in versions for final in (FINAL, WITHIN_LIMITS))
    )


def _plan(copies, aside, homeworks, store, limits):
    """Note all attempts and return the `Plan`; `copies` and `aside` are those of `_by_attempt`."""
    fingerprints, pending, noted, graded_before = {}, {}, {}, 0
    for (student, name, problem, content), duplicates in copies.items():
        direction, variant = homeworks[name].direction, homeworks[name].variant(problem, student)
        if (variant, direction) not in fingerprints:
            fingerprints[variant, direction] = fingerprint(homeworks[name].exercise(variant))
        # One file of several with the same content: the earliest, or where the last attempt counts
        # the latest.
        counting = (max if homeworks[name].attempt == "last" else min)(
            duplicates, key=lambda submission: submission.submitted
        )
        attempt = store.note_attempt(
            student, name, problem, content, counting.submitted, counting.timing
        )
        noted[attempt] = student, name, problem, counting
    surplus = {
        attempt
        for name in homeworks
        for attempt in store.attempts_beyond(name, homeworks[name].attempts)
    }
    for attempt, (student, name, problem, submission) in noted.items():
        if attempt in surplus:  # it cannot count
            continue
        direction, variant = homeworks[name].direction, homeworks[name].variant(problem, student)
        version = fingerprints[variant, direction]
        if _is_graded(store.versions(attempt), version, limits):
            graded_before += 1
            continue
        exercise = homeworks[name].exercise(variant)
        pending[attempt] = {
            "key": attempt,
            "problem": variant,
            "other variants": homeworks[name].other_variants(problem, student),
            "direction": direction,
            "exercise": version,
            "trouble": submission.trouble,
            "sources": exercise.sources_to_run(submission.cells),
            "names in text": submission.names_in_text,
            "names": list(exercise.about["answers"]),
        }
    return Plan(tuple(pending.values()), graded_before, tuple(aside), _own_lines(copies, homeworks))


def _own_lines(copies, homeworks):
    """Return the own lines of code of each student, by homework and student."""
    lines, pristine = {}, {}
    for (student, name, problem, _), (submission, *_) in copies.items():
        variant = homeworks[name].variant(problem, student)
        if variant not in pristine:
            pristine[variant] = copying.pristine_lines(exercises.find(variant))
        own = copying.own_lines(submission.cells, pristine[variant])
        lines.setdefault(name, {}).setdefault(student, set()).update(own)
    return lines


def _by_attempt(entries, homeworks, aside_reasons, files):
    """Sort what was submitted by attempt.

    Parameters
    ----------
    entries : list of Submission or LeftAside
        All that was submitted.
    homeworks : dict
        Assignments by name.
    aside_reasons : dict
        Why notebooks for (homework, problem) are left aside.
    files : dict
        Assignment files by the name of the homework.

    Returns
    -------
    tuple
        ({(student, homework, problem, content): its submissions}, all that is left aside).
    """
    copies, aside = {}, []
    for entry in entries:
        name = entry.assignment
        if isinstance(entry, LeftAside):
            aside.append(entry if name in homeworks else replace(entry, assignment=""))
            continue
        if name not in homeworks:
            reason = matching.why_no_homework(entry, files)
            aside.append(LeftAside(entry.path, reason, entry.student))
            continue
        problem = matching.problem_for(entry, homeworks[name])
        if (name, entry.problem) in aside_reasons:
            reason = aside_reasons[name, entry.problem]
            aside.append(LeftAside(entry.path, reason, entry.student, name))
        elif isinstance(problem, LeftAside):
            aside.append(problem)
        elif homeworks[name].row(problem, entry.student) is None:
            reason = numbers.why_not_asked(homeworks[name], problem, entry.student)
            aside.append(LeftAside(entry.path, reason, entry.student, name))
        else:
            copies.setdefault((entry.student, name, problem, entry.content), []).append(entry)
    return copies, aside


def _homeworks(entries, files):
    """Return (assignments by name, why notebooks for (name, problem) are left aside).

    An assignment is read from its file, or inferred from what was handed in.
    """
    homeworks, aside_reasons = {}, {}
    for name in sorted({entry.assignment for entry in entries if entry.assignment}):
        if name in files:
            homeworks[name] = numbers.read_homework(files[name])
            student_folders.require_handed_out(files[name], homeworks[name])
        elif files:
            # A folder with a misspelt name would be a homework of its own, and its notebooks would
            # be missing, unnoticed, in the one that was meant.
            pass
        elif any(isinstance(entry, Submission) and entry.assignment == name for entry in entries):
            homeworks[name], reasons = matching.infer_homework(name, entries)
            aside_reasons |= {(name, problem): reason for problem, reason in reasons.items()}
    return homeworks, aside_reasons
