"""Text cells: what students wrote in the cells of a notebook that are no code."""

from functools import cache
from pathlib import Path

from workbook.grading.course import handing_out
from workbook.grading.sandbox import submitted_file
from workbook.grading.sandbox.sanitising import normalise_name
from workbook.notebooks import exercises
from workbook.numbering import number_of_name


def read(submitted, assignment):
    """Return {student: [(file, texts of its own)]} of the notebooks of an `Assignment`.

    The texts are those of cells that the notebook did not have when it was handed out, or that were
    changed. Files that cannot be read are left out here; `submissions.find` reports them.
    """
    texts = {}
    with submitted_file.Reader() as reader:
        for path in sorted(Path(submitted).glob("*/*/*.ipynb")):
            student, homework = (normalise_name(part) for part in path.parts[-3:-1])
            if homework != assignment.name or any(
                parent.is_symlink() for parent in path.parents[:2]
            ):
                continue
            try:
                number, cells = reader.text(submitted_file.content(path))
            except (OSError, submitted_file.UnreadableFileError):
                continue
            number = number or number_of_name(path.stem)
            pristine = _pristine(number) | _handed_out(assignment, str(number).partition("~")[0])
            own = [text for cell, text in cells if cell not in pristine]
            if own:
                texts.setdefault(student, []).append((path.name, own))
    return texts


def _handed_out(assignment, problem):
    """Return the hash of the text that only the notebooks of this homework or exam have."""
    text = problem in assignment.problems and handing_out.instruction(assignment, problem)
    return frozenset({submitted_file.text_hash(text)} if text else ())


@cache
def _pristine(number):
    """Return the hashes of the cells of an exercise that are no code."""
    try:
        path = exercises.find(number or "").path
    except exercises.UnknownExercise:
        return frozenset()
    return frozenset(map(submitted_file.text_hash, submitted_file.text_cells(path.read_bytes())))
