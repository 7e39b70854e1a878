"""State constraints g(y) <= 0 along the path: order, boundary control and multiplier in symbols.

The order p is that of the first time derivative of g that contains a control; g^(p)(y, u) = 0 keeps
the trajectory on the boundary. With a multiplier eta >= 0 that is zero where g < 0,

    psi' = -dH/dy + eta dg/dy,      psi(t+) = psi(t-) + nu dg/dy with nu >= 0 where contact begins or ends,

H is continuous, and the control still maximises H (direct adjoining; Hartl, Sethi and Vickson 1995).
For p = 1 the costate does not jump: dg/dy f is negative on the side off the boundary if the control
jumps, so that nu = 0 follows from the continuity of H and the maximum condition. On a boundary arc
on which the control u is inside its bounds, dH/du = 0 holds identically; its derivatives of order 0
to p-1 are conditions where the arc begins, and that of order p determines eta.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib.flows import lie_derivative
from trajlib.pontryagin.problem.singular import vanishes_identically
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True, eq=False)
class StateConstraint:
    """A state constraint with what follows from it.

    Attributes
    ----------
    expression : sympy.Expr
        g in g <= 0.
    order : int
        p, of the first derivative of g that contains a control.
    derivatives : tuple of sympy.Expr
        g and its time derivatives of the orders 1 to p.
    multiplier : sympy.Symbol
        eta, nonnegative.
    boundary_control : dict
        {control: expression} from g^(p) = 0; empty with several controls in g^(p), or without a
        closed form.
    adjoint : dict
        {psi_i: right-hand side of psi_i'} on a boundary arc, with eta.
    conditions : tuple of sympy.Expr
        dH/du and its derivatives of orders 1 to p-1, which vanish where a boundary arc begins;
        empty where the boundary control is not known.
    density : sympy.Expr or None
        eta on a boundary arc, where the boundary control is known.

    Notes
    -----
    Direct adjoining: the costate jumps by nu dg/dy with nu >= 0, and eta >= 0. Source: the section
    on state constraints that is added to chapter 5 (Hartl, Sethi and Vickson 1995).

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> limited = Problem({x: v, v: u}, {u: None}, {x: 0, v: 1}, {x: 0, v: -1}, running=u**2/2,
    ...                   duration=1, path=[x <= sp.Rational(1, 9)])
    >>> (constraint,) = limited.conditions().path
    >>> constraint.order, constraint.boundary_control, constraint.conditions
    (2, {u: 0}, (psi2, -psi1))
    """

    expression: sp.Expr
    order: int
    derivatives: tuple[sp.Expr, ...]
    multiplier: sp.Symbol
    boundary_control: dict[sp.Symbol, sp.Expr]
    adjoint: dict[sp.Symbol, sp.Expr]
    conditions: tuple[sp.Expr, ...]
    density: sp.Expr | None


def constraint_derivatives(problem: Statement, g: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return g and its time derivatives up to the first that contains a control.

    Raises ValueError if none of the first n does.
    """
    derivatives = [g]
    for _ in problem.state:
        derivatives.append(sp.expand(lie_derivative(derivatives[-1], problem.dynamics)))
        if not all(vanishes_identically(sp.diff(derivatives[-1], u)) for u in problem.control):
            return tuple(derivatives)
    raise ValueError(
        f"path: {g} does not depend on the control (none of its first {len(problem.state)} time "
        "derivatives contains it), so that the initial state alone decides about it; expected a "
        "constraint that a control can keep. Leave it out where the initial state satisfies it"
    )


def state_constraint(derived, number: int) -> StateConstraint:
    """Return what follows from a path constraint (0, 1, ...) of a problem.

    `derived`: the `Conditions` of the problem.
    """
    problem = derived.problem
    g = problem.constraints[number]
    derivatives = constraint_derivatives(problem, g)
    eta = sp.Symbol(f"eta{number + 1}" if len(problem.path) > 1 else "eta", nonnegative=True)
    adjoint = {
        psi: rate + eta * sp.diff(g, y)
        for (psi, rate), y in zip(derived.adjoint.items(), problem.state)
    }
    control = _boundary_control(problem, derivatives[-1])
    conditions: list[sp.Expr] = []
    density = None
    if control:
        (u,) = control
        field = {y: f.subs(control) for y, f in problem.dynamics.items()} | {
            psi: rate.subs(control) for psi, rate in adjoint.items()
        }
        slopes = [sp.simplify(sp.diff(derived.hamiltonian, u).subs(control))]
        for _ in range(len(derivatives) - 1):
            slopes.append(sp.expand(lie_derivative(slopes[-1], field)))
        *conditions, last = slopes
        factor = sp.diff(last, eta)
        if factor != 0:
            density = sp.simplify(-last.subs(eta, 0) / factor)
    return StateConstraint(
        g, len(derivatives) - 1, derivatives, eta, control, adjoint, tuple(conditions), density
    )


def _boundary_control(problem, highest):
    """Return {u: expression} from g^(p) = 0, empty without a unique closed form."""
    acting = [u for u in problem.control if highest.has(u)]
    if len(acting) != 1:
        return {}
    (u,) = acting
    if highest.is_polynomial(u) and sp.degree(highest, u) == 1:
        return {u: sp.simplify(-highest.subs(u, 0) / sp.diff(highest, u))}
    return {}
