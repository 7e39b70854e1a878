"""Popov's criterion in floating-point numbers.

The margin is the smallest singular value of (A - lambda E; H) over complex lambda: the distance from (A, H) to the
pairs that are not observable (R. Eising, Systems & Control Letters 4 (1984) 263-264). It is sought by descent from the
computed eigenvalues: for the right singular vector v the best lambda is v* A v, which lowers the value again. That
makes up for the error of a multiple eigenvalue, which is far larger than rounding. A lost mode found is split off by an
orthogonal transformation, and the search goes on in the quotient; in this way the unobservable states are counted and
spanned without any power of A.
"""
from dataclasses import dataclass

import numpy as np
import scipy.linalg

_DESCENTS = 6


def tolerance(A, H):
    """Below this a singular value counts as zero: what rounding in the data can make of it."""
    return 100*len(A)*np.finfo(float).eps*np.linalg.norm(np.vstack([A, H]), 2)


def popov_margin(A, H):
    """(smallest singular value found, its lambda, its unit vector)."""
    starts = _starts(A)
    values = np.array([_singular(A, H, s) for s in starts])
    best = (np.inf, None, None)
    for start in (starts[i] for i in np.argsort(values)[:_DESCENTS]):
        found = _descend(A, H, start)
        if found[0] < best[0]:
            best = found
    return best


def _starts(A):
    """The eigenvalues in the closed upper half-plane, and the means of each with its nearest ones.

    Rounding tears a multiple eigenvalue apart into a ring whose mean stays accurate.
    """
    eigenvalues = np.linalg.eigvals(A)
    eigenvalues = np.where(np.abs(eigenvalues.imag) <= 1e-14*np.abs(eigenvalues).max(initial=0), eigenvalues.real,
                           eigenvalues)
    near = 0.1*max(np.abs(eigenvalues).max(initial=0), np.finfo(float).tiny)
    starts = []
    for eigenvalue in eigenvalues[eigenvalues.imag >= 0]:
        distances = np.abs(eigenvalues - eigenvalue)
        order = np.argsort(distances)
        starts += [eigenvalues[order[:count]].mean() for count in range(1, 1 + np.count_nonzero(distances <= near))]
    # A mean of conjugate ones is real.
    starts = np.array(starts, dtype=complex)
    starts.imag[np.abs(starts.imag) <= 1e-12*np.abs(starts)] = 0
    return np.unique(starts)


def _descend(A, H, value):
    singular, vector = _smallest(A, H, value)
    for _ in range(100):
        better = vector.conj() @ A @ vector
        if not np.imag(value):
            better = better.real
        lower, new_vector = _smallest(A, H, better)
        if not lower < singular*(1 - 1e-3):
            break
        value, singular, vector = better, lower, new_vector
    return singular, value, vector


def _pencil(A, H, value):
    value = value if np.imag(value) else np.real(value)
    return np.vstack([A - value*np.eye(len(A)), H])


def _singular(A, H, value):
    return np.linalg.svd(_pencil(A, H, value), compute_uv=False)[-1]


def _smallest(A, H, value):
    _, singular, right = np.linalg.svd(_pencil(A, H, value))
    return singular[-1], right[-1].conj()


@dataclass(frozen=True)
class Split:
    """Orthonormal columns `seen` and `unseen`; the numbers lambda as they were split off; the margin of the whole
    pair."""

    seen: np.ndarray
    unseen: np.ndarray
    numbers: tuple
    margin: float


def split(A, H):
    """The unobservable states and their orthogonal complement."""
    n = len(A)
    seen, unseen, numbers, margins = np.eye(n), np.zeros((n, 0)), [], []
    limit = tolerance(A, H)
    while seen.shape[1]:
        inner, outer = seen.T @ A @ seen, H @ seen
        margin, value, vector = popov_margin(inner, outer)
        margins.append(float(margin))
        if margin > limit:
            break
        if np.imag(value) and _singular(inner, outer, np.real(value)) <= limit:
            value = np.real(value)
            _, vector = _smallest(inner, outer, value)
        numbers.append(complex(value) if np.imag(value) else float(np.real(value)))
        plane = scipy.linalg.orth(np.column_stack([vector.real, vector.imag]), rcond=1e-8)
        unseen, seen = np.hstack([unseen, seen @ plane]), seen @ scipy.linalg.null_space(plane.T)
    return Split(seen, unseen, tuple(numbers), margins[0])


def lost_modes(A, H, split):
    """Pairs (lambda, columns v with A v = lambda v, H v = 0), conjugate numbers one by one."""
    modes, limit = [], 10*tolerance(A, H)
    for value in split.numbers:
        if any(abs(value - other) <= 1e-6*np.linalg.norm(A, 2) for other, _ in modes):
            continue
        _, singular, right = np.linalg.svd(_pencil(A, H, value))
        vectors = right[singular <= max(limit, singular[-1])].conj().T
        modes.append((value, vectors))
        if np.imag(value):
            modes.append((value.conjugate(), vectors.conj()))
    return modes
