"""What a planar synthesis is asked for, read and checked: the plant, the target, the window."""
import numpy as np
import sympy as sp

from ..statement import Problem
from .fan import Plant, stacked
from .terminal_sets import CurveTarget, PointTarget


def read_window(window):
    try:
        window = tuple((float(low), float(high)) for low, high in window)
    except (TypeError, ValueError):
        raise ValueError(f"window: expected ((left, right), (bottom, top)), got {window!r}") from None
    if len(window) != 2 or not all(np.isfinite(pair).all() and pair[0] < pair[1] for pair in window):
        raise ValueError(f"window: expected ((left, right), (bottom, top)) with left < right and bottom < top, got "
                         f"{window}")
    return window


def positive(value, name):
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected a positive number, got {value!r}") from None
    if not (np.isfinite(number) and number > 0):
        raise ValueError(f"{name}: expected a positive finite number, got {value}")
    return number


def read_plant(problem):
    if not isinstance(problem, Problem):
        raise TypeError(f"problem: expected a Problem, got {type(problem).__name__}")
    if len(problem.state) != 2 or len(problem.control) != 1:
        raise ValueError(f"problem: a planar synthesis needs two states and one control, this problem has "
                         f"{len(problem.state)} and "
                         f"{len(problem.control)}")
    if not problem.time_optimal or problem.maximise:
        raise ValueError("problem: a synthesis is made for the least time; expected running=1, final=0 and a free "
                         "final time")
    # The start is not used, so that its parameters need no values.
    used = set().union(*(e.free_symbols for e in (*problem.field, *problem.controls[problem.control[0]],
                                                  *problem.terminal)))
    left = used - set(problem.state) - set(problem.control)
    if left:
        raise ValueError(f"problem: no value for {', '.join(sorted(map(str, left)))}; use problem.subs({{...}}) first")
    u = problem.control[0]
    if any(sp.simplify(f.diff(u, 2)) != 0 for f in problem.field):
        raise ValueError(f"problem: the right-hand side is not affine in {u}")
    low, high = problem.controls[u]
    if not (low.is_finite and high.is_finite and low < high):
        raise ValueError(f"problem: expected finite bounds {u}_- < {u}_+, got ({low}, {high})")
    plant = Plant(problem.field, problem.state, u, (low, high))
    if plant.singular == 0:
        raise ValueError("problem: det(f1, [f0, f1]) vanishes everywhere, so extremals may be singular along their "
                         "whole length; "
                         "for a linear system: the pair (A, b) is not controllable")
    return plant


def read_target(problem, sides, box, curve):
    if len(problem.terminal) == 2:
        points = sp.solve(problem.terminal, problem.state, dict=True)
        points = [p for p in points if len(p) == 2 and all(v.is_real for v in p.values())]
        if len(points) != 1:
            raise ValueError(f"terminal: two equations have to fix one point, these have {len(points)} real solutions")
        if curve is not None:
            raise ValueError("curve: the target is a point")
        return PointTarget([points[0][s] for s in problem.state])
    if len(problem.terminal) != 1:
        raise ValueError("terminal: expected one equation (a curve) or two (a point)")
    g = problem.terminal[0]
    raw, gradient = stacked(problem.state, [g]), stacked(problem.state, [g.diff(s) for s in problem.state])
    return CurveTarget(lambda *x: raw(*x)[0], gradient, sides, box, _read_curve(curve))


def _read_curve(curve):
    if curve is None:
        return None
    try:
        (x1, x2), (s, low, high) = curve
        low, high = float(low), float(high)
        x1, x2 = sp.sympify(x1), sp.sympify(x2)
    except (TypeError, ValueError, sp.SympifyError):
        raise ValueError(f"curve: expected ((x1(s), x2(s)), (s, low, high)), got {curve!r}") from None
    if not (isinstance(s, sp.Symbol) and low < high and (x1.free_symbols | x2.free_symbols) <= {s}):
        raise ValueError("curve: expected two expressions in one symbol s with numbers for everything else, and low < "
                         "high")
    point = stacked([s], [x1, x2])
    return point, low, high


def greatest_rate(problem, window):
    """The greatest norm of df/dx in the window: the steps have to follow the fastest motion."""
    u = problem.control[0]
    jacobian = sp.Matrix(problem.field).jacobian(problem.state)
    value = stacked([*problem.state, u], list(jacobian))
    x, y = (v.ravel() for v in np.meshgrid(*(np.linspace(*pair, 15) for pair in window)))
    with np.errstate(all="ignore"):
        entries = [np.abs(value(x, y, np.full(x.shape, float(bound)))) for bound in problem.controls[u]]
        rates = [np.maximum(e[0] + e[1], e[2] + e[3]) for e in entries]
    rates = np.concatenate(rates)
    return float(np.max(rates[np.isfinite(rates)], initial=0))

