"""What becomes of answers in other units, by the name of the check."""

import inspect

import sympy as sp
from rescaling import (
    NoRule,
    Rescaled,
    RescaledField,
    RescaledFunctional,
    RescaledQuadratic,
    RescaledSynthesis,
)

from workbook import checks
from workbook.checks.references.singular_arcs import singular_arcs
from workbook.systems import Quadratic


def rescaled(name, answer, data, options, units):
    """Return an answer and the data of the check `name` in other units.

    Raises
    ------
    NoRule
        If no rule is known for the check, or for this form of answer.
    """
    if name not in RULES:
        raise NoRule(name)
    bound = inspect.signature(getattr(checks, name)).bind(answer, *data, **options)
    bound.apply_defaults()
    arguments = dict(list(bound.arguments.items())[1:])
    record = Rescaled
    if isinstance(arguments.get("problem"), Quadratic) or "process" in arguments:
        record = RescaledQuadratic
    elif "field" in arguments:
        record = RescaledField
    elif "system" in arguments:
        record = RescaledSynthesis
    elif "functional" in arguments:
        record = RescaledFunctional
    new = record(arguments, units)
    return RULES[name](new, answer, new.arguments), new.arguments


def _times(factor):
    """Return the rule of an answer that is multiplied by a factor, or by one for each entry."""
    return lambda new, answer, arguments: new.value(answer, factor(new))


def _control(new, answer, arguments):
    if isinstance(answer, (list, tuple)):  # arcs: [value, until]
        return [new.value(list(arc), [new.of_control, new.time]) for arc in answer]
    return new.value(answer, new.of_control)


def _several(factors):
    """Return the rule of an answer with one entry for each state; of one alone, no list."""

    def rule(new, answer, arguments):
        several = isinstance(answer, (list, tuple, sp.MatrixBase))
        return new.value(answer, factors(new) if several else factors(new)[0])

    return rule


def _curve(new, answer, arguments):
    ((variable, _),) = arguments["domain"].items()
    (other,) = set(new.state) - {variable}
    return new.value(answer, new.factors[other])


def _arc(new, answer, arguments):
    arguments["value"] = new.value(arguments["value"], new.factors[arguments["control"]])
    return new.value(answer, new.time)


def _gain(new, answer, arguments):
    return new.value(answer, 1 / new.length)


def _maximum(new, answer, arguments):
    if isinstance(answer, (list, tuple)):
        return new.value(answer, [new.factors[u] for u in new.control])
    return new.value(answer, new.of_control)


def _radius(new, answer, arguments):
    first, second = new.of_state
    if first != second:
        raise NoRule("a circle in states of different units")
    return new.value(answer, first)


def _determinants(new):
    first, second = new.of_state
    return [first * second / new.time] * 2


def _slopes(new):
    first, second = new.of_state
    return second / first


def _matrix(new, answer, arguments):
    if isinstance(answer, list):  # of matrices
        return [_matrix(new, matrix, arguments) for matrix in answer]
    factors = new.of_state
    return new.value(answer, [f / g / new.time for f in factors for g in factors])


def _singular(new, answer, arguments):
    return new.value(answer, new.factors[arguments["control"] or new.control[0]])


def _kelley(new, answer, arguments):
    control = arguments["control"] or new.control[0]
    order = singular_arcs(arguments["problem"], control, tuple(arguments["costates"])).order
    return new.value(answer, new.cost / new.factors[control] ** 2 / new.time ** (2 * order + 1))


UNCHANGED, TIME = _times(lambda new: 1), _times(lambda new: new.time)
COST, CONTROL = _times(lambda new: new.cost), _times(lambda new: new.of_control)
RATE = _times(lambda new: 1 / new.time)
RATE_OF_COST = _times(lambda new: new.cost / new.time)
COSTATES = _several(lambda new: [new.cost / f for f in new.of_state])

RULES = {
    # processes
    "optimal_control": _control,
    "extremal_control": _control,
    "optimal_motion": _several(lambda new: new.of_state),
    "motion_under_law": _several(lambda new: new.of_state),
    "optimal_costate": COSTATES,
    "optimal_law": CONTROL,
    "optimal_cost": lambda new, answer, _: _cost(new, answer),
    "optimal_duration": TIME,
    "optimal_range": UNCHANGED,
    "initial_arc_duration": _arc,
    "arc_transition_curve": _curve,
    "final_value_under_law": UNCHANGED,
    "duration_equation": UNCHANGED,
    # the maximum principle
    "pontryagin_function": RATE_OF_COST,
    "maximised_hamiltonian": RATE_OF_COST,
    "adjoint_equations": _several(lambda new: [new.cost / f / new.time for f in new.of_state]),
    "transversality": UNCHANGED,
    "maximising_control": _maximum,
    "control_equation": _times(lambda new: new.of_control / new.time),
    "switching_function": RATE_OF_COST,
    "switching_rate": _times(lambda new: new.cost / new.of_control / new.time**2),
    "singular_control": _singular,
    "singular_surface": UNCHANGED,
    "singular_costates": COSTATES,
    "singular_order": UNCHANGED,
    "kelley_expression": _kelley,
    "kelley_holds": UNCHANGED,
    # transfers in least time
    "optimal_switching": _times(lambda new: new.cost / new.time / new.of_control),
    "isochrone_radius": _radius,
    "switching_interval": TIME,
    "switching_count": UNCHANGED,
    "transferable_initial_states": UNCHANGED,
    "reachable_in_time": UNCHANGED,
    "meeting_time": TIME,
    "least_rate": RATE,
    # syntheses in the plane
    "time_optimal_law": CONTROL,
    "minimal_time": TIME,
    "reachable_initial_states": UNCHANGED,
    "reached_target_points": UNCHANGED,
    "minimal_time_continuous": UNCHANGED,
    "switching_curve": _curve,
    "switching_points": _several(lambda new: new.of_state),
    "switching_curve_crossing": _several(_determinants),
    "other_extremal_exists": UNCHANGED,
    "other_extremal_time": TIME,
    # the calculus of variations
    "extremum_motion": _times(lambda new: new.motion),
    "extremum_value": lambda new, answer, _: _cost(new, answer),
    "extremum_exists": UNCHANGED,
    "stationary_duration": TIME,
    # quadratic costs
    "optimal_gain": _gain,
    "optimal_eigenvalues": RATE,
    "least_quadratic_cost": COST,
    "optimal_limit_state": _times(lambda new: new.length),
    "cost_matrix": _times(lambda new: new.cost / new.length**2),
    "cost_riccati_equation": _times(lambda new: new.cost / new.length**2 / new.time),
    # control by measurements
    "steady_covariance": _times(lambda new: new.length**2),
    "steady_gain": RATE,
    "steady_cost": RATE_OF_COST,
    "controller_equations": _times(lambda new: new.length / new.time),
    # phase planes
    "first_integral": UNCHANGED,
    "equilibria": UNCHANGED,
    "equilibrium_type": UNCHANGED,
    "equilibrium_stability": UNCHANGED,
    "equilibrium_linearisation": _matrix,
    "saddle_slopes": _times(_slopes),
}


def _cost(new, answer):
    """Return the cost in other units, with the constant that is added to it."""
    if new.constant and sp.sympify(answer).has(sp.Float):
        raise NoRule("to three digits, a decimal plus 1000 is another number")
    return new.value(answer, new.cost) + new.constant
