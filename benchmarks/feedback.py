"""Gains on arrays, `trajlib.feedback.place` against scipy.signal.place_poles and python-control's
acker and place.

Right first, fast second. General pairs of n states (entries normal, spectral radius about 1), in
good units and in bad ones (states measured in units that differ by up to ten powers of ten), get
the eigenvalues -1/2, ..., -2; then, which asks for little, those of A moved to the left by 1/50.
The table has the greatest distance of an eigenvalue of A + BK, as NumPy computes it, from the one
asked for: the median of the pairs; `fails` where a peer raises an error for one of them. The last
column is what rounding may do to the eigenvalues of our loop (median): where it is large, the
distances are left to chance, and no gain of floats does better.

Then all eigenvalues at -1, which only Ackermann's formula and ours accept; the distance says little
there, since an n-fold eigenvalue is spread by rounding to the power 1/n, so the table has our
residual. Then seconds; last those of `lqr` and `discrete_lqr` beside SciPy's solvers of the Riccati
equation (bar: `lqr` of 5 to 20 states at most twice SciPy's time).

    .venv/bin/python benchmarks/feedback.py [pairs of each kind, 5 if left out]
"""

import sys
import time
import warnings

import control
import numpy as np
import scipy.linalg
import scipy.signal
from stopwatch import seconds

from trajlib.feedback import discrete_lqr, lqr, place

PEERS = {
    "scipy place_poles": lambda A, B, w: -scipy.signal.place_poles(A, B, w).gain_matrix,
    "control.place": lambda A, B, w: -np.asarray(control.place(A, B, w)),
    "control.acker": lambda A, B, w: -np.atleast_2d(control.acker(A, B, w)),
}


def pair(rng, n, s, spread):
    A, B = rng.normal(size=(n, n)) / np.sqrt(n), rng.normal(size=(n, s))
    units = 10.0 ** rng.uniform(-spread, spread, size=n)
    return A * units / units[:, None], B / units[:, None]


def distance(A, B, gain, wanted):
    from scipy.optimize import linear_sum_assignment

    far = abs(np.subtract.outer(wanted, np.linalg.eigvals(A + B @ gain)))
    return far[linear_sum_assignment(far)].max()


def median(values):
    return "fails" if None in values else f"{np.median(values):.1e}"


def accuracy(count):
    print(
        f"{'n':>3} {'s':>2} {'pairs':>6} {'trajlib':>9}",
        *(f"{name:>18}" for name in PEERS),
        f"{'rounding':>9}",
    )
    for n, s in ((5, 1), (10, 1), (15, 1), (20, 1), (30, 1), (40, 1), (6, 2), (12, 3)):
        for kind in ("good", "bad", "little"):
            rng, found = (
                np.random.default_rng(n),
                {name: [] for name in ("trajlib", *PEERS, "rounding")},
            )
            for _ in range(count):
                A, B = pair(rng, n, s, 5 * (kind == "bad"))
                wanted = (
                    np.linalg.eigvals(A) - 0.02 if kind == "little" else -np.linspace(0.5, 2, n)
                )
                ours = place(A, B, wanted)
                found["trajlib"].append(distance(A, B, ours.gain, wanted))
                found["rounding"].append(ours.uncertainty)
                for name, peer in PEERS.items():
                    try:
                        found[name].append(distance(A, B, peer(A, B, wanted), wanted))
                    except Exception:
                        found[name].append(None)
            ours, *others, rounding = map(median, found.values())
            print(
                f"{n:3} {s:2} {kind:>6} {ours:>9}",
                *(f"{other:>18}" for other in others),
                f"{rounding:>9}",
                flush=True,
            )


def repeated(count):
    print("\nall eigenvalues at -1: the residual of ours, the condition of the eigenvectors")
    for n, s in ((5, 1), (20, 1), (40, 1), (6, 2), (12, 3), (40, 4)):
        rng = np.random.default_rng(n)
        found = [place(*pair(rng, n, s, 0), [-1] * n) for _ in range(count)]
        print(
            f"{n:3} {s:2} {median([one.residual for one in found])} "
            f"{median([one.condition for one in found])}",
            flush=True,
        )


def speed():
    print("\nseconds")
    for n, s in ((5, 1), (20, 1), (40, 1), (12, 3)):
        A, B = pair(np.random.default_rng(n), n, s, 0)
        wanted = -np.linspace(0.5, 2, n)
        print(
            f"{n:3} {s:2} trajlib {seconds(lambda A=A, B=B, w=wanted: place(A, B, w), 3):.2g}, "
            "scipy place_poles "
            f"{seconds(lambda A=A, B=B, w=wanted: PEERS['scipy place_poles'](A, B, w), 3):.2g}",
            flush=True,
        )


def regulators():
    print("\nregulators, milliseconds of the processor: trajlib, SciPy, ratio")
    for n in (2, 5, 10, 20):
        A, B = pair(np.random.default_rng(n), n, 2, 0)
        G, N = np.eye(n), np.eye(2)
        for name, ours, theirs in (
            ("lqr", lqr, scipy.linalg.solve_continuous_are),
            ("discrete_lqr", discrete_lqr, scipy.linalg.solve_discrete_are),
        ):
            mine, other = (
                1e3 * seconds(lambda f=f, A=A, B=B, G=G, N=N: f(A, B, G, N), 30, time.process_time)
                for f in (ours, theirs)
            )
            print(f"{n:3} {name:>12} {mine:7.2f} {other:7.2f} {mine / other:5.1f}", flush=True)


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    pairs = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    accuracy(pairs)
    repeated(pairs)
    speed()
    regulators()
