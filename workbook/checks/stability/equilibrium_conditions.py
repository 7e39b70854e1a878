"""Conditions on parameters: that an equilibrium exists, is the only one, or is of a kind.

`domain` is as for `equilibria`. Without it the equilibria of an equation that is periodic in an angle
are meant, all of them.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData, judged
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.tools.conditions import (
    Case,
    ReferenceCondition,
    compare,
    contradiction_message,
    exactly,
)
from workbook.checks.tools.wording import roots_text, values_text, with_article

#: Conditions on trace, determinant and discriminant of a linearisation in the plane.
KINDS = {
    "focus": lambda trace, determinant, discriminant: (determinant > 0) & (discriminant < 0),
    "node": lambda trace, determinant, discriminant: (determinant > 0) & (discriminant > 0),
    "saddle": lambda trace, determinant, discriminant: determinant < 0,
    "asymptotically stable": lambda trace, determinant, discriminant: (
        (determinant > 0) & (trace < 0)
    ),
}


@judged
def equilibrium_condition(answer, field, state, parameters, domain=None, kind=None, angle=None):
    """Check the parameters for which there is an equilibrium, one alone, or one of a kind.

    Without a kind there has to be an equilibrium in the domain. Of the kind "unique", for an equation
    of second order [y, f] with a polynomial f, there is one only, wherever it lies; real roots are
    counted exactly. The others, in `KINDS`, are those of the equilibrium of a planar system: cases on a
    border, where a root is zero, imaginary or double, count either way, and so do parameters without
    an equilibrium; without a domain all equilibria that are no saddles have to be of the kind. With the
    symbol `angle` it is a condition on an equilibrium (angle, 0), whose borders are judged.

    Can decide when the field, or for a kind the linearisation, is made of polynomials in the state and
    the parameters, or of functions that become so; elsewhere the condition is compared at points.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> e = sp.Symbol("e", real=True)
    >>> checks.equilibrium_condition(sp.Abs(e) < 2, [y, e*y - x], [x, y], [e], kind="focus").status
    'right'
    >>> checks.equilibrium_condition(e < 2, [y, e*y - x], [x, y], [e], kind="focus").status
    'wrong'
    >>> checks.equilibrium_condition(e >= 0, [y, -x - e*x**3], [x, y], [e], kind="unique").status
    'right'
    >>> r = sp.Symbol("r", positive=True)
    >>> checks.equilibrium_condition(e > 2, [r*(e - 2) - r**3], [r], [e]).status
    'right'
    """
    if kind == "unique":
        return _unique(answer, field, state, parameters)
    family = equilibria_of(field, state, parameters, domain)
    return _exists(answer, family) if kind is None else _of_kind(answer, family, kind, angle)


def _exists(answer, family):
    """Judge where there is an equilibrium in the domain."""

    def at(values):
        numbers = family.numbers(values)
        return None if numbers is None else family.exist(numbers)

    def message(values, holds):
        return (
            f"for {values_text(values)} there is {'an' if holds else 'no'} equilibrium, yet your "
            f"condition {'does not hold' if holds else 'holds'}"
        )

    assumptions, at_rest = family.domain_condition, family.at_rest
    reference = ReferenceCondition(
        (Case(sp.And(assumptions, at_rest), family.unknowns),),
        (Case(sp.And(assumptions, sp.Not(at_rest)), family.unknowns, every=True),),
        at,
    )
    agreement = compare(answer, family.parameters, reference, message)
    return f"there is an equilibrium exactly for these parameters: {agreement}"


def _unique(answer, field, state, parameters):
    """Judge where an equation of second order has one equilibrium only."""
    *kinematic, force = [sp.sympify(f).subs(dict.fromkeys(state[1:], 0)) for f in field]
    if any(second != 0 for second in kinematic):
        raise UnsuitableData("field: expected an equation of second order, as [rate, f]")
    x = state[0]
    second = sp.Dummy("y", real=True)
    two_roots = sp.And(sp.Eq(force, 0), sp.Eq(force.subs(x, second), 0), sp.Ne(x, second))
    # `inside` also holds where there is no root at all; `count` excludes this.
    inside = Case(sp.Not(two_roots), (x, second), every=True)
    outside = Case(two_roots, (x, second)), Case(sp.Ne(force, 0), (x,), every=True)

    def count(values):
        return sp.Poly(force.subs(values), x).sqf_part().count_roots()

    def message(values):
        number = count(values)
        points = (
            "no value" if not number else "one value only" if number == 1 else "more than one value"
        )
        return f"there the right-hand sides vanish at {points} of {x}"

    reference = ReferenceCondition((inside,), outside, lambda values: count(values) == 1)
    agreement = compare(answer, parameters, reference, contradiction_message(message))
    return f"the number of real roots of the equation of rest is one there and nowhere else: {agreement}"


def _of_kind(answer, family, kind, angle):
    """Judge where the equilibrium, or the one at `angle`, is of a kind in `KINDS`."""
    state, parameters, domain = family.state, family.parameters, family.domain
    noun = kind if kind.endswith("stable") else with_article(kind)

    def linearisations(values):
        """Return the matrices of the equilibria that count, at parameters or a given angle."""
        numbers = family.numbers({p: values[p] for p in parameters})
        if numbers is None:
            return []
        points = (
            family.points(numbers)[0] if angle is None else [np.array([float(values[angle]), 0.0])]
        )
        matrices = [family.jacobian(point, numbers[:, 0]) for point in points]
        return [A for A in matrices if domain or angle is not None or np.linalg.det(A) > 0]

    def at(values):
        outcomes = {
            _is_of_kind(kind, matrix, with_borders=angle is not None)
            for matrix in linearisations(values)
        }
        return None if None in outcomes or not outcomes else outcomes == {True}

    def message(values, holds):
        which = (
            "the equilibrium" if angle is None else f"the equilibrium {float(values[angle]):.4g}"
        )
        matrices = [] if domain else linearisations(values)
        roots = [
            f": the roots of the characteristic equation are {roots_text(np.linalg.eigvals(matrix))}"
            for matrix in matrices[:1]
        ]
        return (
            f"for {values_text({p: values[p] for p in parameters})} {which} is {'' if holds else 'not '}"
            f"{noun}, yet your condition {'does not hold' if holds else 'holds'}{''.join(roots)}"
        )

    condition = KINDS[kind](*family.invariants)
    if angle is not None:
        at_angle = {state[0]: angle}
        turn = {state[0]: sp.Interval.Ropen(0, 2 * sp.pi)}
        in_turn = equilibria_of(family.field, state, parameters, turn | domain)
        reference = exactly(
            condition.subs(at_angle),
            family.at_rest.subs(at_angle),
            at=at,
            points=lambda: _points_with_angles(in_turn, angle),
        )
        agreement = compare(answer, [angle, *parameters], reference, message)
        return f"it agrees with the roots of the characteristic equation at the equilibria: {agreement}"
    decided = sp.And(
        family.domain_condition,
        family.at_rest,
        *(sp.Ne(x, 0) for x in family.invariants),
        *([family.invariants[1] > 0] if not domain else []),
    )
    reference = exactly(condition, decided, family.unknowns, at)
    agreement = compare(answer, parameters, reference, message)
    which = "every one that is no saddle" if not domain else "it"
    return f"where there is an equilibrium, {which} is {noun} exactly for these parameters: {agreement}"


def _is_of_kind(kind, matrix, with_borders):
    """Return whether a linearisation is of a kind; None close to the border of any, unless asked."""
    trace, determinant, size = np.trace(matrix), np.linalg.det(matrix), np.linalg.norm(matrix) ** 2
    discriminant = trace**2 - 4 * determinant
    if not with_borders and min(abs(discriminant), abs(determinant), trace**2) <= 1e-9 * size:
        return None
    return bool(KINDS[kind](trace, determinant, discriminant))


def _points_with_angles(family, angle):
    """Yield parameters with equilibria, in general position and close to where these vanish."""

    def exist(values):
        numbers = family.numbers(values)
        return numbers is not None and family.exist(numbers)

    samples = [values for values, _, points in family.samples(alone=False) if points]
    near_border = []
    for values in samples[:2]:
        for p in family.parameters:
            inside, outside = values[p], 64 * values[p]
            if exist(values | {p: outside}):
                continue
            for _ in range(40):
                middle = (inside + outside) / 2
                inside, outside = (
                    (middle, outside) if exist(values | {p: middle}) else (inside, middle)
                )
            near_border.append(values | {p: inside * sp.Rational(999, 1000)})
    for values in [*samples, *near_border]:
        (points,) = family.points(family.numbers(values))
        yield from (values | {angle: sp.Rational(float(point[0]))} for point in points)
