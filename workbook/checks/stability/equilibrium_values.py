"""Equilibria of second-order equations by their values x*, families of them among these.

An equation in x is given as the field of its state (x, x'). An equilibrium x(t) = x* is named by
the number x* alone; a periodic family of them is an expression in an integer and is judged by its
members: a turn more of each is one too, and a list of finitely many is not all. The assumptions of
the problem on its parameters (friction is positive) are the condition `given`; values of the
parameters without an equilibrium are left out.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression
from workbook.checks.contract.members import VECTORS, families
from workbook.checks.contract.tolerance import REPEATED, agree
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.stability.equilibrium_sets import agreement
from workbook.checks.tools.samples import conjunction
from workbook.checks.tools.values import number_at, uncertainty_at
from workbook.checks.tools.wording import number_text, point_text, where_text

#: Values are compared between -REACH and REACH; families are followed as far as that and a little
#: further, but at most MOST members on either side of the middle one.
REACH, MOST = 12.0, 60


@judged
def equilibrium_values(answer, field, state, parameters=(), given=(), integer=None, kind=None):
    """Check the values x* of all equilibria x(t) = x* of an equation, or of those of a kind.

    They are expressions in the parameters and an integer.

    Every member is one, and a search finds no other. Also read: SymPy sets, and points (x*, 0). The
    kind is decided by linearisation (Theorem 1.4).

    Can decide when the field is that of one equation of second order and its equilibria are simple
    zeros, for sample values that satisfy what is given.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> n = sp.Symbol("n", integer=True)
    >>> checks.equilibrium_values(sp.pi*n, [y, -sp.sin(x)], [x, y], [], integer=n).status
    'right'
    >>> checks.equilibrium_values(2*sp.pi*n, [y, -sp.sin(x)], [x, y], [], integer=n).status
    'wrong'
    """
    symbols = [*parameters, *([] if integer is None else [integer])]
    expected = "the values written out: a list of expressions, or a set as solveset gives it"
    claims = [
        first_coordinate(part, state, symbols) for part in families(answer, integer, expected)
    ]
    for values, family, numbers, points in equilibria_within_reach(
        field, state, parameters, given, claims
    ):
        _judge_values(claims, values, family, numbers, points, integer, kind)
    proof = agreement(claims, integer, field, state, parameters, conjunction(given), kind)
    return f"these are {_noun(kind)}, and a search finds no other{proof}"


@judged(Expression("parameters"))
def growth_rate(claim, field, state, parameters=(), given=()):
    """Check the positive eigenvalue at the unstable equilibria.

    It is the positive root of the characteristic equation there.

    Can decide when the unstable equilibria have one positive eigenvalue; with parameters at sample
    values.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.growth_rate(1, [y, x - x**3], [x, y], []).status
    'right'
    >>> checks.growth_rate(2, [y, x - x**3], [x, y], []).status
    'wrong'
    """
    for values, family, numbers, points in equilibria_within_reach(
        field, state, parameters, given, claim
    ):
        number = number_at(claim, values)
        for matrix in (family.jacobian(point, numbers) for point in points):
            rate = max(np.linalg.eigvals(matrix).real)
            if rate <= 1e-9 or agree(
                number, rate, claim, 0, REPEATED, uncertainty_at(claim, values)
            ):
                continue
            residual = abs(np.linalg.det(number * np.eye(len(state)) - matrix))
            # The message does not name the equilibrium: another item asks for it.
            message = (
                "it is a root of the characteristic equation at an unstable equilibrium, but not a "
                "positive one"
                if residual < 1e-9 * np.linalg.norm(matrix) ** len(state)
                else "at an unstable equilibrium the characteristic determinant has the modulus "
                f"{residual:.4g} for it, not zero"
            )
            raise Wrong(
                f"your expression gives {number_text(number)}{where_text(values)}; {message}"
            )
    return "it is positive and a root of the characteristic equation at every unstable equilibrium"


def equilibria_within_reach(field, state, parameters=(), given=(), claim=()):
    """Yield (values, `Equilibria`, parameters as floats, points with |x| < REACH) for samples.

    The samples satisfy `given` and have an equilibrium.
    """
    family = equilibria_of(field, state, parameters, given=given)
    for values, numbers, points in family.samples(claim, count=3, alone=False):
        if points:
            yield values, family, numbers, [point for point in points if abs(point[0]) < REACH]


def first_coordinate(part, state, symbols):
    """Return the value x* of a number or of a point (x*, 0, ...)."""
    if isinstance(part, VECTORS) and np.ndim(part) > 0:
        first, *velocities = coercion.as_expressions(part, symbols, len(state))
        if any(velocity != 0 for velocity in velocities):
            raise Wrong(
                f"at an equilibrium {', '.join(f'{x} = 0' for x in state[1:])}: nothing moves there"
            )
        return first
    return coercion.as_expression(part, symbols)


def is_value(number, value, claim, values):
    """Return whether a value of the expression `claim` agrees with a computed one."""
    return agree(number, value, claim, 1, REPEATED, uncertainty_at(claim, values))


def _judge_values(claims, values, family, numbers, points, integer, kind):
    claimed, where, noun = [], where_text(values), _noun(kind)
    chosen = family.of_kind(kind, points, numbers)
    for claim in claims:
        for member, number, at in _members(claim, values, integer):
            if abs(number.imag) > 1e-9 * (1 + abs(number)):
                raise Wrong(f"your value{member} is not real{where}, where there are equilibria")
            number = number.real
            if abs(number) > REACH:
                continue
            position = np.array([number] + [0.0] * (len(family.state) - 1))
            found = [p for p in points if is_value(number, p[0], claim, at)]
            if not found:  # one that the search did not find is one nevertheless
                refined = family.refined(position, numbers)
                if refined is not None and is_value(number, refined[0], claim, at):
                    found = [refined]
            if not found:
                rates = family(position, numbers)
                raise Wrong(
                    f"your value {number:.4g}{member} is no equilibrium{where}: the right-hand sides "
                    f"are {point_text(rates)} there"
                )
            if not family.of_kind(kind, found[:1], numbers):
                raise Wrong(
                    f"your value {number:.4g}{member} is an equilibrium, but none of the {noun}{where}: "
                    "look at the real parts of the roots of the characteristic equation there"
                )
            claimed.append(found[0])
    missed = [p for p in chosen if not any(np.allclose(p, q, atol=1e-6) for q in claimed)]
    periodic = integer is not None and all(_is_periodic(family, p, numbers) for p in chosen)
    if any(not periodic or not any(_same_angle(p, q) for q in claimed) for p in missed):
        raise Wrong(
            f"not all {noun} are there: between -{REACH:g} and {REACH:g} a search finds one that "
            f"your answer does not give{where}{', not even in another turn' if periodic else ''}"
        )
    if chosen and periodic and not any(claim.has(integer) for claim in claims):
        raise Wrong(
            f"not all {noun} are there: {chosen[0][0] + 20 * np.pi:.4g} is one too{where}, and a list "
            f"has an end; write the family with the integer {integer}"
        )
    if missed:
        raise Wrong(
            f"not all {noun} are there: in some turns your answer gives one, and in others it does "
            f"not{where}"
        )


def _noun(kind):
    return "equilibria" if kind is None else f"{kind} equilibria"


def _is_periodic(family, point, numbers):
    """Return whether there is an equilibrium ten turns from a point, too."""
    turned = np.array([point[0] + 20 * np.pi, *point[1:]])
    return np.all(abs(family(turned, numbers)) < 1e-9 * (1 + abs(turned[0])))


def _same_angle(one, other):
    return abs(np.remainder(one[0] - other[0] + np.pi, 2 * np.pi) - np.pi) < 1e-6


def _members(claim, values, integer):
    """Return the members of a family between -REACH and REACH, and a few beyond either end.

    They are triples: the text on the member for a message, its complex number, the values with the
    integer. Without the integer a family has one member.
    """

    def member(k):
        member_values = values if integer is None else values | {integer: sp.Integer(k)}
        return number_at(claim, member_values, "your value"), member_values

    if integer is None or not claim.has(integer):
        return [("", *member(0))]
    # Of a family such as (-1)^n a + pi n every second step is the same.
    (start, _), (following, _) = member(0), member(2)
    step = abs(following - start) / 2
    centre = round((2 * start / (start - following)).real) if step > 1e-9 else 0
    extent = min(int(REACH / step) + 3, MOST) if step > 1e-9 else 12
    return [
        (f" ({integer} = {k})", *member(k)) for k in range(centre - extent, centre + extent + 1)
    ]
