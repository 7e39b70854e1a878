"""Gain, phase, delay and disk margin of a loop with one control, computed from its data alone.

The loop is a rational function L, closed by 1 + L = 0; or a plant with the gain of u = Kx, with L
that of u = Ke and an observer; or a plant with a cost, whose optimal regulator closes the loop, with a
process by the estimate of its steady filter. It has to be asymptotically stable. A margin may be infinite.

A message names no frequency at which a margin is attained, since the margin follows from it. Of a
margin that is too large it names the frequency of a motion that grows within it, of a disk one at which
the curve is nearer.

No check here is declared by a reference: a margin may be infinite.
"""

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from workbook.checks.contract.claims import Expression, Parts
from workbook.checks.contract.direction import directed
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.references.loop_functions import loop_at
from workbook.checks.tools.samples import allowed_values, in_every_case
from workbook.checks.tools.substitution import evaluated
from workbook.checks.tools.values import uncertainty_at, value_at
from workbook.checks.tools.wording import number_text, where_text

COUNT = 6
#: Shares of a claimed change of the loop at which a motion may grow.
SHARES = [k / 16 for k in range(16, 0, -1)]
#: Factors of the control that are tried instead if there is no largest one.
FACTORS = [2.0**k for k in range(1, 30)]
#: Smallest growth rate that rounding does not explain, relative to the frequency.
GROWS = 1e-6


@dataclass
class SameMargin:
    """An expression has the true value of a margin, which may be infinite.

    Parameters
    ----------
    claim : sympy.Expr
        The answer.
    true : float
        The true value.
    quantity : str
        Its name.
    values : dict
        {symbol: value}.
    failure : callable
        `failure(claimed)` is what fails with a margin that is too large, or "".
    outward : int
        -1 for the lower end of an interval, which is too large where it is too far down.
    """

    claim: sp.Expr
    true: float
    quantity: str
    values: dict
    failure: Callable
    outward: int = 1

    def judge(self):
        infinite = evaluated(self.claim, self.values) == sp.oo
        claimed = math.inf if infinite else value_at(self.claim, self.values, self.quantity)
        if math.isinf(self.true) or infinite:
            right = claimed == self.true
        else:
            uncertainty = uncertainty_at(self.claim, self.values)
            right = agree(claimed, self.true, self.claim, uncertain=uncertainty)
        if not right:
            text = "oo" if infinite else number_text(claimed)
            raise Wrong(
                f"{self.quantity} is not {text}{where_text(self.values)}"
                + directed(self._direction(claimed), "")
            )

    def _direction(self, claimed):
        if claimed < 0:
            return ", a negative number"
        if (claimed - self.true) * self.outward < 0:
            return ": there is a larger margin"
        return self.failure(claimed)


def _loops(claims, loop, K, L, process, parameters, given):
    """Yield samples and the loop there."""
    for values in in_every_case(allowed_values(parameters, given, COUNT), claims, given):
        yield values, loop_at(values, loop, K, L, process)


def _growing_text(roots):
    """Return the text on the first of these roots of a loop whose motion grows, or ""."""
    growing = (root for root in roots if root.real > GROWS * (1 + abs(root)))
    root = next(growing, None)
    if root is None:
        return ""
    if abs(root.imag) < GROWS * abs(root):
        return ": within it a motion grows without oscillation"
    return f": within it a motion of the frequency {abs(root.imag):.4g} grows"


@judged(Parts(Expression("parameters"), Expression("parameters"), expected="a list [low, high]"))
def gain_margins(claims, loop, K=None, L=None, process=None, parameters=(), given=sp.true):
    """Check the ends [low, high] of the interval of factors m > 0 of the control.

    It is the largest interval about 1 for which the loop with m L is asymptotically stable; `high`
    may be oo.

    Can decide when the loop is a rational function with numbers, or at sample values of its
    parameters.

    Examples
    --------
    >>> s = sp.Symbol("s")
    >>> checks.gain_margins([0, sp.oo], 3/(s + 1)).status
    'right'
    >>> checks.gain_margins([0, 1], 3/(s + 1)).status
    'wrong'
    """
    for values, numbers in _loops(claims, loop, K, L, process, parameters, given):

        def failure(end):
            factors = FACTORS if math.isinf(end) else (1 + (end - 1) * share for share in SHARES)
            return _growing_text(map(numbers.rightmost, factors))

        for k, end in enumerate(("the lower end", "the upper end")):
            yield SameMargin(claims[k], numbers.gain[k], end, values, failure, 2 * k - 1)
    return "for these factors the loop is asymptotically stable, and at the ends it is not"


def _within_phase(numbers, shift):
    shifts = (min(shift, math.pi) * share for share in SHARES)
    return _growing_text(numbers.rightmost(cmath.exp(-1j * angle)) for angle in shifts)


def _within_delay(numbers, delay):
    return _growing_text(numbers.roots_with_delay(delay))


def _within_disk(numbers, distance):
    nearer = numbers.frequency_within(distance)
    return f": at the frequency {nearer:.4g} the curve is nearer to -1" if nearer else ""


#: {kind of margin: the sentence on a right one, the text on what fails within one that is too large}.
MARGINS = {
    "phase": ("with no smaller shift of the phase the loop loses its stability", _within_phase),
    "delay": ("with no shorter delay the loop loses its stability", _within_delay),
    "disk": ("the Nyquist curve comes to this distance from -1, and not closer", _within_disk),
}


@judged(Expression("parameters"))
def loop_margin(
    claim, loop, K=None, L=None, process=None, parameters=(), given=sp.true, kind="phase"
):
    """Check the phase, delay or disk margin of a loop, as the `kind` says.

    The phase margin is the smallest phase shift, in radians and to either side, with which the loop is
    not asymptotically stable; the delay margin the smallest such delay of the control. Both are oo if
    there is none. The disk margin is the distance min |1 + L(i omega)| of the Nyquist curve from -1.

    Can decide when the loop is a rational function with numbers, or at sample values of its
    parameters.

    Examples
    --------
    >>> s = sp.Symbol("s")
    >>> checks.loop_margin(sp.oo, 1/(2*s + 2)).status, checks.loop_margin(1, 1/(2*s + 2)).status
    ('right', 'wrong')
    >>> checks.loop_margin(sp.pi/2, 1/s, kind="delay").status
    'right'
    >>> checks.loop_margin(1, 1/s, kind="disk").status, checks.loop_margin(2, 1/s, kind="disk").status
    ('right', 'wrong')
    """
    if kind not in MARGINS:
        raise UnsuitableData(f"kind: expected one of {', '.join(MARGINS)}")
    right, failing_within = MARGINS[kind]
    for values, numbers in _loops(claim, loop, K, L, process, parameters, given):

        def failure(claimed):
            return failing_within(numbers, claimed)

        yield SameMargin(claim, getattr(numbers, kind), f"the {kind} margin", values, failure)
    return right
