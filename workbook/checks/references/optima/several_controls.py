"""The fastest process with several controls, constant on a few arcs of free lengths.

No costates are used. Each arc has a length and its controls, within their bounds; the states are
followed in small steps. Of many random processes those that come closest to the target in a short
time are improved by IPOPT. Then a short arc with other controls is inserted wherever this saves
time, as long as possible; the best process counts. Processes whose controls vary on an arc are not
among those compared. The problem is a `pontryagin.Problem` in least time from a given start; only
its statement is used. A verdict compares 24 processes, which takes a second here; the search for arcs
of `direct_optimum` takes 0.3 s for each already with one control.
"""

import functools
import itertools
import math

import numpy as np
import sympy as sp

from trajlib._lazy import casadi as ca
from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.optima.direct_problem import IPOPT, DirectProblem
from workbook.checks.references.optima.optimum import SHORT, Optimum
from workbook.checks.references.optima.runge_kutta import rk4

#: Arcs at first and at most, and steps of each: where processes are only compared, and where they
#: are improved.
ARCS, MOST, QUICK, STEPS = 3, 5, 4, 12
#: So many random processes, so many of them improved, and so many values of the parameters.
TRIED, IMPROVED, CASES = 1500, 3, 24
#: No arc of a random process is longer than this.
LONGEST = 4.0
#: How often arcs are put in, of what length, and what a unit of it has to save.
ROUNDS, INSERTED, SAVED = 5, 1e-4, 1e-3
SOLVER = IPOPT | {"ipopt.tol": 1e-10, "ipopt.max_iter": 60}


class PiecewiseConstant(Optimum):
    """A fastest process with controls that are constant on arcs: (values, beginning, end)."""

    #: What an arc is worth that is too short to be put in, as a share.
    MISSED = 1e-5

    def __init__(self, lengths, controls):
        self.duration = self.cost = float(sum(lengths))
        ends = np.cumsum(lengths)
        self.arcs = [
            (u, end - h, end)
            for h, u, end in zip(lengths, controls, ends)
            if h > SHORT * self.duration
        ]

    def cost_size(self):
        """Return the size of the terms of the cost."""
        return self.duration


class SeveralControls(DirectProblem):
    """The search for the fastest process at values of the parameters."""

    def __init__(self, stated, names):
        super().__init__(stated, names)
        cost = self._running, self._final, self._duration, self._sign, self._returns
        if cost != (1, 0, None, 1, False) or None in self._initial:
            raise UnsuitableData(
                "with several controls the cost has to be the least time from a given start"
            )
        if not all(self._bounded):
            raise UnsuitableData("with several controls each has to have bounds")
        self._size, self._counts = len(self._controls), (len(self._state), len(names))
        # Made once, and kept with this search alone, so that they go when it goes.
        self._end_conditions, self._programme, self._arc = map(
            functools.cache, (self._end_conditions, self._programme, self._arc)
        )

    @staticmethod
    def cases(parameters):
        """Return values of the parameters: each takes values all over its interval."""
        random, columns = np.random.default_rng(19), []
        count = CASES if parameters else 1
        for domain in parameters.values():
            shares = (random.permutation(count) + random.uniform(size=count)) / count
            width = float(domain.sup) - float(domain.inf)
            step = sp.Integer(10) ** (math.floor(math.log10(width)) - 3)
            columns.append(
                [step * round(value / float(step)) for value in float(domain.inf) + width * shares]
            )
        return list(zip(*columns)) if parameters else [()]

    def best(self, case):
        """Return the best process found for values of the parameters."""
        random = np.random.default_rng(23)
        constants = np.array([*self._start(case, None), *case], dtype=float)
        bounds = np.array(self.bounds(case))
        shares = random.integers(0, 3, (TRIED, ARCS, self._size)) / 2
        lengths = LONGEST * random.uniform(size=(TRIED, ARCS)) ** 2
        candidates = np.concatenate(
            [lengths, (bounds[0] + np.ptp(bounds, axis=0) * shares).reshape(TRIED, -1)], axis=1
        )
        order = np.argsort(
            lengths.sum(axis=1) + 4 * np.linalg.norm(self._ends(candidates, constants), axis=1)
        )
        # No two guesses have the same controls at first.
        kinds = shares[order, 0] @ 3 ** np.arange(self._size)
        order, processes = order[np.sort(np.unique(kinds, return_index=True)[1])], []
        solved_count = 0
        for guess in candidates[order]:
            for _ in range(ROUNDS):
                process = self._improved(guess, constants, bounds)
                if process is None:
                    break
                processes.append(process[:2])
                guess = self._with_an_arc(*process, constants, bounds)
                if guess is None:
                    break
            solved_count += process is not None
            if solved_count == IMPROVED:
                break
        if not processes:
            raise RuntimeError("no process that satisfies the conditions was found")
        return PiecewiseConstant(*min(processes, key=lambda process: process[0].sum()))

    def _improved(self, guess, constants, bounds):
        """Return lengths, controls and the target's multipliers of IPOPT's optimum, or None."""
        count = len(guess) // (1 + self._size)
        solver, states = self._programme(count)
        lower, upper = (
            np.concatenate([np.full(count, end), np.tile(control_bound, count)])
            for end, control_bound in zip((0.0, np.inf), bounds)
        )
        guess, free = np.clip(guess, lower, upper), np.full(count * self._counts[0], np.inf)
        result = solver(
            x0=np.concatenate([guess, np.array(states(guess, constants)).ravel("F")]),
            p=constants,
            lbg=0,
            ubg=0,
            lbx=np.concatenate([lower, -free]),
            ubx=np.concatenate([upper, free]),
        )
        if solver.stats()["return_status"] != "Solve_Succeeded":
            return None
        optimum, multipliers = (np.array(result[name]).ravel() for name in ("x", "lam_g"))
        return (
            optimum[:count],
            optimum[count : len(guess)].reshape(count, self._size),
            multipliers[len(free) :],
        )

    def _with_an_arc(self, lengths, controls, multipliers, constants, bounds):
        """Return the process with the inserted arc that saves most, or None if none does."""
        arcs = [(h, u) for h, u in zip(lengths, controls) if h > SHORT * lengths.sum()]
        if len(arcs) >= MOST:
            return None
        end_conditions, best, chosen = self._ends(_packed(arcs)[None], constants), -SAVED, None
        # Between arcs, and inside of one, which it divides.
        for base, positions in (
            (arcs, range(len(arcs) + 1)),
            *(
                ([*arcs[:k], (h * share, u), (h * (1 - share), u), *arcs[k + 1 :]], [k + 1])
                for k, (h, u) in enumerate(arcs)
                for share in (0.5, 0.9)
            ),
        ):
            guesses = [
                _packed([*base[:position], (INSERTED, np.array(control)), *base[position:]])
                for position in positions
                for control in itertools.product(*bounds.T)
            ]
            changes = self._ends(np.array(guesses), constants) - end_conditions
            rates = 1 + changes @ multipliers / INSERTED
            if rates.min() < best:
                best, chosen = rates.min(), guesses[int(np.argmin(rates))]
        return None if chosen is None else np.where(chosen == INSERTED, 0.1 * lengths.sum(), chosen)

    def _ends(self, processes, constants):
        """Return the target's conditions at the end of each of many processes, a row each."""
        end_conditions = self._end_conditions(processes.shape[1] // (1 + self._size))
        return np.array(
            end_conditions(processes.T, np.repeat(constants[:, None], len(processes), axis=1))
        ).T

    def _end_conditions(self, arcs):
        """Return the target's conditions at the end of so many arcs, as a function."""
        process, constants = self._unknown(arcs)
        return ca.Function(
            "end_conditions",
            [process, constants],
            [self._target_gap(self._ends_of(process, constants, QUICK), constants)],
        )

    def _programme(self, arcs):
        """Return IPOPT's function for so many arcs, and the function of the states at their ends.

        The states at the ends are unknowns, too.
        """
        process, constants = self._unknown(arcs)
        y = ca.SX.sym("y", self._counts[0], arcs)
        arc_ends = self._ends_of(
            process, constants, STEPS, ca.horzcat(constants[: self._counts[0]], y[:, :-1])
        )
        programme = {
            "x": ca.vertcat(process, ca.vec(y)),
            "p": constants,
            "f": ca.sum1(process[:arcs]),
            "g": ca.vertcat(ca.vec(arc_ends - y), self._target_gap(y, constants)),
        }
        return (
            ca.nlpsol("several", "ipopt", programme, SOLVER),
            ca.Function("states", [process, constants], [self._ends_of(process, constants, STEPS)]),
        )

    def _unknown(self, arcs):
        """Return symbols of the lengths and controls of arcs, and of the start and the parameters."""
        return ca.SX.sym("x", arcs * (1 + self._size)), ca.SX.sym("p", sum(self._counts))

    def _ends_of(self, process, constants, steps, starts=None):
        """Return the states at the ends of arcs, a column each.

        They begin in the columns of `starts`, or each where the previous one ends.
        """
        arcs, n, y = process.numel() // (1 + self._size), self._counts[0], []
        controls = ca.reshape(process[arcs:], self._size, arcs)
        for k in range(arcs):
            begin = starts[:, k] if starts is not None else y[-1] if y else constants[:n]
            y.append(self._arc(steps)(begin, process[k], controls[:, k], constants[n:]))
        return ca.horzcat(*y)

    def _target_gap(self, states, constants):
        """Return the target's conditions in the last state."""
        return self.casadi_functions[2](states[:, -1], constants[self._counts[0] :])

    def _arc(self, steps):
        """Return the state at the end of an arc, by the Runge-Kutta method, as a function."""
        sizes = self._counts[0], 1, self._size, self._counts[1]
        y, length, u, p = map(ca.SX.sym, "yTup", sizes)

        def rates(_, z):
            return self.casadi_functions[0](z, u, [], p)[:-1]

        end = y
        for _ in range(steps):
            end = rk4(rates, 0, end, length / steps)
        return ca.Function("arc", [y, length, u, p], [end])


def _packed(parts):
    return np.concatenate([[h for h, _ in parts], *(u for _, u in parts)])
