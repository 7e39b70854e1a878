"""Properties of a statement on which several steps of `solve` depend."""

import sympy as sp

from trajlib.pontryagin.problem.angle_relaxation import relax_angles
from trajlib.pontryagin.problem.derivation import conditions
from trajlib.pontryagin.problem.steps import Hypothesis


def constant_slopes(expressions, symbols) -> bool:
    """Check whether expressions are linear in all of the symbols."""
    return not sp.Matrix(expressions).jacobian(list(symbols)).free_symbols


def _linear_plant(problem):
    return constant_slopes(problem.field, (*problem.state, *problem.control))


def _linear_target(problem):
    return bool(problem.terminal) and constant_slopes(problem.terminal, problem.state)


def _relaxed_plant_is_linear(problem):
    relaxed = relax_angles(problem)
    return relaxed is not None and _linear_plant(relaxed.problem)


FREE_TIME = Hypothesis("the final time is free", lambda p: p.free_time)
GIVEN_TIME = Hypothesis("the duration is given", lambda p: not p.free_time)
FINITE_TIME = Hypothesis("the horizon is finite", lambda p: p.duration != sp.oo)
GIVEN_START = Hypothesis("all states are given at t = 0", lambda p: None not in p.initial.values())
TARGET = Hypothesis("there are terminal equations", lambda p: bool(p.terminal))
LINEAR_TARGET = Hypothesis("the terminal equations are linear", _linear_target)
LINEAR_PLANT = Hypothesis("the plant is linear", _linear_plant)
RELAXABLE = Hypothesis(
    "angles, if any, act linearly by their sines and cosines",
    lambda p: relax_angles(p) is not None,
)
RELAXED_LINEAR_PLANT = Hypothesis(
    "the plant is linear, also in sines and cosines of its angles", _relaxed_plant_is_linear
)
NO_FIRST_RETURN = Hypothesis("no first return is asked for", lambda p: not p.first_return)
PATH = Hypothesis("there are path constraints", lambda p: bool(p.path))
NO_PATH = Hypothesis("there are no path constraints", lambda p: not p.path)
CONSTRAINED = Hypothesis("there are inequalities for the states", lambda p: p.constrained)
UNCONSTRAINED = Hypothesis("there are no inequalities for the states", lambda p: not p.constrained)
UNBOUNDED_CONTROLS = Hypothesis(
    "no control has a bound",
    lambda p: all(pair == (-sp.oo, sp.oo) for pair in p.controls.values()),
)
COST_OTHER_THAN_TIME = Hypothesis("the cost is not the time alone", lambda p: not p.time_optimal)
NONLINEAR_HAMILTONIAN = Hypothesis(
    "H is not linear in some control",
    lambda p: any(u not in conditions(p).switching for u in p.control),
)
LINEAR_BETWEEN_BOUNDS = Hypothesis(
    "H is linear in a control between two bounds",
    lambda p: any(
        u in conditions(p).switching and low.is_finite and high.is_finite
        for u, (low, high) in p.controls.items()
    ),
)
