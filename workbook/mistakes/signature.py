"""Compute form-independent signatures of answers: the same bytes for all forms of an answer.

Expressions are evaluated at sample points, conditions at many more. Numbers are put into bins of a
logarithmic scale. A number close to an end of its bin belongs to the next one too, so that rounding
never separates two forms: an answer has several signatures, of which the first is its own.
"""

import hashlib
import itertools
import json
import math
import warnings
from dataclasses import dataclass

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion, condition_coercion
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.traversal import EncodingError
from workbook.checks.contract.verdict import Invalid
from workbook.mistakes.sample_points import (
    CONDITION,
    Evaluator,
    NoValue,
    condition_points,
    expression_points,
    law_points,
)

#: Largest encoding of an answer with a signature, in bytes; longer ones would take too long.
MAX_BYTES = 100_000
#: Relative width of a bin and relative rounding error: with all digits, and with three.
FINE, THREE_DIGITS = (1e-4, 1e-8), (1.2e-2, 5.2e-3)
#: At most so many numbers are tried in two bins; answers with more numbers need all digits.
MAX_DOUBTFUL = 6
#: The argument of controls.
TIME = sp.Symbol("t", real=True)
#: Size relative to the largest number below which a number is zero.
RELATIVE_ZERO = 1e-12


class NoSignature(Exception):
    """An answer has another type than expected, or no values at points."""


@dataclass(frozen=True)
class AnswerType:
    """The type by which an answer is read.

    Attributes
    ----------
    kind : str
        TYPE of the answer; if it ends in "basis", lists of vectors are compared by their span.
    symbols : dict of str
        Assumptions ("", "positive" or "integer") of the symbols by name, in their order.
    """

    kind: str
    symbols: dict


def signatures(value, answer_type):
    """Return a form-independent signature of an answer, and those of its neighbours by rounding.

    Parameters
    ----------
    value
        The answer, as a check receives it.
    answer_type : AnswerType
        How it is read.

    Yields
    ------
    bytes
        The signatures, its own first.

    Raises
    ------
    NoSignature
        If the answer has another type, no values at points, or is too long.
    """
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            if len(encode(value)) > MAX_BYTES:
                raise NoSignature("too long")
            binned = [
                _to_bins(form, answer_type) for form in _interpretations(value, answer_type.kind)
            ]
    except (
        Invalid,
        EncodingError,
        NoValue,
        ArithmeticError,
        AttributeError,
        TypeError,
        ValueError,
    ) as error:
        raise NoSignature from error
    for structure, bins in binned:
        doubtful = [k for k, candidates in enumerate(bins) if len(candidates) > 1][:MAX_DOUBTFUL]
        for chosen in itertools.product(*(bins[k] for k in doubtful)):
            selected = [candidates[0] for candidates in bins]
            for k, bin_ in zip(doubtful, chosen):
                selected[k] = bin_
            yield json.dumps(_fill(structure, selected)).encode()


def _to_bins(value, answer_type):
    reader = _Reader(answer_type)
    return reader.to_bins(reader.read(value, answer_type.kind))


def arcs_as_piecewise(value, kind):
    """Return arcs [value, until] of a function of time as a list of one Piecewise, else [].

    The end of the last arc is the final time, which is not part of an expression.
    """
    arcs = (
        _rows(value)
        if kind == "expression" and isinstance(value, (list, tuple, np.ndarray, sp.MatrixBase))
        else []
    )
    if not arcs or any(len(arc) != 2 or any(isinstance(part, str) for part in arc) for arc in arcs):
        return []
    return [
        sp.Piecewise(
            *((expression, TIME < until) for expression, until in arcs[:-1]), (arcs[-1][0], True)
        )
    ]


def _interpretations(value, kind):
    """Yield the answer, arcs also as cases, and a flat list for a matrix also as its one row."""
    yield value
    yield from arcs_as_piecewise(value, kind)
    if (
        kind == "matrix"
        and isinstance(value, (list, tuple, np.ndarray))
        and not any(
            isinstance(part, (list, tuple, np.ndarray, sp.MatrixBase, sp.Tuple)) for part in value
        )
    ):
        yield [list(value)]


class _Reader:
    """Read an answer into a structure of strings, lists and tuples (for sets) around arrays.

    The last axis of an array belongs to the sample points.
    """

    def __init__(self, answer_type):
        self._symbols, self._constant = answer_type.symbols, True
        self._points = law_points if answer_type.kind == "law" else expression_points

    def read(self, value, kind):
        """Return the structure of an answer of a kind."""
        if kind == "yes/no":
            return str(coercion.as_yes_no(value))
        if kind == "integer":
            return str(coercion.as_integer(value))
        if kind == "condition":
            return self._read_condition(value)
        if kind == "equation":
            return self._read_expressions(
                [[value.lhs - value.rhs if isinstance(value, sp.Eq) else value]], _normalised
            )
        if kind.endswith("basis") and not isinstance(value, dict):
            return self._read_expressions(_vectors(value), _row_reduced)
        if kind == "dict basis":
            return tuple(
                [self._read_untyped(key), self.read(part, "basis")] for key, part in value.items()
            )
        if kind == "matrix":
            return [[self._read_untyped(part) for part in row] for row in _rows(value)]
        if kind in ("set", "list of vector"):
            return tuple(map(self._read_untyped, _elements(value)))
        if kind.startswith("list of "):
            return [self.read(part, kind.removeprefix("list of ")) for part in _elements(value)]
        return self._read_untyped(value)

    def _read_untyped(self, value):
        """Return the structure of a value by its own type; a column and a row are a list."""
        if isinstance(value, str):
            return " ".join(value.lower().replace("-", " ").replace("_", " ").split())
        if isinstance(value, dict):
            return tuple(
                [self._read_untyped(key), self._read_untyped(part)] for key, part in value.items()
            )
        if isinstance(value, (list, tuple, np.ndarray, sp.MatrixBase, sp.Tuple)):
            return [self._read_untyped(part) for row in _rows(value) for part in row]
        if isinstance(value, (bool, sp.logic.boolalg.Boolean)) and not isinstance(value, sp.Symbol):
            return self._read_condition(value)
        return self._read_expressions([[value]])

    def _read_condition(self, value):
        """Return a hash of the truth values of a condition at the points."""
        symbols = [
            sp.Symbol(name, **{assumption or "real": True})
            for name, assumption in self._symbols.items()
        ]
        is_set_of_numbers = isinstance(value, sp.Set) and not value.has(
            sp.ConditionSet, sp.ProductSet
        )
        condition = condition_coercion.as_condition(
            value, symbols[:1] if is_set_of_numbers else symbols
        )
        holds = np.broadcast_to(Evaluator(condition_points, self._symbols)(condition), CONDITION)
        return hashlib.sha256(np.packbits(holds).tobytes()).hexdigest()

    def _read_expressions(self, rows, transform=lambda values: values):
        """Return the values of rows of expressions, shape (rows, columns, points)."""
        expressions = [
            [
                sp.sympify(part.expr if isinstance(part, sp.Lambda) else part, strict=True)
                for part in row
            ]
            for row in rows
        ]
        if any(not isinstance(part, sp.Expr) for row in expressions for part in row):
            raise NoSignature("no expression")
        self._constant &= not any(part.free_symbols for row in expressions for part in row)
        evaluate, count = Evaluator(self._points, self._symbols), len(self._points("", ""))
        values = [np.broadcast_to(evaluate(part), count) for row in expressions for part in row]
        return transform(
            np.array(values, dtype=complex).reshape(len(rows), len(rows and rows[0]), count)
        )

    def to_bins(self, structure):
        """Return the structure with indices for numbers, and the possible bins of each number."""
        arrays = [array[..., :1] if self._constant else array for array in _arrays(structure)]
        numbers = np.concatenate([np.zeros(0), *(array.ravel() for array in arrays)])
        width = THREE_DIGITS if self._constant and len(numbers) <= MAX_DOUBTFUL else FINE
        zero = RELATIVE_ZERO * np.max(abs(numbers), initial=0, where=np.isfinite(numbers))
        bins = [_bins(x, zero, *width) for number in numbers for x in (number.real, number.imag)]
        return _with_indices(structure, iter(arrays), itertools.count()), bins


def _arrays(structure):
    if isinstance(structure, np.ndarray):
        yield structure
    elif isinstance(structure, (list, tuple)):
        for part in structure:
            yield from _arrays(part)


def _with_indices(structure, arrays, counter):
    if isinstance(structure, np.ndarray):
        array = next(arrays)
        return [str(array.shape), *(next(counter) for _ in range(2 * array.size))]
    if isinstance(structure, (list, tuple)):
        return type(structure)([_with_indices(part, arrays, counter) for part in structure])
    return structure


def _fill(structure, bins):
    """Return the structure with its bins; the elements of a set are sorted and occur once."""
    if isinstance(structure, int):
        return bins[structure]
    if isinstance(structure, list):
        return [_fill(part, bins) for part in structure]
    if isinstance(structure, tuple):
        return ["set", *sorted({json.dumps(_fill(part, bins)) for part in structure})]
    return structure


def _bins(number, zero, width, rounding):
    """Return the bin of a real number on a logarithmic scale, and the next one if it is close."""
    if not math.isfinite(number):
        return ["no number"]
    if abs(number) <= zero:
        return ["0"]
    position, sign = math.log(abs(number)) / width + 0.3819, "+" if number > 0 else "-"
    bin_index, margin = math.floor(position), rounding / width
    return [
        f"{sign}{index}"
        for index, is_possible in (
            (bin_index, True),
            (bin_index - 1, position - bin_index < margin),
            (bin_index + 1, bin_index + 1 - position < margin),
        )
        if is_possible
    ]


def _normalised(values):
    """Return values divided by the first that is not zero."""
    nonzero = values[np.isfinite(values) & (abs(values) > RELATIVE_ZERO)]
    return values / nonzero[0] if nonzero.size else values


def _row_reduced(values):
    """Return the reduced row echelon form of a matrix at every point."""
    matrices = np.moveaxis(values, -1, 0).copy()
    for matrix in matrices:
        row = 0
        for column in range(matrix.shape[1]):
            if row == len(matrix):
                break
            pivot = row + np.argmax(abs(matrix[row:, column]))
            if not abs(matrix[pivot, column]) > RELATIVE_ZERO * abs(matrix).max():
                continue
            matrix[[row, pivot]] = matrix[[pivot, row]]
            matrix[row] /= matrix[row, column]
            matrix[:row] -= np.outer(matrix[:row, column], matrix[row])
            matrix[row + 1 :] -= np.outer(matrix[row + 1 :, column], matrix[row])
            row += 1
    return np.moveaxis(matrices, 0, -1)


def _elements(value):
    """Return the elements of a list or set in any of its forms."""
    if isinstance(value, sp.MatrixBase):
        return list(value) if 1 in value.shape else value.tolist()
    if isinstance(value, (list, tuple, set, frozenset, np.ndarray, sp.FiniteSet, sp.Tuple)):
        return list(value)
    if value is sp.S.EmptySet:
        return []
    raise NoSignature("no list")


def _rows(value):
    if isinstance(value, (sp.MatrixBase, np.ndarray)):
        value = value.tolist()
    if not isinstance(value, (list, tuple, sp.Tuple)):
        raise NoSignature("no rows")
    return [list(row) if isinstance(row, (list, tuple, sp.Tuple)) else [row] for row in value]


def _vectors(value):
    """Return the vectors of a basis: a list of vectors, or the columns of one matrix."""
    if isinstance(value, sp.MatrixBase):
        return value.T.tolist()
    return [
        list(part)
        if isinstance(part, sp.MatrixBase)
        else [entry for row in _rows(part) for entry in row]
        for part in _elements(value)
    ]
