"""Estimate the time that a problem takes, from its level and the number of its answers.

>>> study_time("core", ["a_region", "b_region", "b_names"])
'about 20 min'
>>> study_time("advanced", ["a_rank", "b_rank", "b_basis", "c_rank", "d_rank", "e_rank", "f_rank"], core=["a", "b"])
'about 30 min for the core, 1 h for all'
"""

from workbook.authoring.contract import item_of

#: Minutes for an answer, its reasoning and its code, for a student who has read the section.
MINUTES = {"core": 6, "advanced": 9, "starred": 15}


def study_time(level, answers, core=()):
    """Return the time in words; with `core` items, the time for these and for all."""
    total = _in_words(MINUTES[level] * len(answers))
    if not core:
        return f"about {total}"
    core_time = _in_words(MINUTES[level] * sum(item_of(name) in core for name in answers))
    return f"about {core_time} for the core, {total} for all"


def _in_words(minutes):
    if minutes < 55:
        return f"{max(10, 10 * round(minutes / 10))} min"
    halves = round(minutes / 30)
    return f"{halves // 2}{'½' * (halves % 2)} h"
