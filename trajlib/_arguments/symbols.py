"""Reading of symbols, expressions and vector fields."""

from collections.abc import Iterable, Mapping

import numpy as np
import sympy as sp

from trajlib._arguments.arrays import brief


def read_symbols(symbols, name):
    """Return `symbols` as a tuple of distinct SymPy symbols; one symbol alone is allowed."""
    if isinstance(symbols, sp.Symbol):
        symbols = (symbols,)
    if isinstance(symbols, str) or not isinstance(symbols, Iterable):
        raise TypeError(f"{name}: expected SymPy symbols, got {symbols!r}")
    symbols = tuple(symbols)
    non_symbols = [s for s in symbols if not isinstance(s, sp.Symbol)]
    if non_symbols:
        raise TypeError(f"{name}: expected SymPy symbols, got {non_symbols[0]!r}")
    if len(set(symbols)) < len(symbols):
        raise ValueError(f"{name}: the same symbol stands twice in {list(symbols)}")
    return symbols


def read_expression(expression, name):
    """Return `expression` as a SymPy expression; text, which would be evaluated, is refused."""
    if isinstance(expression, str):
        raise TypeError(f"{name}: expected a SymPy expression, got the text {expression!r}")
    try:
        # Not strict, SymPy would evaluate the text that shows an object.
        result = sp.sympify(expression, strict=True)
    except (sp.SympifyError, TypeError, AttributeError, ValueError):
        result = None
    # NumPy's durations are integers to SymPy, and its masked entry is zero.
    no_number = isinstance(expression, np.timedelta64) or expression is np.ma.masked
    if no_number or not isinstance(result, sp.Expr):
        raise TypeError(f"{name}: expected a SymPy expression or a number, got {brief(expression)}")
    if result.has(sp.nan, sp.zoo):
        raise ValueError(f"{name}: {result} is not defined")
    return result


def read_expressions(values, length, name):
    """Return a list, vector or flat array as a tuple of `length` SymPy expressions."""
    # A SymPy matrix is a sequence of its entries, but no instance of Iterable.
    if isinstance(values, (str, Mapping)) or not isinstance(values, (Iterable, sp.MatrixBase)):
        raise TypeError(f"{name}: expected a list of {length} expressions, got {values!r}")
    shape = getattr(values, "shape", None)
    if shape is not None and len(shape) == 2 and 1 not in shape:
        raise ValueError(
            f"{name}: expected a vector of length {length}, got a matrix of shape {tuple(shape)}"
        )
    flat = values.ravel() if hasattr(values, "ravel") else values
    result = tuple(read_expression(value, name) for value in flat)
    if len(result) != length:
        raise ValueError(
            f"{name}: expected {length} components, one for each state variable, got {len(result)}"
        )
    return result


def read_field(field, state):
    """Return the right-hand sides and the state variables of x' = f(x) as tuples of one length."""
    state = read_symbols(state, "state")
    if not state:
        raise ValueError("state: expected at least one state variable")
    return read_expressions(field, len(state), "field"), state


def exact_decimals(expression):
    """Return the expression with each decimal as the number that was written: 0.1 as 1/10."""
    if not expression.has(sp.Float):
        return expression
    return expression.xreplace({f: sp.Rational(str(f)) for f in expression.atoms(sp.Float)})


def read_exact_expression(expression, name):
    """Return `expression` as a SymPy expression without decimals."""
    return exact_decimals(read_expression(expression, name))


def read_duration(value, name, floats=False):
    """Return a time that is not negative, an exact expression; with `floats` a number."""
    t = read_exact_expression(value, name)
    if t.is_negative or t.is_real is False or t.is_infinite or (floats and not t.is_number):
        or_symbol = "" if floats else " or a symbol"
        raise ValueError(f"{name}: expected a time that is not negative{or_symbol}, got {t}")
    return t


def join_names(symbols):
    """Return the names of symbols in alphabetical order, for a message."""
    return ", ".join(sorted(map(str, symbols)))
