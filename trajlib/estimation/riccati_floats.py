"""Algebraic Riccati equations in floats: balanced, solved, refined, with an estimate of the error.

    0 = A P + P A^T + Q - P H^T R^-1 H P              or        P = A P A^T + Q - A P H^T (H P H^T + R)^-1 H P A^T

States are measured in units (powers of two, which cost no digit) that balance the Hamiltonian
matrix, outputs in those of their noise. A first P comes from the stable invariant subspace of that
matrix (A. J. Laub, 1979), or from the doubling algorithm (E. K.-W. Chu, H.-Y. Fan, W.-W. Lin, 2005).
Newton's method (D. L. Kleinman, 1968) refines it: with the gain K of P and F = A - KH

    F D + D F^T = -S(P),   S(P) = F P + P F^T + Q + K R K^T,    P <- P + D,

or F D F^T - D = -S(P), S(P) = F P F^T + Q + K R K^T - P. An error of K enters S in second order only.
S, the small difference of large terms, and P itself are computed in twice the precision
(`compensated`), and the equation for D in coordinates in which P is near the identity, since D needs
few correct digits only. So P + D is nearly always exact but for its own rounding, and what the last
step changes, with that rounding, is the estimate of the error.
"""

import warnings
from contextlib import suppress
from copy import copy
from typing import NamedTuple

import numpy as np

from trajlib.estimation.compensated import negative, pair, product, total, transpose

#: Steps of Newton's method and of the doubling algorithm; both converge quadratically.
STEPS = 40
#: The estimate is this multiple of what the last step changes.
SAFETY = 4
#: How much more noise, beside what is given, makes an equation easy to solve.
MORE_NOISE = 1e8
#: A slower decay, a greater error and a greater norm of P in balanced units are doubtful: a mode may
#: be unmeasured, or free of noise on the border of stability, but for rounding.
SLOW, ROUGH, LARGE = 1e-8, 1e-8, 1e24
EPS = np.finfo(float).eps


class RiccatiSolution(NamedTuple):
    """The stabilising solution, and how well it is known.

    `gain` is that of the correction, K = P H^T R^-1 or P H^T (H P H^T + R)^-1, `loop` A - KH or A (I - KH).
    `residual` is the norm of what is left of the equation beside the norms of the factors of its terms,
    `error` an estimate of |dP|/|P|, in Frobenius norms and the greater of those in the given and in
    balanced units. `doubtful` if an equation that has no such solution may look like this one.
    """

    P: np.ndarray
    gain: np.ndarray
    loop: np.ndarray
    residual: float
    error: float
    doubtful: bool


def solve_riccati(A, H, Q, R, discrete):
    """Return the `RiccatiSolution` for arrays, or None if none was found."""
    noise = _powers_of_two(np.sqrt(np.diag(R)))
    H, R = H / noise[:, None], R / np.outer(noise, noise)
    units = _units(A, H.T @ np.linalg.solve(R, H), Q)
    equation = _Equation(
        A * units / units[:, None], H * units, Q / np.outer(units, units), R, discrete
    )
    for start in (_zero, _by_subspace, _by_doubling, _with_more_noise):
        # Ill-conditioned steps are no error: the result is judged by its own residual. A ValueError,
        # as LinAlgError is one, says that a step is singular or no longer finite.
        with np.errstate(all="ignore"), warnings.catch_warnings(), suppress(ValueError):
            warnings.simplefilter("ignore")
            refined = _refined(equation, start(equation), units)
            if refined is None:
                continue
            return refined._replace(
                P=refined.P * np.outer(units, units),
                gain=refined.gain * units[:, None] / noise,
                loop=refined.loop * units[:, None] / units,
            )
    return None


class _Equation:
    """The equation in balanced units."""

    def __init__(self, A, H, Q, R, discrete):
        self.A, self.H, self.Q, self.R, self.discrete = A, H, Q, R, discrete

    def gain(self, P):
        """Return the gain of the correction, as a pair."""
        from scipy.linalg import cho_factor, cho_solve

        shown, spread = product(pair(self.H), P), pair(self.R)
        if self.discrete:
            spread = total(product(shown, pair(self.H.T)), spread)
        factor = cho_factor(spread[0])
        gain = pair(cho_solve(factor, shown[0]))
        for _ in range(2):
            remainder = total(shown, negative(product(spread, gain)))
            gain = total(gain, pair(cho_solve(factor, remainder[0])))
        return transpose(gain)

    def loop(self, gain):
        """Return the gain that enters the error equations, and their matrix F, as pairs."""
        gain = product(pair(self.A), gain) if self.discrete else gain
        return gain, total(pair(self.A), negative(product(gain, pair(self.H))))

    def remainder(self, gain, loop, P):
        """Return S(P), and the sum of the norms of its terms: for a product those of its factors."""
        noise = product(gain, pair(self.R), transpose(gain))
        term = product(loop, P)
        if self.discrete:
            terms = [product(term, transpose(loop)), negative(P)]
        else:
            terms = [term, transpose(term)]
        terms += [pair(self.Q), noise]
        size, weight = np.linalg.norm(loop[0]), np.linalg.norm(P[0])
        size = weight * (1 + size**2) if self.discrete else 2 * weight * size
        return total(*terms)[0], size + np.linalg.norm(self.Q) + np.linalg.norm(noise[0])

    def applied(self, loop, D):
        """Return F D + D F^T or F D F^T - D."""
        return loop @ D @ loop.T - D if self.discrete else loop @ D + D @ loop.T

    def correction(self, loop, remainder):
        """Return the D for which `applied` is -S."""
        from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

        if self.discrete:
            return solve_discrete_lyapunov(loop, remainder)
        return solve_continuous_lyapunov(loop, -remainder)

    def decay(self, loop):
        """Return how fast the slowest mode decays, beside the fastest; not positive if it does not."""
        values = np.linalg.eigvals(loop)
        if self.discrete:
            return 1 - np.abs(values).max()
        return -values.real.max() / (np.abs(values).max() or 1)


def _refined(equation, P, units):
    """Return the solution from a first P by Newton's method, or None if it does not converge."""
    if P is None or not np.isfinite(P).all():
        return None
    P, last = pair((P + P.T) / 2), np.inf
    for _ in range(STEPS):
        gain = equation.gain(P)
        pushed, loop = equation.loop(gain)
        remainder, terms = equation.remainder(pushed, loop, P)
        axes = _axes(P[0])
        back = np.linalg.inv(axes)
        inner = back @ loop[0] @ axes
        if not np.isfinite(inner).all() or not (decay := equation.decay(inner)) > 0:
            return None
        D = axes @ equation.correction(inner, back @ remainder @ back.T) @ axes.T
        change, wrong = _beside(D, P[0], units), _beside(P[1] + D, P[0], units)
        if change < EPS / 16 or last / 2 <= change < 1e-3:
            break
        P, last = total(P, pair((D + D.T) / 2)), change
    if not wrong * SAFETY < 0.1:
        return None
    residual = np.linalg.norm(remainder - equation.applied(loop[0], P[1])) / (terms or 1)
    error = float(SAFETY * wrong + EPS)
    doubtful = decay < SLOW or error > ROUGH or np.linalg.norm(P[0]) > LARGE
    return RiccatiSolution(P[0], gain[0], loop[0], float(residual), error, bool(doubtful))


def _axes(P):
    """Return coordinates in which P is the identity, where rounding leaves it positive."""
    values, vectors = np.linalg.eigh(P)
    largest = values[-1] if values[-1] > 0 else 1.0
    return vectors * np.sqrt(np.maximum(values, 1e-15 * largest))


def _beside(D, P, units):
    """Return |D|/|P| in balanced units or in those given, whichever is greater."""
    size = np.outer(units, units)
    return max(
        np.linalg.norm(D * scale) / (np.linalg.norm(P * scale) or 1) for scale in (1.0, size)
    )


def _zero(equation):
    """Return P = 0 where there is no noise; it is the solution if A is stable."""
    return None if equation.Q.any() else equation.Q


def _by_subspace(equation):
    """Return P from the stable invariant subspace (E; P), or None."""
    import scipy.linalg

    A, H, Q, R = equation.A, equation.H, equation.Q, equation.R
    if equation.discrete:
        return scipy.linalg.solve_discrete_are(A.T, H.T, Q, R)
    matrix = np.block([[A.T, -H.T @ np.linalg.solve(R, H)], [-Q, -A]])
    _, basis, stable = scipy.linalg.schur(matrix, sort="lhp")
    n = len(A)
    return np.linalg.solve(basis[:n, :n].T, basis[n:, :n].T) if stable == n else None


def _by_doubling(equation):
    """Return P by the doubling algorithm for X = A^T X (E + G X)^-1 A + Q, or None."""
    A, G, Q = equation.A.T, equation.H.T @ np.linalg.solve(equation.R, equation.H), equation.Q
    identity = np.eye(len(A))
    if not equation.discrete:  # the Cayley transformation has the same solution
        rate = np.linalg.norm(np.block([[A, G], [Q, A]]), 2)
        back = np.linalg.inv(A - rate * identity)
        schur_inverse = np.linalg.inv((A - rate * identity).T + Q @ back @ G)
        A, G, Q = (
            identity + 2 * rate * schur_inverse.T,
            2 * rate * back @ G @ schur_inverse,
            2 * rate * schur_inverse @ Q @ back,
        )
    for _ in range(2 * STEPS):
        step = np.linalg.solve(identity + G @ Q, np.hstack([A, G]))
        ahead, spread = step[:, : len(A)], step[:, len(A) :]
        growth = A.T @ Q @ ahead
        G, Q, A = G + A @ spread @ A.T, Q + growth, A @ ahead
        G, Q = (G + G.T) / 2, (Q + Q.T) / 2
        if not np.linalg.norm(growth) > EPS * np.linalg.norm(Q):
            break
    return Q


def _with_more_noise(equation):
    """Return P of an equation with more noise, whose gain is stabilising too, or None.

    The more noise drives the states, the less the variances differ.
    """
    louder = copy(equation)
    louder.Q = equation.Q + MORE_NOISE * np.linalg.norm(equation.Q) * np.eye(len(equation.A))
    return _by_subspace(louder)


def _units(A, G, Q):
    """Return units of the states that balance the Hamiltonian matrix."""
    from scipy.linalg import matrix_balance

    n = len(A)
    sizes = np.abs(np.block([[A, Q], [G, A.T]]))
    np.fill_diagonal(sizes, 0)
    scale = matrix_balance(sizes, permute=False, separate=True)[1][0]
    units = _powers_of_two(np.sqrt(scale[:n] / scale[n:]))
    # A weak measurement makes a large P: both ends of its range are brought equally far from 1.
    weights = [np.linalg.norm(M) for M in (Q / np.outer(units, units), G * np.outer(units, units))]
    return units * (_powers_of_two((weights[0] / weights[1]) ** 0.25) if all(weights) else 1.0)


def _powers_of_two(sizes):
    return np.exp2(np.rint(np.log2(sizes)))
