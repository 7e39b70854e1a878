"""Feedback laws given as expressions or equations, read once and evaluated at many states."""

import copy

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.tolerance import in_decimals, perturbed, relative_tolerance
from workbook.checks.contract.verdict import Invalid, Wrong
from workbook.checks.pontryagin.simulation import point_text
from workbook.checks.tools.numeric_functions import multiprecision_function, real_function
from workbook.checks.tools.wording import NO_NUMBER

#: Number of steps of a motion under a law. A law switches late by at most one step; LAGGING bounds
#: the relative cost of this delay.
STEPS, LAGGING = 1500, 2e-3
#: Number of parts into which the interval between the bounds is divided, and of such divisions, to
#: solve an equation for the control.
PARTS, ROUNDS = 16, 2


class FeedbackLaw:
    """A law, read once, that gives values of the control at many states and times."""

    def __init__(self, answer, problem, parameters, time, with_variants=True):
        self.state, (self.control,) = list(problem.dynamics), problem.controls
        law_parameters = [p for p in parameters if p not in self.state]
        symbols = [*self.state, *law_parameters, *([time] if time else [])]
        self._timed, self._parameters = time is not None, law_parameters
        self.implicit = isinstance(answer, sp.Eq)
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
        self._function, self._arguments = real_function(symbols, [claim]), (symbols, [claim])
        self.no_value = "no solution between the bounds" if self.implicit else NO_NUMBER
        self.decimals = in_decimals(claim)

        def variant(side):
            side = sp.Eq(side, 0, evaluate=False) if self.implicit else side
            return FeedbackLaw(side, problem, parameters, time, False)

        #: Pairs of laws, in each pair one decimal is changed by its uncertainty; none if the
        #: decimals are too many.
        pairs = (with_variants and perturbed(claim)) or ()
        self.perturbed = [[variant(side) for (side,) in pair] for pair in pairs]
        self.rounding = relative_tolerance(claim, computed=LAGGING)

    def multiprecision(self):
        """Return the same law, evaluated in multiprecision numbers."""
        law = copy.copy(self)
        law._function = multiprecision_function(*self._arguments)
        return law

    def __call__(self, states, times, values, bounds):
        """Return the controls at states (n x K) and times (K); nan where there is none."""
        numbers = [
            np.broadcast_to(float(v) if np.ndim(v) == 0 else v, len(times))
            for v in (values[p] for p in self._parameters)
        ]
        arguments = [*states, *numbers, *([times] if self._timed else [])]
        if not self.implicit:
            return self._function(*arguments)[0]
        if not np.all(np.isfinite(bounds)):
            raise Invalid(
                "the control has no bounds, so that an equation may have any solution: write the "
                "law as an expression"
            )
        return self._solved(arguments, bounds)

    def _solved(self, arguments, bounds):
        """Return the solutions between the bounds, by nested brackets and a final secant step."""
        bounds = [np.broadcast_to(bound, arguments[0].shape) for bound in bounds]
        low, high = bounds
        allowed, columns = max(1e-9, self.rounding / 10), np.arange(low.size)
        for level in range(ROUNDS):
            points = low + (high - low) * np.arange(PARTS + 1)[:, None] / PARTS
            residuals = self._function(
                points, *(np.broadcast_to(v, points.shape) for v in arguments)
            )[0]
            with np.errstate(invalid="ignore"):
                has_root = (residuals[:-1] * residuals[1:] <= 0) & (residuals[:-1] != 0)
            has_root[0] |= residuals[0] == 0
            if level == 0:
                size = np.nanmax(np.abs(residuals), axis=0, initial=0)
                if (has_root.sum(axis=0) > 1).any():
                    k = int(np.argmax(has_root.sum(axis=0)))
                    raise Wrong(
                        f"at the state {point_text([v[k] for v in arguments[:2]])} your equation has "
                        f"several solutions between the bounds of {self.control}"
                    )
                # A solution just beyond a bound is read as this bound.
                ends = np.abs(residuals[[0, -1]])
                at_bound = ~has_root.any(axis=0) & (
                    np.nanmin(ends, axis=0, initial=np.inf) <= allowed * size
                )
                bound = np.where(ends[0] <= ends[1], *bounds)
                unsolved = ~has_root.any(axis=0) & ~at_bound
            first = has_root.argmax(axis=0)
            low, high = points[first, columns], points[first + 1, columns]
            at_low, at_high = residuals[first, columns], residuals[first + 1, columns]
        with np.errstate(all="ignore"):
            chord = np.where(
                at_low == at_high, low, low - at_low * (high - low) / (at_high - at_low)
            )
        return np.where(unsolved, np.nan, np.where(at_bound, bound, np.clip(chord, low, high)))
