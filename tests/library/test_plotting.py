"""Pictures: what is drawn where, and that nothing global changes."""

import subprocess
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import pytest
import sympy as sp

from trajlib import plotting
from trajlib.stability import basin_estimate, stability_conditions

x, y, k1, k2, s = sp.symbols("x y k1 k2 s")
pendulum = [y, -y / 3 - sp.sin(x)]


@pytest.fixture(autouse=True)
def close_figures():
    yield
    plt.close("all")


def drawn(ax):
    """Render, so that errors of layout and mathtext come to light."""
    ax.figure.canvas.draw()
    return ax


def hatched_at(ax, point):
    """Whether the hatching covers a point of the plane."""
    return any(
        path.contains_point(point)
        for c in ax.collections
        if c.get_hatch() or getattr(c, "hatches", [None])[0]
        for path in c.get_paths()
    )


def test_import_changes_and_loads_nothing():
    code = (
        "import sys; import trajlib.plotting; assert 'matplotlib' not in sys.modules; import "
        "matplotlib as m; before = dict(m.rcParams); import trajlib.plotting; assert "
        "dict(m.rcParams) == before"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=120)


def test_style_is_local_and_rcparams_survive_every_function():
    before = dict(matplotlib.rcParams)
    with plotting.style():
        assert matplotlib.rcParams["figure.constrained_layout.use"]
    plotting.phase_portrait(pendulum, [x, y], (-4, 4), (-3, 3))
    plotting.region(k1 > 0, [k1, k2], (-1, 1), (-1, 1))
    plotting.roots(s**2 + 1, s)
    assert dict(matplotlib.rcParams) == before


def test_each_function_returns_the_axes_it_was_given():
    with plotting.style():
        _, ax = plt.subplots()
    assert plotting.phase_portrait(pendulum, [x, y], (-4, 4), (-3, 3), ax=ax, starts=[(1, 1)]) is ax
    assert plotting.nullclines(pendulum, [x, y], ax) is ax
    assert plotting.mark_equilibria([(0, 0), (sp.pi, 0)], ["stable focus", "saddle"], ax) is ax
    assert plotting.level_curve(y**2 / 2 + 1 - sp.cos(x), [x, y], 2, ax, label="$V = 2$") is ax
    assert plotting.sublevel_component(y**2 / 2 + 1 - sp.cos(x), [x, y], 2, ax) is ax
    drawn(ax)
    assert ax.get_xlabel() == "$x$" and ax.get_xlim() == (-4, 4)
    labels = [t.get_text() for t in ax.get_legend().get_texts()]
    assert labels == [r"$\dot{x} = 0$", r"$\dot{y} = 0$", "stable focus", "saddle", "$V = 2$"]


def test_labels_are_mathtext_of_the_symbols():
    ax = drawn(
        plotting.region(
            sp.Symbol("lambda") > sp.Symbol("mu_1"), sp.symbols("lambda mu_1"), (0, 1), (0, 1)
        )
    )
    assert (ax.get_xlabel(), ax.get_ylabel()) == (r"$\lambda$", r"$\mu_{1}$")


def test_trajectories_end_at_the_stable_point():
    ax = plotting.phase_portrait(pendulum, [x, y], (-4, 4), (-3, 3), starts=[(1.5, 0)])
    forwards = ax.lines[0].get_xydata()
    assert np.allclose(forwards[0], [1.5, 0]) and np.hypot(*forwards[-1]) < 0.05
    backwards = ax.lines[1].get_xydata()
    assert np.hypot(*backwards[-1]) > 2


def test_field_that_is_undefined_somewhere():
    field = [sp.log(2 - y**2), sp.exp(x) - sp.exp(y)]
    ax = drawn(plotting.phase_portrait(field, [x, y], (-3, 3), (-2, 2), starts=[(0, 0.5)]))
    assert max(np.abs(line.get_ydata()).max() for line in ax.lines) < np.sqrt(2) + 1e-6


def test_parameters_of_a_field():
    d = sp.Symbol("delta")
    drawn(plotting.phase_portrait([y, -d * y - x], [x, y], (-1, 1), (-1, 1), params={d: 0.5}))
    drawn(plotting.phase_portrait([y, -x], [x, y], (-1, 1), (-1, 1), params={}))


def test_region_is_hatched_inside_only():
    result = stability_conditions(s**3 + k1 * s**2 + k2 * s + 1, [k1, k2], symbol=s)
    ax = drawn(result.plot((-1, 4), (-1, 4)))
    assert (
        hatched_at(ax, (2, 2))
        and not hatched_at(ax, (0.5, 0.5))
        and not hatched_at(ax, (-0.5, -0.5))
    )


def test_region_of_two_parts_and_the_empty_one():
    ax = drawn(
        plotting.region(
            sp.Or(sp.And(k1 > 0, k1 * k2 > 1), k1 + k2 <= -1), [k1, k2], (-5, 5), (-5, 5)
        )
    )
    assert hatched_at(ax, (3, 3)) and hatched_at(ax, (-3, -3)) and not hatched_at(ax, (3, -2))
    ax = drawn(plotting.region(sp.false, [k1, k2], (-1, 1), (-1, 1)))
    assert not hatched_at(ax, (0, 0)) and ax.texts[0].get_text() == "empty"
    ax = drawn(plotting.region(sp.true, [k1, k2], (-1, 1), (-1, 1)))
    assert hatched_at(ax, (0.5, 0.5))
    drawn(plotting.region(sp.Not(sp.And(k1 > 0, k2 > 0)), [k1, k2], (-1, 1), (-1, 1)))


def test_only_the_component_around_the_origin_is_hatched():
    V = y**2 / 2 + x**2 + x**3
    estimate = basin_estimate(V, [y, -2 * x - y - 3 * x**2], [x, y])
    ax = drawn(estimate.plot((-1.2, 0.8), (-1, 1)))
    assert hatched_at(ax, (0, 0)) and hatched_at(ax, (-0.6, 0.05)) and not hatched_at(ax, (-1, 0))
    everywhere = basin_estimate(x**2 + y**2, [-x, -y], [x, y])
    drawn(everywhere.plot((-1, 1), (-1, 1)))


def test_roots_are_drawn_at_their_values():
    ax = drawn(plotting.roots([s**2 + 2 * s + 2, s + 3], s, labels=["a", "b"]))
    first, second = ax.lines[:2]
    assert np.allclose(sorted(first.get_ydata()), [-1, 1]) and np.allclose(first.get_xdata(), -1)
    assert np.allclose(second.get_xdata(), -3) and first.get_marker() != second.get_marker()


def test_estimate_has_a_band_of_two_deviations():
    ax = drawn(plotting.estimate([0, 1, 1, 2], [1, 2, 0, 0], [1, 2, 0.5, 1], label="here"))
    middle, low, high = ax.lines
    assert np.allclose(middle.get_ydata(), [1, 2, 0, 0]) and np.allclose(
        high.get_ydata(), [3, 6, 1, 2]
    )
    assert np.allclose(low.get_ydata(), [-1, -2, -1, -2]) and len(ax.collections) == 1
    with pytest.raises(ValueError, match="deviation: expected three arrays"):
        plotting.estimate([0, 1], [1, 2], [1])


@pytest.mark.parametrize(
    "call, error, named",
    [
        (lambda ax: plotting.phase_portrait(pendulum, [x], (0, 1), (0, 1)), ValueError, "state"),
        (lambda ax: plotting.phase_portrait([y], [x, y], (0, 1), (0, 1)), ValueError, "field"),
        (
            lambda ax: plotting.phase_portrait([y, -k1 * x], [x, y], (0, 1), (0, 1)),
            ValueError,
            "params: .*k1",
        ),
        (
            lambda ax: plotting.phase_portrait(pendulum, [x, y], (1, 0), (0, 1)),
            ValueError,
            "x_range",
        ),
        (
            lambda ax: plotting.phase_portrait(pendulum, [x, y], (0, 1), (0, 1), starts=[3]),
            ValueError,
            "starts",
        ),
        (lambda ax: plotting.mark_equilibria([(0, 0)], [], ax), ValueError, "labels"),
        (
            lambda ax: plotting.region(k1 > s, [k1, k2], (0, 1), (0, 1)),
            ValueError,
            "condition: .*s",
        ),
        (lambda ax: plotting.region(k1 + 1, [k1, k2], (0, 1), (0, 1)), TypeError, "condition"),
        (lambda ax: plotting.roots(s**2 + k1, s), ValueError, "polys"),
        (lambda ax: plotting.roots([s, s], s, labels=["one"]), ValueError, "labels"),
        (lambda ax: plotting.level_curve(k1 * x, [x, y], 1, ax), ValueError, "V: .*k1"),
        (lambda ax: plotting.sublevel_component(x**2 + 3, [x, y], 1, ax), ValueError, "level"),
        (lambda ax: plotting.nullclines(pendulum, [x, y], None), TypeError, "ax"),
    ],
)
def test_errors_name_the_argument(call, error, named):
    with plotting.style():
        _, ax = plt.subplots()
    with pytest.raises(error, match=named):
        call(ax)
