"""Stationary solutions that depend on parameters or repeat periodically, and stability.

An equation of second order in x is given as the field of its state (x, x'). A stationary solution
x(t) = x* is named by the number x* alone; a periodic family of them is an expression in an integer
and is judged by its members. The assumptions of the problem on its parameters (friction is positive)
are the condition `given`.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression
from workbook.checks.contract.members import VECTORS, families
from workbook.checks.contract.tolerance import REPEATED, agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.fields import Field
from workbook.checks.stability.equilibrium_sets import agreement
from workbook.checks.tools.conditions import (
    Case,
    ReferenceCondition,
    compare,
    contradiction_message,
)
from workbook.checks.tools.samples import allowed_values, conjunction, in_every_case
from workbook.checks.tools.turns import finite_list_text, members_of
from workbook.checks.tools.values import entry_uncertainties, matrix_at, number_at, uncertainty_at
from workbook.checks.tools.wording import number_text, point_text, where_text

#: Stationary values are compared between -REACH and REACH; families are followed as far as that and
#: a little further.
REACH = 12.0
#: What rounding leaves of a zero matrix, next to the largest one.
ROUNDING = 1e-12
#: For each word of `agreement`: the name of the kind in messages, and the test of an equilibrium.
KIND_TESTS = {
    "stationary": ("stationary solutions", lambda flow, point: True),
    "asymptotically stable": (
        "asymptotically stable ones",
        lambda flow, point: _growth(flow, point) < 0,
    ),
    "unstable": ("unstable ones", lambda flow, point: _growth(flow, point) > 0),
}


@judged
def equilibrium_values(answer, field, state, parameters=(), given=(), integer=None):
    """Check the values x* of all stationary solutions x(t) = x*.

    They are expressions in the parameters and an integer.

    Every member is one, and a search finds no other. Also read: SymPy sets, and points (x*, 0).
    """
    return "at each of them the right-hand sides vanish, and a search finds no other" + _judge_all(
        "stationary", answer, field, state, parameters, given, integer
    )


@judged
def stable_equilibrium_values(answer, field, state, parameters=(), given=(), integer=None):
    """Check the stationary values that Theorem 1.4 proves asymptotically stable.

    The form is that of `equilibrium_values`.
    """
    return (
        "there, and nowhere else, all roots of the characteristic equation have negative real parts"
        + _judge_all("asymptotically stable", answer, field, state, parameters, given, integer)
    )


@judged
def unstable_equilibrium_values(answer, field, state, parameters=(), given=(), integer=None):
    """Check the stationary values that Theorem 1.4 proves unstable.

    The form is that of `equilibrium_values`.
    """
    return (
        "there, and nowhere else, a root of the characteristic equation has a positive real part"
        + _judge_all("unstable", answer, field, state, parameters, given, integer)
    )


def _judge_all(word, answer, field, state, parameters, given, integer):
    """Judge that an answer names all equilibria of a kind, a key of `KIND_TESTS`, and no others.

    Return the text on how this is known.
    """
    claims, (noun, is_of_kind) = _claims(answer, state, parameters, integer), KIND_TESTS[word]
    for values, flow, equilibria in sampled_systems(field, state, parameters, given, claims):
        _judge_values(
            claims,
            values,
            flow,
            equilibria,
            [point for point in equilibria if is_of_kind(flow, point)],
            integer,
            noun,
        )
    return agreement(claims, integer, field, state, parameters, conjunction(given), word)


@judged
def linearisation_matrices(answer, field, state, parameters=(), given=(), integer=None, zeros=None):
    """Check the matrices A of y' = A y that occur at the stationary solutions.

    The order of the matrices is free; y are the deviations.

    Where A may be singular, `zeros` are functions that have the same zeros as the field, all
    simple.
    """
    n = len(state)
    matrices = [
        coercion.as_matrix(part, [*parameters, *_symbols(integer)], (n, n))
        for part in _list_of_matrices(answer)
    ]
    for values, flow, equilibria in sampled_systems(
        field, state, parameters, given, matrices, zeros
    ):
        references = [(point, flow.jacobian(point)) for point in equilibria]
        floor = ROUNDING * max(np.linalg.norm(reference) for _, reference in references)
        claimed = [
            (matrix_at(matrix, at), matrix, entry_uncertainties(matrix, at))
            for matrix in matrices
            for k in (range(-2, 3) if matrix.has(*_symbols(integer)) else (0,))
            for at in [values | {s: sp.Integer(k) for s in _symbols(integer)}]
        ]
        for matrix in claimed:
            if not any(_matrices_agree(matrix, reference, floor) for _, reference in references):
                raise Wrong(
                    f"the matrix {_matrix_text(matrix[0])}{where_text(values)} does not consist of the "
                    "partial derivatives of the right-hand sides at any stationary solution"
                )
        for _, reference in references:
            if not any(_matrices_agree(matrix, reference, floor) for matrix in claimed):
                raise Wrong(
                    "a matrix is missing: at one of the stationary solutions the partial derivatives "
                    f"of the right-hand sides form a matrix that is not in your list{where_text(values)}"
                )
    return (
        "they are the matrices of the linear deviation equations at the stationary solutions "
        "found, and none is left over"
    )


@judged(Expression("parameters"))
def growth_rate(claim, field, state, parameters=(), given=()):
    """Check the positive eigenvalue at the unstable stationary solutions.

    It is the positive root of the characteristic equation there.
    """
    for values, flow, equilibria in sampled_systems(field, state, parameters, given, claim):
        number = number_at(claim, values)
        for point in equilibria:
            matrix = flow.jacobian(point)
            rate = max(np.linalg.eigvals(matrix).real)
            if rate <= 1e-9 or agree(
                number, rate, claim, 0, REPEATED, uncertainty_at(claim, values)
            ):
                continue
            residual = abs(np.linalg.det(number * np.eye(len(state)) - matrix))
            # The message does not name the solution: another item asks for it.
            message = (
                "it is a root of the characteristic equation at an unstable stationary solution, "
                "but not a positive one"
                if residual < 1e-9 * np.linalg.norm(matrix) ** len(state)
                else "at an unstable stationary solution the characteristic determinant has the modulus "
                f"{residual:.4g} for it, not zero"
            )
            raise Wrong(
                f"your expression gives {number_text(number)}{where_text(values)}; {message}"
            )
    return "it is positive and a root of the characteristic equation at every unstable stationary solution"


@judged
def unique_equilibrium(answer, field, state, parameters):
    """Check the parameters for which x' = f(x) has one stationary solution only.

    The right-hand side f is a polynomial; its real roots are counted exactly.
    """
    *kinematic, force = [sp.sympify(f).subs(dict.fromkeys(state[1:], 0)) for f in field]
    if any(second != 0 for second in kinematic):
        raise RuntimeError("this is no equation of second order")
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


def sampled_systems(field, state, parameters, given, claim=(), zeros=None):
    """Yield triples (values, field, equilibria between -REACH and REACH) for sampled parameters.

    There are four samples that satisfy `given`, and more where the answer distinguishes cases that
    these do not cover. The equilibria are the zeros of `zeros`, if these are given.
    """
    for values in in_every_case(allowed_values(parameters, given, 4), claim, given):
        yield (
            values,
            *_field_and_equilibria(
                tuple(field),
                tuple(state),
                tuple(field if zeros is None else zeros),
                tuple(values.items()),
            ),
        )


@functools.lru_cache(maxsize=64)
def _field_and_equilibria(field, state, zeros, values):
    # Cached: several answers of a problem concern the same equation.
    points = Field(zeros, state, dict(values)).equilibria(160, reach=1.2 * REACH)
    return Field(field, state, dict(values)), [point for point in points if abs(point[0]) < REACH]


def _claims(answer, state, parameters, integer):
    """Return the expressions of an answer: one, a list, a SymPy set, or points (x*, 0)."""
    symbols = [*parameters, *_symbols(integer)]
    parts = families(
        answer,
        integer,
        "the values written out: a list of expressions, or a set as solveset gives it",
    )
    return [first_coordinate(part, state, symbols) for part in parts]


def first_coordinate(part, state, symbols):
    """Return the value x* of a number or of a point (x*, 0, ...)."""
    if isinstance(part, VECTORS) and np.ndim(part) > 0:
        first, *velocities = coercion.as_expressions(part, symbols, len(state))
        if any(velocity != 0 for velocity in velocities):
            raise Wrong(
                f"at a stationary solution {', '.join(f'{x} = 0' for x in state[1:])}: nothing "
                "moves there"
            )
        return first
    return coercion.as_expression(part, symbols)


def _judge_values(claims, values, flow, equilibria, expected, integer, noun):
    claimed = []
    for family in claims:
        for member_text, number, member_values in members_of(family, values, integer, REACH):
            if abs(number.imag) > 1e-9 * (1 + abs(number)):
                raise Wrong(f"your value{member_text} is not real{where_text(values)}")
            number = number.real
            if abs(number) > REACH:
                continue
            matching = [
                point for point in equilibria if is_value(number, point[0], family, member_values)
            ]
            if not matching:
                rates_text = point_text(flow([number] + [0.0] * (len(flow.state) - 1)))
                raise Wrong(
                    f"your value {number:.4g}{member_text} is no stationary solution{where_text(values)}: "
                    f"the right-hand sides are {rates_text} there"
                )
            if not any(point is matching[0] for point in expected):
                raise Wrong(
                    f"your value {number:.4g}{member_text} is a stationary solution, but none of the "
                    f"{noun}{where_text(values)}: look at the real parts of the roots there"
                )
            claimed.append(matching[0])
    if any(not any(point is match for match in claimed) for point in expected):
        raise Wrong(
            f"not all {noun} are there: between -{REACH:g} and {REACH:g} a search finds one that "
            f"your answer does not give{where_text(values)}"
        )
    if integer is None or any(family.has(integer) for family in claims):
        return
    for point in expected:  # a finite list for an equation that is periodic in x
        next_turn = np.array([point[0] + 20 * np.pi, *point[1:]])
        if np.all(abs(flow(next_turn)) < 1e-9 * (1 + abs(next_turn[0]))):
            raise Wrong(finite_list_text(noun, next_turn[0], where_text(values), integer))


def _growth(flow, point):
    rate = max(np.linalg.eigvals(flow.jacobian(point)).real)
    if abs(rate) < 1e-8:
        raise RuntimeError("the linearisation does not decide here")
    return rate


def _list_of_matrices(answer):
    """Return the matrices of an answer: a list, a dict of matrices, or a single matrix."""
    if isinstance(answer, dict):
        answer = list(answer.values())
    if isinstance(answer, sp.MatrixBase) or (isinstance(answer, np.ndarray) and answer.ndim == 2):
        return [answer]
    if isinstance(answer, (set, frozenset, np.ndarray, sp.FiniteSet)):
        answer = list(answer)
    if not isinstance(answer, (list, tuple)) or not answer:
        raise Invalid("expected a list of matrices")
    flat = all(
        isinstance(row, (list, tuple))
        and not any(isinstance(entry, (list, tuple)) for entry in row)
        for row in answer
    )
    return [answer] if flat else list(answer)


def _symbols(integer):
    return [] if integer is None else [integer]


def _matrices_agree(claimed, reference, floor):
    numbers, written, uncertain = claimed
    agrees = agree(numbers, reference, written, np.linalg.norm(reference), REPEATED, uncertain)
    return bool(np.all(agrees | (np.abs(numbers - reference) <= floor)))


def is_value(number, value, claim, values):
    """Return whether a value of the expression `claim` agrees with a computed one."""
    return agree(number, value, claim, 1, REPEATED, uncertainty_at(claim, values))


def _matrix_text(matrix):
    return "; ".join(point_text(row.real) for row in matrix)
