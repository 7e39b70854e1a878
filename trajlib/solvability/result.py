"""Result of an analysis of solvability: numbers, verdict in words, picture."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from trajlib import plotting
from trajlib._arguments.arrays import read_array, read_finite_array
from trajlib._typing import ArrayLike
from trajlib.solvability import rounding
from trajlib.solvability.weights import Weights

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Components of a direction smaller than this share of its norm are left out of the words.
MENTIONED = 0.01

#: Width of the verdict in words.
WIDTH = 110


@dataclass(frozen=True, repr=False)
class Solvability:
    """Result of `analyse`; `print` it for a verdict in words.

    Attributes
    ----------
    n, m : int
        Numbers of scalar measurements and of unknowns.
    eps : float
        Relative precision of the floats.
    mu, mu_scaled : float
        Condition numbers of W^{-1/2} Htilde before and after the columns are scaled to norm 1.
    threshold : float
        Condition number mu* below which full rank is guaranteed.
    singular_values : ndarray, shape (m,)
        Decreasing singular values of the matrix under analysis, the scaled one unless
        `scale=False`.
    directions : ndarray, shape (m, m)
        Its right singular vectors by columns, in the scaled unknowns y = D x.
    scaling : ndarray, shape (m,)
        Diagonal of D.
    matrix_error : float
        Bound on the norm of the error of that matrix.
    names, units : tuple of str
        Names and units of the unknowns.
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
    names: Sequence[str]
    units: Sequence[str]
    _scaled_matrix: np.ndarray = field(repr=False)
    _weights: Weights = field(repr=False)
    _entry_errors: np.ndarray = field(repr=False)

    @property
    def level(self) -> float:
        """Level that a singular value must exceed to be reliable."""
        return self.matrix_error + self.singular_values[0] / self.threshold

    @property
    def rank(self) -> int:
        """Guaranteed rank, the number of reliable singular values."""
        return int(np.sum(self.singular_values > self.level))

    @property
    def solvable(self) -> bool:
        """Whether all singular values are reliable."""
        return self.rank == self.m

    @property
    def rounding_bound(self) -> float:
        """Bound (6) of the paper, for consistent equations, relative to the norm of y."""
        greatest, least = self.singular_values[[0, -1]]
        return (
            rounding.rounding_bound(self.m, self.n, greatest / least, self.eps)
            if least > 0
            else np.inf
        )

    def combination(self, k: int) -> np.ndarray:
        """Return the change of the unknowns that belongs to a singular value.

        Parameters
        ----------
        k : int
            Index of the singular value; 0 is the best determined.

        Returns
        -------
        ndarray, shape (m,)
            In the units of the unknowns; it changes the weighted measurements by a vector of length
            1.
        """
        return self.directions[:, k] / self.scaling / self.singular_values[k]

    @property
    def unobservable(self) -> np.ndarray:
        """Changes of the unknowns that are not distinguished from zero, m - rank rows.

        They span the complement of the guaranteed rank, and each changes a different unknown by 1.
        """
        from scipy.linalg import qr

        remaining = self.directions[:, self.rank :]
        if remaining.shape[1] == 0:
            return np.zeros((0, self.m))
        _, _, order = qr(remaining.T, pivoting=True, mode="economic")
        leading = order[: remaining.shape[1]]
        # the unit matrix in the leading unknowns
        rows = np.linalg.solve(remaining[leading].T, remaining.T)
        return rows / self.scaling * self.scaling[leading][:, None]

    @property
    def undetermined(self) -> tuple[str, ...]:
        """Names of the unknowns with a part in the unobservable changes."""
        shares = np.linalg.norm(self.directions[:, self.rank :], axis=1)
        return tuple(name for name, share in zip(self.names, shares) if share > MENTIONED)

    @property
    def standard_deviations(self) -> np.ndarray:
        """Standard errors of the unknowns if W is the covariance of e.

        They are the roots of the diagonal of (Htilde^T W^{-1} Htilde)^{-1}.
        """
        self._require_solvable("standard deviations")
        return np.linalg.norm(self.directions / self.singular_values, axis=1) / self.scaling

    def noise_bound(self, e: ArrayLike, state: ArrayLike | None = None) -> np.ndarray:
        """Return the largest errors |dx_j| that bounded errors of the measurements can cause.

        Parameters
        ----------
        e : array_like
            Bounds on |e_i|, a number or n numbers, in the units of the measurements.
        state : array_like, optional
            x, or bounds on |x_j|; if given, the errors of the matrix multiplied by it are added to
            e.

        Returns
        -------
        ndarray, shape (m,)
            Attained for some errors, so the bound is sharp.
        """
        inverse = np.abs(self.estimator)
        e = np.broadcast_to(read_array(e, "e", "bounds on errors"), (self.n,))
        if not (np.isfinite(e).all() and (e >= 0).all()):
            raise ValueError(
                "e: expected finite bounds on the errors of the measurements, zero or positive"
            )
        return inverse @ (
            e
            if state is None
            else e + self._entry_errors @ np.abs(read_finite_array(state, "state", "numbers"))
        )

    def relative_noise_bound(self, e: ArrayLike, state: ArrayLike) -> float:
        """Return mu |e|/|Htilde x|, a bound on |dx|/|x|.

        Parameters
        ----------
        e : array_like, shape (n,)
            Errors of the measurements.
        state : array_like, shape (m,)
            Unknowns x.

        Returns
        -------
        float
            In norms of weighted e and scaled x.

        Notes
        -----
        Source: (5) of the paper, corrected.
        """
        e = self._weights.apply(read_finite_array(e, "e", "errors as numbers"))
        predicted = self._scaled_matrix @ (
            self.scaling * read_finite_array(state, "state", "numbers")
        )
        return float(
            self.singular_values[0]
            / self.singular_values[-1]
            * np.linalg.norm(e)
            / np.linalg.norm(predicted)
        )

    @property
    def estimator(self) -> np.ndarray:
        """Matrix P of the estimate x = P Z, shape (m, n), by orthogonal reflections."""
        from scipy.linalg import qr, solve_triangular

        self._require_solvable("an estimate")
        Q, R = qr(self._scaled_matrix, mode="economic")
        return self._weights.apply_transposed(solve_triangular(R, Q.T).T).T / self.scaling[:, None]

    def _require_solvable(self, quantity):
        if not self.solvable:
            raise ValueError(f"{quantity} would have no meaning: {self.verdict}")

    @property
    def verdict(self) -> str:
        """Verdict in words."""
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
            values_text = (
                f"smallest is {values[-1]:.2e}"
                if count == 1
                else f"other {count} are {values[self.rank]:.2e} and less"
            )
            lines.append(
                f"Not shown to be solvable: {self.rank} of {self.m} singular values are above "
                f"{self.level:.2e}, the level of the errors; the {values_text}."
            )
            lines += [
                f"Cannot be told from zero: {self._in_words(row)}." for row in self.unobservable
            ]
            determined = [name for name in self.names if name not in self.undetermined]
            lines.append(
                "Determined by themselves: "
                + (", ".join(determined) if determined else "none of the unknowns")
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

    def plot(self) -> tuple[Axes, Axes]:
        """Draw the singular values with the level of the errors, and their directions.

        Returns
        -------
        (matplotlib.axes.Axes, matplotlib.axes.Axes)
        """
        import matplotlib.pyplot as plt

        with plotting.style():
            _, (values_ax, directions_ax) = plt.subplots(
                1, 2, figsize=(8, 3.6), width_ratios=[2, 3]
            )
            index, floor = np.arange(1, self.m + 1), self.level / 1e3
            reliable = self.singular_values > self.level
            kinds = (
                (reliable, "o", plotting.BLUE, "trusted"),
                (~reliable, "s", "white", "not told from zero"),
            )
            for group, marker, face, label in kinds:
                if group.any():
                    heights = np.maximum(self.singular_values[group], floor)
                    values_ax.semilogy(
                        index[group],
                        heights,
                        marker,
                        ls="none",
                        mfc=face,
                        mec=plotting.BLUE,
                        ms=7,
                        label=label,
                    )
            values_ax.axhline(self.level, color=plotting.RED, ls="--", label="level of errors")
            values_ax.set(
                xlabel="number", ylabel="singular value", xticks=index, xlim=(0.5, self.m + 0.5)
            )
            values_ax.legend(loc="best")
            directions_ax.imshow(
                np.abs(self.directions), cmap="Greys", vmin=0, vmax=1.4, aspect="auto"
            )
            for (j, k), share in np.ndenumerate(self.directions):
                if abs(share) >= MENTIONED:
                    directions_ax.text(k, j, f"{share:.2f}", ha="center", va="center", fontsize=9)
            directions_ax.set(
                xticks=index - 1,
                xticklabels=index,
                yticks=index - 1,
                yticklabels=self.names,
                xlabel="direction of singular value number",
            )
        return values_ax, directions_ax


def _short(number):
    return "infinity" if np.isinf(number) else f"{number:.3g}"
