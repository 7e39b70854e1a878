"""Costs with |u|: the control is split, u = p - q with p, q >= 0, and |u| = p + q.

Every admissible u is such a pair with p q = 0 and the same cost. So the best pair is the best
control, provided that its p and q are never positive at once; where the cost rewards |u| this
fails, and the problem is refused.
"""

from dataclasses import dataclass, fields, replace

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.process import DirectProcess
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.problem.errors import WrongStructure
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.problem.steps import Hypothesis, Reformulation

REWARDED_MESSAGE = (
    "the cost rewards the absolute value of a control: p and q with u = p - q are positive at "
    "once, so that p + q is not |u|. State the problem without Abs."
)


@dataclass(frozen=True)
class L1Split:
    """A problem with pairs of controls in place of those with |u| in the cost.

    Attributes
    ----------
    original, problem : Statement
        Before and after.
    parts : tuple of tuple of int
        For each control of the original the indices of its parts.
    pairs : dict
        {u: (p, q)}.
    """

    original: Statement
    problem: Statement
    parts: tuple[tuple[int, ...], ...]
    pairs: dict[sp.Symbol, tuple]

    def arc(self, kind):
        """Return the kinds of the pairs on an arc of the original: "zero" where u = 0."""
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
        """Return the kinds of the original on an arc of the pairs."""
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
        """Return the arcs of the pairs for arcs of the original."""
        if structure is None or isinstance(structure, str):
            return structure
        return [self.arc(kind) for kind in structure]

    def guess(self, guess):
        """Return a guess for the pairs from one for the original."""
        if isinstance(guess, (SplitExtremal, DirectProcess)):
            return guess.inner or guess
        if not isinstance(guess, dict):
            return guess
        result = {key: value for key, value in guess.items() if key not in self.pairs}
        for u, pair in self.pairs.items():
            if u in guess:
                result |= {part: _positive(guess[u], sign) for part, sign in zip(pair, (1, -1))}
        return result

    def differences(self, values, factor=1.0):
        """Return factor (p - q) for the rows of the pairs, and the other rows as they are."""
        return np.array(
            [
                factor * (values[columns[0]] - values[columns[1]])
                if len(columns) == 2
                else values[columns[0]]
                for columns in self.parts
            ]
        )

    def restore(self, extremal: Extremal) -> "SplitExtremal":
        """Return the extremal of the original from one of the pairs."""
        values = {f.name: getattr(extremal, f.name) for f in fields(Extremal)}
        values |= {
            "problem": self.original,
            "arcs": tuple((self.joined(kind), begin, end) for kind, begin, end in extremal.arcs),
        }
        return SplitExtremal(**values, inner=extremal, split=self)


def _kinks(problem):
    """Return the controls u with |u| in the running cost."""
    return {e.args[0] for e in problem.running.atoms(sp.Abs)} & set(problem.control)


def split_l1_controls(problem: Statement) -> L1Split:
    """Split the controls u with |u| in the running cost."""
    kinks = _kinks(problem)
    values: dict = {}
    controls: dict = {}
    pairs: dict = {}
    parts, zero = [], sp.Integer(0)
    sign = -1 if problem.maximise else 1
    for u, (low, high) in problem.controls.items():
        first = len(controls)
        if u not in kinks or low >= zero or high <= zero:
            controls[u] = low, high
            values[sp.Abs(u)] = sp.Abs(u) if u not in kinks else u if low >= zero else -u
        else:
            if (sign * sp.expand(problem.running).coeff(sp.Abs(u))).is_negative:
                raise WrongStructure(REWARDED_MESSAGE)
            # Messages show the names.
            pairs[u] = p, q = sp.Symbol(f"max({u}, 0)"), sp.Symbol(f"max(-{u}, 0)")
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
    """An extremal of a problem with |u| in its cost, u = 0 on an arc "zero".

    `inner`: the extremal of the pairs.
    """

    inner: Extremal | None = None
    split: L1Split | None = None

    def state(self, t):
        """Return the state at given times, as `Extremal.state`."""
        return self.inner.state(t)

    def costate(self, t):
        """Return the costate at given times, as `Extremal.costate`."""
        return self.inner.costate(t)

    def path_multiplier(self, t):
        """Return the multipliers of the path constraints, as `Extremal.path_multiplier`."""
        return self.inner.path_multiplier(t)

    def hamiltonian(self, t):
        """Return H at given times, as `Extremal.hamiltonian`."""
        return self.inner.hamiltonian(t)

    def control(self, t):
        """Return the controls p - q at given times, as `Extremal.control`."""
        return self.split.differences(self.inner.control(t))

    def switching(self, t):
        """Return the switching functions without the term of |u|."""
        return self.split.differences(self.inner.switching(t), 1 / 2)

    def certificate(self, points=None, proved=False):
        """Return evidence for the extremal of the pairs, as `Extremal.certificate`."""
        return self.inner.certificate(points, proved)

    @property
    def optimality(self):
        """What is known of the extremal of the pairs, as `Extremal.optimality`."""
        return self.inner.optimality


def _positive(value, sign):
    """Return the positive part of a guess or of its negative."""
    if callable(value):
        return lambda t: max(sign * float(value(t)), 0.0)
    return np.maximum(sign * np.asarray(value, dtype=float), 0.0)


ABSOLUTE_VALUES = Reformulation(
    "|u| in the running cost",
    "u = p - q with p, q >= 0, and |u| = p + q.",
    "trajlib.pontryagin.indirect.l1_control",
    (Hypothesis("the running cost contains |u| of a control", lambda p: bool(_kinks(p))),),
    split_l1_controls,
    L1Split.structure,
    L1Split.guess,
    L1Split.restore,
    lambda split, _states, controls: split.differences(controls),
    lambda split: ", ".join(f"{u} = {p} - {q}" for u, (p, q) in split.pairs.items()),
)
