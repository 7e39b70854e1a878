"""Oracle of measurements with errors: SymPy's ranks of the derivatives of the error."""

import sympy as sp


def augmented_system(mutant, reference, system, parameters=(), own=False):
    """True for the blocks A, 0, 0 and H, with an error block of the least order from some start of
    which the error comes."""
    if len(mutant) != 2:
        return False
    A, H, S, c = system.A, system.H, system.S, system.c
    matrix, row, n = sp.Matrix(mutant[0]), sp.Matrix(mutant[1]), A.rows
    if (
        matrix.rows != matrix.cols
        or row.shape != (1, matrix.rows)
        or matrix.rows <= n
        or matrix[:n, :n] != A
        or row[:, :n] != H
        or any(matrix[:n, n:])
        or any(matrix[n:, :n])
    ):
        return False
    if own and (matrix[n:, n:] != S or row[:, n:] != c):
        return False
    error, shown, count = matrix[n:, n:], row[:, n:], 2 * (matrix.rows + S.rows)
    wanted = sp.Matrix([(c * S**k * system.start)[0] for k in range(count)])
    least = sp.Matrix(S.rows, S.rows, lambda i, j: wanted[i + j]).rank(simplify=True)
    told = sp.Matrix.vstack(*(shown * error**k for k in range(count)))
    return error.rows == least and told.rank(simplify=True) == told.row_join(wanted).rank(
        simplify=True
    )


ORACLES = {"augmented_system": augmented_system}
