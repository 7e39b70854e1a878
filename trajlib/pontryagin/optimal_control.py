"""The public class of optimal control problems: a statement with the methods that act on it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from trajlib.pontryagin.problem.derivation import Conditions, conditions
from trajlib.pontryagin.problem.presentation import problem_markdown
from trajlib.pontryagin.problem.statement import Statement

if TYPE_CHECKING:
    import numpy as np

    from trajlib.pontryagin.direct.process import DirectProcess
    from trajlib.pontryagin.indirect.explanation import Explanation
    from trajlib.pontryagin.indirect.extremal import Extremal


class Problem(Statement):
    """An optimal control problem in SymPy.

    Parameters
    ----------
    dynamics : dict
        {state: right-hand side}, in the order in which the states are to be counted.
    controls : dict
        {control: (lower, upper)}; the bounds are numbers or expressions in parameters and states,
        None or oo for no bound.
    initial : dict
        {state: value at t = 0}, None for a state that is free at t = 0.
    terminal : list of sympy.Expr, list of sympy.Equality or dict, optional
        Expressions that vanish at the final time, equations, inequalities such as x >= 1, or
        {state: value}; none for a free terminal state.
    running, final : sympy.Expr, optional
        f_0(state, control) and phi_0(state at the final time). If neither is given, the cost is the
        time; if one is given, the other is zero.
    duration : float or tuple, optional
        None for a free final time, a number for a fixed one, (shortest, longest) for one between
        bounds, oo for the infinite horizon of a linear plant with a quadratic cost.
    maximise : bool, optional
        Whether the cost is to be as large as possible.
    first_return : bool, optional
        Whether the process ends when the trajectory first meets the target at some t > 0; for an
        initial state on the target, and for costs that would gain from passing through it. Needs
        exactly one terminal equation.
    path : list of sympy inequalities, optional
        Constraints on the state along the path, such as [v <= 1, x**2 + y**2 >= 1], and bounds of a
        control such as u <= x/4; also those that can be solved for it, as u**2 + v**2 <= 1. A
        constraint that holds at all times if it holds at the end, as on a parameter k' = 0, becomes
        a terminal inequality.
    terminal_inequalities : list of sympy inequalities, optional
        Those at the final time; inequalities among `terminal` are added to them.
    time : sympy.Symbol, optional
        The time since the start, where dynamics, cost, constraints or ends depend on it. It is then
        the last state, with the rate 1; `terminal` may set it equal to a state with rate 0, which
        is the final time wherever that enters.

    Raises
    ------
    TypeError, ValueError
        If an argument is not of this form; the message begins with the argument's name.

    Notes
    -----
    All other symbols are parameters; `subs` gives them values. Units are the user's: time in that
    of the dynamics. Source: (5.1) - (5.3) of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> x1, x2, u, a = sp.symbols("x1 x2 u a")
    >>> transfer = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: a, x2: 0}, terminal=[x1, x2])
    >>> transfer.running, transfer.parameters
    (1, (a,))
    >>> round(transfer.subs({a: 1}).solve().duration, 9)
    2.0

    A speed limit; its multiplier is that of the costate's equation on the boundary arc.

    >>> limited = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 0, x2: 0}, {x1: 3, x2: 0}, path=[x2 <= 1])
    >>> limited.conditions().path[0].order
    1
    >>> limited.solve()
    Extremal(cost=4, duration=4, arcs: u+ [0, 1], boundary [1, 3], u- [3, 4])

    An infinite horizon; the Riccati equation gives J = 1 + sqrt(2).

    >>> Problem({x1: x1 + u}, {u: None}, {x1: 1}, running=x1**2 + u**2, duration=sp.oo).solve()
    Extremal(cost=2.41421356237, duration=inf, arcs: interior [0, inf])

    A force that grows in time: full speed gives x = t + t**2/2.

    >>> t = sp.Symbol("t")
    >>> round(Problem({x1: u + t}, {u: (-1, 1)}, {x1: 0}, {x1: 4}, time=t).solve().duration, 9)
    2.0
    """

    def conditions(self) -> Conditions:
        """Derive the conditions of the maximum principle in symbols.

        Returns
        -------
        Conditions
            Shows itself typeset in a notebook; derived once for a problem.

        Raises
        ------
        ValueError
            If the problem already uses one of the names psi1, ..., psin, lambda0, lambda1, ....
        """
        return conditions(self)

    def explain(self) -> "Explanation":
        """Return which steps `solve` takes for the problem, in which order, and why.

        Returns
        -------
        Explanation
            Reformulations, refusals and methods, each with the hypotheses that hold or the first
            one that does not. Shows itself as text and in a notebook. Nothing is solved.

        Raises
        ------
        ValueError
            If a parameter has no value.

        Examples
        --------
        >>> import sympy as sp
        >>> x, u = sp.symbols("x u")
        >>> frugal = Problem({x: u}, {u: (-1, 1)}, {x: 0}, {x: 1}, running=sp.Abs(u), duration=2)
        >>> print(frugal.explain().applied[0].detail)
        u = max(u, 0) - max(-u, 0)
        """
        # The solvers load with it.
        from trajlib.pontryagin.indirect.explanation import explain

        return explain(self)

    def solve(
        self,
        structure: Sequence | None = None,
        guess: "Extremal | DirectProcess | dict | None" = None,
        starts: int | None = None,
        time_limit: float | None = None,
        progress: bool | None = None,
    ) -> "Extremal":
        """Find an extremal of the problem with its arcs and switching times.

        Parameters
        ----------
        structure : list, optional
            The arcs in order, "u-", "u+", "interior", "singular" or "zero" (tuples of them for
            several controls); found if left out, and not to be given with path constraints.
        guess : Extremal, DirectProcess or dict, optional
            Where the search begins: an extremal of a similar problem, a direct solution, or values for "duration",
            states and controls.
        starts : int, optional
            How many starting guesses to try; by default until three in a row agree.
        time_limit : float, optional
            Seconds after which any step ends; `NotConverged` then has what was found.
        progress : bool, optional
            Whether a line shows what is tried; by default after one second where a person watches.

        Returns
        -------
        Extremal
            Satisfies the conditions of the maximum principle to about 1e-12.

        Raises
        ------
        PontryaginError
            If there is no such extremal or none was found; the class of the error names the reason.

        See Also
        --------
        trajlib.pontryagin.indirect.solve.solve : All arguments, errors and what is proved.
        """
        # CasADi loads with it, which takes half a second.
        from trajlib.pontryagin.indirect.solve import solve

        return solve(self, structure, guess, starts, time_limit, progress)

    def solve_direct(
        self,
        grid: "int | Sequence[float] | np.ndarray" = 80,
        scheme: str = "runge-kutta",
        tolerance: float = 1e-9,
        guess: "DirectProcess | Extremal | dict | None" = None,
        time_limit: float | None = None,
    ) -> "DirectProcess":
        """Find a process by a nonlinear programme on a grid (direct transcription).

        Parameters
        ----------
        grid : int or array_like
            Number of equal intervals, or the nodes as increasing fractions from 0 to 1.
        scheme : str
            "runge-kutta" (constant controls), "trapezoidal" (linear) or "hermite-simpson"
            (quadratic).
        tolerance : float
            Of IPOPT, in natural units.
        guess : DirectProcess, Extremal or dict, optional
            An earlier solution on any grid, or values as for `solve`.
        time_limit : float, optional
            Seconds after which any step ends; `NotConverged` says so.

        Returns
        -------
        DirectProcess
            States, controls, costates estimated from the multipliers, errors on a finer grid; a
            guess for `solve`.

        Raises
        ------
        PontryaginError
            If no process is found.

        See Also
        --------
        trajlib.pontryagin.indirect.solve_direct.solve_direct : The schemes, and all errors.
        """
        # CasADi loads with it.
        from trajlib.pontryagin.indirect.solve_direct import solve_direct

        return solve_direct(self, grid, scheme, tolerance, guess, time_limit)

    def _repr_markdown_(self):
        return problem_markdown(self)
