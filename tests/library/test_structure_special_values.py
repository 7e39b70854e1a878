"""Decompositions with parameters hold exactly where their condition `where` is true."""

import itertools

import numpy as np
import pytest
import sympy as sp

from trajlib.structure import (
    controllability_decomposition,
    controllability_matrix,
    controller_canonical_form,
    decompose_by_inputs,
    decompose_by_outputs,
    observability_decomposition,
    observability_matrix,
    observer_canonical_form,
)

a, b = sp.symbols("a b")
M = sp.Matrix
VALUES = [-1, 0, sp.Rational(1, 2), 1]
PAIRS = [
    (M([[1, a], [0, 2]]), M([[1, b]])),
    (M([[1 / a, 1], [0, b]]), M([[1, 0]])),
    (M([[1, 0, 0], [0, 1, 0], [0, a, 2]]), M([[1, 1, b]])),
    (M([[a, 1, 0], [0, a, 0], [b, 0, 1]]), M([[1, 0, 0]])),
    (M([[0, 1, 0], [0, 0, a], [0, 0, b]]), M([[1, 0, 0], [0, a, 1]])),
    (M([[a, 0, 0], [0, b, 0], [0, 0, 1]]), M([[1, 1, 1]])),
    (M([[a * b, 1], [0, a]]), M([[a - b, 1]])),
]


def at(matrix, point):
    """The matrix at a point; None where an entry is not defined."""
    there = matrix.subs(point)
    return None if there.has(sp.zoo, sp.nan, sp.oo) else there


def holds(A, T, new):
    """Whether T takes A to `new`, T being invertible and all of them defined."""
    return None not in (A, T, new) and T.det() != 0 and (T * A - new * T).is_zero_matrix


@pytest.mark.slow
@pytest.mark.parametrize("A, H", PAIRS)
def test_observability_and_controllability_decompositions(A, H):
    by_outputs, by_inputs = (
        observability_decomposition(A, H),
        controllability_decomposition(A.T, H.T),
    )
    k = by_outputs.sizes[0]
    assert by_inputs.sizes == by_outputs.sizes
    verdicts = set()
    for values in itertools.product(VALUES, repeat=2):
        point = dict(zip((a, b), values))
        here, shown = at(A, point), at(H, point)
        for found, system in ((by_outputs, here), (by_inputs, here and here.T)):
            right = holds(system, at(found.transformation, point), at(found.matrix, point))
            assert (found.where.subs(point) == sp.true) == right, (found.where, point)
            verdicts.add(right)
            if right and found is by_outputs:
                outputs = at(found.outputs, point)
                assert (
                    outputs[:, k:].is_zero_matrix and at(found.matrix, point)[:k, k:].is_zero_matrix
                )
                assert (
                    observability_matrix(at(found.matrix, point)[:k, :k], outputs[:, :k]).rank()
                    == k
                )
                assert observability_matrix(here, shown).rank() == k
            elif right:
                inputs = at(found.inputs, point)
                assert (
                    inputs[k:, :].is_zero_matrix and at(found.matrix, point)[k:, :k].is_zero_matrix
                )
                assert (
                    controllability_matrix(at(found.matrix, point)[:k, :k], inputs[:k, :]).rank()
                    == k
                )
    for found in (by_outputs, by_inputs):
        assert (r"\neq" in found._repr_latex_()) == (found.where != sp.true)
    assert True in verdicts and (
        False in verdicts or by_outputs.where == by_inputs.where == sp.true
    )


@pytest.mark.parametrize(
    "A, H",
    [
        pair
        for pair in PAIRS
        if pair[1].rows == 1 and observability_matrix(*pair).rank() == pair[0].rows
    ],
)
def test_canonical_forms(A, H):
    """There is one exactly where the pair is observable (controllable)."""
    for found, system in (
        (observer_canonical_form(A, H), A),
        (controller_canonical_form(A.T, H.T), A.T),
    ):
        for values in itertools.product(VALUES, repeat=2):
            point = dict(zip((a, b), values))
            here, shown = at(A, point), at(H, point)
            right = here is not None and observability_matrix(here, shown).rank() == A.rows
            assert (found.where.subs(point) == sp.true) == right, (found.where, point)
            if right:
                assert holds(
                    at(system, point), at(found.transformation, point), at(found.matrix, point)
                )


@pytest.mark.parametrize("form", ["sequential", "parallel"])
@pytest.mark.parametrize(
    "A, H",
    [
        (M([[1, a], [0, 2]]), M([[1, 0], [0, b]])),
        (M([[1, 0, b], [0, 2, 0], [a, 0, 1]]), M([[1, 0, 0], [0, 1, 1]])),
        (M([[0, 1, 0], [0, 0, a], [0, 0, b]]), M([[1, 0, 0], [0, a, 1]])),
    ],
)
def test_component_decompositions(A, H, form):
    for found, system in (
        (decompose_by_outputs(A, H, form), A),
        (decompose_by_inputs(A.T, H.T, form), A.T),
    ):
        for values in itertools.product(VALUES, repeat=2):
            point = dict(zip((a, b), values))
            right = holds(
                at(system, point), at(found.transformation, point), at(found.matrix, point)
            )
            assert (found.where.subs(point) == sp.true) == right, (found.where, point)


def test_no_conditions_without_symbols():
    for A, H in (
        (M([[1, 1], [0, 2]]), M([[1, 0]])),
        (np.array([[1.0, 1], [0, 2]]), np.array([[1.0, 0]])),
    ):
        for found in (observability_decomposition(A, H), observer_canonical_form(A, H)):
            assert found.where == sp.true and "neq" not in found._repr_latex_()


def test_parameters_are_real_and_keep_their_signs():
    k = sp.Symbol("k", positive=True)
    assert observability_decomposition(M([[0, k], [0, 1]]), M([[1, 0]])).where == sp.true
    assert observability_decomposition(M([[0, a**2 + 1], [0, 1]]), M([[1, 0]])).where == sp.true
    assert observability_decomposition(M([[0, a], [0, 1]]), M([[1, 0]])).where == sp.Ne(a, 0)
