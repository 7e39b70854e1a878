"""Linear motions in closed form, exactly, also where eigenvalues are zero, repeated or sums to
zero.

For a linear operator M with the eigenvalues l_1, ..., l_N (each as often as it counts) Putzer's
resolvent is

    (sE - M)^-1 v = sum over k of (M - l_1 E)...(M - l_{k-1} E) v / ((s - l_1)...(s - l_k))

and its partial fractions c/(s - l)^{j+1} are read as t^j e^{lt}/j! in continuous time and as C(k,
j) l^{k-j} in discrete time (for l = 0: 1 at k = j, else 0). No eigenvector is needed, so nothing
breaks where one is missing.
"""

import sympy as sp

from trajlib._real_symbols import vanishes
from trajlib.estimation.exact_or_float import tidy, tidy_entry
from trajlib.stability.inequalities import equation


def exact_spectrum(A):
    """The eigenvalues of an exact matrix, each as often as it counts. Raises NotImplementedError if
    they cannot be written with square roots."""
    polynomial, found = A.charpoly(), []
    s = polynomial.gen
    for factor, times in sp.factor_list(polynomial.as_expr(), s)[1]:
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
        found += [sp.radsimp(sp.expand(root)) for root in roots] * times
    return found


def sums(eigenvalues):
    """Those of X -> AX + XA^T on symmetric matrices."""
    return [
        sp.radsimp(sp.expand(a + b))
        for i, a in enumerate(eigenvalues)
        for b in eigenvalues[: i + 1]
    ]


def products(eigenvalues):
    """Those of X -> AXA^T on symmetric matrices."""
    return [
        sp.radsimp(sp.expand(a * b))
        for i, a in enumerate(eigenvalues)
        for b in eigenvalues[: i + 1]
    ]


class Modes:
    """The partial fractions of (sE - M)^-1 start; `where`: the condition on symbols under which
    they hold.

    `apply`: X -> MX on matrices of the shape of `start`; `eigenvalues`: all of M, as often as they
    count.
    """

    def __init__(self, apply, eigenvalues, start):
        self.values, order = _distinct(eigenvalues)
        self.terms, self._below = {}, set()
        fraction, rest = None, start
        for i in order:
            fraction = self._divided(fraction, i)
            for key, coefficient in fraction.items():
                self.terms[key] = self.terms.get(key, sp.zeros(*start.shape)) + coefficient * rest
            rest = (apply(rest) - self.values[i] * rest).applyfunc(
                lambda e: sp.radsimp(sp.expand(e))
            )
            if rest.is_zero_matrix:
                break
        self.terms = {
            key: tidy(matrix) for key, matrix in self.terms.items() if not matrix.is_zero_matrix
        }
        self.where = _nonzero(self._below)

    def _divided(self, fraction, i):
        """Partial fractions of the product with 1/(s - l_i)."""
        if fraction is None:
            return {(i, 0): sp.Integer(1)}
        product = {}
        for (k, j), coefficient in fraction.items():
            if k == i:
                _add(product, (k, j + 1), coefficient)
                continue
            gap = sp.radsimp(sp.expand(self.values[i] - self.values[k]))
            self._below.add(gap)
            for power in range(j + 1):
                _add(product, (k, power), -coefficient / gap ** (j - power + 1))
            _add(product, (i, 0), coefficient / gap ** (j + 1))
        return {key: tidy_entry(c) for key, c in product.items()}

    def at(self, basis, complex_basis):
        """The sum of all terms; `basis(l, j)`, and for a complex l its real and imaginary part
        `complex_basis(l, j)`.

        A pair of conjugate eigenvalues gives twice the real part of one of them.
        """
        total, done = None, set()
        for (i, j), matrix in self.terms.items():
            if (i, j) in done:
                continue
            value = self.values[i]
            if value.has(sp.I) and not vanishes(sp.im(value)):
                mirror = next(
                    k
                    for k, other in enumerate(self.values)
                    if vanishes(other - sp.conjugate(value))
                )
                done.add((mirror, j))
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
    """The values without repetition, and for each eigenvalue the number of its value."""
    values, order = [], []
    for value in eigenvalues:
        same = next((k for k, other in enumerate(values) if vanishes(value - other)), None)
        if same is None:
            values.append(value)
        order.append(len(values) - 1 if same is None else same)
    # What is repeated comes together, so that partial fractions stay short.
    return values, sorted(order)


def _nonzero(below):
    """The condition that none of the expressions vanishes, written without square roots."""
    factors = set()
    for gap in below:
        left = sp.numer(sp.together(gap))
        for root in [p for p in left.atoms(sp.Pow) if p.exp == sp.S.Half and p.free_symbols]:
            y = sp.Dummy("y")
            left = sp.resultant(left.subs(root, y), y**2 - root.base, y)
        factors |= {f for f, _ in sp.factor_list(left)[1] if f.free_symbols and not f.is_nonzero}
    return sp.And(*(sp.Not(equation(factor)) for factor in factors))


def continuous_basis(t):
    """t^j e^{lt}/j! and its real and imaginary part."""

    def plain(value, j):
        return t**j * sp.exp(value * t) / sp.factorial(j)

    def split(value, j):
        a, b = value.as_real_imag()
        size = t**j * sp.exp(a * t) / sp.factorial(j)
        return size * sp.cos(b * t), size * sp.sin(b * t)

    return plain, split


def discrete_basis(k):
    """C(k, j) l^{k-j} and its real and imaginary part, for whole k >= 0."""

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
