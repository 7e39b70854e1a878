"""The types as which checks read answers: under `@judged(Expression("state", "parameters"))` a check is handed a SymPy
expression in the symbols of its data `state` and `parameters`, or is not called at all.

The names are those of the check's own arguments; the symbols that stand in these are the ones an answer may hold. What
depends on the data otherwise is written as a function of them: `Matrix("A", shape=lambda data: data["A"].shape)`.
"""

import sympy as sp

from trajlib.checks.contract import coercion


class Claim:
    """An answer of one type; `read` gives it in this form, or raises `Invalid`."""

    def __init__(self, *names, **form):
        self.names, self.form = names, form

    def read(self, answer, data):
        form = {name: value(data) if callable(value) else value for name, value in self.form.items()}
        return self.coerce(answer, list(dict.fromkeys(symbols_in([data[name] for name in self.names]))), **form)


class Expression(Claim):
    coerce = staticmethod(coercion.as_expression)


class Expressions(Claim):
    """A list of expressions of the `length` given."""

    coerce = staticmethod(coercion.as_expressions)


class Matrix(Claim):
    """A matrix of the `shape` given."""

    coerce = staticmethod(coercion.as_matrix)


class ConditionOn(Claim):
    coerce = staticmethod(coercion.as_condition)


class Number(Claim):
    coerce = staticmethod(lambda answer, symbols: coercion.as_number(answer))


class Integer(Claim):
    coerce = staticmethod(lambda answer, symbols: coercion.as_integer(answer))


def symbols_in(part):
    """The symbols in data: lists in their order, what is written with symbols in that of their names, dicts by their
    keys."""
    if isinstance(part, sp.Symbol):
        return [part]
    if isinstance(part, (list, tuple, dict)):
        return [symbol for one in part for symbol in symbols_in(one)]
    return [] if part is None else sorted(sp.sympify(part).free_symbols, key=str)
