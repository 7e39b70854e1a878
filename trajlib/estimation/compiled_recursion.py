"""The recursion of the Kalman filter as a function of CasADi, for few states and many steps.

A step in NumPy costs a dozen calls, whatever the number n of states; one in CasADi's virtual machine
about a nanosecond an operation. A component that is missing has a row of zeros in H and of the unit
matrix in H P H^T + R: so its column of K is zero, and all steps are one function.
"""

from functools import lru_cache

import numpy as np

from trajlib._arguments.covariances import ROUNDING

#: Up to so many states it is faster than a step of NumPy.
MOST_STATES = 8
#: From so many steps on it is worth its construction.
LEAST_STEPS = 1000
#: Steps in one call.
CHUNK = 200


def covariance_steps(model, P, missing):
    """Return P-, P+, K, S, the inverse of S, log det S and a number that is nan for a negative P+."""
    n, m = len(P), missing.shape[1]
    arguments = ((model.Phi, 2), (model.H, 2), (model.Q, 2), (model.R, 2), (~missing * 1.0, 1))
    shapes = ((n, n), (n, n), (n, m), (m, m), (m, m), (), ())
    following, *outputs = _accumulated(_covariance_step(n, m), P, arguments, shapes, len(missing))
    return np.concatenate([P[None], following[:-1]]), *outputs


def mean_steps(model, x, gains, z, inputs):
    """Return the estimates before and after the measurements of one series."""
    inputs = np.zeros(len(x)) if inputs is None else inputs
    arguments = ((model.Phi, 2), (model.H, 2), (gains, 2), (z, 1), (inputs, 1))
    shapes = (x.shape, x.shape)
    step = _mean_step(len(x), z.shape[1])
    following, estimates = _accumulated(step, x, arguments, shapes, len(z))
    return np.concatenate([x[None], following[:-1]]), estimates


@lru_cache
def _covariance_step(n, m):
    import casadi as ca

    # Arrays of NumPy are read by columns, hence transposed.
    P, Phi, H = ca.SX.sym("P", n, n), ca.SX.sym("Phi", n, n), ca.SX.sym("H", n, m)
    Q, R, measured = ca.SX.sym("Q", n, n), ca.SX.sym("R", m, m), ca.SX.sym("w", m)
    shown = H.T @ P
    spread = shown @ H + R
    mask = ca.diag(measured)
    root = ca.chol(mask @ spread @ mask + ca.diag(1 - measured))
    back = ca.solve(root, ca.SX.eye(m))
    inverse = mask @ back @ back.T @ mask
    gain = (inverse @ shown).T
    # Joseph's form, (E - KH) P (E - KH)^T + K R K^T, by two changes of rank m.
    once = P - gain @ shown
    after = once + (gain @ R - once @ H) @ gain.T
    after = (after + after.T) / 2
    following = Phi.T @ after @ Phi + Q
    following = (following + following.T) / 2
    variances = ca.diag(after)
    margin = ROUNDING * ca.diag(ca.if_else(variances > 0, variances, 1))
    definite = ca.sum1(ca.diag(ca.chol(after + margin)))
    logarithm = 2 * ca.sum1(ca.log(ca.diag(root)))
    outputs = [following, after, gain.T, spread, inverse, logarithm, definite]
    return _many(ca.Function("step", [P, Phi, H, Q, R, measured], outputs))


@lru_cache
def _mean_step(n, m):
    import casadi as ca

    x, Phi, H = ca.SX.sym("x", n), ca.SX.sym("Phi", n, n), ca.SX.sym("H", n, m)
    K, z, u = ca.SX.sym("K", m, n), ca.SX.sym("z", m), ca.SX.sym("u", n)
    estimate = x + K.T @ (z - H.T @ x)
    return _many(ca.Function("step", [x, Phi, H, K, z, u], [Phi.T @ estimate + u, estimate]))


def _many(step):
    return step.mapaccum("steps", CHUNK, {"base": 4})


def _accumulated(steps, state, arguments, shapes, count):
    """Return the outputs of all steps, of the given shapes; the first is the next state.

    `arguments` are arrays with their dimensions in one step; with no dimension more they are the same in
    all steps.
    """
    buffer, run = steps.buffer()
    state = np.array(state)
    buffer.set_arg(0, memoryview(state))
    chunk_arguments = []
    for i, (array, dimensions) in enumerate(arguments):
        constant = array.ndim == dimensions
        chunk = np.zeros((CHUNK, *array.shape[array.ndim - dimensions :]))
        if constant:
            chunk[:] = array
        buffer.set_arg(i + 1, memoryview(chunk))
        chunk_arguments.append((array, chunk, constant))
    outputs = [np.empty((-(-count // CHUNK) * CHUNK, *shape)) for shape in shapes]
    for first in range(0, count, CHUNK):
        last = min(first + CHUNK, count)
        for array, chunk, constant in chunk_arguments:
            if not constant:
                chunk[: last - first] = array[first:last]
        for i, output in enumerate(outputs):
            buffer.set_res(i, memoryview(output[first : first + CHUNK]))
        run()
        state[:] = outputs[0][last - 1]
    return [output[:count] for output in outputs]
