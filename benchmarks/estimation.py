"""The Kalman filter of `trajlib.estimation` against statsmodels, filterpy, simdkalman and cd-dynamax:
numbers first, then seconds.

One series: 100,000 steps of 4 states and 2 outputs, time-invariant, against the compiled filter of
statsmodels and filterpy's predict and update, a call each a step. Many series: 1,000 of 1,000 steps
at once, against simdkalman. Further, what they have no shortcut for: a tenth of the measurements
missing at random, and matrices of each step's own. Five cases of filter and smoother for 2 to 32
states against statsmodels and against loops in plain NumPy (estimation_gaps.py); `--part gaps` runs
the loops alone, also at irregular times, and needs no peer. Last, measurements at irregular moments
side by side with cd-dynamax, in estimation_irregular.py; `--part irregular` runs this alone. The
peers live in an environment of their own, made on the first run in _build/filter-peers or where
`--environment` says; one that cannot be installed is named and left out. Numbers are handed over in
files. The clock is the processor's, inside the process that computes, the least of several runs.
One thread for linear algebra: more only get in one another's way on matrices of this size.

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
PACKAGES = {
    "filterpy": "filterpy",
    "simdkalman": "simdkalman",
    "statsmodels": "statsmodels",
    irregular.NAME: "cd-dynamax==0.5.0",
}
#: What the interpreter of the peers is asked for the five cases of statsmodels.
CASES = "statsmodels-cases"
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
    if name == CASES:
        print(json.dumps(estimation_gaps.of_statsmodels(folder, seconds)))
        return
    data = np.load(folder / "data.npz")
    run = {"filterpy": filterpy, "simdkalman": simdkalman, "statsmodels": statsmodels}[name]
    taken, results = run(data)
    np.savez(folder / f"{name}.npz", **results)
    print(json.dumps(taken))


def filterpy(data):
    from filterpy.kalman import KalmanFilter

    Phi, H, Q, R = system()
    z, missing = data["one"], data["missing"]

    def run(gaps):
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
    return taken, {"states": states, "covariances": covariances, "gaps": run(True)[0]}


def statsmodels(data):
    from statsmodels.tsa.statespace.kalman_filter import KalmanFilter

    Phi, H, Q, R = system()
    z = data["one"]
    with_gaps = np.where(data["missing"][:, None], np.nan, z)

    def run(z):
        f = KalmanFilter(
            2, 4, design=H, obs_cov=R, transition=Phi, selection=np.eye(4), state_cov=Q
        )
        f.bind(z.copy())
        f.initialize_known(np.zeros(4), np.eye(4))
        return f.filter()

    taken = {"whole": seconds(lambda: run(z), RUNS), "gaps": seconds(lambda: run(with_gaps), RUNS)}
    result = run(z)
    return taken, {
        "states": result.filtered_state.T,
        "covariances": result.filtered_state_cov.transpose(2, 0, 1),
        "gaps": run(with_gaps).filtered_state.T,
    }


def simdkalman(data):
    import simdkalman as package

    Phi, H, Q, R = system()
    model = package.KalmanFilter(
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
    taken, states = {"many": seconds(run, RUNS)}, run()
    return taken, {"states": states.mean, "covariances": states.cov[:, -1]}


def environment(folder):
    """Return the interpreter of the peers' environment and the peers that it has.

    It is made if it is not there or was made for other packages.
    """
    python, noted = folder / "bin" / "python", folder / "packages.json"
    made = json.loads(noted.read_text()) if noted.exists() else {}
    if made.get("packages") != PACKAGES:
        print(f"making {folder} with {', '.join(PACKAGES)} ...", flush=True)
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        install = [python, "-m", "pip", "install", "--quiet"]
        peers = [
            name
            for name, package in PACKAGES.items()
            if subprocess.run([*install, package], stderr=subprocess.DEVNULL).returncode == 0
        ]
        made = {"packages": PACKAGES, "peers": peers}
        noted.write_text(json.dumps(made))
    for name in PACKAGES.keys() - set(made["peers"]):
        print(f"{name} could not be installed; its lines are left out")
    return python, made["peers"]


def asked(python, name, folder):
    done = subprocess.run(
        [python, __file__, "--peer", name, "--folder", folder],
        check=True,
        capture_output=True,
        text=True,
    )
    return json.loads(done.stdout.strip().splitlines()[-1])


def compare(python, peers, folder):
    from trajlib.estimation import KalmanFilter, Moments

    one, many = measurements(STEPS, 1, 1)[0], measurements(LENGTH, SERIES, 2)
    missing = np.random.default_rng(3).random(STEPS) < 0.1
    np.savez(folder / "data.npz", one=one, many=many, missing=missing)
    model, start = KalmanFilter(*system()), Moments(np.zeros(4), np.eye(4))
    peers = [name for name in peers if name != irregular.NAME]
    theirs = {name: asked(python, name, folder) for name in peers}
    results = {name: np.load(folder / f"{name}.npz") for name in peers}
    run, gaps = model.run(one, start), model.run(one, start, missing)
    stacks = [np.broadcast_to(matrix, (STEPS, *matrix.shape)) for matrix in system()]
    varying = KalmanFilter(*stacks)
    own = {
        "whole": seconds(lambda: model.run(one, start), 5),
        "gaps": seconds(lambda: model.run(one, start, missing), 2),
    }
    for name in [name for name in ("statsmodels", "filterpy") if name in peers]:
        result = results[name]
        whole = {
            "estimates": (run.estimates, result["states"]),
            "covariances": (run.covariances, result["covariances"]),
        }
        print_comparison("one series", own["whole"], theirs[name]["whole"], STEPS, name, whole)
        pairs = {"estimates": (gaps.estimates, result["gaps"])}
        print_comparison("a tenth missing", own["gaps"], theirs[name]["gaps"], STEPS, name, pairs)
    if "simdkalman" in peers:
        both, result = model.run(many, start), results["simdkalman"]
        print_comparison(
            "1,000 series",
            seconds(lambda: model.run(many, start), RUNS),
            theirs["simdkalman"]["many"],
            SERIES * LENGTH,
            "simdkalman",
            {
                "estimates": (both.estimates, result["states"]),
                "last covariances": (
                    both._steps[1][both.matrix_index[:, -1]],
                    result["covariances"],
                ),
            },
        )
    if "filterpy" in peers:
        print_comparison(
            "matrices of each step",
            seconds(lambda: varying.run(one, start), 2),
            theirs["filterpy"]["whole"],
            STEPS,
            "filterpy",
            {"estimates": (varying.run(one, start).estimates, results["filterpy"]["states"])},
        )


def print_comparison(title, own, other, steps, name, pairs):
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
        python, peers = environment(arguments.environment)
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            if arguments.part == "all":
                compare(python, peers, folder)
                if "statsmodels" in peers:
                    taken = asked(python, CASES, folder)
                    estimation_gaps.beside_statsmodels(folder, taken, seconds)
            if irregular.NAME in peers:
                irregular.side_by_side(folder, lambda name: asked(python, name, folder), seconds)
