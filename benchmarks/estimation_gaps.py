"""Filter and smoother in five cases, and at irregular times, against loops in plain NumPy and statsmodels.

The cases are the filter and the smoother (timed with its filter) without gaps and with a tenth of the rows
missing, and the filter of an orthogonal Phi without process noise, whose covariance never settles. Systems are
drawn at random: n states, 2 outputs. The loops are a textbook's, with one `solve` a step and (E - KH) P, made
symmetric, without which P loses all digits for 32 states; at irregular times with one exponential of van Loan a
step. How far the results are from those of a loop with Joseph's form is printed beside the rates. Where e^{-Ah}
grows, van Loan's exponential loses digits that the power series keeps: the last column has both errors of one
long step from 60 digits. Rates are rows a second of processor time, ratios above 1 say that trajlib is faster.
Run by estimation.py, alone and without statsmodels with `--part gaps`.
"""

from typing import NamedTuple

import numpy as np
import scipy.linalg

STATES = (2, 4, 8, 12, 16, 24, 32)
ROWS, LOOP_ROWS = 20_000, 4_000


def side_by_side(seconds):
    """Print rates of the five cases and at irregular times."""
    print("\n2 outputs: rows a second, and the ratio to the plain loop")
    for n in STATES:
        for case in cases(n):
            beside_the_loop(n, case, seconds)
    print("\nirregular times, 2 outputs: rows a second, and the ratio to the loop of van Loan")
    for n in STATES:
        at_irregular_times(n, seconds)


class Case(NamedTuple):
    title: str
    system: tuple
    missing: np.ndarray
    smoothed: bool


def cases(n):
    """Return the five cases for n states."""
    Phi, H, _, R = system = random_system(n, False)
    undamped = np.linalg.qr(Phi)[0], H, np.zeros((n, n)), R
    none, rows = np.zeros(ROWS, dtype=bool), np.random.default_rng(1).random(ROWS) < 0.1
    return [
        Case("filter", system, none, False),
        Case("filter with gaps", system, rows, False),
        Case("smoother", system, none, True),
        Case("smoother with gaps", system, rows, True),
        Case("filter, Q = 0", undamped, none, False),
    ]


def measurements():
    return np.random.default_rng(4).normal(size=(ROWS, 2))


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
    P = (np.eye(len(x)) - K @ H) @ P
    return x + K @ (z - H @ x), (P + P.T) / 2


def corrected_by_joseph(x, P, z, H, R):
    K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
    reduction = np.eye(len(x)) - K @ H
    return x + K @ (z - H @ x), reduction @ P @ reduction.T + K @ R @ K.T


def loop(case, rows, correct=corrected):
    """Return estimates and covariances of the first rows, filtered or smoothed."""
    (Phi, H, Q, R), z = case.system, measurements()[:rows]
    n = len(Phi)
    x, P = np.zeros(n), np.eye(n)
    before, estimates = np.empty((2, rows, n))
    covariances_before, covariances = np.empty((2, rows, n, n))
    for k, row in enumerate(z):
        before[k], covariances_before[k] = x, P
        if not case.missing[k]:
            x, P = correct(x, P, row, H, R)
        estimates[k], covariances[k] = x, P
        x, P = Phi @ x, Phi @ P @ Phi.T + Q
    for k in range(rows - 2, -1, -1) if case.smoothed else ():
        C = np.linalg.solve(covariances_before[k + 1], Phi @ covariances[k]).T
        estimates[k] += C @ (estimates[k + 1] - before[k + 1])
        covariances[k] += C @ (covariances[k + 1] - covariances_before[k + 1]) @ C.T
    return estimates, covariances


def own(case, rows=ROWS):
    """Return trajlib's run of the first rows, filtered or smoothed."""
    from trajlib.estimation import KalmanFilter, Moments

    n = len(case.system[0])
    run = KalmanFilter(*case.system).run(
        measurements()[:rows], Moments(np.zeros(n), np.eye(n)), case.missing[:rows]
    )
    return run.smoothed() if case.smoothed else run


def of_statsmodels(folder, seconds):
    """Run in the peers' environment: results of all cases to files; returns their seconds."""
    from statsmodels.tsa.statespace.kalman_smoother import KalmanSmoother

    taken = {}
    for n in STATES:
        for case in cases(n):
            Phi, H, Q, R = case.system
            z = np.where(case.missing[:, None], np.nan, measurements())

            def run(case=case, z=z, matrices=(Phi, H, Q, R), n=n):
                Phi, H, Q, R = matrices
                f = KalmanSmoother(
                    2, n, design=H, obs_cov=R, transition=Phi, selection=np.eye(n), state_cov=Q
                )
                f.bind(z.copy())
                f.initialize_known(np.zeros(n), np.eye(n))
                return f.smooth() if case.smoothed else f.filter()

            result, key = run(), f"{n} {case.title}"
            taken[key] = seconds(run, 3)
            kind = "smoothed" if case.smoothed else "filtered"
            np.savez(
                folder / f"{key}.npz",
                estimates=getattr(result, f"{kind}_state").T,
                covariances=getattr(result, f"{kind}_state_cov").transpose(2, 0, 1),
            )
    return taken


def beside_statsmodels(folder, taken, seconds):
    """Print rates and the ratio to statsmodels, whose seconds and results `of_statsmodels` gave."""
    print("\n2 outputs: rows a second, and the ratio to statsmodels")
    for n in STATES:
        for case in cases(n):
            key = f"{n} {case.title}"
            with np.load(folder / f"{key}.npz") as found:
                difference = apart(own(case), (found["estimates"], found["covariances"]))
            time = seconds(lambda case=case: own(case), 3)
            print(
                f"n = {n:2}, {case.title:18} {ROWS / time:9,.0f} ({taken[key] / time:6.2f}), "
                f"apart by {difference}",
                flush=True,
            )


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


def apart(run, reference):
    """Largest differences of estimates and covariances, in standard deviations."""
    estimates, covariances = reference
    deviations = np.sqrt(np.einsum("kii->ki", covariances))
    rows = len(estimates)
    errors = (run.estimates[:rows] - estimates) / deviations
    scale = deviations[:, :, None] * deviations[:, None, :]
    differences = (run.covariances[:rows] - covariances) / scale
    return f"{np.abs(errors).max():.1e} / {np.abs(differences).max():.1e}"


def beside_the_loop(n, case, seconds):
    reference = loop(case, LOOP_ROWS, corrected_by_joseph)
    difference = apart(own(case, LOOP_ROWS), reference)
    rate = ROWS / seconds(lambda: own(case), 3)
    plain = LOOP_ROWS / seconds(lambda: loop(case, LOOP_ROWS), 3)
    print(
        f"n = {n:2}, {case.title:18} {rate:9,.0f} ({rate / plain:6.2f}), apart by {difference}",
        flush=True,
    )


def at_irregular_times(n, seconds):
    from trajlib.estimation import KalmanFilter, Moments

    rng, system = np.random.default_rng(2), random_system(n, True)
    A, _, Q, _ = system
    times, z = np.cumsum(rng.exponential(0.3, ROWS)), rng.normal(size=(ROWS, 2))
    start, rows = Moments(np.zeros(n), np.eye(n)), LOOP_ROWS // 4
    run = KalmanFilter.sampled(*system, times).run(z, start)
    reference = loop_at_times(*system, z[:rows], times)
    rate = ROWS / seconds(lambda: KalmanFilter.sampled(*system, times).run(z, start), 3)
    plain = rows / seconds(lambda: loop_at_times(*system, z[:rows], times), 3)
    print(
        f"n = {n:2}: {rate:9,.0f} ({rate / plain:6.2f}), apart by {apart(run, reference)}"
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
