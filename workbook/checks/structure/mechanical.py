"""Rank tests of mechanical systems M x'' + D x' + K x = L u, z = H1 x + H2 x'.

The systems are records `Mechanical`. The ranks are those of Theorem 2.5, and of Theorem 2.6 by the
dual system; they need no states.

A rank falls exactly where all maximal minors of its matrix vanish together, so the values of lambda
are the roots of their greatest common divisor, a polynomial with rational coefficients. This holds
for a singular M too. All other questions about these systems are judged in the states (x, x'), in
`observability.py` and `controllability.py`.

No check here is declared by a reference: a wrong value is explained by the rank there.
"""

import dataclasses
import functools

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData, judged
from workbook.checks.references.invariant_subspaces import (
    characteristic_coefficients,
    different_roots,
    maximal_minors,
)
from workbook.checks.references.records import observed_pair
from workbook.checks.structure.dual_questions import (
    CONTROL,
    EIGENVALUES,
    OUTPUT,
    compare_eigenvalues,
    roots_evidence,
)
from workbook.checks.tools.comparisons import SameWord
from workbook.checks.tools.samples import general_values, in_every_case

LAMBDA = sp.Symbol("lambda")
PENCIL = "root of det(M lambda^2 + D lambda + K) = 0"
OUTPUT_PENCIL = dataclasses.replace(
    OUTPUT,
    pencil="(M lambda^2 + D lambda + K; H1 + lambda H2)",
    spectrum=PENCIL,
    vector="vector v other than 0 with (M lambda^2 + D lambda + K) v = 0 and (H1 + lambda H2) "
    "v = 0",
)
CONTROL_PENCIL = dataclasses.replace(
    CONTROL,
    pencil="(M lambda^2 + D lambda + K, L)",
    spectrum=PENCIL,
    vector="row w other than 0 with w (M lambda^2 + D lambda + K) = 0 and w L = 0",
)
#: A root is a value at which the square matrix loses its rank: Theorem 2.5 with the output zero.
ROOTS_PENCIL = dataclasses.replace(
    OUTPUT,
    pencil="M lambda^2 + D lambda + K",
    spectrum=PENCIL,
    vector="vector v other than 0 with (M lambda^2 + D lambda + K) v = 0",
)


@judged(EIGENVALUES, system="Mechanical")
def mechanical_eigenvalues(claim, system, parameters=()):
    """Check the different roots of det(M lambda^2 + D lambda + K), also complex ones.

    M is invertible; with parameters the roots are asked for their values in general position.

    Can decide when the entries are exact numbers; parameters are taken in general position.

    Examples
    --------
    >>> from workbook.systems import Mechanical
    >>> spring = Mechanical(M=[[2]], D=[[0]], K=[[8]], L=[[1]])
    >>> checks.mechanical_eigenvalues([2*sp.I, -2*sp.I], spring).status
    'right'
    >>> checks.mechanical_eigenvalues([2, -2], spring).status
    'wrong'
    """
    pair = observed_pair(system, parameters)
    spectra = [
        (values, *[different_roots(characteristic_coefficients(pair.at(point)[0]))] * 2)
        for values, point, _ in pair.samples_for(claim)
    ]
    yield from compare_eigenvalues(claim, spectra, ROOTS_PENCIL)
    evidence = roots_evidence(claim, LAMBDA, _pencil(system).det())
    return f"the determinant vanishes at each of them and nowhere else: {evidence}"


def judge_rank(claim, system, side):
    """Judge whether the rank of Theorem 2.5 is full everywhere, without parameters.

    M may be singular.
    """
    ((_, fixed, _),) = _spectra(system, ())
    rank_text = "falls at some lambda" if len(fixed) else f"is full at every {side.spectrum}"
    return (yield SameWord(claim, not len(fixed), f"the rank of {side.pencil} {rank_text}"))


def judge_roots(claim, system, parameters, side):
    """Judge the different values of lambda at which the rank falls."""
    return compare_eigenvalues(
        claim, _spectra(system, parameters, claim), side, (LAMBDA, _polynomials(system)[0])
    )


def _spectra(system, parameters, claim=()):
    """Return rows (values, lambda where the rank of Theorem 2.5 falls, all characteristic roots)."""
    samples = in_every_case(general_values(parameters), claim)
    return [(values, *_cached_spectra(system.subs(values))) for values in samples]


@functools.lru_cache(maxsize=64)
def _cached_spectra(system):
    return tuple(map(_roots, _polynomials(system)))


@functools.lru_cache(maxsize=64)
def _polynomials(system):
    """Return the polynomials that vanish where the rank falls, and where the square matrix's does."""
    rows = _pencil(system).col_join((system.H1 + LAMBDA * system.H2).applyfunc(_exact))
    minors = [sp.Poly(minor, LAMBDA) for minor in maximal_minors(rows)]
    if minors[0].is_zero:
        raise UnsuitableData(
            "det(M lambda^2 + D lambda + K) vanishes identically: the equations do not determine a "
            "motion"
        )
    return functools.reduce(sp.gcd, minors), minors[0]


def _pencil(system):
    return (system.M * LAMBDA**2 + system.D * LAMBDA + system.K).applyfunc(_exact)


def _exact(x):
    return sp.nsimplify(x, rational=True)


def _roots(poly):
    roots = poly.sqf_part().nroots(n=20, maxsteps=200) if poly.degree() > 0 else []
    return np.array(roots, dtype=complex)
