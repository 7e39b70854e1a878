"""The conditions of the maximum principle for a problem, in symbols (Theorem 5.1 of the problem
book).

With H = psi^T f - lambda_0 f_0 (for a maximum of the cost: + lambda_0 f_0), lambda_0 >= 0,
(lambda_0, psi) not zero:

    psi' = -dH/dy                                                                                          (5.4)
    H(psi, y, u) is largest, among the admissible u, for the optimal control                               (5.5)
    psi(t_k) + lambda_0 grad phi_0 is orthogonal to the target:  = -sum_j lambda_j grad phi_j              (5.6)
    H = 0 along the trajectory if the final time is free, H = const if it is given                         (5.7)

psi_i(0) = 0 for a state that is free at the start. The pair (lambda_0, psi) matters up to a
positive factor: lambda_0 = 1 is the normal case; lambda_0 = 0, in which the cost takes no part, the
abnormal one.
"""

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from trajlib.flows import lie_derivative
from trajlib.pontryagin.problem.elimination import control_field
from trajlib.pontryagin.problem.maximum import maximising_control
from trajlib.pontryagin.problem.presentation import conditions_markdown
from trajlib.pontryagin.problem.singular import SingularArc, singular_arc
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True, eq=False)
class Conditions:
    """The conditions of the maximum principle; shows itself typeset in a notebook.

    - `costate`: the symbols psi1, ..., psin; `multiplier`: lambda0; `terminal_multipliers`:
      lambda1, ..., lambdam
    - `hamiltonian`: H(psi, y, u); `adjoint`: {psi_i: right-hand side of psi_i'}
    - `switching`: {control: dH/du} for the controls in which H is linear
    - `maximising`: {control: the control that makes H largest, a Piecewise}
    - `singular`: {control: SingularArc} for the controls in `switching`
    - `control_field`: {control: its rate, state: ...}, the motion of a control inside its bounds
      without the costates
    - `transversality`: expressions that vanish at the end, `reduced_transversality` the same
      without lambda1, ..., lambdam
    - `initial_transversality`: the psi_i that vanish at the start
    - `stationarity`: the equation H = 0 if the final time is free, else None (H is then constant)
    - `normal`, `abnormal`: H with lambda0 = 1 and with lambda0 = 0

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
    costate: tuple
    multiplier: sp.Symbol
    terminal_multipliers: tuple
    hamiltonian: sp.Expr
    adjoint: dict
    switching: dict

    @cached_property
    def maximising(self):
        return maximising_control(self)

    @cached_property
    def singular(self) -> dict[sp.Symbol, SingularArc]:
        return {u: singular_arc(self, u) for u in self.switching}

    @cached_property
    def control_field(self):
        return control_field(self.problem)

    @cached_property
    def transversality(self):
        problem, sign = self.problem, -1 if self.problem.maximise else 1
        return tuple(
            psi
            + sign * self.multiplier * sp.diff(problem.final, y)
            + sum(m * sp.diff(g, y) for m, g in zip(self.terminal_multipliers, problem.terminal))
            for psi, y in zip(self.costate, problem.state)
        )

    @cached_property
    def reduced_transversality(self):
        """Products of psi + lambda_0 grad phi_0 with the tangent vectors of the target."""
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
    def initial_transversality(self):
        return tuple(
            psi
            for psi, y in zip(self.costate, self.problem.state)
            if self.problem.initial[y] is None
        )

    @property
    def stationarity(self):
        # Between bounds the duration may stop at one of them, where H need not vanish.
        return sp.Eq(self.hamiltonian, 0) if self.problem.duration is None else None

    @property
    def normal(self):
        return self.hamiltonian.subs(self.multiplier, 1)

    @property
    def abnormal(self):
        return self.hamiltonian.subs(self.multiplier, 0)

    def derivative(self, expression):
        """Time derivative of a function of state and costate along the trajectories (the controls
        constant)."""
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
    taken = {s.name for s in (*problem.state, *problem.control, *problem.parameters)}
    clash = taken & {s.name for s in (*costate, multiplier, *terminal_multipliers)}
    if clash:
        raise ValueError(
            f"conditions: {', '.join(sorted(clash))} is the name of a costate or multiplier; "
            "rename the symbol of the problem"
        )
    sign = -1 if problem.maximise else 1
    # exp(-k*(h - 1)) stays whole: exp(k)*exp(-k*h) overflows.
    hamiltonian = sp.expand(
        sum(psi * f for psi, f in zip(costate, problem.field))
        - sign * multiplier * problem.running,
        power_exp=False,
    )
    adjoint = {psi: -sp.diff(hamiltonian, y) for psi, y in zip(costate, problem.state)}
    # Linear in one control while the others stand in the coefficient: still a switching function of
    # this control.
    slopes = {u: sp.diff(hamiltonian, u) for u in problem.control}
    switching = {u: slope for u, slope in slopes.items() if not sp.expand(slope).has(u)}
    return Conditions(
        problem, costate, multiplier, terminal_multipliers, hamiltonian, adjoint, switching
    )
