"""All gains of an observer or a regulator with a prescribed characteristic polynomial.

In the coordinates (xi; eta) of the observability decomposition the errors of the observer obey

    A11 - L1 H1       0
    A21 - L2 H1      A22

so L1 alone moves eigenvalues, those of the pair (A11, H1), which is observable; the polynomial of
A22 is fixed and L2 is free. For one output L1 is unique, L1 = phi(A11) N^-1 e (Ackermann, Bass and
Gura). Several outputs are first joined to one by a chain of Heymann: it gives some of the gains,
not all. Regulators are the same for the transposed system with K = -L^T.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed, require_exact
from trajlib._arguments.renamed import renamed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import exact_decimals, read_expression, read_symbols
from trajlib._typing import ExprLike, MatrixLike
from trajlib.stability.hurwitz import characteristic_polynomial
from trajlib.structure import exact
from trajlib.structure.decomposition import observability_decomposition
from trajlib.structure.fixed_spectrum import detectability, stabilisability
from trajlib.structure.pbh import visible_symbol


@dataclass(frozen=True)
class GainFamily:
    """The gains that give the closed loop a prescribed characteristic polynomial.

    Attributes
    ----------
    gain : sympy.Matrix
        K, s x n, or L, n x m; it contains the symbols `free`, any values of which are admissible.
    free : tuple of sympy.Symbol
        The free symbols of `gain`; empty if no eigenvalue is fixed.
    polynomial : sympy.Expr
        The characteristic polynomial of the closed loop in `symbol`.
    symbol : sympy.Symbol
        The variable of `polynomial` and `fixed`.
    fixed : sympy.Expr
        The factor of the polynomial that no gain changes, 1 if there is none.
    complete : bool
        Whether these are all such gains; with several controls (outputs) there are more.
    """

    gain: sp.Matrix
    free: tuple[sp.Symbol, ...]
    polynomial: sp.Expr
    symbol: sp.Symbol
    fixed: sp.Expr
    complete: bool

    @property
    def simplest(self) -> sp.Matrix:
        """Return the gain with zero for all free symbols."""
        return self.gain.subs(dict.fromkeys(self.free, 0))

    def _repr_latex_(self):
        polynomial = sp.factor(self.polynomial)
        upright = {
            symbol: sp.latex(symbol).replace("free", r"\mathrm{free}") for symbol in self.free
        }
        return rf"$\displaystyle {sp.latex(self.gain, symbol_names=upright)}:\quad {sp.latex(polynomial)}$"


@renamed(margin="degree")
@accepts_state_space("A", "H", C="H")
def observer(
    A: MatrixLike,
    H: MatrixLike,
    polynomial: ExprLike | sp.Poly | None = None,
    symbol: sp.Symbol | None = None,
    *,
    eigenvalues: Sequence[ExprLike] | None = None,
    degree: ExprLike | None = None,
) -> GainFamily:
    """Return all gains L for which A - LH has a prescribed spectrum.

    One of `polynomial`, `eigenvalues` and `degree` prescribes it.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax; exact, also with symbols (then the result holds for general values).
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx; exact.
    polynomial : sympy.Expr or sympy.Poly, optional
        Characteristic polynomial of degree n or, without the fixed factor, of degree rank N; its
        coefficients may be symbols.
    symbol : sympy.Symbol, optional
        Variable of `polynomial`; may be left out if it is its only symbol.
    eigenvalues : sequence of number, optional
        As many numbers as the degree of `polynomial` would be, conjugate ones in pairs.
    degree : float or sympy.Expr, optional
        mu: every eigenvalue that is not fixed goes to -mu.

    Returns
    -------
    GainFamily
        The gains L, n x m, with symbols for what is free.

    Raises
    ------
    ValueError
        If a fixed eigenvalue is not a root of the polynomial or is slower than the degree of stability (the message
        names the mode), if not exactly one prescription is given, if shapes do not fit, or for floats.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB: ``place(A', C', p)'``, ``acker``. Source: Theorem 3.1 and examples 1 - 3 of the problem
    book.

    Examples
    --------
    >>> import sympy as sp
    >>> s, b1, b2 = sp.symbols("s beta1 beta2")
    >>> observer(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([[1, 0]]), s**2 + b1*s + b2, s).gain.T
    Matrix([[beta1, beta2 + 1]])
    >>> hidden = observer(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([[1, 1]]), degree=1)
    >>> hidden.gain.T, hidden.fixed
    (Matrix([[2 - free1, free1]]), lambda + 1)
    """
    require_exact(
        "use place: L = -place(A.T, H.T, eigenvalues).gain.T (trajlib.feedback)", A=A, H=H
    )
    A, H = read_observed(A, H)
    return _family(A, H, _Prescription(polynomial, symbol, eigenvalues, degree), detectability, "N")


@renamed(margin="degree")
@accepts_state_space("A", "B")
def regulator(
    A: MatrixLike,
    B: MatrixLike,
    polynomial: ExprLike | sp.Poly | None = None,
    symbol: sp.Symbol | None = None,
    *,
    eigenvalues: Sequence[ExprLike] | None = None,
    degree: ExprLike | None = None,
) -> GainFamily:
    """Return all gains K for which A + BK has a prescribed spectrum.

    One of `polynomial`, `eigenvalues` and `degree` prescribes it.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; exact, also with symbols (then the result holds for general values).
    B : matrix_like, shape (n, s)
        Matrix of the control; exact.
    polynomial : sympy.Expr or sympy.Poly, optional
        Characteristic polynomial of degree n or, without the fixed factor, of degree rank W.
    symbol : sympy.Symbol, optional
        Variable of `polynomial`; may be left out if it is its only symbol.
    eigenvalues : sequence of number, optional
        As many numbers as the degree of `polynomial` would be, conjugate ones in pairs.
    degree : float or sympy.Expr, optional
        mu: every eigenvalue that is not fixed goes to -mu.

    Returns
    -------
    GainFamily
        The gains K, s x n, with symbols for what is free.

    Raises
    ------
    ValueError
        As `observer`.

    Notes
    -----
    The sign is u = Kx. MATLAB: ``-place(A, B, p)``, ``-acker(A, B, p)``. Source: Theorem 3.3 and
    examples 4 - 6 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> s = sp.Symbol("s")
    >>> regulator(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([0, 1]), s**2 + 2*s + 1, s).gain
    Matrix([[-2, -2]])
    >>> family = regulator(sp.Matrix([[0, 1], [0, -1]]), sp.Matrix([1, 0]), eigenvalues=[-3])
    >>> family.gain, family.polynomial
    (Matrix([[-3, free1]]), lambda**2 + 4*lambda + 3)
    """
    require_exact("use place: K = place(A, B, eigenvalues).gain (trajlib.feedback)", A=A, B=B)
    A, H = read_controlled(A, B)
    family = _family(
        A, H, _Prescription(polynomial, symbol, eigenvalues, degree), _transposed_test, "W"
    )
    gain = (-family.gain.T).subs({symbol: -symbol for symbol in family.free}, simultaneous=True)
    return GainFamily(
        gain, family.free, family.polynomial, family.symbol, family.fixed, family.complete
    )


def _transposed_test(A, H):
    return stabilisability(A.T, H.T)


def _family(A, H, prescription, test, kalman):
    parts = observability_decomposition(A, H)
    observable, unobservable = parts.sizes
    (A11, H1), A22 = parts.part, parts.complement
    symbol = prescription.symbol or visible_symbol(A, H)
    fixed = characteristic_polynomial(A22, symbol) if unobservable else sp.Integer(1)
    movable = prescription.movable(symbol, observable, fixed, lambda: test(A, H), kalman)
    # What has to hold is T L = L1 in the rows of xi: some entries of L stay free, the others
    # follow.
    rows = parts.transformation[:observable, :]
    bound = list(exact.independent_rows(rows.T)) if observable else []
    unbound = [i for i in range(A.rows) if i not in bound]
    used = {s.name for s in A.free_symbols | H.free_symbols | movable.as_expr().free_symbols}
    free = sp.Matrix(unobservable, H.rows, sp.symbols(_names(unobservable * H.rows, used)))
    gain = sp.zeros(A.rows, H.rows)
    for i, row in enumerate(unbound):
        gain[row, :] = free[i, :]
    if observable:
        remainder = (
            _unique_gain(A11, H1, movable) - rows.extract(list(range(observable)), unbound) * free
        )
        gain_rows = exact.product(
            exact.inverse(rows.extract(list(range(observable)), bound)), remainder
        )
        for i, row in enumerate(bound):
            gain[row, :] = gain_rows[i, :].applyfunc(_readable)
    polynomial = sp.expand(movable.as_expr() * fixed)
    return GainFamily(gain, tuple(free), polynomial, symbol, fixed, H.rows == 1)


def _readable(entry):
    entry = sp.cancel(entry)
    return sp.expand(entry) if entry.is_polynomial() else sp.factor(entry)


def _names(count, used):
    candidates = (f"free{k}" for k in range(1, count + len(used) + 1))
    return [name for name in candidates if name not in used][:count]


def _unique_gain(A, H, polynomial):
    """Return L with det(lambda I - A + LH) = polynomial, a choice if there are several outputs."""
    if H.rows == 1:
        return _ackermann(A, H, polynomial)
    joined, weights = _heymann(A.T, H.T)
    chain = A + joined.T * H
    row = weights.T * H
    return _ackermann(chain, row, polynomial) * weights.T - joined.T


def _ackermann(A, h, polynomial):
    """Return phi(A) N^-1 e, from the last column of N^-1 by Horner's rule."""
    n = A.rows
    rows = [h]
    while len(rows) < n:
        rows.append((rows[-1] * A).applyfunc(sp.expand))
    last = exact.inverse(sp.Matrix.vstack(*rows))[:, n - 1]
    gain = sp.zeros(n, 1)
    for coefficient in polynomial.all_coeffs():
        gain = (A * gain + coefficient * last).applyfunc(sp.expand)
    return gain


def _heymann(F, G):
    """Return K and q such that (F + GK, Gq) is controllable, for a controllable pair (F, G)."""
    n, s = G.shape
    first = next(j for j in range(s) if any(G[:, j]))
    states, inputs = G[:, first], []
    while states.cols < n:
        ahead = F * states[:, -1]
        pushes = [sp.zeros(s, 1), *(sp.eye(s)[:, j] for j in range(s))]
        push = next(u for u in pushes if exact.rank(states.row_join(ahead + G * u)) > states.cols)
        states, inputs = states.row_join(exact.tidy(ahead + G * push)), [*inputs, push]
    return exact.product(sp.Matrix.hstack(*inputs, sp.zeros(s, 1)), exact.inverse(states)), sp.eye(
        s
    )[:, first]


class _Prescription:
    """The prescribed spectrum: a polynomial, eigenvalues or a degree of stability."""

    def __init__(self, polynomial, symbol, eigenvalues, degree):
        if sum(part is not None for part in (polynomial, eigenvalues, degree)) != 1:
            raise ValueError("polynomial, eigenvalues, degree: expected one of the three")
        self.symbol = read_symbols(symbol, "symbol")[0] if symbol is not None else None
        self.eigenvalues = eigenvalues
        self.degree = None if degree is None else exact_decimals(read_expression(degree, "degree"))
        if isinstance(polynomial, sp.Poly):
            self.symbol, polynomial = polynomial.gen, polynomial.as_expr()
        self.polynomial = (
            None
            if polynomial is None
            else exact_decimals(read_expression(polynomial, "polynomial"))
        )
        if self.polynomial is not None and self.symbol is None:
            if len(self.polynomial.free_symbols) != 1:
                raise ValueError("symbol: say which symbol the polynomial is in")
            (self.symbol,) = self.polynomial.free_symbols

    def movable(self, symbol, count, fixed, test, kalman):
        """Return the monic characteristic polynomial prescribed for the part of order `count`."""
        if self.degree is not None:
            fixed_spectrum = test()
            if fixed_spectrum.modes and sp.sympify(fixed_spectrum.degree < self.degree) is sp.true:
                raise ValueError(f"degree: {self.degree} cannot be had; {fixed_spectrum.reason}")
            return sp.Poly((symbol + self.degree) ** count, symbol)
        if self.eigenvalues is not None:
            prescribed = sp.Poly(
                sp.expand(
                    sp.prod([symbol - exact_decimals(sp.sympify(e)) for e in self.eigenvalues])
                ),
                symbol,
            )
            if prescribed.has(sp.I):
                raise ValueError("eigenvalues: expected conjugate ones in pairs")
        else:
            prescribed = sp.Poly(self.polynomial, symbol)
        order = count + sp.degree(fixed, symbol)
        if prescribed.degree() not in (count, order):
            raise ValueError(
                f"polynomial: expected the degree {order}"
                + (
                    f", or {count} (the rank of {kalman}) for what is not fixed"
                    if count < order
                    else ""
                )
                + f", got {prescribed.degree()}"
            )
        prescribed = prescribed.monic()
        if prescribed.degree() == count:
            return prescribed
        quotient, remainder = sp.div(prescribed, sp.Poly(fixed, symbol))
        if any(sp.simplify(c) != 0 for c in remainder.all_coeffs()):
            raise ValueError(
                f"polynomial: the factor {sp.factor(fixed)} is fixed and has to divide it; "
                f"{test().reason}"
            )
        return quotient
