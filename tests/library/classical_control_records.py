"""Classical problems of optimal control that are short to state, each with a second route.

Those of public collections (COPS, OptimalControl.jl, PSOPT, Bocop) and of textbooks. Second routes
are closed forms, or SciPy on conditions that were written out by hand. Nothing here is a test.
"""

import numpy as np
import sympy as sp
from control_record import Record
from scipy.integrate import quad, solve_bvp, solve_ivp
from scipy.optimize import brentq, fsolve, minimize

from trajlib.pontryagin import Problem

R = sp.Rational
x, y, v, w, t, h, u, theta, c, k = sp.symbols("x y v w t h u theta c k")
x1, x2, x3, x4, u1, u2 = sp.symbols("x1:5 u1:3")
ONE, FREE, CAR = {u: (-1, 1)}, {u: None}, {x: v, v: u}
COLLECTION = "problems of OptimalControl.jl"
BRYSON = "Bryson and Ho, Applied Optimal Control, 1975"
COPS = "COPS collection of Dolan and More"
BOUNDARY = "SciPy: solve_bvp for the conditions of the maximum principle"


def integrated(rate, span, start):
    """Return the end of a motion, to about twelve digits."""
    return solve_ivp(rate, span, start, rtol=1e-13, atol=1e-14, method="DOP853").y[:, -1]


def integral(f, a, b):
    return quad(f, a, b, epsabs=1e-13, epsrel=1e-13)[0]


def boundary_cost(rate, ends, guess, T, tolerance=1e-11):
    """Return the last component at T of a boundary value problem, whose density is the cost."""
    nodes = np.linspace(0, T, 400)
    solution = solve_bvp(rate, ends, nodes, guess(nodes), tol=tolerance, max_nodes=200_000)
    assert solution.success, solution.message
    return solution.y[-1, -1]


def transfer(problem, arcs, times, cost, route="closed form", source=COLLECTION, **more):
    return lambda: Record(problem, arcs, times, cost, route, source, **more)


def gramian_cost(response, error, T, weight=lambda s: 1.0):
    """Return the least energy int u^2/2 of a linear plant by its Gramian."""
    rows = range(len(error))
    W = [
        [integral(lambda s: response[i](s) * response[j](s) * weight(s), 0, T) for j in rows]
        for i in rows
    ]
    return error @ np.linalg.solve(W, error) / 2


def oscillator_energy():
    cost = gramian_cost([np.sin, np.cos], np.array([np.cos(2), -np.sin(2)]), 2)
    problem = Problem({x: v, v: -x + u}, FREE, {x: 1, v: 0}, [x, v], running=u**2 / 2, duration=2)
    return Record(problem, ["interior"], [], cost, "Gramian by SciPy's quad")


def falling_mass():
    """The mass falls as 1 - t/4."""
    cost = gramian_cost(
        [lambda s: 2 - s, lambda s: 1.0], np.array([1.0, 0]), 2, lambda s: 1 / (1 - s / 4) ** 2
    )
    problem = Problem(
        {x: v, v: u / (1 - t / 4)},
        FREE,
        {x: 0, v: 0},
        [x - 1, v],
        running=u**2 / 2,
        duration=2,
        time=t,
    )
    return Record(problem, ["interior"], [], cost, "Gramian by SciPy's quad")


def oscillator_time():
    def moved(state, pull, s):
        a, b = state[0] - pull, state[1]
        return a * np.cos(s) + b * np.sin(s) + pull, b * np.cos(s) - a * np.sin(s)

    lengths = fsolve(lambda z: moved(moved((1.0, 0.0), -1, z[0]), 1, z[1]), [0.6, 0.9], xtol=1e-12)
    problem = Problem({x: v, v: -x + u}, ONE, {x: 1, v: 0}, [x, v])
    return Record(
        problem,
        ["u-", "u+"],
        [lengths[0]],
        sum(lengths),
        "two circles in the phase plane",
        "Pontryagin and others 1962, section 5",
    )


def linear_tangent_steering():
    """The tangent of the thrust angle is linear in time; thrust 100."""

    def rate(s, state, p, q):
        angle = np.arctan(p - q * s)
        return [state[1], 100 * np.cos(angle), state[3], 100 * np.sin(angle)]

    def excess(z):
        end = integrated(lambda s, state: rate(s, state, *z[1:]), (0, z[0]), [0.0] * 4)
        return end[1:] - [45, 5, 0]

    problem = Problem(
        {x1: x2, x2: 100 * sp.cos(u), x3: x4, x4: 100 * sp.sin(u)},
        FREE,
        dict.fromkeys((x1, x2, x3, x4), 0),
        [x2 - 45, x3 - 5, x4],
    )
    return Record(
        problem,
        ["interior"],
        [],
        fsolve(excess, [0.55, 1.2, 4], xtol=1e-12)[0],
        "SciPy: shooting with the bilinear tangent law",
        COPS,
        published=(("COPS", 0.554571, 1e-6),),
    )


def hypersensitive():
    def rate(s, z):
        a, p, _ = z
        return np.array([-(a**3) + p / 2, 2 * a + 3 * a**2 * p, a**2 + p**2 / 4])

    cost = boundary_cost(
        rate,
        lambda a, b: np.array([a[0] - 1.5, b[0] - 1, a[2]]),
        lambda s: np.array([1.5 * np.exp(-s) + np.exp(s - 25), -np.exp(-s), 0 * s]),
        25,
    )
    problem = Problem(
        {x: -(x**3) + u}, FREE, {x: R(3, 2)}, {x: 1}, running=x**2 + u**2, duration=25
    )
    return Record(
        problem, ["interior"], [], cost, BOUNDARY, "Rao and Mease 2000, with the duration 25"
    )


def dubins():
    """Left turn, straight line, left turn to (4, 4) with a heading turned by a right angle."""
    problem = Problem(
        {x: sp.cos(theta), y: sp.sin(theta), theta: u},
        ONE,
        {x: 0, y: 0, theta: 0},
        [x - 4, y - 4, theta - sp.pi / 2],
    )
    straight = np.hypot(3, 3)
    times = [np.pi / 4, np.pi / 4 + straight]
    return Record(
        problem,
        ["u+", "singular", "u+"],
        times,
        straight + np.pi / 2,
        "closed form: tangents of two circles",
        "Dubins 1957",
    )


def landing():
    """h'' = u - 1 from the height 10 at the speed -1: free fall, then full thrust 2."""
    fall = brentq(lambda s: (10 - s - s * s / 2) - (1 + s) ** 2 / 2, 0, 4)
    problem = Problem({h: v, v: u - 1}, {u: (0, 2)}, {h: 10, v: -1}, [h, v], running=u)
    return Record(
        problem,
        ["u-", "u+"],
        [fall],
        2 * (fall + 1),
        "closed form: two parabolas",
        "Meditch 1964, with a constant mass",
    )


def hanging_chain():
    """x = a cosh((s - b)/a) + c with length 4."""

    def excess(z):
        a, b, c = z
        return [
            a * np.cosh(b / a) + c - 1,
            a * np.cosh((1 - b) / a) + c - 3,
            a * (np.sinh((1 - b) / a) + np.sinh(b / a)) - 4,
        ]

    a, b, shift = fsolve(excess, [0.2, 0.4, 0.8], xtol=1e-12)
    cost = integral(lambda s: (a * np.cosh((s - b) / a) + shift) * np.cosh((s - b) / a), 0, 1)
    length = sp.sqrt(1 + u**2)
    problem = Problem(
        {x: u, y: length}, FREE, {x: 1, y: 0}, [x - 3, y - 4], running=x * length, duration=1
    )
    return Record(
        problem,
        ["interior"],
        [],
        cost,
        "closed form: catenary",
        COPS,
        published=(("COPS", 5.06848, 1e-5),),
    )


def van_der_pol_quadratic():
    def rate(s, z):
        a, b, p, q, _ = z
        pull = p / 2
        return np.array(
            [
                (1 - b**2) * a - b + pull,
                a,
                2 * a - p * (1 - b**2) - q,
                2 * b + p * (2 * a * b + 1),
                a**2 + b**2 + pull**2,
            ]
        )

    cost = boundary_cost(
        rate,
        lambda a, b: np.array([a[0], a[1] - 1, b[2], b[3], a[4]]),
        lambda s: np.array([-s * np.exp(-s) / 2, np.exp(-s), 0 * s, -np.exp(-s), s]),
        5,
    )
    problem = Problem(
        {x1: (1 - x2**2) * x1 - x2 + u, x2: x1},
        FREE,
        {x1: 0, x2: 1},
        running=x1**2 + x2**2 + u**2,
        duration=5,
    )
    return Record(
        problem, ["interior"], [], cost, BOUNDARY, "Bocop examples, without bounds of the control"
    )


def batch_reactor():
    """H is concave in u: u = p2/p1 - 1 up to 5, with p2 = 1."""

    def end(first):
        def rate(s, z, pull=None):
            a, p = z[:2]
            pull = max(1 / p - 1, 0) if pull is None else pull
            return [-(pull + pull**2 / 2) * a, p * (pull + pull**2 / 2) - pull, pull * a]

        def full(s, z):
            return z[1] - 1 / 6

        full.terminal, full.direction = True, -1
        run = solve_ivp(
            rate, (0, 1), [1, first, 0], rtol=1e-13, atol=1e-14, events=full, method="DOP853"
        )
        return (
            integrated(lambda s, z: rate(s, z, 5), (run.t[-1], 1), run.y[:, -1])
            if run.t[-1] < 1
            else run.y[:, -1]
        )

    first = brentq(lambda p: end(p)[1], 0.5, 0.75, xtol=1e-15)
    problem = Problem(
        {x: -(u + u**2 / 2) * x, y: u * x},
        {u: (0, 5)},
        {x: 1, y: 0},
        final=y,
        maximise=True,
        duration=1,
    )
    return Record(
        problem,
        ["interior", "u+"],
        None,
        end(first)[2],
        "SciPy: shooting for the first costate",
        "Bocop examples; Dadebo and McAuley 1995",
        published=(("Dadebo and McAuley", 0.573545, 1e-6),),
    )


def singular_regulator():
    """u = -1, then u = x on the curve v^2 - x^2 = -x(5)^2, which ends with v = 0."""
    switch = brentq(lambda s: np.tanh(5 - s) - (s - 1) / (s - s * s / 2), 1.01, 1.9, xtol=1e-15)
    end = (switch - switch**2 / 2) / np.cosh(5 - switch)
    cost = integral(lambda s: (s - s * s / 2) ** 2 + (1 - s) ** 2, 0, switch)
    cost += end**2 * np.sinh(2 * (5 - switch)) / 2
    problem = Problem(CAR, ONE, {x: 0, v: 1}, running=x**2 + v**2, duration=5)
    return Record(
        problem,
        ["u-", "singular"],
        [switch],
        cost,
        "closed form: parabola and hyperbola",
        "Jacobson, Gershwin and Lele 1970; Aly 1978",
    )


def stirred_tank():
    def rate(s, z):
        a, b, p, q, _ = z
        E = np.exp(25 * a / (a + 2))
        pull = -5 * p * (a + 0.25)
        slope = (b + 0.5) * E * 50 / (a + 2) ** 2
        return np.array(
            [
                -2 * (a + 0.25) + (b + 0.5) * E - pull * (a + 0.25),
                0.5 - b - (b + 0.5) * E,
                2 * a + p * (2 - slope + pull) + q * slope,
                2 * b - p * E + q * (1 + E),
                a**2 + b**2 + pull**2 / 10,
            ]
        )

    cost = boundary_cost(
        rate,
        lambda a, b: np.array([a[0] - 0.05, a[1], b[2], b[3], a[4]]),
        lambda s: np.array([0.05 - s / 20, -s / 20, s / 2 - 0.5, s / 10 - 0.1, s / 10]),
        0.78,
    )
    E = sp.exp(25 * x1 / (x1 + 2))
    problem = Problem(
        {
            x1: -2 * (x1 + R(1, 4)) + (x2 + R(1, 2)) * E - u * (x1 + R(1, 4)),
            x2: R(1, 2) - x2 - (x2 + R(1, 2)) * E,
        },
        FREE,
        {x1: R(1, 20), x2: 0},
        running=x1**2 + x2**2 + u**2 / 10,
        duration=R(39, 50),
    )
    return Record(
        problem,
        ["interior"],
        [],
        cost,
        BOUNDARY,
        "Luus 1990, stirred tank reactor with the initial state (0.05, 0)",
        tolerance=1e-9,
    )


def zermelo_in_shear():
    """psi_1 is constant and psi_2 linear in time."""

    def excess(z):
        T, p, q = z
        end = integrated(
            lambda s, state: [
                p / np.hypot(p, q + p * s) - state[1],
                (q + p * s) / np.hypot(p, q + p * s),
            ],
            (0, T),
            [3.66, -1.86],
        )
        return [*end, p**2 + q**2 - 1]

    problem = Problem(
        {x: sp.cos(theta) - y, y: sp.sin(theta)},
        {theta: None},
        {x: R(183, 50), y: -R(93, 50)},
        [x, y],
    )
    return Record(
        problem,
        ["interior"],
        [],
        fsolve(excess, [5.46, -0.26, 0.97], xtol=1e-12)[0],
        "SciPy: shooting with psi_2 = q + p t",
        f"{BRYSON}, section 2.7",
        published=(("p. 81", 5.46, 5e-3),),
    )


def orbit_raising():
    """Largest radius after 3.3207 with the thrust 0.1405 and the mass 1 - 0.0749 t."""

    def rate(s, z):
        r, a, b, p, q, m = z
        push = 0.1405 / (1 - 0.0749 * s) / np.hypot(q, m)
        return np.array(
            [
                a,
                b**2 / r - 1 / r**2 + push * q,
                -a * b / r + push * m,
                q * (b**2 / r**2 - 2 / r**3) - m * a * b / r**2,
                -p + m * b / r,
                -2 * q * b / r + m * a / r,
            ]
        )

    def ends(a, b):
        circular = b[3] - 1 - b[5] / (2 * b[0] ** 1.5)
        return np.array([a[0] - 1, a[1], a[2] - 1, b[1], b[2] - 1 / np.sqrt(b[0]), circular])

    nodes = np.linspace(0, 3.3207, 400)
    one = np.ones_like(nodes)
    guess = np.array(
        [1 + 0.15 * nodes, 0.1 * one, 1 - 0.05 * nodes, one, 0.5 - 0.15 * nodes, 0.5 * one]
    )
    solution = solve_bvp(rate, ends, nodes, guess, tol=1e-11, max_nodes=100_000)
    push = 1405 / (10000 - 749 * t)
    problem = Problem(
        {
            x1: x2,
            x2: x3**2 / x1 - 1 / x1**2 + push * sp.sin(u),
            x3: -x2 * x3 / x1 + push * sp.cos(u),
        },
        FREE,
        {x1: 1, x2: 0, x3: 1},
        [x2, x3 - 1 / sp.sqrt(x1)],
        final=x1,
        maximise=True,
        duration=R(33207, 10000),
        time=t,
    )
    return Record(
        problem,
        ["interior"],
        [],
        solution.y[0, -1],
        BOUNDARY,
        f"{BRYSON}, section 2.5",
        published=(("p. 67", 1.525, 1e-3),),
    )


def logarithmic_growth():
    """c grows as exp(t/20)."""
    first = (1 - np.exp(-1) / 2) / integral(lambda s: np.exp(-s / 20), 0, 10)
    gain = integral(lambda s: np.exp(-s / 20) * (np.log(first) + s / 20), 0, 10)
    problem = Problem(
        {k: k / 10 - c},
        {c: (R(1, 100), None)},
        {k: 1},
        [k - R(1, 2)],
        running=sp.exp(-t / 20) * sp.log(c),
        maximise=True,
        duration=10,
        time=t,
    )
    return Record(
        problem,
        ["interior"],
        [],
        gain,
        "closed form: Euler equation",
        "Ramsey 1928, with a linear yield and numbers of our own",
    )


def catenoid():
    a = brentq(lambda a: a * np.cosh(1 / (2 * a)) - 1, 0.6, 2, xtol=1e-15)
    problem = Problem({x: u}, FREE, {x: 1}, [x - 1], running=x * sp.sqrt(1 + u**2), duration=1)
    return Record(
        problem,
        ["interior"],
        [],
        a / 2 + a**2 / 2 * np.sinh(1 / a),
        "closed form: catenary",
        "Euler 1744, minimal surface of revolution",
    )


def catalyst_mixing():
    """u = 1, the constant singular control, u = 0: the best lengths and the best constant."""

    def end(z):
        state = [1.0, 0.0]
        for pull, length in ((1, z[0]), (z[1], z[2] - z[0]), (0, 1 - z[2])):
            state = integrated(
                lambda s, q, pull=pull: [
                    pull * (10 * q[1] - q[0]),
                    pull * (q[0] - 10 * q[1]) - (1 - pull) * q[1],
                ],
                (0, length),
                state,
            )
        return sum(state) - 1

    best = minimize(
        end, [0.136, 0.227, 0.72], method="Nelder-Mead", options={"xatol": 1e-8, "fatol": 1e-14}
    ).fun
    problem = Problem(
        {x1: u * (10 * x2 - x1), x2: u * (x1 - 10 * x2) - (1 - u) * x2},
        {u: (0, 1)},
        {x1: 1, x2: 0},
        final=1 - x1 - x2,
        maximise=True,
        duration=1,
    )
    return Record(
        problem,
        ["u+", "singular", "u-"],
        None,
        -best,
        "SciPy: Nelder-Mead over three numbers",
        COPS,
        published=(("COPS", 0.0480556, 1e-6),),
    )


def pendulum():
    def rate(s, z):
        a, b, p, q, _ = z
        return np.array([b, q - np.sin(a), q * np.cos(a), -p, q**2 / 2])

    cost = boundary_cost(
        rate,
        lambda a, b: np.array([a[0], a[1], b[0] - np.pi, b[1], a[4]]),
        lambda s: np.array(
            [
                np.pi * np.sin(np.pi * s / 12),
                np.cos(np.pi * s / 12),
                0.3 * (1 - s),
                0.8 - 0.2 * s,
                s / 6,
            ]
        ),
        6,
    )
    problem = Problem(
        {theta: w, w: u - sp.sin(theta)},
        FREE,
        {theta: 0, w: 0},
        [theta - sp.pi, w],
        running=u**2 / 2,
        duration=6,
    )
    return Record(problem, ["interior"], [], cost, BOUNDARY)


def quadratic_drag():
    """tanh up to the switching, tan after it."""
    a, b, pull = sp.symbols("x v u", real=True)
    first, second = fsolve(
        lambda z: [np.tanh(z[0]) - np.tan(z[1]), np.log(np.cosh(z[0])) - np.log(np.cos(z[1])) - 1],
        [1.3, 0.7],
        xtol=1e-12,
    )
    problem = Problem({a: b, b: pull - sp.Abs(b) * b}, {pull: (-1, 1)}, {a: 0, b: 0}, {a: 1, b: 0})
    return Record(problem, ["u+", "u-"], [first], first + second, "closed form: tanh and tan")


def two_masses():
    """Two masses with a spring: y'' = u/2 and d'' = u - 2 d, symmetric about the middle."""

    def end(z):
        pulls, cuts = [1, -1, 1, -1], [0, z[0], z[1], 2 * z[1] - z[0], 2 * z[1]]
        a, b, p, q = 0.0, 0.0, 0.0, 0.0
        w = np.sqrt(2)
        for pull, begin, stop in zip(pulls, cuts, cuts[1:]):
            s, e = stop - begin, p - pull / 2
            a, b = a + b * s + pull * s**2 / 4, b + pull * s / 2
            p, q = (
                pull / 2 + e * np.cos(w * s) + q / w * np.sin(w * s),
                q * np.cos(w * s) - w * e * np.sin(w * s),
            )
        return [a - 1, p]

    first, middle = fsolve(end, [1.0, 2.1], xtol=1e-12)
    problem = Problem(
        {x1: x3, x2: x4, x3: u - (x1 - x2), x4: x1 - x2},
        ONE,
        dict.fromkeys((x1, x2, x3, x4), 0),
        [x1 - 1, x2 - 1, x3, x4],
    )
    return Record(
        problem,
        ["u+", "u-", "u+", "u-"],
        [first, middle, 2 * middle - first],
        2 * middle,
        "closed form: two equations for the switching times",
        "Singh, Kar and Vadali 1989, with masses and stiffness 1",
    )


def harvest():
    """No harvest up to the level 0.45, which is kept, then the full harvest."""
    level = 0.45
    grown = np.log(level * 3 / (1 - level))
    last = integral(lambda q: 1 / (0.5 - q + q * q), 0.25, level)
    cuts = [grown, 10 - last, 10]
    a, b, c = (10 * np.exp(-cut / 10) for cut in cuts)
    problem = Problem(
        {x: x * (1 - x) - u},
        {u: (0, R(1, 2))},
        {x: R(1, 4)},
        [x - R(1, 4)],
        running=u * sp.exp(-t / 10),
        maximise=True,
        duration=10,
        time=t,
    )
    return Record(
        problem,
        ["u-", "singular", "u+"],
        cuts[:2],
        level * (1 - level) * (a - b) + (b - c) / 2,
        "closed form: logistic growth and the golden rule",
        "Clark, Mathematical Bioeconomics, 1976, with numbers of our own",
    )


def scalar_regulator():
    cost = integrated(lambda s, p: 2 * p - p**2 + 1, (0, 1), [1.0])[0]
    problem = Problem({x: x + u}, FREE, {x: 1}, running=x**2 + u**2, final=x**2, duration=1)
    return Record(problem, ["interior"], [], cost, "SciPy: Riccati equation", "Kalman 1960")


def sphere():
    """The energy of a shortest path is the square of its length."""
    length = np.arccos(np.cos(np.pi / 4) * np.cos(np.pi / 3))
    problem = Problem(
        {x: u1, y: u2},
        {u1: None, u2: None},
        {x: 0, y: 0},
        [x - sp.pi / 4, y - sp.pi / 3],
        running=u1**2 + sp.cos(x) ** 2 * u2**2,
        duration=1,
    )
    return Record(problem, [("interior", "interior")], [], length**2, "closed form: great circle")


ROOT = 18**0.25
WAIT = (3 - 5**0.5) / 2
CLASSICAL = {
    "double integrator, least time": transfer(
        Problem(CAR, ONE, {x: -1, v: 0}, [x, v]), ["u+", "u-"], [1.0], 2.0
    ),
    "double integrator, least energy": transfer(
        Problem(CAR, FREE, {x: -1, v: 0}, [x, v], running=u**2 / 2, duration=1),
        ["interior"],
        [],
        6.0,
    ),
    "double integrator, least fuel": transfer(
        Problem(CAR, ONE, {x: -1, v: 0}, [x, v], running=sp.Abs(u), duration=3),
        ["u+", "zero", "u-"],
        [WAIT, 3 - WAIT],
        2 * WAIT,
    ),
    "double integrator, time and energy": transfer(
        Problem(CAR, FREE, {x: 0, v: 0}, {x: 1, v: 0}, running=1 + u**2 / 2),
        ["interior"],
        [],
        ROOT + 6 / ROOT**3,
        source="",
    ),
    "decay, least energy": transfer(
        Problem({x: -x + u}, FREE, {x: -1}, [x], running=u**2 / 2, duration=1),
        ["interior"],
        [],
        float(1 / (np.exp(2) - 1)),
    ),
    "decay, least time": transfer(
        Problem({x: -x + u}, ONE, {x: -1}, [x]), ["u+"], [], float(np.log(2))
    ),
    "decay, least fuel": transfer(
        Problem({x: -x + u}, ONE, {x: -1}, [x], running=sp.Abs(u), duration=1),
        ["zero", "u+"],
        [1 + float(np.log(1 - np.exp(-1)))],
        float(-np.log(1 - np.exp(-1))),
    ),
    "transfer with unequal bounds": transfer(
        Problem(CAR, {u: (-2, 1)}, {x: 0, v: 0}, {x: 300, v: 0}),
        ["u+", "u-"],
        [20.0],
        30.0,
        source="PSOPT examples",
    ),
    "triple integrator, least time": transfer(
        Problem({x: v, v: w, w: u}, ONE, {x: 0, v: 0, w: 0}, [x - 1, v, w]),
        ["u+", "u-", "u+"],
        [2 ** (-1 / 3), 3 * 2 ** (-1 / 3)],
        4 * 2 ** (-1 / 3),
        source="",
    ),
    "brachistochrone to a vertical line": transfer(
        Problem(
            {x: v * sp.cos(theta), y: v * sp.sin(theta), v: sp.sin(theta)},
            {theta: None},
            {x: 0, y: 0, v: 0},
            [x - 1],
        ),
        ["interior"],
        [],
        float(np.sqrt(np.pi)),
        "closed form: cycloid",
        BRYSON,
    ),
    "hyperbolic geodesic": transfer(
        Problem({y: u}, FREE, {y: 1}, [y - 1], running=sp.sqrt(1 + u**2) / y, duration=1),
        ["interior"],
        [],
        float(2 * np.arcsinh(0.5)),
        "closed form: circle",
        "",
    ),
    "oscillator, least energy": oscillator_energy,
    "oscillator, least time": oscillator_time,
    "double integrator with a falling mass": falling_mass,
    "linear tangent steering": linear_tangent_steering,
    "hypersensitive problem": hypersensitive,
    "Dubins car": dubins,
    "soft landing": landing,
    "hanging chain": hanging_chain,
    "van der Pol, quadratic cost": van_der_pol_quadratic,
    "batch reactor": batch_reactor,
    "singular regulator": singular_regulator,
    "stirred tank reactor": stirred_tank,
    "Zermelo's problem in a shear flow": zermelo_in_shear,
    "orbit raising": orbit_raising,
    "logarithmic growth": logarithmic_growth,
    "catenoid": catenoid,
    "catalyst mixing": catalyst_mixing,
    "pendulum, swing to the top": pendulum,
    "car with quadratic drag": quadratic_drag,
    "two masses with a spring": two_masses,
    "harvest of a logistic stock": harvest,
    "scalar regulator": scalar_regulator,
    "geodesic of the sphere": sphere,
}
