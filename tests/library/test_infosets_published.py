"""The published algorithm against the numbers of the paper; it does not enclose the motion."""

import numpy as np
import pytest
from flights import PUBLISHED, START, fly, seconds

from trajlib.infosets import EmptyInformationSet, InformationSet, Region, SupportPolygons

DATA = {"k": 6.0, "mu": (-1.0, 3.0), "speeds": (180.0, 360.0)}


@pytest.fixture(scope="module")
def truth():
    return fly(START, PUBLISHED, 6.0)


def squares(truth, seed):
    """Measured squares of 400 m with the truth somewhere inside, every 20 s."""
    random = np.random.default_rng(seed)
    return {
        t: Region.box(truth[t, :2] + random.uniform(-200, 200, 2), 400) for t in range(0, 121, 20)
    }


def run(truth, until, seed=1, visit=None, **options):
    """The set at `until`, after its measurement; `visit` is called each second."""
    measured = squares(truth, seed)
    states = InformationSet(measured[0], **{"mode": "published"} | DATA | options)
    for t in range(1, until + 1):
        states.advance()
        if t in measured:
            states.measure(measured[t])
        if visit:
            visit(t, states)
    return states


def test_true_motion_has_the_published_numbers(truth):
    assert truth[53, 3] == pytest.approx(277.0, abs=1e-9)
    assert truth[53, 2] % (2 * np.pi) == pytest.approx(1.177, abs=0.002)
    # by an integrator of its own
    from scipy.integrate import solve_ivp

    state = np.array(START)
    for k, (_, u, w) in enumerate(PUBLISHED):
        state = solve_ivp(
            lambda t, s: [s[3] * np.sin(s[2]), s[3] * np.cos(s[2]), 6 * u / s[3], w],
            (0, 1),
            state,
            rtol=1e-10,
            atol=1e-9,
        ).y[:, -1]
        assert np.allclose(state, truth[k + 1], atol=1e-5)


@pytest.mark.parametrize("seed", range(8))
def test_the_nodes_nearest_to_the_truth_at_53_s_are_the_published_ones(truth, seed):
    """Of the speed this depends on the random measurements: which nodes are deleted when speeds are
    thinned decides between two lattices. The published node is on one of them, in four of these
    eight runs."""
    states = run(truth, 53, seed)
    speed = states.speed_nodes[np.argmin(np.abs(states.speed_nodes - truth[53, 3]))]
    heading = states.heading_nodes[
        np.argmin(np.abs(states.heading_nodes - truth[53, 2] % (2 * np.pi)))
    ]
    if seed in (3, 4, 5, 6):
        assert f"{speed:.1f}" == "278.2" and speed == pytest.approx(180 + 6 * 180 / 11)
    else:
        assert f"{speed:.1f}" == "270.0" and speed == pytest.approx(180 + 5.5 * 180 / 11)
    assert f"{heading:.3f}" == "1.173" and heading == pytest.approx(112 * 2 * np.pi / 600)


def test_speeds_and_headings_at_20_s_before_the_measurement(truth):
    measured = squares(truth, 1)
    states = InformationSet(measured[0], **DATA, mode="published", max_speeds=40)
    assert len(states.speed_nodes) == 22
    states.advance(20)
    bounds = states.bounds()
    assert len(states.speed_nodes) == 33 and [round(end) for end in bounds.speed] == [163, 437]
    assert bounds.speed == pytest.approx((162.857, 437.143), abs=1e-3)
    assert bounds.heading == (0, 2 * np.pi)
    states.measure(measured[20])
    after = states.bounds()
    assert after.heading[1] - after.heading[0] < 1.2 and after.speed[1] - after.speed[0] < 150


def test_twelve_nodes_at_the_start_for_twenty_at_most():
    states = InformationSet(Region.box([0, 0], 400), **DATA, mode="published")
    assert len(states.speed_nodes) == 12 and np.diff(states.speed_nodes) == pytest.approx(180 / 11)
    assert states.sections.shape == (12, 600) and states.sections.area == pytest.approx(160000)


def union(found, low, high, count=70):
    """Area of the union of all sections, by counting points of a grid."""
    grid = np.stack(np.meshgrid(*np.linspace(low, high, count).T), axis=-1).reshape(-1, 2)
    inside = np.zeros(len(grid), dtype=bool)
    for part in np.array_split(found.projection("xy").values, 60):
        inside |= SupportPolygons.of_tight(part[:, None]).contains(grid).any(axis=0)
    return inside.mean() * np.prod(high - low)


@pytest.mark.slow
def test_more_normals_give_smaller_sets(truth):
    """t = 79 s, m = 4, 8, 16."""
    states = {m: run(truth, 79, seed=5, normals=m) for m in (4, 8, 16)}
    # not one inside the other: fewer nodes of speed are left with more normals, so that others are
    # added
    low, high = np.array([(16000, 23000), (3000, 11500)]).T.astype(float)
    large, middle, small = (union(states[m], low, high) for m in (4, 8, 16))
    assert small < 0.98 * middle and middle < 0.9 * large


def test_nodes_of_speed_are_kept_within_their_limits(truth):
    counts, steps = [], []

    def note(t, states):
        counts.append(len(states.speed_nodes))
        steps.append(np.diff(states.speed_nodes)[0])

    run(truth, 120, visit=note)
    assert min(counts) >= 10 and max(counts) <= 20
    assert {round(step * 11 / 180, 6) for step in steps} == {0.5, 1}
    run(truth, 120, max_speeds=40, visit=note)
    assert min(counts[120:]) >= 20 and max(counts[120:]) <= 40
    # a single row that is left becomes many again, each a copy
    states = InformationSet(
        Region.box([0, 0], 400),
        k=6,
        mu=(-1, 3),
        speeds=(200, 200),
        mode="published",
        heading_range=0.0,
    )
    states.measure(Region.box([0, 0], 100))
    assert len(states.speed_nodes) >= 10 and 200 == pytest.approx(np.median(states.speed_nodes))


def test_step_agrees_with_the_paper():
    """One heading, one speed: the section moves by D V, then to the nodes of nine controls."""
    states = InformationSet(
        [[-1, -1], [1, 1]],
        k=6,
        mu=(-1, 3),
        speeds=(200, 200),
        mode="published",
        heading_range=np.pi / 2,
        headings=600,
        normals=4,
    )
    states.advance()
    nodes_left = states.projection("psi-V")
    nodes = int(6 / (200 * 2 * np.pi / 600)) + 1
    assert (
        nodes_left[:, 0] == pytest.approx((150 + np.array([-nodes, 0, nodes])) * 2 * np.pi / 600)
        and (nodes_left[:, 1] == 200).all()
    )
    for section in states.projection("xy").values:
        assert section == pytest.approx([1, 201, 1, -199], abs=1e-9)
    # D |mu|/dV = 1/3 and 1: q = 2 and 1, by 1 and 2 nodes of 3 m/s
    states.advance()
    assert sorted(set(states.projection("psi-V")[:, 1])) == [200, 206]
    states.advance()
    assert sorted(set(states.projection("psi-V")[:, 1])) == [197, 200, 203, 206, 212]


TURN = {"k": 6.0, "mu": (-1.0, 3.0), "speeds": (285.0, 289.0), "heading_range": 0.0}


def test_published_step_loses_a_true_position():
    """From the right-hand edge, a turn to the right as fast as possible: Euler's step leaves out k
    D^2/2 = 3 m."""
    truth = fly((200, 0, 0, 287), seconds((2, 1, 0)), 6.0)
    published = InformationSet(Region.box([0, 0], 400), **TURN, mode="published")
    guaranteed = InformationSet(Region.box([0, 0], 400), **TURN)
    for t in (1, 2):
        published.advance()
        guaranteed.advance()
        assert not published.projection().contains(truth[t, :2]).any()
        assert published.bounds().x[1] < truth[t, 0] - 2.9
        assert guaranteed.contains(truth[t])
    # a measurement that is right: the published set finds a contradiction
    measured = Region.box(truth[2, :2] + [20, 0], 40)
    with pytest.raises(EmptyInformationSet, match="t = 2") as caught:
        published.measure(measured)
    assert caught.value.time == 2 and not published.sections.empty.all()
    assert guaranteed.measure(measured).contains(truth[2])


def test_published_step_loses_a_state_with_half_the_control():
    """Headings between those of u = -1, 0, 1 have no section after a step."""
    truth = fly((0, 0, 0, 287), seconds((1, 0.5, 0)), 6.0)
    published = InformationSet(Region.box([0, 0], 400), **TURN, mode="published").advance()
    assert not published.contains(truth[1]) and published.contains(
        fly((0, 0, 0, 287), seconds((1, 0, 0)), 6.0)[1]
    )


@pytest.mark.slow
def test_published_mode_loses_the_true_state_and_guaranteed_mode_does_not(truth):
    missed = {"published": [], "guaranteed": []}
    for mode, times in missed.items():
        run(
            truth,
            120,
            seed=5,
            mode=mode,
            visit=lambda t, states: states.contains(truth[t]) or times.append(t),
        )
    assert missed["published"] and missed["guaranteed"] == []


def test_delay_of_the_speed():
    """Greatest acceleration from the greatest speed: moved late, the nodes stay behind it for the
    first seconds."""
    states = InformationSet(Region.box([0, 0], 400), **DATA, mode="published")
    beyond = []
    for t in range(1, 6):
        states.advance()
        beyond.append(360 + 3 * t - states.bounds().speed[1])
    assert max(beyond) >= 12


@pytest.mark.parametrize(
    "change, words",
    [
        ({"max_speeds": 3}, "max_speeds: expected 4 or more"),
        ({"headings": 7}, "headings: expected 8 or more"),
        ({"normals": 2}, "normals: expected 3 or more"),
        ({"mu": (0.0, 3.0)}, "mu1 < 0 < mu2"),
        ({"mu": (1.0, -3.0)}, "low <= high"),
        ({"speeds": (0.0, 10.0)}, "V > 0"),
        ({"speeds": (10.0, np.inf)}, "speeds: expected"),
        ({"k": -1.0}, "k: expected a positive"),
        ({"dt": 0.0}, "dt: expected a positive"),
        ({"mode": "exact"}, 'expected "guaranteed" or "published"'),
        ({"heading_range": (1.0, 0.0)}, "heading_range"),
        ({"heading_range": (0.0, 7.0)}, "heading_range"),
        ({"region": [[0, 0, 1]]}, "points: expected shape"),
        ({"mode": "guaranteed", "max_speeds": 20}, "belongs to the published mode"),
    ],
)
def test_bad_arguments_are_named(change, words):
    with pytest.raises(ValueError, match=words):
        InformationSet(**{"region": Region.box([0, 0], 400), "mode": "published"} | DATA | change)


def test_arguments_that_are_no_numbers_are_named():
    for change in (
        {"mu": "fast"},
        {"heading_range": "north"},
        {"k": "six"},
        {"speeds": [1, [2]]},
        {"headings": 60.5},
    ):
        with pytest.raises(TypeError, match=f"{next(iter(change))}: expected"):
            InformationSet(**{"region": Region.box([0, 0], 400)} | DATA | change)


@pytest.mark.parametrize("mode", ["published", "guaranteed"])
def test_bad_steps_are_named(mode):
    states = InformationSet(
        Region.box([0, 0], 4), k=0.5, mu=(-10, 3), speeds=(21, 40), mode=mode, headings=60
    )
    with pytest.raises(ValueError, match="V > 0; measure"):
        states.advance(30)
    assert states.time >= 1
    with pytest.raises(ValueError, match="more than half a circle; take dt below"):
        InformationSet(
            Region.box([0, 0], 4), k=60, mu=(-1, 3), speeds=(10, 40), mode=mode, headings=60
        ).advance()
    with pytest.raises(TypeError, match="steps: expected a whole number"):
        states.advance(0.5)
    with pytest.raises(ValueError, match="steps: expected 0 or more"):
        states.advance(-1)
    with pytest.raises(ValueError, match="region 1: expected one polygon with 12 normals"):
        states.measure(Region.box([0, 0], 4), states.sections)
    with pytest.raises(ValueError, match="regions: expected one or more"):
        states.measure()
    with pytest.raises(ValueError, match="state: expected shape"):
        states.contains([0, 0, 0])
    with pytest.raises(ValueError, match="state: expected one of 4"):
        states.contains([[0, 0, 0, 10]])
    with pytest.raises(ValueError, match='expected "xy" or "psi-V"'):
        states.projection("V")
    with pytest.raises(ValueError, match="it is empty"):
        states.measure(states.sections[0, 0].intersect(states.sections[0, 0].shift([1e6, 0])))
