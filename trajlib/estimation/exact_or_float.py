"""Linear algebra for exact matrices and arrays where their operators differ.

Products, sums and transposes are written once for both, with @ and .T.
"""

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.exceptions import DMNonInvertibleMatrixError


def solve(S, B):
    """Return S^-1 B for a square matrix; raise numpy's LinAlgError if it is singular."""
    if isinstance(S, np.ndarray):
        return np.linalg.solve(S, B)
    # Over the field that the entries generate, with elements such as exp(t), zero is decided
    # exactly.
    wide = DomainMatrix.from_Matrix(S.row_join(B), extension=True).to_field()
    n = S.rows
    try:
        solution = wide[:, :n].lu_solve(wide[:, n:])
    except DMNonInvertibleMatrixError:
        raise np.linalg.LinAlgError("the matrix is singular") from None
    return tidy(solution.to_Matrix())


def tidy(matrix):
    """Return exact entries in lowest terms; an array unchanged."""
    return matrix if isinstance(matrix, np.ndarray) else matrix.applyfunc(tidy_entry)


def tidy_entry(entry):
    if entry.is_Rational:
        return entry
    if not entry.free_symbols:
        return sp.radsimp(sp.expand(entry))
    roots = {p for p in entry.atoms(sp.Pow) if abs(p.exp) == sp.S.Half and p.base.free_symbols}
    if len({p.base for p in roots}) == 1:
        return _with_one_root(entry, sp.sqrt(roots.pop().base))
    return sp.factor(sp.cancel(entry))


def _with_one_root(entry, root):
    """Return c + d root with rational c and d.

    SymPy's cancel does not use that the square of the root is rational.
    """
    y = sp.Dummy("y")
    square = y**2 - root.base
    numerator, denominator = (
        sp.rem(part, square, y) for part in sp.fraction(sp.together(entry.subs(root, y)))
    )
    conjugate = denominator.subs(y, -y)
    denominator, numerator = (
        sp.rem(sp.expand(denominator * conjugate), square, y),
        sp.rem(sp.expand(numerator * conjugate), square, y),
    )
    return sum(sp.factor(sp.cancel(numerator.coeff(y, k) / denominator)) * root**k for k in (0, 1))


def symmetric(matrix):
    """Return a covariance made exactly symmetric."""
    return (matrix + matrix.T) / 2 if isinstance(matrix, np.ndarray) else tidy(matrix)


def identity_like(matrix):
    n = matrix.shape[0]
    return np.eye(n) if isinstance(matrix, np.ndarray) else sp.eye(n)


def stack(*matrices):
    return (
        np.vstack(matrices) if isinstance(matrices[0], np.ndarray) else sp.Matrix.vstack(*matrices)
    )


def latex(value):
    """Return LaTeX of a matrix, an array (rounded) or an expression."""
    if isinstance(value, (np.ndarray, float)):
        rounded = np.round(value, 6)
        return sp.latex(sp.Matrix(rounded) if np.ndim(rounded) else float(rounded))
    return sp.latex(value)
