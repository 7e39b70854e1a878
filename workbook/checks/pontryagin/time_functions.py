"""Answers as functions of time, evaluated at many instants and parameters.

They are controls, motions and costates.

A control is an expression, or a list of arcs [value, until]; motions and costates are an expression
for each state.
"""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Claim
from workbook.checks.contract.tolerance import (
    in_decimals,
    perturbed,
    perturbed_in_pairs,
    relative_tolerance,
)
from workbook.checks.contract.verdict import Invalid, Wrong
from workbook.checks.pontryagin.formula_changes import FormulaChanges
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import no_number_text, summed_changes
from workbook.checks.tools.wording import NO_NUMBER, process_part_text

#: Relative tolerance of an answer without decimals: the accuracy of its integration.
INTEGRATED = 1e-5
#: The end of a process, as a fraction of its duration: a function may be defined only up to the end,
#: which is known up to rounding.
ENDING = 1 - 1e-9
#: Arcs that are shorter than this, relative to the time at which they begin, have no length.
NO_LENGTH = 1e-9


class Motion(Claim):
    """All states as functions of time; the first ones suffice if the others are derivatives."""

    @staticmethod
    def coerce(answer, symbols, problem, time):
        claims, state = _one_or_several(answer, symbols), list(problem.dynamics)
        while (
            len(claims) < len(state)
            and problem.dynamics[state[len(claims) - 1]] == state[len(claims)]
        ):
            claims.append(_slope(claims[-1], time))
        if len(claims) != len(state):
            raise Invalid(
                f"expected the motion as expressions in {time}: {', '.join(map(str, state))}"
            )
        return claims


class Costates(Claim):
    """An expression for each state; with one state the expression alone suffices."""

    @staticmethod
    def coerce(answer, symbols, problem):
        claims = _one_or_several(answer, symbols)
        if len(claims) != len(problem.dynamics):
            raise Invalid(
                f"expected a costate for each state: {', '.join(map(str, problem.dynamics))}"
            )
        return claims


class InTime:
    """Expressions in time and parameters, with their derivatives in time."""

    def __init__(self, claims, time, parameters, with_variants=True):
        symbols = [time, *(parameters or ())]

        def compiled(parts):
            return [
                real_function(symbols, expressions)
                for expressions in (parts, [_slope(part, time) for part in parts])
            ]

        self._values, self._rates = compiled(claims)
        self._changes = FormulaChanges(claims, symbols)
        # A state that is the derivative of the one before has no decimals of its own.
        slopes = [k > 0 and claims[k] == _slope(claims[k - 1], time) for k in range(len(claims))]
        written = [claim for claim, is_slope in zip(claims, slopes) if not is_slope]
        variants = perturbed(*written) if with_variants and in_decimals(*written) else []
        #: Pairs of the same, in each pair one decimal is changed by its uncertainty.
        self.variants = [
            [InTime(_with_slopes(side, slopes, time), time, parameters, False) for side in sides]
            for sides in variants or ()
        ]
        self.rounding = (
            relative_tolerance(*claims, computed=INTEGRATED) if variants is None else INTEGRATED
        )

    def values(self, times, parameters):
        """Return the values at an instant or an array of them, a row each; nan where not real."""
        return at_instants(self._values, times, *map(float, parameters.values()))

    def rates(self, times, parameters):
        return at_instants(self._rates, times, *map(float, parameters.values()))

    def changes(self, parameters, duration):
        """Return the instants of (0, duration) at which another formula begins."""
        return self._changes.instants([*map(float, parameters.values())], 0, duration)

    def uncertainty(self, times, parameters):
        """Return the uncertainties, from decimals, of the values and of the rates, a row each."""
        uncertainties = []
        for part in (InTime.values, InTime.rates):
            written = part(self, times, parameters)
            changes = (
                np.fmax(*(np.abs(part(side, times, parameters) - written) for side in sides))
                for sides in self.variants
            )
            uncertainties.append(sum(map(np.nan_to_num, changes), np.zeros_like(written)))
        return uncertainties


def _with_slopes(written, slopes, time):
    """Return all states, including those that are the derivative of the state before."""
    parts, states = iter(written), []
    for is_slope in slopes:
        states.append(_slope(states[-1], time) if is_slope else next(parts))
    return states


class Control(Claim):
    """A list of arcs (value, until), or a single one (value, None), whose value may jump."""

    @staticmethod
    def coerce(answer, symbols, time):
        if isinstance(answer, (np.ndarray, sp.MatrixBase)):
            answer = answer.tolist()
        _refuse_sums(answer)
        if _is_list(answer) and answer and all(_is_list(arc) and len(arc) == 2 for arc in answer):
            constants = [symbol for symbol in symbols if symbol != time]
            return [
                (coercion.as_expression(value, symbols), coercion.as_expression(until, constants))
                for value, until in answer
            ]
        return [(coercion.as_expression(answer, symbols), None)]


class Steering:
    """A control that was read, evaluated for many parameters."""

    def __init__(self, arcs, time, parameters, with_variants=True):
        self.time, self.parameters = time, list(parameters or ())
        self._expressions = [value for value, _ in arcs]
        symbols = [time, *self.parameters]
        self._values = [real_function(symbols, [value]) for value in self._expressions]
        self._ends = [
            until if until is None else real_function(self.parameters, [until]) for _, until in arcs
        ]
        #: Whether the ends of the arcs depend on parameters, for some of which arcs have no length.
        self.ends_vary = any(until is not None and until.free_symbols for _, until in arcs)
        parts = [part for arc in arcs for part in arc if part is not None]
        variants = perturbed(*parts) if with_variants and in_decimals(*parts) else []
        #: Pairs of controls, in each pair one decimal is changed by its uncertainty.
        self.perturbed = [
            [Steering(_arcs(side, arcs), time, parameters, False) for side in sides]
            for sides in variants or ()
        ]
        #: Controls with two decimals changed: row j, and in it each decimal after the j-th.
        self.perturbed_in_pairs = [
            [Steering(_arcs(pair, arcs), time, parameters, False) for pair in row]
            for row in (perturbed_in_pairs(*parts) if variants else ())
        ]
        self.rounding = (
            relative_tolerance(*parts, computed=INTEGRATED) if variants is None else INTEGRATED
        )
        #: The largest relative uncertainty of a decimal.
        self.decimal_tolerance = relative_tolerance(*parts, computed=INTEGRATED)

    def ends(self, values, duration=np.inf):
        """Return the times at which the arcs end, none after `duration`; None for a single expression.

        For some parameters an arc may have no length.
        """
        if self._ends == [None]:
            return None
        ends = self._end_times(values, duration)
        for begin, end in itertools.pairwise([0.0, *ends]):
            if end < begin - NO_LENGTH * abs(begin):
                raise Wrong(
                    f"your arcs end at times that decrease: {end:.4g} comes after {begin:.4g}"
                )
        return ends

    def _end_times(self, values, duration):
        numbers = [float(values[p]) for p in self.parameters]
        return [
            min(_real(until(*numbers), f"the end of your arc number {k}"), duration)
            for k, until in enumerate(self._ends, 1)
        ]

    def end_uncertainties(self, values):
        """Return the uncertainty, from decimals, of the time at which each arc ends."""
        numbers = [float(values[p]) for p in self.parameters]

        def ends(steering):
            return np.array([until(*numbers)[0] for until in steering._ends])

        return summed_changes(ends(self), (map(ends, sides) for sides in self.perturbed))

    def sections(self, values, duration):
        """Return triples (begin, end, function of an array of times) between the jumps.

        They extend from 0 to the duration; arcs may end before. Arcs without length are left out.
        """
        numbers = [float(values[p]) for p in self.parameters]

        def smooth(value, expression):
            def u(times):
                claimed = at_instants(value, times, *numbers)[0]
                # A control may be undefined at single instants, as between the cases t < 1 and t > 1.
                for offset in (1e-9 * duration, -1e-9 * duration):
                    undefined = np.flatnonzero(np.isnan(claimed))
                    if len(undefined):
                        claimed[undefined] = at_instants(
                            value, times[undefined] + offset, *numbers
                        )[0]
                for t in times[np.isnan(claimed)]:
                    reason = no_number_text(expression, {self.time: t, **values})
                    raise Wrong(f"your control is {reason}, {process_part_text(t, duration)}")
                return claimed

            return u

        if self._ends == [None]:
            u = smooth(self._values[0], self._expressions[0])
            breaks = jumps(u, duration)
            # The value at a jump itself does not matter, so it is taken a little inside.
            return [(a, b, _inside(u, a, b)) for a, b in zip([0.0, *breaks], [*breaks, duration])]
        ends = self._end_times(values, duration)
        return [
            (begin, end, smooth(value, expression))
            for begin, end, value, expression in zip(
                [0.0, *ends], ends, self._values, self._expressions
            )
            if end > begin + NO_LENGTH * abs(begin)
        ]


def values_of(sections, times):
    """Return the values of a control, given by its sections, at instants."""
    times = np.clip(times, sections[0][0], sections[-1][1])
    values, remaining = np.empty(len(times)), np.ones(len(times), dtype=bool)
    for begin, end, u in sections:
        inside = remaining & (begin <= times) & (times <= end)
        if inside.any():
            values[inside] = u(times[inside])
        remaining &= ~inside
    return values


def _arcs(parts, arcs):
    """Return arcs with the structure of `arcs` from a flat list of their parts."""
    parts = iter(parts)
    return [tuple(None if part is None else next(parts) for part in arc) for arc in arcs]


def _is_list(answer):
    return isinstance(answer, (list, tuple, sp.Tuple))


def _slope(expression, time):
    """Return the derivative of an expression between its jumps, which `jumps` finds."""
    return sp.diff(expression, time).replace(sp.DiracDelta, lambda *_: sp.S.Zero)


def _refuse_sums(answer):
    """Refuse symbolic sums, which would be added up again at each of many instants."""
    parts = sp.flatten(answer) if _is_list(answer) else [answer]
    if any(isinstance(part, sp.Basic) and part.has(sp.Sum) for part in parts):
        raise Invalid("the answer contains a sum that is not worked out; write it without `sp.Sum`")


def _one_or_several(answer, symbols):
    _refuse_sums(list(answer) if isinstance(answer, (sp.MatrixBase, np.ndarray)) else answer)
    several = _is_list(answer) or isinstance(answer, (sp.MatrixBase, np.ndarray))
    return coercion.as_expressions(answer if several else [answer], symbols)


def jumps(u, duration, pieces=360):
    """Return the instants of (0, duration) at which a function of an array of times jumps.

    They are found by bisection between neighbours that differ.
    """
    times = np.linspace(0, duration, pieces + 1)
    times[0] += 1e-9 * duration
    values = u(times)
    scale = max(map(abs, values)) or 1.0
    left, right, a, b = times[:-1], times[1:], values[:-1], values[1:]
    for _ in range(45):
        differ = ~(abs(a - b) < 1e-6 * scale)
        left, right, a, b = left[differ], right[differ], a[differ], b[differ]
        if not len(left):
            return []
        middle = (left + right) / 2
        value = u(middle)
        later = abs(value - a) < abs(value - b)
        left, right = np.where(later, middle, left), np.where(later, right, middle)
        a, b = np.where(later, value, a), np.where(later, b, value)
    return [t for t in left if 1e-6 * duration < t < (1 - 1e-6) * duration]


def at_instants(function, times, *numbers):
    """Return the values of a `real_function` at an array of times, a row for each expression."""
    try:
        return function(times, *numbers)
    except Invalid:  # some functions, such as erf, take single numbers only
        if np.ndim(times) == 0:
            raise
        return np.array([function(t, *numbers) for t in times]).T


def _inside(u, begin, end):
    margin = 1e-9 * (end - begin)
    return lambda times: u(np.clip(times, begin + margin, end - margin))


def _real(value, name):
    """Return the single entry of an array as a float."""
    if not np.isfinite(value[0]):
        raise Wrong(f"{name} is {NO_NUMBER}")
    return float(value[0])
