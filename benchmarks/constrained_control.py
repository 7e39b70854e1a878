"""Constrained problems of the literature by `Problem.solve()` against a direct method in CasADi.

The peer is trapezoidal collocation with IPOPT, written here in plain CasADi. It gets the duration of
the solution and straight lines as a guess; trajlib gets the statement alone. Both are solved twice in
one process, and the processor time of the second
solution counts, that from the bare statement. Printed are the errors of the cost,
from the second route of each record, and the ratio of the times.

`--masses` times n masses with n controls instead, n = 1 .. 8: rest to rest with the least energy and
bounds of the controls, and the exponent with which the time grows.
"""

import argparse
import sys
import time
from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import sympy as sp

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "library"))
from optimal_control_records import CONSTRAINED, INTEGRATED, record

from trajlib.pontryagin import Problem

INTERVALS = 200


def collocation(problem, duration):
    """Return the cost of a trapezoidal collocation on INTERVALS intervals; nan if IPOPT fails."""
    symbols = (*problem.state, *problem.control)

    def function(e):
        return sp.lambdify(symbols, e, modules=[ca, {"Abs": ca.fabs}])

    opti, n, N = ca.Opti(), len(problem.state), INTERVALS
    x, u = opti.variable(n, N + 1), opti.variable(len(problem.control), N + 1)
    T = opti.variable() if problem.free_time else duration
    start = [float(v) for v in problem.initial.values()]
    columns = [(*ca.vertsplit(x[:, i]), *ca.vertsplit(u[:, i])) for i in range(N + 1)]
    fields, density = [function(f) for f in problem.field], function(problem.running)
    rates = [ca.vertcat(*(f(*column) for f in fields)) for column in columns]
    costs = [density(*column) for column in columns]
    opti.subject_to(x[:, 0] == start)
    for i in range(N):
        opti.subject_to(x[:, i + 1] == x[:, i] + T / N * (rates[i] + rates[i + 1]) / 2)
    path = [function(g) for g in problem.constraints]
    for j, (low, high) in enumerate(problem.controls.values()):
        path += [function(low - problem.control[j])] if low != -sp.oo else []
        path += [function(problem.control[j] - high)] if high != sp.oo else []
    for g in path:
        for column in columns:
            opti.subject_to(g(*column) <= 0)
    for g in problem.terminal:
        opti.subject_to(function(g)(*columns[-1]) == 0)
    for g in problem.end_constraints:
        opti.subject_to(function(g)(*columns[-1]) <= 0)
    if problem.free_time:
        opti.subject_to(T >= 1e-3)
        opti.set_initial(T, duration)
    cost = function(problem.final)(*columns[-1])
    cost += T / N * (sum(costs) - (costs[0] + costs[-1]) / 2)
    opti.minimize(-cost if problem.maximise else cost)
    ends = {y: y - g for y in problem.state for g in problem.terminal if not (y - g).has(y)}
    for i, y in enumerate(problem.state):
        end = float(ends[y]) if y in ends and ends[y].is_number else start[i]
        opti.set_initial(x[i, :], np.linspace(start[i], end, N + 1))
    opti.set_initial(u, 0.1)
    opti.solver(
        "ipopt",
        {"print_time": False},
        {"print_level": 0, "sb": "yes", "max_iter": 2000, "max_cpu_time": 20},
    )
    try:
        return float(opti.solve().value(cost))
    except RuntimeError:
        return np.nan


def seconds(solve):
    """Return the result of a second call and its processor time."""
    solve()
    start = time.process_time()
    result = solve()
    return result, time.process_time() - start


def compare(names):
    print(f"{'problem':42s}{'error':>9s}{'peer':>9s}{'seconds':>9s}{'peer':>9s}")
    for name in names:
        reference = record(name)
        extremal, own = seconds(lambda r=reference: replace(r.problem).solve())
        cost, peer = seconds(lambda r=reference, T=extremal.duration: collocation(r.problem, T))
        size = 1 + abs(float(reference.cost))
        errors = [abs(value - float(reference.cost)) / size for value in (extremal.cost, cost)]
        print(f"{name:42s}{errors[0]:9.0e}{errors[1]:9.0e}{own:9.2f}{peer:9.2f}", flush=True)


def masses(n):
    """Return n masses with a control each, from rest to rest, with bounds of the controls."""
    x, v, u = (sp.symbols(f"{letter}1:{n + 1}", seq=True) for letter in "xvu")
    return Problem(
        {**dict(zip(x, v)), **dict(zip(v, u))},
        dict.fromkeys(u, (-5, 5)),
        dict.fromkeys((*x, *v), 0),
        {**{x[i]: sp.Rational(n + i, 2 * n) for i in range(n)}, **dict.fromkeys(v, 0)},
        running=sum(a**2 for a in u),
        duration=1,
    )


def grow():
    times = []
    for n in range(1, 9):
        extremal, own = seconds(lambda n=n: masses(n).solve())
        times.append(own)
        exact = sum(reference_energy((n + i) / (2 * n)) for i in range(n))
        print(f"n = {n}: {own:6.2f} s, error {abs(extremal.cost - exact) / exact:.0e}", flush=True)
    exponent = np.polyfit(np.log(range(4, 9)), np.log(times[3:]), 1)[0]
    print(f"grows with n to the power {exponent:.1f} from n = 4 on")


def reference_energy(distance):
    """Return the least int u^2 over the distance, rest to rest in the time 1, |u| <= 5.

    Unbounded u = 6 d (1 - 2 t) has its largest value 6 d; beyond 5 it is cut off: u = 5 up to
    1/2 - c, then linear, with 1/4 - c^2/3 = d/5.
    """
    if 6 * distance <= 5:
        return 12 * distance**2
    c = np.sqrt(3 * (0.25 - distance / 5))
    return 25 * (1 - 2 * c + 2 * c / 3)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--masses", action="store_true")
    parser.add_argument("names", nargs="*", default=[*INTEGRATED, *CONSTRAINED])
    arguments = parser.parse_args()
    grow() if arguments.masses else compare(arguments.names)
