"""Shaping filters: a correlated noise as the output of a linear system driven by white noise.

A process with the correlation D e^{-a |tau|} obeys w' = -aw + q with the intensity 2aD and the
variance D from the beginning; for a = 0 it is a constant of the variance D. A sum of such
correlations is that of independent processes. The states of the noise are then estimated beside
those of the system.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib._arguments.symbols import exact_decimals, read_expression, read_symbols
from trajlib.estimation.exact_or_float import stack


@dataclass(frozen=True)
class ShapingFilter:
    """w' = A w + q, noise = H w: `A`: k x k, `H`: 1 x k, `Q`: k x k, the intensity of q,
    `covariance`: k x k, that of w at all times."""

    A: object
    H: object
    Q: object
    covariance: object

    def correlation(self, tau):
        """The correlation function of the noise at tau >= 0; A is diagonal."""
        return sum(
            self.H[k] ** 2 * self.covariance[k, k] * sp.exp(self.A[k, k] * tau)
            for k in range(self.A.rows)
        )


def shaping_filter(correlation, tau):
    """The system that makes a noise with the given correlation function from white noise.

    `correlation`: an expression in the symbol `tau` >= 0, a sum of terms D e^{-a tau} with D > 0
    and a >= 0 (symbols with assumptions, or numbers); the function is even in tau. Returns
    `ShapingFilter`. Raises ValueError for other functions. Source: problems 4.41 - 4.43; "forming
    equation" in the hint to 4.43.

    >>> import sympy as sp
    >>> tau = sp.Symbol("tau")
    >>> found = shaping_filter(8*sp.exp(-tau), tau)    # problem 4.41
    >>> found.A, found.Q, found.covariance
    (Matrix([[-1]]), Matrix([[16]]), Matrix([[8]]))
    """
    (tau,) = read_symbols(tau, "tau")
    correlation = exact_decimals(read_expression(correlation, "correlation"))
    terms = {}
    for term in sp.Add.make_args(sp.expand(correlation)):
        size, rate = term, sp.Integer(0)
        for power in [f for f in sp.Mul.make_args(sp.powsimp(term)) if isinstance(f, sp.exp)]:
            rate, size = (
                rate - power.exp.coeff(tau),
                sp.powsimp(sp.powsimp(size) / sp.exp(power.exp.coeff(tau) * tau)),
            )
        if size.has(tau) or rate.has(tau) or rate.is_nonnegative is not True:
            raise ValueError(
                f"correlation: expected a sum of terms D e^(-a {tau}) with a >= 0, got {term}"
                + (
                    " (give the symbols assumptions, positive=True)"
                    if term.free_symbols - {tau}
                    else ""
                )
            )
        terms[rate] = terms.get(rate, 0) + size
    for rate, variance in terms.items():
        if variance.is_positive is not True:
            raise ValueError(
                f"correlation: the term with the rate {rate} has the variance {variance}, which is "
                "not known to be positive"
            )
    rates, variances = list(terms), list(terms.values())
    return ShapingFilter(
        -sp.diag(*rates),
        sp.ones(1, len(rates)),
        sp.diag(*(2 * a * D for a, D in terms.items())),
        sp.diag(*variances),
    )


@dataclass(frozen=True)
class ShapedProcess:
    """A system with the states of its noise below its own: `A`, `Q`: square, of n + k; `H`: m x (n
    + k), None if no H was given; `noise_covariance`: k x k, with which the states of the noise
    begin."""

    A: object
    Q: object
    H: object
    noise_covariance: object


def with_shaping(A, shaping, B=None, Q=None, H=None, C=None):
    """The system x' = Ax + Bw + q, z = Hx + Cw + r with a noise w made by a shaping filter.

    `A`: n x n; `shaping`: `ShapingFilter` with k states; `B`: n x 1, where the noise enters the
    equations, None if it does not; `Q`: n x n, the intensity of a further white noise, None for
    none; `H`: m x n and `C`: m x 1, where it enters the measurements. Exact. Returns
    `ShapedProcess`. Raises ValueError for shapes that do not fit.

    >>> import sympy as sp
    >>> tau = sp.Symbol("tau")
    >>> found = with_shaping(0, shaping_filter(8*sp.exp(-tau), tau), B=1, H=1)    # problem 4.41
    >>> found.A, found.H
    (Matrix([
    [0,  1],
    [0, -1]]), Matrix([[1, 0]]))
    """
    if any_floats(A, B, Q, H, C):
        raise ValueError("A: expected exact matrices (SymPy)")
    A = read_square(A, "A", False)
    n, k = A.rows, shaping.A.rows
    B = sp.zeros(n, 1) if B is None else _column(B, "B", n)
    larger = stack(A.row_join(B * shaping.H), sp.zeros(k, n).row_join(shaping.A))
    noise = sp.diag(sp.zeros(n) if Q is None else read_matrix(Q, "Q", n, n, False), shaping.Q)
    output = None
    if H is not None:
        H = read_matrix(H, "H", None, n, False)
        C = sp.zeros(H.rows, 1) if C is None else _column(C, "C", H.rows)
        output = H.row_join(C * shaping.H)
    return ShapedProcess(larger, noise, output, shaping.covariance)


def _column(given, name, length):
    matrix = read_matrix(given, name, None, None, False)
    matrix = matrix.T if matrix.rows == 1 and length != 1 else matrix
    if matrix.shape != (length, 1):
        raise ValueError(
            f"{name}: expected a column of {length} entries, got the shape {tuple(matrix.shape)}"
        )
    return matrix
