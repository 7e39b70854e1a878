"""The tables in `adversarial/`, whose rows are judged among the tests of their problems."""

from pathlib import Path

from adversarial.tables import ROWS

from workbook.authoring import master_paths

SOLUTIONS = Path(__file__).resolve().parents[2] / "solutions"


def test_a_row_stands_once_under_a_problem_and_says_why():
    assert len({row[:3] for row in ROWS}) == len(ROWS)
    assert all(len(row.reason) > 5 for row in ROWS)
    problems = {f"{path.parent.name[2:]}.{int(path.stem[1:])}" for path in master_paths(SOLUTIONS)}
    assert {row.problem for row in ROWS} <= problems


def test_the_table_is_large_enough():
    due = [row.due for row in ROWS]
    assert due.count("wrong") >= 150 and due.count("right") >= 120
    assert len({row.problem for row in ROWS}) >= 80
