"""Shaping filters: correlated noise as the output of a linear system driven by white noise.

A process with the correlation D e^{-a |tau|} obeys w' = -aw + q with the intensity 2aD and the
initial variance D; for a = 0 it is a constant of the variance D. A sum of such correlations belongs
to a sum of independent processes. The states of the noise are then estimated together with those of
the system.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.matrices import read_matrix, read_square, require_exact
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import exact_decimals, read_expression, read_symbols
from trajlib._typing import MatrixLike, ScalarLike
from trajlib.estimation.exact_or_float import stack


@dataclass(frozen=True)
class ShapingFilter:
    """Linear system w' = A w + q with the output noise = H w.

    Attributes
    ----------
    A : sympy.Matrix, shape (k, k)
        Diagonal matrix of the system.
    H : sympy.Matrix, shape (1, k)
        Output matrix.
    Q : sympy.Matrix, shape (k, k)
        Intensity of q.
    covariance : sympy.Matrix, shape (k, k)
        Covariance of w at all times.
    """

    A: sp.Matrix
    H: sp.Matrix
    Q: sp.Matrix
    covariance: sp.Matrix

    def correlation(self, tau: ScalarLike) -> sp.Expr:
        """Return the correlation function of the noise.

        Parameters
        ----------
        tau : scalar_like
            Time difference, tau >= 0.

        Returns
        -------
        sympy.Expr
        """
        return sum(
            self.H[k] ** 2 * self.covariance[k, k] * sp.exp(self.A[k, k] * tau)
            for k in range(self.A.rows)
        )


def shaping_filter(correlation: sp.Expr, tau: sp.Symbol) -> ShapingFilter:
    """Return the system that makes a noise with a given correlation function from white noise.

    Parameters
    ----------
    correlation : sympy.Expr
        Even function, given for tau >= 0 as a sum of terms D e^{-a tau} with D > 0 and a >= 0
        (numbers, or symbols with assumptions).
    tau : sympy.Symbol
        Time difference.

    Returns
    -------
    ShapingFilter

    Raises
    ------
    ValueError
        If the function has another form.

    Notes
    -----
    Source: problems 4.41 - 4.43; "forming equation" in the hint to 4.43.

    Examples
    --------
    >>> import sympy as sp
    >>> tau = sp.Symbol("tau")
    >>> shaping = shaping_filter(8*sp.exp(-tau), tau)    # problem 4.41
    >>> shaping.A, shaping.Q, shaping.covariance
    (Matrix([[-1]]), Matrix([[16]]), Matrix([[8]]))
    """
    (tau,) = read_symbols(tau, "tau")
    correlation = exact_decimals(read_expression(correlation, "correlation"))
    terms: dict = {}
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
    """System augmented by the states of its noise, which stand below its own.

    Attributes
    ----------
    A : sympy.Matrix, shape (n + k, n + k)
        Matrix of the augmented system.
    Q : sympy.Matrix, shape (n + k, n + k)
        Intensity of its white noise.
    H : sympy.Matrix or None, shape (m, n + k)
        Measurement matrix, None if no H was given.
    noise_covariance : sympy.Matrix, shape (k, k)
        Initial covariance of the states of the noise.
    """

    A: sp.Matrix
    Q: sp.Matrix
    H: sp.Matrix | None
    noise_covariance: sp.Matrix


@accepts_state_space("A", time="continuous", instead="join the blocks with numpy.block")
def with_shaping(
    A: MatrixLike,
    shaping: ShapingFilter,
    B: MatrixLike = None,
    Q: MatrixLike = None,
    H: MatrixLike = None,
    C: MatrixLike = None,
) -> ShapedProcess:
    """Return the system x' = Ax + Bw + q, z = Hx + Cw + r augmented by a shaping filter for w.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system, exact.
    shaping : ShapingFilter
        Shaping filter with k states.
    B : matrix_like, shape (n, 1), optional
        Where the noise enters the equations; left out, it does not.
    Q : matrix_like, shape (n, n), optional
        Intensity of a further white noise.
    H : matrix_like, shape (m, n), optional
        Measurement matrix.
    C : matrix_like, shape (m, 1), optional
        Where the noise enters the measurements.

    Returns
    -------
    ShapedProcess

    Raises
    ------
    ValueError
        If shapes do not fit or a matrix is an array.

    Examples
    --------
    >>> import sympy as sp
    >>> tau = sp.Symbol("tau")
    >>> process = with_shaping(0, shaping_filter(8*sp.exp(-tau), tau), B=1, H=1)    # problem 4.41
    >>> process.A, process.H
    (Matrix([
    [0,  1],
    [0, -1]]), Matrix([[1, 0]]))
    """
    require_exact("join the blocks with numpy.block", A=A, B=B, Q=Q, H=H, C=C)
    A = read_square(A, "A", False)
    n, k = A.rows, shaping.A.rows
    B = sp.zeros(n, 1) if B is None else _column(B, "B", n)
    augmented = stack(A.row_join(B * shaping.H), sp.zeros(k, n).row_join(shaping.A))
    intensity = sp.diag(sp.zeros(n) if Q is None else read_matrix(Q, "Q", n, n, False), shaping.Q)
    output = None
    if H is not None:
        H = read_matrix(H, "H", None, n, False)
        C = sp.zeros(H.rows, 1) if C is None else _column(C, "C", H.rows)
        output = H.row_join(C * shaping.H)
    return ShapedProcess(augmented, intensity, output, shaping.covariance)


def _column(entries, name, length):
    matrix = read_matrix(entries, name, None, None, False)
    matrix = matrix.T if matrix.rows == 1 and length != 1 else matrix
    if matrix.shape != (length, 1):
        raise ValueError(
            f"{name}: expected a column of {length} entries, got the shape {tuple(matrix.shape)}"
        )
    return matrix
