"""The Kalman filter of `trajlib.estimation` against filterpy, simdkalman and cd-dynamax: numbers
first, then seconds.

One series: 100,000 steps of 4 states and 2 outputs, time-invariant, against filterpy's predict and
update, a call each a step. Many series: 1,000 of 1,000 steps at once, against simdkalman. Further,
what they have no shortcut for: a tenth of the measurements missing at random, and matrices of each
step's own. Last, measurements at irregular moments side by side with cd-dynamax, in
estimation_irregular.py; `--part irregular` runs this alone. `--part gaps` compares with loops in
plain NumPy, for 2 to 32 states, with gaps and at irregular times (estimation_gaps.py), and needs no
peer. The peers live in an environment of their own, made on the first run in _build/filter-peers or
where `--environment` says; numbers are handed over in files. The clock is the processor's, inside
the process that computes, the least of several runs. One thread for linear algebra: more only get
in one another's way on matrices of this size.

    OPENBLAS_NUM_THREADS=1 .venv/bin/python benchmarks/estimation.py
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import estimation_gaps
import estimation_irregular as irregular
import numpy as np

HERE = Path(__file__).resolve().parent
PEERS = ("filterpy", "simdkalman")
PACKAGES = [*PEERS, "cd-dynamax==0.5.0"]
STEPS, SERIES, LENGTH, RUNS = 100_000, 1_000, 1_000, 3


def seconds(function, runs):
    """Processor time of a call, the least of several."""
    taken = []
    for _ in range(runs):
        start = time.process_time()
        function()
        taken.append(time.process_time() - start)
    return min(taken)


def system():
    """Two oscillators, one damped, driven and seen together."""
    turn = np.array([[np.cos(0.3), np.sin(0.3)], [-np.sin(0.3), np.cos(0.3)]])
    Phi = np.block([[0.98 * turn, 0.05 * np.ones((2, 2))], [np.zeros((2, 2)), 0.999 * turn.T]])
    return (
        Phi,
        np.array([[1.0, 0, 0.5, 0], [0, 0.3, 0, 1]]),
        np.diag([0.1, 0.2, 0.05, 0.1]),
        np.diag([0.5, 0.8]),
    )


def measurements(steps, series, seed):
    from trajlib.estimation import Moments, simulate_discrete

    Phi, H, Q, R = system()
    return simulate_discrete(
        Phi, Q, Moments(np.zeros(4), np.eye(4)), steps, series, seed, H, R
    ).measurements


def peer(name, folder):
    """Run in the peers' environment: estimates and covariances to a file, seconds to the output."""
    if name == irregular.NAME:
        print(json.dumps(irregular.peer(folder, seconds)))
        return
    data = np.load(folder / "data.npz")
    Phi, H, Q, R = system()
    if name == "filterpy":
        from filterpy.kalman import KalmanFilter

        z, missing = data["one"], data["missing"]

        def run(gaps, keep=False):
            f = KalmanFilter(dim_x=4, dim_z=2)
            f.F, f.H, f.Q, f.R, f.P, f.x = Phi, H, Q, R, np.eye(4), np.zeros((4, 1))
            states, covariances = np.empty((len(z), 4)), np.empty((len(z), 4, 4))
            for k, row in enumerate(z):
                f.update(None if gaps and missing[k] else row[:, None])
                states[k], covariances[k] = f.x[:, 0], f.P
                f.predict()
            return states, covariances

        taken = {"whole": seconds(lambda: run(False), 2), "gaps": seconds(lambda: run(True), 2)}
        states, covariances = run(False)
        with_gaps, _ = run(True)
        np.savez(folder / "filterpy.npz", states=states, covariances=covariances, gaps=with_gaps)
    else:
        import simdkalman

        model = simdkalman.KalmanFilter(
            state_transition=Phi, process_noise=Q, observation_model=H, observation_noise=R
        )

        def run():
            return model.compute(
                data["many"],
                0,
                initial_value=np.zeros(4),
                initial_covariance=np.eye(4),
                filtered=True,
                smoothed=False,
                observations=False,
            ).filtered.states

        run()
        taken = {"many": seconds(run, RUNS)}
        states = run()
        np.savez(folder / "simdkalman.npz", states=states.mean, covariances=states.cov[:, -1])
    print(json.dumps(taken))


def environment(folder):
    """The interpreter of the peers' environment, made if it is not there or was made with other
    packages."""
    python, noted = folder / "bin" / "python", folder / "packages.json"
    if not noted.exists() or json.loads(noted.read_text()) != PACKAGES:
        print(f"making {folder} with {', '.join(PACKAGES)} ...", flush=True)
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", *PACKAGES], check=True)
        noted.write_text(json.dumps(PACKAGES))
    return python


def asked(python, name, folder):
    done = subprocess.run(
        [python, __file__, "--peer", name, "--folder", folder],
        check=True,
        capture_output=True,
        text=True,
    )
    return json.loads(done.stdout.strip().splitlines()[-1])


def compare(python, folder):
    from trajlib.estimation import KalmanFilter, Moments

    one, many = measurements(STEPS, 1, 1)[0], measurements(LENGTH, SERIES, 2)
    missing = np.random.default_rng(3).random(STEPS) < 0.1
    np.savez(folder / "data.npz", one=one, many=many, missing=missing)
    model, start = KalmanFilter(*system()), Moments(np.zeros(4), np.eye(4))
    theirs = asked(python, "filterpy", folder) | asked(python, "simdkalman", folder)
    known = {name: np.load(folder / f"{name}.npz") for name in PEERS}

    run = model.run(one, start)
    told(
        "one series",
        seconds(lambda: model.run(one, start), 5),
        theirs["whole"],
        STEPS,
        "filterpy",
        {
            "estimates": (run.estimates, known["filterpy"]["states"]),
            "covariances": (run.covariances, known["filterpy"]["covariances"]),
        },
    )
    gaps = model.run(one, start, missing)
    told(
        "a tenth missing",
        seconds(lambda: model.run(one, start, missing), 2),
        theirs["gaps"],
        STEPS,
        "filterpy",
        {"estimates": (gaps.estimates, known["filterpy"]["gaps"])},
    )
    both = model.run(many, start)
    told(
        "1,000 series",
        seconds(lambda: model.run(many, start), RUNS),
        theirs["many"],
        SERIES * LENGTH,
        "simdkalman",
        {
            "estimates": (both.estimates, known["simdkalman"]["states"]),
            "last covariances": (
                both._steps[1][both.matrix_index[:, -1]],
                known["simdkalman"]["covariances"],
            ),
        },
    )
    stacks = [np.broadcast_to(matrix, (STEPS, *matrix.shape)) for matrix in system()]
    varying = KalmanFilter(*stacks)
    told(
        "matrices of each step",
        seconds(lambda: varying.run(one, start), 2),
        theirs["whole"],
        STEPS,
        "filterpy",
        {"estimates": (varying.run(one, start).estimates, known["filterpy"]["states"])},
    )


def told(title, own, other, steps, name, pairs):
    apart = ", ".join(
        f"{what} differ by {np.abs(mine - theirs).max() / np.abs(theirs).max():.1e}"
        for what, (mine, theirs) in pairs.items()
    )
    print(
        f"{title:22} {own / steps * 1e6:8.3f} us a step, {name} {other / steps * 1e6:8.3f}: "
        f"{other / own:7.1f} times; {apart}",
        flush=True,
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--environment", type=Path, default=HERE.parent / "_build" / "filter-peers")
    parser.add_argument("--part", choices=["all", "gaps", "irregular"], default="all")
    parser.add_argument("--peer")
    parser.add_argument("--folder", type=Path)
    arguments = parser.parse_args()
    if arguments.peer:
        peer(arguments.peer, arguments.folder)
        sys.exit()
    if arguments.part != "irregular":
        estimation_gaps.side_by_side(seconds)
    if arguments.part != "gaps":
        with tempfile.TemporaryDirectory() as folder:
            folder, python = Path(folder), environment(arguments.environment)
            if arguments.part == "all":
                compare(python, folder)
            irregular.side_by_side(folder, lambda name: asked(python, name, folder), seconds)
