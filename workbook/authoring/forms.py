"""Other forms of a right answer, which every answer of a type has: the same value as people and
programs write it.

`forms(value, kind, symbols)` gives them by name. A form changes what holds the parts of an answer
(a tuple for a list, a column, an array, a set), or how the parts are written (symbols without
assumptions, another order of operations, decimals where they count). Most do both, so that few
verdicts try many.
"""

import fractions
import functools
import itertools

import numpy as np
import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean, BooleanAtom

from workbook.checks.contract.encoding import encode


def forms(value, kind, symbols):
    """Return {name: the answer in this form}; every way to hold and to write its parts occurs.

    `symbols` are those of which a condition may be given as a set of values.
    """
    return dict(each_form(value, kind, symbols))


def each_form(value, kind, symbols):
    """Yield the pairs of `forms`, each computed when it is asked for."""
    for pair in itertools.zip_longest(
        *(changing(value, kind, symbols, ways) for ways in (WRITERS, HOLDERS))
    ):
        ways = list(filter(None, pair))
        yield ", ".join(ways), changed(value, kind, symbols, ways)


def changing(value, kind, symbols, ways):
    """Yield the names of the `ways` that change the value, each to something new."""
    seen = {encode(value)}
    for name in ways:
        other = encode(changed(value, kind, symbols, [name]))
        if other not in seen:
            seen.add(other)
            yield name


def changed(value, kind, symbols, names):
    for name in names:
        value = (
            HOLDERS[name](value, kind)
            if name in HOLDERS
            else _written(value, kind, WRITERS[name], symbols)
        )
    return value


def _written(value, kind, write, symbols):
    """Return the value with each of its parts written in another way."""
    if isinstance(value, (list, tuple)):
        return type(value)(_written(part, _inner(kind), write, symbols) for part in value)
    if isinstance(value, dict):
        return {
            write(key, "part", symbols): _written(part, "part", write, symbols)
            for key, part in value.items()
        }
    if isinstance(value, sp.MatrixBase):
        parts = [write(part, "part", symbols) for part in value]
        return sp.Matrix(*value.shape, parts) if parts != list(value) else value
    return value if isinstance(value, np.ndarray) else write(value, kind, symbols)


def _inner(kind):
    """Return the kind of the parts of a list."""
    return kind.removeprefix("list of ") if kind.startswith("list of ") else "part"


# What holds the parts.


def _nested(make):
    """Every list, tuple and matrix as `make` of its parts."""

    def hold(value, kind):
        if isinstance(value, sp.MatrixBase) and 0 not in value.shape:
            value = value.tolist()
        if isinstance(value, dict):
            return {key: hold(part, kind) for key, part in value.items()}
        return (
            make(hold(part, kind) for part in value) if isinstance(value, (list, tuple)) else value
        )

    return hold


def _each(hold_one):
    """The outer list of several stays; each of them is held by `hold_one`."""

    def hold(value, kind):
        if isinstance(value, (list, tuple)) and kind.startswith("list of "):
            return [hold(part, _inner(kind)) for part in value]
        if isinstance(value, dict):
            return {key: hold(part, "part") for key, part in value.items()}
        return hold_one(value, kind)

    return hold


def _array(value, kind):
    if isinstance(value, str):
        return np.array(value)
    if isinstance(value, sp.MatrixBase) and 0 not in value.shape:
        value = value.tolist()
    rows = [value] if _flat(value) else value
    if (
        not isinstance(rows, list)
        or not rows
        or not all(map(_flat, rows))
        or len(set(map(len, rows))) > 1
    ):
        return value
    numbers = all(type(part) in (int, float) for row in rows for part in row)
    return np.array(value, dtype=None if numbers else object)


def _sympy_array(value, kind):
    return (
        sp.Array(value)
        if _flat(value) or (isinstance(value, sp.MatrixBase) and 0 not in value.shape)
        else value
    )


def _column(value, kind):
    return sp.Matrix(list(value)) if _flat(value) and kind.startswith("vector") else value


def _row(value, kind):
    return sp.Matrix([list(value)]) if _flat(value) and kind.startswith("vector") else value


def _sparse(value, kind):
    return sp.SparseMatrix(value) if isinstance(value, sp.MatrixBase) else value


def _unordered(make):
    """Return the parts as a set, where their order does not matter."""

    def hold(value, kind):
        if not kind.startswith("set") or not isinstance(value, (list, tuple)):
            return value
        return make(tuple(part) if isinstance(part, list) else part for part in value)

    return hold


def _several(value, kind):
    return list(value.args) if isinstance(value, sp.And) and kind == "condition" else value


def _flat(value):
    return (
        isinstance(value, (list, tuple))
        and len(value) > 0
        and not any(
            isinstance(part, (list, tuple, dict, str, sp.MatrixBase, np.ndarray)) for part in value
        )
    )


HOLDERS = {
    "tuples": _nested(tuple),
    "lists": _nested(list),
    "arrays": _each(_array),
    "SymPy arrays": _each(_sympy_array),
    "columns": _each(_column),
    "rows": _each(_row),
    "sparse matrices": _each(_sparse),
    "a set": _unordered(set),
    "a set of SymPy": _unordered(lambda parts: sp.FiniteSet(*parts)),
    "backwards": _unordered(lambda parts: list(parts)[::-1]),
    "a list of conditions": _several,
}


# How a part is written.


def _plain(part, kind, symbols):
    return (
        part.xreplace({s: sp.Symbol(s.name) for s in part.free_symbols})
        if isinstance(part, sp.Basic)
        else part
    )


def _expression(rewrite):
    # to see whether it changes anything, beside other changes, of another answer
    rewritten = functools.cache(rewrite)

    def write(part, kind, symbols):
        return rewritten(part) if isinstance(part, sp.Expr) and part.free_symbols else part

    return write


def _rational(rewrite):
    """Return a writer that changes rational functions only."""
    return _expression(
        lambda part: rewrite(part) if part.is_rational_function(*part.free_symbols) else part
    )


def _float(part, kind, symbols):
    """Decimals with all the digits of a float."""
    if isinstance(part, (int, sp.Integer)) and not isinstance(part, bool):
        return float(part)
    if isinstance(part, sp.Expr) and part.is_number and part.is_finite:
        return float(part) if part.is_real else complex(part)
    if isinstance(part, sp.Basic):
        return part.xreplace({n: sp.Float(n) for n in part.atoms(sp.Rational) if not n.is_Integer})
    return part


def _three_digits(part, kind, symbols):
    """Return a number rounded to three digits."""
    number = isinstance(part, float) or (
        isinstance(part, sp.Expr) and part.is_number and part.is_real and part.is_finite
    )
    return float(f"{float(part):.3g}") if number and kind == "number" else part


def _relations(rewrite):
    """Return a condition with each of its relations rewritten."""

    def write(part, kind, symbols):
        relations = (
            part.atoms(Relational) if isinstance(part, Boolean) and kind == "condition" else ()
        )
        return part.xreplace({r: rewrite(r) for r in relations}) if relations else part

    return write


def _values(part, kind, symbols):
    """The set of those values of the only symbol for which a condition holds."""
    if (
        not isinstance(part, Boolean)
        or kind != "condition"
        or len(symbols) != 1
        or part.free_symbols != set(symbols)
    ):
        return part
    return _as_set(part)


@functools.cache
def _as_set(condition):
    try:
        return condition.as_set()
    except NotImplementedError:  # SymPy cannot solve it
        return condition


def _word(part, kind, symbols):
    if kind == "yes/no":
        return "Yes" if part in (True, sp.true, "yes") else "No"
    return (
        part.title().replace(" ", "-")
        if isinstance(part, str) and kind.startswith("choice")
        else part
    )


def _truth(part, kind, symbols):
    """Python's for SymPy's, and SymPy's for Python's."""
    return (
        bool(part)
        if isinstance(part, BooleanAtom)
        else sp.sympify(part)
        if isinstance(part, bool)
        else part
    )


def _of_numpy(part, kind, symbols):
    kinds = {str: np.str_, bool: np.bool_, int: np.int64, float: np.float64}
    return kinds[type(part)](part) if type(part) in kinds and kind != "part" else part


def _fraction(part, kind, symbols):
    return fractions.Fraction(int(part.p), int(part.q)) if isinstance(part, sp.Rational) else part


WRITERS = {
    "plain symbols": _plain,
    "expanded": _expression(sp.expand),
    "factored": _rational(sp.factor),
    "over one denominator": _rational(sp.together),
    "floats": _float,
    "three digits": _three_digits,
    "negations": _relations(lambda r: sp.Not(r.negated, evaluate=False)),
    "turned round": _relations(lambda r: r.reversed),
    "on one side": _relations(lambda r: r.func(r.lhs - r.rhs, 0) if r.rhs.is_finite else r),
    "a set of values": _values,
    "words": _word,
    "truths": _truth,
    "NumPy's numbers": _of_numpy,
    "fractions": _fraction,
}
