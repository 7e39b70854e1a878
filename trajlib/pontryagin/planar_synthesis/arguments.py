"""The arguments of a planar synthesis, read and checked: plant, target, window."""

from itertools import product

import numpy as np
import sympy as sp

from trajlib.pontryagin.planar_synthesis.array_functions import array_function
from trajlib.pontryagin.planar_synthesis.control_terms import ControlTerm
from trajlib.pontryagin.planar_synthesis.terminal_sets import CurveTarget, PointTarget
from trajlib.pontryagin.problem.statement import Statement


def read_window(window):
    """Return the window as two pairs of floats. Raises ValueError if it is not of that form."""
    try:
        window = tuple((float(low), float(high)) for low, high in window)
    except (TypeError, ValueError):
        raise ValueError(
            f"window: expected ((left, right), (bottom, top)), got {window!r}"
        ) from None
    if len(window) != 2 or not all(
        np.isfinite(pair).all() and pair[0] < pair[1] for pair in window
    ):
        raise ValueError(
            "window: expected ((left, right), (bottom, top)) with left < right and bottom < top, "
            f"got {window}"
        )
    return window


def read_positive(value, name):
    """Return a positive finite float. Raises TypeError or ValueError for anything else."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected a positive number, got {value!r}") from None
    if not (np.isfinite(number) and number > 0):
        raise ValueError(f"{name}: expected a positive finite number, got {value}")
    return number


def read_plant(problem: Statement) -> list[ControlTerm]:
    """Return the term of H for each control. Raises TypeError or ValueError for other problems."""
    if not isinstance(problem, Statement):
        raise TypeError(f"problem: expected a Problem, got {type(problem).__name__}")
    if len(problem.state) != 2:
        raise ValueError(
            f"problem: a planar synthesis needs two states, this problem has {len(problem.state)}"
        )
    if problem.constrained or problem.bounds_depend_on_state:
        raise ValueError(
            "problem: a planar synthesis is computed for constant bounds of the controls, without "
            "inequalities along the path or at the end"
        )
    if problem.duration is not None:
        raise ValueError(
            "duration: with a given duration the optimal law depends on the time that is left, so "
            "that it is no feedback in the plane of the states; leave the duration free, or use "
            "solve() for the process from one start"
        )
    # The initial state is not used, so that its parameters need no values.
    bounds = [b for pair in problem.controls.values() for b in pair]
    used = set().union(
        *(
            e.free_symbols
            for e in (*problem.field, *bounds, *problem.terminal, problem.running, problem.final)
        )
    )
    unbound = used - set(problem.state) - set(problem.control)
    if unbound:
        raise ValueError(
            f"problem: no value for {', '.join(sorted(map(str, unbound)))}; use problem.subs({{...}}) "
            "first"
        )
    cost = -problem.running if problem.maximise else problem.running
    return [ControlTerm(problem, cost, u) for u in problem.control]


class TerminalCost:
    """The terminal cost with the sign of a minimum: `value`, (1, N), and `gradient`, (2, N)."""

    def __init__(self, problem):
        cost = -problem.final if problem.maximise else problem.final
        self.value = array_function(problem.state, [cost])
        self.gradient = array_function(problem.state, [cost.diff(x) for x in problem.state])


def refuse_singular_arcs(problem, plant, window):
    """Raise ValueError where an admissible control can follow det(F, F_j, [F, F_j]) = 0."""
    x, y = (v.ravel() for v in np.meshgrid(*(np.linspace(*pair, 121) for pair in window)))
    for term in plant.terms:
        drift = sp.Matrix(problem.field).subs(dict.fromkeys(problem.control, 0))
        for det in term.singular:
            slope = sp.Matrix([det.diff(s) for s in problem.state])
            values = array_function(
                problem.state, [det, (slope.T * drift)[0], (slope.T * term.input_field)[0]]
            )(x, y)
            with np.errstate(all="ignore"):
                u = -values[1] / values[2]
            sign = np.sign(values[0]).reshape(121, 121)
            close = np.zeros(sign.shape, bool)
            close[:, 1:] |= sign[:, 1:] * sign[:, :-1] <= 0
            close[1:] |= sign[1:] * sign[:-1] <= 0
            room = 0.05 * float(term.high - term.low)
            inside = (u > float(term.low) + room) & (u < float(term.high) - room)
            if (inside & close.ravel()).sum() > 3:
                raise ValueError(
                    f"problem: where {sp.simplify(det)} = 0 a motion could be singular in "
                    f"{term.u}, and a synthesis without singular arcs would be wrong; solve() "
                    "finds processes with such arcs from one start"
                )


def read_target(problem: Statement, sides, box, curve) -> PointTarget | CurveTarget:
    """Return the target of a problem: a point or a curve."""
    if len(problem.terminal) == 2:
        points = sp.solve(problem.terminal, problem.state, dict=True)
        points = [p for p in points if len(p) == 2 and all(v.is_real for v in p.values())]
        if len(points) != 1:
            raise ValueError(
                f"terminal: two equations have to fix one point, these have {len(points)} real "
                "solutions"
            )
        if curve is not None:
            raise ValueError("curve: the target is a point")
        point = [points[0][s] for s in problem.state]
        _refuse_free_rest(problem, dict(zip(problem.state, point)))
        return PointTarget(point)
    if len(problem.terminal) != 1:
        raise ValueError("terminal: expected one equation (a curve) or two (a point)")
    g = problem.terminal[0]
    raw, gradient = (
        array_function(problem.state, [g]),
        array_function(problem.state, [g.diff(s) for s in problem.state]),
    )
    return CurveTarget(lambda *x: raw(*x)[0], gradient, sides, box, _read_curve(curve))


def _refuse_free_rest(problem, point):
    """Raise ValueError if time costs nothing at a target point."""
    cost = sp.expand((-problem.running if problem.maximise else problem.running).subs(point))
    values = array_function(problem.control, [cost])(
        *np.meshgrid(
            *(np.linspace(float(low), float(high), 41) for low, high in problem.controls.values())
        )
    )
    if not (values > 0).all():
        turned = "with the opposite sign, for a maximum; " if problem.maximise else ""
        raise ValueError(
            f"running: it has to be positive at a target point ({turned}there it is {cost}): where "
            "a moment costs nothing, controls may switch infinitely often, or the best process is "
            "not attained; solve() says which"
        )


def _read_curve(curve):
    """Return (function of s, low, high) of a parametrised curve."""
    if curve is None:
        return None
    try:
        (x1, x2), (s, low, high) = curve
        low, high = float(low), float(high)
        x1, x2 = sp.sympify(x1), sp.sympify(x2)
    except (TypeError, ValueError, sp.SympifyError):
        raise ValueError(
            f"curve: expected ((x1(s), x2(s)), (s, low, high)), got {curve!r}"
        ) from None
    if not (isinstance(s, sp.Symbol) and low < high and (x1.free_symbols | x2.free_symbols) <= {s}):
        raise ValueError(
            "curve: expected two expressions in one symbol s with numbers for everything else, "
            "and low < high"
        )
    point = array_function([s], [x1, x2])
    return point, low, high


def greatest_rate(problem: Statement, window) -> float:
    """Return the greatest norm of df/dx in the window, by which the steps are chosen."""
    jacobian = sp.Matrix(problem.field).jacobian(problem.state)
    value = array_function([*problem.state, *problem.control], list(jacobian))
    x, y = (v.ravel() for v in np.meshgrid(*(np.linspace(low, high, 15) for low, high in window)))
    rates = []
    with np.errstate(all="ignore"):
        for bounds in product(*problem.controls.values()):
            e = np.abs(value(x, y, *(np.full(x.shape, float(bound)) for bound in bounds)))
            rates.append(np.maximum(e[0] + e[1], e[2] + e[3]))
    values = np.concatenate(rates)
    return float(np.max(values[np.isfinite(values)], initial=0))
