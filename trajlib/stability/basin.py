"""An estimate from inside of the domain of attraction, by a level set of a Lyapunov function
(worked example 2).

If V is positive definite, and on the bounded component of {V < c} around the origin V' <= 0 and the
set V' = 0 holds no whole trajectory but the origin, that component belongs to the domain of
attraction (Theorem 1.5). As c grows from zero the component changes smoothly until its boundary
meets an obstacle:

- a critical point of V (where it would join another component),
- another equilibrium,
- a curve on which V' changes its sign, or that consists of trajectories on which V' = 0,
- the boundary of a constraint;

on a curve it is met first in a point where grad V is normal to the curve (Lagrange). These points
are found exactly, with the parameters as symbols. Which of them is met first is a question of order
and connection: it is decided by descending from each along -grad V, for three sample values of the
parameters; if the samples disagree there is no single formula, and an error says so. Systems whose
obstacles are roots of long polynomials take some seconds.
"""

from dataclasses import dataclass
from itertools import combinations

import numpy as np
import sympy as sp

from trajlib._arguments.symbols import exact_decimals, read_expression, read_field
from trajlib._real_symbols import as_real, restore_names, vanishes
from trajlib.stability.inequalities import sign_of
from trajlib.stability.lyapunov import (
    barbashin_krasovskii,
    derivative_factors,
    is_positive_definite,
    lyapunov_derivative,
    separate_parts,
)
from trajlib.stability.real_solutions import solve_real
from trajlib.typesetting import escape_markdown


@dataclass(frozen=True)
class BasinEstimate:
    """The component of {V < level} around the origin lies in the domain of attraction.

    `level` is oo if the whole space does. `obstacles`: the points that the boundary meets at this
    level; `reason` says what they are.
    """

    V: sp.Expr
    state: tuple
    level: sp.Expr
    obstacles: tuple
    reason: str

    def plot(self, x_range, y_range, ax=None):
        """Hatch the estimate in the plane and draw the level curve; returns the Axes. Needs numbers
        for parameters."""
        from trajlib import plotting

        if len(self.state) != 2 or self.V.free_symbols - set(self.state):
            raise ValueError("plot: expected a planar system with numbers for all parameters")
        if self.level == sp.oo:
            return plotting.region(sp.true, self.state, x_range, y_range, ax=ax)
        ax = plotting.window(self.state, x_range, y_range, ax=ax)
        plotting.sublevel_component(self.V, self.state, self.level, ax)
        return plotting.level_curve(
            self.V, self.state, self.level, ax, label=f"$V = {sp.latex(_short(self.level))}$"
        )

    def _repr_markdown_(self):
        if self.level == sp.oo:
            return f"the whole space ({escape_markdown(self.reason)})"
        return f"$V = {sp.latex(self.V)} < {sp.latex(_short(self.level))}$ ({escape_markdown(self.reason)})"


def basin_estimate(V, field, state, constraint=None):
    """The largest level c for which Theorem 1.5 holds on the component of {V < c} around the
    origin.

    `V`: a Lyapunov function; `field`, `state`: the system x' = f(x) with f(0) = 0; symbols besides
    the state are parameters, whose assumptions (positive=True, negative=True) are needed wherever
    the answer depends on their signs. `constraint`: inequalities on the state that must hold inside
    as well. Returns `BasinEstimate`. Raises ValueError if V is not positive definite, if V' is not
    <= 0 near the origin, if V' vanishes on whole trajectories at any distance from the origin, or
    if no single formula holds for all values of the parameters. Source: Theorem 1.5 and worked
    example 2 of the problem book.

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
    to_real, back = as_real(V, *field, *state)
    V, field, real_state = (
        V.xreplace(to_real),
        [f.xreplace(to_real) for f in field],
        tuple(to_real.get(x, x) for x in state),
    )
    origin = dict.fromkeys(real_state, 0)
    if not all(vanishes(f.subs(origin)) for f in field):
        raise ValueError(
            "field: the origin is not an equilibrium; write the equations in deviations first"
        )
    definite = is_positive_definite(V, real_state)
    if definite.condition is not sp.true:
        raise ValueError(
            restore_names(f"V: it is not known to be positive definite ({definite.reason})", back)
        )
    rate = lyapunov_derivative(V, field, real_state)
    try:
        curves = [
            *_sign_changes(rate, real_state),
            *_trajectories(V, field, real_state),
            *_boundaries(constraint, real_state, to_real),
        ]
        obstacles = _obstacles(V, field, real_state, curves)
        level, met, reason = _first_level(V, obstacles, real_state)
    except ValueError as error:
        raise ValueError(restore_names(str(error), back)) from None
    return BasinEstimate(
        V.xreplace(back),
        state,
        level.xreplace(back),
        tuple(tuple(v.xreplace(back) for v in point) for point in met),
        restore_names(reason, back),
    )


def _sign_changes(rate, state):
    """Curves on which V' may change its sign; raises ValueError unless V' <= 0 near the origin."""
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
            near = {
                1: is_positive_definite(g, state).condition,
                -1: is_positive_definite(-g, state).condition,
            }
            factor_sign = next((s for s, condition in near.items() if condition is sp.true), None)
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
    """Invariant curves on which V' = 0; equilibria are obstacles anyway."""
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
    """The points that can stop the growth, as pairs (point, what it is)."""
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
    """The members of a periodic family that lie nearest to the origin."""
    for n in integers:
        if any(v.has(n) for v in point):
            return [
                member
                for k in (0, 1, -1, 2, -2)
                for member in _members(tuple(v.subs(n, k) for v in point), integers)
            ]
    return [point]


def _first_level(V, obstacles, state):
    """The level at which the component meets the first obstacle, the obstacles there, and the
    reason."""
    parameters = sorted(
        V.free_symbols.union(*(v.free_symbols for p, _ in obstacles for v in p)) - set(state),
        key=str,
    )
    levels = [_height(V.subs(dict(zip(state, p)), simultaneous=True)) for p, _ in obstacles]
    verdicts = set()
    for sample in _samples(parameters):
        met = _first_met(
            V.subs(sample),
            state,
            [_numbers(p, sample) for p, _ in obstacles],
            [float(level.subs(sample)) for level in levels],
        )
        verdicts.add(met)
    if len(verdicts) > 1:
        raise ValueError(
            "V: which obstacle comes first depends on the parameters; substitute numbers"
        )
    (met,) = verdicts
    level = levels[met[0]] if met else sp.oo
    doubts = {
        _bounded(V.subs(sample), state, level.subs(sample)) for sample in _samples(parameters)
    } - {""}
    if not met:
        if doubts:
            raise ValueError(
                "V: no obstacle is met, but V is not known to grow without bound in all directions"
            )
        return level, (), "V grows without bound and meets no obstacle: attraction from everywhere"
    reason = "; ".join(f"at {tuple(map(_short, obstacles[i][0]))}: {obstacles[i][1]}" for i in met)
    return level, tuple(obstacles[i][0] for i in met), reason + "".join(f"; {d}" for d in doubts)


def _short(value):
    """Roots of polynomials are shown as decimals."""
    return value.evalf(6) if value.has(sp.CRootOf) else value


def _height(level):
    return level if level.has(sp.CRootOf) else sp.factor(sp.simplify(level))


def _numbers(point, sample):
    return np.array([float(v.subs(sample)) for v in point])


def _samples(parameters):
    """Three sets of values that respect the assumptions on the parameters."""
    if not parameters:
        return [{}]
    values = [
        (
            sp.Rational(1),
            sp.Rational(3, 2),
            sp.Rational(2, 3),
            sp.Rational(5, 4),
            sp.Rational(4, 5),
        ),
        (
            sp.Rational(1, 3),
            sp.Rational(7, 3),
            sp.Rational(1, 2),
            sp.Rational(3),
            sp.Rational(9, 7),
        ),
        (
            sp.Rational(5, 2),
            sp.Rational(1, 5),
            sp.Rational(8, 3),
            sp.Rational(1, 4),
            sp.Rational(6, 5),
        ),
    ]
    return [
        {p: -row[i % 5] if p.is_negative else row[i % 5] for i, p in enumerate(parameters)}
        for row in values
    ]


def _first_met(V, state, points, levels):
    """Indices of the obstacles that the growing component meets first."""
    order = sorted((i for i in range(len(points)) if levels[i] > 1e-12), key=lambda i: levels[i])
    descend = _descent(V, state)
    for i in order:
        if descend(points[i]):
            return tuple(
                j
                for j in order
                if abs(levels[j] - levels[i]) <= 1e-9 * levels[i] and (j == i or descend(points[j]))
            )
    return ()


def _descent(V, state):
    """A test whether {V < V(p)} joins p to the origin: some descent from next to p must end
    there."""
    from scipy.integrate import solve_ivp

    value = sp.lambdify(state, V, "numpy")
    gradient = sp.lambdify(state, [sp.diff(V, x) for x in state], "numpy")
    directions = np.random.default_rng(0).normal(size=(24, len(state)))
    directions = np.vstack([np.eye(len(state)), -np.eye(len(state)), directions])

    def reaches_origin(point):
        size = np.linalg.norm(point)
        height = value(*point)
        for direction in directions:
            start = point + 1e-3 * size * direction / np.linalg.norm(direction)
            if value(*start) >= height:
                continue

            def down(_, x):
                return -np.asarray(gradient(*x), dtype=float) * size**2 / abs(height)

            def arrived(_, x):
                return np.linalg.norm(x) - 1e-2 * size

            def left(_, x):
                return np.linalg.norm(x) - 50 * size

            arrived.terminal = left.terminal = True
            # LSODA rests cheaply where the descent ends in another minimum.
            end = solve_ivp(
                down, (0, 1e5), start, "LSODA", events=(arrived, left), rtol=1e-6, atol=1e-9 * size
            ).t_events
            if end[0].size:
                return True
        return False

    return reaches_origin


def _bounded(V, state, level):
    """Empty if the component of {V < level} around the origin is known to be bounded, else a
    remark."""
    for part, variables in separate_parts(V, state):
        if _grows(part, variables):
            continue
        if len(variables) > 1 or level == sp.oo or not _walled(part, variables[0], float(level)):
            return "that the component is bounded was not shown"
    return ""


def _grows(part, variables):
    """Whether a part of V tends to +oo in all directions, by its terms of highest degree."""
    if not part.is_polynomial(*variables):
        return False
    poly = sp.Poly(part, *variables)
    degree = poly.total_degree()
    top = sum(
        c * sp.prod(x**k for x, k in zip(variables, m)) for m, c in poly.terms() if sum(m) == degree
    )
    return degree % 2 == 0 and is_positive_definite(top, variables).condition is sp.true


def _walled(part, x, level):
    """In a sum of separate parts: whether part(x) rises to the level on both sides, without falling
    below 0 before."""
    profile = sp.lambdify(x, part, "numpy")
    for side in (1, -1):
        steps = side * np.linspace(0, 100 * (1 + abs(level)), 400001)
        values = profile(steps) * np.ones_like(steps)
        # The level may be touched between two grid points.
        crossed = np.flatnonzero(values >= level * (1 - 1e-6))
        if not crossed.size or values[: crossed[0]].min() < -1e-12 * level:
            return False
    return True
