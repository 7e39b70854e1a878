"""Records off the fast path: gaps, and irregular times, against loops in plain NumPy.

The loops are a textbook's, with one `solve` a step and (E - KH) P; at irregular times with one exponential
of van Loan a step. Systems are drawn at random: n states, 2 outputs, a tenth of the rows or of the entries
missing. How far the results are from those of a loop with Joseph's form is printed beside the rates; the
plain loop, which is timed, may lose the symmetry of P, and with it all digits (n = 32). Where e^{-Ah} grows, van
Loan's exponential loses digits that the power series keeps: the last column has both errors of one long step
from 60 digits. Rates are rows a second of processor time, ratios above 1 say that trajlib is faster. Run by
estimation.py, alone with `--part gaps`.
"""

import numpy as np
import scipy.linalg

STATES = (2, 4, 8, 12, 16, 24, 32)
ROWS, LOOP_ROWS = 20_000, 4_000


def side_by_side(seconds):
    """Print rates with gaps and at irregular times."""
    print("\na tenth missing, 2 outputs: rows a second, and the ratio to the plain loop")
    for n in STATES:
        with_gaps(n, seconds)
    print("\nirregular times, 2 outputs: rows a second, and the ratio to the loop of van Loan")
    for n in STATES:
        at_irregular_times(n, seconds)


def random_system(n, continuous):
    rng = np.random.default_rng(n)
    A, mixing = rng.normal(size=(n, n)), rng.normal(size=(n, n))
    values = np.linalg.eigvals(A)
    if continuous:
        A -= (values.real.max() + 0.2) * np.eye(n)
    else:
        A *= 0.98 / np.abs(values).max()
    return A, rng.normal(size=(2, n)), mixing @ mixing.T / n, np.diag([0.5, 0.8])


def corrected(x, P, z, H, R):
    K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


def corrected_by_joseph(x, P, z, H, R):
    K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
    reduction = np.eye(len(x)) - K @ H
    return x + K @ (z - H @ x), reduction @ P @ reduction.T + K @ R @ K.T


def loop_with_gaps(Phi, H, Q, R, z, missing, correct=corrected):
    n = len(Phi)
    x, P = np.zeros(n), np.eye(n)
    estimates, covariances = np.empty((len(z), n)), np.empty((len(z), n, n))
    for k, row in enumerate(z):
        if not missing[k]:
            x, P = correct(x, P, row, H, R)
        estimates[k], covariances[k] = x, P
        x, P = Phi @ x, Phi @ P @ Phi.T + Q
    return estimates, covariances


def van_loan(A, Q, step):
    n = len(A)
    power = scipy.linalg.expm(np.block([[-A, Q], [np.zeros((n, n)), A.T]]) * step)
    Phi = power[n:, n:].T
    return Phi, Phi @ power[:n, n:]


def loop_at_times(A, H, Q, R, z, times):
    n = len(A)
    x, P = np.zeros(n), np.eye(n)
    estimates, covariances = np.empty((len(z), n)), np.empty((len(z), n, n))
    for k, row in enumerate(z):
        if k:
            Phi, noise = van_loan(A, Q, times[k] - times[k - 1])
            x, P = Phi @ x, Phi @ P @ Phi.T + noise
        x, P = corrected(x, P, row, H, R)
        estimates[k], covariances[k] = x, P
    return estimates, covariances


def apart(run, loop):
    """Largest differences of estimates and covariances, in standard deviations."""
    estimates, covariances = loop
    deviations = np.sqrt(np.einsum("kii->ki", covariances))
    rows = len(estimates)
    errors = (run.estimates[:rows] - estimates) / deviations
    scale = deviations[:, :, None] * deviations[:, None, :]
    differences = (run.covariances[:rows] - covariances) / scale
    return f"{np.abs(errors).max():.1e} / {np.abs(differences).max():.1e}"


def with_gaps(n, seconds):
    from trajlib.estimation import KalmanFilter, Moments

    rng, system = np.random.default_rng(1), random_system(n, False)
    z, rows, entries = (
        rng.normal(size=(ROWS, 2)),
        rng.random(ROWS) < 0.1,
        rng.random((ROWS, 2)) < 0.1,
    )
    filter, start = KalmanFilter(*system), Moments(np.zeros(n), np.eye(n))
    run = filter.run(z, start, rows)
    loop = loop_with_gaps(*system, z[:LOOP_ROWS], rows[:LOOP_ROWS], corrected_by_joseph)
    rates = [
        ROWS / seconds(lambda missing=missing: filter.run(z, start, missing), 3)
        for missing in (rows, entries)
    ]
    plain = LOOP_ROWS / seconds(lambda: loop_with_gaps(*system, z[:LOOP_ROWS], rows[:LOOP_ROWS]), 3)
    print(
        f"n = {n:2}: whole rows {rates[0]:9,.0f} ({rates[0] / plain:5.2f}), "
        f"entries {rates[1]:9,.0f} ({rates[1] / plain:5.2f}), apart by {apart(run, loop)}",
        flush=True,
    )


def at_irregular_times(n, seconds):
    from trajlib.estimation import KalmanFilter, Moments

    rng, system = np.random.default_rng(2), random_system(n, True)
    A, _, Q, _ = system
    times, z = np.cumsum(rng.exponential(0.3, ROWS)), rng.normal(size=(ROWS, 2))
    start, rows = Moments(np.zeros(n), np.eye(n)), LOOP_ROWS // 4
    run = KalmanFilter.sampled(*system, times).run(z, start)
    loop = loop_at_times(*system, z[:rows], times)
    rate = ROWS / seconds(lambda: KalmanFilter.sampled(*system, times).run(z, start), 3)
    plain = rows / seconds(lambda: loop_at_times(*system, z[:rows], times), 3)
    print(
        f"n = {n:2}: {rate:9,.0f} ({rate / plain:6.2f}), apart by {apart(run, loop)}"
        + (f"; noise of a step of 2.5 {errors_of_a_long_step(A, Q)}" if n <= 8 else ""),
        flush=True,
    )


def errors_of_a_long_step(A, Q, step=2.5):
    """Relative errors of the noise of one step from 60 digits."""
    import mpmath

    from trajlib.estimation import discretise

    n = len(A)
    with mpmath.workdps(60):
        joint = np.block([[-A, Q], [np.zeros((n, n)), A.T]]).tolist()
        power = mpmath.expm(mpmath.matrix(joint) * mpmath.mpf(step))
        exact = np.array((power[n:, n:].T * power[:n, n:]).tolist(), dtype=float)
    size = np.abs(exact).max()
    own, loop = discretise(A, Q, step).Q, van_loan(A, Q, step)[1]
    return (
        f"{np.abs(own - exact).max() / size:.1e}, van Loan {np.abs(loop - exact).max() / size:.1e}"
    )
