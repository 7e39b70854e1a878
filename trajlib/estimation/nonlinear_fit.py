"""Nonlinear least squares for z = h(x) + r by the Gauss-Newton method.

Each step solves the linear problem z - h(x) = H dx + r, H the Jacobian at x. With S the sum of the
whitened residuals times the second derivatives of h, the iteration contracts by the largest modulus
of an eigenvalue of (H^T H)^-1 S at the solution: as fast as Newton's method only where the
residuals vanish or h is linear, and not at all from 1 on. So steps are shortened where they would
overshoot, and the limit is called a minimum only if H^T H - S is positive definite there.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import read_vector
from trajlib._arguments.symbols import exact_decimals, read_expression, read_symbols
from trajlib._numerical_rank import zero_level
from trajlib._typing import ArrayLike

#: How often a step is shortened before the misfit counts as no longer falling.
HALVINGS = 40


@dataclass(frozen=True)
class GaussNewton:
    """Result of the iteration; true in an `if` only if it converged to a local minimum.

    Attributes
    ----------
    estimate : ndarray, shape (n,)
        Last point.
    covariance : ndarray, shape (n, n)
        (H^T R^-1 H)^-1 there, the covariance of the error to first order.
    residuals : ndarray, shape (m,)
        z - h(x).
    misfit : float
        Their weighted sum of squares.
    steps : tuple of float
        Lengths of the steps.
    rate : float
        Factor by which undamped steps shrink near the solution; from 1 on they do not converge.
    converged : bool
        Whether a local minimum was reached.
    reason : str
        Outcome in words.
    """

    estimate: np.ndarray
    covariance: np.ndarray
    residuals: np.ndarray
    misfit: float
    steps: tuple
    rate: float
    converged: bool
    reason: str

    def __bool__(self):
        return self.converged

    def _repr_markdown_(self):
        return f"{self.reason}: {np.round(self.estimate, 8).tolist()}, misfit {self.misfit:.6g}"


def gauss_newton(
    h: Iterable,
    z: ArrayLike,
    variables: sp.Symbol | Iterable,
    start: ArrayLike,
    R: ArrayLike | None = None,
    *,
    tolerance: float = 1e-10,
    max_steps: int = 100,
) -> GaussNewton:
    """Return the minimum of (z - h(x))^T R^-1 (z - h(x)) near an initial guess.

    Parameters
    ----------
    h : iterable of sympy.Expr
        m expressions, whose first and second derivatives are formed exactly.
    z : array_like
        m measurements.
    variables : sympy.Symbol or iterable of sympy.Symbol
        n unknowns.
    start : array_like
        Initial guess, n numbers.
    R : array_like, shape (m, m), optional
        Covariance of r, positive definite; left out, the unit matrix.
    tolerance : float
        The iteration ends with a step shorter than this times the length of x (at least 1, and at
        least that of `start`).
    max_steps : int
        Largest number of steps.

    Returns
    -------
    GaussNewton
        In floats; check its truth value for convergence.

    Raises
    ------
    ValueError
        If the columns of the Jacobian are dependent at `start`, h is not finite there, or shapes do
        not fit.

    Notes
    -----
    MATLAB: ``lsqnonlin``, ``nlinfit``. Source: "Nonlinear least squares", section 4; its remark
    that the iteration is as fast as Newton's holds for vanishing residuals.

    Examples
    --------
    >>> import sympy as sp
    >>> x, y = sp.symbols("x y")
    >>> fit = gauss_newton([x**2 + y**2, x - y], [5, 1], [x, y], [1, 0])
    >>> bool(fit), fit.estimate.round(6).tolist(), fit.rate < 1e-9
    (True, [2.0, 1.0], True)
    """
    variables = read_symbols(variables, "variables")
    functions = sp.Matrix([exact_decimals(read_expression(e, "h")) for e in h])
    foreign = functions.free_symbols - set(variables)
    if foreign:
        raise ValueError(
            f"h: it also has {', '.join(sorted(map(str, foreign)))}; give these values"
        )
    m, n = functions.rows, len(variables)
    z = read_vector(z, "z", m, True)
    x = read_vector(start, "start", n, True)
    R = np.eye(m) if R is None else read_covariance(R, "R", m, True, definite=True)
    return _iterate(_Whitened(functions, z, variables, R), x, tolerance, max_steps)


class _Whitened:
    """Residuals, Jacobian and second derivatives, whitened by the Cholesky factor of R."""

    def __init__(self, h, z, variables, R) -> None:
        self.factor, self.z = np.linalg.cholesky(R), z
        n = len(variables)
        self.shape = (h.rows, n)
        second = [sp.hessian(entry, variables) for entry in h]
        self.functions = [
            sp.lambdify([variables], list(part), "numpy", cse=True)
            for part in (h, h.jacobian(variables), sp.Matrix.vstack(*second))
        ]

    def residuals(self, x):
        with np.errstate(all="ignore"):
            value = np.linalg.solve(self.factor, self.z - self._at(0, x))
        return value if np.isfinite(value).all() else np.full(len(value), np.inf)

    def jacobian(self, x):
        return np.linalg.solve(self.factor, self._at(1, x).reshape(self.shape))

    def curvature(self, x, residuals):
        """Return the sum of the residuals times the second derivatives, n x n."""
        second = self._at(2, x).reshape(len(residuals), -1)
        return (np.linalg.solve(self.factor.T, residuals) @ second).reshape(
            self.shape[1], self.shape[1]
        )

    def _at(self, k, x):
        return np.array(self.functions[k](x), dtype=float)


def _iterate(problem, x, tolerance, max_steps):
    residuals = problem.residuals(x)
    if not np.isfinite(residuals).all():
        raise ValueError(f"start: h is not finite at {x.tolist()}")
    unit, steps, reason = max(1.0, np.linalg.norm(x)), [], None
    while reason is None:
        H = problem.jacobian(x)
        if _dependent(H):
            if not steps:
                raise ValueError(
                    f"start: the columns of the Jacobian are dependent at {x.tolist()}, so there "
                    "is no step; start elsewhere, or measure more"
                )
            reason = f"not converged: the columns of the Jacobian become dependent at {x.tolist()}"
            break
        step = np.linalg.lstsq(H, residuals, rcond=None)[0]
        limit = tolerance * max(unit, np.linalg.norm(x))
        share, x_next, residuals_next = _shortened(
            problem, x, residuals, step, np.linalg.norm(H @ step) ** 2
        )
        steps.append(float(share * np.linalg.norm(step)))
        if share:
            x, residuals = x_next, residuals_next
        if np.linalg.norm(step) <= limit:
            reason = "converged"
        elif not share:
            reason = "not converged: no shorter step lowers the misfit"
        elif len(steps) >= max_steps:
            reason = f"not converged: after {max_steps} steps the last one still has the length {steps[-1]:.3g}"
    return _result(problem, x, residuals, steps, reason)


def _shortened(problem, x, residuals, step, descent):
    """Return the share of a step that lowers the misfit without overshooting, or 0.

    Also returned are the point and the residuals there. Near a minimum the misfit is flat to
    rounding, but its slope along the step is not: it begins at -descent, and a share is too long if
    it comes to more than half of that with the other sign.
    """
    share, misfit = 1.0, residuals @ residuals
    for _ in range(HALVINGS):
        point = x + share * step
        new_residuals = problem.residuals(point)
        if np.isfinite(new_residuals).all() and new_residuals @ new_residuals <= misfit * (
            1 + 1e-13
        ):
            slope = -(new_residuals @ (problem.jacobian(point) @ step))
            if slope <= descent / 2 + 1e-13 * misfit:
                return share, point, new_residuals
            share *= min(max(descent / (descent + slope), 0.1), 0.9)
        else:
            share /= 2
    return 0.0, x, residuals


def _dependent(H):
    lengths = np.linalg.norm(H, axis=0)
    if not np.isfinite(H).all() or not (lengths > 0).all() or H.shape[0] < H.shape[1]:
        return True
    values = np.linalg.svd(H / lengths, compute_uv=False)
    return values[-1] <= zero_level(*H.shape) * values[0]


def _result(problem, x, residuals, steps, reason):
    H, curvature = problem.jacobian(x), problem.curvature(x, residuals)
    normal, rate, covariance = H.T @ H, np.inf, np.full((len(x), len(x)), np.inf)
    if not _dependent(H):
        half = np.linalg.inv(np.linalg.qr(H)[1])
        covariance = half @ half.T
        rate = float(np.abs(np.linalg.eigvalsh(half.T @ curvature @ half)).max())
    if reason == "converged":
        lengths = np.sqrt(np.diag(normal))
        if np.linalg.eigvalsh((normal - curvature) / np.outer(lengths, lengths))[0] <= 0:
            reason = "not converged: the steps end at a stationary point that is no minimum of the misfit"
        else:
            reason = f"converged in {len(steps)} steps to a local minimum"
    return GaussNewton(
        x,
        covariance,
        problem.factor @ residuals,
        float(residuals @ residuals),
        tuple(steps),
        rate,
        reason.startswith("converged"),
        reason,
    )
