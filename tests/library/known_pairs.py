"""Pairs (A, H) with known unobservable states, rotated and in bad units.

`known_pair(rng)` gives (A, H, number of unobservable states, name). Four kinds: Jordan blocks with
eigenvalues that come again, observed from the k-th state of the block on; a random observable part
with random unobservable states behind it; a chain of integrators observed from the k-th on; and two chains
with one eigenvalue, of which one is observed.
"""

import numpy as np

EIGENVALUES = (-3, -2, -1, -0.5, 0, 0.5, 1, 1.5, 2, 3)


def known_pair(rng, largest=60):
    n, m = int(rng.integers(2, largest + 1)), int(rng.integers(1, 4))
    kind = (_jordan_blocks, _hidden_part, _chain, _two_chains)[int(rng.integers(4))]
    A, H, unobservable = kind(rng, n, m)
    rotated, scaled = rng.integers(2, size=2)
    if rotated:
        Q = np.linalg.qr(rng.normal(size=(n, n)))[0]
        A, H = Q @ A @ Q.T, H @ Q.T
    if scaled:
        units = 10.0 ** rng.uniform(-6, 6, size=n)
        A = A * units / units[:, None] * 10.0 ** rng.uniform(-6, 6)
        H = H * units * 10.0 ** rng.uniform(-6, 6, size=(m, 1))
    name = (
        f"{kind.__name__}, {n} states, {m} outputs"
        + ", rotated" * int(rotated)
        + ", scaled" * int(scaled)
    )
    return A, H, unobservable, name


def _jordan_blocks(rng, n, m):
    """Blocks of one eigenvalue are observed in different directions."""
    A, H, unobservable, start, blocks = np.zeros((n, n)), np.zeros((m, n)), 0, 0, {}
    while start < n:
        size = min(int(rng.integers(1, 6)), n - start)
        value, inside = float(rng.choice(EIGENVALUES)), slice(start, start + size)
        A[inside, inside] = value * np.eye(size) + np.diag(np.ones(size - 1), 1)
        blocks.setdefault(value, []).append((start, size))
        start += size
    for same in blocks.values():
        rng.shuffle(same)
        directions = np.linalg.qr(rng.normal(size=(m, m)))[0]
        for k, (start, size) in enumerate(same):
            behind = min(int(rng.choice([0, 0, 0, 0, 1, 2, size])), size) if k < m else size
            unobservable += behind
            if behind < size:
                H[:, start + behind] = directions[:, k]
                H[:, start + behind + 1 : start + size] = 0.5 * rng.normal(
                    size=(m, size - behind - 1)
                )
    return A, H, unobservable


def _hidden_part(rng, n, m):
    k = int(rng.integers(0, max(1, n // 2)))
    A, H = rng.normal(size=(n, n)) / np.sqrt(n), rng.normal(size=(m, n))
    A[: n - k, n - k :], H[:, n - k :] = 0, 0
    return A, H, k


def _chain(rng, n, m):
    k = int(rng.integers(0, n // 2 + 1))
    A, H = np.diag(np.ones(n - 1), 1) * rng.uniform(0.5, 2), np.zeros((m, n))
    H[0, k], H[1:, k + 1 :] = 1, rng.normal(size=(m - 1, n - k - 1))
    return A, H, k


def _two_chains(rng, n, m):
    k = max(1, n // 3)
    observed = n - k
    A, H = np.eye(n) + np.diag(np.ones(n - 1), 1), np.zeros((m, n))
    A[observed - 1, observed] = 0
    A[observed:, :observed], H[:, 0] = rng.normal(size=(k, observed)), rng.normal(size=m)
    return A, H, k
