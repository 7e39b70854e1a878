"""Checks of SymPy nodes that writing and reading share: names, sizes and arguments."""

import builtins
import math
import re
import unicodedata

import numpy as np
import sympy as sp
from sympy.core.assumptions import _assume_defined

from workbook.checks.contract.limits import MAX_DIGITS
from workbook.checks.contract.magnitude import MAX_EXPONENT, log2, size
from workbook.checks.contract.sympy_nodes import scalar

MAX_NAME = 100  # characters of a symbol's or function's name
# magnitude of anything without symbols, and the precision of a Float
NUMBER_BITS = int(MAX_DIGITS * math.log2(10))

# \w: letters of any language, digits, _; then accents, and what LaTeX needs
_NAME = re.compile(r"[\w\u0300-\u036f\\{}^*+\-,′ ]+")
_CALLABLE = {*dir(builtins), *dir(np)}


def check_name(walk, name):
    """Return the name of a symbol or function after checking its characters."""
    if not _NAME.fullmatch(walk.text(name, MAX_NAME)):
        raise walk.error(
            f"has the name {name!r}; names may have letters, digits, spaces and _ {{ }} ^ * + - , "
            "\\"
        )
    return name


def check_function_name(walk, name):
    """Return the name of a function that is none of Python's or NumPy's."""
    # Python reads identifiers in the form NFKC: a full-width `exec` is `exec`.
    words = re.findall(r"\w+", unicodedata.normalize("NFKC", check_name(walk, name)))
    if not _CALLABLE.isdisjoint(words):
        raise walk.error(
            f"is a function called {name!r}, as one of Python's or NumPy's is; choose another name"
        )
    return name


def check_assumptions(walk, assumptions):
    """Return a copy of assumptions, each of them one of SymPy's own, true or false."""
    if type(assumptions) is not dict:
        raise walk.error("should have its assumptions in a dict")
    for name, value in assumptions.items():
        if type(name) is not str or name not in _assume_defined or type(value) is not bool:
            raise walk.error("has an assumption that is not one of SymPy's")
    if assumptions.get("commutative") is False:
        raise walk.error("is a symbol that does not commute; commuting ones are allowed")
    return dict(assumptions)


def check_float(walk, magnitude, precision):
    """Refuse a Float of too many bits."""
    if not 1 <= walk.integer(precision) <= NUMBER_BITS or abs(magnitude) > NUMBER_BITS:
        raise walk.error(f"is a Float beyond {MAX_DIGITS} digits")


def spend_on_powers(walk, monomials):
    """Count the coefficients of a polynomial against the limit of values."""
    # SymPy stores all powers up to the highest, present or not.
    walk.spend(math.prod(1 + max(powers) for powers in zip(*monomials)))


def check_args(walk, row, args):
    """Refuse arguments that the node of this row does not take."""
    predicates = row.takes + (row.more,) * (len(args) - len(row.takes)) if row.more else row.takes
    if len(args) != len(predicates) or not all(
        accepts(arg) for accepts, arg in zip(predicates, args)
    ):
        types = ", ".join(type(arg).__name__ for arg in args[:4])
        raise walk.error(
            f"is {row.cls.__name__} of ({types}{', ...' * (len(args) > 4)}), which is not an answer"
        )
    if row.cls is sp.Interval:
        _check_interval(walk, *args)


def _check_interval(walk, start, end, left_open, right_open):
    # The constructor's checks, as far as numbers decide them.
    backwards = start.is_Number and end.is_Number and not start < end
    closed_at_infinity = (start is -sp.oo and left_open is sp.false) or (
        end is sp.oo and right_open is sp.false
    )
    if backwards or closed_at_infinity:
        raise walk.error("is an Interval whose ends are not in order, or closed at infinity")


def check_size(walk, node):
    """Refuse a number too large to work with."""
    if not scalar(node):
        return
    if isinstance(node, sp.Pow) and node.exp.is_Number and log2(node.exp) > math.log2(MAX_EXPONENT):
        raise walk.error(f"is a power with an exponent beyond {MAX_EXPONENT}")
    *bits, symbolic = size(node, walk.sizes)
    if not symbolic and not max(bits) <= NUMBER_BITS:
        raise walk.error(
            f"is a number with more than about {MAX_DIGITS} digits before or after the point"
        )
