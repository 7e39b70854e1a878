"""Singular arcs: where the switching function vanishes on an interval, and the control that keeps
it zero.

H is linear in u and dH/du = 0 on an interval. Its time derivatives along the trajectory vanish too;
the first that contains u is of even order 2q,

    d^(2q)/dt^(2q) dH/du = a(psi, y) + u b(psi, y),

q is the order of the singular arc and u = -a/b its control. A minimum needs (-1)^q b <= 0 (Kelley;
Theorem 5.2 of the problem book). The equations dH/du = ... = d^(2q-1)/dt^(2q-1) dH/du = 0 are
linear in (psi, lambda_0): a singular arc exists only where they, with H = 0 for a free final time,
have a solution that is not zero.
"""

from dataclasses import dataclass
from itertools import combinations, islice

import sympy as sp

#: Derivatives of the switching function are looked at up to so many terms. Those of a robot's arm
#: grow sixfold with each and would take hours; those of the problems of this book have a dozen.
MOST_TERMS = 100


@dataclass(frozen=True, eq=False)
class SingularArc:
    """What can be said of the singular arcs of one control.

    - `order`: q, or None if no derivative of the switching function contains the control, as far as
      they were looked at
    - `derivatives`: dH/du and its time derivatives, of orders 0 to 2q-1, which vanish on the arc
    - `control`: the singular control -a/b, with what these equations say about (psi, lambda_0) put
      in; None if unknown
    - `kelley`: (-1)^q b; a minimum needs kelley <= 0
    - `surface`: expressions in the state alone that vanish on the arc (none: the state is not
      restricted)
    - `excluded`: True if the equations leave only (psi, lambda_0) = 0, so that there is no such arc
    - `reason`: the result in words
    """

    control_symbol: sp.Symbol
    order: int | None
    derivatives: tuple
    control: sp.Expr | None
    kelley: sp.Expr | None
    surface: tuple
    excluded: bool
    reason: str


def singular_arc(derived, u):
    """`SingularArc` of the control `u` in the `Conditions` given; the other controls are taken to
    be constant.

    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x, u = sp.symbols("x u")
    >>> turnpike = Problem({x: u}, {u: (-1, 1)}, {x: 1}, {x: sp.Rational(1, 2)}, running=x**2, duration=2)
    >>> arc = turnpike.conditions().singular[u]
    >>> arc.order, arc.surface, arc.control, arc.kelley
    (1, (x,), 0, -2*lambda0)
    """
    derivatives, highest = raw_derivatives(derived, u, MOST_TERMS)
    if highest is None and len(sp.Add.make_args(derivatives[-1])) > MOST_TERMS:
        return SingularArc(
            u,
            None,
            derivatives[:-1],
            None,
            None,
            (),
            False,
            f"the derivatives of the switching function have more than {MOST_TERMS} terms before "
            f"it is known what keeps it zero: singular arcs of {u} are not looked for",
        )
    order = len(derivatives) // 2 if highest is not None else None
    unknowns = (
        derived.costate if derived.problem.running == 0 else (*derived.costate, derived.multiplier)
    )
    equations = list(derivatives)
    if derived.problem.duration is None:
        equations.append(derived.hamiltonian.subs(u, 0))
    surface = _surface(sp.Matrix(equations).jacobian(unknowns), derived.problem.state)
    if surface is None:
        return SingularArc(
            u,
            order,
            derivatives,
            None,
            None,
            (),
            True,
            "the equations leave only psi = 0, lambda_0 = 0: there is no singular arc",
        )
    if highest is None:
        return SingularArc(
            u,
            None,
            derivatives,
            None,
            None,
            surface,
            False,
            f"no derivative of the switching function contains {u}: it is not determined on a "
            "singular arc",
        )
    highest = sp.expand(sp.simplify(highest), power_exp=False)
    a, b = highest.subs(u, 0), sp.diff(highest, u)
    known = _eliminated(derivatives, derived, unknowns, surface)
    kelley = sp.factor(
        sp.trigsimp(_on(surface, (-1) ** order * b.subs(known), derived.problem.state))
    )
    control = None
    if kelley != 0:
        control = _on(surface, sp.simplify((-a / b).subs(known)), derived.problem.state)
    words = (
        "zero, so that the control is not determined"
        if kelley == 0
        else "negative"
        if kelley.is_negative
        else "not positive"
        if kelley.is_nonpositive
        else "positive: such an arc minimises nothing"
        if kelley.is_positive
        else "of a sign that depends on the point"
    )
    return SingularArc(
        u,
        order,
        derivatives,
        control,
        kelley,
        surface,
        False,
        f"order {order}; (-1)^q b = {kelley} is {words}",
    )


def raw_derivatives(derived, u, most=None):
    """dH/du and its derivatives as long as they do not contain u, and the first that does (None if
    none). One of more than `most` terms is the last, whether it contains u or not."""
    derivatives = [derived.switching[u]]
    for _ in range(2 * len(derived.costate)):
        following = sp.expand(derived.derivative(derivatives[-1]), power_exp=False)
        if most and len(sp.Add.make_args(following)) > most:
            return (*derivatives, following), None
        if len(derivatives) % 2 == 0 and not _vanishes(sp.diff(following, u)):
            return tuple(derivatives), following
        if following == 0:
            break
        # With several controls u may appear in an odd derivative, where (Goh's condition) its
        # factor vanishes.
        derivatives.append(following.subs(u, 0))
    return tuple(derivatives), None


def _vanishes(expression):
    """Whether an expression is zero identically: values decide that it is not, much faster than
    rules that it is."""
    point = {
        s: sp.Rational(2 * k + 3, 2 * k + 5)
        for k, s in enumerate(sorted(expression.free_symbols, key=str))
    }
    value = expression.evalf(subs=point)
    if value.is_number and abs(value) > 1e-10:
        return False
    return sp.simplify(expression) == 0


def _surface(matrix, state):
    """Where the linear equations for the multipliers have a solution that is not zero.

    A tuple of expressions that vanish there, empty if this is everywhere, None if it is nowhere.
    """
    if matrix.rows < matrix.cols:
        return ()
    # A few minors are enough: what all have in common is the surface.
    minors = {
        _state_factors(matrix.extract(list(rows), list(range(matrix.cols))).det(), state)
        for rows in islice(combinations(range(matrix.rows), matrix.cols), 12)
    } - {sp.Integer(0)}
    if not minors:
        return ()
    if 1 in minors:
        return None
    common = sp.gcd_list(sorted(minors, key=str)) if len(minors) > 1 else next(iter(minors))
    if common.free_symbols & set(state):
        return (common,)
    # x1 = x2 = 0 needs no x1*x2 = 0 beside it.
    return tuple(
        m
        for m in sorted(minors, key=sp.default_sort_key)
        if not any(o != m and sp.denom(sp.cancel(m / o)).is_number for o in minors)
    )


def _state_factors(expression, state):
    """The factors of the numerator that contain the state, each once; 1 if there are none, 0 for
    zero."""
    numerator = sp.numer(sp.together(expression))
    if sp.expand(numerator) == 0:
        return sp.Integer(0)
    bases = {
        f.as_base_exp()[0]
        for f in sp.Mul.make_args(sp.factor(numerator))
        if f.free_symbols & set(state)
    }
    # An exponential has no zeros.
    return sp.Mul(*(b for b in bases if b != sp.E and not isinstance(b, sp.exp)))


def _eliminated(derivatives, derived, unknowns, surface):
    """The costates that the equations determine, in terms of the other ones."""
    matrix, known = sp.Matrix(derivatives).jacobian(unknowns), {}
    matrix = matrix.applyfunc(lambda e: _on(surface, e, derived.problem.state))
    reduced, pivots = matrix.rref(simplify=True)
    # On a surface that cannot be put in, the equations still seem to leave only zero: there the
    # others imply the last.
    stays = not all(_can_be_put_in(equation, derived.problem.state) for equation in surface)
    while stays and pivots and len(pivots) == sum(any(matrix.col(j)) for j in range(matrix.cols)):
        matrix = matrix[:-1, :]
        reduced, pivots = matrix.rref(simplify=True)
    for row, pivot in enumerate(pivots):
        # On the surface an equation for lambda_0 alone is satisfied.
        if unknowns[pivot] != derived.multiplier:
            known[unknowns[pivot]] = -sum(
                (reduced[row, j] * unknowns[j] for j in range(len(unknowns)) if j != pivot),
                sp.Integer(0),
            )
    return known


def _can_be_put_in(equation, state):
    """Whether `_on` can use an equation of the surface."""
    return isinstance(equation, (sp.sin, sp.cos, sp.tan)) or any(
        equation.is_polynomial(y) and sp.degree(equation, y) == 1 for y in state
    )


def _on(surface, expression, state):
    """The shortest form of an expression on the surface.

    One state is eliminated where the surface is linear in it; on a surface sin(g) = 0 (cos, tan)
    the function is zero.
    """
    candidates = [expression]
    for equation in surface:
        if isinstance(equation, (sp.sin, sp.cos, sp.tan)):
            # sin(y) = 0 leaves cos(y) = +-1 on the two branches of the surface.
            candidates.append(
                sp.simplify(candidates[-1 if len(surface) > 1 else 0].subs(equation, 0))
            )
            continue
        for y in state:
            if equation.is_polynomial(y) and sp.degree(equation, y) == 1:
                candidates.append(
                    sp.simplify(
                        candidates[-1 if len(surface) > 1 else 0].subs(y, sp.solve(equation, y)[0])
                    )
                )
                if len(surface) > 1:
                    break
    return min(candidates, key=sp.count_ops)
