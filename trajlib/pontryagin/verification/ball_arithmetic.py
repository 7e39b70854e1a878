"""Ball arithmetic (python-flint's Arb): exact numbers as balls, and enclosures by fractions.

The proofs need hundreds of bits, matrix exponentials and inverses, which the intervals of floats in
`trajlib.solvability.intervals` do not have.
"""

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp


class NotProved(ValueError):
    """A proof is not possible; the message names the obstacle."""


class Undetermined(NotProved):
    """A proof fails, but may succeed with more digits."""


@dataclass(frozen=True)
class Enclosure:
    """A number known to lie between two fractions.

    Attributes
    ----------
    low, high : fractions.Fraction
        low <= number <= high.
    text : str
        The number with the digits that are certain.

    Examples
    --------
    >>> third = Enclosure(Fraction(33, 100), Fraction(34, 100), "[0.335 +/- 0.006]")
    >>> sp.Rational(1, 3) in third, sp.sqrt(2) in third
    (True, False)
    """

    low: Fraction
    high: Fraction
    text: str

    def __contains__(self, value):
        low, high = (sp.Rational(e.numerator, e.denominator) for e in (self.low, self.high))
        return bool(low <= value) and bool(value <= high)

    def __float__(self):
        return float((self.low + self.high) / 2)

    def __str__(self):
        return self.text


def to_balls(matrix):
    """Return a matrix of exact numbers as a matrix of balls."""
    from flint import arb_mat

    return arb_mat(matrix.rows, matrix.cols, [to_ball(e) for e in matrix])


def to_ball(expression, values=None):
    """Return a real number, or an expression in symbols with values, as a ball."""
    from flint import arb, fmpq

    e = sp.sympify(expression)
    if e.is_Rational:
        return arb(fmpq(e.p, e.q))
    if e.is_Symbol:
        return values[e]
    if e in (sp.pi, sp.E):
        return arb.pi() if e == sp.pi else arb(1).exp()
    parts = [to_ball(a, values) for a in e.args]
    if e.is_Add:
        return sum(parts[1:], parts[0])
    if e.is_Mul:
        return sp.prod(parts)
    if e.is_Pow:
        return parts[0] ** parts[1] if e.exp.is_Integer or e.base.is_positive else _unknown(e)
    methods = {
        sp.sin: "sin",
        sp.cos: "cos",
        sp.tan: "tan",
        sp.exp: "exp",
        sp.log: "log",
        sp.sinh: "sinh",
        sp.cosh: "cosh",
        sp.tanh: "tanh",
        sp.atan: "atan",
    }
    return getattr(parts[0], methods[type(e)])() if type(e) in methods else _unknown(e)


def _unknown(expression):
    raise NotProved(f"the number {expression} has no enclosure here")


def enclosure(ball) -> Enclosure:
    """Return the ends of a ball as fractions."""
    low, high = (Fraction(*_quotient(end)) for end in (ball.lower(), ball.upper()))
    return Enclosure(low, high, ball.str(30))


def _quotient(point):
    """Return numerator and denominator of an exact ball."""
    mantissa, exponent = map(int, point.man_exp())
    return (mantissa * 2**exponent, 1) if exponent >= 0 else (mantissa, 2**-exponent)


def taylor_range(derivatives, rate, z, half):
    """Enclose row z over the times within `half` of the point z by Taylor's formula.

    `derivatives`: row, row M, row M^2, ...
    """
    from flint import arb

    near = arb(0, half.upper())
    size = max(abs(z[i, 0]).upper() for i in range(z.nrows()))
    norm = max(sum((abs(e) for e in line), arb(0)).upper() for line in rate.table())
    last = sum((abs(e) for e in derivatives[-1].entries()), arb(0)) * size * (norm * half).exp()
    value, factor = arb(0), arb(1)
    for order, row in enumerate(derivatives[:-1]):
        value, factor = value + (row * z)[0, 0] * factor, factor * near / (order + 1)
    return value + factor * arb(0, last.upper())
