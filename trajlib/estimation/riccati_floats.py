"""Algebraic Riccati equations in floats: balanced, solved, refined, and judged.

    0 = A P + P A^T + Q - P H^T R^-1 H P              or        P = A P A^T + Q - A P H^T (H P H^T + R)^-1 H P A^T

States are measured in units (powers of two, which cost no digit) that balance the Hamiltonian
matrix, outputs in those of their noise. A first P comes from the stable invariant subspace of that
matrix (A. J. Laub, 1979), or from the doubling algorithm (E. K.-W. Chu, H.-Y. Fan, W.-W. Lin, 2005).
Newton's method (D. L. Kleinman, 1968) refines it: with S(P) what is left of the equation, the gain K
of P and F = A - KH

    F D + D F^T = -S(P)    or    F D F^T - D = -S(P),    P <- P + D.

S, the small difference of large terms, is computed in twice the precision (`compensated`), and the
equation for D is solved in coordinates in which P is near the identity, since D needs few correct
digits only. So P + D is nearly always exact but for its own rounding.

Whether there is a stabilising solution, and how near it is, follows from one inequality (L. V.
Kantorovich, 1948). Let F be stable, l the norm of the inverse of D -> F D + D F^T, s that of H^T R^-1 H and
r that of S(P). If 4 l^2 s r < 1, there is one within 2 l r of P. Then the Hamiltonian matrix has no
eigenvalue on the imaginary axis. In discrete time s is the norm of H^T (H P H^T + R)^-1 H, and if
16 l^2 s r max(1, |F|^2) < 1, the symplectic pencil has no eigenvalue on the unit circle. With r
enlarged by what the rounding of A, H, Q and R may change, and F stable after such a change too, the
verdict is that for all such data.
"""

import warnings
from copy import copy
from typing import NamedTuple

import numpy as np
from numpy.linalg import norm

from trajlib.estimation.compensated import product, total

#: Steps of Newton's method and of the doubling algorithm; both converge quadratically.
STEPS = 40
#: The estimate is this multiple of the bound for the error, or of what the last step changes.
SAFETY = 4
#: How much more noise, beside what is given, makes an equation easy to solve.
MORE_NOISE = 1e8
#: Room for the blocked algorithms of LAPACK, for each row.
WORK = 64
#: For a semidefinite Q a slower decay, a greater error and a greater norm of P in balanced units are
#: doubtful: a mode may be unmeasured, or free of noise on the border of stability, but for rounding.
SLOW, ROUGH, LARGE = 1e-8, 1e-8, 1e24
EPS = np.finfo(float).eps


class RiccatiSolution(NamedTuple):
    """The stabilising solution, and how well it is known.

    `gain` is that of the correction, K = P H^T R^-1 or P H^T (H P H^T + R)^-1, `loop` A - KH or A (I - KH).
    `residual` is the norm of what is left of the equation beside the norms of the factors of its terms,
    `error` an estimate of |dP|/|P|, in Frobenius norms and the greater of those in the given and in
    balanced units. `certain` unless an equation that has no such solution may look like this one.
    """

    P: np.ndarray
    gain: np.ndarray
    loop: np.ndarray
    residual: float
    error: float
    certain: bool


def stabilising_solution(A, H, Q, R, discrete, definite, obstacle):
    """Return the `RiccatiSolution` for arrays, or in words why there is none.

    No solution of an algebraic Riccati equation in floats is returned but by this function. If Q is
    semidefinite, which is called `definite`, rank tests decide whether there is one. They are asked by
    `obstacle()`, which returns the reason or None, only where a mode may be hidden but for rounding:
    they take many times as long. If Q is indefinite the inequality decides; where it does not hold,
    `obstacle()` returns a reason that it found otherwise, or raises LinAlgError.
    """
    solution = _solve(A, H, Q, R, discrete, definite)
    if solution is not None and solution.certain:
        return solution
    reason = obstacle()
    if reason is None and solution is None:
        raise np.linalg.LinAlgError(
            "not found: the Riccati equation has a stabilising solution (by the rank tests no mode is "
            "in its way), but its entries differ by more than floats can hold, since a mode is hardly "
            "measured, hardly controlled or hardly driven; change that, or give exact entries (SymPy)"
        )
    return reason or solution


def _solve(A, H, Q, R, discrete, definite):
    """Return the `RiccatiSolution`, or None if none was found."""
    noise = _powers_of_two(np.sqrt(R.diagonal()))
    H, R = H / noise[:, None], R / (noise[:, None] * noise)
    units = _units(A, H.T @ np.linalg.solve(R, H), Q)
    scale = units[:, None] * units
    balanced = (A * units / units[:, None], H * units, Q / scale, R)
    equation = (_Discrete if discrete else _Continuous)(*balanced)
    # Ill-conditioned steps are no error: the result is judged by its own residual.
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for start in (_zero, _by_subspace, _by_doubling, _with_more_noise):
            try:
                P = start(equation)
                refined = None if P is None else _refined(equation, P, units, definite)
            except ValueError:  # as LinAlgError is one: a step is singular or no longer finite
                continue
            if refined is not None:
                P, gain, loop, *known = refined
                gain, loop = gain * units[:, None] / noise, loop * units[:, None] / units
                return RiccatiSolution(P * scale, gain, loop, *known)
    return None


class _Point(NamedTuple):
    """The equation at one P.

    `remainder` is S(P), `terms` the sum of the norms of the factors of its terms, and `push` H^T R^-1, in
    discrete time H^T (H P H^T + R)^-1.
    """

    gain: np.ndarray
    loop: np.ndarray
    remainder: np.ndarray
    terms: float
    push: np.ndarray


class _Equation:
    """The equation in balanced units."""

    def __init__(self, A, H, Q, R):
        self.A, self.H, self.Q, self.R = A, H, Q, R

    def corrected(self, P, shown, weight):
        """Return the gain K, its share of P to be subtracted, as a pair, and `push`.

        For a weight W and Y = HP that share is Y^T W^-1 Y. With the rounded K and E = W K^T - Y it is
        K(Y - E)/2, its transpose and E^T W^-1 E, in which E needs no more digits.
        """
        from scipy.linalg.lapack import dpotrf, dpotrs

        factor, failed = dpotrf(weight[0])
        if failed:
            raise np.linalg.LinAlgError("H P H^T + R is not positive definite")
        gain = dpotrs(factor, shown[0])[0].T
        high, low = total(product(weight, gain.T), (-shown[0], -shown[1]))
        fault = high + low
        high, low = total(shown, (-fault, 0.0))
        high, low = product(gain / 2, (high, low))
        square = fault.T @ dpotrs(factor, fault)[0]
        share = total((high, low), (high.T, low.T), (square, 0.0))
        return gain, share, dpotrs(factor, self.H)[0].T


class _Continuous(_Equation):
    def at(self, P):
        A, H, Q, R = self.A, self.H, self.Q, self.R
        shown = product(H, P)
        gain, share, push = self.corrected(P, shown, (R, np.zeros_like(R)))
        high, low = product(A, P)
        high, low = total((high, low), (high.T, low.T), (Q, 0.0), (-share[0], -share[1]))
        P = P[0]
        loop = A - gain @ H
        terms = 2 * norm(loop) * norm(P) + norm(Q) + norm(gain @ R @ gain.T)
        return _Point(gain, loop, high + low, terms, push)

    def rounding(self, P, point):
        """Return bounds for what the rounding of the data changes in S(P) and in F, beside EPS."""
        gain, P = np.abs(point.gain), np.abs(P)
        loop = np.abs(self.A) + gain @ np.abs(self.H)
        half = loop @ P + gain @ np.abs(self.R) @ gain.T / 2
        return half + half.T + np.abs(self.Q), loop

    def linear(self, F):
        """Return how fast the slowest mode decays beside the fastest, and the solver for D."""
        from scipy.linalg.lapack import dgees, dtrsyl

        T, _, real, imaginary, U, _, _ = dgees(_no_order, F, lwork=WORK * len(F))

        def solve(C):
            D, scale, _ = dtrsyl(T, T, U.T @ C @ U, tranb="T")
            return U @ D @ U.T / -scale

        return -real.max() / (np.hypot(real, imaginary).max() or 1), solve

    def applied(self, F, D):
        """Return the left side of the linear equation for D."""
        return F @ D + D @ F.T

    def square(self, F, spread):
        """Return a bound for the part of S(P + D) that is quadratic in D, beside |D|^2."""
        return spread

    def contraction(self, F, inverse, spread, remainder):
        """Return what has to be less than 1 for a stabilising solution."""
        return 4 * inverse**2 * spread * remainder

    def weakening(self, F, change):
        """Return how much a change of F changes in the linear equation, beside |D|."""
        return 2 * change

    def improved(self, point, D):
        """Return gain and loop for P + D."""
        gain = point.gain + D @ point.push
        return gain, self.A - gain @ self.H


class _Discrete(_Equation):
    def at(self, P):
        A, H, Q, R = self.A, self.H, self.Q, self.R
        shown = product(H, P)
        weight = total(product(shown, H.T), (R, 0.0))
        gain, share, push = self.corrected(P, shown, weight)
        kept = total(P, (-share[0], -share[1]))
        high, low = total(product(product(A, kept), A.T), (Q, 0.0), (-P[0], -P[1]))
        P = P[0]
        ahead = A @ gain
        loop = A - ahead @ H
        terms = norm(P) * (1 + norm(loop) ** 2) + norm(Q) + norm(ahead @ R @ ahead.T)
        return _Point(gain, loop, high + low, terms, push)

    def rounding(self, P, point):
        A, ahead = np.abs(self.A), np.abs(self.A @ point.gain)
        loop = A + ahead @ np.abs(self.H)
        kept = P - point.gain @ (self.H @ P)
        half = A @ np.abs(kept) @ A.T + ahead @ (
            np.abs(self.H) @ np.abs(P) @ np.abs(point.loop.T) + np.abs(self.R) @ ahead.T / 2
        )
        return half + half.T + np.abs(self.Q), loop

    def linear(self, F):
        from scipy.linalg import solve_discrete_lyapunov

        return 1 - np.abs(np.linalg.eigvals(F)).max(), lambda C: solve_discrete_lyapunov(F, C)

    def applied(self, F, D):
        return F @ D @ F.T - D

    def square(self, F, spread):
        return 2 * spread * norm(F) ** 2

    def contraction(self, F, inverse, spread, remainder):
        return 16 * inverse**2 * spread * remainder * max(1, norm(F) ** 2)

    def weakening(self, F, change):
        return change * (2 * norm(F) + change)

    def improved(self, point, D):
        gain = point.gain + (D - point.gain @ (self.H @ D)) @ point.push
        return gain, self.A - (self.A @ gain) @ self.H


def _refined(equation, P, units, definite):
    """Return the fields of the solution from a first P, or None if Newton's method does not converge."""
    if not np.isfinite(P).all():
        return None
    P, last = ((P + P.T) / 2, np.zeros_like(P)), np.inf
    for _ in range(STEPS):
        point = equation.at(P)
        axes, back = _axes(P[0])
        F, remainder = back @ point.loop @ axes, back @ point.remainder @ back.T
        if not np.isfinite(F).all():
            return None
        decay, solve = equation.linear(F)
        if not decay > 0:
            return None
        inner, inverse = solve(remainder), norm(solve(np.eye(len(F))))
        spread = norm(axes.T @ point.push @ (equation.H @ axes))
        D = axes @ inner @ axes.T
        D = (D + D.T) / 2
        size = norm(inner)
        rounding, of_loop = equation.rounding(P[0], point)
        change_of_loop = EPS * norm(np.abs(back) @ of_loop @ np.abs(axes))
        left = norm(remainder)
        if not definite:
            left += EPS * norm(np.abs(back) @ rounding @ np.abs(back.T))
        weakening = equation.weakening(F, change_of_loop)
        solvable = inverse * weakening < 1 and equation.contraction(F, inverse, spread, left) < 1
        # What is wrong in D: the linear equation, its two sides, and what is quadratic in D.
        unsolved = norm(equation.applied(F, inner) + remainder)
        sides = weakening * size + EPS * norm(
            np.abs(back) @ np.abs(point.remainder) @ np.abs(back.T)
        )
        square = equation.square(F, spread) * size**2
        bound = inverse * (unsolved + sides + square) * len(F) ** 0.5
        if solvable and bound < EPS:
            change = bound
            break
        change = _beside(D, P[0], units)
        if last / 2 <= change < 1e-3:
            break
        P, last = total(P, (D, 0.0)), change
    if not SAFETY * change < 0.1:
        return None
    rounded = P[0] + (P[1] + D)
    moved = (rounded - P[0]) - P[1]
    residual = norm(point.remainder + equation.applied(point.loop, moved)) / (point.terms or 1)
    gain, loop = equation.improved(point, D)
    error = float(SAFETY * change + EPS)
    if definite:
        solvable = decay >= SLOW and error <= ROUGH and norm(P[0]) <= LARGE
    return rounded, gain, loop, float(residual), error, bool(solvable)


def _axes(P):
    """Return coordinates in which P is diagonal with 1 or -1, and the way back, where it is regular."""
    values, vectors = np.linalg.eigh(P)
    sizes = np.abs(values)
    roots = np.sqrt(np.maximum(sizes, 1e-15 * sizes.max())) if sizes.any() else np.ones(len(P))
    return vectors * roots, (vectors / roots).T


def _beside(D, P, units):
    """Return |D|/|P| in balanced units or in those given, whichever is greater."""
    size = units[:, None] * units
    return max(norm(D) / (norm(P) or 1), norm(D * size) / (norm(P * size) or 1))


def _zero(equation):
    """Return P = 0 where there is no noise; it is the solution if A is stable."""
    return None if equation.Q.any() else equation.Q


def _by_subspace(equation):
    """Return P from the stable invariant subspace (E; P), or None."""
    A, H, Q, R = equation.A, equation.H, equation.Q, equation.R
    if isinstance(equation, _Discrete):
        from scipy.linalg import solve_discrete_are

        return solve_discrete_are(A.T, H.T, Q, R)
    from scipy.linalg.lapack import dgees, dtrsen

    n = len(A)
    matrix = _blocks(A.T, -H.T @ np.linalg.solve(R, H), -Q, -A)
    T, _, real, _, basis, _, _ = dgees(_no_order, matrix, lwork=WORK * 2 * n)
    if (real < 0).sum() != n:
        return None
    _, basis, _, _, _, _, _, failed = dtrsen(real < 0, T, basis, job="N")
    return None if failed else np.linalg.solve(basis[:n, :n].T, basis[n:, :n].T)


def _by_doubling(equation):
    """Return P by the doubling algorithm for X = A^T X (E + G X)^-1 A + Q, or None."""
    A, G, Q = equation.A.T, equation.H.T @ np.linalg.solve(equation.R, equation.H), equation.Q
    identity = np.eye(len(A))
    if isinstance(equation, _Continuous):  # the Cayley transformation has the same solution
        rate = np.linalg.norm(_blocks(A, G, Q, A), 2)
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
    from scipy.linalg.lapack import dgebal

    n = len(A)
    sizes = np.abs(_blocks(A, Q, G, A.T))
    np.fill_diagonal(sizes, 0)
    scale = dgebal(sizes, scale=1)[3]
    units = _powers_of_two(np.sqrt(scale[:n] / scale[n:]))
    # A weak measurement makes a large P: both ends of its range are brought equally far from 1.
    square = units[:, None] * units
    noise, measurement = norm(Q / square), norm(G * square)
    return units * (_powers_of_two((noise / measurement) ** 0.25) if noise and measurement else 1.0)


def _blocks(A, B, C, D):
    return np.concatenate([np.concatenate([A, B], axis=1), np.concatenate([C, D], axis=1)])


def _no_order(real, imaginary):
    """Leave the eigenvalues in the order of LAPACK."""


def _powers_of_two(sizes):
    return np.exp2(np.rint(np.log2(sizes)))
