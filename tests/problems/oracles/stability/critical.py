"""Oracles of critical cases of stability."""

import sympy as sp


def unbounded_motion(
    mutant, reference, field, state, parameters, time, constants=(), program=None, part=None
):
    """True for every motion of the linear system whose distance from zero has no bound."""
    matrix, motion = _linear_part(field, state, program, part), sp.Matrix(list(mutant))
    if (
        len(motion) != matrix.rows
        or not (motion.diff(time) - matrix * motion).applyfunc(sp.simplify).is_zero_matrix
    ):
        return False
    return sp.limit(sp.expand(motion.dot(motion)), time, sp.oo) == sp.oo


def conserved_quadratic_form(mutant, reference, field, state, parameters, program=None, part=None):
    """True for every positive definite quadratic form whose derivative along the motions is
    identically zero."""
    part = list(part or state)
    velocity = _linear_part(field, state, program, part) * sp.Matrix(part)
    weights = sp.hessian(mutant, part)
    form, rate = (
        sp.Matrix(part).dot(weights * sp.Matrix(part)) / 2,
        sp.Matrix([mutant]).jacobian(part).dot(velocity),
    )
    if sp.expand(mutant - form) != 0 or sp.expand(rate) != 0:
        return False
    return bool(
        weights.subs(
            {p: sp.Rational(3 + j, 2) for j, p in enumerate(parameters)}
        ).is_positive_definite
    )


def _linear_part(field, state, program, part):
    rest = dict.fromkeys(state, 0) | (program or {})
    chosen = [list(state).index(s) for s in part or state]
    return sp.Matrix(field).jacobian(state).subs(rest).extract(chosen, chosen)


ORACLES = {
    "unbounded_motion": unbounded_motion,
    "conserved_quadratic_form": conserved_quadratic_form,
}
