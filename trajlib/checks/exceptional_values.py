"""The values of a parameter at which observability is lost, each with what is unseen there.

A condition such as alpha != 1 may be guessed; the states that stay unseen at the value left out may not. The truth is that of
`pairs`: the largest invariant subspace in the kernel of the output, at every value where it can appear.
"""

from fractions import Fraction

import sympy as sp

from trajlib.checks import coercion
from trajlib.checks.dual_questions import OUTPUT, judge_basis
from trajlib.checks.pairs import pair_of
from trajlib.checks.parameter_places import allowed, places
from trajlib.checks.verdict import Invalid, Wrong, judged


@judged
def unseen_where_lost(answer, A, H, parameter):
    """Every real value of the parameter for which x' = A x, z = H x is not observable, as {value: basis of the unseen states}.

    For systems that lose observability at finitely many values, all of them rational.
    """
    if not isinstance(answer, dict):
        raise Invalid("expected a dictionary such as {4: [[3, 1, 0]]}, from each value to a basis of the unseen states there")
    lost = _values_where_lost(pair_of(A, H, (parameter,)), parameter)
    named = {}
    for key, basis in answer.items():
        value = coercion.as_number(key)
        near = [other for other in lost if _same(value, other)]
        if not near:
            told = sp.N(value, 4) if value.has(sp.Float) else value
            raise Wrong(f"at {parameter} = {told} the system is observable: there is no unseen state but zero")
        if near[0] in named:
            raise Wrong(f"the value {parameter} = {key} comes twice")
        named[near[0]] = basis
    if len(named) < len(lost):
        raise Wrong(f"the number of values at which the system is not observable is {len(lost)}; your answer names "
                    f"{len(named) or 'none'} of them")
    for value, basis in named.items():
        try:
            judge_basis(basis, pair_of(A.subs(parameter, value), H.subs(parameter, value)), OUTPUT)
        except Wrong as reason:
            raise Wrong(f"for {parameter} = {value}: {reason}") from None
    return "at these values of the parameter and no others the system is not observable, and the vectors are bases of what is unseen"


def _values_where_lost(pair, parameter):
    """The exceptional values, SymPy rationals."""
    if all(pair.unseen):
        raise ValueError("the system is observable for no value in general position")
    found = []
    for place in places((Fraction(0),), (Fraction(1),), pair.boundaries):
        if allowed(place, [parameter]) and pair.unseen_at(place):
            if place.irrational:
                raise ValueError("observability is lost at an irrational value")
            (value,) = place.coordinates
            found.append(sp.Rational(value.numerator, value.denominator))
    return found


def _same(value, other):
    """Decimals count to three digits; what is exact has to be right."""
    return coercion.rounds_to(value, other, scale=1e-3) if value.has(sp.Float) else sp.simplify(value - other) == 0
