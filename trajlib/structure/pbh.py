"""Kernels of a polynomial matrix P(lambda) at the roots of an irreducible polynomial f.

The PBH test (Popov, Belevitch, Hautus; Theorems 2.3 - 2.6) asks for the rank of such a matrix at
the eigenvalues. All roots of an irreducible f are alike, so the elimination runs in the field of
the polynomials in lambda modulo f and never needs the roots themselves; the kernel is given in
terms of lambda, for any root.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib._typing import Matrix
from trajlib.structure.exact import simple_multiple

# A stand-in, so that the user's own matrices may contain a symbol lambda.
LAMBDA = sp.Dummy("lambda")


@dataclass(frozen=True)
class HiddenMode:
    """An unobservable or uncontrollable mode: the rank in the PBH test falls at its eigenvalue.

    Attributes
    ----------
    eigenvalue : sympy.Expr, complex or sympy.Poly
        The eigenvalue in closed form, or, where it has none, the irreducible polynomial in lambda
        that it is a root of; the vectors then contain lambda.
    vectors : matrix
        For observability the columns v with A v = lambda v, H v = 0; for controllability the rows w
        with w A = lambda w, w B = 0.
    """

    eigenvalue: sp.Expr | sp.Poly | complex
    vectors: Matrix

    def _repr_latex_(self):
        vectors = sp.Matrix(self.vectors)
        if isinstance(self.eigenvalue, sp.Poly):
            value = f"{sp.latex(self.eigenvalue.as_expr())} = 0"
        else:
            value = rf"\lambda = {sp.latex(sp.sympify(self.eigenvalue))}"
        return rf"$\displaystyle {value}:\quad {sp.latex(vectors)}$"


def visible_symbol(*matrices, names=("lambda", "s", "mu", "lambda_")):
    """Return lambda, or another symbol if the matrices contain one of that name."""
    used = {s.name for m in matrices for s in m.free_symbols - {LAMBDA}}
    return sp.Symbol(next(name for name in names if name not in used))


def hidden_modes(P, determinant, basis=None):
    """Return the modes with P(lambda) v = 0 (given as `basis` v) at the roots of `determinant`."""
    modes, shown = [], visible_symbol(P)
    for factor, kernel in (
        pair for f in irreducible_factors(determinant, P) for pair in kernels_modulo(P, f)
    ):
        if not kernel.cols:
            continue
        if basis is not None:
            kernel = sp.Matrix.hstack(
                *(simple_multiple(basis * kernel[:, j]) for j in range(kernel.cols))
            )
        roots = closed_roots(factor)
        if not roots:
            modes.append(HiddenMode(factor.replace(LAMBDA, shown), kernel.subs(LAMBDA, shown)))
        modes += [
            HiddenMode(root, kernel.subs(LAMBDA, root).applyfunc(_simplified_entry))
            for root in roots
        ]
    return tuple(modes)


def irreducible_factors(polynomial, P):
    """Return the monic irreducible factors in lambda over the field of P, each once."""
    domain = _field([*P, polynomial])
    if not domain.is_EX:
        return [f.monic() for f, _ in sp.Poly(polynomial, LAMBDA, domain=domain).factor_list()[1]]
    numerator = sp.numer(sp.together(polynomial))
    return [
        sp.Poly(f, LAMBDA, domain=domain).monic()
        for f, _ in sp.factor_list(numerator)[1]
        if f.has(LAMBDA)
    ]


def _field(entries):
    return sp.construct_domain(
        [c for e in entries for c in sp.Poly(e, LAMBDA).all_coeffs()], extension=True, field=True
    )[0]


def closed_roots(f):
    """Return the roots in closed form, or () where such a formula would be too long."""
    if f.degree() <= 2 or (f.degree() == 4 and f.nth(3) == f.nth(1) == 0):
        return tuple(sorted(sp.roots(f.as_expr(), f.gen), key=sp.default_sort_key))
    return ()


def kernels_modulo(P, f):
    """Yield pairs (factor, basis of the kernel of P at its roots) for a monic square-free f.

    The basis has columns in lambda. There is one pair, (f, kernel), if f is irreducible. An f that
    is reducible over a field in which SymPy cannot factor shows it by an element without inverse;
    then its two parts are treated one by one.
    """
    domain = _field([*P, f.as_expr()])
    f = f.set_domain(domain)
    try:
        yield f, _kernel(P, f, domain)
    except _Divisor as divisor:
        for part in (divisor.args[0], f.quo(divisor.args[0])):
            yield from kernels_modulo(P, part.monic())


class _Divisor(Exception):
    """Signals a proper divisor of the modulus, its argument."""


def _kernel(P, f, domain):
    """Return the kernel of P by Gaussian elimination modulo f."""
    rows = [[sp.Poly(e, LAMBDA, domain=domain).rem(f) for e in P.row(i)] for i in range(P.rows)]
    pivots = []
    for column in range(P.cols):
        top = len(pivots)
        row = next((i for i in range(top, len(rows)) if not rows[i][column].is_zero), None)
        if row is None:
            continue
        rows[top], rows[row] = rows[row], rows[top]
        inverse = _inverse(rows[top][column], f)
        rows[top] = [(e * inverse).rem(f) for e in rows[top]]
        for i in range(len(rows)):
            multiple = rows[i][column]
            if i != top and not multiple.is_zero:
                rows[i] = [(e - multiple * p).rem(f) for e, p in zip(rows[i], rows[top])]
        pivots.append(column)
    columns = []
    for free in (j for j in range(P.cols) if j not in pivots):
        vector = [sp.Integer(0)] * P.cols
        vector[free] = sp.Integer(1)
        for i, pivot in enumerate(pivots):
            vector[pivot] = -rows[i][free].as_expr()
        columns.append(simple_multiple(sp.Matrix(vector)))
    return sp.Matrix.hstack(sp.zeros(P.cols, 0), *columns)


def _inverse(element, f):
    try:
        return element.invert(f)
    except sp.polys.polyerrors.NotInvertible:
        raise _Divisor(element.gcd(f)) from None


def _simplified_entry(entry):
    return sp.radsimp(sp.expand(entry)) if not entry.free_symbols else sp.expand(entry)
