"""Test problems of optimal control: statement, arcs, times and cost by two routes, source, prints.

The first route is `Problem.solve`; the second stands with each record: a closed form, or SciPy's
integrator with the conditions written out by hand. The tests of the library compare both. Nothing
here is a test. Run as a script it writes the data file of `trajlib.pontryagin.registry`.
"""

import itertools
import json
from functools import cache
from pathlib import Path

import numpy as np
import sympy as sp
from classical_control_records import CLASSICAL
from control_record import Record
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve, minimize, minimize_scalar

from trajlib.pontryagin import Problem

R = sp.Rational
x, y, v, w, t, h, m, u, theta, a, b, c, k = sp.symbols("x y v w t h m u theta a b c k")
x1, x2, x3, x4, x5, x6, u1, u2, u3 = sp.symbols("x1:7 u1:4")


def bryson_denham(limit):
    """x'' = u, x <= limit: touch point for 1/6 <= limit <= 1/4, boundary arc [3 limit, 1 - 3 limit] below."""
    touches = bool(limit >= R(1, 6))
    cost = 2 + 6 * (1 - 4 * limit) ** 2 if touches else 4 / (9 * limit)
    return Record(
        Problem(
            {x: v, v: u},
            {u: None},
            {x: 0, v: 1},
            {x: 0, v: -1},
            running=u**2 / 2,
            duration=1,
            path=[x <= limit],
        ),
        ["interior"] * (1 + bool(limit < R(1, 4)))
        if touches
        else ["interior", "boundary", "interior"],
        ([R(1, 2)] if limit < R(1, 4) else []) if touches else [3 * limit, 1 - 3 * limit],
        cost,
        "closed form: cubic splines",
        "Bryson, Denham and Dreyfus 1963; Bryson and Ho, Applied Optimal Control, 1975, pp. 120-123",
    )


def goddard_by_feedback(limit):
    """Full thrust, the singular surface, v = `limit` until the fuel is spent, coasting to rest.

    Without a limit the singular surface is followed until the fuel is spent.
    """
    exhaust = 0.5

    def drag(h, v):
        return 310 * v**2 * np.exp(-500 * (h - 1))

    def surface(_, z):
        return drag(z[0], z[1]) * (1 + z[1] / exhaust) - z[2] / z[0] ** 2

    def singular_thrust(z):
        """The thrust that keeps `surface` zero: its rate is linear in the thrust."""
        h, v, m = z
        D = drag(h, v)
        by_h = -500 * D * (1 + v / exhaust) + 2 * m / h**3
        by_v, by_m = 2 * D / v * (1 + v / exhaust) + D / exhaust, -1 / h**2
        return (by_v * (D / m + 1 / h**2) - by_h * v) / (by_v / m - by_m / exhaust)

    def empty(_, z):
        return z[2] - 0.6

    stages = [(lambda z: 3.5, surface)]
    if limit is None:
        stages += [(singular_thrust, empty)]
    else:
        stages += [
            (singular_thrust, lambda _, z: z[1] - limit),
            (lambda z: drag(z[0], limit) + z[2] / z[0] ** 2, empty),
        ]
    stages += [(lambda z: 0.0, lambda _, z: z[1])]
    z, time, times = np.array([1.0, 0.0, 1.0]), 0.0, []
    for thrust, end in stages:

        def rate(_, z, thrust=thrust):
            force = thrust(z)
            return [z[1], (force - drag(z[0], z[1])) / z[2] - 1 / z[0] ** 2, -force / exhaust]

        def stop(s, z, end=end):
            return end(s, z)

        stop.terminal = True
        run = solve_ivp(
            rate, (0, 1), z, events=stop, rtol=1e-13, atol=1e-15, method="DOP853", max_step=1e-3
        )
        z, time = run.y[:, -1], time + run.t[-1]
        times.append(time)
    return z[0], times


def goddard(limit=None, **arguments):
    drag = 310 * v**2 * sp.exp(-500 * (h - 1))
    cost, times = goddard_by_feedback(limit)
    return Record(
        Problem(
            {h: v, v: (R(7, 2) * u - drag) / m - 1 / h**2, m: -7 * u},
            {u: (0, 1)},
            {h: 1, v: 0, m: 1},
            [m - R(3, 5)],
            final=h,
            maximise=True,
            path=[] if limit is None else [v <= R(1, 10)],
        ),
        ["u+", "singular", *(["boundary"] if limit else []), "u-"],
        times[:-1],
        cost,
        "SciPy: the motion with the control of each arc as a feedback law",
        tolerance=1e-9,
        **arguments,
    )


def goddard_with_limit():
    return goddard(
        0.1,
        source="Goddard's rocket of the COPS collection with a speed limit; the problems of "
        "control-toolbox (Julia) print the times 0.02350968, 0.05973738, 0.10157134 and 0.2020474406",
    )


def goddard_without_limit():
    return goddard(
        source="Goddard's rocket of the COPS collection of Dolan and More",
        published=(("COPS", 1.01283, 1e-5),),
    )


def van_der_pol_singular():
    """u = -1, u = 1, then u = 2 x1 - x2 (1 - x1^2), for which psi_2 = 0 and psi_1 = x2."""

    def singular(z):
        return 2 * z[0] - z[1] * (1 - z[0] ** 2)

    def cost(lengths):
        z, ends = np.array([0.0, 1.0, 0.0]), [0, *np.cumsum(lengths), 4]
        for (begin, end), law in zip(
            itertools.pairwise(ends), (lambda z: -1.0, lambda z: 1.0, singular)
        ):

            def rate(_, z, law=law):
                energy = (z[0] ** 2 + z[1] ** 2) / 2
                return [z[1], -z[0] + z[1] * (1 - z[0] ** 2) + law(z), energy]

            z = path_of(rate, z, (begin, end)).y[:, -1]
        return z[2]

    options = {"xatol": 1e-8, "fatol": 1e-15}
    best = minimize(cost, [1.37, 1.1], method="Nelder-Mead", options=options)
    return Record(
        Problem(
            {x: v, v: -x + v * (1 - x**2) + u},
            {u: (-1, 1)},
            {x: 0, v: 1},
            running=(x**2 + v**2) / 2,
            duration=4,
        ),
        ["u-", "u+", "singular"],
        None,
        best.fun,
        "SciPy: least cost over the lengths of three arcs, the singular control as a feedback law",
        "bang-bang-singular control of the van der Pol oscillator; its first print was not found",
        published=(("digits from a secondary source", 0.7576179, 1e-7),),
    )


def rayleigh_fastest():
    """Arcs u = 1, -1, 1 to rest, the least time over the length of the first."""

    def end(lengths):
        z = np.array([-5.0, -5.0])
        for length, pull in zip(lengths, (1, -1, 1)):

            def rate(_, z, pull=pull):
                return [z[1], -z[0] + z[1] * (1.4 - 0.14 * z[1] ** 2) + 4 * pull]

            z = path_of(rate, z, (0, length)).y[:, -1]
        return z

    def duration(first):
        others = fsolve(lambda z: end([first, *z]), [2.2, 0.35], xtol=1e-13)
        return first + sum(others)

    best = minimize_scalar(duration, bracket=(1.0, 1.12, 1.2), tol=1e-9)
    return Record(
        Problem(
            {x: v, v: -x + v * (R(7, 5) - R(7, 50) * v**2) + 4 * u},
            {u: (-1, 1)},
            {x: -5, v: -5},
            [x, v],
        ),
        ["u+", "u-", "u+"],
        None,
        best.fun,
        "SciPy: least time over the lengths of three arcs that end at rest",
        "time-optimal Rayleigh oscillator; its first print was not found",
        published=(("digits from a secondary source", 3.66817, 1e-5),),
    )


def double_integrator(**arguments):
    return Problem({x: v, v: u}, {u: (-1, 1)}, {x: 0, v: 0}, **arguments)


def brachistochrone():
    """Cycloid, slope 1/2 of the line, cycloid to a horizontal end; each cusp is at rest height."""
    phi = 2 * np.arctan(2)
    high = 1 - np.cos(phi)
    first = 0.1 / (high - (phi - np.sin(phi)) / 2)
    last = 1.2 / (2 * high + np.pi - phi + np.sin(phi))
    speeds = [np.sqrt(2 * radius * high) for radius in (first, last)]
    along = np.sqrt(5) * (speeds[1] - speeds[0])
    entry = phi * np.sqrt(first)
    total = entry + along + (np.pi - phi) * np.sqrt(last)
    return Record(
        Problem(
            {x: v * sp.cos(theta), y: v * sp.sin(theta), v: sp.sin(theta)},
            {theta: (0, sp.pi / 2)},
            {x: 0, y: 0, v: 0},
            [x - 1],
            path=[y <= x / 2 + R(1, 10)],
        ),
        ["interior", "boundary", "interior"],
        [entry, entry + along],
        total,
        "closed form: two cycloids and a line between them",
        "Bryson and Ho, Applied Optimal Control, 1975",
    )


def path_of(rate, start, span, events=None):
    return solve_ivp(rate, span, start, events=events, rtol=1e-12, atol=1e-13, method="DOP853")


def first_order_contact(field, boundary_control, multiplier_free, gain, guess, start, T):
    """Cost by shooting: interior, boundary, interior arcs for a constraint of order one.

    `field(t, x, psi, u)`: (x', f_0, psi' without eta); u = `gain` psi_2 inside. Unknown are psi(0)
    and both junction times; on the boundary arc psi_2 = u_b/gain. `multiplier_free` is the distance
    from the boundary.
    """

    def inside(s, z):
        return field(s, z[:2], z[3:], gain * z[4])

    def on_boundary(s, z):
        control = boundary_control(s, z[:2])
        return field(s, z[:2], np.array([z[3], control / gain]), control)

    def run(unknown):
        entry, leaving = unknown[2:]
        first = path_of(inside, [*start, 0, *unknown[:2]], (0, entry)).y[:, -1]
        second = path_of(on_boundary, first, (entry, leaving)).y[:, -1]
        second[4] = boundary_control(leaving, second[:2]) / gain
        last = path_of(inside, second, (leaving, T)).y[:, -1]
        contact = [
            multiplier_free(entry, first[:2]),
            gain * first[4] - boundary_control(entry, first[:2]),
        ]
        return last[2], [*contact, *last[3:]]

    solution = fsolve(lambda z: run(z)[1], guess, xtol=1e-13)
    return run(solution)[0], list(solution[2:])


def jacobson_lele():
    """x2 <= 8 (t - 1/2)^2 - 1/2 for x1' = x2, x2' = u - x2."""

    def field(s, q, psi, control):
        rate = [q[1], control - q[1], q @ q + 0.005 * control**2]
        return [*rate, 2 * q[0], -psi[0] + psi[1] + 2 * q[1]]

    cost, times = first_order_contact(
        field,
        lambda s, q: q[1] + 16 * (s - 0.5),
        lambda s, q: q[1] - 8 * (s - 0.5) ** 2 + 0.5,
        100.0,
        [0.4, 0.11, 0.29, 0.70],
        [0, -1],
        1,
    )
    return Record(
        Problem(
            {x: v, v: u - v, t: 1},
            {u: None},
            {x: 0, v: -1, t: 0},
            running=x**2 + v**2 + R(1, 200) * u**2,
            duration=1,
            path=[v <= 8 * (t - R(1, 2)) ** 2 - R(1, 2)],
        ),
        ["interior", "boundary", "interior"],
        times,
        cost,
        "SciPy: shooting over three arcs",
        "Jacobson and Lele 1969; MISER3 manual, problem 2; an example of Pyomo and of ICLOCS",
        1e-9,
        (("TOMLAB, 50 points", 0.1698243, 1e-5),),
    )


def van_der_pol():
    """x2 >= -2/5 for the van der Pol oscillator."""

    def field(s, q, psi, control):
        rate = [q[1], -q[0] + q[1] * (1 - q[0] ** 2) + control, q @ q + control**2]
        costate = [psi[1] * (1 + 2 * q[0] * q[1]) + 2 * q[0], -psi[0] - psi[1] * (1 - q[0] ** 2)]
        return [*rate, costate[0], costate[1] + 2 * q[1]]

    problem = Problem(
        {x: v, v: -x + v * (1 - x**2) + u},
        {u: None},
        {x: 1, v: 0},
        running=x**2 + v**2 + u**2,
        duration=5,
        path=[v >= -R(2, 5)],
    )
    guess = [*problem.solve().costate(0), 0.63, 1.47]
    cost, times = first_order_contact(
        field,
        lambda s, q: q[0] + 0.4 * (1 - q[0] ** 2),
        lambda s, q: q[1] + 0.4,
        0.5,
        np.round(guess, 3),
        [1, 0],
        5,
    )
    return Record(
        problem,
        ["interior", "boundary", "interior"],
        times,
        cost,
        "SciPy: shooting over three arcs",
        "Maurer and Augustin 2001, state constraint of order one",
        1e-9,
    )


def rayleigh():
    """u <= -x1/6: u = min(2 psi_2, -x1/6), with dH/du as the multiplier of the bound."""

    def rate(s, z):
        q, psi = z[:2], z[3:]
        control = min(2 * psi[1], -q[0] / 6)
        excess = (4 * psi[1] - 2 * control) / 6
        return [
            q[1],
            -q[0] + q[1] * (1.4 - 0.14 * q[1] ** 2) + 4 * control,
            control**2 + q[0] ** 2,
            psi[1] + 2 * q[0] + excess,
            -psi[0] - psi[1] * (1.4 - 0.42 * q[1] ** 2),
        ]

    problem = Problem(
        {x: v, v: -x + v * (R(7, 5) - R(7, 50) * v**2) + 4 * u},
        {u: None},
        {x: -5, v: -5},
        running=u**2 + x**2,
        duration=R(9, 2),
        path=[u + x / 6 <= 0],
    )
    guess = np.round(problem.solve().costate(0), 3)

    def end(psi):
        return path_of(rate, [-5, -5, 0, *psi], (0, 4.5)).y[:, -1]

    cost = end(fsolve(lambda psi: end(psi)[3:], guess, xtol=1e-12))[2]
    return Record(
        problem,
        ["u+", "interior", "u+", "interior"],
        None,
        cost,
        "SciPy: shooting, the control being the lesser of two",
        "Maurer and Augustin 2001, doi 10.1007/978-3-662-04331-8_2; Betts 2010, example 4.6",
        1e-8,
        (("Betts", 44.80444, 6e-6),),
        (("PSOPT", 44.77625),),
    )


def disc():
    """Two tangents to the unit disc and the arc between them."""
    far = np.sqrt(4.01)
    around = 2 * np.arctan(20) - 2 * np.arccos(1 / far)
    tangent = np.sqrt(3.01)
    return Record(
        Problem(
            {x: sp.cos(theta), y: sp.sin(theta)},
            {theta: None},
            {x: -2, y: -R(1, 10)},
            {x: 2, y: -R(1, 10)},
            path=[x**2 + y**2 >= 1],
        ),
        ["interior", "boundary", "interior"],
        [tangent, tangent + around],
        2 * tangent + around,
        "closed form: two tangents and an arc",
    )


def disc_with_energy():
    """x from rest to rest over 4, y from rest to rest twice over 9/10: 6 d^2/T^3 each."""
    return Record(
        Problem(
            {x: v, v: a, y: w, w: b},
            {a: None, b: None},
            {x: -2, v: 0, y: -R(1, 10), w: 0},
            {x: 2, v: 0, y: -R(1, 10), w: 0},
            running=(a**2 + b**2) / 2,
            duration=4,
            path=[x**2 + y**2 >= 1],
        ),
        [("interior", "interior")] * 2,
        [2.0],
        6 * 16 / 64 + 2 * 6 * 0.81 / 8,
        "closed form by symmetry: one touch point, order two",
    )


tau = np.arccosh(2.0)
CONSTRAINED = {
    "Bryson-Denham 1/4": bryson_denham(R(1, 4)),
    "Bryson-Denham 1/5": bryson_denham(R(1, 5)),
    "Bryson-Denham 1/6": bryson_denham(R(1, 6)),
    "Bryson-Denham 1/9": bryson_denham(R(1, 9)),
    "speed limit, least time": Record(
        double_integrator(terminal={x: 10, v: 0}, path=[sp.Abs(v) <= 2]),
        ["u+", "boundary 1", "u-"],
        [2, 5],
        7,
        "closed form: trapezium of speeds",
    ),
    "speed limit, least energy": Record(
        Problem(
            {x: v, v: u},
            {u: None},
            {x: 0, v: 0},
            {x: 1, v: 0},
            running=u**2 / 2,
            duration=1,
            path=[v <= R(5, 4)],
        ),
        ["interior", "boundary", "interior"],
        [R(3, 10), R(7, 10)],
        R(125, 18),
        "closed form: parabolas of speed up to the limit, order one",
    ),
    "limits of speed and acceleration": Record(
        Problem(
            {x: v, v: a, a: u},
            {u: (-1, 1)},
            {x: 0, v: 0, a: 0},
            {x: 10, v: 0, a: 0},
            path=[v <= 2, sp.Abs(a) <= 1],
        ),
        ["u+", "boundary 2", "u-", "boundary 1", "u-", "boundary 3", "u+"],
        [1, 2, 3, 5, 6, 7],
        8,
        "closed form: seven segments, T = x/v + v/a + a/j; orders two and one",
    ),
    "limit of speed, bounded jerk": Record(
        Problem(
            {x: v, v: a, a: u},
            {u: (-1, 1)},
            {x: 0, v: 0, a: 0},
            {x: 10, v: 0, a: 0},
            path=[v <= 2],
        ),
        ["u+", "u-", "boundary", "u-", "u+"],
        [np.sqrt(2), 2 * np.sqrt(2), 5, 5 + np.sqrt(2)],
        5 + 2 * np.sqrt(2),
        "closed form: T = x/v + 2 sqrt(v/j); order two",
    ),
    "bound that depends on time": Record(
        Problem({x: u, t: 1}, {u: (-1, 1 - t / 4)}, {x: 0, t: 0}, [x - 1]),
        ["u+"],
        [],
        4 - 2 * np.sqrt(2),
        "closed form: t - t^2/8 = 1",
    ),
    "boundary to the end": Record(
        Problem(
            {x: u}, {u: None}, {x: 1}, running=(x**2 + u**2) / 2, duration=3, path=[x >= R(1, 2)]
        ),
        ["interior", "boundary"],
        [tau],
        np.sqrt(3) / 4 + (3 - tau) / 8,
        "closed form: x = cosh(t - arccosh 2)/2; order one",
    ),
    "terminal inequality": Record(
        double_integrator(terminal=[x - 1, v <= R(1, 2)]),
        ["u+", "u-"],
        [np.sqrt(9 / 8)],
        2 * np.sqrt(9 / 8) - 0.5,
        "closed form: v1^2/2 + (v1^2 - 1/4)/2 = 1",
    ),
    "two terminal inequalities": Record(
        Problem(
            {x: a, y: b},
            {a: None, b: None},
            {x: 0, y: 0},
            [x >= 1, y >= 2, x + y <= 10],
            running=(a**2 + b**2) / 2,
            duration=1,
        ),
        [("interior", "interior")],
        [],
        R(5, 2),
        "closed form: a straight line to the nearest point",
    ),
    "terminal inequality, free duration": Record(
        Problem({x: u}, {u: (-1, 1)}, {x: 0}, [x >= 1], running=1, duration=(0, 5)),
        ["u+"],
        [],
        1,
        "closed form: x = t",
    ),
    "terminal disc": Record(
        Problem(
            {x: a, y: b},
            {a: None, b: None},
            {x: 0, y: 0},
            [(x - 2) ** 2 + y**2 <= 1],
            running=(a**2 + b**2) / 2,
            duration=1,
        ),
        [("interior", "interior")],
        [],
        R(1, 2),
        "closed form: a straight line to the nearest point of the disc",
    ),
    "terminal inequality, inactive": Record(
        double_integrator(terminal=[x - 1, v <= R(3, 2)]),
        ["u+"],
        [],
        np.sqrt(2),
        "closed form: t^2/2 = 1",
    ),
    "state-dependent bound": Record(
        Problem({x: u}, {u: (0, x / 4)}, {x: 1}, [x - 2]),
        ["u+"],
        [],
        4 * np.log(2),
        "closed form: x = e^(t/4)",
    ),
    "brachistochrone above a line": brachistochrone(),
    "disc, shortest path": disc(),
    "disc, least energy": disc_with_energy(),
}
INTEGRATED = {
    "Goddard with a speed limit": goddard_with_limit,
    "Jacobson-Lele": jacobson_lele,
    "van der Pol with a state constraint": van_der_pol,
    "Rayleigh with a mixed constraint": rayleigh,
}


def chain_of_three():
    """psi_3 = s^3/6, s = 3 - t, and u = min(1, psi_3): int u^2/2 - psi_3 u."""
    s = 6 ** (1 / 3)
    return -(s**7) / 504 + (3 - s) / 2 - (81 - s**4) / 24


def ramsey():
    """k' = sqrt(k) - c, k from 1/10 to 1/10 in 10 units; the gain log(c) exp(-t/20).

    c' = c (1/(2 sqrt(k)) - 1/20).
    """

    def run(first):
        def rate(s, z):
            root = np.sqrt(z[0])
            return [root - z[1], z[1] * (1 / (2 * root) - 0.05), np.exp(-s / 20) * np.log(z[1])]

        def exhausted(s, z):
            return z[0] - 0.05

        exhausted.terminal = True
        return solve_ivp(
            rate,
            (0, 10),
            [0.1, first, 0],
            events=exhausted,
            rtol=1e-12,
            atol=1e-14,
            method="DOP853",
        )

    def excess(first):
        motion = run(first)
        return motion.y[0, -1] - 0.1 if motion.t[-1] == 10 else motion.t[-1] - 10

    return run(brentq(excess, 0.05, 0.2, xtol=1e-16, rtol=1e-15)).y[2, -1]


def arm():
    """Each joint turns at its bound, with one change or two, placed symmetrically.

    The moments of inertia come from the others.
    """

    def ends(z):
        T, first = z
        state = np.array([4.5, 0, np.pi / 4, 0, 0, 0])
        cuts = [0, T / 4, first, T / 2, T - first, 3 * T / 4, T]
        for begin, end in itertools.pairwise(cuts):
            middle = (begin + end) / 2
            pull = 1 if T / 4 < middle < 3 * T / 4 else -1
            swing = 1 if middle < T / 2 else -1
            lift = 1 if first < middle < T - first else -1

            def rate(s, q):
                inertia = ((5 - q[0]) ** 3 + q[0] ** 3) / 3
                return [*q[3:], pull / 5, swing / (inertia * np.sin(q[2]) ** 2), lift / inertia]

            state = path_of(rate, state, (0, end - begin)).y[:, -1]
        return state[[1, 2]] - [2 * np.pi / 3, np.pi / 4]

    return fsolve(ends, [9.1, 2.6], xtol=1e-13)[0]


def reach():
    inertia = ((5 - x1) ** 3 + x1**3) / 3
    return Problem(
        {
            x1: x4,
            x2: x5,
            x3: x6,
            x4: u1 / 5,
            x5: u2 / (inertia * sp.sin(x3) ** 2),
            x6: u3 / inertia,
        },
        {u1: (-1, 1), u2: (-1, 1), u3: (-1, 1)},
        {x1: R(9, 2), x2: 0, x3: sp.pi / 4, x4: 0, x5: 0, x6: 0},
        [x1 - R(9, 2), x2 - 2 * sp.pi / 3, x3 - sp.pi / 4, x4, x5, x6],
    )


def turn():
    """Four arcs with u = -1, 1, -1, 1 that end at rest at (1, 1), a right angle turned."""

    def ends(lengths):
        state = np.zeros(4)
        for length, pull in zip(lengths, (-1, 1, -1, 1)):

            def rate(s, q, pull=pull):
                return [np.cos(q[2]), np.sin(q[2]), q[3], pull]

            state = path_of(rate, state, (0, length)).y[:, -1]
        return state - [1, 1, np.pi / 2, 0]

    return sum(fsolve(ends, [1.1, 3.1, 3.1, 1.1], xtol=1e-13))


# Costs and times by integration, found when they are asked for.
def threefold_zero():
    return Record(
        Problem(
            {x: v, v: w, w: u}, {u: (0, 1)}, {x: 0, v: 0, w: 0}, running=u**2 / 2 - x, duration=3
        ),
        ["u+", "interior"],
        [3 - 6 ** (1 / 3)],
        chain_of_three(),
        "closed form: psi_3 = s^3/6 has a threefold zero at the end",
    )


def touched_bound():
    return Record(
        Problem(
            {x: u, t: 1},
            {u: (0, 1)},
            {x: 0, t: 0},
            running=u**2 / 2 - u * (t - 1) ** 4,
            duration=2,
        ),
        ["interior"],
        [],
        -1 / 9,
        "closed form: u = (t - 1)^4 touches its bound",
    )


def ramsey_growth():
    return Record(
        Problem(
            {k: sp.sqrt(k) - c, t: 1},
            {c: (R(1, 100), None)},
            {k: R(1, 10), t: 0},
            [k - R(1, 10)],
            running=sp.exp(-t / 20) * sp.log(c),
            duration=10,
            maximise=True,
        ),
        ["interior"],
        [],
        ramsey(),
        "SciPy: shooting for the Euler equation",
        "Ramsey 1928, with numbers of our own",
    )


def robot_arm():
    return Record(
        reach(),
        [
            ("u-", "u+", "u-"),
            ("u+", "u+", "u-"),
            ("u+", "u+", "u+"),
            ("u+", "u-", "u+"),
            ("u+", "u-", "u-"),
            ("u-", "u-", "u-"),
        ],
        None,
        arm(),
        "SciPy: two equations for the switching times",
        "COPS collection of Dolan and More",
    )


def maier_stein(duration, action):
    return Record(
        Problem(
            {x: x - x**3 - 10 * x * y**2 + u1, y: -(1 + x**2) * y + u2},
            {u1: None, u2: None},
            {x: -1, y: 0},
            [x - 1, y],
            running=u1**2 + u2**2,
            duration=duration,
        ),
        [("interior", "interior")],
        [],
        action,
        "least action of paths by the midpoint rule on up to 1600 intervals, extrapolated",
        "the system of Maier and Stein; Heymann and Vanden-Eijnden 2008 discuss its least action",
        2e-8,
    )


def turning():
    return Record(
        Problem(
            {x: sp.cos(v), y: sp.sin(v), v: w, w: u},
            {u: (-1, 1)},
            {x: 0, y: 0, v: 0, w: 0},
            [x - 1, y - 1, v - sp.pi / 2, w],
        ),
        ["u-", "u+", "u-", "u+"],
        None,
        turn(),
        "SciPy: four arcs; SLSQP from random lengths of four to seven arcs found none better",
    )


UNCONSTRAINED = {
    "a switching function with a threefold zero at the end": threefold_zero,
    "a bound that is touched": touched_bound,
    "Ramsey": ramsey_growth,
    "robot arm": robot_arm,
    "Maier-Stein, T = 5": lambda: maier_stein(5, 0.85713996),
    "Maier-Stein, T = 20": lambda: maier_stein(20, 0.68009388),
    "quarter turn from rest to rest": turning,
    "Goddard": goddard_without_limit,
    "van der Pol": van_der_pol_singular,
    "Rayleigh": rayleigh_fastest,
}


GROUPS = {
    "classical": CLASSICAL,
    "unconstrained": UNCONSTRAINED,
    "integrated": INTEGRATED,
    "constrained": CONSTRAINED,
}
NAMES = tuple(name for group in GROUPS.values() for name in group)
FILE = Path(__file__).parents[2] / "trajlib" / "pontryagin" / "problems.json"


@cache
def record(name):
    """Return the record of a name, its second route being computed once."""
    value = next(records[name] for records in GROUPS.values() if name in records)
    return value() if callable(value) else value


def data(name):
    """Return a record as strings, numbers and lists; expressions as SymPy reads them.

    The cost has the digits on which both routes agree, and so have the times.
    """
    value = record(name)
    problem, digits = value.problem, round(-np.log10(value.tolerance))
    times = None if value.times is None else [f"{float(s):.{digits}g}" for s in value.times]
    return {
        "dynamics": {str(s): str(f) for s, f in problem.dynamics.items()},
        "controls": {str(s): [str(low), str(high)] for s, (low, high) in problem.controls.items()},
        "initial": {str(s): None if f is None else str(f) for s, f in problem.initial.items()},
        "terminal": [str(g) for g in problem.terminal],
        "terminal_inequalities": [str(g) for g in problem.terminal_inequalities],
        "path": [str(g) for g in problem.path],
        "running": str(problem.running),
        "final": str(problem.final),
        "duration": _duration(problem.duration),
        "maximise": problem.maximise,
        "cost": f"{float(value.cost):.{digits}g}",
        "arcs": value.arcs,
        "times": times,
        "route": value.route,
        "source": value.source,
        "published": [[where, number] for where, number, _ in value.published],
        "refuted": [list(pair) for pair in value.refuted],
        "group": next(group for group, records in GROUPS.items() if name in records),
    }


def _duration(duration):
    return [str(d) for d in duration] if isinstance(duration, tuple) else duration and str(duration)


if __name__ == "__main__":
    table = {"problems": {name: data(name) for name in NAMES}}
    FILE.write_text(json.dumps(table, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
