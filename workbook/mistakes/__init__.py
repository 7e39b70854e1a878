"""Named mistakes: the sentence on a wrong answer that was foreseen.

The masters hold wrong answers, each with its misconception. The student notebooks come with files
of sealed sentences only (`sealing`), found and opened by the signature of the wrong answer, which
does not depend on its form (`signature`).
"""

import json

from workbook.checks.contract.former_names import with_former_names
from workbook.notebooks import exercises

#: The sealed mistakes that a page brought along, by problem; elsewhere they are beside the notebooks.
brought: dict[str, dict] = {}


def find_mistake(problem, answer, value):
    """Return the sentence on a wrong value of an answer.

    Parameters
    ----------
    problem : str
        Number of the problem.
    answer : str
        Name of the answer.
    value
        The wrong value, as a check receives it.

    Returns
    -------
    str
        The sentence, perhaps with a hint on a second line; "" if there is none.
    """
    # SymPy, and only for wrong answers
    from workbook.mistakes.sealing import find
    from workbook.mistakes.signature import AnswerType, NoSignature, signatures

    known = brought[problem] if problem in brought else _stored(problem)
    # the check cell of an earlier notebook has the former name
    answer = next((name for name in known if answer in (name, with_former_names(name))), None)
    if answer is None:
        return ""
    mistakes = known[answer]
    answer_type = AnswerType(mistakes["kind"], mistakes["symbols"])
    try:
        return find(mistakes["told"], f"{problem} {answer}", signatures(value, answer_type))
    except NoSignature:
        return ""


def _stored(problem):
    """Return the sealed mistakes beside the notebook of a problem: what is known of each answer."""
    try:
        return read_sealed(exercises.path_of(problem))
    except exercises.UnknownExercise:  # a notebook of another edition
        return {}


def read_sealed(notebook):
    """Return the sealed mistakes beside a student notebook, {} if there are none."""
    file = mistakes_file(notebook)
    return json.loads(file.read_text(encoding="utf-8"))["answers"] if file.is_file() else {}


def mistakes_file(notebook):
    """Return the file of the sealed mistakes of a student notebook: p15.mistakes of p15.ipynb."""
    return notebook.with_suffix(".mistakes")
