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


def varying_recursion(F, u, start):
    """Return the same for a matrix of each step, `F` of shape (N, n, n).

    Chunks of steps are computed beside each other, then their final states in turn.
    """
    series, count, n = u.shape
    width = int(np.ceil(np.sqrt(count)))
    chunks = -(-count // width)
    matrices = np.broadcast_to(np.eye(n), (chunks * width, n, n)).copy()
    matrices[:count] = F
    inputs = np.zeros((series, chunks * width, n))
    inputs[:, :count] = u
    matrices, inputs = (
        matrices.reshape(chunks, width, n, n),
        inputs.reshape(series, chunks, width, n),
    )
    # Transition from the initial state of a chunk, and response to its inputs, after each step.
    transitions, forced = np.empty_like(matrices), np.empty_like(inputs)
    product, state = np.broadcast_to(np.eye(n), (chunks, n, n)), np.zeros((series, chunks, n))
    for k in range(width):
        product = matrices[:, k] @ product
        state = np.einsum("cij,scj->sci", matrices[:, k], state) + inputs[:, :, k]
        transitions[:, k], forced[:, :, k] = product, state
    initial = [start]
    for c in range(chunks - 1):
        initial.append(initial[-1] @ transitions[c, -1].T + forced[:, c, -1])
    states = forced + np.einsum("ckij,scj->scki", transitions, np.stack(initial, axis=1))
    return np.concatenate([start[:, None], states.reshape(series, -1, n)[:, :count]], axis=1)


def congruence_recursion(matrices, noises, start):
    """Return P_0, ..., P_N of P_{k+1} = C_k P_k C_k^T + M_k.

    `matrices` and `noises`, of shape (N, n, n), are C_k and M_k; the chunks are those of
    `varying_recursion`.
    """
    count, n = len(matrices), len(start)
    width = int(np.ceil(np.sqrt(count)))
    chunks = -(-count // width) if count else 0
    factors = np.broadcast_to(np.eye(n), (chunks * width, n, n)).copy()
    added = np.zeros_like(factors)
    factors[:count], added[:count] = matrices, noises
    factors, added = (part.reshape(chunks, width, n, n) for part in (factors, added))
    transitions, forced = np.empty_like(factors), np.empty_like(added)
    product, covariance = np.broadcast_to(np.eye(n), (chunks, n, n)), np.zeros((chunks, n, n))
    for k in range(width):
        C = factors[:, k]
        product = C @ product
        covariance = C @ covariance @ C.transpose(0, 2, 1) + added[:, k]
        transitions[:, k], forced[:, k] = product, covariance
    covariances = np.empty((count + 1, n, n))
    covariances[0] = start
    for c in range(chunks):
        first, last = c * width, min((c + 1) * width, count)
        transition = transitions[c, : last - first]
        covariances[first + 1 : last + 1] = (
            transition @ covariances[first] @ transition.transpose(0, 2, 1)
            + forced[c, : last - first]
        )
    return (covariances + covariances.transpose(0, 2, 1)) / 2
