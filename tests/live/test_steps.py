"""The worked solutions in steps, for every master."""

from pathlib import Path

import pytest

from workbook.authoring import read_all
from workbook.live.steps import CODE, FIGURE, TEXT, solution_steps

pytestmark = pytest.mark.slow
ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def masters():
    return read_all(ROOT / "solutions")


def test_every_answer_begins_with_text_and_every_cell_is_one_step(masters):
    for master in masters:
        steps = solution_steps(master)
        assert set(steps) == set(master.answers), master.number
        together = [step for group in dict.fromkeys(steps.values()) for step in group]
        assert sorted(step.text for step in together if step.kind != TEXT) == sorted(
            master.code("answer", "figure")
        )
        for name, group in steps.items():
            assert group[0].kind == TEXT, f"{master.number} {name}"
            assert CODE in {step.kind for step in group}


def test_no_formula_is_split(masters):
    for master in masters:
        for group in solution_steps(master).values():
            for step in group:
                if step.kind == TEXT:
                    assert step.text.count("$$") % 2 == 0 and step.text.count("```") % 2 == 0, (
                        step.text
                    )


def test_the_order_of_an_item(masters):
    master = next(master for master in masters if master.number == "1.15")
    kinds = [step.kind for step in solution_steps(master)["a_region"]]
    assert kinds == [TEXT] * 4 + [CODE, FIGURE, TEXT]
    assert "The region lies above" in solution_steps(master)["a_region"][3].text
