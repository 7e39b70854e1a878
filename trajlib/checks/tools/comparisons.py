"""What a check yields: comparisons of an answer with the truth, each at values of the symbols.

`judged` does them one after the other. Here the answer gets its values, has to be finite and real there, is compared to
the precision that `contract.tolerance` knows, and the first difference is told with its place.
"""

import cmath
from dataclasses import dataclass

import sympy as sp

from trajlib.checks.contract.tolerance import EXACT, same
from trajlib.checks.contract.verdict import Wrong
from trajlib.checks.tools.values import truth_at, value_at
from trajlib.checks.tools.wording import rounded_text


@dataclass
class Same:
    """An expression has the value `true` of the quantity `what`; `size` is that of the terms, which may cancel."""

    claim: sp.Expr
    true: float
    what: str
    values: dict
    size: float = 0.0
    computed: float = EXACT

    def judge(self):
        said = value_at(self.claim, self.values, self.what)
        if not cmath.isfinite(self.true):
            raise RuntimeError(f"{self.what} could not be computed")
        if not same(said, self.true, self.claim, self.size, self.computed):
            raise Wrong(f"for {rounded_text(self.values)} {self.what} is {self.true:.4g}; "
                        f"your expression gives {said:.4g}")


@dataclass
class Agrees:
    """A condition is as `true` as the property; `told` says how it is there."""

    claim: sp.Basic
    true: bool
    told: str
    values: dict

    def judge(self):
        if truth_at(self.claim, self.values) != self.true:
            raise Wrong(f"for {rounded_text(self.values)} {self.told}, yet your condition "
                        f"{'fails' if self.true else 'holds'}")
