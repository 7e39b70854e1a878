"""What students share that few others have."""

import json
import re
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import graded, hand_in

from workbook.checks.contract.verdict import MISSING, RIGHT, WRONG
from workbook.grading.course import copying, course, submissions
from workbook.grading.course.store import Store
from workbook.grading.reports.scores import scores
from workbook.grading.reports.summary import summary
from workbook.grading.sandbox.limited_process import LimitedProcess, LimitError
from workbook.grading.sandbox.limits import Limits
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
    own_code = {student: copying.OwnCode(own) for student, own in lines.items()}
    (_, pair) = copying.pairs(scores(store, homework), own_code)
    assert pair.students == ("ann", "cid") and pair.kind == "lines of code"
    assert ("values = minors(a_poly)", 2) in pair.shared and len(pair.shared) == 4


CODE = '''
def minors(polynomial):
    """Return the Hurwitz determinants."""
    coefficients = sp.Poly(polynomial, s).all_coeffs()
    size = len(coefficients) - 1
    table = sp.zeros(size, size)
    for row in range(size):
        for column in range(size):
            place = 2 * column - row + 1
            if 0 <= place <= size:
                table[row, column] = coefficients[place]
    return [table[: k + 1, : k + 1].det() for k in range(size)]
'''
NAMES = ["minors", "polynomial", "coefficients", "size", "table", "row", "column", "place", "k"]


def _shapes(*cells, pristine=()):
    return copying.shapes(json.dumps({"cells": cells, "pristine": pristine}).encode())


def _renamed(code):
    for k, name in enumerate(NAMES):
        code = re.sub(rf"\b{name}\b", f"x{k}", code)
    return code


def test_renaming_variables_changes_no_shape():
    renamed = _renamed(CODE).replace('"""Return the Hurwitz determinants."""', "# mine")
    assert len(_shapes(CODE)) >= 6 and _shapes(CODE).keys() == _shapes(renamed).keys()
    # Another thought has another shape; so has the same one with other data or functions.
    other = "def f(p):\n    q = sp.Poly(p, s)\n    m = sp.Matrix(q.all_coeffs())\n    return m.T * m + m\n"
    assert not _shapes(CODE).keys() & _shapes(other).keys()
    changed = CODE.replace("sp.", "np.").replace("range", "reversed").replace("<=", "<")
    assert not _shapes(CODE).keys() & _shapes(changed).keys()
    # What was handed out is nobody's.
    assert _shapes(CODE, "a_region = ...", pristine=[CODE, "a_region = ..."]) == {}


@pytest.mark.parametrize(
    "cell", ["(" * 100_000, f"x = {'-' * 100_000}1", "%run x\ndef f(:", "\0", "x = '\ud800'"]
)
def test_cells_that_cannot_be_parsed_have_no_shape(cell):
    with LimitedProcess(copying.shapes) as process:
        request = json.dumps({"cells": [cell, CODE], "pristine": []}).encode()
        try:
            assert process.call(copying.shapes, request).keys() >= _shapes(CODE).keys()
        except LimitError:
            assert len(cell) > 1000
        request = json.dumps({"cells": [CODE], "pristine": []}).encode()
        assert process.call(copying.shapes, request) == _shapes(CODE)


def test_renamed_code_is_shown_with_how_common_it_is(class_of_forty, store, homework):
    common = (
        "import numpy as np\nvalues = [1, 2]\nfor v in values:\n    print(v**2 + 1, v - 3, [v])\n"
    )
    own_code = {f"s{k:02}": copying.OwnCode(set(), _shapes(common)) for k in range(40)}
    own_code |= {
        "ann": copying.OwnCode(set(), _shapes(common, CODE)),
        "cid": copying.OwnCode(set(), _shapes(_renamed(CODE))),
    }
    class_scores = scores(store, homework)
    (_, pair) = copying.pairs(class_scores, own_code)
    assert pair.students == ("ann", "cid") and pair.kind == copying.SHAPES
    assert {students for _, students in pair.shared} == {2}
    page = summary(homework, class_scores, pairs=[pair])
    assert "whatever their variables are called" in page and "= len(" in page
    assert "This decides nothing" in page


def test_shapes_are_found_once_and_stored(tmp_path, monkeypatch):
    """A class is read again in seconds: only new notebooks are parsed."""
    for student, code in [("ann", CODE), ("bob", _renamed(CODE))]:
        hand_in(tmp_path, student, "1.15", {"a_region": f"1\n{code}"})
    entries = list(submissions.find(tmp_path / "submitted"))
    homeworks, _ = course._homeworks(entries, {})
    copies, aside = course._by_attempt(entries, homeworks, {}, {})
    with Store(tmp_path / "grades.sqlite") as store:
        first = course._plan(copies, aside, homeworks, store, Limits())
        monkeypatch.setattr(LimitedProcess, "call", None)
        again = course._plan(copies, aside, homeworks, store, Limits())
    assert first.own_code == again.own_code
    ann, bob = (first.own_code["hw1"][name] for name in ("ann", "bob"))
    assert ann.lines != bob.lines and ann.shapes.keys() == bob.shapes.keys() and ann.shapes
