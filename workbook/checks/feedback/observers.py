"""Observers given by their equations e' = f(e, z, u), judged by the error d = x - e.

Along the motions of x' = Ax + Bu, z = Hx the error has to obey an equation of its own, d' = (A -
LH) d with some L, for all x and u; then its spectrum is judged as that of a gain.

No check here is declared by a reference: any gain is right, and an answer has several expressions.
"""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expressions
from workbook.checks.contract.tolerance import EXACT
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.feedback.loops import Requirement, in_fractions
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.samples import (
    general_values,
    in_every_case,
    sample_values,
    signed_values,
)
from workbook.checks.tools.values import entry_uncertainties, matrix_at, number_at
from workbook.checks.tools.wording import number_text, where_text


@judged(
    Expressions(
        "estimates", "outputs", "controls", "parameters", length=lambda data: len(data["estimates"])
    ),
    system="Linear with outputs",
)
def observer_equations(
    claims,
    system,
    estimates,
    outputs,
    controls=(),
    parameters=(),
    given=sp.true,
    degree=0,
    polynomial=None,
    symbol=None,
):
    """Check the right-hand sides of the equations of an observer of x' = Ax + Bu, z = Hx.

    They are expressions in the `estimates`, z and u.

    The requirement is that of `observer_gain`, on the matrix that the errors obey.

    Can decide when the right-hand sides are linear in estimates, outputs and controls.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> e1, e2, z, u = sp.symbols("e1 e2 z u")
    >>> cart = Linear(A=[[0, 1], [0, 0]], B=[[0], [1]], H=[[1, 0]])
    >>> observer = [e2 + 3*(z - e1), u + 2*(z - e1)]
    >>> checks.observer_equations(observer, cart, [e1, e2], [z], [u]).status
    'right'
    >>> checks.observer_equations([e2, u], cart, [e1, e2], [z], [u]).status
    'wrong'
    """
    requirement = Requirement(tuple(parameters), given, degree, polynomial, symbol)
    A, B, H = system.A, system.B, system.H
    symbols = [*estimates, *outputs, *controls]
    right_sides = sp.Matrix(claims)
    _require_linear(claims, symbols, parameters, estimates)
    zeros = dict.fromkeys(symbols, sp.Integer(0))
    F, G, J = (
        right_sides.jacobian(part).subs(zeros) if part else sp.zeros(A.rows, 0)
        for part in (estimates, outputs, controls)
    )
    for values in in_every_case(general_values(parameters), claims):
        of_F, of_G, of_J = (entry_uncertainties(part, values) for part in (F, G, J))
        failure = "a control that is known has to act on the estimate as on the state"
        _require_equal(J, B, values, of_J, failure, controls, "")
        failure = "an estimate that is exact at one instant has to stay exact"
        inserted = ", with z = H e inserted,"
        uncertainty = of_F + of_G @ abs(matrix_at(H, values))
        _require_equal(F + G * H, A, values, uncertainty, failure, estimates, inserted)
    return requirement.judge(in_fractions, F, "the matrix of the errors", "your equations")


@judged(
    Expressions(
        "state",
        "estimates",
        "time",
        "K",
        "L",
        length=lambda data: len(data["state"]) + len(data["estimates"]),
    )
)
def closed_loop_equations(claims, field, state, controls, desired, H, K, L, estimates, time):
    """Check the right-hand sides for the state x and for the estimates e of its deviations.

    The deviations are those from the process x*, u* with the `desired` motion, under u = u* + K
    e and the observer e' = Ae + BKe + L (z - H x* - He), z = Hx.

    The field is linear; `desired` prescribes some of the state as functions of time, and the rest
    of the state and the controls are constant.

    Can decide when the `desired` motion determines these constants; the equations are compared at
    sample values of all symbols.

    Examples
    --------
    >>> x, u, e, t = sp.symbols("x u e t")
    >>> loop = [u], [x], [u], {x: 0}, *map(sp.Matrix, ([[1]], [[-1]], [[2]])), [e], t
    >>> checks.closed_loop_equations([-e, 2*x - 3*e], *loop).status
    'right'
    >>> checks.closed_loop_equations([e, 2*x - 3*e], *loop).status
    'wrong'
    """
    e = sp.Matrix(estimates)
    prescribed = {s: sp.sympify(function) for s, function in desired.items()}
    unprescribed = [s for s in (*state, *controls) if s not in prescribed]
    residuals = [
        f.subs(prescribed) - sp.diff(prescribed.get(s, 0), time) for s, f in zip(state, field)
    ]
    (constants,) = sp.solve(residuals, unprescribed, dict=True)
    process = prescribed | constants
    field = sp.Matrix(field)
    A, B = field.jacobian(state), field.jacobian(controls)
    deviations = sp.Matrix([s - process[s] for s in state])
    true = [
        *field.subs(dict(zip(controls, sp.Matrix([process[u] for u in controls]) + K * e))),
        *(A * e + B * K * e + L * H * (deviations - e)),
    ]
    symbols = sorted(set().union(*(side.free_symbols for side in (*true, *claims))), key=str)
    for values in in_every_case(sample_values(symbols), claims):
        for symbol, claim, right_side in zip((*state, *estimates), claims, true):
            parts = sp.Add.make_args(sp.expand(right_side))
            size = sum(abs(complex(term.subs(values))) for term in parts)
            rate = complex(right_side.subs(values)).real
            yield SameValue(claim, rate, f"the rate of {symbol}", values, size)
    return "the plant, its control and the observer agree with the signs and the process that were asked"


def _require_linear(claims, symbols, parameters, estimates):
    """Raise `Wrong` unless each right-hand side is linear in the symbols, at values of them."""
    zeros = dict.fromkeys(symbols, sp.Integer(0))
    coefficients = [[claim.diff(s).subs(zeros) for s in symbols] for claim in claims]
    samples = in_every_case(signed_values(symbols), claims)
    for values, symbol_values in zip(itertools.cycle(general_values(parameters)), samples):
        for symbol, claim, parts in zip(estimates, claims, coefficients):
            claimed = number_at(claim, values | symbol_values, f"the right-hand side for {symbol}")
            terms = [
                number_at(part, values, "a coefficient") * symbol_values[s]
                for part, s in zip(parts, symbols)
            ]
            if not abs(claimed - sum(terms)) <= 1e-9 * (abs(claimed) + sum(map(abs, terms))):
                raise Wrong(
                    f"the right-hand side for {symbol} is not linear in "
                    f"{', '.join(map(str, symbols))}"
                )


def _require_equal(claimed, true, values, uncertainty, failure, names, part_text):
    numbers, expected = (
        np.array(m.subs(values).evalf(30).tolist(), dtype=complex).reshape(m.shape)
        for m in (claimed, true)
    )
    size = abs(expected).max(initial=0) + abs(numbers).max(initial=0) + 1
    wrong = ~(abs(numbers - expected) <= uncertainty + EXACT * size)
    if wrong.any():
        i, k = np.argwhere(wrong)[0]
        raise Wrong(
            f"{failure}{where_text(values)}: in your equation {i + 1}{part_text} {names[k]} has the "
            f"coefficient {number_text(numbers[i, k])}, which is not that of the system"
        )
