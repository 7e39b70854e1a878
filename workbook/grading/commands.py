"""The command `workbook grade`.

It grades with a progress bar, then writes tables and pages.
"""

import hashlib
import math
from collections import Counter
from dataclasses import replace
from datetime import datetime
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from workbook.checks.course_checks import own_checks
from workbook.course import pinned
from workbook.grading.course import assignment as assignments
from workbook.grading.course import (
    copying,
    course,
    ledger,
    objections,
    record,
    submissions,
    text_cells,
)
from workbook.grading.course.assignment import InputError
from workbook.grading.course.store import Store
from workbook.grading.reports import (
    canvas,
    console_summary,
    exporting,
    handing_back,
    review,
    review_page,
    statistics,
)
from workbook.grading.reports.feedback import feedback
from workbook.grading.reports.pages import count
from workbook.grading.reports.scores import scores
from workbook.grading.reports.summary import summary
from workbook.grading.reports.text_page import text_page

IN_WASM = (
    "notebooks run in WebAssembly, which is slower than bubblewrap on Linux; one that needs what is "
    "missing there (CasADi, control, writing files, threads) waits for a machine with Linux"
)


def grade_course(options):
    """Grade a course as `GradingOptions` say, and write all tables and pages.

    Without a folder of assignment files it is `assignments`, if that exists.

    Returns
    -------
    dict
        A summary as plain data, as the option --json prints it.

    Raises
    ------
    InputError
        If folders or files cannot be used.
    SandboxUnavailableError
        If there is no sandbox.
    """
    options = replace(
        options,
        submitted=Path(options.submitted),
        out=Path(options.out),
        assignment_folder=_assignments(options.assignment_folder),
    )
    console = Console(stderr=True, quiet=options.quiet, soft_wrap=True, emoji=False)
    if (home := pinned()) is not None:
        console.print(f"course: {home.title} ({home.folder})", markup=False)
        own_checks(home)  # raises `CourseError` if they cannot be used
    # A roster or folder that cannot be used is an error before an hour of grading, not after it.
    roster = canvas.read_roster(options.roster) if options.roster is not None else None
    expected = _expected(roster, options.submitted)
    cluster = _cluster(options.cluster, console) if options.cluster is not None else None
    if options.wasm:
        console.print(IN_WASM, markup=False)
    homeworks, plan, failures = _grade_with_progress_bar(console, options, cluster)
    if failures:
        console.print(
            f"the grader itself failed on {count(failures, 'notebook')}: run it again, and it will "
            "grade what is missing",
            markup=False,
            style="red",
        )
    for path, why in plan.waiting:
        console.print(f"{path}: {why}", markup=False, style="yellow")
    for entry in plan.aside:
        console.print(f"left aside: {entry.path}: {entry.reason}", markup=False, style="yellow")
    for problem, paths in plan.assumed.items():
        console.print(
            f"taken for problem {problem}, by its name or since no other is asked for: "
            f"{', '.join(paths)}",
            markup=False,
            style="yellow",
        )
    result = {
        "graded": len(plan.pending),
        "failed": failures,
        "waiting for Linux": list(plan.waiting),
        "already graded": plan.graded_before,
        "left aside": [(entry.path, entry.reason) for entry in plan.aside],
        "taken for": plan.assumed,
    }
    homeworks = _in_time(homeworks)
    graded, tables = _write_all(options, console, homeworks, plan, roster, expected)
    if options.review:
        texts = {a.name: text_cells.read(options.submitted, a) for a in homeworks if a.by_hand}
        questions = [
            q
            for a, of_class in graded
            for q in review_page.questions(a, of_class, texts.get(a.name, {}))
        ]
        review.serve(options.out, questions, options.by)
        _, tables = _write_all(options, console, homeworks, plan, roster, expected)
    return result | tables


def _write_all(options, console, homeworks, plan, roster, expected):
    """Write tables and pages of all homeworks, and print what a lecturer has to know of them.

    Returns ([(assignment, scores)], what the summary says of each homework).
    """
    tables = {
        "assignments": {},
        "late": {},
        "to review": {},
        "changes": {},
        "objections without a reply": {},
        "not in the roster": {},
        "handed in nothing": {},
        "time unknown": {},
    }
    now = datetime.now().astimezone().isoformat(timespec="seconds")
    files, graded, grace_days_used = assignments.files(options.assignment_folder), [], Counter()
    students = [*expected, *submissions.students(options.submitted)]
    with Store(options.out / "grades.sqlite") as store:
        for assignment in homeworks:
            name, folder = assignment.name, options.out / assignment.name
            of_class = scores(store, assignment, students, plan.aside, grace_days_used)
            graded.append((assignment, of_class))
            grace_days_used.update({score.student: score.grace_days_used for score in of_class})
            changes, waiting = write(
                folder,
                assignment,
                of_class,
                now,
                roster,
                options.site,
                options.submitted,
                plan.own_code.get(name, {}),
            )
            unknown = [
                score.student
                for score in of_class
                if roster is not None and score.student not in expected
            ]
            tables["assignments"][name] = {
                score.student: round(score.points, 4) for score in of_class
            }
            tables["late"][name] = {
                score.student: list(score.late) for score in of_class if score.late
            }
            tables["to review"][name] = {
                score.student: [[answer.problem, answer.answer] for answer in score.to_review]
                for score in of_class
                if score.needs_review
            }
            tables["changes"][name] = [vars(change) for change in changes]
            tables["objections without a reply"][name] = waiting
            tables["not in the roster"][name] = unknown
            tables["handed in nothing"][name] = [
                score.student for score in of_class if score.is_absent
            ]
            tables["time unknown"][name] = {
                score.student: list(score.untimed) for score in of_class if score.untimed
            }
            console_summary.print_summary(
                console, folder, assignment, of_class, changes, files.get(name)
            )
            console_summary.print_objections(console, folder, waiting)
            if roster is not None:
                console_summary.print_roster_differences(console, assignment, roster, unknown)
    if len(homeworks) > 1:
        _write_course(options.out, graded)
    return graded, tables


def _write_course(out, graded):
    """Write what concerns all homeworks: [(assignment, scores)], by due date."""
    record.put(out / "course.csv", statistics.course_csv(graded))
    record.put(out / "course.html", statistics.course_page(graded))


def _in_time(homeworks):
    """Return the homeworks by due date; those without one come last."""
    return sorted(
        homeworks.values(),
        key=lambda homework: (
            homework.due.timestamp() if homework.due else math.inf,
            homework.name,
        ),
    )


def write(folder, assignment, graded, now, roster=None, site="", submitted=None, own_code=None):
    """Write tables and pages of a homework into a folder; `own_code` is that of the students.

    Returns (the changes since last time, the students whose objection has no reply). What students
    wrote beside answers, and the names that the system gave them, are read in `submitted`.
    """
    name = assignment.name
    texts = handed_in = entries = ()
    if submitted is not None:
        entries = [entry for entry in ledger.read(submitted) if entry.assignment == name]
        handed_in = objections.handed_in(submitted, name)
        texts = text_cells.read(submitted, assignment) if assignment.by_hand else ()
    former = record.objections(folder / "grades.json")
    all_objections = objections.updated(former, handed_in, folder / "replies", now)
    changes, all_changes, written = record.compared(
        folder / "grades.json", assignment, graded, now, all_objections
    )
    pages = {
        score.student: feedback(
            assignment, score, site, [o for o in all_objections if o.student == score.student]
        )
        for score in graded
    }
    page_names = {student: f"feedback/{page_name(student)}" for student in pages}
    files = {
        "grades.csv": exporting.grades_csv(assignment, graded),
        "changes.csv": exporting.changes_csv(all_changes),
        "moodle.csv": exporting.moodle_csv(assignment, graded),
        "nbgrader.csv": exporting.nbgrader_csv(assignment, graded),
        "mail-merge.csv": handing_back.mail_merge(graded, entries, page_names),
        "items.csv": statistics.items_csv(assignment, graded),
        "summary.html": summary(
            assignment, graded, all_objections, copying.pairs(graded, own_code or {})
        ),
    }
    files |= {page_names[student]: page for student, page in pages.items()}
    if assignment.by_hand:
        files["by_hand.html"] = text_page(assignment, graded, dict(texts))
    if isinstance(roster, canvas.Gradebook):
        files["canvas.csv"] = canvas.canvas_csv(assignment, graded, roster)
    to_hand_back = {score.student: pages[score.student] for score in graded if score.handed_in}
    for archive, content in handing_back.archives(to_hand_back, entries).items():
        record.put_bytes(folder / archive, content)
    for file, text in (files | {"grades.json": written}).items():  # grades.json last
        record.put(folder / file, text)
    return changes, [objection.student for objection in all_objections if not objection.reply]


def page_name(student):
    """Return the name of a student's page; one too long for a file is cut and gets its hash."""
    if len(student.encode()) <= 240:
        return f"{student}.html"
    return f"{student.encode()[:200].decode(errors='ignore')}-{hashlib.sha256(student.encode()).hexdigest()[:16]}.html"


def _expected(roster, submitted):
    """Return the students in the roster, by the names of their folders."""
    if roster is None:
        return set()
    return set(roster.identities(submissions.students(submitted))) - {""}


def _cluster(options, console):
    # The only import of the cluster code; grading on this machine needs nothing of it.
    from workbook.grading.cluster.coordinator import Cluster

    cluster = Cluster(
        **options, report=lambda line: console.print(line, markup=False, style="yellow")
    )
    cluster.check()
    if not cluster.address.startswith("tls://"):
        cluster.report(
            f"{cluster.address} is not encrypted: who can reach it can read and change grades, and "
            "run anything on the workers"
        )
    return cluster


def _where(options):
    """Return what the progress bar says of the place where notebooks run."""
    if options.cluster is not None:
        return "grading on the cluster"
    if options.trusting:
        return "grading without a sandbox"
    return "grading in WebAssembly" if options.wasm else "grading in bubblewrap"


def _grade_with_progress_bar(console, options, cluster):
    bar = Progress(
        TextColumn(_where(options)),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[rate]}"),
        TimeRemainingColumn(),
        # Drawing it as often as by default takes as much processor time as a fork for each
        # notebook.
        console=console,
        refresh_per_second=2,
        disable=console.quiet,
    )
    task = bar.add_task("grading", total=None, rate="")

    def progress(done, total):
        if total:  # the bar is shown only if there is something to do
            bar.start()
            speed = bar.tasks[0].speed
            bar.update(
                task,
                completed=done,
                total=total,
                rate=f"{60 * speed:.0f} a minute" if speed else "",
            )

    try:
        return course.grade(
            options,
            cluster,
            progress,
            report=lambda line: console.print(line, markup=False),
        )
    finally:
        if bar.live.is_started:
            bar.stop()


def _assignments(folder):
    """Return the folder of assignment files: the given one, or `assignments` here, or None."""
    if folder is None:
        return Path("assignments") if Path("assignments").is_dir() else None
    if not Path(folder).is_dir():
        raise InputError(f"{folder} is not a folder")
    return Path(folder)
