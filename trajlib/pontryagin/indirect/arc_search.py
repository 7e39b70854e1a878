"""From the discrete solutions of a search to an extremal.

The arcs of a discrete solution are found (`structure`), and Newton's method solves the boundary
value problem over these arcs (`refinement`, `shooting`, `flow`), on finer and finer grids.
"""

import numpy as np

from trajlib.pontryagin.direct.descent import escape_saddle, finer_solution
from trajlib.pontryagin.direct.free_duration import fixed_duration, refuse_unbounded_duration
from trajlib.pontryagin.direct.multistart import Multistart
from trajlib.pontryagin.direct.refusals import DEGENERATE_TARGET, OF_SOLUTIONS, WITHOUT_EXTREMAL
from trajlib.pontryagin.direct.transcription import DirectSolution
from trajlib.pontryagin.indirect.assembly import extremal_of_shot
from trajlib.pontryagin.indirect.chattering import CHATTERING
from trajlib.pontryagin.indirect.contacts import end_constraints
from trajlib.pontryagin.indirect.newton import CANCELLING
from trajlib.pontryagin.indirect.refinement import refine
from trajlib.pontryagin.indirect.structure import candidate_structures, detect_arcs
from trajlib.pontryagin.problem.arcs import Arc, arc_name
from trajlib.pontryagin.problem.errors import NotConverged, NotUnique, WrongStructure
from trajlib.pontryagin.problem.hypotheses import FINITE_TIME
from trajlib.pontryagin.problem.log import current_log
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.state_constraints import constraint_derivatives
from trajlib.pontryagin.problem.steps import Method
from trajlib.pontryagin.problem.time_limit import is_end_of_time
from trajlib.pontryagin.verification.optimality import sufficiency_theorem
from trajlib.pontryagin.verification.second_variation import process_of_extremal, second_variation

# Lists of arcs that are tried, at most: on finer grids each contact with a boundary may be an arc or a
# touch point. Where one of them leads to an extremal, it is among the first.
MOST_LISTS = 20
# Costs of discrete solutions that differ by a smaller share are those of one process.
SAME = 1e-6
# An extremal whose cost is higher by this share than that of the discrete solution from which Newton's
# method began is another process.
WORSE = 1e-2
# Growth of errors along segments from which Newton's method goes to the solution nearby.
SHORT = 3.0


def search_extremal(numeric, kinds, guess, starts):
    """Return an extremal of a problem in natural units, found by search and refinement."""
    search = _ArcSearch(numeric, Multistart(numeric, kinds, starts))
    try:
        search.find_solutions(guess)
        return search.best_extremal() if kinds is None else search.with_structure(kinds)
    except BaseException as error:
        if not is_end_of_time(error):
            raise
        raise search.out_of_time() from None


class _ArcSearch:
    """From the discrete solutions of a search to an extremal.

    `reasons`: why extremals were refused; `tried`: how many lists of arcs were tried.
    """

    def __init__(self, numeric: NumericProblem, multistart: Multistart):
        self.numeric, self.multistart = numeric, multistart
        self.flow_cache: dict = {}
        self.longest_growth = CANCELLING
        self.reasons: list = []
        self.tried = 0

    def find_solutions(self, guess):
        """Search for the discrete solutions."""
        self.search_result = self.multistart.search(guess)

    def out_of_time(self):
        """Return the error with what was found by the end of the time."""
        best, starts = self.multistart.best, _count(self.multistart.starts, "start")
        if best is None:
            found = f"no process that ends on the target was found from {starts}"
        else:
            cost, duration = (
                self.numeric.user_cost(best.cost),
                self.numeric.user_time(best.duration),
            )
            found = (
                f"the best process found from {starts} has the cost {cost:.6g} and lasts "
                f"{duration:.6g} (a discrete solution)"
            )
        if self.tried:
            lists = _count(self.tried, "list")
            found += f"; {lists} of arcs led to no extremal so far"
        return NotConverged(
            f"the time limit is over: {found}. Nothing is proved by that: allow more time, or give "
            "a guess."
        )

    def with_structure(self, kinds):
        """Return the extremal with given arcs. Raises `WrongStructure` if there is none."""
        solution, _ = self.search_result.solutions[0]
        DEGENERATE_TARGET.check(self.numeric, self.search_result)
        arcs = _arcs_of_structure(kinds, solution)
        duration = fixed_duration(self.numeric, solution)
        current_log().note("arcs", f"{', '.join(map(arc_name, kinds))}: given")
        extremal = self._extremal(solution, arcs, duration, keep_structure=True)
        reason = _certificate_failure(extremal)
        if reason:
            raise WrongStructure(reason)
        return extremal

    def best_extremal(self):
        """Return the best certified extremal, or raise the reason why there is none."""
        numeric, solutions = self.numeric, self.search_result.solutions
        for refusal in OF_SOLUTIONS:
            refusal.check(numeric, self.search_result)
        for solution, side in solutions:
            extremal = self._certified(solution, side)
            if extremal is not None:
                return extremal
        solution, side = solutions[0]
        for refusal in WITHOUT_EXTREMAL:
            other = refusal.check(numeric, solution, side)
            extremal = other and self._certified(other, side)
            if extremal:
                return extremal
        raise self._error(numeric.user_cost(solution.cost))

    def _extremal(self, solution, arcs, duration, keep_structure=False):
        numeric = self.numeric.with_end_constraints(end_constraints(self.numeric, solution))
        shot = refine(
            numeric, solution, arcs, duration, self.flow_cache, keep_structure, self.longest_growth
        )
        return extremal_of_shot(
            numeric, shot, self.search_result.starts, self.search_result.processes
        )

    def _certified(self, solution, side):
        """Return a certified extremal next to a solution, on finer and finer grids, or None."""
        numeric, factor = self.numeric, 1
        while factor is not None:
            duration = fixed_duration(numeric, solution)
            CHATTERING.check(numeric, detect_arcs(numeric, solution), solution.states[-1], duration)
            extremal = self._first_certified(solution, duration)
            if extremal is not None and self._segments_shortened(solution, extremal):
                continue
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
                better = _solution_beside_saddle(numeric, extremal, duration, side)
                if better is not None and better.cost < solution.cost - SAME * abs(solution.cost):
                    solution, factor = better, 1
                    continue
                # Newton's method has left a solution as good as that for the saddle.
                self.longest_growth = SHORT
                self.reasons.append(
                    "the extremal found is a saddle: the cost falls along its second variation"
                )
            factor = {1: 4, 4: 10, 10: None}[factor] if self.tried < MOST_LISTS else None
            if factor is not None:
                solution = finer_solution(numeric, solution, side, factor) or solution
        return None

    def _segments_shortened(self, solution, extremal):
        """Shorten the segments, once, if an extremal is worse than its solution; return whether."""
        sign = -1 if self.numeric.problem.maximise else 1
        worse = sign * extremal.cost > solution.cost + WORSE * abs(solution.cost)
        if not worse or self.longest_growth == SHORT:
            return False
        self.longest_growth = SHORT
        return True

    def _first_certified(self, solution, duration):
        """Return the first extremal that holds, with the arcs that a solution may have, or None."""
        for arcs in candidate_structures(self.numeric, solution):
            if self.tried == MOST_LISTS:
                break
            self.tried += 1
            names = ", ".join(arc_name(arc.kinds) for arc in arcs)
            log = current_log()
            log.show("arcs", f"list {self.tried} of arcs: {names}")
            try:
                extremal = self._extremal(solution, arcs, duration)
                reason = _certificate_failure(extremal)
            except WrongStructure as error:
                reason = error
            log.note("arcs", f"{names}: {reason or 'an extremal'}")
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
        bound = ""
        if self.tried == MOST_LISTS:
            bound = f" ({_count(MOST_LISTS, 'list')} of arcs, the most that are tried)"
        advice = "Give a guess" if self.numeric.path_orders else "Give the structure, or a guess"
        return WrongStructure(
            f"the arcs that the discrete solution shows could not be joined to an extremal{bound}: "
            + "; ".join(dict.fromkeys(map(str, self.reasons)))
            + f". {advice}; look at the discrete cost {cost:.6g} to see whether an optimal process "
            "exists."
        )


def _count(number, noun):
    return f"{number} {noun}{'s' * (number != 1)}"


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


def _solution_beside_saddle(numeric, extremal, duration, side):
    """Return a discrete solution of lower cost than an extremal that is a saddle, or None."""
    # Its variations keep to the inequalities that are active at the end.
    process = process_of_extremal(extremal._numeric, extremal, duration)
    solution = DirectSolution(
        np.concatenate([[0.0], np.cumsum(process.widths)]),
        process.states,
        process.costates,
        process.controls,
        -extremal.cost if extremal.problem.maximise else extremal.cost,
    )
    variation = second_variation(extremal._numeric, process)
    return escape_saddle(numeric, solution, variation, side) if variation.sign < 0 else None


def _description(problem):
    theorem = sufficiency_theorem(problem)
    normal = " with lambda_0 > 0" if theorem and theorem[1] else ""
    known = [f"every extremal{normal} is optimal ({theorem[0]})"] if theorem else []
    orders = [str(len(constraint_derivatives(problem, g)) - 1) for g in problem.constraints]
    known += [f"the orders of the path constraints are {', '.join(orders)}"] if orders else []
    return "; ".join(known)


SEARCH = Method(
    "search and multiple shooting",
    "Discrete solutions from several guesses, their arcs, and Newton's method for the boundary value "
    "problem over these arcs; the certificate decides.",
    "Bock and Plitt 1984; trajlib.pontryagin.indirect.arc_search",
    (FINITE_TIME,),
    search_extremal,
    _description,
)
