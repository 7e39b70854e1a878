"""Tight values of many polygons against SciPy's `linprog`, a programme a normal; and a step of
information sets as published against the guaranteed one, in the run of chapter 9.

The peers solve the same tasks: `linprog` gives the support values of the same half-planes, and both
steps follow the same motion with the same measurements.
"""

import numpy as np
from scipy.optimize import linprog
from stopwatch import seconds

from trajlib.infosets import InformationSet, Region, SupportPolygons
from trajlib.infosets.polygons import normals

RUNS = 3
DATA = {"k": 6.0, "mu": (-1.0, 3.0), "speeds": (180.0, 360.0)}


def programmed(values):
    n = normals(values.shape[-1])
    found = [
        [linprog(-direction, A_ub=n, b_ub=one, bounds=(None, None)) for direction in n]
        for one in values
    ]
    return np.array([[-np.inf if one.status == 2 else -one.fun for one in row] for row in found])


def flown(mode, until):
    """A forecast of 20 s from all headings, then from what a square has left."""
    found = InformationSet(Region.box([0, 0], 400), mode=mode, **DATA)
    for t in range(1, until + 1):
        found.advance()
        if t == 20:
            found.measure(Region.box([4500, 200], 400))


def main():
    for m in (8, 12, 16):
        values = np.random.default_rng(m).normal(0.3 + 0.1 * m, 1, (20, m))
        many = np.tile(values, (5000, 1))
        ours = seconds(lambda: SupportPolygons(many), RUNS) / len(many)
        peer = seconds(lambda: programmed(values), 1) / len(values)
        tight, true = SupportPolygons(values).values, programmed(values)
        there = np.isfinite(true)
        assert (there == np.isfinite(tight)).all()
        apart = np.abs(tight[there] - true[there]).max()
        print(
            f"m = {m}: {1e6 * ours:.2f} us a polygon, linprog {1e3 * peer:.1f} ms, "
            f"{peer / ours:,.0f} times as long; "
            f"values differ by {apart:.0e}, {np.sum(~there[:, 0])} of {len(values)} empty"
        )
    for until in (20, 40):
        old, new = (
            1e3 * seconds(lambda: flown(mode, until), RUNS) / until
            for mode in ("published", "guaranteed")
        )
        print(
            f"{until} steps from all headings, a measurement at 20 s: published {old:.1f} ms a "
            f"step, guaranteed {new:.1f} ms, {new / old:.1f} times as long"
        )


if __name__ == "__main__":
    main()
