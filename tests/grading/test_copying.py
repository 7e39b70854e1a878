"""What students share that few others have."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import graded

from workbook.checks.contract.verdict import MISSING, RIGHT, WRONG
from workbook.grading.course import copying
from workbook.grading.reports.scores import scores
from workbook.grading.reports.summary import summary
from workbook.notebooks import exercises

HOMEWORK = 'problems = ["1.17", "1.18"]\n'


@pytest.fixture
def class_of_forty(store):
    """Everybody makes one of two common mistakes; Ann and Bob make three rare ones alike."""
    for k in range(40):
        texts = {"a_region": "common", "b_region": f"own {k}"}
        graded(store, f"s{k:02}", "1.17", {"a_region": WRONG, "b_region": WRONG}, texts=texts)
    for student in ("ann", "bob"):
        rare = {"a_region": "<rare>", "b_region": "odd"}
        graded(store, student, "1.17", {"a_region": WRONG, "b_region": WRONG}, texts=rare)
        graded(store, student, "1.18", {"a_region": WRONG, "b_region": RIGHT}, texts=rare)
    # The same right answers, and notebooks without an answer, are no sign of anything.
    for student in ("cid", "dan"):
        statuses = {"a_region": MISSING, "b_region": MISSING}
        graded(store, student, "1.17", statuses, content="untouched")
        statuses = {"a_region": RIGHT, "b_region": RIGHT}
        graded(store, student, "1.18", statuses, texts={"a_region": "k1 > 0", "b_region": "k"})


def test_a_chain_of_equal_wrong_answers_is_shown(class_of_forty, store, homework):
    class_scores = scores(store, homework)
    (pair,) = copying.pairs(class_scores, {})
    assert pair.students == ("ann", "bob") and pair.kind == "wrong answers"
    assert pair.shared == (("1.17 a_region", 2), ("1.17 b_region", 2), ("1.18 a_region", 2))
    page = summary(homework, class_scores, pairs=[pair])
    assert "3 wrong answers" in page and "1.17 a_region</code> (2 students)" in page


def test_identical_notebooks_are_shown(class_of_forty, store, homework):
    for student in ("eve", "fay"):
        statuses = {"a_region": RIGHT, "b_region": RIGHT}
        graded(store, student, "1.17", statuses, content="the same file")
    first, _ = copying.pairs(scores(store, homework), {})
    assert first.students == ("eve", "fay") and first.kind == "identical notebooks"


def test_nearly_identical_code_is_shown(class_of_forty, store, homework):
    cells = [source for _, source in exercises.find("1.17").cells]
    pristine = copying.pristine_lines(exercises.find("1.17"))
    assert copying.own_lines(cells, pristine) == set()
    code = (
        "def minors(p):  # mine\n    q = sp.Poly(p, s)\n    return q.all_coeffs()\n"
        "values = minors(a_poly)\nprint(values)"
    )
    renamed = code.replace("print(values)", "display(values[0])").replace("# mine", "# another")
    common = "import numpy as np\nfrom matplotlib import pyplot as plt"
    lines = {f"s{k:02}": copying.own_lines([*cells, common], pristine) for k in range(40)}
    lines |= {
        "ann": copying.own_lines([*cells, common, code], pristine),
        "cid": copying.own_lines([renamed, common], pristine),
    }
    (_, pair) = copying.pairs(scores(store, homework), lines)
    assert pair.students == ("ann", "cid") and pair.kind == "lines of code"
    assert ("values = minors(a_poly)", 2) in pair.shared and len(pair.shared) == 4
