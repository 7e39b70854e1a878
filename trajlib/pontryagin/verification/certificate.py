"""Certificate of an extremal, from the trajectory alone (Theorem 5.1 of the problem book).

State, costate and control are functions of time here, wherever they come from. On every arc the
differential equations are tested in integral form, y(b) - y(a) against the integral of the
right-hand side over panels [a, b] by Gaussian quadrature, so that nothing is shared with a solver:
neither its grid, nor its integrator, nor its derivatives (SymPy and NumPy here). All residuals are
relative: to 1 + the largest state, costate or Hamiltonian that occurs, in units in which these are
about 1 in size (`problem.scaling`), so that they do not depend on the user's units.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields

import numpy as np

from trajlib.pontryagin.problem.scaling import units_of_process
from trajlib.pontryagin.problem.state_bounds import with_constant_bounds
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.verification.constraint_residuals import ConstraintResiduals
from trajlib.pontryagin.verification.optimality import Optimality
from trajlib.pontryagin.verification.residuals import TrajectoryResiduals, sampled

# Panels on an arc, more and more until the integrals agree with the trajectory to within
# INTEGRATED: a rapid turn needs many. A remaining defect is one of the trajectory, not of the
# quadrature.
PANELS, INTEGRATED = (12, 48, 192), 1e-11
# Times at which the sizes of the values are taken.
SAMPLES = 65


@dataclass(frozen=True)
class Certificate:
    """Residuals of the conditions of the maximum principle, all zero for an exact extremal.

    The conditions are necessary. With path constraints they include the signs of the multipliers,
    complementarity and the jumps of the costate, but no condition of second order: that the extremal
    is a local minimum is not tested where it touches a boundary (see `optimality`).

    Attributes
    ----------
    dynamics, adjoint : float
        Of y' = f and psi' = -dH/dy, jumps at the switchings included.
    initial, terminal : float
        Of the conditions at both ends, psi_i(0) = 0 for free initial states included.
    transversality : float
        Distance of psi(t_k) + lambda_0 grad phi_0 from the normals of the target.
    bounds : float
        Largest violation of the bounds on the controls.
    maximum : float
        Largest amount by which H is below its maximum over the admissible controls.
    drift : float
        Largest minus smallest value of H along the trajectory.
    stationarity : float
        max |H| where it is to vanish (free final time), else 0.
    end : float
        |max H| at t_k where it is to vanish: whether the terminal conditions agree with the maximum
        condition.
    multipliers : float
        By how much lambda_0 >= 0 or (lambda_0, psi) != 0 fails.
    passage : float
        How far the trajectory passes the target before the final time (with first_return), else 0.
    kelley : float or None
        Largest (-1)^q b on the singular arcs, not positive for a minimum; None without such arcs.
    path : float
        Largest violation of the path constraints, also between grid points; 0 without them.
    jumps : float
        Largest part of a jump of the costate that is no multiple of the gradient of a path
        constraint that is active there.
    sign : float
        By how much the multipliers of the path constraints fail to be nonnegative. They vanish
        where a constraint is inactive: `adjoint` and `jumps` would be positive otherwise.
    constrained : bool
        Whether the problem has inequalities along the path or at the end.
    optimality : Optimality or None
        What is known beyond these necessary conditions; None where the search is not known.
    """

    dynamics: float
    adjoint: float
    initial: float
    terminal: float
    transversality: float
    bounds: float
    maximum: float
    drift: float
    stationarity: float
    end: float
    multipliers: float
    passage: float
    kelley: float | None
    path: float = 0.0
    jumps: float = 0.0
    sign: float = 0.0
    constrained: bool = False
    optimality: Optimality | None = None

    @property
    def worst(self) -> float:
        """The largest of the residuals (Kelley's sign apart)."""
        return max(getattr(self, name) for name in _RESIDUALS)

    def failures(self, tolerance: float = 1e-9) -> list[str]:
        """Return the names of the conditions that do not hold to within a tolerance.

        Parameters
        ----------
        tolerance : float, optional
            Largest residual that counts as zero.

        Returns
        -------
        list of str
            Names of attributes, empty if all conditions hold.
        """
        names = [name for name in _RESIDUALS if not getattr(self, name) <= tolerance]
        return names + ["kelley"] * (self.kelley is not None and not self.kelley <= tolerance)

    def holds(self, tolerance: float = 1e-9) -> bool:
        """Check whether all conditions hold to within a tolerance.

        Parameters
        ----------
        tolerance : float, optional
            Largest residual that counts as zero.

        Returns
        -------
        bool
            Whether `failures` is empty.
        """
        return not self.failures(tolerance)

    def _repr_markdown_(self):
        words = {
            "dynamics": r"$\dot y = f$",
            "adjoint": r"$\dot\psi = -\partial H/\partial y$",
            "initial": "initial conditions",
            "terminal": "terminal conditions",
            "transversality": "transversality",
            "bounds": "bounds of the controls",
            "maximum": r"$\max_u H - H$",
            "drift": "drift of $H$",
            "stationarity": r"$\vert H\vert$ (free time)",
            "end": r"$\vert\max_u H\vert$ at $t_k$",
            "multipliers": r"$\lambda_0 \ge 0$, $(\lambda_0, \psi) \ne 0$",
            "passage": "target met before the end",
        }
        if self.constrained:
            words |= {
                "path": "path constraints",
                "jumps": r"jumps of $\psi$ along $\partial g/\partial y$",
                "sign": r"$\eta \ge 0$, $\nu \ge 0$",
            }
        rows = "".join(f"| {word} | {getattr(self, name):.1e} |\n" for name, word in words.items())
        if self.kelley is not None:
            rows += f"| Kelley: $(-1)^q b \\le 0$ | {self.kelley:.3g} |\n"
        statement = f"\n{str(self.optimality).capitalize()}.\n" if self.optimality else ""
        return f"| condition | residual |\n|---|---|\n{rows}{statement}"


_RESIDUALS = [
    f.name for f in fields(Certificate) if f.name not in ("kelley", "constrained", "optimality")
]


def certify(
    problem: Statement,
    state: Callable,
    costate: Callable,
    control: Callable,
    duration: float,
    switching_times: Sequence[float] = (),
    multiplier: float = 1.0,
    arcs: Sequence | None = None,
    points: int | None = None,
) -> Certificate:
    """Return the residuals of all conditions for a trajectory given as functions of time.

    Parameters
    ----------
    problem : Problem
        Without parameters.
    state, costate, control : callable
        Functions of an array of N times with values of the shapes (n, N), (n, N), (k, N).
    duration : float
        The final time t_k.
    switching_times : list of float, optional
        Times at which the control jumps or changes its law.
    multiplier : float, optional
        lambda_0.
    arcs : list of str or tuple, optional
        The kinds of the arcs as in `Extremal.arcs`, for Kelley's sign.
    points : int, optional
        Number of panels on an arc, with twelve points each; by default 12, more where needed.

    Returns
    -------
    Certificate
        All residuals, relative.

    Raises
    ------
    ValueError
        If parameters have no value, if switching times are not increasing inside (0, duration), or
        if the functions do not return arrays of these shapes.

    Notes
    -----
    Source: (5.4) - (5.7) and Theorem 5.2 of the problem book.

    Examples
    --------
    >>> import numpy as np, sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x, u = sp.symbols("x u")
    >>> fall = Problem({x: u}, {u: (-1, 1)}, {x: 2}, [x])
    >>> evidence = certify(fall, lambda t: [2 - t], lambda t: [0*t - 1], lambda t: [0*t - 1], duration=2)
    >>> evidence.holds()
    True
    >>> certify(fall, lambda t: [2 - t], lambda t: [0*t + 1], lambda t: [0*t - 1], duration=2).failures()
    ['maximum', 'stationarity']
    """
    problem, (state, costate, control), duration, switching_times = _in_own_units(
        problem, (state, costate, control), duration, switching_times, multiplier
    )
    for panels in PANELS if points is None else [points]:
        values = TrajectoryResiduals(
            problem, state, costate, control, duration, switching_times, multiplier, panels
        )
        dynamics, adjoint = values.defects()
        constraints = ConstraintResiduals(values, state, costate) if problem.constrained else None
        if constraints:
            adjoint = constraints.adjoint_defect()
        if max(dynamics, adjoint) <= INTEGRATED:
            break
    H = values.hamiltonian(values.y, values.psi, values.u)
    excess, end = values.excess()
    scale_H = (
        1
        + np.max(np.abs(values.psi) * np.abs(values.rates))
        + abs(multiplier) * np.max(np.abs(values.densities))
    )
    free = problem.duration is None
    size = abs(multiplier) + np.max(np.abs(values.psi))
    return Certificate(
        dynamics=dynamics,
        adjoint=adjoint,
        initial=values.initial(),
        terminal=max(values.terminal(), constraints.end_violation() if constraints else 0.0),
        transversality=float((constraints or values).transversality()),
        bounds=values.bound_violation(),
        maximum=float(np.max(excess, initial=0.0) / scale_H),
        drift=float(np.ptp(H) / scale_H),
        stationarity=float(np.max(np.abs(H)) / scale_H) if free else 0.0,
        end=float(abs(end) / scale_H) if free else 0.0,
        multipliers=float(max(-multiplier, 0.0) if size > 1e-9 else 1.0),
        passage=values.passage(),
        kelley=values.kelley(arcs),
        path=constraints.violation() if constraints else 0.0,
        jumps=constraints.jump_defect() if constraints else 0.0,
        sign=constraints.sign() if constraints else 0.0,
        constrained=constraints is not None,
    )


def _inner_control(bounds, state, control):
    """Return the controls between constant bounds as a function of time."""

    def inner(t):
        offset, factor = bounds.values(np.asarray(state(t), dtype=float))
        return (np.asarray(control(t), dtype=float) - offset) / factor

    return inner


def _in_own_units(problem, functions, duration, switching_times, multiplier):
    """Return the same arguments in units in which the values of the process are about 1.

    `functions`: state, costate and control.
    """
    if problem.parameters:
        raise ValueError(f"certify: no value for {', '.join(map(str, problem.parameters))}")
    bounds = with_constant_bounds(problem)
    if bounds is not None:
        state, costate, control = functions
        problem, functions = (
            bounds.problem,
            (state, costate, _inner_control(bounds, state, control)),
        )
    times, n = np.linspace(0, float(duration), SAMPLES), len(problem.state)
    sizes = (n, n, len(problem.control))
    values = (
        sampled(function, times, rows, name)
        for function, rows, name in zip(functions, sizes, ("state", "costate", "control"))
    )
    scaling = units_of_process(problem, *values, float(duration), float(multiplier))
    if scaling is None:
        return problem, functions, duration, switching_times
    time = float(scaling.time)

    def scaled(function, units):
        units = np.array([[float(unit)] for unit in units])
        return lambda t: np.asarray(function(np.minimum(time * t, duration)), float) / units

    units = (scaling.states, [scaling.cost / s for s in scaling.states], scaling.controls)
    return (
        scaling.problem,
        tuple(map(scaled, functions, units)),
        duration / time,
        [t / time for t in switching_times],
    )
