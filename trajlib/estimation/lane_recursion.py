"""The recursion of the Kalman filter in parts of a record beside each other ("lanes").

The influence of the initial covariance decays. So a long record is cut into lanes, and all take
their steps together, each but the first from a guess. Then each lane starts again from the end of
the one before, until it meets what it had; from there on that is right. Where this takes longer
than a lane, None is returned.

What has met stays together: the map of a step does not increase the distance of two covariances, the
greatest |log| of an eigenvalue of P_1^-1 P_2 (P. Bougerol, SIAM Journal on Control and Optimization
31, 1993), nor that of two states, measured by P^-1.
"""

import numpy as np

MOST_LANES, FEWEST_LANES = 16, 4
#: From so many steps on lanes are worth their second beginnings.
LEAST_STEPS = 50 * MOST_LANES
#: How near covariances and states have to be to be the same, beside the standard deviations.
SETTLED = 1e-13
#: So many steps lie between two looks whether lanes have met.
LOOK = 8


def covariance_lanes(model, P, missing):
    """Return P-, P+ and K of each step, or None where the influence of the start decays too slowly."""
    count, (m, n) = len(missing), model.H.shape[-2:]
    matrices, measured = (model.Phi, model.H, model.Q, model.R), (~missing).astype(float)
    try:
        lanes = _number_of_lanes(matrices, measured, P)
        if lanes is None:
            return None
        measured = _in_lanes(measured, 1, lanes)
        parts = [np.empty((*measured.shape[:2], *shape)) for shape in ((n, n), (n, n), (n, m))]
        step = _covariance_step([_in_lanes(M, 2, lanes) for M in matrices], measured, *parts[1:])
        ends = _take_steps(step, np.broadcast_to(P, (lanes, n, n)), parts[0])
        starts = np.concatenate([P[None], ends[:-1]])
        if not _meets(step, starts, parts[0], _near_covariances):
            return None
    except np.linalg.LinAlgError:
        return None
    return [part.reshape(-1, *part.shape[2:])[:count] for part in parts]


def _number_of_lanes(matrices, measured, P):
    """Return so many lanes that two guesses meet in half of one; None if these were too few."""
    (m, n), longest = matrices[1].shape[-2:], len(measured) // (2 * FEWEST_LANES)
    measured_twice = np.broadcast_to(measured[:longest], (2, longest, m))
    unused = np.empty((2, longest, n, n)), np.empty((2, longest, n, m))
    beginning = [M if M.ndim == 2 else M[None, :longest] for M in matrices]
    step = _covariance_step(beginning, measured_twice, *unused)
    pair = np.array([P, P + np.diag(np.where(np.diag(P) > 0, np.diag(P), 1.0))])
    for k in range(longest):
        if k % LOOK == 0 and _near_covariances(k, pair[:1], pair[1:]):
            return min(MOST_LANES, len(measured) // (2 * (k + 1)))
        pair = step(k, pair)
    return None


def mean_lanes(model, x, gains, z, inputs, deviations):
    """Return the predictions of S series, shape (S, N, n), or None as `covariance_lanes`.

    `deviations` are the standard deviations of the predictions, shape (N, n).
    """
    (series, count), n = z.shape[:2], x.shape[-1]
    lanes = MOST_LANES
    Phi, H, gains = (_in_lanes(M, 2, lanes) for M in (model.Phi, model.H, gains))
    # From here on a step of all series is one matrix.
    z, deviations = _in_lanes(z.transpose(1, 0, 2), 2, lanes), _in_lanes(deviations, 1, lanes)
    inputs = (
        np.zeros((series, n)) if inputs is None else _in_lanes(inputs.transpose(1, 0, 2), 2, lanes)
    )
    predicted = np.empty((*z.shape[:3], n))

    def step(k, states):
        innovations = z[:, k] - states @ _transposed(H, k)
        return (states + innovations @ _transposed(gains, k)) @ _transposed(Phi, k) + _at(inputs, k)

    def near(k, states, earlier):
        size = np.abs(earlier).max(axis=(0, 1), initial=0)
        limit = SETTLED * deviations[:, k, None] + 4 * np.finfo(float).eps * size
        return (np.abs(states - earlier) <= limit).all()

    x = np.broadcast_to(x, (series, n))
    ends = _take_steps(step, np.broadcast_to(x, (lanes, series, n)), predicted)
    if not _meets(step, np.concatenate([x[None], ends[:-1]]), predicted, near):
        return None
    return predicted.reshape(-1, series, n)[:count].transpose(1, 0, 2)


def _covariance_step(matrices, measured, after, gains):
    """Return the function of a step, which writes P+ and K.

    What it returns is overwritten by its next call: new arrays in each step take as long as it does.
    """
    Phis, Hs, Qs, Rs = matrices
    m = measured.shape[2]
    corrected, work, predicted = np.empty((3, len(measured), *after.shape[2:]))

    def step(k, P):
        H, R, mask = _at(Hs, k), _at(Rs, k), measured[:, k]
        HP = H @ P
        # Missing components have a row of zeros in H and of the unit matrix in the covariance.
        spread = (HP @ _transposed(Hs, k) + R) * (mask[:, :, None] * mask[:, None, :])
        spread.reshape(len(P), -1)[:, :: m + 1] += 1 - mask
        solution = np.linalg.solve(spread, mask[:, :, None] * HP)
        K = solution.transpose(0, 2, 1)
        # Joseph's form by two changes of rank m.
        np.subtract(P, np.matmul(K, HP, out=work), out=corrected)
        change = K @ R - corrected @ _transposed(Hs, k)
        np.add(corrected, np.matmul(change, solution, out=work), out=corrected)
        after[:, k], gains[:, k] = corrected, K
        np.matmul(_at(Phis, k), corrected, out=work)
        np.matmul(work, _transposed(Phis, k), out=corrected)
        np.add(corrected, _at(Qs, k), out=corrected)
        np.add(corrected, corrected.transpose(0, 2, 1), out=predicted)
        return np.multiply(predicted, 0.5, out=predicted)

    return step


def _near_covariances(_k, covariances, earlier):
    units = np.sqrt(np.maximum(np.einsum("kii->ki", earlier), 0))
    limit = SETTLED * units[:, :, None] * units[:, None, :]
    return (np.abs(covariances - earlier) <= limit).all()


def _take_steps(step, state, states):
    """Write the states of all steps from one on, and return that after the last."""
    for k in range(states.shape[1]):
        states[:, k] = state
        state = step(k, state)
    return state


def _meets(step, state, states, near):
    """Replace the states by those from another one on until both are the same; whether they are."""
    for k in range(states.shape[1]):
        if k % LOOK == 0 and near(k, state, states[:, k]):
            return True
        states[:, k] = state
        state = step(k, state)
    return False


def _in_lanes(array, dimensions, lanes):
    """Return an array of all steps as lanes x steps x ..., and one that is the same in all unchanged.

    What lacks at the end is filled with the last.
    """
    if array.ndim == dimensions:
        return array
    length = -(-len(array) // lanes)
    more = np.broadcast_to(array[-1], (lanes * length - len(array), *array.shape[1:]))
    return np.concatenate([array, more]).reshape(lanes, length, *array.shape[1:])


def _at(array, k):
    return array if array.ndim == 2 else array[:, k]


def _transposed(array, k):
    return array.T if array.ndim == 2 else array[:, k].transpose(0, 2, 1)
