"""Answers without a value: infinite, undefined, undefined in places. No check may call one right.

A comparison such as `abs(value - true) > tolerance` is False for nan, so a check that only looks
for a difference finds none. SymPy keeps such values unnoticed in an expression that was built with
`evaluate=False`.
"""

import itertools

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from trajlib.pontryagin import Problem
from workbook.systems import Controlled

LOGIC = (Relational, sp.And, sp.Or, sp.Not)
NEVER = sp.Integer(10) ** 9
#: Without a value, whatever the symbols.
CONSTANT = {
    "oo - oo": sp.Add(sp.oo, -sp.oo, evaluate=False),
    "0*oo": sp.Mul(0, sp.oo, evaluate=False),
    "1/0": sp.Pow(0, -1, evaluate=False),
    "nan": sp.nan,
    "oo": sp.oo,
}
#: Problems, and where their answers are defined in the mutant: what is left out is not asked for
#: there. By hand, each with its reason.
NOT_ASKED = {
    ("1.6", "k > -1"): "stationary angles exist for -3/4 <= k < 0 alone",
    ("1.9", "theta < 0"): "the curve dv/dt = 0 exists for sin(theta) < 0 alone",
    ("1.12", "u > 1"): "there is a cycle for u > 1 alone",
    ("4.2", "q > 1"): "there are algebraic estimates for q >= 8/3 alone",
    ("4.15", "a < 1"): "the variance has a limit for a < 0 alone",
    ("4.19", "alpha < 1"): "the variance has a limit for |alpha| < 1 alone",
    ("5.2", "x0 < 1"): "the target can be reached from |x0| < 1 alone",
    ("5.3", "x2 < 1"): "the target can be reached from x2 < 1 alone",
    ("5.7", "x2 < 1"): "the target can be reached from |x2| < 1 alone, in item d",
    ("5.18", "t < 1"): "the process ends at t = 1",
    ("5.19", "t < 1"): "the process ends at t = 1",
    ("5.9", "x1 > -1"): "starts with -R < x1, and R < 1",
    ("5.12", "t < 1"): "the transfer takes pi/4",
    ("5.22", "t < 1"): "the transfer of item a takes 1",
    ("5.28", "t < 1"): "the interval of item a ends at 1, and x(1) is free there",
    ("5.65", "t < 1"): "the process ends at t = 1",
    ("5.48", "psi2 < 1"): "the costate of the cost is -1",
    ("5.48", "t < 1"): "the process ends at t = 1",
    ("5.49", "y < 1"): "the river ends at y = 1",
    ("7.4", "M > 1"): "every condition number is at least 1",
}


def undefined_variants(value, data=()):
    """Yield pairs (description, answer): all entries without a value, one entry, or in places.

    Every kind of `CONSTANT` comes for the whole answer; for single entries the kinds take turns, the
    last entry first, and five entries at most: all of a 6 by 6 matrix would show no more. `data` are
    the arguments of the check: where they hold the interval of a symbol, the answer is left undefined
    in one half of it and then in the other.
    """
    if isinstance(value, LOGIC):
        yield from _conditions(value)
        return
    paths = list(entries(value))
    if not paths:
        return
    for name, bad in CONSTANT.items():
        yield f"{name} everywhere", _put(value, paths, lambda entry, bad=bad: bad)
    if len(paths) > 1:
        # A cycle that begins with oo - oo in the last entry: there a loop that gives up early has
        # not looked.
        for path, (name, bad) in zip([paths[-1], *paths[:4]], itertools.cycle(CONSTANT.items())):
            yield f"{name} in {path}", _put(value, [path], lambda entry, bad=bad: bad)
    symbols = sorted(
        set().union(*(sp.sympify(entry_at(value, path)).free_symbols for path in paths)), key=str
    )
    if symbols:
        yield (
            f"defined for {symbols[0]} > {NEVER} alone",
            _put(value, paths, lambda entry: _only(entry, symbols[0], symbols[0] > NEVER)),
        )
    for symbol in symbols[:3]:
        border = _border(symbol, data)
        for condition in (symbol > border, symbol < border):
            if condition not in (sp.true, sp.false):
                changed = _put(
                    value,
                    paths,
                    lambda entry, symbol=symbol, condition=condition: _only(
                        entry, symbol, condition
                    ),
                )
                yield f"defined for {condition} alone", changed


def _only(entry, symbol, condition):
    """Return the entry where a condition on its symbol holds, undefined elsewhere."""
    return (
        sp.Piecewise((entry, condition), evaluate=False)
        if symbol in sp.sympify(entry).free_symbols
        else entry
    )


def _border(symbol, data):
    """Return a value inside the interval of a symbol, or where a condition of the data holds."""
    data = [
        part
        for datum in data
        for part in (
            datum
            if isinstance(datum, Controlled)
            else [datum.controls]
            if isinstance(datum, Problem)
            else [datum]
        )
    ]
    for part in data:
        interval = (
            part.get(symbol)
            if isinstance(part, dict)
            else part.as_set()
            if isinstance(part, LOGIC) and part.free_symbols == {symbol}
            else None
        )
        if isinstance(interval, (tuple, list)) and all(
            sp.sympify(end).is_number and sp.sympify(end).is_finite for end in interval
        ):
            return sp.Rational(sum(interval)) / 2
        if isinstance(interval, sp.FiniteSet):
            return sp.Add(*interval) / len(interval)
        if isinstance(interval, sp.Interval):
            low, high = ((end, end.is_finite is not False) for end in (interval.inf, interval.sup))
            return (
                (low[0] + high[0]) / 2
                if low[1] and high[1]
                else low[0] + 1
                if low[1]
                else high[0] - 1
                if high[1]
                else sp.S.One
            )
    conditions = [
        item
        for part in data
        for item in (part if isinstance(part, (list, tuple)) else [part])
        if isinstance(item, LOGIC)
    ]
    return (
        -sp.S.One
        if symbol.is_negative or any(part.subs(symbol, 1) == sp.false for part in conditions)
        else sp.S.One
    )


def _conditions(condition):
    """Yield the condition as one side of an equation, and with a side without a value."""
    yield "an equation between conditions", sp.Eq(condition, sp.true, evaluate=False)
    relation = min(condition.atoms(Relational), key=str)
    for name in ("oo - oo", "1/0"):
        yield (
            f"{name} on one side",
            condition.xreplace(
                {relation: relation.func(relation.lhs, CONSTANT[name], evaluate=False)}
            ),
        )


def entries(value, path=()):
    """Yield the paths to the numbers and expressions of an answer."""
    if isinstance(value, (list, tuple)):
        for k, part in enumerate(value):
            yield from entries(part, (*path, k))
    elif isinstance(value, dict):
        for key, part in value.items():
            yield from entries(part, (*path, key))
    elif isinstance(value, (sp.MatrixBase, np.ndarray)):
        yield from ((*path, k) for k in np.ndindex(value.shape))
    elif isinstance(value, (sp.Expr, int, float, np.number)) and not isinstance(
        value, (bool, np.bool_)
    ):
        yield path


def entry_at(value, path):
    for step in path:
        value = value[step]
    return value


def _put(value, paths, change):
    """Return a copy of the answer with the entries at some paths changed."""
    for path in paths:
        value = _with(value, path, change)
    return value


def _with(value, path, change):
    if not path:
        return change(value)
    first, *rest = path
    if isinstance(value, np.ndarray):
        value = sp.Matrix(value)
        if isinstance(first, tuple) and len(first) == 1:
            first = (first[0], 0)
    copy = (
        value.as_mutable()
        if isinstance(value, sp.MatrixBase)
        else list(value)
        if isinstance(value, (list, tuple))
        else dict(value)
    )
    copy[first] = _with(value[first], rest, change)
    return type(value)(copy) if isinstance(value, tuple) else copy
