"""Simulation of a process: control bounds, end conditions and cost against the optimum.

A process has to keep to the bounds of the control and to the ends, and to cost what the best
process found costs. The motion under a control in time is integrated in small steps.
"""

import numpy as np

from workbook.checks.contract.verdict import Wrong
from workbook.checks.pontryagin.time_functions import INTEGRATED, values_of
from workbook.checks.references.optima.runge_kutta import steered
from workbook.checks.tools import wording

#: Relative accuracy of the least cost, and of the cost of a process that is integrated in small
#: steps.
COSTS = 1e-6
#: Number of values of each decimal, within its uncertainty, at which the cost is compared.
ACROSS = 41
#: Relative accuracy of the parabola that interpolates the change of the cost between three values.
BENT = 0.02
#: The time at which the state of a process is compared, in words.
AT_BEST_END, AT_OWN_END = "when the best process ends", "when your last arc ends"


class Path:
    """The motion under a claimed control: lists of times, states and pairs (time, control).

    The last entry of a state is the cost so far.
    """

    def __init__(self, best, sections, where):
        self.best, self.where, self._sections = best, where, sections
        y = np.array(best.start, dtype=float)
        self.times, self.states, self.controls = [0.0], [y], []
        for begin, end, u in sections:
            steps = max(8, int(240 * (end - begin) / best.duration))
            h = (end - begin) / steps
            times = begin + h / 2 * np.arange(2 * steps + 1)
            claimed = u(times).tolist()
            for k in range(1, 2 * steps, 2):
                try:
                    y = steered(best.field, claimed[k - 1 : k + 2], y, h)
                except OverflowError:  # Python's powers raise it, where NumPy's are infinite
                    raise Wrong(
                        f"{where}under your control the states become too large to be computed with "
                        + wording.process_part_text(times[k], sections[-1][1])
                    ) from None
                self.times.append(times[k + 1])
                self.states.append(y)
                self.controls.append((times[k], claimed[k]))

    def require_admissible(self, rounding):
        low, high = self.best.bounds
        slack = max(1e-9, rounding / 10) * (high - low)

        def outside(u):
            return not low - slack <= u <= high + slack

        for t, _ in (pair for pair in self.controls if outside(pair[1])):
            duration = self._sections[-1][1]
            instants = wording.round_instants(duration)
            for instant, u in zip(instants, values_of(self._sections, instants)):
                if outside(u):
                    raise Wrong(
                        f"{self.where}your control is {u:.4g} at t = {instant:.4g}, outside its bounds"
                    )
            part_text = wording.process_part_text(t, duration)
            raise Wrong(f"{self.where}your control is outside its bounds {part_text}")


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
    """Raise `Wrong` unless a process keeps to the ends and costs no more than the best one.

    The last entry of `states` is the cost so far; `source` (the control or law) and `when` (the
    end of the process) are words for the message. `perturbed_ends` are pairs of ends of the process
    when one of its decimals is changed by its uncertainty, `paired_ends` the ends when two of them
    are, in the order of `perturbed_in_pairs`.
    """
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
        # Without the cost: close to the optimum it would show the least cost.
        raise Wrong(
            f"{where}{source} keeps to the ends; there is an admissible process with the same ends "
            "that costs "
            + ("more, and the cost is to be maximised" if problem.maximise else "less")
        )


def require_end_conditions(y, best, rounding, prefix, perturbed_ends=(), when=AT_BEST_END):
    """Raise `Wrong` unless a process ends on the target.

    `perturbed_ends` are pairs of ends when one decimal is changed by its uncertainty.
    """
    if not on_target(y, best, rounding, perturbed_ends):
        # Without the state when the best process ends, since the duration may be an answer.
        state = (
            f"{point_text(y[:-1])} {when}, which is not on the target"
            if when == AT_OWN_END
            else f"not on the target {when}"
        )
        raise Wrong(f"{prefix} the state is {state}")


def on_target(y, best, rounding, perturbed_ends=()):
    """Return whether a process that ends in y keeps to the ends."""
    gap, allowed = best.gap(y), 2 * rounding * best.size()
    ranges = [parabola_range(*(best.gap(end) - gap for end in sides)) for sides in perturbed_ends]
    least, greatest = (gap + sum((part[k] for part in ranges), np.zeros(len(gap))) for k in (0, 1))
    return bool(np.all((least <= allowed) & (greatest >= -allowed)))


def parabola_range(below, above):
    """Return the least and the greatest value on [-1, 1] of a parabola, entry by entry.

    It vanishes at zero and has the values `below` and `above` at -1 and 1.
    """
    slope, curvature = np.subtract(above, below) / 2, np.asarray(np.add(above, below) / 2)
    with np.errstate(all="ignore"):
        inner = np.where(np.abs(slope) < 2 * np.abs(curvature), -(slope**2) / (4 * curvature), 0.0)
    return np.minimum.reduce([below, above, inner]), np.maximum.reduce([below, above, inner])


def _least_quadratic(sides, paired_values):
    """Return the least value on [-1, 1]^n of a quadratic polynomial that vanishes at zero.

    `sides` are its values at -1 and 1 on the axes, `paired_values` those where two coordinates are
    1.
    """
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
    # The duration of the best process has the relative accuracy `INTEGRATED`.
    early = np.asarray(times[1:-1]) < (1 - INTEGRATED) * times[-1]
    sides = np.array([best.gap(y)[0] for y, is_early in zip(states[1:-1], early) if is_early])
    tolerance = 1e-6 * best.size()
    if sides.min(initial=0) < -tolerance and sides.max(initial=0) > tolerance:
        k = int(np.flatnonzero(np.sign(sides) != np.sign(sides[np.argmax(np.abs(sides[:9]))]))[0])
        part_text = wording.process_part_text(times[k + 1], times[-1])
        raise Wrong(f"{where}the target is met {part_text} already, and the process ends there")


def point_text(values):
    """Return a state as text; one coordinate is written as a number."""
    text = wording.point_text(values)
    return text[1:-1] if len(values) == 1 else text
