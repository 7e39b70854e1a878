"""Linearising along an orbit against central differences with SciPy's `solve_ivp`, and `analyse`
against `numpy.linalg.matrix_rank`.

Time is one half of the comparison and accuracy the other: the exact stacked matrix of the
geostationary orbit is known, so both results are compared with it. The peer has the same integrator
and tolerance; it gives no estimate of its error and no verdict.
"""

import numpy as np
from scipy.integrate import solve_ivp
from stopwatch import seconds

from trajlib.solvability import analyse, clohessy_wiltshire, linearise, stack

RUNS = 5
GRAVITY, EARTH, RATE = 398600.4418, 6378.137, 7.2921159e-5  # km^3/s^2, km, 1/s
ORBIT = (GRAVITY / RATE**2) ** (1 / 3)
START = np.array([ORBIT, 0, 0, 0, ORBIT * RATE, 0])
STATIONS = EARTH * np.array([[0.46, 0.35, 0.82], [0.76, -0.05, 0.65]])
# steps of the differences before their factor: km and km/s
SIZES = np.array([1, 1, 1, RATE, RATE, RATE])


def field(t, s):
    x, y, z, vx, vy, vz = s
    r3 = (x * x + y * y + z * z) ** 1.5
    return [vx, vy, vz, -GRAVITY * x / r3, -GRAVITY * y / r3, -GRAVITY * z / r3]


def ranges(t, s):
    c, k = np.cos(RATE * t), np.sin(RATE * t)
    return [
        np.sqrt(
            (s[0] - c * p[0] + k * p[1]) ** 2
            + (s[1] - k * p[0] - c * p[1]) ** 2
            + (s[2] - p[2]) ** 2
        )
        for p in STATIONS
    ]


def differences(times, step, rtol):
    def outputs(state):
        motion = solve_ivp(
            field,
            (times[0], times[-1]),
            state,
            method="DOP853",
            t_eval=times,
            rtol=rtol,
            atol=rtol * 1e-3,
        )
        return np.array(ranges(times, motion.y)).T.ravel()

    return np.column_stack(
        [
            (outputs(START + step * size * e) - outputs(START - step * size * e))
            / (2 * step * size)
            for size, e in zip(SIZES, np.eye(6))
        ]
    )


def exact(times):
    """In axes that turn, the satellite rests; the start is carried over from axes that do not."""
    directions = np.array([ORBIT, 0, 0]) - STATIONS
    sight = np.hstack(
        [directions / np.linalg.norm(directions, axis=1, keepdims=True), np.zeros((2, 3))]
    )
    turning = np.eye(6)
    turning[3, 1], turning[4, 0] = RATE, -RATE
    return stack(sight, clohessy_wiltshire(RATE, times)) @ turning


def main():
    for number in (145, 1441):
        times = np.linspace(0, 86400, number)
        true = exact(times)
        scale = np.linalg.norm(true, axis=0)

        def error(matrix):
            return np.abs((matrix - true) / scale).max() * np.sqrt(len(true))

        found = linearise(field, ranges, START, times, rtol=1e-10)
        ours = seconds(lambda: linearise(field, ranges, START, times, rtol=1e-10), RUNS)
        print(
            f"linearising, {number} epochs, 2 stations: {1e3 * ours:.0f} ms, relative error "
            f"{error(found.matrix):.0e} "
            f"(estimated {np.abs(found.error / scale).max() * np.sqrt(len(true)):.0e})"
        )
        for rtol in (1e-10, 1e-12):
            peer = seconds(lambda: differences(times, 1.0, rtol), RUNS)
            # the peer gets the step that suits it best, which its user would not know
            wrong, step = min(
                (error(differences(times, step, rtol)), step)
                for step in (0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0)
            )
            print(
                f"   central differences, rtol {rtol:.0e}: {1e3 * peer:.0f} ms, error {wrong:.0e} "
                f"with the best step ({step:g} km); ours takes {ours / peer:.2f} times as long, "
                f"its error is {wrong / error(found.matrix):.0f} times smaller"
            )
    random = np.random.default_rng(0)
    for n in (100, 1000, 10_000):
        matrix = random.standard_normal((n, 6))
        ours, peer = (
            seconds(lambda: analyse(matrix, np.ones(n)), RUNS),
            seconds(lambda: np.linalg.matrix_rank(matrix), RUNS),
        )
        print(
            f"judging {n:>6,} x 6: {1e3 * ours:.2f} ms, numpy.linalg.matrix_rank {1e3 * peer:.2f} "
            f"ms: {ours / peer:.1f} times"
        )


if __name__ == "__main__":
    main()
