"""What an answer is, whatever its form: bytes that are the same for all forms of it, and for hardly
anything else.

Expressions become their values at places, conditions their truth at many more. Numbers are put into
cells of a logarithmic scale. One that lies close to an end of its cell counts for the next one too,
so that rounding never makes two answers of one: an answer has several signatures, of which the
first is its own.
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
    NoValue,
    Walk,
    condition_places,
    expression_places,
    law_places,
)

#: Longer answers, as bytes of their encoding, are like nothing: they would take too long.
LONGEST = 100_000
#: The width of a cell and how far rounding may move a number: where all digits are given, and where
#: three.
FINE, THREE_DIGITS = (1e-4, 1e-8), (1.2e-2, 5.2e-3)
#: Of so many numbers each may lie at the end of its cell; in an answer of more of them all digits
#: count.
FEW = 6
#: The time in which controls are asked for.
TIME = sp.Symbol("t", real=True)
#: What is a smaller share of the largest number beside it is what rounding leaves of zero.
NOTHING = 1e-12


class Unlike(Exception):
    """An answer of another kind than was asked, or one that has no values at places."""


@dataclass(frozen=True)
class Question:
    """What an answer is read as: its kind, and {name: assumption} of the symbols it may hold, in
    their order.

    In a kind that ends in "basis" a list of vectors counts by what it spans.
    """

    kind: str
    symbols: dict


def signatures(value, question):
    """The signatures of an answer, its own first; raises `Unlike`."""
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            if len(encode(value)) > LONGEST:
                raise Unlike("too long")
            found = [_in_cells(part, question) for part in _layouts(value, question.kind)]
    except (
        Invalid,
        EncodingError,
        NoValue,
        ArithmeticError,
        AttributeError,
        TypeError,
        ValueError,
    ) as error:
        raise Unlike from error
    for shape, cells in found:
        doubtful = [k for k, cell in enumerate(cells) if len(cell) > 1][:FEW]
        for chosen in itertools.product(*(cells[k] for k in doubtful)):
            taken = [cell[0] for cell in cells]
            for k, cell in zip(doubtful, chosen):
                taken[k] = cell
            yield json.dumps(_filled(shape, taken)).encode()


def _in_cells(value, question):
    reading = _Reading(question)
    return reading.in_cells(reading.read(value, question.kind))


def in_cases(value, kind):
    """Arcs [value, until], which stand for an expression in the time, as cases in a list; empty for
    anything else. The end of the last arc is that of the motion, of which an expression says
    nothing."""
    arcs = (
        _rows(value)
        if kind == "expression" and isinstance(value, (list, tuple, np.ndarray, sp.MatrixBase))
        else []
    )
    if not arcs or any(len(arc) != 2 or any(isinstance(part, str) for part in arc) for arc in arcs):
        return []
    return [sp.Piecewise(*((held, TIME < until) for held, until in arcs[:-1]), (arcs[-1][0], True))]


def _layouts(value, kind):
    """The answer, arcs also as cases, and where a list without rows stands for a matrix the one row
    that it may be instead of a column."""
    yield value
    yield from in_cases(value, kind)
    if (
        kind == "matrix"
        and isinstance(value, (list, tuple, np.ndarray))
        and not any(
            isinstance(part, (list, tuple, np.ndarray, sp.MatrixBase, sp.Tuple)) for part in value
        )
    ):
        yield [list(value)]


class _Reading:
    """Reads an answer into its shape: strings, lists, and tuples for sets, around arrays of numbers
    at places."""

    def __init__(self, question):
        self._symbols, self._constant = question.symbols, True
        self._places = law_places if question.kind == "law" else expression_places

    def read(self, value, kind):
        if kind == "yes/no":
            return str(coercion.as_yes_no(value))
        if kind == "integer":
            return str(coercion.as_integer(value))
        if kind == "condition":
            return self._truths(value)
        if kind == "equation":
            return self._numbers(
                [[value.lhs - value.rhs if isinstance(value, sp.Eq) else value]], _in_ratio
            )
        if kind.endswith("basis") and not isinstance(value, dict):
            return self._numbers(_vectors(value), _spanned)
        if kind == "dict basis":
            return tuple([self._told(key), self.read(part, "basis")] for key, part in value.items())
        if kind == "matrix":
            return [[self._told(part) for part in row] for row in _rows(value)]
        if kind in ("set", "list of vector"):
            return tuple(map(self._told, _listed(value)))
        if kind.startswith("list of "):
            return [self.read(part, kind.removeprefix("list of ")) for part in _listed(value)]
        return self._told(value)

    def _told(self, value):
        """The shape of what says itself what it is; a column and a row are a list."""
        if isinstance(value, str):
            return " ".join(value.lower().replace("-", " ").replace("_", " ").split())
        if isinstance(value, dict):
            return tuple([self._told(key), self._told(part)] for key, part in value.items())
        if isinstance(value, (list, tuple, np.ndarray, sp.MatrixBase, sp.Tuple)):
            return [self._told(part) for row in _rows(value) for part in row]
        if isinstance(value, (bool, sp.logic.boolalg.Boolean)) and not isinstance(value, sp.Symbol):
            return self._truths(value)
        return self._numbers([[value]])

    def _truths(self, value):
        """What a condition says at the places, as a hash."""
        known = [
            sp.Symbol(name, **{assumed or "real": True}) for name, assumed in self._symbols.items()
        ]
        numbers = isinstance(value, sp.Set) and not value.has(sp.ConditionSet, sp.ProductSet)
        condition = condition_coercion.as_condition(value, known[:1] if numbers else known)
        holds = np.broadcast_to(Walk(condition_places, self._symbols)(condition), CONDITION)
        return hashlib.sha256(np.packbits(holds).tobytes()).hexdigest()

    def _numbers(self, rows, made=lambda values: values):
        """The values of expressions in rows at the places, which are the last axis."""
        expressions = [
            [
                sp.sympify(part.expr if isinstance(part, sp.Lambda) else part, strict=True)
                for part in row
            ]
            for row in rows
        ]
        if any(not isinstance(part, sp.Expr) for row in expressions for part in row):
            raise Unlike("no expression")
        self._constant &= not any(part.free_symbols for row in expressions for part in row)
        walk, count = Walk(self._places, self._symbols), len(self._places("", ""))
        values = [np.broadcast_to(walk(part), count) for row in expressions for part in row]
        return made(
            np.array(values, dtype=complex).reshape(len(rows), len(rows and rows[0]), count)
        )

    def in_cells(self, shape):
        """The shape with an index in the place of every number, and the cells that each of them may
        be in."""
        arrays = [array[..., :1] if self._constant else array for array in _arrays(shape)]
        numbers = np.concatenate([np.zeros(0), *(array.ravel() for array in arrays)])
        width = THREE_DIGITS if self._constant and len(numbers) <= FEW else FINE
        nothing = NOTHING * np.max(abs(numbers), initial=0, where=np.isfinite(numbers))
        cells = [
            _cells(x, nothing, *width) for number in numbers for x in (number.real, number.imag)
        ]
        return _indexed(shape, iter(arrays), itertools.count()), cells


def _arrays(shape):
    if isinstance(shape, np.ndarray):
        yield shape
    elif isinstance(shape, (list, tuple)):
        for part in shape:
            yield from _arrays(part)


def _indexed(shape, arrays, counter):
    if isinstance(shape, np.ndarray):
        array = next(arrays)
        return [str(array.shape), *(next(counter) for _ in range(2 * array.size))]
    if isinstance(shape, (list, tuple)):
        return type(shape)([_indexed(part, arrays, counter) for part in shape])
    return shape


def _filled(shape, cells):
    """The shape with its cells; the parts of a set in an order of their own, and each once."""
    if isinstance(shape, int):
        return cells[shape]
    if isinstance(shape, list):
        return [_filled(part, cells) for part in shape]
    if isinstance(shape, tuple):
        return ["set", *sorted({json.dumps(_filled(part, cells)) for part in shape})]
    return shape


def _cells(number, nothing, width, moved):
    """The cell of a real number on a logarithmic scale, and the next one if it lies close to it."""
    if not math.isfinite(number):
        return ["no number"]
    if abs(number) <= nothing:
        return ["0"]
    place, sign = math.log(abs(number)) / width + 0.3819, "+" if number > 0 else "-"
    own, near = math.floor(place), moved / width
    return [
        f"{sign}{cell}"
        for cell, close in (
            (own, True),
            (own - 1, place - own < near),
            (own + 1, own + 1 - place < near),
        )
        if close
    ]


def _in_ratio(values):
    """Values up to a common factor."""
    known = values[np.isfinite(values) & (abs(values) > NOTHING)]
    return values / known[0] if known.size else values


def _spanned(values):
    """The reduced rows of a matrix at every place; rows that hang on others become zero."""
    found = np.moveaxis(values, -1, 0).copy()
    for matrix in found:
        row = 0
        for column in range(matrix.shape[1]):
            if row == len(matrix):
                break
            pivot = row + np.argmax(abs(matrix[row:, column]))
            if not abs(matrix[pivot, column]) > NOTHING * abs(matrix).max():
                continue
            matrix[[row, pivot]] = matrix[[pivot, row]]
            matrix[row] /= matrix[row, column]
            matrix[:row] -= np.outer(matrix[:row, column], matrix[row])
            matrix[row + 1 :] -= np.outer(matrix[row + 1 :, column], matrix[row])
            row += 1
    return np.moveaxis(found, 0, -1)


def _listed(value):
    """The parts of a list in any of its forms."""
    if isinstance(value, sp.MatrixBase):
        return list(value) if 1 in value.shape else value.tolist()
    if isinstance(value, (list, tuple, set, frozenset, np.ndarray, sp.FiniteSet, sp.Tuple)):
        return list(value)
    if value is sp.S.EmptySet:
        return []
    raise Unlike("no list")


def _rows(value):
    if isinstance(value, (sp.MatrixBase, np.ndarray)):
        value = value.tolist()
    if not isinstance(value, (list, tuple, sp.Tuple)):
        raise Unlike("no rows")
    return [list(row) if isinstance(row, (list, tuple, sp.Tuple)) else [row] for row in value]


def _vectors(value):
    """The vectors of a basis: lists of them, columns, and the columns of one matrix."""
    if isinstance(value, sp.MatrixBase):
        return value.T.tolist()
    return [
        list(part)
        if isinstance(part, sp.MatrixBase)
        else [entry for row in _rows(part) for entry in row]
        for part in _listed(value)
    ]
