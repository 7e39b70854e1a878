"""Comparison of an answer with the best process at the instants where one of the two changes.

A jump of an answer that is smaller than its change from one sample to the next shows only there,
and so does a change that comes a little early or late.
"""

import numpy as np

from workbook.checks.contract.tolerance import EXACT
from workbook.checks.pontryagin.simulation import BENT, parabola_range
from workbook.checks.references.optima.runge_kutta import rk4

#: Distance from a change at which its two sides are compared, relative to the duration.
BESIDE = 1e-9
#: Accuracy of the instants at which the best control changes, relative to the duration.
LOCATED = 1e-5


def jumps_between_formulas(motion, values, duration):
    """Yield (t, jump, tolerance) at the instants at which a motion or costate changes its formula.

    The jump is that of each entry, the least that the decimals of the answer allow. Its tolerance is
    that of rounding, with decimals that of the parabola through their ends.
    """
    offset = BESIDE * duration
    instants, jumps = _jumps(motion, values, duration)
    variants = [[_jumps(side, values, duration)[1] for side in sides] for sides in motion.variants]
    size = np.abs(motion.values(np.linspace(0, 1 - BESIDE, 9) * duration, values)).max(axis=1)
    if any(len(part) != len(jumps) for sides in variants for part in sides):
        return  # a change moves out of the process: the samples decide
    for k, t in enumerate(instants):
        changes = [[part[k] - jumps[k] for part in sides] for sides in variants]
        ranges = [parabola_range(*sides) for sides in changes]
        low, high = (jumps[k] + sum(ends[j] for ends in ranges) for j in (0, 1))
        rates = sum(np.abs(motion.rates(t + side, values)) for side in (-offset, offset))
        allowed = EXACT * size + 4 * offset * np.nan_to_num(rates)
        if changes:
            allowed = allowed + BENT * np.abs(changes).max(axis=(0, 1))
        yield t, np.where((low <= 0) & (high >= 0), 0, np.fmin(np.abs(low), np.abs(high))), allowed


def _jumps(motion, values, duration):
    offset = BESIDE * duration
    instants = motion.changes(values, duration)
    return instants, [
        motion.values(t + offset, values) - motion.values(t - offset, values) for t in instants
    ]


def processes_between_changes(instants, best):
    """Yield (t, state, control) of the best process between its changes and those of an answer."""
    for j, *controls in best.changes():
        for instant in instants:
            middle = (best.times[j] + instant) / 2
            step = np.clip(middle, *best.times[[j - 1, j + 1]]) - best.times[j]
            t, u = best.times[j] + step, controls[int(step > 0)]
            if u is not None and LOCATED * best.duration < abs(step):
                y = np.append(best.states[:, j], 0)
                yield t, rk4(lambda _, z, u=u: best.field(z, u), 0, y, step)[:-1], u
