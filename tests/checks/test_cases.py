"""The tables of cases: what each check accepts and rejects, row by row."""

import importlib.util
from pathlib import Path

import pytest

from trajlib import checks

TABLES = sorted((Path(__file__).parent / "cases").glob("*/*.py"))
NOT_CHECKS = {"NotYet", "Unusable", "Verdict", "collecting", "judged", "report"}


def _load(path):
    spec = importlib.util.spec_from_file_location(f"cases_{path.parent.name}_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


MODULES = {f"{path.parent.name}.{path.stem}": _load(path) for path in TABLES}
CASES = [case for module in MODULES.values() for case in module.CASES]


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.check}: {case.note}")
def test_case(case):
    verdict = getattr(checks, case.check)(case.answer, *case.data, **dict(case.options))
    assert verdict.status == case.verdict, verdict.message
    assert len(verdict.message) > 10


@pytest.mark.parametrize("name", sorted(set(dir(checks)) - NOT_CHECKS))
def test_every_check_has_its_table(name):
    verdicts = [case.verdict for case in CASES if case.check == name]
    assert verdicts.count("right") >= 2 and verdicts.count("wrong") >= 2 and "invalid" in verdicts, verdicts
    assert all(module.LIMITS is not None for module in MODULES.values())
