"""Direct transcription with piecewise-constant controls, solved by IPOPT.

The controls are constant on N equal intervals, as bang arcs are; polynomial controls would pass
their bounds between the nodes. The states at the nodes are joined by Runge-Kutta steps; the
multipliers of these continuity equations are the costates.
"""

from dataclasses import dataclass, replace

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.direct.ipopt import Ipopt
from trajlib.pontryagin.problem.numeric import NumericProblem, runge_kutta

# Intervals of a discrete solution.
INTERVALS = 80
# Largest violation of its equations by a last iterate that is a guess for Newton's method.
NEARLY = 1e-3
# Iterations of IPOPT where many starts are tried, at most.
PATIENCE = 100


@dataclass(frozen=True)
class DirectSolution:
    """A discrete extremal with lambda_0 = 1 from direct transcription.

    Attributes
    ----------
    times : ndarray, shape (N+1,)
        Ends of the intervals.
    states, costates : ndarray, shape (N+1, n)
        At these times.
    controls : ndarray, shape (N, k)
        On the intervals.
    cost : float
        With the sign of a minimum.
    lengths : ndarray or None
        Of the arcs, where their structure was given.
    path_multipliers : ndarray or None, shape (N+1, c)
        Of the path constraints at these times, zero where they are not imposed.
    end_multipliers : ndarray or None
        Of the terminal inequalities.
    """

    times: np.ndarray
    states: np.ndarray
    costates: np.ndarray
    controls: np.ndarray
    cost: float
    lengths: np.ndarray | None = None
    path_multipliers: np.ndarray | None = None
    end_multipliers: np.ndarray | None = None

    @property
    def duration(self) -> float:
        """The final time."""
        return self.times[-1]


@dataclass(frozen=True)
class Failure:
    """A failure of IPOPT: its status, with cost, duration and size of the last iterate.

    `last`: this iterate, where it nearly satisfies the equations when the iterations end.
    """

    status: str
    cost: float
    duration: float
    largest_state: float
    last: DirectSolution | None = None


class Transcription:
    """The nonlinear programme of a numeric problem on about N intervals.

    Parameters
    ----------
    numeric : NumericProblem
        The problem.
    intervals : int
        Number of intervals, at least 12 for each arc of a structure.
    structure : list of tuple of str, optional
        Kinds of the arcs; each arc then has its own intervals and length, and its controls are at
        their bounds or free. None: all intervals are equal and all controls free.
    side : int, optional
        Side of the target to stay on before the final time (first return).
    distance_only : bool, optional
        Minimise the distance of the final state from the target instead of the cost.
    patience : int, optional
        Most iterations.
    near : bool, optional
        Whether the guesses will be nearly solutions, from which IPOPT may step without its filter.
    """

    def __init__(
        self,
        numeric,
        intervals,
        structure=None,
        side=None,
        distance_only=False,
        patience=400,
        near=False,
    ):
        self.numeric, self.structure = numeric, structure
        self.arc_count = 1 if structure is None else len(structure)
        self.intervals_per_arc = max(12, intervals // self.arc_count) if structure else intervals
        n, k, self.N = numeric.n, numeric.k, self.arc_count * self.intervals_per_arc
        N = self.N
        X, U, D = ca.MX.sym("X", n, N + 1), ca.MX.sym("U", k, N), ca.MX.sym("D", self.arc_count)
        lengths = ca.horzcat(
            *(
                ca.repmat(D[i] / self.intervals_per_arc, 1, self.intervals_per_arc)
                for i in range(self.arc_count)
            )
        )
        ends, pieces = runge_kutta(numeric).map(N)(X[:, :-1], U, lengths)
        target = ca.Function("target", [numeric.x], [numeric.target])
        final = ca.Function("final", [numeric.x], [numeric.final])
        self.fixed = [i for i in range(n) if not np.isnan(numeric.start[i])]
        low, high = (
            (numeric.shortest, numeric.longest)
            if numeric.duration is None
            else (numeric.duration,) * 2
        )
        # (expression, lower, upper); the first two carry the costates.
        parts = [
            (ca.vec(ends - X[:, 1:]), 0, 0),
            (X[self.fixed, 0] - ca.DM(numeric.start[self.fixed]), 0, 0),
            (ca.sum1(D), low, high),
        ]
        cost = ca.sum2(pieces) + final(X[:, -1])
        if distance_only:
            cost = ca.sumsqr(target(X[:, -1]))
        elif numeric.m:
            parts.append((target(X[:, -1]), 0, 0))
        if side is not None:
            parts.append((ca.vec(side * target.map(N - 1)(X[:, 1:-1])), 0, np.inf))
        self.path_rows = path_rows(numeric, N)
        if len(self.path_rows):
            self.path_offset = sum(e.numel() for e, _, _ in parts)
            path = ca.Function("path", [numeric.x], [numeric.path]).map(N + 1)(X)
            parts.append((ca.vec(path)[self.path_rows.tolist()], -np.inf, 0))
        self.end_offset = sum(e.numel() for e, _, _ in parts)
        end_count = len(numeric.problem.end_constraints)
        if end_count:
            end_path = ca.Function("end", [numeric.x], [numeric.end_path])
            parts.append((end_path(X[:, -1]), -np.inf, 0))
        self.limits = {
            "lbg": np.concatenate([np.full(e.numel(), a) for e, a, _ in parts]),
            "ubg": np.concatenate([np.full(e.numel(), b) for e, _, b in parts]),
        }
        lower, upper = self._control_bounds()
        free = np.full(n * (N + 1), np.inf)
        self.limits["lbx"] = np.concatenate(
            [-free, lower.ravel(), np.full(self.arc_count, 0.0 if structure else low)]
        )
        self.limits["ubx"] = np.concatenate([free, upper.ravel(), np.full(self.arc_count, high)])
        options = {"adaptive_mu_globalization": "kkt-error"} if near else {}
        nlp = {"x": ca.veccat(X, U, D), "f": cost, "g": ca.vertcat(*(e for e, _, _ in parts))}
        self.solver = Ipopt("transcription", nlp, 1e-9, patience, **options)

    def _control_bounds(self):
        lower, upper = (np.tile(b, (self.N, 1)) for b in (self.numeric.lower, self.numeric.upper))
        for index, kinds in enumerate(self.structure or []):
            rows = slice(index * self.intervals_per_arc, (index + 1) * self.intervals_per_arc)
            for j, kind in enumerate(kinds):
                if kind == "u-":
                    upper[rows, j] = lower[rows, j]
                elif kind == "u+":
                    lower[rows, j] = upper[rows, j]
        return lower, upper

    def solve(self, guess, duration: float | None = None) -> DirectSolution | Failure:
        """Return the solution, or a `Failure` if IPOPT does not report one.

        `guess`: (duration, states (M+1, n), controls (M, k)) on M equal intervals. `duration`:
        fixes it at this number instead of that of the problem.
        """
        limits = dict(self.limits)
        if duration is not None:
            row = self.numeric.n * self.N + len(self.fixed)
            limits["lbg"], limits["ubg"] = limits["lbg"].copy(), limits["ubg"].copy()
            limits["lbg"][row] = limits["ubg"][row] = duration
        n, k, N = self.numeric.n, self.numeric.k, self.N
        guessed_duration, states, controls = guess
        grid = np.linspace(0, 1, N + 1)
        states = np.stack(
            [
                np.interp(grid, np.linspace(0, 1, len(states)), column)
                for column in np.transpose(states)
            ],
            axis=1,
        )
        middles = (grid[:-1] + grid[1:]) / 2
        controls = controls[np.minimum((middles * len(controls)).astype(int), len(controls) - 1)]
        start = np.concatenate(
            [
                states.ravel(),
                controls.ravel(),
                np.full(self.arc_count, guessed_duration / self.arc_count),
            ]
        )
        result = self.solver(x0=np.clip(start, limits["lbx"], limits["ubx"]), **limits)
        z, dual = (result[name].full().ravel() for name in ("x", "lam_g"))
        states, lengths = z[: n * (N + 1)].reshape(N + 1, n), z[n * (N + 1) + k * N :]
        status, solved = self.solver.status, self.solver.solved
        values = result["g"].full().ravel()
        violation = np.maximum(limits["lbg"] - values, values - limits["ubg"])
        nearly = status == "Maximum_Iterations_Exceeded" and np.max(violation) < NEARLY
        failure = Failure(
            status, float(result["f"]), float(lengths.sum()), float(np.max(np.abs(states)))
        )
        if not solved and not nearly:
            return failure
        constraint_count = len(self.numeric.path_orders)
        costates = np.empty((N + 1, n))
        # The multiplier of F(x_k) - x_{k+1} = 0 is the derivative of the cost with respect to
        # x_{k+1}: -psi.
        costates[1:] = -dual[: n * N].reshape(N, n)
        costates[0] = 0
        costates[0, self.fixed] = dual[n * N : n * N + len(self.fixed)]
        times = np.concatenate(
            [[0.0], np.cumsum(np.repeat(lengths / self.intervals_per_arc, self.intervals_per_arc))]
        )
        controls, angles = z[n * (N + 1) : n * (N + 1) + k * N].reshape(N, k), self.numeric.angles
        # IPOPT may add whole turns to an angle.
        controls[:, angles] = np.unwrap(
            np.mod(controls[:, angles] + np.pi, 2 * np.pi) - np.pi, axis=0
        )
        path_multipliers = np.zeros((N + 1) * constraint_count)
        if constraint_count:
            path_multipliers[self.path_rows] = dual[self.path_offset :][: len(self.path_rows)]
        solution = DirectSolution(
            times,
            states,
            costates,
            controls,
            float(result["f"]),
            lengths,
            path_multipliers.reshape(N + 1, constraint_count),
            dual[self.end_offset :],
        )
        return solution if solved else replace(failure, last=solution)


def path_rows(numeric: NumericProblem, intervals: int) -> np.ndarray:
    """Return where path constraints are imposed: indices into their values at all nodes.

    Not where the ends determine them: there no inequality has an interior.
    """
    problem, c = numeric.problem, len(numeric.path_orders)
    fixed = {y for y, value in problem.initial.items() if value is not None}
    ends = {
        y
        for y in problem.state
        if any((y - e).is_number or (y + e).is_number for e in problem.terminal)
    }
    imposed = np.ones((intervals + 1, c), dtype=bool)
    for j, g in enumerate(problem.constraints):
        imposed[0, j] = not g.free_symbols <= fixed
        imposed[-1, j] = not g.free_symbols <= ends
    return np.nonzero(imposed.ravel())[0]


def target_multipliers(
    numeric: NumericProblem, solution: DirectSolution, multiplier=1.0
) -> np.ndarray:
    """Return nu, (m,): psi + lambda_0 grad phi_0 = -(grad phi)^T nu at the end of a solution."""
    if not numeric.m:
        return np.zeros(0)
    end = solution.states[-1]
    slope = (
        ca.Function("final", [numeric.x], [ca.gradient(numeric.final, numeric.x)])(end)
        .full()
        .ravel()
    )
    normals = numeric.target_value(end)[1].full()
    return np.linalg.lstsq(normals.T, -multiplier * (solution.costates[-1] + slope), rcond=None)[0]
