"""Means and covariances of random vectors and of their linear images.

For y = Bx + b the mean is B mu + b and the covariance B P B^T, whatever the distribution of x.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_vector
from trajlib._typing import Matrix, MatrixLike
from trajlib.estimation.exact_or_float import latex, symmetric, tidy
from trajlib.stability.regions import latex_condition


@dataclass(frozen=True)
class Moments:
    """Mean and covariance of a random vector.

    Lists and scalars are read as exact, arrays as floats.

    Parameters
    ----------
    mean : matrix_like
        Mean, n components; kept as a column, for floats as a flat array.
    covariance : matrix_like, shape (n, n)
        Covariance matrix, positive semidefinite.
    where : sympy.Boolean
        Condition on symbols under which a formula holds.

    Raises
    ------
    ValueError
        If shapes do not fit, or the covariance is not symmetric or not positive semidefinite.

    Notes
    -----
    Source: Definitions 4.2 - 4.10 of the problem book. MATLAB: ``mean``, ``cov`` for a sample.

    Examples
    --------
    >>> x = Moments([1, 2], [[5, 1], [1, 3]])
    >>> x.transformed([[1, 1]]).covariance
    Matrix([[10]])
    >>> x.correlation[0, 1]
    sqrt(15)/15
    """

    mean: MatrixLike
    covariance: MatrixLike
    where: sp.Basic = sp.true

    def __post_init__(self):
        floats = any_floats(self.mean, self.covariance)
        covariance = read_covariance(self.covariance, "covariance", None, floats)
        object.__setattr__(self, "covariance", covariance)
        mean = read_vector(self.mean, "mean", covariance.shape[0], floats)
        object.__setattr__(self, "mean", mean)

    @property
    def deviations(self) -> Matrix:
        """Standard deviations of the components, of the shape of the mean."""
        if isinstance(self.covariance, np.ndarray):
            return np.sqrt(np.maximum(np.diag(self.covariance), 0))
        return self.covariance.diagonal().T.applyfunc(sp.sqrt)

    @property
    def correlation(self) -> Matrix:
        """Matrix of the correlation coefficients, n x n.

        Raises
        ------
        ValueError
            If a variance is zero.

        Notes
        -----
        Source: Definition 4.8.
        """
        sigma, P = self.deviations, self.covariance
        if any(s == 0 for s in sigma):
            raise ValueError(
                "covariance: a component without variance has no correlation with others"
            )
        if isinstance(P, np.ndarray):
            return P / np.outer(sigma, sigma)
        return sp.Matrix(*P.shape, lambda i, j: P[i, j] / (sigma[i] * sigma[j])).applyfunc(
            sp.simplify
        )

    def transformed(self, B: MatrixLike, b: MatrixLike = 0) -> Moments:
        """Return the moments of y = Bx + b, with the covariance B P B^T.

        Parameters
        ----------
        B : matrix_like, shape (k, n)
            Matrix of the linear map.
        b : matrix_like
            Shift, k components.

        Returns
        -------
        Moments
        """
        floats = any_floats(B, b, self.covariance)
        n = self.covariance.shape[0]
        B = read_matrix(B, "B", None, n, floats)
        P, mean = (
            read_covariance(self.covariance, "covariance", n, floats),
            read_vector(self.mean, "mean", n, floats),
        )
        shift = read_vector(
            [0] * B.shape[0] if np.ndim(b) == 0 and b == 0 else b, "b", B.shape[0], floats
        )
        return trusted_moments(tidy(B @ mean + shift), symmetric(B @ P @ B.T), self.where)

    def subs(self, *values: Any) -> Moments:
        """Return the moments with values, or other expressions, for their symbols.

        Parameters
        ----------
        *values : object
            Arguments of SymPy's ``subs``.

        Returns
        -------
        Moments
        """
        return trusted_moments(
            *(part.subs(*values) for part in (self.mean, self.covariance, self.where))
        )

    def _repr_latex_(self):
        mean = sp.Matrix(self.mean) if isinstance(self.mean, np.ndarray) else self.mean
        where = "" if self.where == sp.true else rf",\quad {latex_condition(self.where)}"
        return rf"$\displaystyle \mu = {latex(mean)},\quad P = {latex(self.covariance)}{where}$"


def trusted_moments(mean, covariance, where=sp.true):
    """Return `Moments` of computed matrices without checking them again, which may be slow."""
    moments = object.__new__(Moments)
    for name, value in (("mean", mean), ("covariance", covariance), ("where", where)):
        object.__setattr__(moments, name, value)
    return moments
