"""Problems 5.29 - 5.62 with other numbers than in `test_pontryagin_book_problems`.

Limiting cases of a statement, other structures, initial states that leave little choice; the
references share nothing with the library.
"""

from dataclasses import dataclass

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq, fsolve, minimize

from trajlib.pontryagin import Chattering, Infeasible, NotUnique, Problem, Unbounded

pytestmark = pytest.mark.slow
R = sp.Rational
x, y, u, v, w, p, m, h, a, r, b = sp.symbols("x y u v w p m h a r b")
x1, x2 = sp.symbols("x1 x2")
ONE, FREE, THROTTLE, TWO = {u: (-1, 1)}, {u: None}, {p: (0, 1)}, {v: (0, 1), w: (-1, 1)}
PLANE, CART = {x1: x2, x2: u}, {a: w, w: a + u, x: v, v: u}
AT_REST = dict.fromkeys((x, y, v, w), 0)


def motion(rate, start, until, event=None):
    """Times and states of a motion, to its event if there is one."""
    if event is not None:
        event.terminal = True
    run = solve_ivp(rate, (0, until), start, events=event, rtol=1e-12, atol=1e-13, method="DOP853")
    assert event is None or run.t_events[0].size
    return run.t[-1], run.y[:, -1]


def rocket(thrust, g=1, k=0, c=1, up=1):
    """5.29, 5.51 upwards; 5.30, 5.52 with h downwards."""
    return {h: v, v: (up * thrust * p - k * v**2) / m - up * g, m: -thrust * p / c}


def thrust_along(gravity=0):
    return {x: v, y: w, v: sp.cos(u), w: sp.sin(u) - gravity}


def burnt(time, thrust, c):
    """The gain of speed in a vacuum without gravity, m = 1 at first."""
    return -c * np.log(1 - thrust * time / c)


def ascent(height, speed, thrust, c, time):
    """5.29: burn first, then rise."""
    end = speed + burnt(time, thrust, c) - time
    way = quad(lambda s: speed + burnt(s, thrust, c) - s, 0, time, epsabs=1e-14)[0]
    return -(height + way + end**2 / 2)


def landing(height, speed, thrust, c):
    """5.30: fall (or rise) freely, then burn for s to stop at the ground."""

    def missed(s):
        at = burnt(s, thrust, c) - s
        return (
            (at**2 - speed**2) / 2
            + quad(lambda q: at - burnt(q, thrust, c) + q, 0, s, epsabs=1e-15)[0]
            - height
        )

    return thrust / c * brentq(missed, 1e-3, 0.99 * c / thrust, xtol=1e-15) - 1


def tangent(T):
    """Rise and speed for tan(theta) from tan to -tan in time T, without gravity."""
    return (
        lambda tan: (tan * np.hypot(1, tan) - np.arcsinh(tan)) * T**2 / (4 * tan**2)
    ), lambda tan: T * np.arcsinh(tan) / tan


def linear_tangent(height, T):
    rise, speed = tangent(T)
    return -speed(brentq(lambda tan: rise(tan) - height, 1e-3, 50, xtol=1e-15))


def orbit(height, speed):
    tan = brentq(
        lambda tan: tangent(speed * tan / np.arcsinh(tan))[0](tan) - height, 1e-3, 50, xtol=1e-15
    )
    return speed * tan / np.arcsinh(tan)


def against_gravity(gravity, height, T=None, speed=None):
    """5.36: tan(theta) linear in time, from what the ends ask for."""

    def ends(at, slope, T):
        def along(f):
            return quad(lambda s: f(s) / np.hypot(1, at - slope * s), 0, T, epsabs=1e-14)[0]

        return (
            along(lambda s: at - slope * s) - gravity * T,
            along(lambda s: (T - s) * (at - slope * s)) - gravity * T**2 / 2 - height,
            along(lambda s: 1.0),
        )

    if T is not None:
        at, slope = fsolve(lambda z: ends(*z, T)[:2], [2, 1], xtol=1e-14)
        return -ends(at, slope, T)[2]
    return fsolve(lambda z: np.array(ends(*z)) - [0, 0, speed], [2, 1, 3], xtol=1e-14)[2]


def first_root(function, end, count=4000):
    grid = np.linspace(1e-6, end, count)
    values = function(grid)
    k = int(np.argmax(values[:-1] * values[1:] < 0))
    return brentq(function, grid[k], grid[k + 1], xtol=1e-15)


def flight(T, start, g):
    """5.37: v = C cos(theta), theta = g (t - T)/C."""
    C = brentq(lambda C: C * np.cos(g * T / C) - start, 2 * g * T / np.pi * 1.0001, 100, xtol=1e-15)
    return -C * (T / 2 + C * np.sin(2 * g * T / C) / (4 * g))


def flight_in_air(T, start):
    """5.38: theta' = cos(theta) (1 + 3 v^2 sin(theta))/v, theta(T) = 0."""

    def end(theta):
        return motion(
            lambda s, z: [
                np.cos(z[0]) * (1 + 3 * z[1] ** 2 * np.sin(z[0])) / z[1],
                -(z[1] ** 2) - np.sin(z[0]),
                z[1] * np.cos(z[0]),
            ],
            [theta, start, 0],
            T,
        )[1]

    return -end(brentq(lambda theta: end(theta)[0], -1.2, 0, xtol=1e-14))[2]


def in_a_current(stream, slope, start, target, guesses):
    """5.39 with the current U(y): theta' = -U'(y) cos^2(theta); the fastest of the ways found."""

    def missed(z):
        end = motion(
            lambda s, q: [
                np.cos(q[2]) + stream(q[1]),
                np.sin(q[2]),
                -slope(q[1]) * np.cos(q[2]) ** 2,
            ],
            [*start, z[0]],
            z[1],
        )[1]
        return end[:2] - target

    found = [fsolve(missed, guess, xtol=1e-13, full_output=True) for guess in guesses]
    return min(z[1] for z, _, ok, _ in found if ok == 1 and z[1] > 0)


def down_to_the_lane():
    """5.40 with v = 1 + 3 exp(-4 y^2): cos(theta)/v is constant.

    The path turns where v = 1/k, at y = s.
    """

    def speed(at):
        return 1 + 3 * np.exp(-4 * at**2)

    def along(f, turn):
        # y = turn + q^2 takes the root at the turning point away.
        def part(q):
            at, top = turn + q**2, speed(turn)
            slower = -3 * np.exp(-4 * turn**2) * np.expm1(-4 * q**2 * (2 * turn + q**2))
            return 2 * q * f(speed(at) / top, speed(at)) * top / np.sqrt(slower * (top + speed(at)))

        return quad(part, 0, np.sqrt(1 - turn), epsabs=1e-12, epsrel=1e-12, limit=400)[0]

    turn = brentq(lambda turn: along(lambda kv, speed: kv, turn) - 3, 1e-4, 0.5, xtol=1e-15)
    return 2 * along(lambda kv, speed: 1 / speed, turn)


def guided(ratio, c, start, end, low, high):
    """5.42, 5.43: the equation of the book for the heading, which is zero at the end."""

    def run(heading):
        def rate(s, z):
            radius, beta, alpha = z
            turn = (-np.sin(alpha) + ratio * np.sin(beta)) / radius
            return [
                np.cos(alpha) - ratio * np.cos(beta),
                turn / c,
                turn - ratio * (1 - c) / (radius * c) * np.cos(alpha) * np.sin(alpha - beta),
            ]

        return motion(rate, [*start, heading], 20, lambda s, z: z[0] - end)

    return run(brentq(lambda heading: run(heading)[1][2], low, high, xtol=1e-13))[0]


def swinging_in(gain, start, end):
    """5.45 with a constant gain."""
    return motion(
        lambda s, z: [z[1], z[0] * z[2] ** 2, (gain - 2 * z[1]) * z[2] / z[0]],
        start,
        5,
        lambda s, z: z[0] - end,
    )[0]


def burn_in_air(k, thrust, start, end, singular=True):
    """5.51, c = g = 1: to the surface k v^2 (1 + v) = m, along it, and up without thrust."""

    def rates(s, z, force):
        return [z[1], (force - k * z[1] ** 2) / z[2] - 1, -force]

    def surface(s, z):
        return k * z[1] ** 2 * (1 + z[1]) - z[2]

    def empty(s, z):
        return z[2] - end

    def along(s, z):
        slope = 2 * k * z[1] + 3 * k * z[1] ** 2
        return rates(s, z, slope * (k * z[1] ** 2 / z[2] + 1) / (slope / z[2] + 1))

    first = thrust if surface(0, start) < 0 else 0
    z = motion(lambda s, z: rates(s, z, first), start, 1, surface if singular else empty)[1]
    if singular:
        z = motion(along, z, 2, empty)[1]
    return -motion(lambda s, z: rates(s, z, 0), z, 5, lambda s, z: z[1])[1][0]


def landing_in_air(k, height):
    """5.52: the fall meets, at equal depth and speed, the burn that ends at the ground."""

    def ended(z):
        fallen = motion(lambda s, q: [q[1], 1 - k * q[1] ** 2], [-height, 0], z[0])[1]
        return motion(lambda s, q: [q[1], 1 - (3 + k * q[1] ** 2) / q[2], -3], [*fallen, 1], z[1])[
            1
        ]

    return -ended(fsolve(lambda z: ended(z)[:2], [3.2, 0.18], xtol=1e-13))[2]


def far_at_one_height():
    """5.53, Q = (v^2 + m^2/v^2)/2 and c = 1: a singular arc, then no thrust.

    On singular arcs S = v Q_v - Q + v (Q - m Q_m) = 0.
    """
    q, n = sp.symbols("q n", positive=True)
    Q = (q**2 + n**2 / q**2) / 2
    S = q * Q.diff(q) - Q + q * (Q - n * Q.diff(n))
    drag, surface, by_speed, by_mass = (
        sp.lambdify((q, n), e) for e in (Q, S, S.diff(q), S.diff(n))
    )

    def rates(z, force):
        return [z[1], (force - drag(z[1], z[2])) / z[2], -force]

    def along(s, z):
        slope, weight = by_speed(z[1], z[2]), by_mass(z[1], z[2])
        return rates(z, slope * drag(z[1], z[2]) / z[2] / (slope / z[2] - weight))

    z = motion(lambda s, z: rates(z, 0), [0, 2, 1], 5, lambda s, z: surface(z[1], z[2]))[1]
    z = motion(along, z, 5, lambda s, z: z[2] - 0.5)[1]
    return -motion(lambda s, z: rates(z, 0), z, 5, lambda s, z: z[1] - 0.5)[1][0]


def pursuit(turn, pace, radius, angle, end):
    """5.54 - 5.56: u = -2 sign(angle) until the angle is zero, then straight on."""
    sign = np.sign(angle)
    time, (at, _) = motion(
        lambda s, z: [pace(z[1]), turn(z[1]) / z[0] - 2 * sign],
        [radius, angle],
        5,
        lambda s, z: z[1],
    )
    return time + (end - at) / pace(0.0)


def robot(place, offset):
    """5.57, 5.58: turns on the spot by g, with v = 1 by f, and a straight path; the shortest."""

    def ends(z, side):
        g, f, way = z
        one, two = side * g, side * (g + f)
        on_spot = offset * np.array([np.cos(one) - 1, np.sin(one)])
        arc = side * np.array(
            [np.sin(two) - np.sin(one), np.cos(one) - np.cos(two)]
        ) + offset * np.array([np.cos(two) - np.cos(one), np.sin(two) - np.sin(one)])
        return on_spot + arc + way * np.array([np.cos(two), np.sin(two)]) - place

    best = np.inf
    for side in (1, -1):
        for start in (
            [0.5, 0.5, 0.5],
            [0.1, 1, 1],
            [1.5, 1.5, 2],
            [1.2, 0.5, 0.01],
            [0.01, 0.5, 2],
        ):
            found = minimize(
                sum,
                start,
                jac=lambda z: np.ones(3),
                bounds=[(0, 7)] * 3,
                method="SLSQP",
                constraints={"type": "eq", "fun": ends, "args": (side,)},
                options={"ftol": 1e-15, "maxiter": 300},
            )
            if np.abs(ends(found.x, side)).max() < 1e-9:
                best = min(best, found.fun)
    return best


def unstable_regulator(T):
    """5.59: u = -1, then v' = x/2, then u = 1 to the origin at the time T."""

    def run(z):
        state, cost = np.array([0.5, 0.25, 0]), 0
        for length, push in ((z[0], -1), (z[1] - z[0], None), (T - z[1], 1)):
            state = motion(
                lambda s, q: [
                    q[1],
                    q[0] / 2 if push is None else q[0] + push,
                    q[0] ** 2 + 2 * q[1] ** 2,
                ],
                state,
                length,
            )[1]
        cost = state[2]
        return state, cost

    ends = fsolve(lambda z: run(z)[0][:2], [1.2430, 5.9774], xtol=1e-13)
    return run(ends)[1]


def cart(start, k, guess):
    """5.60: four arcs, from -1 on, that the four terminal equations determine."""

    def run(lengths):
        (angle, rate), place, speed, cost, sign = start, 0.0, 0.0, 0.0, -1
        for s in lengths:
            path = np.polynomial.Polynomial([place, speed, sign / 2])
            cost += s + k * (path**2).integ()(s)
            angle, rate = (
                (angle + sign) * np.cosh(s) + rate * np.sinh(s) - sign,
                (angle + sign) * np.sinh(s) + rate * np.cosh(s),
            )
            place, speed, sign = path(s), speed + sign * s, -sign
        return [angle, rate, place, speed], cost

    lengths = fsolve(lambda lengths: run(lengths)[0], guess, xtol=1e-13)
    return run(lengths)[1]


def fuller(place, speed):
    """5.61: u changes on x = -xi v|v|, xi^2 = (sqrt(33) - 1)/24; cost and ratio of the arcs."""
    xi, cost, lengths = np.sqrt((np.sqrt(33) - 1) / 24), 0.0, []
    sign = -np.sign(place + xi * speed * abs(speed))
    for _ in range(30):
        path = np.polynomial.Polynomial([place, speed, sign / 2])
        rate = path.deriv()
        # On the curve the speed has the sign of the push.
        ends = (path + sign * xi * rate**2).roots()
        s = min(
            t.real
            for t in ends
            if abs(t.imag) < 1e-9 and t.real > 1e-12 * (1 + abs(speed)) and sign * rate(t.real) > 0
        )
        cost, place, speed, sign = cost + (path**2).integ()(s), path(s), rate(s), -sign
        lengths.append(s)
        if s < 1e-6:
            break
    return cost, lengths[3] / lengths[4]


@dataclass
class Case:
    """A statement with its least cost (a number, or how to find it) and where that is from."""

    problem: Problem
    cost: object
    source: str


def of_angle(sign, drift, start, end, angle, **more):
    return Problem(
        {x: sign * (sp.cos(y) - drift), y: -sign * sp.sin(y) / x + u},
        {u: (-2, 2)},
        {x: start, y: angle},
        [x - end],
        **more,
    )


def headed(field, start, target):
    """5.39, 5.40: the fastest way under a heading."""
    return Problem(
        dict(zip((x, y), field)), FREE, dict(zip((x, y), start)), [x - target[0], y - target[1]]
    )


def meeting(start):
    """5.35: to rest at the origin."""
    return Problem(thrust_along(), FREE, dict(zip((x, y, v, w), start)), [x, y, v, w])


def round_trip(wind):
    """5.41: the greatest area of a closed flight."""
    return Problem(
        {x: sp.cos(u) - wind, y: sp.sin(u)},
        FREE,
        {x: 0, y: 0},
        [x, y],
        running=-(x * sp.sin(u) - y * (sp.cos(u) - wind)) / 2,
        duration=3,
    )


def navigation(ratio, c, start, end, **more):
    return Problem(
        {r: sp.cos(u) - ratio * sp.cos(b), b: (-sp.sin(u) + ratio * sp.sin(b)) / (r * c)},
        FREE,
        dict(zip((r, b), start)),
        [r - end],
        **more,
    )


SWING = {r: v, v: r * w**2, w: (u - 2 * v) * w / r}
LANE, SPHERE = 1 + 3 * sp.exp(-4 * y**2), 1 + x**2 + y**2
ROBOT = {x: v * sp.cos(a), y: v * sp.sin(a), a: w}
OFFSET = {x: v * sp.cos(a) - w * sp.sin(a), y: v * sp.sin(a) + w * sp.cos(a), a: w}
ORIGIN = {x: 0, y: 0, a: 0}
CASES = {
    "5.29, thrown upwards": Case(
        Problem(rocket(3), THROTTLE, {h: 0, v: R(1, 2), m: 1}, [v, m - R(2, 5)], final=-h),
        lambda: ascent(0, 0.5, 3, 1, 0.2),
        "burn, then rise",
    ),
    "5.29, too weak to lift off": Case(
        Problem(rocket(R(4, 5), c=2), THROTTLE, {h: 5, v: 1, m: 1}, [v, m - R(2, 5)], final=-h),
        lambda: ascent(5, 1, 0.8, 2, 1.5),
        "burn, then rise",
    ),
    "5.30, thrown down": Case(
        Problem(rocket(3, up=-1), THROTTLE, {h: -2, v: R(1, 2), m: 1}, [v, h], final=-m),
        lambda: landing(2, 0.5, 3, 1),
        "fall, then burn",
    ),
    "5.30, rising": Case(
        Problem(rocket(3, c=2, up=-1), THROTTLE, {h: -1, v: -1, m: 1}, [v, h], final=-m),
        lambda: landing(1, -1, 3, 2),
        "fall, then burn",
    ),
    "5.32": Case(
        Problem(thrust_along(), FREE, AT_REST, [y - 1, w], final=-v, duration=3),
        lambda: linear_tangent(1, 3),
        "linear tangent",
    ),
    "5.33": Case(
        Problem(thrust_along(), FREE, AT_REST, [y - 1, w, v - 2]),
        lambda: orbit(1, 2),
        "linear tangent",
    ),
    "5.33, to rest": Case(
        Problem(thrust_along(), FREE, {x: 0, y: 0, v: 2, w: 0}, [y - 1, w, v]),
        lambda: orbit(1, 2),
        "the same, backwards",
    ),
    "5.35, from rest": Case(meeting((1, 2, 0, 0)), 2 * 5**0.25, "on a line: half of the way each"),
    "5.35, too fast": Case(
        meeting((1, 1, -2, -2)),
        2 * np.sqrt(2) + np.sqrt(16 - 4 * np.sqrt(2)),
        "on a line: past the target and back",
    ),
    "5.36 as 5.32": Case(
        Problem(thrust_along(R(1, 3)), FREE, AT_REST, [y - 1, w], final=-v, duration=3),
        lambda: against_gravity(1 / 3, 1, T=3),
        "linear tangent",
    ),
    "5.36 as 5.33": Case(
        Problem(thrust_along(R(1, 3)), FREE, AT_REST, [y - 1, w, v - 2]),
        lambda: against_gravity(1 / 3, 1, speed=2),
        "linear tangent",
    ),
    "5.36 as 5.34": Case(
        Problem(thrust_along(R(1, 2)), FREE, {x: 2, y: 1, v: 0, w: 1}, [x, y]),
        lambda: first_root(lambda T: 4 + (1 + T - T**2 / 4) ** 2 - T**4 / 4, 10),
        "constant direction",
    ),
    "5.34, on the way past": Case(
        Problem(thrust_along(), FREE, {x: 2, y: 0, v: -3, w: 0}, [x, y]),
        np.sqrt(13) - 3,
        "constant direction; 3 - sqrt(5) is an extremal too",
    ),
    "5.34, back from beyond": Case(
        Problem(thrust_along(), FREE, {x: 2, y: R(1, 4), v: -3, w: 0}, [x, y]),
        lambda: first_root(lambda T: (2 - 3 * T) ** 2 + 1 / 16 - T**4 / 4, 10),
        "constant direction",
    ),
    "5.37, long": Case(
        Problem(
            {x: v * sp.cos(u), y: v * sp.sin(u), v: -sp.sin(u)},
            FREE,
            {x: 0, y: 0, v: 1},
            final=-x,
            duration=3,
        ),
        lambda: flight(3, 1, 1),
        "v = C cos(theta)",
    ),
    "5.37, fast": Case(
        Problem(
            {x: v * sp.cos(u), y: v * sp.sin(u), v: -2 * sp.sin(u)},
            FREE,
            {x: 0, y: 0, v: 5},
            final=-x,
            duration=1,
        ),
        lambda: flight(1, 5, 2),
        "v = C cos(theta)",
    ),
    "5.38, fast": Case(
        Problem(
            {x: v * sp.cos(u), y: v * sp.sin(u), v: -(v**2) - sp.sin(u)},
            FREE,
            {x: 0, y: 0, v: 2},
            final=-x,
            duration=2,
        ),
        lambda: flight_in_air(2, 2),
        "the book's boundary value problem",
    ),
    "5.39, constant": Case(
        headed((sp.cos(u) + R(1, 2), sp.sin(u)), (0, 0), (1, 2)), 2.0, "3 T^2/4 + T = 5"
    ),
    "5.39, faster than the ship": Case(
        headed((sp.cos(u) + 2, sp.sin(u)), (0, 0), (3, 1)),
        2 - np.sqrt(6) / 3,
        "3 T^2 - 12 T + 10 = 0",
    ),
    "5.39, shear": Case(
        headed((sp.cos(u) - y, sp.sin(u)), (R(183, 50), R(-93, 50)), (0, 0)),
        lambda: in_a_current(
            lambda q: -q, lambda q: -1, (3.66, -1.86), (0, 0), [(1.8, 5), (2.5, 6), (1, 4)]
        ),
        "shooting with the corrected equation of the book",
    ),
    "5.39, whirl": Case(
        headed((sp.cos(u) - y / 2, sp.sin(u) + x / 2), (R(3, 2), 0), (0, 1)),
        lambda: first_root(lambda T: 3.25 - 3 * np.sin(T / 2) - T**2, 5),
        "straight in the turning frame",
    ),
    "5.39, river": Case(
        headed((sp.cos(u) + R(3, 4) * (1 - y**2), sp.sin(u)), (0, -1), (3, 1)),
        lambda: in_a_current(
            lambda q: 0.75 * (1 - q**2),
            lambda q: -1.5 * q,
            (0, -1),
            (3, 1),
            [(1, 2.6), (0.5, 2.5), (1.4, 3)],
        ),
        "shooting",
    ),
    "5.40, sphere": Case(
        headed((SPHERE * sp.cos(u), SPHERE * sp.sin(u)), (1, R(1, 2)), (R(-1, 2), R(1, 2))),
        np.arctan(np.sqrt(2)),
        "the arc between two points of a sphere",
    ),
    "5.40, fast lane": Case(
        headed((LANE * sp.cos(u), LANE * sp.sin(u)), (-3, 1), (3, 1)),
        lambda: down_to_the_lane(),
        "two quadratures, by Snell's law",
    ),
    "5.41": Case(round_trip(R(3, 10)), -9 / (4 * np.pi) * 0.91**1.5, "an ellipse"),
    "5.41, strong wind": Case(
        round_trip(R(19, 20)), -9 / (4 * np.pi) * (1 - 0.95**2) ** 1.5, "an ellipse"
    ),
    "5.42": Case(
        navigation(2, -1, (3, R(3, 10)), 1, maximise=True),
        lambda: guided(2, -1, (3, 0.3), 1, -1.5, 1.5),
        "the book's boundary value problem",
    ),
    "5.43": Case(
        navigation(R(1, 2), -1, (1, R(3, 10)), R(3, 2)),
        lambda: guided(0.5, -1, (1, 0.3), 1.5, -1.2, 1.2),
        "the book's boundary value problem",
    ),
    "5.45, away": Case(
        Problem(SWING, ONE, {r: 1, v: 0, w: 1}, [r - 2]),
        lambda: swinging_in(1, [1, 0, 1], 2),
        "the gain that turns fastest",
    ),
    "5.45, closer": Case(
        Problem(SWING, ONE, {r: 1, v: -1, w: R(1, 2)}, [r - R(1, 2)]),
        lambda: swinging_in(-1, [1, -1, 0.5], 0.5),
        "the gain that turns slowest",
    ),
    "5.46": Case(
        Problem({x1: u, x2: x1**2}, ONE, {x1: R(1, 2), x2: 0}, final=x2, duration=1),
        1 / 24,
        "to rest",
    ),
    "5.47": Case(
        Problem({x1: u, x2: -(x1**2)}, ONE, {x1: R(1, 4), x2: 0}, final=x2, duration=1),
        -(125 - 1) / 192,
        "away",
    ),
    "5.48": Case(
        Problem({x1: u, x2: -u * x1}, ONE, {x1: R(1, 2), x2: 0}, final=x2, duration=1),
        -1.0,
        "(x1(0)^2 - x1(1)^2)/2",
    ),
    "5.49": Case(
        Problem({x: 1 - y**2, y: u}, ONE, {x: 0, y: -1}, [y - 1], final=-x, duration=R(5, 2)),
        -11 / 6,
        "half a unit of time in the middle",
    ),
    "5.49, no time to lose": Case(
        Problem({x: 1 - y**2, y: u}, ONE, {x: 0, y: -1}, [y - 1], final=-x, duration=2),
        -4 / 3,
        "straight across",
    ),
    "5.51, from rest": Case(
        Problem(rocket(R(7, 2), k=20), THROTTLE, {h: 0, v: 0, m: 1}, [v, m - R(3, 5)], final=-h),
        lambda: burn_in_air(20, 3.5, [0, 0, 1], 0.6),
        "law on the surface",
    ),
    "5.51, thrown upwards": Case(
        Problem(rocket(R(7, 2), k=20), THROTTLE, {h: 0, v: 1, m: 1}, [v, m - R(3, 5)], final=-h),
        lambda: burn_in_air(20, 3.5, [0, 1, 1], 0.6),
        "law on the surface",
    ),
    "5.51, thin air": Case(
        Problem(rocket(3, k=R(1, 2)), THROTTLE, {h: 0, v: 0, m: 1}, [v, m - R(1, 2)], final=-h),
        lambda: burn_in_air(0.5, 3, [0, 0, 1], 0.5, singular=False),
        "burn, then rise",
    ),
    "5.52": Case(
        Problem(
            {h: v, v: 1 - (3 * p + 2 * v**2) / m, m: -3 * p},
            THROTTLE,
            {h: -2, v: 0, m: 1},
            [v, h],
            final=-m,
        ),
        lambda: landing_in_air(2, 2),
        "fall and burn joined",
    ),
    "5.53": Case(
        Problem(
            {x: v, v: (3 * p - v**2 / 2 - m**2 / (2 * v**2)) / m, m: -3 * p},
            THROTTLE,
            {x: 0, v: 2, m: 1},
            [v - R(1, 2), m - R(1, 2)],
            final=-x,
        ),
        lambda: far_at_one_height(),
        "law on the surface",
    ),
    "5.54 a": Case(
        of_angle(-1, 2, 1, 3, -1, maximise=True),
        lambda: pursuit(np.sin, lambda q: 2 - np.cos(q), 1, -1, 3),
        "motion with an event",
    ),
    "5.54 b": Case(
        of_angle(-1, R(1, 2), 3, R(1, 2), 1),
        lambda: pursuit(np.sin, lambda q: 0.5 - np.cos(q), 3, 1, 0.5),
        "the same",
    ),
    "5.55": Case(
        of_angle(1, 2, 3, R(1, 2), 1, maximise=True),
        lambda: pursuit(lambda q: -np.sin(q), lambda q: np.cos(q) - 2, 3, 1, 0.5),
        "the same",
    ),
    "5.56": Case(
        of_angle(1, R(1, 2), 1, 3, -1),
        lambda: pursuit(lambda q: -np.sin(q), lambda q: np.cos(q) - 0.5, 1, -1, 3),
        "the same",
    ),
    "5.57, behind": Case(
        Problem(ROBOT, TWO, ORIGIN, [x + 3, y - 1]), lambda: robot((-3, 1), 0), "turns and a way"
    ),
    "5.57, inside the circle": Case(
        Problem(ROBOT, TWO, ORIGIN, [x, y - R(1, 2)]), lambda: robot((0, 0.5), 0), "the same"
    ),
    "5.57, ahead": Case(Problem(ROBOT, TWO, ORIGIN, [x - 2, y]), 2.0, "straight"),
    "5.58": Case(
        Problem(OFFSET, TWO, ORIGIN, [x - 2, y + 2]), lambda: robot((2, -2), 1), "turns and a way"
    ),
    "5.59": Case(
        Problem(
            {x1: x2, x2: x1 + u},
            ONE,
            {x1: R(1, 2), x2: R(1, 4)},
            [x1, x2],
            running=x1**2 + 2 * x2**2,
            duration=6,
        ),
        lambda: unstable_regulator(6),
        "two equations; the problem is convex",
    ),
    "5.60, no price": Case(
        Problem(CART, ONE, {a: R(3, 10), w: 0, x: 0, v: 0}, [a, w, x, v]),
        lambda: cart((0.3, 0), 0, [0.9, 2, 1.5, 0.5]),
        "four equations",
    ),
    "5.60, small price": Case(
        Problem(CART, ONE, {a: R(1, 5), w: 0, x: 0, v: 0}, [a, w, x, v], running=1 + x**2 / 10),
        lambda: cart((0.2, 0), 0.1, [0.7, 1.6, 1.3, 0.4]),
        "four equations",
    ),
    "5.60, swinging": Case(
        Problem(CART, ONE, {a: R(-1, 5), w: R(1, 2), x: 0, v: 0}, [a, w, x, v], running=1 + x**2),
        lambda: cart((-0.2, 0.5), 1, [0.9, 2, 1.5, 0.5]),
        "four equations",
    ),
    "5.62, no time to lose": Case(
        Problem(PLANE, ONE, {x1: 2, x2: -2}, [x1 - 2, x2 - 2], running=x1**2, duration=4),
        3.2,
        "u = 1 throughout",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_cost(name):
    case = CASES[name]
    extremal = case.problem.solve()
    cost = case.cost() if callable(case.cost) else case.cost
    assert extremal.cost == pytest.approx(cost, rel=1e-10, abs=1e-11)
    assert extremal.certificate().holds()


@pytest.mark.parametrize(
    "problem, error, message",
    [
        (
            Problem(thrust_along(), FREE, AT_REST, [y - 3, w], final=-v, duration=3),
            Infeasible,
            "least time .* 3.4641",
        ),
        (round_trip(R(6, 5)), Infeasible, "cannot exceed -0.6"),
        (
            Problem({x: 1 - y**2, y: u}, ONE, {x: 0, y: -1}, [y - 1], final=-x, duration=1),
            Infeasible,
            "cannot exceed 0",
        ),
        (
            Problem({x1: u, x2: -u * x1}, ONE, {x1: 0, x2: 0}, [x1], final=x2, duration=1),
            NotUnique,
            "leaves u open",
        ),
        (
            Problem(
                {x1: x2, x2: x1 + u},
                ONE,
                {x1: R(1, 2), x2: R(1, 4)},
                [x1, x2],
                running=x1**2 + 2 * x2**2,
            ),
            Unbounded,
            "not attained",
        ),
        (
            Problem(
                {x1: x2, x2: x1 + u}, ONE, {x1: 1, x2: R(1, 4)}, [x1, x2], running=x1**2 + 2 * x2**2
            ),
            Infeasible,
            "cannot fall below 1.25",
        ),
        (
            Problem(
                CART, ONE, {a: R(3, 5), w: R(1, 2), x: 0, v: 0}, [a, w, x, v], running=1 + x**2
            ),
            Infeasible,
            "cannot fall below 1.1",
        ),
        (
            Problem(PLANE, ONE, {x1: 2, x2: -2}, [x1 - 2, x2 - 2], running=x1**2, duration=8),
            Chattering,
            "infinitely often",
        ),
    ],
    ids=[
        "5.32 too high",
        "5.41 blown away",
        "5.49 too late",
        "5.48 closed",
        "5.59",
        "5.59 out of reach",
        "5.60 fallen",
        "5.62",
    ],
)
def test_reason_without_an_extremal(problem, error, message):
    with pytest.raises(error, match=message):
        problem.solve()


@pytest.mark.parametrize("start", [(1, 0), (-1, -1)])
def test_numbers_of_chattering(start):
    with pytest.raises(Chattering) as caught:
        Problem(PLANE, ONE, dict(zip((x1, x2), start)), [x1, x2], running=x1**2).solve()
    numbers, (cost, ratio) = caught.value.numbers, fuller(*map(float, start))
    assert abs(numbers.cost - cost) < numbers.cost_error < 1e-11
    assert abs(numbers.ratio - ratio) < numbers.ratio_error < 1e-4


def test_switchings_that_accumulate_at_an_arc_of_order_three():
    """The third derivative of x is u, the cost x^2: more switchings cost less.

    With 4 switchings a stationary process costs 1.2521203. The cost in the message is that of its
    arcs, here by polynomials.
    """
    with pytest.raises(Chattering, match="order 3: ever more arcs cost ever less") as caught:
        Problem({x: v, v: w, w: u}, ONE, {x: 1, v: 0, w: 0}, [x, v, w], running=x**2).solve()
    numbers, state, cost, sign = caught.value.numbers, [1.0, 0.0, 0.0], 0.0, -1
    for length in numbers.lengths:
        path = np.polynomial.Polynomial([state[0], state[1], state[2] / 2, sign / 6])
        cost += (path**2).integ()(length)
        state, sign = [path(length), path.deriv()(length), path.deriv(2)(length)], -sign
    assert np.max(np.abs(state)) < 1e-10 and abs(cost - numbers.cost) < 1e-11
    assert numbers.cost < 1.252112728 < 1.252120322 and numbers.cost_error < 1e-9
