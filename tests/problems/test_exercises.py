"""An untouched notebook is judged missing; that it matches its master is a rule of `test_rules.py`."""

import pytest

from workbook.notebooks import exercises
from workbook.notebooks.execution import judge, run_notebook

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("exercise", exercises.read_all(), ids=lambda exercise: exercise.number)
def test_untouched_is_missing(exercise):
    answers = exercise.about["answers"]
    stubs = [source for _, source in exercise.code("data", "answer")]
    run = run_notebook(stubs, answers)
    assert run.errors == ()
    verdicts = judge(exercise.code("data", "check"), run, answers)
    assert {name: verdict.status for name, verdict in verdicts.items()} == dict.fromkeys(
        answers, "missing"
    )
