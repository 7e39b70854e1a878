"""Exact discretisation in floats of x' = Ax + q for many steps at once.

For a short step h, |A| h <= 1, both e^{Ah} and the covariance W(h) of the noise are power series in h
with matrices that do not depend on h,

    e^{Ah} = sum A^j h^j / j!,    W(h) = sum W_j h^{j+1} / (j+1)!,   W_0 = Q,   W_{j+1} = A W_j + W_j A^T,

so that all steps are summed by one matrix product. A longer step is doubled repeatedly, which keeps W
positive semidefinite. Each squaring of e^{Ah} doubles its relative error; so all but the last
doublings are done on e^{Ah} - E, which for slow modes is small, and exact to its own digits. C. F. van
Loan (1978) has the same integrals from one exponential.
"""

import numpy as np

#: So many terms leave less than rounding: 2^j / (j + 1)! is below 1e-17 from there on.
TERMS = 25
#: So many of the doublings square e^{Ah} itself, which keeps the digits of what has decayed.
SQUARINGS = 6


def discretise_steps(A, Q, steps):
    """Return Phi and the covariance of the noise for each step, both of shape (K, n, n)."""
    n = len(A)
    rate = np.abs(A).sum(axis=1).max() or 1.0
    scaled = A / rate
    powers, noises = [scaled], [Q / rate]
    for j in range(1, TERMS):
        image = scaled @ noises[-1]
        powers.append(scaled @ powers[-1] / (j + 1))
        noises.append((image + image.T) / (j + 1))
    times = rate * np.asarray(steps, dtype=float)
    doublings = np.ceil(np.log2(np.maximum(times, 1))).astype(int)
    times = times / 2.0**doublings
    factors = times[:, None] ** np.arange(1, TERMS + 1)
    growth = (factors @ np.reshape(powers, (TERMS, -1))).reshape(-1, n, n)
    noise = (factors @ np.reshape(noises, (TERMS, -1))).reshape(-1, n, n)
    Phi = np.eye(n) + growth
    for k in range(doublings.max(initial=0)):
        longer, early = doublings > k, doublings > k + SQUARINGS
        late = longer & ~early
        half, half_noise = Phi[longer], noise[longer]
        doubled = half_noise + half @ half_noise @ half.transpose(0, 2, 1)
        noise[longer] = (doubled + doubled.transpose(0, 2, 1)) / 2
        growth[early] = 2 * growth[early] + growth[early] @ growth[early]
        Phi[early], Phi[late] = np.eye(n) + growth[early], Phi[late] @ Phi[late]
    return Phi, noise
