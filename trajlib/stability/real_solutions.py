"""All real solutions of a system of equations, exactly, with conditions on the parameters.

The system is solved branch by branch: an equation is split into its factors; an equation in one
unknown is solved, another unknown is eliminated where an equation gives it; polynomial systems go
through a Groebner basis. Equations that cannot be solved in closed form are always reported. All
symbols must be real (see `trajlib._real_symbols`). Parameters are generic: a parameter that is a
factor of an equation, or of the highest power of an unknown, is taken to be nonzero, and this is
reported.
"""

from dataclasses import dataclass, field

import sympy as sp

from trajlib._real_symbols import vanishes
from trajlib.stability.inequalities import nonnegative, nonzero, positive, tidied


class Unsolved(Exception):
    """Signals that no closed form is known; the arguments are the equation and its unknown."""


@dataclass
class RealSolutions:
    """`branches`: pairs (unknown -> value, condition); unknowns without a value are free.

    `unsolved`: pairs (equation, unknown) that were given up; `nonzero`: expressions in the
    parameters taken to be nonzero; `generic`: whether further special values of the parameters may
    be excepted; `integers`: the symbols n of periodic families; `taken`: names these must not have.
    """

    taken: set
    branches: list = field(default_factory=list)
    unsolved: list = field(default_factory=list)
    nonzero: set = field(default_factory=set)
    generic: bool = False
    integers: list = field(default_factory=list)

    def fresh_integer(self):
        """Return a new integer n for a periodic family."""
        names = (f"{letter}{index}" for index in ["", *range(1, 100)] for letter in "nmj")
        name = next(name for name in names if name not in self.taken)
        self.taken.add(name)
        self.integers.append(sp.Symbol(name, integer=True))
        return self.integers[-1]

    def suppose_nonzero(self, expressions):
        """Record that expressions in the parameters are taken to be nonzero."""
        self.nonzero |= {
            -e if e.could_extract_minus_sign() else e for e in expressions if not e.is_nonzero
        }


def solve_real(equations, unknowns):
    """Return all real solutions of `equations` = 0 in `unknowns` as `RealSolutions`."""
    result = RealSolutions(taken={s.name for e in equations for s in e.free_symbols})
    _solve(list(equations), tuple(unknowns), {}, (), result)
    defined = tuple(r for e in equations for r in definedness(e))
    branches = {}
    for values, requirements in result.branches:
        values = {x: _substituted(v, values) for x, v in values.items()}
        residuals = [e.subs(values) for e in equations]
        if any(v.has(sp.I) for v in values.values()) or not all(
            e.free_symbols or vanishes(e) for e in residuals
        ):
            continue
        condition = tidied(
            sp.And(*(r.reduced(values) for r in (*requirements, *defined)), *_assumed(values))
        )
        if condition is not sp.false:
            branches.setdefault(
                tuple(sorted(values.items(), key=lambda kv: kv[0].name)), (values, condition)
            )
    result.branches = list(branches.values())
    return result


def _substituted(value, values):
    """Insert the values found later into those found earlier."""
    while value.free_symbols & set(values):
        value = value.subs(values)
    return sp.expand(value) if value.is_polynomial() else value


def _assumed(values):
    """Yield conditions for unknowns declared positive, negative or nonnegative."""
    for unknown, value in values.items():
        if unknown.is_positive:
            yield positive(value)
        elif unknown.is_negative:
            yield positive(-value)
        elif unknown.is_nonnegative:
            yield nonnegative(value)


@dataclass(frozen=True)
class Requirement:
    """A requirement of a formula: expression > 0 (kind ">"), >= 0 (">=") or != 0 ("!=")."""

    expression: sp.Expr
    kind: str

    def reduced(self, values):
        """Return the requirement for given values of the unknowns, as a reduced condition."""
        value = self.expression.subs(values)
        if value.has(sp.nan, sp.zoo, sp.oo):
            return sp.false
        if self.kind == ">":
            return positive(value)
        if self.kind == ">=":
            return nonnegative(value)
        return nonzero(value)


def definedness(expression):
    """Yield what a formula needs to be defined: logarithms, even roots, denominators, arcs."""
    for part in sp.preorder_traversal(expression):
        if isinstance(part, sp.log):
            yield Requirement(part.args[0], ">")
        elif isinstance(part, sp.Pow) and part.exp.is_number:
            even_root = part.exp.is_Rational and part.exp.q % 2 == 0
            if even_root:
                yield Requirement(part.base, ">" if part.exp < 0 else ">=")
            elif part.exp.is_negative:
                yield Requirement(part.base, "!=")
        elif isinstance(part, (sp.asin, sp.acos)):
            yield Requirement(1 - part.args[0] ** 2, ">=")


def _solve(equations, unknowns, values, requirements, result):
    """Solve the rest of the system on one branch and append the solutions to `result`."""
    remaining = []
    for equation in equations:
        numerator = sp.numer(sp.together(equation.subs(values)))
        if sp.expand(numerator) == 0:
            continue
        remaining.append(numerator)
    open_unknowns = [x for x in unknowns if x not in values]
    if not remaining:
        result.branches.append((values, requirements))
        return

    # Without unknowns an equation is a condition on the parameters.
    for equation in remaining:
        if not equation.free_symbols & set(open_unknowns):
            if vanishes(equation):
                return _solve(
                    [e for e in remaining if e is not equation],
                    unknowns,
                    values,
                    requirements,
                    result,
                )
            result.suppose_nonzero([equation] if equation.free_symbols else [])
            return None

    # A product vanishes with one of its factors.
    for index, equation in enumerate(remaining):
        factors = _factors(equation, open_unknowns, result)
        if len(factors) > 1 or factors[0] != equation:
            other_equations = remaining[:index] + remaining[index + 1 :]
            for factor in factors:
                _solve([factor, *other_equations], unknowns, values, requirements, result)
            return None

    try:
        _eliminate(remaining, open_unknowns, unknowns, values, requirements, result)
    except Unsolved as problem:
        result.unsolved.append(problem.args)
    return None


def _factors(equation, unknowns, result):
    _, factors = sp.factor_list(_one_logarithm(equation))
    with_unknowns = [f for f, _ in factors if f.free_symbols & set(unknowns)]
    result.suppose_nonzero(f for f, _ in factors if f.free_symbols and f not in with_unknowns)
    return with_unknowns


def _one_logarithm(equation):
    return sp.logcombine(equation, force=True) if len(equation.atoms(sp.log)) > 1 else equation


def _eliminate(remaining, open_unknowns, unknowns, values, requirements, result):
    """Choose the equation and unknown that are cheapest to solve and go on with every root."""
    choices = sorted(
        (
            (_cost(e, x, open_unknowns), i, j)
            for i, e in enumerate(remaining)
            for j, x in enumerate(open_unknowns)
            if x in e.free_symbols
        )
    )
    cost, i, j = choices[0]
    if (
        cost[0] > 1
        and all(e.is_polynomial(*open_unknowns) for e in remaining)
        and len(remaining) > 1
    ):
        basis = list(sp.groebner(remaining, *open_unknowns, order="lex").exprs)
        result.generic |= any(e.free_symbols - set(open_unknowns) for e in remaining)
        if basis == [1]:
            return
        if set(map(sp.expand, basis)) != set(map(sp.expand, remaining)):
            _solve(basis, unknowns, values, requirements, result)
            return
    problem = None
    for _, i, j in choices:
        unknown = open_unknowns[j]
        try:
            roots = real_roots(remaining[i], unknown, result)
            break
        except Unsolved as error:
            problem = problem or error
    else:
        raise problem
    other_equations = remaining[:i] + remaining[i + 1 :]
    for root, needed in roots:
        narrowed = {x: v.subs(unknown, root) for x, v in values.items()} | {unknown: root}
        if all(r.reduced(narrowed) is not sp.false for r in needed):
            _solve(other_equations, unknowns, narrowed, requirements + needed, result)


def _cost(equation, unknown, unknowns):
    """Return a sort key: linear with known coefficient first, then one unknown, then the rest."""
    other_unknowns = equation.free_symbols & set(unknowns) - {unknown}
    if equation.is_polynomial(unknown):
        degree = sp.degree(equation, unknown)
        slope = sp.LC(equation, unknown)
        if degree == 1 and not slope.free_symbols & set(unknowns):
            return (0, len(other_unknowns), equation.count_ops())
        return (1 if not other_unknowns else 2, degree, equation.count_ops())
    return (1 if not other_unknowns else 2, 10, equation.count_ops())


def real_roots(equation, x, result):
    """Return real roots of equation = 0 in x: pairs (value, requirements); may raise `Unsolved`."""
    equation = sp.numer(sp.together(equation))
    roots = {}
    for factor, _ in sp.factor_list(_one_logarithm(equation))[1]:
        if x in factor.free_symbols:
            for value, needed in _roots_of_factor(factor, x, result):
                roots.setdefault(value, needed)
    return list(roots.items())


def _roots_of_factor(factor, x, result):
    if factor.is_polynomial(x):
        result.suppose_nonzero(f for f, _ in sp.factor_list(sp.LC(factor, x))[1])
        return _polynomial_roots(sp.Poly(factor, x), factor)
    generators = _generators(factor, x)
    if len(generators) == 1:
        (g,) = generators
        z = sp.Dummy("z", real=True)
        inner = factor.subs(g, z)
        if x not in inner.free_symbols:
            return [
                (root, needed + inverse_needed + still_more)
                for value, needed in real_roots(inner, z, result)
                for argument, target, inverse_needed in _inverted(g, value, result)
                for root, still_more in real_roots(argument - target, x, result)
            ]
    if all(isinstance(g, (sp.sin, sp.cos)) for g in generators):
        return _trigonometric_roots(factor, x, generators, result)
    raise Unsolved(factor, x)


def _generators(factor, x):
    """Return the functions of x in which the equation is a polynomial."""
    try:
        return [g for g in sp.Poly(factor).gens if g.has(x)]
    except sp.PolynomialError:
        raise Unsolved(factor, x) from None


def _polynomial_roots(poly, shown):
    x = poly.gen
    if poly.domain.is_ZZ or poly.domain.is_QQ:
        return [(root, ()) for root in dict.fromkeys(poly.real_roots())]
    step = sp.gcd_list([m for (m,), _ in poly.terms()])
    if step > 1:
        z = sp.Dummy("z", real=True)
        roots = []
        for value, needed in _polynomial_roots(
            sp.Poly({(m // step,): c for (m,), c in poly.terms()}, z), shown
        ):
            if step % 2:
                roots.append((sp.real_root(value, step), needed))
            else:
                root = sp.root(_short(value), step)
                roots += [
                    (r, (*needed, Requirement(value, ">="))) for r in dict.fromkeys((root, -root))
                ]
        return roots
    if poly.degree() == 1:
        slope, constant = poly.all_coeffs()
        return [(_short(-constant / slope), ())]
    if poly.degree() == 2:
        a, b, c = poly.all_coeffs()
        discriminant = sp.factor(b**2 - 4 * a * c)
        return [
            (
                _short((-b + sign * sp.sqrt(discriminant)) / (2 * a)),
                (Requirement(discriminant, ">="),),
            )
            for sign in (-1, 1)
        ]
    raise Unsolved(shown, x)


def _short(value):
    return min((value, sp.factor(value)), key=sp.count_ops)


def _inverted(g, value, result):
    """Solve g = h(u) = value for u: triples (u, value of u, requirements)."""
    u = g.args[0]
    if isinstance(g, sp.exp):
        return [(u, sp.log(value), (Requirement(value, ">"),))]
    if isinstance(g, sp.log):
        return [(u, sp.exp(value), ())]
    if isinstance(g, sp.Pow) and g.exp.is_Rational and g.exp.p == 1:
        return [(u, value**g.exp.q, (Requirement(value, ">="),) if g.exp.q % 2 == 0 else ())]
    if isinstance(g, (sp.sin, sp.cos, sp.tan)):
        needed = ()
        if isinstance(g, sp.tan):
            angles = (sp.atan(value), sp.atan(value) + sp.pi)
        else:
            needed = (Requirement(1 - value**2, ">="),)
            angles = (
                (sp.asin(value), sp.pi - sp.asin(value))
                if isinstance(g, sp.sin)
                else (sp.acos(value), -sp.acos(value))
            )
        turns = 2 * sp.pi * result.fresh_integer()
        # -pi and pi are the same angle.
        angles = dict.fromkeys(sp.pi if angle == -sp.pi else angle for angle in angles)
        return [(u, angle + turns, needed) for angle in angles]
    raise Unsolved(g - value, next(iter(u.free_symbols)))


def _trigonometric_roots(factor, x, generators, result):
    """Solve polynomials in sin u and cos u of one angle u, by the tangent of u or u/2."""
    arguments = {g.args[0] for g in generators}
    if len(arguments) > 1:
        expanded = sp.expand_trig(factor)
        if {g.args[0] for g in _generators(expanded, x)} == arguments:
            raise Unsolved(factor, x)
        return real_roots(expanded, x, result)
    (u,) = arguments
    s, c, t = (sp.Dummy(name, real=True) for name in "sct")
    inner = factor.subs({sp.sin(u): s, sp.cos(u): c})
    if sp.Poly(inner, s, c).is_homogeneous:
        angles = [
            (sp.atan(value) + half, needed)
            for half in (0, sp.pi)
            for value, needed in real_roots(inner.subs({s: t, c: 1}), t, result)
        ]
        upright, special = inner.subs({s: 1, c: 0}), (sp.pi / 2, -sp.pi / 2)
    else:
        half_angle = inner.subs({s: 2 * t / (1 + t**2), c: (1 - t**2) / (1 + t**2)})
        angles = [
            (2 * sp.atan(value), needed) for value, needed in real_roots(half_angle, t, result)
        ]
        upright, special = inner.subs({s: 0, c: -1}), (sp.pi,)
    if upright == 0:
        angles += [(angle, ()) for angle in special]
    turns = 2 * sp.pi * result.fresh_integer()
    return [
        (root, needed + root_needed)
        for angle, needed in angles
        for root, root_needed in real_roots(u - angle - turns, x, result)
    ]
