"""Problems in phases against solutions by other routes, and the conditions at the jumps."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve, minimize

from trajlib.pontryagin import NotConverged, Phase, PhasedProblem, Unbounded

R = sp.Rational
x, y, v, w, m, u, theta = sp.symbols("x y v w m u theta")
CART, REST, ONE, FREE = {x: v, v: u}, {x: 0, v: 0}, {u: (-1, 1)}, {u: None}
HALF = [x - R(1, 2)]
# The speed is halved at x = 1/2; cost: time and energy.
IMPACT = PhasedProblem(
    [
        Phase(CART, FREE, HALF, running=1 + u**2, jump={v: v / 2}),
        Phase(CART, FREE, [x - 1, v], running=1 + u**2),
    ],
    REST,
)


def test_two_constant_speeds():
    """u1 + 2 u2 = 1 with the least u1^2 + u2^2."""
    phases = [
        Phase({x: u}, FREE, running=u**2, duration=1),
        Phase({x: 2 * u}, FREE, [x - 1], running=u**2, duration=1),
    ]
    extremal = PhasedProblem(phases, {x: 0}).solve()
    assert extremal.cost == pytest.approx(0.2, rel=1e-12)
    assert extremal.optimality.proved
    first, second = extremal.phases
    assert first.control(0.3) == pytest.approx([0.2], rel=1e-12)
    assert second.control([1.5, 2]) == pytest.approx(np.array([[0.4, 0.4]]), rel=1e-12)
    assert second.state(2) == pytest.approx([1], rel=1e-12)


def energy(distance, begin, end, duration):
    """Return the least integral of u^2 from one position and speed to another."""
    mean = distance / duration
    return 4 / duration * (begin**2 + begin * end + end**2 - 3 * mean * (begin + end - mean))


@pytest.fixture(scope="module")
def impact():
    return IMPACT.solve()


def test_impact(impact):
    def cost(z):
        first, second, speed = z
        return first + second + energy(0.5, 0, speed, first) + energy(0.5, speed / 2, 0, second)

    best = minimize(
        cost, [1.2, 1.2, 0.6], method="Nelder-Mead", options={"fatol": 1e-15, "xatol": 1e-9}
    )
    assert impact.cost == pytest.approx(best.fun, rel=1e-9)
    assert [*impact.durations, impact.phases[0].state(impact.durations[0])[1]] == pytest.approx(
        best.x, rel=1e-6
    )


def test_matching_conditions(impact):
    """psi_v before is half of psi_v behind; H = 0 in both phases; psi_x jumps by a multiplier."""
    first, second = impact.phases
    before, behind = first.costate(first.end), second.costate(second.begin)
    assert before[1] == pytest.approx(behind[1] / 2, rel=1e-9)
    assert abs(before[0] - behind[0]) > 0.5
    for phase in impact.phases:
        t = np.linspace(phase.begin, phase.end, 7)
        (_, speed), psi, (force,) = phase.state(t), phase.costate(t), phase.control(t)
        assert psi[0] * speed + psi[1] * force - 1 - force**2 == pytest.approx(0, abs=1e-9)
        assert force == pytest.approx(psi[1] / 2, abs=1e-9)
    assert impact.certificate().holds()


def test_slippery_half():
    """Half of the brake is left: v = sqrt(1/2) at the border, at most sqrt(3/4) before it."""
    slippery = {u: (-R(1, 2), 1)}
    road = PhasedProblem([Phase(CART, ONE, HALF), Phase(CART, slippery, [x - 1, v])], REST).solve()
    assert road.duration == pytest.approx(np.sqrt(3) + np.sqrt(0.5), rel=1e-10)
    assert [kind for kind, _, _ in road.phases[0].arcs] == ["u+", "u-"]
    assert road.phases[0].arcs[1][1] == pytest.approx(np.sqrt(0.75), rel=1e-9)


def test_three_phases():
    """Friction on the middle third."""
    phases = [
        Phase(CART, ONE, [x - 1]),
        Phase({x: v, v: u - v}, ONE, [x - 2]),
        Phase(CART, ONE, [x - 3, v]),
    ]
    extremal = PhasedProblem(phases, REST).solve()

    def end(_t, z):
        return z[0] - 1

    end.terminal = True
    middle = solve_ivp(
        lambda t, z: [z[1], 1 - z[1]], (0, 9), [0, np.sqrt(2)], events=end, rtol=1e-12, atol=1e-12
    )
    slow = middle.y[1, -1]
    top = np.sqrt((2 + slow**2) / 2)
    expected = [np.sqrt(2), middle.t[-1], 2 * top - slow]
    assert extremal.durations == pytest.approx(expected, rel=1e-9)


def test_rocket_of_two_stages():
    """Full thrust until the fuel is spent, then a vertical throw: heights in closed form."""
    flight, thrust = {x: v, v: u / m - 1, m: -2 * u}, {u: (0, R(7, 2))}
    rocket = PhasedProblem(
        [
            Phase(flight, thrust, [m - R(1, 2)], jump={m: m - R(1, 10)}),
            Phase(flight, thrust, [m - R(1, 10), v]),
        ],
        {x: 0, v: 0, m: 1},
        final=x,
        maximise=True,
    )
    extremal = rocket.solve()
    height = speed = 0.0
    for full, empty in ((1.0, 0.5), (0.4, 0.1)):
        # v = v0 - c ln(m/m0) - t with c = 1/2 and m = m0 - 7t
        t = (full - empty) / 7
        gain = 0.5 / 7 * (full - empty - empty * np.log(full / empty))
        height += speed * t + gain - t**2 / 2
        speed += 0.5 * np.log(full / empty) - t
    assert extremal.cost == pytest.approx(height + speed**2 / 2, rel=1e-10)
    second = extremal.phases[1]
    assert second.state(second.begin)[2] == pytest.approx(0.4, rel=1e-12)


def test_ascent_of_two_stages_over_a_plane():
    """The tangent of the angle is linear in time across the staging, so two numbers remain."""
    stages = ((2, 1, 0.0, 0.5, 1.0), (1, 0.25, 0.5, 1.5, 0.4))

    def rate(thrust, flow):
        direction = [thrust / m * f(theta) for f in (sp.cos, sp.sin)]
        return {x: v, y: w, v: direction[0], w: direction[1] - 1, m: -flow}

    ascent = PhasedProblem(
        [
            Phase(rate(2, 1), {theta: None}, duration=R(1, 2), jump={m: m - R(1, 10)}),
            Phase(rate(1, R(1, 4)), {theta: None}, [y - R(3, 10), w], duration=1),
        ],
        {x: 0, y: 0, v: 0, w: 0, m: 1},
        final=v,
        maximise=True,
    )
    extremal = ascent.solve()

    def burnout(a, b):
        z = np.zeros(3)
        for thrust, flow, begin, end, mass in stages:

            def field(t, z, thrust=thrust, flow=flow, begin=begin, mass=mass):
                slope = a - b * t
                force = thrust / (mass - flow * (t - begin)) / np.hypot(1, slope)
                return [z[1], slope * force - 1, force]

            z = solve_ivp(field, (begin, end), z, rtol=1e-12, atol=1e-12).y[:, -1]
        return z

    a, b = fsolve(lambda c: burnout(*c)[:2] - [0.3, 0], [0.8, 0.6], xtol=1e-12)
    assert extremal.cost == pytest.approx(burnout(a, b)[2], rel=1e-9)
    angles = [extremal.phases[0].control(0.25)[0], extremal.phases[1].control(1.25)[0]]
    assert np.tan(angles) == pytest.approx([a - 0.25 * b, a - 1.25 * b], rel=1e-7)


def test_phases_of_given_length_may_be_too_short():
    phases = [
        Phase(CART, ONE, running=u**2, duration=1),
        Phase(CART, ONE, [x - 10, v], duration=1),
    ]
    with pytest.raises(NotConverged, match=r"terminal equations are missed by \d"):
        PhasedProblem(phases, REST).solve(starts=1)


def test_infimum_of_ever_longer_phases():
    """Without a price for the time, the energy tends to zero."""
    phases = [
        Phase(CART, FREE, HALF, running=u**2, jump={v: v / 2}),
        Phase(CART, FREE, [x - 1, v], running=u**2),
    ]
    with pytest.raises(Unbounded, match="improves with ever longer phases"):
        PhasedProblem(phases, REST).solve(starts=1)


def test_guess(impact):
    values = [
        {"duration": 1, x: [0, 0.5], v: 0.3, u: 0},
        {"duration": 1, x: [0.5, 1], v: [0.3, 0], u: 0},
    ]
    assert IMPACT.solve(guess=values).cost == pytest.approx(impact.cost, rel=1e-10)
    with pytest.raises(ValueError, match="guess: expected a list of 2 dicts"):
        IMPACT.solve(guess=values[0])
    with pytest.raises(ValueError, match="guess: m is no state or control of phase 1"):
        IMPACT.solve(guess=[{m: 1}, {}])


def test_plot(impact):
    axes = impact.plot()
    assert [ax.get_ylabel() for ax in axes] == ["state", "control", "costate"]
    times, speeds = axes[0].lines[1].get_data()
    gap = np.flatnonzero(np.isnan(speeds))[0]
    assert speeds[gap + 1] == pytest.approx(speeds[gap - 1] / 2)
    assert np.nanmax(times) == pytest.approx(impact.duration)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: PhasedProblem(Phase(CART, ONE), REST), "phases: expected a list of two phases"),
        (lambda: PhasedProblem([Phase(CART, ONE)], REST), "phases: expected a list of two phases"),
        (lambda: PhasedProblem([Phase(CART, ONE), CART], REST), "phases: expected Phase objects"),
        (
            lambda: PhasedProblem([Phase(CART, ONE), Phase(CART, ONE, jump={v: 0})], REST),
            "phases: the last phase has a jump",
        ),
        (lambda: PhasedProblem([Phase(CART, ONE)] * 2, {x: 0}), "initial: expected the states of"),
        (
            lambda: PhasedProblem([Phase({x: u}, ONE), Phase(CART, ONE)], {x: 0}),
            "jump: v begins in phase 2; give its value",
        ),
        (
            lambda: PhasedProblem([Phase(CART, ONE, jump={m: 0}), Phase(CART, ONE)], REST),
            "jump: m of phase 1 is no state of phase 2",
        ),
        (
            lambda: PhasedProblem([Phase(CART, ONE, duration=1)] * 2, REST),
            "running, final: expected a cost",
        ),
        (lambda: Phase(CART, ONE, jump={v: u}), "jump: the value of v contains u"),
        (lambda: Phase(CART, ONE, jump=[v]), "jump: expected a dict"),
        (lambda: Phase(CART, ONE, duration=sp.oo), "duration: expected a finite duration"),
        (lambda: Phase(CART, {}), "controls: expected a dict"),
        (lambda: IMPACT.solve(starts=0), "starts: expected at least one"),
    ],
)
def test_arguments(make, message):
    with pytest.raises((TypeError, ValueError), match=message):
        make()


def test_times_of_a_phase(impact):
    with pytest.raises(ValueError, match="t: expected times of the phase"):
        impact.phases[1].state(0)
