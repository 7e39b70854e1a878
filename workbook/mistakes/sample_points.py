"""What expressions are, and where conditions hold, at fixed places that hang on the names of the
symbols alone.

An answer is only looked at: its tree is walked and its numbers are NumPy's, so nothing is
simplified, compiled or run.
"""

import functools
import hashlib
import math

import numpy as np
import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

#: At how many places expressions are tried, and how many it takes to meet every part of a law of
#: control, or every border of a condition.
FEW, LAW, CONDITION = 24, 400, 6000
#: Two sides that differ by a smaller share are equal but for rounding.
ROUNDING = 1e-9
#: Coordinates that put places of conditions exactly on borders: a third are small, a third as
#: people write them.
SMALL = (0, 1, -1, 2, -2, 3, -3, 0.5, -0.5)
USUAL = tuple(
    sorted(
        {p / q for q in (1, 2, 3, 4, 5, 8, 9) for p in range(-12, 13)}
        | {
            s * k
            for s in (1, -1)
            for k in (
                *(math.pi * k / 12 for k in range(1, 13)),
                *(math.sqrt(k) * q for k in (2, 3, 5, 6, 7, 8) for q in (1, 0.5)),
                0.01,
                20,
                100,
                1000,
            )
        }
    )
)


class NoValue(Exception):
    """Something that has no numbers at places, such as an integral."""


def expression_places(name, assumed):
    """Ordinary values, with a third of the places all positive, so that roots and logarithms are
    real there."""
    return _signed(0.35 + 2.3 * _shares(name, FEW, "size"), name, assumed, FEW // 3)


def law_places(name, assumed):
    """Small and large values together, for every region of a plane."""
    return _signed(0.08 * 100 ** _shares(name, LAW, "size"), name, assumed, 0)


def condition_places(name, assumed):
    """A third small numbers, a third usual ones, a third any."""
    small, usual = (
        np.array(pool)[(_shares(name, CONDITION, what) * len(pool)).astype(int)]
        for pool, what in ((SMALL, "small"), (USUAL, "usual"))
    )
    which = _shares(name, CONDITION, "which")
    found = np.where(
        which < 1 / 3,
        small,
        np.where(which < 2 / 3, usual, 6 * _shares(name, CONDITION, "any") - 3),
    )
    found = np.round(found) if assumed == "integer" else found
    return np.where(found == 0, 1, abs(found)) if assumed == "positive" else found


def _signed(sizes, name, assumed, positive):
    sizes = np.ceil(3 * sizes) if assumed == "integer" else sizes
    turned = (
        (_shares(name, len(sizes), "sign") < 0.5)
        & (np.arange(len(sizes)) >= positive)
        & (assumed != "positive")
    )
    return np.where(turned, -sizes, sizes)


def _shares(name, count, what):
    """`count` numbers between 0 and 1, always the same ones for a name."""
    stream = hashlib.shake_256(f"{what} {name}".encode()).digest(4 * count)
    return np.frombuffer(stream, "<u4") / 2**32


class Walk:
    """Finds values of SymPy trees at places: `places(name, assumed)` gives those of a symbol,
    `symbols` what is assumed of it."""

    def __init__(self, places, symbols):
        self._places, self._symbols, self._known = places, symbols, {}

    def __call__(self, node):
        """Complex numbers, or truths; a single one where they are the same at all places."""
        if node not in self._known:
            self._known[node] = self._value(node)
        return self._known[node]

    def _value(self, node):
        if isinstance(node, (sp.Symbol, AppliedUndef, sp.Derivative)):
            return self._places(str(node), self._symbols.get(str(node), "")).astype(complex)
        if node.is_Number or isinstance(node, sp.NumberSymbol):
            return complex(node)
        if node is sp.I:
            return 1j
        if isinstance(node, sp.Piecewise):
            return np.select(
                [np.asarray(self(case.cond)) for case in node.args],
                [self(case.expr) for case in node.args],
                np.nan,
            )
        parts = [self(part) for part in node.args]
        if isinstance(node, Relational):
            return _compared(node, *parts)
        if found := FUNCTIONS.get(node.func):
            return found(*parts)
        raise NoValue(type(node).__name__)


def _compared(relation, left, right):
    real = (abs(np.imag(left)) < ROUNDING) & (abs(np.imag(right)) < ROUNDING)
    size = np.maximum(np.maximum(abs(left), abs(right)), 1)
    difference = np.real(left) - np.real(right)
    sign = np.where(abs(difference) <= ROUNDING * size, 0, np.sign(difference))
    return real & ~np.isnan(sign) & SIGNS[relation.func](sign)


SIGNS = {
    sp.Gt: lambda sign: sign > 0,
    sp.Ge: lambda sign: sign >= 0,
    sp.Lt: lambda sign: sign < 0,
    sp.Le: lambda sign: sign <= 0,
    sp.Eq: lambda sign: sign == 0,
    sp.Ne: lambda sign: sign != 0,
}


def _above(x):
    """Numbers that are real but for rounding as real ones, which roots and logarithms continue from
    above."""
    x = np.asarray(x, dtype=complex)
    return np.where(abs(x.imag) <= ROUNDING * abs(x), x.real + 0j, x)


def _power(base, exponent):
    whole = (
        np.ndim(exponent) == 0 and complex(exponent).imag == 0 and complex(exponent).real % 1 == 0
    )
    return (
        np.asarray(base, dtype=complex) ** int(complex(exponent).real)
        if whole
        else _above(base) ** exponent
    )


def _sign(x):
    size = abs(x)
    return np.where(size < ROUNDING, 0, x / np.where(size == 0, 1, size))


def _real(function):
    return lambda *parts: function(*(np.real(part) for part in parts))


def _all(function):
    return lambda *parts: functools.reduce(function, parts)


#: What SymPy's functions are in numbers.
FUNCTIONS = {
    sp.Add: _all(np.add),
    sp.Mul: _all(np.multiply),
    sp.Pow: _power,
    sp.Abs: np.abs,
    sp.exp: np.exp,
    sp.log: lambda x: np.log(_above(x)),
    sp.sin: np.sin,
    sp.cos: np.cos,
    sp.tan: np.tan,
    sp.cot: lambda x: 1 / np.tan(x),
    sp.sec: lambda x: 1 / np.cos(x),
    sp.asin: np.arcsin,
    sp.acos: np.arccos,
    sp.atan: np.arctan,
    sp.atan2: _real(np.arctan2),
    sp.acot: lambda x: np.arctan(1 / x),
    sp.sinh: np.sinh,
    sp.cosh: np.cosh,
    sp.tanh: np.tanh,
    sp.coth: lambda x: 1 / np.tanh(x),
    sp.asinh: np.arcsinh,
    sp.acosh: np.arccosh,
    sp.atanh: np.arctanh,
    sp.acoth: lambda x: np.arctanh(1 / x),
    sp.sinc: lambda x: np.sinc(x / np.pi),
    sp.re: np.real,
    sp.im: np.imag,
    sp.conjugate: np.conj,
    sp.arg: np.angle,
    sp.sign: _sign,
    sp.Heaviside: lambda x, at_zero=0.5: (1 + _sign(x)) / 2,
    sp.floor: _real(np.floor),
    sp.ceiling: _real(np.ceil),
    sp.Mod: _real(np.mod),
    sp.Max: _real(_all(np.maximum)),
    sp.Min: _real(_all(np.minimum)),
    sp.And: _all(np.logical_and),
    sp.Or: _all(np.logical_or),
    sp.Not: np.logical_not,
    sp.Xor: _all(np.logical_xor),
    sp.Implies: lambda a, b: ~a | b,
    sp.ITE: lambda test, yes, no: np.where(test, yes, no),
    type(sp.true): lambda: True,
    type(sp.false): lambda: False,
}
