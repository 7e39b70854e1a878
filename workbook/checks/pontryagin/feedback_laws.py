"""Feedback laws given as expressions or equations, read once and evaluated at many states."""

import copy

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.tolerance import in_decimals, perturbed, relative_tolerance
from workbook.checks.contract.verdict import Invalid, Wrong
from workbook.checks.pontryagin.simulation import point_text
from workbook.checks.tools.numeric_functions import multiprecision_function, real_function

#: A law is followed in so many steps. Where it switches it lags by a step, which costs it this
#: share at most.
STEPS, LAGGING = 1500, 2e-3
#: In so many parts the distance of the bounds is divided, so often, to find what control an
#: equation means.
PARTS, ROUNDS = 16, 2


class FeedbackLaw:
    """A law, read once: at many states and times it gives values of the control."""

    def __init__(self, answer, problem, parameters, time, followed=True):
        self.state, (self.control,) = list(problem.dynamics), problem.controls
        others = [p for p in parameters if p not in self.state]
        symbols = [*self.state, *others, *([time] if time else [])]
        self._timed, self._others, self.implicit = (
            time is not None,
            others,
            isinstance(answer, sp.Eq),
        )
        if self.implicit:
            left, right = (
                coercion.as_expression(side, [self.control, *symbols]) for side in answer.args
            )
            claim = left - right
            if self.control not in claim.free_symbols:
                raise Invalid(
                    f"expected the law as an expression, or as an equation for {self.control}"
                )
            symbols = [self.control, *symbols]
        else:
            claim = coercion.as_expression(answer, symbols)
        self._function, self._written = real_function(symbols, [claim]), (symbols, [claim])
        self.none = "no solution between the bounds" if self.implicit else "no real number"
        self.decimals = in_decimals(claim)
        #: Pairs of laws that the decimals of this one leave open; none if there are too many.
        self.changed = (
            [
                [
                    FeedbackLaw(
                        sp.Eq(side, 0, evaluate=False) if self.implicit else side,
                        problem,
                        parameters,
                        time,
                        False,
                    )
                    for (side,) in pair
                ]
                for pair in perturbed(claim) or ()
            ]
            if followed
            else ()
        )
        self.rounding = relative_tolerance(claim, computed=LAGGING)

    def wide(self):
        """The same law in numbers of any size."""
        other = copy.copy(self)
        other._function = multiprecision_function(*self._written)
        return other

    def __call__(self, states, times, values, bounds):
        """The controls at states (n x K) and times (K); nan where there is none."""
        numbers = [
            np.broadcast_to(float(v) if np.ndim(v) == 0 else v, len(times))
            for v in (values[p] for p in self._others)
        ]
        known = [*states, *numbers, *([times] if self._timed else [])]
        if not self.implicit:
            return self._function(*known)[0]
        if not np.all(np.isfinite(bounds)):
            raise Invalid(
                "the control has no bounds, so that an equation may have any solution: write the "
                "law as an expression"
            )
        return self._solved(known, bounds)

    def _solved(self, known, bounds):
        """The solutions between the bounds: brackets, made smaller together, and a chord in the
        last one."""
        bounds = [np.broadcast_to(bound, known[0].shape) for bound in bounds]
        low, high = bounds
        allowed, every = max(1e-9, self.rounding / 10), np.arange(low.size)
        for turn in range(ROUNDS):
            points = low + (high - low) * np.arange(PARTS + 1)[:, None] / PARTS
            left = self._function(points, *(np.broadcast_to(v, points.shape) for v in known))[0]
            with np.errstate(invalid="ignore"):
                changed = (left[:-1] * left[1:] <= 0) & (left[:-1] != 0)
            changed[0] |= left[0] == 0
            if turn == 0:
                size = np.nanmax(np.abs(left), axis=0, initial=0)
                if (changed.sum(axis=0) > 1).any():
                    k = int(np.argmax(changed.sum(axis=0)))
                    raise Wrong(
                        f"at the state {point_text([v[k] for v in known[:2]])} your equation has "
                        f"several solutions between the bounds of {self.control}"
                    )
                # What ends just beyond a bound is meant to be this bound.
                ends = np.abs(left[[0, -1]])
                meant = ~changed.any(axis=0) & (
                    np.nanmin(ends, axis=0, initial=np.inf) <= allowed * size
                )
                bound = np.where(ends[0] <= ends[1], *bounds)
                none = ~changed.any(axis=0) & ~meant
            first = changed.argmax(axis=0)
            low, high = points[first, every], points[first + 1, every]
            at_low, at_high = left[first, every], left[first + 1, every]
        with np.errstate(all="ignore"):
            chord = np.where(
                at_low == at_high, low, low - at_low * (high - low) / (at_high - at_low)
            )
        return np.where(none, np.nan, np.where(meant, bound, np.clip(chord, low, high)))
