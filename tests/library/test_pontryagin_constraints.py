"""Problems with path constraints, terminal inequalities and state-dependent bounds.

Each record has its source, the digits published there, and a value by a route of its own: a closed
form, or SciPy's integrator with the conditions written out by hand.
"""

from dataclasses import dataclass

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from trajlib.pontryagin import (
    Chattering,
    Infeasible,
    NotConverged,
    NotUnique,
    Problem,
    certify,
    synthesis,
)

R = sp.Rational
x, y, v, w, t, h, m, u, theta, a, b = sp.symbols("x y v w t h m u theta a b")


@dataclass
class Record:
    """A problem, its arcs, junction times (None: not compared) and cost by another route."""

    problem: Problem
    arcs: list
    times: list | None
    cost: float
    source: str
    tolerance: float = 1e-10
    published: float | None = None
    published_tolerance: float = 0.0


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
        "Bryson, Denham and Dreyfus 1963; Bryson and Ho, Applied Optimal Control",
    )


def goddard_by_feedback():
    """Full thrust, the singular surface, v = 1/10 held until the fuel is spent, coasting to rest."""
    c, limit = 0.5, 0.1

    def drag(h, v):
        return 310 * v**2 * np.exp(-500 * (h - 1))

    def surface(_, z):
        return drag(z[0], z[1]) * (1 + z[1] / c) - z[2] / z[0] ** 2

    def singular_thrust(z):
        h, v, m = z
        D = drag(h, v)
        by_h = -500 * D * (1 + v / c) + 2 * m / h**3
        by_v, by_m = 2 * D / v * (1 + v / c) + D / c, -1 / h**2
        return (by_v * (D / m + 1 / h**2) - by_h * v) / (by_v / m - by_m / c)

    stages = [
        (lambda z: 3.5, surface),
        (singular_thrust, lambda _, z: z[1] - limit),
        (lambda z: drag(z[0], limit) + z[2] / z[0] ** 2, lambda _, z: z[2] - 0.6),
        (lambda z: 0.0, lambda _, z: z[1]),
    ]
    z, time, times = np.array([1.0, 0.0, 1.0]), 0.0, []
    for thrust, end in stages:

        def rate(_, z, thrust=thrust):
            force = thrust(z)
            return [z[1], (force - drag(z[0], z[1])) / z[2] - 1 / z[0] ** 2, -force / c]

        end.__dict__.update(terminal=True) if hasattr(end, "__dict__") else None

        def stop(s, z, end=end):
            return end(s, z)

        stop.terminal = True
        run = solve_ivp(
            rate, (0, 1), z, events=stop, rtol=1e-13, atol=1e-15, method="DOP853", max_step=1e-3
        )
        z, time = run.y[:, -1], time + run.t[-1]
        times.append(time)
    return z[0], times


def goddard():
    drag = 310 * v**2 * sp.exp(-500 * (h - 1))
    cost, times = goddard_by_feedback()
    return Record(
        Problem(
            {h: v, v: (R(7, 2) * u - drag) / m - 1 / h**2, m: -7 * u},
            {u: (0, 1)},
            {h: 1, v: 0, m: 1},
            [m - R(3, 5)],
            final=h,
            maximise=True,
            path=[v <= R(1, 10)],
        ),
        ["u+", "singular", "boundary", "u-"],
        times[:3],
        cost,
        "published switchings 0.02350968, 0.05973738, 0.10157134 and final time 0.2020474405",
        1e-9,
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
        "Bryson and Ho, Applied Optimal Control; three arcs in closed form",
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
        "Jacobson and Lele 1969; MISER3 manual, problem 2; TOMLAB prints 0.1698243 with 50 points",
        1e-9,
        0.16982,
        1e-5,
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
        "Maurer and Augustin 2001; Betts 2010, example 4.6: 44.80444 (PSOPT prints 44.77625)",
        1e-8,
        44.80444,
        6e-6,
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
        "shortest path around a disc: two tangents and an arc",
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
        "touch point on a disc, order two: closed form by symmetry",
    )


tau = np.arccosh(2.0)
RECORDS = {
    "Bryson-Denham 1/4": bryson_denham(R(1, 4)),
    "Bryson-Denham 1/5": bryson_denham(R(1, 5)),
    "Bryson-Denham 1/6": bryson_denham(R(1, 6)),
    "Bryson-Denham 1/9": bryson_denham(R(1, 9)),
    "speed limit, least time": Record(
        double_integrator(terminal={x: 10, v: 0}, path=[sp.Abs(v) <= 2]),
        ["u+", "boundary 1", "u-"],
        [2, 5],
        7,
        "trapezium of speeds, textbook",
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
        "parabolas of speed to the limit; order one",
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
        "seven segments of bounded jerk: T = x/v + v/a + a/j; orders two and one",
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
        "T = x/v + 2 sqrt(v/j); order two",
    ),
    "bound that depends on time": Record(
        Problem({x: u, t: 1}, {u: (-1, 1 - t / 4)}, {x: 0, t: 0}, [x - 1]),
        ["u+"],
        [],
        4 - 2 * np.sqrt(2),
        "t - t^2/8 = 1",
    ),
    "boundary to the end": Record(
        Problem(
            {x: u}, {u: None}, {x: 1}, running=(x**2 + u**2) / 2, duration=3, path=[x >= R(1, 2)]
        ),
        ["interior", "boundary"],
        [tau],
        np.sqrt(3) / 4 + (3 - tau) / 8,
        "x = cosh(t - arccosh 2)/2; order one",
    ),
    "terminal inequality": Record(
        double_integrator(terminal=[x - 1, v <= R(1, 2)]),
        ["u+", "u-"],
        [np.sqrt(9 / 8)],
        2 * np.sqrt(9 / 8) - 0.5,
        "v1^2/2 + (v1^2 - 1/4)/2 = 1",
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
        "straight line to the nearest point",
    ),
    "terminal inequality, free duration": Record(
        Problem({x: u}, {u: (-1, 1)}, {x: 0}, [x >= 1], running=1, duration=(0, 5)),
        ["u+"],
        [],
        1,
        "x = t",
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
        "straight line to the nearest point of the disc",
    ),
    "terminal inequality, inactive": Record(
        double_integrator(terminal=[x - 1, v <= R(3, 2)]), ["u+"], [], np.sqrt(2), "t^2/2 = 1"
    ),
    "state-dependent bound": Record(
        Problem({x: u}, {u: (0, x / 4)}, {x: 1}, [x - 2]), ["u+"], [], 4 * np.log(2), "x = e^(t/4)"
    ),
    "brachistochrone above a line": brachistochrone(),
    "disc, shortest path": disc(),
    "disc, least energy": disc_with_energy(),
}
SLOW = {
    "Goddard": goddard,
    "Jacobson-Lele": jacobson_lele,
    "van der Pol": van_der_pol,
    "Rayleigh": rayleigh,
}


def holds(record):
    extremal = record.problem.solve()
    assert [kind for kind, _, _ in extremal.arcs] == record.arcs
    assert abs(extremal.cost - float(record.cost)) <= record.tolerance * (1 + abs(record.cost))
    if record.times is not None:
        expected = np.array(record.times, dtype=float)
        assert np.allclose(extremal.switching_times, expected, rtol=0, atol=record.tolerance)
    if record.published:
        assert abs(extremal.cost - record.published) <= record.published_tolerance
    evidence = extremal.certificate()
    assert evidence.holds(1e-10)
    return extremal


@pytest.mark.parametrize("name", RECORDS)
def test_record(name):
    holds(RECORDS[name])


@pytest.mark.slow
@pytest.mark.parametrize("name", SLOW)
def test_record_by_integration(name):
    holds(SLOW[name]())


def test_goddard_as_published():
    extremal = goddard().problem.solve()
    published = [0.02350968, 0.05973738, 0.10157134]
    assert np.allclose(extremal.switching_times, published, rtol=0, atol=1.5e-8)
    assert abs(extremal.duration - 0.2020474405) < 1e-10


@pytest.mark.parametrize(
    ("limit", "jumps"), [(R(1, 5), [48 * (1 - R(4, 5))]), (R(1, 9), [18, 18]), (R(1, 6), [16])]
)
def test_jumps_of_the_costate(limit, jumps):
    """nu = 48 (1 - 4 l) at a touch point, 2/(9 l^2) at both ends of a boundary arc."""
    extremal = bryson_denham(limit).problem.solve()
    assert np.allclose([nu for _, _, nu in extremal.jumps], np.array(jumps, float), rtol=1e-10)
    assert extremal.optimality.proved
    assert np.allclose(extremal.path_multiplier(np.linspace(0, 1, 11)), 0)


def test_multiplier_along_a_boundary_arc():
    """x = 1/2 held: psi = u = 0, and psi' = x + eta (-1) gives eta = 1/2."""
    extremal = RECORDS["boundary to the end"].problem.solve()
    assert np.allclose(extremal.path_multiplier([1.0, 2.0, 2.9]), [[0, 0.5, 0.5]], atol=1e-10)


@pytest.mark.parametrize("factor", [R(1, 10**4), 10**4])
def test_other_units(factor):
    """Lengths in other units: the same arcs, the cost times the square of the factor."""
    problem = Problem(
        {x: v, v: u},
        {u: None},
        {x: 0, v: factor},
        {x: 0, v: -factor},
        running=u**2 / 2,
        duration=1,
        path=[x <= factor / 9],
    )
    extremal = problem.solve()
    assert abs(extremal.cost / factor**2 - 4) < 1e-9
    assert np.allclose(extremal.switching_times, [1 / 3, 2 / 3], atol=1e-9)
    assert np.allclose([float(nu / factor) for _, _, nu in extremal.jumps], 18)
    assert extremal.certificate().holds()


def test_inactive_constraint():
    free = double_integrator(terminal={x: 1, v: 0})
    limited = double_integrator(terminal={x: 1, v: 0}, path=[v <= 2])
    assert abs(limited.solve().cost - free.solve().cost) < 1e-14
    assert not limited.solve().touches_boundary


def test_conditions():
    problem = bryson_denham(R(1, 9)).problem
    (constraint,) = problem.conditions().path
    psi1, psi2 = problem.conditions().costate
    assert constraint.order == 2
    assert constraint.derivatives == (x - R(1, 9), v, u)
    assert constraint.boundary_control == {u: 0}
    assert constraint.conditions == (psi2, -psi1)
    assert constraint.density == 0
    assert constraint.adjoint[psi1] == constraint.multiplier
    shown = problem.conditions()._repr_markdown_()
    assert "of order $p = 2$" in shown and r"\nu \ge 0" in shown


def test_conditions_of_goddard():
    """v = 1/10: thrust is drag plus weight."""
    (constraint,) = goddard().problem.conditions().path
    assert constraint.order == 1
    force = 310 * v**2 * sp.exp(500 - 500 * h) + m / h**2
    assert sp.simplify(constraint.boundary_control[u] * R(7, 2) - force) == 0


def test_certificate_finds_what_is_wrong():
    """Each condition of a constraint has a trajectory that violates it alone."""
    problem = Problem({x: u}, {u: (-1, 1)}, {x: 0}, running=x, duration=2, path=[x >= -1])
    sections = [1.0]

    def state(s):
        return [np.maximum(-s, -1.0)]

    def control(s):
        return [np.where(s < 1, -1.0, 0.0)]

    def costate(s):
        return [np.where(s < 1, s - 1, 0.0)]

    def failures(q=state, p=costate, r=control, problem=problem):
        return certify(problem, q, p, r, 2, sections).failures()

    assert failures() == []
    assert failures(problem=Problem(**arguments(problem, path=[x >= -R(1, 2)]))) == [
        "adjoint",
        "path",
    ]
    # eta < 0: for the opposite cost the state is not to be kept at the boundary.
    opposite = Problem(**arguments(problem, running=-x))
    assert "sign" in failures(p=lambda s: [0 * s], problem=opposite)
    # A costate that jumps where no constraint is active.
    assert (
        "jumps"
        in certify(
            problem,
            state,
            lambda s: [np.where(s < 0.5, s - 2, costate(s)[0])],
            control,
            2,
            [0.5, 1.0],
        ).failures()
    )


def arguments(problem, **changed):
    names = ("dynamics", "controls", "initial", "running", "duration", "path")
    return {name: getattr(problem, name) for name in names} | changed


def test_certificate_between_grid_points():
    """A narrow peak of the state between all samples is found."""
    problem = Problem({x: u}, {u: None}, {x: 0}, running=u**2, duration=1, path=[x <= R(1, 2)])

    def state(s):
        return [0.5 + 1e-3 - 2 * (s - 0.50321) ** 2]

    evidence = certify(problem, state, lambda s: [0 * s], lambda s: [-4 * (s - 0.50321)], 1)
    assert abs(evidence.path - 1e-3) < 1e-9


@pytest.mark.parametrize(
    ("error", "text", "arguments"),
    [
        (TypeError, "path: expected inequalities", {"path": [x]}),
        (TypeError, "path: expected inequalities", {"path": [sp.Eq(x, 1)]}),
        (TypeError, "path: expected inequalities", {"path": [x < 1]}),
        (TypeError, "path: expected a list", {"path": "x <= 1"}),
        (ValueError, "path: .* does not depend on the state", {"path": [t <= 1]}),
        (ValueError, "path: .* is a second upper bound of u", {"path": [u <= x]}),
        (ValueError, "path: .* neither a constraint", {"path": [u**2 + x**2 <= 1]}),
        (
            ValueError,
            "first_return: not provided",
            {"path": [v <= 1], "terminal": [x], "first_return": True},
        ),
        (ValueError, "path: .* is not smooth", {"path": [sp.Max(x, v) <= 1]}),
        (ValueError, "path: the same inequality", {"path": [x <= 1, x <= 1]}),
        (ValueError, "terminal: .* contains a control", {"terminal": [x - 1, u <= 1]}),
    ],
)
def test_statements_that_are_refused(error, text, arguments):
    with pytest.raises(error, match=text):
        double_integrator(**{"terminal": {x: 1, v: 0}} | arguments)


@pytest.mark.parametrize(
    ("error", "text", "problem"),
    [
        (
            Infeasible,
            "initial state violates",
            double_integrator(terminal=[x - 1], path=[x >= R(1, 2)]),
        ),
        (
            Infeasible,
            "final state violates",
            double_integrator(terminal=[x - 1], path=[x <= R(1, 2)]),
        ),
        (
            Chattering,
            "order 3",
            Problem(
                {x: v, v: w, w: u},
                {u: None},
                {x: 1, v: -2, w: 0},
                running=x + u**2 / 2,
                duration=10,
                path=[x >= 0],
            ),
        ),
        (
            NotUnique,
            "multiplier is not unique",
            Problem({x: u}, {u: (0, 1)}, {x: 0}, running=(x - 2) ** 2, duration=2, path=[x <= 1]),
        ),
        (
            ValueError,
            "contains a control",
            Problem({x: v, v: -x, w: u}, {u: (0, 1)}, {x: 0, v: 1, w: 0}, [w - 1], path=[x <= 2]),
        ),
    ],
)
def test_problems_that_are_refused(error, text, problem):
    with pytest.raises(error, match=text):
        problem.solve()


def test_given_structures_and_syntheses_are_refused():
    problem = double_integrator(terminal={x: 1, v: 0}, path=[v <= R(1, 2)])
    with pytest.raises(ValueError, match="structure: with path constraints"):
        problem.solve(structure=["u+", "u-"])
    with pytest.raises(ValueError, match="problem: a planar synthesis"):
        synthesis(problem)
    assert not problem.solve().certificate(proved=True).holds


def test_contact_that_steps_pass_over():
    """Braking from v = 1 takes 1/2: no process exists, and none is returned."""
    problem = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 0, v: 1}, {x: 0, v: -1}, path=[x <= R(1, 4)])
    with pytest.raises(NotConverged, match="pass beyond it between them"):
        problem.solve()


def test_extremal_is_shown():
    import matplotlib

    matplotlib.use("agg")
    extremal = RECORDS["limits of speed and acceleration"].problem.solve()
    assert len(extremal.plot()) == 4
    assert "boundary 2" in extremal._repr_markdown_()
    assert "path constraints" in extremal.certificate()._repr_markdown_()
