"""Discrete solutions from several starting guesses, or the reason why there is none."""

from dataclasses import dataclass
from functools import cache
from itertools import islice, zip_longest

import numpy as np

from trajlib.pontryagin.direct.descent import descend
from trajlib.pontryagin.direct.free_duration import FALLS
from trajlib.pontryagin.direct.guesses import (
    oscillating_guesses,
    random_guesses,
    starting_guesses,
    target_sides,
)
from trajlib.pontryagin.direct.negative_loop import NEGATIVE_LOOP
from trajlib.pontryagin.direct.other_sides import guesses_on_other_sides
from trajlib.pontryagin.direct.refusals import WITHOUT_SOLUTION
from trajlib.pontryagin.direct.transcription import (
    INTERVALS,
    PATIENCE,
    DirectSolution,
    Transcription,
)
from trajlib.pontryagin.problem.arcs import arc_name
from trajlib.pontryagin.problem.errors import NotConverged
from trajlib.pontryagin.problem.log import current_log
from trajlib.pontryagin.problem.time_limit import half_is_over
from trajlib.pontryagin.verification.optimality import sufficiency_theorem

# Several guesses are compared on fewer intervals; solutions within this share of the best cost are
# refined.
COARSE, CLOSE = 30, 0.05
# Most iterations on many intervals from a solution on few; how many guesses of several kinds in a
# row have to lead to one process to be enough.
REFINING, AGREEING = 80, 3
# How many guesses on other sides of obstacles are tried, at most.
OTHER_SIDES = 12
# How often oscillations are tried again in the duration of the best process found.
OSCILLATIONS = 4


@dataclass(frozen=True)
class SearchResult:
    """Discrete solutions, the best first, and how they were found.

    Attributes
    ----------
    solutions : list of tuple
        (DirectSolution, side of the target).
    starts : int
        Number of starting guesses that were tried.
    processes : int
        Number of different processes to which they led.
    coarse_durations : list of float
        The durations that the solutions had on few intervals.
    """

    solutions: list[tuple[DirectSolution, int | None]]
    starts: int
    processes: int
    coarse_durations: list[float]


class Multistart:
    """The search for discrete solutions: guesses tried, failures, least distance from the target.

    Parameters
    ----------
    numeric : NumericProblem
        The problem.
    structure : list of tuple of str, optional
        Kinds of the arcs.
    count : int, optional
        So many guesses on each side of the target; by default until AGREEING in a row lead to one
        process.

    Attributes
    ----------
    starts : int
        Number of guesses tried so far.
    best : DirectSolution or None
        The solution of least cost found so far.
    """

    def __init__(self, numeric, structure=None, count=None):
        self.numeric, self.structure, self.count = numeric, structure, count
        self.failures, self.closest, self.starts, self.processes = [], np.inf, 0, 0
        self.nearest, self.convex = None, sufficiency_theorem(numeric.problem) is not None
        self.coarse_durations, self.best, self.noted = [], None, 0

    def search(self, guess=None) -> SearchResult:
        """Return the discrete solutions over the sides of the target.

        Where a theorem makes every extremal optimal one solution is enough, and so with a guess or
        given arcs. Otherwise guesses of several kinds are tried on few intervals, and the best
        solutions are refined; with a solution, no further guess is tried after half of the time.
        Raises `PontryaginError` with the reason if there is no solution.
        """
        numeric, solutions = self.numeric, []
        single = guess is not None or self.structure is not None or self.convex
        for side in target_sides(numeric):
            solutions += self.first_solution(side, guess) if single else self.best_solutions(side)
        if not solutions:
            self.raise_reason()
        # Where a theorem makes every extremal optimal there are no saddles.
        if not self.convex and self.structure is None:
            solutions = [(descend(numeric, solution, side), side) for solution, side in solutions]
        solutions.sort(key=lambda pair: pair[0].cost)
        return SearchResult(solutions, self.starts, max(self.processes, 1), self.coarse_durations)

    def solve(self, programme, start):
        """Return the solution found from a guess in a list; a failure is noted."""
        result = programme.solve(start)
        if isinstance(result, DirectSolution):
            if self.best is None and self.structure is None:
                NEGATIVE_LOOP.check(self.numeric, result)
            if self.best is None or result.cost < self.best.cost:
                self.best = result
            self._log(programme, self._shown(result), result)
            return [result]
        self.failures.append(result)
        self._log(programme, result.status)
        return []

    def _log(self, programme, outcome, solution=None):
        """Note what came of a guess; the first programme that sees a start counts as its own."""
        new, self.noted = self.starts > self.noted, self.starts
        state = f"{self.starts} {'start' if self.starts == 1 else 'starts'}"
        if self.best is not None:
            state += f", best cost {self.numeric.user_cost(self.best.cost):.6g}"
        log = current_log()
        log.note(
            "start" if new else "grid",
            f"{f'start {self.starts}' if new else 'again'} on {programme.N} intervals: {outcome}",
            None if solution is None else float(self.numeric.user_cost(solution.cost)),
        )
        log.show("start", state)

    def _shown(self, solution):
        numeric = self.numeric
        return (
            f"cost {numeric.user_cost(solution.cost):.6g}, "
            f"duration {numeric.user_time(solution.duration):.6g}"
        )

    def first_solution(self, side, guess):
        """Return the first solution, from the guess or from the likeliest guesses, in a list."""
        numeric = self.numeric
        programme = Transcription(numeric, INTERVALS, self.structure, side)
        # A point is hardly reached by chance: begin with some process that reaches it.
        ladder_first = guess is None and numeric.duration is None and numeric.m > 1
        for attempt in ("ladder", "guesses") if ladder_first else ("guesses", "ladder"):
            if attempt == "guesses":
                starts = (
                    [guess] if guess is not None else starting_guesses(numeric, INTERVALS, side)
                )
            elif guess is None and numeric.m and not self.divergence():
                starts = self.process_to_target(side)
            else:
                starts = []
            for start in starts:
                self.starts += 1
                solutions = self.solve(programme, start)
                if solutions:
                    self.processes += 1
                    return [(solution, side) for solution in solutions]
        return []

    def best_solutions(self, side):
        """Return the best of the solutions from several guesses, refined, in a list."""
        numeric = self.numeric
        coarse = Transcription(numeric, COARSE, None, side, patience=PATIENCE)
        point = numeric.duration is None and numeric.m > 1
        coarse_solutions = self._distinct_solutions(coarse, self._diverse_guesses(side, point))
        ladder_tried = numeric.m == 0 or point
        if not coarse_solutions:
            # Few intervals may be too long for a plant that is fast or unstable.
            fine = Transcription(numeric, INTERVALS, None, side)
            coarse_solutions = self._distinct_solutions(fine, self._diverse_guesses(side))
            if not coarse_solutions and not ladder_tried and not self.divergence():
                coarse_solutions = self._distinct_solutions(fine, self.process_to_target(side))
        if point and len(coarse_solutions) > 1 and not half_is_over():
            coarse_solutions = self._improved_by_oscillations(coarse, coarse_solutions)
        if coarse_solutions and numeric.path_orders:
            coarse_solutions = self._with_other_sides(coarse, coarse_solutions)
        self.processes += len(coarse_solutions)
        fine_programme = Transcription(numeric, INTERVALS, None, side, patience=REFINING, near=True)

        @cache
        def patient_programme():
            return Transcription(numeric, INTERVALS, None, side)

        solutions = []
        for solution in coarse_solutions:
            if len(solutions) == 3 or (
                solutions and solution.cost > solutions[0].cost + CLOSE * abs(solutions[0].cost)
            ):
                break
            if len(solution.controls) == INTERVALS:
                solutions.append(solution)
                continue
            # On few intervals a process may be far from the one on many: then it takes patience.
            # Where IPOPT does not converge there, its last iterate or the solution on few is used.
            start = (solution.duration, solution.states, solution.controls)
            finer = self.solve(fine_programme, start) or self.solve(patient_programme(), start)
            if not finer and self.failures[-1].last is not None:
                finer = [self.failures[-1].last]
            self.coarse_durations += [solution.duration] * len(finer)
            solutions += finer or [solution]
        return [(solution, side) for solution in _distinct(solutions)]

    def _diverse_guesses(self, side, ladder=False):
        """Yield guesses of several kinds in turn: constant controls, straight lines, oscillations.

        `ladder`: at last a process that reaches the target, which is searched for only if the
        others are not enough.
        """
        starts = list(starting_guesses(self.numeric, COARSE, side))
        oscillations = oscillating_guesses(self.numeric, COARSE, starts[0][0])
        if self.count is not None:
            yield from (*starts, *oscillations)
            yield from random_guesses(self.numeric, COARSE, starts[0][0])
        yield from (
            start
            for pair in zip_longest(starts, oscillations)
            for start in pair
            if start is not None
        )
        for process in self.process_to_target(side) if ladder else []:
            yield process
            # The other guesses may have failed because their durations were too short.
            for share in (0.7, 0.5, 0.35):
                yield from oscillating_guesses(self.numeric, COARSE, share * process[0])

    def _distinct_solutions(self, programme, starts):
        """Return the different solutions, the best first; AGREEING equal ones in a row are enough.

        Where the number of starts is given, they are not.
        """
        solutions, repeats = [], 0
        for start in islice(starts, self.count):
            if solutions and half_is_over():
                break
            self.starts += 1
            for solution in self.solve(programme, start):
                before, solutions = len(solutions), _distinct([*solutions, solution])
                repeats = repeats + 1 if len(solutions) == before else 1
            if repeats == AGREEING and self.count is None:
                break
        return solutions

    def _improved_by_oscillations(self, programme, solutions):
        """Return the solutions with better ones from oscillations in the duration of the best.

        Where different processes reach a point, the durations of the first guesses were chance.
        """
        for _ in range(OSCILLATIONS):
            best = solutions[0]
            starts = [
                start
                for sign in (1, -1)
                for start in oscillating_guesses(self.numeric, COARSE, best.duration, sign)
            ]
            candidates = []
            for start in starts:
                self.starts += 1
                candidates += self.solve(programme, start)
            solutions = _distinct([*solutions, *candidates])
            if solutions[0].cost >= best.cost - FALLS * abs(best.cost):
                break
        return solutions

    def _with_other_sides(self, programme, solutions):
        """Return the solutions with those that pass obstacles on their other sides."""
        tried, starts = [], 0
        while untried := [s for s in solutions if not any(s is other for other in tried)]:
            tried.append(untried[0])
            for start in guesses_on_other_sides(self.numeric, untried[0]):
                if starts == OTHER_SIDES or half_is_over():
                    return solutions
                starts += 1
                self.starts += 1
                solutions = _distinct([*solutions, *self.solve(programme, start)])
        return solutions

    def process_to_target(self, side):
        """Return a process that ends on the target in a list; empty if none was found.

        The least distance is noted. A free duration is fixed at one trial value after another, up
        and down a ladder: then the search is convex for a linear system, and finds a process if
        there is one.
        """
        numeric = self.numeric
        programme = Transcription(
            numeric, INTERVALS // 3, self.structure, side, distance_only=True, patience=PATIENCE
        )
        _, states, controls = next(iter(starting_guesses(numeric, INTERVALS, side)))
        processes = []

        def reached(duration):
            if numeric.duration is None and not numeric.shortest <= duration <= numeric.longest:
                return False
            # Zero control is stationary where the plant has no drift: try an oscillation as well.
            start = (duration, states, controls)
            for guess in [start, *oscillating_guesses(numeric, INTERVALS // 3, duration)[:1]]:
                result = programme.solve(guess, duration)
                if isinstance(result, DirectSolution):
                    distance = float(np.sqrt(max(result.cost, 0.0)))
                    current_log().note(
                        "grid",
                        f"distance {distance:.2g} from the target in the time "
                        f"{numeric.user_time(duration):.6g}",
                    )
                    if distance < self.closest:
                        self.closest, self.nearest = distance, (duration, result.states[-1])
                    if distance < 1e-4:
                        processes[:] = [(duration, result.states, result.controls)]
                        return True
                    if self.convex:
                        return False
            return False

        if numeric.duration is not None:
            reached(numeric.duration)
        elif reached(1.0):
            for duration in (0.25, 0.06):
                if not reached(duration):
                    break
        else:
            ladder = (2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 0.25, 128.0, 256.0, 512.0)
            # A point that can be held is reached in the longest time allowed, if it is reached at
            # all.
            ladder += (numeric.longest,) * numeric.time_bounds_given
            duration = next((d for d in ladder if reached(d)), None)
            if duration is not None and duration > 2:
                reached(duration / np.sqrt(2))
        return processes

    def divergence(self):
        """Return the failure in which the cost fell without bound, or None."""
        for failure in self.failures:
            large = failure.cost < -1e8 or failure.largest_state > 1e12
            if failure.status == "Diverging_Iterates" or (
                large and failure.status == "Maximum_Iterations_Exceeded"
            ):
                return failure
        return None

    @property
    def distance_text(self):
        """How near to the target the search came; empty where it was not missed."""
        if not 1e-4 < self.closest < np.inf:
            return ""
        return (
            f"the terminal equations are missed by {self.closest:.3g} at least (least distance "
            "found, by local search)"
        )

    def raise_reason(self):
        """Raise the reason why no solution was found."""
        numeric = self.numeric
        for refusal in WITHOUT_SOLUTION:
            refusal.check(numeric, self)
        arcs = (
            f" with the arcs {', '.join(map(arc_name, self.structure))}" if self.structure else ""
        )
        status = f", last status: {self.failures[-1].status}" if self.failures else ""
        longest = (
            f" that lasts {numeric.user_time(numeric.longest):g} at most"
            if numeric.duration is None and not numeric.time_bounds_given
            else ""
        )
        distance = self.distance_text and f"; {self.distance_text}"
        raise NotConverged(
            f"no process{arcs}{longest} that ends on the target was found from {self.starts} starts"
            f"{distance} (IPOPT{status}). Nothing is proved by that: give a "
            "guess for the duration and the states, or look whether the problem has a solution at "
            "all."
        )


def _distinct(solutions):
    """Return the solutions without those that show the same process, the best first.

    Of the same ones the smoothest is kept: an angle may jump by a whole turn from one interval to
    the next.
    """
    distinct = []
    for solution in sorted(solutions, key=lambda p: np.sum(np.abs(np.diff(p.controls, axis=0)))):
        if not any(
            abs(solution.cost - reference.cost) < 1e-4 * (1e-3 + abs(reference.cost))
            and abs(solution.duration - reference.duration) < 1e-3 * reference.duration
            and np.max(np.abs(solution.states - reference.states))
            < 1e-2 * (1 + np.max(np.abs(reference.states)))
            for reference in distinct
        ):
            distinct.append(solution)
    return sorted(distinct, key=lambda solution: solution.cost)
