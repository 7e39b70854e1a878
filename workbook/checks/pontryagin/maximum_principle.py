"""Pontryagin function, adjoint equations, switching function and maximising control.

`problem` is a `pontryagin.Problem`; `costates` are the symbols psi_1, ..., psi_n in the order of
its states. The cost has the multiplier lambda_0 = 1: H = psi^T f - f_0, or + f_0 if the cost is
maximised. Each answer is judged by its values at sample states, costates, controls
and parameters; `domain` gives intervals for these where their symbols may not take all values.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression, Expressions
from workbook.checks.contract.direction import directed
from workbook.checks.contract.tolerance import EXACT, agree, in_decimals
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.pontryagin.sample_points import (
    RIVALS,
    SAMPLES,
    ZeroSet,
    control_bounds,
    is_in_domain,
    points_near_switching,
    sample_points,
)
from workbook.checks.references.optima.units import sample_units
from workbook.checks.references.singular_arcs import hamiltonian, known_costates, singular_arcs
from workbook.checks.tools.conditions import decide, exactly
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import entry_uncertainties, number_at, uncertainty_at, value_at
from workbook.checks.tools.wording import other_text, rounded_text, values_text

#: Largest distance of compared controls from the claimed one, where it has no bound.
UNBOUNDED = 20.0


@judged(
    Expression("problem.state", "problem.control", "costates", "problem.parameters"),
    problem="pontryagin.Problem with any number of controls, its duration also an interval",
)
def pontryagin_function(claim, problem, costates, domain=None):
    """Check the Pontryagin function H with lambda_0 = 1.

    It is an expression in states, controls, costates and parameters.

    Can decide when the costs and right-hand sides have values at sample states, controls and
    costates, where H is compared.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 4, v: 0}, [x, v])
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> checks.pontryagin_function(p1*v + p2*u - 1, cart, [p1, p2]).status
    'right'
    >>> checks.pontryagin_function(p1*v + p2*u, cart, [p1, p2]).status
    'wrong'
    """
    true = hamiltonian(problem, costates)
    for values in sample_points(problem, costates, domain):
        _require_equal(claim, true, values, "H")
    return f"it is H, tried at {SAMPLES} points"


@judged(
    Expressions(
        "problem.state", "problem.control", "costates", "problem.parameters", length="costates"
    ),
    problem="pontryagin.Problem with any number of controls, its duration also an interval",
)
def adjoint_equations(claims, problem, costates, domain=None):
    """Check the right-hand sides of the adjoint equations with lambda_0 = 1.

    They stand in the order of the states.

    Can decide when the right-hand sides are differentiable at the sample states, where they are
    compared.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 4, v: 0}, [x, v])
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> checks.adjoint_equations([0, -p1], cart, [p1, p2]).status
    'right'
    >>> checks.adjoint_equations([0, p1], cart, [p1, p2]).status
    'wrong'
    """
    H = hamiltonian(problem, costates)
    for psi, y, claim in zip(costates, problem.state, claims):
        for values in sample_points(problem, costates, domain):
            _require_equal(claim, -sp.diff(H, y), values, f"{psi}'")
    return f"they are the adjoint equations at {SAMPLES} points"


@judged(
    Expression("problem.state", "problem.control", "costates", "problem.parameters"),
    problem="pontryagin.Problem with any number of controls, its duration also an interval",
)
def switching_function(claim, problem, costates, control=None, domain=None):
    """Check the switching function dH/du, up to a positive factor.

    Its sign decides on which bound the control lies.

    Can decide when H is linear in the control, at sample states and costates.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 4, v: 0}, [x, v])
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> checks.switching_function(p2, cart, [p1, p2]).status, checks.switching_function(p1, cart, [p1, p2]).status
    ('right', 'wrong')
    """
    control = control or problem.control[0]
    slope = sp.diff(hamiltonian(problem, costates), control)
    for values in sample_points(problem, costates, domain, use_known_costates=True):
        claimed, true = (value_at(e, values, "the switching function") for e in (claim, slope))
        if np.sign(claimed) != np.sign(true):
            raise Wrong(
                f"for {rounded_text(values)}, H {'grows' if true > 0 else 'falls'} with {control}, "
                f"and your function is {claimed:.4g}"
            )
    _require_sign(claim, slope, control, known_costates(problem, costates), domain)
    # Equal signs at random points do not imply common zeros, which are compared too.
    return _require_common_zeros(claim, slope, problem, costates, domain)


@judged(
    Expression("problem.state", "problem.control", "costates", "problem.parameters"),
    problem="pontryagin.Problem with one control, its duration also an interval",
)
def switching_rate(claim, problem, costates, control=None, domain=None):
    """Check the time derivative of dH/du along the trajectories and the adjoint equations.

    Can decide when H is linear in the control and the right-hand sides are differentiable, at
    sample states and costates.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> p1, p2 = sp.symbols("p1 p2", real=True)
    >>> cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 4, v: 0}, [x, v])
    >>> checks.switching_rate(-p1, cart, [p1, p2]).status
    'right'
    >>> checks.switching_rate(p1, cart, [p1, p2]).status
    'wrong'
    """
    first, *_ = singular_arcs(problem, control or problem.control[0], tuple(costates)).derivatives
    H = hamiltonian(problem, costates)
    flow = dict(problem.dynamics) | {psi: -sp.diff(H, y) for psi, y in zip(costates, problem.state)}
    true = sum((sp.diff(first, s) * rate for s, rate in flow.items()), sp.S.Zero)
    for values in sample_points(problem, costates, domain, use_known_costates=True):
        _require_equal(claim, true, values, "the derivative of dH/du")
    return f"it is the derivative of dH/du at {SAMPLES} points"


@judged(problem="pontryagin.Problem with any number of controls, its duration also an interval")
def maximising_control(answer, problem, costates, domain=None):
    """Check the control that maximises H, in states, costates and parameters.

    Of several controls it is a list.

    Can decide when an admissible control maximises H at the sample states and costates, where no
    other may give more.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 4, v: 0}, [x, v])
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> checks.maximising_control(sp.sign(p2), cart, [p1, p2]).status
    'right'
    >>> checks.maximising_control(-sp.sign(p2), cart, [p1, p2]).status
    'wrong'
    """
    symbols = [*problem.state, *costates, *problem.parameters]
    controls = list(problem.control)
    single = len(controls) == 1 and not isinstance(answer, (list, tuple, sp.MatrixBase))
    claims = (
        [coercion.as_expression(answer, symbols)]
        if single
        else coercion.as_expressions(answer, symbols, len(controls))
    )
    H = real_function([*symbols, *controls], [hamiltonian(problem, costates)])
    units = sample_units(problem, costates, domain)
    control_units = [float(units[u]) for u in controls]
    for values in (
        *sample_points(problem, costates, domain, controls=False),
        *points_near_switching(problem, costates, domain),
    ):
        numbers, bounds = [float(values[s]) for s in symbols], control_bounds(problem, values)
        claimed = np.array([value_at(claim, values, str(u)) for claim, u in zip(claims, controls)])
        uncertainties = entry_uncertainties(sp.Matrix(claims), values).ravel()
        for u, unit, value, (low, high), uncertainty in zip(
            controls, control_units, claimed, bounds, uncertainties
        ):
            slack = EXACT * (unit + abs(value)) + uncertainty
            if not low - slack <= value <= high + slack:
                raise Wrong(
                    f"for {rounded_text(values)} your {u} is {value:.4g}, which is not admissible"
                )
        # Decimals leave the control uncertain, and near its maximum H hardly depends on it.
        near_axes = [
            np.clip(value + uncertainty * np.linspace(-1, 1, 21), *pair)
            for value, uncertainty, pair in zip(claimed, uncertainties, bounds)
        ]
        rival_axes = [
            unit * _rivals(value / unit, *np.array(pair) / unit)
            for unit, value, pair in zip(control_units, claimed, bounds)
        ]
        near, rivals = (
            np.array(np.meshgrid(*axes)).reshape(len(controls), -1)
            for axes in (near_axes, rival_axes)
        )
        claimed_values = H(*numbers, *near)[0] if uncertainties.any() else H(*numbers, *claimed)[:1]
        rival_values = H(*numbers, *rivals)[0]
        if not claimed_values.max() >= np.nanmax(rival_values) - 1e-9 * np.ptp(
            rival_values
        ) - 0.01 * np.ptp(claimed_values):
            raise Wrong(
                f"for {rounded_text(values)} your control does not maximise H: it gives H = "
                f"{H(*numbers, *claimed)[0]:.4g}, and another admissible control gives more"
            )
    return f"no admissible control gives a greater H, tried at {SAMPLES} points"


@judged(
    Expression("problem.state", "costates", "problem.parameters"),
    problem="pontryagin.Problem with any number of controls",
)
def maximised_hamiltonian(claim, problem, costates, domain=None):
    """Check the greatest value of H over the admissible controls with lambda_0 = 1.

    The controls enter H linearly.

    Can decide when the controls enter H linearly, at sample states and costates.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> p1, p2 = sp.symbols("p1 p2", real=True)
    >>> cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 4, v: 0}, [x, v])
    >>> checks.maximised_hamiltonian(p1*v + sp.Abs(p2) - 1, cart, [p1, p2]).status
    'right'
    >>> checks.maximised_hamiltonian(p1*v + p2 - 1, cart, [p1, p2]).status
    'wrong'
    """
    H, controls = sp.expand(hamiltonian(problem, costates)), list(problem.control)
    if any(sp.diff(H, u, v) != 0 for u in controls for v in controls):
        raise UnsuitableData("H is not linear in the controls")
    remaining_terms, slopes = H.subs(dict.fromkeys(controls, 0)), [sp.diff(H, u) for u in controls]
    for values in (
        *sample_points(problem, costates, domain, controls=False),
        *points_near_switching(problem, costates, domain),
    ):
        numbers = [float(e.subs(values)) for e in slopes]
        terms = [
            max(slope * low, slope * high)
            for slope, (low, high) in zip(numbers, control_bounds(problem, values))
        ]
        parts = [float(part.subs(values)) for part in sp.Add.make_args(remaining_terms)]
        claimed = value_at(claim, values, "the greatest value of H")
        expected = sum(parts) + sum(terms)
        size = max(map(abs, [*parts, *terms]))
        if not agree(claimed, expected, claim, size, uncertain=uncertainty_at(claim, values)):
            raise Wrong(
                f"for {rounded_text(values)} your expression gives {claimed:.4g}; "
                + directed(
                    "no admissible control gives H so great a value"
                    if claimed > expected
                    else "there are admissible controls that give H a greater value",
                    "that is not the greatest value of H",
                )
            )
    return f"it is the greatest value of H, at {SAMPLES} points"


def _require_equal(claim, true, values, quantity):
    true = sp.expand(true)
    parts = [abs(number_at(part, values)) for part in sp.Add.make_args(true)]
    claimed, expected = value_at(claim, values, quantity), number_at(true, values).real
    if not agree(claimed, expected, claim, max(parts), uncertain=uncertainty_at(claim, values)):
        if true.is_number:  # the true number would be the answer itself
            raise Wrong(f"{quantity} is not {claimed:.4g}, which your expression gives")
        raise Wrong(f"for {rounded_text(values)}, {other_text(quantity, claimed, expected)}")


def _require_sign(claim, slope, control, costate_values, domain):
    """Raise `Wrong` where a function does not have the sign of dH/du, if this can be decided.

    A factor may change its sign where no sample lies. With decimals the zeros are uncertain, and
    nothing is decided.
    """
    if in_decimals(claim):
        return
    claim, slope = claim.subs(costate_values), slope.subs(costate_values)
    symbols = sorted({*claim.free_symbols, *slope.free_symbols}, key=str)
    domain_condition = sp.And(*(domain[s].as_relational(s) for s in symbols if s in (domain or {})))
    for sign, verb, negated_verb in (
        (sp.Gt, "grows", "does not grow"),
        (sp.Lt, "falls", "does not fall"),
    ):
        _, point = decide(sign(claim, 0), symbols, exactly(sign(slope, 0), domain_condition))
        if point:
            values, holds = point
            raise Wrong(
                f"for {values_text(values)}, H {verb if holds else negated_verb} with {control}, and your "
                "function does not have the sign of dH/du"
            )


def _require_common_zeros(claim, slope, problem, costates, domain):
    costate_values = known_costates(problem, costates)
    symbols = [s for s in (*costates, *problem.state) if s not in costate_values]
    units = sample_units(problem, costates, domain)
    claimed_zeros, true_zeros = (
        ZeroSet([e.subs(costate_values)], symbols, [*problem.parameters, *problem.control], units)
        for e in (claim, slope)
    )
    for values in sample_points(problem, costates, domain, use_known_costates=True):
        for zeros, other_zeros in ((claimed_zeros, true_zeros), (true_zeros, claimed_zeros)):
            point = zeros.zero_near({s: v for s, v in values.items() if s not in costate_values})
            if (
                point is not None
                and is_in_domain(point, domain)
                and not other_zeros.distance(point) <= claimed_zeros.uncertainty(point)
            ):
                raise Wrong(
                    f"for {rounded_text(point)} your function "
                    + (
                        "vanishes, and dH/du does not"
                        if zeros is claimed_zeros
                        else "does not vanish, and dH/du does"
                    )
                )
    return "it has the sign of dH/du and vanishes with it"


def _rivals(value, low, high):
    """Return admissible controls to compare with: over the whole interval and around a value."""
    low, high = max(low, value - UNBOUNDED), min(high, value + UNBOUNDED)
    around = (1 + abs(value)) * np.geomspace(1e-4, 0.1, 13)
    sides = np.clip([value - around, value + around], low, high)
    return np.unique([*np.linspace(low, high, RIVALS), *sides.ravel()])
