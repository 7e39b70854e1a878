"""Boundary arcs of state constraints: conditions where they begin, control and multiplier.

Along the arc psi' = -dH/dy + eta dg/dy. Where H is concave in the control, it is a component of the
flow as on an interior arc; g and its derivatives up to the order 2p-1 along this flow are conditions
where the arc begins, and that of order 2p contains eta. Where H is linear in the control, g^(p) = 0
is solved for it; g, ..., g^(p-1) and dH/du with its derivatives up to the order p-1 are the
conditions, and that of order p contains eta.
"""

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.problem.errors import WrongStructure


def boundary_control(numeric, constraint, i, control):
    """Return (g, ..., g^(p-1)) and the control i, in which H is linear, from g^(p) = 0.

    `control`: the controls of the arc, of which the others enter g^(p).
    """
    derivatives = [numeric.path[constraint]]
    for _ in range(numeric.path_orders[constraint]):
        derivatives.append(ca.jtimes(derivatives[-1], numeric.x, numeric.field))
    u, highest = numeric.u[i], derivatives.pop()
    value = -ca.substitute(highest, u, 0) / ca.substitute(ca.jacobian(highest, u), u, 0)
    return derivatives, ca.substitute(value, numeric.u, control)


def boundary_conditions(flow, expression, count):
    """Return `count` derivatives of an expression that vanish on the arc, and eta.

    `flow.rate_with(eta)` is y' for a multiplier. Raises `WrongStructure` if another derivative than
    that of order `count` is the first to contain eta.
    """
    eta = ca.SX.sym("eta")
    rate = flow.rate_with(eta)
    derivatives = [expression]
    for _ in range(count):
        derivatives.append(ca.jtimes(derivatives[-1], flow.y, rate))
        if len(derivatives) <= count and _occurs(flow, eta, derivatives[-1]):
            break
    highest = derivatives.pop()
    factor = ca.jacobian(highest, eta)
    if len(derivatives) < count or not _occurs(flow, eta, highest):
        g = flow.numeric.problem.path[flow.boundary]
        raise WrongStructure(
            f"the boundary arc of {g} with the controls {', '.join(flow.kinds)}: the conditions on "
            "it do not determine its multiplier"
        )
    without = [ca.substitute(d, eta, 0) for d in derivatives]
    return without, -ca.substitute(highest, eta, 0) / ca.substitute(factor, eta, 0)


def _occurs(flow, eta, expression):
    """Check whether eta occurs, by the values of the derivative by it at fixed points."""
    if not ca.which_depends(expression, eta)[0]:
        return False
    numeric, random = flow.numeric, np.random.default_rng(0)
    factor = ca.Function(
        "factor", [flow.y, numeric.multiplier, eta], [ca.jacobian(expression, eta)]
    )
    centre = np.concatenate(
        [numeric.assumed_start, np.zeros(numeric.n), numeric.middle()[flow.interior]]
    )
    values = [
        abs(float(factor(centre + 0.3 * random.standard_normal(flow.size), 1.0, 0.0)))
        for _ in range(4)
    ]
    return not max(values) < 1e-9
