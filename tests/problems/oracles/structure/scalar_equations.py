"""Oracle of scalar equations: another equation is the same one if it is the reference times a
constant."""

import sympy as sp
from sympy.core.function import AppliedUndef

from oracles.sameness import vanishes


def scalar_equation(mutant, reference, system, motion, control, parameters=()):
    """Left less right, as a linear form in the derivatives, is that of the reference times a factor
    that is not zero."""
    if not isinstance(mutant, sp.Eq):
        return False
    one, other = (sp.expand((side.lhs - side.rhs).doit()) for side in (mutant, reference))
    top = motion.diff(motion.args[0], system.A.rows)
    factor = sp.cancel(one.coeff(top) / other.coeff(top))
    if factor == 0 or factor.free_symbols - set(parameters) or factor.atoms(AppliedUndef):
        return False
    return vanishes(sp.expand(one - factor * other))


ORACLES = {"scalar_equation": scalar_equation}
