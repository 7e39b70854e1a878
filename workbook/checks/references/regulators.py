"""Linear regulators with a quadratic cost at numbers, given as a `Quadratic`: what a law costs, and
what costs least.

A regulator is a steady filter of the dual process (`references/processes.py`), whose errors have the
transposed matrix of its loop; so what a gain costs comes from a linear equation, of Lyapunov, and
the least cost from an invariant subspace. With a given end it comes from the exponential of the
Hamiltonian matrix, with what the cost does not see left out it is that of the rest. No Riccati
equation is integrated.
"""

import numpy as np
import sympy as sp

from workbook.checks.references import processes
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
        """The matrix X of what u = gain x costs from x, factor x^T X x; raises LinAlgError if a
        state does not decay.
        """
        return processes.error_covariance(self._dual, -gain.T)

    def gain_for(self, cost):
        """The gain that costs least now, if what comes later costs x^T `cost` x."""
        return -processes.filter_gain(self._dual, cost).T

    def rates(self, cost):
        """The terms of the rate at which the matrix of the cost changes by the Riccati equation."""
        gain = self.gain_for(cost)
        return -self.A.T @ cost, -cost @ self.A, -self.G, gain.T @ self.N @ gain

    def least(self, time=0.0):
        """The matrix S of the least cost from a state at a time."""
        if np.isfinite(self.duration):
            return self._with_an_end(self.duration - time)
        return (
            self._of_what_is_seen()
            if self.anywhere
            else processes.steady_covariances(self._dual)[0]
        )

    def _with_an_end(self, left):
        from scipy.linalg import expm

        push = self.B @ np.linalg.solve(self.N, self.B.T)
        both = expm(-left * np.block([[self.A, -push], [-self.G, -self.A.T]])) @ np.vstack(
            [np.eye(len(self.A)), self.F]
        )
        n = len(self.A)
        found = np.linalg.solve(both[:n].T, both[n:].T)
        return (found + found.T) / 2

    def _of_what_is_seen(self):
        exact = [
            sp.Matrix(matrix).applyfunc(lambda x: sp.nsimplify(x, rational=True))
            for matrix in (self.A, self.G)
        ]
        unseen = np.array(pair_of(*exact).unobservable[0], dtype=float).reshape(-1, len(self.A))
        seen = np.linalg.svd(unseen)[2][len(unseen) :] if len(unseen) else np.eye(len(self.A))
        if not len(seen):
            return 0 * self.A
        rest = Quadratic(
            *map(
                sp.Matrix,
                (seen @ self.A @ seen.T, seen @ self.B, _even(seen @ self.G @ seen.T), self.N),
            )
        )
        return seen.T @ Regulator(rest, {}).least() @ seen


def dual(problem):
    """The process whose steady filter is the regulator, transposed."""
    return Process(problem.A.T, Q=problem.G, H=problem.B.T, R=problem.N)


def exists(problem):
    """Whether a law of least cost brings every state to zero, at general values of the symbols:
    Popov's test."""
    return processes.steady_exists(dual(problem)).at({})


def steady_loop(problem, process, values):
    """The matrix and the noise of (x, e) for the best feedback by the measurements of a process,
    and the weight of (x, e) in its cost; without measurements those of x, the state being known."""
    one, noise = Regulator(problem, values), processes.at_values(process, values, start=False)
    K = one.gain_for(one.least())
    if not len(noise.H):
        return one.A + one.B @ K, noise.Q, one.G + K.T @ one.N @ K
    L = processes.filter_gain(noise, processes.steady_covariances(noise)[0])
    n = len(K.T)
    loop = np.block([[one.A, one.B @ K], [L @ noise.H, one.A + one.B @ K - L @ noise.H]])
    zero = np.zeros((n, n))
    return (
        loop,
        np.block([[noise.Q, zero], [zero, L @ noise.R @ L.T]]),
        np.block([[one.G, zero], [zero, K.T @ one.N @ K]]),
    )


def _even(matrix):
    return (matrix + matrix.T) / 2
