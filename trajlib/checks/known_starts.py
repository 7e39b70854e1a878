"""Outputs z = H e^(At) L u of unknown numbers u: which u the output never shows, for all values of the parameters, exactly.

Where a start is known in part, as with an error C sin(omega t) whose amplitude alone is unknown, only some motions of x' = A x come
into question: those from x(0) = L u. Such a motion is unseen exactly if L u lies in the largest invariant subspace of ker H.
"""

import functools
from random import Random

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from trajlib.checks import coercion
from trajlib.checks.at_values import number_at
from trajlib.checks.dual_questions import as_vectors, tolerance_of
from trajlib.checks.invariant_subspaces import ONE, ZERO, echelon, kernel, to_floats
from trajlib.checks.pairs import Pair
from trajlib.checks.parameter_places import allowed, places
from trajlib.checks.verdict import Invalid, Wrong
from trajlib.checks.wording import number_text, where_text


def starts_of(A, H, L, parameters=(), of=None):
    """The `Starts` of matrices as the data give them; `of` are the positions of the u that is asked for, if not all of it."""
    return _known_starts(sp.ImmutableMatrix(A), sp.ImmutableMatrix(H), sp.ImmutableMatrix(L), tuple(parameters), of)


@functools.lru_cache(maxsize=64)
def _known_starts(A, H, L, parameters, of):
    return Starts(A, H, L, parameters, of)


class Starts(Pair):
    """A pair (A, H) of rational functions of the parameters with the matrix L of numbers: `unseen` are now vectors u."""

    def __init__(self, A, H, L, parameters, of=None):
        super().__init__(A, H, parameters)
        if L.rows != A.rows:
            raise ValueError(f"starts of shape {L.shape} belong to no system of order {A.rows}")
        self.unknowns, self._of = L.cols, of
        self.starts = [[_fraction(entry) for entry in L.row(i)] for i in range(L.rows)]

    def unseen_at(self, place):
        """A basis of the u (or of what is asked of them) from which the output stays zero; None where an entry is not defined."""
        hidden = super().unseen_at(place)
        if hidden is None:
            return None
        # Combinations L u = (hidden) d; the columns of `hidden` are independent, so every one has its own u.
        relations = kernel([[*row, *(vector[i] for vector in hidden)] for i, row in enumerate(self.starts)], self.unknowns + len(hidden))
        found = [relation[:self.unknowns] for relation in relations]
        return found if self._of is None else echelon([[vector[i] for i in self._of] for vector in found])[0]

    @functools.cached_property
    def _minors(self):
        """As in `Pair`, of the rows H L, H A L, ..., which say what the derivatives of z at t = 0 tell of u."""
        A, H = (self._cleared(quotients) for quotients in self._quotients)
        rows, block = [], H
        for _ in range(self.order):
            rows.append(block)
            block = block * A
        starts = DomainMatrix([[H.domain.from_sympy(sp.Rational(x.numerator, x.denominator)) for x in row] for row in self.starts],
                              (self.order, self.unknowns), H.domain)
        told = rows[0].vstack(*rows[1:]) * starts
        random, found = Random(5), []
        for _ in range(2):
            mix = DomainMatrix([[H.domain(random.randint(-9, 9)) for _ in range(told.shape[0])] for _ in range(self.unknowns)],
                               (self.unknowns, told.shape[0]), H.domain)
            found.append(self._determinant(mix * told))
        if any(poly.is_zero for poly in found):
            return [found[0] + found[1]]
        common = found[0].gcd(found[1])
        return [common, *(poly.quo(common) for poly in found)]


def judge_starts(answer, starts, where=""):
    """A basis of the unseen u, as a list of vectors or as the columns of a matrix."""
    n = starts.unknowns
    vectors = as_vectors(answer, n, starts.parameters)
    tolerance = tolerance_of(*vectors)
    for (values, place), unseen in zip(starts.samples, starts.unseen):
        at = where or where_text(values)
        said = np.array([[number_at(entry, values, f"component {i} of your vector {k}") for i, entry in enumerate(vector, 1)]
                         for k, vector in enumerate(vectors, 1)]).reshape(len(vectors), n)
        space, _ = np.linalg.qr(to_floats(unseen, n).T)
        for k, vector in enumerate(said, 1):
            size = np.linalg.norm(vector)
            if size == 0:
                raise Wrong(f"your vector {k} is zero{at}; a basis consists of vectors that are not")
            if not np.linalg.norm(vector - space @ (space.T @ vector)) <= tolerance * size:
                raise Wrong(f"{_seen(starts, place, vector, k)}{at}")
        if len(said) and np.linalg.svd(said / np.linalg.norm(said, axis=1)[:, None], compute_uv=False)[-1] < 1e-2 * tolerance:
            raise Wrong(f"your {len(said)} vectors are linearly dependent{at}")
        if len(said) < len(unseen):
            raise Wrong(f"the number of independent vectors with z = 0 for all time is {len(unseen)}{at}; your answer has "
                        f"{len(said) or 'none'} of them")
    return "each of them gives z = 0 for all time, they are independent, and there are no more" if vectors else \
        "nothing but zero gives z = 0 for all time"


def judge_where_lost(answer, starts, parameter, at_value):
    """{value of the parameter: basis of the unseen u there}; `at_value(value)` are the `Starts` without the parameter.

    For what is lost at finitely many values, all of them rational.
    """
    if not isinstance(answer, dict):
        example = [3, 1, *[0] * (starts.unknowns - 2)]
        raise Invalid(f"expected a dictionary such as {{4: [{example}]}}, from each value to a basis of what is unseen there")
    lost, named = _values_where_lost(starts, parameter), {}
    for key, basis in answer.items():
        value = coercion.as_number(key)
        near = [other for other in lost if (coercion.rounds_to(value, other, scale=1e-3) if value.has(sp.Float)
                                            else sp.simplify(value - other) == 0)]
        if not near:
            raise Wrong(f"at {parameter} = {sp.N(value, 4) if value.has(sp.Float) else value} nothing but zero gives z = 0 for all time")
        if near[0] in named:
            raise Wrong(f"the value {parameter} = {key} comes twice")
        named[near[0]] = basis
    if len(named) < len(lost):
        raise Wrong(f"the number of values at which something is unseen is {len(lost)}; your answer names {len(named) or 'none'} of them")
    for value, basis in named.items():
        judge_starts(basis, at_value(value), f" for {parameter} = {value}")
    return "at these values of the parameter and no others something is unseen, and the vectors are bases of it"


def _values_where_lost(starts, parameter):
    if all(starts.unseen):
        raise ValueError("something is unseen for all values in general position")
    found = []
    for place in places((ZERO,), (ONE,), starts.boundaries):
        if allowed(place, [parameter]) and starts.unseen_at(place):
            if place.irrational:
                raise ValueError("something is unseen at an irrational value")
            (value,) = place.coordinates
            found.append(sp.Rational(value.numerator, value.denominator))
    return found


def _seen(starts, place, vector, k):
    """Why a vector does not belong: the first derivative of z at t = 0 that is not zero."""
    A, H = (to_floats(rows, starts.order) for rows in starts.at(place))
    state, growth = to_floats(starts.starts, starts.unknowns) @ vector, max(1.0, np.linalg.norm(A))
    scale = max(np.linalg.norm(state), 1e-30)
    for order in range(starts.order):
        for j, value in enumerate(H @ state):
            if abs(value) > 1e-4 * scale * growth**order * max(np.linalg.norm(H[j]), 1e-30):
                output = ("z" if len(H) == 1 else f"z{j + 1}") + "'" * order
                return f"your vector {k} gives {output} = {number_text(value)} at t = 0 and not 0"
        state = A @ state
    return f"your vector {k} does not keep z = 0 to three digits"


def _fraction(entry):
    entry = sp.nsimplify(entry, rational=True)
    if not entry.is_Rational:
        raise ValueError(f"a start has to be given by rational numbers, not by {entry}")
    return ONE * int(entry.p) / int(entry.q)
