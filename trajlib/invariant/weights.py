"""The weights of least variance, by orthogonal reflections.

With K = L L^T let

    L^{-1} [Theta^T, Psi^T] = [Q_1, Q_2] [[R_11, R_12], [0, R_22]];    then    P = L^{-T} Q_2 R_22^{-T} o,
    sigma = |R_22^{-T} o|.

R_22 is the part of the signal's functions that is orthogonal to the nuisance's. Where it is nearly
singular the two are nearly dependent, and noise and everything that psi leaves out are multiplied:
by how much is the gain |P|. Polynomials are taken in centred time (`trajlib.invariant.centring`).
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from trajlib._numerical_rank import zero_level
from trajlib.invariant.centring import centred, exact_rank, remainders, time_scale
from trajlib.invariant.functionals import on_basis
from trajlib.invariant.sample_arguments import sample_functions

#: A functional of which more than this share lies in the zero directions cannot be estimated.
REACHED = 1e-9
#: Below this margin a part of a record has its polynomials centred anew.
CENTRED_ANEW = 1e-4

_LOST = (
    "basis, nuisance: at the samples some of the functions, or combinations of them, differ by less "
    "than the rounding of floats, so no estimate can be trusted. Leave a function out or sample "
    "longer; give polynomials and SymPy expressions instead of Python functions, whose rank is "
    "known in floats only"
)


@dataclass(frozen=True)
class Sampled:
    """Functions of signal and nuisance with their samples.

    Attributes
    ----------
    uncentred : tuple
        Basis and nuisance as they were given.
    functions : list
        Functions with the span of the basis, to which functionals are applied.
    combination : ndarray
        They are this matrix times the basis.
    Psi, Theta : ndarray
        Samples by rows, those of Psi up to multiples of rows of Theta.
    """

    times: np.ndarray
    uncentred: tuple
    functions: list
    combination: np.ndarray
    Psi: np.ndarray
    Theta: np.ndarray

    @classmethod
    def on(cls, times, basis, nuisance):
        """Return the samples at the times, with polynomials in time centred there."""
        scale = time_scale(times)
        functions, combination, polynomials = centred(basis, scale)
        further, _, dividing = centred(nuisance, scale)
        sampled = list(functions)
        for k, remainder in remainders(polynomials, dividing, scale):
            sampled[k] = remainder
        Psi, Theta = (
            sample_functions(part, times, name)
            for part, name in ((sampled, "basis"), (further, "nuisance"))
        )
        return cls(times, (basis, nuisance), functions, combination, Psi, Theta)

    def solver(self, samples, covariance):
        """Return the solver for a slice of the samples, with polynomials centred anew if needed."""
        times = self.times[samples]
        cut = replace(self, times=times, Psi=self.Psi[:, samples], Theta=self.Theta[:, samples])
        solver = WeightSolver(cut, covariance)
        if solver.margin < CENTRED_ANEW:
            solver = WeightSolver(Sampled.on(times, *self.uncentred), covariance)
        return solver


class WeightSolver:
    """Weights for sampled functions and one covariance."""

    def __init__(self, sampled, covariance) -> None:
        from scipy.linalg import qr

        self.sampled = sampled
        (K, N), M = sampled.Psi.shape, len(sampled.Theta)
        if N < K + M:
            raise ValueError(
                f"times: {N} samples are fewer than the {K + M} functions of signal and nuisance"
            )
        self.factor = (
            np.sqrt(covariance) if covariance.ndim == 1 else np.linalg.cholesky(covariance)
        )
        signal, self.sizes = _unit_columns(self._whitened(sampled.Psi.T))
        nuisance, pivots = _unit_columns(self._whitened(sampled.Theta.T))[0], np.ones(0)
        level = zero_level(N, K + M)
        if M:
            nuisance, R, _ = qr(nuisance, mode="economic", pivoting=True)
            pivots = np.abs(np.diag(R))
            nuisance = nuisance[:, pivots > level]
        Q, R = np.linalg.qr(np.hstack([nuisance, signal]))
        self.Q = Q[:, nuisance.shape[1] :]
        self.U, self.s, self.Vt = np.linalg.svd(R[nuisance.shape[1] :, nuisance.shape[1] :])
        self.nonzero = self.s > level
        #: Least singular value or pivot: how far the functions are from dependent ones.
        self.margin = min([1.0, *self.s, *pivots])
        self.rank, self.count = nuisance.shape[1] + int(self.nonzero.sum()), K + M

    def solve(self, functional):
        """Return P, sigma and |P| of a functional, or of m of them at once."""
        if self.exact_rank not in (self.rank, None):
            raise ValueError(_LOST)
        o = on_basis(functional, self.sampled.functions)
        scaled = (o.T / self.sizes).T
        along = self.Vt @ scaled
        undetermined = np.abs(along[~self.nonzero])
        if (undetermined > REACHED * np.linalg.norm(scaled, axis=0)).any():
            self._raise_undetermined(o, undetermined)
        if self.exact_rank is None:
            raise ValueError(_LOST)
        w = self.U[:, self.nonzero] @ (along[self.nonzero].T / self.s[self.nonzero]).T
        P = self._whitened(self.Q @ w, transposed=True)
        return P, np.linalg.norm(w, axis=0), np.linalg.norm(P, axis=0)

    @cached_property
    def exact_rank(self):
        """Rank of the samples of all functions; None if floats do not tell it."""
        if self.rank == self.count:
            return self.rank
        basis, nuisance = self.sampled.uncentred
        return exact_rank([*basis, *nuisance], self.sampled.times)

    def _raise_undetermined(self, o, undetermined):
        row = int(np.argmax(undetermined.reshape(len(undetermined), -1).max(axis=1)))
        of_functions = self.Vt[~self.nonzero][row] / self.sizes
        combination = of_functions @ self.sampled.combination
        size = combination[np.argmax(np.abs(combination))]
        text = " + ".join(
            f"{c:.4g} basis[{k}]" for k, c in enumerate(combination / size) if abs(c / size) > 1e-6
        ).replace("+ -", "- ")
        raise ValueError(
            f"functional: the samples do not determine it. At all of them {text} is a combination of "
            "the nuisance's functions or zero, within rounding, while the functional is "
            f"{np.abs(of_functions @ o / size).max():.4g} on it. Leave a function out, or sample "
            "longer or more densely"
        )

    def _whitened(self, rows, transposed=False):
        from scipy.linalg import solve_triangular

        if self.factor.ndim == 1:
            return (rows.T / self.factor).T
        return solve_triangular(self.factor, rows, lower=True, trans="T" if transposed else "N")


def _unit_columns(matrix):
    sizes = np.linalg.norm(matrix, axis=0)
    sizes = np.where(sizes > 0, sizes, 1)
    return matrix / sizes, sizes
