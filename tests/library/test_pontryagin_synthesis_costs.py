"""Planar syntheses for other costs than the time, for maxima and for several controls.

Against closed forms, Bellman's equation and `solve`.
"""

import numpy as np
import pytest
import sympy as sp

from trajlib.pontryagin import Problem, synthesis

pytestmark = pytest.mark.slow
x1, x2, u, v = sp.symbols("x1 x2 u v")
R = sp.Rational
ANYWHERE, ONE, BOX = {x1: None, x2: None}, {u: (-1, 1)}, {u: (-1, 1), v: (-1, 1)}
PLANE, ORIGIN = {x1: x2, x2: u}, [x1, x2]


def starts(window, count=200, seed=2):
    random = np.random.default_rng(seed)
    return np.array([random.uniform(*pair, count) for pair in window])


def from_one_side(a, b, curves):
    """Signs: 1 to the right of all curves x1 = -c x2|x2|, -1 to the left of all, 0 between."""
    sides = np.array([np.sign(a + c * b * np.abs(b)) for c in curves])
    return np.where((sides == 1).all(axis=0), 1, np.where((sides == -1).all(axis=0), -1, 0))


def test_time_and_fuel():
    """Problem 5.25, with the closed form of its page."""
    window = ((-8, 8), (-2.4, 2.4))
    found = synthesis(
        Problem(PLANE, ONE, ANYWHERE, ORIGIN, running=1 + R(3, 4) * sp.Abs(u)),
        window=window,
        horizon=12,
    )
    a, b = starts(window)
    side = from_one_side(a, b, (2, 0.5))
    a, b, side = a * np.where(side, side, 1), b * np.where(side, side, 1), side
    with np.errstate(invalid="ignore"):
        cost = np.where(
            side != 0, 7 * b / 4 + np.sqrt(10 * a + 5 * b * b), np.abs(a / b) + 5 * np.abs(b) / 4
        )
        time = np.where(
            side != 0, b + 3.5 * np.sqrt((a + b * b / 2) / 2.5), np.abs(a / b) + np.abs(b) / 2
        )
    sign = np.where(side, side, 1)
    assert np.abs(found.cost(sign * a, sign * b) - cost).max() < 1e-8
    assert np.abs(found.time(sign * a, sign * b) - time).max() < 1e-8
    assert (found.control(sign * a, sign * b) == -side).all()
    assert (found.level(sign * a, sign * b)[side == 0] == "zero").all()
    changes = {("u-", "zero"), ("u+", "zero"), ("zero", "u-"), ("zero", "u+")}
    assert {curve.change for curve in found.switching_curves} == changes
    for curve in found.switching_curves:
        p, q = curve.points.T
        assert np.abs(p + (0.5 if curve.change[0] == "zero" else 2) * q * np.abs(q)).max() < 1e-10
        assert curve.kind == ("followed" if curve.change[0] == "zero" else "crossed")
    assert found.regularity().regular and not found.barriers


def test_time_and_energy():
    """Problem 5.26: between the curves the law is a root of an equation of the fourth degree."""
    window = ((-8, 8), (-2.8, 2.8))
    found = synthesis(
        Problem(PLANE, ONE, ANYWHERE, ORIGIN, running=1 + u**2 / 2), window=window, horizon=12
    )
    a, b = starts(window)
    side, w = from_one_side(a, b, (43 / 6, 0.5)), found.control(a, b)
    inside = side == 0
    assert inside.sum() > 40 and (w[~inside] == -side[~inside]).all()
    root = a * (2 - w * w) ** 2 + 23 / 6 * b * np.abs(b) + b * b * (4 * w - 2 / 3 * w**3)
    assert np.abs(root[inside]).max() < 1e-8 and (found.level(a, b)[inside] == "interior").all()
    p, q = (side * a)[~inside], (side * b)[~inside]
    assert (
        np.abs(found.cost(a, b)[~inside] - 1.5 * q - np.sqrt(23 / 3 * (p + q * q / 2))).max() < 1e-8
    )
    for curve in found.switching_curves:
        p, q = curve.points.T
        assert (
            np.abs(p + (0.5 if curve.change[0] == "interior" else 43 / 6) * q * np.abs(q)).max()
            < 1e-10
        )
    tests = found.regularity()
    assert tests.regular and tests["E"].value < 1e-12


@pytest.mark.parametrize(
    "target, running, side",
    [
        (ORIGIN, 1 + x1**2, "both"),
        ([x1**2 + x2**2 - 1], x1**2, "outside"),
        ([x1], 1 + u**2 / 2 + sp.Abs(u) / 4, "positive"),
    ],
    ids=["time and place", "place, to a circle", "time, energy and fuel, to a line"],
)
def test_least_costs_satisfy_the_bellman_equation(target, running, side):
    window = ((-2, 2), (-2, 2)) if side != "positive" else ((0, 2), (-2, 2))
    found = synthesis(
        Problem(PLANE, ONE, ANYWHERE, target, running=running), window=window, horizon=8, side=side
    )
    a, b = starts([(low + 0.01, high - 0.01) for low, high in window], 120)
    h = 1e-5
    with np.errstate(invalid="ignore"):
        slopes = [
            (found.cost(a + h, b) - found.cost(a - h, b)) / (2 * h),
            (found.cost(a, b + h) - found.cost(a, b - h)) / (2 * h),
        ]
    price = sp.lambdify((x1, x2, u), running, "numpy")
    values = np.linspace(-1, 1, 401)
    left = np.min([price(a, b, w) + slopes[0] * b + slopes[1] * w for w in values], axis=0)
    law = price(a, b, found.control(a, b)) + slopes[0] * b + slopes[1] * found.control(a, b)
    known = np.isfinite(left)
    assert known.sum() > 80
    # Points within h of a curve on which the cost has a kink are no test.
    for residual in (left, law):
        assert np.quantile(np.abs(residual[known]), 0.95) < 1e-4


def test_single_problems_agree():
    running = 1 + x1**2 + u**2
    found = synthesis(
        Problem({x1: x2, x2: u - sp.sin(x1)}, ONE, ANYWHERE, ORIGIN, running=running),
        window=((-1, 1), (-1, 1)),
        horizon=5,
    )
    for start in ((R(3, 4), R(-1, 2)), (-1, -1)):
        one = Problem(
            {x1: x2, x2: u - sp.sin(x1)}, ONE, dict(zip((x1, x2), start)), ORIGIN, running=running
        ).solve()
        place = tuple(map(float, start))
        assert found.cost(*place) == pytest.approx(one.cost, rel=1e-9)
        assert found.time(*place) == pytest.approx(one.duration, rel=1e-8)
        assert found.control(*place) == pytest.approx(one.control(0)[0], abs=1e-7)


@pytest.mark.parametrize("maximise, sign", [(False, -1), (True, 1)])
def test_greatest_terminal_value(maximise, sign):
    """Problem 5.24: half a turn around u = 1 leads furthest."""
    found = synthesis(
        Problem({x1: x2, x2: u - x1}, ONE, ANYWHERE, [x2], final=sign * x1, maximise=maximise),
        side="positive",
        horizon=8,
    )
    a, b = starts(((-3, 3), (0.05, 3)))
    assert np.abs(found.cost(a, b) - sign * (1 + np.hypot(a - 1, b))).max() < 1e-9
    assert (found.control(a, b) == 1).all()


def test_the_longest_time():
    """x1' = x2 - 2 with x2 held below 2: to reach x1 = 0 as late as possible push x2 upwards."""
    plant = {x1: x2 - 2, x2: u - x2}
    found = synthesis(
        Problem(plant, ONE, ANYWHERE, [x1], maximise=True),
        side="positive",
        window=((0, 2), (-1, 1)),
        horizon=5,
    )
    for start in ((1, R(1, 2)), (R(3, 2), -R(1, 2))):
        one = Problem(plant, ONE, dict(zip((x1, x2), start)), [x1], maximise=True).solve()
        assert found.cost(*map(float, start)) == pytest.approx(one.cost, rel=1e-9)
        assert found.control(*map(float, start)) == 1


def test_two_controls_one_of_which_is_open():
    """Each coordinate has a control of its own: only the farther one is in a hurry."""
    found = synthesis(Problem({x1: u, x2: v}, BOX, ANYWHERE, ORIGIN), window=((-2, 2), (-2, 2)))
    a, b = starts(found.window)
    assert np.abs(found.time(a, b) - np.maximum(np.abs(a), np.abs(b))).max() < 1e-9
    assert not found.unique(a, b).any()
    assert found.level(1, 0.5) == ("u-", "open") and found.level(0.5, 1) == ("open", "u-")
    first, second = found.control(1, 0.5)
    assert first == -1 and second == pytest.approx(-0.5, abs=1e-9)  # one value of many
    assert found.control(a, b).shape == (2, a.size)


def test_two_controls_of_one_chain():
    """x1' = x2 + u, x2' = v: both at their bounds in turn from afar, the first open from nearby."""
    plant = {x1: x2 + u, x2: v}
    found = synthesis(Problem(plant, BOX, ANYWHERE, ORIGIN), window=((-2, 2), (-2, 2)))
    for start in ((1, R(1, 2)), (2, R(3, 2)), (-1, -1), (R(3, 2), -R(1, 2))):
        one = Problem(plant, BOX, dict(zip((x1, x2), start)), ORIGIN).solve()
        place = tuple(map(float, start))
        assert found.time(*place) == pytest.approx(one.duration, rel=1e-10) and found.unique(*place)
        assert list(found.control(*place)) == list(one.control(0))
    # |x2| is the time where the other coordinate has some to spare: it goes with v = -sign x2, and
    # u is what it takes.
    a, b = starts(found.window, 400)
    spare = np.abs(a + b * np.abs(b) / 2) < np.abs(b)
    assert 50 < spare.sum() and (found.unique(a, b) == ~spare).all()
    assert np.abs(found.time(a, b)[spare] - np.abs(b)[spare]).max() < 1e-9
    assert found.level(0.1, -1) == ("open", "u+")


@pytest.mark.parametrize(
    "problem, message",
    [
        (
            Problem(PLANE, ONE, ANYWHERE, ORIGIN, running=x1**2),
            "positive at a target point .there it is 0",
        ),
        (
            Problem(PLANE, ONE, ANYWHERE, ORIGIN, running=u**2),
            "positive at a target point .there it is u",
        ),
        (
            Problem(PLANE, ONE, ANYWHERE, ORIGIN, maximise=True),
            "with the opposite sign, for a maximum",
        ),
        (Problem(PLANE, ONE, ANYWHERE, ORIGIN, running=1 + u**4), "second degree"),
        (
            Problem(PLANE, ONE, ANYWHERE, ORIGIN, running=2 + u**2 - sp.Abs(u)),
            "neither convex nor concave",
        ),
        (Problem(PLANE, ONE, ANYWHERE, ORIGIN, running=2 + x1 * sp.Abs(u)), "one sign"),
        (
            Problem({x1: u, x2: v}, BOX, ANYWHERE, ORIGIN, running=2 + u * v),
            "product of u with another control",
        ),
        (Problem({x1: x2 * u, x2: v * u}, BOX, ANYWHERE, ORIGIN), "not affine"),
        # A raft goes fastest in the middle of the river (5.49), and would stay there.
        (Problem({x1: u, x2: 1}, ONE, ANYWHERE, [x1 - 1], running=1 + x1**2 - x2), "singular in u"),
    ],
)
def test_problems_without_a_synthesis(problem, message):
    with pytest.raises(ValueError, match=message):
        synthesis(problem)


def test_figures_label_every_level():
    import matplotlib.pyplot as plt

    for running, controls, plant, names in (
        (1 + sp.Abs(u), ONE, PLANE, {"$u = -1$", "$u = 1$", "$u = 0$"}),
        (1 + u**2, ONE, PLANE, {"$u = -1$", "$u = 1$", "$-1 < u < 1$"}),
        (1, BOX, {x1: u, x2: v}, {r"$u = -1, v\ \mathrm{open}$"}),
    ):
        found = synthesis(
            Problem(plant, controls, ANYWHERE, ORIGIN, running=running),
            window=((-1, 1), (-1, 1)),
            horizon=2,
        )
        ax = found.plot()
        shown = [text.get_text() for text in ax.get_legend().get_texts()]
        assert names <= set(shown) and len(shown) == len(set(shown))
        plt.close(ax.figure)
