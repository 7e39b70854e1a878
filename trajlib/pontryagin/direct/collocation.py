"""The nonlinear programme of a problem on any grid, by three schemes.

On the interval [t_k, t_k+1] of the length h, with f_k = f(x_k, u_k), the equations are

- "runge-kutta": x_k+1 = one classical Runge-Kutta step with a constant control (order 4),
- "trapezoidal": x_k+1 = x_k + h/2 (f_k + f_k+1), the control being linear (order 2),
- "hermite-simpson": x_k+1 = x_k + h/6 (f_k + 4 f_m + f_k+1), f_m = f(x_m, u_m) in the middle of the
  cubic through both ends, x_m = (x_k + x_k+1)/2 + h/8 (f_k - f_k+1), the control being quadratic
  (order 4),

and the cost is integrated by the same formulas (Betts, Practical Methods for Optimal Control, 2010,
chapter 4). The multiplier of an equation is -psi: at t_k+1 for Runge-Kutta steps, in the middle of
the interval for the others.
"""

from dataclasses import dataclass

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.direct.ipopt import Ipopt
from trajlib.pontryagin.direct.transcription import path_rows
from trajlib.pontryagin.problem.errors import NotConverged
from trajlib.pontryagin.problem.numeric import NumericProblem, runge_kutta

SCHEMES = ("runge-kutta", "trapezoidal", "hermite-simpson")


def control_points(scheme: str, fractions: np.ndarray) -> np.ndarray:
    """Return where the controls of a scheme stand, as fractions of the duration."""
    middles = (fractions[1:] + fractions[:-1]) / 2
    if scheme == "runge-kutta":
        return middles
    if scheme == "trapezoidal":
        return fractions
    return np.sort(np.concatenate([fractions, middles]))


@dataclass(frozen=True)
class Discretised:
    """The solution of a nonlinear programme in the units of its numeric problem.

    `times`: (N+1,); `states`, `costates`: (N+1, n); `controls`: (M, k) at the control points;
    `path_multipliers`: (N+1, c), densities in time; `terminal_multipliers`: of the equations, then of
    the inequalities; `nlp`: {"x", "f", "g"} in CasADi symbols.
    """

    times: np.ndarray
    states: np.ndarray
    costates: np.ndarray
    controls: np.ndarray
    path_multipliers: np.ndarray
    terminal_multipliers: np.ndarray
    cost: float
    iterations: int
    nlp: dict


def solve_programme(
    numeric: NumericProblem,
    fractions: np.ndarray,
    scheme: str,
    tolerance: float,
    start: tuple,
    side: int | None = None,
) -> Discretised:
    """Solve the programme with IPOPT.

    `start`: (duration, states at the nodes, controls at the control points). `side`: of the target,
    on which the states stay before the end. Raises `NotConverged` if IPOPT fails.
    """
    n, k, N = numeric.n, numeric.k, len(fractions) - 1
    count = len(control_points(scheme, fractions))
    X, U, T = ca.MX.sym("X", n, N + 1), ca.MX.sym("U", k, count), ca.MX.sym("T")
    ends, pieces = _steps(numeric, scheme, X, U, T * ca.DM(np.diff(fractions)).T)
    final = ca.Function("final", [numeric.x], [numeric.final, numeric.target, numeric.end_path])
    end_cost, target, end_path = final(X[:, -1])
    fixed = np.flatnonzero(~np.isnan(numeric.start)).tolist()
    low, high = (
        (numeric.shortest, numeric.longest) if numeric.duration is None else (numeric.duration,) * 2
    )
    rows = path_rows(numeric, N)
    path = ca.Function("path", [numeric.x], [numeric.path]).map(N + 1)(X)
    parts = {
        "defects": (ca.vec(ends - X[:, 1:]), 0.0, 0.0),
        "start": (X[fixed, 0] - ca.DM(numeric.start[fixed]), 0.0, 0.0),
        "target": (target, 0.0, 0.0),
        "end": (end_path, -np.inf, 0.0),
        "path": (ca.vec(path)[rows.tolist()], -np.inf, 0.0),
    }
    if side is not None:
        targets = ca.Function("target", [numeric.x], [numeric.target]).map(N - 1)(X[:, 1:-1])
        parts["side"] = (ca.vec(side * targets), 0.0, np.inf)
    sizes = {name: e.numel() for name, (e, _, _) in parts.items()}
    nlp = {
        "x": ca.veccat(X, U, T),
        "f": ca.sum2(pieces) + end_cost,
        "g": ca.vertcat(*(e for e, _, _ in parts.values())),
    }
    solver = Ipopt("collocation", nlp, tolerance, 1000)
    free = np.full(X.numel(), np.inf)
    lower = np.concatenate([-free, np.tile(numeric.lower, count), [low]])
    upper = np.concatenate([free, np.tile(numeric.upper, count), [high]])
    duration, states, controls = start
    guess = np.concatenate([np.ravel(states), np.ravel(controls), [duration]])
    result = solver(
        x0=np.clip(guess, lower, upper),
        lbx=lower,
        ubx=upper,
        lbg=np.concatenate([np.full(sizes[name], a) for name, (_, a, _) in parts.items()]),
        ubg=np.concatenate([np.full(sizes[name], b) for name, (_, _, b) in parts.items()]),
    )
    if not solver.solved:
        raise NotConverged(
            f"IPOPT found no solution on {N} intervals by the scheme {scheme} "
            f"({solver.status} after {solver.iterations} iterations). Nothing is proved by "
            "that: give a guess, or another grid or scheme."
        )
    z, dual = (result[name].full().ravel() for name in ("x", "lam_g"))
    cuts = np.cumsum(list(sizes.values()))[:-1]
    multipliers = dict(zip(parts, np.split(dual, cuts)))
    states = z[: X.numel()].reshape(N + 1, n)
    times = fractions * z[-1]
    densities = np.zeros((N + 1) * len(numeric.path_orders))
    densities[rows] = multipliers["path"]
    controls, angles = z[X.numel() : -1].reshape(count, k), numeric.angles
    # IPOPT may add whole turns to an angle, across which nothing could be interpolated.
    controls[:, angles] = np.unwrap(controls[:, angles], axis=0)
    widths = np.diff(times)
    weights = (np.append(widths, 0) + np.insert(widths, 0, 0)) / 2
    terminal = np.concatenate([multipliers["target"], multipliers["end"]])
    return Discretised(
        times,
        states,
        _costates(numeric, scheme, states, widths, fixed, multipliers),
        controls,
        densities.reshape(N + 1, -1) / weights[:, None],
        terminal,
        float(result["f"]),
        solver.iterations,
        nlp,
    )


def _steps(numeric, scheme, X, U, h):
    """Return the states at the ends of the steps, (n, N), and the pieces of the cost, (1, N)."""
    N = X.shape[1] - 1
    if scheme == "runge-kutta":
        return runge_kutta(numeric).map(N)(X[:, :-1], U, h)
    rate = ca.Function("rate", [numeric.x, numeric.u], [numeric.field, numeric.density])
    every = 1 if scheme == "trapezoidal" else 2
    f, cost = rate.map(N + 1)(X, U[:, ::every])
    width = ca.repmat(h, numeric.n, 1)
    if scheme == "trapezoidal":
        return (
            X[:, :-1] + width / 2 * (f[:, :-1] + f[:, 1:]),
            h / 2 * (cost[:, :-1] + cost[:, 1:]),
        )
    middle = (X[:, :-1] + X[:, 1:]) / 2 + width / 8 * (f[:, :-1] - f[:, 1:])
    f_middle, cost_middle = rate.map(N)(middle, U[:, 1::2])
    return (
        X[:, :-1] + width / 6 * (f[:, :-1] + 4 * f_middle + f[:, 1:]),
        h / 6 * (cost[:, :-1] + 4 * cost_middle + cost[:, 1:]),
    )


def _costates(numeric, scheme, states, widths, fixed, multipliers):
    """Return the costates at the nodes, estimated from the multipliers of the equations."""
    inner = -multipliers["defects"].reshape(len(widths), numeric.n)
    first = np.zeros(numeric.n)
    first[fixed] = multipliers["start"]
    if scheme == "runge-kutta":
        return np.vstack([first, inner])
    # Between the middles of two intervals; at the end by transversality.
    share = (widths[:-1] / (widths[:-1] + widths[1:]))[:, None]
    between = inner[:-1] * (1 - share) + inner[1:] * share
    slopes = ca.Function(
        "slopes",
        [numeric.x],
        [
            ca.jacobian(e, numeric.x)
            for e in (numeric.final, numeric.target, numeric.end_path, numeric.path)
        ],
    )(states[-1])
    final, *normals = (slope.full() for slope in slopes)
    last = -final.ravel()
    for name, normal in zip(("target", "end"), normals):
        last -= normal.T @ multipliers[name]
    return np.vstack([first, between, last])
