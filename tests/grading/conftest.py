"""What tests about verdicts and points share: a homework as its module describes it, and a store of results."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment  # noqa: E402

from trajlib.grading.store import Store  # noqa: E402


@pytest.fixture
def homework(request, tmp_path):
    """The assignment that the test's module writes down as `HOMEWORK`."""
    return an_assignment(tmp_path, request.module.HOMEWORK)


@pytest.fixture
def store(tmp_path):
    """An empty store of verdicts, open."""
    with Store(tmp_path / "graded" / "grades.sqlite") as opened:
        yield opened
