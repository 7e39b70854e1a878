"""Outputs z = H e^(At) L u of unknown numbers u: which u are unobservable, exactly, with parameters.

Where an initial state is known in part, as with an error C sin(omega t) whose amplitude alone is
unknown, only some motions of x' = A x are possible: those from x(0) = L u. Such a motion is
unobservable exactly if L u lies in the largest invariant subspace of ker H.

Where a row H(t) consists of sines, cosines, exponentials and powers of t, the products of these
functions with the coordinates obey linear equations with constant coefficients. So z = H(t) x is an
output of a constant system of higher order, from known initial states for every x(0). No rows of
derivatives are needed.
"""

import functools

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.invariant_subspaces import ONE, echelon, kernel, to_floats
from workbook.checks.references.pairs import Pair
from workbook.checks.tools.conditions import Case

#: More functions than this a row H(t) of a problem does not need for its derivatives.
MOST_FUNCTIONS = 16


def initial_states_of(A, H, L, parameters=(), selected=None):
    """Return the `InitialStates` of matrices as the data give them.

    `selected` are the indices of the unknowns whose observability is asked for, by default all.
    """
    return _initial_states(*map(sp.ImmutableMatrix, (A, H, L)), tuple(parameters), selected)


def initial_states_of_varying(A, H, time, parameters=()):
    """Return the products of functions in H(t) and coordinates of x as one constant system.

    Its initial states are those of every x(0).
    """
    functions, rates, rows = _functions(H, time)
    n, E = A.rows, sp.eye(len(functions))
    matrix = sp.kronecker_product(rates, sp.eye(n)) + sp.kronecker_product(E, A)
    begin = sp.Matrix([f.subs(time, 0) for f in functions])
    return initial_states_of(
        matrix, sp.Matrix.hstack(*rows), sp.kronecker_product(begin, sp.eye(n)), parameters
    )


class InitialStates(Pair):
    """A pair (A, H) of rational functions of the parameters, and initial states x(0) = L u.

    `unobservable` are now vectors u; L is a matrix of numbers.
    """

    def __init__(self, A, H, L, parameters, selected=None):
        super().__init__(A, H, parameters)
        if L.rows != A.rows:
            raise UnsuitableData(f"starts of shape {L.shape} belong to no system of order {A.rows}")
        self.unknowns, self._selected = L.cols, selected
        self.starts = [[_fraction(entry) for entry in L.row(i)] for i in range(L.rows)]

    def unobservable_at(self, point):
        """Return a basis of the u, or of those asked for, from which the output stays zero.

        None where an entry is not defined.
        """
        unobservable = super().unobservable_at(point)
        if unobservable is None:
            return None
        # Combinations L u = (unobservable) d; the columns of `unobservable` are independent, so every one has
        # its own u.
        relations = kernel(
            [[*row, *(vector[i] for vector in unobservable)] for i, row in enumerate(self.starts)],
            self.unknowns + len(unobservable),
        )
        unknowns = [relation[: self.unknowns] for relation in relations]
        return (
            unknowns
            if self._selected is None
            else echelon([[vector[i] for i in self._selected] for vector in unknowns])[0]
        )

    @functools.cached_property
    def _observability_cases(self):
        """The `Case` without and the one with unobservable u in the selected unknowns."""
        if self._selected is None:
            return super()._observability_cases
        u = sp.symbols(f"u:{self.unknowns}", real=True, cls=sp.Dummy)
        unobservable = sp.And(
            self._defined,
            *(sp.Eq(row, 0) for row in self._derivative_rows().to_Matrix() * sp.Matrix(u)),
        )
        selected_nonzero = sp.Or(*(sp.Ne(u[i], 0) for i in self._selected))
        fails = sp.And(unobservable, selected_nonzero)
        return Case(sp.And(self._defined, sp.Not(fails)), u, every=True), Case(fails, u)

    def dimension_at(self, values):
        if self._selected is None or all(value.is_Rational for value in values.values()):
            return super().dimension_at(values)
        rows = self._rows_at(values)
        remaining = [i for i in range(self.unknowns) if i not in self._selected]
        ranks = (np.linalg.matrix_rank(part, tol=1e-9) for part in (rows[:, remaining], rows))
        rank_of_remaining, rank = map(int, ranks)
        return len(self._selected) + rank_of_remaining - rank

    def state_of(self, vector):
        return to_floats(self.starts, self.unknowns) @ vector

    def _derivative_rows(self):
        """Return the rows H L, H A L, ...: the derivatives of z at t = 0 as functions of u."""
        rows = super()._derivative_rows()
        starts = [[rows.domain.from_sympy(sp.Rational(x)) for x in row] for row in self.starts]
        return rows * DomainMatrix(starts, (self.order, self.unknowns), rows.domain)


_initial_states = functools.lru_cache(maxsize=64)(InitialStates)


def _fraction(entry):
    entry = sp.nsimplify(entry, rational=True)
    if not entry.is_Rational:
        raise UnsuitableData(f"a start has to be given by rational numbers, not by {entry}")
    return ONE * int(entry.p) / int(entry.q)


def _functions(H, time):
    """Return (f, R, [H1, H2, ...]) with f' = R f and H = f1 H1 + f2 H2 + ..., f of time."""
    parts = [_split(entry, time) for entry in H]
    functions = list(dict.fromkeys(f for part in parts for f in part))
    slopes = []
    while len(slopes) < len(functions):
        slopes.append(_split(functions[len(slopes)].diff(time), time))
        functions += [f for f in slopes[-1] if f not in functions]
        if len(functions) > MOST_FUNCTIONS:
            raise UnsuitableData(
                "H(t) has to consist of sines, cosines, exponentials and powers of the time"
            )
    rates = sp.Matrix([[slope.get(f, 0) for f in functions] for slope in slopes])
    rows = [sp.Matrix(*H.shape, [part.get(f, 0) for part in parts]) for f in functions]
    return functions, rates, rows


def _split(expression, time):
    """Return {function of time: its coefficient} of a sum."""
    coefficients = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        coefficient, function = term.as_independent(time, as_Add=False)
        if coefficient != 0:
            coefficients[function] = coefficients.get(function, 0) + coefficient
    return coefficients
