"""Bang-bang trajectories to the target: the lengths of their arcs, found without costates.

Along arcs at the bounds the state depends on the lengths alone. Where switchings nearly coincide, the
target determines the lengths only in higher order: to three switchings at c - h, c and c + h it answers by
terms in h^2 and h^3. Newton's method for the whole boundary value problem starts from states that do not
fit together, with errors far above these terms. Here all states follow from the initial one.
"""

from copy import copy

import numpy as np

#: Steps of Newton's method, each of which at most halves h, and of the integrator on an arc.
ITERATIONS, STEPS = 60, 64


def reach_target(numeric, shot, duration):
    """Return the solution with lengths for which its bang-bang control ends on the target, or None.

    None also where not all arcs are at bounds, an initial value is free, or there are fewer arcs than
    equations.
    """
    equations = numeric.m + (duration is not None)
    if (
        any(kind not in ("u-", "u+") for flow in shot.flows for kind in flow.kinds)
        or len(shot.jumps)
        or np.isnan(numeric.start).any()
        or len(shot.flows) < equations
        or any(flow.continues(left) for left, flow in zip(shot.flows, shot.flows[1:]))
    ):
        return None
    lengths, last = shot.lengths.copy(), np.inf
    for _ in range(ITERATIONS):
        starts, end, by_lengths = _motion(numeric, shot, lengths)
        value, slope = (part.full() for part in numeric.target_value(end))
        remainder, jacobian = value.ravel(), slope @ by_lengths
        if duration is not None:
            remainder = np.append(remainder, lengths.sum() - duration)
            jacobian = np.vstack([jacobian, np.ones(len(lengths))])
        if not np.isfinite(jacobian).all():
            return None
        size = np.linalg.norm(remainder)
        if size < 1e-13 * (1 + np.linalg.norm(end)) and size > last / 2:
            break
        step, last = np.linalg.lstsq(jacobian, -remainder, rcond=1e-15)[0], size
        shrinking = step < 0
        lengths += step * min(
            1.0, 0.9 * np.min(-lengths[shrinking] / step[shrinking], initial=np.inf)
        )
    else:
        return None
    reached = copy(shot)
    reached.lengths, reached.starts = lengths, starts
    reached.steps = [STEPS] * len(lengths)
    return reached


def _motion(numeric, shot, lengths):
    """Return the beginnings of the arcs, the final state, and its derivatives by the lengths."""
    n = numeric.n
    state, by_lengths, starts = numeric.start, np.zeros((n, len(lengths))), []
    for i, (flow, length, start) in enumerate(zip(shot.flows, lengths, shot.starts)):
        starts.append(np.concatenate([state, start[n:]]))
        end, by_start, _, by_length = flow.transition(starts[-1], shot.multiplier, length, STEPS)
        by_lengths = by_start[:n, :n] @ by_lengths
        by_lengths[:, i] += by_length[:n]
        state = end[:n]
    return starts, state, by_lengths
