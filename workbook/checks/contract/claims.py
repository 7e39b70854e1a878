"""Claims: the types as which checks read answers.

Under `@judged(Expression("state", "parameters"))` a check gets a SymPy expression in the symbols of
its data `state` and `parameters`, or is not called at all.

The names are those of the check's own arguments, `system.A` for what a record among them holds, or
functions of the data; the symbols that occur in these are the ones an answer may hold. What else a
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
    """Base class of claims: an answer of one type.

    Parameters
    ----------
    *names : str or callable
        Data, by name or as functions of all data, whose symbols the answer may hold.
    **form
        Arguments of `coerce`; strings and callables stand for data, too.

    Notes
    -----
    A derived class defines `coerce(answer, symbols, **form)`.
    """

    def __init__(self, *names, **form):
        self.names, self.form = names, form

    def read(self, answer, data):
        """Return an answer in the form of this claim.

        Parameters
        ----------
        answer : object
            The decoded answer.
        data : dict
            The arguments of the check, by name.

        Raises
        ------
        Invalid
            If the answer is of another type.
        """
        form = {
            name: _datum(value, data) if callable(value) or isinstance(value, str) else value
            for name, value in self.form.items()
        }
        named = [_datum(name, data) for name in self.names]
        return self.coerce(answer, list(dict.fromkeys(symbols_in(named))), **form)


class Expression(Claim):
    """One SymPy expression."""

    coerce = staticmethod(coercion.as_expression)


class Expressions(Claim):
    """A list of expressions.

    Notes
    -----
    It has the `length` given or that of a datum. Of length 1 the expression itself is accepted, and
    with `names` a dict with these keys.
    """

    @staticmethod
    def coerce(answer, symbols, length=None, names=()):
        answer = in_order(answer, names) if names else answer
        length = length if length is None else _size(length)
        single = length == 1 and isinstance(answer, (sp.Expr, numbers.Number))
        return coercion.as_expressions([answer] if single else answer, symbols, length)


class Matrix(Claim):
    """A matrix of the `shape` given or of that of a datum; of shape 1 x 1 also an expression."""

    @staticmethod
    def coerce(answer, symbols, shape=None):
        shape = getattr(shape, "shape", shape)
        if shape == (1, 1) and isinstance(answer, (sp.Expr, Boolean, numbers.Number, str)):
            return sp.ImmutableMatrix([[coercion.as_expression(answer, symbols)]])
        return coercion.as_matrix(answer, symbols, shape)


class MatrixOrVector(Claim):
    """A matrix of the `shape` given; a row may be written as a column and a column as a row.

    Notes
    -----
    Of shape 1 x 1 an expression is accepted, too.
    """

    @staticmethod
    def coerce(answer, symbols, shape):
        if shape == (1, 1):
            return Matrix.coerce(answer, symbols, shape)
        other_shapes = [shape[::-1]] if 1 in shape else []
        matrix = coercion.as_matrix(answer, symbols, shape, *other_shapes)
        return matrix if matrix.shape == shape else matrix.T


class Vectors(Claim):
    """A list of vectors of the `size` given or that of a datum.

    Notes
    -----
    Also accepted: a set of them, a matrix whose columns they are. With `names` a vector may be a dict.
    """

    @staticmethod
    def coerce(answer, symbols, size, names=()):
        return vectors(answer, _size(size), symbols, names)


class Values(Claim):
    """Any number of expressions in any order, as a list or a set.

    Parameters
    ----------
    *names : str or callable
        As for `Claim`.
    expected : str
        Description of the answer for a student.

    Notes
    -----
    A dict of SymPy's `eigenvals` counts as the values that it names, whatever their multiplicities.
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
    """A condition on symbols."""

    coerce = staticmethod(condition_coercion.as_condition)


class Number(Claim):
    """A real number."""

    coerce = staticmethod(lambda answer, symbols: coercion.as_number(answer))


class Integer(Claim):
    """A whole number."""

    coerce = staticmethod(lambda answer, symbols: coercion.as_integer(answer))


class YesNo(Claim):
    """Yes or no, as a bool or a word."""

    coerce = staticmethod(lambda answer, symbols: coercion.as_yes_no(answer))


class Choice(Claim):
    """One of the `words`, which may be the keys of a datum."""

    coerce = staticmethod(lambda answer, symbols, words: coercion.as_choice(answer, tuple(words)))


class Parts(Claim):
    """A list of a fixed number of parts, each of a type of its own.

    Parameters
    ----------
    *parts : Claim
        The types of the parts.
    expected : str
        Description of the answer for a student.
    """

    def __init__(self, *parts, expected):
        self.parts, self.expected = parts, expected

    def read(self, answer, data):
        if not isinstance(answer, (list, tuple)) or len(answer) != len(self.parts):
            raise Invalid(f"expected {self.expected}")
        return [part.read(value, data) for part, value in zip(self.parts, answer)]


class Table(Claim):
    """A dict, read as a list of pairs (key, value).

    Parameters
    ----------
    key, value : Claim
        The types of all keys and of all values.
    expected : str or callable
        Description of the answer for a student, or a function of the data that returns it.
    """

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
    """Return a datum by its name, a field of one (`system.A`), or a function of the data."""
    if callable(name):
        return name(data)
    first, *parts = name.split(".")
    return functools.reduce(getattr, parts, data[first])


def _size(counted):
    """Return a number of entries: itself, or that of a list or the rows of a matrix."""
    return (
        counted
        if isinstance(counted, int)
        else counted.rows
        if isinstance(counted, sp.MatrixBase)
        else len(counted)
    )


def symbols_in(part):
    """Return the symbols in data, in the order of lists; those of an expression by name."""
    if isinstance(part, sp.Symbol):
        return [part]
    if isinstance(part, (list, tuple, dict)):
        return [symbol for item in part for symbol in symbols_in(item)]
    return [] if part is None else sorted(sp.sympify(part).free_symbols, key=str)
