"""Feedback laws followed from many initial states at once and compared with fastest times."""

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.wording import NO_NUMBER

#: Relative excess over the fastest time that is allowed: a switching curve may be written in
#: decimals.
SLOWER = 0.004
#: Distance at which a state counts as on the target, relative to the size of the state.
CLOSE = 3e-5
#: Distance at which a state counts as on a curve beyond which a law is not defined.
ON_CURVE = 1e-6
#: Values of a law that differ by less are equal.
EQUAL_CONTROLS = 1e-6
#: Fractions of the fastest time at which a motion under a law is compared with the optimum: the
#: remaining time has to suffice, since no law makes up for lost time.
FOLLOWED = (0.12, 0.4, 0.97)
#: Numbers of steps of a motion and of instants in each step at which the law is evaluated; CLOSELY
#: for a second run from states from which the first came too late. Close to states from which the
#: target cannot be reached, a law may have to switch within a thousandth of the way.
STEPS, CLOSELY = (48, 1), (480, 16)


class Law:
    """A law in the state and the parameters, evaluated at many states at once."""

    def __init__(self, expression, reference, curve=None):
        symbols = [*reference.state, *reference.parameters, *([curve[0]] if curve else [])]
        self._function = real_function(symbols, [expression])
        # The value of a law on a curve alone is used where the law is not defined beyond the curve,
        # on the border of its initial states.
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
    """Raise `Wrong` for an initial state from which the law needs longer than the optimum."""
    x, late_indices, remaining_time = _late_states(law, reference, batch, STEPS)
    subset = batch.take(late_indices)
    # Rounding may make a motion late that is just in time: then its distance decides.
    distance = (
        reference.missing(x[late_indices], subset.case, remaining_time[late_indices], subset.inside)
        if len(late_indices)
        else np.zeros(0)
    )
    late_indices = late_indices[~(distance <= CLOSE * (1 + np.linalg.norm(subset.x, axis=1)))]
    for first in range(0, len(late_indices), 8):
        # Close to the border of the initial states of a law, a step may have missed a switching.
        subset = batch.take(late_indices[first : first + 8])
        _, slow, remaining_time = _late_states(law, reference, subset, CLOSELY)
        # Close to a barrier the computed optimum may have missed a thin target too.
        for k in slow[~reference.beside_barrier(subset.take(slow))] if len(slow) else ():
            elapsed = subset.time[k] * (1 + SLOWER) + 1e-3 - remaining_time[k]
            raise Wrong(
                f"{reference.start_text(subset, k)} your law is too slow: where it has brought the state "
                f"after {elapsed:.4g}, the target can no longer be reached in the least time"
            )


def _late_states(law, reference, batch, resolution):
    """Return the states reached, the indices of those that are late, and the remaining times."""
    for x, elapsed in _closed_loop(law, reference.plant, batch, *resolution):
        time = reference.solve(x, batch.case).time
        remaining_time = batch.time * (1 + SLOWER) + 1e-3 - elapsed
        # Rounding may make the target unreachable on the way; only a finite loss of time counts.
        if (np.isfinite(time) & (time > remaining_time)).all():
            break
    return x, np.flatnonzero(~(time <= remaining_time)), remaining_time


def _closed_loop(law, plant, batch, steps, instant_count):
    """Yield (states, times) of the motions under a law at each of the FOLLOWED fractions.

    The control is held as long as the law has this value at some point close to the state, so that
    rounding and the value of the law on a curve alone decide nothing. The law is evaluated at some
    instants of each step; bisection between two of them finds the switching time.
    """
    x, case = batch.x.copy(), batch.case
    t = np.zeros(len(x))
    h = FOLLOWED[-1] * batch.time / steps
    last_switch = np.full(len(x), -np.inf)
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
    # A motion that comes to a switching waits until all others have come to one or to the end, so
    # that one bisection finds all switching times.
    waiting, rounds = np.zeros(len(x), dtype=bool), np.zeros(len(x), dtype=int)
    first, last = np.zeros(len(x)), np.zeros(len(x))
    for end in (part * batch.time for part in FOLLOWED):
        while True:
            active = np.flatnonzero(~waiting & (t < end - 1e-12) & (rounds < 5 * steps))
            if len(active):
                rounds[active] += 1
                step = np.minimum(h[active], end[active] - t[active])
                # A chattering law switches with a small delay; where this delay decides, there is no
                # switching time to search for.
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
                claimed = holds(points, u[moved_rows], case[moved_rows])
                count = len(active) * instant_count
                held = claimed[:count].reshape(-1, instant_count)
                delayed = np.zeros(len(active), dtype=bool)
                delayed[delayed_rows] = ~claimed[count:]
                switching, k = ~held.all(axis=1), held.argmin(axis=1)[:, None]
                before, after = (np.take_along_axis(instants, j, axis=1)[:, 0] for j in (k, k + 1))
                waiting[active] = switching
                first[active], last[active] = before, np.where(delayed, delay, after)
                continuing = active[~switching]
                x[continuing] = points[instant_count - 1 : count : instant_count][~switching]
                t[continuing] += step[~switching]
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
            rows = switching_rows
            x[rows] = plant.move(x[rows], u[rows], last[rows])
            t[rows] += last[rows]
            waiting[rows] = False
            claimed = law(x[rows], case[rows])
            outside = (claimed < low - EQUAL_CONTROLS) | (claimed > high + EQUAL_CONTROLS)
            for k in np.flatnonzero(outside):
                point = x[rows[k]]
                raise Wrong(
                    f"a motion under your law comes to ({point[0]:.4g}, {point[1]:.4g}), "
                    f"where it gives {claimed[k]:.4g}, outside the bounds of the control"
                )
            u[rows], last_switch[rows] = np.clip(claimed, low, high), t[rows]
            for k in rows[np.isnan(claimed)]:
                nearby_values = clipped(neighbours(x[k : k + 1]), np.repeat(case[k], 5))
                if np.isnan(nearby_values).all():
                    raise Wrong(
                        f"a motion under your law comes to ({x[k][0]:.4g}, {x[k][1]:.4g}), where "
                        f"it gives {NO_NUMBER}"
                    )
                # On a curve alone a law need not be defined.
                u[k] = nearby_values[~np.isnan(nearby_values)][0]
        yield x.copy(), t.copy()
