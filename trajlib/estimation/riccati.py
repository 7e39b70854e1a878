"""Exact solution of algebraic Riccati equations by spectral factorisation.

The stabilising P spans, as (E; P), the invariant subspace of the Hamiltonian matrix that belongs to
its eigenvalues in the left half-plane. Their polynomial p is a factor of the characteristic
polynomial, which is even:

    s^2 - c               p = s + sqrt(c),                        c > 0
    s^4 + c1 s^2 + c0     p = s^2 + alpha s + beta,               beta = sqrt(c0), alpha = sqrt(2 beta - c1)

and p(M) (E; P) = 0 is a linear equation for P. There is such a P only if no eigenvalue lies on the
axis: c > 0, c0 > 0 and 2 beta > c1. In discrete time the symplectic pencil L - zM becomes a
Hamiltonian matrix by z = (1 + s)/(1 - s), also for a singular Phi.
"""

from contextlib import suppress

import numpy as np
import sympy as sp

from trajlib._real_symbols import as_real, sign_of_number, vanishes
from trajlib.estimation.exact_or_float import solve
from trajlib.stability.inequalities import equation, positive
from trajlib.stability.regions import stability_conditions

#: Digits with which rows are told from dependent ones, as many as are needed.
DIGITS = (15, 60, 240)


def continuous_hamiltonian(A, H, Q, R):
    S = H.T * solve(R, H)
    return sp.Matrix(sp.BlockMatrix([[A.T, -S], [-Q, -A]]))


def discrete_hamiltonian(Phi, H, Q, R):
    """Return the Hamiltonian matrix of the symplectic pencil; None if -1 is an eigenvalue.

    In that case there is no stabilising solution.
    """
    n, S = Phi.rows, H.T * solve(R, H)
    left = sp.Matrix(sp.BlockMatrix([[Phi.T, sp.zeros(n)], [-Q, sp.eye(n)]]))
    right = sp.Matrix(sp.BlockMatrix([[sp.eye(n), S], [sp.zeros(n), Phi]]))
    try:
        return solve(left + right, left - right)
    except np.linalg.LinAlgError:
        return None


class _EigenvalueOnAxis(Exception):
    """An eigenvalue of the Hamiltonian matrix is imaginary: there is no stabilising solution."""


class Stabilising:
    """Stabilising solution for a Hamiltonian matrix.

    `P` is the solution, None if there is none, and `where` the condition under which it holds. P is
    written in auxiliary symbols for the roots; `in_given_symbols` puts a matrix of such entries in
    lowest terms and in the given symbols.
    """

    def __init__(self, hamiltonian):
        self._roots, self._conditions, self._from_real, self.P, self.where = (
            [],
            [],
            {},
            None,
            sp.false,
        )
        if hamiltonian is None:
            return
        to_real, self._from_real = as_real(hamiltonian)
        M = hamiltonian.xreplace(to_real)
        with suppress(_EigenvalueOnAxis):
            self._solve(M, self._stable_factor(M))

    def _stable_factor(self, M):
        """Return the coefficients of p, highest first."""
        polynomial = M.charpoly()
        s = polynomial.gen
        parts = [
            (sp.Poly(f, s).monic(), times)
            for f, times in sp.factor_list(polynomial.as_expr(), s)[1]
            if sp.Poly(f, s).degree()
        ]
        product = sp.Poly(1, s)
        while parts:
            f, times = parts.pop()
            if f.nth(0) == 0:
                raise _EigenvalueOnAxis
            mirrored = sp.Poly(f.as_expr().subs(s, -s), s).monic()
            if f == mirrored:
                piece = self._half(f)
            else:
                parts = [(g, k) for g, k in parts if g != mirrored]
                piece = (
                    self._half(f * mirrored)
                    if f.degree() <= 2
                    else self._stable_factor_of_pair(f, mirrored)
                )
            product = product * piece**times
        return product.all_coeffs()

    def _half(self, even):
        """Return the factor of an even polynomial with its roots on the left."""
        s = even.gen
        if even.degree() == 2:
            return sp.Poly(s + self._root(-even.nth(0)), s)
        if even.degree() == 4:
            beta = self._root(even.nth(0))
            return sp.Poly(s**2 + self._root(2 * beta - even.nth(2)) * s + beta, s)
        y = sp.Dummy("y")
        inner = sp.Poly(sum(c * y ** (k // 2) for (k,), c in even.terms()), y)
        roots = sp.roots(inner, cubics=False, quartics=False, multiple=True)
        if len(roots) < inner.degree() or inner.free_symbols_in_domain:
            raise NotImplementedError(
                "an exact solution of the Riccati equation needs the roots of "
                f"{inner.as_expr(sp.Symbol('y'))}, which square roots do not express; give the "
                "matrices as arrays of floats"
            )
        half = sp.Poly(1, s)
        for root in roots:
            if vanishes(sp.im(root)):
                half *= sp.Poly(s + self._root(root), s)
            elif sp.im(root) > 0:
                size = sp.sqrt(sp.expand(root * sp.conjugate(root)))
                half *= sp.Poly(
                    s**2 + self._root(2 * size - 2 * sp.re(root)) * s + self._root(size**2), s
                )
        return half

    def _stable_factor_of_pair(self, f, mirrored):
        if not f.free_symbols_in_domain:
            for factor in (f, mirrored):
                if stability_conditions(factor.as_expr(), [], symbol=f.gen).region == sp.true:
                    return factor
        raise NotImplementedError(
            f"an exact solution of the Riccati equation needs the roots of {f.as_expr()}; give the "
            "matrices as arrays of floats"
        )

    def _root(self, square):
        """Return the positive root, and record the condition that it exists.

        It is an auxiliary symbol unless it is an element of the field.
        """
        square = sp.factor(square)
        value = square.xreplace(dict(self._expanded_roots()))
        if not value.free_symbols:
            condition = sp.sympify(sign_of_number(value) > 0)
        else:
            condition = sp.true if value.is_positive else _positive(value)
        if condition == sp.false:
            raise _EigenvalueOnAxis
        self._conditions.append(condition)
        root = sp.sqrt(sp.sqrtdenest(square)) if not square.free_symbols else sp.sqrt(square)
        if not root.atoms(sp.Pow) - square.atoms(sp.Pow) or root.is_Rational:
            return root
        symbol = sp.Dummy("root", positive=True)
        self._roots.append((symbol, square))
        return symbol

    def _expanded_roots(self):
        full = {}
        for symbol, square in self._roots:
            full[symbol] = sp.sqrt(square.xreplace(full))
        return full

    def _solve(self, M, factor):
        n = M.rows // 2
        value = sp.zeros(2 * n)
        for coefficient in factor:
            value = (value * M + coefficient * sp.eye(2 * n)).applyfunc(self._reduced)
        V, W = value[:, :n], value[:, n:]
        rows = self._independent(W)
        if rows is None:
            return
        W, V = W.extract(rows, list(range(n))), V.extract(rows, list(range(n)))
        P = -(W.adjugate() * V / W.det()).applyfunc(self._reduced)
        self.P = ((P + P.T) / 2).applyfunc(self._reduced)
        denominator = sp.lcm_list([sp.denom(sp.together(entry)) for entry in self.P])
        conditions = [
            sp.Not(equation(f))
            for f, _ in sp.factor_list(denominator)[1]
            if f.free_symbols
            and not f.is_nonzero
            and not f.has(*(symbol for symbol, _ in self._roots))
        ]
        self.where = sp.And(*self._conditions, *conditions).xreplace(self._from_real)

    def _independent(self, W):
        """Return the indices of n independent rows of W, or None."""
        symbols = sorted(W.free_symbols - {symbol for symbol, _ in self._roots}, key=str)
        roots, rng = self._expanded_roots(), np.random.default_rng(1)
        symbols = sorted(
            set(symbols).union(*(root.free_symbols for root in roots.values())), key=str
        )
        for _ in range(60):
            signs = [
                1 if s.is_positive else -1 if s.is_negative else rng.choice([-1, 1])
                for s in symbols
            ]
            point = {
                s: sign * sp.Rational(int(rng.integers(1, 40)), 7)
                for s, sign in zip(symbols, signs)
            }
            if not all(c.subs(point) == sp.true for c in self._conditions):
                continue
            for digits in DIGITS:
                values = {
                    symbol: sp.N(root.subs(point), 2 * digits) for symbol, root in roots.items()
                }
                rows = _independent_rows(W.subs(point).subs(values).evalf(2 * digits), digits)
                if len(rows) == W.cols:
                    return rows
            return None
        return None

    def _reduced(self, entry):
        """Return an entry linear in each auxiliary symbol, with none in the denominator."""
        for k in range(len(self._roots) - 1, -1, -1):
            symbol, square = self._roots[k]
            if entry.has(symbol):
                relation = symbol**2 - square
                numerator, denominator = (
                    sp.rem(part, relation, symbol) for part in sp.fraction(sp.together(entry))
                )
                conjugate = denominator.subs(symbol, -symbol)
                numerator, denominator = (
                    sp.rem(sp.expand(part * conjugate), relation, symbol)
                    for part in (numerator, denominator)
                )
                return sum(
                    self._reduced(numerator.coeff(symbol, i) / denominator) * symbol**i
                    for i in (0, 1)
                )
        return sp.factor(sp.cancel(entry)) if entry.free_symbols else sp.radsimp(sp.expand(entry))

    def in_given_symbols(self, matrix):
        return (
            matrix.applyfunc(self._reduced)
            .xreplace(self._expanded_roots())
            .xreplace(self._from_real)
        )


def _independent_rows(matrix, digits):
    """Return the indices of rows that are independent of those before, to so many digits."""
    reduced, rows = [], []
    for i in range(matrix.rows):
        row = list(matrix.row(i))
        size = max(map(abs, row))
        for pivot, pivot_row in reduced:
            factor = row[pivot] / pivot_row[pivot]
            row = [entry - factor * pivot_entry for entry, pivot_entry in zip(row, pivot_row)]
        pivot = max(range(len(row)), key=lambda j: abs(row[j]))
        if abs(row[pivot]) > size * sp.Float(10) ** -digits:
            reduced.append((pivot, row))
            rows.append(i)
    return rows


def _positive(expression):
    """Return expression > 0, in lowest terms for polynomials and rational functions."""
    if (
        expression.atoms(sp.Pow) and any(not p.exp.is_Integer for p in expression.atoms(sp.Pow))
    ) or expression.has(sp.Abs):
        return sp.Gt(expression, 0)
    return positive(expression)
