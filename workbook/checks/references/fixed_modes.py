"""Fixed eigenvalues, which no gain changes: those of A on the unobservable states.

They come from the largest invariant subspace inside ker H, exactly, and not from a rank test. Those
of the uncontrollable part are the same for the transposed matrices.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.references.invariant_subspaces import (
    characteristic_coefficients,
    different_roots,
    maximal_minors,
    rank_falls,
    restricted,
)
from workbook.checks.references.pairs import pair_of
from workbook.checks.tools.conditions import Case, ReferenceCondition

#: Real parts computed in floating point; below this the eigenvalue lies on the border.
ON_BORDER = 1e-9


def fixed_eigenvalues(pair, claim=()):
    """Return the different fixed eigenvalues, an array at each of `pair.samples_for(claim)`."""
    return [
        different_roots(_characteristic(pair, point, unobservable))
        if unobservable
        else np.array([])
        for _, point, unobservable in pair.samples_for(claim)
    ]


def _characteristic(pair, point, unobservable):
    """Return the coefficients of the characteristic polynomial of A on the unobservable states."""
    return characteristic_coefficients(restricted(pair.at(point)[0], unobservable))


def slower_than(degree, pair):
    """Return whether for a sample a fixed eigenvalue has a real part above -degree.

    For 0 the real part must not be below zero.
    """
    limit = ON_BORDER - float(degree) if degree else -ON_BORDER
    return any((values.real > limit).any() for values in fixed_eigenvalues(pair))


def greatest_degree(pair):
    """Return the greatest degree of stability that a gain gives, exact, or None if there is no greatest one.

    The pair must not have parameters.
    """
    ((_, point, unobservable),) = pair.samples_for(())
    if not unobservable:
        return None
    coefficients = map(sp.Rational, _characteristic(pair, point, unobservable))
    roots = sp.Poly(list(coefficients), sp.Dummy("s")).sqf_part().all_roots()
    return -max(map(sp.re, roots), key=float)


def common_degree(equation):
    """Return the greatest degree of stability of feedback by an estimate for one equation, a `Scalar`.

    With v(d/dt) x = w(d/dt) u, z = m(d/dt) x a common root of v and w is uncontrollable, one of v and m
    unobservable.
    """
    left, *polynomials = (
        sp.Poly(side, equation.symbol)
        for side in (equation.left, equation.right, equation.measured)
    )
    roots = [root for polynomial in polynomials for root in sp.gcd(left, polynomial).all_roots()]
    return -max(map(sp.re, roots), key=float) if roots else None


def unobservable_eigenvalues_at(A, H, values):
    """Return the eigenvalues at which the columns of s - A above H are dependent, as floats.

    Whether there are any is decided exactly, for parameters that are algebraic numbers: they are the
    roots of the greatest common divisor of all minors.
    """
    s = sp.Dummy("s")
    pencil = (s * sp.eye(A.rows) - A).col_join(H).subs(values)
    minors = (sp.Poly(minor, s, extension=True) for minor in maximal_minors(pencil))
    return np.array(functools.reduce(sp.gcd, minors).nroots(), dtype=complex)


def degrees_with_parameters(A, H, mu, parameters):
    """Return the `ReferenceCondition` that a gain for x' = Ax, z = Hx gives the degree mu.

    It is a condition on mu and the parameters: by the PBH test, no eigenvalue u + i w with u > -mu at
    which the columns of u + i w - A above H are dependent.
    """
    u, w = sp.symbols("u w", real=True, cls=sp.Dummy)
    dependent = rank_falls(u + sp.I * w, A, H)

    def at(values):
        if all(value.is_Rational for value in values.values()):
            best = greatest_degree(pair_of(A.subs(values), H.subs(values)))
            return best is None or bool(values[mu] <= best)
        if not all(value.is_algebraic for value in values.values()):
            return None
        largest = unobservable_eigenvalues_at(A, H, values).real.max(initial=-np.inf)
        return bool(largest <= ON_BORDER - float(values[mu]))

    return ReferenceCondition(
        (Case(sp.Or(u <= -mu, sp.Not(dependent)), (u, w), every=True),),
        (Case(sp.And(u > -mu, dependent), (u, w)),),
        at,
    )
