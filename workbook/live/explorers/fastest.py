"""The time-optimal motion of the double integrator from a point that is moved, with its costate."""

import sympy as sp

from workbook.display import Explorer
from workbook.live.explorers.built_once import built_once

#: Ranges of position, speed and time; seconds in which the button goes through a motion.
POSITIONS, SPEEDS, TIMES, SECONDS = (-2.5, 2.5), (-2, 2), (0, 7), 6


@built_once
def fastest_motion():
    """Show the fastest motion of problem 5.3 a, x1' = x2, x2' = u, |u| <= 1, to the origin.

    Left: the switching curve x1 = -x2 |x2|/2 and the motion from a point that is moved. Right: the
    costate psi2, whose sign is the control, scaled so that its largest modulus is one.
    """
    x1, x2, share, first, top, switch, end, now, u, t, w = sp.symbols(
        "x1 x2 share first top switch end now u t w", real=True
    )
    figure = Explorer(
        "Where is the sign of the control changed?",
        "The motion from a point to the origin in minimum time, the switching curve, and beside "
        "them the costate and the control as functions of the time.",
    )
    figure.parameter(x1, 1, POSITIONS)
    figure.parameter(x2, 0.8, SPEEDS)
    figure.parameter(share, 0, (0, 1), "elapsed part of the time", play=SECONDS)
    above = x1 + x2 * sp.Abs(x2) / 2 > 0
    figure.quantity(first, sp.Piecewise((-1, above), (1, True)))
    figure.quantity(top, sp.sqrt(sp.Max(x2**2 / 2 - first * x1, 0)))
    figure.quantity(switch, top - first * x2)
    figure.quantity(end, switch + top)
    figure.quantity(now, share * end)
    figure.quantity(u, sp.Piecewise((first, now < switch), (-first, True)))

    def state(time):
        before, after = sp.Min(time, switch), sp.Max(time - switch, 0)
        speed = x2 + first * (before - after)
        position = x1 + x2 * before + first * before**2 / 2
        return position + (x2 + first * switch) * after - first * after**2 / 2, speed

    motion, speeds = figure.curve(t, 0, end), figure.curve(w, *SPEEDS)
    plane = figure.panel("x1", "x2", POSITIONS, SPEEDS, height=0.8)
    plane.line(speeds, -w * sp.Abs(w) / 2, w, "dashed", "switching curve")
    plane.line(motion, *state(t), "solid", "fastest motion")
    plane.point(*state(now))
    plane.point(x1, x2, "initial state")
    over_time = figure.panel("t", "", TIMES, (-1.3, 1.3), height=0.8)
    over_time.line(motion, t, first * (switch - t) / sp.Max(switch, top, 1e-9), "solid", "ψ₂")
    over_time.line(
        motion, t, sp.Piecewise((first, t < switch), (-first, True)), "dotted", "control u"
    )
    over_time.segments([(now, -1.3), (now, 1.3)], "thin", "now")
    figure.sentence(
        (
            True,
            "The minimum time is {end}, with a switching at t = {switch}; at t = {now} the control "
            "is {u}.",
        )
    )
    return figure
