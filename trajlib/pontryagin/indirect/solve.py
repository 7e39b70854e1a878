"""From a problem to an extremal: reformulate, refuse what has no solution, solve, restore.

The steps and their order are the lists of `steps`, which `explain` prints. Where no method gives the
extremal by linear equations, the problem is solved in natural units by a search for discrete
solutions and multiple shooting (`arc_search`).
"""

from collections.abc import Sequence

from trajlib.pontryagin.direct.guesses import read_guess
from trajlib.pontryagin.direct.process import DirectProcess
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.indirect.steps import (
    BEFORE_SEARCH,
    LINEAR_QUADRATIC,
    NATURAL_UNITS,
    POLYNOMIAL_END,
    REFORMULATIONS,
    RICCATI,
    SEARCH,
)
from trajlib.pontryagin.indirect.structure import read_structure
from trajlib.pontryagin.problem.errors import PontryaginError
from trajlib.pontryagin.problem.log import current_log, logged
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.problem.time_limit import in_time


def solve(
    problem: Statement,
    structure: Sequence | None = None,
    guess: Extremal | DirectProcess | dict | None = None,
    starts: int | None = None,
    time_limit: float | None = None,
    progress: bool | None = None,
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
    guess : Extremal, DirectProcess or dict, optional
        An extremal of a similar problem, a direct solution (`solve_direct`), or {"duration":
        number, state or control: number, list of values at equal steps, or function of time}, any
        of them.
    starts : int, optional
        How many starting guesses to try, random ones after those that follow from the statement; by
        default until three in a row lead to one process. Not used where a guess is given or where a
        theorem makes every extremal optimal.
    time_limit : float, optional
        Seconds after which any step ends. After half of them no further starting guess is tried if
        a process was found.
    progress : bool, optional
        Whether one line shows the starting guesses and lists of arcs tried, Newton's residual and
        the time while it computes. By default after one second in a terminal and in a notebook in
        which a person works. `Extremal.log` has the same as records, and so has the error.

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
        If no process was found, which proves nothing, or the time is over; the message has what was
        found by then.

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
    _check_effort(starts, progress)
    with logged(progress) as log:
        try:
            return in_time(time_limit, _solve, problem, structure, guess, starts)
        except PontryaginError as error:
            error.log = log
            raise


def _solve(problem, structure, guess, starts):
    """Follow the steps in their order."""
    note = current_log().note
    if RICCATI.applies(problem):
        note("step", RICCATI.name)
        if structure is not None or guess is not None:
            raise ValueError("structure, guess: an infinite horizon needs none; leave them out")
        return RICCATI.solve(problem)
    for step in REFORMULATIONS:
        if step.applies(problem):
            note("step", step.name)
            other = step.reformulate(problem)
            arguments = step.structure(other, structure), step.guess(other, guess), starts
            return step.restore(other, _solve(other.problem, *arguments))
    numeric = NumericProblem(problem)
    if problem.path and structure is not None:
        raise ValueError("structure: with path constraints the arcs are found; leave it out")
    kinds = None if structure is None else read_structure(numeric, structure)
    start = read_guess(numeric, guess)
    note("step", "refusals before the search")
    for refusal in BEFORE_SEARCH:
        refusal.check(numeric)
    extremal = LINEAR_QUADRATIC.solve(numeric) if kinds is None else None
    if extremal is None and kinds is None and guess is None and POLYNOMIAL_END.applies(problem):
        extremal = POLYNOMIAL_END.solve(problem)
    # Both leave inequalities aside: the extremal is valid where it satisfies them.
    if extremal is not None and (not problem.constrained or extremal.certificate().holds()):
        note("step", "an extremal by linear equations")
        return extremal
    note("step", SEARCH.name)
    if not NATURAL_UNITS.applies(problem):
        return SEARCH.solve(numeric, kinds, start, starts)
    scaling = NATURAL_UNITS.reformulate(problem)
    numeric, start = NumericProblem(scaling.problem, scaling), NATURAL_UNITS.guess(scaling, start)
    return NATURAL_UNITS.restore(scaling, SEARCH.solve(numeric, kinds, start, starts))


def _check_effort(starts, progress):
    """Raise TypeError or ValueError if `starts` is no count, or `progress` no truth value."""
    if not isinstance(progress, (bool, type(None))):
        raise TypeError(f"progress: expected True, False or None, got {progress!r}")
    if starts is not None and (isinstance(starts, bool) or not isinstance(starts, int)):
        raise TypeError(f"starts: expected a whole number, got {starts!r}")
    if starts is not None and starts < 1:
        raise ValueError(f"starts: expected at least one, got {starts}")
