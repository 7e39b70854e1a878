"""The nearest unobservable system: the PBH test in floating-point numbers.

The distance from (A, H) to the pairs that are not observable is the least singular value of (A -
lambda I; H) over all complex lambda (R. Eising, Systems & Control Letters 4 (1984) 263-264). It has
many local minima. `nearest` descends from

- the eigenvalues of A, and of the blocks of the staircase behind its smallest steps: a step taken
  for zero loses just these;
- the means of eigenvalues with their neighbours: rounding tears a multiple one into a ring whose
  mean stays accurate;
- points spread over the disc of the radius |A|, since the least value may lie far from every
  eigenvalue.

With the singular vectors u = (u1; u2), v at lambda two steps lower the value: v* A v, the best
number for this v, and Newton's step sigma/(u1* v) towards a zero. What is returned is an upper
bound of the distance, the best of these descents: a smaller one may exist.
"""

import numpy as np

_EPS = np.finfo(float).eps
_DESCENTS, _MEANS, _STEPS = 8, 12, 60


def nearest(A, H, stairs):
    """Return local minima of a pair of norm 1, in the coordinates of `stairs`, the least first.

    Each is a triple (least singular value, its lambda, its unit vector).
    """
    points = _starts(stairs)
    minima, used = [], []
    for index in np.argsort(_rough_values(A, H, points)):
        start = points[index]
        # Near neighbours lead to one minimum; the first three starts are the most promising,
        # however near.
        if len(used) >= 3 and min(abs(start - previous) for previous in used) <= 1e-3:
            continue
        used.append(start)
        minima.append(descend(A, H, start))
        if len(used) == _DESCENTS:
            break
    return sorted(minima, key=lambda minimum: minimum[0])


def smallest(A, H, value):
    """Return the smallest singular value of (A - lambda I; H) and its vectors, (sigma, u, v)."""
    left_vectors, values, right_vectors = np.linalg.svd(_pencil(A, H, value), full_matrices=False)
    return values[-1], left_vectors[:, -1], right_vectors[-1].conj()


def _pencil(A, H, value):
    value = value if np.imag(value) else np.real(value)
    return np.vstack([A - value * np.eye(len(A)), H])


def _starts(stairs):
    ends, matrix = np.cumsum(stairs.sizes), stairs.matrix
    behind = [0, *(ends[k - 1] for k in np.argsort(stairs.heights)[:4] if k)]
    points = [
        mean for start in behind for mean in _means(np.linalg.eigvals(matrix[start:, start:]))
    ]
    points = np.array(points, dtype=complex)
    points.imag[np.abs(points.imag) <= 1e-12] = 0
    disc = np.outer([0.25, 0.5, 0.75, 1], np.exp(1j * np.pi * np.linspace(0, 1, 9))).ravel()
    points = np.concatenate([points, disc])
    return np.unique(np.round(points[points.imag >= 0], 13))


def _means(eigenvalues):
    """Return the eigenvalues with Im >= 0 and their means with their nearest neighbours."""
    means = []
    for eigenvalue in eigenvalues[eigenvalues.imag >= 0]:
        distances = np.abs(eigenvalues - eigenvalue)
        neighbours = eigenvalues[np.argsort(distances)][: np.count_nonzero(distances <= 0.3)][
            :_MEANS
        ]
        means += list(np.cumsum(neighbours) / np.arange(1, len(neighbours) + 1))
    return means


def _rough_values(A, H, points):
    """Return sigma at many points from the squares: values below 1e-8 are not distinguished."""
    pencils = A - points[:, None, None] * np.eye(len(A))
    squares = pencils.conj().transpose(0, 2, 1) @ pencils + H.T @ H
    return np.sqrt(np.maximum(np.linalg.eigvalsh(squares)[:, 0], 0))


def descend(A, H, value):
    """Return (sigma, lambda, unit vector) of a local minimum below that at `value`."""
    value = value if np.imag(value) else np.real(value)
    sigma, u, v = smallest(A, H, value)
    for _ in range(_STEPS):
        slope = np.vdot(u[: len(A)], v)
        steps = [value + sigma / slope] if abs(slope) > 1e-8 else []
        better = None
        for candidate in (*steps, np.vdot(v, A @ v)):
            candidate = candidate if np.imag(value) else np.real(candidate)
            trial = (*smallest(A, H, candidate), candidate)
            if trial[0] < sigma * (1 - 1e-3) and (better is None or trial[0] < better[0]):
                better = trial
            if better and better[0] < sigma / 5:
                break
        if better is None or sigma <= 2 * _EPS:
            break
        sigma, u, v, value = better
    return float(sigma), value, v
