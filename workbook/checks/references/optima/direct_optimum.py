"""The best process of a problem with any cost by direct optimisation, without costates.

The states are polynomials on pieces of the duration that satisfy the equations at the Radau points.
First the control is constant on many equal pieces. This is an admissible process, so that no error
of the discretisation makes it look better than any process is, and it shows the arcs: where the
control lies on a bound, vanishes with an absolute value in the cost, or is inside. Then these arcs
get lengths of their own and polynomials as controls, within the bounds between the points too, and
the cost is known to about nine digits. The problem is a `pontryagin.Problem`; only its statement is
used (`direct_problem`, `direct_programme`, `direct_guesses`).

A problem whose plant is not linear, whose cost is not convex, or whose duration is free is searched
from several controls, and the best process counts. An answer that does better than this shows that
the search has failed, and is not judged.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.references.optima.direct_guesses import DirectGuesses
from workbook.checks.references.optima.direct_problem import statement
from workbook.checks.references.optima.direct_programme import BARRIERS, degree_of, kinds_of
from workbook.checks.references.optima.optimum import Optimum
from workbook.checks.references.optima.several_controls import SeveralControls
from workbook.checks.references.optima.units import in_scaled_units

#: A free duration lies between these.
SHORTEST, LONGEST = 1e-3, 40.0
#: Durations that are given first, one after the other, where with a free one no process was found.
FIXED = (8.0, 16.0, 32.0, 4.0)
#: A least cost that was found twice, up to this, is not searched for any longer.
TWICE = 1e-6
#: An arc that takes a smaller part of the duration came out as none: where the control acts late, as at
#: the beginning of a motion, the cost grows with the cube of its length, so no smaller one is found.
EMPTY = 1e-5
#: From how many controls a search begins.
STARTS = 6
#: Up to what two costs are the same.
SAME = 1e-9


@in_scaled_units
def optima(problem, parameters=None, points=None):
    """Return pairs ({parameter: value}, `Optimum`).

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem.
    parameters : dict, optional
        {symbol: interval}, from which sample values are taken.
    points : list of dict, optional
        Values of the parameters instead.
    """
    stated = statement(problem)
    if points is None:
        return _optima(stated, tuple((parameters or {}).items()))
    return [(point, _search(stated, tuple(point)).best(tuple(point.values()))) for point in points]


@functools.lru_cache(maxsize=64)
def _optima(stated, parameters):
    names = tuple(symbol for symbol, _ in parameters)
    search = _search(stated, names)
    return [(dict(zip(names, case)), search.best(case)) for case in search.cases(dict(parameters))]


@functools.lru_cache(maxsize=64)
def _search(stated, names):
    _, controls, *_ = stated
    return (_Search if len(controls) == 1 else SeveralControls)(stated, names)


class _Search(DirectGuesses):
    """The search for the best process at values of the parameters."""

    def best(self, case):
        """Return the best process for values of the parameters."""
        free = self._duration is None or isinstance(self._duration, tuple)
        ends = self._duration if isinstance(self._duration, tuple) else (self._duration,)
        low, *_, high = (self._value(d, case) for d in (*ends, ends[-1]))
        span = (SHORTEST if low is None else low, LONGEST if high is None else high)
        is_linear = all(
            not sp.diff(f, v).free_symbols & {*self._state, *self._controls}
            for f in self._field
            for v in (*self._state, *self._controls)
        )
        processes, random = [], np.random.default_rng(11)
        for side in self._sides(case):
            costs = []
            for attempt in range(1 if is_linear and not free and self._convex(case) else STARTS):
                process = self._run(case, span, side, *self._guess(case, span, random, attempt))
                if process:
                    processes.append(process)
                    costs = sorted([*costs, process[0]])
                elif (
                    is_linear
                    and free
                    and attempt == 0
                    and (with_duration := self._with_durations(case, span, side, random))
                ):
                    # For a linear plant that search is convex: there is nothing else to be found.
                    processes, costs = processes + with_duration, [with_duration[0][0]]
                    break
                if len(costs) > 1 and costs[1] - costs[0] <= TWICE * (1 + abs(costs[0])):
                    break
            if not costs and free and not is_linear:
                processes += self._with_durations(case, span, side, random)
        if not processes:
            raise RuntimeError("no process that satisfies the conditions was found")
        _cost, arcs, unknown, side = min(processes, key=lambda process: process[0])
        free_count = free + self._initial.count(None)
        guesses = [
            self._arcs(case, arcs, unknown, free_count, keep_short) for keep_short in (False, True)
        ]
        refined = [
            process
            for k, guess in enumerate(guesses)
            if k == 0 or kinds_of(guess[0]) != kinds_of(guesses[0][0])
            for barrier in BARRIERS
            if (process := self._run(case, span, side, *guess, barrier))
        ]
        if not refined:
            refined = self._refined_beyond(case, span, side, *guesses[0])
        elif self._curved and not self._absolute:
            best = min(refined, key=lambda process: process[0])
            refined += self._refined_beyond(case, span, side, *best[1:3])
        if not refined:
            raise RuntimeError("the arcs of the best process could not be made exact")
        least = min(refined, key=lambda process: process[0])
        zero_arc_guess = self._with_zero_arcs(case, *guesses[0])
        zero = zero_arc_guess and self._run(case, span, side, *zero_arc_guess)
        if zero and zero[0] <= least[0] + SAME * (1 + abs(least[0])) + 10 * self._defect(
            case, *least[1:3]
        ):
            least = zero
        arcs, unknown = self._without_empty_arcs(*least[1:3])
        if len(arcs) < len(least[1]) and (fewer := self._run(case, span, side, arcs, unknown)):
            least = fewer
        return self._optimum(case, least[0], *self._without_empty_arcs(*least[1:3]))

    def _without_empty_arcs(self, arcs, unknown):
        """Return arcs and unknowns without the arcs that came out as none."""
        times, states, controls, lengths = self._unpacked(arcs, unknown)
        present = lengths > EMPTY * times[-1]
        keep = np.repeat(present, [pieces * degree_of(arcs) for _, pieces in arcs])
        states = states[:, np.append(True, keep)]
        return list(itertools.compress(arcs, present)), self._packed(
            states[:, 0], states[:, 1:], controls[keep], lengths[present]
        )

    def _refined_beyond(self, case, span, side, arcs, unknown):
        """Return, in a list, the process that may have further short arcs at its ends."""
        guess = self._with_end_arcs(case, arcs, unknown)
        process = guess and self._run(case, span, side, *guess)
        return [process] if process else []

    def _with_durations(self, case, span, side, random):
        """Return, in a list, a process found from one with a given duration.

        For a linear plant the search with a given duration is convex.
        """
        for duration in filter(lambda d: span[0] <= d <= span[1], FIXED):
            fixed = (duration, duration)
            process = self._run(case, fixed, side, *self._guess(case, fixed, random, 0))
            process = process and self._run(case, span, side, process[1], process[2])
            if process:
                return [process]
        return []

    def _optimum(self, case, cost, arcs, unknown):
        times, states, controls, lengths = self._unpacked(arcs, unknown)
        ends = np.cumsum(lengths)
        found = list(zip(kinds_of(arcs), ends - lengths, ends))
        return Optimum(self, case, self._sign * cost, times, states, controls, found)
