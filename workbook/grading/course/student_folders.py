"""Write a folder for each student of a homework in which everyone has numbers of their own.

Each lies in `assignments/hw1/students/` and has the README of the homework and the student's
notebooks, under the names that they have in every homework. The rows are those of `numbers.csv`,
and only proved rows are handed out.
"""

import io
import zipfile
from pathlib import Path

from workbook.grading.course import numbers, worksheet
from workbook.grading.course.assignment import InputError
from workbook.grading.course.handing_out import file_name, release
from workbook.grading.course.record import put, put_bytes
from workbook.grading.sandbox.sanitising import normalise_name
from workbook.notebooks import exercises

FOLDER = "students"
README = """
## Your numbers

Some of your notebooks have numbers of your own, and you are graded by them: answers for other
numbers are wrong.
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
    rows = proved_rows(homework.problems)
    table = numbers.draw(homework.numbers or {}, students, rows)
    if not table:
        raise InputError("numbers are drawn for the students of a class: give --roster class.csv")
    for student, own in table.items():
        for problem, row in own.items():
            if row not in rows.get(problem, ()):
                raise InputError(f"{numbers.NAME}: {problem} has no proved row {row} ({student})")
    put(target / numbers.NAME, numbers.text(table, rows))
    for student, own in table.items():
        _write_folder(target, student, own, homework, site)
    return table


def moodle_archive(folder, name, grading_worksheet):
    """Write the students' files as an archive that Moodle hands out, each to its student.

    Moodle takes it under *Upload multiple feedback files in a zip*, where the name of a folder says
    whose it is.

    Parameters
    ----------
    folder : path
        Folder of all homeworks.
    name : str
        The homework's, whose folders are written.
    grading_worksheet : path
        Moodle's grading worksheet of the assignment, with the students' addresses.

    Returns
    -------
    path : pathlib.Path
        The archive.
    students : list of str
        Those of the homework who are not in the worksheet.

    Raises
    ------
    InputError
        If the worksheet has none of the students.
    """
    target = Path(folder) / name
    table = numbers.read(target / numbers.NAME)
    participants = {
        normalise_name(participant.address): (participant.name.replace("_", " "), number)
        for number, participant in worksheet.read(grading_worksheet).items()
    }
    if not participants.keys() & table.keys():
        raise InputError(f"{grading_worksheet} has the addresses of none of the students")
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as file:
        for student in table:
            full_name, number = participants.get(student, ("", ""))
            for path in sorted((target / FOLDER / student).iterdir()) if number else ():
                file.write(path, f"{full_name}_{number}_assignfeedback_file/{path.name}")
    put_bytes(target / "moodle.zip", archive.getvalue())
    return target / "moodle.zip", [student for student in table if student not in participants]


def require_handed_out(path, homework):
    """Raise `InputError` if a student's folder has other numbers than the homework says now.

    Then a row was given to somebody else, or a problem's rows changed, after the folder was
    written. A folder that is not there is not looked at.
    """
    for student, own in (homework.numbers or {}).items():
        for problem in own:
            file = path.parent / FOLDER / student / file_name(problem)
            variant = exercises.find(homework.variant(problem, student))
            if file.is_file() and exercises.read(file).code("data") != variant.code("data"):
                raise InputError(
                    f"{file} has other numbers than {variant.number} has now: if {student} is to "
                    f"have these, hand them out by `workbook assignment numbers {homework.name}`"
                )


def proved_rows(problems):
    """Return {problem: its proved rows} of those problems that vary, which are proved now.

    Raises
    ------
    InputError
        If there are no masters here, or none of the problems varies.
    """
    from workbook.authoring import read
    from workbook.authoring.contract import master_file
    from workbook.authoring.variants import prove

    solutions = exercises.CHECKOUT / "solutions"
    if not solutions.is_dir():
        raise InputError("--numbers needs the masters: run it in a checkout of the workbook")
    varying = [p for p in problems if read(solutions / master_file(p)).numbers]
    if not varying:
        raise InputError(f"none of the problems {', '.join(problems)} varies")
    return {
        problem: [
            int(proof.name.partition("~")[2])
            for proof in prove(exercises.CHECKOUT, problem)
            if not proof.faults
        ]
        for problem in varying
    }


def _write_folder(target, student, own, homework, site):
    folder = target / FOLDER / student
    try:
        folder.mkdir(parents=True, exist_ok=True)
        readme = (target / "README.md").read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"{folder} cannot be written: {error.strerror}") from None
    put(folder / "README.md", readme + README)
    for problem in homework.problems:
        variant = f"{problem}~{own[problem]}" if problem in own else problem
        put(folder / file_name(problem), release(homework, variant, site))


def _is_folder_name(student):
    return bool(student.strip(" .")) and not {"/", "\\", "\0"} & set(student) and student[0] != "."
