"""An inner estimate of the domain of attraction by a level set of a Lyapunov function.

If V is positive definite, and on the bounded component of {V < c} around the origin V' <= 0 and the
set V' = 0 holds no whole trajectory but the origin, that component belongs to the domain of
attraction (Theorem 1.5; worked example 2). As c grows from zero the component changes smoothly
until its boundary meets an obstacle:

- a critical point of V (where it would join another component),
- another equilibrium,
- a curve on which V' changes its sign, or that consists of trajectories on which V' = 0,
- the boundary of a constraint;

on a curve it is met first in a point where grad V is normal to the curve (Lagrange). These points
are found exactly, with the parameters as symbols. Which of them is met first is decided in
`first_obstacle`, for three sample values of the parameters; if the samples disagree there is no
single formula, and an error states that. Systems whose obstacles are roots of long polynomials take
some seconds.
"""

from dataclasses import dataclass
from itertools import combinations
from typing import Any

import sympy as sp

from trajlib import plotting
from trajlib._arguments.symbols import exact_decimals, read_expression, read_field
from trajlib._real_symbols import as_real, restore_names, vanishes
from trajlib._typing import Expressions, Symbols
from trajlib.stability.first_obstacle import first_level, short
from trajlib.stability.inequalities import sign_of
from trajlib.stability.lyapunov import (
    barbashin_krasovskii,
    derivative_factors,
    is_positive_definite,
    lyapunov_derivative,
)
from trajlib.stability.real_solutions import solve_real
from trajlib.typesetting import escape_markdown


@dataclass(frozen=True)
class BasinEstimate:
    """An estimate: the component of {V < level} around 0 is in the domain of attraction.

    Attributes
    ----------
    V : sympy.Expr
        The Lyapunov function.
    state : tuple of sympy.Symbol
        The state variables.
    level : sympy.Expr
        The level; oo if the whole space is attracted.
    obstacles : tuple of tuple
        The points that the boundary meets at this level.
    reason : str
        The kind of these points.
    """

    V: sp.Expr
    state: tuple[sp.Symbol, ...]
    level: sp.Expr
    obstacles: tuple[tuple[sp.Expr, ...], ...]
    reason: str

    def plot(
        self, x_range: tuple[float, float], y_range: tuple[float, float], ax: Any = None
    ) -> Any:
        """Hatch the estimate in the plane and draw the level curve.

        Parameters
        ----------
        x_range, y_range : tuple of float
            (low, high) of each state variable.
        ax : matplotlib.axes.Axes, optional
            The axes to draw on; new ones by default.

        Returns
        -------
        matplotlib.axes.Axes
            The axes.

        Raises
        ------
        ValueError
            If the system is not planar, or if a parameter has no number.
        """
        if len(self.state) != 2 or self.V.free_symbols - set(self.state):
            raise ValueError("plot: expected a planar system with numbers for all parameters")
        if self.level == sp.oo:
            return plotting.region(sp.true, self.state, x_range, y_range, ax=ax)
        ax = plotting.window(self.state, x_range, y_range, ax=ax)
        plotting.sublevel_component(self.V, self.state, self.level, ax)
        return plotting.level_curve(
            self.V, self.state, self.level, ax, label=f"$V = {sp.latex(short(self.level))}$"
        )

    def _repr_markdown_(self):
        if self.level == sp.oo:
            return f"the whole space ({escape_markdown(self.reason)})"
        return f"$V = {sp.latex(self.V)} < {sp.latex(short(self.level))}$ ({escape_markdown(self.reason)})"


def basin_estimate(
    V: sp.Expr, field: Expressions, state: Symbols, constraint: sp.Basic | None = None
) -> BasinEstimate:
    """Return the largest level of V whose component around 0 is attracted by Theorem 1.5.

    Parameters
    ----------
    V : sympy.Expr
        A Lyapunov function. Symbols besides the state are parameters, whose assumptions
        (positive=True, negative=True) are needed wherever the answer depends on their signs.
    field : sequence of n sympy.Expr
        Right-hand sides f(x), with f(0) = 0.
    state : sequence of n sympy.Symbol
        The state variables x.
    constraint : sympy.Basic, optional
        Inequalities on the state, joined by And, that must hold inside as well.

    Returns
    -------
    BasinEstimate
        The level and the obstacles at it.

    Raises
    ------
    ValueError
        If V is not positive definite, if V' is not <= 0 near the origin, if V' vanishes on whole
        trajectories at any distance from the origin, or if no single formula holds for all values
        of the parameters.

    Notes
    -----
    Source: Theorem 1.5 and worked example 2 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> y1, y2 = sp.symbols("y1 y2")
    >>> a, b = sp.symbols("a b", positive=True)
    >>> V = y2**2/2 + b*y1**2 + y1**3
    >>> basin_estimate(V, [y2, -2*b*y1 - a*y2 - 3*y1**2], [y1, y2]).level
    4*b**3/27
    """
    field, state = read_field(field, state)
    V = exact_decimals(read_expression(V, "V"))
    field = [exact_decimals(f) for f in field]
    to_real, from_real = as_real(V, *field, *state)
    V, field, real_state = (
        V.xreplace(to_real),
        [f.xreplace(to_real) for f in field],
        tuple(to_real.get(x, x) for x in state),
    )
    origin = dict.fromkeys(real_state, 0)
    if not all(vanishes(f.subs(origin)) for f in field):
        raise ValueError(
            "field: the origin is not an equilibrium; write the deviation equations first"
        )
    definite = is_positive_definite(V, real_state)
    if definite.condition is not sp.true:
        raise ValueError(
            restore_names(
                f"V: it is not known to be positive definite ({definite.reason})", from_real
            )
        )
    rate = lyapunov_derivative(V, field, real_state)
    try:
        curves = [
            *_sign_changes(rate, real_state),
            *_trajectories(V, field, real_state),
            *_boundaries(constraint, real_state, to_real),
        ]
        obstacles = _obstacles(V, field, real_state, curves)
        level, met_points, reason = first_level(V, obstacles, real_state)
    except ValueError as error:
        raise ValueError(restore_names(str(error), from_real)) from None
    return BasinEstimate(
        V.xreplace(from_real),
        state,
        level.xreplace(from_real),
        tuple(tuple(v.xreplace(from_real) for v in point) for point in met_points),
        restore_names(reason, from_real),
    )


def _sign_changes(rate, state):
    """Yield curves on which V' may change sign; ValueError unless V' <= 0 near the origin."""
    if rate == 0:
        raise ValueError(
            "V: its derivative vanishes identically, so the origin is stable but nothing is "
            "attracted"
        )
    origin = dict.fromkeys(state, 0)
    sign = sp.Mul(*[sign_of(f) ** m for f, m in _known_factors(rate)])
    for g, multiplicity, kind in derivative_factors(rate, state):
        if multiplicity % 2 == 0:
            continue
        if kind == "parameter":
            raise ValueError(
                f"V: the sign of its derivative {rate} depends on that of {g}; declare its symbols "
                "positive or negative"
            )
        value = g.subs(origin)
        if value == 0:
            conditions = {
                1: is_positive_definite(g, state).condition,
                -1: is_positive_definite(-g, state).condition,
            }
            factor_sign = next(
                (s for s, condition in conditions.items() if condition is sp.true), None
            )
        else:
            factor_sign = sign_of(value)
        if factor_sign is None:
            raise ValueError(
                f"V: its derivative {rate} changes sign near the origin, or is not known to keep it"
            )
        sign *= factor_sign
        if kind == "curve":
            yield g, f"V' changes its sign on {g} = 0"
    if sign > 0:
        raise ValueError(
            f"V: its derivative {rate} is positive near the origin, so it proves nothing about "
            "attraction"
        )


def _known_factors(rate):
    numerator, denominator = sp.fraction(sp.together(rate))
    for part in (numerator, denominator):
        content, factors = sp.factor_list(part)
        yield content, 1
        yield from ((f, m) for f, m in factors if sign_of(f))


def _trajectories(V, field, state):
    """Yield invariant curves on which V' = 0; equilibria are obstacles anyway."""
    M = barbashin_krasovskii(V, field, state)
    if M.only_origin is None:
        raise ValueError(f"V: {M.reason}")
    for trajectory, _condition in M.others:
        if isinstance(trajectory, sp.Basic) and not isinstance(trajectory, sp.Tuple):
            if trajectory.lhs.subs(dict.fromkeys(state, 0)) == 0:
                raise ValueError(
                    f"V: its derivative vanishes on whole trajectories of {trajectory} next to the origin"
                )
            yield (
                trajectory.lhs - trajectory.rhs,
                f"{trajectory} consists of trajectories with V' = 0",
            )


def _boundaries(constraint, state, to_real):
    if constraint is None:
        return
    for relation in sp.And.make_args(sp.sympify(constraint)):
        if not isinstance(relation, (sp.Gt, sp.Ge, sp.Lt, sp.Le)):
            raise ValueError(f"constraint: expected inequalities joined by And, got {constraint}")
        inside = (relation.gts - relation.lts).xreplace(to_real)
        if sign_of(inside.subs(dict.fromkeys(state, 0))) != 1:
            raise ValueError(f"constraint: the origin does not satisfy {relation}")
        yield inside, f"the boundary of the constraint {relation}"


def _obstacles(V, field, state, curves):
    """Return the points that can stop the growth, as pairs (point, kind)."""
    gradient = [sp.diff(V, x) for x in state]
    systems = [(list(field), "another equilibrium"), (gradient, "a critical point of V")]
    for g, kind in curves:
        normal = [sp.diff(g, x) for x in state]
        parallel = [
            gradient[i] * normal[j] - gradient[j] * normal[i]
            for i, j in combinations(range(len(state)), 2)
        ]
        systems.append(([g, *parallel], kind))
    obstacles = {}
    for system, kind in systems:
        solutions = solve_real(system, state)
        if solutions.unsolved:
            raise ValueError(
                f"V: not all obstacles could be found exactly ({kind}); substitute numbers"
            )
        for values, condition in solutions.branches:
            free = dict.fromkeys((x for x in state if x not in values), sp.Integer(0))
            if not all(vanishes(sp.diff(V.subs(values), x)) for x in free):
                raise ValueError(
                    f"V: {kind} comes in whole lines {values}, on which V is not constant"
                )
            # A whole curve with one value of V, such as a circle, is represented by its point on an
            # axis.
            values, condition = (
                {x: v.subs(free) for x, v in values.items()} | free,
                condition.subs(free),
            )
            if condition is sp.false:
                continue
            if condition is not sp.true:
                raise ValueError(
                    f"V: whether {kind} is there depends on {condition}; declare the signs of the "
                    "parameters (positive=True, negative=True) or substitute numbers"
                )
            for point in _members(tuple(values[x] for x in state), solutions.integers):
                if any(v != 0 for v in point):
                    obstacles.setdefault(point, kind)
    return list(obstacles.items())


def _members(point, integers):
    """Return the members of a periodic family that lie nearest to the origin."""
    for n in integers:
        if any(v.has(n) for v in point):
            return [
                member
                for k in (0, 1, -1, 2, -2)
                for member in _members(tuple(v.subs(n, k) for v in point), integers)
            ]
    return [point]
