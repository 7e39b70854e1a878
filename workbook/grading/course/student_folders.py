"""Write a folder for each student of a homework in which everyone has numbers of their own.

Each lies in `assignments/hw1/students/` and has the README of the homework and the student's
notebooks, under the names that they have in every homework. Rows, and the problem of a pool, are
those of `numbers.csv`, and only proved rows are handed out.
"""

from dataclasses import replace
from pathlib import Path

from workbook.grading.course import numbers
from workbook.grading.course.assignment import POOL, InputError
from workbook.grading.course.handing_out import file_name, release
from workbook.grading.course.record import put
from workbook.grading.sandbox.sanitising import portable_name
from workbook.notebooks import exercises

FOLDER = "students"
README = """
## Your numbers

Some of your notebooks have numbers of your own, or are of a problem that others do not have, and
you are graded by them: answers for other numbers are wrong.
"""


def hand_out(folder, name, students=(), site=""):
    """Draw rows for students who have none, and write the folder of every student.

    Parameters
    ----------
    folder : path
        Folder of all homeworks.
    name : str
        The homework's.
    students : iterable of str
        The class; those who have rows keep them.
    site : str
        Address of the student edition of the site, for links to the theory.

    Returns
    -------
    dict
        {student: {problem: row}}, as in `numbers.csv`.

    Raises
    ------
    InputError
        If no problem of the homework varies, nobody is in the class, or a row is not proved.
    """
    target = Path(folder) / name
    homework = numbers.read_homework(target / "assignment.toml")
    if unusable := [student for student in students if not _is_folder_name(student)]:
        raise InputError(f"{unusable[0]!r} in the roster cannot be the name of a folder")
    rows = proved_rows(homework.problems, homework.pool)
    table = numbers.draw(homework.numbers or {}, students, rows)
    if not table:
        raise InputError("numbers are drawn for the students of a class: give --roster class.csv")
    homework = replace(homework, numbers=table)
    for student, own in table.items():
        for problem, row in own.items():
            if row not in rows.get(problem, ()):
                raise InputError(f"{numbers.NAME}: {problem} has no proved row {row} ({student})")
    put(target / numbers.NAME, numbers.text(table, rows))
    for student in table:
        _write_folder(target, student, homework, site)
    return table


def require_handed_out(path, homework):
    """Raise `InputError` if a student's folder has other numbers than the homework says now.

    Then a row was given to somebody else, or a problem's rows changed, after the folder was
    written. A folder that is not there is not looked at.
    """
    if homework.pool and homework.numbers is None:
        raise InputError(
            f"{path.with_name(numbers.NAME)} is to say who has which problem of the pool: run "
            f"`workbook assignment numbers {homework.name} --roster class.csv`"
        )
    for student, own in (homework.numbers or {}).items():
        for problem in {*own, *homework.pool} - {POOL}:
            file = path.parent / FOLDER / student / file_name(problem)
            if not file.is_file():
                continue
            variant = exercises.find(homework.variant(problem, student))
            reason = ""
            if homework.row(problem, student) is None:
                reason = numbers.why_not_asked(homework, problem, student)
            elif exercises.read(file).code("data") != variant.code("data"):
                reason = f"it has other numbers than {variant.number} has now"
            if reason:
                raise InputError(
                    f"{file}: {reason}; if {student} is to have what {numbers.NAME} says, hand it "
                    f"out by `workbook assignment numbers {homework.name}`"
                )


def proved_rows(problems, pool=()):
    """Return {problem: its proved rows} of those problems that vary, which are proved now.

    By `POOL` it has the problems of a pool.

    Raises
    ------
    InputError
        If there are no masters here, or none of the problems varies.
    """
    # SymPy loads with them
    from workbook.authoring import read_master
    from workbook.authoring.variants import prove

    masters = {problem: exercises.master_path(problem) for problem in problems}
    if not any(path.is_file() for path in masters.values()):
        raise InputError(
            "--numbers needs the masters: run it in a checkout of the workbook or in a course"
        )
    varying = [p for p, path in masters.items() if path.is_file() and read_master(path).numbers]
    if not varying and not pool:
        raise InputError(f"none of the problems {', '.join(problems)} varies")
    rows = {
        problem: [
            int(proof.name.partition("~")[2])
            for proof in prove(exercises.home_of(problem).folder, problem)
            if not proof.faults
        ]
        for problem in varying
    }
    return rows | {POOL: list(pool)} if pool else rows


def _write_folder(target, student, homework, site):
    folder = target / FOLDER / student
    try:
        folder.mkdir(parents=True, exist_ok=True)
        readme = (target / "README.md").read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"{folder} cannot be written: {error.strerror}") from None
    put(folder / "README.md", readme + README)
    for problem in homework.problems:
        file = folder / file_name(problem)
        if problem in homework.pool and problem != homework.drawn(student):
            file.unlink(missing_ok=True)  # the table may have had it before
            continue
        put(file, release(homework, homework.variant(problem, student), site))


def _is_folder_name(student):
    return bool(student) and student[0] != "." and student == portable_name(student)
