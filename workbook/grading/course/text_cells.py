"""Text cells: what students wrote in the cells of a notebook that are no code."""

import re
from functools import cache
from pathlib import Path

from workbook.grading.sandbox import submitted_file
from workbook.grading.sandbox.sanitising import normalise_name, sanitise
from workbook.notebooks import exercises

#: A link, which a notebook that was handed out has or has not.
LINK = re.compile(r"\[([^\]]*)\]\([^)]*\)")


def read(submitted, assignment):
    """Return {student: [(file, texts of its own)]} of a homework's notebooks.

    The texts are those of cells that the notebook did not have when it was handed out, or that were
    changed. Files that cannot be read are left out here; `submissions.find` reports them.
    """
    texts = {}
    for path in sorted(Path(submitted).glob("*/*/*.ipynb")):
        student, homework = (normalise_name(part) for part in path.parts[-3:-1])
        if homework != assignment or any(parent.is_symlink() for parent in path.parents[:2]):
            continue
        try:
            content = submitted_file.content(path)
            cells = submitted_file.text_cells(content)
            number, *_ = submitted_file.notebook(content)
        except (OSError, submitted_file.UnreadableFileError):
            continue
        number = number or submitted_file.number_of_name(path.stem)
        pristine = _pristine(number)
        own = [
            sanitise(cell, keep="\n\t")
            for cell in cells
            if cell.strip() and _plain(cell) not in pristine
        ]
        if own:
            texts.setdefault(student, []).append((path.name, own))
    return texts


@cache
def _pristine(number):
    """Return the plain texts of the cells of an exercise that are no code."""
    try:
        path = exercises.find(number or "").path
    except exercises.UnknownExercise:
        return frozenset()
    return frozenset(map(_plain, submitted_file.text_cells(path.read_bytes())))


def _plain(text):
    return " ".join(LINK.sub(r"\1", text).split())
