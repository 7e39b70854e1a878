"""The guaranteed mode keeps the true state: bounds on displacements, single steps, long motions."""

import numpy as np
import pytest
from flights import PUBLISHED, START, fly
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.infosets import (
    ConstantSpeedInformationSet,
    EmptyInformationSet,
    InformationSet,
    Region,
    SupportPolygons,
)
from trajlib.infosets.cells import Cells
from trajlib.infosets.polygons import normals

K, MU = 6.0, (-1.0, 3.0)


def controls(kind, random, dt, steps):
    """Pieces (duration, u, w) of motions that use their freedom in different ways, four a step."""
    count = 4 * steps
    if kind == "random":
        u, w = random.uniform(-1, 1, count), random.uniform(*MU, count)
    elif kind == "extreme":
        u, w = random.choice([-1, 0, 1], count), random.choice(MU, count)
    elif kind == "half":
        u, w = random.choice([-0.5, 0.5], count), random.choice([-0.5, 1.5], count)
    elif kind == "one turn":
        u, w = np.full(count, random.choice([-1, 1])), np.full(count, random.choice(MU))
    # straight on, then a turn: late switches
    else:
        u, w = np.where(np.arange(count) < random.integers(count), 0, 1), np.full(count, MU[1])
    return [(dt / 4, float(a), float(b)) for a, b in zip(u, w)]


KINDS = ["random", "extreme", "half", "one turn", "late"]


def follow(
    kind, seed, steps=24, dt=1.0, every=6, headings=120, side=400.0, normals=12, shape="square"
):
    """A motion from a corner of everything that is known at the start, with measurements that
    have the truth at their edge; every state is asserted to be in the set. Returns the number of
    steps."""
    random = np.random.default_rng(seed)
    width, low = random.uniform(0, 30), random.uniform(60, 250)
    arc = random.uniform(0, 2 * np.pi, 2) * [1, 0.3]
    # at the ends of the intervals
    ends = random.choice([0, 1], 2)
    start = (*random.uniform(-1e5, 1e5, 2), arc[0] + ends[0] * arc[1], low + ends[1] * width)
    motion = fly(start, controls(kind, random, dt, steps), K)[::4]
    states = InformationSet(
        around(start[:2], side, random, shape),
        k=K,
        mu=MU,
        speeds=(low, low + width),
        dt=dt,
        headings=headings,
        heading_range=(arc[0], arc[0] + arc[1]),
        normals=normals,
    )
    assert states.contains(start)
    for step in range(1, steps + 1):
        states.advance()
        assert states.contains(motion[step]), (kind, seed, step)
        if step % every == 0:
            states.measure(around(motion[step, :2], side, random, shape))
            assert states.contains(motion[step]), (kind, seed, step, "measured")
    bounds = states.bounds()
    assert all(
        low - 1e-6 <= value <= high + 1e-6
        for value, (low, high) in zip(motion[-1, [0, 1, 3]], (bounds.x, bounds.y, bounds.speed))
    )
    assert (motion[-1, 2] - bounds.heading[0]) % (2 * np.pi) <= bounds.heading[1] - bounds.heading[
        0
    ] + 1e-6
    return steps


def around(point, side, random, shape):
    """A measured set with the point at a corner, on an edge, or on a circle."""
    if shape == "disc":
        angle = random.uniform(0, 2 * np.pi)
        return Region.disc(point + side / 2 * np.array([np.sin(angle), np.cos(angle)]), side / 2)
    if shape == "triangle":
        return Region.polygon(point + side * np.array([[0, 0], *random.uniform(-1, 1, (2, 2))]))
    return Region.box(point + side / 2 * random.choice([-1, 1], 2), side)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_true_state_is_kept(kind):
    steps = sum(
        follow(
            kind,
            seed,
            headings=(120, 60, 90, 200)[seed % 4],
            dt=(1.0, 0.5, 2.0)[seed % 3],
            normals=(4, 8, 12, 7)[seed % 4],
            shape=("square", "disc", "triangle")[seed % 3],
        )
        for seed in range(12)
    )
    assert steps == 288


@pytest.mark.parametrize("kind", KINDS)
def test_true_state_is_kept_in_selected_motions(kind):
    assert (
        follow(kind, 101, steps=12) + follow(kind, 102, steps=12, headings=60, shape="disc") == 24
    )


@pytest.mark.slow
def test_true_state_is_kept_between_small_measured_sets():
    """Squares of 5 m, so that a bound that forgets a metre would show."""
    for seed in range(8):
        follow(KINDS[seed % 5], 200 + seed, steps=30, every=2, side=5.0, headings=600)


@given(seed=st.integers(0, 10**6), kind=st.sampled_from(KINDS), dt=st.sampled_from([0.2, 1.0, 3.0]))
@settings(max_examples=60, deadline=None)
def test_the_bound_on_the_displacement_of_a_cell(seed, kind, dt):
    """From anywhere in a cell, by any controls: the displacement on all normals, the new heading
    and speed."""
    random = np.random.default_rng(seed)
    m, headings = int(random.choice([4, 7, 12])), int(random.choice([30, 100, 601]))
    low, arc = random.uniform(20, 300), (random.uniform(0, 6), 0.0)
    grid = Cells(np.zeros(m), K, MU, (low, low), 2 * dt, headings, arc)
    psi, speed = grid.headings[0], grid.speeds[0]
    grid.advance(dt, dt)
    for _ in range(10):
        start = (
            0,
            0,
            psi + grid.heading_step / 2 * random.choice([-1, -0.3, 1]),
            speed + grid.speed_step / 2 * random.choice([-1, 0.5, 1]),
        )
        end = fly(start, controls(kind, random, dt, 1), K)[-1]
        sections = grid.sections_at(*end[2:])
        assert SupportPolygons.of_tight(sections).contains(end[:2]).any()
        assert (normals(m) @ end[:2] <= grid.values.reshape(-1, m).max(axis=0)).all()


def test_the_bound_on_the_displacement_is_nearly_attained():
    """Along each normal some motion comes within the parts that the bound gives away: half of mu2
    D^2 over the parts of a step, and the width of a cell that a motion cannot use to the end."""
    grid = Cells(np.zeros(12), K, MU, (200.0, 200.0), 2.0, 600, (0.0, 0.0))
    psi, speed, half = grid.headings[0], grid.speeds[0], grid.heading_step / 2
    grid.advance(1.0, 1.0)
    for n, value in zip(normals(12), grid.values.reshape(-1, 12).max(axis=0)):
        best = max(
            n @ fly((0, 0, psi + a * half, speed + b), [(0.125, u, w)] * 8, K)[-1, :2]
            for a in (-1, 0, 1)
            for b in (-grid.speed_step / 2, grid.speed_step / 2)
            for u in (-1, 0, 1)
            for w in MU
        )
        assert best - 1e-9 <= value <= best + 0.6


def test_speed_interval_without_measurements():
    """Without measurements the interval is [low + mu1 t, high + mu2 t], up to the grid of 2 m/s."""
    states = InformationSet(Region.box([0, 0], 400), k=6, mu=MU, speeds=(180, 360))
    assert states.bounds().speed == (180, 360) and len(states.speed_nodes) == 90
    assert states.advance(20).bounds().speed == (160, 420)
    states = InformationSet(Region.box([0, 0], 400), k=6, mu=MU, speeds=(200, 201), headings=60)
    assert states.advance(5).bounds().speed == (195, 217)  # a cell is 2 wide


def test_areas_and_bounds_are_near_the_published_ones():
    """On the published motion: how much the guarantee costs."""
    truth = fly(START, PUBLISHED, 6.0)
    random, extents = np.random.default_rng(5), {"published": [], "guaranteed": []}
    measurements = {
        t: Region.box(truth[t, :2] + random.uniform(-200, 200, 2), 400) for t in range(0, 61, 20)
    }
    for mode, rows in extents.items():
        states = InformationSet(measurements[0], k=6, mu=MU, speeds=(180, 360), mode=mode)
        for t in range(1, 54):
            states.advance()
            if t in measurements:
                states.measure(measurements[t])
            if t in (19, 33, 53):
                bounds = states.bounds()
                rows.append([high - low for low, high in (bounds.x, bounds.y)])
    ratio = np.array(extents["guaranteed"]) / np.array(extents["published"])
    assert 0.85 < ratio.min() and ratio.max() < 1.05


def test_a_heading_circle_is_closed_and_opened():
    """A known heading spreads to all, comes together at a measurement, and the states stay in the
    set across north."""
    states = InformationSet(
        Region.box([0, 0], 10), k=30, mu=MU, speeds=(100, 102), headings=36, heading_range=6.2
    )
    truth = fly((0, 0, 6.2, 100), [(1.0, 1, 0)] * 14, 30.0)
    arcs = []
    for t in range(1, 15):
        states.advance()
        assert states.contains(truth[t]) and states.contains(truth[t] + [0, 0, 2 * np.pi, 0])
        arcs.append(np.ptp(states.bounds().heading))
    assert arcs == sorted(arcs) and arcs[-1] == 2 * np.pi and states.sections.shape[1] == 36
    states.measure(Region.disc(truth[14, :2], 20))
    assert (
        states.contains(truth[14])
        and np.ptp(states.bounds().heading) < 2 * np.pi
        and states.sections.shape[1] < 36
    )


@pytest.mark.parametrize("heading, u", [(5.3, 1), (1.0, -1)])
def test_a_turn_across_the_seam_of_a_full_circle(heading, u):
    """All headings are possible from the start, so that the circle is closed, and the truth passes
    north."""
    truth = fly((0, 0, heading, 100), [(1.0, u, 0)] * 8, 30.0)
    states = InformationSet(Region.disc([0, 0], 5), k=30, mu=MU, speeds=(99, 101), headings=90)
    assert all(states.advance().contains(state) for state in truth[1:])
    known = ConstantSpeedInformationSet(Region.disc([0, 0], 5), k=30, speed=100, headings=90)
    assert all(known.advance().contains(state[:3]) for state in truth[1:])


@pytest.mark.parametrize("u", [1, -1])
def test_half_turns_to_both_sides_end_in_one_cell(u):
    """One cell of heading more on each side in a step: after 18 steps the ends of the arc meet, and
    both are kept."""
    k = 100 * 2 * np.pi / 36
    truth = fly((0, 0, 0.01, 100), [(1.0, u, 0)] * 19, k)
    states = ConstantSpeedInformationSet(
        Region.disc([0, 0], 5), k=k, speed=100, headings=36, heading_range=0.0
    )
    assert all(states.advance().contains(state[:3]) for state in truth[1:])
    assert states.sections.shape == (1, 36)


def test_several_measurements_at_once_are_intersected_first():
    boxes = Region.box([1000, 0], 400, 4000), Region.box([0, 1000], 4000, 400)
    options = {"k": 6, "mu": MU, "speeds": (100, 140), "headings": 60}
    once = InformationSet(Region.box([0, 0], 400), **options).advance(10).measure(*boxes)
    one_by_one = (
        InformationSet(Region.box([0, 0], 400), **options)
        .advance(10)
        .measure(boxes[0])
        .measure(boxes[1])
    )
    assert np.allclose(once.sections.values, one_by_one.sections.values, atol=1e-6)
    assert once.bounds().x == pytest.approx((800, 1200)) and once.bounds().y == pytest.approx(
        (800, 1200)
    )


def test_inconsistent_measurement_has_its_time_and_leaves_the_set_unchanged():
    states = InformationSet(
        Region.box([0, 0], 400), k=6, mu=MU, speeds=(100, 140), headings=60, dt=0.5
    ).advance(3)
    before = states.sections.values.copy()
    for region in (Region.box([5000, 0], 100), [[1e6, 0], [1e6, 1]]):
        with pytest.raises(EmptyInformationSet, match="t = 1.5") as caught:
            states.measure(region)
        assert caught.value.time == 1.5 and np.array_equal(before, states.sections.values)
    with pytest.raises(EmptyInformationSet):
        states.measure(Region.box([100, 0], 50), Region.box([-100, 0], 50))
    assert isinstance(caught.value, ValueError)


def test_representation():
    states = InformationSet(Region.box([0, 0], 400), k=6, mu=MU, speeds=(100, 140), headings=60)
    assert repr(states).startswith(
        "guaranteed information set at t = 0: 1200 sections, x in [-200, 200]"
    )
    assert "V in [100, 140]" in str(states.bounds())
    nodes = states.projection("psi-V")
    assert nodes.shape == (1200, 2) and (nodes[:, 0] < 2 * np.pi).all()
    ax = states.plot(label="all")
    assert ax.collections[0].get_rasterized() and len(ax.collections[0].get_paths()) == 1200
    assert states.measure(states.sections[0, 0]).sections.shape == (20, 60)
