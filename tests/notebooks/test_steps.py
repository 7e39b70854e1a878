"""The cells below an exercise that check the steps of work on paper count for nothing."""

import pytest

from workbook.notebooks import exercises
from workbook.notebooks.execution import judge, run_notebook

EXERCISE = exercises.find("1.15")
(_, STUB), (_, CHECK) = EXERCISE.code("steps")


def _verdicts(*steps):
    cells = [source for _, source in EXERCISE.code("data", "check")]
    cells[1:1] = ["a_region = (k1 > 0) & (k1*k2 > 1)"]
    sources = EXERCISE.sources_to_run([*cells, *steps])
    names = EXERCISE.about["answers"]
    run = run_notebook(sources, names, timeout=60)
    verdicts = judge(EXERCISE.code("data", "check"), run, names)
    return {name: verdict.status for name, verdict in verdicts.items()}, run.errors


def test_every_exercise_has_them():
    assert all(
        [source for _, source in exercise.code("steps")] == [STUB, CHECK]
        for exercise in exercises.read_all()
    )


@pytest.mark.parametrize(
    "steps",
    [
        (STUB, CHECK),
        ("my_steps = [k1 > 0, k1 > 1]", CHECK),
        ("my_steps = [k1 > 0, k1 > 0]", CHECK),
        ("my_steps = [k1 >", CHECK),
    ],
)
def test_answers_are_judged_as_without_them(steps):
    assert _verdicts(*steps)[0] == _verdicts()[0]


def test_untouched_cells_do_not_run():
    assert EXERCISE.sources_to_run([STUB, CHECK]) == ["", ""]
    assert _verdicts(STUB, CHECK) == _verdicts()
