"""Small changes of a right answer, like slips: signs, factors, neighbours, strictness, order."""

import itertools
import random

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

SWAPPED = {
    sp.StrictGreaterThan: sp.StrictLessThan,
    sp.StrictLessThan: sp.StrictGreaterThan,
    sp.GreaterThan: sp.LessThan,
    sp.LessThan: sp.GreaterThan,
    sp.Equality: sp.Unequality,
    sp.Unequality: sp.Equality,
}
LOOSENED = {
    sp.StrictGreaterThan: sp.GreaterThan,
    sp.GreaterThan: sp.StrictGreaterThan,
    sp.StrictLessThan: sp.LessThan,
    sp.LessThan: sp.StrictLessThan,
}
EXCHANGED = {
    sp.sin: sp.cos,
    sp.cos: sp.sin,
    sp.sinh: sp.cosh,
    sp.cosh: sp.sinh,
    sp.exp: lambda x: sp.exp(-x),
}


#: Most mutants of one answer.
MOST = 24


def mutants(value, kind=""):
    """Return up to `MOST` mutants of an answer, always the same ones, each once."""
    variants = list(_mutants(value, kind))
    random.Random(7).shuffle(variants)
    return list({repr(mutant): mutant for mutant in variants[:MOST]}.values())


def _mutants(value, kind):
    if isinstance(value, (bool, np.bool_)):
        yield not value
    elif isinstance(value, str):
        words = kind.partition("(")[2].rpartition(")")[0].split(",")
        yield from (word.strip() for word in words if word.strip() and word.strip() != value)
        if kind == "yes/no":
            yield {"yes": "no", "no": "yes"}[value]
    elif isinstance(value, (int, float, np.number)):
        yield from (
            v for v in (-value, value + 1, 2 * value, value / 2, 1.05 * value) if v != value
        )
    elif isinstance(value, (list, tuple)):
        inner = kind.removeprefix("list of ")
        for k, part in enumerate(value):
            yield [*value[:k], *value[k + 1 :]]
            for changed in list(_mutants(part, inner))[:6]:
                yield [*value[:k], changed, *value[k + 1 :]]
        for k in range(len(value) - 1):
            yield [*value[:k], value[k + 1], value[k], *value[k + 2 :]]
        if value:
            nested = isinstance(value[0], (list, tuple)) and any(
                isinstance(x, (list, tuple)) for x in value[0]
            )
            (
                yield [*value, value[0]]
                if nested or not isinstance(value[0], (list, tuple, sp.MatrixBase))
                else [*value, [x + 1 for x in value[0]]]
            )
    elif isinstance(value, dict):
        for key, part in value.items():
            for changed in list(_mutants(part, kind))[:6]:
                yield value | {key: changed}
    elif isinstance(value, np.ndarray):
        yield from (np.array(m.tolist(), dtype=float) for m in _mutants(sp.Matrix(value), kind))
    elif isinstance(value, sp.MatrixBase):
        for k in range(len(value)):
            for changed in list(_mutants(value[k], "expression"))[:3]:
                copy = value.as_mutable()
                copy[k] = changed
                yield copy
        if value.rows == value.cols and value != value.T:
            yield value.T
    elif isinstance(value, (Relational, sp.And, sp.Or, sp.Not)):
        yield from _conditions(value)
    elif isinstance(value, (sp.logic.boolalg.BooleanAtom,)):
        yield sp.Not(value)
    elif isinstance(value, sp.Expr):
        yield from (m for m in _expressions(value) if m != value)
    else:
        raise TypeError(f"no mutants for {type(value).__name__}; add a rule")


def _conditions(condition):
    if condition in (sp.true, sp.false):
        return
    if isinstance(condition, Relational):
        yield SWAPPED[type(condition)](condition.lhs, condition.rhs)
        if type(condition) in LOOSENED:
            yield LOOSENED[type(condition)](condition.lhs, condition.rhs)
        yield condition.func(condition.lhs, condition.rhs + 1)
        yield condition.func(-condition.lhs, condition.rhs)
        yield condition.func(
            condition.lhs,
            condition.rhs + sp.Rational(1, 20) * (1 + abs(condition.rhs))
            if condition.rhs.is_number
            else 2 * condition.rhs,
        )
        for changed in list(_expressions(condition.lhs))[:4]:
            yield condition.func(changed, condition.rhs)
        return
    for k, part in enumerate(condition.args):
        others = condition.args[:k] + condition.args[k + 1 :]
        yield condition.func(*others)
        for changed in _conditions(part):
            yield condition.func(*others, changed)
    if isinstance(condition, sp.And):
        yield sp.Or(*condition.args)


def _expressions(expression):
    if expression.is_number:
        yield from (
            -expression,
            expression + 1,
            2 * expression,
            expression + sp.Rational(1, 20) * (1 + abs(expression)),
        )
        return
    yield -expression
    yield 2 * expression
    yield expression + 1
    if isinstance(expression, sp.Add):
        for term in expression.args:
            yield expression - term
            yield expression - 2 * term
    for law in sorted(expression.atoms(sp.Piecewise), key=str)[:3]:
        for k, (part, condition) in enumerate(law.args):
            # A corner of the law: another value in one case, or a case with another border.
            changes = [
                (-part, condition),
                *[(part, changed) for changed in list(_conditions(condition))[:4]],
            ]
            yield from (
                expression.xreplace({law: sp.Piecewise(*law.args[:k], change, *law.args[k + 1 :])})
                for change in changes
            )
    symbols = sorted(expression.free_symbols, key=str)
    for one, other in itertools.pairwise(symbols):
        yield expression.xreplace({one: other, other: one})
    for power in sorted(expression.atoms(sp.Pow), key=str)[:4]:
        yield expression.xreplace({power: sp.Pow(power.base, power.exp + 1)})
    for function in sorted(expression.atoms(sp.Function), key=str)[:4]:
        if function.func in EXCHANGED:
            yield expression.xreplace({function: EXCHANGED[function.func](*function.args)})
