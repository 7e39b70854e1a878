"""The command `workbook`; bad input ends in one line and exit code 2.

Each command imports what it needs, so that the others start without SymPy.
"""

import gc
import json
import sys
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table

from workbook import course
from workbook.checks.contract.verdict import INVALID, MISSING, RIGHT, UNCHECKED, WRONG
from workbook.grading import cli as grading
from workbook.notebooks import exercises
from workbook.notebooks.origin import marks_of, why_foreign
from workbook.numbering import read_number
from workbook.terminal import AsJson, CourseCommands, CourseFolder, UserError, console

app = CourseCommands(
    help="The executable workbook on controlled motion: its problems, solutions and checks.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.add_typer(grading.assignment, name="assignment")
COLOURS = {RIGHT: "green", WRONG: "red", MISSING: "yellow", INVALID: "magenta", UNCHECKED: "cyan"}


@app.command()
def problems(
    only_course: Annotated[
        bool, typer.Option("--only-course", help="Leave out the workbook's own.")
    ] = False,
    as_json: AsJson = False,
):
    """List the problems: number, section, level, title."""
    homes = course.courses()
    if only_course and len(homes) == 1:
        raise UserError(
            "there is no course here: work in its folder, or name it by --course FOLDER"
        )
    listed = [exercise.about for exercise in exercises.read_all(homes[-only_course:])]
    if as_json:
        keys = ("number", "title", "section", "level", "topics", "answers")
        _print_json([{key: about[key] for key in keys} for about in listed])
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
    """Run the worked solution of a problem (where its master is); print answers and verdicts."""
    from workbook.authoring import read_master
    from workbook.checks.contract.decoding import describe_encoded
    from workbook.notebooks.execution import judge, run_notebook

    exercise = exercises.find(number)
    master_path = exercises.master_path(number)
    if not master_path.exists():
        raise UserError(
            f"the solution of {number} is not here: solutions are only in a checkout of the "
            "workbook"
        )
    master = read_master(master_path)
    run = run_notebook(master.code("data", "answer"), master.answers)
    if run.errors:
        raise UserError(f"{master_path.name} fails: {run.errors[0]}")
    verdicts = judge(exercise.code("data", "check"), run, master.answers)
    texts = {name: describe_encoded(data) for name, data in run.encoded.items()}
    if as_json:
        answers = {
            name: {
                "type": master.answers[name].kind,
                "text": texts[name],
                "encoded": json.loads(data),
            }
            for name, data in run.encoded.items()
        }
        _print_json({"number": number, "answers": answers, "verdicts": _as_dicts(verdicts)})
    else:
        console.print(f"[bold]{number}[/bold]  {master.title}")
        for name in master.answers:
            console.print(f"  {name} = {texts.get(name, run.unreadable.get(name))}", markup=False)
            _print_verdict(name, verdicts[name])
    raise typer.Exit(_exit_code(verdicts))


@app.command()
def check(
    notebook: Annotated[Path, typer.Argument(help="Your notebook: a file such as ch1/p15.ipynb.")],
    as_json: AsJson = False,
    timeout: Annotated[float, typer.Option(help="Seconds that the notebook may run.")] = 120,
):
    """Run your notebook and judge its answers. The exit code is 0 if all are right, otherwise 1."""
    from workbook.checks.course_checks import own_checks
    from workbook.notebooks.execution import EndedEarly, TimeLimit, judge, run_notebook

    if not notebook.exists() and read_number(notebook):
        exercises.notebook_path(notebook)  # raises UnknownExercise for another number
        raise UserError(
            f"check reads a notebook of yours, the file in which you answered problem {notebook}; "
            f"`workbook exercises {notebook} --to my-folder` puts a fresh one there"
        )
    submitted = exercises.read(notebook)
    pristine = exercises.leaving_to_grading(exercises.find(submitted.number), submitted.kept)
    if submitted.hides_direction:
        pristine = exercises.in_homework(pristine)
    own_checks(exercises.home_of(pristine.number))  # raises `CourseError` if they cannot be used
    if foreign := why_foreign(marks_of(submitted.about), pristine):
        raise UserError(f"{notebook} is not judged: {foreign}")
    sources = pristine.sources_to_run([source for _, source in submitted.cells])
    try:
        run = run_notebook(
            sources, pristine.about["answers"], timeout=timeout, folder=notebook.resolve().parent
        )
    except TimeLimit:
        raise UserError(
            f"{notebook} was still running after {timeout:g} s; --timeout allows it more"
        ) from None
    except EndedEarly as error:
        raise UserError(
            f"no answer of {notebook} was read: {error}; a cell that calls os._exit() does that, and "
            "so does a lack of memory"
        ) from None
    verdicts = judge(pristine.code("data", "check"), run, pristine.about["answers"])
    if as_json:
        _print_json(
            {
                "number": pristine.number,
                "verdicts": _as_dicts(verdicts),
                "errors": run.errors,
                "read": run.read,
            }
        )
    else:
        console.print(f"[bold]{pristine.number}[/bold]  {pristine.about['title']}")
        for code in run.read:
            console.print(f"  read as: {code}", markup=False)
        for stopped in run.errors:
            console.print(f"  {stopped}", style="yellow", markup=False)
        for name, verdict in verdicts.items():
            _print_verdict(name, verdict)
        right = sum(verdict.status == RIGHT for verdict in verdicts.values())
        kept = len(verdicts.keys() & set(submitted.kept))
        later = f"; the grading judges {kept}" if kept else ""
        console.print(f"{right} of {len(verdicts) - kept} right{later}")
    raise typer.Exit(_exit_code(verdicts))


@app.command(name="exercises")
def write_exercises(
    numbers: Annotated[
        list[str] | None, typer.Argument(help="Only these problems; default: all.")
    ] = None,
    to: Annotated[Path | None, typer.Option(help="Folder to put fresh notebooks into.")] = None,
    as_json: AsJson = False,
):
    """Put student notebooks into a folder (--to), or write those of masters here anew."""
    if to is not None:
        changed = [str(path) for path in _copy_exercises(to, numbers)]
        summary = _copied_text(changed)
    elif homes := _homes_with_masters(numbers):
        from workbook import authoring

        changed = [
            str(path.relative_to(home.folder))
            for home, own in homes.items()
            for path in authoring.write_exercises(home.folder, own)
        ]
        summary = "\n".join(changed) or "all notebooks are in step with their masters"
    else:
        raise UserError(
            "there are no masters here; workbook exercises --to my-folder gives you notebooks to "
            "work on, and workbook new --course my-course begins a course of your own"
        )
    print(json.dumps({"changed": changed}) if as_json else summary)


@typer.Typer.command(app, name="new")  # its --course may be a folder that is no course yet
def new_problem(
    number: Annotated[
        str,
        typer.Argument(help='Number of the new problem, such as "rob.2"; with --course optional.'),
    ] = "",
    folder: CourseFolder = None,
):
    """Begin a problem: write a page and its trials. Or begin a course, with one problem in it."""
    from workbook import authoring

    if not number and folder is None:
        raise UserError(
            "give the number of the problem, such as rob.2, or --course FOLDER to begin a course"
        )
    if folder is not None and not number:
        try:
            paths, number = authoring.new_course(folder)
        except (FileExistsError, ValueError) as error:
            raise UserError(error) from None
        print("\n".join(map(str, paths)))
        print(f"a course with one problem; prove it by: workbook prove --course {folder} {number}")
        return
    if folder is not None:
        course.enter(folder)
    home = exercises.home_of(number) if read_number(number) else course.WORKBOOK
    try:
        paths = authoring.new_problem(home.solutions, number)
    except (ValueError, FileExistsError) as error:
        raise UserError(error) from None
    print("\n".join(str(path.relative_to(home.folder)) for path in paths))
    print(f"replace what says PLACEHOLDER, and try it by: workbook prove {number}")


@app.command()
def prove(
    numbers: Annotated[
        list[str] | None,
        typer.Argument(help="Only these problems; default: all of the course."),
    ] = None,
    as_json: AsJson = False,
):
    """Prove problems: their checks take what is right, and refuse each wrong trial."""
    from workbook import authoring

    homes = _homes_with_masters(numbers)
    if not homes:
        raise UserError("there are no masters here: run this in a course or a checkout")
    proofs = {
        master.number: authoring.prove(master)
        for home, own in homes.items()
        for master in _masters(home, own)
    }
    if as_json:
        _print_json({number: vars(proof) for number, proof in proofs.items()})
    else:
        for number, proof in proofs.items():
            console.print(f"{number}: {proof.summary}", markup=False, highlight=False)
            for fault in proof.faults:
                console.print(f"  {fault}", markup=False, style="yellow")
    raise typer.Exit(1 if any(proof.faults for proof in proofs.values()) else 0)


@app.command()
def page(
    to: Annotated[Path, typer.Option(help="The folder to pack into.")] = Path("_build/run"),
):
    """Pack Python for the answer boxes of a site (33 MB, the same for every course)."""
    from workbook.engine.pack import pack

    try:
        pack(to)
    except ModuleNotFoundError as error:
        raise UserError(error) from None
    print(f"{to}: Python for the answer boxes of a site")


@app.command()
def variants(
    numbers: Annotated[
        list[str] | None, typer.Argument(help="Only these problems; default: all that vary.")
    ] = None,
    as_json: AsJson = False,
):
    """Prove that the other numbers of problems can be handed out (where their masters are)."""
    from workbook.authoring.variants import prove

    homes = _homes_with_masters(numbers)
    if not homes:
        raise UserError("there are no masters here: run this in a checkout or in a course")
    proofs = {
        master.number: list(prove(home.folder, master.number))
        for home, own in homes.items()
        for master in _masters(home, own)
        if master.numbers or numbers
    }
    if as_json:
        _print_json({number: [vars(proof) for proof in rows] for number, rows in proofs.items()})
        return
    for number, rows in proofs.items():
        proved = [proof for proof in rows if not proof.faults]
        site = max((proof.site_share for proof in proved), default=0.0)
        shared = max((proof.shared for proof in proved), default=0.0)
        console.print(
            f"{number}: {len(proved)} of {len(rows)} rows proved; the answers of the site earn "
            f"{site:.0%} at most, two rows share {shared:.0%}",
            highlight=False,
        )
        for proof in rows:
            for fault in proof.faults:
                console.print(f"  {proof.name}: {fault}", markup=False, style="yellow")


@app.command()
def route(
    name: Annotated[
        str, typer.Argument(metavar="[ROUTE]", help="Such as linear-control; default: list all.")
    ] = "",
    start: Annotated[
        list[datetime] | None,
        typer.Option(formats=["%Y-%m-%d"], help="First day; repeat it for the second term."),
    ] = None,
    ics: Annotated[
        Path | None, typer.Option(help="With --start: calendar file (.ics) to write.")
    ] = None,
    as_json: AsJson = False,
):
    """Print a way through the course, week by week, with dates if you like."""
    from workbook.routes.calendar import to_ics, week_dates
    from workbook.routes.course import course
    from workbook.routes.printing import as_data, week_lines, week_texts
    from workbook.routes.spacing import self_tests

    if not name:
        if start or ics:
            raise UserError("--start and --ics are for one route: workbook route linear-control")
        _print_routes(course().routes.values(), as_json)
        return
    if ics and not start:
        raise UserError("a calendar needs the first day: --start 2027-02-08")
    chosen = course().find(name)
    dates = week_dates(chosen, [day.date() for day in start]) if start else []
    if ics:
        try:
            text = to_ics(chosen, dates, week_texts(course(), chosen))
            ics.write_text(text, encoding="utf-8", newline="")
        except OSError as error:
            raise UserError(f"{ics} cannot be written: {error.strerror}") from None
    if as_json:
        _print_json(as_data(course(), chosen, dates))
        return
    console.print(f"[bold]{chosen.title}[/bold]\n{chosen.about}")
    if assumed := course().assumed(chosen):
        console.print(
            f"It assumes: {'; '.join(section.name for section in assumed)}.", markup=False
        )
    tests = self_tests(course(), chosen)
    for k, week in enumerate(chosen.weeks):
        console.print()
        day = f", from {dates[k]}" if dates else ""
        console.print(f"[bold]{chosen.unit.capitalize()} {week.number}[/bold]{day}")
        for heading, text in week_lines(course(), week, tests[week.number]).items():
            console.print(f"  {heading + ':':<10} {text}", markup=False)
    console.print("\nMinutes are an estimate by a rule, not measured.")
    if ics:
        console.print(f"{ics}: {len(dates)} events", markup=False)


def _print_routes(routes, as_json):
    if as_json:
        _print_json([{"name": r.name, "title": r.title, "weeks": len(r.weeks)} for r in routes])
        return
    table = Table("route", "title", "length", "homework", box=None, pad_edge=False)
    for each in routes:
        hours = sum(week.minutes for week in each.weeks) / 60
        table.add_row(
            each.name, each.title, f"{len(each.weeks)} {each.unit}s", f"about {hours:.0f} h"
        )
    console.print(table)


app.command()(grading.grade)


@app.command()
def live(
    name: Annotated[
        str,
        typer.Argument(
            metavar="[PROBLEM or LECTURE]",
            help='A problem such as "1.15" or the slug of a lecture; default: list both.',
        ),
    ] = "",
    port: Annotated[
        int | None, typer.Option(help="Port of JupyterLab; default: a free one.")
    ] = None,
    browser: Annotated[
        bool,
        typer.Option("--browser/--no-browser", help="Open a browser, or only print the address."),
    ] = True,
    keep: Annotated[
        Path | None, typer.Option(help="File or folder to keep the notebook in at the end.")
    ] = None,
    discard: Annotated[
        bool, typer.Option("--discard", help="Throw the notebook away without asking.")
    ] = False,
    prepare: Annotated[
        bool, typer.Option("--prepare", help="Compute everything first, so that no step waits.")
    ] = False,
):
    """Open a problem or a lecture in JupyterLab for a class, on a copy (where its master is)."""
    from workbook.live import LiveError, find_presentation, lectures, present

    course.pinned()  # kernels have another working folder

    if keep is not None and discard:
        raise UserError("give either --keep or --discard")
    try:
        if name:
            presentation = find_presentation(name)
            print_line = partial(print, flush=True)
            present(presentation, port, browser, keep, discard, prepare, print_line)
            return
        listed = lectures()
    except LiveError as error:
        raise UserError(error) from None
    table = Table("lecture or problem", "title", box=None, pad_edge=False)
    for lecture in listed:
        table.add_row(lecture.name, lecture.title)
    for exercise in exercises.read_all():
        table.add_row(exercise.number, exercise.about["title"])
    console.print(table)


app.command()(grading.collect)
app.command()(grading.score)


def main():
    """Run the command; errors of the user end in one line on stderr and exit code 2."""
    try:
        app()
    except (UserError, exercises.UnknownExercise, course.CourseError) as error:
        _exit_with(error)
    except ValueError as error:
        # imported only where a ValueError was raised
        from workbook.authoring import MasterError
        from workbook.grading.course.assignment import InputError
        from workbook.routes.course import UnknownRoute

        if not isinstance(error, (InputError, MasterError, UnknownRoute)):
            raise
        _exit_with(error)
    except RuntimeError as error:
        from workbook.notebooks.execution import TimeLimit

        if not isinstance(error, TimeLimit):
            raise
        _exit_with(f"{error}, which this machine may be too busy for: try again")
    finally:
        # keeps the garbage collector from traversing all that is imported when the process exits
        gc.freeze()


def _homes_with_masters(numbers):
    """Return {course: numbers} of problems; without numbers that of the nearest masters, []."""
    if not numbers:
        homes = [home for home in course.courses() if home.solutions.is_dir()]
        return {homes[-1]: []} if homes else {}
    homes = {}
    for number in numbers:
        homes.setdefault(exercises.home_of(number), []).append(number)
    return {home: own for home, own in homes.items() if home.solutions.is_dir()}


def _masters(home, numbers):
    from workbook import authoring

    if not numbers:
        return authoring.read_all(home.solutions)
    return [authoring.read_master(exercises.master_path(number)) for number in numbers]


def _exit_with(error):
    print(f"workbook: {error}", file=sys.stderr)
    sys.exit(2)


def _print_json(document):
    print(json.dumps(document, ensure_ascii=False, indent=1))


def _copy_exercises(folder, numbers):
    """Copy exercises below a folder as ch1/p15.ipynb; existing files are not overwritten."""
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


def _copied_text(paths):
    """Return how many notebooks were written, and what to do with the first."""
    if not paths:
        return "nothing is written: all these notebooks are there already"
    count = "1 notebook" if len(paths) == 1 else f"{len(paths)} notebooks"
    quoted = f'"{paths[0]}"' if " " in paths[0] else paths[0]  # as all shells read it
    return f"wrote {count}; open {paths[0]} in Jupyter, or check it by: workbook check {quoted}"


def _print_verdict(name, verdict):
    from workbook.checks.contract.reporting import MARKS  # loads what renders reports

    colour = COLOURS[verdict.status]
    console.print(f"  [{colour}]{MARKS[verdict.status]} {verdict.status:<9}[/{colour}] ", end="")
    console.print(f"{name}: {verdict.message}", markup=False)
    for line in verdict.mistake.splitlines():
        console.print(f"    {line}", markup=False)


def _as_dicts(verdicts):
    return {
        name: {"verdict": verdict.status, "message": verdict.message}
        | ({"mistake": verdict.mistake} if verdict.mistake else {})
        for name, verdict in verdicts.items()
    }


def _exit_code(verdicts):
    return 0 if all(verdict.status == RIGHT for verdict in verdicts.values()) else 1


if __name__ == "__main__":
    main()
