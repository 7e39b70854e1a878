"""Means and covariances of random vectors and of their linear images.

For y = Bx + b the mean is B mu + b and the covariance B P B^T; nothing else of the distribution is
needed.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_vector
from trajlib.estimation.exact_or_float import latex, symmetric, tidy
from trajlib.stability.regions import latex_condition


@dataclass(frozen=True)
class Moments:
    """The mean (n, a column; for floats a flat array) and the covariance (n x n) of a random
    vector.

    Lists and scalars are read as exact, arrays as floats. `where` is the condition on symbols under
    which a formula holds. Raises ValueError for shapes that do not fit and a covariance that is not
    symmetric or has a negative direction. Source: Definitions 4.2 - 4.10 of the problem book.

    >>> x = Moments([1, 2], [[5, 1], [1, 3]])
    >>> x.transformed([[1, 1]]).covariance
    Matrix([[10]])
    >>> x.correlation[0, 1]
    sqrt(15)/15
    """

    mean: object
    covariance: object
    where: object = sp.true

    def __post_init__(self):
        floats = any_floats(self.mean, self.covariance)
        mean = read_vector(self.mean, "mean", None, floats)
        object.__setattr__(self, "mean", mean)
        object.__setattr__(
            self, "covariance", read_covariance(self.covariance, "covariance", len(mean), floats)
        )

    @property
    def deviations(self):
        """Standard deviations, the roots of the diagonal; shape as the mean."""
        if isinstance(self.covariance, np.ndarray):
            return np.sqrt(np.maximum(np.diag(self.covariance), 0))
        return self.covariance.diagonal().T.applyfunc(sp.sqrt)

    @property
    def correlation(self):
        """Coefficients of correlation, n x n (Definition 4.8). Raises ValueError if a variance is
        zero."""
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

    def transformed(self, B, b=0):
        """Moments of y = Bx + b, `B`: k x n, `b`: k components; covariance B P B^T."""
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

    def subs(self, *values):
        """The moments with values, or other expressions, for their symbols."""
        return trusted_moments(
            *(part.subs(*values) for part in (self.mean, self.covariance, self.where))
        )

    def _repr_latex_(self):
        mean = sp.Matrix(self.mean) if isinstance(self.mean, np.ndarray) else self.mean
        where = "" if self.where == sp.true else rf",\quad {latex_condition(self.where)}"
        return rf"$\displaystyle \mu = {latex(mean)},\quad P = {latex(self.covariance)}{where}$"


def trusted_moments(mean, covariance, where=sp.true):
    """`Moments` of what has been computed here: nothing is read again, which for long formulas
    takes time."""
    moments = object.__new__(Moments)
    for name, value in (("mean", mean), ("covariance", covariance), ("where", where)):
        object.__setattr__(moments, name, value)
    return moments


def moments_of_values(values, probabilities=None):
    """Moments of a vector that takes finitely many values, or of a sample (MATLAB: mean, cov).

    `values`: a row for each value, N x n (a flat list for a scalar); `probabilities`: N numbers,
    not negative, of sum 1. Without probabilities the values are a sample: all weigh the same and
    the covariance is divided by N - 1. Returns `Moments`. Raises ValueError for what is no
    distribution. Source: Definitions 4.2 - 4.10.

    >>> import sympy as sp
    >>> third, half = sp.Rational(1, 3), sp.Rational(1, 2)
    >>> found = moments_of_values([[0, 0], [1, 1], [-1, 1]], [third, half, half*third])    # x and x^2
    >>> found.mean.T, found.covariance[0, 1]
    (Matrix([[1/3, 2/3]]), 1/9)
    """
    floats = any_floats(values, probabilities)
    flat = np.ndim(values) == 1
    table = read_matrix(values, "values", None, None, floats)
    table = table.T if flat else table
    count = table.shape[0]
    if probabilities is None:
        if count < 2:
            raise ValueError("values: one value is no sample; give probabilities or more values")
        weights = np.full(count, 1 / count) if floats else sp.ones(count, 1) / count
    else:
        weights = read_vector(probabilities, "probabilities", count, floats)
        total = sum(weights)
        if any(w.is_negative if not floats else w < 0 for w in weights):
            raise ValueError("probabilities: expected numbers that are not negative")
        if abs(total - 1) > 1e-9 if floats else sp.simplify(total - 1).is_zero is False:
            raise ValueError(f"probabilities: expected the sum 1, got {total}")
    mean = table.T @ weights
    centred = (
        table - np.outer(np.ones(count), mean) if floats else table - sp.ones(count, 1) * mean.T
    )
    weighted = centred * weights[:, None] if floats else sp.diag(*weights) * centred
    covariance = symmetric(centred.T @ weighted)
    if probabilities is None:
        covariance = covariance * count / (count - 1)
    return Moments(tidy(mean), covariance)
