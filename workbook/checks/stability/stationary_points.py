"""Stationary points of planar systems that contain parameters: position, existence and type.

`domain` is a dict from symbols of the state or parameters to SymPy intervals, as in
`trajlib.stability.equilibria`; an interval of length 2 pi makes a state variable an angle, for
which values modulo 2 pi are the same. What `domain` does not name ranges over all numbers that the
assumptions of the symbol allow. The reference is found from the field alone, for sample values of
the parameters, by Newton's method from many initial points at once. "The stationary point" of a
check is the only one in the domain: a data cell that leaves room for two makes the answer
unchecked. A circular cycle is a stationary point of the radial equation r' = R(r), r > 0.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Choice, Expression
from workbook.checks.contract.members import VECTORS, in_order
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.stationary_points import stationary_points_of
from workbook.checks.stability.equilibrium_angles import is_angle_equation, judge_angle_roots
from workbook.checks.tools.conditions import Case, ReferenceCondition, compare, exactly
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import uncertainty_at
from workbook.checks.tools.wording import (
    NO_NUMBER,
    deviation_rate_text,
    other_text,
    point_text,
    sample_text,
    tried_text,
    values_text,
)

STABILITY = ("asymptotically stable", "stable", "unstable")
TYPES = tuple(
    f"{stability} {noun}"
    for noun in ("node", "star", "degenerate node", "focus")
    for stability in ("stable", "unstable")
)
TYPES += ("saddle", "centre")


@judged
def stationary_points(answer, field, state, parameters, domain=None, zeros=None):
    """Check all stationary points in the domain, as expressions in the parameters.

    The answer is one point, or a list of points. A point whose formula is not real, or leaves the
    domain, for some values of the parameters stands for no point there. Where derivatives vanish
    at a point as well, `zeros` are functions that have the same zeros, all simple.
    """
    searched = stationary_points_of(field if zeros is None else zeros, state, parameters, domain)
    return _judge_points(
        answer, stationary_points_of(field, state, parameters, domain), "stationary point", searched
    )


@judged
def nullcline(answer, rate, variable, parameters, domain=None):
    """Check the curve on which `rate` vanishes, solved for `variable`.

    The other state variables count as parameters.
    """
    return _judge_points(
        answer, stationary_points_of([rate], [variable], parameters, domain), "point of the curve"
    )


@judged
def stationary_exists(answer, field, state, parameters, domain=None):
    """Check the parameters for which there is a stationary point in the domain."""
    return _judge_existence(
        answer, stationary_points_of(field, state, parameters, domain), "stationary point"
    )


@judged
def stationary_linearisation(answer, field, state, parameters, domain=None):
    """Check the matrix A of the linearisation at the stationary point.

    For one equation it is a number.
    """
    n = len(state)
    if n == 1 and not isinstance(answer, (list, tuple, sp.MatrixBase, np.ndarray)):
        answer = [[answer]]
    matrix = coercion.as_matrix(answer, parameters, (n, n))
    family = stationary_points_of(field, state, parameters, domain)
    for values, numbers, equilibrium in family.samples(matrix):
        true = family.jacobian(equilibrium, numbers)
        size = np.linalg.norm(true)
        for k in range(n):
            claimed = [real_at(entry, values) for entry in matrix[:, k]]
            if any(value is None for value in claimed):
                raise Wrong(f"{sample_text(values)}an entry of your matrix is {NO_NUMBER}")
            column = list(matrix[:, k])
            uncertain = [uncertainty_at(entry, values) for entry in column]
            if not agree(claimed, true[:, k], column, size, uncertain=uncertain).all():
                raise Wrong(
                    f"{sample_text(values)}{deviation_rate_text(state[k], claimed, true[:, k])}"
                )
    return (
        "small deviations from the stationary solution change the right-hand sides as it predicts"
    )


@judged(Expression("parameters"))
def stationary_value(claim, expression, field, state, parameters, domain=None):
    """Check the value of an expression of the state at the stationary point."""
    family = stationary_points_of(field, state, parameters, domain)
    expression_at = stationary_points_of([expression], state, parameters, domain)
    for values, numbers, equilibrium in family.samples(claim):
        true, claimed = float(expression_at(equilibrium, numbers)[0]), real_at(claim, values)
        if claimed is None or not agree(
            claimed,
            true,
            claim,
            _scale(expression, values, state, equilibrium),
            uncertain=uncertainty_at(claim, values),
        ):
            noun = "the value at the stationary solution"
            if claimed is None:
                raise Wrong(f"{sample_text(values)}your expression gives {NO_NUMBER}")
            if not values:
                raise Wrong(f"{noun} is not {claimed:.4g}")
            raise Wrong(f"{sample_text(values)}{other_text(noun, claimed, true)}")
    return f"it is the value at the stationary solution{tried_text(parameters)}"


@judged(Choice(words=STABILITY))
def stationary_stability(claim, field, state, parameters, domain=None):
    """Check whether the stationary point is asymptotically stable, stable or unstable.

    The word "stable" means stable but not asymptotically; Theorem 1.4 decides.
    """
    family = stationary_points_of(field, state, parameters, domain)
    for values, numbers, equilibrium in family.samples():
        eigenvalues = np.linalg.eigvals(family.jacobian(equilibrium, numbers))
        largest = max(eigenvalues.real)
        if abs(largest) < 1e-9 * (1 + max(abs(eigenvalues))):
            raise RuntimeError("the linearisation does not decide here")
        if claim != ("unstable" if largest > 0 else "asymptotically stable"):
            raise Wrong(
                f"{sample_text(values)}this does not agree with the linearisation: look at "
                "the signs of the real parts of its roots"
            )
    return f"it agrees with the roots of the linearisation{tried_text(parameters)}"


@judged
def stationary_type(answer, field, state, parameters, domain=None):
    """Check the type of the stationary point of a planar system.

    It is the same for all values of the parameters.
    """
    spelled = (
        answer.lower().replace("center", "centre").replace("star node", "star")
        if isinstance(answer, str)
        else answer
    )
    claim = coercion.as_choice(spelled, TYPES)
    family = stationary_points_of(field, state, parameters, domain)
    for values, numbers, equilibrium in family.samples():
        matrix = family.jacobian(equilibrium, numbers)
        kind = _kind(matrix)
        if claim != kind:
            raise Wrong(
                f"{sample_text(values)}the roots of the linearisation are not those of a {claim}"
            )
    return f"it agrees with the roots of the linearisation{tried_text(parameters)}"


@judged
def focus_region(answer, field, state, parameters, domain=None):
    """Check the parameters for which the stationary point is a focus.

    The border, where the roots are equal, counts either way. Without a domain the
    equation is phi'' = f(phi, phi'), periodic in phi, and all its stationary angles that are no
    saddles have to be foci.
    """
    return _judge_roots(answer, field, state, parameters, domain, -1)


@judged
def node_region(answer, field, state, parameters, domain=None):
    """Check the parameters for which the stationary point is a node.

    The border, where the roots are equal, counts either way. Without a domain the
    equation is phi'' = f(phi, phi'), periodic in phi, and all its stationary angles that are no
    saddles have to be nodes.
    """
    return _judge_roots(answer, field, state, parameters, domain, 1)


def _judge_points(answer, family, noun, searched=None):
    """Judge all equilibria of a family, one point or a list; they are those of `searched`."""
    points = _points(answer, family)
    in_domain = [False] * len(points)
    for values, numbers, equilibria in (searched or family).samples(points, alone=False):
        missed, outside = list(equilibria), ""
        for k, point in enumerate(points):
            position = [real_at(coordinate, values) for coordinate in point]
            if any(coordinate is None for coordinate in position):
                outside = f"; your answer gives {NO_NUMBER}"
                continue
            position = family.rounded_inside(np.array(position, dtype=float), point)
            if not family.inside(position):
                outside = (
                    f"; {_position_text(family.state, position)}, which your answer gives, lies "
                    "outside the domain"
                )
                continue
            in_domain[k] = True
            uncertainties = [uncertainty_at(coordinate, values) for coordinate in point]
            matches = [
                j
                for j, equilibrium in enumerate(missed)
                if family.is_same_point(position, equilibrium, point, uncertainties)
            ]
            if not matches:
                if any(
                    family.is_same_point(position, equilibrium, point, uncertainties)
                    for equilibrium in equilibria
                ):
                    raise Wrong(f"{sample_text(values)}two of your points are the same")
                rates = family(position, numbers)
                if not equilibria and np.all(abs(rates) < 1e-9):
                    continue  # the search did not find it
                message = (
                    f"sides are {_vector_text(rates)}"
                    if len(rates) > 1
                    else f"side is {rates[0]:.4g}"
                )
                raise Wrong(
                    f"{sample_text(values)}your answer gives "
                    f"{_position_text(family.state, position)}; the right-hand {message} there, not zero"
                )
            del missed[matches[0]]
        if missed:
            raise Wrong(
                f"{sample_text(values)}there is a {noun} in the domain that your answer does "
                f"not give{outside}"
            )
    if not all(in_domain):
        raise Wrong(
            f"point {in_domain.index(False) + 1} of your list lies outside the domain"
            + (" for all sample values of the parameters" if family.parameters else "")
        )
    return f"it gives every {noun} in the domain and nothing else{tried_text(family.parameters)}"


def _judge_existence(answer, family, noun):
    def at(values):
        numbers = family.numbers(values)
        return (
            None if numbers is None else bool(family.newton(numbers, starts=32, steps=40)[1].any())
        )

    def message(values, holds):
        return (
            f"for {values_text(values)} there is {'a' if holds else 'no'} {noun}, yet your "
            f"condition {'does not hold' if holds else 'holds'}"
        )

    assumptions, at_rest = family.domain_condition, family.at_rest
    reference = ReferenceCondition(
        (Case(sp.And(assumptions, at_rest), tuple(family.state)),),
        (Case(sp.And(assumptions, sp.Not(at_rest)), tuple(family.state), every=True),),
        at,
    )
    agreement = compare(answer, family.parameters, reference, message)
    return f"there is a {noun} exactly for these parameters: {agreement}"


def _judge_roots(answer, field, state, parameters, domain, sign):
    """Compare a condition with the sign of the discriminant: -1 focus, 1 node."""
    if domain is None and is_angle_equation(field, state):
        return judge_angle_roots(answer, field, state, parameters, sign)
    return _judge_point_roots(
        answer,
        stationary_points_of(field, state, parameters, domain),
        sign,
        "a node" if sign > 0 else "a focus",
    )


def _judge_point_roots(answer, family, sign, noun):

    def at(values):
        numbers = family.numbers(values)
        if numbers is None:
            return None
        positions, exist = family.single_points(numbers)
        ((a,), (b,)), ((c,), (d,)) = family.jacobian(positions, numbers)
        trace, determinant, size = a + d, a * d - b * c, a**2 + b**2 + c**2 + d**2
        discriminant = trace**2 - 4 * determinant
        decided = (
            abs(discriminant) > 1e-9 * size
            and abs(determinant) > 1e-9 * size
            and trace**2 > 1e-9 * size
        )
        return (
            bool(np.sign(discriminant) == sign and determinant > 0)
            if exist[0] and decided
            else None
        )

    def message(values, holds):
        return (
            f"for {values_text(values)} the stationary point is {'' if holds else 'not '}{noun}, "
            f"yet your condition {'does not hold' if holds else 'holds'}"
        )

    _, determinant, discriminant = family.invariants
    decided = sp.And(
        family.domain_condition, family.at_rest, *(sp.Ne(x, 0) for x in family.invariants)
    )
    reference = exactly(
        sp.And(sign * discriminant > 0, determinant > 0), decided, tuple(family.state), at
    )
    agreement = compare(answer, family.parameters, reference, message)
    return f"the stationary point is {noun} exactly for these parameters: {agreement}"


def _points(answer, family):
    """Return a list of points, each a list of expressions, from one point or a list of them."""
    n = len(family.state)

    def single(point):
        point = in_order(point, family.state)
        if n == 1 and not isinstance(point, VECTORS):
            point = [point]
        return coercion.as_expressions(point, family.parameters, length=n)

    if isinstance(answer, sp.MatrixBase) and 1 not in answer.shape:
        answer = [list(answer.row(k)) for k in range(answer.rows)]
    if isinstance(answer, np.ndarray):
        answer = answer.tolist()
    if isinstance(answer, (set, frozenset, sp.FiniteSet)):
        return [single(point) for point in answer]
    if isinstance(answer, (list, tuple)) and (
        n == 1 or any(isinstance(point, (dict, *VECTORS)) for point in answer)
    ):
        if (
            n > 1
            and len(answer) == n
            and all(isinstance(p, (list, tuple)) and len(p) == 1 for p in answer)
        ):
            return [single(answer)]  # a column
        points = [single(point) for point in answer]
        if not points:
            raise Invalid("expected at least one point")
        return points
    return [single(answer)]


def _scale(expression, values, state, equilibrium):
    """Return the size of the terms of an expression at a point: their sum may cancel."""
    numbers = values | {x: sp.Float(float(v), 20) for x, v in zip(state, equilibrium)}
    return sum(
        abs(real_at(term, numbers) or 0.0) for term in sp.Add.make_args(sp.expand(expression))
    )


def _kind(matrix):
    """Return the type of the stationary point whose linearisation is this matrix."""
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


def _position_text(state, position):
    return ", ".join(f"{s} = {x:.4g}" for s, x in zip(state, position))


def _vector_text(values):
    """Return numbers for a message; rounding errors of a zero are shown as zero."""
    size = max(abs(value) for value in values)
    return point_text([value if abs(value) > 1e-12 * size else 0.0 for value in values])
