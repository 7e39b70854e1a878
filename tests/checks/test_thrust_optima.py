"""The fastest transfers under a thrust of free direction, against what a search and a separating
plane say."""

import numpy as np
import pytest
import sympy as sp
from scipy.optimize import minimize

from trajlib.pontryagin import Problem
from workbook.checks.references.optima.direct_optimum import optima
from workbook.checks.references.optima.thrust_optima import thrust_optima

x, y, v, w, u = sp.symbols("x y v w u")
RANDOM = np.random.default_rng(2).integers(-300, 300, (12, 4)).tolist()


def thrust(start, terminal, pull=0, size=1):
    return Problem(
        {x: v, y: w, v: size * sp.cos(u), w: size * sp.sin(u) - pull},
        {u: None},
        dict(zip((x, y, v, w), map(sp.Rational, start))),
        terminal,
    )


def only(problem):
    ((_, best),) = thrust_optima(problem)
    return best


@pytest.mark.parametrize("start", RANDOM)
def test_to_a_place(start):
    """The disc of all positions that can be reached holds the target then, and not before."""
    start = [sp.Rational(s, 100) for s in start]
    best = only(thrust(start, [x - 1, y], pull=sp.Rational(1, 3), size=2))
    times = best.duration * np.linspace(1e-3, 1, 2000)
    px, py, vx, vy = map(float, start)
    off = np.hypot(px + vx * times - 1, py + vy * times - times**2 / 6) - times**2
    assert abs(off[-1]) < 1e-12 * (1 + times[-1] ** 2) and (off[:-1] > 0).all()
    np.testing.assert_allclose(best.states[:2, -1], [1, 0], atol=1e-10)


@pytest.mark.parametrize("start", RANDOM)
def test_to_rest(start):
    """A little earlier a plane separates the target from all that can be reached."""
    start = [sp.Rational(s, 100) for s in start]
    best = only(thrust(start, [x, y, v, w]))
    np.testing.assert_allclose(best.states[:, -1], 0, atol=1e-8)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    T = 0.999 * best.duration
    s, z = (1 + nodes) / 2 * T, np.array(start, dtype=float)
    still = np.array([z[0] + T * z[2], z[1] + T * z[3], z[2], z[3]])

    def margin(p):
        return (
            p @ still + np.hypot(p[2] + p[0] * s, p[3] + p[1] * s) @ weights * T / 2
        ) / np.linalg.norm(p)

    assert min(minimize(margin, p).fun for p in [-still, *np.eye(4), *-np.eye(4)]) < 0


@pytest.mark.parametrize(
    "start, time",
    [
        ((3, 4, 0, 0), 2 * np.sqrt(5)),
        ((0, 0, 1, 0), 1 + np.sqrt(2)),
        ((2, -1, -1, "1/2"), np.sqrt(2.5 + 4 * np.sqrt(5)) - np.sqrt(1.25)),
        (("1/4", 0, -2, 0), 2 + np.sqrt(7)),
    ],
)
def test_along_a_line(start, time):
    best = only(thrust(start, [x, y, v, w]))
    assert best.duration == pytest.approx(time, rel=1e-14)
    np.testing.assert_allclose(best.states[:, -1], 0, atol=1e-12)


@pytest.mark.slow
def test_a_search_finds_nothing_better():
    position, rest = thrust((1, 2, 1, 0), [x, y]), thrust((1, 2, 1, 0), [x, y, v, w])
    assert optima(position)[0][1].duration == pytest.approx(only(position).duration, rel=1e-8)
    assert 0 <= optima(rest)[0][1].duration - only(rest).duration < 5e-3


def test_other_problems_are_left():
    assert thrust_optima(thrust((1, 2, 1, 0), [y, w])) is None
    assert thrust_optima(thrust((1, 2, 1, 0), [x, y, v, w - 1])) is None
    assert thrust_optima(thrust((1, 2, 1, 0), [x, y, v, w], pull=1)) is None
