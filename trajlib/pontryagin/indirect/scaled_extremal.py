"""Extremals that were found in other units than the user's."""

from dataclasses import dataclass, fields, replace

import numpy as np

from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.problem.scaling import Scaling, natural_units
from trajlib.pontryagin.problem.steps import Hypothesis, Reformulation


@dataclass(frozen=True, eq=False, repr=False)
class ScaledExtremal(Extremal):
    """An extremal in the user's units.

    `inner`: the extremal in those of the `scaling`; `weight`: c in psi = (c/s) Psi, the unit of the
    cost but for lambda_0 = 0.
    """

    inner: Extremal | None = None
    scaling: Scaling | None = None
    weight: float = 1.0

    def state(self, t):
        """Return the state at given times, as `Extremal.state`."""
        return self._scaled(self.inner.state, t, self.scaling.states)

    def costate(self, t):
        """Return the costate at given times, as `Extremal.costate`."""
        return self._scaled(self.inner.costate, t, [self.weight / s for s in self.scaling.states])

    def control(self, t):
        """Return the controls at given times, as `Extremal.control`."""
        return self._scaled(self.inner.control, t, self.scaling.controls)

    def switching(self, t):
        """Return dH/du at given times, as `Extremal.switching`."""
        pace = self.weight / float(self.scaling.time)
        return self._scaled(self.inner.switching, t, [pace / r for r in self.scaling.controls])

    def path_multiplier(self, t):
        """Return the multipliers of the path constraints, as `Extremal.path_multiplier`."""
        pace = self.weight / float(self.scaling.time)
        units = [pace / float(unit) for unit in self.scaling.path]
        return self._scaled(self.inner.path_multiplier, t, units)

    def hamiltonian(self, t):
        """Return H at given times, as `Extremal.hamiltonian`."""
        pace = self.weight / float(self.scaling.time)
        return pace * self.inner.hamiltonian(self._inner_times(t))

    @property
    def optimality(self):
        """What is known of the extremal, as `Extremal.optimality`."""
        return (
            replace(self.inner, _proof=self._proof).optimality
            if self._proof
            else self.inner.optimality
        )

    def _scaled(self, function, t, units):
        values = function(self._inner_times(t))
        return (values.T * np.array(units, dtype=float)).T

    def _inner_times(self, t):
        times = np.minimum(self._times(t) / float(self.scaling.time), self.inner.duration)
        return times[0] if np.ndim(t) == 0 else times


def _scaled_guess(scaling, guess):
    """Return a guess (duration, states, controls) in other units; None for none."""
    if guess is None:
        return None
    duration, states, controls = guess
    return (
        duration / float(scaling.time),
        states / np.array(scaling.states, dtype=float),
        controls / np.array(scaling.controls, dtype=float),
    )


def restore_units(scaling: Scaling, extremal: Extremal) -> ScaledExtremal:
    """Return the extremal in the user's units."""
    time, cost = float(scaling.time), float(scaling.cost)
    weight = cost
    if not extremal.normal:
        units = np.array(scaling.states, dtype=float)
        weight = 1 / float(np.linalg.norm(extremal.costate(0) / units))
    values = {f.name: getattr(extremal, f.name) for f in fields(Extremal)}
    values |= {
        "problem": scaling.original,
        "cost": extremal.cost * cost + float(scaling.constant_cost),
        "duration": extremal.duration * time,
        "arcs": tuple((kind, begin * time, end * time) for kind, begin, end in extremal.arcs),
        "jumps": tuple(
            (
                scaling.original.path[index := scaling.problem.path.index(relation)],
                instant * time,
                nu * weight / float(scaling.path[index]),
            )
            for relation, instant, nu in extremal.jumps
        ),
        "terminal_multipliers": tuple(
            value * weight / float(unit)
            for value, unit in zip(extremal.terminal_multipliers, scaling.terminal)
        ),
    }
    return ScaledExtremal(**values, inner=extremal, scaling=scaling, weight=weight)


def _description(scaling):
    units = dict(
        zip(
            (*scaling.original.state, *scaling.original.control),
            (*scaling.states, *scaling.controls),
        )
    )
    units |= {"t": scaling.time, "J": scaling.cost}
    shown = [f"{name} in units of {float(unit):.6g}" for name, unit in units.items() if unit != 1]
    if scaling.constant_cost != 0:
        shown.append(f"J without the constant {float(scaling.constant_cost):.6g}")
    return ", ".join(shown)


NATURAL_UNITS = Reformulation(
    "natural units",
    "y = s Y, u = r U, t = tau t', J = c J' + J_0 with units in which all terms are about 1 in size.",
    "trajlib.pontryagin.problem.scaling",
    (
        Hypothesis(
            "the terms differ much from 1 in size, or the cost has a constant part or factor",
            lambda p: natural_units(p) is not None,
        ),
    ),
    natural_units,
    lambda _scaling, structure: structure,
    _scaled_guess,
    restore_units,
    lambda scaling, _states, controls: (controls.T * np.array(scaling.controls, dtype=float)).T,
    _description,
)
