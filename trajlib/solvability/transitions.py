"""Exact transition matrices, and the stacked matrix of all measurements."""

from collections.abc import Callable

import numpy as np

from trajlib._arguments.arrays import read_finite_array
from trajlib._arguments.numbers import read_number, read_numeric_matrix, read_times
from trajlib._typing import ArrayLike


def transition(A: ArrayLike, times: ArrayLike, reference: float | None = None) -> np.ndarray:
    """Return the transition matrices exp(A (t_i - t_s)) of a constant matrix A.

    Parameters
    ----------
    A : array_like, shape (m, m)
        Matrix of the system x' = A x.
    times : array_like, shape (k,)
        Increasing times; dates become seconds since the first of them.
    reference : float, optional
        Reference time t_s, the first of the times if left out.

    Returns
    -------
    ndarray, shape (k, m, m)

    Raises
    ------
    ValueError
        If A is not square or times do not increase.

    Notes
    -----
    MATLAB: ``expm``.

    Examples
    --------
    >>> transition([[0, 1], [0, 0]], [0, 2])[1].tolist()
    [[1.0, 2.0], [0.0, 1.0]]
    """
    from scipy.linalg import expm

    A = read_numeric_matrix(A, "A")
    if A.shape[0] != A.shape[1]:
        raise ValueError(f"A: expected a square matrix, got shape {A.shape}")
    times = read_times(times)
    since = times - (times[0] if reference is None else read_number(reference, "reference"))
    return expm(A * since[:, None, None])


def clohessy_wiltshire(rate: float, times: ArrayLike, reference: float | None = None) -> np.ndarray:
    """Return the exact transition matrices of the motion near a circular orbit.

    Parameters
    ----------
    rate : float
        Angular velocity w of the orbit and of the axes, positive.
    times : array_like, shape (k,)
        Increasing times; dates become seconds since the first of them.
    reference : float, optional
        Reference time t_s, the first of the times if left out.

    Returns
    -------
    ndarray, shape (k, 6, 6)

    Raises
    ------
    ValueError
        If the rate is not positive or times do not increase.

    Notes
    -----
    Unknowns: x outwards, y forwards, z along the axis of the orbit, then their velocities. The
    equations are x'' = 3 w^2 x + 2 w y', y'' = -2 w x', z'' = -w^2 z.

    Examples
    --------
    >>> phi = clohessy_wiltshire(0.5, [0.0, 4*np.pi])[1]       # after a revolution only y has moved
    >>> [(i, j, round(float(value)/np.pi, 9)) for (i, j), value in np.ndenumerate(phi - np.eye(6)) if abs(value) > 1e-9]
    [(1, 0, -12.0), (1, 4, -12.0)]
    """
    w = float(rate)
    if not (np.isfinite(w) and w > 0):
        raise ValueError(f"rate: expected a positive angular velocity, got {rate}")
    times = read_times(times)
    a = w * (times - (times[0] if reference is None else read_number(reference, "reference")))
    s, c, ones, zeros = np.sin(a), np.cos(a), np.ones_like(a), np.zeros_like(a)
    # written so, 1 - cos a and sin a - a keep their digits for small angles
    half, drift = 2 * np.sin(a / 2) ** 2, _sine_minus_angle(a)
    return np.moveaxis(
        np.array(
            [
                [1 + 3 * half, zeros, zeros, s / w, 2 * half / w, zeros],
                [6 * drift, ones, zeros, -2 * half / w, (4 * s - 3 * a) / w, zeros],
                [zeros, zeros, c, zeros, zeros, s / w],
                [3 * w * s, zeros, zeros, c, 2 * s, zeros],
                [-6 * w * half, zeros, zeros, -2 * s, 1 - 4 * half, zeros],
                [zeros, zeros, -w * s, zeros, zeros, c],
            ]
        ),
        -1,
        0,
    )


def _sine_minus_angle(a):
    """Return sin a - a without cancellation."""
    square = a * a
    series = 1.0
    for k in (15, 13, 11, 9, 7, 5):
        series = 1 - square / (k * (k - 1)) * series
    return np.where(np.abs(a) < 0.5, -a * square / 6 * series, np.sin(a) - a)


def stack(
    H: ArrayLike | Callable,
    Phi: ArrayLike | Callable,
    times: ArrayLike | None = None,
    reference: float | None = None,
) -> np.ndarray:
    """Return the stacked matrix Htilde = [H_1 Phi_1; ...; H_k Phi_k].

    Parameters
    ----------
    H : array_like or callable, shape (k, r, m)
        Measurement matrices; of shape (r, m) for the same each time; or a function H(t).
    Phi : array_like or callable, shape (k, m, m)
        Transition matrices, or a function Phi(t, t_s).
    times : array_like, shape (k,), optional
        Increasing times, needed for functions.
    reference : float, optional
        Reference time t_s for functions, the first of the times if left out.

    Returns
    -------
    ndarray, shape (k r, m)

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    Source: (3), (4) of the paper.

    Examples
    --------
    >>> stack([[1, 0]], transition([[0, 1], [0, 0]], [0, 1, 2])).tolist()
    [[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]]
    """
    if callable(H) or callable(Phi):
        if times is None:
            raise ValueError("times: a function H or Phi needs the times of the measurements")
        times = read_times(times)
        since = times[0] if reference is None else read_number(reference, "reference")
        Phi = np.array([Phi(t, since) for t in times], dtype=float) if callable(Phi) else Phi
        H = np.array([np.atleast_2d(H(t)) for t in times], dtype=float) if callable(H) else H
    Phi, H = (
        read_finite_array(matrix, name, "matrices of numbers")
        for name, matrix in (("Phi", Phi), ("H", H))
    )
    if Phi.ndim != 3 or Phi.shape[1] != Phi.shape[2]:
        raise ValueError(f"Phi: expected k square matrices, shape (k, m, m), got shape {Phi.shape}")
    k, m, _ = Phi.shape
    if H.ndim == 2:
        H = np.broadcast_to(H, (k, *H.shape))
    if H.ndim != 3 or H.shape[0] != k or H.shape[2] != m:
        raise ValueError(
            f"H: expected shape (r, {m}) or ({k}, r, {m}) to go with Phi of shape {Phi.shape}, got "
            f"shape {H.shape}"
        )
    return (H @ Phi).reshape(-1, m)
