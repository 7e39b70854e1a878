"""Extremals from solutions of the boundary value problem."""

import numpy as np

from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.indirect.refinement import arc_lengths
from trajlib.pontryagin.indirect.shooting import ShootingSolution, costate_jumps
from trajlib.pontryagin.problem.arcs import BOUNDARY, CONSTANT_ANGLES, boundary_kind
from trajlib.pontryagin.problem.errors import WrongStructure
from trajlib.pontryagin.problem.numeric import NumericProblem


def extremal_of_shot(
    numeric: NumericProblem, shot: ShootingSolution, starts: int, processes: int
) -> Extremal:
    """Return the extremal of a converged solution, with lambda_0 = 1 in the normal case.

    Raises `WrongStructure` if it meets the target before its end, against first_return.
    """
    n, problem = numeric.n, numeric.problem
    largest = max(np.max(np.abs(start[n : 2 * n])) for start in shot.starts)
    normal = shot.multiplier > 1e-9 * largest
    scale = shot.multiplier if normal else np.linalg.norm(shot.starts[0][n : 2 * n])
    for start in shot.starts:
        start[n : 2 * n] /= scale
    shot.multiplier = 1.0 if normal else 0.0
    shot.terminal_multipliers = shot.terminal_multipliers / scale
    shot.jumps = shot.jumps / scale
    ends = [
        flow.nodes(np.append(start, 0.0), shot.multiplier, length, steps)[-1]
        for flow, start, length, steps in zip(shot.flows, shot.starts, shot.lengths, shot.steps)
    ]
    times = [float(t) for t in np.concatenate([[0.0], np.cumsum(arc_lengths(shot))])]
    flows = [
        flow for i, flow in enumerate(shot.flows) if not i or not flow.continues(shot.flows[i - 1])
    ]
    names = dict.fromkeys(CONSTANT_ANGLES, "interior")
    if len(problem.path) == 1:
        names[boundary_kind(0)] = BOUNDARY
    shown = [tuple(names.get(kind, kind) for kind in flow.kinds) for flow in flows]
    arcs = tuple(
        (kinds[0] if numeric.k == 1 else kinds, begin, end)
        for kinds, begin, end in zip(shown, times, times[1:])
    )
    cost = sum(end[-1] for end in ends) + float(numeric.final_value(ends[-1][:n]))
    extremal = Extremal(
        problem,
        float(-cost if problem.maximise else cost),
        times[-1],
        arcs,
        shot.multiplier,
        _terminal_multipliers(numeric, shot),
        shot.residual,
        _jumps(numeric, shot),
        numeric,
        shot,
        starts,
        processes,
    )
    if problem.first_return and _passes_target(extremal):
        raise WrongStructure(
            "the trajectory with these arcs meets the target before its end, against first_return"
        )
    return extremal


def _terminal_multipliers(numeric, shot):
    """Return the multipliers of the terminal equations, then of the inequalities."""
    problem = numeric.problem
    m, c = len(problem.terminal), len(problem.path)
    result = [*map(float, shot.terminal_multipliers[:m]), *[0.0] * len(problem.end_constraints)]
    for index, value in zip(numeric.end_constraints, shot.terminal_multipliers[m:]):
        if index >= c:
            result[m + index - c] = float(value)
    return tuple(result)


def _jumps(numeric, shot):
    """Return (path constraint, time, nu) for the jumps of the costate, those at the end last."""
    path, begins = numeric.problem.path, np.concatenate([[0.0], np.cumsum(shot.lengths)])
    inside = [
        (path[constraint], float(begins[index]), float(nu))
        for (index, constraint), nu in zip(costate_jumps(numeric, shot.flows).items(), shot.jumps)
    ]
    at_end = shot.terminal_multipliers[len(numeric.problem.terminal) :]
    return tuple(inside) + tuple(
        (path[constraint], float(begins[-1]), float(nu))
        for constraint, nu in zip(numeric.end_constraints, at_end)
        if constraint < len(path)
    )


def _passes_target(extremal):
    """Check whether the single terminal equation changes its sign before the end."""
    between = extremal.state(np.linspace(0, extremal.duration, 402)[1:-1])
    values = extremal._numeric.target_value.map(400)(between)[0].full().ravel()
    largest = np.max(np.abs(values))
    return bool(np.min(values) < -1e-9 * largest and np.max(values) > 1e-9 * largest)
