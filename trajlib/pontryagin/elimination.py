"""The motion of a control inside its bounds, with the costates eliminated.

Where H is greatest inside the bounds, H_u = 0 all the time, and so is its derivative along the motion and the adjoint
equations: u' = -(derivative of H_u for a fixed u)/H_uu. If one costate that enters is not known from the end of the
process, H_u = 0 expresses it by the state and the control; if two are, and nothing stands beside them, it tells their
ratio, which is enough.
"""

import sympy as sp


def control_field(conditions):
    """{control: u', state: ...}: the equation of the control, and those of the states that enter it, in their order."""
    problem, H = conditions.problem, conditions.hamiltonian.subs(conditions.multiplier, 1)
    if len(problem.control) != 1:
        raise ValueError("problem: the costates are eliminated for problems with one control")
    u = problem.control[0]
    known = _known(conditions)
    slope = sp.diff(H, u)
    drift = sum((sp.diff(slope, y)*f for y, f in problem.dynamics.items()), sp.S.Zero)
    drift += sum((sp.diff(slope, psi)*rate.subs(conditions.multiplier, 1) for psi, rate in conditions.adjoint.items()),
                 sp.S.Zero)
    slope, drift, bend = (sp.expand(e.subs(known)) for e in (slope, drift, sp.diff(slope, u)))
    free = [psi for psi in conditions.costate if any(e.has(psi) for e in (slope, drift, bend))]
    rest, gains = slope.subs(dict.fromkeys(free, 0)), [sp.diff(slope, psi) for psi in free]
    if len(free) == 2 and rest == 0:
        values = {free[0]: gains[1], free[1]: -gains[0]}
    elif len(free) == 1:
        values = {free[0]: -rest/gains[0]}
    elif not free:
        values = {}
    else:
        raise ValueError(f"problem: {len(free)} costates are not known from the end of the process, and the condition "
                         "H_u = 0 does not eliminate them")
    rate = -sp.simplify(drift.subs(values))/sp.simplify(bend.subs(values))
    field = {u: sp.expand(sp.trigsimp(sp.simplify(rate)))}
    met = {y for y in problem.dynamics if field[u].has(y)}
    while more := {y for y in problem.dynamics if y not in met and any(problem.dynamics[z].has(y) for z in met)}:
        met |= more
    return field | {y: f for y, f in problem.dynamics.items() if y in met}


def _known(conditions):
    """Costates that do not change, with the values that the end gives them."""
    ends = [e.subs(conditions.multiplier, 1) for e in conditions.reduced_transversality]
    return {psi: psi - e for psi in conditions.costate if conditions.adjoint[psi] == 0
            for e in ends if sp.diff(e, psi) == 1 and not (psi - e).free_symbols}
