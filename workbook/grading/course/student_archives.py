"""Archives of the students' folders that Moodle and Canvas hand out, each file to its student."""

import io
import zipfile
from pathlib import Path, PurePosixPath

from workbook.grading.course import numbers, worksheet
from workbook.grading.course.assignment import InputError
from workbook.grading.course.collecting import named_files
from workbook.grading.course.handing_out import file_name
from workbook.grading.course.record import put_bytes
from workbook.grading.course.student_folders import FOLDER
from workbook.grading.sandbox.sanitising import normalise_name
from workbook.numbering import number_of_name


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


def canvas_archive(folder, name, download, roster=None):
    """Write the students' files as an archive that Canvas hands out, each to its student.

    Canvas takes it under *Upload submissions* and attaches a file, as a comment, to the submission
    whose file it has the number of, under the name which that file had. So each notebook answers
    the one of its problem that the student has handed in before.

    Parameters
    ----------
    folder : path
        Folder of all homeworks.
    name : str
        The homework's, whose folders are written and whose table names students by Canvas's "ID".
    download : path
        What *Download submissions* gave: the notebooks as they were handed out to all.
    roster : Roster, optional
        The class, by which a file name is understood that can be read in two ways.

    Returns
    -------
    path : pathlib.Path
        The archive.
    students : list of str
        Those of the homework for whom it holds nothing.

    Raises
    ------
    InputError
        If the download has a notebook of none of the students.
    """
    target = Path(folder) / name
    table, names = numbers.read(target / numbers.NAME), {}
    for path, student, file in named_files(download, roster):
        problem = number_of_name(PurePosixPath(file).stem)
        own = target / FOLDER / student / file_name(problem) if problem else None
        if student in table and own is not None and own.is_file():
            names[path.rpartition("/")[2]] = student, own
    if not names:
        raise InputError(f"{download} has a notebook of the homework of none of its students")
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as file:
        for name_in_canvas, (_, own) in sorted(names.items()):
            file.write(own, name_in_canvas)
    put_bytes(target / "canvas.zip", archive.getvalue())
    reached = {student for student, _ in names.values()}
    return target / "canvas.zip", [student for student in table if student not in reached]
