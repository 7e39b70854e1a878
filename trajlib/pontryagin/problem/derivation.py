"""The conditions of the maximum principle in symbols (Theorem 5.1 of the problem book).

With H = psi^T f - lambda_0 f_0 (for a maximum of the cost: + lambda_0 f_0), lambda_0 >= 0,
(lambda_0, psi) not zero:

    psi' = -dH/dy                                                                                          (5.4)
    H(psi, y, u) is largest, among the admissible u, for the optimal control                               (5.5)
    psi(t_k) + lambda_0 grad phi_0 is orthogonal to the target:  = -sum_j lambda_j grad phi_j              (5.6)
    H = 0 along the trajectory if the final time is free, H = const if it is given                         (5.7)

psi_i(0) = 0 for a state that is free at t = 0. The pair (lambda_0, psi) is determined up to a
positive factor: lambda_0 = 1 is the normal case; lambda_0 = 0, in which the cost has no influence,
the abnormal one.
"""

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from trajlib.flows import lie_derivative
from trajlib.pontryagin.problem.elimination import control_field
from trajlib.pontryagin.problem.maximum import maximising_control
from trajlib.pontryagin.problem.presentation import conditions_markdown
from trajlib.pontryagin.problem.singular import SingularArc, singular_arc
from trajlib.pontryagin.problem.state_constraints import StateConstraint, state_constraint
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True, eq=False)
class Conditions:
    """The conditions of the maximum principle; shows itself typeset in a notebook.

    Attributes
    ----------
    problem : Problem
        The problem from which they are derived.
    costate : tuple of sympy.Symbol
        psi1, ..., psin.
    multiplier : sympy.Symbol
        lambda0, nonnegative.
    terminal_multipliers : tuple of sympy.Symbol
        lambda1, ..., lambdam, one for each terminal equation; then those of the terminal
        inequalities, nonnegative, and zero where these hold strictly.
    hamiltonian : sympy.Expr
        The Pontryagin function H(psi, y, u), with lambda0.
    adjoint : dict
        {psi_i: right-hand side of psi_i'}.
    switching : dict
        {control: dH/du} for the controls in which H is linear.

    Notes
    -----
    H = psi^T f - lambda_0 f_0 is maximised by the optimal control. Source: Theorem 5.1 of the
    problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x1, x2, u = sp.symbols("x1 x2 u")
    >>> derived = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 1, x2: 0}, terminal=[x1, x2]).conditions()
    >>> derived.hamiltonian
    -lambda0 + psi1*x2 + psi2*u
    >>> derived.adjoint[derived.costate[1]], derived.switching[u]
    (-psi1, psi2)
    """

    problem: Statement
    costate: tuple[sp.Symbol, ...]
    multiplier: sp.Symbol
    terminal_multipliers: tuple[sp.Symbol, ...]
    hamiltonian: sp.Expr
    adjoint: dict[sp.Symbol, sp.Expr]
    switching: dict[sp.Symbol, sp.Expr]

    @cached_property
    def maximising(self) -> dict[sp.Symbol, sp.Expr | None]:
        """{control: the control that makes H largest}, a Piecewise; None without a closed form."""
        return maximising_control(self)

    @cached_property
    def singular(self) -> dict[sp.Symbol, SingularArc]:
        """{control: SingularArc} for the controls in `switching`."""
        return {u: singular_arc(self, u) for u in self.switching}

    @cached_property
    def path(self) -> tuple[StateConstraint, ...]:
        """One StateConstraint for each path constraint: order, boundary control, multiplier."""
        return tuple(state_constraint(self, j) for j in range(len(self.problem.path)))

    @cached_property
    def control_field(self) -> dict[sp.Symbol, sp.Expr]:
        """{control: u', state: ...}: the control inside its bounds, with the costates eliminated."""
        return control_field(self.problem)

    @cached_property
    def transversality(self) -> tuple[sp.Expr, ...]:
        """Expressions that vanish at the final time, with lambda1, ..., lambdam."""
        problem, sign = self.problem, -1 if self.problem.maximise else 1
        return tuple(
            psi
            + sign * self.multiplier * sp.diff(problem.final, y)
            + sum(
                m * sp.diff(g, y)
                for m, g in zip(
                    self.terminal_multipliers, (*problem.terminal, *problem.end_constraints)
                )
            )
            for psi, y in zip(self.costate, problem.state)
        )

    @cached_property
    def reduced_transversality(self) -> tuple[sp.Expr, ...]:
        """Products of psi + lambda_0 grad phi_0 with the tangent vectors of the target.

        They vanish at the final time and do not contain lambda1, ..., lambdam.
        """
        problem, sign = self.problem, -1 if self.problem.maximise else 1
        normal = sp.Matrix(
            [
                psi + sign * self.multiplier * sp.diff(problem.final, y)
                for psi, y in zip(self.costate, problem.state)
            ]
        )
        if not problem.terminal:
            return tuple(normal)
        tangents = sp.Matrix(problem.terminal).jacobian(problem.state).nullspace()
        cleared = (
            tangent * sp.lcm([sp.denom(sp.together(c)) for c in tangent]) for tangent in tangents
        )
        return tuple(sp.expand(sp.cancel((normal.T * tangent)[0])) for tangent in cleared)

    @property
    def initial_transversality(self) -> tuple[sp.Symbol, ...]:
        """The costates psi_i that vanish at t = 0, those of free initial states."""
        return tuple(
            psi
            for psi, y in zip(self.costate, self.problem.state)
            if self.problem.initial[y] is None
        )

    @property
    def stationarity(self) -> sp.Eq | None:
        """The equation H = 0 if the final time is free, else None (H is then constant)."""
        return sp.Eq(self.hamiltonian, 0) if self.problem.duration is None else None

    @property
    def normal(self) -> sp.Expr:
        """H with lambda0 = 1."""
        return self.hamiltonian.subs(self.multiplier, 1)

    @property
    def abnormal(self) -> sp.Expr:
        """H with lambda0 = 0."""
        return self.hamiltonian.subs(self.multiplier, 0)

    def derivative(self, expression: sp.Expr) -> sp.Expr:
        """Return the time derivative along the trajectories, the controls being constant.

        Parameters
        ----------
        expression : sympy.Expr
            A function of state and costate.

        Returns
        -------
        sympy.Expr
            Its Lie derivative along y' = f and psi' = -dH/dy.
        """
        return lie_derivative(expression, {**self.problem.dynamics, **self.adjoint})

    def _repr_markdown_(self):
        return conditions_markdown(self)


def conditions(problem: Statement) -> Conditions:
    """Return the conditions of the maximum principle for a problem, derived once for it.

    Raises ValueError if the problem already uses one of the names psi1, ..., psin, lambda0,
    lambda1, .... Source: Theorem 5.1 of the problem book.
    """
    return problem.cached("conditions", lambda: _derived(problem))


def _derived(problem):
    n = len(problem.state)
    costate = tuple(sp.Symbol(f"psi{i}", real=True) for i in range(1, n + 1))
    multiplier = sp.Symbol("lambda0", nonnegative=True)
    terminal_multipliers = tuple(
        sp.Symbol(f"lambda{j}", real=True) for j in range(1, len(problem.terminal) + 1)
    )
    terminal_multipliers += tuple(
        sp.Symbol(f"lambda{j}", nonnegative=True)
        for j in range(
            len(problem.terminal) + 1, len(problem.terminal) + len(problem.end_constraints) + 1
        )
    )
    taken = {s.name for s in (*problem.state, *problem.control, *problem.parameters)}
    names = {s.name for s in (*costate, multiplier, *terminal_multipliers)}
    if problem.path:
        names |= {"eta", *(f"eta{j}" for j in range(1, len(problem.path) + 1))}
    clash = taken & names
    if clash:
        raise ValueError(
            f"conditions: {', '.join(sorted(clash))} is the name of a costate or multiplier; "
            "rename the symbol of the problem"
        )
    sign = -1 if problem.maximise else 1
    # exp(-k*(h - 1)) is not expanded: exp(k)*exp(-k*h) overflows.
    hamiltonian = sp.expand(
        sum(psi * f for psi, f in zip(costate, problem.field))
        - sign * multiplier * problem.running,
        power_exp=False,
    )
    adjoint = {psi: -sp.diff(hamiltonian, y) for psi, y in zip(costate, problem.state)}
    # A coefficient that contains other controls is still the switching function of this control.
    slopes = {u: sp.diff(hamiltonian, u) for u in problem.control}
    switching = {u: slope for u, slope in slopes.items() if not sp.expand(slope).has(u)}
    return Conditions(
        problem, costate, multiplier, terminal_multipliers, hamiltonian, adjoint, switching
    )
