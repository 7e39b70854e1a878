"""One row of a check's table of cases: the table is the check's test and its page in the book."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Case:
    check: str
    answer: object
    data: tuple
    verdict: str
    note: str
    options: tuple = ()
