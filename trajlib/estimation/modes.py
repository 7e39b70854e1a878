"""Closed-form solutions of linear equations, also for repeated or opposite eigenvalues.

For a linear operator M with the eigenvalues l_1, ..., l_N (with multiplicity) Putzer's resolvent is

    (sE - M)^-1 v = sum over k of (M - l_1 E)...(M - l_{k-1} E) v / ((s - l_1)...(s - l_k))

and its partial fractions c/(s - l)^{j+1} correspond to t^j e^{lt}/j! in continuous time and to C(k,
j) l^{k-j} in discrete time (for l = 0: 1 at k = j, else 0). No eigenvectors are needed, so
defective matrices are no exception.
"""

import sympy as sp

from trajlib._real_symbols import vanishes
from trajlib.estimation.exact_or_float import tidy, tidy_entry
from trajlib.stability.inequalities import equation


def exact_spectrum(A):
    """Return the eigenvalues of an exact matrix, with multiplicity.

    Raises NotImplementedError if they cannot be written with square roots.
    """
    polynomial, eigenvalues = A.charpoly(), []
    s = polynomial.gen
    for factor, multiplicity in sp.factor_list(polynomial.as_expr(), s)[1]:
        factor = sp.Poly(factor, s)
        if factor.degree() == 0:
            continue
        if factor.degree() <= 2:
            a, b, c = [0, *factor.all_coeffs()][-3:]
            if factor.degree() == 1:
                roots = [-c / b]
            else:
                root = sp.sqrt(sp.factor(b**2 - 4 * a * c))
                roots = [(-b + root) / (2 * a), (-b - root) / (2 * a)]
        else:
            roots = sp.roots(factor, cubics=False, quartics=False, multiple=True)
            if len(roots) < factor.degree():
                shown = factor.as_expr().subs(s, sp.Symbol("lambda"))
                raise NotImplementedError(
                    f"A: the roots of {shown} cannot be written with square roots; give the "
                    "matrices as arrays of floats"
                )
        eigenvalues += [sp.radsimp(sp.expand(root)) for root in roots] * multiplicity
    return eigenvalues


def sums(eigenvalues):
    """Return the eigenvalues of X -> AX + XA^T on symmetric matrices."""
    return [
        sp.radsimp(sp.expand(a + b))
        for i, a in enumerate(eigenvalues)
        for b in eigenvalues[: i + 1]
    ]


def products(eigenvalues):
    """Return the eigenvalues of X -> AXA^T on symmetric matrices."""
    return [
        sp.radsimp(sp.expand(a * b))
        for i, a in enumerate(eigenvalues)
        for b in eigenvalues[: i + 1]
    ]


class Modes:
    """Partial fractions of (sE - M)^-1 start.

    `apply`: X -> MX on matrices of the shape of `start`; `eigenvalues`: all of M, with
    multiplicity; `where`: the condition on symbols under which they hold.
    """

    def __init__(self, apply, eigenvalues, start) -> None:
        self.values, order = _distinct(eigenvalues)
        self.terms: dict = {}
        self._denominators: set = set()
        fraction, remainder = None, start
        for i in order:
            fraction = self._divided(fraction, i)
            for key, coefficient in fraction.items():
                self.terms[key] = (
                    self.terms.get(key, sp.zeros(*start.shape)) + coefficient * remainder
                )
            remainder = (apply(remainder) - self.values[i] * remainder).applyfunc(
                lambda e: sp.radsimp(sp.expand(e))
            )
            if remainder.is_zero_matrix:
                break
        self.terms = {
            key: tidy(matrix) for key, matrix in self.terms.items() if not matrix.is_zero_matrix
        }
        self.where = _nonzero(self._denominators)

    def _divided(self, fraction, i):
        """Return the partial fractions of the product with 1/(s - l_i)."""
        if fraction is None:
            return {(i, 0): sp.Integer(1)}
        product = {}
        for (k, j), coefficient in fraction.items():
            if k == i:
                _add(product, (k, j + 1), coefficient)
                continue
            gap = sp.radsimp(sp.expand(self.values[i] - self.values[k]))
            self._denominators.add(gap)
            for power in range(j + 1):
                _add(product, (k, power), -coefficient / gap ** (j - power + 1))
            _add(product, (i, 0), coefficient / gap ** (j + 1))
        return {key: tidy_entry(c) for key, c in product.items()}

    def at(self, basis, complex_basis):
        """Return the sum of all terms.

        `basis(l, j)` is the function of a term, `complex_basis(l, j)` its real and imaginary part
        for a complex l. A pair of conjugate eigenvalues gives twice the real part of one of them.
        """
        total, paired = None, set()
        for (i, j), matrix in self.terms.items():
            if (i, j) in paired:
                continue
            value = self.values[i]
            if value.has(sp.I) and not vanishes(sp.im(value)):
                partner = next(
                    k
                    for k, candidate in enumerate(self.values)
                    if vanishes(candidate - sp.conjugate(value))
                )
                paired.add((partner, j))
                real, imaginary = complex_basis(value, j)
                parts = [
                    matrix.applyfunc(lambda e, k=k: sp.radsimp(sp.expand(e)).as_real_imag()[k])
                    for k in (0, 1)
                ]
                term = 2 * (parts[0] * real - parts[1] * imaginary)
            else:
                term = matrix * basis(value, j)
            total = term if total is None else total + term
        return total


def _add(terms, key, value):
    terms[key] = terms.get(key, 0) + value


def _distinct(eigenvalues):
    """Return the distinct values, and for each eigenvalue the index of its value."""
    values, order = [], []
    for value in eigenvalues:
        position = next(
            (k for k, distinct in enumerate(values) if vanishes(value - distinct)), None
        )
        if position is None:
            values.append(value)
        order.append(len(values) - 1 if position is None else position)
    # Repeated eigenvalues are adjacent, so that partial fractions stay short.
    return values, sorted(order)


def _nonzero(denominators):
    """Return the condition that no expression vanishes, written without square roots."""
    factors = set()
    for gap in denominators:
        condition = sp.numer(sp.together(gap))
        for root in [p for p in condition.atoms(sp.Pow) if p.exp == sp.S.Half and p.free_symbols]:
            y = sp.Dummy("y")
            condition = sp.resultant(condition.subs(root, y), y**2 - root.base, y)
        factors |= {
            f for f, _ in sp.factor_list(condition)[1] if f.free_symbols and not f.is_nonzero
        }
    return sp.And(*(sp.Not(equation(factor)) for factor in factors))


def continuous_basis(t):
    """Return t^j e^{lt}/j! and its real and imaginary part, as functions of (l, j)."""

    def plain(value, j):
        return t**j * sp.exp(value * t) / sp.factorial(j)

    def split(value, j):
        a, b = value.as_real_imag()
        size = t**j * sp.exp(a * t) / sp.factorial(j)
        return size * sp.cos(b * t), size * sp.sin(b * t)

    return plain, split


def discrete_basis(k):
    """Return C(k, j) l^{k-j} and its real and imaginary part, for integers k >= 0."""

    def choose(j):
        return sp.prod([k - i for i in range(j)]) / sp.factorial(j)

    def plain(value, j):
        return sp.KroneckerDelta(k, j) if value == 0 else choose(j) * value ** (k - j)

    def split(value, j):
        angle, size = sp.arg(value), sp.sqrt(sp.expand(value * sp.conjugate(value)))
        return tuple(
            choose(j) * size ** (k - j) * wave(angle * (k - j)) for wave in (sp.cos, sp.sin)
        )

    return plain, split
