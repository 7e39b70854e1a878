"""Stationary angles: existence, values, stability and type.

A stationary angle is the solution phi(t) = phi0 of an equation phi'' = f(phi, phi') that is periodic
in phi, given as the field of its state (phi, phi').
"""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression
from workbook.checks.contract.members import VECTORS, families
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.stationary_angles import stationary_angles
from workbook.checks.stability.equilibrium_sets import KIND_CONDITIONS, agreement
from workbook.checks.tools.conditions import (
    Case,
    ReferenceCondition,
    compare,
    contradiction_message,
    exactly,
)
from workbook.checks.tools.turns import finite_list_text, members_of
from workbook.checks.tools.values import number_at, uncertainty_at
from workbook.checks.tools.wording import other_text, roots_text, values_text

#: Turns in which angles are looked for, and the size of the angles in them.
TURNS, ALL_TURNS = (-1, 0, 1), 4 * np.pi


@judged
def equilibrium_angles_exist(answer, field, state, parameters):
    """Check the parameters for which phi'' = f(phi, phi') has stationary solutions at all."""
    angles = stationary_angles(tuple(field), tuple(state), tuple(parameters))
    at_rest = sp.Eq(sp.sympify(field[1]).subs(state[1], 0), 0)
    reference = ReferenceCondition(
        (Case(at_rest, (state[0],)),),
        (Case(sp.Not(at_rest), (state[0],), every=True),),
        angles.exist,
    )
    agreement = compare(
        answer,
        parameters,
        reference,
        contradiction_message(
            lambda values: "there f(phi, 0) runs from {:.4g} to {:.4g}".format(
                *angles.extremes(values)
            )
        ),
    )
    return f"f(phi, 0) takes the value zero for these parameters and for no others: {agreement}"


@judged
def equilibrium_angles(answer, field, state, parameters, integer):
    """Check all stationary angles, as expressions in the parameters and an integer.

    Those of all turns are asked for.
    """
    return _judge_angle_lists(answer, field, state, parameters, integer, "stationary")


@judged
def stable_equilibrium_angles(answer, field, state, parameters, integer):
    """Check the stationary angles that Theorem 1.4 proves asymptotically stable.

    The form is that of `equilibrium_angles`.
    """
    return _judge_angle_lists(answer, field, state, parameters, integer, "asymptotically stable")


@judged
def unstable_equilibrium_angles(answer, field, state, parameters, integer):
    """Check the stationary angles that Theorem 1.4 proves unstable.

    The form is that of `equilibrium_angles`.
    """
    return _judge_angle_lists(answer, field, state, parameters, integer, "unstable")


@judged(Expression("deviations", "angle", "parameters"))
def angle_linearisation(claim, field, state, parameters, angle, deviations):
    """Check the linearisation psi'' = ... at a stationary angle, linear in psi and psi'.

    `angle` is the symbol of the stationary angle, `deviations` those of psi and psi'. It is judged
    at stationary angles only, so that the answer may use the equation f(phi0, 0) = 0.
    """
    if not claim.is_polynomial(*deviations) or sp.Poly(claim, *deviations).total_degree() > 1:
        raise Invalid(
            f"expected an expression that is linear in {deviations[0]} and {deviations[1]}"
        )
    angles = stationary_angles(tuple(field), tuple(state), tuple(parameters))
    for values in angles.samples_for(claim):
        for phi in angles.angles(values):
            slope, friction = angles.derivatives(values, phi)
            for deviation, true in (
                ((1, 0), slope),
                ((0, 1), friction),
                ((0, 0), 0.0),
                ((1, 1), slope + friction),
            ):
                at = values | {angle: sp.Float(phi, 20)} | dict(zip(deviations, deviation))
                claimed = number_at(claim, at)
                if not abs(claimed - true) <= 1e-8 * (abs(slope) + abs(friction)):
                    message = ", ".join(
                        f"{symbol} = {value}" for symbol, value in zip(deviations, deviation)
                    )
                    raise Wrong(
                        f"for {values_text(values)}, at a stationary angle, "
                        + other_text(
                            f"the change of phi'' to first order by a deviation {message}",
                            claimed.real,
                            true,
                        )
                    )
    return "to first order the right-hand side changes so, at all stationary angles of several sets of parameters"


@judged
def stable_angle_condition(answer, field, state, parameters, angle):
    """Check the condition on a stationary angle for it to be asymptotically stable."""
    return _judge_angle_condition(
        answer,
        field,
        state,
        parameters,
        angle,
        lambda sum_, product: (sum_ < 0) & (product > 0),
        "asymptotically stable",
    )


@judged
def saddle_angle_condition(answer, field, state, parameters, angle):
    """Check the condition on a stationary angle for it to be a saddle."""
    return _judge_angle_condition(
        answer, field, state, parameters, angle, lambda sum_, product: product < 0, "a saddle"
    )


def _judge_angle_lists(answer, field, state, parameters, integer, word):
    # A stationary solution may be given as the point (phi0, 0) of the phase plane.
    parts = [
        part[0] if isinstance(part, VECTORS) and len(part) == 2 and part[1] == 0 else part
        for part in families(answer, integer, "a list of angles, as expressions")
    ]
    claims = [coercion.as_expression(part, [*parameters, integer]) for part in parts]
    angles = stationary_angles(tuple(field), tuple(state), tuple(parameters))
    for values in angles.samples_for(claims):
        reference_angles = angles.angles(values)
        chosen = [
            phi
            for phi in reference_angles
            if KIND_CONDITIONS[word](*angles.derivatives(values, phi))
        ]
        matched = set()
        for family in claims:
            for member, claimed, at in members_of(family, values, integer, ALL_TURNS):
                uncertainty = uncertainty_at(family, at)
                if abs(claimed.imag) > 1e-9 * (1 + abs(claimed)):
                    raise Wrong(
                        f"your value{member} is not real for {values_text(values)}, where there "
                        "are stationary angles"
                    )
                turned = [
                    claimed.real + np.remainder(phi - claimed.real + np.pi, 2 * np.pi) - np.pi
                    for phi in reference_angles
                ]
                matching = [
                    (phi, round((true - phi) / (2 * np.pi)))
                    for phi, true in zip(reference_angles, turned)
                    if agree(claimed.real, true, family, 2 * np.pi, uncertain=uncertainty)
                ]
                if not matching:
                    raise Wrong(
                        f"your value {claimed.real:.4g}{member} is no stationary angle for "
                        f"{values_text(values)}: f(phi, 0) is "
                        f"{angles.force(values, claimed.real):.4g} there"
                    )
                if matching[0][0] not in chosen:
                    raise Wrong(
                        f"your angle {claimed.real:.4g} for {values_text(values)} is "
                        "stationary, but not "
                        f"{word}: {_roots_text(*angles.derivatives(values, matching[0][0]))}"
                    )
                matched.add(matching[0])
        missing = [
            phi + 2 * np.pi * turn for turn in TURNS for phi in chosen if (phi, turn) not in matched
        ]
        if missing and any(phi not in {match for match, _ in matched} for phi in chosen):
            raise Wrong(
                f"not all angles are there: between 0 and 2 pi there is one that is {word} for "
                f"{values_text(values)} and that your answer does not give, not even in another turn"
            )
        if missing and not any(claim.has(integer) for claim in claims):
            raise Wrong(
                finite_list_text(
                    f"angles that are {word}", missing[0], f" for {values_text(values)}", integer
                )
            )
        if missing:
            raise Wrong(
                f"not all angles are there: in some turns your answer gives one that is {word} for "
                f"{values_text(values)}, and in others it does not"
            )
    proof_text = agreement(claims, integer, field, state, parameters, sp.true, word)
    return (
        f"these angles are {word} for several sets of parameters, and a search of the circle finds "
        f"no other{proof_text}"
    )


def _judge_angle_condition(answer, field, state, parameters, angle, kind, word):
    symbols = [angle, *parameters]
    force, at_rest = sp.sympify(field[1]).subs(state[0], angle), {state[1]: 0}
    slope, friction = (sp.diff(force, x).subs(at_rest) for x in (angle, state[1]))
    angles = stationary_angles(tuple(field), tuple(state), tuple(parameters))

    def reference(values):
        slope, friction = angles.derivatives(values, float(values[angle]))
        return bool(kind(friction, -slope))

    def points():
        """Stationary angles in general position, and close to where two of them meet."""
        for values in [*angles.samples, *(near for near, _ in angles.edges)]:
            yield from (values | {angle: sp.Rational(float(phi))} for phi in angles.angles(values))

    def message(values, holds):
        return (
            f"the stationary angle {float(values[angle]):.4g} for "
            f"{values_text({p: values[p] for p in parameters})} is {'' if holds else 'not '}{word}, "
            f"and your condition {'does not hold' if holds else 'holds'} there: "
            f"{_roots_text(*angles.derivatives(values, float(values[angle])))}"
        )

    exact = exactly(
        kind(friction, -slope), sp.Eq(force.subs(at_rest), 0), at=reference, points=points
    )
    agreement = compare(answer, symbols, exact, message)
    return f"it agrees with the roots of the characteristic equation at the stationary angles: {agreement}"


def is_angle_equation(field, state):
    """Return whether a planar field is that of an equation phi'' = f(phi, phi') periodic in phi."""
    if len(state) != 2 or sp.sympify(field[0]) != state[1]:
        return False
    force = sp.sympify(field[1])
    return force.has(state[0]) and force.subs(state[0], state[0] + 2 * sp.pi) == force


def judge_angle_roots(answer, field, state, parameters, sign):
    """Compare a condition with the discriminants at the angles that are no saddles: -1 focus, 1 node."""
    word = "node" if sign > 0 else "focus"
    phi, rate = state
    force = sp.sympify(field[1])
    slope, friction = (sp.diff(force, x).subs(rate, 0) for x in state)
    border = friction**2 + 4 * slope
    assumptions = sp.And(sp.Eq(force.subs(rate, 0), 0), slope < 0, sp.Ne(border, 0))
    angles = stationary_angles(tuple(field), tuple(state), tuple(parameters))

    def discriminants(values):
        pairs = angles.slopes(values)
        return [friction**2 + 4 * slope for slope, friction in pairs if slope < 0], pairs

    def reference(values):
        values_of_discriminant, pairs = discriminants(values)
        if not values_of_discriminant or min(abs(d) for d in values_of_discriminant) < 1e-9 * max(
            friction**2 + abs(slope) for slope, friction in pairs
        ):
            return None
        return all(sign * discriminant > 0 for discriminant in values_of_discriminant)

    def message(values):
        slope, friction = next((pair for pair in discriminants(values)[1] if pair[0] < 0), (0, 0))
        return _roots_text(slope, friction)

    exact = exactly(sign * border > 0, assumptions, (phi,), reference)
    agreement = compare(answer, parameters, exact, contradiction_message(message))
    return (
        "for these parameters, and for no others, the stationary angles that are no saddles are "
        f"of the kind {word}: {agreement}"
    )


def _roots_text(slope, friction):
    return f"the roots of the characteristic equation are {roots_text(np.roots([1.0, -friction, -slope]))}"
