"""Unobservable states, exactly: the largest subspace of ker H that A maps into itself.

A motion x' = A x keeps z = H x equal to zero for all time exactly if it begins in this subspace. It
is found by removing from ker H what A maps out of it, again and again, in exact elimination of
fractions. The uncontrollable part is the same for the transposed matrices.
"""

import itertools
from fractions import Fraction

import numpy as np
import sympy as sp

ZERO, ONE = Fraction(0), Fraction(1)


def unobservable_subspace(A, H):
    """Return a basis, a list of vectors, of the states from which H x stays zero.

    A and H are lists of rows.
    """
    basis = kernel(H, len(A))
    while basis:
        images = [product(A, vector) for vector in basis]
        # Which combinations of the basis stay in its span: those for which images * c = basis * d
        # has a solution.
        relations = kernel(list(zip(*images, *basis)), 2 * len(basis))
        if len(relations) == len(basis):
            break
        basis = [combined(relation[: len(basis)], basis) for relation in relations]
    return basis


def restricted(A, basis):
    """Return the matrix F, a list of rows, of A on an invariant subspace: A (basis) = (basis) F."""
    size = len(basis)
    rows, _ = echelon(list(zip(*basis, *(product(A, vector) for vector in basis))))
    return [list(row[size:]) for row in rows[:size]]


def kernel(rows, columns):
    """Return a basis of the solutions of `rows` x = 0 in so many unknowns."""
    reduced, pivots = echelon(rows)
    basis = []
    for free in sorted(set(range(columns)) - set(pivots)):
        vector = [ZERO] * columns
        vector[free] = ONE
        for row, pivot in zip(reduced, pivots):
            vector[pivot] = -row[free]
        basis.append(vector)
    return basis


def echelon(rows):
    """Return the reduced echelon form without zero rows, and the columns of its pivots."""
    remaining, reduced, pivots = [list(row) for row in rows], [], []
    for column in range(len(remaining[0]) if remaining else 0):
        chosen = next((row for row in remaining if row[column]), None)
        if chosen is None:
            continue
        remaining.remove(chosen)
        inverse = ONE / chosen[column]
        chosen = [inverse * entry for entry in chosen]
        remaining, reduced = (
            [
                [a - row[column] * b for a, b in zip(row, chosen)] if row[column] else row
                for row in part
            ]
            for part in (remaining, reduced)
        )
        reduced.append(chosen)
        pivots.append(column)
    return reduced, pivots


def product(rows, vector):
    """Return the matrix with these rows times a vector."""
    return [sum((a * x for a, x in zip(row, vector) if a and x), ZERO) for row in rows]


def combined(weights, vectors):
    """Return the sum of the vectors with these weights."""
    return [sum((c * x for c, x in zip(weights, entries)), ZERO) for entries in zip(*vectors)]


def characteristic_coefficients(rows):
    """Return coefficients of det(lambda I - rows), highest first, by Leverrier's recursion."""
    n, power, coefficients = len(rows), None, [ONE]
    for k in range(1, n + 1):
        # power = rows * (power + found[-1] * E), with the first one being the matrix itself.
        inner = [
            [
                (power[i][j] if power else ZERO) + (coefficients[-1] if i == j else ZERO)
                for j in range(n)
            ]
            for i in range(n)
        ]
        columns = [product(rows, column) for column in zip(*inner)]
        power = [list(row) for row in zip(*columns)]
        coefficients.append(-sum((power[i][i] for i in range(n)), ZERO) / k)
    return coefficients


def different_roots(coefficients):
    """Return the different complex roots of a polynomial with fractions as coefficients.

    A multiple root is returned once, without loss of digits.
    """
    poly = sp.Poly([sp.Rational(c.numerator, c.denominator) for c in coefficients], sp.Symbol("s"))
    simple = [float(c) for c in poly.sqf_part().all_coeffs()]
    roots = np.roots(simple)
    for _ in range(3):
        roots = roots - np.polyval(simple, roots) / np.polyval(np.polyder(simple), roots)
    return roots


def chain(first, matrix, count):
    """Return [first, first * matrix, first * matrix^2, ...], so many matrices of SymPy."""
    return list(itertools.accumulate([first, *[matrix] * (count - 1)], lambda rows, A: rows * A))


def maximal_minors(matrix):
    """Yield the minors of a matrix that have all its columns."""
    for rows in itertools.combinations(range(matrix.rows), matrix.cols):
        yield matrix.extract(list(rows), list(range(matrix.cols))).det(method="berkowitz")


def rank_falls(s, A, H):
    """Return the condition that the columns of s - A above H are dependent, for a complex s."""
    minors = maximal_minors((s * sp.eye(A.rows) - A).col_join(H))
    return sp.And(*(sp.Eq(part, 0) for minor in minors for part in sp.expand(minor).as_real_imag()))


def orthogonal_complement(rows):
    """Return an orthonormal basis, in rows, of the orthogonal complement of independent rows."""
    return np.linalg.svd(rows)[2][len(rows) :] if len(rows) else np.eye(rows.shape[1])


def to_floats(rows, columns):
    """Return rows of fractions as an array of floats, also if there are none."""
    return np.array([[float(entry) for entry in row] for row in rows]).reshape(len(rows), columns)
