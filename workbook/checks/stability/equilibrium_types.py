"""Stability and type of equilibria, decided by linearisation.

`domain` is as for `equilibria`. "The equilibrium" of a check is the only one in the domain: a data
cell that leaves room for two makes the answer unchecked.
"""

import numpy as np

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Choice
from workbook.checks.contract.tolerance import half_unit, in_decimals
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.stability.equilibrium_values import (
    equilibria_within_reach,
    first_coordinate,
    is_value,
)
from workbook.checks.stability.linearisation import STABILITY
from workbook.checks.tools.wording import point_text, sample_text, tried_text, with_article

TYPES = tuple(
    f"{stability} {noun}"
    for noun in ("node", "star", "degenerate node", "focus")
    for stability in ("stable", "unstable")
)
TYPES += ("saddle", "centre")


@judged(Choice(words=STABILITY))
def equilibrium_stability(claim, field, state, parameters, domain=None):
    """Check whether the equilibrium is asymptotically stable, stable or unstable.

    The word "stable" means stable but not asymptotically; Theorem 1.4 decides.

    Can decide when the domain holds one equilibrium whose linearisation has no eigenvalue on the
    imaginary axis; with parameters at sample values.

    Examples
    --------
    >>> v, ahead = sp.Symbol("v", positive=True), sp.Interval.open(0, sp.oo)
    >>> checks.equilibrium_stability("asymptotically stable", [1 - v**2], [v], [], {v: ahead}).status
    'right'
    >>> checks.equilibrium_stability("unstable", [1 - v**2], [v], [], {v: ahead}).status
    'wrong'
    """
    family = equilibria_of(field, state, parameters, domain)
    for values, numbers, point in family.samples():
        growth = family.growth(point, numbers)
        if claim != ("unstable" if growth > 0 else "asymptotically stable"):
            raise Wrong(
                f"{sample_text(values)}this does not agree with the linearisation: look at "
                "the signs of the real parts of its roots"
            )
    return f"it agrees with the roots of the linearisation{tried_text(parameters)}"


@judged
def equilibrium_type(answer, field, state, parameters=None, domain=None):
    """Check the type of the equilibrium of a planar system, the only one in the domain, or of all.

    It is the same for all values of the parameters. Without the data `parameters` all equilibria of a
    second-order equation are asked for: the answer is a dict {x*: word}. The words are `TYPES`.

    Can decide when every equilibrium that is meant has a type that its linearisation determines.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.equilibrium_type("saddle", [y, x], [x, y], []).status
    'right'
    >>> checks.equilibrium_type("stable node", [y, x], [x, y], []).status
    'wrong'
    >>> checks.equilibrium_type({0: "stable focus", 2: "saddle", -2: "saddle"}, [y, x**3/4 - x - y], [x, y]).status
    'right'
    """
    if parameters is None:
        return _judge_all_types(answer, field, state)
    claim = _read_type(answer)
    family = equilibria_of(field, state, parameters, domain)
    for values, numbers, point in family.samples():
        if claim != _type(family.jacobian(point, numbers)):
            raise Wrong(
                f"{sample_text(values)}the roots of the linearisation are not those of {with_article(claim)}"
            )
    return f"it agrees with the roots of the linearisation{tried_text(parameters)}"


def _read_type(word):
    """Return the word of `TYPES` that an answer is, in other spellings too."""
    if isinstance(word, str):
        word = word.lower().replace("center", "centre").replace("star node", "star")
    return coercion.as_choice(word, TYPES)


def _judge_all_types(answer, field, state):
    """Judge the types of all equilibria of a second-order equation, named by their values x*."""
    ((_, family, numbers, equilibria),) = equilibria_within_reach(field, state)
    remaining = list(equilibria)
    pairs = list(answer.items()) if isinstance(answer, dict) else answer
    if not (
        isinstance(pairs, (list, tuple))
        and all(isinstance(p, (list, tuple)) and len(p) == 2 for p in pairs)
    ):
        raise Invalid("expected a dict such as {3: 'saddle'}, from the value to the word")
    for value, word in pairs:
        kind = _read_type(word)
        claim = coercion.as_number(first_coordinate(value, state, ()))
        number = float(claim)
        matching = [point for point in equilibria if is_value(number, point[0], claim, {})]
        if not matching:
            raise Wrong(
                f"x = {number:.4g} is no equilibrium: the right-hand sides are "
                f"{point_text(family(np.array([number, 0.0]), numbers))}, not zero"
            )
        if kind != _type(family.jacobian(matching[0], numbers)):
            raise Wrong(
                f"at x = {number:.4g} the roots of the characteristic equation are not those of "
                f"{with_article(kind)}"
            )
        remaining = [point for point in remaining if point is not matching[0]]
    if remaining:
        raise Wrong("the portrait has an equilibrium that your answer does not name")
    return "at every equilibrium the roots of the characteristic equation are those of your type"


@judged
def saddle_slopes(answer, field, state):
    """Check the slopes of the motions through the saddles of a second-order equation.

    The answer is a pair: the slope of the motions that leave, that of the motions that arrive.

    Judged by the direction of the field close to each saddle: along these lines it points to or
    away from it.

    Can decide when all saddles have the same slopes, those of their linearisation.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.saddle_slopes([1, -1], [y, x - x**3], [x, y]).status
    'right'
    >>> checks.saddle_slopes([-1, 1], [y, x - x**3], [x, y]).status
    'wrong'
    """
    claims = list(map(coercion.as_number, coercion.as_expressions(answer, (), 2)))
    ((_, family, numbers, equilibria),) = equilibria_within_reach(field, state)
    saddles = [(p, A) for p in equilibria if np.linalg.det(A := family.jacobian(p, numbers)) < 0]
    if not saddles:
        raise RuntimeError("the equation has no saddle")
    for point, matrix in saddles:

        def rates(slope, matrix=matrix):
            line = np.array([1.0, slope]) / np.hypot(1, slope)
            velocity = matrix @ line
            return line[0] * velocity[1] - line[1] * velocity[0], velocity @ line

        for claim, sign, direction_text in zip(claims, (1, -1), ("leave", "come to")):
            slope = float(claim)
            across, along = rates(slope)
            rounding_interval = (
                [slope - half_unit(slope), slope + half_unit(slope)] if in_decimals(claim) else []
            )
            allowed = 1e-7 * np.linalg.norm(matrix) + max(
                (abs(rates(rounded)[0] - across) for rounded in rounding_interval), default=0.0
            )
            if not abs(across) <= allowed or not along * sign > 0:
                raise Wrong(
                    f"along the line of slope {slope:.4g} through the saddle at {state[0]} = "
                    f"{point[0]:.4g} small deviations change at the rate {along:.3g} along it and "
                    f"{across:.3g} across it: these motions do not {direction_text} the saddle"
                )
    return "along these lines the linear field at each saddle points straight away from it and straight to it"


def _type(matrix):
    """Return the type of the equilibrium whose linearisation is this matrix."""
    trace, determinant, size = np.trace(matrix), np.linalg.det(matrix), np.linalg.norm(matrix)
    if abs(determinant) < 1e-9 * size**2:
        raise RuntimeError("the linearisation has a root zero: it does not decide the type")
    if determinant < 0:
        return "saddle"
    if abs(trace) < 1e-9 * size:
        return "centre"
    stability = "stable" if trace < 0 else "unstable"
    discriminant = trace**2 - 4 * determinant
    if abs(discriminant) < 1e-8 * size**2:
        star = np.linalg.norm(matrix - trace / 2 * np.eye(2)) < 1e-6 * size
        return f"{stability} {'star' if star else 'degenerate node'}"
    return f"{stability} {'node' if discriminant > 0 else 'focus'}"
