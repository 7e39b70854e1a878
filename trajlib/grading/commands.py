"""What `trajlib grade` does: grade with a progress bar, then write tables and pages."""

from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from trajlib.grading import course, exporting, pages
from trajlib.grading.sandbox import Limits
from trajlib.grading.scores import scores
from trajlib.grading.store import Store


def grade_course(submitted, out, assignment_folder, processes, timeout, quiet):
    """Grade and write everything below `out`; returns a summary as plain data."""
    out, console = Path(out), Console(stderr=True, quiet=quiet)
    bar = Progress(TextColumn("grading"), BarColumn(), MofNCompleteColumn(), TextColumn("{task.fields[rate]}"), TimeRemainingColumn(), console=console)
    with bar:
        task = bar.add_task("grading", total=None, rate="")

        def progress(done, total):
            speed = bar.tasks[0].speed
            bar.update(task, completed=done, total=total, rate=f"{60 * speed:.0f} a minute" if speed else "")

        known, plan = course.grade(submitted, out, assignment_folder, processes, Limits(wall_seconds=timeout), progress=progress)
    for path, why in plan.aside:
        console.print(f"left aside: {path}: {why}", markup=False, style="yellow")
    summary = {"graded": len(plan.pending), "already graded": plan.known, "left aside": [[str(path), why] for path, why in plan.aside], "assignments": {}}
    with Store(out / "grades.sqlite") as store:
        for name, assignment in known.items():
            graded = scores(store, assignment)
            _write(out / name, assignment, graded)
            summary["assignments"][name] = {score.student: round(score.points, 4) for score in graded}
            console.print(f"{name}: {len(graded)} students, tables and pages in {out / name}", markup=False)
    return summary


def _write(folder, assignment, graded):
    (folder / "feedback").mkdir(parents=True, exist_ok=True)
    files = {"grades.csv": exporting.plain_csv(assignment, graded), "moodle.csv": exporting.moodle_csv(assignment, graded),
             "nbgrader.csv": exporting.nbgrader_csv(assignment, graded), "summary.html": pages.summary(assignment, graded)}
    files |= {f"feedback/{score.student}.html": pages.feedback(assignment, score) for score in graded}
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8", newline="")
