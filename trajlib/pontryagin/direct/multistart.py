"""Discrete solutions of a problem from several starting guesses, or the reason why there is none."""

from dataclasses import dataclass
from itertools import zip_longest

import numpy as np

from trajlib.pontryagin.direct.descent import descend
from trajlib.pontryagin.direct.free_duration import FALLS, least_time, user_cost
from trajlib.pontryagin.direct.guesses import guesses, refuse_start_on_target, sides, waves
from trajlib.pontryagin.direct.infeasibility import refuse_infeasible, separated
from trajlib.pontryagin.direct.transcription import INTERVALS, PATIENCE, Picture, Transcription
from trajlib.pontryagin.problem.arcs import arc_name
from trajlib.pontryagin.problem.errors import Infeasible, NotConverged, Unbounded
from trajlib.pontryagin.verification.optimality import held, theorem

# Where several starts are compared, they are on fewer intervals; those within this share of the
# best cost are refined.
COARSE, CLOSE = 30, 0.05
# Iterations on many intervals from a solution on few, at most; how many starts of several kinds
# have to lead to one process to be enough.
REFINING, AGREEING = 80, 3
# How often swings are tried anew in the duration of the best process found.
SWINGS = 4


@dataclass(frozen=True)
class Search:
    """Discrete pictures, each with its side of the target, the best first; from how many starts,
    and how many differ; the durations that these had on few intervals.
    """

    pictures: list
    starts: int
    found: int
    coarse_durations: list


def search(numeric, guess=None, structure=None):
    """`Search`: the pictures over the sides of the target. Raises what `explain` finds if there is
    none.

    Where a theorem makes every extremal optimal one picture is enough, and so with a guess or given
    arcs. Otherwise motions of several kinds are started from, on few intervals, and the best
    pictures are refined.
    """
    refuse_start_on_target(numeric)
    refuse_infeasible(numeric)
    attempts = _Attempts(numeric, structure)
    one = guess is not None or structure is not None or theorem(numeric.problem)
    pictures = []
    for side in sides(numeric):
        pictures += attempts.first(side, guess) if one else attempts.several(side)
    if not pictures:
        attempts.explain()
    # Where a theorem makes every extremal optimal there are no saddles.
    if not attempts.convex and structure is None:
        pictures = [(descend(numeric, picture, side), side) for picture, side in pictures]
    pictures.sort(key=lambda pair: pair[0].cost)
    return Search(pictures, attempts.starts, max(attempts.found, 1), attempts.coarse_durations)


class _Attempts:
    """The starts that were tried, with what failed and the least distance from the target."""

    def __init__(self, numeric, structure):
        self.numeric, self.structure = numeric, structure
        self.failures, self.closest, self.starts, self.found = [], np.inf, 0, 0
        self.nearest, self.convex = None, theorem(numeric.problem) is not None
        self.coarse_durations = []

    def solved(self, programme, start):
        """The picture that a start leads to, in a list; what fails is noted."""
        self.starts += 1
        result = programme.solve(start)
        if isinstance(result, Picture):
            return [result]
        self.failures.append(result)
        return []

    def first(self, side, guess):
        """The first picture, from the guess or from the likeliest starts, in a list."""
        numeric = self.numeric
        programme = Transcription(numeric, INTERVALS, self.structure, side)
        # A point is hard to hit by chance: begin with some way to it.
        ladder_first = guess is None and numeric.duration is None and numeric.m > 1
        for attempt in ("ladder", "guesses") if ladder_first else ("guesses", "ladder"):
            if attempt == "guesses":
                starts = [guess] if guess is not None else guesses(numeric, INTERVALS, side)
            elif guess is None and numeric.m and not self.runs_away():
                starts = self.reaching(side)
            else:
                starts = []
            for start in starts:
                pictures = self.solved(programme, start)
                if pictures:
                    self.found += 1
                    return [(picture, side) for picture in pictures]
        return []

    def several(self, side):
        """The best of the pictures from several starts, refined, in a list."""
        numeric = self.numeric
        coarse = Transcription(numeric, COARSE, None, side, patience=PATIENCE)
        point = numeric.duration is None and numeric.m > 1
        rough, tried = self._compared(coarse, self._spread(side, point)), numeric.m == 0 or point
        if not rough:
            # Few intervals may be too long for a plant that is fast or unstable.
            fine = Transcription(numeric, INTERVALS, None, side)
            rough = self._compared(fine, self._spread(side))
            if not rough and not tried and not self.runs_away():
                rough = self._compared(fine, self.reaching(side))
        if point and len(rough) > 1:
            rough = self._swung(coarse, rough)
        self.found += len(rough)
        pictures, refined = (
            [],
            Transcription(numeric, INTERVALS, None, side, patience=REFINING, near=True),
        )
        for picture in rough:
            if len(pictures) == 3 or (
                pictures and picture.cost > pictures[0].cost + CLOSE * abs(pictures[0].cost)
            ):
                break
            # Where IPOPT does not come to an end on many intervals, the picture on few has to do.
            if len(picture.controls) == INTERVALS:
                pictures.append(picture)
                continue
            finer = self.solved(refined, (picture.duration, picture.states, picture.controls))
            self.coarse_durations += [picture.duration] * len(finer)
            pictures += finer or [picture]
        return [(picture, side) for picture in _different(pictures)]

    def _spread(self, side, ladder=False):
        """Starts of several kinds in turn: motions under constant controls, straight lines,
        controls that swing.

        `ladder`: a way to the target as the last one, which is looked for only if the others are
        not enough.
        """
        starts = list(guesses(self.numeric, COARSE, side))
        swings = waves(self.numeric, COARSE, starts[0][0])
        yield from (
            start for pair in zip_longest(starts, swings) for start in pair if start is not None
        )
        for way in self.reaching(side) if ladder else []:
            yield way
            # The others may have failed for want of time.
            for share in (0.7, 0.5, 0.35):
                yield from waves(self.numeric, COARSE, share * way[0])

    def _compared(self, programme, starts):
        """The different pictures that the starts lead to, the best first; enough where AGREEING in
        a row are the same.
        """
        pictures, row = [], 0
        for start in starts:
            for picture in self.solved(programme, start):
                before, pictures = len(pictures), _different([*pictures, picture])
                row = row + 1 if len(pictures) == before else 1
            if row == AGREEING:
                break
        return pictures

    def _swung(self, programme, pictures):
        """The pictures, and those that the best one's duration leads to from swings, as long as a
        better one is found.

        Where different processes reach a point, how long the first starts took was chance.
        """
        for _ in range(SWINGS):
            best = pictures[0]
            starts = [
                start
                for sign in (1, -1)
                for start in waves(self.numeric, COARSE, best.duration, sign)
            ]
            found = [picture for start in starts for picture in self.solved(programme, start)]
            pictures = _different([*pictures, *found])
            if pictures[0].cost >= best.cost - FALLS * abs(best.cost):
                break
        return pictures

    def reaching(self, side):
        """A process that ends on the target, in a list; empty if none was found, the least distance
        being noted.

        A free duration is fixed at one trial value after another, up and down a ladder: with it the
        search is convex for a linear system, and finds a way if there is one.
        """
        numeric = self.numeric
        programme = Transcription(
            numeric, INTERVALS // 3, self.structure, side, distance_only=True, patience=PATIENCE
        )
        _, states, controls = next(iter(guesses(numeric, INTERVALS, side)))
        ways = []

        def reached(duration):
            if numeric.duration is None and not numeric.shortest <= duration <= numeric.longest:
                return False
            # Zero control is stationary where the plant has no drift: begin with a motion as well.
            start = (duration, states, controls)
            for guess in [start, *waves(numeric, INTERVALS // 3, duration)[:1]]:
                result = programme.solve(guess, duration)
                if isinstance(result, Picture):
                    distance = float(np.sqrt(max(result.cost, 0.0)))
                    if distance < self.closest:
                        self.closest, self.nearest = distance, (duration, result.states[-1])
                    if distance < 1e-4:
                        ways[:] = [(duration, result.states, result.controls)]
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
            # The longest time allowed is the one in which a point that can be held is reached, if
            # it is reached at all.
            ladder += (numeric.longest,) * numeric.time_bounds_given
            duration = next((d for d in ladder if reached(d)), None)
            if duration is not None and duration > 2:
                reached(duration / np.sqrt(2))
        return ways

    def runs_away(self):
        """The failure in which the cost fell without bound, if there is one."""
        for failure in self.failures:
            large = failure.cost < -1e8 or failure.largest_state > 1e12
            if failure.status == "Diverging_Iterates" or (
                large and failure.status == "Maximum_Iterations_Exceeded"
            ):
                return failure
        return None

    def explain(self):
        """Raise the reason why no picture was found."""
        numeric, failure = self.numeric, self.runs_away()
        if failure:
            raise Unbounded(
                f"the cost falls without bound (it passed {user_cost(numeric, failure.cost):.3g}): "
                "there is no optimal process. Check the sign of the cost, bound the controls, or "
                "fix the duration."
            )
        what = (
            f" with the arcs {', '.join(map(arc_name, self.structure))}" if self.structure else ""
        )
        missed = (
            f"the terminal equations are missed by {self.closest:.3g} at least (least distance "
            "found, by local search)"
            if 1e-4 < self.closest < np.inf
            else ""
        )
        if missed and not what:
            self._refuse_separated(missed)
        status = f", last status: {self.failures[-1].status}" if self.failures else ""
        longest = (
            f" that lasts {numeric.longest:g} at most"
            if numeric.duration is None and not numeric.time_bounds_given
            else ""
        )
        raise NotConverged(
            f"no process{what}{longest} that ends on the target was found from {self.starts} starts"
            f"{'; ' + missed if missed else ''} (IPOPT{status}). Nothing is proved by that: give a "
            "guess for the duration and the states, or look whether the problem has a solution at "
            "all."
        )

    def _refuse_separated(self, missed):
        """Raise `Infeasible` if the target is separated from what can be reached in the time given,
        or in less."""
        numeric, (duration, end) = self.numeric, self.nearest
        longest = numeric.duration if numeric.duration is not None else numeric.longest
        if duration != longest or (numeric.duration is None and not held(numeric.problem)):
            return
        if not separated(numeric, duration, end):
            return
        text = (
            f"no admissible control leads to the target in the time {duration:.6g}: a costate "
            f"separates it from all states that can be reached; {missed}"
        )
        shortest = least_time(numeric) if numeric.duration is not None else None
        if shortest is not None and shortest > numeric.duration:
            raise Infeasible(
                f"the duration {duration:.6g} is too short: the least time in which the target is "
                f"reached is {shortest:.6g}. {text[0].upper() + text[1:]}."
            )
        raise Infeasible(text + ". Try another duration, or a free one.")


def _different(pictures):
    """The pictures without those that show the same process as another one, the best first.

    Of the same ones the smoothest is kept: an angle may jump by a whole turn from one interval to
    the next.
    """
    kept = []
    for picture in sorted(pictures, key=lambda p: np.sum(np.abs(np.diff(p.controls, axis=0)))):
        if not any(
            abs(picture.cost - other.cost) < 1e-4 * (1e-3 + abs(other.cost))
            and abs(picture.duration - other.duration) < 1e-3 * other.duration
            and np.max(np.abs(picture.states - other.states))
            < 1e-2 * (1 + np.max(np.abs(other.states)))
            for other in kept
        ):
            kept.append(picture)
    return sorted(kept, key=lambda picture: picture.cost)
