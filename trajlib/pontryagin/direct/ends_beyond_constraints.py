"""Given initial and final states that violate an inequality for the states."""

from trajlib.flows import lie_derivative
from trajlib.pontryagin.problem.errors import Infeasible
from trajlib.pontryagin.problem.hypotheses import CONSTRAINED
from trajlib.pontryagin.problem.singular import vanishes_identically
from trajlib.pontryagin.problem.steps import Refusal

# Margin by which a value counts as beyond a bound, relative to the size of the values.
MARGIN = 1e-9


def _refuse_ends_beyond_constraints(numeric):
    problem = numeric.problem
    start = {y: value for y, value in problem.initial.items() if value is not None}
    end = {
        y: value
        for y in problem.state
        for g in problem.terminal
        for value in (y - g, y + g)
        if value.is_number
    }
    constant = (
        relation
        for relation in problem.terminal_inequalities
        if vanishes_identically(lie_derivative(relation.lhs, problem.dynamics))
    )
    relations = [("initial", start, relation) for relation in (*problem.path, *constant)]
    relations += [
        ("final", end, relation) for relation in (*problem.path, *problem.terminal_inequalities)
    ]
    for name, values, relation in relations:
        value = relation.lhs.subs(values)
        size = max((abs(float(v)) for v in values.values()), default=0.0)
        if value.is_number and float(value) > MARGIN * (1 + size):
            raise Infeasible(
                f"the {name} state violates the constraint {relation}: its left-hand side is "
                f"{float(value):.6g}"
            )


ENDS_BEYOND_CONSTRAINTS = Refusal(
    "ends that violate an inequality",
    "No process keeps to an inequality that a given initial or final state violates.",
    "evaluation at the ends",
    (CONSTRAINED,),
    Infeasible,
    _refuse_ends_beyond_constraints,
)
