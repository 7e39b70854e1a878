"""Regions of parameters in which a linear system is stable.

The reference spectrum is that of `references.spectra`.
"""

import functools

import sympy as sp
from sympy.core.function import AppliedUndef

from workbook.checks.contract.verdict import judged
from workbook.checks.references.records import matrix_of
from workbook.checks.references.spectra import compare_region
from workbook.systems import Deviations


@judged
def stability_region(answer, system, parameters, degree=0):
    """Check the parameters for which every root has real part below `-degree`.

    For 0 this is asymptotic stability.

    `system` is a characteristic polynomial in one further symbol, a square matrix, a linear
    differential equation `system` = 0 of an unknown x(t), or `Deviations` from a motion of
    another one, by their linearisation. Parameters where the order of the equation drops
    are accepted either way; with a positive degree of stability (Definition 1.5, Re <= -mu) so is the
    boundary.

    Can decide when the coefficients are polynomials in the parameters, or rational functions of
    them: then for all values at once. Elsewhere the condition is compared with the roots at
    points.

    Examples
    --------
    >>> s, p, q = sp.symbols("s p q", real=True)
    >>> checks.stability_region(sp.And(p > 2, q > 0), s**2 + (p - 2)*s + q, [p, q]).message
    'agrees with the roots: proved for all values'
    >>> checks.stability_region(p > 2, s**2 + (p - 2)*s + q, [p, q]).status
    'wrong'
    """
    if isinstance(system, Deviations):
        return compare_region(
            answer, matrix_of(system, parameters), parameters, "asymptotically stable", degree
        )
    property_text = "stable" if degree == 0 else "stable with the degree of stability"
    motions = system.atoms(AppliedUndef)
    return compare_region(
        answer,
        characteristic_of(system, *motions) if motions else system,
        parameters,
        property_text,
        degree,
    )


@functools.lru_cache(maxsize=16)
def characteristic_of(equation, motion):
    """Return the characteristic polynomial of a linear equation.

    It is the left-hand side for x(t) = e^(s t), divided by e^(s t).
    """
    (time,) = motion.args
    s = sp.Dummy("s")
    return sp.expand(sp.expand(equation.subs(motion, sp.exp(s * time)).doit()) * sp.exp(-s * time))
