"""Singular arcs: their order, control, surface and Kelley's condition.

H is linear in u and dH/du = 0 on an interval. Its time derivatives along the trajectory vanish too;
the first that contains u is of even order 2q,

    d^(2q)/dt^(2q) dH/du = a(psi, y) + u b(psi, y),

q is the order of the singular arc and u = -a/b its control. Where u lies strictly between its
bounds, a minimum needs (-1)^q b <= 0 (Kelley; Theorem 5.2 of the problem book). The equations
dH/du = ... = d^(2q-1)/dt^(2q-1) dH/du = 0 are linear in (psi, lambda_0): a singular arc exists only
where they, with H = 0 for a free final time, have a solution that is not zero.
"""

from dataclasses import dataclass
from itertools import combinations, islice

import sympy as sp

#: Derivatives of the switching function are computed up to so many terms. Those of a robot's arm
#: grow sixfold with each and would take hours; those of the problems of this book have a dozen.
MAX_TERMS = 100


@dataclass(frozen=True, eq=False)
class SingularArc:
    """The singular arcs of one control.

    Attributes
    ----------
    control_symbol : sympy.Symbol
        The control u.
    order : int or None
        q; None if no derivative of the switching function contains u, as far as they were computed.
    derivatives : tuple of sympy.Expr
        dH/du and its time derivatives of orders 0 to 2q-1, which vanish on the arc.
    control : sympy.Expr or None
        The singular control -a/b, with the costates eliminated by these equations; None if unknown.
    kelley : sympy.Expr or None
        (-1)^q b; a minimum needs kelley <= 0 where the control lies strictly between its bounds.
    surface : tuple of sympy.Expr
        Expressions in the state alone that vanish on the arc; empty if the state is not restricted.
    excluded : bool
        Whether the equations leave only (psi, lambda_0) = 0, so that there is no such arc.
    reason : str
        The result in words.
    """

    control_symbol: sp.Symbol
    order: int | None
    derivatives: tuple[sp.Expr, ...]
    control: sp.Expr | None
    kelley: sp.Expr | None
    surface: tuple[sp.Expr, ...]
    excluded: bool
    reason: str


def singular_arc(derived, u: sp.Symbol) -> SingularArc:
    """Return the singular arcs of a control, the other controls being constant.

    Parameters
    ----------
    derived : Conditions
        The conditions of a problem.
    u : sympy.Symbol
        A control in which H is linear.

    Returns
    -------
    SingularArc
        Order, singular control, surface and Kelley's sign.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x, u = sp.symbols("x u")
    >>> turnpike = Problem({x: u}, {u: (-1, 1)}, {x: 1}, {x: sp.Rational(1, 2)}, running=x**2, duration=2)
    >>> arc = turnpike.conditions().singular[u]
    >>> arc.order, arc.surface, arc.control, arc.kelley
    (1, (x,), 0, -2*lambda0)
    """
    derivatives, highest = raw_derivatives(derived, u, MAX_TERMS)
    if highest is None and len(sp.Add.make_args(derivatives[-1])) > MAX_TERMS:
        return SingularArc(
            u,
            None,
            derivatives[:-1],
            None,
            None,
            (),
            False,
            f"the derivatives of the switching function have more than {MAX_TERMS} terms before "
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
    order = len(derivatives) // 2
    highest = sp.expand(sp.simplify(highest), power_exp=False)
    a, b = highest.subs(u, 0), sp.diff(highest, u)
    eliminated = _eliminated(derivatives, derived, unknowns, surface)
    kelley = sp.factor(
        sp.trigsimp(_on(surface, (-1) ** order * b.subs(eliminated), derived.problem.state))
    )
    control = None
    if kelley != 0:
        control = _on(surface, sp.simplify((-a / b).subs(eliminated)), derived.problem.state)
    sign = (
        "zero, so that the control is not determined"
        if kelley == 0
        else "negative"
        if kelley.is_negative
        else "not positive"
        if kelley.is_nonpositive
        else "positive: no minimum with the control strictly between its bounds"
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
        f"order {order}; (-1)^q b = {kelley} is {sign}",
    )


def raw_derivatives(derived, u, max_terms=None):
    """Return dH/du with its derivatives that do not contain u, and the first that does, or None.

    A derivative of more than `max_terms` terms is the last, whether it contains u or not.
    """
    derivatives = [derived.switching[u]]
    for _ in range(2 * len(derived.costate)):
        derivative = sp.expand(derived.derivative(derivatives[-1]), power_exp=False)
        if max_terms and len(sp.Add.make_args(derivative)) > max_terms:
            return (*derivatives, derivative), None
        if len(derivatives) % 2 == 0 and not vanishes_identically(sp.diff(derivative, u)):
            return tuple(derivatives), derivative
        if derivative == 0:
            break
        # With several controls u may appear in an odd derivative, where (Goh's condition) its
        # factor vanishes.
        derivatives.append(derivative.subs(u, 0))
    return tuple(derivatives), None


def vanishes_identically(expression):
    """Check whether an expression is zero identically.

    Values decide that it is not, much faster than rules decide that it is.
    """
    point = {
        s: sp.Rational(2 * k + 3, 2 * k + 5)
        for k, s in enumerate(sorted(expression.free_symbols, key=str))
    }
    value = expression.evalf(50, subs=point)
    if value.is_number and value.is_finite and abs(value) > 1e-40:
        return False
    return sp.simplify(expression) == 0


def _surface(matrix, state):
    """Return where the linear equations for the multipliers have a non-zero solution.

    A tuple of expressions that vanish there, empty if this is everywhere, None if it is nowhere.
    """
    if matrix.rows < matrix.cols:
        return ()
    # A few minors are enough: their common factor is the surface.
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
    """Return the product of the numerator's distinct factors that contain the state; 0 for zero."""
    numerator = sp.numer(sp.together(expression))
    if sp.expand(numerator) == 0:
        return sp.Integer(0)
    bases = {
        f.as_base_exp()[0]
        for f in sp.Mul.make_args(sp.factor(numerator))
        if f.free_symbols & set(state)
    }
    # An exponential has no zeros, nor has a state that is positive by assumption.
    return sp.Mul(*(b for b in bases if not b.is_nonzero and not isinstance(b, sp.exp)))


def _eliminated(derivatives, derived, unknowns, surface):
    """Express the costates that the equations determine by the other ones."""
    matrix, costates = sp.Matrix(derivatives).jacobian(unknowns), {}
    matrix = matrix.applyfunc(lambda e: _on(surface, e, derived.problem.state))
    reduced, pivots = matrix.rref(simplify=True)
    # On a surface that cannot be substituted, the equations still seem to leave only zero: there
    # the others imply the last.
    redundant = not all(_is_explicit(equation, derived.problem.state) for equation in surface)
    while (
        redundant and pivots and len(pivots) == sum(any(matrix.col(j)) for j in range(matrix.cols))
    ):
        matrix = matrix[:-1, :]
        reduced, pivots = matrix.rref(simplify=True)
    for row, pivot in enumerate(pivots):
        # On the surface an equation for lambda_0 alone is satisfied.
        if unknowns[pivot] != derived.multiplier:
            costates[unknowns[pivot]] = -sum(
                (reduced[row, j] * unknowns[j] for j in range(len(unknowns)) if j != pivot),
                sp.Integer(0),
            )
    return costates


def _is_explicit(equation, state):
    """Check whether `_on` can use an equation of the surface."""
    return isinstance(equation, (sp.sin, sp.cos, sp.tan)) or any(
        equation.is_polynomial(y) and sp.degree(equation, y) == 1 for y in state
    )


def _on(surface, expression, state):
    """Return the shortest form of an expression on the surface.

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
