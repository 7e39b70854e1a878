"""Oracles of stability regions."""

import sympy as sp

from oracles.sameness import LOGIC, same_condition


def stability_region(mutant, reference, system, parameters, margin=0):
    """As `same_condition`, with the two conventions: where the order drops, and on the boundary of a margin."""
    if not isinstance(mutant, LOGIC):
        return False
    if isinstance(system, sp.MatrixBase):
        leading, polynomial = sp.S.One, system.charpoly()
    else:
        (symbol,) = sp.sympify(system).free_symbols - set(parameters)
        polynomial = sp.Poly(system, symbol)
        leading = polynomial.LC()

    def convention(point):
        # A condition that is true or false everywhere has no symbols: any values will do for it.
        values = dict.fromkeys(parameters, 0) | {p: sp.Rational(v.numerator, v.denominator) for p, v in point.items()}
        if leading.xreplace(values) == 0:
            return True
        if margin == 0:
            return False
        roots = sp.Poly(polynomial.as_expr().xreplace(values), polynomial.gen).nroots(n=20)
        return abs(max(sp.re(root) for root in roots) + margin) < 1e-9

    return same_condition(mutant, reference, convention)


def stable_equation(mutant, reference, equation, motion, parameters):
    """As `stability_region` for the polynomial of a linear equation."""
    time, s = motion.args[0], sp.Symbol("s")
    order = max((d.derivative_count for d in equation.atoms(sp.Derivative)), default=0)
    terms = [sp.diff(equation, sp.Derivative(motion, (time, k)) if k else motion) * s**k for k in range(order + 1)]
    return stability_region(mutant, reference, sp.Add(*terms), parameters)


ORACLES = {"stability_region": stability_region, "stable_equation": stable_equation}
