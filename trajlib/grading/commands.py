"""What `trajlib grade` and `trajlib score` do: grade with a progress bar, then write tables and pages; give points by hand."""

import hashlib
from datetime import datetime
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from trajlib.grading import course, exporting, manual, record
from trajlib.grading.assignment import BadInput
from trajlib.grading.feedback import feedback
from trajlib.grading.handing_out import spoken
from trajlib.grading.printable import printable_name
from trajlib.grading.sandbox import Limits
from trajlib.grading.scores import scores
from trajlib.grading.store import Store
from trajlib.grading.summary import summary

#: Changes of grades that are told one by one; all are in changes.csv.
MOST_TOLD = 20


def grade_course(submitted, out, assignment_folder, processes, timeout, trusting, quiet, roster=None, site="", cluster=None):
    """Grade and write everything below `out`; returns a summary as plain data.

    `roster` is a gradebook exported from Canvas (a file), `site` the address of the student edition of the site, `cluster` the
    options (address, ca_file, cert, key) of a `trajlib.grading.cluster.Cluster`.
    """
    submitted, out, console = Path(submitted), Path(out), Console(stderr=True, quiet=quiet, soft_wrap=True)
    # A roster or folder that cannot be used is said before an hour of grading, not after it.
    roster = exporting.read_roster(roster) if roster is not None else None
    assignment_folder = _assignments(assignment_folder)
    cluster = _cluster(cluster, console) if cluster is not None else None
    known, plan, failed = _with_a_bar(console, submitted, out, assignment_folder, processes, Limits.of_time(timeout), trusting, cluster)
    if failed:
        console.print(f"the grader itself failed on {failed} notebooks: run it again, and it will grade these", markup=False, style="red")
    for path, why in plan.aside:
        console.print(f"left aside: {path}: {why}", markup=False, style="yellow")
    result = {"graded": len(plan.pending), "failed": failed, "already graded": plan.known, "left aside": plan.aside,
               "assignments": {}, "late": {}, "to review": {}, "changes": {}, "not in the roster": {}}
    now = datetime.now().astimezone().isoformat(timespec="seconds")
    with Store(out / "grades.sqlite") as store:
        for name, assignment in known.items():
            graded = scores(store, assignment, _students(submitted))
            changes, strangers = write(out / name, assignment, graded, now, roster, site)
            result["assignments"][name] = {score.student: round(score.points, 4) for score in graded}
            result["late"][name] = {score.student: list(score.late) for score in graded if score.late}
            result["to review"][name] = {score.student: [[answer.problem, answer.answer] for answer in score.to_review]
                                         for score in graded if score.needs_review}
            result["changes"][name] = [vars(change) for change in changes]
            result["not in the roster"][name] = strangers
            file = assignment_folder / name / "assignment.toml" if assignment_folder else None
            _tell(console, out / name, assignment, graded, changes, strangers, file if file and file.exists() else None)
    return result


def score_by_hand(graded, student, assignment, problem, answer, points, comment=""):
    """Store a lecturer's points for one answer, or with `points` None take them back; returns a sentence that says so."""
    place = f"{student}, {assignment}, {problem} {answer}"
    found = record.read(Path(graded) / assignment / "grades.json")["students"]
    if not found:
        raise BadInput(f"there are no grades of {assignment} in {graded}; run trajlib grade first, or say where with --graded")
    if student not in found:
        raise BadInput(f"{assignment} has no student {student}; a folder of that name beside the others' makes one known to trajlib grade")
    worth = {(each["problem"], each["answer"]): each["max points"] for each in found[student]["answers"]}
    if (problem, answer) not in worth:
        raise BadInput(f"{assignment} asks for no {problem} {answer}; there are {', '.join(f'{p} {a}' for p, a in worth)}")
    if points is not None and not 0 <= points <= worth[problem, answer]:
        raise BadInput(f"{place} is worth {worth[problem, answer]:g} points; assignment.toml can make it more")
    with Store(Path(graded) / "grades.sqlite") as store:
        if points is not None:
            store.set_manual(student, assignment, problem, answer, points, comment)
            return f"{place}: {points:g} of {worth[problem, answer]:g} points by hand"
        if not manual.take_back(store, student, assignment, problem, answer):
            raise BadInput(f"{place} has no points by hand")
        return f"{place}: the automatic points count again"


def write(folder, assignment, graded, now, roster=None, site=""):
    """Write tables and pages into `folder`; returns the changes since the last time, and students the roster does not know."""
    changes, all_changes = record.bring_up_to_date(folder / "grades.json", assignment, graded, now)
    files = {"grades.csv": exporting.grades_csv(assignment, graded), "changes.csv": exporting.changes_csv(all_changes),
             "moodle.csv": exporting.moodle_csv(assignment, graded), "nbgrader.csv": exporting.nbgrader_csv(assignment, graded),
             "summary.html": summary(assignment, graded)}
    files |= {f"feedback/{page_name(score.student)}": feedback(assignment, score, site) for score in graded}
    strangers = []
    if roster is not None:
        files["canvas.csv"], strangers = exporting.canvas_csv(assignment, graded, roster)
    for name, text in files.items():
        record.put(folder / name, text)
    return changes, strangers


def page_name(student):
    """The name of a student's page; a name too long for a file is cut, and told from others by its hash."""
    if len(student.encode()) <= 240:
        return f"{student}.html"
    return f"{student.encode()[:200].decode(errors='ignore')}-{hashlib.sha256(student.encode()).hexdigest()[:16]}.html"


def _cluster(options, console):
    # Only here, since grading on this machine needs nothing of it.
    from trajlib.grading.cluster import Cluster, check

    cluster = Cluster(**options, tell=lambda line: console.print(line, markup=False, style="yellow"))
    check(cluster)
    if not cluster.address.startswith("tls://"):
        cluster.tell(f"{cluster.address} is not encrypted: who can reach it can read and change grades, and run anything on the workers")
    return cluster


def _with_a_bar(console, submitted, out, assignment_folder, processes, limits, trusting, cluster):
    bar = Progress(TextColumn("grading"), BarColumn(), MofNCompleteColumn(), TextColumn("{task.fields[rate]}"), TimeRemainingColumn(),
                   console=console)
    task = bar.add_task("grading", total=None, rate="")

    def progress(done, total):
        if total:  # nothing is shown before it is known that there is something to do
            bar.start()
            speed = bar.tasks[0].speed
            bar.update(task, completed=done, total=total, rate=f"{60 * speed:.0f} a minute" if speed else "")

    try:
        return course.grade(submitted, out, assignment_folder, processes, limits, trusting=trusting, cluster=cluster, progress=progress)
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


def _students(submitted):
    """Everyone with a folder, also who handed nothing in."""
    return [printable_name(entry.name) for entry in submitted.iterdir()
            if entry.is_dir() and not entry.is_symlink() and not entry.name.startswith(".")]


def _tell(console, folder, assignment, graded, changes, strangers, file):
    """What a lecturer has to know now; everything else is in the files."""
    console.print(f"{assignment.name}: {assignment.max_points:g} points, "
                  + (f"due {spoken(assignment.due)}, " if assignment.due else "no due date, ")
                  + (f"by {file}" if file else "one for each answer, since there is no assignment.toml for it"), markup=False)
    handed_in, late = sum(score.handed_in for score in graded), sum(bool(score.late) for score in graded)
    console.print(f"  {handed_in} of {len(graded)} students handed something in, {late} late; tables and pages in {folder}", markup=False)
    waiting = [score for score in graded if score.needs_review]
    if waiting:
        console.print(f"  {len(waiting)} need your look: {folder / 'summary.html'} says which answers could not be judged; "
                      "Moodle, Canvas and nbgrader get no grade of theirs yet", markup=False, style="yellow")
    if changes:
        are_not = "answer is not what it was" if len(changes) == 1 else "answers are not what they were"
        console.print(f"  {len(changes)} {are_not}:", markup=False)
    for change in changes[:MOST_TOLD]:
        console.print(f"    {_told(change)}", markup=False, highlight=False)
    if len(changes) > MOST_TOLD:
        console.print(f"    and {len(changes) - MOST_TOLD} more, all in {folder / 'changes.csv'}", markup=False)
    if strangers:
        console.print(f"  not in the roster: {', '.join(strangers)}", markup=False, style="yellow")


def _told(change):
    verdicts = [change.old_verdict] if change.old_verdict == change.new_verdict else [change.old_verdict, change.new_verdict]
    return (f"{change.student} {change.problem} {change.answer}: {' -> '.join(verdicts)}, "
            f"{change.old_points:g} -> {change.new_points:g} points ({change.why})")
