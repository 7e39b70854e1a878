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
SAME = 1e-6
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
        if key not in reference.cache:
            reference.cache[key] = [ends.table(case) for case in reference.cases]
        return reference.cache[key]

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
    x, late, left = _late(law, reference, batch, STEPS)
    subset = batch.take(late)
    # What is in time by a hair's breadth may come out as late: there the distance decides.
    missing = (
        reference.missing(x[late], subset.case, left[late], subset.inside)
        if len(late)
        else np.zeros(0)
    )
    late = late[~(missing <= CLOSE * (1 + np.linalg.norm(subset.x, axis=1)))]
    for first in range(0, len(late), 8):
        # Close to the border of the starts that a law is meant for a switching may have been
        # stepped over.
        subset = batch.take(late[first : first + 8])
        _, slow, left = _late(law, reference, subset, CLOSELY)
        # Next to a barrier a thin target may have been missed by the optimum too.
        for k in slow[~reference.beside_barrier(subset.take(slow))] if len(slow) else ():
            passed = subset.time[k] * (1 + SLOWER) + 1e-3 - left[k]
            raise Wrong(
                f"{reference.start_text(subset, k)} your law is too slow: where it has brought the state "
                f"after {passed:.4g}, the target can no longer be reached in the least time"
            )


def _late(law, reference, batch, closeness):
    """Where the law has brought each start, for which of them the time left does not suffice then,
    and this time."""
    for x, passed in _closed_loop(law, reference.plant, batch, *closeness):
        time, left = reference.solve(x, batch.case).time, batch.time * (1 + SLOWER) + 1e-3 - passed
        # On the way the target may seem to be out of reach by a hair's breadth: what is lost can be
        # counted.
        if (np.isfinite(time) & (time > left)).all():
            break
    return x, np.flatnonzero(~(time <= left)), left


def _closed_loop(law, plant, batch, steps, moments):
    """Where the law has brought each start after each part of its fastest time: pairs (states,
    times).

    The control is held until no value of the law next to the state is the control held: rounding,
    and what the law says on a curve alone, decide nothing. The law is asked at some moments of each
    step, and when it switches is found by bisection between two of them.
    """
    x, case = batch.x.copy(), batch.case
    t, h, rest = np.zeros(len(x)), FOLLOWED[-1] * batch.time / steps, np.full(len(x), -np.inf)
    low, high = plant.bounds
    around = np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]]) * 1e-8

    def beside(x):
        return (x[:, None] + (1 + abs(x).max(axis=1))[:, None, None] * around).reshape(-1, 2)

    def value(x, case):
        # nan, which equals no control, where the law has no value
        return np.clip(law(x, case), low, high)

    def holds(x, u, case):
        return (abs(value(beside(x), np.repeat(case, 5)).reshape(-1, 5) - u[:, None]) < SAME).any(
            axis=1
        )

    u = value(x, case)
    # A start whose law switches waits until all others have come to a switching or to the end: one
    # search serves them together.
    waits, turns = np.zeros(len(x), dtype=bool), np.zeros(len(x), dtype=int)
    first, last = np.zeros(len(x)), np.zeros(len(x))
    for end in (part * batch.time for part in FOLLOWED):
        while True:
            busy = np.flatnonzero(~waits & (t < end - 1e-12) & (turns < 5 * steps))
            if len(busy):
                turns[busy] += 1
                step = np.minimum(h[busy], end[busy] - t[busy])
                # A law that chatters is followed with a small delay; where this delay decides,
                # there is nothing to search for.
                early = np.clip(rest[busy] + h[busy] / 40 - t[busy], 0, step)
                soon = np.flatnonzero(early > 0)
                asked = np.maximum(step[:, None] * np.arange(moments + 1) / moments, early[:, None])
                asked_rows = np.concatenate([np.repeat(busy, moments), busy[soon]])
                points = plant.move(
                    x[asked_rows],
                    u[asked_rows],
                    np.concatenate([asked[:, 1:].ravel(), early[soon]]),
                )
                claimed, count = holds(points, u[asked_rows], case[asked_rows]), len(busy) * moments
                held, delayed = (
                    claimed[:count].reshape(-1, moments),
                    np.zeros(len(busy), dtype=bool),
                )
                delayed[soon] = ~claimed[count:]
                switching, k = ~held.all(axis=1), held.argmin(axis=1)[:, None]
                before, after = (np.take_along_axis(asked, j, axis=1)[:, 0] for j in (k, k + 1))
                waits[busy] = switching
                first[busy], last[busy] = before, np.where(delayed, early, after)
                on = busy[~switching]
                x[on], t[on] = (
                    points[moments - 1 : count : moments][~switching],
                    t[on] + step[~switching],
                )
                continue
            here = np.flatnonzero(waits)
            if not len(here):
                break
            there = here[first[here] < last[here]]
            if len(there):

                def goes_on(spans, rows, there=there):
                    batch = there[rows]
                    return holds(plant.move(x[batch], u[batch], spans), u[batch], case[batch])

                last[there] = bisect(goes_on, first[there], last[there], 40)[1]
            x[here], t[here], waits[here] = (
                plant.move(x[here], u[here], last[here]),
                t[here] + last[here],
                False,
            )
            claimed = law(x[here], case[here])
            for k in np.flatnonzero((claimed < low - SAME) | (claimed > high + SAME)):
                raise Wrong(
                    f"a motion under your law comes to ({x[here[k]][0]:.4g}, {x[here[k]][1]:.4g}), "
                    f"where it gives {claimed[k]:.4g}, outside the bounds of the control"
                )
            u[here], rest[here] = np.clip(claimed, low, high), t[here]
            for k in here[np.isnan(claimed)]:
                near = value(beside(x[k : k + 1]), np.repeat(case[k], 5))
                if np.isnan(near).all():
                    raise Wrong(
                        f"a motion under your law comes to ({x[k][0]:.4g}, {x[k][1]:.4g}), where "
                        "it gives no real number"
                    )
                u[k] = near[~np.isnan(near)][0]  # on a curve alone a law need not be defined
        yield x.copy(), t.copy()
