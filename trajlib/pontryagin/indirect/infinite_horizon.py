"""Linear plants with a quadratic cost and an infinite horizon, by the Riccati equation.

y' = A y + B u, J = int_0^oo (y^T G y + 2 y^T C u + u^T N u) dt. With the stabilising solution S the
control is u = K y, the least cost y*^T S y*, and completing the square shows that no control that
brings the state to zero costs less. H = 0 along the process, with psi = -2 S y.

Terminal equations y = 0 mean that the state tends to zero. Without them every control is admissible:
S is then the least solution S >= 0, and states that the cost does not contain need not decay.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, cast

import numpy as np
import sympy as sp

from trajlib.pontryagin.indirect.drawing import draw_extremal
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.problem.errors import PontryaginError, Unbounded
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.problem.steps import Hypothesis, Method
from trajlib.pontryagin.verification.certificate import certify

# Time constants after which a decaying mode has vanished among rounding errors.
DECAYED = 40
# Exponent beyond which a growing mode is not followed.
LARGEST = 300
# Terms of the exponential series at 1/2: the next is 1/(2^15 15!), about 2e-17.
TERMS = 14
PROOF = "a linear plant, a quadratic cost, and the solution of the Riccati equation"
EXPECTED = (
    "duration: an infinite horizon is provided for y' = A y + B u with a cost of the second degree in "
    "(y, u), positive definite in u, without bounds, constraints and a terminal cost; the initial state "
    "is given, and terminal are no equations or y = 0. Write the deviations from the equilibrium, or "
    "give a finite duration"
)


@dataclass(frozen=True)
class _Quadratic:
    """The matrices of y' = A y + B u and of the density y^T G y + 2 y^T C u + u^T N u."""

    A: np.ndarray
    B: np.ndarray
    G: np.ndarray
    C: np.ndarray
    N: np.ndarray


def solve_infinite_horizon(problem: Statement) -> Extremal:
    """Return the extremal of a linear-quadratic problem with an infinite horizon.

    Raises `ValueError` for other problems, `Unbounded` if the cost has no lower bound, and
    `PontryaginError` if no law has the least cost for all initial states.
    """
    # With it, all of the packages of filters and regulators are loaded.
    from trajlib.feedback.quadratic_cost import lqr

    if problem.parameters:
        names = ", ".join(map(str, problem.parameters))
        raise ValueError(f"solve: no value for {names}; give values by problem.subs({{...}})")
    plant, convex = _read(problem)
    stable = bool(problem.terminal) or not convex
    regulator = lqr(plant.A, plant.B, plant.G, plant.N, plant.C, stable=stable)
    if not regulator:
        error = PontryaginError if convex else Unbounded
        raise error(
            f"the infinite horizon has no optimal law for all initial states: {regulator.reason}"
        )
    S, K = (np.asarray(matrix, dtype=float) for matrix in (regulator.cost, regulator.gain))
    start = np.array([float(value) for value in problem.initial.values()])
    sign, k = -1 if problem.maximise else 1, len(problem.control)
    kind = "interior" if k == 1 else ("interior",) * k
    return InfiniteHorizonExtremal(
        problem=problem,
        cost=float(sign * start @ S @ start),
        duration=np.inf,
        arcs=((kind, 0.0, np.inf),),
        multiplier=1.0,
        terminal_multipliers=(0.0,) * len(problem.terminal),
        residual=float(regulator.residual or 0.0),
        jumps=(),
        _numeric=cast(Any, None),
        _shot=cast(Any, None),
        _proof=PROOF + ("" if not stable else ", among the controls that bring the state to zero"),
        plant=plant,
        riccati=S,
        gain=K,
    )


def _read(problem):
    """Return (`_Quadratic`, whether the cost is convex); raises ValueError for other problems."""
    y, u = list(problem.state), list(problem.control)
    zero, arguments = dict.fromkeys([*y, *u], 0), [*y, *u]
    running = -problem.running if problem.maximise else problem.running
    field, form = sp.Matrix(problem.field), sp.hessian(running, arguments) / 2
    slopes, n = field.jacobian(arguments), len(y)
    N = form[n:, n:]
    vector = sp.Matrix(arguments)
    targets = sp.Matrix(problem.terminal).jacobian(y) if problem.terminal else sp.eye(n)
    if (
        slopes.free_symbols
        or form.free_symbols
        or targets.free_symbols
        or any(field.subs(zero))
        or sp.expand(running - (vector.T * form * vector)[0]) != 0
        or problem.final != 0
        or problem.constrained
        or problem.first_return
        or None in problem.initial.values()
        or any(pair != (-sp.oo, sp.oo) for pair in problem.controls.values())
        or any(g.subs(zero) != 0 for g in problem.terminal)
        or targets.rank() < n
        or not N.is_positive_definite
    ):
        raise ValueError(EXPECTED)
    slopes, values = (np.array(part.evalf(), dtype=float) for part in (slopes, form))
    plant = _Quadratic(slopes[:, :n], slopes[:, n:], values[:n, :n], values[:n, n:], values[n:, n:])
    return plant, bool(form.is_positive_semidefinite)


@dataclass(frozen=True, eq=False, repr=False)
class InfiniteHorizonExtremal(Extremal):
    """An extremal y' = (A + B K) y for all times t >= 0.

    `plant`: the matrices of the problem; `riccati`, `gain`: S, (n, n), and K, (k, n).
    """

    plant: _Quadratic | None = None
    riccati: np.ndarray | None = None
    gain: np.ndarray | None = None

    def state(self, t):
        """Return the state at given times t >= 0, as `Extremal.state`."""
        return self._shaped(t, self._states(t))

    def costate(self, t):
        """Return the costate -2 S y at given times t >= 0, as `Extremal.costate`."""
        return self._shaped(t, -2 * self.riccati @ self._states(t))

    def control(self, t):
        """Return the control K y at given times t >= 0, as `Extremal.control`."""
        return self._shaped(t, self.gain @ self._states(t))

    def switching(self, t):
        """Return dH/du at given times t >= 0, as `Extremal.switching`."""
        y, plant = self._states(t), self.plant
        u, psi = self.gain @ y, -2 * self.riccati @ y
        return self._shaped(t, plant.B.T @ psi - 2 * (plant.N @ u + plant.C.T @ y))

    def path_multiplier(self, t):
        """Return an array without rows: there are no path constraints."""
        return self._shaped(t, np.zeros((0, len(self._times(t)))))

    def hamiltonian(self, t):
        """Return H at given times t >= 0, as `Extremal.hamiltonian`."""
        y, plant = self._states(t), self.plant
        u, psi = self.gain @ y, -2 * self.riccati @ y
        density = np.sum(y * (plant.G @ y + 2 * plant.C @ u), axis=0)
        density += np.sum(u * (plant.N @ u), axis=0)
        values = np.sum(psi * (plant.A @ y + plant.B @ u), axis=0) - density
        return float(values[0]) if np.ndim(t) == 0 else values

    def plot(self, axes=None):
        """Draw the process until it has settled, as `Extremal.plot`."""
        arcs = ((self.arcs[0][0], 0.0, self._settled),)
        return draw_extremal(replace(self, duration=self._settled, arcs=arcs), axes)

    def certificate(self, points=None, proved=False):
        """Return evidence until the process has settled, as `Extremal.certificate`.

        By then y = 0, or psi = 0 if no terminal equations are given, up to rounding errors.
        """
        if proved:
            raise ValueError("proved: not provided for an infinite horizon")
        end = self._settled
        # Fast modes need short panels, in the beginning only.
        sections = [end / 2.0**j for j in range(self._halvings, 0, -1)]
        evidence = certify(
            replace(self.problem, duration=sp.Rational(end)),
            self.state,
            self.costate,
            self.control,
            end,
            sections,
            points=points,
        )
        return replace(evidence, optimality=self.optimality)

    @cached_property
    def _eigenvalues(self):
        return np.linalg.eigvals(self.plant.A + self.plant.B @ self.gain)

    @cached_property
    def _settled(self):
        """The time after which all decaying modes have vanished among rounding errors."""
        rates = self._eigenvalues.real
        fastest = np.max(np.abs(self._eigenvalues), initial=0.0)
        decays = -rates[rates < -1e-12 * fastest]
        end = DECAYED / np.min(decays) if len(decays) else 1 / (fastest or 1.0)
        return float(min(end, LARGEST / max(np.max(rates), 1e-300)))

    @cached_property
    def _halvings(self):
        return max(
            1, int(np.ceil(np.log2(max(2.0, self._settled * np.max(np.abs(self._eigenvalues))))))
        )

    def _states(self, t):
        start = np.array([float(value) for value in self.problem.initial.values()])
        return (_exponentials(self.plant.A + self.plant.B @ self.gain, self._times(t)) @ start).T

    def _times(self, t):
        times = np.atleast_1d(np.asarray(t, dtype=float))
        if times.ndim != 1:
            raise ValueError(
                f"t: expected a number or a one-dimensional array, got shape {times.shape}"
            )
        if not np.all((times >= 0) & np.isfinite(times)):
            raise ValueError("t: expected finite times t >= 0")
        return times

    def _shaped(self, t, values):
        return values[:, 0] if np.ndim(t) == 0 else values


def _exponentials(matrix, times):
    """Return e^(M t), (N, n, n), by scaling and squaring, for many times at once.

    SciPy's function takes one matrix after another, each in several threads.
    """
    size = np.linalg.norm(matrix, 1) * times
    halvings = np.ceil(np.log2(np.maximum(size, 0.5))).astype(int) + 1
    result = np.empty((len(times), *matrix.shape))
    for count in np.unique(halvings):
        group = halvings == count
        scaled = matrix * (times[group] / 2.0**count)[:, None, None]
        power = np.broadcast_to(np.eye(len(matrix)), scaled.shape)
        for term in range(TERMS, 0, -1):
            power = np.eye(len(matrix)) + scaled @ power / term
        for _ in range(count):
            power = power @ power
        result[group] = power
    return result


RICCATI = Method(
    "Riccati equation",
    "The stabilising solution of the Riccati equation gives the optimal law and the least cost.",
    "Kalman 1960; trajlib.pontryagin.indirect.infinite_horizon",
    (Hypothesis("the horizon is infinite", lambda p: p.duration == sp.oo),),
    solve_infinite_horizon,
)
