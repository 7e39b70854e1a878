"""Fingerprint: one hash of all that a stored result depends on besides the notebook.

When it changes, the notebook is graded again.
"""

import hashlib
import json

from workbook.grading.sandbox.preloading import JUDGING_MODULES
from workbook.mistakes import mistakes_file
from workbook.notebooks import exercises
from workbook.notebooks.dependencies import module_closure


def fingerprint(exercise):
    """Return the hash of what judges the answers of an exercise.

    This is its data and check cells, its named mistakes, the `checks.py` of its course if it uses a
    check of that, and all modules of ours that these import or that run and judge a notebook.
    """
    cells, mistakes = exercise.code("data", "check"), mistakes_file(exercise.path)
    own = (
        exercises.home_of(exercise.number).checks.read_text("utf-8") if exercise.own_checked else ""
    )
    closure = module_closure("\n".join([JUDGING_MODULES, *(source for _, source in cells), own]))
    return hashlib.sha256(
        json.dumps(
            [
                cells,
                mistakes.read_text(encoding="utf-8") if mistakes.is_file() else "",
                own,
                closure,
            ],
            sort_keys=True,
        ).encode()
    ).hexdigest()
