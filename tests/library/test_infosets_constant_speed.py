"""Information sets for a known speed, and the exact reachable set of the Dubins car.

The reachable set is tested by brute force over turn-straight and turn-turn controls, by search among
all motions with two switches and by quadrature, and the information sets are tested against it.
"""

import numpy as np
import pytest
from flights import fly
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.optimize import minimize

from trajlib.infosets import (
    ConstantSpeedInformationSet,
    EmptyInformationSet,
    Region,
    SupportPolygons,
    dubins_reachable,
)
from trajlib.infosets.polygons import normals


def ends(controls, durations, heading=0.0):
    """Ends (count, 2) of motions with unit speed and radius: controls (pieces,), durations (count,
    pieces)."""
    psi, position = np.full(len(durations), float(heading)), np.zeros((len(durations), 2))
    for u, d in zip(controls, durations.T):
        after = psi + u * d
        if u:
            position += (
                np.stack([np.cos(psi) - np.cos(after), np.sin(after) - np.sin(psi)], axis=-1) / u
            )
        else:
            position += d[:, None] * np.stack([np.sin(psi), np.cos(psi)], axis=-1)
        psi = after
    return position


def two_pieces(T, count=2001):
    first = np.linspace(0, T, count)
    return np.column_stack([first, T - first])


@pytest.mark.parametrize("T", [0.3, 1.5, np.pi, 4.0, 3 * np.pi / 2, 2 * np.pi, 9.0])
def test_the_support_function_against_brute_force(T):
    """No motion goes beyond it, and turn-straight motions reach it; turn-turn motions do not go
    further."""
    directions = np.linspace(0, 2 * np.pi, 73)
    n = np.stack([np.sin(directions), np.cos(directions)])
    support = dubins_reachable(T).support(directions)
    turn_straight = np.maximum(
        *((ends((side, 0), two_pieces(T)) @ n).max(axis=0) for side in (1, -1))
    )
    turn_turn = np.maximum(
        *((ends((side, -side), two_pieces(T)) @ n).max(axis=0) for side in (1, -1))
    )
    assert (turn_straight <= support + 1e-12).all() and (turn_straight >= support - 1e-5 * T).all()
    assert (turn_turn <= support + 1e-12).all()
    random = np.random.default_rng(1)
    for controls in random.uniform(-1, 1, (300, 5)):
        reached = ends(controls, random.dirichlet(np.ones(5), 20) * T)
        assert (reached @ n <= support + 1e-12).all()


def test_the_support_function_against_quadrature_and_units():
    exact = dubins_reachable(13.0, speed=20.0, k=5.0, heading=1.0, position=(100.0, -50.0))
    assert exact.radius == 80 and exact.turn == pytest.approx(3.25)
    for phi in np.linspace(-4, 4, 17):
        apart = abs((phi - 1.0 + np.pi) % (2 * np.pi) - np.pi)
        distance = quad(
            lambda s: 20 * np.cos(max(apart - 0.25 * s, 0)),
            0,
            13,
            points=[min(4 * apart, 13)],
            limit=200,
        )[0]
        assert exact.support(phi) == pytest.approx(
            distance + 100 * np.sin(phi) - 50 * np.cos(phi), abs=1e-6
        )


def shortest_miss(place, T):
    """The least distance from a place at which a motion with two switches and the length T ends."""
    share = np.linspace(0, 1, 50)
    first, second = (part.ravel() for part in np.meshgrid(share, share))
    durations = T * np.column_stack([first, (1 - first) * second, (1 - first) * (1 - second)])
    best = np.inf
    for controls in ((1, 0, 1), (1, 0, -1), (-1, 0, 1), (-1, 0, -1), (1, -1, 1), (-1, 1, -1)):

        def miss(two):
            a, b = np.clip(two, 0, 1)
            return np.hypot(
                *(ends(controls, T * np.array([[a, (1 - a) * b, (1 - a) * (1 - b)]]))[0] - place)
            )

        distance = np.hypot(*(ends(controls, durations) - place).T)
        for k in np.argsort(distance)[:2]:
            states = minimize(
                miss,
                [first[k], second[k]],
                method="Nelder-Mead",
                options={"xatol": 1e-9, "fatol": 1e-9, "maxiter": 300},
            )
            best = min(best, states.fun)
        if best < 1e-6:
            break
    return best


@pytest.mark.slow
@pytest.mark.parametrize("T", [2.0, np.pi, 4.0, 3 * np.pi / 2, 2 * np.pi, 7.0])
def test_membership_against_a_search(T):
    random = np.random.default_rng(round(100 * T))
    near = ends((1, 0, -1), random.dirichlet(np.ones(3), 12) * T) + random.normal(0, 0.3, (12, 2))
    positions = np.concatenate([near, random.uniform(-min(T, 4), T, (12, 2))])
    inside = dubins_reachable(T).contains(positions)
    misses = np.array([shortest_miss(position, T) for position in positions])
    assert (
        (misses[inside] < 1e-6).all() and (misses[~inside] > 1e-4).all() and 0 < inside.sum() < 24
    )


@given(seed=st.integers(0, 10**6), T=st.sampled_from([0.5, 1.5, np.pi, 4.0, 5.5, 2 * np.pi, 9.0]))
@settings(max_examples=40, deadline=None)
def test_reached_points_are_members(seed, T):
    random = np.random.default_rng(seed)
    controls = random.choice([-1, 0, 1, 0.3], 6)
    positions = ends(controls, random.dirichlet(0.5 * np.ones(6), 30) * T, heading=2.0)
    exact = dubins_reachable(T, heading=2.0)
    assert exact.contains(positions).all()
    away = random.normal(size=(30, 2))
    away *= (exact.turn * 1.001 + random.exponential(size=30)[:, None]) / np.linalg.norm(
        away, axis=1, keepdims=True
    )
    assert not exact.contains(away).any()


@pytest.mark.slow
@pytest.mark.parametrize("T", [np.pi / 2, np.pi, 5 * np.pi / 4, 2 * np.pi])
def test_boundary_separates_reached_and_other_points(T):
    """Beside each of its points one side is reached and one is not; it is made of turn-straight and
    turn-turn ends."""
    exact = dubins_reachable(T)
    points = np.concatenate([curve[1:-1] for curve in exact.boundary(60)])
    angle = np.linspace(0, 2 * np.pi, 25)
    near = points[:, None] + 5e-3 * np.stack([np.sin(angle), np.cos(angle)], axis=-1)
    inside = exact.contains(near).sum(axis=1)
    assert len(points) > 60 and (inside > 0).all() and (inside < 25).all()
    assert exact.contains(points).all()
    families = np.concatenate(
        [ends(word, two_pieces(T, 20001)) for word in ((1, 0), (-1, 0), (1, -1), (-1, 1))]
    )
    gaps = np.min(np.hypot(*(points[:, None] - families[::7]).transpose(2, 0, 1)), axis=1)
    assert gaps.max() < 2e-2 * T / np.pi


def test_known_positions():
    half = dubins_reachable(np.pi)
    assert half.contains([[0, np.pi], [2, 0], [-2, 0]]).all()
    assert not half.contains([[0, np.pi + 1e-3], [0, 2], [2.01, 0], [0, 0]]).any()
    circle = dubins_reachable(2 * np.pi)
    assert (
        circle.contains([0, 0]) and not circle.contains([0, 1]) and not circle.contains([0, -2.6])
    )
    assert circle.support(np.pi) == pytest.approx(np.pi)


@pytest.mark.parametrize("steps", [8, 16, 32, 64])
def test_three_controls_converge_from_inside_with_second_order(steps):
    """m = 64, one heading: outer boundaries agree, the published one is inside by O(D^2), at most
    where it goes on straight for all of the time at half a step's turn from the direction, T (1 -
    cos(D/2))."""
    T = 6.0
    states = ConstantSpeedInformationSet(
        [[0, 0]],
        speed=1,
        k=1,
        dt=T / steps,
        heading_range=np.pi / 2,
        normals=64,
        headings=4000,
        mode="published",
        wrapped=False,
    ).advance(steps)
    assert len(states.heading_nodes) == 2 * steps + 1
    exact = dubins_reachable(T, heading=np.pi / 2).support(2 * np.pi * np.arange(64) / 64)
    short = exact - states.sections.hull().values
    assert short.min() > -1e-9 and 0.2 < short.max() / (T * (1 - np.cos(T / steps / 2))) <= 1


@pytest.mark.slow
@pytest.mark.parametrize("i", [1, 2, 3, 4])
def test_figure_9_the_exact_set_lies_inside_up_to_the_step(i):
    """At the times i (pi/2) V/k all that is reached lies in the union of the sections, grown by
    O(D^2); of the union a part is not reached, along the inner boundary."""
    speed, k, steps = 100.0, 5.0, 40
    t = i * np.pi / 2 * speed / k
    exact = dubins_reachable(t, speed=speed, k=k, heading=np.pi / 2)
    states = ConstantSpeedInformationSet(
        [[0, 0]],
        speed=speed,
        k=k,
        dt=t / steps,
        heading_range=np.pi / 2,
        normals=64,
        headings=4000,
        mode="published",
        wrapped=False,
    ).advance(steps)
    sections = states.projection()
    grown = SupportPolygons.of_tight(sections.values + 2e-3 * exact.radius * i**2)
    random = np.random.default_rng(i)
    positions = (
        ends((1, 0, -1), random.dirichlet(np.ones(3), 300) * exact.turn, heading=np.pi / 2)
        * exact.radius
    )
    assert grown.values.shape == (2 * steps + 1, 64)
    assert all(grown.contains(position).any() for position in positions)
    corners = sections.vertices
    within = (corners + corners.mean(axis=-2, keepdims=True)) / 2
    assert np.sum(~exact.contains(within)) > 3


def test_figure_10_normals_at_five_eighths_of_a_turn():
    """How far the polygons of 12, 24 and 48 normals go beyond the convex hull: a quarter with twice
    as many."""
    T, steps, directions = 5 * np.pi / 4, 64, np.linspace(0, 2 * np.pi, 1441)
    n, beyond = np.stack([np.sin(directions), np.cos(directions)]), []
    for m in (12, 24, 48):
        states = ConstantSpeedInformationSet(
            [[0, 0]],
            speed=1,
            k=1,
            dt=T / steps,
            heading_range=0.0,
            normals=m,
            headings=4000,
            mode="published",
            wrapped=False,
        ).advance(steps)
        reach = (states.sections.hull().vertices @ n).max(axis=0)
        beyond.append((reach - dubins_reachable(T).support(directions)).max())
    assert beyond[0] == pytest.approx(0.129, abs=0.001) and beyond[1] == pytest.approx(
        0.0325, abs=0.0005
    )
    assert np.array(beyond[:-1]) / beyond[1:] == pytest.approx(4, abs=0.1)


def flight(seed, steps, dt, k, speed):
    random = np.random.default_rng(seed)
    u = random.choice([-1, -0.5, 0, 0.3, 1], 3 * steps)
    start = (*random.uniform(-1e4, 1e4, 2), random.uniform(0, 2 * np.pi), speed)
    return fly(start, [(dt / 3, a, 0) for a in u], k)[::3, :3], random


@pytest.mark.parametrize("wrapped", [True, False])
def test_guaranteed_set_keeps_the_true_state(wrapped):
    for seed in range(12):
        dt, headings = (1.0, 0.4, 2.0)[seed % 3], (60, 90, 360)[seed % 3]
        truth, random = flight(seed, 24, dt, 15.0, 100.0)
        heading = truth[0, 2]
        arc = (None, heading, (heading - 0.4, heading), (heading, heading + 0.1))[seed % 4]

        def seen(step):
            return Region.box(truth[step, :2] + 20 * random.choice([-1, 1], 2), 40)

        states = ConstantSpeedInformationSet(
            seen(0),
            speed=100.0,
            k=15.0,
            dt=dt,
            headings=headings,
            heading_range=arc,
            wrapped=wrapped,
        )
        for step in range(1, 25):
            states.advance()
            if step % 5 == 0:
                states.measure(seen(step))
            assert states.contains(truth[step]), (seed, step)
            assert states.bounds().x[0] <= truth[step, 0] + 1e-6


def test_guaranteed_set_encloses_the_exact_set_and_converges_to_it():
    T, excess = np.pi, []
    exact = dubins_reachable(T)
    for steps in (10, 20, 40, 80):
        states = ConstantSpeedInformationSet(
            [[0, 0]],
            speed=1,
            k=1,
            dt=T / steps,
            heading_range=0.0,
            normals=32,
            headings=2 * steps,
            wrapped=False,
        ).advance(steps)
        beyond = states.sections.hull().values - exact.support(2 * np.pi * np.arange(32) / 32)
        assert beyond.min() > 0
        excess.append(beyond.max())
    assert np.array(excess[:-1]) / excess[1:] == pytest.approx(2, abs=0.4)


def test_published_motion_with_squares():
    """V = 200, k = 5, 360 headings, squares of 400 m every 20 s, rectangles, two turns."""
    pieces = [
        (1.0, u, 0)
        for count, u in ((10, 0), (20, 1), (15, 0), (25, -1), (10, 0))
        for _ in range(count)
    ]
    truth = fly((0, 0, 1.0, 200), pieces, 5.0)[:, :3]
    random = np.random.default_rng(3)
    states = ConstantSpeedInformationSet(
        Region.box(truth[0, :2], 400), speed=200, k=5, headings=360, normals=4, mode="published"
    )
    assert len(states.heading_nodes) == 360
    for t in range(1, 81):
        states.advance()
        if t % 20 == 0:
            if t == 20:
                assert (
                    states.bounds().heading[1] - states.bounds().heading[0] > 6.2
                    and len(states.heading_nodes) <= 800
                )
            states.measure(Region.box(truth[t, :2] + random.uniform(-200, 200, 2), 400))
            low, high = states.bounds().heading
            assert (truth[t, 2] - low) % (2 * np.pi) < high - low < 2
            assert states.projection("psi").shape == states.heading_nodes.shape
    assert (
        states.bounds().speed is None
        and "psi in" in str(states.bounds())
        and "V in" not in str(states.bounds())
    )


@pytest.mark.parametrize("mode", ["published", "guaranteed"])
def test_figure_6_from_one_heading(mode):
    """V = 400, k = 15, a parallelogram at 20 s and a rectangle at 32 s; the motion, which is not
    given, is ours."""
    pieces = [(1.0, u, 0) for count, u in ((10, 0), (15, 1), (15, -1)) for _ in range(count)]
    truth = fly((0, 0, 0, 400), pieces, 15.0)[:, :3]
    states = ConstantSpeedInformationSet(
        Region.disc([0, 0], 100), speed=400, k=15, heading_range=0.0, mode=mode
    )
    shape = np.array([[-500, -200], [100, -200], [500, 200], [-100, 200]])
    widths = []
    for t in range(1, 41):
        states.advance()
        if t in (20, 32):
            before = states.bounds()
            states.measure(
                truth[t, :2]
                + (shape if t == 20 else [[-300, -150], [300, -150], [300, 150], [-300, 150]])
            )
            widths.append((np.ptp(before.heading), np.ptp(states.bounds().heading)))
        if mode == "guaranteed" or t in (20, 32, 40):
            assert states.contains(truth[t])
    assert all(after < 0.7 * before for before, after in widths)


def test_merged_headings_have_the_mean_and_the_hull():
    states = ConstantSpeedInformationSet(
        [[0, 0]], speed=1, k=1, dt=0.01, heading_range=1.0, headings=8, normals=8, mode="published"
    ).advance()
    assert states.heading_nodes == pytest.approx([1.0])
    shifted = np.concatenate([ends((u,), np.array([[0.01]]), heading=1.0) for u in (-1, 0, 1)])
    assert np.allclose(states.sections.values[0], (shifted @ normals(8).T).max(axis=0))


def test_averaged_heading_loses_a_state():
    """Merged to the mean, the true heading is soon not near the one of any section that holds the
    place."""
    options = {"speed": 1.0, "k": 1.0, "dt": 0.2, "heading_range": 0.0, "headings": 12}
    truth = fly((0, 0, 0, 1.0), [(0.2, 1, 0)] * 10, 1.0)[:, :3]
    published = ConstantSpeedInformationSet([[0, 0]], mode="published", **options)
    guaranteed = ConstantSpeedInformationSet([[0, 0]], **options)
    lost = False
    for state in truth[1:]:
        lost |= not published.advance().contains(state)
        assert guaranteed.advance().contains(state)
    assert lost


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: dubins_reachable(0), "t: expected a positive"),
        (lambda: dubins_reachable(1, speed=-1), "speed: expected a positive"),
        (lambda: dubins_reachable(1, k=np.inf), "k: expected a finite"),
        (lambda: dubins_reachable(1, heading=np.nan), "heading: expected a finite"),
        (lambda: dubins_reachable(1, position=[1, 2, 3]), "position: expected shape"),
        (lambda: dubins_reachable(1, position=[[1, 2]]), "position: expected a point"),
        (lambda: dubins_reachable(1).contains([1, 2, 3]), "points: expected shape"),
        (
            lambda: dubins_reachable(1).contains([1, 2], tolerance=0),
            "tolerance: expected a positive",
        ),
        (lambda: known(speed=0), "speed: expected a positive"),
        (lambda: known(k=10, dt=10, speed=10), "more than half a circle; take dt below 3.14"),
        (lambda: known(mode="exact"), "mode"),
        (lambda: known(headings=3), "headings: expected 8"),
        (lambda: known().projection("V"), 'expected "xy" or "psi"'),
        (lambda: known().contains([1, 2, 3, 4]), "state: expected shape"),
        (lambda: known(region=np.zeros((0, 2))), "points: expected shape"),
    ],
)
def test_bad_arguments_are_named(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def known(**change):
    return ConstantSpeedInformationSet(**({"region": [[0, 0]], "speed": 10.0, "k": 1.0} | change))


def test_empty_set_and_representations():
    for mode in ("published", "guaranteed"):
        states = known(mode=mode, headings=36).advance(3)
        with pytest.raises(EmptyInformationSet, match="t = 3"):
            states.measure(Region.disc([100, 0], 5))
        assert f"{mode} information set at t = 3" in repr(states)
        states.measure(Region.disc([30, 0], 5))
        assert 0.5 < np.mean(states.bounds().heading) < 2.5
        assert (len(states.plot().collections[0].get_paths()),) == states.projection().shape


def test_regions_of_every_kind_agree():
    points = [[5, 25], [15, 25], [15, 35], [5, 35]]
    for region in (
        points,
        Region.polygon(points),
        Region.box([10, 30], 10),
        Region.box([10, 30], 10).around(12),
    ):
        states = known(headings=36).advance(3).measure(region)
        assert states.bounds().x[0] >= 5 - 1e-9
