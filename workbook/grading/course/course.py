"""Grade a course: find what was submitted, run what has no result, store each result."""

import json
import os
import sys
from collections import Counter
from contextlib import closing, contextmanager
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

from filelock import FileLock, Timeout

from workbook.course import pinned
from workbook.grading.course import assignment as assignments
from workbook.grading.course import copying, matching, numbers, student_folders, submissions
from workbook.grading.course.policy import Budget
from workbook.grading.course.store import Store
from workbook.grading.course.submissions import LeftAside, Submission
from workbook.grading.pool import grader
from workbook.grading.pool.fingerprint import fingerprint
from workbook.grading.pool.judging import ELSEWHERE, FINAL, NOT_FINAL, WITHIN_LIMITS
from workbook.grading.pool.turns import Turns
from workbook.grading.sandbox import preloading
from workbook.grading.sandbox.limited_process import LimitedProcess, LimitError
from workbook.grading.sandbox.limits import Limits
from workbook.notebooks import exercises


class CourseError(assignments.InputError):
    """The folders cannot be graded, or not now; the message gives the reason."""


@dataclass(frozen=True)
class Plan:
    """What a run is to do.

    Parameters
    ----------
    pending : tuple of Pending
        Notebooks to be graded.
    graded_before : int
        How many notebooks have a result already.
    aside : tuple of LeftAside
        What is left aside.
    own_code : dict
        The students' own code: {homework: {student: `copying.OwnCode`}}.
    used : dict
        The seconds of computing of notebooks that have a result, by (homework, student).
    assumed : dict
        The notebooks that do not say themselves which problem they are for: {problem: paths}.
    waiting : tuple
        (path, why) of the notebooks that wait for a machine with Linux.
    """

    pending: tuple
    graded_before: int
    aside: tuple
    own_code: dict = field(default_factory=dict)
    used: dict = field(default_factory=dict)
    assumed: dict = field(default_factory=dict)
    waiting: tuple = ()


@dataclass(frozen=True)
class Pending:
    """A notebook to be graded.

    Parameters
    ----------
    owner : tuple of str
        The homework and the student.
    submission : Submission
        The notebook.
    version : str
        That of the exercise, which its result is stored with.
    task : Task
        What is to be graded; its key is the attempt in the store.
    """

    owner: tuple
    submission: Submission
    version: str
    task: grader.Task


def grade(options, cluster=None, progress=lambda done, total: None, report=lambda line: None):
    """Grade what was submitted, and store the results in grades.sqlite.

    What has a result by the very same exercise and library is not graded again, so a killed run
    continues where it stopped, and a changed exercise regrades only what it changed; other limits
    regrade what exceeded the former ones. Each result is stored as soon as it is there.

    Parameters
    ----------
    options : GradingOptions
        Which folders, in how many processes, within which limits, and in which sandbox.
    cluster : workbook.grading.cluster.coordinator.Cluster, optional
        Its workers grade, not this machine.
    progress : callable
        Called with the numbers of notebooks that are done and that are to be graded.
    report : callable
        Called with one line before something that takes long.

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
    submitted, out = Path(options.submitted), Path(options.out)
    if out.resolve().is_relative_to(submitted.resolve()):
        raise CourseError(
            f"{out} lies in {submitted}, where every folder is a student's: put it beside"
        )
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CourseError(f"{out} cannot be made: {error.strerror}") from None
    home = pinned()
    if home is not None and home.folder.is_relative_to(submitted.resolve()):
        raise CourseError(
            f"the course {home.folder} lies in {submitted}, where every folder is a student's: name "
            "yours by --course FOLDER"
        )
    if not (options.trusting or options.wasm):
        _require_hidden(submitted, out, *([home.folder] if home else []))
    with (
        _locked(out),
        _early_forkserver(out, cluster is not None or options.wasm) as forkserver,
        Store(out / "grades.sqlite") as store,
    ):
        files = assignments.files(options.assignment_folder)
        entries = list(submissions.find(submitted, _budgets(files)))
        homeworks, aside_reasons = _homeworks(entries, files)
        count = options.processes or _cores()
        settings = grader.Settings(options.limits, options.bounds, options.trusting)
        if cluster is None:  # else each worker of the cluster does so for its machine
            settings = settings.fit_memory(count)
        with store.transaction():
            copies, aside = _by_attempt(entries, homeworks, aside_reasons, files)
            plan = _plan(copies, aside, homeworks, store, settings.limits)
        progress(0, len(plan.pending))
        failures, waiting, turns = 0, [], _turns(plan, homeworks)
        with closing(
            _judgements(
                plan.pending,
                turns,
                count,
                settings,
                cluster,
                forkserver,
                report if options.wasm else None,
            )
        ) as judgements:
            for done, (pending, judgement, task_limits) in enumerate(judgements, start=1):
                judgement = grader.with_text_cells(judgement, pending.submission.names_in_text)
                store.record(
                    pending.task.key,
                    _version(pending.version, judgement.final, task_limits),
                    judgement,
                )
                failures += judgement.final == NOT_FINAL
                if judgement.final == ELSEWHERE:
                    waiting.append((pending.submission.path, judgement.remarks[0]))
                progress(done, len(plan.pending))
    plan = replace(_without(plan, turns.left_over, homeworks), waiting=tuple(waiting))
    return homeworks, plan, failures


def _require_hidden(*folders):
    """Refuse folders that notebooks can read in the sandbox of Linux."""
    from workbook.grading.sandbox import isolation  # for Linux only

    for folder in folders:
        if (visible := isolation.visible_parent(folder)) is not None:
            raise CourseError(
                f"{folder} lies in {visible}, which every notebook can read: move it elsewhere"
            )


def _budgets(files):
    """Return a function that returns the `Budget` of a homework, read when it is first asked for."""

    @cache
    def budget_of(name):
        return assignments.read(files[name]).policy.budget if name in files else Budget()

    return budget_of


def _turns(plan, homeworks):
    """Return the `Turns` of the notebooks that can be run."""
    tasks = {}
    for pending in plan.pending:
        if not pending.submission.trouble:
            tasks.setdefault(pending.owner, []).append(pending.task)
    budgets = {
        (name, student): 60 * homeworks[name].policy.budget.cpu_minutes for name, student in tasks
    }
    return Turns(tasks, plan.used, budgets)


def _without(plan, left_over, homeworks):
    """Return the plan with the tasks left aside for which no computing time was left."""
    keys = {task.key for task in left_over}
    over = [pending for pending in plan.pending if pending.task.key in keys]
    aside = [
        LeftAside(
            pending.submission.path,
            "the student's notebooks here have used up "
            f"{homeworks[pending.owner[0]].policy.budget.cpu_minutes:g} minutes of computing "
            "([budget] in assignment.toml)",
            pending.owner[1],
            pending.owner[0],
            by_hand=True,
        )
        for pending in over
    ]
    pending = tuple(p for p in plan.pending if p not in over)
    return replace(plan, pending=pending, aside=(*plan.aside, *aside))


def _cores():
    """Return how many processors this process may use."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@contextmanager
def _locked(out):
    """Lock the folder: two graders would do everything twice. The lock ends with the process."""
    try:
        lock = FileLock(out / ".grading", timeout=0).acquire()
    except Timeout:
        raise CourseError(f"another workbook grade is at work on {out}") from None
    except OSError as error:
        raise CourseError(f"{out} cannot be written to: {error.strerror}") from None
    with lock:
        yield


@contextmanager
def _early_forkserver(out, needless):
    """Start a forkserver while submissions are read, in a first run, which surely needs it."""
    if needless or (out / "grades.sqlite").exists():
        yield None
        return
    from workbook.grading.sandbox.forkserver import Forkserver  # for Linux only

    with closing(Forkserver.start(preloading.ALWAYS)) as forkserver:
        yield forkserver


def _judgements(pending, turns, count, settings, cluster, forkserver, report):
    """Yield (what was pending, its judgement, its limits) in the order they are done.

    With `report`, notebooks run in WebAssembly.
    """
    for unreadable in pending:
        if trouble := unreadable.submission.trouble:
            exercise = exercises.find(unreadable.task.problem)
            yield unreadable, grader.unreadable_notebook(exercise, trouble), settings.limits
    by_key = {p.task.key: p for p in pending if not p.submission.trouble}
    if not by_key:
        return
    count = min(count, len(by_key))
    if report is not None:
        from workbook.grading.pool import spawned_workers  # needs the extra `wasm`

        grading = spawned_workers.grade_all(turns, count, settings, report)
    else:
        modules = preloading.modules_for(
            {p.task.problem for p in by_key.values()},
            [source for p in by_key.values() for source in p.task.sources],
        )
        settings = replace(settings, modules=modules)
        if cluster is not None:
            grading = cluster.grade_all(turns, settings)
        else:
            from workbook.grading.pool import worker_pool  # for Linux only

            grading = worker_pool.grade_all(turns, count, settings, forkserver)
    with closing(grading) as results:
        for key, result in results:
            judgement = grader.from_plain(result)
            turns.done(by_key[key].owner, judgement.seconds)
            yield (
                by_key[key],
                judgement,
                Limits(**result["limits"]) if "limits" in result else settings.limits,
            )


def _version(exercise, final, limits):
    """Return the name under which a result is stored: what it depends on besides the notebook."""
    return {
        FINAL: exercise,
        WITHIN_LIMITS: f"{exercise} within {limits}",
        NOT_FINAL: "failed",
        ELSEWHERE: "waiting",
    }[final]


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
    fingerprints, pending, noted, graded_before, used = {}, [], {}, 0, Counter()
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
            used[name, student] += store.seconds_used(attempt)
            continue
        exercise = homeworks[name].exercise(variant)
        task = grader.Task(
            variant,
            direction,
            exercise.sources_to_run(submission.cells),
            homeworks[name].other_variants(problem, student),
            attempt,
            tuple(exercise.about["answers"]),
        )
        pending.append(Pending((name, student), submission, version, task))
    own_code = _own_code(noted, homeworks, store)
    return Plan(tuple(pending), graded_before, tuple(aside), own_code, dict(used), _assumed(copies))


def _assumed(copies):
    """Return {problem: paths of the notebooks that do not say themselves that they are for it}."""
    paths = {}
    for (_, _, problem, _), (submission, *_) in copies.items():
        if submission.problem != problem:
            paths.setdefault(problem, []).append(submission.path)
    return paths


def _own_code(noted, homeworks, store):
    """Return the own code of each student, by homework and student.

    The shapes of an attempt's code are found once and stored, since parsing takes longer than all
    else that a run without new notebooks does.
    """
    own_code, pristine = {}, {}
    with LimitedProcess(copying.shapes) as process:
        for attempt, (student, name, problem, submission) in noted.items():
            variant = homeworks[name].variant(problem, student)
            if variant not in pristine:
                exercise = exercises.find(variant)
                cells = [source for _, source in exercise.cells]
                pristine[variant] = exercise, cells, copying.pristine_lines(exercise)
            exercise, cells, lines = pristine[variant]
            own = own_code.setdefault(name, {}).setdefault(student, copying.OwnCode())
            own.lines |= copying.own_lines(submission.cells, lines)
            shapes = store.shapes(attempt)
            if shapes is None:
                sources = exercise.sources_to_run(submission.cells)
                request = json.dumps({"cells": sources, "pristine": cells}).encode()
                try:
                    shapes = process.call(copying.shapes, request)
                except LimitError:  # nobody else has such a notebook
                    shapes = {}
                store.set_shapes(attempt, shapes)
            own.shapes |= shapes
    return own_code


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
    copies, others = matching.one_of_each_hand_in(copies)
    return copies, aside + others


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
