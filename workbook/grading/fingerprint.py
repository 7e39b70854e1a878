"""What a stored result depends on besides the notebook, as one hash: when it changes, the notebook
is graded again."""

import hashlib
import json

from workbook.mistakes import mistakes_file
from workbook.notebooks.dependencies import module_closure

#: What runs a notebook's cells, and reads and judges what they hand over.
JUDGES = "import workbook.notebooks.cells, workbook.grading.judging"


def fingerprint(exercise):
    """What a result depends on besides the notebook: the exercise's data and check cells, its named
    mistakes, the library under them, and the judge."""
    cells, mistakes = exercise.code("data", "check"), mistakes_file(exercise.path)
    closure = module_closure("\n".join([JUDGES, *(source for _, source in cells)]))
    return hashlib.sha256(
        json.dumps(
            [cells, mistakes.read_text(encoding="utf-8") if mistakes.is_file() else "", closure],
            sort_keys=True,
        ).encode()
    ).hexdigest()
