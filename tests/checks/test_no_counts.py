"""A message never tells how many values, points or vectors there are: of an answer with one left
out it says the same whatever is left, and a wrong yes or no learns that something is there and not
how much."""

import re

import pytest
from case import check_named
from case_tables import CASES

#: A count of what is asked for, as it could stand in a message.
COUNT = re.compile(
    r"(?<!more than )\b(\d+|two|three|four) (of them|of which|of these|values?|equilibria|"
    r"stationary points|angles|circles|independent(?! motions were asked for))|"
    r"\b(finds|holds|names|are) \d+\b|\bof \d+\b"
)
SEVERAL = [
    case
    for case in CASES
    if case.verdict == "right"
    and isinstance(case.answer, (list, tuple, dict, set))
    and len(case.answer) > 1
]
YES_NO = [case for case in CASES if case.verdict == "wrong" and isinstance(case.answer, bool)]


def said(case, answer):
    return check_named(case.check)(answer, *case.data, **dict(case.options))


@pytest.mark.parametrize("case", SEVERAL, ids=lambda case: f"{case.check}: {case.note}")
def test_one_member_left_out(case):
    fewer = (
        dict(list(case.answer.items())[:-1])
        if isinstance(case.answer, dict)
        else list(case.answer)[:-1]
    )
    verdict = said(case, fewer)
    assert verdict.status != "wrong" or not COUNT.search(verdict.message), verdict.message


@pytest.mark.parametrize("case", YES_NO, ids=lambda case: f"{case.check}: {case.note}")
def test_a_wrong_yes_or_no(case):
    message = said(case, case.answer).message
    assert not COUNT.search(message), message
