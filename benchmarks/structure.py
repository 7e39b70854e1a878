"""Verdicts and decompositions of `trajlib.structure` against python-control, SciPy and
sympy.physics.control.

Right first, fast second. Floats: pairs whose unobservable states are known by construction
(tests/library/known_pairs.py: rotated, in bad units, defective, up to 60 states) are judged by
everybody, and wrong ranks are counted; then seconds for a verdict and a decomposition up to n =
100. The peers: the rank of python-control's Kalman matrix; its `minreal` (SLICOT's staircase, only
where slycot is installed); Popov's criterion at SciPy's eigenvalues. Exact: verdicts against
sympy.physics.control, which for parameters says True or False and never where; conditions in two
parameters, which none of them has, up to n = 8 (there a cubic without simple roots comes up, and
the system is refused). Proved distances to the nearest unobservable pair, which none of them has.

    .venv/bin/python benchmarks/structure.py [number of pairs, 500 if left out]

SLICOT joins when slycot is in the environment (.venv/bin/pip install slycot).
"""

import sys
import warnings
from importlib.util import find_spec
from pathlib import Path

import control
import numpy as np
import scipy.linalg
import sympy as sp
from stopwatch import seconds
from sympy.physics.control import StateSpace

from trajlib.structure import (
    distance_to_unobservable,
    observability,
    observability_conditions,
    observability_decomposition,
)

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "library"))
from known_pairs import known_pair

ROUNDING = np.finfo(float).eps


def kalman(A, H):
    return np.linalg.matrix_rank(control.obsv(A, H))


def popov(A, H):
    """Holds or not; the rank is not known from it."""
    values = scipy.linalg.eigvals(A)
    limit = 100 * len(A) * ROUNDING * np.linalg.norm(np.vstack([A, H]), 2)
    return all(
        scipy.linalg.svdvals(np.vstack([A - x * np.eye(len(A)), H]))[-1] > limit for x in values
    )


def slicot(A, H):
    """Order of the minimal realisation with all states steered: the rank of observability."""
    return control.minreal(control.ss(A, np.eye(len(A)), H, 0), verbose=False).nstates


def ours(A, H):
    return observability(A, H).rank


def judged(count):
    """Wrong ranks (verdicts for Popov's criterion) of each method."""
    peers = {"trajlib": ours, "rank of control.obsv": kalman}
    if find_spec("slycot"):
        peers["control.minreal (SLICOT)"] = slicot
    else:
        print("slycot is not installed: SLICOT's staircase is left out")
    wrong, failed = (
        dict.fromkeys([*peers, "Popov at SciPy's eigenvalues"], 0),
        dict.fromkeys(peers, 0),
    )
    yes, rng = dict.fromkeys(wrong, 0), np.random.default_rng(16)
    for _ in range(count):
        A, H, unobservable, _ = known_pair(rng)
        for name, method in peers.items():
            try:
                rank = method(A, H)
            except Exception:
                failed[name] += 1
                continue
            wrong[name] += rank != len(A) - unobservable
            yes[name] += (rank == len(A)) != (unobservable == 0)
        said = popov(A, H) != (unobservable == 0)
        wrong["Popov at SciPy's eigenvalues"] += said
        yes["Popov at SciPy's eigenvalues"] += said
    print(
        f"\n{count} pairs of known structure, 2 to 60 states: wrong ranks, wrong verdicts, refused"
    )
    for name, number in wrong.items():
        ranks = "   -" if name.startswith("Popov") else f"{number:4}"
        print(f"  {name:30} {ranks} {yes[name]:4} {failed.get(name, 0):4}")


def timed():
    print("\nseconds for one pair, observable and with a third of the states unobservable")
    for n in (10, 30, 60, 100):
        rng, row = np.random.default_rng(n), []
        for hidden in (0, n // 3):
            A, H = rng.normal(size=(n, n)) / np.sqrt(n), rng.normal(size=(2, n))
            A[: n - hidden, n - hidden :], H[:, n - hidden :] = 0, 0
            Q = np.linalg.qr(rng.normal(size=(n, n)))[0]
            A, H = Q @ A @ Q.T, H @ Q.T
            verdict, split = (
                seconds(lambda f=f: f(A, H), 3)
                for f in (observability, observability_decomposition)
            )
            peers = seconds(lambda: kalman(A, H), 3), seconds(lambda: popov(A, H), 3)
            found = observability(A, H).rank, kalman(A, H)
            row.append(
                f"verdict {verdict:6.3f} ({verdict / peers[1]:5.1f} x Popov at the eigenvalues), "
                f"decomposition {split:6.3f}, obsv {peers[0]:6.3f}; ranks {found[0]}, obsv "
                f"{found[1]}, true {n - hidden}"
            )
        print(f"  n = {n:3}: " + "\n           ".join(row))


def exact():
    print("\nexact verdicts: seconds, trajlib and sympy.physics.control")
    for n in (4, 6, 8, 12):
        rng = np.random.default_rng(n)
        A, H = sp.Matrix(rng.integers(-3, 4, (n, n))), sp.Matrix(rng.integers(-3, 4, (1, n)))
        system = StateSpace(A, sp.zeros(n, 1), H, sp.zeros(1))
        own, peer = (
            seconds(lambda: observability(A, H), 3),
            seconds(lambda: system.is_observable(), 1),
        )
        print(f"  n = {n:2}: {own:7.3f} {peer:7.3f}   {peer / own:5.1f} times")
    a = sp.Symbol("a")
    A, H = sp.Matrix([[0, 1], [0, a]]), sp.Matrix([[1, -1]])
    found = observability_conditions(A, H, [a])
    print(
        f"  with a parameter: trajlib {found.region}; sympy.physics.control "
        f"{StateSpace(A, sp.zeros(2, 1), H, sp.zeros(1)).is_observable()}, and nothing of a = 1"
    )


def conditions():
    print(
        "\nconditions in two parameters (neither python-control, SciPy nor sympy.physics.control "
        "has them): seconds"
    )
    a, b = sp.symbols("a b")
    for n in range(2, 9):
        # a symmetric chain with a and b at its ends, both of which are measured together
        A = sp.zeros(n)
        for i in range(n - 1):
            A[i, i + 1] = A[i + 1, i] = 1
        A[0, 0], A[n - 1, n - 1] = a, b
        H = sp.Matrix([[1] + [0] * (n - 2) + [1]])
        try:
            taken = seconds(lambda: observability_conditions(A, H, [a, b]), 1)
            found = observability_conditions(A, H, [a, b])
            print(f"  n = {n}: {taken:6.2f}   {str(found.region)[:80]}")
        except NotImplementedError as error:
            print(f"  n = {n}: refused: {str(error)[:90]}")


def distances():
    print(
        "\ndistance to the nearest unobservable pair, proved within 1 % (no peer has it): seconds"
    )
    for n in (5, 10, 20, 30):
        rng = np.random.default_rng(n)
        pairs = {
            "chain": (np.diag(np.ones(n - 1), 1), np.eye(n)[[0]]),
            "random, 1 output": (rng.normal(size=(n, n)), rng.normal(size=(1, n))),
            "random, 3 outputs": (rng.normal(size=(n, n)), rng.normal(size=(3, n))),
        }
        for name, (A, H) in pairs.items():
            taken, found = (
                seconds(lambda: distance_to_unobservable(A, H), 1),
                distance_to_unobservable(A, H),
            )
            print(f"  n = {n:2} {name:17}: {taken:6.2f}   {found.lower:.5f} to {found.upper:.5f}")


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    judged(int(sys.argv[1]) if len(sys.argv) > 1 else 500)
    timed()
    exact()
    conditions()
    distances()
