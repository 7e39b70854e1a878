"""From a problem to an extremal: reformulate, solve, restore.

A problem with |u| in its cost is solved in another form (`l1_control`), a linear plant with a
quadratic cost by one linear solve (`linear_quadratic`), and all others in natural units
(`problem.scaling`): discrete solutions (`direct.multistart`), their arcs (`structure`), and Newton's
method for the boundary value problem over these arcs (`refinement`, `shooting`, `flow`).
"""

from collections.abc import Sequence

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.degenerate_target import refuse_degenerate_target
from trajlib.pontryagin.direct.descent import escape_saddle, finer_solution, solution_from_controls
from trajlib.pontryagin.direct.first_integrals import refuse_first_integrals
from trajlib.pontryagin.direct.free_duration import (
    fixed_duration,
    refuse_any_duration,
    refuse_falling_cost,
    refuse_unbounded_duration,
)
from trajlib.pontryagin.direct.guesses import read_guess, refuse_start_on_target
from trajlib.pontryagin.direct.impulses import refuse_impulses
from trajlib.pontryagin.direct.infeasibility import (
    refuse_ends_beyond_constraints,
    refuse_infeasible,
)
from trajlib.pontryagin.direct.multistart import SearchResult, search
from trajlib.pontryagin.direct.passing_beyond import refuse_passing_beyond
from trajlib.pontryagin.direct.sliding import refuse_sliding, relaxed_solution, sequential_controls
from trajlib.pontryagin.direct.transcription import INTERVALS, DirectSolution, target_multipliers
from trajlib.pontryagin.indirect.assembly import extremal_of_shot
from trajlib.pontryagin.indirect.bounded_extremal import (
    inner_guess,
    inner_structure,
    restore_bounds,
)
from trajlib.pontryagin.indirect.chattering import refuse_chattering
from trajlib.pontryagin.indirect.contacts import end_constraints
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.indirect.infinite_horizon import solve_infinite_horizon
from trajlib.pontryagin.indirect.l1_control import split_l1_controls
from trajlib.pontryagin.indirect.linear_quadratic import solve_linear_quadratic
from trajlib.pontryagin.indirect.polynomial_end import solve_polynomial_end
from trajlib.pontryagin.indirect.refinement import refine
from trajlib.pontryagin.indirect.scaled_extremal import restore_units, scaled_guess
from trajlib.pontryagin.indirect.structure import candidate_structures, detect_arcs, read_structure
from trajlib.pontryagin.problem.arcs import Arc, arc_name
from trajlib.pontryagin.problem.errors import NotUnique, WrongStructure
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.scaling import natural_units
from trajlib.pontryagin.problem.state_bounds import with_constant_bounds
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.verification.second_variation import process_of_solution, second_variation


def solve(
    problem: Statement,
    structure: Sequence | None = None,
    guess: Extremal | dict | None = None,
    starts: int | None = None,
    time_limit: float | None = None,
) -> Extremal:
    """Find an extremal of a problem; called as `problem.solve(...)`.

    Parameters
    ----------
    problem : Problem
        Without parameters.
    structure : list, optional
        The arcs in order, "u-", "u+", "interior", "singular" (tuples of them for several controls);
        with |u| in the running cost also "zero", where u = 0. Found if left out; with path
        constraints it is always found.
    guess : Extremal or dict, optional
        An extremal of a similar problem, or {"duration": number, state or control: number, list of
        values at equal steps, or function of time}, any of them.
    starts : int, optional
        How many starting guesses to try, random ones after those that follow from the statement; by
        default until three in a row lead to one process. Not used where a guess is given or where a
        theorem makes every extremal optimal.
    time_limit : float, optional
        Seconds after which no further starting guess is tried.

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
        If switchings, or contacts with the boundary of a path constraint, accumulate.
    WrongStructure
        If the arcs cannot be joined to an extremal.
    NotUnique
        If a control, a free duration or the multiplier of a path constraint is not determined.
    NotConverged
        If no process was found, which proves nothing.

    Notes
    -----
    `Extremal.optimality` has what is known beyond the necessary conditions. For linear plants with
    a convex cost and a given duration, and for the least time to a point at which a linear plant
    can be held, the extremal is proved optimal. Otherwise the search begins at several guesses,
    leaves saddles and maxima along the second variation, and returns the best extremal it found; a
    better one is not excluded (see `compare`). Source: Theorem 5.1 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x, u = sp.symbols("x u")
    >>> turnpike = Problem({x: u}, {u: (-1, 1)}, {x: 1}, {x: sp.Rational(1, 2)}, running=x**2, duration=2)
    >>> turnpike.solve()
    Extremal(cost=0.375, duration=2, arcs: u- [0, 1], singular [1, 1.5], u+ [1.5, 2])
    """
    _check_effort(starts, time_limit)
    if problem.duration == sp.oo:
        if structure is not None or guess is not None:
            raise ValueError("structure, guess: an infinite horizon needs none; leave them out")
        return solve_infinite_horizon(problem)
    bounds = with_constant_bounds(problem)
    if bounds is not None:
        structure, guess = inner_structure(bounds, structure), inner_guess(bounds, guess)
        return restore_bounds(bounds, solve(bounds.problem, structure, guess, starts, time_limit))
    split = split_l1_controls(problem)
    if split is not None:
        structure, guess = split.structure(structure), split.guess(guess)
        return split.restore(solve(split.problem, structure, guess, starts, time_limit))
    numeric = NumericProblem(problem)
    if problem.path and structure is not None:
        raise ValueError("structure: with path constraints the arcs are found; leave it out")
    kinds = None if structure is None else read_structure(numeric, structure)
    effort = {"starts": starts, "time_limit": time_limit}
    start = read_guess(numeric, guess)
    refuse_start_on_target(numeric)
    refuse_ends_beyond_constraints(numeric)
    refuse_infeasible(numeric)
    refuse_first_integrals(numeric)
    refuse_any_duration(numeric)
    extremal = solve_linear_quadratic(numeric) if kinds is None else None
    if extremal is None and kinds is None and guess is None:
        extremal = solve_polynomial_end(problem)
    # Both leave inequalities aside: the extremal is valid where it satisfies them.
    if extremal is not None and (not problem.constrained or extremal.certificate().holds()):
        return extremal
    scaling = natural_units(problem)
    if scaling is None:
        return _refined(numeric, kinds, start, effort)
    inner = NumericProblem(scaling.problem, scaling)
    return restore_units(scaling, _refined(inner, kinds, scaled_guess(scaling, start), effort))


def _check_effort(starts, time_limit):
    """Raise TypeError or ValueError if `starts` is no count or `time_limit` no time."""
    if starts is not None and (isinstance(starts, bool) or not isinstance(starts, int)):
        raise TypeError(f"starts: expected a whole number, got {starts!r}")
    if starts is not None and starts < 1:
        raise ValueError(f"starts: expected at least one, got {starts}")
    if time_limit is not None and not float(time_limit) > 0:
        raise ValueError(f"time_limit: expected a positive number of seconds, got {time_limit}")


def _refined(numeric, kinds, guess, effort):
    """Return an extremal of a problem in natural units, found by search and refinement."""
    refinement = _Refinement(numeric, search(numeric, guess, kinds, **effort))
    return refinement.best_extremal() if kinds is None else refinement.with_structure(kinds)


class _Refinement:
    """From the discrete solutions of a search to an extremal; `reasons`: why others were refused."""

    def __init__(self, numeric: NumericProblem, search_result: SearchResult):
        self.numeric, self.search_result = numeric, search_result
        self.flow_cache: dict = {}
        self.reasons: list = []

    def with_structure(self, kinds):
        """Return the extremal with given arcs. Raises `WrongStructure` if there is none."""
        solution, _ = self.search_result.solutions[0]
        refuse_degenerate_target(self.numeric, solution.states)
        arcs = _arcs_of_structure(kinds, solution)
        duration = fixed_duration(self.numeric, solution)
        extremal = self._extremal(solution, arcs, duration, keep_structure=True)
        reason = _certificate_failure(extremal)
        if reason:
            raise WrongStructure(reason)
        return extremal

    def best_extremal(self):
        """Return the best certified extremal, or raise the reason why there is none."""
        numeric, solutions = self.numeric, self.search_result.solutions
        refuse_degenerate_target(numeric, solutions[0][0].states)
        refuse_falling_cost(numeric, self.search_result)
        for solution, side in solutions:
            extremal = self._certified(solution, side)
            if extremal is not None:
                return extremal
        solution, side = solutions[0]
        refuse_passing_beyond(numeric, solution)
        relaxed = None if numeric.path_orders else relaxed_solution(numeric, solution, side)
        if relaxed is not None:
            controls = sequential_controls(numeric, relaxed)
            sequential = solution_from_controls(numeric, relaxed, side, controls)
            refuse_sliding(numeric, solution, relaxed, sequential)
            extremal = self._certified(sequential, side)
            if extremal is not None:
                return extremal
        if fixed_duration(numeric, solution) is None:
            finer = finer_solution(numeric, solution, side, 4) or solution
            refuse_unbounded_duration(numeric, finer, side)
        refuse_impulses(numeric, solution, side)
        raise self._error(numeric.user_cost(solution.cost))

    def _extremal(self, solution, arcs, duration, keep_structure=False):
        numeric = self.numeric.with_end_constraints(end_constraints(self.numeric, solution))
        shot = refine(numeric, solution, arcs, duration, self.flow_cache, keep_structure)
        return extremal_of_shot(
            numeric, shot, self.search_result.starts, self.search_result.processes
        )

    def _certified(self, solution, side):
        """Return a certified extremal next to a solution, on finer and finer grids, or None."""
        numeric, factor = self.numeric, 1
        while factor is not None:
            duration = fixed_duration(numeric, solution)
            refuse_chattering(
                numeric, detect_arcs(numeric, solution), solution.states[-1], duration
            )
            extremal = self._first_certified(solution, duration)
            if extremal is not None:
                sign = 1
                if (
                    not extremal.optimality.proved
                    and extremal.normal
                    and not extremal.touches_boundary
                ):
                    sign = extremal._variation.sign
                # More time may change nothing to second order because it costs nothing at all.
                if sign == 0 and duration is None:
                    refuse_unbounded_duration(numeric, solution, side)
                if sign >= 0:
                    return extremal
                better = _solution_beside_saddle(numeric, extremal, side)
                if better is not None:
                    solution, factor = better, 1
                    continue
                self.reasons.append(
                    "the extremal found is a saddle: the cost falls along its second variation"
                )
            factor = {1: 4, 4: 10, 10: None}[factor]
            if factor is not None:
                solution = finer_solution(numeric, solution, side, factor) or solution
        return None

    def _first_certified(self, solution, duration):
        """Return the first extremal that holds, with the arcs that a solution may have, or None."""
        for arcs in candidate_structures(self.numeric, solution):
            try:
                extremal = self._extremal(solution, arcs, duration)
            except WrongStructure as error:
                self.reasons.append(error)
                continue
            reason = _certificate_failure(extremal)
            if not reason:
                return extremal
            self.reasons.append(reason)
        return None

    def _error(self, cost):
        """Return the error with the reasons why no arcs were joined to an extremal."""
        open_control = next((e for e in self.reasons if isinstance(e, NotUnique)), None)
        if open_control:
            return NotUnique(
                f"{open_control}. So many controls may be equally good, as where several motions must "
                "end at one moment and only the slowest sets it; one of them has a cost of about "
                f"{cost:.6g} (a discrete solution). To single one out, give a structure, or the "
                "control a small cost."
            )
        return WrongStructure(
            "the arcs that the discrete solution shows could not be joined to an extremal: "
            + "; ".join(dict.fromkeys(map(str, self.reasons)))
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
            "process with these arcs does not have it. Leave it out, or leave the structure to "
            "solve()."
        )
    return [Arc(kind, begin, end) for kind, begin, end in zip(kinds, ends, ends[1:])]


def _certificate_failure(extremal):
    """Return which conditions the extremal's certificate finds violated; "" if all hold."""
    failures, worst = extremal._residuals.failures(), extremal._residuals.worst
    if not failures:
        return ""
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
