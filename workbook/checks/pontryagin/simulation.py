"""Simulation of a process: control bounds, end conditions and cost against the optimum.

A process has to keep to the bounds of the control and to the ends, and to cost what the best
process found costs. The motion under a control in time is followed in small steps.
"""

import numpy as np

from workbook.checks.contract.verdict import Wrong
from workbook.checks.pontryagin.time_functions import INTEGRATED
from workbook.checks.tools import wording

#: Up to which share of its terms the least cost is known, and the cost of a process that is
#: followed in small steps.
COSTS = 1e-6
#: At so many values of each decimal, between those that three digits leave open, the cost is looked
#: at.
ACROSS = 41
#: How well a parabola says what the cost is between three of them, as a part of its changes.
BENT = 0.02
#: When a process is asked for its state, in words.
AT_BEST_END, AT_OWN_END = "when the best process ends", "when your last arc ends"


class Path:
    """The motion under a student's control: lists of times, of states with the cost so far as the
    last entry, and of pairs (time, control)."""

    def __init__(self, best, sections, where):
        self.best, self.where = best, where
        y = np.array(best.start, dtype=float)
        self.times, self.states, self.controls = [0.0], [y], []
        for begin, end, u in sections:
            steps = max(8, int(240 * (end - begin) / best.duration))
            h = (end - begin) / steps
            times = begin + h / 2 * np.arange(2 * steps + 1)
            claimed = u(times).tolist()
            for k in range(1, 2 * steps, 2):
                try:
                    y = _step(best.field, claimed[k - 1 : k + 2], y, h)
                except OverflowError:  # Python's powers raise it, where NumPy's are infinite
                    raise Wrong(
                        f"{where}under your control the numbers become too large to be computed "
                        f"with, at t = {times[k]:.4g}"
                    ) from None
                self.times.append(times[k + 1])
                self.states.append(y)
                self.controls.append((times[k], claimed[k]))

    def require_admissible(self, rounding):
        low, high = self.best.bounds
        slack = max(1e-9, rounding / 10) * (high - low)
        for t, u in self.controls:
            if not low - slack <= u <= high + slack:
                raise Wrong(
                    f"{self.where}your control is {u:.4g} at t = {t:.4g}, outside its bounds"
                )


def require_optimal(
    times,
    states,
    best,
    problem,
    rounding,
    where,
    source,
    perturbed_ends=(),
    paired_ends=(),
    when=AT_BEST_END,
):
    """Raise `Wrong` unless a process keeps to the ends and costs no more than the best one;
    `states` hold the cost so far as the last entry, `whose` says what the process is made by,
    `when` when it ends. `others` are the pairs of ends to which it comes when one of its decimals
    is changed by what it leaves open, `together` those where two are, as `changed_together` lists
    them."""
    if problem.first_return:
        require_single_meeting(times, states, best, where)
    require_end_conditions(
        states[-1], best, rounding, f"{where}under {source}", perturbed_ends, when
    )
    sign = -1 if problem.maximise else 1
    cost = best.total(states[-1])
    excess = sign * (cost - best.cost)
    allowed = max(COSTS, rounding if rounding > INTEGRATED else 0) * best.cost_size()
    cost_changes, paired_changes = (
        [[sign * (best.total(end) - cost) for end in ends] for ends in part]
        for part in (perturbed_ends, paired_ends)
    )
    least = excess + (
        _least_quadratic(cost_changes, paired_changes)
        if paired_changes
        else sum(parabola_range(*sides)[0] for sides in cost_changes)
    )
    if least < -10 * allowed and not perturbed_ends:
        raise RuntimeError(
            f"a process was given that does better than the best one found, by {-excess:.2g}"
        )
    if not least <= allowed + BENT * max(
        (abs(part) for sides in cost_changes for part in sides), default=0
    ):
        # not what it costs: next to the optimum that is hardly more than the least cost
        raise Wrong(
            f"{where}{source} keeps to the ends; there is an admissible process with the same ends "
            "that costs " + ("more, and the cost is to be great" if problem.maximise else "less")
        )


def require_end_conditions(y, best, rounding, prefix, perturbed_ends=(), when=AT_BEST_END):
    """Raise `Wrong` unless a process ends on the target; `others` are pairs of ends that a decimal
    leaves open."""
    if not on_target(y, best, rounding, perturbed_ends):
        # not where it is when the best process ends, as when that is may be asked for
        state = (
            f"{point_text(y[:-1])} {when}, which is not on the target"
            if when == AT_OWN_END
            else f"not on the target {when}"
        )
        raise Wrong(f"{prefix} the state is {state}")


def on_target(y, best, rounding, perturbed_ends=()):
    """Whether a process that ends in y keeps to the ends."""
    gap, allowed = best.gap(y), 2 * rounding * best.size()
    ranges = [parabola_range(*(best.gap(end) - gap for end in sides)) for sides in perturbed_ends]
    least, greatest = (gap + sum((part[k] for part in ranges), np.zeros(len(gap))) for k in (0, 1))
    return bool(np.all((least <= allowed) & (greatest >= -allowed)))


def parabola_range(below, above):
    """The least and the greatest value on [-1, 1] of the parabola through zero that has the given
    values at its ends; of arrays entry by entry."""
    slope, curvature = np.subtract(above, below) / 2, np.asarray(np.add(above, below) / 2)
    with np.errstate(all="ignore"):
        inner = np.where(np.abs(slope) < 2 * np.abs(curvature), -(slope**2) / (4 * curvature), 0.0)
    return np.minimum.reduce([below, above, inner]), np.maximum.reduce([below, above, inner])


def _least_quadratic(sides, paired_values):
    """The least value on [-1, 1]^n of the polynomial of second degree that vanishes at zero and has
    the given values at -1 and 1 on the axes, and where two coordinates are 1."""
    axes = np.meshgrid(*[np.linspace(-1, 1, ACROSS)] * len(sides))
    value = sum(
        (above - below) / 2 * s + (above + below) / 2 * s**2
        for (below, above), s in zip(sides, axes)
    )
    for j, row in enumerate(paired_values):
        for k, corner in enumerate(row, j + 1):
            value = value + (corner - sides[j][1] - sides[k][1]) * axes[j] * axes[k]
    return float(value.min())


def require_single_meeting(times, states, best, where):
    # When the best process ends is known up to `INTEGRATED`.
    early = np.asarray(times[1:-1]) < (1 - INTEGRATED) * times[-1]
    sides = np.array([best.gap(y)[0] for y, is_early in zip(states[1:-1], early) if is_early])
    tolerance = 1e-6 * best.size()
    if sides.min(initial=0) < -tolerance and sides.max(initial=0) > tolerance:
        k = int(np.flatnonzero(np.sign(sides) != np.sign(sides[np.argmax(np.abs(sides[:9]))]))[0])
        raise Wrong(
            f"{where}the target is met at the time {times[k + 1]:.4g} already, and the process "
            "ends there"
        )


def point_text(values):
    """A state for a message; of one coordinate it is a number."""
    text = wording.point_text(values)
    return text[1:-1] if len(values) == 1 else text


def _step(field, controls, y, h):
    """A step of the method of Runge and Kutta under a control given at its begin, middle and
    end."""
    begin, middle, end = controls
    a = field(y, begin)
    b = field(y + h / 2 * a, middle)
    c = field(y + h / 2 * b, middle)
    d = field(y + h * c, end)
    return y + h / 6 * (a + 2 * b + 2 * c + d)
