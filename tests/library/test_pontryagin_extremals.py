"""Extremals against closed forms, derived beside each problem; certificates; poor guesses."""

from dataclasses import dataclass, field

import numpy as np
import optimal_control_records
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import fsolve

from trajlib.pontryagin import Problem, compare
from trajlib.pontryagin.direct.multistart import Multistart
from trajlib.pontryagin.direct.transcription import DirectSolution
from trajlib.pontryagin.indirect.refinement import refine
from trajlib.pontryagin.indirect.structure import detect_arcs
from trajlib.pontryagin.problem.numeric import NumericProblem

pytestmark = pytest.mark.slow
x, x1, x2, u, v, t, p, T = sp.symbols("x x1 x2 u v t p T")
half = sp.Rational(1, 2)
ONE = {u: (-1, 1)}


@dataclass
class Record:
    """A problem with its extremal: arcs, switching times, psi(0) (or None), cost, source."""

    problem: Problem
    arcs: list
    times: list
    costate: list | None
    cost: float
    source: str
    multiplier: float = 1.0
    others: dict = field(default_factory=dict)


def double_integrator(a, b):
    """x'' = u from (a, b) to the origin.

    With s = a + b|b|/2 > 0 first u = -1 for b + r, r = sqrt(a + b^2/2), then u = 1 for r. psi_2
    vanishes at the switching, where H = 0 reads psi_1 x_2 = 1 with x_2 = -r; s < 0 is its mirror
    image.
    """
    sign = 1 if a + b * abs(b) / 2 > 0 else -1
    r = np.sqrt(sign * a + b * b / 2) or np.nan
    t = sign * b + r
    return Record(
        Problem({x1: x2, x2: u}, ONE, {x1: a, x2: b}, [x1, x2]),
        ["u-", "u+"][::sign],
        [t],
        [-sign / r, -sign * t / r],
        t + r,
        "worked out by hand; compare example 2 of the book",
    )


def turnpike(a, b):
    """x' = u, min of int x^2 over [0, 2] from a to b: down to zero, rest there (singular), up.

    psi' = 2x, psi = 0 on the singular arc.
    """
    return Record(
        Problem({x: u}, ONE, {x: a}, [x - b], running=x**2, duration=2),
        ["u-", "singular", "u+"],
        [a, 2 - b],
        [-(a**2)],
        (a**3 + b**3) / 3,
        "by hand",
    )


def oscillator(damping, last, between, first):
    """x'' + d x' + x = u to the origin, integrated backwards from it.

    The switching function psi_2 has zeros pi/omega apart. `last` = length of the last arc (u = 1
    there), `between` full arcs, `first` = length of the first. At the end H = 0 reads psi_2 u = 1;
    psi_2 is a damped sine that vanishes `last` before the end.
    """
    A, omega = np.array([[0, 1.0], [-1, -damping]]), np.sqrt(1 - damping**2 / 4)
    lengths = [last] + [np.pi / omega] * between + [first]
    point, sign = np.zeros(2), 1
    for length in lengths:
        centre = np.array([sign, 0.0])
        point, sign = centre + expm(-A * length) @ (point - centre), -sign
    kinds = ["u+" if k % 2 == 0 else "u-" for k in range(len(lengths))][::-1]
    T = sum(lengths)
    # psi' = -A^T psi, psi_2(T) = 1 and psi_2(T - last) = 0.
    back = expm(A.T * last)
    psi_end = np.array([-back[1, 1] / back[1, 0], 1.0])
    return Record(
        Problem(
            {x1: x2, x2: -x1 - sp.Float(damping) * x2 + u},
            ONE,
            {x1: point[0], x2: point[1]},
            [x1, x2],
        ),
        kinds,
        list(np.cumsum(lengths[::-1])[:-1]),
        list(expm(A.T * T) @ psi_end),
        T,
        "backwards from the origin",
    )


def saturated(T):
    """x'' = u, |u| <= 1, (1, 0) -> 0 in time T, min of int u^2.

    u = -1, then linear through zero at T/2, then 1. With c half the length of the linear arc,
    int (T/2 - t) u dt = -1 gives T^2/4 - c^2/3 = 1. On that arc u = psi_2/2.
    """
    c = np.sqrt(3 * (T**2 / 4 - 1))
    t = T / 2 - c
    return Record(
        Problem({x1: x2, x2: u}, ONE, {x1: 1, x2: 0}, [x1, x2], running=u**2, duration=T),
        ["u-", "interior", "u+"],
        [t, T - t],
        [-2 / c, -2 - 2 * t / c],
        2 * t + 2 * c / 3,
        "by hand",
    )


def circle(alpha, before):
    """x'' = u to the unit circle (example 2 of the book).

    The last arc has u = -1 and ends at the angle alpha in (pi/2, pi). It begins on the curve
    (5.14), -tan(alpha) before the end; the arc before, of length `before`, has u = 1. psi(t_k) =
    -nu (cos alpha, sin alpha) with H = 0: nu (-cos alpha sin alpha + sin alpha) = 1.
    """
    c, s, tan = np.cos(alpha), np.sin(alpha), np.tan(alpha)
    p1, p2 = c + tan * (s - tan / 2), s - tan
    start = [p1 - p2 * before + before**2 / 2, p2 - before]
    nu, T = 1 / (s - c * s), before - tan
    return Record(
        Problem({x1: x2, x2: u}, ONE, {x1: start[0], x2: start[1]}, [x1**2 + x2**2 - 1]),
        ["u+", "u-"],
        [before],
        [-nu * c, -nu * (s + c * T)],
        T,
        "(5.12), (5.14) of the book",
    )


def bilinear(start, kinds, times, cost, costate, source, **arguments):
    dynamics, low_high = {x1: x2, x2: -u * x1}, {u: (1, 4)}
    return Record(
        Problem(dynamics, low_high, dict(zip((x1, x2), start)), [x2], **arguments),
        kinds,
        times,
        costate,
        cost,
        source,
    )


RECORDS = {
    "double integrator": double_integrator(1.0, 0.0),
    "double integrator, far": double_integrator(-30.0, 11.0),
    "double integrator, near the curve": double_integrator(0.5001, -1.0),
    "turnpike": turnpike(1.0, 0.5),
    "turnpike, short rest": turnpike(1.2, 0.79),
    "oscillator, 2 arcs": oscillator(0.0, 1.0, 0, 2.0),
    "oscillator, 4 arcs": oscillator(0.0, 2.0, 2, 0.5),
    "oscillator, short first arc": oscillator(0.0, 1.0, 1, 0.02),
    "damped oscillator, 2 arcs": oscillator(1.0, 1.5, 0, 1.0),
    "damped oscillator, 3 arcs": oscillator(1.0, 0.7, 1, 1.3),
    "saturated": saturated(2.1),
    "saturated, long linear arc": saturated(2.3),
    "circle": circle(2.3, 1.1),
    "circle, near the end of the curve": circle(1.9, 0.4),
    "problem 5.11": bilinear([1, 0], ["u+"], [], np.pi / 2, None, "x = cos 2t", first_return=True),
    "problem 5.12": bilinear(
        [0, 1],
        ["u+"],
        [],
        np.pi / 4,
        [1, 0],
        "x = (sin 2t)/2; H = 0 at the end",
    ),
    "problem 5.13": bilinear(
        [1, 0], ["u-"], [], np.pi, None, "x = cos t", first_return=True, maximise=True
    ),
    # As problem 5.14: fast to x = 0, where the speed is 2, then slowly, as far as the amplitude 2.
    "largest swing": bilinear(
        [1, 0],
        ["u+", "u-"],
        [np.pi / 4],
        -2.0,
        [2, 0],
        "cos 2t, then -2 sin(t - pi/4); x(t_k) = -2 x(0), so psi_1(0) = 2",
        running=0,
        final=x1,
        first_return=True,
    ),
    "free end": Record(
        Problem({x: u}, {u: None}, {x: 1}, running=x**2 + u**2, duration=1),
        ["interior"],
        [],
        [-2 * np.tanh(1)],
        np.tanh(1),
        "x = cosh(1 - t)/cosh 1, psi = 2 u",
    ),
    "free start": Record(
        Problem({x: u}, {u: None}, {x: None}, [x - 1], running=x**2 + u**2, duration=1),
        ["interior"],
        [],
        [0.0],
        np.tanh(1),
        "the same, backwards",
    ),
    "final time in the dynamics": Record(
        Problem({x: u + t / T, T: 0}, ONE, {x: 0, T: None}, [x - 2, t - T], time=t),
        ["u+"],
        [],
        None,
        4 / 3,
        "x(T) = T + T/2",
    ),
    # With the thrust p it takes 2/sqrt(p): 2/sqrt(p) + p^(3/2)/2 is minimal where 3 p^2 = 4.
    "design variable": Record(
        Problem(
            {x1: x2, x2: p * u, p: 0},
            ONE,
            {x1: 0, x2: 0, p: None},
            {x1: 1, x2: 0},
            running=1 + p**2 / 4,
            path=[p >= half, p <= 3],
        ),
        ["u+", "u-"],
        None,
        None,
        2 * 0.75**0.25 + 0.75**-0.75 / 2,
        "calculus",
    ),
    "design variable at its bound": Record(
        Problem(
            {x1: x2, x2: p * u, p: 0},
            ONE,
            {x1: 0, x2: 0, p: None},
            {x1: 1, x2: 0},
            running=1 + p**2 / 4,
            path=[p >= half, p <= 1],
        ),
        ["u+", "u-"],
        [1.0],
        None,
        2.5,
        "(1 + p^2/4) 2/sqrt(p) falls up to p = 1",
    ),
    "example 1": Record(
        Problem({x1: x2, x2: u}, ONE, {x1: 0, x2: 0}, [x2], running=x1, duration=1),
        ["u-", "u+"],
        [0.5],
        [-1, -0.375],
        -0.125,
        "example 1 of the book: psi_1 = t - 1, psi_2 = -(t - 1)^2/2 + 1/8",
    ),
    "singular from the start": Record(
        Problem({x: u}, ONE, {x: 0}, [x - half], running=x**2, duration=2),
        ["singular", "u+"],
        [1.5],
        [0.0],
        1 / 24,
        "turnpike without its first arc",
    ),
    "singular throughout": Record(
        Problem({x: u}, ONE, {x: 0}, [x], running=x**2, duration=2),
        ["singular"],
        [],
        None,
        0.0,
        "rest",
    ),
    # H = psi u - x + u^2 is convex in u: bounds with equal H, no zero of dH/du. psi' = 1, psi(1/4)
    # = 0, x = -t, then up.
    "convex in the control": Record(
        Problem({x: u}, ONE, {x: 0}, [x - half], running=x - u**2, duration=1),
        ["u-", "u+"],
        [0.25],
        [-0.25],
        -15 / 16,
        "by hand",
    ),
    # Constant current w = 1/3: a straight course at the speed 1 with |d - w T| = T, that is 8 T^2/9
    # + 2 T/3 - 5 = 0.
    "Zermelo": Record(
        Problem(
            {x1: sp.cos(v) + sp.Rational(1, 3), x2: sp.sin(v)},
            {v: None},
            {x1: 0, x2: 0},
            [x1 - 1, x2 - 2],
        ),
        ["interior"],
        [],
        None,
        (-2 / 3 + np.sqrt(4 / 9 + 160 / 9)) / (16 / 9),
        "by hand",
    ),
    # int u^2 has to vanish: u = 0, whatever the cost int u; lambda_0 = 0.
    "abnormal": Record(
        Problem({x1: u**2, x2: u}, {u: None}, {x1: 0, x2: 0}, [x1], running=u, duration=1),
        ["interior"],
        [],
        [-1, 0],
        0.0,
        "only u = 0 is admissible",
        multiplier=0.0,
    ),
    "unstable, 5.2": Record(
        Problem({x: x + u}, ONE, {x: half}, [x]),
        ["u-"],
        [],
        [-2.0],
        np.log(2),
        "x = 1 - e^t/2; H = 0",
    ),
    "switching curve": Record(
        Problem({x1: x2, x2: u}, ONE, {x1: half, x2: -1}, [x1, x2]),
        ["u+"],
        [],
        None,
        1.0,
        "no switching; the costate is not unique",
    ),
}


@pytest.mark.parametrize("name", RECORDS)
def test_record(name):
    record = RECORDS[name]
    extremal = record.problem.solve()
    assert [kind for kind, _, _ in extremal.arcs] == record.arcs
    assert extremal.cost == pytest.approx(record.cost, rel=1e-11, abs=1e-11)
    if record.times is not None:
        assert extremal.switching_times == pytest.approx(
            record.times, abs=1e-9 * (1 + extremal.duration)
        )
    if record.costate is not None:
        assert extremal.costate(0) == pytest.approx(record.costate, rel=1e-9, abs=1e-9)
    assert extremal.multiplier == record.multiplier and extremal.residual < 1e-12
    evidence = extremal.certificate()
    assert evidence.holds(1e-11), evidence
    if "singular" in record.arcs:
        assert evidence.kelley < 0
    else:
        assert evidence.kelley is None


def test_scaling_of_states():
    """Example 2 of the book in quarters of a millimetre: the same times, costates inverse."""
    large = Problem({x1: x2, x2: 4000 * u}, ONE, {x1: 4000, x2: 0}, [x1, x2])
    extremal = large.solve()
    assert extremal.duration == pytest.approx(2, rel=1e-12)
    assert extremal.switching_times == pytest.approx([1], rel=1e-11)
    assert 4000 * extremal.costate(0) == pytest.approx([-1, -1], rel=1e-10)
    assert extremal.certificate().holds(1e-11) and extremal.optimality.proved
    assert large.solve(guess=extremal).duration == pytest.approx(2, rel=1e-12)
    given = large.solve(["u-", "u+"], guess={"duration": 3, x1: [4000, 0]})
    assert given.duration == pytest.approx(2, rel=1e-12)


def test_large_initial_values():
    """A tumour p and its vessels q under an inhibitor with a limited dose y.

    Hahnfeldt and others; Ledzewicz and Schaettler give 8533 for this initial state: full dose, a
    singular arc, no dose. The volumes in litres/1000 or in cubic millimetres lead to the same
    process.
    """
    p, q, y = sp.symbols("p q y", positive=True)

    def tumour(unit):
        death = sp.Rational(2, 100) + sp.Rational(873, 100000) * (unit * p) ** sp.Rational(2, 3)
        return Problem(
            {
                p: -sp.Rational(84, 1000) * p * sp.log(p / q),
                q: sp.Rational(585, 100) * p - death * q - sp.Rational(15, 100) * u * q,
                y: u,
            },
            {u: (0, 75)},
            {p: sp.Rational(12000, unit), q: sp.Rational(15000, unit), y: 0},
            [y - 300],
            final=p,
        )

    fine, rough = tumour(1).solve(), tumour(1000).solve()
    assert (
        [kind for kind, _, _ in fine.arcs]
        == ["u+", "singular", "u-"]
        == [kind for kind, _, _ in rough.arcs]
    )
    assert fine.cost == pytest.approx(1000 * rough.cost, rel=1e-11) and round(fine.cost) == 8533
    assert fine.duration == pytest.approx(rough.duration, rel=1e-8)
    assert fine.certificate().holds() and fine.certificate().kelley < 0


def test_two_controls():
    """Two independent problems, with arcs that begin and end at different times, cost their sum."""
    quadratic, resting = saturated(2.2), turnpike(1.0, 0.5)
    joint = Problem(
        {x1: x2, x2: u, x: v},
        {u: (-1, 1), v: (-1, 1)},
        {x1: 1, x2: 0, x: 1},
        [x1, x2, x - half],
        running=u**2 + x**2,
        duration=2.2,
    )
    extremal = joint.solve()
    # Between 1 and 2.2 - 1/2 the second one rests.
    assert extremal.cost == pytest.approx(quadratic.cost + resting.cost, abs=1e-11)
    assert extremal.switching_times == pytest.approx(sorted([*quadratic.times, 1.0, 1.7]), abs=1e-9)
    assert extremal.arcs[0][0] == ("u-", "u-") and extremal.certificate().holds(1e-11)


def test_least_fuel():
    """x'' = p - q, p, q in [0, 1], (1, 0) to rest at 0 in time 3, least int (p + q).

    No thrust between two arcs of length s: s (3 - s) = 1.
    """
    p, q = sp.symbols("p q")
    extremal = Problem(
        {x1: x2, x2: p - q},
        {p: (0, 1), q: (0, 1)},
        {x1: 1, x2: 0},
        [x1, x2],
        running=p + q,
        duration=3,
    ).solve()
    s = (3 - np.sqrt(5)) / 2
    assert [kinds for kinds, _, _ in extremal.arcs] == [("u-", "u+"), ("u-", "u-"), ("u+", "u-")]
    assert extremal.cost == pytest.approx(
        2 * s, abs=1e-12
    ) and extremal.switching_times == pytest.approx([s, 3 - s], abs=1e-11)
    assert extremal.certificate().holds(1e-11)


@pytest.mark.parametrize("damping, between", [(0.0, 0), (0.0, 1), (1.0, 0)])
def test_corners_of_the_switching_curve(damping, between):
    """An initial state from which all arcs last half a period, with lambda_0 = 0.

    The switching function vanishes at both ends. Without a switching Newton's method may find any
    of many costates; one of them alone satisfies the maximum condition.
    """
    period = np.pi / np.sqrt(1 - damping**2 / 4)
    record = oscillator(damping, period, 0, period * between)
    extremal = record.problem.solve()
    assert [kind for kind, _, _ in extremal.arcs] == ["u-", "u+"][1 - between :]
    assert extremal.cost == pytest.approx(period * (1 + between), rel=1e-11) and not extremal.normal
    assert extremal.certificate().holds(1e-11)


@pytest.mark.parametrize("start, sign", [((2, 0), 1), ((-2, 0), -1)])
def test_exact_corners(start, sign):
    extremal = Problem({x1: x2, x2: -x1 + u}, ONE, dict(zip((x1, x2), start)), [x1, x2]).solve()
    assert [kind for kind, _, _ in extremal.arcs] == ["u+" if sign > 0 else "u-"]
    assert extremal.duration == pytest.approx(np.pi, abs=1e-11) and extremal.certificate().holds(
        1e-11
    )
    # psi_2 = sign sin t
    assert extremal.costate(0) == pytest.approx([-sign, 0], abs=1e-9)


OUTSIDE, INSIDE = (
    np.arccos(0.92) + np.arccos(0.2),
    np.arctan2(0.05, 1.3) + np.arccos(0.84625 / np.hypot(1.3, 0.05)),
)


@pytest.mark.parametrize(
    "radius, start, kinds, least",
    [(half, (1.5, 0), ["u-", "u+"], OUTSIDE), (1, (0.3, 0.05), ["u-"], INSIDE)],
)
def test_fastest_of_several_extremals_to_a_circle(radius, start, kinds, least):
    """The oscillator (problem 5.8); other guesses lead to slower extremals, or to none.

    Outside: u = -1 turns around (-1, 0) to the circle of radius 1 around (1 + R, 0), in a triangle
    with the sides 5/2, 5/2, 1; the last arc begins at (1 + R - cos s, -sin s). Inside: u = -1
    alone, (x1 + 1) cos T + x2 sin T = x1 + 1 - (R^2 - r^2)/2.
    """
    extremal = Problem(
        {x1: x2, x2: -x1 + u}, ONE, dict(zip((x1, x2), start)), [x1**2 + x2**2 - radius**2]
    ).solve()
    assert [kind for kind, _, _ in extremal.arcs] == kinds
    assert extremal.duration == pytest.approx(least, abs=1e-11) and extremal.certificate().holds(
        1e-11
    )
    assert "a better process is not excluded" in extremal._repr_markdown_()


@settings(max_examples=15, deadline=None, derandomize=True)
@given(a=st.floats(-8, 8), b=st.floats(-5, 5))
def test_double_integrator_from_anywhere(a, b):
    record = double_integrator(a, b)
    # On the switching curve itself there is one arc.
    assume(min(record.times[0], record.cost - record.times[0]) > 1e-3)
    extremal = record.problem.solve()
    assert extremal.duration == pytest.approx(record.cost, rel=1e-11)
    assert extremal.switching_times == pytest.approx(record.times, abs=1e-9)
    assert extremal.certificate().holds(1e-10)


@pytest.mark.parametrize(
    "name",
    ["double integrator", "turnpike", "oscillator, 4 arcs", "saturated", "circle", "Goddard"],
)
def test_perturbed_direct_solutions_lead_to_the_same_extremal(name):
    """Newton's method from states, costates and arcs that are off by some per cent."""
    record = RECORDS[name] if name in RECORDS else optimal_control_records.record(name)
    numeric = NumericProblem(record.problem)
    solution, _ = Multistart(numeric).search().solutions[0]
    arcs = detect_arcs(numeric, solution)
    random = np.random.default_rng(3)
    for _ in range(3):

        def shaken(values, by=0.03):
            return values + by * np.ptp(values, axis=0) * random.standard_normal(values.shape)

        off = DirectSolution(
            solution.times * 1.02,
            shaken(solution.states),
            shaken(solution.costates),
            solution.controls,
            solution.cost,
        )
        shot = refine(numeric, off, arcs, numeric.duration, {})
        assert shot.lengths.sum() == pytest.approx(record.problem.solve().duration, rel=1e-10)


def test_guesses_of_the_user():
    problem = RECORDS["double integrator"].problem
    for guess in (
        {"duration": 5},
        {"duration": 0.5, x1: [1, 0], u: -1},
        {x2: lambda t: -t},
        RECORDS["saturated"].problem.solve(),
    ):
        assert problem.solve(guess=guess).duration == pytest.approx(2, abs=1e-11)
    with pytest.raises(ValueError, match="guess: x is neither"):
        problem.solve(guess={x: 1})
    with pytest.raises(TypeError, match="guess: expected"):
        problem.solve(guess=3)


def test_given_structures_and_comparison():
    found = compare(
        RECORDS["turnpike"].problem, [["u-", "singular", "u+"], ["u-", "u+"], ["u+", "u-"]]
    )
    assert found.best.cost == pytest.approx(0.375, abs=1e-12) and len(found.refused) == 2
    assert "|" in found._repr_markdown_()


def test_evaluation():
    extremal = RECORDS["double integrator"].problem.solve()
    t = np.linspace(0, 2, 41)
    assert (
        extremal.state(t).shape == (2, 41)
        and extremal.state(0.3).shape == (2,)
        and extremal.control(t).shape == (1, 41)
    )
    assert extremal.state(t)[0] == pytest.approx(
        np.where(t < 1, 1 - t**2 / 2, (2 - t) ** 2 / 2), abs=1e-13
    )
    assert extremal.switching(t)[0] == pytest.approx(t - 1, abs=1e-12)
    assert np.abs(extremal.hamiltonian(t)).max() < 1e-12
    assert list(extremal.control([0.5, extremal.switching_times[0], 1.5])[0]) == [-1, 1, 1]
    with pytest.raises(ValueError, match="times between 0"):
        extremal.state(2.5)


def test_figures_are_drawn():
    import matplotlib.pyplot as plt

    for name, count in (("turnpike", 3), ("circle", 4)):
        axes = RECORDS[name].problem.solve().plot()
        assert len(axes) == count and all(ax.lines for ax in axes)
        axes[0].figure.canvas.draw()
        plt.close("all")


def test_a_body_that_stops_turning_does_not_chatter():
    """Three bang arcs; on the singular arc through the target other torques would turn the body."""
    w, torques = sp.symbols("w1:4"), sp.symbols("u1:4")
    rates = {
        w[0]: w[1] * w[2] / 2 + torques[0],
        w[1]: torques[1] - w[0] * w[2],
        w[2]: w[0] * w[1] / 3 + torques[2],
    }
    problem = Problem(
        rates, dict.fromkeys(torques, (-half, half)), dict(zip(w, (1, -half, 3 * half / 2))), w
    )

    def end(lengths):
        state = [1, -0.5, 0.75]
        for length, u in zip(lengths, ((-1, 1, 1), (-1, 1, -1), (-1, 1, 1))):
            state = solve_ivp(
                lambda t, y: [
                    y[1] * y[2] / 2 + u[0] / 2,
                    u[1] / 2 - y[0] * y[2],
                    y[0] * y[1] / 3 + u[2] / 2,
                ],
                (0, length),
                state,
                rtol=1e-12,
                atol=1e-13,
                method="DOP853",
            ).y[:, -1]
        return state

    lengths = fsolve(end, [0.06, 1.5, 0.2], xtol=1e-13)
    assert problem.solve().duration == pytest.approx(lengths.sum(), rel=1e-10)
