"""What is unseen, as bases: for a system, for all values of a parameter, or at the values at which observability is
lost. Of the transposed matrices: the combinations of the coordinates that no control changes.

A condition such as alpha != 1 may be guessed; the states that stay unseen at the value left out may not. The truth is
that of `pairs`: the largest invariant subspace in the kernel of the output, at every value where it can appear.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from trajlib.checks.contract import coercion
from trajlib.checks.contract.tolerance import in_decimals, rounds_to, share
from trajlib.checks.contract.verdict import Invalid, Wrong
from trajlib.checks.structure.dual_questions import how_many
from trajlib.checks.tools.conditions import allowed
from trajlib.checks.tools.values import number_at
from trajlib.checks.tools.wording import number_text, where_text
from trajlib.checks.truths.invariant_subspaces import to_floats
from trajlib.checks.truths.pairs import place_of, special_values


def judge_basis(answer, pair, side, at=None):
    """A basis of what is unseen, as a list of vectors or as the columns of a matrix; `at` tells of the place, if `pair`
    does not."""
    n = pair.unknowns
    vectors = as_vectors(answer, n, pair.parameters)
    tolerance = share(*vectors)
    for (values, place), unseen in [*zip(pair.samples, pair.unseen), *_where_vectors_fail(vectors, pair)]:
        where = where_text(values) if at is None else at
        said = np.array([[number_at(entry, values, f"component {i} of your vector {k}")
                          for i, entry in enumerate(vector, 1)]
                         for k, vector in enumerate(vectors, 1)]).reshape(len(vectors), n)
        space, _ = np.linalg.qr(to_floats(unseen, n).T)
        for k, vector in enumerate(said, 1):
            size = np.linalg.norm(vector)
            if size == 0:
                raise Wrong(f"your vector {k} is zero{where}; a basis consists of vectors that are not")
            if not np.linalg.norm(vector - space @ (space.T @ vector)) <= tolerance * size:
                raise Wrong(f"{_seen(pair, place, vector, k, side)}{where}")
        if len(said) and np.linalg.svd(said / np.linalg.norm(said, axis=1)[:, None],
                                       compute_uv=False)[-1] < 1e-2 * tolerance:
            raise Wrong(f"your {len(said)} vectors are linearly dependent{where}")
        if len(said) < len(unseen):
            raise Wrong(f"there {how_many(unseen, side)}{where}; your answer has {len(said) or 'none'} of them")
    return side.basis_right if vectors else side.none_free


def _where_vectors_fail(vectors, pair):
    """Rational values of a single parameter at which the vectors are not defined or become dependent: a basis that
    serves for all values has to serve there too."""
    if len(pair.parameters) != 1 or not vectors or not all(e.is_rational_function(*pair.parameters) for v in vectors
                                                           for e in v):
        return []
    (parameter,) = pair.parameters
    columns = sp.Matrix(vectors).T.applyfunc(lambda e: sp.together(sp.nsimplify(e, rational=True)))
    if columns.has(sp.nan, sp.zoo, sp.oo):
        return []  # undefined at every sample as well
    minors = [sp.numer(sp.together(columns.extract(list(rows), list(range(columns.cols))).det(method="berkowitz")))
              for rows in itertools.combinations(range(columns.rows), columns.cols)]
    critical = [sp.Poly(e, parameter, domain="QQ") for e in (*map(sp.denom, columns), functools.reduce(sp.gcd, minors))]
    at_roots = [{parameter: value} for value in special_values(critical, parameter)]
    return [((values, place_of(values)), unseen) for values in at_roots
            if (unseen := pair.unseen_at(place_of(values))) is not None]


def as_vectors(answer, n, parameters):
    """A list of vectors from a list, a set, a matrix whose columns they are; none of them from anything empty."""
    if isinstance(answer, np.ndarray) and answer.ndim == 2:
        answer = sp.Matrix(*answer.shape, [sp.sympify(x) for x in answer.ravel().tolist()])
    if isinstance(answer, np.ndarray):
        answer = answer.tolist()  # one vector, or none
    if isinstance(answer, sp.MatrixBase):
        if 0 in answer.shape:
            return []
        if n not in answer.shape:
            raise Invalid(f"expected a list of vectors with {n} components each, or a matrix whose columns they are; "
                          f"the shape of yours is {answer.shape}")
        if answer.rows != n:
            answer = answer.T  # an array made of a list of vectors has them as rows
        answer = [list(answer.col(j)) for j in range(answer.cols)]
    if answer is sp.S.EmptySet:
        return []
    if not isinstance(answer, (list, tuple, set, frozenset, sp.FiniteSet, sp.Tuple)):
        raise Invalid(f"expected a list of vectors with {n} components each")
    parts = list(answer)
    if parts and n > 1 and all(isinstance(part, (int, float, complex, sp.Expr)) and not isinstance(part, bool)
                               for part in parts):
        parts = [parts]  # a single vector, written without the outer list
    if n > 1 and len(parts) == n and all(isinstance(part, (list, tuple)) and len(part) == 1 for part in parts):
        parts = [[part[0] for part in parts]]  # a single column
    return [coercion.as_expressions(part, parameters, n) for part in parts]


def _seen(pair, place, vector, k, side):
    """Why a vector does not belong: the first of the numbers H A^k v, or w A^k B, that is not zero."""
    A, H = (to_floats(rows, pair.order) for rows in pair.at(place))
    state = pair.state_of(vector)
    scale, growth = max(np.linalg.norm(state), 1e-30), max(1.0, np.linalg.norm(A))
    for order in range(pair.order):
        for j, value in enumerate(H @ state):
            if abs(value) > 1e-4 * scale * growth**order * max(np.linalg.norm(H[j]), 1e-30):
                return side.shows(k, order, "" if len(H) == 1 else j + 1, number_text(value))
        state = A @ state
    return side.shows_little.format(k=k)


def judge_where_lost(answer, pair, side, at_value):
    """Every real value of the single parameter at which something is unseen, as {value: basis of what is unseen there}.

    For what is lost at finitely many values, all of them rational; `at_value(value)` is the pair without the parameter.
    """
    (parameter,) = pair.parameters
    if not isinstance(answer, dict):
        example = [3, 1, *[0] * (pair.unknowns - 2)]
        raise Invalid(f"expected a dictionary such as {{4: [{example}]}}, from each value to a basis of {side.left} "
                      f"there")
    lost, named = _values_where_lost(pair, parameter), {}
    for key, basis in answer.items():
        value = coercion.as_number(key)
        near = [other for other in lost if _same(value, other)]
        if not near:
            raise Wrong(f"at {parameter} = {sp.N(value, 4) if value.has(sp.Float) else value} {side.none_free}")
        if near[0] in named:
            raise Wrong(f"the value {parameter} = {key} comes twice")
        named[near[0]] = basis
    if len(named) < len(lost):
        raise Wrong(f"the number of values at which the system is {side.fails} is {len(lost)}; your answer names "
                    f"{len(named) or 'none'} of them")
    for value, basis in named.items():
        judge_basis(basis, at_value(value), side, f" for {parameter} = {value}")
    return (f"at these values of the parameter and no others the system is {side.fails}, and the vectors are bases of "
            f"{side.left}")


def _values_where_lost(pair, parameter):
    """The exceptional values, SymPy rationals."""
    if all(pair.unseen):
        raise ValueError("something is unseen for all values in general position")
    values = special_values(pair.boundaries, parameter)
    real = {root for poly in pair.boundaries for root in sp.Poly(poly, parameter).real_roots() if not root.is_Rational}
    if any(pair.dimension_at({parameter: root}) for root in real if allowed(parameter, 1 if root > 0 else -1)):
        raise ValueError("something is unseen at an irrational value")
    return [value for value in values if pair.unseen_at(place_of({parameter: value}))]


def _same(value, other):
    """Decimals count to three digits; what is exact has to be right."""
    return rounds_to(value, other, size=1) if in_decimals(value) else sp.simplify(value - other).is_zero
