"""What is said of problems without a solution, or with more than one, before and after the search."""

import re
import threading
import time
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from trajlib.pontryagin import (
    Infeasible,
    NotConverged,
    NotUnique,
    PontryaginError,
    Problem,
    Unbounded,
    WrongStructure,
)
from trajlib.pontryagin.direct.degenerate_target import refuse_degenerate_target
from trajlib.pontryagin.direct.first_integrals import FIRST_INTEGRALS, FIXED_POINT
from trajlib.pontryagin.direct.transcription import Transcription
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.time_limit import (
    OutOfTime,
    limited,
    seconds_left,
    stopped_from_within,
)

R = sp.Rational
x, y, z, u, v = sp.symbols("x y z u v")
TWINS, FREE, ONE = {x: -x + u, y: -y + u}, {u: None}, {u: (-1, 1)}
START = {x: 1, y: R(1, 2)}
BEGIN = {x: 1, y: 0, z: 0}


@pytest.mark.parametrize(
    "problem, message",
    [
        (Problem(TWINS, ONE, START, [x, y]), r"x - y = exp\(-t\)/2 whatever .* asks for 0, which it never"),
        (Problem(TWINS, FREE, START, [x, y], running=1 + u**2), "an uncontrollable mode .* -1"),
        (Problem(TWINS, FREE, START, [x, y], running=u**2, duration=1), "does not depend on the c"),
        (Problem(TWINS, ONE, START, [x - y - R(1, 4), y], duration=(1, 2)), "at t = 0.693147 only"),
        (
            Problem({**TWINS, z: -2 * z}, ONE, {**START, z: 1}, [x - R(1, 4), y, z - R(1, 2)]),
            "at the times 0.693147 and 0.346574",
        ),
        (Problem({x: y, y: u, z: 2}, ONE, {x: 1, y: 0, z: 0}, [x, y, z + 1]), r"z (= 2\*t|begins)"),
        # Modes with complex and repeated eigenvalues: a spiral, a circle, t + 1, (t + 1) e^(-t).
        (Problem({x: -x + y, y: -x - y, z: u}, ONE, BEGIN, [x, y, z - 1]), "x = 0, y = 0, .* at once"),
        (Problem({x: y, y: -x, z: u}, ONE, BEGIN, [x - 2, z - 1]), "x - 2 = 0, .* at no time"),
        (Problem({x: y, y: -x, z: u}, ONE, BEGIN, [x, y, z - 1]), "x = 0, y = 0, .* at once"),
        (Problem({x: y, y: -x, z: u}, ONE, BEGIN, [x, z - 1], duration=(2, 4)), "x = 0, .* no time"),
        (Problem({x: y, y: 0, z: u}, ONE, {**BEGIN, y: 1}, [x, z - 1]), "eigenvalues 0"),
        (Problem({x: y - x, y: -y, z: u}, ONE, {**BEGIN, y: 1}, [x, z - 1]), "eigenvalues -1"),
        # The limit of x' = -x + u with |u| <= 1, for the units of the user as well.
        (Problem({x: -x + u}, ONE, {x: 0}, [x - 1]), "remains below 1"),
        (Problem({x: -x + u}, {u: (-R(1, 10**9), R(1, 10**9))}, {x: 0}, [x - R(2, 10**9)]), "below"),
    ],
)  # fmt: skip
@pytest.mark.timeout(60)
def test_uncontrollable_modes_are_infeasible(problem, message):
    with pytest.raises(Infeasible, match=message):
        problem.solve()


TURNED, TWO = {x: y * u, y: -x * u}, {u: (-1, 1), v: (-1, 1)}
SPHERE = {x: y * u - y / 2, y: -x * u + x / 2 + z * v, z: -y * v}
NORTH = {x: 1, y: 0, z: 0}


@pytest.mark.parametrize("unit", [1, R(1, 10**6), 10**6])
@pytest.mark.parametrize(
    "plant, controls, start, target, message",
    [
        (TURNED, ONE, {x: 1, y: 0}, [x - 2, y], r"x\*\*2 \+ y\*\*2 = \S+ .* the target asks for"),
        (TURNED, ONE, {x: 1, y: 0}, [x - 2], "asks for at least"),
        (TURNED, ONE, {x: 1, y: 0}, [x + y - 2], "asks for at least"),
        (TURNED, FREE, {x: 1, y: 0}, [x**2 + y**2 - 4], "first integral"),
        ({x: u * x, y: -u * y}, FREE, {x: 1, y: 1}, [x - 2, y - 2], r"x\*y = "),
        ({x: u, y: x * u}, ONE, {x: 0, y: 0}, [x - 1, y - 1], r"x\*\*2 - .*y.* = 0"),
        ({x: u, y: x**2 * u}, ONE, {x: 0, y: 0}, [x - 1, y - 1], r"x\*\*3 - .*y.* = 0"),
        (SPHERE, TWO, NORTH, [x, y - 1, z - 1], r"x\*\*2 \+ y\*\*2 \+ z\*\*2 = "),
        # A linear plant with a target that is not.
        ({x: y, y: -x, z: u}, ONE, {x: 0, y: 1, z: 0}, [x**2 + y**2 - 4, z - 1], "first integral"),
        # The gradient has a function that is no polynomial.
        ({x: u * sp.cos(x), y: x * u * sp.cos(x)}, ONE, {x: 0, y: 0}, [x - 1, y - 1], "y.* = 0"),
        ({x: y, y: -u * sp.sin(x)}, ONE, {x: 0, y: 0}, [x - 1], "the initial state all right-hand"),
    ],
)  # fmt: skip
@pytest.mark.timeout(60)
def test_first_integrals_are_infeasible(plant, controls, start, target, message, unit):
    table = {s: s / unit for s in plant}
    problem = Problem(
        {s: unit * f.subs(table, simultaneous=True) for s, f in plant.items()},
        controls,
        {s: unit * value for s, value in start.items()},
        [sp.expand(unit * g.subs(table, simultaneous=True)) for g in target],
    )
    with pytest.raises(Infeasible, match=message):
        problem.solve()


def test_targets_beside_first_integrals():
    """Equations of the target alone, and a plant that nothing moves, lead to no wrong verdict."""
    twice = [x**2 + y**2 - 1, x**2 + y**2 - 4]
    with pytest.raises(Infeasible):
        Problem(TURNED, ONE, {x: 1, y: 0}, twice, duration=1).solve()
    resting = Problem({x: 0, y: u * x}, FREE, {x: 2, y: 0}, [x**2 - 4], running=u**2, duration=1)
    unmoved = Problem({x: 0}, FREE, {x: 2}, [x**2 - 4], running=(u - 1) ** 2, duration=1)
    for problem in (resting, unmoved):
        numeric = NumericProblem(problem)
        assert FIRST_INTEGRALS.applies(problem) and FIXED_POINT.applies(problem)
        FIXED_POINT.check(numeric)
        FIRST_INTEGRALS.check(numeric)


@pytest.mark.parametrize("angle", [R(1, 3), 1.1, sp.pi / 5])
def test_first_integrals_that_allow_the_target(angle):
    """Also with coordinates of the target that are rounded."""
    end = [sp.cos(angle), -sp.sin(angle)]
    extremal = Problem(TURNED, ONE, {x: 1, y: 0}, [x - end[0], y - end[1]]).solve()
    assert extremal.duration == pytest.approx(float(angle), rel=1e-9)


def test_modes_that_reach_the_target():
    """The mode x - y is zero at both ends."""
    extremal = Problem(TWINS, ONE, {x: 1, y: 1}, [x, y]).solve()
    assert extremal.duration == pytest.approx(float(sp.log(2)), rel=1e-12)


def test_oscillation_that_reaches_the_target():
    """x = cos t = 1/2 first at t = pi/3; z = 1 then costs t + 1/t."""
    extremal = Problem(
        {x: y, y: -x, z: u}, ONE, BEGIN, [x - R(1, 2), z - 1], running=1 + u**2
    ).solve()
    assert extremal.duration == pytest.approx(np.pi / 3, rel=1e-12)
    assert extremal.cost == pytest.approx(np.pi / 3 + 3 / np.pi, rel=1e-12)


@pytest.mark.parametrize(
    "problem",
    [
        Problem({x: u}, ONE, {x: 1}, [x**2]),
        Problem({x: u}, FREE, {x: 1}, [x**2], running=u**2, duration=1),
        Problem({x: u}, ONE, {x: 10**6}, [x**4]),
        Problem({x: u, y: v}, {**ONE, v: (-1, 1)}, START, [x**2 + y**2], running=1 + u**2 + v**2),
        # The equation holds to 1e-17 at a distance of 3e-9.
        Problem({x: u}, ONE, {x: 1}, [sp.cos(x) - 1]),
    ],
    ids=lambda problem: str(problem.terminal[0]),
)
def test_degenerate_targets_are_named(problem):
    with pytest.raises(PontryaginError, match="gradient of .* vanishes on the target"):
        problem.solve()


@pytest.mark.parametrize("start", [2, 10**4, 1e-6])
def test_targets_with_a_normal_are_not_refused(start):
    """A path along the axis to the unit circle, from near and far."""
    circle = Problem({x: u, y: v}, {**ONE, v: (-1, 1)}, {x: start, y: 0}, [x**2 + y**2 - 1])
    path = np.stack([np.linspace(start, 1, 50), np.zeros(50)], axis=1)
    refuse_degenerate_target(NumericProblem(circle), path)


@pytest.mark.parametrize(
    ("message", "summary"),
    [
        (
            "no process was found from 7 starts (IPOPT, last status: Failed). Nothing is proved.",
            "no process was found from 7 starts (IPOPT, last status: Failed)",
        ),
        ("H (with t(0): 1.5; 2) remains 0.5: f(x(0)) = 1", "H (with t(0): 1.5; 2) remains 0.5"),
        ("the target is missed by 0.5; try again", "the target is missed by 0.5"),
        ("nothing is known", "nothing is known"),
    ],
)
def test_errors_have_a_short_sentence(message, summary):
    assert PontryaginError(message).summary == summary


# A shallow well near zero and a deep one far away.
WELLS = Problem(
    {x: u},
    FREE,
    {x: 0},
    running=u**2 / 2,
    final=-sp.exp(-((x + R(1, 2)) ** 2)) / 2 - 20 * sp.exp(-((x - 5) ** 2)),
    duration=1,
)


def test_more_starts_find_a_better_process():
    """The cost is s^2/2 + phi(s), s being the end: its least value on a fine grid."""
    s = np.linspace(-2, 8, 1000001)
    values = s**2 / 2 + sp.lambdify(x, WELLS.final)(s)
    few, many = WELLS.solve(), WELLS.solve(starts=30)
    assert many.cost == pytest.approx(np.min(values), abs=1e-9) and many.cost < few.cost - 7
    assert many.optimality.starts == 30 and many.optimality.processes > 1
    assert "locally minimal, best of 30 starts" in repr(many)
    evidence = many.certificate()
    assert evidence.holds() and evidence.optimality == many.optimality
    assert "best of 2 found from 30 starts" in evidence._repr_markdown_()


# A load on a rope, in least time, with a bound of its angle: more lists of arcs than time.
POSITION, SPEED, ANGLE, RATE = sp.symbols("p s a w")
CRANE = Problem(
    {POSITION: SPEED, SPEED: u, ANGLE: RATE, RATE: -ANGLE - u},
    {u: (-1, 1)},
    {POSITION: 0, SPEED: 0, ANGLE: 0, RATE: 0},
    {POSITION: 5, SPEED: 0, ANGLE: 0, RATE: 0},
    path=[ANGLE <= R(4, 5), ANGLE >= -R(4, 5)],
)


@pytest.mark.parametrize(
    ("seconds", "found"),
    [
        # the watcher may be late on a busy machine, so that the search has begun
        (0.001, "(before or after the search|from 0 starts)"),
        (5, "found from [0-9]+ starts?( has the cost 6.8|. Nothing is proved)"),
    ],
)
def test_time_limit_ends_any_step(seconds, found):
    begin = time.process_time()
    with pytest.raises(NotConverged, match=f"time limit is over: .*{found}"):
        replace(CRANE).solve(time_limit=seconds)
    # The rest is that between two iterations, and the time to set up a programme.
    assert time.process_time() - begin < seconds + 5


def test_a_direct_solution_ends_in_time():
    with pytest.raises(NotConverged, match="time limit is over"):
        replace(CRANE).solve_direct(2000, "hermite-simpson", time_limit=1)
    with pytest.raises(
        ValueError, match="time_limit: expected a positive number of seconds, got 0"
    ):
        CRANE.solve_direct(time_limit=0)


@pytest.mark.parametrize(
    "step",
    [
        lambda: sp.factorint(int("9" * 70 + "7")),
        lambda: [None for _ in iter(int, 1)],
    ],
)
def test_steps_that_end(step):
    threads = threading.active_count()
    with pytest.raises(OutOfTime), limited(0.2):
        step()
    assert threading.active_count() == threads
    assert seconds_left() == np.inf


def test_ipopt_ends_within_one_call(monkeypatch):
    """Also where the programme was set up long before: the time is that of the whole `solve`."""
    left = iter([5.0, 5.0, 5.0, 5.0, 0.0, 0.0])
    for module in ("direct.ipopt", "problem.time_limit"):
        monkeypatch.setattr(f"trajlib.pontryagin.{module}.seconds_left", lambda: next(left))
    guess = (1.0, np.zeros((2, 4)), np.zeros((1, 1)))
    programme = Transcription(NumericProblem(CRANE), 400)
    with pytest.raises(OutOfTime):
        programme.solve(guess)
    assert programme.solver.status == "User_Requested_Stop"
    assert programme.solver.iterations == 3 and next(left, None) is None


def test_nothing_is_raised_within_a_call_that_ends_itself():
    with pytest.raises(OutOfTime), limited(0.1):
        with stopped_from_within():
            begin = time.monotonic()
            while time.monotonic() < begin + 0.3:
                pass
            ended = seconds_left() == 0
    assert ended


def test_the_search_over_arcs_has_a_bound(monkeypatch):
    monkeypatch.setattr("trajlib.pontryagin.indirect.arc_search.MOST_LISTS", 2)
    with pytest.raises(
        WrongStructure, match=r"\(2 lists of arcs, the most that are tried\)"
    ) as raised:
        replace(CRANE).solve()
    # With path constraints no structure can be given.
    assert "Give a guess; look" in str(raised.value)


def test_time_limit():
    begin = time.monotonic()
    extremal = WELLS.solve(starts=10**9, time_limit=2)
    assert time.monotonic() - begin < 20 and extremal.optimality.starts < 10**9
    with pytest.raises(ValueError, match="time_limit: expected a positive"):
        WELLS.solve(time_limit=0)
    with pytest.raises(ValueError, match="starts: expected at least one"):
        WELLS.solve(starts=0)


DOUBLE_WELL = 10 * (x**2 - 1) ** 2 + x


@pytest.mark.parametrize("unit", [1, 1000, R(1, 1000)])
@pytest.mark.parametrize("maximise", [False, True])
def test_polynomial_terminal_cost_is_decided(unit, maximise):
    """From the shallower well: V(s) = (s - 1)^2/2, and the sum on a fine grid."""
    s, sign = np.linspace(-3, 3, 600001), -1 if maximise else 1
    least = np.min((s - 1) ** 2 / 2 + 10 * (s**2 - 1) ** 2 + s)
    extremal = Problem(
        {x: u},
        FREE,
        {x: unit},
        running=sign * u**2 / 2,
        final=sign * unit**2 * DOUBLE_WELL.subs(x, x / unit),
        duration=1,
        maximise=maximise,
    ).solve()
    assert sign * extremal.cost == pytest.approx(float(least * unit**2), rel=1e-9)
    assert extremal.optimality.proved and extremal.certificate().holds()


def test_polynomial_of_one_of_two_states():
    """The search finds no better process from a guess beside either well."""
    problem = Problem(
        {x: y, y: u},
        FREE,
        {x: 1, y: 0},
        [y],
        running=u**2 / 2 + x**2,
        final=DOUBLE_WELL,
        duration=1,
    )
    extremal = problem.solve()
    costs = [problem.solve(guess={x: [1, end]}).cost for end in (-1, 1)]
    assert extremal.optimality.proved
    assert extremal.cost == pytest.approx(min(costs), rel=1e-10)


def test_polynomial_that_falls_without_bound():
    with pytest.raises(Unbounded, match="outweighs any running cost"):
        Problem({x: u}, FREE, {x: 1}, running=u**2 / 2, final=-(x**4), duration=1).solve()


@pytest.mark.parametrize(
    "problem",
    [
        # The cost of u = h^(-1/3) during the time h is h^(1/3).
        Problem({x: u**3}, FREE, {x: 0}, [x - 1], running=u**2, duration=1),
        Problem({x: u}, FREE, {x: 1}, [x], running=x**2, duration=1),
        Problem({x: y, y: u}, FREE, {x: 1, y: 0}, [x, y], running=x**2 + y**2, duration=1),
        Problem(
            {x: y, y: u}, FREE, {x: 0, y: 0}, [x - 1, y], running=sp.sqrt(1 + u**2), duration=1
        ),
    ],
)
def test_impulses_are_named(problem):
    with pytest.raises(Unbounded, match="impulses seem to approach the infimum"):
        problem.solve()


def test_impulses_are_named_by_the_control_of_the_user():
    problem = Problem({x: u}, FREE, {x: 0}, [x - 1], running=(1 + x) * sp.Abs(u), duration=1)
    with pytest.raises(PontryaginError, match=r"max\(u, 0\)") as error:
        problem.solve()
    assert "_u" not in str(error.value)


def test_shortest_duration_is_no_infimum():
    """u = T^(-1/3) costs T + T^(1/3): the infimum is 0, and no number stands for it."""
    with pytest.raises(Unbounded, match=r"ever shorter processes") as error:
        Problem({x: u**3}, FREE, {x: 0}, [x - 1], running=1 + u**2).solve()
    assert not re.search("infimum [0-9]", str(error.value))


def test_least_time_without_bounds_is_not_attained():
    with pytest.raises(Unbounded, match="in any time t > 0"):
        Problem({x: y, y: u}, FREE, {x: 0, y: 0}, [x - 1, y]).solve()


PLANT, ENDS = {x: y, y: u}, ({x: 0, y: 0}, [x - 1, y])


@pytest.mark.parametrize(
    "problem, change",
    [
        # Back and forth, ever longer or again and again; the shortest process is a local minimum.
        (Problem(PLANT, ONE, *ENDS, running=-(y**2)), "falls .* adds -"),
        (Problem(PLANT, ONE, *ENDS, running=y**2, maximise=True), "rises .* adds [0-9]"),
        (Problem(PLANT, ONE, *ENDS, running=1 - y**2), "falls .* after the time 8 adds -2.67 "),
        (Problem(PLANT, ONE, ENDS[0], [x - 1], running=1 - y**2), "falls .* adds -"),
        (Problem(PLANT, FREE, *ENDS, running=1 + u**2 - y**2), "falls .* adds -"),
        (Problem(PLANT, ONE, *ENDS, running=x), "falls .* adds -"),
        (Problem(PLANT, ONE, *ENDS, running=1 - 2 * x * y - x**2), "falls .* adds -"),
        (Problem({x: u}, ONE, {x: 0}, [x - 1], running=1 - x**2), "falls .* adds -"),
        (Problem({x: y, y: u - y}, ONE, *ENDS, running=R(1, 4) - y**2), "falls .* adds -"),
    ],
)
def test_closed_trajectories_of_negative_cost(problem, change):
    with pytest.raises(Unbounded, match=f"the cost {change}.* any number of times"):
        problem.solve()


@pytest.mark.parametrize(
    "problem, cost",
    [
        # t^2/2 = 1/2 at speed t, there and back: 2 - 2/4 int_0^1 t^2 dt; a loop costs 3/4 a unit of time.
        (Problem(PLANT, ONE, *ENDS, running=1 - y**2 / 4, path=[y <= 1, y >= -1]), R(11, 6)),
        # |y| <= 1 follows from the plant alone.
        (Problem({x: y, y: u - y}, ONE, *ENDS, running=1 - y**2 / 2), 1.880098599),
        # The longest time is given.
        (Problem(PLANT, ONE, *ENDS, running=-(y**2), duration=(2, 4)), -R(19, 12)),
        # The first guesses lead to a saddle, from which shifted switchings lead away.
        (Problem(PLANT, ONE, *ENDS, running=-(y**2), duration=4), -R(19, 12)),
        # Every process costs the same, and so does every loop: nothing.
        (Problem({x: u}, ONE, {x: 0}, [x - 1], running=1 - x * u), R(1, 2)),
    ],
)
def test_running_costs_that_may_be_negative_with_a_best_process(problem, cost):
    assert problem.solve().cost == pytest.approx(float(cost), rel=1e-9)


def crane(distance, rate=R("9.81") / 5):
    """Return the crane of the engineer's guide: a trolley with a load on a rope."""
    s, w, angle, turning = sp.symbols("s v theta omega")
    field = {s: w, w: u, angle: turning, turning: -rate * angle - u / 5}
    return Problem(
        field, {u: (-R(1, 2), R(1, 2))}, dict.fromkeys(field, 0), [s - distance, w, angle, turning]
    )


@pytest.mark.parametrize("distance", [R(10), R("10.04"), R("10.065"), R("40.2")])
def test_switchings_that_nearly_coincide(distance):
    """The control is odd about the half time c, with switchings at c - h, c and c + h.

    L = (c^2 - 2 h^2)/2, and the load is at rest for 2 (1 - cos wh) = 1 - cos wc; h tends to zero where
    the acceleration lasts one period of the rope.
    """
    w, c = float(sp.sqrt(R("9.81") / 5)), float(sp.sqrt(2 * distance))
    for _ in range(50):
        h = np.arccos((1 + np.cos(w * c)) / 2) / w
        c = np.sqrt(2 * float(distance) + 2 * h**2)
    extremal = crane(distance).solve()
    np.testing.assert_allclose(extremal.switching_times, [c - h, c, c + h], atol=1e-8)
    assert extremal.duration == pytest.approx(2 * c, rel=1e-12) and extremal.optimality.proved


def test_switchings_too_close_for_the_grid_are_named():
    """A linear plant that one control controls has no singular arc, whatever the grid shows."""
    with pytest.raises(WrongStructure, match="u has no singular arc") as error:
        crane(R("10.0597")).solve()
    assert not isinstance(error.value, NotUnique)


@pytest.mark.parametrize(
    ("resistance", "expected"),
    [
        (lambda v: sp.Abs(v) * v, r"Abs\(v\) has no derivative for complex v; declare it as sp"),
        (lambda v: sp.sign(v) / 4, r"sign\(v\) jumps, .* such as tanh\(v/epsilon\)"),
        (lambda v: sp.Heaviside(v) / 4, r"Heaviside\(v\) jumps"),
        (lambda v: sp.floor(v), r"floor\(v\) jumps"),
    ],
)
def test_states_without_a_derivative(resistance, expected):
    x, v, u = sp.symbols("x v u")
    with pytest.raises(ValueError, match=f"solve: {expected}"):
        Problem({x: v, v: u - resistance(v)}, {u: (-1, 1)}, {x: 0, v: 0}, {x: 1, v: 0}).solve()


def test_a_modulus_of_a_real_state():
    """v' = 1 - v^2 and then -1 - v^2, from rest to rest: tanh and tan, lengths by logarithms."""
    x, v, u = sp.symbols("x v u", real=True)
    drag = Problem({x: v, v: u - sp.Abs(v) * v}, {u: (-1, 1)}, {x: 0, v: 0}, {x: 1, v: 0})
    first, second = drag.solve().switching_times[0], drag.solve().duration
    assert np.tanh(first) == pytest.approx(np.tan(second - first), abs=1e-9)
    assert np.log(np.cosh(first)) - np.log(np.cos(second - first)) == pytest.approx(1, abs=1e-9)
