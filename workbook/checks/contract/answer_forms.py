"""The forms in which students keep answers: vectors as lists, rows, columns, arrays, and so on."""

import sys

import numpy as np
import sympy as sp

#: What an answer is called that is of another kind than asked; the first that fits.
KINDS = (
    ((bool, np.bool_), "a truth value"),
    (str, "a text: leave its quotation marks out"),
    ((int, float, complex, np.number), "a number"),
    (sp.MatrixBase, "a matrix"),
    (np.ndarray, "an array"),
    (sp.Lambda, "an `sp.Lambda`"),
    (sp.Expr, "an expression"),
    (sp.logic.boolalg.Boolean, "a condition"),
    ((sp.Set, set, frozenset), "a set"),
    ((list, tuple, sp.Tuple), "a list"),
    (dict, "a dict: give its values alone"),
)


def vector_entries(answer):
    """Return the components of a vector in any of its usual forms, or None if it is none."""
    answer = unwrapped(answer)
    if isinstance(answer, np.ndarray):
        return list(answer.ravel()) if is_vector(answer) else None
    if isinstance(answer, sp.MatrixBase):
        return list(answer) if is_vector(answer) else None
    if isinstance(answer, dict):
        return list(answer.values())
    if isinstance(answer, (list, tuple, sp.Tuple)):
        nested = [vector_entries(entry) for entry in answer]
        if nested and all(entry is not None and len(entry) == 1 for entry in nested):
            return [entry[0] for entry in nested]  # a column
        if len(nested) == 1 and nested[0] is not None:
            return nested[0]  # a row
        return list(answer)
    return None


def is_empty_list(answer):
    """Return whether an answer is the list of no numbers; a dict without entries is none."""
    return vector_entries(answer) == [] and not isinstance(answer, dict)


def is_vector(array):
    """Return whether an array or a matrix is a list of numbers: a row, a column, or empty."""
    return len(array.shape) <= 1 or bool({0, 1} & set(array.shape))


def unwrapped(answer):
    """Return a CasADi DM as an array and an array without axes as its entry."""
    casadi = sys.modules.get("casadi")
    if casadi is not None and isinstance(answer, casadi.DM):
        answer = answer.full()
    if isinstance(answer, np.ndarray) and answer.ndim == 0:
        return answer.item()
    return answer


def counted(number, noun):
    """Return a number with its noun, in the plural if there are several."""
    return f"{number} {noun}{'s' if number != 1 else ''}" if number is not None else f"{noun}s"


def kind_of(answer):
    """Return the kind of an answer in words, without calling its own repr."""
    if answer is None:
        return "None (was the value computed but not assigned?)"
    if callable(answer) and not isinstance(answer, sp.Basic):
        return "a function"
    words = (word for types, word in KINDS if isinstance(answer, types))
    return next(words, f"a value of type {type(answer).__name__}")


def has_logical_cases(answer):
    """Return whether a Piecewise in an answer has conditions as its values."""
    return any(
        is_logical(pair.expr) for piecewise in answer.atoms(sp.Piecewise) for pair in piecewise.args
    )


def is_logical(part):
    """Return whether it is a condition only; a symbol may be one and is an expression, too."""
    # a symbol is both
    return isinstance(part, sp.logic.boolalg.Boolean) and not isinstance(part, sp.Expr)
