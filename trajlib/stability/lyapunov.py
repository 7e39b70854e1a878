"""Lyapunov functions: derivatives, definiteness, and the set of zero derivative.

Definitions 1.3, 1.4 and Theorem 1.5 (Barbashin-Krasovskii) of the problem book, for x' = g(x) with
g(0) = 0.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.symbols import exact_decimals, read_expression, read_field, read_symbols
from trajlib._real_symbols import as_real, restore_names, vanishes
from trajlib._typing import Expressions, Symbols
from trajlib.flows import lie_derivative
from trajlib.stability.inequalities import positive, sign_of, tidied
from trajlib.stability.real_solutions import solve_real
from trajlib.typesetting import escape_markdown


def lyapunov_derivative(V: sp.Expr, field: Expressions, state: Symbols) -> sp.Expr:
    """Return the derivative of V along the system, grad V . f.

    Parameters
    ----------
    V : sympy.Expr
        A function of the state.
    field : sequence of n sympy.Expr
        Right-hand sides f(x).
    state : sequence of n sympy.Symbol
        The state variables x.

    Returns
    -------
    sympy.Expr
        The derivative in its shorter form, expanded or factored.

    Notes
    -----
    Source: Definition 1.4 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> x1, x2, a, b = sp.symbols("x1 x2 a b")
    >>> lyapunov_derivative(x2**2/2 + x1**2/2 + b*x1**4/4, [x2, -a*x2 - x1 - b*x1**3], [x1, x2])
    -a*x2**2
    """
    V = exact_decimals(read_expression(V, "V"))
    field, state = read_field(field, state)
    rate = sp.expand(lie_derivative(V, dict(zip(state, map(exact_decimals, field)))))
    return min((rate, sp.factor(rate)), key=sp.count_ops)


@dataclass(frozen=True)
class Definiteness:
    """Whether a function is positive definite near the origin.

    In an `if` only a decided answer counts; anything else raises TypeError.

    Attributes
    ----------
    condition : sympy.Basic or None
        `sp.true`, `sp.false`, a condition on parameters, or None where it could not be decided.
    reason : str
        Why.
    """

    condition: sp.Basic | None
    reason: str

    @property
    def verdict(self) -> str:
        """Return the verdict in words."""
        if self.condition is None:
            return "not decided"
        if self.condition in (sp.true, sp.false):
            return "positive definite" if self.condition else "not positive definite"
        return "depends on parameters"

    def __bool__(self):
        if self.condition not in (sp.true, sp.false):
            raise TypeError(f"definiteness: {self.verdict}: {self.reason}")
        return bool(self.condition)

    def _repr_markdown_(self):
        if self.verdict == "depends on parameters":
            return f"positive definite if ${sp.latex(self.condition)}$"
        return f"{self.verdict}: {escape_markdown(self.reason)}"


def is_positive_definite(V: sp.Expr, state: Symbols) -> Definiteness:
    """Decide whether V is positive definite near the origin (in the whole space if V is a form).

    Parameters
    ----------
    V : sympy.Expr
        A function that is smooth at 0; symbols besides the state are parameters.
    state : sequence of sympy.Symbol
        Its variables.

    Returns
    -------
    Definiteness
        The verdict, perhaps with a condition on the parameters.

    Notes
    -----
    Variables that do not occur together in a term are judged separately: in one variable by the
    first derivative that does not vanish, in several by Sylvester's criterion on the second
    derivatives, in two by the real roots of the lowest form. Source: Definition 1.3 of the problem
    book.

    Examples
    --------
    >>> import sympy as sp
    >>> x1, x2, b = sp.symbols("x1 x2 b")
    >>> is_positive_definite(x2**2/2 + b*x1**2 + x1**3, [x1, x2]).condition
    b > 0
    >>> is_positive_definite(x1**2 + 3*x1*x2 + x2**2, [x1, x2]).verdict
    'not positive definite'
    """
    state = read_symbols(state, "state")
    V = exact_decimals(read_expression(V, "V"))
    to_real, from_real = as_real(V, *state)
    V, real_state = V.xreplace(to_real), [to_real.get(x, x) for x in state]
    at_zero = V.subs(dict.fromkeys(real_state, 0))
    if not vanishes(at_zero):
        return Definiteness(sp.false, f"V(0) = {at_zero.xreplace(from_real)} is not zero")
    missing = [x for x, real in zip(state, real_state) if not V.has(real)]
    if missing:
        return Definiteness(
            sp.false, f"V does not depend on {missing[0]}, so it vanishes along that axis"
        )
    conditions = []
    for part, variables in separate_parts(V, real_state):
        condition, reason = _definite_part(part, variables)
        if condition is None or condition is sp.false:
            return Definiteness(condition, restore_names(reason, from_real))
        conditions.append(condition)
    condition = tidied(sp.And(*conditions)).xreplace(from_real)
    return Definiteness(
        condition,
        "the lowest terms are positive definite"
        if condition is sp.true
        else f"the lowest terms are positive definite if {condition}",
    )


def separate_parts(V, state):
    """Split V - V(0) into a sum of parts without common variables, each zero at 0.

    Returns pairs (part, its variables).
    """
    groups = []
    for term in sp.Add.make_args(sp.expand(V)):
        terms, variables = [term], [x for x in state if term.has(x)]
        if not variables:
            continue
        for group in [g for g in groups if set(g[1]) & set(variables)]:
            groups.remove(group)
            terms, variables = (
                group[0] + terms,
                [x for x in state if x in set(group[1]) | set(variables)],
            )
        groups.append((terms, variables))
    parts = [(sp.Add(*terms), variables) for terms, variables in groups]
    return [(part - part.subs(dict.fromkeys(variables, 0)), variables) for part, variables in parts]


def _definite_part(part, variables):
    """Return (condition, reason) for one part of a sum; None means not decided."""
    if len(variables) == 1:
        return _definite_in_one(part, variables[0])
    origin = dict.fromkeys(variables, 0)
    if not all(vanishes(sp.diff(part, x).subs(origin)) for x in variables):
        return sp.false, "the linear terms do not vanish"
    hessian = sp.hessian(part, variables).subs(origin)
    minors = [hessian[:k, :k].det() for k in range(1, len(variables) + 1)]
    condition = sp.And(*(positive(m) for m in minors))
    if hessian.free_symbols or condition is sp.true:
        return condition, "the quadratic terms are not positive definite"
    if not hessian.is_positive_semidefinite:
        return sp.false, "the quadratic terms take negative values"
    if not part.is_polynomial(*variables):
        return None, "the quadratic terms are only semidefinite, and V is not a polynomial"
    poly = sp.Poly(part, *variables)
    lowest = min(sum(m) for m in poly.monoms())
    form = sum(
        c * sp.prod(x**k for x, k in zip(variables, m)) for m, c in poly.terms() if sum(m) == lowest
    )
    if lowest % 2:
        return sp.false, f"the terms of lowest degree {lowest} change sign"
    if lowest == 2:
        return (
            (sp.false, "the quadratic form vanishes along a line")
            if sp.expand(form - part) == 0
            else (None, "the quadratic terms are only semidefinite")
        )
    if len(variables) == 2 and not form.free_symbols - set(variables):
        x, y = variables
        profile = sp.Poly(form.subs(y, 1), x)
        if form.subs({x: 1, y: 0}) > 0 and profile.count_roots() == 0:
            return sp.true, ""
        if any(form.subs({x: sp.Rational(i, 4), y: j}) < 0 for i in range(-40, 41) for j in (0, 1)):
            return sp.false, f"the terms of lowest degree {lowest} take negative values"
    return None, f"the terms of lowest degree {lowest} were not decided"


def _definite_in_one(part, x):
    """Decide by the first derivative at 0 that does not vanish: of even order and positive."""

    def from_order(order):
        if order > 12:
            return None
        derivative = sp.diff(part, x, order).subs(x, 0)
        if derivative == 0:
            return from_order(order + 1)
        order_condition = positive(derivative) if order % 2 == 0 else sp.false
        vanishes = sp.Eq(derivative, 0)
        if order_condition is sp.true or vanishes is sp.false or sign_of(derivative):
            return order_condition
        higher_condition = from_order(order + 1)
        # Where a coefficient vanishes for some value of a parameter the next one decides.
        return (
            order_condition
            if higher_condition is None
            else sp.Or(order_condition, sp.And(vanishes, higher_condition))
        )

    condition = from_order(1)
    if condition is None:
        return None, f"no derivative in {x} up to order 12 differs from zero at 0"
    return condition, f"the first terms in {x} are not positive"


@dataclass(frozen=True)
class ZeroDerivativeSet:
    """The set M where the derivative of V vanishes, and the whole trajectories in it.

    Attributes
    ----------
    derivative : sympy.Expr
        V' along the system.
    zero_set : sympy.Basic
        M as a condition on the state.
    others : tuple
        The trajectories in M besides the origin, as pairs (trajectory, condition): an equilibrium
        (tuple) or an invariant curve (equation), and the condition on the parameters under which it
        is in M.
    only_origin : sympy.Basic or None
        `sp.true`, `sp.false` or a condition on the parameters: M holds no whole trajectory but the
        origin; None where that was not decided.
    reason : str
        The result in words.
    """

    derivative: sp.Expr
    zero_set: sp.Basic
    others: tuple[tuple[tuple | sp.Eq, sp.Basic], ...]
    only_origin: sp.Basic | None
    reason: str

    def _repr_markdown_(self):
        formulas = rf"\dot V = {sp.latex(self.derivative)},\quad M: {sp.latex(self.zero_set)}"
        return f"${formulas}$ ({escape_markdown(self.reason)})"


def barbashin_krasovskii(V: sp.Expr, field: Expressions, state: Symbols) -> ZeroDerivativeSet:
    """Return the set M of Theorem 1.5 where V' = 0, and the whole trajectories in it.

    Parameters
    ----------
    V : sympy.Expr
        A Lyapunov function.
    field : sequence of n sympy.Expr
        Right-hand sides f(x).
    state : sequence of n sympy.Symbol
        The state variables x.

    Returns
    -------
    ZeroDerivativeSet
        M, and whether it holds whole trajectories besides the origin.

    Notes
    -----
    A trajectory that stays in {g = 0} satisfies g = 0, g' = 0, g'' = 0, ... with derivatives taken
    along the system; the common zeros of these are found exactly. Parameters that are factors of V'
    are taken to be nonzero. Source: Theorem 1.5 of the problem book (Barbashin-Krasovskii,
    LaSalle).

    Examples
    --------
    >>> import sympy as sp
    >>> x1, x2, a, b = sp.symbols("x1 x2 a b")
    >>> M = barbashin_krasovskii(x2**2/2 + x1**2/2 + b*x1**4/4, [x2, -a*x2 - x1 - b*x1**3], [x1, x2])
    >>> M.zero_set, M.only_origin
    (Eq(x2, 0), b >= 0)
    """
    rate = lyapunov_derivative(V, field, state)
    field, state = read_field(field, state)
    field = [exact_decimals(f) for f in field]
    to_real, from_real = as_real(rate, *field, *state)
    real_field, real_state = (
        [f.xreplace(to_real) for f in field],
        [to_real.get(x, x) for x in state],
    )
    if rate == 0:
        return ZeroDerivativeSet(
            rate, sp.true, (), sp.false, "V' vanishes identically: every trajectory lies in M"
        )

    equations, pairs, doubts, assumed = [], [], [], set()
    for g, _, kind in derivative_factors(rate.xreplace(to_real), real_state):
        if kind == "parameter":
            assumed.add(g)
            continue
        equations.append(
            sp.And(*(sp.Eq(x, 0) for x in real_state)) if kind == "definite" else sp.Eq(g, 0)
        )
        if kind == "definite":
            continue
        trajectories, doubt = _trajectories_within(g, real_field, real_state)
        pairs += trajectories
        doubts += [doubt] if doubt else []
    other_trajectories = tuple(
        (
            trajectory.xreplace(from_real)
            if isinstance(trajectory, sp.Basic)
            else tuple(v.xreplace(from_real) for v in trajectory),
            condition.xreplace(from_real),
        )
        for trajectory, condition in dict(pairs).items()
    )
    zero_set = sp.Or(*equations).xreplace(from_real)
    present = sp.Or(*(condition for _, condition in other_trajectories))
    only_origin = sp.false if present is sp.true else None if doubts else sp.Not(present)
    reason = "; ".join(doubts) or (
        "M holds no whole trajectory but the origin"
        if present is sp.false
        else f"M also holds {', '.join(str(trajectory) for trajectory, _ in other_trajectories)}"
    )
    if assumed:
        reason += ", for " + ", ".join(sorted(f"{g.xreplace(from_real)} != 0" for g in assumed))
    return ZeroDerivativeSet(rate, zero_set, other_trajectories, only_origin, reason)


def derivative_factors(rate, state):
    """Yield the factors of V' as triples (g, multiplicity, kind).

    Kinds: "parameter" (no state variable in it, sign not known), "definite" (a form that vanishes
    at the origin alone) and "curve". Factors of known sign are left out.
    """
    for g, multiplicity in sp.factor_list(sp.numer(sp.together(rate)))[1]:
        if sign_of(g):
            continue
        if not g.free_symbols & set(state):
            yield g, multiplicity, "parameter"
        elif _is_definite_form(g, state) or _is_definite_form(-g, state):
            yield g, multiplicity, "definite"
        else:
            yield g, multiplicity, "curve"


def _is_definite_form(g, state):
    return (
        g.is_polynomial(*state)
        and sp.Poly(g, *state).is_homogeneous
        and is_positive_definite(g, state).condition is sp.true
    )


def _trajectories_within(g, field, state):
    """Return the trajectories in {g = 0} as pairs (trajectory, condition), and a doubt or None."""
    rate = sp.expand(lie_derivative(g, dict(zip(state, field))))
    if g.is_polynomial(*state) and rate.is_polynomial(*state) and sp.rem(rate, g, *state) == 0:
        return [(sp.Eq(g, 0), sp.true)], None
    system = [g]
    for _ in state:
        system.append(sp.expand(lie_derivative(system[-1], dict(zip(state, field)))))
        solutions = solve_real(system, state)
        if solutions.unsolved:
            return [], f"the trajectories in {g} = 0 were not decided"
        if all(len(values) == len(state) for values, _ in solutions.branches):
            break
    trajectories = []
    for values, condition in solutions.branches:
        if len(values) < len(state):
            return trajectories, f"the trajectories in {g} = 0 were not decided"
        point = tuple(values[x] for x in state)
        # Isolated points that stay in the set must be at rest.
        at_rest = all(vanishes(f.subs(values)) for f in field)
        if at_rest and any(v != 0 for v in point):
            trajectories.append((point, condition))
    return trajectories, None
