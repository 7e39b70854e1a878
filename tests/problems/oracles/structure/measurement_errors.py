"""Oracles of measurements with errors and of outputs that change with time: SymPy's null spaces of the derivatives of z
at t = 0."""

import functools
import itertools

import sympy as sp

from oracles.sameness import LOGIC
from oracles.structure.linear_systems import _holds, _values


def with_error(A, H, S, c, start):
    """The derivatives of z at t = 0 as rows for (x(0), C), as many as decide whether z vanishes."""
    start = sp.Matrix(start)
    return sp.Matrix.vstack(*((H * A**k).row_join(c * S**k * start) for k in range(A.rows + S.rows)))


def varying(A, H, time):
    """The same for x(0), by the product rule: twelve derivatives are enough for a plane and a sine."""
    rows = [H]
    for _ in range(11):
        rows.append(rows[-1].diff(time) + rows[-1] * A)
    return sp.Matrix.vstack(*(row.subs(time, 0) for row in rows)).expand()


def where(mutant, N, parameter, found):
    """Whether a condition holds exactly at those values where `found` is true of all vectors of the null space."""
    if not isinstance(mutant, LOGIC):
        return False
    rows = [N.row(i) for i in range(N.rows) if any(N.row(i))]
    minors = (sp.Poly(sp.Matrix.vstack(*chosen).det(), parameter)
              for chosen in itertools.combinations(rows[:8], N.cols))
    common = functools.reduce(sp.gcd, (minor for minor in minors if not minor.is_zero))
    return all(_holds(mutant, parameter, value)
               == all(found(v) for v in N.subs(parameter, value).applyfunc(sp.simplify).nullspace())
               for value in _values(parameter, common, mutant))


def region_with_error(found):
    return lambda mutant, reference, A, H, S, c, start, parameters: where(mutant, with_error(A, H, S, c, start),
                                                                          *parameters, found(A.rows))


def is_basis(vectors, N):
    if not isinstance(vectors, (list, tuple)) or any(not isinstance(v, (list, tuple)) or len(v) != N.cols
                                                     for v in vectors):
        return False
    columns = sp.Matrix(N.cols, len(vectors), lambda i, j: vectors[j][i])
    return columns.rank() == columns.cols == N.cols - N.rank() and (N * columns).expand().is_zero_matrix


def are_bases(mutant, reference, N, parameter):
    if not isinstance(mutant, dict) or {sp.sympify(value) for value in mutant} != {sp.sympify(value)
                                                                                   for value in reference}:
        return False
    return all(is_basis(basis, N.subs(parameter, value)) for value, basis in mutant.items())


def augmented_system(mutant, reference, A, H, S, c, start, parameters=(), own=False):
    """True for the blocks A, 0, 0 and H, with an error block of the least order from some start of which the error
    comes."""
    if len(mutant) != 2:
        return False
    matrix, row, n = sp.Matrix(mutant[0]), sp.Matrix(mutant[1]), A.rows
    if (matrix.rows != matrix.cols or row.shape != (1, matrix.rows) or matrix.rows <= n or matrix[:n, :n] != A
        or row[:, :n] != H \
             or any(matrix[:n, n:]) or any(matrix[n:, :n])):
        return False
    if own and (matrix[n:, n:] != S or row[:, n:] != c):
        return False
    error, shown, count = matrix[n:, n:], row[:, n:], 2 * (matrix.rows + S.rows)
    wanted = sp.Matrix([(c * S**k * sp.Matrix(start))[0] for k in range(count)])
    least = sp.Matrix(S.rows, S.rows, lambda i, j: wanted[i + j]).rank(simplify=True)
    told = sp.Matrix.vstack(*(shown * error**k for k in range(count)))
    return error.rows == least and told.rank(simplify=True) == told.row_join(wanted).rank(simplify=True)


ORACLES = {
    "augmented_system": augmented_system,
    "observable_with_error_parameters": region_with_error(lambda n: lambda v: False),
    "state_found_parameters": region_with_error(lambda n: lambda v: not any(v[:n])),
    "amplitude_found_parameters": region_with_error(lambda n: lambda v: v[n] == 0),
    "unseen_with_error": lambda mutant, reference, *data: is_basis(mutant, with_error(*data)),
    "unseen_with_error_where_lost": lambda mutant, reference, *data: are_bases(mutant, reference,
                                                                               with_error(*data[:-1]), data[-1]),
    "varying_observable_parameters": lambda mutant, reference, A, H, time, parameters: where(
        mutant, varying(A, H, time), *parameters, lambda v: False),
    "varying_unseen_where_lost": lambda mutant, reference, A, H, time, parameter: are_bases(
        mutant, reference, varying(A, H, time), parameter),
}
