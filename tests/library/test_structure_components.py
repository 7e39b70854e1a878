"""Sequential and parallel decompositions have the block shapes of the module's docstring."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.structure import (
    controllability_matrix,
    decompose_by_inputs,
    decompose_by_outputs,
    observability_matrix,
)

M = sp.Matrix
half = sp.Rational(1, 2)
SEVEN = (
    M([[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 2, 1], [0, 0, 0, 2]]),
    M([[1, 0], [0, 1], [0, 1], [1, 0]]),
)
P33 = (
    M([[1, -1, 0, 0], [0, 1, 0, 0], [0, 0, 2, -1], [0, 0, 0, 2]]),
    M([[1, 0], [0, 1], [0, 1], [1, 0]]),
)
P34 = (
    half * M([[0, 2, 2, 0], [1, 3, -1, 0], [1, 1, 1, 0], [2, -2, 2, 2]]),
    half * M([[0, 0], [1, 1], [1, 1], [0, 2]]),
)
P14 = (
    M([[0, -1, 1, 0], [1, 0, 0, 1], [-1, 0, 0, -1], [0, 2, 1, 0]]),
    M([[1, 0, 0, 0], [0, 1, 0, 0]]),
)
P15 = (
    half * M([[3, 1, -1, 1], [0, 2, 0, 0], [-1, 1, 3, -1], [0, 0, 0, 4]]),
    M([[1, 0, 1, 1], [1, 1, -1, 0]]),
)


def entry(matrix, i, j, value):
    assert sp.simplify(matrix[i, j] - value) == 0, (i, j, matrix)


def judge_outputs(A, H, T, Anew, Hnew, sizes, remaining, form):
    """Assert all properties of a decomposition by outputs that `components` states."""
    n, total = A.rows, sum(sizes)
    assert T.det() != 0 and total == observability_matrix(A, H).rank() and remaining == n - total
    assert (Anew * T - T * A).is_zero_matrix and (Hnew * T - H).is_zero_matrix
    firsts = [sum(sizes[:i]) for i in range(len(sizes))]
    assert Anew[:total, total:].is_zero_matrix and Hnew[:, total:].is_zero_matrix
    for i, (start, size) in enumerate(zip(firsts, sizes)):
        for row in range(start, start + size):
            for j, (other, length) in enumerate(zip(firsts, sizes)):
                for column in range(other, other + length):
                    free = (
                        row == start + size - 1 and j <= i
                        if form == "sequential"
                        else column == other
                    )
                    if not free:
                        entry(Anew, row, column, int(column == row + 1 and i == j))
        for j, (other, length) in enumerate(zip(firsts, sizes)):
            for column in range(other, other + length):
                free = (
                    not size and j < i
                    if form == "sequential"
                    else column == other and j < i and size < length
                )
                if not free:
                    entry(Hnew, i, column, int(j == i and column == start))
    if form == "parallel":
        # The length of the chain of output i in the shuttle's order.
        rows, lengths = sp.zeros(0, n), [0] * H.rows
        for power in range(n):
            for i in range(H.rows):
                longer = sp.Matrix.vstack(rows, H[i, :] * A**power)
                if lengths[i] == power and longer.rank() > rows.rows:
                    rows, lengths[i] = longer, power + 1
        assert tuple(lengths) == sizes
    else:
        ranks = [observability_matrix(A, H[: i + 1, :]).rank() for i in range(H.rows)]
        assert tuple(late - early for early, late in zip([0, *ranks], ranks)) == sizes


def judge_inputs(A, B, found):
    """Assert the dual: transposed, in the parallel form with each subsystem reversed."""
    order, start = list(range(A.rows)), 0
    for size in found.sizes:
        if found.form == "parallel":
            order[start : start + size] = reversed(order[start : start + size])
        start += size
    P = found.basis[:, order]
    judge_outputs(
        A.T,
        B.T,
        P.T,
        found.matrix.extract(order, order).T,
        found.inputs[order, :].T,
        found.sizes,
        found.remaining,
        found.form,
    )


@pytest.mark.parametrize("form", ["sequential", "parallel"])
@pytest.mark.parametrize(
    "system, sizes",
    [
        (SEVEN, {"sequential": (3, 1), "parallel": (2, 2)}),
        (P33, {"sequential": (3, 1), "parallel": (2, 2)}),
        (P34, {"sequential": (3, 0), "parallel": (2, 1)}),
    ],
    ids=["example 7", "2.33", "2.34"],
)
def test_decompositions_by_inputs(system, sizes, form):
    found = decompose_by_inputs(*system, form)
    assert (
        found.sizes == sizes[form] and found.remaining == 4 - controllability_matrix(*system).rank()
    )
    judge_inputs(*system, found)


@pytest.mark.parametrize("form", ["sequential", "parallel"])
@pytest.mark.parametrize("system", [P14, P15], ids=["2.14", "2.15"])
def test_decompositions_by_outputs(system, form):
    found = decompose_by_outputs(*system, form)
    judge_outputs(
        *system,
        found.transformation,
        found.matrix,
        found.outputs,
        found.sizes,
        found.remaining,
        form,
    )


def test_example_7():
    A, B = SEVEN
    found = decompose_by_inputs(A, B, "sequential")
    assert found.basis == M([[1, 1, 1, 0], [0, 0, 0, 1], [0, 1, 4, 1], [1, 2, 4, 0]])
    assert found.matrix == M([[0, 0, 4, 6], [1, 0, -8, -7], [0, 1, 5, 2], [0, 0, 0, 1]])
    g1, f1 = B[:, 0], B[:, 1]
    g2, f2 = A * g1, A * f1
    assert A * f2 == -g1 + g2 / 2 - 3 * f1 / 2 + 5 * f2 / 2
    found = decompose_by_inputs(A, B, "parallel")
    assert found.basis == M.hstack(g2 - 7 * g1 / 2 - f1 / 2, g1, f2 - 5 * f1 / 2 - g1 / 2, f1)
    assert found.inputs == M([[0, 0], [1, 0], [0, 0], [0, 1]])


entries = st.integers(-2, 2)


@st.composite
def systems(draw):
    n, m = draw(st.integers(2, 4)), draw(st.integers(1, 3))
    sparse = st.one_of(st.just(0), entries)
    return (
        M(n, n, draw(st.lists(sparse, min_size=n * n, max_size=n * n))),
        M(m, n, draw(st.lists(sparse, min_size=m * n, max_size=m * n))),
    )


@settings(max_examples=25, deadline=None, derandomize=True)
@given(systems(), st.sampled_from(["sequential", "parallel"]))
def test_random_systems(system, form):
    A, H = system
    found = decompose_by_outputs(A, H, form)
    judge_outputs(
        A, H, found.transformation, found.matrix, found.outputs, found.sizes, found.remaining, form
    )
    judge_inputs(A.T, H.T, decompose_by_inputs(A.T, H.T, form))


def test_errors_and_display():
    with pytest.raises(ValueError, match='form: expected "sequential" or "parallel"'):
        decompose_by_inputs(*SEVEN, "shuttle")
    import numpy as np

    with pytest.raises(ValueError, match="exact"):
        decompose_by_outputs(np.eye(2), np.ones((1, 2)), "parallel")
    assert "TAT^{-1}" in decompose_by_inputs(*SEVEN, "parallel")._repr_latex_()
