"""The page that a lecturer chooses a check from (book/guides/checks.md)."""

import re
from pathlib import Path

import pytest
from case import CHECKS

from workbook import checks

GUIDE = (Path(__file__).parents[2] / "book/guides/checks.md").read_text("utf-8")
CHOICE, OWN = GUIDE.split("## Choosing a check")[1].split("## A check of your own")


def test_the_table_names_every_check_of_the_course_once():
    rows = [line.split("|")[2] for line in CHOICE.splitlines() if line.count("|") == 3]
    named = re.findall(r"`(\w+)`", "".join(rows))
    assert sorted(named) == [name for name in CHECKS if not name.startswith("research.")]


@pytest.mark.parametrize(
    "answer, status",
    [("length*sp.sin(q)", "right"), ("length*sp.cos(q)", "wrong"), ("length", "wrong")],
)
def test_the_check_of_the_page_judges(answer, status):
    check, report = re.findall(r"```python\n(.*?)```", OWN, re.S)
    names = {"__name__": "exercise"}
    exec(f"{check}\na_height = {answer}", names)
    with checks.collecting() as verdicts:
        exec(report, names)
    assert verdicts["a_height"].status == status
