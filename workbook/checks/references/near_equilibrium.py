"""Stability of an equilibrium from nearby motions, where the linearisation is inconclusive."""

import functools

import numpy as np

#: The distance from zero at which motions start, and how long they are followed.
RADIUS, DURATION = 0.05, 200.0


@functools.lru_cache(maxsize=16)
def stability_from_motions(flow):
    """Return the stability of zero, and the reason, from motions that begin on a small sphere.

    Notes
    -----
    It is meant for fields whose linearisation is critical. Decisive is whether the motions still shrink
    or grow after the fast parts have died out: the largest distance in a late interval of time against
    that in an earlier one. Distance is measured in the coordinates of the eigenvectors, in which the
    linear terms change the amplitude of no critical part.
    """
    _, vectors = np.linalg.eig(flow.jacobian([0.0] * len(flow.state)))
    measure = np.linalg.inv(vectors) if np.linalg.cond(vectors) < 1e6 else np.eye(len(flow.state))
    random = np.random.default_rng(2)
    trends = []
    for _ in range(2):
        start = random.normal(size=len(flow.state))
        # a motion may come to zero from one side and leave it on the other
        for side in (RADIUS, -RADIUS):
            trends.append(_amplitude_ratio(flow, measure, side * start / np.linalg.norm(start)))
    low, high = min(trends) - 1, max(trends) - 1
    if high == np.inf:
        return (
            "unstable",
            f"a motion that starts at distance {RADIUS} from zero leaves the ball of radius 1",
        )
    steady = max(-low, high) < 1e-5
    change = "less than 0.001" if steady else f"{100 * low:.2g} to {100 * high:.2g}"
    reason = (
        f"in motions that start at distance {RADIUS} the amplitude changes by {change} per cent "
        f"from half the time {DURATION:g} to the whole"
    )
    if low > 1e-4:
        return "unstable", reason
    if high < -1e-4:
        return "asymptotically stable", reason
    if steady:
        return "stable", reason
    raise RuntimeError(f"motions near zero do not decide: {reason}")


def _amplitude_ratio(flow, measure, start):
    """Return the ratio of the final amplitude of a motion to that midway; inf if it escapes."""
    times = np.concatenate([np.linspace(end - 0.1, end, 600) for end in (0.5, 1.0)]) * DURATION
    path = flow.path(start, DURATION, 1.0, times)
    if path.t_events[0].size:
        return np.inf
    amplitudes = np.linalg.norm(measure @ path.y, axis=0)
    midway, final = amplitudes[:600].max(), amplitudes[600:].max()
    return final / midway if midway > 1e-8 else 0.0
