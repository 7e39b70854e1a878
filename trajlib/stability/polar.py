"""Planar systems in polar coordinates and their limit cycles: problems 1.12 and 1.13.

With x1 = r cos phi, x2 = r sin phi the system x' = f(x) turns into r' = (x1 f1 + x2 f2)/r, phi' =
(x1 f2 - x2 f1)/r^2. If r' depends on r alone, the circles on which it vanishes are the closed
trajectories, and its sign on both sides determines their stability.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.symbols import exact_decimals, read_expression, read_field, read_symbols
from trajlib._real_symbols import as_real, restore_names
from trajlib._typing import Expressions, ExprLike, Symbols
from trajlib.stability.inequalities import sign_factors
from trajlib.stability.real_solutions import solve_real
from trajlib.stability.strict_inequalities import TooLarge, solution_point


def polar_form(
    field: Expressions, state: Symbols, r: sp.Symbol, phi: sp.Symbol
) -> tuple[sp.Expr, sp.Expr]:
    """Return the right-hand sides (r', phi') of a planar system in polar coordinates.

    Parameters
    ----------
    field : sequence of 2 sympy.Expr
        Right-hand sides f(x).
    state : sequence of 2 sympy.Symbol
        (x1, x2) with x1 = r cos phi, x2 = r sin phi.
    r, phi : sympy.Symbol
        The polar coordinates; phi is the two-argument angle atan2(x2, x1).

    Returns
    -------
    tuple of sympy.Expr
        r' and phi'.

    Raises
    ------
    ValueError
        If the system is not planar or contains `r` or `phi`.

    Notes
    -----
    Source: problem 1.13 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> x1, x2, r, phi = sp.symbols("x1 x2 r phi")
    >>> R = x1**2 + x2**2 - 1
    >>> polar_form([x2 - x1*R, -x1 - x2*R], [x1, x2], r, phi)
    (-r**3 + r, -1)
    """
    field, state = read_field(field, state)
    if len(state) != 2:
        raise ValueError(f"state: expected a planar system, got {len(state)} variables")
    r, phi = read_symbols((r, phi), "r, phi")
    if {r, phi} & set().union(set(state), *(f.free_symbols for f in field)):
        raise ValueError(f"r, phi: {r} and {phi} must not stand in the system itself")
    radius, angle = sp.Dummy("r", positive=True), sp.Dummy("phi", real=True)
    x1, x2 = radius * sp.cos(angle), radius * sp.sin(angle)
    f1, f2 = (exact_decimals(f).subs(dict(zip(state, (x1, x2))), simultaneous=True) for f in field)
    rates = (x1 * f1 + x2 * f2) / radius, (x1 * f2 - x2 * f1) / radius**2
    back = {radius: r, angle: phi}
    return tuple(_simplified(rate, angle).xreplace(back) for rate in rates)


def _simplified(rate, angle):
    """Expand, with cos^2 = 1 - sin^2 where that shortens: a normal form of polynomials."""
    rate = sp.expand(rate)
    s, c = sp.symbols("s c")
    inner = rate.xreplace({sp.sin(angle): s, sp.cos(angle): c})
    normal = []
    if inner.is_polynomial(s, c):
        remainder = sp.expand(sp.rem(inner, s**2 + c**2 - 1, c, s)).xreplace(
            {s: sp.sin(angle), c: sp.cos(angle)}
        )
        if not remainder.has(angle):
            return remainder  # no form of it is shorter, and trigsimp takes a hundred times as long
        normal = [remainder]
    return min([rate, sp.expand(sp.trigsimp(rate)), *normal], key=sp.count_ops)


@dataclass(frozen=True)
class LimitCycle:
    """A circular limit cycle.

    Attributes
    ----------
    radius : sympy.Expr
        Its radius.
    period : sympy.Expr or None
        Its period; None without an angular rate.
    stability : str
        "stable", "unstable" or "semistable".
    condition : sympy.Basic
        The condition on the parameters under which the cycle exists.
    """

    radius: sp.Expr
    period: sp.Expr | None
    stability: str
    condition: sp.Basic

    def _repr_markdown_(self):
        text = f"{self.stability} limit cycle, $r = {sp.latex(self.radius)}$"
        if self.period is not None:
            text += f", period ${sp.latex(self.period)}$"
        if self.condition is not sp.true:
            text += f", if ${sp.latex(self.condition)}$"
        return text


def limit_cycles(
    radial_rate: sp.Expr, r: sp.Symbol, angular_rate: ExprLike | None = None
) -> list[LimitCycle]:
    """Return the limit cycles of r' = radial_rate(r), phi' = angular_rate(r).

    Parameters
    ----------
    radial_rate : sympy.Expr
        r' as a function of `r` and parameters.
    r : sympy.Symbol
        The radius.
    angular_rate : sympy.Expr, optional
        phi' as a function of `r` and parameters; a circle on which it is zero consists of
        equilibria and is left out.

    Returns
    -------
    list of LimitCycle
        A cycle is stable if r' is positive just inside and negative just outside, unstable in the
        opposite case, semistable if the signs are equal (also where the derivative of r' vanishes).
        The period is 2 pi/abs(phi').

    Raises
    ------
    ValueError
        If r' is identically zero (then all circles are closed) or cannot be solved.

    Notes
    -----
    Source: problems 1.12 and 1.13 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> r, u = sp.symbols("r u")
    >>> limit_cycles((u - 2)*r - r**3, r, r + 1)
    [LimitCycle(radius=sqrt(u - 2), period=2*pi/(sqrt(u - 2) + 1), stability='stable', condition=u > 2)]
    >>> [c.stability for c in limit_cycles(-r*(r**2 - 1)**2, r)]
    ['semistable']
    """
    radial = exact_decimals(read_expression(radial_rate, "radial_rate"))
    (r,) = read_symbols(r, "r")
    if radial == 0 or sp.expand(radial) == 0:
        raise ValueError(
            "radial_rate: it is identically zero, so every circle is closed and none is a limit "
            "cycle"
        )
    angular = (
        None
        if angular_rate is None
        else exact_decimals(read_expression(angular_rate, "angular_rate"))
    )
    radius = sp.Dummy("r", positive=True)
    to_real, from_real = as_real(radial, *([] if angular is None else [angular]))
    to_real[r], from_real[radius] = radius, r
    radial = radial.xreplace(to_real)
    angular = None if angular is None else angular.xreplace(to_real)

    solutions = solve_real([radial], [radius])
    if solutions.unsolved or solutions.integers:
        raise ValueError(
            f"radial_rate: the zeros of {radial_rate} could not all be found; substitute numbers"
        )
    try:
        cycles = [
            cycle
            for values, condition in solutions.branches
            if (cycle := _cycle(radial, angular, radius, values[radius], condition))
        ]
    except ValueError as error:
        raise ValueError(restore_names(str(error), from_real)) from None
    cycles = [
        LimitCycle(
            c.radius.xreplace(from_real),
            c.period and c.period.xreplace(from_real),
            c.stability,
            c.condition.xreplace(from_real),
        )
        for c in cycles
    ]
    return sorted(cycles, key=lambda c: sp.default_sort_key(c.radius))


def _cycle(radial, angular, radius, size, condition):
    """Return the cycle r = size, or None if the circle consists of equilibria."""
    period = None
    if angular is not None:
        speed = sp.simplify(angular.subs(radius, size))
        if speed == 0:
            return None
        period = 2 * sp.pi / (speed * _sign_under(speed, condition, "angular_rate"))
    return LimitCycle(size, period, _stability(radial, radius, size, condition), condition)


def _stability(radial, radius, size, condition):
    """Decide by the first derivative of r' that does not vanish on the cycle."""
    for order in range(1, 20):
        derivative = sp.simplify(sp.diff(radial, radius, order).subs(radius, size))
        if derivative != 0:
            if order % 2 == 0:
                return "semistable"
            return "stable" if _sign_under(derivative, condition, "radial_rate") < 0 else "unstable"
    raise ValueError(f"radial_rate: its first 19 derivatives vanish at r = {size}")


def _sign_under(expression, condition, name):
    """Return the sign of an expression wherever the condition holds; ValueError if not one."""
    # A square root that is real and not zero is positive.
    roots = {
        p
        for p in expression.atoms(sp.Pow)
        if p.exp.is_Rational and p.exp.q % 2 == 0 and p.exp.is_positive
    }
    sign, odd, _ = sign_factors(
        expression.xreplace({p: sp.Dummy("root", positive=True) for p in roots})
    )
    if not odd:
        return sign
    sign, odd, _ = sign_factors(expression)
    product = sign * sp.Mul(*odd)
    assumed_positive = [
        c.gts - c.lts for c in sp.And.make_args(condition) if isinstance(c, (sp.Gt, sp.Lt))
    ]
    symbols = sorted(product.free_symbols | condition.free_symbols, key=str)
    try:
        if solution_point([*assumed_positive, product], symbols) is None:
            return -1
        if solution_point([*assumed_positive, -product], symbols) is None:
            return 1
    except TooLarge:
        pass
    raise ValueError(
        f"{name}: the answer depends on the sign of {product}; declare its symbols positive or "
        "negative, or substitute numbers"
    )
