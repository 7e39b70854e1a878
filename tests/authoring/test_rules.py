"""What every master, its trials and its student's notebook keep to: a test for each rule, over all problems.

A rule yields (file, text, what is wrong) for a master; a finding has the file and the line of that text.
"""

import ast
import base64
import functools
import json
import re
from dataclasses import replace
from pathlib import Path

import nbformat
import pytest

from workbook.authoring import Cell, Links, Trial, new_problem, read_master
from workbook.authoring.judged_problem import call_nodes
from workbook.authoring.mistakes import mistake_sentence, source_hash
from workbook.authoring.scaffold import PLACEHOLDER
from workbook.authoring.student_notebook import baseurl, student_notebook
from workbook.authoring.trials import trials_file
from workbook.checks.contract.former_names import with_former_names
from workbook.mistakes import mistakes_file
from workbook.notebooks import exercises

pytestmark = pytest.mark.slow
ROOT = Path(__file__).resolve().parents[2]
#: Options of checks that may be written as numbers in a check cell.
TOLERANCES = {"tolerance", "horizon"}
OLD_WORDS = re.compile(r"(^|_)(unseen|lost|seen)(_|$)")
DIRECTIVE = re.compile(r"```\{|:label:|\{ref\}|solution-start")


@functools.cache
def links():
    return Links(ROOT, baseurl(ROOT))


def findings(rule, masters):
    """Return "file:line: what is wrong" for all that a rule finds."""
    return [
        f"{path.relative_to(ROOT).as_posix()}:{line_of(path, text)}: {wrong}"
        for master in masters
        for path, text, wrong in rule(master)
    ]


def line_of(path, text):
    written = path.read_text(encoding="utf-8")
    return written.count("\n", 0, max(written.find(text), 0)) + 1


def wrong_trials(master):
    """Yield (trial, its first line, its sentence to the student or None)."""
    for trial in master.trials["wrong"]:
        yield trial, trial.source.partition("\n")[0], mistake_sentence(master, trial)


def nothing_is_left_of_the_template(master):
    for path in (master.path, trials_file(master.path)):
        for line in path.read_text(encoding="utf-8").split("\n"):
            if PLACEHOLDER in line:
                yield path, line, f"to be replaced: {line.strip()}"


def every_wrong_trial_has_a_sentence(master):
    for trial, line, sentence in wrong_trials(master):
        if sentence is None:
            yield (
                trials_file(master.path),
                line,
                f"{trial.name} needs a sentence to the student who has it, with . or ? at its end",
            )


def no_sentence_is_on_the_page(master):
    page = master.path.read_text(encoding="utf-8")
    for _, _, sentence in wrong_trials(master):
        words = (sentence or "").partition("\n")[0]
        if len(words) > 20 and words in page:
            yield master.path, words, f"the page shows this sentence to everybody: {words}"


def no_sentence_holds_the_answer(master):
    for trial, line, sentence in wrong_trials(master):
        text = sentence or ""
        words = set(re.findall(r"\w+", text.partition("\n")[0]))
        named = "_" in trial.name and trial.name in words  # others are ordinary words
        if named or len(text) >= 400 or "right answer" in text:
            yield trials_file(master.path), line, f"it says too much: {text}"


def check_cells_hold_no_answers(master):
    """Their arguments are answers, data and tolerances."""
    known = {"checks", *master.answers}
    for source in master.code("data"):
        known |= {node.id for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Name)}
    for source in master.code("check"):
        for name, call in call_nodes(source).items():
            if ast.unparse(call.args[0]) != name or not ast.unparse(call.func).startswith(
                "checks."
            ):
                yield master.path, source, f"{name} is not what is checked under its name"
            tolerances = [keyword.value for keyword in call.keywords if keyword.arg in TOLERANCES]
            for node in ast.walk(call):
                computed = (ast.Lambda, ast.BinOp, ast.Compare, ast.BoolOp, ast.Subscript)
                if isinstance(node, computed) or (isinstance(node, ast.Call) and node is not call):
                    yield master.path, source, f"computed inside a check: {ast.unparse(node)}"
                if isinstance(node, ast.Name) and node.id not in known:
                    yield master.path, source, f"{node.id} is neither data nor an answer"
                if isinstance(node, ast.Constant) and node not in tolerances:
                    yield master.path, source, f"a literal in a check: {ast.unparse(node)}"


def the_notebook_is_in_step(master):
    written = json.loads(master.exercise.read_text(encoding="utf-8"))
    if written != student_notebook(master, links()):
        yield master.exercise, "", f"run `workbook exercises {master.number}`"
    nbformat.validate(written)
    for cell in written["cells"]:
        if not "".join(cell["source"]).strip():
            yield master.exercise, cell["id"], "an empty cell"


def the_notebook_holds_no_solution(master):
    notebook = json.loads(master.exercise.read_text(encoding="utf-8"))
    cells = "\n".join("".join(cell["source"]) for cell in notebook["cells"])
    shown = "\n".join(master.code("data", "check"))
    trials = [trial.source for role in master.trials.values() for trial in role]
    for source in [*master.code("answer", "figure"), *trials]:
        for line in map(str.strip, source.split("\n")):
            if len(line) > 30 and line not in shown and line in cells:
                yield master.path, line, f"a line of the solution is in the notebook: {line}"
    if left := DIRECTIVE.search(cells):
        yield master.exercise, left[0], f"a directive was left: {left[0]}"


def mistakes_are_in_step_and_sealed(master):
    path = mistakes_file(master.exercise)
    text = path.read_text(encoding="utf-8")
    mistakes = json.loads(text)
    if mistakes["of"] != source_hash(master) or not set(mistakes["answers"]) <= set(master.answers):
        yield path, "", f"run `workbook exercises {master.number}`"
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
            if readable.encode() in shown:
                yield path, "", f"readable without the key: {readable}"


def no_name_has_a_word_that_the_book_no_longer_uses(master):
    """And no former name is one that another answer of the problem has."""
    former = {name: with_former_names(name) for name in master.answers}
    for name, old in former.items():
        taken = [*former.values(), *(other for other in former if other != name)]
        if OLD_WORDS.search(name) or taken.count(old) > 1:
            yield master.path, name, f"{name} and {old}, its former name, need names of their own"


RULES = (
    nothing_is_left_of_the_template,
    every_wrong_trial_has_a_sentence,
    no_sentence_is_on_the_page,
    no_sentence_holds_the_answer,
    check_cells_hold_no_answers,
    the_notebook_is_in_step,
    the_notebook_holds_no_solution,
    mistakes_are_in_step_and_sealed,
    no_name_has_a_word_that_the_book_no_longer_uses,
)


def test_every_exercise_has_a_master(masters):
    assert [each.path for each in exercises.read_all()] == [each.exercise for each in masters]


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_rule(rule, masters):
    found = findings(rule, masters)
    assert not found, "\n" + "\n".join(found)


def _with_comment(comment):
    trials = [Trial("a_region", "a_region = sp.And(k1 > 0, k2 > 0)", comment)]
    return lambda master: replace(master, trials=master.trials | {"wrong": trials})


def _with_cell(role, source):
    return lambda master: replace(master, cells=(*master.cells, Cell(role, source, 1)))


#: What breaks a rule in problem 1.15, and what is then found.
BROKEN = {
    every_wrong_trial_has_a_sentence: (_with_comment("too small"), "needs a sentence"),
    no_sentence_is_on_the_page: (
        _with_comment("Which leading minors decide a cubic?"),
        "the page shows this sentence",
    ),
    no_sentence_holds_the_answer: (_with_comment("Is a_region all of it?"), "it says too much"),
    check_cells_hold_no_answers: (
        _with_cell("check", "checks.report(a_region=checks.stability_region(a_region, [1]))"),
        "a literal in a check: 1",
    ),
    the_notebook_is_in_step: (
        lambda master: replace(master, title="Another title"),
        "run `workbook exercises 1.15`",
    ),
    the_notebook_holds_no_solution: (
        _with_cell("answer", "x\nWrite the second minor out. Where can it vanish?"),
        "a line of the solution is in the notebook: Write the second minor",
    ),
    mistakes_are_in_step_and_sealed: (
        _with_comment("Is it enough that one of them is positive?"),
        "run `workbook exercises 1.15`",
    ),
    no_name_has_a_word_that_the_book_no_longer_uses: (
        lambda master: replace(master, answers={"a_unseen": None}),
        "a_unseen and a_unseen",
    ),
}


@pytest.mark.parametrize("rule", BROKEN, ids=lambda rule: rule.__name__)
def test_a_rule_finds_what_breaks_it(rule):
    broken, told = BROKEN[rule]
    assert told in "\n".join(findings(rule, [broken(read_master(ROOT / "solutions/ch1/p15.md"))]))


def test_a_finding_has_the_file_and_the_line(tmp_path, monkeypatch):
    """Of a new problem, whose template is still to be filled in."""
    monkeypatch.setitem(globals(), "ROOT", tmp_path)
    page, _ = new_problem(tmp_path / "solutions", "6.99")
    first = next(
        k for k, line in enumerate(page.read_text("utf-8").split("\n"), 1) if PLACEHOLDER in line
    )
    found = findings(nothing_is_left_of_the_template, [read_master(page)])
    assert found[0].startswith(f"solutions/ch6/p99.md:{first}: to be replaced: ")
