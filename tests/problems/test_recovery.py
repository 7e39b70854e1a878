"""The student who corrects answers from messages finds what a message tells, and nothing else."""

import pytest
import sympy as sp
from recovery import OWN, TRUE, coefficients, recovered

from workbook.checks.contract.verdict import Verdict

x = sp.Symbol("x")


class OneAnswer:
    """A problem with one answer, right to three digits, and one message on all others."""

    def __init__(self, answer, message):
        self.reference, self.data, self.message = {"a": answer}, {"x": x}, message

    def judge_one(self, name, value):
        own, true = (float(sp.sympify(part).subs(x, 2.5)) for part in (value, self.reference["a"]))
        right = abs(own - true) <= 5e-3 * abs(true)
        return Verdict("right" if right else "wrong", self.message(own, true))


@pytest.mark.parametrize(
    "message, kind",
    [
        (lambda own, true: f"for x = 2.5 it is {true:.4g}; your expression gives {own:.4g}", TRUE),
        (lambda own, true: f"for x = 2.5 it is {true:.4g}", TRUE),
        (lambda own, true: f"for x = 2.5 it has to be C = {true:.4g}", TRUE),
        (lambda own, true: f"for x = 2.5 yours is {own / true:.4g} times as great", OWN),
        (lambda own, true: f"for x = 2.5 the two sides differ by {own - true:.4g}", OWN),
        (lambda own, true: f"for x = 2.5 you lose {3 * (own - true):.4g} of what there is", OWN),
    ],
)
@pytest.mark.parametrize("answer", [sp.sqrt(7), 3 * x**2 / 7, 5 * x / 3 + sp.exp(-x)])
def test_a_message_that_tells_how_far_an_answer_is_off_corrects_it(answer, message, kind):
    found = recovered(OneAnswer(answer, message), "a")
    assert "factor" in [what for what, *_ in found] and {kind} == {row[1] for row in found}


@pytest.mark.parametrize("answer", [sp.sqrt(7), 3 * x**2 / 7, 5 * x / 3 + sp.exp(-x)])
def test_a_message_with_the_number_of_the_answer_alone_corrects_nothing(answer):
    def message(own, true):
        return f"for x = 2.5 it is less than {own:.4g}, which your expression gives"

    assert recovered(OneAnswer(answer, message), "a") == []


def test_coefficients_are_those_of_all_parts_and_of_no_exponent():
    answer = {1: [sp.Matrix([[x**2 / 3, 2]])], 2: x > sp.Rational(2, 3)}
    assert [(what, right) for what, right, _ in coefficients(answer)] == [
        ("factor of entry 1 of 1", 1),
        ("factor of entry 1 of entry 1 of 1", 1),
        ("number 1/3 of entry 1 of entry 1 of 1", sp.Rational(1, 3)),
        ("factor of entry 2 of entry 1 of 1", 1),
        ("number 2/3 of 2", sp.Rational(2, 3)),
    ]
    for _, right, put in coefficients(answer):
        assert put(right) == answer != put(3 * right)
