"""Costs with |u|: the control is split inside, u = p - q with p, q >= 0, and |u| = p + q.

Every admissible u is such a pair with p q = 0 and the same cost. So the best pair is the best
control, provided that its p and q are never positive at once; where the cost rewards |u| this
fails, and the problem is refused.
"""

from dataclasses import dataclass, fields, replace

import numpy as np
import sympy as sp

from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.problem.errors import WrongStructure
from trajlib.pontryagin.problem.statement import Statement

REWARDED_MESSAGE = (
    "the cost rewards the absolute value of a control: p and q with u = p - q are positive at "
    "once, so that p + q is not |u|. State the problem without Abs."
)


@dataclass(frozen=True)
class L1Split:
    """The `original` statement, the `problem` with pairs of controls in its place, `pairs` {u: (p, q)}.

    `parts`: for each control of the original the columns of its parts.
    """

    original: Statement
    problem: Statement
    parts: tuple
    pairs: dict

    def arc(self, kind):
        """The arc of the pairs for an arc of the statement: "zero" where u = 0."""
        kinds = (kind,) if isinstance(kind, str) else tuple(kind)
        pairs = {"u+": ("u+", "u-"), "u-": ("u-", "u+"), "zero": ("u-", "u-")}
        split = []
        for control_kind, columns in zip(kinds, self.parts):
            if len(columns) == 2 and control_kind not in pairs:
                raise ValueError(
                    f"structure: with |u| in the cost expected u-, zero or u+ for u, got {control_kind!r}"
                )
            split += pairs[control_kind] if len(columns) == 2 else [control_kind]
        return tuple(split)

    def joined(self, kind):
        """The arc of the statement for an arc of the pairs."""
        kinds = (kind,) if isinstance(kind, str) else kind
        result = []
        for columns in self.parts:
            control_kind = tuple(kinds[i] for i in columns)
            if len(control_kind) == 1:
                result += control_kind
            elif "u-" not in control_kind:
                raise WrongStructure(REWARDED_MESSAGE)
            else:
                p, q = control_kind
                result.append("zero" if p == q else p if q == "u-" else "u-" if q == "u+" else q)
        return result[0] if len(result) == 1 else tuple(result)

    def structure(self, structure):
        """The arcs of the pairs for the arcs of the statement."""
        if structure is None or isinstance(structure, str):
            return structure
        return [self.arc(kind) for kind in structure]

    def guess(self, guess):
        """A guess of the statement as one of the pairs."""
        if isinstance(guess, SplitExtremal):
            return guess.inner
        if not isinstance(guess, dict):
            return guess
        result = {key: value for key, value in guess.items() if key not in self.pairs}
        for u, pair in self.pairs.items():
            if u in guess:
                result |= {part: _positive(guess[u], sign) for part, sign in zip(pair, (1, -1))}
        return result

    def restore(self, extremal):
        """The extremal of the statement for one of the pairs: `SplitExtremal`."""
        values = {f.name: getattr(extremal, f.name) for f in fields(Extremal)}
        values |= {
            "problem": self.original,
            "arcs": tuple((self.joined(kind), begin, end) for kind, begin, end in extremal.arcs),
        }
        return SplitExtremal(**values, inner=extremal, split=self)


def split_l1_controls(problem):
    """`L1Split` of a problem whose running cost holds |u| of controls u alone; None for any other
    problem."""
    kinks = {e.args[0] for e in problem.running.atoms(sp.Abs)} & set(problem.control)
    if not kinks:
        return None
    values, controls, parts, pairs, zero = {}, {}, [], {}, sp.Integer(0)
    sign = -1 if problem.maximise else 1
    for u, (low, high) in problem.controls.items():
        first = len(controls)
        if u not in kinks or low >= zero or high <= zero:
            controls[u] = low, high
            values[sp.Abs(u)] = sp.Abs(u) if u not in kinks else u if low >= zero else -u
        else:
            if (sign * sp.expand(problem.running).coeff(sp.Abs(u))).is_negative:
                raise WrongStructure(REWARDED_MESSAGE)
            pairs[u] = p, q = sp.symbols(f"{u}_+ {u}_-", cls=sp.Dummy)
            controls |= {p: (zero, high), q: (zero, -low)}
            values |= {sp.Abs(u): p + q, u: p - q}
        parts.append(tuple(range(first, len(controls))))
    return L1Split(
        problem,
        replace(
            problem,
            running=problem.running.subs(values),
            controls=controls,
            dynamics={y: f.subs(values) for y, f in problem.dynamics.items()},
        ),
        tuple(parts),
        pairs,
    )


@dataclass(frozen=True, eq=False, repr=False)
class SplitExtremal(Extremal):
    """An extremal of a problem with |u| in its cost; on an arc "zero" u = 0. `inner`: the extremal
    of the pairs."""

    inner: Extremal | None = None
    split: L1Split | None = None

    def control(self, t):
        return self._joined(self.inner.control(t), lambda p, q: p - q)

    def switching(self, t):
        """Half the difference of the slopes for p and q: the switching function without the term of
        |u|."""
        return self._joined(self.inner.switching(t), lambda p, q: (p - q) / 2)

    def certificate(self, points=None, proved=False):
        return self.inner.certificate(points, proved)

    @property
    def optimality(self):
        return self.inner.optimality

    def _joined(self, values, join):
        return np.array(
            [
                join(*values[list(columns)]) if len(columns) == 2 else values[columns[0]]
                for columns in self.split.parts
            ]
        )


def _positive(value, sign):
    if callable(value):
        return lambda t: max(sign * float(value(t)), 0.0)
    return np.maximum(sign * np.asarray(value, dtype=float), 0.0)
