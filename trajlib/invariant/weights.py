"""The weights of least variance, by orthogonal reflections.

With K = L L^T let

    L^{-1} [Theta^T, Psi^T] = [Q_1, Q_2] [[R_11, R_12], [0, R_22]];    then    P = L^{-T} Q_2 R_22^{-T} o,
    sigma = |R_22^{-T} o|.

R_22 is the part of the signal's functions that is orthogonal to the nuisance's. Where it is nearly
singular the two are nearly dependent, and noise and everything that psi leaves out are multiplied:
by how much is the gain |P|.
"""

import numpy as np

from trajlib.invariant.arguments import ROUNDINGS

#: A functional of which more than this share lies in the zero directions cannot be estimated.
REACHED = 1e-9


class WeightSolver:
    """Weights for given samples of the functions and one covariance."""

    def __init__(self, Psi, Theta, covariance) -> None:
        self.K, self.N = Psi.shape
        if self.N < self.K + len(Theta):
            raise ValueError(
                f"times: {self.N} samples are fewer than the {self.K + len(Theta)} functions of "
                "signal and nuisance"
            )
        self.factor = (
            np.sqrt(covariance) if covariance.ndim == 1 else np.linalg.cholesky(covariance)
        )
        signal, self.sizes = _unit_columns(self._whitened(Psi.T))
        nuisance = _span(_unit_columns(self._whitened(Theta.T))[0])
        Q, R = np.linalg.qr(np.hstack([nuisance, signal]))
        self.Q = Q[:, nuisance.shape[1] :]
        self.U, self.s, self.Vt = np.linalg.svd(R[nuisance.shape[1] :, nuisance.shape[1] :])
        self.nonzero = self.s > ROUNDINGS * self.N * np.finfo(float).eps

    def solve(self, o):
        """Return P, sigma and |P| for o of shape (K,) or (K, m)."""
        scaled = (o.T / self.sizes).T
        along = self.Vt @ scaled
        undetermined = np.abs(along[~self.nonzero])
        if (undetermined > REACHED * np.linalg.norm(scaled, axis=0)).any():
            self._raise_undetermined(o, undetermined)
        w = self.U[:, self.nonzero] @ (along[self.nonzero].T / self.s[self.nonzero]).T
        P = self._whitened(self.Q @ w, transposed=True)
        return P, np.linalg.norm(w, axis=0), np.linalg.norm(P, axis=0)

    def _raise_undetermined(self, o, undetermined):
        row = int(np.argmax(undetermined.reshape(len(undetermined), -1).max(axis=1)))
        combination = self.Vt[~self.nonzero][row] / self.sizes
        combination = combination / combination[np.argmax(np.abs(combination))]
        text = " + ".join(
            f"{c:.4g} basis[{k}]" for k, c in enumerate(combination) if abs(c) > 1e-6
        ).replace("+ -", "- ")
        size = np.abs(combination @ o).max()
        raise ValueError(
            f"functional: the samples do not determine it. At all of them {text} is a combination of "
            f"the nuisance's functions or zero, while the functional is {size:.4g} on it. Leave a "
            "function out, or sample longer or more densely; count the time from the record, not "
            "from far away"
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


def _span(columns):
    """Return an orthonormal basis of the span of unit columns, which may be dependent."""
    from scipy.linalg import qr

    if columns.shape[1] == 0:
        return columns
    Q, R, _ = qr(columns, mode="economic", pivoting=True)
    return Q[:, np.abs(np.diag(R)) > ROUNDINGS * len(columns) * np.finfo(float).eps]
