"""Students' notebooks match their masters, hold no solutions, and are judged correctly."""

import base64
import functools
import json
import re
from pathlib import Path

import nbformat
import pytest

from workbook.authoring import Links, master_paths, read
from workbook.authoring.mistakes import source_hash
from workbook.authoring.student_notebook import baseurl, student_notebook
from workbook.mistakes import mistakes_file
from workbook.notebooks import exercises
from workbook.notebooks.execution import judge, run_notebook

pytestmark = pytest.mark.slow
ROOT = Path(__file__).resolve().parents[2]
PATHS = master_paths(ROOT / "solutions")
once = functools.cache(read)


@pytest.fixture(params=PATHS, ids=lambda path: f"{path.parent.name[2:]}.{int(path.stem[1:])}")
def master(request):
    return once(request.param)


@pytest.fixture(scope="module")
def links():
    return Links(ROOT, baseurl(ROOT))


def test_every_exercise_has_a_master():
    assert [e.path for e in exercises.read_all()] == [once(path).exercise for path in PATHS]


def test_in_step_with_its_master(master, links):
    written = json.loads(master.exercise.read_text(encoding="utf-8"))
    assert written == student_notebook(master, links), "run `workbook exercises`"
    nbformat.validate(written)
    assert [
        cell["metadata"] for cell in written["cells"] if not "".join(cell["source"]).strip()
    ] == [], "empty cells"


def test_holds_no_solution(master):
    text = master.exercise.read_text(encoding="utf-8")
    notebook = json.loads(text)
    cells = ["".join(cell["source"]) for cell in notebook["cells"]]
    trials = [trial.source for role in master.trials.values() for trial in role]
    for source in [*master.code("answer", "figure"), *trials]:
        for line in (line.strip() for line in source.split("\n")):
            if len(line) > 30 and line not in "\n".join(master.code("data", "check")):
                assert line not in "\n".join(cells), f"a line of the solution: {line}"
    assert not re.search(r"```\{|:label:|\{ref\}|solution-start", "\n".join(cells)), (
        "a directive was left"
    )


def test_mistakes_are_in_step_and_sealed(master):
    text = mistakes_file(master.exercise).read_text(encoding="utf-8")
    mistakes = json.loads(text)
    assert mistakes["of"] == source_hash(master), f"run `workbook exercises {master.number}`"
    assert set(mistakes["answers"]) <= set(master.answers)
    shown = text.encode() + b"".join(
        base64.b64decode(code)
        for asked in mistakes["answers"].values()
        for code in asked["told"].values()
    )
    for trial in master.trials["wrong"]:
        value = trial.source.rpartition("=")[2].strip()
        words = [part for part in re.split(r"(?<=[.?]) ", trial.comment) if len(part) > 10]
        hidden = len(value) > 8 and value not in master.answers  # whose names are known
        for readable in [*words, *([value] if hidden else [])]:
            assert readable.encode() not in shown, readable


def test_untouched_is_missing(master):
    exercise = exercises.find(master.number)
    stubs = [source for _, source in exercise.code("data", "answer")]
    run = run_notebook(stubs, master.answers)
    assert run.errors == ()
    verdicts = judge(exercise.code("data", "check"), run, master.answers)
    assert {v.status for v in verdicts.values()} == {"missing"}
