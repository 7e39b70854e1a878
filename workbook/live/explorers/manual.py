"""A control set by hand against the optimal one: the oscillator of problem 5.16."""

from dataclasses import replace

import numpy as np
import sympy as sp

from workbook.display import Explorer
from workbook.live.explorers.built_once import built_once
from workbook.live.worked_problem import WorkedProblem

DURATION = 2 * sp.pi
#: Intervals in which the control is constant, and steps in each.
PIECES, STEPS = 8, 30


@built_once
def manual_control():
    """Set u(t) in eight intervals and compare the final energy with that of the optimal control.

    The mass of problem 5.16 b starts from x = 3 at rest, |u| <= 1; here the process lasts a whole
    period, 2 pi. `best_arcs=1` shows the optimal control and its trajectory.
    """
    problem = replace(WorkedProblem("5.16").data["half_period"], duration=DURATION)
    optimum = problem.solve()
    (bounds,) = problem.controls.values()
    levels = sp.symbols(f"u1:{PIECES + 1}")
    x, v, n, t, best_x, best_v, best_u, shown, energy = sp.symbols(
        "x v n t best_x best_v best_u best_arcs energy"
    )
    figure = Explorer(
        "Which control gives the oscillator the greatest energy after a period?",
        "A control that is constant in eight intervals, and the trajectory of the oscillator.",
    )
    for level in levels:
        figure.parameter(level, 0, bounds)
    figure.parameter(shown, 0, (0, 1), "the best arcs", step=1)
    u = sp.Piecewise(*((level, n <= k * STEPS) for k, level in enumerate(levels, 1)), (0, True))
    step = DURATION / (PIECES * STEPS)
    cosine, sine = sp.cos(step).evalf(), sp.sin(step).evalf()
    # the state turns about (u, 0)
    motion = figure.recursion(
        [x, v],
        [u + (x - u) * cosine + v * sine, v * cosine - (x - u) * sine],
        problem.initial.values(),
        PIECES * STEPS,
    )
    motion.last(energy, (x**2 + v**2) / 2)
    times = np.linspace(0, optimum.duration, PIECES * STEPS + 1)
    best = figure.table(
        {
            t: times,
            best_x: [optimum.state(time)[0] for time in times],
            best_v: [optimum.state(time)[1] for time in times],
            best_u: [optimum.control(time)[0] for time in times],
        }
    )

    def if_shown(value):
        return sp.Piecewise((value, shown > 0.5), (sp.nan, True))

    low, high = bounds
    control = figure.panel("t", "u", (0, float(DURATION)), (1.25 * low, 1.25 * high), height=0.8)
    for bound in bounds:
        control.segments([(0, bound), (DURATION, bound)], "thin")
    control.line(motion, n * step, u, "solid", "by hand")
    control.line(best, if_shown(t), best_u, "dashed", "the best arcs")
    for k, level in enumerate(levels):
        control.point((k + sp.Rational(1, 2)) * DURATION / PIECES, level)
    plane = figure.panel("x1", "x2", (-7.5, 7.5), (-7.5, 7.5))
    plane.line(motion, x, v, "solid", "by hand")
    plane.line(best, if_shown(best_x), best_v, "dashed", "the best arcs")
    figure.sentence(
        (shown < 0.5, "Energy at the end: {energy} by hand."),
        (True, "Energy at the end: {energy} by hand, " + f"{-optimum.cost:.2f} is the best."),
    )
    return figure
