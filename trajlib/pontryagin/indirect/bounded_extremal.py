"""Extremals of problems in which bounds of the controls depend on the state."""

from dataclasses import dataclass, fields

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.process import DirectProcess
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.problem.arcs import KINDS
from trajlib.pontryagin.problem.errors import WrongStructure
from trajlib.pontryagin.problem.state_bounds import StateBounds, with_constant_bounds
from trajlib.pontryagin.problem.steps import Hypothesis, Reformulation


@dataclass(frozen=True, eq=False, repr=False)
class BoundedExtremal(Extremal):
    """An extremal of a problem with bounds that depend on the state.

    `inner`: the extremal for controls between constant bounds.
    """

    inner: Extremal | None = None
    bounds: StateBounds | None = None

    def state(self, t):
        """Return the state at given times, as `Extremal.state`."""
        return self.inner.state(t)

    def costate(self, t):
        """Return the costate at given times, as `Extremal.costate`."""
        return self.inner.costate(t)

    def hamiltonian(self, t):
        """Return H at given times, as `Extremal.hamiltonian`."""
        return self.inner.hamiltonian(t)

    def path_multiplier(self, t):
        """Return the multipliers of the path constraints, as `Extremal.path_multiplier`."""
        return self.inner.path_multiplier(t)

    def control(self, t):
        """Return the controls at given times, as `Extremal.control`."""
        times = self._times(t)
        values = _restored_controls(self.bounds, self.state(times), self.inner.control(times))
        return values[:, 0] if np.ndim(t) == 0 else values

    def switching(self, t):
        """Return dH/du at given times, as `Extremal.switching`."""
        times = self._times(t)
        _, factor = self.bounds.values(self.state(times))
        values = self.inner.switching(times) / factor
        return values[:, 0] if np.ndim(t) == 0 else values

    @property
    def optimality(self):
        """What is known of the extremal, as `Extremal.optimality`."""
        return self.inner.optimality


def _restore_bounds(bounds: StateBounds, extremal: Extremal) -> BoundedExtremal:
    """Return the extremal of the original problem."""
    values = {f.name: getattr(extremal, f.name) for f in fields(Extremal)}
    turned = [factor == -1 for factor in bounds.factors]
    arcs = tuple((_kind(kind, turned), begin, end) for kind, begin, end in extremal.arcs)
    return BoundedExtremal(
        **values | {"problem": bounds.original, "arcs": arcs}, inner=extremal, bounds=bounds
    )


def _inner_structure(bounds: StateBounds, structure):
    """Return the arcs of the controls v for arcs of the original."""
    if structure is None or isinstance(structure, str):
        return structure
    turned = [factor == -1 for factor in bounds.factors]
    return [_kind(kind, turned) for kind in structure]


def _inner_guess(bounds: StateBounds, guess):
    """Return a guess for the controls v; only an extremal, a duration and states are of use."""
    if isinstance(guess, (BoundedExtremal, DirectProcess)):
        return guess.inner or guess
    if isinstance(guess, dict) and set(guess) & set(bounds.original.control):
        raise ValueError(
            "guess: with bounds that depend on the state expected the duration and states only"
        )
    return guess


def _kind(kind, turned):
    """Return the kinds with the bounds exchanged where u = b - v."""
    kinds = (kind,) if isinstance(kind, str) else tuple(kind)
    if len(kinds) != len(turned):
        raise WrongStructure(f"expected one of {', '.join(KINDS)} for each control, got {kind!r}")
    exchange = {"u-": "u+", "u+": "u-"}
    result = tuple(exchange.get(k, k) if t else k for k, t in zip(kinds, turned))
    return result[0] if isinstance(kind, str) else result


def _restored_controls(bounds, states, controls):
    offset, factor = bounds.values(states)
    return offset + factor * controls


def _description(bounds):
    pairs = zip(bounds.original.control, bounds.offsets, bounds.factors, bounds.problem.controls)
    return ", ".join(
        f"{u} = {offset + factor * sp.Symbol(v.name)}" for u, offset, factor, v in pairs if u != v
    )


STATE_BOUNDS = Reformulation(
    "bounds that depend on the state",
    "a(y) <= u <= b(y) becomes u = a + (b - a) v with 0 <= v <= 1; the costate stays the same.",
    "trajlib.pontryagin.problem.state_bounds",
    (Hypothesis("a bound of a control contains a state", lambda p: p.bounds_depend_on_state),),
    with_constant_bounds,
    _inner_structure,
    _inner_guess,
    _restore_bounds,
    _restored_controls,
    _description,
)
