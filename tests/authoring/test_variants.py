"""Variants: the contract of a section of numbers, and the proof of a row."""

import ast
import json
import re
from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp

from workbook.authoring import Links, MasterError, master_paths, read_master
from workbook.authoring.numbers import NumbersError, phrases, read_numbers, row_texts, with_row
from workbook.authoring.student_notebook import baseurl, student_notebook
from workbook.authoring.trials import numbers_section, read_trials, trials_file
from workbook.authoring.variants import Variants, prove, variants_of
from workbook.course import WORKBOOK
from workbook.mistakes import find_mistake
from workbook.notebooks import exercises
from workbook.numbering import read_number

ROOT = Path(__file__).resolve().parents[2]
#: Seen in the trials: to read all masters would take every process of the tests seconds before its
#: first one.
VARYING = [
    f"{path.parent.name[2:]}.{int(path.stem[1:])}"
    for path in master_paths(ROOT / "solutions")
    if numbers_section(trials_file(path))
]
MASTER = read_master(ROOT / "solutions" / "ch2/p04.md")
ROWS = "weight, friction, stiffness = [(1, 3, 2), (2, 7, 10)]\n"
ANSWERS = """\
p, q = sorted(-root for root in b_matrix.eigenvals())
a_observable = sp.Ne(weight * alpha - beta, weight**2)
b_unobservable = sp.Or(sp.Eq(h, p), sp.Eq(h, q))
b_unobservable_states = {p: [[1, -p]], q: [[1, -q]]}
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder for variants of its own."""
    monkeypatch.setattr(type(WORKBOOK), "variants", tmp_path / "variants")
    return tmp_path / "variants"


@pytest.fixture
def checkout(tmp_path):
    """A checkout with problem 2.4, whose section of numbers the function returned replaces."""
    target = tmp_path / "solutions" / "ch2"
    target.mkdir(parents=True)
    (tmp_path / "book").mkdir()
    page, trials = MASTER.path, MASTER.path.with_suffix(".trials.py")
    (target / "p04.md").write_text(page.read_text("utf-8"), encoding="utf-8")
    before = trials.read_text("utf-8").partition("# %% numbers")[0]

    def write(section):
        text = f"{before}# %% numbers\n{section}"
        (target / "p04.trials.py").write_text(text, encoding="utf-8")
        return tmp_path

    return write


def test_the_section_is_no_trial_and_keeps_lines_in_place(tmp_path):
    path = tmp_path / "p15.trials.py"
    text = "# %% wrong\na = 1  # why?\n# %% numbers\nn = [1]\n\na = n\n# %% right\na = 2  # so\n"
    path.write_text(text, encoding="utf-8")
    assert numbers_section(path) == "n = [1]\n\na = n\n"
    trials = read_trials(path, {"a": None})
    assert [trial.source for trial in trials["wrong"] + trials["right"]] == ["a = 1", "a = 2"]
    path.write_text(text.replace("n = [1]", "n = [1"), encoding="utf-8")
    with pytest.raises(MasterError, match=r"trials\.py:4: no Python"):
        numbers_section(path)
    path.write_text(text.replace("a = 2  # so", "a = 2"), encoding="utf-8")
    with pytest.raises(MasterError, match=r"trials\.py:8: .*under a comment"):
        read_trials(path, {"a": None})


@pytest.mark.parametrize(
    "section, message",
    [
        ("", "no section # %% numbers"),
        (ANSWERS, "begin with rows"),
        ("weight, friction, stiffness = [(1, 3, 3)]\n", "row 0 is not written as"),
        ("weight, friction, stiffness = [(1, 3)]\n", "each row has 3 values"),
        (ROWS.replace("]", ", (1, 3, 2)]"), "two rows have the same numbers"),
        (ROWS + 'shown = ["z = «friction*»x"]\n', "the page has no phrase z = 3x"),
    ],
)
def test_a_section_that_breaks_the_contract(section, message):
    with pytest.raises(MasterError, match=message):
        Variants(replace(MASTER, numbers=section))


def test_only_the_numbers_of_a_data_cell_change():
    section = "n, masses, a = [(1, [2, 3], sp.Rational(1, 2)), (-2, [4], sp.Rational(5, 3))]"
    cell = "é = 'n = 1'; n, a = 1, sp.Rational(1, 2)  # n = 1\nmasses = [2, 3]  # both\nm = n"
    data = ["import sympy as sp", cell]
    numbers = read_numbers(_WithData(section, data))
    assert [with_row(part, numbers, 0) for part in data] == data
    assert with_row(cell, numbers, 1) == (
        "é = 'n = 1'; n, a = -2, sp.Rational(5, 3)  # n = 1\nmasses = [4]  # both\nm = n"
    )
    assert row_texts([sp.Matrix([[1, sp.Rational(-1, 2)]]), (1, 2)]) == (
        "sp.Matrix([[1, sp.Rational(-1, 2)]])",
        "(1, 2)",
    )


class _WithData:
    """Stands for a master with a section and data cells."""

    path = Path("p15.md")

    def __init__(self, section, data):
        self.numbers, self._data = section, data

    def code(self, role):
        return self._data


@pytest.mark.parametrize(
    "phrase, text",
    [
        ("«n*»x «+m*»y «+k*»z", "x - 3y + \\frac{1}{2}z"),
        ("«-n*»x + «k» «+m»", "-x + \\frac{1}{2} - 3"),
        ("«'a' * 2»", "aa"),
    ],
)
def test_phrases(phrase, text):
    values = {"n": 1, "m": -3, "k": sp.Rational(1, 2), "shown": [phrase]}
    assert phrases(values) == [text]


def test_a_coefficient_that_vanishes_is_no_phrase():
    with pytest.raises(NumbersError, match="the coefficient n - 1 is 0"):
        phrases({"n": 1, "shown": ["«n - 1*»x"]})


@pytest.mark.parametrize(
    "section, fault",
    [
        (ROWS + ANSWERS.replace("weight**2", "weight"), "a_observable: the right answer is wrong"),
        (ROWS, "the right answer is wrong"),
        (ROWS.replace("2, 7, 10", "1, 7, 10") + ANSWERS, None),
        (
            ROWS.replace("2, 7, 10", "1, 7, 10") + ANSWERS + "site_share = 0.3",
            "the answers of the site earn 0.33, more than 0.30",
        ),
        (ROWS.replace("2, 7, 10", "0, 7, 10") + ANSWERS, "weight is 0"),
        (ROWS.replace("2, 7, 10", "2, 4, 2") + ANSWERS, "is unchecked"),
        (ROWS.replace("2, 7, 10", "2, 10**40 + 1, 10**40") + ANSWERS, "letters, that of row 0"),
        (
            ROWS.replace("2, 7, 10", "0, 7, 10") + 'shown = ["z = «weight*»x"]\n' + ANSWERS,
            "the coefficient weight is 0",
        ),
        (
            ROWS + 'shown = ["+ «friction*»\\\\dot x", "+ «weight + 2*»\\\\dot x"]\n' + ANSWERS,
            "two phrases are the same in row 0",
        ),
    ],
)
def test_a_row_is_proved_or_its_faults_are_named(checkout, folder, section, fault):
    (proof,) = prove(checkout(section), "2.4")
    if fault is None:
        assert proof.faults == () and proof.site_share == pytest.approx(1 / 3)
    else:
        assert fault in "; ".join(proof.faults)
    # only a proved row can be found
    assert (folder / "ch2" / "p04~1.ipynb").exists() == (fault is None)


def test_a_row_that_shares_answers_with_an_earlier_one_is_refused(checkout, folder):
    # row 3 has the weight of row 1, row 4 the roots of row 2
    rows = "[(1, 3, 2), (2, 7, 10), (3, 4, 3), (2, 5, 6), (4, 4, 3), (5, 6, 8)]"
    root = checkout(f"weight, friction, stiffness = {rows}\n" + ANSWERS)
    proofs = list(prove(root, "2.4"))
    shared = "it shares {} of the answers that vary with row {}, more than 0.20"
    assert [proof.faults for proof in proofs] == [
        *[(), (), (shared.format("0.33", 1),), (shared.format("0.67", 2),), ()]
    ]
    assert [proof.shared for proof in proofs] == pytest.approx([0, 0, 1 / 3, 2 / 3, 0])
    assert not (folder / "ch2" / "p04~3.ipynb").exists()


@pytest.mark.parametrize(
    "one, other, shared",
    [
        ("(h - 1) * (h + 1)", "h**2 - 1", 1),
        ("sp.Matrix([[1], [2 * (h + 1)]])", "sp.Matrix([1, 2 * h + 2])", 1),
        ("{1: [sp.sqrt(3 + 2 * sp.sqrt(2))]}", "{1: [1 + sp.sqrt(2)]}", 1),
        ("sp.Rational(10001, 10002)", "sp.Rational(10002, 10003)", 1),  # equal to three digits
        ("10001", "10002", 0),
        ("h > 1", "h >= 1", 0),
    ],
)
def test_right_values_are_compared_in_one_form(one, other, shared):
    answers = f"a_observable = b_unobservable = [{one}, {other}, 7][friction - 3]\n"
    rows = "weight, friction, stiffness = [(1, 3, 2), (2, 4, 3), (3, 5, 4)]\n"
    variants = Variants(replace(MASTER, numbers=rows + answers))
    assert variants.most_shared(1) == (0, shared) and variants.most_shared(2) == (0, 0)


def test_a_wrong_trial_in_literals_is_right_for_some_row(checkout, folder):
    root = checkout(ROWS.replace("2, 7, 10", "1, 4, 3") + ANSWERS)
    trials = root / "solutions" / "ch2" / "p04.trials.py"
    text = trials.read_text("utf-8")
    literal = "# Why?\nb_unobservable = sp.Or(sp.Eq(h, 1), sp.Eq(h, 3))\n# %% right\n"
    trials.write_text(text.replace("# %% right\n", literal), encoding="utf-8")
    (proof,) = prove(root, "2.4")
    assert "sp.Eq(h, 3)) is right" in "; ".join(proof.faults)


def test_a_proof_is_kept_until_something_behind_it_changes(checkout, folder, monkeypatch):
    root = checkout(ROWS + ANSWERS)
    (first,) = prove(root, "2.4")
    monkeypatch.setattr("workbook.authoring.variants.Child", None)  # which proves
    assert list(prove(root, "2.4")) == [first]
    monkeypatch.undo()
    monkeypatch.setattr(type(WORKBOOK), "variants", folder)
    page = root / "solutions" / "ch2" / "p04.md"
    page.write_text(page.read_text("utf-8") + "\n", encoding="utf-8")
    notebook = folder / "ch2" / "p04~1.ipynb"
    notebook.write_text("{}", encoding="utf-8")
    assert list(prove(root, "2.4")) == [first] and notebook.read_text("utf-8") != "{}"
    # a row that fails now can no longer be handed out
    assert [bool(proof.faults) for proof in prove(checkout(ROWS), "2.4")] == [True]
    assert not notebook.exists()


def test_names_of_variants(folder):
    with pytest.raises(exercises.UnknownExercise, match=r"`workbook variants 2\.4` proves"):
        exercises.find("2.4~3")
    for name in ("2.4~0", "2.4~", "2.4~03", "2.4~x", "2.4~1~2", "~1", "2.4 ~1"):
        with pytest.raises(exercises.UnknownExercise):
            exercises.find(name)


@pytest.mark.parametrize("number", VARYING)
def test_row_0_gives_the_students_notebook_back_letter_by_letter(number):
    master = read_master(ROOT / "solutions" / read_number(number).file(".md"))
    notebook = student_notebook(Variants(master).variant(0), Links(ROOT, baseurl(ROOT)))
    written = master.exercise.read_text(encoding="utf-8")
    assert json.dumps(notebook, indent=1, ensure_ascii=False) + "\n" == written


@pytest.mark.parametrize("number", VARYING)
def test_each_number_of_a_row_is_shown(number):
    """A number that no phrase shows would stand in the statement as in row 0."""
    variants = variants_of(ROOT, number)
    names = variants.names(0)
    fields = re.findall(r"«\+?(.*?)\*?»", "".join(names["shown"]), re.DOTALL)
    shown = set().union(*(_names(ast.parse(field), ast.Load) for field in fields))
    for statement in reversed(ast.parse(variants.numbers.source).body):
        if _names(statement, ast.Store) & shown:  # what a phrase shows was computed here
            shown |= _names(statement, ast.Load)
    assert set(variants.numbers.names) <= shown
    assert len(variants.numbers.rows) > 8


@pytest.mark.parametrize("number", VARYING)
def test_no_two_rows_share_more_than_a_fifth_of_the_answers_that_vary(number):
    variants = variants_of(ROOT, number)
    rows = range(1, len(variants.numbers.rows))
    assert max(share for _, share in map(variants.most_shared, rows)) <= 1 / 5 + 1e-9


def _names(tree, context):
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    return {node.id for node in nodes if isinstance(node.ctx, context)}


def test_the_guide_for_lecturers_lists_the_problems_that_vary():
    text = (ROOT / "book" / "guides" / "lecturer.md").read_text(encoding="utf-8")
    section = text.partition("In these problems the numbers can differ:")[2].partition("Each has")[
        0
    ]
    assert sorted(re.findall(r"\b\d\.\d+", section)) == sorted(VARYING)


@pytest.mark.slow
@pytest.mark.parametrize("number", VARYING)
def test_three_rows_are_proved(number, folder):
    variants = variants_of(ROOT, number)
    last = len(variants.numbers.rows) - 1
    proofs = list(prove(ROOT, number, [1, last // 2, last]))
    assert [proof.faults for proof in proofs] == [()] * 3
    for proof in proofs:
        exercise = exercises.find(proof.name)
        assert exercise.number == proof.name
        assert f'"{proof.name}"' in exercise.code("check")[0][1]
        assert proof.site_share <= max(1 / 3, float(variants.names(0).get("site_share", 0)))


@pytest.mark.slow
def test_a_named_mistake_is_found_in_its_own_row(folder):
    list(prove(ROOT, "2.4", [1, 2]))
    h = sp.Symbol("h", real=True)
    mistake = sp.Or(sp.Eq(h, -1), sp.Eq(h, -3))  # the roots of row 1 themselves
    assert "Substitute one of them into z" in find_mistake("2.4~1", "b_unobservable", mistake)
    assert find_mistake("2.4~2", "b_unobservable", mistake) == ""
