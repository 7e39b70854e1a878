"""Time-optimal synthesis of problem 5.8: the oscillator to a circle whose radius is changed."""

import sympy as sp

from workbook.display import Explorer
from workbook.live.explorers.built_once import built_once

X_RANGE, Y_RANGE, RADII = (-6, 6), (-3.6, 3.6), (0.3, 4)
#: Time step of the motion, and the number of its steps.
STEP, STEPS = 0.05, 420


@built_once
def circle_synthesis():
    """Show the oscillator to the circle of radius R in minimum time, from a point that is moved.

    R is between 0.3 and 4; the region with u = 1 is filled. Inside the circle there is a dispersal
    curve for R <= 2; for larger R two semicircles are crossed (solution of 5.8). The figure uses
    the control laws of the solution, since computing a synthesis takes seconds.
    """
    x1, x2, R, angle, w1, w2, u, time, inside, duration = sp.symbols(
        "x1 x2 R angle w1 w2 u time inside duration", real=True
    )
    figure = Explorer(
        "5.8: where does the optimal control change, outside the circle and inside it?",
        "The plane of the oscillator with a circle, the region with u = 1, and the motion from a "
        "point to the circle in minimum time.",
    )
    figure.parameter(x1, -4, X_RANGE)
    figure.parameter(x2, 2, Y_RANGE)
    figure.parameter(R, 1, RADII)
    figure.quantity(inside, sp.Piecewise((1, x1**2 + x2**2 < R**2), (0, True)))
    arrived = sp.Or(
        sp.And(inside > 0.5, w1**2 + w2**2 >= R**2), sp.And(inside < 0.5, w1**2 + w2**2 <= R**2)
    )
    # under a constant control the state turns about (u, 0); the law is evaluated once in a step
    turned = (
        u + (w1 - u) * sp.cos(STEP) + w2 * sp.sin(STEP),
        w2 * sp.cos(STEP) - (w1 - u) * sp.sin(STEP),
        control_law(w1, w2, R),
        time + STEP,
    )
    states = [w1, w2, u, time]
    motion = figure.recursion(
        states,
        [sp.Piecewise((old, arrived), (new, True)) for old, new in zip(states, turned)],
        [x1, x2, control_law(x1, x2, R), 0],
        STEPS,
    )
    motion.last(duration, time)
    around = figure.curve(angle, 0, 2 * sp.pi)
    plane = figure.panel("w1", "w2", X_RANGE, Y_RANGE, height=0.6)
    plane.names = ("x₁", "x₂")
    plane.region(control_law(w1, w2, R) > 0, "u = 1")
    plane.line(around, R * sp.cos(angle), R * sp.sin(angle), "dashed", "circle")
    plane.line(motion, w1, w2, "solid", "fastest motion")
    plane.point(x1, x2, "initial state")
    figure.sentence((True, "From this point the circle is reached after t = {duration}."))
    return figure


def control_law(x1, x2, R):
    """Return the optimal control at a point outside or inside the circle of radius R.

    On the switching curves it is 1.
    """

    def root(value):
        return sp.sqrt(sp.Max(value, 0))

    def sign(value):
        return sp.Piecewise((-1, value < 0), (1, True))

    r = sp.sqrt(x1**2 + x2**2)
    distance = sp.Abs(x1) - R
    semicircle = root(1 - (distance - 2 * sp.floor(distance / 2) - 1) ** 2)
    outside = sp.Piecewise(
        (-sign(x2 + sign(x1) * semicircle), distance > 0),
        (-sign(x2), True),
    )
    rho = R - 2 * sp.floor((R - r) / 2)
    gain = (rho**2 - r**2) / 2
    inside = sp.Piecewise(
        (sign(x2 - x1 * root(gain / (2 - gain))), rho <= 2),
        (sign(x2 - sign(x1) * root(1 - (sp.Abs(x1) - rho + 1) ** 2)), sp.Abs(x1) > rho - 2),
        (sign(x2), True),
    )
    return sp.Piecewise((outside, r > R), (inside, True))
