"""Riccati equations in floats, `trajlib.estimation.stationary_filter` against SciPy's solvers.

Random equations of 2 to 100 states, of the kinds of tests/library/riccati_pairs.py, half of them in
discrete time. The truth is computed with 700 bits. The table has for each kind how many are solved
and how many are called unsolvable, which is false for all of them; the greatest ratio of the error
|dP|/|P| to its own estimate (bar: 1), the median of the estimate beside the error (bar: 1000), and
the median and the greatest error, beside those of SciPy. Then the time at n = 100 (bar: 3 times
SciPy's).

    .venv/bin/python benchmarks/riccati.py [number of equations, 500 if left out] [states, 100]
"""

import sys
import warnings
from pathlib import Path

import numpy as np
import scipy.linalg
from stopwatch import seconds

from trajlib.estimation import discrete_stationary_filter, stationary_filter

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "library"))
from riccati_pairs import KINDS, difference, reference, riccati_pairs


def ours(A, H, Q, R, discrete):
    return (discrete_stationary_filter if discrete else stationary_filter)(A, H, Q, R)


def peer(A, H, Q, R, discrete):
    solve = scipy.linalg.solve_discrete_are if discrete else scipy.linalg.solve_continuous_are
    return solve(A.T, H.T, Q, R)


def accuracy(count, largest):
    rows = {kind: [] for kind in KINDS}
    for kind, *equation in riccati_pairs(count, largest):
        found, theirs = tried(ours, equation), tried(peer, equation)
        P = reference(*equation)
        mine = difference(P, found.covariance) if found else None
        other = difference(P, theirs) if theirs is not None else None
        rows[kind].append((found, mine, other))
    print(
        f"{'':>18} {'solved':>10} {'false none':>10} {'error/est.':>10} {'est./error':>10} "
        f"{'median, greatest error':>24} {'SciPy: solved':>14} {'median, greatest error':>24}"
    )
    for kind, row in rows.items():
        solved = [(found.error, mine) for found, mine, _ in row if found]
        refused = sum(found is not None and not found for found, _, _ in row)
        estimates, errors = np.array(solved).T
        errors = np.maximum(errors, 1e-18)
        others = [other for *_, other in row if other is not None]
        print(
            f"{kind:>18} {len(solved):5} / {len(row):<3}{refused:10} "
            f"{max(errors / estimates):10.2f} {np.median(estimates / errors):10.1f} "
            f"{np.median(errors):14.1e} {max(errors):9.1e} "
            f"{len(others):10} / {len(row):<3}{np.median(others):13.1e} {max(others):9.1e}",
            flush=True,
        )


def tried(function, equation):
    """Return the result, or None for "not found"; SciPy refuses some R in bad units as singular."""
    try:
        return function(*equation)
    except np.linalg.LinAlgError:
        return None
    except ValueError:
        if function is ours:
            raise
        return None


def speed():
    print("\nseconds at n = 100: trajlib, SciPy, ratio")
    for m in (5, 20, 50):
        rng = np.random.default_rng(m)
        A, H = rng.normal(size=(100, 100)) / 10, rng.normal(size=(m, 100))
        for discrete in (False, True):
            equation = A, H, np.eye(100), np.eye(m), discrete
            mine, theirs = (seconds(lambda f=f, e=equation: f(*e), 5) for f in (ours, peer))
            kind = "discrete" if discrete else "continuous"
            print(f"{m:3} outputs, {kind:>10}: {mine:.3f} {theirs:.3f} {mine / theirs:.1f}")


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    sizes = [int(argument) for argument in sys.argv[1:]] + [500, 100][len(sys.argv) - 1 :]
    speed()
    accuracy(*sizes)
