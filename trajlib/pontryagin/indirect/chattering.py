"""Chattering: switchings accumulate where a bang arc meets a singular arc of even order.

On a singular arc of even order q with (-1)^q b < 0 and a control inside the bounds, no bang arc can
join it with a jump of the control: the optimal control switches infinitely often before it gets
there (Fuller's problem, q = 2, where the arcs shrink by the factor 4.13). No finite list of arcs
describes such an extremal, so it is refused, with the numbers of `accumulation` where they are
known.

A bang arc can join a singular arc of odd order q > 1, but only from the few states of one
trajectory: from the others the cost may fall with every further arc as well (the third derivative
of x as control, the cost x^2, q = 3). There the numbers decide.
"""

from itertools import pairwise

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.indirect.accumulation import estimate_accumulation
from trajlib.pontryagin.indirect.flow import ArcFlow
from trajlib.pontryagin.problem.errors import Chattering, WrongStructure
from trajlib.pontryagin.problem.hypotheses import LINEAR_BETWEEN_BOUNDS
from trajlib.pontryagin.problem.steps import Refusal


def _refuse_chattering(numeric, arcs, end, duration):
    """Raise `Chattering` if the arcs reach a singular arc that bang arcs cannot join.

    `arcs`: list of `Arc`; `end`: final state; `duration`: None if the final time is free. At a
    singular arc of odd order above one it is raised only if further arcs lower the cost. A free
    final time in which the target lies on the singular arc is the case of Fuller: resting there
    costs nothing more.
    """
    for j in range(numeric.k):
        if not numeric.affine[j] or not np.isfinite([numeric.lower[j], numeric.upper[j]]).all():
            continue
        kinds = [arc.kinds[j] for arc in arcs]
        # A boundary arc of a state constraint may lead from the one to the other.
        joined = any({"singular"} < {*pair} <= {"singular", "u-", "u+"} for pair in pairwise(kinds))
        rests = (
            duration is None and numeric.m and kinds[-1] != "singular" and _may_rest(numeric, end)
        )
        if not joined and not rests:
            continue
        kinds_of_arc = arcs[kinds.index("singular")].kinds if joined else arcs[-1].kinds
        probe = tuple("singular" if i == j else kind for i, kind in enumerate(kinds_of_arc))
        try:
            flow = ArcFlow(numeric, probe)
        except WrongStructure:
            continue
        q = flow.orders[j]
        if q > 1 and (joined or _rests_on_arc(numeric, flow, j, end)):
            numbers = estimate_accumulation(numeric, arcs, flow, duration)
            if q % 2 and not numbers:
                continue
            reason = (
                "ever more arcs cost ever less"
                if q % 2
                else "a bang arc cannot join a singular arc of even order, so the control switches infinitely often "
                "before"
            )
            lengths = ", ".join(
                f"{arc.end - arc.begin:.3g}" for arc in arcs if arc.kinds[j] != "singular"
            )
            evidence = f"With ever more arcs {numbers}." if numbers else f"First arcs: {lengths}."
            raise Chattering(
                f"the switchings of {numeric.problem.control[j]} accumulate where the trajectory "
                f"reaches a singular arc of order {q}: {reason}. {evidence} No list of arcs describes "
                "it; bound the number of switchings in another way, for example by a cost on the "
                "control.",
                numbers,
            )


def _may_rest(numeric, end):
    """Check whether resting at the end may cost nothing, by the running cost alone.

    A process that rests keeps to the target, G f = 0, so that psi^T f = 0 by transversality if the
    end itself has no cost, and H = -f_0. This cheap test saves the derivatives of the switching
    function, which fill pages where the plant is not simple.
    """
    if numeric.problem.final != 0 or any(ca.which_depends(numeric.density, numeric.u)):
        return True
    return abs(float(ca.Function("density", [numeric.x], [numeric.density])(end))) < 1e-7 * (
        1 + np.max(np.abs(end))
    )


def _rests_on_arc(numeric, flow, j, end):
    """Check whether the end state lies on the singular arc and can rest there at no cost.

    It needs lambda_0 = 1, a control strictly inside its bounds, an arc that keeps to the target,
    and H = 0, since the final time is free: where the arc has a running cost, resting there is not
    free. Nor does the process rest there where other controls, at their bounds, drive it away from
    the target.
    """
    n = numeric.n
    # Where its switching function vanishes H does not depend on the singular control.
    other_controls = [
        {"u-": numeric.lower[i], "u+": numeric.upper[i]}.get(kind, 0.0)
        for i, kind in enumerate(flow.kinds)
    ]
    equations = ca.vertcat(
        flow.entry, ca.substitute(numeric.hamiltonian, numeric.u, ca.DM(other_controls))
    )
    unknown = ca.vertcat(numeric.psi, numeric.multiplier)
    matrix = ca.Function("matrix", [numeric.x, unknown], [ca.jacobian(equations, unknown)])(
        end, np.zeros(n + 1)
    ).full()
    # psi from the equations with lambda_0 = 1; they hold only on the singular surface.
    psi, *_ = np.linalg.lstsq(matrix[:, :n], -matrix[:, n], rcond=1e-9)
    residual = np.max(np.abs(matrix[:, :n] @ psi + matrix[:, n]))
    if residual > 1e-7 * (1 + np.max(np.abs(matrix))):
        return False
    control = flow.functions["control"](np.concatenate([end, psi]), 1.0)
    leaving = ca.Function(
        "leaving", [numeric.x, numeric.u], [ca.jtimes(numeric.target, numeric.x, numeric.field)]
    )
    if np.max(np.abs(leaving(end, control).full())) > 1e-7 * (1 + np.max(np.abs(end))):
        return False
    u = float(control.full()[j, 0])
    width = numeric.upper[j] - numeric.lower[j]
    return numeric.lower[j] + 1e-6 * width < u < numeric.upper[j] - 1e-6 * width


CHATTERING = Refusal(
    "chattering",
    "A bang arc cannot join a singular arc of even order: the switchings accumulate.",
    "Fuller 1963; McDanell and Powers 1971",
    (LINEAR_BETWEEN_BOUNDS,),
    Chattering,
    _refuse_chattering,
)
