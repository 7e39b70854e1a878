"""Estimate the time that a problem takes, from its level and the number of its answers.

Reading and setting up take `SET_UP` minutes, each of the first answers `MINUTES`, and each further one
half of it, since the answers of one problem repeat a method. It is a rule, not a measurement.

>>> minutes("core", 3), minutes("advanced", 7)
(34, 82)
>>> study_time("core", ["a_region", "b_region", "b_names"])
'about 30 min'
>>> study_time("advanced", ["a_rank", "b_rank", "b_basis", "c_rank", "d_rank", "e_rank", "f_rank"], core=["a", "b"])
'about 50 min for the core, 1½ h for all'
"""

import math

from workbook.authoring.contract import item_of

SET_UP = 10
#: Minutes for an answer, its reasoning and its code, for a student who has read the section.
MINUTES = {"core": 8, "advanced": 13, "starred": 20}
#: So many answers take their whole time.
WHOLE = 4


def minutes(level, answers):
    """Return the estimated minutes for a number of answers of one problem."""
    return SET_UP + math.ceil(MINUTES[level] * (min(answers, WHOLE) + max(answers - WHOLE, 0) / 2))


def rounded_minutes(level, answers):
    """Return these minutes as routes and homework give them, to five minutes."""
    return 5 * round(minutes(level, answers) / 5)


def study_time(level, answers, core=()):
    """Return the time in words; with `core` items, the time for these and for all."""
    total = _in_words(minutes(level, len(answers)))
    if not core:
        return f"about {total}"
    core_time = _in_words(minutes(level, sum(item_of(name) in core for name in answers)))
    return f"about {core_time} for the core, {total} for all"


def _in_words(minutes):
    if minutes < 55:
        return f"{10 * round(minutes / 10)} min"
    halves = round(minutes / 30)
    return f"{halves // 2}{'½' * (halves % 2)} h"
