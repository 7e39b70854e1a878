"""Refinement of a discrete solution to an extremal by Newton's method."""

from copy import copy
from dataclasses import replace

import numpy as np

from trajlib.pontryagin.direct.transcription import DirectSolution, target_multipliers
from trajlib.pontryagin.indirect.bang_bang import reach_target
from trajlib.pontryagin.indirect.contacts import jump_guess
from trajlib.pontryagin.indirect.maximum_condition import required_arcs
from trajlib.pontryagin.indirect.multipliers import choose_multipliers
from trajlib.pontryagin.indirect.newton import CANCELLING, newton
from trajlib.pontryagin.indirect.shooting import (
    ArcEquations,
    ShootingSolution,
    arc_flow,
    control_jumps,
    costate_jumps,
)
from trajlib.pontryagin.indirect.structure import axis_of
from trajlib.pontryagin.problem.arcs import CONSTANT_ANGLES, Arc, arc_name, boundary_constraint
from trajlib.pontryagin.problem.errors import WrongStructure
from trajlib.pontryagin.problem.numeric import NumericProblem

# Largest relative residual of an accepted solution; most end near 1e-15.
ACCEPTED = 1e-10
# Change of an arc's end when its steps are halved, at which the steps are short enough.
INTEGRATED = 2e-13
# The same for the first steps.
ROUGH = 1e-3
# How far Newton's last step may move the ends of the arcs, relative to the duration.
DETERMINED = 1e-8
SAMPLES = 32
# Share of the duration below which an interior arc is a rapid change of the control from bound to
# bound.
SWEEP = 1e-2
# Largest number of steps of the integrator on one arc.
MAX_STEPS = 1024
# Largest number of segments of one arc, and growth of errors on one of them beyond which no digit
# is left.
MAX_SEGMENTS, MAX_GROWTH = 48, 1e20


def refine(
    numeric: NumericProblem,
    solution: DirectSolution,
    arcs: list[Arc],
    duration: float | None,
    flow_cache: dict,
    keep_structure: bool = False,
    longest_growth: float = CANCELLING,
) -> ShootingSolution:
    """Refine a discrete solution with given arcs by multiple shooting.

    Arcs that vanish are left out, and where the maximum condition fails the arcs are detected anew
    on the trajectory, unless the structure is to be kept. `flow_cache` holds the flows built so
    far; errors grow by `longest_growth` at most along a segment. Raises `WrongStructure` if nothing
    leads to an extremal.
    """
    tried_structures, reason = set(), ""
    while (structure := tuple((arc.kinds, arc.touch) for arc in arcs)) not in tried_structures:
        tried_structures.add(structure)
        shot = shoot(numeric, solution, arcs, duration, flow_cache, longest_growth)
        lengths = arc_lengths(shot)
        short = int(np.argmin(lengths))
        if lengths[short] < 1e-7 * lengths.sum() and len(arcs) > 1:
            reason = (
                f"the arc {arc_name(arcs[short].kinds)} (number {short + 1}) shrinks to nothing"
            )
            arcs = _without(numeric, arcs, short)
        elif not shot.residual <= ACCEPTED:
            reason = (
                f"the conditions for the arcs {', '.join(arc_name(arc.kinds) for arc in arcs)} were "
                f"not satisfied (residual {shot.residual:.1e})"
            )
            break
        elif not shot.uncertainty <= DETERMINED:
            reason = (
                f"the conditions for the arcs {', '.join(arc_name(arc.kinds) for arc in arcs)} do not "
                "determine their lengths (Newton's method would still move them by "
                f"{shot.uncertainty:.1e} of the duration)"
            )
            break
        else:
            description, required = required_arcs(numeric, shot)
            if not description and shot.multiplier >= -1e-8:
                return shot
            chosen = _with_chosen_multipliers(numeric, shot, duration)
            if chosen is not None:
                return chosen
            if shot.multiplier < -1e-8:
                reason = "the only solution near the guess has lambda_0 < 0"
                break
            reason = f"the maximum condition fails on {description}"
            solution, arcs = to_direct_solution(numeric, shot), required
        if keep_structure:
            break
    raise WrongStructure(reason)


def shoot(numeric, solution, arcs, duration, flow_cache, longest_growth=CANCELLING):
    """Solve the equations of these arcs by Newton's method from a discrete solution.

    If lambda_0 tends to zero against psi: where the multipliers are not unique, a normal solution
    may be found from a larger lambda_0; if none is, the abnormal one is searched for. Where nothing is
    found, a bang-bang trajectory that ends on the target is tried in place of the discrete one.
    """
    guess = _starting_values(numeric, solution, arcs, flow_cache, longest_growth)
    shot = _solved(numeric, copy(guess), duration, abnormal=False)
    if not shot.residual <= ACCEPTED:
        reached = reach_target(numeric, guess, duration)
        if reached is not None:
            return _solved(numeric, reached, duration, abnormal=False)
    if not _nearly_abnormal(numeric, shot):
        return shot
    normal = copy(guess)
    normal.multiplier = _largest_costate(numeric, guess)
    normal = _solved(numeric, normal, duration, abnormal=False)
    accepted = (
        normal.residual <= ACCEPTED
        and not _nearly_abnormal(numeric, normal)
        and normal.multiplier > 0
    )
    if accepted and not required_arcs(numeric, normal)[0]:
        return normal
    abnormal = _solved(numeric, copy(shot), duration, abnormal=True)
    return abnormal if abnormal.residual <= max(ACCEPTED, shot.residual) else shot


def _with_chosen_multipliers(numeric, shot, duration):
    """Return the same trajectory with multipliers that satisfy the maximum condition, or None."""
    chosen = choose_multipliers(numeric, shot, duration)
    if chosen is None:
        return None
    chosen = _solved(numeric, chosen, duration, abnormal=False)
    return chosen if chosen.residual <= ACCEPTED and not required_arcs(numeric, chosen)[0] else None


def _largest_costate(numeric, shot):
    return max(np.max(np.abs(start[numeric.n : 2 * numeric.n])) for start in shot.starts)


def _nearly_abnormal(numeric, shot):
    return abs(shot.multiplier) < 1e-4 * _largest_costate(numeric, shot)


def arc_lengths(shot):
    """Return the lengths of the arcs, the segments of one arc being added."""
    lengths = []
    for index, (flow, length) in enumerate(zip(shot.flows, shot.lengths)):
        if index and flow.continues(shot.flows[index - 1]):
            lengths[-1] += length
        else:
            lengths.append(length)
    return np.array(lengths)


def _starting_values(numeric, solution, arcs, flow_cache, longest_growth):
    """Cut arcs into segments along which errors grow by `longest_growth` at most.

    Every segment begins with the values of the discrete solution: integrated from the beginning of
    a long arc, its errors would grow.
    """
    scale = np.linalg.norm(np.append(solution.costates[0], 1.0))
    segment_flows, starts, lengths = [], [], []
    for arc in arcs:
        flow = arc_flow(numeric, arc.kinds, arc.touch, flow_cache)
        pieces, length = 1, arc.end - arc.begin
        while True:
            begins = arc.begin + length * np.arange(pieces) / pieces
            points = [
                _point(numeric, solution, flow, begin, length / pieces, scale) for begin in begins
            ]
            error_growth = growth(flow, points, 1 / scale, length / pieces)
            if (
                error_growth > longest_growth
                and length < SWEEP * solution.duration
                and "interior" in flow.kinds
            ):
                # No error grows so fast: the control has passed its bound, beyond which H is not
                # concave.
                length *= _swept(numeric, flow, points[0], 1 / scale, length)
                error_growth = growth(flow, points[:1], 1 / scale, length)
            if error_growth <= longest_growth or pieces >= MAX_SEGMENTS:
                break
            needed = (
                np.log(error_growth) / np.log(longest_growth) if np.isfinite(error_growth) else 2
            )
            pieces = int(min(max(np.ceil(pieces * min(needed, 4)), pieces + 1), MAX_SEGMENTS))
        if error_growth > MAX_GROWTH:
            raise WrongStructure(
                f"errors along the arc {arc_name(flow.kinds)} grow by {error_growth:.0e} even on {pieces} "
                "segments"
            )
        segment_flows.append(flow)
        if pieces > 1:
            segment_flows += [arc_flow(numeric, arc.kinds, None, flow_cache)] * (pieces - 1)
        starts += points
        lengths += [length / pieces] * pieces
    begins = np.concatenate([[0.0], np.cumsum(lengths)])
    jumps = [
        jump_guess(solution, constraint, begins[index]) / scale
        for index, constraint in costate_jumps(numeric, segment_flows).items()
    ]
    return ShootingSolution(
        segment_flows,
        starts,
        np.array(lengths),
        1 / scale,
        target_multipliers(numeric, solution, 1 / scale),
        [8] * len(segment_flows),
        np.array(jumps),
    )


def _swept(numeric, flow, point, multiplier, length):
    """Return the part of a short arc before an interior control passes a bound."""
    path = flow.nodes(np.append(point, 0.0), multiplier, length, SAMPLES)[:, :-1]
    controls = flow.values("control", path.T, multiplier).T[:, flow.interior]
    slack = 1e-3 * (numeric.upper - numeric.lower)[flow.interior]
    inside = (controls > numeric.lower[flow.interior] - slack) & (
        controls < numeric.upper[flow.interior] + slack
    )
    outside = np.nonzero(~inside.all(axis=1))[0]
    return max(outside[0], 1) / SAMPLES if len(outside) else 1.0


def _point(numeric, solution, flow, begin, length, scale):
    """Return y of the discrete solution where a segment begins.

    Where a control jumps or changes fast, it is between two samples that of neither: there the
    first sample on the segment is taken, or, if there is none, the control that maximises H.
    """
    middles = (solution.times[:-1] + solution.times[1:]) / 2
    x = [np.interp(begin, solution.times, column) for column in solution.states.T]
    # Costates belong to the ends of the intervals: the first is not reliable where the initial
    # state is fixed.
    psi = [np.interp(begin, solution.times, column) / scale for column in solution.costates.T]
    w = [
        axis_of(solution.controls[:, j])
        if flow.kinds[j] in CONSTANT_ANGLES
        else np.interp(begin + 0.02 * length, middles, solution.controls[:, j])
        for j in flow.interior
    ]
    widths = numeric.upper - numeric.lower
    bounded = [j for j in flow.interior if flow.kinds[j] == "interior" and np.isfinite(widths[j])]
    if bounded:
        after = np.searchsorted(middles, begin)
        u = solution.controls[min(after, len(middles) - 1)]
        if after == len(middles) or middles[after] > begin + length:
            u = numeric.best_controls(np.array([x]), scale * np.array([psi]), u[None])[0][0]
        for component, j in enumerate(flow.interior):
            if j in bounded and abs(u[j] - w[component]) > widths[j] / 4:
                w[component] = u[j]
    return np.array(x + psi + w)


def growth(flow, points, multiplier, length):
    """Return the largest growth of errors along segments; infinite if one cannot be integrated."""
    largest = 0.0
    for point in points:
        _, by_start, _, by_length = flow.transition(point, multiplier, length, 8)
        finite = np.isfinite(by_start).all() and np.isfinite(by_length).all()
        largest = max(largest, float(np.max(np.abs(by_start))) if finite else np.inf)
    return largest


def _solved(numeric, shot, duration, abnormal):
    """Apply Newton's method with steps halved until the integration is exact to rounding."""
    first = np.concatenate([[shot.multiplier], shot.starts[0][numeric.n : 2 * numeric.n]])
    shot.multiplier, scale = (0.0 if abnormal else shot.multiplier), np.linalg.norm(first)
    before, jumping = np.inf, control_jumps(numeric, shot)
    # With steps that are far too long Newton's method would solve another problem, and stay near
    # its solution.
    shot.steps = finer_steps(shot, ROUGH)
    for _ in range(8):
        equations = ArcEquations(
            numeric, shot.flows, shot.steps, duration, first / scale**2, abnormal, jumping
        )
        z, residual, uncertainty = newton(equations, equations.pack(shot))
        shot = equations.unpack(z, residual, uncertainty)
        steps = finer_steps(shot, INTEGRATED)
        if steps == shot.steps or not np.isfinite(residual):
            break
        shot.steps = steps
        # A residual that finer steps do not reduce is not an error of the steps.
        if shot.residual > max(ACCEPTED, min(1e-3, before / 2)):
            break
        before = shot.residual
    return shot


def finer_steps(shot, accuracy):
    """Return the numbers of steps, doubled as often as the accuracy needs at order 8.

    The error of an arc is the change of its end when the steps are halved.
    """
    finer = list(shot.steps)
    for i, (flow, start, length) in enumerate(zip(shot.flows, shot.starts, shot.lengths)):
        begin, steps = np.append(start, 0.0), shot.steps[i]
        once, twice = (
            flow.nodes(begin, shot.multiplier, length, s)[-1] for s in (steps, 2 * steps)
        )
        error = np.max(np.abs(once - twice) / (1 + np.abs(twice)))
        if not error < accuracy and steps < MAX_STEPS:
            doublings = np.log2(error / accuracy) / 8 if np.isfinite(error) else 1
            finer[i] = int(min(steps * 2 ** np.clip(np.ceil(doublings), 1, 3), MAX_STEPS))
    return finer


def to_direct_solution(numeric, shot):
    """Sample a solution of the boundary value problem, with lambda_0 = 1 where possible."""
    scale = shot.multiplier if shot.multiplier > 1e-8 else 1.0
    times, states, costates, controls = (
        [0.0],
        [shot.starts[0][: numeric.n]],
        [shot.starts[0][numeric.n : 2 * numeric.n]],
        [],
    )
    for flow, start, length in zip(shot.flows, shot.starts, shot.lengths):
        path = flow.nodes(np.append(start, 0.0), shot.multiplier, length, SAMPLES)
        times += list(times[-1] + length * np.arange(1, SAMPLES + 1) / SAMPLES)
        states += list(path[1:, : numeric.n])
        costates += list(path[1:, numeric.n : 2 * numeric.n])
        controls.append(
            flow.values("control", ((path[1:] + path[:-1]) / 2)[:, :-1].T, shot.multiplier).T
        )
    return DirectSolution(
        np.array(times),
        np.array(states),
        np.array(costates) / scale,
        np.concatenate(controls),
        np.nan,
    )


def _without(numeric, arcs, index):
    """Remove an arc that vanished; its neighbours, if of one kind, become one arc.

    A boundary arc of an order above one leaves a touch point.
    """
    constraint, after = boundary_constraint(arcs[index].kinds), arcs[index + 1 :]
    if constraint is not None and numeric.path_orders[constraint] > 1 and index and after:
        after[0] = replace(after[0], touch=constraint)
    remaining = []
    for arc in arcs[:index] + after:
        if remaining and remaining[-1].kinds == arc.kinds and arc.touch is None:
            remaining[-1] = replace(remaining[-1], end=arc.end)
        else:
            remaining.append(arc)
    return remaining
