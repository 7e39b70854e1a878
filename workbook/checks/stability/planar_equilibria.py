"""Equilibria of a second-order equation without parameters: types and slopes at saddles.

The equation in x is given as the field of its state (x, x').
"""

import numpy as np

from workbook.checks.contract import coercion
from workbook.checks.contract.tolerance import half_unit, in_decimals
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.stability.equilibrium_families import (
    first_coordinate,
    is_value,
    sampled_systems,
)
from workbook.checks.tools.wording import point_text

KINDS = ("stable node", "stable focus", "unstable node", "unstable focus", "saddle", "centre")


@judged
def equilibrium_types(answer, field, state):
    """Check the type of every stationary point of a planar portrait, a dict {x*: word}.

    The words are `KINDS`.
    """
    ((_, flow, equilibria),) = sampled_systems(field, state, (), ())
    remaining = list(equilibria)
    pairs = list(answer.items()) if isinstance(answer, dict) else answer
    if not (
        isinstance(pairs, (list, tuple))
        and all(isinstance(p, (list, tuple)) and len(p) == 2 for p in pairs)
    ):
        raise Invalid("expected a dict such as {3: 'saddle'}, from the value to the word")
    for value, word in pairs:
        kind = coercion.as_choice(word, KINDS)
        claim = coercion.as_number(first_coordinate(value, state, ()))
        number = float(claim)
        matching = [point for point in equilibria if is_value(number, point[0], claim, {})]
        if not matching:
            raise Wrong(
                f"x = {number:.4g} is no stationary solution: the right-hand sides are "
                f"{point_text(flow([number, 0.0]))}, not zero"
            )
        eigenvalues = np.linalg.eigvals(flow.jacobian(matching[0]))
        if kind != _kind(eigenvalues):
            raise Wrong(
                f"at x = {number:.4g} the roots of the characteristic equation are not those of a "
                f"{kind}"
            )
        remaining = [point for point in remaining if point is not matching[0]]
    if remaining:
        raise Wrong("the portrait has a stationary point that your answer does not name")
    return (
        "at every stationary point the roots of the characteristic equation are those of your type"
    )


@judged
def saddle_slopes(answer, field, state):
    """Check the slopes of the motions through the saddles of a second-order equation.

    The answer is a pair: the slope of the motions that leave, that of the motions that arrive.

    Judged by the direction of the field close to each saddle: along these lines it points to or
    away from it.
    """
    claims = list(map(coercion.as_number, coercion.as_expressions(answer, (), 2)))
    ((_, flow, equilibria),) = sampled_systems(field, state, (), ())
    saddles = [point for point in equilibria if np.linalg.det(flow.jacobian(point)) < 0]
    if not saddles:
        raise RuntimeError("the equation has no saddle")
    for point in saddles:

        def rates(slope, point=point):
            line = np.array([1.0, slope]) / np.hypot(1, slope)
            velocity = flow.derivative(point, line)
            return line[0] * velocity[1] - line[1] * velocity[0], velocity @ line

        for claim, sign, direction_text in zip(claims, (1, -1), ("leave", "come to")):
            slope = float(claim)
            across, along = rates(slope)
            rounding_interval = (
                [slope - half_unit(slope), slope + half_unit(slope)] if in_decimals(claim) else []
            )
            allowed = 1e-7 * np.linalg.norm(flow.jacobian(point)) + max(
                (abs(rates(rounded)[0] - across) for rounded in rounding_interval), default=0.0
            )
            if not abs(across) <= allowed or not along * sign > 0:
                raise Wrong(
                    f"along the line of slope {slope:.4g} through the saddle at {state[0]} = "
                    f"{point[0]:.4g} small deviations change at the rate {along:.3g} along it and "
                    f"{across:.3g} across it: these motions do not {direction_text} the saddle"
                )
    return "along these lines the linear field at each saddle points straight away from it and straight to it"


def _kind(eigenvalues):
    real, imaginary = eigenvalues.real, max(abs(eigenvalues.imag))
    if min(real) < 0 < max(real):
        return "saddle"
    if max(abs(real)) < 1e-9 * (1 + imaginary):
        return "centre"
    return f"{'stable' if max(real) < 0 else 'unstable'} {'focus' if imaginary > 1e-9 else 'node'}"
