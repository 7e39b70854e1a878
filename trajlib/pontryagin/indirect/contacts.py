"""Contacts of a discrete solution with the boundaries of its path constraints.

A contact is a run of nodes at which a constraint is active. It may be a boundary arc or, for an
order above one, a touch point; which of them is decided by the certificate of the extremal.
"""

import itertools
from dataclasses import dataclass, replace

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.direct.transcription import DirectSolution, path_rows
from trajlib.pontryagin.problem.arcs import Arc, boundary_constraint, boundary_kind
from trajlib.pontryagin.problem.errors import Chattering, NotUnique
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.state_constraints import constraint_derivatives
from trajlib.pontryagin.problem.steps import Hypothesis, Refusal

# Nodes up to which a contact may be a touch point; largest number of structures that are tried.
TOUCHING, MOST = 3, 8
# Distance from the boundary up to which a given end is on it; share of the greatest distance up to
# which the nodes between two contacts belong to them.
AT, NEAR = 1e-9, 1e-3
# Size of g^(p), relative to its derivative by the controls, up to which these keep g = 0.
HOLDING = 1e-3


@dataclass(frozen=True)
class Contact:
    """A run of nodes, `first` to `last`, at which a path constraint is active.

    `time` is the mean of their times, weighted by the multipliers. `kind` is "boundary" or "touch".
    """

    constraint: int
    first: int
    last: int
    time: float
    kind: str = "boundary"


def contact_structures(numeric: NumericProblem, solution: DirectSolution) -> list[list[Contact]]:
    """Return the lists of contacts that a discrete solution may have, the likeliest first."""
    options = []
    for contact in contacts(numeric, solution):
        boundary, touch = contact, replace(contact, kind="touch")
        order, width = numeric.path_orders[contact.constraint], contact.last - contact.first
        if contact.last == len(solution.controls) and width < TOUCHING:
            # At the end alone it is a terminal equation.
            options.append([[], [boundary]])
        elif order == 1:
            options.append([[boundary], []] if width < TOUCHING else [[boundary]])
        elif width < TOUCHING:
            options.append([[touch], [boundary], []])
        else:
            ends = [
                Contact(contact.constraint, node, node, float(solution.times[node]), "touch")
                for node in (contact.first, contact.last)
            ]
            options.append([[boundary], [touch], ends])
    choices = itertools.islice(itertools.product(*options), MOST)
    return [list(itertools.chain(*choice)) for choice in choices]


def contacts(numeric: NumericProblem, solution: DirectSolution) -> list[Contact]:
    """Return the contacts of a discrete solution, those of each constraint in order of time."""
    multipliers = solution.path_multipliers
    if not numeric.path_orders or multipliers is None:
        return []
    N, c = len(solution.controls), len(numeric.path_orders)
    slack = -numeric.path_value.map(N + 1)(solution.states.T)[0].full().T
    # Interior-point methods leave products multiplier * slack of one size: the larger one counts.
    active = multipliers > np.abs(slack)
    imposed = np.zeros((N + 1) * c, dtype=bool)
    imposed[path_rows(numeric, N)] = True
    implied = ~imposed.reshape(N + 1, c)
    result = []
    for j in range(c):
        # A given end on the boundary belongs to the contact beside it.
        for node, beside in ((0, 1), (N, N - 1)):
            active[node, j] |= implied[node, j] and abs(slack[node, j]) <= AT and active[beside, j]
        # On a boundary arc the multiplier may vanish.
        near = slack[:, j] <= NEAR * np.max(slack[:, j])
        for first, end in _runs(near):
            nodes = np.nonzero(active[first:end, j])[0]
            if len(nodes):
                active[first + nodes[0] : first + nodes[-1] + 1, j] = True
        for first, end in _runs(active[:, j]):
            weights = multipliers[first:end, j] + 1e-300
            time = float(weights @ solution.times[first:end] / weights.sum())
            result.append(Contact(j, int(first), int(end - 1), time))
    return result


def _runs(flags):
    """Return (first, end) of the runs of true values."""
    return np.flatnonzero(np.diff(np.concatenate([[0], flags, [0]]))).reshape(-1, 2)


def end_constraints(numeric: NumericProblem, solution: DirectSolution) -> list[int]:
    """Return the inequalities that are active at the end, where no equation implies them.

    Indices into the path constraints followed by the terminal inequalities.
    """
    N, c = len(solution.controls), len(numeric.path_orders)
    imposed = [row - N * c for row in path_rows(numeric, N) if row >= N * c]
    at_end = {contact.constraint for contact in contacts(numeric, solution) if contact.last == N}
    active = [j for j in imposed if j in at_end]
    if numeric.problem.terminal_inequalities and solution.end_multipliers is not None:
        function = ca.Function("end", [numeric.x], [numeric.end_path])
        slack = -function(solution.states[-1]).full().ravel()
        active += [c + int(i) for i in np.nonzero(solution.end_multipliers > np.abs(slack))[0]]
    return active


def with_boundary_labels(numeric, solution, columns, chosen):
    """Return the labels of all controls with those of the boundary arcs of the contacts.

    `columns`: for each control its labels on the intervals. Raises `NotUnique` where all controls
    that could keep the constraint are at their bounds.
    """
    columns = [list(column) for column in columns]
    N = len(solution.controls)
    for contact in chosen:
        if contact.kind != "boundary":
            continue
        first, last = contact.first, contact.last
        if first == last:
            first, last = max(first - 1, 0), min(last + 1, N)
        if last - first > TOUCHING:
            HIGH_ORDER.check(numeric, contact.constraint)
        inside = slice(first, last)
        acting = _acting_controls(numeric, contact.constraint)
        free = [i for i in acting if np.mean([k == "between" for k in columns[i][inside]]) > 0.5]
        if not free and not _holds_boundary(numeric, solution, contact, inside):
            # The steps are too long for this contact: the certificate of its arcs decides.
            continue
        if not free:
            _refuse_common_arc(numeric, contact, [columns[i][inside] for i in acting])
            raise NotUnique(
                f"on the boundary of {numeric.problem.path[contact.constraint]} the controls that "
                "act on it are at their bounds, so that its multiplier is not unique. Leave out the "
                "constraint or the bound that implies the other."
            )
        columns[free[0]][inside] = [boundary_kind(contact.constraint)] * (last - first)
    return [np.array(column, dtype=object) for column in columns]


def _refuse_high_order(numeric, constraint):
    order = numeric.path_orders[constraint]
    if order > 2:
        g = numeric.problem.path[constraint]
        raise Chattering(
            f"{g} is a state constraint of order {order}: a boundary arc has "
            f"{2 * order} conditions where it begins, more than two times and two jumps of the "
            "costate can satisfy except by chance, and contacts with the boundary accumulate before "
            "it. No list of arcs was found for this extremal. Bound a derivative of this quantity "
            "instead, or put a penalty for it into the cost."
        )


def _refuse_common_arc(numeric, contact, parts):
    """Raise `NotUnique` if the controls of a boundary arc already follow another boundary."""
    path = numeric.problem.path
    for other, relation in enumerate(path):
        if other != contact.constraint and any(boundary_kind(other) in part for part in parts):
            raise NotUnique(
                f"the boundaries of {path[contact.constraint]} and {relation} are followed at once, with "
                "no control for each of them, so that their multipliers are not unique. Leave out the "
                "constraint that the other implies there."
            )


def _holds_boundary(numeric, solution, contact, inside):
    """Check whether the controls keep the trajectory on the boundary: g^(p) = 0."""
    x, u, highest = numeric.x, numeric.u, numeric.path[contact.constraint]
    for _ in range(numeric.path_orders[contact.constraint]):
        highest = ca.jtimes(highest, x, numeric.field)
    free = ca.jtimes(highest, u, ca.SX.ones(numeric.k))
    value = ca.Function("highest", [x, u], [highest, free])
    rates = [
        [float(part) for part in value(state, control)]
        for state, control in zip(solution.states[inside], solution.controls[inside])
    ]
    return all(abs(rate) <= HOLDING * (1 + abs(slope)) for rate, slope in rates)


def _acting_controls(numeric, constraint):
    """Return the indices of the controls in the derivative of the constraint's order."""
    problem = numeric.problem
    highest = constraint_derivatives(problem, problem.constraints[constraint])[-1]
    return [i for i, u in enumerate(problem.control) if highest.has(u)]


def with_touch_points(arcs: list[Arc], chosen: list[Contact]) -> list[Arc]:
    """Return the arcs, cut at the touch points."""
    for contact in chosen:
        if contact.kind != "touch":
            continue
        arcs = [
            part
            for arc in arcs
            for part in (
                [
                    Arc(arc.kinds, arc.begin, contact.time, arc.touch),
                    Arc(arc.kinds, contact.time, arc.end, contact.constraint),
                ]
                if arc.begin < contact.time < arc.end
                and boundary_constraint(arc.kinds) != contact.constraint
                else [arc]
            )
        ]
    return arcs


def jump_guess(solution: DirectSolution, constraint: int, time: float) -> float:
    """Return the multiplier of a jump of the costate near a time: the sum over the nodes there."""
    if solution.path_multipliers is None:
        return 0.0
    step = solution.duration / len(solution.controls)
    near = np.abs(solution.times - time) <= 2.5 * step
    return float(solution.path_multipliers[near, constraint].sum())


ORDER_ABOVE_TWO = Hypothesis(
    "a path constraint has an order above two",
    lambda p: any(len(constraint_derivatives(p, g)) > 3 for g in p.constraints),
)
HIGH_ORDER = Refusal(
    "boundary arc of an order above two",
    "It has more conditions at its beginning than unknowns: contacts with the boundary accumulate.",
    "Robbins 1980",
    (ORDER_ABOVE_TWO,),
    Chattering,
    _refuse_high_order,
)
