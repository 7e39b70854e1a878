"""Exact linear algebra over the field of the entries: rationals, radicals, functions.

With symbols a rank is generic: the one for all values of the symbols but those on which some
polynomial vanishes.
"""

from random import Random

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.hyperbolic import HyperbolicFunction
from sympy.functions.elementary.trigonometric import TrigonometricFunction
from sympy.polys.matrices import DomainMatrix

from trajlib._real_symbols import as_real
from trajlib.stability.inequalities import equation

#: Terms of a matrix beyond which an elimination with symbols may take minutes.
_MOST_TERMS = 200
#: Terms of a matrix times its symbols beyond which its inverse takes minutes, and pages.
_LONGEST_INVERSE = 300


def field_matrix(matrix):
    """Return the matrix over the smallest field of its entries, where zero is decided exactly."""
    _refuse_functions(matrix)
    return DomainMatrix.from_Matrix(matrix, extension=True).to_field()


def _refuse_functions(matrix):
    for term in sorted(matrix.atoms(sp.Function, sp.Pow), key=str):
        symbols = term.free_symbols if isinstance(term, sp.Function) else term.exp.free_symbols
        if symbols and not isinstance(term, AppliedUndef):
            displayed = term.xreplace({s: sp.Symbol(s.name) for s in term.free_symbols})
            angle = isinstance(term, (TrigonometricFunction, HyperbolicFunction))
            hint = ", or the rational functions of tau = tan(angle/2)" if angle else ""
            raise ValueError(
                f"A: {displayed} stands in the system, and a rank with such functions is not exact "
                f"here; put symbols for them{hint}"
            )


def rank(matrix):
    """Return the exact rank; generic if there are symbols.

    Raises NotImplementedError where the symbols are too many to decide it.
    """
    if 0 in matrix.shape:
        return 0
    # Full rank at one point is full rank in general; the elimination is for what falls short.
    if _has_full_rank_at_a_point(matrix):
        return min(matrix.shape)
    if matrix.free_symbols and number_of_terms(matrix) > _MOST_TERMS:
        raise NotImplementedError(
            f"A: with {len(matrix.free_symbols)} symbols the rank falls short at random "
            "values, and whether it always does is beyond the methods here; give some of the "
            "symbols values"
        )
    return field_matrix(matrix).rank()


def _has_full_rank_at_a_point(matrix):
    at_point = at_a_point(matrix) if matrix.free_symbols else None
    return at_point is not None and field_matrix(at_point).rank() == min(matrix.shape)


def number_of_terms(matrix):
    return sum(len(sp.Add.make_args(sp.numer(sp.together(entry)))) for entry in matrix)


def at_a_point(matrix):
    """Return the matrix at integers for its symbols where it is defined; None if not found."""
    _refuse_functions(matrix)
    symbols, random = sorted(matrix.free_symbols, key=str), Random(len(matrix))
    for _ in range(5):
        at_point = matrix.subs(
            {s: (-1 if s.is_negative else 1) * random.randint(2, 10**4) ** 2 for s in symbols}
        )
        if not at_point.has(sp.nan, sp.zoo) and not at_point.free_symbols:
            return at_point
    return None


def determinant(matrix):
    """Return the determinant from the characteristic polynomial, which needs no division."""
    domain_matrix = DomainMatrix.from_Matrix(matrix, extension=True)
    return sp.Integer(-1) ** matrix.rows * domain_matrix.domain.to_sympy(
        domain_matrix.charpoly()[-1]
    )


def inverse(matrix):
    """Return the inverse.

    Raises NotImplementedError where its entries would be quotients too long to be found or read.
    """
    if len(matrix.free_symbols) * number_of_terms(matrix) > _LONGEST_INVERSE:
        raise NotImplementedError(
            f"A: with {len(matrix.free_symbols)} symbols the new coordinates are too long to be "
            "inverted; give some of the symbols values"
        )
    return tidy(field_matrix(matrix).inv().to_Matrix())


def product(*matrices):
    """Return a product of exact matrices with tidy entries."""
    result = matrices[0]
    for factor in matrices[1:]:
        result = result * factor
    return tidy(result)


def tidy(matrix):
    """Return the matrix with entries in lowest terms, rational functions factored."""

    def entry(e):
        if e.is_Rational:
            return e
        return sp.factor(sp.cancel(e)) if e.free_symbols else sp.radsimp(sp.expand(e))

    return matrix.applyfunc(entry)


def denominator(*matrices):
    """Return the least common denominator of all entries."""
    return sp.lcm_list([sp.denom(sp.together(entry)) for matrix in matrices for entry in matrix])


def factors(polynomial):
    """Return the factors of a polynomial that contain symbols, each once."""
    return [factor for factor, _ in sp.factor_list(polynomial)[1] if factor.free_symbols]


def where_defined(*matrices):
    """Return the real values of the symbols for which no denominator vanishes, as a condition."""
    divisor = denominator(*matrices)
    to_real, from_real = as_real(divisor)
    return sp.And(
        *(sp.Not(equation(factor)) for factor in factors(divisor.xreplace(to_real)))
    ).xreplace(from_real)


def independent_rows(matrix):
    """Return the indices of the rows that do not depend on the rows above them."""
    if 0 in matrix.shape:
        return ()
    first = matrix[: matrix.cols, :]
    if first.rows == first.cols and _has_full_rank_at_a_point(first):
        return tuple(range(first.rows))
    return field_matrix(matrix.T).rref()[1]


def null_columns(matrix):
    """Return a basis of the kernel as columns, in the form of `simple_multiple`."""
    n = matrix.cols
    if not matrix.rows:
        return sp.eye(n)
    if matrix.rows >= n and _has_full_rank_at_a_point(matrix):
        return sp.zeros(n, 0)
    kernel = field_matrix(matrix).nullspace().to_Matrix()
    return sp.Matrix.hstack(
        sp.zeros(n, 0), *(simple_multiple(kernel[i, :]).T for i in range(kernel.rows))
    )


def simple_multiple(vector):
    """Return the multiple with coprime polynomial entries, the first nonzero one positive."""
    entries = [sp.together(e) for e in vector]
    common_denominator = sp.lcm_list([sp.denom(e) for e in entries])
    entries = [sp.cancel(e * common_denominator) for e in entries]
    divisor = sp.gcd_list(entries)
    if divisor not in (0, 1):
        entries = [sp.cancel(e / divisor) for e in entries]
    first = next((e for e in entries if e != 0), sp.Integer(1))
    if first.could_extract_minus_sign():
        entries = [-e for e in entries]
    return sp.Matrix(*vector.shape, [sp.expand(e) for e in entries])
