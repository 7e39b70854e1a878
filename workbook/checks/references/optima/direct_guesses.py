"""Initial guesses of a direct optimisation: controls on equal pieces, then arcs of the control."""

import itertools

import numpy as np

from workbook.checks.references.optima.direct_programme import (
    COARSE,
    FINE,
    DirectProgramme,
    kinds_of,
)
from workbook.checks.references.optima.radau import radau
from workbook.checks.references.optima.runge_kutta import rk4

#: From how many controls a search begins, each constant on so many parts of one of these durations.
PARTS, DURATIONS = 6, (3.0, 1.5, 6.0)
#: Where a motion is so many times as fast as usual it has met a pole of the field: then of so many
#: others one counts.
WILD, TRIED = 20, 240
#: How close to a bound, as a part of the distance of both, a control lies on it.
ON_BOUND = 2e-4
#: To what share of the distance of its bounds a control is about zero, and up to what two costs are
#: the same.
QUIET, SAME = 0.05, 1e-9
#: How close to a bound, as a part of their distance, a control between them may have touched it.
TOUCHING = 0.03


class DirectGuesses(DirectProgramme):
    """Guesses from which IPOPT begins."""

    def _guess(self, case, span, random, attempt):
        """Return equal pieces, and the process of a control constant on parts of the duration."""
        pieces, degree = COARSE
        low, high = np.clip(self.bounds(case), -3, 3)
        duration = span[0] if span[0] == span[1] else np.clip(DURATIONS[attempt % 3], *span)
        parts = random.uniform(low, high, PARTS) if attempt else np.full(PARTS, (low + high) / 2)
        states, speeds = self._followed(case, duration, parts)
        if span[0] != span[1] and not speeds.max() <= WILD * np.median(speeds):
            duration, parts = self._closest_guess(case, span, attempt)
            states, _ = self._followed(case, duration, parts)
        controls = np.repeat(parts, degree * pieces // PARTS)
        return [(None, pieces)], self._packed(self._start(case, 0.1), states, controls, [duration])

    def _followed(self, case, duration, parts):
        """Return states at the Radau points, and speeds, under a control that is constant on parts."""
        pieces, degree = COARSE
        y, t, states, speeds = self._start(case, 0.1), 0.0, [], []
        for k, u in enumerate(np.repeat(parts, pieces // PARTS)):

            def field(_, z, u=u):
                return np.array(self.rates(*z, u, *case)[:-1])

            for end in (k + radau(degree)[0][1:]) * duration / pieces:
                y = rk4(field, t, y, end - t)
                t = end
                states.append(y)
                speeds.append(np.linalg.norm(field(t, y)))
        return np.array(states).T, np.array(speeds)

    def _closest_guess(self, case, span, attempt):
        """Return the random duration and control, constant on parts, that end closest to the target."""
        low, high = np.clip(self.bounds(case), -3, 3)
        rates, _, gap, insides = self.casadi_functions
        parts = (
            low + (high - low) * np.random.default_rng(attempt).integers(0, 3, (PARTS, TRIED)) / 2
        )
        durations = np.clip(np.resize(DURATIONS, TRIED), *span)
        y = np.repeat(self._start(case, 0.1)[:, None], TRIED, axis=1)
        for u in np.repeat(parts, 4, axis=0):
            y = rk4(
                lambda _, z, u=u[None]: np.array(rates(z, u, abs(insides(z, u, case)), case))[:-1],
                0,
                y,
                durations / PARTS / 4,
            )
        distances = np.linalg.norm(np.array(gap(y, case)), axis=0)
        chosen = np.argmin(np.where(np.isfinite(distances), distances, np.inf))
        return durations[chosen], parts[:, chosen]

    def _arcs(self, case, arcs, unknown, free, keep_short):
        """Return the arcs of a control that is constant on equal pieces, and the unknowns for them.

        `free` is the number of unknowns beside the lengths of the arcs that can meet the target. With
        `keep_short` a piece or two at the beginning, at the end or between two arcs may hold an arc of another
        kind, whose length may come out as zero.
        """
        times, states, controls, (duration,) = self._unpacked(arcs, unknown)
        pieces, degree = COARSE
        values, (low, high) = controls[::degree], self.bounds(case)
        near = ON_BOUND * (high - low if np.isfinite(high - low) else 1 + np.abs(values).max())
        special = [low, high, *([0.0] if self._absolute else [])]
        kinds = [next((v for v in special if abs(u - v) <= near), None) for u in values]
        runs, k = [], 0
        for kind, group in itertools.groupby(kinds):
            count = len(list(group))
            # A piece or two between other arcs hold a jump, and are no arc.
            if kind is not None or count > 2:
                runs.append((kind, k, k + count))
            elif keep_short:
                before, after = (kinds[j] if 0 <= j < pieces else None for j in (k - 1, k + count))
                runs += [
                    (inner, k, k + count)
                    for inner in self._between(before, after, values[k], special)
                ]
            k += count
        merged = []
        for kind, begin, end in runs or [(None, 0, pieces)]:
            if merged and merged[-1][0] == kind:
                merged[-1][2] = end
            else:
                merged.append([kind, begin, end])
        inner = ((before[2] + after[1]) / 2 for before, after in itertools.pairwise(merged))
        borders = [0, *inner, pieces]
        # The lengths alone may be too few to meet the target.
        arcs_found = [
            (kind if len(merged) - 1 + free >= len(self._terminal) else None, FINE[0])
            for kind, _, _ in merged
        ]
        steps = np.repeat(np.diff(borders), FINE[0]) / FINE[0]
        piece_starts = np.append(0, np.cumsum(steps))[:-1]
        shares = (piece_starts[:, None] + steps[:, None] * radau(FINE[1])[0][1:]).ravel()
        moments = shares * duration / pieces
        states = np.array([np.interp(moments, times, row) for row in states])
        return arcs_found, self._packed(
            unknown[: len(self._state)],
            states,
            np.interp(moments, (times[1:] + times[:-1]) / 2, controls),
            np.diff(borders) * duration / pieces,
        )

    def _between(self, before, after, value, special):
        """Return the kind of arc, in a list, that a piece between two others may hold."""
        if not self._absolute:
            return [None] * self._curved
        neighbours = [u for u in (before, after) if u is not None]
        if len(neighbours) == 2:
            return [u for u in special if min(neighbours) < u < max(neighbours)]
        candidates = [
            u for u in special if neighbours and (u - value) * (neighbours[0] - value) < 0
        ]
        return [min(candidates, key=lambda u: abs(u - value))] if candidates else []

    def _with_end_arcs(self, case, arcs, unknown):
        """Return the arcs, with short ones of other kinds before and after them, or None.

        An arc at an end that is shorter than a piece of the first run is not seen there. Its length
        may come out as zero.
        """
        times, states, controls, lengths = self._unpacked(arcs, unknown)
        kinds, count = kinds_of(arcs), FINE[0] * FINE[1]
        at_start = controls[0] - times[1] * (controls[1] - controls[0]) / (times[2] - times[1])
        before = self._beyond(case, kinds, at_start)[::-1]
        after = self._beyond(case, kinds[::-1], controls[-1])
        if not before and not after:
            return None
        ends = {0: len(before), -1: len(after)}
        first_states, last_states = (
            np.repeat(states[:, [k]], count * ends[k], axis=1) for k in ends
        )
        first_lengths, last_lengths = (np.full(ends[k], times[-1] / COARSE[0] / 2) for k in ends)
        first_controls, last_controls = (
            np.repeat([end if kind is None else kind for kind in kinds_beyond], count)
            for kinds_beyond, end in ((before, controls[0]), (after, controls[-1]))
        )
        return (
            [(kind, FINE[0]) for kind in (*before, *kinds, *after)],
            self._packed(
                states[:, 0],
                np.concatenate([first_states, states[:, 1:], last_states], axis=1),
                np.concatenate([first_controls, controls, last_controls]),
                np.concatenate([first_lengths, lengths, last_lengths]),
            ),
        )

    def _beyond(self, case, kinds, control):
        """Return the kinds of arcs that may lie outside the first one, on which the control is given."""
        (low, high), kind = self.bounds(case), kinds[0]
        if kind is None:
            near = TOUCHING * (high - low)
            return [bound for bound in (low, high) if abs(control - bound) <= near < np.inf]
        if self._curved and not self._absolute:
            return []
        special = [low, *([0.0] if self._absolute else []), high]
        k = special.index(kind)
        below, above = special[:k][::-1], special[k + 1 :]
        if below and above and len(kinds) > 1 and kinds[1] is not None:
            return above if kinds[1] < kind else below
        return max(below, above, key=len)

    def _with_zero_arcs(self, case, arcs, unknown):
        """Return the arcs with the control zero on inner arcs where it averages zero, or None.

        There the cost hardly depends on where such an arc begins, unless its control is a single number.
        """
        (low, high), count = self.bounds(case), FINE[0] * FINE[1]
        if self._curved or self._absolute or len(arcs) == 1:
            return None
        if not (low < 0 < high and np.isfinite(high - low)):
            return None
        *_, controls, _ = self._unpacked(arcs, unknown)
        middles = [
            controls[k * count : (k + 1) * count][count // 4 : -count // 4]
            for k in range(len(arcs))
        ]
        kinds = [
            0.0 if kind is None and abs(middle.mean()) <= QUIET * (high - low) else kind
            for (kind, _), middle in zip(arcs, middles)
        ]
        if self._returns:  # a first arc that rests on the target would be a return
            kinds[0] = arcs[0][0]
        return (
            ([(kind, pieces) for kind, (_, pieces) in zip(kinds, arcs)], unknown)
            if kinds != kinds_of(arcs)
            else None
        )
