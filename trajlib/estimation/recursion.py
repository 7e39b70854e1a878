"""Linear recursion x_{k+1} = F x_k + u_k, computed in blocks.

The steps of a block take one matrix product, the final states of the blocks the same recursion.
"""

import numpy as np

#: Steps in a block: a product costs BLOCK n multiplications a step and component, a single step
#: costs a call.
BLOCK = 8


def recursion(F: np.ndarray, u: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Return x_0, ..., x_N of x_{k+1} = F x_k + u_k for several series beside each other.

    Parameters
    ----------
    F : ndarray, shape (n, n)
        Matrix of the recursion.
    u : ndarray, shape (S, N, n)
        Inputs of S series.
    start : ndarray, shape (S, n)
        Initial states x_0.

    Returns
    -------
    ndarray, shape (S, N + 1, n)
    """
    series, count, n = u.shape
    states = np.empty((series, count + 1, n))
    states[:, 0] = start
    if count <= BLOCK:
        for k in range(count):
            states[:, k + 1] = states[:, k] @ F.T + u[:, k]
        return states
    powers = [np.eye(n)]
    for _ in range(BLOCK):
        powers.append(F @ powers[-1])
    # From the inputs of a block to its states for the initial state zero: rows x_1, ..., x_BLOCK.
    response = np.zeros((BLOCK, n, BLOCK, n))
    for j in range(BLOCK):
        for i in range(j + 1):
            response[j, :, i] = powers[j - i]
    blocks = -(-count // BLOCK)
    padded = np.zeros((series, blocks * BLOCK, n))
    padded[:, :count] = u
    # Plain matrices, since products of stacks are computed one by one.
    within = padded.reshape(series * blocks, BLOCK * n) @ response.reshape(BLOCK * n, BLOCK * n).T
    ends = recursion(powers[BLOCK], within.reshape(series, blocks, BLOCK * n)[:, :, -n:], start)
    within += ends[:, :-1].reshape(-1, n) @ np.concatenate(powers[1:]).T
    states[:, 1:] = within.reshape(series, -1, n)[:, :count]
    return states
