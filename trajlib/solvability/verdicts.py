"""The verdict: what the measurements determine, judged by singular values that are larger than
their own errors.

Let A = W^{-1/2} Htilde D^{-1} and let the computed A be wrong by an unknown matrix whose norm is at
most delta. Singular values move by no more than delta, and rounding in their computation moves them
by no more than s_max/mu*. So each computed value above

    level = delta + s_max/mu*

belongs to a true one that is not zero: their number is a guaranteed rank. With delta = 0 all m
values are above the level if and only if mu < mu*, the condition of the paper.
"""

import textwrap
from dataclasses import dataclass, field

import numpy as np

from trajlib._arguments.numbers import read_names, read_numeric_matrix
from trajlib.solvability import rounding
from trajlib.solvability.weights import Weights

#: Components of a direction smaller than this share of its norm are left out of the words.
MENTIONED = 0.01
#: Width of the verdict in words.
WIDTH = 110


@dataclass(frozen=True, repr=False)
class Solvability:
    """What `analyse` finds; `print` it for a verdict in words.

    `mu`, `mu_scaled`: condition numbers of W^{-1/2} Htilde before and after the columns are scaled
    to norm 1. `threshold`: mu*. `singular_values`: m of them, falling, of the matrix that is judged
    (the scaled one unless `scale=False`); `directions`: their right singular vectors by columns, in
    the scaled unknowns y = D x; `scaling`: the diagonal of D. `matrix_error`: bound on the norm of
    the error of that matrix; `level`: what a singular value must exceed to be trusted; `rank`: how
    many do. `solvable`: whether all do. `rounding_bound`: (6) of the paper, for consistent
    equations, relative to the norm of y.
    """

    n: int
    m: int
    eps: float
    mu: float
    mu_scaled: float
    threshold: float
    singular_values: np.ndarray
    directions: np.ndarray
    scaling: np.ndarray
    matrix_error: float
    names: tuple
    units: tuple
    _judged: np.ndarray = field(repr=False)
    _weights: Weights = field(repr=False)
    _entry_errors: np.ndarray = field(repr=False)

    @property
    def level(self):
        return self.matrix_error + self.singular_values[0] / self.threshold

    @property
    def rank(self):
        return int(np.sum(self.singular_values > self.level))

    @property
    def solvable(self):
        return self.rank == self.m

    @property
    def rounding_bound(self):
        greatest, least = self.singular_values[[0, -1]]
        return (
            rounding.rounding_bound(self.m, self.n, greatest / least, self.eps)
            if least > 0
            else np.inf
        )

    def combination(self, k):
        """The change of the unknowns, in their units, that belongs to singular value k (0: best
        determined) and alters the weighted measurements by a vector of length 1."""
        return self.directions[:, k] / self.scaling / self.singular_values[k]

    @property
    def unseen(self):
        """Changes of the unknowns that cannot be told from no change, m - rank rows.

        They span what is left over by the guaranteed rank, and are chosen such that each changes an
        unknown of its own by 1.
        """
        from scipy.linalg import qr

        left = self.directions[:, self.rank :]
        if left.shape[1] == 0:
            return np.zeros((0, self.m))
        _, _, order = qr(left.T, pivoting=True, mode="economic")
        leading = order[: left.shape[1]]
        # the unit matrix in the leading unknowns
        rows = np.linalg.solve(left[leading].T, left.T)
        return rows / self.scaling * self.scaling[leading][:, None]

    @property
    def undetermined(self):
        """Names of the unknowns that take part in what is unseen."""
        shares = np.linalg.norm(self.directions[:, self.rank :], axis=1)
        return tuple(name for name, share in zip(self.names, shares) if share > MENTIONED)

    @property
    def standard_deviations(self):
        """Square roots of the diagonal of (Htilde^T W^{-1} Htilde)^{-1}: errors of the unknowns if
        W is the covariance of e."""
        self._demand("standard deviations")
        return np.linalg.norm(self.directions / self.singular_values, axis=1) / self.scaling

    def noise_bound(self, e, state=None):
        """Greatest errors |dx_j| that errors of the measurements can cause, m numbers: attained,
        not only a bound.

        `e`: a number or n numbers that |e_i| never exceeds, in the units of the measurements. `state`: x, or bounds on
        |x_j|; if given, the errors of the matrix are added, which change the measurements by as much as they are
        multiplied with x.
        """
        inverse = np.abs(self.estimator)
        e = np.broadcast_to(np.asarray(e, dtype=float), (self.n,))
        if not (np.isfinite(e).all() and (e >= 0).all()):
            raise ValueError(
                "e: expected finite bounds on the errors of the measurements, zero or positive"
            )
        return inverse @ (
            e if state is None else e + self._entry_errors @ np.abs(np.asarray(state, dtype=float))
        )

    def relative_noise_bound(self, e, state):
        """mu |e|/|Htilde x|, a bound on |dx|/|x| (norms of weighted e and scaled x): (5) of the
        paper, corrected."""
        e = self._weights.apply(np.asarray(e, dtype=float))
        seen = self._judged @ (self.scaling * np.asarray(state, dtype=float))
        return float(
            self.singular_values[0]
            / self.singular_values[-1]
            * np.linalg.norm(e)
            / np.linalg.norm(seen)
        )

    @property
    def estimator(self):
        """The matrix P, shape (m, n), of the estimate x = P Z; computed by orthogonal
        reflections."""
        from scipy.linalg import qr, solve_triangular

        self._demand("an estimate")
        Q, R = qr(self._judged, mode="economic")
        return self._weights.apply_transposed(solve_triangular(R, Q.T).T).T / self.scaling[:, None]

    def _demand(self, what):
        if not self.solvable:
            raise ValueError(f"{what} would have no meaning: {self.verdict}")

    @property
    def verdict(self):
        """The finding in words."""
        values = self.singular_values
        lines = [
            f"{self.m} unknowns, {self.n} scalar measurements; condition number {_short(self.mu)} "
            f"as given, {_short(self.mu_scaled)} with scaled columns; full rank is guaranteed "
            f"below {_short(self.threshold)}."
        ]
        if self.matrix_error:
            lines[0] = (
                lines[0][:-1]
                + f" for an exact matrix; this one is wrong by up to {self.matrix_error:.1e} of "
                f"its columns."
            )
        else:
            lines[0] = lines[0][:-1] + "; the matrix is taken as exact."
        if self.solvable:
            lines.append(
                f"Solvable: the smallest singular value {values[-1]:.2e} is above "
                f"{self.level:.2e}, the level of the errors."
            )
            weakest = self._in_words(self.combination(self.m - 1))
            lines.append(
                f"Least certain: {weakest}, which changes the weighted measurements by 1 in all."
            )
        else:
            count = self.m - self.rank
            others = (
                f"smallest is {values[-1]:.2e}"
                if count == 1
                else f"other {count} are {values[self.rank]:.2e} and less"
            )
            lines.append(
                f"Not shown to be solvable: {self.rank} of {self.m} singular values are above "
                f"{self.level:.2e}, the level of the errors; the {others}."
            )
            lines += [f"Cannot be told from zero: {self._in_words(row)}." for row in self.unseen]
            seen = [name for name in self.names if name not in self.undetermined]
            lines.append(
                "Determined by themselves: "
                + (", ".join(seen) if seen else "none of the unknowns")
                + "."
            )
        return "\n".join(textwrap.fill(line, WIDTH, subsequent_indent="  ") for line in lines)

    def _in_words(self, row):
        shares = np.abs(row * self.scaling)
        order = [
            j for j in np.argsort(-shares, kind="stable") if shares[j] > MENTIONED * shares.max()
        ]
        row = row * np.sign(row[order[0]])
        parts = [f"{self.names[j]} by {row[j]:.4g} {self.units[j]}".rstrip() for j in order]
        return parts[0] + (" together with " + ", ".join(parts[1:]) if parts[1:] else "")

    def __repr__(self):
        return self.verdict

    def plot(self):
        """Singular values with the level of the errors, and the shares of the unknowns in their
        directions; returns the two Axes."""
        import matplotlib.pyplot as plt

        from trajlib import plotting

        with plotting.style():
            _, (left, right) = plt.subplots(1, 2, figsize=(8, 3.6), width_ratios=[2, 3])
            index, floor = np.arange(1, self.m + 1), self.level / 1e3
            trusted = self.singular_values > self.level
            kinds = (
                (trusted, "o", plotting.BLUE, "trusted"),
                (~trusted, "s", "white", "not told from zero"),
            )
            for chosen, marker, face, label in kinds:
                if chosen.any():
                    heights = np.maximum(self.singular_values[chosen], floor)
                    left.semilogy(
                        index[chosen],
                        heights,
                        marker,
                        ls="none",
                        mfc=face,
                        mec=plotting.BLUE,
                        ms=7,
                        label=label,
                    )
            left.axhline(self.level, color=plotting.RED, ls="--", label="level of errors")
            left.set(
                xlabel="number", ylabel="singular value", xticks=index, xlim=(0.5, self.m + 0.5)
            )
            left.legend(loc="best")
            right.imshow(np.abs(self.directions), cmap="Greys", vmin=0, vmax=1.4, aspect="auto")
            for (j, k), share in np.ndenumerate(self.directions):
                if abs(share) >= MENTIONED:
                    right.text(k, j, f"{share:.2f}", ha="center", va="center", fontsize=9)
            right.set(
                xticks=index - 1,
                xticklabels=index,
                yticks=index - 1,
                yticklabels=self.names,
                xlabel="direction of singular value number",
            )
        return left, right


def analyse(matrix, W=None, *, eps=None, scale=True, matrix_error=None, names=None, units=None):
    """Judge the system Z = Htilde x + e before it is solved (MATLAB: svd, cond, rank).

    `matrix`: Htilde, shape (n, m), or a `Linearisation`, whose error estimates, names and units are
    then used. `W`: covariance of e: n variances, a symmetric positive definite matrix (n, n), or k
    blocks (k, r, r) of its diagonal; unit variances if left out. `eps`: relative precision of the
    machine numbers. `matrix_error`: bounds on the errors of the entries, an array like `matrix`, or
    a number, the errors relative to the greatest entry of their column; nothing, if the matrix is
    exact. `scale=False`: judge without scaling the columns.

    >>> import numpy as np
    >>> t = np.linspace(0, 1, 20)
    >>> print(analyse(np.stack([np.ones(20), t, 1 + t], axis=1), names=["a", "b", "c"]))      # doctest: +ELLIPSIS
    3 unknowns, 20 scalar measurements; ...
    Not shown to be solvable: 2 of 3 singular values are above ...
    Cannot be told from zero: c by 1 together with a by -1, b by -1.
    Determined by themselves: none of the unknowns.
    """
    if hasattr(matrix, "Phi"):
        names, units = names or matrix.names, units or matrix.units
        matrix_error = matrix.error if matrix_error is None else matrix_error
        matrix = matrix.matrix
    matrix = read_numeric_matrix(matrix, "matrix")
    n, m = matrix.shape
    names, units = read_names(names, m), read_names(units, m, "units")
    if m == 0:
        raise ValueError("matrix: it has no columns, so there is nothing to determine")
    if n < m:
        raise ValueError(
            f"matrix: {n} scalar measurements for {m} unknowns; whatever they are, {m - n} "
            "combinations stay free. Take more measurements or fewer unknowns"
        )
    zero = [name for name, column in zip(names, matrix.T) if not column.any()]
    if zero:
        raise ValueError(
            f"matrix: the column of {', '.join(zero)} is zero: no measurement ever sees it. Leave "
            "it out, or measure something else"
        )
    eps = rounding.EPS if eps is None else float(eps)
    weights = Weights(W, n)
    weighted = weights.apply(matrix)
    # norms by columns of size 1, so that their squares neither overflow nor vanish
    largest = np.abs(weighted).max(axis=0)
    if not (np.isfinite(largest).all() and (largest > 0).all()):
        raise ValueError(
            "matrix: its weighted entries are too large or too small for machine numbers; change "
            "the units"
        )
    norms = largest * np.linalg.norm(weighted / largest, axis=0)
    entry_errors = _entry_errors(matrix_error, matrix)
    scaled = weighted / norms
    scaling = norms if scale else np.full(m, norms.max())
    errors = weights.apply_absolute(entry_errors) / scaling
    # reflections first: what follows is done with m x m matrices, and columns may be scaled before
    # or after
    triangle = np.linalg.qr(scaled, mode="r")
    values, directions = np.linalg.svd(triangle * (norms / scaling))[1:]
    return Solvability(
        n,
        m,
        eps,
        _condition(triangle * (norms / norms.max())),
        _condition(triangle),
        rounding.threshold(m, n, eps),
        values,
        directions.T,
        scaling,
        float(np.linalg.norm(errors)),
        names,
        units,
        weighted / scaling,
        weights,
        entry_errors,
    )


def _entry_errors(error, matrix):
    if error is None:
        return np.zeros_like(matrix)
    error = np.asarray(error, dtype=float)
    if not (np.isfinite(error).all() and (error >= 0).all()):
        raise ValueError("matrix_error: expected finite numbers, zero or positive")
    if error.ndim == 0:
        return np.broadcast_to(error * np.abs(matrix).max(axis=0), matrix.shape)
    if error.shape != matrix.shape:
        raise ValueError(
            f"matrix_error: expected a number or an array of shape {matrix.shape}, got shape "
            f"{error.shape}"
        )
    return error


def _condition(matrix):
    values = np.linalg.svd(matrix, compute_uv=False)
    return float(values[0] / values[-1]) if values[-1] > 0 else np.inf


def _short(number):
    return "infinity" if np.isinf(number) else f"{number:.3g}"
