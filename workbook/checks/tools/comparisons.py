"""What a check yields: comparisons of an answer with the truth.

`judged` does them one after the other. Here the answer gets its values, has to be finite there, is
compared to the precision that `contract.tolerance` knows, and the first difference is told with its
place. What a comparison found on the way it gives back: `said = yield Entries(...)`.

- `Same`: an expression has a value, `Entries`: a matrix has its entries, at values of the symbols.
- `Agrees`: a condition is as true as a property, at values of the symbols.
- `Members`: of several things all are named and no more.
- `Word`: a word is the right one of those offered.
- `Follows`: two sides of a law are equal.
"""

import cmath
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp

from workbook.checks.contract.tolerance import EXACT, agree, in_decimals
from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.values import matrix_at, truth_at, uncertain_at, value_at
from workbook.checks.tools.wording import apart, rounded_text


@dataclass
class Same:
    """An expression has the value `true` of the quantity `what`; `size` is that of the terms, which
    may cancel. A value that is `constant`, the same for all values of the symbols, is not told: it
    would be the answer itself."""

    claim: sp.Expr
    true: float
    what: str
    values: dict
    size: float = 0.0
    computed: float = EXACT
    constant: bool = False

    def judge(self):
        said = value_at(self.claim, self.values, self.what)
        if not cmath.isfinite(self.true):
            raise RuntimeError(f"{self.what} could not be computed")
        if not agree(
            said,
            self.true,
            self.claim,
            self.size,
            self.computed,
            uncertain_at(self.claim, self.values),
        ):
            if self.constant or not self.values:
                raise Wrong(f"{self.what} is another number than {said:.4g}")
            true, said = apart(self.true, said)
            raise Wrong(
                f"for {rounded_text(self.values)}, {self.what} is {true}; your expression gives "
                f"{said}"
            )


@dataclass
class Entries:
    """A matrix has the entries `true`; `size` is that of the terms of each, of each row, or of all.

    `told(said, i, j)` is the message on the worst entry of the first wrong row. Gives back the
    numbers said.
    """

    claim: sp.MatrixBase
    true: np.ndarray
    told: Callable
    values: dict
    size: np.ndarray | float = 0.0
    computed: float = EXACT

    def judge(self):
        said, true = matrix_at(self.claim, self.values), np.asarray(self.true)
        uncertain = (
            [
                [uncertain_at(self.claim[i, j], self.values) for j in range(self.claim.cols)]
                for i in range(self.claim.rows)
            ]
            if in_decimals(*self.claim)
            else None
        )
        right = agree(said, true, self.claim, self.size, self.computed, uncertain)
        if not right.all():
            row = int(np.argmin(right.all(axis=1)))
            raise Wrong(
                self.told(said, row, int(np.argmax(abs(said[row] - true[row]) * ~right[row])))
            )
        return said


@dataclass
class Agrees:
    """A condition is as `true` as the property; `told` says how it is there."""

    claim: sp.Basic
    true: bool
    told: str
    values: dict

    def judge(self):
        if truth_at(self.claim, self.values) != self.true:
            raise Wrong(
                f"for {rounded_text(self.values)} {self.told}, yet your condition "
                f"{'fails' if self.true else 'holds'}"
            )


@dataclass
class Members:
    """Of `true` things all are named and no more, in any order; `fits(one, other)` says whether one
    named is another.

    `stranger(one)` is the message on one that belongs not, `missing(count, others)` that on so many
    named where others are left out, `twice(one)` that on one named before; without it things may be
    named again. Gives back what the named ones are.
    """

    said: list
    true: list
    fits: Callable
    stranger: Callable
    missing: Callable
    twice: Callable | None = None

    def judge(self):
        found, left = [], list(range(len(self.true)))
        for one in self.said:
            near = [k for k, other in enumerate(self.true) if self.fits(one, other)]
            if not near:
                raise Wrong(self.stranger(one))
            if self.twice and not set(near) & set(left):
                raise Wrong(self.twice(one))
            left = [k for k in left if k not in (near[:1] if self.twice else near)]
            found.append(self.true[near[0]])
        if left:
            raise Wrong(self.missing(len(self.true) - len(left), [self.true[k] for k in left]))
        return found


@dataclass
class Word:
    """A word is the `true` one. The reason is told either way, after the words `contrary` if it is
    not, and given back.
    """

    claim: object
    true: object
    reason: str
    contrary: str = ""

    def judge(self):
        if self.claim != self.true:
            raise Wrong(self.contrary + self.reason)
        return self.reason


@dataclass
class Follows:
    """Two sides of a law, numbers or arrays of them, are equal up to a `share` of the `size` of
    their terms.

    `told(k)` is the message, with the place of the largest difference where there are several.
    """

    left: np.ndarray | complex
    right: np.ndarray | complex
    size: float
    told: Callable
    share: float = EXACT

    def judge(self):
        difference = abs(np.asarray(self.left) - self.right)
        if not (difference <= self.share * self.size).all() or not np.isfinite(self.size).all():
            raise Wrong(self.told(np.unravel_index(np.argmax(difference), difference.shape)))
