"""A notebook's check and the grader give the same verdict and message on any object.

An answer is judged after it was encoded.
"""

import collections
import decimal
import itertools
from pathlib import Path

import casadi
import mpmath
import numpy as np
import pytest
import scipy.sparse
import sympy as sp
from harness import solve

from workbook.authoring import read_master
from workbook.authoring.forms import forms
from workbook.authoring.judged_problem import JudgedProblem
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.traversal import EncodingError
from workbook.notebooks import exercises
from workbook.notebooks.execution import in_child, judge_cells

pytestmark = pytest.mark.slow
SOLUTIONS = Path(__file__).resolve().parents[2] / "solutions"
PROBLEMS = ("1.3", "1.8", "1.11", "5.3", "7.2")


class Row(list):
    pass


class Word(str):
    pass


def elementwise(change):
    """Return the change of an answer that changes each of its numbers and words."""

    def changed(value):
        if isinstance(value, (list, tuple)):
            return type(value)(map(changed, value))
        return value.applyfunc(change) if isinstance(value, sp.MatrixBase) else change(value)

    return changed


def as_set(values):
    try:
        return {tuple(value) if isinstance(value, list) else value for value in values}
    except TypeError:  # of matrices
        return values


def as_decimal_number(make):
    return lambda value: (
        make(str(sp.N(value, 30)))
        if isinstance(value, sp.Expr) and value.is_number and value.is_real
        else value
    )


#: Forms whose verdict may be any: decimals where an exact number is asked.
EITHER = {
    "mpmath": elementwise(as_decimal_number(mpmath.mpf)),
    "floats": elementwise(as_decimal_number(float)),
    "sets": lambda value: as_set(value) if isinstance(value, list) else value,
    "tuples of SymPy": lambda value: (
        sp.Tuple(*value) if isinstance(value, (list, tuple)) else value
    ),
    "partly": lambda value: [..., *value[1:]] if isinstance(value, list) else value,
    "partly None": lambda value: [None, ..., *value[2:]] if isinstance(value, list) else value,
    "texts": str,
    "fives": lambda value: 5,
}
#: What cannot cross is invalid, in the encoder's words.
REFUSED = {
    "named tuples": lambda value: (
        collections.namedtuple("Pair", [f"x{i}" for i in range(len(value))])(*value)
        if isinstance(value, list)
        else value
    ),
    "subclasses": lambda value: {list: Row, str: Word, dict: collections.OrderedDict}.get(
        type(value), lambda same: same
    )(value),
    "Decimals": as_decimal_number(decimal.Decimal),
    "functions": lambda value: lambda t: value,
    "None": lambda value: None,
    "CasADi": lambda value: casadi.SX.sym("x"),
    "iterators": lambda value: iter(value) if isinstance(value, list) else value,
    "matrices of NumPy": lambda value: np.zeros((2, 2)).view(np.matrix),
    "matrices of mpmath": lambda value: mpmath.eye(2),
    "sparse matrices of SciPy": lambda value: scipy.sparse.eye(2, format="csr"),
}


@pytest.mark.parametrize("number", PROBLEMS)
def test_notebook_and_grade_agree(number):
    exercise = exercises.find(number)
    master = read_master(SOLUTIONS / exercise.path.parent.name / f"{exercise.path.stem}.md")
    answers = in_child(solve, master, timeout=120)["answers"]
    assert in_child(_disagreements, exercise, master, answers, timeout=300) == []


def _disagreements(exercise, master, answers):
    problem, disagreements = JudgedProblem(master, answers), []
    for form, answers, expected in _turns(problem):
        here = {
            name: [verdict.status, verdict.message]
            for name, verdict in problem.judge(answers).items()
        }
        graded = judge_cells(
            exercise.code("data", "check"), *_handed_over(answers), list(problem.reference)
        )
        for name in answers:
            kept = expected in (here[name][0], "any") and (
                expected != "invalid" or here[name][1].startswith("answer ")
            )
            if here[name] != graded[name][:2] or not kept:
                disagreements.append([form, name, here[name], graded[name]])
    return disagreements


def _turns(problem):
    """Yield (form, answers, verdict due): all answers in one form after another."""
    accepted = {
        name: forms(value, problem.master.answers[name].kind, problem.symbols(name))
        for name, value in problem.reference.items()
    }
    for turn in itertools.zip_longest(*(others.items() for others in accepted.values())):
        tried = {name: other for name, other in zip(accepted, turn) if other is not None}
        yield (
            [form for form, _ in tried.values()],
            {name: value for name, (_, value) in tried.items()},
            "right",
        )
    for changes, expected in ((EITHER, "any"), (REFUSED, "invalid")):
        for form, change in changes.items():
            others = {name: change(value) for name, value in problem.reference.items()}
            yield (
                form,
                {
                    name: other
                    for name, other in others.items()
                    if other is not problem.reference[name]
                },
                expected,
            )


def _handed_over(answers):
    """Return (encoded, unreadable) as a student's process hands them over."""
    encoded, unreadable = {}, {}
    for name, value in answers.items():
        try:
            encoded[name] = encode(value).decode()
        except EncodingError as error:
            unreadable[name] = str(error)
    return encoded, unreadable
