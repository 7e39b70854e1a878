"""The guaranteed set with steps of any length, bounds on the speed, measured headings and speeds."""

import numpy as np
import pytest
from flights import PUBLISHED, START, fly

from trajlib.infosets import (
    ConstantSpeedInformationSet,
    EmptyInformationSet,
    InformationSet,
    Region,
    SupportPolygons,
)
from trajlib.infosets.cells import Cells

K, MU, FULL = 6.0, (-1.0, 3.0), 2 * np.pi
KINDS = ["random", "extreme", "one turn", "late", "turned over"]


def controls(kind, random, count):
    """Controls u, w of `count` pieces that use their freedom in different ways."""
    side, switch = random.choice([-1, 1]), random.integers(1, count + 1)
    u = {
        "random": random.uniform(-1, 1, count),
        "extreme": random.choice([-1, 0, 1], count),
        "one turn": np.full(count, side),
        "late": np.where(np.arange(count) < switch, 0, side),
        "turned over": np.where(np.arange(count) < switch, side, -side),
    }[kind]
    if kind in ("random", "extreme"):
        return u, random.uniform(*MU, count) if kind == "random" else random.choice(MU, count)
    return u, np.full(count, random.choice(MU))


def motion(start, kind, random, durations, limits):
    """States at the end of each duration, four controls in each; at its limits the speed stays."""
    states = [np.array(start, dtype=float)]
    for duration, u, w in zip(durations, *(part.reshape(-1, 4) for part in kind)):
        state = states[-1]
        for a, b in zip(u, w):
            part = duration / 4
            limit = limits[1] if b > 0 else limits[0]
            within = min(part, (limit - state[3]) / b)
            state = fly(state, [(within, a, b)], K)[-1]
            state = fly(state, [(part - within, a, 0)], K)[-1] if within < part else state
        states.append(state)
    return np.array(states)


def require(states, truth, random, where):
    """The state is in the set, its coordinates within the bounds, its position where it leads."""
    assert states.contains(truth), where
    bounds = states.bounds()
    for value, (low, high) in zip(truth[[0, 1, 3]], (bounds.x, bounds.y, bounds.speed)):
        assert low - 1e-6 <= value <= high + 1e-6, where
    low, high = bounds.heading
    assert (truth[2] - low + 1e-7) % FULL <= high - low + 2e-7, where
    # what the proof keeps: all cells that are as near as the leads have the position
    grid = states._grid
    speed = truth[3] + grid._speed_lead * grid.speed_step * random.choice([-1, 0, 1])
    row = int(np.argmin(np.abs(grid.speeds - speed)))
    lead = grid._heading_lead[row] * grid.heading_step
    for heading in truth[2] + lead * np.array([-1, 0.5, 1]) * (1 - 1e-9):
        apart = np.abs((grid.headings - heading + np.pi) % FULL - np.pi)
        cells = grid.values[row, apart <= grid.heading_step / 2 * (1 + 1e-6)]
        assert SupportPolygons.of_tight(cells).contains(truth[:2]).any(), where


def follow(seed):
    """A motion with steps and measurements at irregular times, the truth at the edge of each."""
    random = np.random.default_rng(seed)
    kind, dt = KINDS[seed % 5], float(random.choice([0.05, 0.3, 1.0, 2.0]))
    steps, side = int(random.integers(8, 20)), float(random.choice([5, 100, 400]))
    low, width = random.uniform(60, 250), random.uniform(0, 30)
    limits = (0.0, np.inf)
    if seed % 2:
        limits = low - random.uniform(0, 5), low + width + random.uniform(0, 8)
    arc = random.uniform(0, FULL), random.choice([0, 0.3, 6.2])
    ends = random.choice([0, 1], 2)
    start = (*random.uniform(-1e4, 1e4, 2), arc[0] + ends[0] * arc[1], low + ends[1] * width)
    durations = [random.choice([1.0, random.uniform(0.02, 3)]) * dt for _ in range(steps)]
    truth = motion(start, controls(kind, random, 4 * steps), random, durations, limits)

    def around(state):
        return Region.box(state[:2] + side / 2 * random.choice([-1, 1], 2), side)

    def edge(value, width):
        return (
            (value - width, value + 1e-9)
            if random.choice([0, 1])
            else (value - 1e-9, value + width)
        )

    states = InformationSet(
        around(truth[0]),
        k=K,
        mu=MU,
        speeds=(low, low + width),
        dt=dt,
        headings=int(random.choice([60, 97, 200, 600])),
        heading_range=(arc[0], arc[0] + arc[1]),
        normals=int(random.choice([4, 7, 12])),
        speed_step=float(random.choice([0.7, 2, 5])) if dt < 0.3 or seed % 3 else None,
        speed_limits=limits if seed % 2 else None,
    )
    for step, (at, state) in enumerate(zip(np.cumsum(durations), truth[1:])):
        states.advance(to=at)
        require(states, state, random, (seed, step))
        measured = random.choice(7)
        if measured < 3:
            states.measure(
                *[around(state)] * (measured != 1),
                heading=edge(state[2], random.uniform(0, 0.2)) if measured != 2 else None,
                speed=edge(state[3], random.uniform(0, 5)) if measured else None,
            )
            require(states, state, random, (seed, step, "measured"))


@pytest.mark.parametrize("seed", range(10))
def test_true_state_is_kept(seed):
    follow(seed)


@pytest.mark.slow
@pytest.mark.parametrize("first", range(100, 200, 20))
def test_true_state_is_kept_in_many_motions(first):
    for seed in range(first, first + 20):
        follow(seed)


def test_every_step_keeps_the_inequalities_of_the_proof(monkeypatch):
    """(9.6) and (9.6a) for all pairs of rows: what a section is given to, with the leads."""
    checked = []

    def watched(grid, values, reach):
        checked.append(reach)
        return hulls(grid, values, reach)

    hulls = Cells._hulls
    monkeypatch.setattr(Cells, "_hulls", watched)
    random, grid = np.random.default_rng(0), None
    for step in random.choice([0.05, 0.3, 1.0, 2.7], 60):
        if not grid or len(grid.values) > 120:
            grid = Cells(np.zeros(4), K, MU, (90, 150), 2.0, 600, (0.0, 0.3))
        lead, speed_lead = grid._heading_lead, grid._speed_lead
        slowest = grid.speeds - 1 - 2 * speed_lead + MU[0] * step
        turn = K * step / np.maximum(slowest, grid.speed_bounds()[0] + MU[0] * step)
        before = grid._row
        grid.advance(step, grid._elapsed + step)
        q, reach = before - grid._row, checked[-1]
        wider = step * (MU[1] - MU[0]) / 2
        assert 2 * speed_lead + 2 * q >= wider + 2 * grid._speed_lead - 1e-9 and reach.shape == (
            len(turn),
            2 * q + 1,
        )
        for shift in range(2 * q + 1):
            new_lead = grid._heading_lead[shift : shift + len(turn)]
            spread = (lead + reach[:, shift]) * grid.heading_step
            assert (spread >= turn + new_lead * grid.heading_step - 1e-7).all()


@pytest.mark.parametrize("dt, headings", [(1.0, 600), (0.05, 600), (0.7, 97), (1.0, 2000)])
@pytest.mark.parametrize("wrapped", [True, False])
def test_heading_spreads_by_what_is_possible(dt, headings, wrapped):
    """For a known speed the arc grows by exactly k t/V to either side of the cell at the start."""
    states = ConstantSpeedInformationSet(
        Region.box([0, 0], 400),
        speed=200.0,
        k=K,
        dt=dt,
        headings=headings,
        heading_range=1.0,
        wrapped=wrapped,
    )
    for at in (0.3, 5.0, 20.0, 41.3):
        low, high = states.advance(to=at).bounds().heading
        assert high - low == pytest.approx(FULL / headings + 2 * K * at / 200, abs=1e-9)
        assert (low - 1 + K * at / 200 + 1) % FULL == pytest.approx(1, abs=1e-9)
        truth = fly((0, 0, 1, 200), [(at / 50, 1, 0)] * 50, K)[-1]
        assert states.contains(truth[:3])


def test_heading_of_an_unknown_speed_after_20_s():
    """The greatest turn is that of the slowest vehicle that brakes; one cell a step was 0.17 rad."""
    states = InformationSet(
        Region.box([0, 0], 400), k=K, mu=MU, speeds=(180, 200), heading_range=0.0
    ).advance(20)
    low, high = states.bounds().heading
    possible = 2 * K * np.log(180 / 160) + FULL / 600
    assert possible <= high - low <= possible + 0.005


def test_short_steps_with_wide_cells_of_speed():
    """The width of a cell no longer shrinks with the step: 90 rows and not 1800."""
    states = InformationSet(
        Region.box([0, 0], 400), k=K, mu=MU, speeds=(180, 360), dt=0.05, speed_step=2.0
    )
    states.advance(to=1.0)
    assert len(states.speed_nodes) <= 94 and states.bounds().speed == pytest.approx((179, 363))
    once = InformationSet(Region.box([0, 0], 400), k=K, mu=MU, speeds=(180, 360)).advance()
    for fine, coarse in zip(states.bounds().x, once.bounds().x):
        assert fine == pytest.approx(coarse, abs=5)


def test_a_time_is_reached_in_equal_steps():
    states = InformationSet(Region.box([0, 0], 400), k=K, mu=MU, speeds=(180, 190), headings=60)
    assert states.advance(to=2.5).time == 2.5 and states.advance().time == 3.5
    assert states.bounds().speed == pytest.approx((176.5, 200.5))
    assert states.advance(to=3.5).time == 3.5 and states.advance(0).time == 3.5
    with pytest.raises(ValueError, match="to: the time 3 is past, the set is at 3.5"):
        states.advance(to=3)
    with pytest.raises(ValueError, match="either the number of steps or the time"):
        states.advance(2, to=9)
    with pytest.raises(TypeError, match="to: expected a number"):
        states.advance(to=np.datetime64("2026-11-27", "ns"))
    published = InformationSet(
        Region.box([0, 0], 400), k=K, mu=MU, speeds=(180, 190), mode="published"
    )
    assert published.advance(to=3).time == 3
    with pytest.raises(ValueError, match="no whole number of steps dt = 1 from 3"):
        published.advance(to=3.5)


def test_lasting_bounds_on_the_speed():
    """Without them the prediction ends when the least speed comes to zero."""
    options = {"k": K, "mu": MU, "speeds": (60, 100), "headings": 60, "heading_range": 0.0}
    states = InformationSet(Region.box([0, 0], 10), **options, speed_limits=(50, 110))
    assert states.advance(100).bounds().speed == (50, 110) and len(states.speed_nodes) <= 32
    assert states.bounds().y[1] <= 100 * 110 + 10
    with pytest.raises(ValueError, match="V > 0; measure earlier, .* or give speed_limits"):
        InformationSet(Region.box([0, 0], 10), **options | {"k": 0.5}).advance(100)
    with pytest.raises(ValueError, match="speed_limits: expected positive speeds with some"):
        InformationSet(Region.box([0, 0], 10), **options, speed_limits=(110, 120))


@pytest.mark.parametrize("mode", ["guaranteed", "published"])
def test_measured_heading_and_speed_cut_the_set_down(mode):
    states = InformationSet(
        Region.box([0, 0], 400), k=K, mu=MU, speeds=(180, 360), mode=mode
    ).advance(5)
    states.measure(heading=(6.2, 6.4), speed=(250, 260))
    bounds = states.bounds()
    width = 2 * FULL / 600
    assert 6.2 - width <= bounds.heading[0] and bounds.heading[1] <= 6.4 + width
    # as published two nodes are added, and then nodes between all
    beyond = 2 if mode == "guaranteed" else 1.5 * 180 / 11
    assert 250 - beyond <= bounds.speed[0] and bounds.speed[1] <= 260 + beyond
    before = states.sections.values.copy()
    with pytest.raises(EmptyInformationSet, match="t = 5"):
        states.measure(heading=3.0)
    with pytest.raises(EmptyInformationSet):
        states.measure(speed=(500, 600))
    assert np.array_equal(before, states.sections.values)
    with pytest.raises(ValueError, match="heading: expected a heading or"):
        states.measure(heading=(2, 1))
    with pytest.raises(ValueError, match="speed: expected"):
        states.measure(speed=(2, 1))


@pytest.mark.parametrize("mode", ["guaranteed", "published"])
def test_measured_heading_for_a_known_speed(mode):
    states = ConstantSpeedInformationSet(Region.box([0, 0], 400), speed=200, k=5, mode=mode)
    low, high = states.advance(3).measure(heading=(1, 1.5), speed=(190, 210)).bounds().heading
    assert 0.95 <= low <= 1 and 1.5 <= high <= 1.55
    with pytest.raises(EmptyInformationSet):
        states.measure(speed=(210, 220))


def test_published_steps_are_counted_from_the_start_or_from_each_measurement():
    """The paper divides each interval between measurements anew: q = 5 then begins anew as well."""
    truth = fly(START, PUBLISHED, K)
    shifted = {}
    for counted_from in ("start", "measurement"):
        states = InformationSet(
            Region.box(truth[0, :2], 400),
            k=K,
            mu=MU,
            speeds=(180, 360),
            mode="published",
            counted_from=counted_from,
            max_speeds=40,
        )
        rows = []
        for t in range(1, 15):
            rows.append(states.advance().bounds().speed[1])
            if t == 3:
                states.measure(Region.box(truth[t, :2], 1e5))
        shifted[counted_from] = [t for t in range(1, 14) if rows[t] > rows[t - 1]]
    # dV = 180/21: q = 2 for mu2 = 3, and the first shift is that of the step number 2
    assert shifted["start"] == [2, 4, 6, 8, 10, 12]
    assert shifted["measurement"] == [2, 5, 7, 9, 11, 13]
    with pytest.raises(ValueError, match='counted_from: expected "start" or "measurement"'):
        InformationSet(
            Region.box([0, 0], 1), k=K, mu=MU, speeds=(1, 2), mode="published", counted_from="q"
        )


@pytest.mark.parametrize(
    "mode, option, owner",
    [
        ("published", {"speed_step": 1.0}, "guaranteed"),
        ("published", {"speed_limits": (1, 500)}, "guaranteed"),
        ("guaranteed", {"counted_from": "start"}, "published"),
    ],
)
def test_options_of_the_other_mode_are_refused(mode, option, owner):
    with pytest.raises(ValueError, match=f"{next(iter(option))}: it belongs to the {owner} mode"):
        InformationSet(Region.box([0, 0], 1), k=K, mu=MU, speeds=(180, 360), mode=mode, **option)
