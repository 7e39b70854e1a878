"""Planar syntheses against closed forms, support functions, and Bellman's equation."""

import functools
import warnings

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

from trajlib.pontryagin import Problem, synthesis
from trajlib.pontryagin.planar_synthesis.arguments import read_plant
from trajlib.pontryagin.planar_synthesis.integration import series_step
from trajlib.pontryagin.planar_synthesis.plant import Plant

pytestmark = pytest.mark.slow
x1, x2, u, alpha = sp.symbols("x1 x2 u alpha", real=True)
DOUBLE, OSCILLATOR, SADDLE = (
    np.array([[0, 1], [0, 0]]),
    np.array([[0, 1], [-1, 0]]),
    np.array([[0, 1], [1, 0]]),
)
DAMPED, EXCITED = np.array([[0, 1], [0, -1]]), np.array([[0, 1], [0, 1]])


def problem(terminal, bounds=(-1, 1), force=0):
    return Problem({x1: x2, x2: force + u}, {u: bounds}, {x1: None, x2: None}, terminal=terminal)


def linear(A, terminal, bounds=(-1, 1)):
    return problem(terminal, bounds, sum(sp.Integer(int(c)) * x for c, x in zip(A[1], (x1, x2))))


def starts(window, count=150, seed=1, where=None):
    random = np.random.default_rng(seed)
    x = np.array([random.uniform(*pair, count) for pair in window])
    return x if where is None else x[:, where(*x)]


def least_times(A, bounds, support, x, horizon, inside=False):
    """Return when no direction p separates the reachable states from a convex target any more.

    The target is given by its support function. From inside: when the reachable states first leave
    the target in some direction.
    """
    angles = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    p = np.array([np.cos(angles), np.sin(angles)])
    moments = np.linspace(0, horizon, int(100 * horizon) + 1)
    step, flow = expm(A * moments[1]), [p.T]
    for _ in moments[1:]:
        flow.append(flow[-1] @ step)
    flow = np.array(flow)
    push = flow[:, :, 1]
    extreme = (np.maximum if inside else np.minimum)(push * bounds[0], push * bounds[1])
    gained = np.vstack(
        [np.zeros(angles.size), np.cumsum((extreme[1:] + extreme[:-1]) / 2, axis=0) * moments[1]]
    )
    level = support(p)
    times = []
    for start in x.T:
        gap = (flow @ start + gained - level).max(axis=1) * (-1 if inside else 1)
        k = int(np.argmax(gap <= 0))
        times.append(
            np.inf
            if gap[k] > 0
            else moments[k]
            if k == 0
            else moments[k - 1] + gap[k - 1] / (gap[k - 1] - gap[k]) * moments[1]
        )
    return np.array(times)


@pytest.fixture(scope="module")
def to_rest():
    return synthesis(problem([x1, x2]), horizon=9)


def test_double_integrator_to_the_origin(to_rest):
    a, b = starts(to_rest.window, 400)
    side = a + b * np.abs(b) / 2
    exact = np.sign(side) * b + 2 * np.sqrt(b**2 / 2 + np.sign(side) * a)
    assert np.abs(to_rest.time(a, b) - exact).max() < 1e-8
    assert (to_rest.control(a, b) == -np.sign(side)).all()
    assert to_rest.time(0, 0) == 0
    for curve in to_rest.switching_curves:
        assert curve.kind == "followed"
        assert (
            np.abs(curve.points[:, 0] + curve.points[:, 1] * np.abs(curve.points[:, 1]) / 2).max()
            < 1e-12
        )
    assert (
        len(to_rest.switching_curves) == 2 and not to_rest.dispersal_curves and not to_rest.barriers
    )
    assert to_rest.regularity().regular


def test_on_the_switching_curve_the_control_is_the_one_that_follows(to_rest):
    b = np.array([-1.5, -0.7, 0.7, 1.5])
    assert (to_rest.control(-b * np.abs(b) / 2, b) == -np.sign(b)).all()


def test_isochrones_are_lines_of_equal_time(to_rest):
    pieces = to_rest.isochrone(2.5)
    points = np.vstack(pieces)
    assert len(points) > 50
    assert np.abs(to_rest.time(*points.T) - 2.5).max() < 1e-6


def test_one_sided_control_reaches_the_origin_from_one_side_only():
    found = synthesis(problem([x1, x2], (0, 1)), horizon=12)
    a, b = starts(found.window, 400)
    possible = (b < 0) & (a >= b**2 / 2)
    # coasting to the parabola x1 = x2^2/2, then braking
    time = -b / 2 - a / np.where(b == 0, 1, b)
    known = possible & (time < 11.5)
    assert (found.reaches(a, b)[known]).all() and not found.reaches(a, b)[~possible].any()
    assert np.abs(found.time(a, b)[known] - time[known]).max() < 1e-7
    border = [
        c for c in found.barriers if np.abs(c.points[:, 0] - c.points[:, 1] ** 2 / 2).max() < 1e-9
    ]
    assert border and np.isinf(border[0].jump)


def test_oscillator_switches_on_semicircles():
    found = synthesis(linear(OSCILLATOR, [x1, x2]), window=((-4, 4), (-3, 3)), horizon=10)
    assert len(found.switching_curves) == 4
    for curve in found.switching_curves:
        a, b = curve.points.T
        centre = -np.sign(b[len(b) // 2]) * (1 if np.abs(a).max() < 2.1 else 3)
        assert np.abs((a - centre) ** 2 + b**2 - 1).max() < 1e-10
    assert {c.kind for c in found.switching_curves} == {"followed", "crossed"}
    x = starts(found.window)
    bound = least_times(OSCILLATOR, (-1, 1), lambda p: 0 * p[0], x, 10)
    assert np.abs(found.time(*x) - bound).max() < 5e-3


def test_saddle_reaches_the_origin_from_a_strip():
    found = synthesis(linear(SADDLE, [x1, x2]), window=((-2, 2), (-2, 2)), horizon=9)
    a, b = starts(found.window, 600)
    assert not found.reaches(a, b)[np.abs(a + b) >= 1].any()
    assert found.reaches(a, b)[np.abs(a + b) < 0.97].all()


@pytest.fixture(scope="module")
def to_circle():
    return synthesis(
        problem([x1**2 + x2**2 - 1]),
        side="outside",
        window=((-4, 4), (-3, 3)),
        horizon=9,
        curve=((sp.cos(alpha), sp.sin(alpha)), (alpha, 0, 2 * sp.pi)),
    )


def test_circle_has_the_switching_curve_of_the_book(to_circle):
    assert len(to_circle.switching_curves) == 2
    for curve in to_circle.switching_curves:
        assert curve.kind == "crossed"
        angle = np.pi - np.arctan(curve.times)
        tan, sin, cos = np.tan(angle), np.sin(angle), np.cos(angle)
        exact = np.array([cos + tan * (sin - tan / 2), sin - tan]) * np.sign(curve.points[5, 1])
        assert np.abs(exact - curve.points.T).max() < 1e-11


def test_circle_is_left_by_two_optimal_and_two_other_abnormal_extremals(to_circle):
    optimal = [c for c in to_circle.borders if c.optimal]
    assert len(to_circle.borders) == 4 and len(optimal) == 2
    for curve in optimal:
        side = np.sign(curve.points[5, 1])
        assert np.abs(side * curve.points[:, 0] - 1 + curve.points[:, 1] ** 2 / 2).max() < 1e-9
    tests = to_circle.regularity()
    assert not to_circle.barriers and tests["F"].holds and tests["A"].value == 4
    assert not tests["C"].holds and not tests.regular
    assert tests["E"].value < 1e-12 and tests["D"].value == 1


CONVEX = {
    # name: (A, bounds, terminal, support function, side, window, horizon, where starts lie)
    "damped": (DAMPED, (-1, 1), [x1, x2], lambda p: 0 * p[0], "both", ((-3, 3), (-3, 3)), 9, None),
    "excited": (
        EXCITED,
        (-1, 1),
        [x1, x2],
        lambda p: 0 * p[0],
        "both",
        ((-2, 2), (-0.9, 0.9)),
        9,
        None,
    ),
    "uneven bounds": (
        DOUBLE,
        (-1, 2),
        [x1, x2],
        lambda p: 0 * p[0],
        "both",
        ((-2, 2), (-2, 2)),
        9,
        None,
    ),
    "another point": (
        DOUBLE,
        (-1, 1),
        [x1 - 1, x2 - 1],
        lambda p: p[0] + p[1],
        "both",
        ((-1, 3), (-1, 3)),
        9,
        None,
    ),
    "circle": (
        DOUBLE,
        (-1, 1),
        [x1**2 + x2**2 - 1],
        lambda p: 1 + 0 * p[0],
        "outside",
        ((-4, 4), (-3, 3)),
        9,
        lambda a, b: a * a + b * b > 1,
    ),
    "circle with barriers": (
        DOUBLE,
        (-1, 1),
        [x1**2 + x2**2 - 4],
        lambda p: 2 + 0 * p[0],
        "outside",
        ((-5, 5), (-4, 4)),
        12,
        lambda a, b: a * a + b * b > 4,
    ),
    "from inside": (
        DOUBLE,
        (-1, 1),
        [x1**2 + x2**2 - 4],
        lambda p: 2 + 0 * p[0],
        "inside",
        ((-2.1, 2.1), (-2.1, 2.1)),
        5,
        lambda a, b: a * a + b * b < 4,
    ),
    "ellipse": (
        DOUBLE,
        (-1, 1),
        [x1**2 + x2**2 / 4 - sp.Rational(1, 4)],
        lambda p: np.hypot(p[0] / 2, p[1]),
        "outside",
        ((-3, 3), (-3, 3)),
        9,
        lambda a, b: a * a + b * b / 4 > 0.25,
    ),
    "parabola": (
        DOUBLE,
        (-1, 1),
        [x1 - x2**2],
        lambda p: np.where(
            p[0] < -1e-9,
            p[1] ** 2 / (4 * np.maximum(-p[0], 1e-9)),
            np.where(np.abs(p).max(axis=0) > 2, 0, np.inf),
        ),
        "negative",
        ((-3, 3), (-3, 3)),
        9,
        lambda a, b: a < b * b,
    ),
    "oscillator, circle": (
        OSCILLATOR,
        (-1, 1),
        [x1**2 + x2**2 - 4],
        lambda p: 2 + 0 * p[0],
        "outside",
        ((-4, 4), (-4, 4)),
        9,
        lambda a, b: a * a + b * b > 4,
    ),
    "oscillator, inside": (
        OSCILLATOR,
        (-1, 1),
        [x1**2 + x2**2 - 9],
        lambda p: 3 + 0 * p[0],
        "inside",
        ((-3, 3), (-3, 3)),
        9,
        lambda a, b: a * a + b * b < 9,
    ),
    "saddle, circle": (
        SADDLE,
        (-1, 1),
        [x1**2 + x2**2 - sp.Rational(16, 25)],
        lambda p: 0.8 + 0 * p[0],
        "outside",
        ((-2, 2), (-2, 2)),
        8,
        lambda a, b: (a * a + b * b > 0.64) & (np.abs(a + b) < 1.05),
    ),
    "saddle, one-sided": (
        SADDLE,
        (0, 1),
        [x1**2 + x2**2 - sp.Rational(16, 25)],
        lambda p: 0.8 + 0 * p[0],
        "outside",
        ((-2, 2), (-2, 2)),
        8,
        lambda a, b: a * a + b * b > 0.64,
    ),
}


@functools.cache
def convex(name):
    A, bounds, terminal, _, side, window, horizon, _ = CONVEX[name]
    return synthesis(linear(A, terminal, bounds), side=side, window=window, horizon=horizon)


@pytest.mark.parametrize("name", CONVEX)
def test_times_are_the_lower_bounds_by_support_functions(name):
    A, bounds, _, support, side, window, horizon, where = CONVEX[name]
    found = convex(name)
    x = starts(window, where=where)
    bound = least_times(A, bounds, support, x, horizon, inside=side == "inside")
    ours = found.time(*x)
    assert np.isfinite(ours).sum() > 20
    clear = bound < 0.95 * horizon
    assert np.isfinite(ours[clear]).all() and not np.isfinite(ours[np.isinf(bound)]).any()
    assert np.abs(ours - bound)[clear].max() < 5e-3


def test_barriers_begin_where_the_target_is_touched():
    found = synthesis(
        problem([x1**2 + x2**2 - 4]),
        side="outside",
        window=((-5, 5), (-4, 4)),
        horizon=14,
        curve=((2 * sp.cos(alpha), 2 * sp.sin(alpha)), (alpha, 0, 2 * sp.pi)),
    )
    assert len(found.barriers) == 2
    upper = next(c for c in found.barriers if c.points[0, 1] > 0)
    assert upper.points[0] == pytest.approx([1, np.sqrt(3)], abs=1e-9)  # cos(alpha) = 1/R
    assert np.abs(upper.points[:, 0] + upper.points[:, 1] ** 2 / 2 - 2.5).max() < 1e-9
    reached = sorted(arc.parameter for arc in found.reached)
    assert reached[0] == pytest.approx((np.pi / 3, np.pi), abs=1e-9)
    tests = found.regularity()
    assert not tests["F"].holds and tests["F"].value == pytest.approx(upper.jump)
    left, right = upper.points[8] - [0.01, 0], upper.points[8] + [0.01, 0]
    assert found.time(*right) - found.time(*left) > 1


def test_line_has_the_time_of_free_fall():
    found = synthesis(problem([x1]), side="positive", window=((0, 3), (-3, 3)), horizon=9)
    a, b = starts(found.window)
    assert np.abs(found.time(a, b) - b - np.sqrt(b**2 + 2 * a)).max() < 1e-8
    assert (found.control(a, b) == -1).all() and not found.switching_curves


def test_dispersal_curve_has_two_controls_and_equal_times():
    found = convex("from inside")
    (curve,) = found.dispersal_curves
    points, times = curve.points[2:-2:6], curve.times[2:-2:6]
    assert np.abs(found.time(*points.T) - times).max() < 1e-8
    normal = np.array([0, 1e-4])
    assert (found.control(*(points + normal).T) * found.control(*(points - normal).T) == -1).all()
    mirrored = np.interp(-curve.points[:, 0], *curve.points[np.argsort(curve.points[:, 0])].T)
    assert np.abs(mirrored + curve.points[:, 1])[20:-20].max() < 1e-3  # point symmetry


@pytest.mark.parametrize(
    "force, terminal",
    [(-sp.sin(x1), [x1, x2]), (x2 * (1 - x1**2) - x1, [x1, x2]), (-x2 * sp.Abs(x2) / 2, [x1])],
    ids=["pendulum", "van der Pol", "quadratic drag"],
)
def test_nonlinear_systems_satisfy_the_bellman_equation(force, terminal):
    found = synthesis(problem(terminal, force=force), window=((-1.5, 1.5), (-1.2, 1.2)), horizon=5)
    a, b = starts(((-1.4, 1.4), (-1.1, 1.1)), 200)
    h = 1e-5
    with np.errstate(invalid="ignore"):
        slope = [
            (found.time(a + h, b) - found.time(a - h, b)) / (2 * h),
            (found.time(a, b + h) - found.time(a, b - h)) / (2 * h),
        ]
    drift = sp.lambdify((x1, x2), force, "numpy")(a, b)
    left = -slope[0] * b - slope[1] * drift + np.abs(slope[1])
    known = np.isfinite(left)
    assert known.sum() > 100
    # Points within h of a curve on which T has a kink are no test.
    assert np.quantile(np.abs(left[known] - 1), 0.95) < 1e-3
    steep = known & (np.abs(slope[1]) > 1e-3) & (np.abs(left - 1) < 1e-3)
    assert (found.control(a, b)[steep] == -np.sign(slope[1][steep])).all()


def test_agrees_with_the_solver_of_single_problems():
    pendulum = problem([x1, x2], force=-sp.sin(x1))
    found = synthesis(pendulum, window=((-2, 2), (-2, 2)), horizon=6)
    for start in ((1.2, 0.5), (-1.5, -0.4)):
        one = Problem(
            pendulum.dynamics,
            pendulum.controls,
            dict(zip((x1, x2), start)),
            terminal=pendulum.terminal,
        ).solve()
        assert found.time(*start) == pytest.approx(one.duration, abs=1e-7)


def test_traced_curve_and_parametrisation_agree(to_circle):
    traced = convex("circle")
    x = starts(to_circle.window, where=lambda a, b: a * a + b * b > 1.01)
    assert np.abs(traced.time(*x) - to_circle.time(*x)).max() < 1e-7


def test_points_on_the_target_and_shapes(to_circle):
    assert to_circle.time(1, 0) == 0
    assert isinstance(to_circle.time(2, 0), float) and to_circle.control(
        np.ones((2, 3)), 2.0
    ).shape == (2, 3)
    assert to_circle.reaches(2, 0) is True


def test_figure_labels_each_kind_of_curve_once(to_circle):
    import matplotlib.pyplot as plt

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ax = to_circle.plot(isochrones=[1, 2])
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    assert len(names) == len(set(names)) and {
        "switching curve",
        "abnormal extremal",
        "isochrones",
    } <= set(names)
    plt.close(ax.figure)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"problem": "x"}, "problem: expected a Problem"),
        ({"problem": Problem({x1: u}, {u: (-1, 1)}, {x1: 0}, terminal=[x1 - 1])}, "two states"),
        (
            {
                "problem": Problem(
                    {x1: x2, x2: u}, {u: (-1, 1)}, {x1: 0, x2: 0}, terminal=[x1 - 1], duration=2
                )
            },
            "depends on the time that is left",
        ),
        ({"problem": problem([x1, x2], (None, 1))}, "finite bounds"),
        ({"problem": problem([x1, x2], (-1, sp.Symbol("R")))}, "no value for R"),
        (
            {"problem": Problem({x1: x2, x2: u**2}, {u: (-1, 1)}, {x1: 0, x2: 0}, terminal=[x1])},
            "not affine",
        ),
        (
            {"problem": Problem({x1: u, x2: 0}, {u: (-1, 1)}, {x1: 0, x2: 0}, terminal=[x1])},
            "not controllable",
        ),
        ({"problem": problem([x1**2 + x2**2 + 1])}, "no solutions in the window"),
        ({"problem": problem([x1**2 - x2**2])}, "gradient"),
        ({"problem": problem([x1, x1 * x2])}, "fix one point"),
        ({"problem": problem([x2], (1, 2)), "side": "positive"}, "no extremal ends"),
        ({"problem": problem([x1]), "side": "left"}, "side: expected one of"),
        ({"problem": problem([x1]), "window": ((1, 0), (0, 1))}, "window: expected"),
        ({"problem": problem([x1]), "window": 3}, "window: expected"),
        ({"problem": problem([x1]), "horizon": -1}, "horizon: expected a positive"),
        ({"problem": problem([x1]), "curve": ((1, alpha), (alpha, -1, 1))}, "does not satisfy"),
        ({"problem": problem([x1]), "curve": 3}, "curve: expected"),
        (
            {"problem": problem([x1, x2]), "curve": ((0, alpha), (alpha, -1, 1))},
            "target is a point",
        ),
    ],
)
def test_invalid_arguments(arguments, message):
    with pytest.raises((TypeError, ValueError), match=message):
        synthesis(**arguments)


def test_points_outside_the_window_are_refused(to_rest):
    with pytest.raises(ValueError, match="inside the window"):
        to_rest.time(10, 0)
    with pytest.raises(ValueError, match="horizon"):
        to_rest.isochrone(99)
    with pytest.raises(KeyError, match="conditions are A, B"):
        to_rest.regularity()["Z"]


@pytest.fixture(scope="module")
def to_line():
    return synthesis(problem([x1 - x2]), horizon=8)


def test_barriers_of_both_sides_are_mirror_images(to_line):
    """Barriers of the line x1 = x2 (problem 5.10) end where the extremals touch it, at +-(1, 1)."""
    one, other = sorted(to_line.barriers, key=lambda curve: -curve.points[0, 0])
    assert np.allclose(one.points, -other.points, atol=1e-9) and np.allclose(
        one.points[0], [1, 1], atol=1e-9
    )
    assert np.allclose(one.points[:, 0], (1 + one.points[:, 1] ** 2) / 2, atol=1e-9)
    assert one.jump == pytest.approx(other.jump, rel=1e-3) and np.isfinite(one.jump)


@pytest.mark.parametrize("side", [1, -1])
def test_time_beside_a_barrier_is_that_of_the_detour(to_line, side):
    v = np.linspace(0.1, 0.99, 10)
    edge = (1 + v**2) / 2
    for beyond in (1e-3, 1e-4):
        x = side * np.array([edge + beyond, v])
        assert np.allclose(
            to_line.time(*x), 1 + v + np.sqrt(v**2 + 2 * (edge + beyond) - 1), atol=1e-6
        )


@pytest.mark.parametrize("side", [1, -1])
def test_no_point_is_missed_where_a_barrier_meets_the_target(to_line, side):
    """Next to (1, 1) in problem 5.10 neighbours meet the line again at different steps."""
    a, b = 1 + starts(((-0.3, 0.3), (-0.3, 0.3)), 2000)
    a, b = a[a > b], b[a > b]
    direct = (b < 1) & (a < (1 + b * b) / 2)
    with np.errstate(invalid="ignore"):
        exact = np.where(
            direct, 1 - b - np.sqrt(1 + b * b - 2 * a), 1 + b + np.sqrt(b * b + 2 * a - 1)
        )
    assert 10 < direct.sum() < a.size / 2
    assert np.abs(to_line.time(side * a, side * b) - exact).max() < 1e-6


def test_no_time_behind_the_target():
    """Extremals are continued a little beyond the target for their neighbours only."""
    found = synthesis(problem([x1]), side="positive", window=((-1, 1), (-2, 2)), horizon=6)
    a, b = starts(found.window)
    assert (found.reaches(a, b) == (a > 0)).all()


def inside_circle(radius):
    return synthesis(
        linear(OSCILLATOR, [x1**2 + x2**2 - radius**2]),
        side="inside",
        window=((-float(radius), float(radius)),) * 2,
        horizon=6,
    )


@pytest.mark.parametrize("radius", [sp.Rational(3, 2), sp.Rational(37, 20)])
def test_dispersal_curve_of_the_oscillator_runs_to_its_ends(radius):
    """Inside a circle (problem 5.8): x2 = x1 sqrt(D/(2 - D)), 2 D = R^2 - r^2.

    It runs from the circle through the centre to the circle. Near its ends, and everywhere as R
    grows to 2, the two extremals run side by side for a long time.
    """
    found = inside_circle(radius)
    points = np.vstack([curve.points for curve in found.dispersal_curves])
    size = np.hypot(*points.T)
    D = (float(radius) ** 2 - size**2) / 2
    assert np.abs(points[:, 1] - points[:, 0] * np.sqrt(D / (2 - D))).max() < 1e-10
    for branch in (points[:, 0] > 0, points[:, 0] < 0):
        covered = np.sort(np.append(size[branch], [0, float(radius)]))
        assert np.diff(covered).max() < 0.06
    assert not found.switching_curves and found.regularity()["C"].holds


def test_dispersal_curve_that_is_followed():
    """Inside the circle of radius 2 it is r = 2 |cos(angle)|, made of two touching extremals.

    Extremals switch on it.
    """
    found = inside_circle(sp.Integer(2))
    for curves in (found.switching_curves, found.dispersal_curves):
        points = np.vstack([curve.points for curve in curves])
        assert np.abs((np.abs(points[:, 0]) - 1) ** 2 + points[:, 1] ** 2 - 1).max() < 1e-10
        assert (points[:, 0] * points[:, 1] > 0).all()
        for branch in (points[:, 0] > 0, points[:, 0] < 0):
            assert (
                np.ptp(points[branch][:, 0]) > 1.98
                and np.diff(np.sort(points[branch][:, 0])).max() < 0.1
            )
    assert {curve.kind for curve in found.switching_curves} == {"followed"}


def test_touching_the_target_from_inside_fails_condition_c():
    """R = 3.3: the abnormal extremal from (R, 0) is optimal.

    Back with u = 1 it is a circle around (1, 0), above the semicircle on which extremals switch.
    """
    found = inside_circle(sp.Rational(33, 10))
    condition = found.regularity()["C"]
    assert not condition.holds and "(3.3, " in condition.text
    angle = np.linspace(0.1, 1.0, 9)
    assert np.abs(found.time(1 + 2.3 * np.cos(angle), 2.3 * np.sin(angle)) - angle).max() < 1e-4
    assert all(curve.arrives and not curve.optimal for curve in found.borders)


@pytest.mark.parametrize("size", [0.0, 0.1, 3.0, 20.0])
def test_a_step_of_a_linear_plant_is_exact(size):
    """Against the exponential of the joined matrix."""
    draw = np.random.default_rng(7)
    matrix = size * draw.standard_normal((3, 3)) / 3
    constant, start = draw.standard_normal((3, 1)), draw.standard_normal((3, 4))
    h = np.array([0.2, -0.5, 0.0, 1.0])
    joined = np.block([[matrix, constant], [np.zeros((1, 4))]])
    there = [(expm(joined * when) @ np.append(z, 1))[:3] for when, z in zip(h, start.T)]
    found = series_step(matrix, np.linalg.norm(matrix, 1), matrix @ start + constant, start, h)
    assert np.allclose(found.T, there, rtol=1e-12, atol=1e-13 * np.abs(there).max())


def test_crossing_of_a_surface():
    """psi_2 = -sin(angle - tau) of the oscillator at its zero, and slightly beyond it."""
    to_rest = linear(OSCILLATOR, [x1, x2])
    plant = Plant(to_rest, read_plant(to_rest))
    angle = np.array([1.0, 0.3, 0.05, 0.0, -1e-15])
    z = np.zeros((7, angle.size))
    z[2], z[3], z[4] = np.cos(angle), -np.sin(angle), 1
    mode, surface = np.full(angle.size, plant.first_mode(z)[0]), np.zeros(angle.size, int)
    for h in (np.full(angle.size, 1.2), angle + 1e-3):
        when, there = plant.first_zero(z, mode, surface, h, plant.step(z, mode, h))
        assert np.abs(when - np.maximum(angle, 0)).max() < 1e-14 and np.abs(there[3]).max() < 1e-14


def test_later_crossing_from_beyond_a_surface():
    to_rest = linear(OSCILLATOR, [x1, x2])
    plant = Plant(to_rest, read_plant(to_rest))
    # psi_2 = sin(tau - 1e-9) is in the mode of its positive values, begins below, and comes down
    # after a half-turn
    z = np.array([0, 0, np.cos(1e-9), -np.sin(1e-9), 1, 0, 0])[:, None]
    mode, surface, h = np.array([1]), np.array([0]), np.array([3.5])
    assert plant.name(1) == "u+"
    when, _ = plant.first_zero(z, mode, surface, h, plant.step(z, mode, h))
    assert abs(when[0] - np.pi - 1e-9) < 1e-13
