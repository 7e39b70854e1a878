"""A check that declares the type of its answer gets it read, and every comparison that it yields is
done."""

import pytest
import sympy as sp

from workbook.checks import judged
from workbook.checks.contract.claims import (
    Choice,
    Expression,
    Expressions,
    Integer,
    Matrix,
    Number,
    Parts,
    Table,
    Values,
    Vectors,
    YesNo,
    symbols_in,
)
from workbook.checks.contract.verdict import Invalid, Wrong
from workbook.checks.tools.comparisons import (
    SameEntries,
    SameMembers,
    SameSides,
    SameTruth,
    SameValue,
    SameWord,
)

x, k = sp.symbols("x k", positive=True)


@judged(Expression("x", "parameters"))
def twice(claim, x, parameters=(k,)):
    """Twice the product."""
    for value in (1, 2, 3):
        yield SameValue(claim, 2.5 * 2 * value, "twice the product", {x: 2.5, k: value})
    return "it is"


@pytest.mark.parametrize(
    "answer, status",
    [
        (2 * x * k, "right"),
        (2.0 * sp.Symbol("x") * k, "right"),
        (2 * x, "wrong"),
        (2.1 * x * k, "wrong"),
        (x + sp.Symbol("y"), "invalid"),
        (x / (k - 2), "wrong"),
        ("2", "invalid"),
        (..., "missing"),
    ],
)
def test_an_expression(answer, status):
    assert twice(answer, x).status == status, twice(answer, x).message


def test_the_last_comparison_counts():
    assert twice(sp.Piecewise((2 * x * k, k < 3), (0, True)), x).message == (
        "for x = 2.5, k = 3, twice the product is greater than 0, which your expression gives"
    )


def test_the_form_depends_on_the_data():
    @judged(Expressions("A", length=lambda data: data["A"].rows))
    def rows(claims, A):
        return f"{len(claims)}"

    assert rows([k, 1], sp.diag(k, 2)).message == "2"
    assert rows([k], sp.diag(k, 2)).status == rows([x, 1], sp.diag(k, 2)).status == "invalid"


def test_a_truth_that_cannot_be_computed_is_no_verdict_on_the_answer():
    @judged(Expression())
    def lost(claim):
        yield SameValue(claim, float("nan"), "the number", {})

    assert lost(1).status == "unchecked"


def test_a_condition_agrees():
    SameTruth(x > 1, True, "it holds", {x: 2}).judge()
    with pytest.raises(Exception, match="for x = 0.5 it fails, yet your condition holds"):
        SameTruth(x < 1, False, "it fails", {x: 0.5}).judge()


def test_symbols_in_data():
    assert symbols_in([x, {k: sp.Interval(0, 1)}, sp.Matrix([[x * k]]), None, 3]) == [x, k, k, x]


A = sp.Matrix([[1, k], [0, 2]])


@pytest.mark.parametrize(
    "claim, answer, read",
    [
        (YesNo(), "yes", True),
        (Choice(words=("node", "focus")), "Focus", "focus"),
        (Choice(words="names"), "the angle", "the angle"),
        (Vectors("x", size="A"), [[1, x], [0, 1]], [[1, x], [0, 1]]),
        (Vectors("x", size="A"), sp.Matrix([1, x]), [[1, x]]),
        (Vectors("x", size=3), [], []),
        (Matrix("A", shape="A"), A.tolist(), A),
        (Values("x", expected="values"), {2, x}, {2, x}),
        (Values("x", expected="values"), x, {x}),
        (Values("x", expected="values"), {x: 2, sp.Integer(1): 1}, {x, 1}),
        (
            Parts(Matrix(shape="A"), Integer(), expected="two"),
            [[[1, 2], [3, 4]], 5.0],
            [sp.Matrix([[1, 2], [3, 4]]), 5],
        ),
        (Table(Number(), YesNo(), "a dict"), {2: "no"}, [(2, False)]),
    ],
)
def test_what_a_claim_reads(claim, answer, read):
    found = claim.read(answer, {"x": x, "A": A, "names": {"the angle": 1}})
    assert (set(found) if isinstance(read, set) else found) == read


@pytest.mark.parametrize(
    "claim, answer",
    [
        (YesNo(), 3),
        (Choice(words=("node", "focus")), "saddle"),
        (Vectors("x", size="A"), [[1, 2, 3]]),
        (Matrix(shape="A"), [[1, 2]]),
        (Values("x", expected="values"), "x"),
        (Values("x", expected="values"), {x: 1.5}),
        (Parts(Number(), Number(), expected="two"), [1]),
        (Table(Number(), Number(), "a dict"), [[1, 2]]),
        (Table(Number(), Number(), lambda data: "a dict"), {"one": 2}),
    ],
)
def test_what_a_claim_refuses(claim, answer):
    with pytest.raises(Invalid):
        claim.read(answer, {"x": x, "A": A})


def test_entries():
    claim, told = sp.Matrix([[1, x], [2, 3]]), lambda said, i, j: f"{i} {j} {said[i, j].real:g}"
    assert (SameEntries(claim, [[1, 5], [2, 3]], told, {x: 5}).judge() == [[1, 5], [2, 3]]).all()
    for true, message in (([[1, 5], [2, 4]], "1 1 3"), ([[1, 4], [5, 5]], "0 1 5")):
        with pytest.raises(Wrong, match=message):
            SameEntries(claim, true, told, {x: 5}).judge()


def members(claimed, **repeated):
    return SameMembers(
        claimed,
        [1, 4, 9],
        lambda one, other: abs(one - other) < 0.1,
        lambda one: f"{one} is none",
        lambda count, others: f"{count} of them, not {others}",
        **repeated,
    )


def test_members():
    assert members([9.01, 1, 4, 4]).judge() == [9, 1, 4, 4]
    for said, message in (
        ([1, 4], r"2 of them, not \[9\]"),
        ([1, 4, 9, 5], "5 is none"),
        ([], "0 of them"),
    ):
        with pytest.raises(Wrong, match=message):
            members(said).judge()
    with pytest.raises(Wrong, match="4 again"):
        members([1, 4, 4, 9], repeated=lambda one: f"{one} again").judge()


def test_a_word_and_a_law():
    assert SameWord("node", "node", "the roots are real").judge() == "the roots are real"
    with pytest.raises(Wrong, match="but the roots are real"):
        SameWord("focus", "node", "the roots are real", "but ").judge()
    SameSides([1, 2.0], [1, 2.0 + 1e-12], 1.0, lambda k: "").judge()
    for left, size in (([1, 3], 1.0), ([1, float("nan")], 1.0), ([1, 2], float("inf"))):
        with pytest.raises(Wrong, match="at"):
            SameSides(left, [1, 2], size, lambda k: f"at {k}").judge()
