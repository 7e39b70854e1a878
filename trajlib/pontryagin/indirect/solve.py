"""From a problem to an extremal: reformulate, solve, restore.

A problem with |u| in its cost or with large states is solved in another form (`l1_control`,
`state_scaling`), and its extremal restored. Between them: discrete solutions (`direct.multistart`),
their arcs (`structure`), and Newton's method for the boundary value problem over these arcs
(`refinement`, `shooting`, `flow`).
"""

import numpy as np

from trajlib.pontryagin.direct.descent import escape_saddle, finer_solution, solution_from_controls
from trajlib.pontryagin.direct.free_duration import (
    fixed_duration,
    refuse_falling_cost,
    refuse_unbounded_duration,
)
from trajlib.pontryagin.direct.guesses import read_guess
from trajlib.pontryagin.direct.multistart import search
from trajlib.pontryagin.direct.sliding import refuse_sliding, relaxed_solution, sequential_controls
from trajlib.pontryagin.direct.transcription import INTERVALS, DirectSolution, target_multipliers
from trajlib.pontryagin.indirect.chattering import refuse_chattering
from trajlib.pontryagin.indirect.extremal import Extremal, extremal_of_shot
from trajlib.pontryagin.indirect.l1_control import split_l1_controls
from trajlib.pontryagin.indirect.refinement import refine
from trajlib.pontryagin.indirect.state_scaling import scale_large_states
from trajlib.pontryagin.indirect.structure import candidate_structures, detect_arcs, read_structure
from trajlib.pontryagin.problem.arcs import Arc, arc_name
from trajlib.pontryagin.problem.errors import NotUnique, WrongStructure
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.verification.second_variation import process_of_solution, second_variation


def solve(problem: Statement, structure=None, guess=None) -> Extremal:
    """Find an extremal of a problem; called as `problem.solve(...)`.

    Parameters
    ----------
    problem : Problem
        Without parameters.
    structure : list, optional
        The arcs in order, "u-", "u+", "interior", "singular" (tuples of them for several controls);
        with |u| in the running cost also "zero", where u = 0. Found if left out.
    guess : Extremal or dict, optional
        An extremal of a similar problem, or {"duration": number, state or control: number, list of
        values at equal steps, or function of time}, any of them.

    Returns
    -------
    Extremal
        Satisfies the conditions of the maximum principle to about 1e-12: its own certificate holds.

    Raises
    ------
    ValueError
        If a parameter has no value, or an argument is not of this form.
    StartOnTarget
        If the initial state is on the target and the final time is free.
    Infeasible
        With a proof, also for a duration that is too short.
    Unbounded
        If the cost has no minimum.
    Chattering
        If switchings accumulate.
    WrongStructure
        If the arcs cannot be joined to an extremal.
    NotUnique
        If a control or a free duration is not determined.
    NotConverged
        If no process was found, which proves nothing.

    Notes
    -----
    `Extremal.optimality` has what is known beyond the necessary conditions. For linear plants with a
    convex cost and a given duration, and for the least time to a point at which a linear plant can be
    held, the extremal is proved optimal. Otherwise the search begins at several guesses, leaves saddles
    and maxima along the second variation, and returns the best extremal it found; a better one is not
    excluded (see `compare`). Source: Theorem 5.1 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x, u = sp.symbols("x u")
    >>> turnpike = Problem({x: u}, {u: (-1, 1)}, {x: 1}, {x: sp.Rational(1, 2)}, running=x**2, duration=2)
    >>> turnpike.solve()
    Extremal(cost=0.375, duration=2, arcs: u- [0, 1], singular [1, 1.5], u+ [1.5, 2])
    """
    reformulations = []
    for reformulate in (split_l1_controls, scale_large_states):
        step = reformulate(problem)
        if step is not None:
            structure, guess = step.structure(structure), step.guess(guess)
            problem = step.problem
            reformulations.append(step)
    extremal = _solved(problem, structure, guess)
    for step in reversed(reformulations):
        extremal = step.restore(extremal)
    return extremal


def _solved(problem, structure, guess):
    """Return an extremal of a problem that is smooth in its controls and well scaled."""
    numeric = NumericProblem(problem)
    kinds = None if structure is None else read_structure(numeric, structure)
    search_result = search(numeric, read_guess(numeric, guess), kinds)
    flow_cache = {}
    if kinds is not None:
        solution, _ = search_result.solutions[0]
        arcs = _arcs_of_structure(kinds, solution)
        shot = refine(
            numeric,
            solution,
            arcs,
            fixed_duration(numeric, solution),
            flow_cache,
            keep_structure=True,
        )
        extremal = extremal_of_shot(
            problem, numeric, shot, search_result.starts, search_result.found
        )
        reason = _certificate_failure(extremal)
        if reason:
            raise WrongStructure(reason)
        return extremal
    refuse_falling_cost(numeric, search_result)
    reasons = []
    for solution, side in search_result.solutions:
        extremal = _certified_extremal(
            problem, numeric, solution, side, search_result, flow_cache, reasons
        )
        if extremal is not None:
            return extremal
    solution, side = search_result.solutions[0]
    relaxed = relaxed_solution(numeric, solution, side)
    if relaxed is not None:
        separate = solution_from_controls(
            numeric, relaxed, side, sequential_controls(numeric, relaxed)
        )
        refuse_sliding(numeric, solution, relaxed, separate)
        extremal = _certified_extremal(
            problem, numeric, separate, side, search_result, flow_cache, reasons
        )
        if extremal is not None:
            return extremal
    if fixed_duration(numeric, solution) is None:
        refuse_unbounded_duration(
            numeric, finer_solution(numeric, solution, side, 4) or solution, side
        )
    cost = -solution.cost if problem.maximise else solution.cost
    open_control = next((reason for reason in reasons if isinstance(reason, NotUnique)), None)
    if open_control:
        raise NotUnique(
            f"{open_control}. So many controls may be equally good, as where several motions must "
            "end at one moment and only the slowest sets it; one of them has a cost of about "
            f"{cost:.6g} (a discrete solution). To single one out, give a structure, or the control "
            "a small cost."
        )
    raise WrongStructure(
        "the arcs that the discrete solution shows could not be joined to an extremal: "
        + "; ".join(dict.fromkeys(map(str, reasons)))
        + ". Give the structure, or a guess; look at the "
        f"discrete cost {cost:.6g} to see whether an optimal process exists."
    )


def _arcs_of_structure(kinds, solution):
    """Return the arcs of a given structure with the lengths that they have in the solution."""
    ends = np.concatenate([[0.0], np.cumsum(solution.lengths)])
    if min(solution.lengths) < 1e-6 * solution.duration:
        short = int(np.argmin(solution.lengths))
        raise WrongStructure(
            f"the arc {arc_name(kinds[short])} (number {short + 1}) shrinks to nothing: the best "
            "process "
            "with these arcs does not have it. Leave it out, or leave the structure to solve()."
        )
    return [Arc(kind, begin, end) for kind, begin, end in zip(kinds, ends, ends[1:])]


def _certified_extremal(problem, numeric, solution, side, search_result, flow_cache, reasons):
    """Return a certified extremal next to the solution, on finer and finer grids, or None.

    The reasons of failures are appended to `reasons`.
    """
    factor = 1
    while factor is not None:
        duration = fixed_duration(numeric, solution)
        refuse_chattering(numeric, detect_arcs(numeric, solution), solution.states[-1], duration)
        for arcs in candidate_structures(numeric, solution):
            try:
                shot = refine(numeric, solution, arcs, duration, flow_cache)
                extremal = extremal_of_shot(
                    problem, numeric, shot, search_result.starts, search_result.found
                )
                reason = _certificate_failure(extremal)
            except WrongStructure as error:
                reason = error
            if not reason:
                break
            reasons.append(reason)
        if not reason:
            if extremal.optimality.proved or not extremal.normal or extremal._variation.sign > 0:
                return extremal
            if extremal._variation.sign == 0:
                # More time may change nothing to second order because it costs nothing at all.
                if duration is None:
                    refuse_unbounded_duration(numeric, solution, side)
                return extremal
            reason = "the extremal found is a saddle: the cost falls along its second variation"
            better = _solution_beside_saddle(numeric, extremal, side)
            if better is not None:
                solution, factor = better, 1
                continue
            reasons.append(reason)
        factor = {1: 4, 4: 10, 10: None}[factor]
        if factor is not None:
            solution = finer_solution(numeric, solution, side, factor) or solution
    return None


def _certificate_failure(extremal):
    """Return which conditions the extremal's certificate finds violated; "" if all hold."""
    failures = extremal.certificate().failures()
    if not failures:
        return ""
    worst = extremal.certificate().worst
    return (
        f"the certificate of the arcs {', '.join(str(kind) for kind, _, _ in extremal.arcs)} fails "
        f"({', '.join(failures)}; {worst:.1e})"
    )


def _solution_beside_saddle(numeric, extremal, side):
    """Return a discrete solution of lower cost than an extremal that is a saddle, or None."""
    times = np.linspace(0, extremal.duration, INTERVALS + 1)
    sign = -1 if extremal.problem.maximise else 1
    solution = DirectSolution(
        times,
        extremal.state(times).T,
        extremal.costate(times).T,
        extremal.control((times[1:] + times[:-1]) / 2).T,
        sign * extremal.cost,
    )
    variation = second_variation(
        numeric, process_of_solution(numeric, solution, target_multipliers(numeric, solution))
    )
    return escape_saddle(numeric, solution, variation, side) if variation.sign < 0 else None
