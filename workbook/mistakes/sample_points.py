"""Evaluate expressions and conditions at fixed sample points.

The points depend on the names of the symbols only. The tree of an answer is evaluated with NumPy;
nothing is simplified, compiled or run.
"""

import functools
import hashlib
import math

import numpy as np
import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

#: Numbers of points for expressions, for control laws with several regions, and for conditions.
EXPRESSION, LAW, CONDITION = 24, 400, 6000
#: Relative difference up to which two sides are equal.
ROUNDING = 1e-9
#: Coordinates that put points exactly on borders of conditions.
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
    """A function that has no values at points, such as an integral."""


def expression_points(name, assumption):
    """Return the values of a symbol at the points for expressions.

    At the first third of the points all symbols are positive, so that roots and logarithms are real.
    """
    return _signed(
        0.35 + 2.3 * _uniform(name, EXPRESSION, "size"), name, assumption, EXPRESSION // 3
    )


def law_points(name, assumption):
    """Return the values of a symbol at the points for control laws: small and large ones."""
    return _signed(0.08 * 100 ** _uniform(name, LAW, "size"), name, assumption, 0)


def condition_points(name, assumption):
    """Return the values of a symbol at the points for conditions: small, usual and any numbers."""
    small, usual = (
        np.array(pool)[(_uniform(name, CONDITION, purpose) * len(pool)).astype(int)]
        for pool, purpose in ((SMALL, "small"), (USUAL, "usual"))
    )
    choice = _uniform(name, CONDITION, "which")
    values = np.where(
        choice < 1 / 3,
        small,
        np.where(choice < 2 / 3, usual, 6 * _uniform(name, CONDITION, "any") - 3),
    )
    values = np.round(values) if assumption == "integer" else values
    return np.where(values == 0, 1, abs(values)) if assumption == "positive" else values


def _signed(sizes, name, assumption, positive):
    sizes = np.ceil(3 * sizes) if assumption == "integer" else sizes
    negative = (
        (_uniform(name, len(sizes), "sign") < 0.5)
        & (np.arange(len(sizes)) >= positive)
        & (assumption != "positive")
    )
    return np.where(negative, -sizes, sizes)


def _uniform(name, count, purpose):
    """Return `count` numbers in [0, 1), always the same for a name and a purpose."""
    stream = hashlib.shake_256(f"{purpose} {name}".encode()).digest(4 * count)
    return np.frombuffer(stream, "<u4") / 2**32


class Evaluator:
    """Evaluate SymPy trees at the sample points.

    Parameters
    ----------
    points : callable
        `points(name, assumption)` returns the values of a symbol.
    symbols : dict of str
        Assumptions ("", "positive" or "integer") by the names of the symbols.
    """

    def __init__(self, points, symbols):
        self._points, self._symbols, self._values = points, symbols, {}

    def __call__(self, node):
        """Return complex numbers or truth values: one for each point, or one for all.

        Raises
        ------
        NoValue
            If a function of the tree has no values at points.
        """
        if node not in self._values:
            self._values[node] = self._value(node)
        return self._values[node]

    def _value(self, node):
        if isinstance(node, (sp.Symbol, AppliedUndef, sp.Derivative)):
            return self._points(str(node), self._symbols.get(str(node), "")).astype(complex)
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
            return _compare(node, *parts)
        if function := FUNCTIONS.get(node.func):
            return function(*parts)
        raise NoValue(type(node).__name__)


def _compare(relation, left, right):
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


def _on_upper_side(x):
    """Return numbers with imaginary parts of rounding size set to +0, the upper side of the cut."""
    x = np.asarray(x, dtype=complex)
    return np.where(abs(x.imag) <= ROUNDING * abs(x), x.real + 0j, x)


def _power(base, exponent):
    is_integer = (
        np.ndim(exponent) == 0 and complex(exponent).imag == 0 and complex(exponent).real % 1 == 0
    )
    return (
        np.asarray(base, dtype=complex) ** int(complex(exponent).real)
        if is_integer
        else _on_upper_side(base) ** exponent
    )


def _sign(x):
    size = abs(x)
    return np.where(size < ROUNDING, 0, x / np.where(size == 0, 1, size))


def _of_real_parts(function):
    return lambda *parts: function(*(np.real(part) for part in parts))


def _reduce(function):
    return lambda *parts: functools.reduce(function, parts)


#: NumPy functions for SymPy's.
FUNCTIONS = {
    sp.Add: _reduce(np.add),
    sp.Mul: _reduce(np.multiply),
    sp.Pow: _power,
    sp.Abs: np.abs,
    sp.exp: np.exp,
    sp.log: lambda x: np.log(_on_upper_side(x)),
    sp.sin: np.sin,
    sp.cos: np.cos,
    sp.tan: np.tan,
    sp.cot: lambda x: 1 / np.tan(x),
    sp.sec: lambda x: 1 / np.cos(x),
    sp.asin: np.arcsin,
    sp.acos: np.arccos,
    sp.atan: np.arctan,
    sp.atan2: _of_real_parts(np.arctan2),
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
    sp.floor: _of_real_parts(np.floor),
    sp.ceiling: _of_real_parts(np.ceil),
    sp.Mod: _of_real_parts(np.mod),
    sp.Max: _of_real_parts(_reduce(np.maximum)),
    sp.Min: _of_real_parts(_reduce(np.minimum)),
    sp.And: _reduce(np.logical_and),
    sp.Or: _reduce(np.logical_or),
    sp.Not: np.logical_not,
    sp.Xor: _reduce(np.logical_xor),
    sp.Implies: lambda a, b: ~a | b,
    sp.ITE: lambda test, yes, no: np.where(test, yes, no),
    type(sp.true): lambda: True,
    type(sp.false): lambda: False,
}
