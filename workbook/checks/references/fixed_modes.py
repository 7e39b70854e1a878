"""Eigenvalues that no gain changes: those of A on the states that an output never shows.

They come from the largest invariant subspace inside ker H, exactly, and not from a rank test. Those
that no control reaches are the same for the transposed matrices.
"""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.references.invariant_subspaces import (
    characteristic_coefficients,
    different_roots,
    restricted,
)
from workbook.checks.references.pairs import pair_of
from workbook.checks.tools.conditions import Case, ReferenceCondition

#: Real parts computed in floating point; below this the eigenvalue lies on the border.
ON_BORDER = 1e-9


def fixed_eigenvalues(pair):
    """The different eigenvalues at every sample of the parameters: a list of arrays, parallel to
    `pair.samples`."""
    return [
        different_roots(characteristic_coefficients(restricted(pair.at(place)[0], unseen)))
        if unseen
        else np.array([])
        for (_, place), unseen in zip(pair.samples, pair.unobservable)
    ]


def slower_than(margin, pair):
    """Whether for some of the samples a fixed eigenvalue has a real part above -margin; without one
    not below zero."""
    limit = ON_BORDER - float(margin) if margin else -ON_BORDER
    return any((values.real > limit).any() for values in fixed_eigenvalues(pair))


def greatest_margin(pair):
    """The greatest margin that a gain gives, exact, or None if there is no greatest one; without
    parameters."""
    (unseen,) = pair.unobservable
    if not unseen:
        return None
    ((_, place),) = pair.samples
    coefficients = [
        sp.Rational(c.numerator, c.denominator)
        for c in characteristic_coefficients(restricted(pair.at(place)[0], unseen))
    ]
    roots = sp.Poly(coefficients, sp.Dummy("s")).sqf_part().all_roots()
    return -max((sp.re(root) for root in roots), key=float)


def common_margin(equation):
    """The same for a feedback by an estimate of one equation, a `Scalar`: with v(d/dt) x = w(d/dt)
    u, z = m(d/dt) x a common root of v and w is out of reach, one of v and m hidden."""
    left, *others = (
        sp.Poly(side, equation.symbol)
        for side in (equation.left, equation.right, equation.measured)
    )
    roots = [root for other in others for root in sp.gcd(left, other).all_roots()]
    return -max(map(sp.re, roots), key=float) if roots else None


def margins_with_parameters(A, H, mu, parameters):
    """The `ReferenceCondition` that a gain for x' = Ax, z = Hx gives the margin mu, in mu and the parameters: no
    eigenvalue u + i w > -mu at which the columns of u + i w - A above H are dependent (the test of
    Popov)."""
    u, w = sp.symbols("u w", real=True, cls=sp.Dummy)
    pencil = ((u + sp.I * w) * sp.eye(A.rows) - A).col_join(H)
    minors = (
        pencil.extract(list(rows), list(range(A.rows))).det(method="berkowitz")
        for rows in itertools.combinations(range(pencil.rows), A.rows)
    )
    dependent = sp.And(
        *(sp.Eq(part, 0) for minor in minors for part in sp.expand(minor).as_real_imag())
    )

    def at(values):
        if not all(value.is_Rational for value in values.values()):
            return None
        best = greatest_margin(pair_of(A.subs(values), H.subs(values)))
        return best is None or bool(values[mu] <= best)

    return ReferenceCondition(
        (Case(sp.Or(u <= -mu, sp.Not(dependent)), (u, w), every=True),),
        (Case(sp.And(u > -mu, dependent), (u, w)),),
        at,
    )
