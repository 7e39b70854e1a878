"""Hooks: a lower layer calls them, a higher one fills them (`workbook/__init__.py`)."""

from collections.abc import Callable


def _no_sentence(problem, answer, value):
    return ""


#: The sentence on a wrong value of an answer of a problem, "" if there is none; `checks.report` shows it.
find_mistake: Callable[[str, str, object], str] = _no_sentence
