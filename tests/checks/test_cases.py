"""The tables of cases: what each check accepts and rejects, row by row."""

import functools
import importlib.util
import inspect
from pathlib import Path

import pytest
from case import CHECKS, REFUSED, check_named

from workbook.checks.contract.data_kinds import RECORDS
from workbook.checks.contract.few_numbers import MOST_NUMBERS, numbers_in
from workbook.checks.contract.shapes import COMMON, LIST_OR_RANGES, SHAPES
from workbook.checks.contract.verdict import UnsuitableData

TABLES = sorted((Path(__file__).parent / "cases").glob("*/*.py"))


def _load(path):
    spec = importlib.util.spec_from_file_location(f"cases_{path.parent.name}_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


MODULES = {f"{path.parent.name}.{path.stem}": _load(path) for path in TABLES}
CASES = [case for module in MODULES.values() for case in module.CASES]
#: Themes whose checks look for optima and follow motions: two thirds of the time of all cases.
LONG = {"pontryagin"}


def rows():
    for name, module in MODULES.items():
        marks = [pytest.mark.slow] if name.partition(".")[0] in LONG else []
        yield from (
            pytest.param(case, marks=marks, id=f"{case.check}: {case.note}")
            for case in module.CASES
        )


@pytest.mark.parametrize("case", list(rows()))
def test_case(case):
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


@pytest.mark.parametrize("name", CHECKS)
def test_every_check_has_its_table(name):
    verdicts = [case.verdict for case in CASES if case.check == name]
    assert (
        verdicts.count("right") >= 2 and verdicts.count("wrong") >= 2 and "invalid" in verdicts
    ), verdicts
    assert all(module.LIMITS is not None for module in MODULES.values())


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
