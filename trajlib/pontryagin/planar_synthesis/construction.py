"""Planar synthesis by backward integration of extremals from the target.

For the least (or greatest) phi_0(x(t_k)) + int f_0(x, u) dt, the final time being free, at a point
or on a smooth curve g(x) = 0, the maximum principle leaves one-parameter families of extremals:
they end on the target with a covector that transversality and H = 0 determine (`terminal_sets`).
Integrated backwards their controls change where H asks for another level (`plant`); they are given
up where they meet the target again (the process ends at the first hit) and where another extremal
is better. The remaining ones are the synthesis:

    switching curve    where a control of optimal trajectories changes its level,
    dispersal curve    where two extremals of equal cost start: beyond it the other one is better,
    barrier            an extremal, mostly one that touches the target, across which the least cost jumps.

Extremals with singular arcs are not searched for. They need det(F, F_j, [F, F_j]) = 0 for the
fields with the cost as a third state, which is det(f1, [f0, f1]) for the least time: where this is
possible, `regularity()` reports it, and for other costs such a problem is refused if an admissible
control can follow an arc. A control whose switching function can vanish only for good is open
there, and its possible values are shown by the trajectories that hold it at one value.

Source: chapter 5 of the problem book (worked example 2, figure 5.1); V. G. Boltyansky's regular
synthesis.
"""

import numpy as np

from trajlib.pontryagin.planar_synthesis.arguments import (
    TerminalCost,
    greatest_rate,
    read_plant,
    read_positive,
    read_target,
    read_window,
    refuse_singular_arcs,
)
from trajlib.pontryagin.planar_synthesis.curves import Curve
from trajlib.pontryagin.planar_synthesis.dispersal import dispersal_curves, find_overtakings
from trajlib.pontryagin.planar_synthesis.fan import Fan
from trajlib.pontryagin.planar_synthesis.fan_filling import fill, held_fans, single_extremal
from trajlib.pontryagin.planar_synthesis.plant import Plant
from trajlib.pontryagin.planar_synthesis.switching_curves import switching_curves
from trajlib.pontryagin.planar_synthesis.synthesis import Synthesis
from trajlib.pontryagin.planar_synthesis.terminal_sets import Transversality, end_families
from trajlib.pontryagin.planar_synthesis.value_function import ValueFunction
from trajlib.pontryagin.problem.statement import Statement

SIDES = {"both": (1, -1), "positive": (1,), "negative": (-1,), "outside": (1,), "inside": (-1,)}


def synthesis(
    problem: Statement,
    *,
    window: tuple = ((-3, 3), (-3, 3)),
    horizon: float = 6.0,
    side: str = "both",
    curve: tuple | None = None,
) -> Synthesis:
    """Compute the optimal synthesis of a planar system with bounded controls.

    Parameters
    ----------
    problem : Problem
        Two states, a free final time and numbers for all parameters; two terminal equations (a
        point) or one (a smooth curve), at which the process ends when it first meets it. The
        initial state is not used. The cost may be the time or another one, to be least or greatest:
        the dynamics are linear in the controls, the running cost is of the second degree in each,
        with multiples of |u|, without products of two; the bounds are finite.
    window : tuple, optional
        ((left, right), (bottom, top)) in the phase plane.
    horizon : float, optional
        The longest duration of a process, in the unit of time of the dynamics.
    side : str, optional
        For a curve, the side from which it is met: "positive" or "negative" by the sign of the
        terminal expression ("outside", "inside" are synonyms for closed curves), or "both".
    curve : tuple, optional
        ((x1(s), x2(s)), (s, low, high)), a parametrisation of the terminal curve in SymPy, to which
        `reached` then refers. Without it the curve is traced and the parameter is its length.

    Returns
    -------
    Synthesis
        Optimal cost, time and control in the window, and the curves on which they change.

    Raises
    ------
    TypeError, ValueError
        For a problem of another kind (a given duration, for which the law depends on the remaining
        time; a running cost that is not positive at a target point; singular arcs that would have
        to be part of it), and where no extremal ends on the target.

    Notes
    -----
    Source: chapter 5 of the problem book (worked example 2, figure 5.1).

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x1, x2, u = sp.symbols("x1 x2 u")
    >>> plant, bounds, anywhere = {x1: x2, x2: u}, {u: (-1, 1)}, {x1: None, x2: None}
    >>> to_rest = Problem(plant, bounds, anywhere, terminal=[x1, x2])
    >>> fastest = synthesis(to_rest, window=((-2, 2), (-2, 2)))
    >>> round(float(fastest.time(1, 0)), 9), float(fastest.control(1, 0)), float(fastest.control(-1, 0))
    (2.0, -1.0, 1.0)
    >>> saving = Problem(plant, bounds, anywhere, terminal=[x1, x2], running=1 + u**2/2)
    >>> cheapest = synthesis(saving, window=((-2, 2), (-2, 2)))
    >>> round(float(cheapest.cost(1, 0))**2, 9), cheapest.level(1, 0), cheapest.level(1, -1)
    (7.666666667, 'u-', 'interior')
    """
    window = read_window(window)
    horizon = read_positive(horizon, "horizon")
    plant = Plant(problem, read_plant(problem))
    if side not in SIDES:
        raise ValueError(f"side: expected one of {', '.join(map(repr, SIDES))}, got {side!r}")
    # extremals may leave the window for a while
    box = tuple((3 * low - 2 * high, 3 * high - 2 * low) for low, high in window)
    target, final = read_target(problem, SIDES[side], box, curve), TerminalCost(problem)
    refuse_singular_arcs(problem, plant, window)
    steps = int(
        np.clip(np.ceil(max(100, horizon * greatest_rate(problem, window) / 0.12)), 100, 1200)
    )

    fans, arcs, touches = [], [], []
    for sigma in target.sides:
        transversality = Transversality(target, plant, final, sigma)
        ends, touching = end_families(transversality)
        touches += [
            single_extremal(transversality, touch, horizon, steps, box) for touch in touching
        ]
        for family in ends:
            fan = Fan(plant, target, family, horizon, steps, box)
            fill(fan, window)
            if (fan.last_step > 0).any():
                arcs.append(family)
            fans += [
                filled for filled in (fan, *held_fans(fan, window)) if (filled.last_step > 0).any()
            ]
    if not fans:
        raise ValueError(
            "terminal: no extremal ends on this target: no admissible velocity crosses it towards "
            "the side asked for"
        )
    value_function = ValueFunction(fans, window)
    dispersal = dispersal_curves(
        np.hstack([find_overtakings(fan, value_function) for fan in fans]), value_function
    )
    return Synthesis(
        problem,
        window,
        horizon,
        switching_curves(fans, window),
        dispersal,
        _reached(arcs) if target.sides != (0,) else [],
        target,
        value_function,
        touches,
        lambda x: final.value(*x)[0],
    )


def _reached(families_):
    """Return the parts of the target at which optimal trajectories end, where w > 0."""
    arcs = []
    for family in families_:
        s = np.linspace(family.low, family.high, 201)
        arcs.append(Curve(family.point(s).T, np.zeros(s.size), parameter=(family.low, family.high)))
    return arcs
