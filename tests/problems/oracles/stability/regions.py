"""Oracles of stability regions."""

import sympy as sp
from sympy.core.function import AppliedUndef

from oracles.sameness import LOGIC, same_condition
from workbook.systems import Deviations


def stability_region(mutant, reference, system, parameters, degree=0):
    """As `same_condition`, with the two conventions: where the order drops, and on the boundary of
    a degree."""
    if not isinstance(mutant, LOGIC):
        return False
    if isinstance(system, Deviations):
        system = sp.Matrix(
            [[sp.diff(f, x).subs(system.motion) for x in system.state] for f in system.field]
        )
    if isinstance(system, sp.MatrixBase):
        leading, polynomial = sp.S.One, system.charpoly()
    else:
        system = _polynomial(system)
        (symbol,) = sp.sympify(system).free_symbols - set(parameters)
        polynomial = sp.Poly(system, symbol)
        leading = polynomial.LC()

    def convention(point):
        # A condition that is true or false everywhere has no symbols: any values will do for it.
        values = dict.fromkeys(parameters, 0) | {
            p: sp.Rational(v.numerator, v.denominator) for p, v in point.items()
        }
        if leading.xreplace(values) == 0:
            return True
        if degree == 0:
            return False
        roots = sp.Poly(polynomial.as_expr().xreplace(values), polynomial.gen).nroots(n=20)
        return abs(max(sp.re(root) for root in roots) + degree) < 1e-9

    return same_condition(mutant, reference, convention)


def _polynomial(equation):
    """That of a linear differential equation; what is none stays."""
    motions = sp.sympify(equation).atoms(AppliedUndef)
    if not motions:
        return equation
    (motion,) = motions
    time, s = motion.args[0], sp.Symbol("s")
    order = max((d.derivative_count for d in equation.atoms(sp.Derivative)), default=0)
    return sp.Add(
        *(
            sp.diff(equation, sp.Derivative(motion, (time, k)) if k else motion) * s**k
            for k in range(order + 1)
        )
    )


ORACLES = {"stability_region": stability_region}
