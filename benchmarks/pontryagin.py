"""Extremals by `Problem.solve()` against YAPSS, rockit, dymos and plain CasADi: error of the cost
and of the switching times against the time from the bare statement to the result, each solved in a
fresh process, packages imported before the clock starts; and the processor time of a second solution
in the same process, which depends little on what else the machine does.

The peers live in an environment of their own, which is made on the first run (`python -m venv`,
then pip) in _build/peers or where `--environment` says. Peers get a guess of the time and straight
lines as states; trajlib gets the statement alone. Their switching times are read off their controls
with the right structure given, so that no peer suffers from a bad reading.
"""

import argparse
import itertools
import json
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
from pontryagin_peers import CASES, GUESSES, PEERS

RUNS = 4
LIMIT = 300  # seconds for one peer on one problem
PACKAGES = ["yapss", "rockit-meco", "dymos", "casadi"]
HERE = Path(__file__).resolve().parent


def environment(folder):
    """The interpreter of the peers' environment, made if it is not there."""
    python = folder / "bin" / "python"
    if not python.exists():
        print(f"making {folder} with {', '.join(PACKAGES)} ...", flush=True)
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", *PACKAGES], check=True)
    return python


def ours(name):
    """What a fresh process prints for trajlib: cost, switching times, seconds, residuals."""
    # The peers' packages are imported before the clock starts, so ours are too; trajlib's own
    # modules load inside.
    import casadi  # noqa: F401
    import numpy  # noqa: F401
    import sympy as sp

    from trajlib.pontryagin import Problem

    case = CASES[name]
    start = time.perf_counter()
    x, u = sp.symbols(f"x1:{len(case.start) + 1}"), sp.Symbol("u")
    extremal = Problem(
        dict(zip(x, case.field(x, u))),
        {u: (-1, 1)},
        dict(zip(x, case.start)),
        {x[i]: end for i, end in case.fixed},
        running=case.density(x, u),
        duration=case.duration,
    ).solve()
    seconds = time.perf_counter() - start
    again = time.process_time()
    replace(extremal.problem).solve()
    print(
        json.dumps(
            {
                "cost": extremal.cost,
                "switchings": extremal.switching_times,
                "seconds": seconds,
                "again": time.process_time() - again,
                "worst": extremal.certificate().worst,
            }
        )
    )


def run(command):
    """The last line that a process prints, as JSON; a word saying why if there is none."""
    try:
        # One thread for linear algebra: more only get in one another's way on problems of this
        # size. A folder of its own, since OpenMDAO leaves its output where it runs.
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                command,
                capture_output=True,
                text=True,
                timeout=LIMIT,
                cwd=folder,
                env=os.environ | {"OPENBLAS_NUM_THREADS": "1"},
            )
    except subprocess.TimeoutExpired:
        return f"more than {LIMIT} s"
    try:
        return json.loads(done.stdout.strip().splitlines()[-1])
    except (IndexError, ValueError):
        return "fails"


def switchings(case, times, controls):
    """Switching times of a peer's control: from the mean between the middles of the true arcs, or
    from the line that meets a bound."""
    times, controls = np.array(times), np.array(controls)
    if "line" in case.levels:
        middles = (times[1:] + times[:-1]) / 2 if len(times) > len(controls) else times
        found = []
        for bound, half in ((-1.0, middles <= times[-1] / 2), (1.0, middles > times[-1] / 2)):
            inside = half & (np.abs(controls) < 0.97)
            slope, offset = np.polyfit(middles[inside], controls[inside], 1)
            found.append((bound - offset) / slope)
        return found
    ends = [0.0, *case.switchings, case.cost if case.duration is None else case.duration]
    cuts = [0.0, *((ends[i] + ends[i + 1]) / 2 for i in range(1, len(ends) - 2)), times[-1]]
    found = []
    for (low, high), (a, b) in zip(itertools.pairwise(cuts), zip(case.levels, case.levels[1:])):
        grid = np.linspace(low, high, 200_001)
        grid = (grid[1:] + grid[:-1]) / 2
        if len(times) > len(controls):
            u = controls[
                np.clip(np.searchsorted(times, grid, side="right") - 1, 0, len(controls) - 1)
            ]
        else:
            u = np.interp(grid, times, controls)
        found.append(low + float(np.mean((b - u) / (b - a))) * (high - low))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--environment",
        type=Path,
        default=HERE.parent / "_build" / "peers",
        help="where the peers live",
    )
    parser.add_argument(
        "--problem", choices=list(CASES), action="append", help="only this one (may be repeated)"
    )
    parser.add_argument("--peer", choices=list(PEERS), action="append", help="only this one")
    parser.add_argument("--ours", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.ours:
        return ours(arguments.ours)
    python = environment(arguments.environment.resolve())
    for name in arguments.problem or CASES:
        case = CASES[name]
        print(
            f"\n{name}: J = {case.cost:.12f}, switchings "
            f"{', '.join(f'{t:.10f}' for t in case.switchings) or 'not compared'}"
        )
        titles = ("error of J", "of switchings", "seconds", "again")
        print(f"{'':38} {titles[0]:>11} {titles[1]:>14} {titles[2]:>9} {titles[3]:>9}", flush=True)
        best = measured(python, name, case, arguments.peer or list(PEERS))
        mine = best.pop("trajlib")
        line(
            "trajlib",
            case,
            mine,
            mine["switchings"],
            f"worst residual of the certificate {mine['worst']:.1e}",
        )
        for peer, result in best.items():
            if isinstance(result, str):
                print(f"{peer:38} {result:>11}")
                continue
            line(
                peer,
                case,
                result,
                switchings(case, result["times"], result["controls"]),
                f"with the guess {result['guess']:g} of the time"
                if result["guess"] != guesses(case)[0]
                else "",
            )
            ratios = (mine[clock] / result[clock] for clock in ("seconds", "again"))
            print("{:38} trajlib takes {:.2f} times as long, again {:.2f}".format("", *ratios))
        print(f"load of the machine: {os.getloadavg()[0]:.1f}", flush=True)


def guesses(case):
    """A user's guesses of the time for the peers, in turn."""
    return (case.guess,) if case.guess else GUESSES[:1] if case.duration else GUESSES


def measured(python, name, case, peers):
    """{solver: its result with its shortest times, or a word saying why there is none}; the solvers
    take turns, since other work slows all of them."""
    best, guess = {}, {}
    for turn in range(RUNS):
        results = {"trajlib": run([sys.executable, HERE / "pontryagin.py", "--ours", name])}
        for peer in peers:
            if isinstance(best.get(peer), str) or (turn and "dymos" in peer):
                continue
            for first in [guess[peer]] if peer in guess else guesses(case):
                guess[peer] = first
                results[peer] = run(
                    [python, HERE / "pontryagin_peers.py", peer, name, str(guess[peer])]
                )
                if results[peer] != "fails":
                    break
            if not isinstance(results[peer], str):
                results[peer]["guess"] = guess[peer]
        for solver, result in results.items():
            if solver in best and not isinstance(result, str):
                for clock in ("seconds", "again"):
                    result[clock] = min(result[clock], best[solver][clock])
            if solver not in best or not isinstance(result, str):
                best[solver] = result
    return best


def line(solver, case, result, times, remark):
    error = max((abs(a - b) for a, b in zip(times, case.switchings)), default=float("nan"))
    remark = f"   ({remark})" if remark else ""
    print(
        f"{solver:38} {abs(result['cost'] - case.cost):11.1e} {error:14.1e} "
        f"{result['seconds']:9.3f} {result['again']:9.3f}{remark}",
        flush=True,
    )


if __name__ == "__main__":
    main()
