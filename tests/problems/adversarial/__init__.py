"""Answers by somebody who did not write the masters: believable wrong ones and right ones in
unusual forms, each settled by mathematics before a check had seen it. A row says the problem, the
answer, its code in the names of the data cell, and why it is wrong or right."""

from typing import NamedTuple


class Row(NamedTuple):
    problem: str
    name: str
    code: str
    due: str
    reason: str


def wrong(problem, name, code, reason):
    return Row(problem, name, code, "wrong", reason)


def right(problem, name, code, reason):
    return Row(problem, name, code, "right", reason)
