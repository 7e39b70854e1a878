"""Linear regulators with a quadratic cost, given as a `Quadratic`: costs of laws, and least costs.

A regulator is a steady filter of the dual process (`references/processes.py`), whose errors have the
transposed matrix of its loop; so the cost of a gain comes from a Lyapunov equation, and the least
cost from an invariant subspace. With a finite duration it comes from the exponential of the
Hamiltonian matrix; if states that the cost does not depend on are left out, it is that of the rest.
No Riccati equation is integrated.
"""

from types import SimpleNamespace

import numpy as np
import sympy as sp

from workbook.checks.references import processes
from workbook.checks.references.invariant_subspaces import orthogonal_complement, to_floats
from workbook.checks.references.natural_units import COST, natural_units
from workbook.checks.references.pairs import pair_of
from workbook.systems import Process, Quadratic


class Regulator:
    """A `Quadratic` at values of its symbols, as arrays of floats."""

    def __init__(self, problem, values):
        for name in "ABGNF":
            setattr(self, name, processes.to_array(getattr(problem, name), values))
        self.duration = float(sp.sympify(problem.duration).subs(values))
        self.factor = float(sp.sympify(problem.factor).subs(values))
        self.anywhere, self._values = problem.anywhere, values
        self._dual = processes.at_values(dual(problem), values, start=False)

    def cost_of(self, gain):
        """Return X, where u = gain x costs factor x^T X x; LinAlgError if a state does not decay."""
        return processes.error_covariance(self._dual, -gain.T)

    def gain_for(self, cost):
        """Return the gain of least cost at present, if the later cost is x^T `cost` x."""
        return -processes.filter_gain(self._dual, cost).T

    def loop(self):
        """Return A + BK with the gain K of least cost at the time 0."""
        return self.A + self.B @ self.gain_for(self.least())

    def rates(self, cost):
        """Return the terms of the Riccati equation for the rate of the matrix of the cost."""
        gain = self.gain_for(cost)
        return -self.A.T @ cost, -cost @ self.A, -self.G, gain.T @ self.N @ gain

    def least(self, time=0.0):
        """Return the matrix S of the least cost from a state at a time."""
        if np.isfinite(self.duration):
            return self._finite_horizon_cost(self.duration - time)
        return (
            self._cost_of_observable_part()
            if self.anywhere
            else processes.steady_covariances(self._dual)[0]
        )

    def _finite_horizon_cost(self, remaining_time):
        from scipy.linalg import expm

        n, push = len(self.A), self.B @ np.linalg.solve(self.N, self.B.T)
        hamiltonian = np.block([[self.A, -push], [-self.G, -self.A.T]])
        solution = expm(-remaining_time * hamiltonian) @ np.vstack([np.eye(n), self.F])
        cost = np.linalg.solve(solution[:n].T, solution[n:].T)
        return (cost + cost.T) / 2

    def _cost_of_observable_part(self):
        unobservable = to_floats(pair_of(self.A, self.G).unobservable[0], len(self.A))
        observable = orthogonal_complement(unobservable)
        if not len(observable):
            return 0 * self.A
        A, G = (observable @ matrix @ observable.T for matrix in (self.A, self.G))
        part = Quadratic(*map(sp.Matrix, (A, observable @ self.B, (G + G.T) / 2, self.N)))
        return observable.T @ Regulator(part, {}).least() @ observable


def dual(problem):
    """Return the process whose steady filter is the regulator, transposed."""
    return Process(problem.A.T, Q=problem.G, H=problem.B.T, R=problem.N)


def cost_units(problem):
    """Return the natural units of the entries of a matrix S of the cost, a matrix.

    For numbers of S in these units all terms of the Riccati equation are of one size.
    """
    state, control = ([sp.Dummy() for _ in range(n)] for n in problem.B.shape)
    x, u = sp.Matrix(state), sp.Matrix(control)
    record = SimpleNamespace(
        state=state,
        control=control,
        dynamics=dict(zip(state, problem.A * x + problem.B * u)),
        controls={},
        initial={},
        terminal=[],
        running=x.dot(problem.G * x) + u.dot(problem.N * u),
        final=x.dot(problem.F * x),
        duration=sp.sympify(problem.duration),
    )
    units = natural_units(record)
    return sp.Matrix([[units[COST] / units[a] / units[b] for b in state] for a in state])


def covariance_units(process):
    """Return the natural units of the entries of the covariance of errors, a matrix.

    They are the `cost_units` of the regulator to which the filter is dual.
    """
    return cost_units(Quadratic(process.A.T, process.H.T, G=process.Q, N=process.R))


def exists(problem):
    """Return whether a law of least cost brings every state to zero, by the PBH test."""
    return processes.steady_exists(dual(problem)).at({})


def steady_loop(problem, process, values):
    """Return matrix, noise and weight of cost of (x, e) under the best feedback.

    Without measurements they are those of x, the state being known.
    """
    from scipy.linalg import block_diag

    regulator, noise = Regulator(problem, values), processes.at_values(process, values, start=False)
    K = regulator.gain_for(regulator.least())
    if not len(noise.H):
        return regulator.A + regulator.B @ K, noise.Q, regulator.G + K.T @ regulator.N @ K
    L = processes.filter_gain(noise, processes.steady_covariances(noise)[0])
    A, push, output = regulator.A, regulator.B @ K, L @ noise.H
    return (
        np.block([[A, push], [output, A + push - output]]),
        block_diag(noise.Q, L @ noise.R @ L.T),
        block_diag(regulator.G, K.T @ regulator.N @ K),
    )
