"""The types as which checks read answers: under `@judged(Expression("state", "parameters"))` a
check is handed a SymPy expression in the symbols of its data `state` and `parameters`, or is not
called at all.

The names are those of the check's own arguments, `system.A` for what a record among them holds, or
functions of the data; the symbols that stand in these are the ones an answer may hold. What else a
type depends on is written as the name of a datum, of whose shape or length the answer is,
`Matrix("parameters", shape="A")`, or as a function of the data: `Expressions("times", length=lambda
data: data["A"].rows)`. Types of several parts are made of those of the parts: `Table(Number(),
Vectors(size="A"))`.
"""

import functools
import numbers

import sympy as sp
from sympy.logic.boolalg import Boolean

from workbook.checks.contract import coercion, condition_coercion
from workbook.checks.contract.members import NUMBERS, in_order, members, vectors
from workbook.checks.contract.verdict import Invalid


class Claim:
    """An answer of one type; `read` gives it in this form, or raises `Invalid`."""

    def __init__(self, *names, **form):
        self.names, self.form = names, form

    def read(self, answer, data):
        form = {
            name: _datum(value, data) if callable(value) or isinstance(value, str) else value
            for name, value in self.form.items()
        }
        named = [_datum(name, data) for name in self.names]
        return self.coerce(answer, list(dict.fromkeys(symbols_in(named))), **form)


class Expression(Claim):
    coerce = staticmethod(coercion.as_expression)


class Expressions(Claim):
    """A list of expressions, of the `length` given or as long as a datum; for a single one itself
    will do, and a dict for those of the `names` given."""

    @staticmethod
    def coerce(answer, symbols, length=None, names=()):
        answer = in_order(answer, names) if names else answer
        length = length if length is None else _size(length)
        single = length == 1 and isinstance(answer, (sp.Expr, numbers.Number))
        return coercion.as_expressions([answer] if single else answer, symbols, length)


class Matrix(Claim):
    """A matrix of the `shape` given or of that of a datum; of 1 x 1 an expression will do."""

    @staticmethod
    def coerce(answer, symbols, shape=None):
        shape = getattr(shape, "shape", shape)
        if shape == (1, 1) and isinstance(answer, (sp.Expr, Boolean, numbers.Number, str)):
            return sp.ImmutableMatrix([[coercion.as_expression(answer, symbols)]])
        return coercion.as_matrix(answer, symbols, shape)


class Laid(Claim):
    """A matrix of the `shape` given; a row or column may also be written the other way, and of 1 x
    1 an expression will do."""

    @staticmethod
    def coerce(answer, symbols, shape):
        found = Matrix.coerce(answer, symbols, shape if shape == (1, 1) else None)
        if 1 in shape and found.shape == shape[::-1]:
            found = found.T
        if found.shape != shape:
            raise Invalid(f"expected a matrix of shape {tuple(shape)}, got {found.shape}")
        return found


class Vectors(Claim):
    """A list of vectors of the `size` given or that of a datum: also a set of them, a matrix whose
    columns they are. For the `names` given a vector may be a dict."""

    @staticmethod
    def coerce(answer, symbols, size, names=()):
        return vectors(answer, _size(size), symbols, names)


class Values(Claim):
    """Any number of expressions in any order, as a list or a set; `expected` says so to a student.

    What SymPy's `eigenvals` gives counts as the values that it names, whatever their
    multiplicities.
    """

    def __init__(self, *names, expected):
        super().__init__(*names)
        self.expected = expected

    def coerce(self, answer, symbols):
        for multiplicity in answer.values() if isinstance(answer, dict) else ():
            coercion.as_integer(multiplicity)
        parts = members(
            list(answer) if isinstance(answer, dict) else answer, self.expected, single=NUMBERS
        )
        return [coercion.as_expression(part, symbols) for part in parts]


class ConditionOn(Claim):
    coerce = staticmethod(condition_coercion.as_condition)


class Number(Claim):
    coerce = staticmethod(lambda answer, symbols: coercion.as_number(answer))


class Integer(Claim):
    coerce = staticmethod(lambda answer, symbols: coercion.as_integer(answer))


class YesNo(Claim):
    coerce = staticmethod(lambda answer, symbols: coercion.as_yes_no(answer))


class Choice(Claim):
    """One of the `words`, which may be the keys of a datum."""

    coerce = staticmethod(lambda answer, symbols, words: coercion.as_choice(answer, tuple(words)))


class Parts(Claim):
    """A list of so many parts, each of a type of its own; `expected` says which."""

    def __init__(self, *parts, expected):
        self.parts, self.expected = parts, expected

    def read(self, answer, data):
        if not isinstance(answer, (list, tuple)) or len(answer) != len(self.parts):
            raise Invalid(f"expected {self.expected}")
        return [part.read(one, data) for part, one in zip(self.parts, answer)]


class Table(Claim):
    """A dict, read as a list of pairs (key, value), of a type each; `expected` says what it is."""

    def __init__(self, key, value, expected):
        self.key, self.value, self.expected = key, value, expected

    def read(self, answer, data):
        if not isinstance(answer, dict):
            raise Invalid(
                f"expected {self.expected(data) if callable(self.expected) else self.expected}"
            )
        return [
            (self.key.read(key, data), self.value.read(value, data))
            for key, value in answer.items()
        ]


def _datum(name, data):
    """A function of the data, a datum by its name, or what a record among them holds."""
    if callable(name):
        return name(data)
    first, *parts = name.split(".")
    return functools.reduce(getattr, parts, data[first])


def _size(given):
    """How many entries: a number, a list of them, or a square matrix of so many rows."""
    return (
        given
        if isinstance(given, int)
        else given.rows
        if isinstance(given, sp.MatrixBase)
        else len(given)
    )


def symbols_in(part):
    """The symbols in data: lists in their order, what is written with symbols in that of their
    names, dicts by their keys."""
    if isinstance(part, sp.Symbol):
        return [part]
    if isinstance(part, (list, tuple, dict)):
        return [symbol for one in part for symbol in symbols_in(one)]
    return [] if part is None else sorted(sp.sympify(part).free_symbols, key=str)
