"""Random Riccati equations of filters, and their solutions in many digits.

`riccati_pairs` gives (kind, A, H, Q, R, discrete) with a stabilising solution: general ones; states,
outputs and time in units that differ by up to twelve powers of ten; a quarter of the states hardly
measured; two unstable modes, 1 and 1 + 1e-6, that one row of H measures alike; and a measurement of
the strength 1e-9.

`reference` is the doubling algorithm in numbers of 700 bits (python-flint), with a noise of 1e-120 in
all states, without which it finds the least solution, not the stabilising one.
"""

import flint
import numpy as np

KINDS = ("general", "units", "hardly measured", "1 and 1 + 1e-6", "measurement 1e-9")


def riccati_pairs(count, largest, seed=39):
    rng = np.random.default_rng(seed)
    for k in range(count):
        kind = KINDS[k % len(KINDS)]
        n, m = int(np.exp(rng.uniform(np.log(2), np.log(largest + 1)))), int(rng.integers(1, 4))
        m = max(m, n // 12)
        A, H = rng.normal(size=(n, n)) / np.sqrt(n), rng.normal(size=(m, n))
        B, C = rng.normal(size=(n, n)), rng.normal(size=(m, m))
        driven = kind == KINDS[3] or rng.integers(2)
        Q = B @ B.T / n if driven else np.diag((np.arange(n) >= n // 2).astype(float))
        R, discrete = C @ C.T + np.eye(m), bool(rng.integers(2))
        if kind == "units":
            states, outputs = 10.0 ** rng.uniform(-6, 6, n), 10.0 ** rng.uniform(-6, 6, m)
            time = 1.0 if discrete else 10.0 ** rng.uniform(-6, 6)
            A, H = A * states / states[:, None] * time, H * states * outputs[:, None]
            Q, R = Q / np.outer(states, states), R * np.outer(outputs, outputs)
        elif kind == "hardly measured":
            seen, strength = n - max(1, n // 4), 10.0 ** rng.uniform(-9, -3)
            A[:seen, seen:] *= strength
            H[:, seen:] *= strength
        elif kind == "1 and 1 + 1e-6":
            values = np.concatenate([[1, 1 + 1e-6], rng.uniform(-1.5, 1.5, n - 2)])
            A = np.triu(A, 1) / 10 + np.diag(values)
            A[0, 1], H[:, :2] = 0, 1
        elif kind == "measurement 1e-9":
            H = H * 1e-9
        yield kind, A, H, (Q + Q.T) / 2, (R + R.T) / 2, discrete


def reference(A, H, Q, R, discrete):
    """Return P as a matrix of python-flint."""
    flint.ctx.prec, n = 700, len(A)
    one = flint.arb_mat(np.eye(n).tolist())
    a, h, q, r = (flint.arb_mat(matrix.tolist()) for matrix in (A.T, H, Q, R))
    q = q + one * (flint.arb(float(np.linalg.norm(Q))) * flint.arb(10) ** -120)
    g = h.transpose() * r.solve(h)
    if not discrete:
        rate = flint.arb(1.2345 * float(np.linalg.norm(A, 2)))
        back = _middle((a - one * rate).inv())
        other = _middle(((a - one * rate).transpose() + q * back * g).inv())
        a = one + 2 * rate * other.transpose()
        g, q = 2 * rate * back * g * other, 2 * rate * other * q * back
    for _ in range(300):
        step = _middle((one + g * q).inv())
        ahead, spread = step * a, step * g
        growth = a.transpose() * q * ahead
        g, q, a = _middle(g + a * spread * a.transpose()), _middle(q + growth), _middle(a * ahead)
        if _greatest(growth) <= _greatest(q) * flint.arb(2) ** -230:
            return q
    raise ArithmeticError("the doubling algorithm does not converge")


def difference(P, near):
    """Return |near - P|/|P|."""
    error = floats(flint.arb_mat(near.tolist()) - P)
    return np.linalg.norm(error) / np.linalg.norm(floats(P))


def floats(matrix):
    entries = [float(entry) for entry in matrix.entries()]
    return np.array(entries).reshape(matrix.nrows(), matrix.ncols())


def _middle(matrix):
    """Drop the radii of the balls: this is no enclosure."""
    return flint.arb_mat(
        matrix.nrows(), matrix.ncols(), [entry.mid() for entry in matrix.entries()]
    )


def _greatest(matrix):
    return max((abs(entry) for entry in matrix.entries()), key=float)
