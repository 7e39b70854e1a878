"""The questions inside the theory: each self-test has three, and each block is proved."""

import re
import sys
from functools import cache
from pathlib import Path

import pytest

from workbook import checks
from workbook.checks.contract.encoding import describe

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "book" / "_ext"))
from workbook_site.self_tests import notebook_of, question_of, questions_of  # noqa: E402

#: Pages that have no frame (aims, self-test, summary, what comes next), and why.
WITHOUT_FRAME = {
    "ch5/test_problems": "a table made from the records of the library, no theory",
    "ch8/figures": "figures of the paper computed again, no theory",
    "ch9/figures": "figures of the paper computed again, no theory",
}
SECTIONS = [
    path
    for path in sorted((ROOT / "book").glob("ch*/*.md"))
    if f"{path.parent.name}/{path.stem}" not in WITHOUT_FRAME
]
#: Pages of worked examples: a whole case, one without its last step, and one as a question.
FADING = (
    "ch1/examples",
    "ch1/example_regions",
    "ch2/examples",
    "ch2/example_control",
    "ch3/observer_examples",
    "ch4/least_squares",
    "ch4/inertial_navigation",
    "ch5/example_integral",
    "ch5/example_circle",
    "ch5/singular_example",
    "ch5/state_constraints",
)
FRAME = (":::{admonition} After this section you can", "## Self-test", "## Summary", "## Next")


@cache
def _questions(path):
    return questions_of(path.read_text(encoding="utf-8"))


def _all_questions():
    pages = sorted((ROOT / "book").glob("ch*/*.md"))
    return [
        pytest.param(path, question, id=f"{path.parent.name}/{path.stem}-{question.name}")
        for path in pages
        for question in _questions(path)
    ]


def _judge(path, question, assignment):
    """Return the answer and its verdict, after the cells that the page runs before the check."""
    *before, check = _cells_up_to(path, question)
    names = {"__name__": "exercise"}
    for source in before:
        exec(source, names)
    exec(assignment, names)
    with checks.collecting() as verdicts:
        exec(check, names)
    return names[question.name], verdicts[question.name]


def _cells_up_to(path, question):
    for cell in notebook_of(_questions(path))["cells"]:
        if cell["metadata"]["tags"] == ["data"]:
            yield cell["source"]
        elif cell["source"] == question.check_cell:
            yield cell["source"]
            return


@pytest.mark.parametrize(("path", "question"), _all_questions())
def test_each_block_is_proved(path, question):
    right, verdict = _judge(path, question, question.answer[0])
    assert verdict.status == "right", verdict.message
    for assignment, _ in question.wrong:
        wrong, verdict = _judge(path, question, assignment)
        assert verdict.status == "wrong", verdict.message
        told = verdict.message.replace(describe(wrong), "")
        assert not re.search(rf"(?<![\w.]){re.escape(describe(right))}(?![\w.])", told), told


@pytest.mark.parametrize(("path", "question"), _all_questions())
def test_the_stub_is_not_answered(path, question):
    _, verdict = _judge(path, question, question.stub)
    assert verdict.status == "missing"


def test_only_pages_that_exist_are_left_out():
    assert all((ROOT / "book" / f"{page}.md").exists() for page in WITHOUT_FRAME)


def test_sections_and_questions_are_counted():
    assert len(SECTIONS) == 54
    for path in SECTIONS:
        text = path.read_text(encoding="utf-8")
        assert len(questions_of(text[text.index("## Self-test") :])) == 3, path.stem


@pytest.mark.parametrize("page", FADING)
def test_worked_examples_fade(page):
    """The second case lacks its last step, the third one is a question."""
    text = (ROOT / "book" / f"{page}.md").read_text(encoding="utf-8")
    examples = text[: text.index("## Self-test")]
    stages = ("**Second case.**", ":::{fold} The last step", "**Third case.**", ":::{self-test}")
    positions = [examples.find(stage) for stage in stages]
    assert -1 not in positions and positions == sorted(positions)
    assert len(questions_of(examples)) == 1


def test_a_section_has_its_frame():
    for path in SECTIONS:
        text = path.read_text(encoding="utf-8")
        positions = [text.find(part) for part in FRAME]
        assert -1 not in positions and positions == sorted(positions), path
        *_, summary, following = re.split(r"^## (?:Summary|Next)$", text, flags=re.M)
        assert len(re.findall(r"^- ", summary, re.M)) == 3, path
        assert "{problem}`" in following, path
        assert "?" in text[: positions[0]], f"{path} opens with its question"
        assert "\nYou need " in text[positions[0] : positions[1]], path


def test_names_of_a_page_differ():
    for path in SECTIONS:
        names = [question.name for question in _questions(path)]
        assert len(set(names)) == len(names), path


@pytest.mark.parametrize(
    ("left_out", "message"),
    [
        ("```python\n", "block of Python"),
        ("# %% check\n", "one answer, one check"),
        ("# %% wrong: Why?\nx = 2\n", "at least one wrong"),
        (": Why?", "why it is wrong"),
    ],
)
def test_incomplete_blocks_are_refused(left_out, message):
    block = (
        "Which?\n\n```python\n# %% answer: a number\nx = 1\n# %% wrong: Why?\nx = 2\n"
        "# %% check\nchecks.right(x)\n```\n\nThe reason.\n"
    )
    assert question_of(block).name == "x"
    with pytest.raises(ValueError, match=message):
        question_of(block.replace(left_out, ""))
