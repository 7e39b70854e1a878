"""Handing back: archives of pages that Moodle and Canvas give to their students, and a mail merge.

Moodle (*Upload multiple feedback files in a zip*) knows a file by NAME_NUMBER_assignsubmission_file_
before its name, Canvas (*Upload submissions*) by the numbers of the student and of the file that the
student handed in. Both stand in the ledger; a student who is not there, or of another system, is in
the table only.
"""

import io
import re
import zipfile

from workbook.grading.course.csv_files import BOM, quoted
from workbook.grading.reports.exporting import decimal, without_formula

FILE = "feedback.html"
MOODLE_MARK = "_assignsubmission_"


def archives(pages, entries):
    """Return {name of an archive: its bytes}, without those that would be empty.

    Parameters
    ----------
    pages : dict
        Page by student.
    entries : list of ledger.Entry
        The lines of the ledger on the homework.

    Returns
    -------
    dict
        The same bytes for the same pages.
    """
    names = {"feedback-moodle.zip": {}, "feedback-canvas.zip": {}}
    for entry in entries:
        if entry.student not in pages or not entry.source:
            continue
        if MOODLE_MARK in entry.source:
            name = f"{entry.name.replace('_', ' ')}_{entry.number}{MOODLE_MARK}file_{FILE}"
            names["feedback-moodle.zip"][entry.student] = name
        elif prefix := _canvas_prefix(entry):
            # The last line: Canvas attaches a page to the file that was handed in last.
            names["feedback-canvas.zip"][entry.student] = prefix + FILE
    return {
        archive: _zip({name: pages[student] for student, name in of_students.items()})
        for archive, of_students in names.items()
        if of_students
    }


def mail_merge(scores, entries, page_names):
    """Return a table with a row for each student: address, name, points and page.

    The points of a student who still waits for a lecturer's look are empty.
    """
    names = {entry.student: entry.name for entry in entries if entry.name}
    header = ["address", "name", "student", "points", "max", "handed in", "page"]
    rows = [
        [
            score.student if "@" in score.student else "",
            names.get(score.student, ""),
            score.student,
            "" if score.needs_review else decimal(score.points),
            decimal(score.max_points),
            "yes" if score.handed_in else "no",
            page_names[score.student],
        ]
        for score in scores
    ]
    return BOM + quoted([header, *(map(without_formula, row) for row in rows)])


def _canvas_prefix(entry):
    """Return what Canvas writes before the name of a file, "" if it did not name this one."""
    for part in entry.source.split("/"):
        if match := re.match(rf"(?:.*?_)?{re.escape(entry.number)}_\d+_", part):
            return match[0]
    return ""


def _zip(files):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", compresslevel=1) as archive:
        for name, text in files.items():
            # Without the time, so that unchanged pages give an unchanged archive.
            archive.writestr(
                zipfile.ZipInfo(name),
                text.encode("utf-8", "backslashreplace"),
                zipfile.ZIP_DEFLATED,
            )
    return content.getvalue()
