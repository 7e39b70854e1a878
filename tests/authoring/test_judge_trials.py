"""The common mistakes of a problem's page (book/judge_trials.py): selection, pictures, cache."""

import json
import shutil
import sys
from pathlib import Path

import pytest
import sympy as sp

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "book"))
import judge_trials
from judge_trials import Mistake

from workbook.authoring.master import read_all, read_master
from workbook.authoring.mistakes import mistake_sentence
from workbook.authoring.trials import trials_file

ROOT = Path(__file__).resolve().parents[2]
x, y, z = sp.symbols("x y z", real=True)


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    """A book of problem 1.15 alone, whose mistakes have been judged."""
    root = tmp_path_factory.mktemp("book")
    for name in ("_config.yml", "requirements.txt"):
        shutil.copy(ROOT / name, root)
    page = root / "solutions" / "ch1" / "p15.md"
    page.parent.mkdir(parents=True)
    for path in (page, trials_file(page)):
        shutil.copy(ROOT / path.relative_to(root), path)
    assert judge_trials.main(root) == 0
    return root


@pytest.fixture
def region_mistakes(book):
    text = (book / "_build" / "mistakes" / "ch1" / "p15.json").read_text(encoding="utf-8")
    return json.loads(text)["checks"][0][0]


def test_a_mistake_has_its_verdict_and_its_question(book, region_mistakes):
    assert region_mistakes["answer"] == "a_region"
    first = region_mistakes["mistakes"][0]
    assert first["code"] == "a_region = sp.And(k1 > 0, k2 > 0)"
    assert first["message"].startswith("the point k1 = 1, k2 = 1/2 lies inside your region")
    assert first["question"].endswith("Which minor was not looked at?")  # without the hint
    assert "<svg" in (book / "_build" / "mistakes" / "ch1" / first["picture"]).read_text()


def test_a_rebuild_judges_what_changed(book, capsys):
    assert judge_trials.main(book) == 0
    assert "up to date" in capsys.readouterr().out
    trials = trials_file(book / "solutions" / "ch1" / "p15.md")
    trials.write_text(trials.read_text() + "\n# nothing else\n")
    assert judge_trials.main(book) == 0
    assert "trials of 0 of 1 problems" in capsys.readouterr().out
    trials.write_text(trials.read_text().replace("Are positive", "Why are positive", 1))
    assert judge_trials.main(book) == 0
    assert "trials of 1 of 1 problems" in capsys.readouterr().out


def test_a_trial_that_is_not_wrong_ends_the_build(book, tmp_path, capsys):
    root = shutil.copytree(book, tmp_path / "book")
    trials = trials_file(root / "solutions" / "ch1" / "p15.md")
    trials.write_text(trials.read_text().replace("(k1 > 0, k2 > 0)", "(k1 > 0, k1*k2 > 1)", 1))
    assert judge_trials.main(root) == 1
    assert "a wrong trial of a_region is right" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("messages", "selected"),
    [
        (["at 1", "at 2", "no root"], [0, 2]),  # the same message at another point
        (["at 1", "at 2", "at 3"], [0, 1]),  # two at least
        (["a", "b", "c", "d", "e"], [0, 1, 2, 3]),  # four at most
        (["a"], [0]),
    ],
)
def test_different_messages_are_selected_first(messages, selected):
    mistakes = [Mistake(str(k), message, "") for k, message in enumerate(messages)]
    assert judge_trials.select(mistakes) == [mistakes[k] for k in selected]


@pytest.mark.parametrize(
    ("value", "drawn"),
    [
        (sp.And(x > 0, y < 1), True),
        ([x > 0, x * y > 1], True),
        (sp.true, True),
        (sp.Ne(x, y), False),  # all but a line: nothing to hatch
        (sp.And(x > 0, z > 0), False),
        (x + y, False),
        ([x, y], False),
        ([[1, 0], [0, 1]], False),
        (sp.Interval(0, 1), False),
    ],
)
def test_conditions_of_two_parameters_are_drawn(value, drawn):
    assert judge_trials.is_region(value, {"x": "1", "y": "0"}) == drawn


def test_worked_answers_are_not_shown_as_code():
    master = read_master(ROOT / "solutions" / "ch1" / "p15.md")
    judge = judge_trials.Judge(master)
    (trial,) = [t for t in master.trials["right"] if t.source.startswith("p, q")]
    typed = judge._typed(trial, [x > 0, x * y - 1 > 0])
    assert typed == "a_region = [x > 0, x*y - 1 > 0]"


def test_the_students_notebooks_hold_no_question():
    for master in read_all(ROOT / "solutions"):
        text = master.exercise.read_text(encoding="utf-8")
        for trial in master.trials["wrong"]:
            question = (mistake_sentence(master, trial) or "").partition("\n")[0]
            assert not question or question not in text, (master.number, question)
