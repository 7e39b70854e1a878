"""Notebooks that were handed out before answers were renamed are judged by their former names."""

import json

from workbook import page
from workbook.checks.contract.check_cells import marked
from workbook.checks.contract.former_names import with_former_names
from workbook.mistakes import find_mistake
from workbook.notebooks import exercises
from workbook.notebooks.execution import judge, run_notebook

EXERCISE = exercises.find("2.3")


def former_cells(answers):
    """Return the code of a notebook as it was handed out, with answers in place of the stubs."""
    return [
        *(with_former_names(source) for _, source in EXERCISE.code("data")),
        *answers,
        *(with_former_names(source) for _, source in EXERCISE.code("check")),
    ]


def test_renamed_are_94_answers():
    names = [name for exercise in exercises.read_all() for name in exercise.about["answers"]]
    assert sum(with_former_names(name) != name for name in names) == 94


def test_the_command_and_the_grader_read_former_names():
    sources = EXERCISE.sources_to_run(former_cells(["a_unseen = [[0, 1]]", "b_unseen = [[1, 0]]"]))
    assert sources[-1] == marked(EXERCISE.code("check")[-1][1])
    names = EXERCISE.about["answers"]
    verdicts = judge(EXERCISE.code("data", "check"), run_notebook(sources, names), names)
    told = {
        name: verdict.status for name, verdict in verdicts.items() if verdict.status != "missing"
    }
    assert set(told) == {"a_unobservable_states", "b_unobservable_states"}
    # the mistake that a trial of the problem names is told, too
    assert any(verdict.mistake for verdict in verdicts.values())


def test_a_page_reads_former_names():
    data, check = EXERCISE.code("data")[0][1], EXERCISE.code("check")[0][1]
    now = page.run_cell([data, "a_unobservable_states = [[0, 1]]"], check)
    assert page.run_cell([data, "a_unseen = [[0, 1]]"], check)["verdicts"] == now["verdicts"]
    assert now["verdicts"]["a_unobservable_states"] in ("right", "wrong")


def test_the_check_cell_of_an_earlier_notebook_names_the_mistake():
    known = json.loads(EXERCISE.path.with_suffix(".mistakes").read_text(encoding="utf-8"))
    assert "a_unobservable_states" in known["answers"]
    told = find_mistake("2.3", "a_unobservable_states", [[0, 1]])
    assert told and find_mistake("2.3", "a_unseen", [[0, 1]]) == told


def test_a_cell_with_a_former_check_is_known():
    exercise = exercises.find("3.1")
    cells = [source for _, source in exercise.code("check")]
    former = [cell.replace("possible_degrees(", "possible_margins(") for cell in cells]
    assert former != cells
    assert exercise.sources_to_run(former) == exercise.sources_to_run(cells)
