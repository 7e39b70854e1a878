"""What `workbook grade` and `workbook score` do: grade with a progress bar, then write tables and
pages; give points by hand."""

import hashlib
from datetime import datetime
from pathlib import Path
from unicodedata import normalize

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from workbook.grading import assignment as assignments
from workbook.grading import canvas, console_summary, course, exporting, record, submissions
from workbook.grading.assignment import BadInput
from workbook.grading.feedback import feedback
from workbook.grading.pages import count
from workbook.grading.sandbox import Limits
from workbook.grading.scores import scores
from workbook.grading.store import Store
from workbook.grading.summary import summary


def grade_course(
    submitted,
    out,
    assignment_folder,
    processes,
    timeout,
    trusting,
    quiet,
    roster=None,
    site="",
    cluster=None,
):
    """Grade and write everything below `out`; returns a summary as plain data.

    `roster` is a gradebook exported from Canvas (a file), `site` the address of the student edition
    of the site, `cluster` the options (address, ca_file, cert, key) of a
    `workbook.grading.cluster.coordinator.Cluster`.
    """
    submitted, out, console = (
        Path(submitted),
        Path(out),
        Console(stderr=True, quiet=quiet, soft_wrap=True),
    )
    # A roster or folder that cannot be used is said before an hour of grading, not after it.
    roster = canvas.read_roster(roster) if roster is not None else None
    assignment_folder = _assignments(assignment_folder)
    cluster = _cluster(cluster, console) if cluster is not None else None
    known, plan, failed = _with_a_bar(
        console,
        submitted,
        out,
        assignment_folder,
        processes,
        Limits.of_time(timeout),
        trusting,
        cluster,
    )
    if failed:
        console.print(
            f"the grader itself failed on {count(failed, 'notebook')}: run it again, and it will "
            "grade what is missing",
            markup=False,
            style="red",
        )
    for one in plan.aside:
        console.print(f"left aside: {one.path}: {one.why}", markup=False, style="yellow")
    result = {
        "graded": len(plan.pending),
        "failed": failed,
        "already graded": plan.known,
        "left aside": [(one.path, one.why) for one in plan.aside],
        "assignments": {},
        "late": {},
        "to review": {},
        "changes": {},
        "not in the roster": {},
    }
    now = datetime.now().astimezone().isoformat(timespec="seconds")
    files = assignments.files(assignment_folder)
    with Store(out / "grades.sqlite") as store:
        for name, assignment in known.items():
            graded = scores(store, assignment, submissions.students(submitted), plan.aside)
            changes, strangers = write(out / name, assignment, graded, now, roster, site)
            result["assignments"][name] = {
                score.student: round(score.points, 4) for score in graded
            }
            result["late"][name] = {
                score.student: list(score.late) for score in graded if score.late
            }
            result["to review"][name] = {
                score.student: [[answer.problem, answer.answer] for answer in score.to_review]
                for score in graded
                if score.needs_review
            }
            result["changes"][name] = [vars(change) for change in changes]
            result["not in the roster"][name] = strangers
            console_summary.tell(console, out / name, assignment, graded, changes, files.get(name))
            if roster is not None:
                console_summary.tell_of_roster(console, assignment, roster, strangers)
    return result


def score_by_hand(graded, student, assignment, problem, answer, points, comment=""):
    """Store a lecturer's points for one answer, or with `points` None take them back; returns a
    sentence that says so."""
    student, assignment = normalize("NFC", student), normalize("NFC", assignment)
    place = f"{student}, {assignment}, {problem} {answer}"
    found = record.read(Path(graded) / assignment / "grades.json")["students"]
    if not found:
        raise BadInput(
            f"there are no grades of {assignment} in {graded}; run workbook grade first, or say "
            "where with --graded"
        )
    if student not in found:
        raise BadInput(
            f"{assignment} has no student {student}; a folder of that name beside the others' "
            "makes one known to workbook grade"
        )
    worth = {
        (each["problem"], each["answer"]): each["max points"] for each in found[student]["answers"]
    }
    if (problem, answer) not in worth:
        raise BadInput(
            f"{assignment} asks for no {problem} {answer}; there are "
            f"{', '.join(f'{p} {a}' for p, a in worth)}"
        )
    if points is not None and not 0 <= points <= worth[problem, answer]:
        raise BadInput(
            f"{place} is worth {worth[problem, answer]:g} points; assignment.toml can make it more"
        )
    with Store(Path(graded) / "grades.sqlite") as store:
        if points is not None:
            store.set_manual(student, assignment, problem, answer, points, comment)
            return f"{place}: {points:g} of {worth[problem, answer]:g} points by hand"
        if not store.take_back(student, assignment, problem, answer):
            raise BadInput(f"{place} has no points by hand")
        return f"{place}: the automatic points count again"


def write(folder, assignment, graded, now, roster=None, site=""):
    """Write tables and pages into `folder`; returns the changes since the last time, and students
    the roster does not know."""
    changes, all_changes, written = record.compared(folder / "grades.json", assignment, graded, now)
    files = {
        "grades.csv": exporting.grades_csv(assignment, graded),
        "changes.csv": exporting.changes_csv(all_changes),
        "moodle.csv": exporting.moodle_csv(assignment, graded),
        "nbgrader.csv": exporting.nbgrader_csv(assignment, graded),
        "summary.html": summary(assignment, graded),
    }
    files |= {
        f"feedback/{page_name(score.student)}": feedback(assignment, score, site)
        for score in graded
    }
    strangers = []
    if roster is not None:
        files["canvas.csv"], strangers = canvas.canvas_csv(assignment, graded, roster)
    for name, text in (files | {"grades.json": written}).items():  # that one last
        record.put(folder / name, text)
    return changes, strangers


def page_name(student):
    """The name of a student's page; a name too long for a file is cut, and told from others by its
    hash."""
    if len(student.encode()) <= 240:
        return f"{student}.html"
    return f"{student.encode()[:200].decode(errors='ignore')}-{hashlib.sha256(student.encode()).hexdigest()[:16]}.html"


def _cluster(options, console):
    # Only here, since grading on this machine needs nothing of it.
    from workbook.grading.cluster.coordinator.coordinator import Cluster, check

    cluster = Cluster(
        **options, tell=lambda line: console.print(line, markup=False, style="yellow")
    )
    check(cluster)
    if not cluster.address.startswith("tls://"):
        cluster.tell(
            f"{cluster.address} is not encrypted: who can reach it can read and change grades, and "
            "run anything on the workers"
        )
    return cluster


def _with_a_bar(console, submitted, out, assignment_folder, processes, limits, trusting, cluster):
    bar = Progress(
        TextColumn("grading"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[rate]}"),
        TimeRemainingColumn(),
        # Drawing it as often as it is by default takes as much of a processor as a fork
        # for each notebook.
        console=console,
        refresh_per_second=2,
        disable=console.quiet,
    )
    task = bar.add_task("grading", total=None, rate="")

    def progress(done, total):
        if total:  # nothing is shown before it is known that there is something to do
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
            submitted,
            out,
            assignment_folder,
            processes,
            limits,
            trusting=trusting,
            cluster=cluster,
            progress=progress,
        )
    finally:
        if bar.live.is_started:
            bar.stop()


def _assignments(folder):
    """Where homeworks stand: the folder named, or `assignments` here, or nowhere."""
    if folder is None:
        return Path("assignments") if Path("assignments").is_dir() else None
    if not Path(folder).is_dir():
        raise BadInput(f"{folder} is not a folder")
    return Path(folder)
