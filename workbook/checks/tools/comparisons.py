"""Comparisons of an answer with its reference, which a check yields.

`judged` runs them one after the other. Here symbols of the answer are given values, the answer has
to be finite there, is compared to the precision that `contract.tolerance` defines, and the first
difference raises `Wrong` with its position. A comparison returns what it computed:
`numbers = yield SameEntries(...)`.

- `SameValue`: an expression has a value, `SameEntries`: a matrix has its entries, at values of the
  symbols.
- `SameTruth`: a condition is as true as a property, at values of the symbols.
- `SameMembers`: of several things all are named and no more; `SameNumbers`: of several numbers.
- `SameWord`: a word is the right one of those offered.
- `SameSides`: two sides of an equation are equal.
"""

import cmath
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp

from workbook.checks.contract.tolerance import EXACT, REPEATED, agree, in_decimals
from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.values import (
    matrix_at,
    numbers_at,
    truth_at,
    uncertainty_at,
    value_at,
)
from workbook.checks.tools.wording import number_text, other_text, rounded_text, where_text


@dataclass
class SameValue:
    """An expression has the true value of a quantity.

    Parameters
    ----------
    claim : sympy.Expr
        The answer.
    true : float
        The true value.
    quantity : str
        The quantity, for the message.
    values : dict
        {symbol: value}.
    size : float
        The size of the terms, which may cancel.
    computed : float
        The relative precision of the true value.
    constant : bool
        Whether the value is the same for all values of the symbols; then it is not shown, since it
        would be the answer itself.
    """

    claim: sp.Expr
    true: float
    quantity: str
    values: dict
    size: float = 0.0
    computed: float = EXACT
    constant: bool = False

    def judge(self):
        value = value_at(self.claim, self.values, self.quantity)
        if not cmath.isfinite(self.true):
            raise RuntimeError(f"{self.quantity} could not be computed")
        if not agree(
            value,
            self.true,
            self.claim,
            self.size,
            self.computed,
            uncertainty_at(self.claim, self.values),
        ):
            if self.constant or not self.values:
                raise Wrong(f"{self.quantity} is not {value:.4g}, which your answer gives")
            raise Wrong(
                f"for {rounded_text(self.values)}, {other_text(self.quantity, value, self.true)}"
            )


@dataclass
class SameEntries:
    """A matrix has the true entries; returns its numbers.

    Parameters
    ----------
    claim : sympy.Matrix
        The answer.
    true : numpy.ndarray
        The true entries.
    message : callable
        `message(numbers, i, j)` is the message on the worst entry of the first wrong row.
    values : dict
        {symbol: value}.
    size : float or numpy.ndarray
        The size of the terms of each entry, of each row, or of all.
    computed : float
        The relative precision of the true entries.
    """

    claim: sp.MatrixBase
    true: np.ndarray
    message: Callable
    values: dict
    size: np.ndarray | float = 0.0
    computed: float = EXACT

    def judge(self):
        numbers, true = matrix_at(self.claim, self.values), np.asarray(self.true)
        uncertain = (
            [
                [uncertainty_at(self.claim[i, j], self.values) for j in range(self.claim.cols)]
                for i in range(self.claim.rows)
            ]
            if in_decimals(*self.claim)
            else None
        )
        right = agree(numbers, true, self.claim, self.size, self.computed, uncertain)
        if not right.all():
            row = int(np.argmin(right.all(axis=1)))
            raise Wrong(
                self.message(
                    numbers, row, int(np.argmax(abs(numbers[row] - true[row]) * ~right[row]))
                )
            )
        return numbers


@dataclass
class SameTruth:
    """A condition holds exactly where a property does.

    Parameters
    ----------
    claim : sympy.Basic
        The condition of the answer.
    true : bool
        Whether the property holds.
    message : str
        How it is there, for the message.
    values : dict
        {symbol: value}.
    """

    claim: sp.Basic
    true: bool
    message: str
    values: dict

    def judge(self):
        if truth_at(self.claim, self.values) != self.true:
            raise Wrong(
                f"for {rounded_text(self.values)} {self.message}, yet your condition "
                f"{'fails' if self.true else 'holds'}"
            )


@dataclass
class SameMembers:
    """The answer names all true members and no others, in any order; returns those matched.

    Parameters
    ----------
    claimed, true : list
        The members named in the answer and the true ones.
    matches : callable
        `matches(member, reference)`: whether a named member is a true one.
    extra : callable
        `extra(member)` builds the message on a named member that is none of the true ones.
    missing : callable
        `missing(count, unmatched)` builds the message if only `count` of the true members are named;
        `unmatched` are the others.
    repeated : callable, optional
        `repeated(member)` builds the message on a member named before; without it members may be
        named again.
    """

    claimed: list
    true: list
    matches: Callable
    extra: Callable
    missing: Callable
    repeated: Callable | None = None

    def judge(self):
        matched, unmatched = [], list(range(len(self.true)))
        for member in self.claimed:
            matches = [
                k for k, reference in enumerate(self.true) if self.matches(member, reference)
            ]
            if not matches:
                raise Wrong(self.extra(member))
            if self.repeated and not set(matches) & set(unmatched):
                raise Wrong(self.repeated(member))
            unmatched = [
                k for k in unmatched if k not in (matches[:1] if self.repeated else matches)
            ]
            matched.append(self.true[matches[0]])
        if unmatched:
            raise Wrong(
                self.missing(len(self.true) - len(unmatched), [self.true[k] for k in unmatched])
            )
        return matched


@dataclass
class SameNumbers:
    """Numbers are the true ones at values of the symbols, in any order.

    Parameters
    ----------
    claims : list of sympy.Expr
        The answer.
    true : list of complex
        The true numbers.
    extra, missing : str
        The messages on a number that is none of the true ones, and if one is not named, with
        `{number}` for that number and `{where}` for the values.
    values : dict
        {symbol: value}.
    size : float
        The size of the terms.
    """

    claims: list
    true: list
    extra: str
    missing: str
    values: dict
    size: float = 0.0

    def judge(self):
        names = [f"value {k}" for k in range(1, len(self.claims) + 1)]
        where = where_text(self.values)

        def matches(member, true):
            claim, number = member
            uncertain = uncertainty_at(claim, self.values)
            return agree(number, true, claim, self.size, REPEATED, uncertain)

        SameMembers(
            list(zip(self.claims, numbers_at(self.claims, self.values, names))),
            list(self.true),
            matches,
            lambda member: self.extra.format(number=number_text(member[1]), where=where),
            lambda *_: self.missing.format(where=where),
        ).judge()


@dataclass
class SameWord:
    """A word is the right one; returns the reason.

    Parameters
    ----------
    claim, true : object
        The word of the answer and the right one.
    reason : str
        The reason, which the message holds either way.
    prefix : str
        What precedes it in the message if the word is wrong.
    """

    claim: object
    true: object
    reason: str
    prefix: str = ""

    def judge(self):
        if self.claim != self.true:
            raise Wrong(self.prefix + self.reason)
        return self.reason


@dataclass
class SameSides:
    """Two sides of an equation are equal up to rounding.

    Parameters
    ----------
    left, right : complex or numpy.ndarray
        Their numbers.
    size : float
        The size of the terms.
    message : callable
        `message(k)` builds the message; k is the index of the largest difference.
    share : float
        The tolerance relative to the size.
    """

    left: np.ndarray | complex
    right: np.ndarray | complex
    size: float
    message: Callable
    share: float = EXACT

    def judge(self):
        difference = abs(np.asarray(self.left) - self.right)
        if not (difference <= self.share * self.size).all() or not np.isfinite(self.size).all():
            raise Wrong(self.message(np.unravel_index(np.argmax(difference), difference.shape)))
