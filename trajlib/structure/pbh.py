"""Kernels of a polynomial matrix P(lambda) at the roots of an irreducible polynomial f.

Popov's criteria (Theorems 2.3 - 2.6) ask for the rank of such a matrix at the characteristic
numbers. All roots of an irreducible f are alike, so the elimination runs in the field of the
polynomials in lambda modulo f and never needs the roots themselves; the kernel comes out in terms
of lambda, whatever root lambda is.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib.structure.exact import simple_multiple

# A stand-in, so that the user's own matrices may contain a symbol lambda.
LAMBDA = sp.Dummy("lambda")


@dataclass(frozen=True)
class HiddenMode:
    """A characteristic number at which the rank in Popov's criterion falls.

    `eigenvalue`: the number in closed form, or, where it has none, the irreducible `sp.Poly` in
    lambda that it is a root of; the vectors then contain lambda. `vectors`: for observability the
    matrix whose columns v satisfy A v = lambda v, H v = 0; for controllability the one whose rows w
    satisfy w A = lambda w, w B = 0.
    """

    eigenvalue: object
    vectors: object

    def _repr_latex_(self):
        vectors = sp.Matrix(self.vectors)
        if isinstance(self.eigenvalue, sp.Poly):
            value = f"{sp.latex(self.eigenvalue.as_expr())} = 0"
        else:
            value = rf"\lambda = {sp.latex(sp.sympify(self.eigenvalue))}"
        return rf"$\displaystyle {value}:\quad {sp.latex(vectors)}$"


def visible_symbol(*matrices, names=("lambda", "s", "mu", "lambda_")):
    """The lambda of results: a plain symbol, with another name if the matrices contain one that is
    called so."""
    used = {s.name for m in matrices for s in m.free_symbols - {LAMBDA}}
    return sp.Symbol(next(name for name in names if name not in used))


def hidden_modes(P, determinant, basis=None):
    """The `HiddenMode`s at the roots of `determinant` (expressions in LAMBDA): columns v with
    P(lambda) v = 0, or, with a `basis`, `basis` v."""
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
        modes += [HiddenMode(root, kernel.subs(LAMBDA, root).applyfunc(_settled)) for root in roots]
    return tuple(modes)


def irreducible_factors(polynomial, P):
    """Monic irreducible factors in lambda over the field of the coefficients of P, each once."""
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
    """The roots in closed form, or () where a formula would help nobody."""
    if f.degree() <= 2 or (f.degree() == 4 and f.nth(3) == f.nth(1) == 0):
        return tuple(sorted(sp.roots(f.as_expr(), f.gen), key=sp.default_sort_key))
    return ()


def kernels_modulo(P, f):
    """Pairs (factor, basis of the kernel of P at its roots, as columns in lambda) for a monic f
    without multiple roots.

    There is one pair, (f, kernel), if f is irreducible. An f that falls apart over a field in which
    SymPy cannot factor shows it by an element without inverse; then its two parts are treated one
    by one.
    """
    domain = _field([*P, f.as_expr()])
    f = f.set_domain(domain)
    try:
        yield f, _kernel(P, f, domain)
    except _Divisor as divisor:
        for part in (divisor.args[0], f.quo(divisor.args[0])):
            yield from kernels_modulo(P, part.monic())


class _Divisor(Exception):
    """The argument is a proper divisor of the modulus."""


def _kernel(P, f, domain):
    """Gauss's elimination modulo f."""
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


def _settled(entry):
    return sp.radsimp(sp.expand(entry)) if not entry.free_symbols else sp.expand(entry)
