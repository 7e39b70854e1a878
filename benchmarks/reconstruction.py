"""Reconstruction with the search for the weight M against one `make_smoothing_spline` fit with M
given, and its growth.

The peer solves a single problem of the same functional; ours solves one for every trial value of M
and the sweep at the end.
"""

import numpy as np
from scipy.interpolate import make_smoothing_spline
from stopwatch import seconds

from trajlib.reconstruction import SweepGains, reconstruct

RUNS = 3
BOUND, SIGMA = 0.5, 2.0  # m/s^2, m


def record(n):
    t = np.arange(float(n))
    return t, 100 * np.sin(t / 20) + SIGMA * np.random.default_rng(1).standard_normal(n)


def main():
    for n in (1_000, 10_000, 100_000, 1_000_000):
        t, h = record(n)
        found = reconstruct(t, h, SIGMA, max_acceleration=BOUND)
        ours = seconds(lambda: reconstruct(t, h, SIGMA, max_acceleration=BOUND), RUNS)
        line = (
            f"{n:>9,} samples: {ours:.3f} s, {1e6 * ours / n:.2f} us a sample, M = {found.M:.4g}, "
        )
        line += f"max |u| - D = {found.max_acceleration - BOUND:.1e}"
        if n <= 100_000:
            peer = seconds(
                lambda: make_smoothing_spline(t, h, w=np.full(n, SIGMA**-2), lam=found.M), RUNS
            )
            line += (
                f"; make_smoothing_spline {peer:.3f} s, ours takes {ours / peer:.2f} times as long"
            )
        print(line)
    t, h = record(10_000)
    records = np.stack([h] * 100, axis=1)
    gains = SweepGains(t, SIGMA, 10.0)
    one, many = seconds(lambda: gains.apply(h), RUNS), seconds(lambda: gains.apply(records), RUNS)
    print(
        f"gains ready, 10,000 samples: one record {1e3 * one:.2f} ms, 100 records {1e3 * many:.0f} "
        "ms"
    )


if __name__ == "__main__":
    main()
