"""Oracles of the conditions of the maximum principle: by algebra, where the checks look at
places."""

import sympy as sp

from oracles.pontryagin.processes import same_parts
from oracles.sameness import same_value, vanishes


def same_conditions(mutant, reference, problem, costates):
    """True if two lists of linear conditions have the same solutions."""
    solved = [
        sp.linsolve([_difference(e) for e in _listed(one)] or [sp.S.Zero], list(costates))
        for one in (mutant, reference)
    ]
    return (
        solved[0] == solved[1] or all(map(same_value, *(next(iter(s), ()) for s in solved)))
        if all(solved)
        else solved[0] == solved[1]
    )


def same_zeros(mutant, reference, problem, *_, **__):
    """True if two equations, or lists of them, hold at the same states."""
    state = list(problem.state)
    if not all(
        isinstance(part, (sp.Expr, sp.Eq)) for one in (mutant, reference) for part in _listed(one)
    ):
        return False
    if len(_listed(mutant)) == len(_listed(reference)) == 1:
        return _factors(_listed(mutant)[0], state) == _factors(_listed(reference)[0], state)
    return sp.solve([_difference(e) for e in _listed(mutant)], state, dict=True) == sp.solve(
        [_difference(e) for e in _listed(reference)], state, dict=True
    )


def same_on_the_arc(mutant, reference, problem, costates, control=None, domain=None):
    """True if two expressions agree on the surface of the singular arcs, as the library finds
    it."""
    arc = problem.conditions().singular[control or problem.control[0]]
    difference = sp.sympify(mutant - reference).subs(_known(problem, costates))
    found = sp.solve(list(arc.surface), list(problem.state), dict=True) if arc.surface else [{}]
    return all(vanishes(difference.subs(solution)) for solution in found)


def same_sign(mutant, reference, problem, costates, control=None, domain=None):
    """True if two functions are positive multiples of one another."""
    known = _known(problem, costates)
    ratio = sp.cancel(sp.sympify(mutant).subs(known) / sp.sympify(reference).subs(known))
    return bool(ratio.is_positive)


def same_rate(mutant, reference, problem, costates, *_, **__):
    known = _known(problem, costates)
    return vanishes((mutant - reference).subs(known))


def _known(problem, costates):
    """Costates that are constant, and of which transversality tells the value."""
    derived = problem.conditions()
    conditions = [e.subs(derived.multiplier, 1) for e in derived.reduced_transversality]
    return {
        psi: -(e - own)
        for psi, own in zip(costates, derived.costate)
        if derived.adjoint[own] == 0
        for e in conditions
        if e.has(own) and (e - own).is_number
    }


def _listed(answer):
    return list(answer) if isinstance(answer, (list, tuple)) else [answer]


def _difference(part):
    return part.lhs - part.rhs if isinstance(part, sp.Eq) else part


def _factors(equation, state):
    numerator = sp.numer(sp.together(_difference(equation)))
    return {
        factor
        for factor, _ in (
            sp.factor_list(numerator, *state)
            if numerator.is_polynomial(*state)
            else sp.factor_list(sp.simplify(numerator))
        )[1]
    }


ORACLES = {
    "transversality": same_conditions,
    "singular_surface": same_zeros,
    "singular_control": same_on_the_arc,
    "kelley_expression": same_on_the_arc,
    "switching_function": same_sign,
    "switching_rate": same_rate,
    "maximising_control": same_parts,
}
