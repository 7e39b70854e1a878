"""Pole placement in floating point, with an estimate of its accuracy.

With one control the gain is unique, K = -e^T W^-1 psi(A) (Ackermann), and only the arithmetic is in
question. The formula loses as many digits as Kalman's matrix W has in its condition, thirty and
more for n = 40. So it is computed with many digits, and again with twice as many, until both agree
to all those of a float; bad units cost nothing, since these numbers have no bounds on their
exponents. The rounding of K to floats is all the error that is left. It can be too much by itself:
to move thirty eigenvalues of a general matrix by one control takes a gain so large that its last
digit moves them by more than their size. Then no gain of floats is good.

With several controls the gain is chosen for well-conditioned eigenvectors, by
`scipy.signal.place_poles` (A. L. Tits and Y. Yang, 1996). That refuses an eigenvalue which comes
more often than there are controls, since eigenvectors are then missing. In this case Jordan chains
are prescribed: A X + B G = X J, K = G X^-1 (S. P. Bhattacharyya and E. de Souza, 1982), for several
G. SciPy's eigenvectors are left a little off by its search; they are corrected once.

Of the gains found, SciPy's in the given units among them, the one is returned whose loop comes
closest; for one control the exact one, rounded, unless SciPy's is ten times closer: then the digits
of floats have ended, and a smaller gain does less harm.

The accuracy of a gain is judged by the rational function

    h(z) = det(I - K (zI - A)^-1 B) = det(zI - A - BK)/det(zI - A)    and
    f(z) = prod(z - lambda_i)/det(zI - A),

which needs the resolvent of A only, not that of the loop. If |h - f| < |f| on a circle, A + BK has as
many eigenvalues within as are prescribed there (E. Rouche). The least circles about the prescribed
values for which this is so, whatever the rounding of h and f, give the uncertainty, also where
eigenvectors are missing: there an eigenvalue in a chain of k moves like the k-th root of a change.
"""

import warnings
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

import mpmath
import numpy as np

from trajlib._arguments.matrices import read_controlled
from trajlib._arguments.state_space import accepts_state_space
from trajlib._numerical_rank import zero_level
from trajlib._typing import MatrixLike
from trajlib.structure.rank_tests import controllability
from trajlib.structure.scaling import balanced

#: Decimal digits of the first attempt, and those that are no longer doubled.
FIRST, LAST = 50, 1600
#: Two computations agree if no entry of the gain differs by more than this share.
AGREED = 1e-18
#: How many matrices G are tried for Jordan chains.
TRIED = 40
#: From this ratio of units on, SciPy is asked in balanced units as well.
UNEVEN = 100
#: How much closer another gain may come by the chance of its last digits.
LUCK = 10
EPS = np.finfo(float).eps
#: Points of the upper half of the circles.
CIRCLE = np.exp(1j * np.pi * np.linspace(0, 1, 9))


@dataclass(frozen=True)
class Placement:
    """A gain of floats with the accuracy of the eigenvalues that it gives.

    Attributes
    ----------
    gain : numpy.ndarray, shape (s, n)
        K of u = Kx.
    requested : numpy.ndarray, shape (n,)
        The eigenvalues asked for.
    reached : numpy.ndarray, shape (n,)
        The eigenvalues of A + BK as NumPy computes them, in the order of `requested`.
    distance : float
        The greatest distance between the two.
    residual : float
        The greatest share of its norm by which A + BK, in balanced units, has to be changed so that an
        eigenvalue asked for is exact; of the size of rounding, 1e-16, at best.
    condition : float
        Condition number of the eigenvectors of A + BK, in the same units; infinite or huge if some are
        missing, as for an eigenvalue that is repeated more often than there are controls.
    uncertainty : float
        Bound for the distance of the eigenvalues of A + BK, for this K of floats and without the rounding
        of their computation, from those asked for; for one control with the gain that would be exact,
        rounded. Where it is not small beside the eigenvalues, no gain of floats does better.
    """

    gain: np.ndarray
    requested: np.ndarray
    reached: np.ndarray
    distance: float
    residual: float
    condition: float
    uncertainty: float


@accepts_state_space("A", "B", p="eigenvalues")
def place(A: MatrixLike, B: MatrixLike, eigenvalues: Sequence[complex]) -> Placement:
    """Return a gain K of floats such that A + BK has given eigenvalues, repeated ones too.

    Parameters
    ----------
    A : array_like, shape (n, n)
        Matrix of x' = Ax + Bu. A python-control StateSpace stands for A and B:
        `place(sys, eigenvalues)`.
    B : array_like, shape (n, s)
        Matrix of the control.
    eigenvalues : sequence of n numbers
        The eigenvalues of A + BK, conjugate ones in pairs.

    Returns
    -------
    Placement
        The gain and its accuracy.

    Raises
    ------
    ValueError
        If the pair is not controllable (the message names the mode that cannot be moved), if the
        eigenvalues are not n finite numbers or not in pairs, or if no gain was placement.

    Notes
    -----
    Keywords of python-control: `p` for `eigenvalues`.
    The sign is u = Kx. For an observer L = -place(A.T, H.T, eigenvalues).gain.T. MATLAB:
    ``-place(A, B, p)``, ``-acker(A, B, p)``. Source: Theorem 3.3 of the problem book.

    Examples
    --------
    >>> import numpy as np
    >>> placement = place(np.array([[0.0, 1.0], [1.0, 0.0]]), np.array([[0.0], [1.0]]), [-1, -1])
    >>> print(placement.gain)
    [[-2. -2.]]
    >>> placement.residual < 1e-15, placement.condition > 1e7
    (True, True)
    """
    dual, dual_inputs = read_controlled(A, B)
    A, B = np.array(dual.tolist(), dtype=float).T, np.array(dual_inputs.tolist(), dtype=float).T
    prescribed = _read(eigenvalues, len(A))
    test = controllability(A, B)
    if not test:
        raise ValueError(
            f"A, B: {test.reason}; only what is controllable can be placed "
            "(controllability_decomposition splits it off)"
        )
    gains = [_scipy(A, B, prescribed)]
    if B.shape[1] == 1:
        gains.insert(0, _single(A, B[:, 0], prescribed)[None, :])
    elif gains[0] is None:
        gains.append(_in_good_units(_by_chains, A, B, prescribed))
    else:
        if _uneven(A, B):
            gains.append(_in_good_units(_scipy, A, B, prescribed))
        gains += [_again(A, B, gain, prescribed) for gain in gains if gain is not None]
    placed = [_judged(A, B, gain, prescribed) for gain in gains if gain is not None]
    if not placed:
        raise ValueError("eigenvalues: no gain was found that gives them")
    best = min(placed, key=lambda placement: placement.distance)
    if B.shape[1] > 1:
        return best
    return (
        placed[0]
        if placed[0].distance < LUCK * best.distance
        else replace(best, uncertainty=placed[0].uncertainty)
    )


def _read(eigenvalues, n):
    prescribed = np.array([complex(value) for value in eigenvalues])
    if len(prescribed) != n:
        raise ValueError(f"eigenvalues: expected {n} numbers, got {len(prescribed)}")
    if not np.isfinite(prescribed).all():
        wrong = prescribed[~np.isfinite(prescribed)][0]
        raise ValueError(f"eigenvalues: expected finite numbers, got {wrong:g}")
    if Counter(prescribed) != Counter(prescribed.conj()):
        raise ValueError("eigenvalues: expected conjugate ones in pairs")
    return prescribed if prescribed.imag.any() else prescribed.real


def _single(A, b, prescribed):
    """Return the gain for one control, correct in all digits of its floats."""
    digits, last = FIRST, None
    while digits <= LAST:
        gain = _ackermann(A, b, prescribed, digits)
        if gain is not None and last is not None:
            # zero, but for its rounding
            small = [abs(new) <= 1e-10 * abs(old) for new, old in zip(gain, last)]
            if all(
                tiny or abs(new - old) <= AGREED * abs(new)
                for new, old, tiny in zip(gain, last, small)
            ):
                return np.array([0.0 if tiny else float(new) for new, tiny in zip(gain, small)])
        digits, last = 2 * digits, gain
    raise ValueError(f"A, B: {LAST} digits do not tell this pair from one that is not controllable")


def _ackermann(A, b, prescribed, digits):
    """Return -e^T W^-1 psi(A) with so many digits, or None if W is singular for them."""
    with mpmath.workdps(digits):
        exact = [[mpmath.mpf(x) for x in row] for row in A.tolist()]
        columns = list(zip(*exact))
        chain = [[mpmath.mpf(x) for x in b.tolist()]]
        while len(chain) < len(b):
            chain.append([mpmath.fdot(row, chain[-1]) for row in exact])
        try:  # the rows of W^T are the members of the chain
            row = list(
                mpmath.lu_solve(mpmath.matrix(chain), mpmath.matrix([0] * (len(b) - 1) + [1]))
            )
        except ZeroDivisionError:
            return None

        def times(vector):
            return [mpmath.fdot(vector, column) for column in columns]

        for value in prescribed:
            if value.imag > 0:  # with its conjugate: A^2 - 2 Re A + |lambda|^2
                real, imaginary = mpmath.mpf(value.real), mpmath.mpf(value.imag)
                once = [x - real * y for x, y in zip(times(row), row)]
                row = [x - real * y + imaginary**2 * z for x, y, z in zip(times(once), once, row)]
            elif value.imag == 0:
                row = [x - mpmath.mpf(value.real) * y for x, y in zip(times(row), row)]
        return [-x for x in row]


def _scipy(A, B, prescribed):
    """Return SciPy's gain, or None for an eigenvalue repeated more often than it allows."""
    from scipy.signal import place_poles

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that it has not converged; the loop is judged anyway
        try:
            gain = -place_poles(A, B, prescribed).gain_matrix
        except (ValueError, np.linalg.LinAlgError):
            return None
    return gain if np.isfinite(gain).all() else None


def _again(A, B, gain, prescribed):
    """Return the gain from eigenvectors corrected once: SciPy's search leaves them a little off.

    With g = K v for the vectors v of the loop, (lambda I - A) v' = B g gives vectors close to them,
    and K' v' = g.
    """
    values, vectors = np.linalg.eig(A + B @ gain)
    order = _matched(prescribed, values)
    pushes = gain @ vectors[:, order]
    try:
        ahead = np.column_stack(
            [
                np.linalg.solve(value * np.eye(len(A)) - A, B @ push)
                for value, push in zip(prescribed, pushes.T)
            ]
        )
        corrected = np.linalg.solve(ahead.T, pushes.T).T.real
    except np.linalg.LinAlgError:
        return None
    return corrected if np.isfinite(corrected).all() else None


def _uneven(A, B):
    """Whether the units of states or controls differ so much that others may do better."""
    _, _, units, pushes, _ = _in_units(A, B)
    return max(sizes.max() / sizes.min() for sizes in (units, pushes)) > UNEVEN


def _in_good_units(method, A, B, prescribed):
    scaled, inputs, units, pushes, rate = _in_units(A, B)
    gain = method(scaled, inputs, prescribed / rate)
    return None if gain is None else pushes[:, None] * gain / units


def _in_units(A, B):
    """Return A, B in balanced units, x = D y, u = R v, with D, R and the unit of time."""
    balance = balanced(A.T, B.T)  # of the dual pair: its states are measured in the inverse units
    units = 1 / balance.units
    scaled, inputs = A * units / units[:, None] / balance.rate, B / units[:, None] / balance.rate
    sizes = np.linalg.norm(inputs, axis=0)
    pushes = 1 / np.where(sizes > 0, sizes, 1)
    return scaled, inputs * pushes, units, pushes, balance.rate


def _by_chains(A, B, prescribed):
    """Return the best conditioned gain that gives the loop Jordan chains, or None.

    Each eigenvalue has as many chains as there are controls, or as are needed.
    """
    from scipy.linalg import solve_sylvester

    n, s = B.shape
    jordan = _jordan(prescribed, np.linalg.matrix_rank(B, rtol=zero_level(*B.shape)))
    random, best = np.random.default_rng(3), (np.inf, None)
    for _ in range(TRIED):
        # A first gain parts the spectra, without which the equation may have no solution.
        first, G = random.normal(size=(2, s, n))
        try:
            X = solve_sylvester(A + B @ first, -jordan, -B @ G)
            gain = first + np.linalg.solve(X.T, G.T).T
        except np.linalg.LinAlgError:
            continue
        condition = np.linalg.cond(X)
        if np.isfinite(gain).all() and condition < best[0]:
            best = condition, gain
    return best[1]


def _jordan(prescribed, max_chains):
    """Return a real matrix with these eigenvalues, each in at most `max_chains` Jordan chains."""
    blocks = []
    for value, times in Counter(value for value in prescribed.tolist() if value.imag >= 0).items():
        chains = min(times, max_chains)
        lengths = [times // chains + (k < times % chains) for k in range(chains)]
        small = (
            np.array([[value.real]])
            if not value.imag
            else np.array([[value.real, value.imag], [-value.imag, value.real]])
        )
        # A link of the size of the eigenvalue keeps the chain well-conditioned.
        blocks += [
            np.kron(np.eye(length), small)
            + abs(value or 1.0) * np.kron(np.eye(length, k=1), np.eye(len(small)))
            for length in lengths
        ]
    n = sum(map(len, blocks))
    matrix, start = np.zeros((n, n)), 0
    for block in blocks:
        matrix[start : start + len(block), start : start + len(block)] = block
        start += len(block)
    return matrix


def _judged(A, B, gain, prescribed):
    """Return the `Placement` of a gain."""
    loop = A + B @ gain
    # Units in which the loop is judged: they change no eigenvalue.
    balance = balanced(loop, np.zeros((1, len(loop))))
    matrix, rate, units = balance.A, balance.rate, balance.units
    scaled = A * units / units[:, None] / rate, B / units[:, None] / rate, gain * units
    residual = max(
        np.linalg.svd(matrix - value / rate * np.eye(len(matrix)), compute_uv=False)[-1]
        for value in set(prescribed.tolist())
    )
    reached, vectors = np.linalg.eigvals(loop), np.linalg.eig(matrix)[1]
    with np.errstate(all="ignore"):
        condition = float(np.linalg.cond(vectors))
    reached = reached[_matched(prescribed, reached)]
    return Placement(
        gain,
        prescribed,
        reached,
        float(abs(prescribed - reached).max()),
        float(residual),
        condition,
        float(rate * _displacement(*scaled, prescribed / rate)),
    )


def _displacement(A, B, gain, values):
    """Return a bound for the distance of the eigenvalues of A + BK from `values`, to a factor of two."""
    # No eigenvalue, prescribed or not, is further from another.
    largest = 4 * (np.linalg.norm(A) + np.linalg.norm(B) * np.linalg.norm(gain) + abs(values).max())
    radius = EPS * max(abs(values).max(), EPS)
    for value in {value for value in values.tolist() if value.imag >= 0}:
        if not _encloses(A, B, gain, values, value, radius):
            low, high = np.log2(radius), np.log2(largest)
            while high - low > 1:
                middle = (low + high) / 2
                enclosed = _encloses(A, B, gain, values, value, 2**middle)
                low, high = (low, middle) if enclosed else (middle, high)
            radius = 2**high
    return radius


def _encloses(A, B, gain, values, value, radius):
    """Whether |h - f| < |f| on the circle about a value, judged at points of it."""
    z = value + radius * (CIRCLE if value.imag == 0 else np.append(CIRCLE, CIRCLE.conj()))
    shifted = z[:, None, None] * np.eye(len(A)) - A
    with np.errstate(all="ignore"):
        try:
            resolvent = np.linalg.inv(shifted)
            response = resolvent @ B
            loop = np.eye(B.shape[1]) - gain @ response
            cofactors = np.linalg.det(loop)[:, None, None] * np.linalg.inv(loop)
        except np.linalg.LinAlgError:
            return False
        signs, logarithms = np.linalg.slogdet(shifted)
        logarithms = np.log(z[:, None] - values + 0j).sum(axis=1) - logarithms
        expected = np.exp(logarithms) / signs
        # Rounding, to first order: of the resolvent and its determinant, and of the products with K.
        relative = EPS * (abs(resolvent) @ abs(shifted))
        response_error = relative @ abs(response) + EPS * abs(response)
        loop_error = abs(gain) @ (response_error + EPS * abs(response))
        rounding = (abs(cofactors).transpose(0, 2, 1) * loop_error).sum(axis=(1, 2))
        rounding += abs(expected) * np.trace(relative, axis1=1, axis2=2)
        difference = abs(np.linalg.det(loop) - expected)
        return bool((difference + rounding < abs(expected)).all())


def _matched(prescribed, values):
    """Return the order in which `values` are closest to `prescribed`, all together."""
    from scipy.optimize import linear_sum_assignment

    return linear_sum_assignment(abs(np.subtract.outer(prescribed, values)))[1]
