"""Sets of equilibria of a second-order equation, decided for all parameter values.

That a set of expressions names all equilibria x*, or all that are stable, and no others, is
a condition on the parameters and one more number: it is a member exactly if the right-hand sides
vanish there, and the linearisation is as required. Where the equation holds x in sines and
cosines of multiples of m x alone, the number is the angle m x, and members are compared as points
of the circle. Families that are not periodic with this turn are left to samples. Where two
equilibria meet, s = 0, either kind is accepted.
"""

import functools
import math

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from workbook.checks.contract.tolerance import in_decimals
from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.conditions import Case, ReferenceCondition, decide

#: What the linearisation y'' = s y + r y' has to satisfy, by its coefficients s and r.
KINDS = {
    None: lambda slope, friction: sp.true,
    "asymptotically stable": lambda slope, friction: sp.And(slope < 0, friction < 0),
    "unstable": lambda slope, friction: sp.Or(slope > 0, friction > 0),
}


def agreement(claims, integer, field, state, parameters, given, kind):
    """Return how it is known that `claims` are all equilibria of a kind in `KINDS`.

    Samples showed no difference. Raise `Wrong` where the decision finds one.
    """
    if not in_decimals(*claims) and len(state) == 2 and sp.sympify(field[0]) == state[1]:
        membership = _membership(tuple(claims), integer, sp.sympify(field[1]), tuple(state), kind)
        if membership:
            number, member, elsewhere, right, wrong = membership
            reference = ReferenceCondition(
                (Case(sp.And(given, right)),),
                (Case(sp.And(given, elsewhere)), Case(sp.And(given, wrong))),
            )
            decided, point = decide(member, [*parameters, number], reference)
            if point:
                (values, holds), word = point, kind or "an equilibrium"
                message = ", ".join(f"{p} = {values[p]}" for p in parameters)
                raise Wrong(
                    f"for {message} your answer "
                    + (
                        f"leaves out one that is {word}"
                        if holds
                        else f"names one that is not {word}"
                    )
                )
            if decided:
                return ": proved for all values"
    return ""


@functools.lru_cache(maxsize=64)
def _membership(claims, integer, acceleration, state, kind):
    """Return a symbol, and the conditions that it is claimed, no equilibrium, of the kind, or not.

    Return None where they cannot be written down.
    """
    x, rate = state
    force, slope, friction = (
        part.subs(rate, 0) for part in (acceleration, acceleration.diff(x), acceleration.diff(rate))
    )
    number = sp.Dummy("x", real=True)
    angles = [
        f.args[0]
        for part in (force, slope, friction)
        for f in part.atoms(TrigonometricFunction)
        if f.has(x)
    ]
    if not angles:
        if any(integer is not None and claim.has(integer) for claim in claims):
            return None
        point, members = number, [sp.Eq(number, claim) for claim in claims]
    else:
        turns = [angle.coeff(x) for angle in angles]
        if not all(turn.is_Integer and not turn.is_zero for turn in turns):
            return None
        m = math.gcd(*map(int, turns))
        turned = [_members_in_one_turn(claim, integer, m) for claim in claims]
        if None in turned:
            return None
        point = number / m
        members = [
            sp.And(
                *(
                    sp.Eq(f(number), sp.expand_trig(f(sp.expand(m * member))))
                    for f in (sp.cos, sp.sin)
                )
            )
            for member in sum(turned, [])
        ]
    force_at_point, slope, friction = (part.subs(x, point) for part in (force, slope, friction))
    if angles and any(
        part.has(number) and part.subs({sp.sin(number): 0, sp.cos(number): 0}).has(number)
        for part in map(sp.expand_trig, (force_at_point, slope, friction))
    ):
        return None
    is_kind = KINDS[kind](slope, friction)
    return (
        number,
        sp.Or(*members),
        sp.Ne(force_at_point, 0),
        sp.And(sp.Eq(force_at_point, 0), is_kind),
        sp.And(sp.Eq(force_at_point, 0), sp.Not(is_kind), sp.Ne(slope, 0)),
    )


def _members_in_one_turn(family, integer, m):
    """Return the members of a family within one turn of m x, or None if it is not so periodic."""
    step = sp.expand(family.subs(integer, integer + 1) - family)
    count = None if step.is_zero or step.free_symbols else 2 * sp.pi / (m * abs(step))
    return (
        [family.subs(integer, k) for k in range(int(count))]
        if count is not None and count.is_Integer
        else None
    )
