"""Every row of the tables in `adversarial/` has the verdict that mathematics gives it, from the check cell and the data
of its problem alone."""

from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from adversarial import ch1, ch2, ch3, ch4, ch5, ch5_later, ch5_near, ch5_processes, ch5_quadratic, ch5_syntheses, ch6_7
from harness import alone, data_of

from trajlib import checks
from trajlib.checks.contract.encoding import decode, encode
from trajlib.execution import in_child
from trajlib.masters import read

SOLUTIONS = Path(__file__).resolve().parents[2] / "solutions"
CHAPTERS = ch1, ch2, ch3, ch4, ch5, ch5_syntheses, ch5_processes, ch5_later, ch5_quadratic, ch5_near, ch6_7
ROWS = [row for chapter in CHAPTERS for row in chapter.ROWS]


@pytest.mark.slow
@pytest.mark.parametrize("problem", dict.fromkeys(row.problem for row in ROWS))
def test_every_verdict_is_the_one_due(problem):
    rows = [row for row in ROWS if row.problem == problem]
    chapter, number = problem.split(".")
    master = read(SOLUTIONS / f"ch{chapter}" / f"p{int(number):02d}.md")
    assert [row.name for row in rows if row.name not in master.answers] == [], "no answers of this problem"
    verdicts = in_child(_verdicts, master, rows, timeout=120)
    assert [f"{row.name} = {row.code} is {status}, though {row.reason}: {message}"
            for row, (status, message) in zip(rows, verdicts) if status != row.due] == []
    assert all(len(message) > 20 for status, message in verdicts)


def _verdicts(master, rows):
    """(status, message) of each row: the data cell is executed once."""
    data, cells, found = data_of(master), alone(master), []
    for row in rows:
        value = decode(encode(eval(row.code, data | {"np": np, "sp": sp})))
        with checks.collecting() as verdicts:
            exec(cells[row.name], data | {row.name: value})
        found.append((verdicts[row.name].status, verdicts[row.name].message))
    return found


def test_a_row_stands_once_and_says_why():
    assert len({row[:3] for row in ROWS}) == len(ROWS)
    assert all(len(row.reason) > 5 for row in ROWS)


def test_the_table_is_large_enough():
    due = [row.due for row in ROWS]
    assert due.count("wrong") >= 150 and due.count("right") >= 120
    assert len({row.problem for row in ROWS}) >= 80
