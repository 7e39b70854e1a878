"""The command `workbook`. Bad input ends in one line that says what and where, with exit code 2."""

import gc
import json
import re
import sys
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table

from workbook.checks.contract.verdict import INVALID, MISSING, RIGHT, UNCHECKED, WRONG
from workbook.notebooks import exercises

app = typer.Typer(
    help="The executable workbook on controlled motion: its problems, solutions and checks.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
assignment = typer.Typer(
    help="Make a homework: to hand out, or as an autograder for Gradescope.", no_args_is_help=True
)
app.add_typer(assignment, name="assignment")
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document instead of text.")]
COLOURS = {RIGHT: "green", WRONG: "red", MISSING: "yellow", INVALID: "magenta", UNCHECKED: "cyan"}
console = Console(highlight=False, soft_wrap=True)


class UserError(Exception):
    """Something the user can mend; the message is the whole output."""


@app.command()
def problems(as_json: AsJson = False):
    """List the problems: number, section, level, title."""
    listed = [exercise.about for exercise in exercises.read_all()]
    if as_json:
        print(
            json.dumps(
                [
                    {
                        key: about[key]
                        for key in ("number", "title", "section", "level", "topics", "answers")
                    }
                    for about in listed
                ],
                ensure_ascii=False,
                indent=1,
            )
        )
        return
    table = Table("number", "section", "level", "title", "answers", box=None, pad_edge=False)
    for about in listed:
        table.add_row(
            about["number"],
            about["section"],
            about["level"],
            about["title"],
            str(len(about["answers"])),
        )
    console.print(table)


@app.command()
def solve(
    number: Annotated[str, typer.Argument(help='A problem such as "1.15".')],
    as_json: AsJson = False,
):
    """Run a problem's worked solution (from a checkout) and print its answers and their
    verdicts."""
    from workbook.authoring import read
    from workbook.checks.contract.decoding import decode
    from workbook.checks.contract.encoding import describe
    from workbook.notebooks.execution import judge, run_notebook

    exercise = exercises.find(number)
    master_path = (
        exercises.CHECKOUT / "solutions" / exercise.path.parent.name / f"{exercise.path.stem}.md"
    )
    if not master_path.exists():
        raise UserError(
            f"the solution of {number} is not here: solutions are only in a checkout of the "
            "workbook"
        )
    master = read(master_path)
    run = run_notebook(master.code("data", "answer"), master.answers)
    if run.errors:
        raise UserError(f"{master_path.name} fails: {run.errors[0]}")
    verdicts = judge(exercise.code("data", "check"), run, master.answers)
    texts = {name: describe(decode(data)) for name, data in run.encoded.items()}
    if as_json:
        answers = {
            name: {
                "type": master.answers[name].kind,
                "text": texts[name],
                "encoded": json.loads(data),
            }
            for name, data in run.encoded.items()
        }
        print(
            json.dumps(
                {"number": number, "answers": answers, "verdicts": _plain(verdicts)},
                ensure_ascii=False,
                indent=1,
            )
        )
    else:
        console.print(f"[bold]{number}[/bold]  {master.title}")
        for name in master.answers:
            console.print(f"  {name} = {texts.get(name, run.unreadable.get(name))}", markup=False)
            _show(name, verdicts[name])
    raise typer.Exit(_code(verdicts))


@app.command()
def check(
    notebook: Annotated[
        Path, typer.Argument(help="A notebook of yours: a file, such as ch1/p15.ipynb.")
    ],
    as_json: AsJson = False,
    timeout: Annotated[float, typer.Option(help="Seconds the notebook may run.")] = 120,
):
    """Run a notebook of yours and judge its answers. The exit code is 0 if all are right, 1 if
    not."""
    from workbook.notebooks.execution import TimeLimit, judge, run_notebook

    if not notebook.exists() and re.fullmatch(r"\d+\.\d+", str(notebook)):
        exercises.place(notebook)
        raise UserError(
            f"check reads a notebook of yours, the file in which you answered problem {notebook}; "
            f"`workbook exercises {notebook} --to my-folder` puts a fresh one there"
        )
    worked = exercises.read(notebook)
    pristine = exercises.find(worked.number)
    sources = pristine.to_run([source for _, source in worked.cells])
    try:
        run = run_notebook(
            sources, pristine.about["answers"], timeout=timeout, folder=notebook.resolve().parent
        )
    except TimeLimit:
        raise UserError(
            f"{notebook} was still running after {timeout:g} s; --timeout allows it more"
        ) from None
    verdicts = judge(pristine.code("data", "check"), run, pristine.about["answers"])
    if as_json:
        print(
            json.dumps(
                {"number": pristine.number, "verdicts": _plain(verdicts), "errors": run.errors},
                ensure_ascii=False,
                indent=1,
            )
        )
    else:
        console.print(f"[bold]{pristine.number}[/bold]  {pristine.about['title']}")
        for error in run.errors:
            console.print(f"  {error}", style="yellow", markup=False)
        for name, verdict in verdicts.items():
            _show(name, verdict)
        right = sum(verdict.status == RIGHT for verdict in verdicts.values())
        console.print(f"{right} of {len(verdicts)} right")
    raise typer.Exit(_code(verdicts))


@app.command(name="exercises")
def write_exercises(
    numbers: Annotated[
        list[str] | None, typer.Argument(help="Only these problems; all if none is named.")
    ] = None,
    to: Annotated[
        Path | None, typer.Option(help="Put fresh notebooks into this folder, to work on.")
    ] = None,
    as_json: AsJson = False,
):
    """Put the students' notebooks into a folder (--to); without it, in a checkout, regenerate them
    from the masters."""
    if to is not None:
        changed = [str(path) for path in _put(to, numbers)]
        done = "nothing is written: all these notebooks are there already"
    elif (exercises.CHECKOUT / "solutions").is_dir():
        from workbook.authoring import write_exercises as write

        changed = [
            str(path.relative_to(exercises.CHECKOUT))
            for path in write(exercises.CHECKOUT, numbers or ())
        ]
        done = "all notebooks are in step with their masters"
    else:
        raise UserError(
            "there are no masters here; workbook exercises --to my-folder gives you notebooks to "
            "work on"
        )
    print(json.dumps({"changed": changed}) if as_json else "\n".join(changed) or done)


@app.command(name="new")
def begin(
    number: Annotated[str, typer.Argument(help='A problem that is not there yet, such as "2.30".')],
):
    """Begin a problem (in a checkout): a page and its trials, valid but for the mathematics."""
    from workbook.authoring import begin as write

    solutions = exercises.CHECKOUT / "solutions"
    if not solutions.is_dir():
        raise UserError("there are no masters here: run this in a checkout of the workbook")
    try:
        written = write(solutions, number)
    except (ValueError, FileExistsError) as error:
        raise UserError(error) from None
    print("\n".join(str(path.relative_to(exercises.CHECKOUT)) for path in written))
    print(f"replace what says PLACEHOLDER, and try it by: make test-problem N={number}")


@app.command()
def grade(
    submitted: Annotated[
        Path, typer.Argument(help="Folder submitted/<student>/<assignment>/<notebook>.ipynb.")
    ],
    out: Annotated[
        Path, typer.Option(help="Folder for the grade store, tables and feedback pages.")
    ],
    assignments: Annotated[
        Path | None,
        typer.Option(
            help="Folder <assignment>/assignment.toml; default: assignments, if it is there."
        ),
    ] = None,
    roster: Annotated[
        Path | None, typer.Option(help="Gradebook exported from Canvas, to fill one column of.")
    ] = None,
    site: Annotated[
        str,
        typer.Option(help="Address of the student edition of the site, for links to the theory."),
    ] = "",
    processes: Annotated[
        int | None, typer.Option(help="Notebooks graded at the same time; default: all cores.")
    ] = None,
    timeout: Annotated[
        float, typer.Option(help="Seconds of computing one notebook may take.", min=1)
    ] = 120,
    trust_students: Annotated[
        bool, typer.Option("--trust-students", help="Run notebooks without a sandbox, as yourself.")
    ] = False,
    cluster: Annotated[
        str | None,
        typer.Option(help="Grade on a Dask cluster: its scheduler's address, tls://host:8786."),
    ] = None,
    tls_ca_file: Annotated[
        Path | None, typer.Option(help="For --cluster: the certificate of who signed the others.")
    ] = None,
    tls_cert: Annotated[
        Path | None, typer.Option(help="For --cluster: this machine's certificate.")
    ] = None,
    tls_key: Annotated[
        Path | None, typer.Option(help="For --cluster: the private key to it.")
    ] = None,
    as_json: AsJson = False,
):
    """Grade a course: run every notebook in a sandbox, judge its answers, write tables and
    feedback.

    A run that was stopped goes on where it was; what has not changed is not graded again.
    """
    if sys.platform != "linux":
        raise UserError(
            "grading needs Linux; on Windows it runs in WSL, on a Mac in a virtual machine"
        )
    if not submitted.is_dir():
        raise UserError(f"{submitted} is not a folder")
    if processes is not None and processes < 1:
        raise UserError("--processes is a number from 1 up")
    if cluster is not None and processes is not None:
        raise UserError(
            "--processes is for this machine; with --cluster each worker grades as many at a time "
            "as it has threads"
        )
    if cluster is None and (tls_ca_file or tls_cert or tls_key):
        raise UserError("--tls-ca-file, --tls-cert and --tls-key are for --cluster")
    where = (
        {"address": cluster, "ca_file": tls_ca_file, "cert": tls_cert, "key": tls_key}
        if cluster is not None
        else None
    )
    try:
        summary = _grade_course(
            submitted,
            out,
            assignments,
            processes,
            timeout,
            trust_students,
            as_json,
            roster,
            site,
            where,
        )
    except KeyboardInterrupt:
        print(
            "workbook: stopped; what is graded is stored, and the same command goes on from there",
            file=sys.stderr,
        )
        raise typer.Exit(130) from None
    print(json.dumps(summary, ensure_ascii=False, indent=1)) if as_json else None


@app.command()
def live(
    word: Annotated[
        str,
        typer.Argument(
            metavar="[PROBLEM or LECTURE]",
            help='A problem such as "1.15" or a lecture\'s slug; without it, a list.',
        ),
    ] = "",
    port: Annotated[
        int | None, typer.Option(help="JupyterLab's port; default: one that is free.")
    ] = None,
    browser: Annotated[
        bool,
        typer.Option("--browser/--no-browser", help="Open a browser, or only print the address."),
    ] = True,
    keep: Annotated[
        Path | None, typer.Option(help="Keep the notebook there when the lecture ends.")
    ] = None,
    discard: Annotated[
        bool, typer.Option("--discard", help="Throw the notebook away without asking.")
    ] = False,
):
    """Before a class: open a problem or a lecture in JupyterLab on a throw-away copy (from a
    checkout)."""
    from workbook.live import LiveError, find, lectures, present

    if keep is not None and discard:
        raise UserError("give either --keep or --discard")
    try:
        if word:
            present(
                find(word), port, browser, keep, discard, say=lambda text: print(text, flush=True)
            )
            return
        listed = lectures()
    except LiveError as error:
        raise UserError(error) from None
    table = Table("lecture or problem", "title", box=None, pad_edge=False)
    for lecture in listed:
        table.add_row(lecture.word, lecture.title)
    for exercise in exercises.read_all():
        table.add_row(exercise.number, exercise.about["title"])
    console.print(table)


@app.command()
def collect(
    download: Annotated[
        Path, typer.Argument(help="All submissions from Moodle or Canvas: .zip or folder.")
    ],
    homework: Annotated[str, typer.Argument(metavar="ASSIGNMENT", help="The homework's name.")],
    into: Annotated[Path, typer.Option(help="Folder of all submissions.")] = Path("submitted"),
    worksheet: Annotated[
        Path | None, typer.Option(help="Moodle's grading worksheet, for addresses.")
    ] = None,
):
    """Put a download from Moodle or Canvas into folders submitted/STUDENT/ASSIGNMENT, as workbook
    grade reads them."""
    from workbook.grading.collecting import collect as put

    collected, aside = put(download, homework, into, worksheet)
    for path, why in aside:
        console.print(f"left aside: {path}: {why}", markup=False, style="yellow")
    files, students = sum(map(len, collected.values())), len(collected)
    console.print(
        f"{into}: {files} file{'s' * (files != 1)} of {students} student{'s' * (students != 1)} "
        f"for {homework}",
        markup=False,
    )


@app.command()
def score(
    student: Annotated[str, typer.Argument(help="As the student's folder is called.")],
    homework: Annotated[str, typer.Argument(metavar="ASSIGNMENT", help="The homework's name.")],
    problem: Annotated[str, typer.Argument(help='A problem such as "1.15".')],
    answer: Annotated[str, typer.Argument(help="The answer's variable, such as a_region.")],
    points: Annotated[
        float | None, typer.Argument(help="From 0 to what the answer is worth.")
    ] = None,
    comment: Annotated[str, typer.Option(help="For the student, shown on the feedback page.")] = "",
    remove: Annotated[
        bool, typer.Option("--remove", help="Take points given by hand back.")
    ] = False,
    graded: Annotated[
        Path, typer.Option(help="Folder that workbook grade wrote (its --out).")
    ] = Path("graded"),
):
    """Give points for one answer by hand. They beat the automatic ones, also after a regrade, until
    --remove."""
    from workbook.grading.commands import score_by_hand

    if remove == (points is not None):
        raise UserError("give either POINTS or --remove")
    console.print(
        score_by_hand(graded, student, homework, problem, answer, points, comment), markup=False
    )
    console.print("run workbook grade again to write tables and pages anew")


@assignment.command()
def new(
    name: Annotated[str, typer.Argument(help="The homework's name; it names its folder.")],
    numbers: Annotated[
        list[str], typer.Argument(metavar="PROBLEMS", help="Its problems, such as 1.4 1.15.")
    ],
    title: Annotated[str | None, typer.Option(help="Title for people; default: the name.")] = None,
    due: Annotated[
        str | None,
        typer.Option(help='"2026-10-01 23:59", or "2026-10-01" for the end of that day.'),
    ] = None,
    assignments: Annotated[Path, typer.Option(help="Folder in which homeworks stand.")] = Path(
        "assignments"
    ),
    site: Annotated[
        str,
        typer.Option(help="Address of the student edition of the site, for links to the theory."),
    ] = "",
):
    """Make a homework folder: the students' notebooks, a README for them, and assignment.toml with
    points and dates."""
    from workbook.grading.handing_out import due_date, due_text, make

    made = make(assignments, name, numbers, title, due_date(due) if due else None, site)
    answers = sum(len(points) for points in made.points.values())
    console.print(
        f"{assignments / name}: {len(made.problems)} problems, {answers} answers, "
        f"{made.max_points:g} "
        f"points, " + (f"due {due_text(made.due)}" if made.due else "no due date"),
        markup=False,
    )


@assignment.command()
def gradescope(
    name: Annotated[str, typer.Argument(help="The homework's name.")],
    out: Annotated[
        Path, typer.Option(help="The archive to write, to be uploaded as an autograder.")
    ],
    assignments: Annotated[Path, typer.Option(help="Folder in which homeworks stand.")] = Path(
        "assignments"
    ),
):
    """Make an autograder for Gradescope from assignments/NAME/assignment.toml."""
    from workbook.grading.gradescope.bundle import make

    made = make(assignments, name, out)
    console.print(
        f"{out}: an autograder for {made.title}, {made.max_points:g} points; upload it to "
        "Gradescope",
        markup=False,
    )


def main():
    """Entry point: errors that the user can mend become one line on stderr and exit code 2."""
    try:
        app()
    except (UserError, exercises.UnknownExercise) as error:
        print(f"workbook: {error}", file=sys.stderr)
        sys.exit(2)
    except ValueError as error:
        # Masters and homeworks that break their contract say so themselves; nothing else of ours
        # raises a ValueError here.
        from workbook.authoring import MasterError
        from workbook.grading.assignment import InputError

        if not isinstance(error, (InputError, MasterError)):
            raise
        print(f"workbook: {error}", file=sys.stderr)
        sys.exit(2)
    finally:
        # or Python would look through all that is imported, to end a process that ends anyway
        gc.freeze()


def _put(folder, numbers):
    """Copy exercises below `folder` as ch1/p15.ipynb; what stands there, somebody's work, is left
    alone."""
    chosen = [exercises.find(number) for number in numbers] if numbers else exercises.read_all()
    for exercise in chosen:
        path = folder / exercise.path.parent.name / exercise.path.name
        if not path.exists():
            try:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(exercise.path.read_bytes())
            except OSError as error:
                raise UserError(f"{path} cannot be written: {error.strerror}") from None
            yield path


def _grade_course(*given):
    # Also what is to be imported is inside: that takes long enough for somebody to press Ctrl-C.
    from workbook.grading.interrupts import repeat_lost_interrupts

    with repeat_lost_interrupts():
        from workbook.grading.commands import grade_course
        from workbook.grading.isolation import ProcessStartError, SandboxUnavailableError

        try:
            return grade_course(*given)
        except ProcessStartError as error:
            raise UserError(str(error)) from None
        except SandboxUnavailableError as error:
            raise UserError(f"{error}; --trust-students grades without a sandbox") from None


def _show(name, verdict):
    from workbook.checks.contract.reporting import MARKS

    colour = COLOURS[verdict.status]
    console.print(f"  [{colour}]{MARKS[verdict.status]} {verdict.status:<9}[/{colour}] ", end="")
    console.print(f"{name}: {verdict.message}", markup=False)
    for line in verdict.mistake.splitlines():
        console.print(f"    {line}", markup=False)


def _plain(verdicts):
    return {
        name: {"verdict": verdict.status, "message": verdict.message}
        | ({"mistake": verdict.mistake} if verdict.mistake else {})
        for name, verdict in verdicts.items()
    }


def _code(verdicts):
    return 0 if all(verdict.status == RIGHT for verdict in verdicts.values()) else 1


if __name__ == "__main__":
    main()
