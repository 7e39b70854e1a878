"""The control that maximises the Pontryagin function, in closed form (equation (5.5)).

Linear in u: a bound, by the sign of the switching function. Strictly concave in u: the stationary
point, clipped to the bounds. Otherwise the largest of the stationary points and the bounds, which
is found numerically.
"""

import sympy as sp


def maximising_control(derived):
    """Return {control: expression}, None where no closed form was found.

    An expression is a Piecewise or the stationary point. The Piecewise is nan on the zeros of a
    switching function, where the maximum condition does not determine the control.
    """
    curved = [u for u in derived.problem.control if u not in derived.switching]
    result = {u: _bang(derived, u) for u in derived.switching}
    stationary = _stationary(derived, curved)
    for u in curved:
        result[u] = _cut_off(derived, u, stationary.get(u)) if stationary else None
    return {u: result[u] for u in derived.problem.control}


def stationary_controls(derived, controls):
    """Return all solutions of dH/du = 0 as a list of dicts; empty if SymPy finds none."""
    equations = [sp.diff(derived.hamiltonian, u) for u in controls]
    if not all(_solvable(equation, controls) for equation in equations):
        return []
    try:
        return sp.solve(equations, controls, dict=True)
    except NotImplementedError:
        return []


def _solvable(equation, controls):
    """Check whether an equation is algebraic in the controls or of low degree in one function.

    Elsewhere (rates exp(-2500/u) and exp(-5000/u) of two reactions) SymPy may search for a closed
    form for minutes.
    """
    if equation.is_algebraic_expr(*controls):
        return True
    polynomial = sp.Poly(sp.numer(sp.together(equation)))
    functions = [g for g in polynomial.gens if g.has(*controls)]
    return len(functions) == 1 and polynomial.degree(functions[0]) <= 4


def _bang(derived, u):
    low, high = derived.problem.controls[u]
    if low == -sp.oo and high == sp.oo:
        return None
    slope = derived.switching[u]
    return sp.Piecewise((high, slope > 0), (low, slope < 0), (sp.nan, True))


def _stationary(derived, curved):
    if not curved:
        return {}
    solutions = [s for s in stationary_controls(derived, curved) if len(s) == len(curved)]
    return {u: sp.factor(e) for u, e in solutions[0].items()} if len(solutions) == 1 else {}


def _cut_off(derived, u, point):
    """Clip the stationary point to the bounds, valid where H is strictly concave in u alone."""
    if point is None:
        return None
    curvature = sp.diff(derived.hamiltonian, u, 2).subs(
        derived.multiplier, sp.Symbol("lambda0", positive=True)
    )
    if not curvature.is_negative:
        return None
    low, high = derived.problem.controls[u]
    pieces = [(low, point < low)] if low != -sp.oo else []
    pieces += [(high, point > high)] if high != sp.oo else []
    return sp.Piecewise(*pieces, (point, True)) if pieces else point
