"""Mistakes that are named: what a wrong answer that was foreseen may have come from, in a sentence
to its giver.

The masters hold wrong answers, each with its misconception. Of those a student's copy gets, beside
the notebook, only fingerprints (`sealing`) of what they are whatever their form (`signature`): an
answer that a check has found wrong is looked up there, and opens the sentence that was written for
it.
"""

import json

from workbook.notebooks import exercises


def name_of(problem, answer, value):
    """The sentence for a wrong value of an answer, with a hint below it if one belongs to it; "" if
    there is none."""
    from workbook.mistakes.sealing import find
    from workbook.mistakes.signature import Question, Unlike, signatures

    file = file_beside(exercises.place(problem))
    asked = (
        json.loads(file.read_text(encoding="utf-8"))["answers"].get(answer)
        if file.is_file()
        else None
    )
    if asked is None:
        return ""
    try:
        return find(
            asked["told"],
            f"{problem} {answer}",
            signatures(value, Question(asked["kind"], asked["symbols"])),
        )
    except Unlike:
        return ""


def file_beside(notebook):
    """Where the sealed mistakes of a problem stand: p15.mistakes beside p15.ipynb."""
    return notebook.with_suffix(".mistakes")
