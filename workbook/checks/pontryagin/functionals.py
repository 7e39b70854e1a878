"""Extrema of the calculus of variations, for problems given as a `Functional`.

Motions on which the functional is least, its least value, and whether there is a best motion.

A motion is judged by its definition. It has the given values at the ends. No admissible variation
changes the functional to first order; variations inside the interval and variations of a free end
are tried. The functional has the value that direct optimisation finds (`functional_optimum`). The
Euler equation is not formed.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Number, YesNo
from workbook.checks.contract.direction import directed
from workbook.checks.contract.shapes import COMMON
from workbook.checks.contract.tolerance import (
    agree,
    in_decimals,
    perturbed,
    relative_tolerance,
    rounds_to,
)
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.optima.functional_optimum import FunctionalOptimum, units_of
from workbook.checks.tools.comparisons import SameValue, SameWord
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.samples import sample_values
from workbook.checks.tools.wording import NO_NUMBER, values_text

#: Number of sets of parameters at which an answer is compared.
SAMPLES = 4
#: Relative uncertainty of the quadrature and of direct optimisation.
COMPUTED = 1e-6
#: Windows in which a motion is varied, as parts of the interval. Neighbours overlap; the last one is
#: the whole interval.
WINDOWS = [*((k / 10, (k + 2) / 10) for k in range(9)), (0, 1)]
#: A rate of change with the duration that is smaller than this, relative to value/duration, is zero.
STILL = 1e-7
#: Relative step around a duration in decimals, within which the zero of the rate is interpolated;
#: two zeros closer than DOUBLE steps count as a double zero.
BESIDE, DOUBLE = 0.01, 0.1
#: Durations among which a best one is looked for, from short to long.
DURATIONS = np.geomspace(0.2, 80, 14)


class OfMotion(Expression):
    """An expression in the time of the datum `functional` and in the parameters."""

    def read(self, answer, data):
        return self.coerce(answer, [data["functional"].time, *data["parameters"]])


@judged(OfMotion(), parameters=COMMON["parameters"])
def extremum_motion(claim, functional, parameters=()):
    """Check the motion x(t) on which a functional is least, or greatest.

    It is an expression in time and parameters.

    Can decide when the functional has a best motion that direct optimisation finds; variations of
    the answer are tried.

    Examples
    --------
    >>> from workbook.systems import Functional
    >>> t = sp.Symbol("t", real=True)
    >>> x = sp.Function("x")
    >>> length = Functional(x(t).diff(t)**2, x(t), (t, 0, 1), start=[0], end=[2])
    >>> checks.extremum_motion(2*t, length).status, checks.extremum_motion(2*t**2, length).status
    ('right', 'wrong')
    """
    for values, best in _optima(functional, tuple(parameters)):
        where = f"for {values_text(values)} " if values else ""
        sides = perturbed(claim) if in_decimals(claim) else []
        motion = _Motion(
            claim.subs(values),
            best,
            where,
            relative_tolerance(claim) if sides is None else COMPUTED,
            [[_Motion(side.subs(values), best, where) for (side,) in pair] for pair in sides or ()],
        )
        motion.require_given_ends()
        motion.require_stationary()
        motion.require_best()
    return (
        "it has the given values at the ends, no variation changes the functional to first order, "
        f"and its value there is the {_word(functional)} one"
    )


@judged(Expression("parameters"), parameters=COMMON["parameters"])
def extremum_value(claim, functional, parameters=()):
    """Check the least, or greatest, value of a functional, as an expression in the parameters.

    Can decide when the functional has a best motion that direct optimisation finds.

    Examples
    --------
    >>> from workbook.systems import Functional
    >>> t = sp.Symbol("t", real=True)
    >>> x = sp.Function("x")
    >>> length = Functional(x(t).diff(t)**2, x(t), (t, 0, 1), start=[0], end=[2])
    >>> checks.extremum_value(4, length).status, checks.extremum_value(2, length).status
    ('right', 'wrong')
    """
    for values, best in _optima(functional, tuple(parameters)):
        if values:
            yield SameValue(
                claim, best.value, f"the {_word(functional)} value", values, computed=COMPUTED
            )
            continue
        claimed = real_function([], [claim])()[0]
        if not agree(claimed, best.value, claim, computed=COMPUTED):
            if not np.isfinite(claimed):
                raise Wrong(f"your value is {NO_NUMBER}")
            unattainable = (claimed < best.value) != functional.maximise
            raise Wrong(
                f"your value is {claimed:.4g}; "
                + directed(
                    "no motion with the given ends attains it"
                    if unattainable
                    else "there is a motion with the given ends that does better",
                    f"it is not the {_word(functional)} value on motions with the given ends",
                )
            )
    return f"direct optimisation finds this {_word(functional)} value"


@judged(YesNo())
def extremum_exists(claim, functional, duration=None):
    """Check whether a functional has a best motion.

    With `duration`, the symbol in the end of the interval, the motion has to be best among those
    of all durations.

    For integrands that are at most quadratic. A functional that is strictly convex for the
    motions with the given ends has a best motion.
    """
    word = _word(functional)
    if duration is None:
        exists = _optimum(functional).convex()
        reason = (
            "the second variation always makes it worse"
            if exists
            else "some variations do not make it worse to second order"
        )
        reason += ", tried with functions on 40 parts of the interval"
    else:
        sign = -1 if functional.maximise else 1
        durations = DURATIONS * float(units_of(functional).time)
        series = [
            sign * _optimum(functional.subs({duration: sp.Float(T)})).value for T in durations
        ]
        exists = int(np.argmin(series)) not in (0, len(series) - 1)
        reason = (
            f"its {word} values for {len(series)} durations from {durations[0]:.3g} to "
            f"{durations[-1]:.3g} "
            f"{'have a best one among them' if exists else 'only get better towards one end'}"
        )
    yield SameWord(claim, exists, reason, "look at how the functional behaves: ")
    return reason


@judged(Number())
def stationary_duration(claim, functional, duration):
    """Check a duration at which the best value of a functional is stationary, optimal or not.

    The symbol `duration` stands in the end of the interval.
    """
    T, longest = float(claim), DURATIONS[-1] * float(units_of(functional).time)
    if not 0 < T < longest:
        raise Wrong(f"expected a duration between 0 and {longest:g}")
    rate, size = _rate(functional, duration, T)
    if abs(rate) <= STILL * size:
        return "the best value does not change with the duration there, to first order"
    if in_decimals(claim):
        before, after = (
            _rate(functional, duration, T * (1 + shift))[0] for shift in (-BESIDE, BESIDE)
        )
        # Zeros of the parabola through the three rates; rounding may split a double zero into a
        # complex pair close to the real line.
        zeros = np.roots([(before + after) / 2 - rate, (after - before) / 2, rate])
        if any(
            abs(zero.imag) < DOUBLE and rounds_to(T, T * (1 + BESIDE * zero.real)) for zero in zeros
        ):
            return "to three digits the best value does not change with the duration there, to first order"
    raise Wrong(
        f"at your duration {T:.4g} the {_word(functional)} value still changes with the duration"
    )


def _rate(functional, duration, T, step=0.004):
    """Return the derivative of the best value by the duration, and the size of its terms."""

    def value(part):
        return _optimum(functional.subs({duration: sp.Float(T * (1 + part * step))})).value

    near, far = (value(part) - value(-part) for part in (1, 2))
    return (8 * near - far) / (12 * step * T), abs(value(1)) / T


class _Motion:
    """A claimed motion at values of the parameters.

    `perturbed` are pairs of motions, in each pair one decimal is changed by its uncertainty.
    """

    def __init__(self, claim, best, where, rounding=COMPUTED, perturbed=()):
        self.functional, self.best, self.where = best.functional, best, where
        self.rounding, self.perturbed = rounding, perturbed
        time, n = self.functional.time, self.functional.order
        self._at = real_function([time], [sp.diff(claim, time, k) for k in range(n + 1)])
        self._claim_at = [real_function([time], [sp.diff(claim, time, k)]) for k in range(n)]
        symbols = [time, *(sp.Dummy(f"x{k}") for k in range(n + 1))]
        integrand = self.functional.integrand.subs(
            dict(reversed(list(zip(self.functional.derivatives, symbols[1:]))))
        )
        self._rates = real_function(symbols, [integrand, *(integrand.diff(s) for s in symbols[1:])])
        end = {
            d.subs(time, self.functional.interval[2]): s
            for d, s in zip(self.functional.derivatives, symbols[1:-1])
        }
        final = self.functional.final.subs(end)
        self._final = real_function(symbols[1:-1], [final, *(final.diff(s) for s in symbols[1:-1])])
        self._needed = [k for k, s in enumerate(symbols[1:-1]) if final.has(s)]
        self.begin, self.end = best.begin, best.begin + best.duration

    def require_given_ends(self):
        for point, k, value in self._ends():
            if value is None:
                continue
            claimed, expected = self._value(k, point), float(value)
            size = max(abs(expected), np.abs(self._along()[1][k]).max())
            if not abs(claimed - expected) <= self.rounding * size + self._uncertainty(
                claimed, lambda motion: motion._value(k, point)
            ):
                raise Wrong(
                    f"{self.where}your motion does not satisfy a condition that is given at an end: "
                    f"{self._name(k)} is {claimed:.4g} at t = {point:.4g}"
                )

    def require_stationary(self):
        n, span = self.functional.order, self.end - self.begin
        for first, last in WINDOWS:
            a, b = self.begin + first * span, self.begin + last * span
            bump = np.poly1d([-1, a + b, -a * b]) ** n / ((b - a) / 2) ** (2 * n)
            rate, size = self._variation(bump, a, b)
            if not abs(rate) <= self.rounding * size + self._uncertainty(
                rate, lambda motion: motion._variation(bump, a, b)[0]
            ):
                part = "" if last - first == 1 else f" between t = {a:.4g} and t = {b:.4g} alone"
                raise Wrong(
                    f"{self.where}your motion, varied{part} with its ends kept, changes the "
                    "functional to first order. Along an extremal no variation does"
                )
        middle = (self.begin + self.end) / 2
        for point, k, value in self._ends():
            if value is not None:
                continue
            free_end = _end_variation(point, middle, k, n), point, middle, k
            rate, size = self._free_end_variation(*free_end)
            if not abs(rate) <= self.rounding * size + self._uncertainty(
                rate, lambda motion: motion._free_end_variation(*free_end)[0]
            ):
                raise Wrong(
                    f"{self.where}{self._name(k)} is not given at t = {point:.4g}; moved there, the "
                    "functional changes to first order. So the natural condition at this end fails"
                )

    def _ends(self):
        """Yield (instant, order of a derivative, its value if given) at both ends."""
        for point, values in zip(
            (self.begin, self.end), (self.functional.start, self.functional.end)
        ):
            yield from ((point, k, value) for k, value in enumerate(values))

    def require_best(self):
        claimed, size = self._functional()
        uncertainty = self._uncertainty(claimed, lambda motion: motion._functional()[0])
        if not abs(claimed - self.best.value) <= self.rounding * size + uncertainty:
            raise Wrong(
                f"{self.where}your motion is an extremal and gives the functional the value "
                f"{claimed:.4g}, but another motion with the given ends does better"
            )

    def _uncertainty(self, value, quantity):
        """Return the uncertainty, from its decimals, of a quantity with this value."""
        return sum(max(abs(quantity(motion) - value) for motion in pair) for pair in self.perturbed)

    def _functional(self):
        """Return the value of the functional, and the size of its terms."""
        nodes, along, weights = self._along()
        rates = self._finite_rates(nodes, *along)[0]
        claimed = float(weights @ rates) + self._at_end()[0]
        return claimed, max(abs(claimed), float(weights @ abs(rates)))

    def _free_end_variation(self, variation, point, middle, k):
        """Return the first variation along a polynomial that moves a free end, and its size."""
        rate, size = self._variation(variation, min(point, middle), max(point, middle))
        at_end = self._at_end()[1 + k] if point == self.end else 0.0
        return rate + at_end, size + abs(at_end)

    def _variation(self, variation, a, b):
        """Return the first variation along a polynomial on [a, b], and the size of its terms."""
        nodes, weights = _quadrature(a, b)
        rates = self._finite_rates(nodes, *self._values(nodes))[1:]
        terms = [weights * rate * np.polyder(variation, k)(nodes) for k, rate in enumerate(rates)]
        return float(sum(term.sum() for term in terms)), sum(np.abs(term).sum() for term in terms)

    def _finite_rates(self, nodes, *values):
        """Return the integrand along the motion, and its partial derivatives."""
        rates = self._rates(nodes, *values)
        for t in nodes[~np.isfinite(rates).all(axis=0)]:
            raise Wrong(
                f"{self.where}at t = {t:.4g} on your motion the integrand, or a derivative of it, "
                f"is {NO_NUMBER}"
            )
        return rates

    def _at_end(self):
        """Return the final cost Phi and its derivatives at the end of the motion."""
        orders = range(self.functional.order)
        return self._final(
            *(self._value(k, self.end) if k in self._needed else 0.0 for k in orders)
        )

    def _along(self):
        borders = self.begin + np.arange(11) / 10 * (self.end - self.begin)
        parts = itertools.starmap(_quadrature, itertools.pairwise(borders))
        nodes, weights = map(np.concatenate, zip(*parts))
        return nodes, self._values(nodes), weights

    def _values(self, nodes):
        values = self._at(nodes)
        for t in nodes[~np.isfinite(values).all(axis=0)]:
            raise Wrong(
                f"{self.where}at t = {t:.4g} your motion, or a derivative of it, is {NO_NUMBER}"
            )
        return values

    def _value(self, k, point):
        claimed = self._claim_at[k](point)[0]
        if not np.isfinite(claimed):
            raise Wrong(
                f"{self.where}{self._name(k)} of your motion is {NO_NUMBER}, at t = {point:.4g}"
            )
        return claimed

    def _name(self, k):
        return f"{self.functional.motion.func}" + "'" * k


@functools.lru_cache(maxsize=256)
def _quadrature(a, b, steps=40, reach=3.2):
    """Return nodes and weights on (a, b) of the tanh-sinh rule (Takahasi and Mori).

    The integrand may be infinite at the ends.
    """
    s = np.linspace(-reach, reach, 2 * steps + 1)
    inner = np.pi / 2 * np.sinh(s)
    nodes = (a + b) / 2 + (b - a) / 2 * np.tanh(inner)
    weights = (b - a) / 2 * np.pi / 2 * np.cosh(s) / np.cosh(inner) ** 2 * reach / steps
    inside = (nodes > a) & (nodes < b)
    return nodes[inside], weights[inside]


def _end_variation(point, middle, k, n):
    """Return the polynomial whose k-th derivative is 1 at `point`.

    All other derivatives up to order n - 1 vanish there, and all of them at `middle`.
    """
    powers = [np.poly1d([1] + [0] * m) for m in range(2 * n)]
    rows = [
        [np.polyder(power, order)(position) for power in powers]
        for position in (point, middle)
        for order in range(n)
    ]
    return np.poly1d(np.linalg.solve(np.array(rows), np.eye(2 * n)[k])[::-1])


def _word(functional):
    return "greatest" if functional.maximise else "least"


@functools.lru_cache(maxsize=128)
def _optimum(functional):
    return FunctionalOptimum(functional)


def _optima(functional, parameters):
    """Return pairs (values of the parameters, optimum there)."""
    samples = sample_values(parameters, SAMPLES) if parameters else [{}]
    return [
        (values, _optimum(functional.subs(values) if values else functional)) for values in samples
    ]
