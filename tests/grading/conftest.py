"""Fixtures of tests about verdicts and points: a homework, and a store of results."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment

from workbook.grading.course.store import Store

#: Their tests wait: for sandboxes, worker processes, whole commands, a browser, limits of time.
WAITING = {
    "test_between_sandboxes",
    "test_budgets",
    "test_cluster",
    "test_commands",
    "test_fairness",
    "test_gradescope",
    "test_hostile",
    "test_judging",
    "test_nothing_lost",
    "test_pages",
    "test_review",
    "test_sandbox",
}
HERE = Path(__file__).parent


def pytest_collection_modifyitems(items):
    for item in items:
        if HERE in item.path.parents and item.path.stem in WAITING:
            item.add_marker(pytest.mark.waits)


@pytest.fixture
def homework(request, tmp_path):
    """The assignment that the test's module has as `HOMEWORK`."""
    return an_assignment(tmp_path, request.module.HOMEWORK)


@pytest.fixture
def store(tmp_path):
    """An empty store of verdicts, open."""
    with Store(tmp_path / "graded" / "grades.sqlite") as opened:
        yield opened
