"""The tables of cases: what each check accepts and rejects, row by row."""

import functools
import inspect
from collections import Counter

import pytest
from case import CHECKS, REFUSED, check_named
from case_tables import CASES, LONG, TABLES

from workbook.checks.contract.data_kinds import RECORDS
from workbook.checks.contract.few_numbers import MOST_NUMBERS, numbers_in
from workbook.checks.contract.shapes import COMMON, LIST_OR_RANGES, SHAPES
from workbook.checks.contract.verdict import UnsuitableData


def rows(long):
    """Return the rows of the tables of long themes, or of all others."""
    return [
        pytest.param(case, id=f"{case.check}: {case.note}")
        for name, table in TABLES.items()
        if (name.partition(".")[0] in LONG) == long
        for case in table.CASES
    ]


@pytest.mark.parametrize("case", rows(long=False))
def test_case(case):
    _judge(case)


@pytest.mark.slow
@pytest.mark.parametrize("case", rows(long=True))
def test_long_case(case):
    _judge(case)


def _judge(case):
    judge = functools.partial(
        check_named(case.check), case.answer, *case.data, **dict(case.options)
    )
    if case.verdict == REFUSED:
        with pytest.raises((UnsuitableData, TypeError), match=r"^\w.{10}"):
            judge()
        return
    verdict = judge()
    assert verdict.status == case.verdict, verdict.message
    assert len(verdict.message) > 10
    own = numbers_in(str(case.answer))
    assert len([n for n in numbers_in(verdict.message) if n not in own]) <= MOST_NUMBERS, (
        verdict.message
    )
    assert "is another one" not in verdict.message, "it names the property that fails"


def test_every_check_has_its_table():
    rows = Counter((case.check, case.verdict) for case in CASES)
    least = {"right": 2, "wrong": 2, "invalid": 1}
    assert [
        f"{name}: {rows[name, verdict]} of {number} {verdict}"
        for name in CHECKS
        for verdict, number in least.items()
        if rows[name, verdict] < number
    ] == []
    assert all(table.LIMITS is not None for table in TABLES.values())


@pytest.mark.parametrize("theme", SHAPES)
def test_every_check_of_a_theme_documents_the_shapes_of_its_data(theme):
    shapes, used = SHAPES[theme], set()
    for name in CHECKS:
        check = check_named(name)
        if check.__module__.split(".")[-2] == theme:
            names = list(inspect.signature(check).parameters)[1:]
            lines = dict(line.strip().partition(" : ")[::2] for line in check.__doc__.splitlines())
            # a check may take other records, or parameters in another form, than most of its theme
            assert all(
                lines[argument] == shapes[argument]
                or lines[argument] in (COMMON["parameters"], LIST_OR_RANGES)
                or any(record in lines[argument] for record in RECORDS)
                for argument in names
            ), name
            used |= set(names)
    assert set(shapes) - set(COMMON) <= used, "shapes of no check's data"
