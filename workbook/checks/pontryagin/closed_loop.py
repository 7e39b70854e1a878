"""Feedback laws followed from many initial states at once and compared with fastest times."""

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.numeric_functions import real_function

#: A law may be slower than the optimum by this share: its switching curve may be written in
#: decimals.
SLOWER = 0.004
#: How close to the target counts as on it, in units of the size of the state.
CLOSE = 3e-5
#: How close to a curve counts as on it, where a law is not defined beyond.
ON_CURVE = 1e-6
#: Two values of a law this close are one.
EQUAL_CONTROLS = 1e-6
#: The parts of the fastest time for which a law is followed; whether the rest suffices is asked of
#: the optimum after each of them, since no law makes up for what was lost.
FOLLOWED = (0.12, 0.4, 0.97)
#: In so many steps it is followed, and asked at so many moments of each; and once more, closely,
#: from where it comes too late. Next to states from which the target is out of reach it may have to
#: switch within a thousandth of the way.
STEPS, CLOSELY = (48, 1), (480, 16)


class Law:
    """An expression of the state and the parameters, on many states at once."""

    def __init__(self, expression, reference, curve=None):
        symbols = [*reference.state, *reference.parameters, *([curve[0]] if curve else [])]
        self._function = real_function(symbols, [expression])
        # What a law says on a curve alone counts where it says nothing beyond, on the border of the
        # starts it is for.
        self._on_curves = expression.has(sp.Eq) and real_function(
            symbols, [expression.replace(sp.Eq, lambda a, b: abs(a - b) <= ON_CURVE * (1 + abs(a)))]
        )
        self._cases = np.array(reference.cases, dtype=float).reshape(
            len(reference.cases), len(reference.parameters)
        )
        self._abscissa, self._tables = (
            (curve[1], self._tabulated(curve[2], reference)) if curve else (None, [])
        )

    @staticmethod
    def _tabulated(ends, reference):
        key = ("table", str(ends.variable), ends.interval)
        if key not in reference.kept:
            reference.kept[key] = [ends.table(case) for case in reference.cases]
        return reference.kept[key]

    def __call__(self, x, case):
        values = [*x.T, *self._cases[case].T]
        if self._tables:
            points = np.broadcast_to(self._abscissa(*values), len(x))
            ordinate = np.full(len(x), np.nan)
            for k, (first, second) in enumerate(self._tables):
                ordinate[case == k] = np.interp(
                    points[case == k], first, second, left=np.nan, right=np.nan
                )
            values.append(ordinate)
        claimed = self._function(*values)[0]
        if self._on_curves and np.isnan(claimed).any():
            claimed = np.where(np.isnan(claimed), self._on_curves(*values)[0], claimed)
        return claimed


def follow(law, reference, batch):
    """Raise `Wrong` for a start from which the law needs longer than the optimum."""
    x, late_indices, remaining_time = _late_states(law, reference, batch, STEPS)
    subset = batch.take(late_indices)
    # What is in time by a hair's breadth may come out as late: there the distance decides.
    distance = (
        reference.missing(x[late_indices], subset.case, remaining_time[late_indices], subset.inside)
        if len(late_indices)
        else np.zeros(0)
    )
    late_indices = late_indices[~(distance <= CLOSE * (1 + np.linalg.norm(subset.x, axis=1)))]
    for first in range(0, len(late_indices), 8):
        # Close to the border of the starts that a law is meant for a switching may have been
        # stepped over.
        subset = batch.take(late_indices[first : first + 8])
        _, slow, remaining_time = _late_states(law, reference, subset, CLOSELY)
        # Next to a barrier a thin target may have been missed by the optimum too.
        for k in slow[~reference.beside_barrier(subset.take(slow))] if len(slow) else ():
            elapsed = subset.time[k] * (1 + SLOWER) + 1e-3 - remaining_time[k]
            raise Wrong(
                f"{reference.start_text(subset, k)} your law is too slow: where it has brought the state "
                f"after {elapsed:.4g}, the target can no longer be reached in the least time"
            )


def _late_states(law, reference, batch, resolution):
    """Where the law has brought each start, for which of them the time left does not suffice then,
    and this time."""
    for x, elapsed in _closed_loop(law, reference.plant, batch, *resolution):
        time, remaining_time = (
            reference.solve(x, batch.case).time,
            batch.time * (1 + SLOWER) + 1e-3 - elapsed,
        )
        # On the way the target may seem to be out of reach by a hair's breadth: what is lost can be
        # counted.
        if (np.isfinite(time) & (time > remaining_time)).all():
            break
    return x, np.flatnonzero(~(time <= remaining_time)), remaining_time


def _closed_loop(law, plant, batch, steps, instant_count):
    """Where the law has brought each start after each part of its fastest time: pairs (states,
    times).

    The control is held until no value of the law next to the state is the control held: rounding,
    and what the law says on a curve alone, decide nothing. The law is asked at some moments of each
    step, and when it switches is found by bisection between two of them.
    """
    x, case = batch.x.copy(), batch.case
    t, h, last_switch = (
        np.zeros(len(x)),
        FOLLOWED[-1] * batch.time / steps,
        np.full(len(x), -np.inf),
    )
    low, high = plant.bounds
    offsets = np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]]) * 1e-8

    def neighbours(x):
        return (x[:, None] + (1 + abs(x).max(axis=1))[:, None, None] * offsets).reshape(-1, 2)

    def clipped(x, case):
        # nan, which equals no control, where the law has no value
        return np.clip(law(x, case), low, high)

    def holds(x, u, case):
        return (
            abs(clipped(neighbours(x), np.repeat(case, 5)).reshape(-1, 5) - u[:, None])
            < EQUAL_CONTROLS
        ).any(axis=1)

    u = clipped(x, case)
    # A start whose law switches waits until all others have come to a switching or to the end: one
    # search serves them together.
    waiting, rounds = np.zeros(len(x), dtype=bool), np.zeros(len(x), dtype=int)
    first, last = np.zeros(len(x)), np.zeros(len(x))
    for end in (part * batch.time for part in FOLLOWED):
        while True:
            active = np.flatnonzero(~waiting & (t < end - 1e-12) & (rounds < 5 * steps))
            if len(active):
                rounds[active] += 1
                step = np.minimum(h[active], end[active] - t[active])
                # A law that chatters is followed with a small delay; where this delay decides,
                # there is nothing to search for.
                delay = np.clip(last_switch[active] + h[active] / 40 - t[active], 0, step)
                delayed_rows = np.flatnonzero(delay > 0)
                instants = np.maximum(
                    step[:, None] * np.arange(instant_count + 1) / instant_count, delay[:, None]
                )
                moved_rows = np.concatenate(
                    [np.repeat(active, instant_count), active[delayed_rows]]
                )
                points = plant.move(
                    x[moved_rows],
                    u[moved_rows],
                    np.concatenate([instants[:, 1:].ravel(), delay[delayed_rows]]),
                )
                claimed, count = (
                    holds(points, u[moved_rows], case[moved_rows]),
                    len(active) * instant_count,
                )
                held, delayed = (
                    claimed[:count].reshape(-1, instant_count),
                    np.zeros(len(active), dtype=bool),
                )
                delayed[delayed_rows] = ~claimed[count:]
                switching, k = ~held.all(axis=1), held.argmin(axis=1)[:, None]
                before, after = (np.take_along_axis(instants, j, axis=1)[:, 0] for j in (k, k + 1))
                waiting[active] = switching
                first[active], last[active] = before, np.where(delayed, delay, after)
                continuing = active[~switching]
                x[continuing], t[continuing] = (
                    points[instant_count - 1 : count : instant_count][~switching],
                    t[continuing] + step[~switching],
                )
                continue
            switching_rows = np.flatnonzero(waiting)
            if not len(switching_rows):
                break
            searched_rows = switching_rows[first[switching_rows] < last[switching_rows]]
            if len(searched_rows):

                def still_holds(spans, rows, searched_rows=searched_rows):
                    batch = searched_rows[rows]
                    return holds(plant.move(x[batch], u[batch], spans), u[batch], case[batch])

                last[searched_rows] = bisect(
                    still_holds, first[searched_rows], last[searched_rows], 40
                )[1]
            x[switching_rows], t[switching_rows], waiting[switching_rows] = (
                plant.move(x[switching_rows], u[switching_rows], last[switching_rows]),
                t[switching_rows] + last[switching_rows],
                False,
            )
            claimed = law(x[switching_rows], case[switching_rows])
            for k in np.flatnonzero(
                (claimed < low - EQUAL_CONTROLS) | (claimed > high + EQUAL_CONTROLS)
            ):
                point = x[switching_rows[k]]
                raise Wrong(
                    f"a motion under your law comes to ({point[0]:.4g}, {point[1]:.4g}), "
                    f"where it gives {claimed[k]:.4g}, outside the bounds of the control"
                )
            u[switching_rows], last_switch[switching_rows] = (
                np.clip(claimed, low, high),
                t[switching_rows],
            )
            for k in switching_rows[np.isnan(claimed)]:
                nearby_values = clipped(neighbours(x[k : k + 1]), np.repeat(case[k], 5))
                if np.isnan(nearby_values).all():
                    raise Wrong(
                        f"a motion under your law comes to ({x[k][0]:.4g}, {x[k][1]:.4g}), where "
                        "it gives no real number"
                    )
                # On a curve alone a law need not be defined.
                u[k] = nearby_values[~np.isnan(nearby_values)][0]
        yield x.copy(), t.copy()
