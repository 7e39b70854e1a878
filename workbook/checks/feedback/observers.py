"""Observers given by their equations e' = f(e, z, u), judged by the error d = x - e.

Along the motions of x' = Ax + Bu, z = Hx the error has to obey an equation of its own, d' = (A -
LH) d with some L, for all x and u; then its spectrum is judged as that of a gain.
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
    )
)
def observer_equations(
    claims,
    system,
    estimates,
    outputs,
    controls=(),
    parameters=(),
    given=sp.true,
    margin=0,
    polynomial=None,
    symbol=None,
):
    """Check the right-hand sides of the equations of an observer of x' = Ax + Bu, z = Hx.

    They are expressions in the `estimates`, z and u.

    The requirement is that of `observer_gain`, on the matrix that the errors obey.
    """
    requirement = Requirement(tuple(parameters), given, margin, polynomial, symbol)
    A, B, H = system.A, system.B, system.H
    symbols = [*estimates, *outputs, *controls]
    right = sp.Matrix(claims)
    _hold_linear(claims, symbols, parameters, estimates)
    plain = dict.fromkeys(symbols, sp.Integer(0))
    F, G, J = (
        right.jacobian(part).subs(plain) if part else sp.zeros(A.rows, 0)
        for part in (estimates, outputs, controls)
    )
    for values in in_every_case(general_values(parameters), claims):
        open_F, open_G, open_J = (entry_uncertainties(part, values) for part in (F, G, J))
        _hold_same(
            J,
            B,
            values,
            open_J,
            "a control that is known acts on the estimate as on the state",
            controls,
        )
        _hold_same(
            F + G * H,
            A,
            values,
            open_F + open_G @ abs(matrix_at(H, values)),
            "an estimate that is exact at one moment does not stay so while the state moves",
            estimates,
        )
    return requirement.hold(in_fractions, F, "the matrix of the errors", "your equations")


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

    The field is linear, `desired` prescribes some of the state as functions of time; what it
    leaves open is constant.
    """
    e, prescribed = sp.Matrix(estimates), {s: sp.sympify(motion) for s, motion in desired.items()}
    open_ = [s for s in (*state, *controls) if s not in prescribed]
    (found,) = sp.solve(
        [f.subs(prescribed) - sp.diff(prescribed.get(s, 0), time) for s, f in zip(state, field)],
        open_,
        dict=True,
    )
    process = prescribed | found
    field = sp.Matrix(field)
    A, B = field.jacobian(state), field.jacobian(controls)
    deviations = sp.Matrix([s - process[s] for s in state])
    true = [
        *field.subs(dict(zip(controls, sp.Matrix([process[u] for u in controls]) + K * e))),
        *(A * e + B * K * e + L * H * (deviations - e)),
    ]
    symbols = sorted(
        set().union(
            *(right.free_symbols for right in true), *(claim.free_symbols for claim in claims)
        ),
        key=str,
    )
    for values in in_every_case(sample_values(symbols), claims):
        for symbol, claim, right in zip((*state, *estimates), claims, true):
            terms = [abs(complex(term.subs(values))) for term in sp.Add.make_args(sp.expand(right))]
            yield SameValue(
                claim, complex(right.subs(values)).real, f"the rate of {symbol}", values, sum(terms)
            )
    return "the plant, its control and the observer agree with the signs and the process that were asked"


def _hold_linear(claims, symbols, parameters, estimates):
    """Whether each right-hand side is a sum of multiples of the symbols, at values of them."""
    plain = dict.fromkeys(symbols, sp.Integer(0))
    coefficients = [[claim.diff(s).subs(plain) for s in symbols] for claim in claims]
    for values, others in zip(
        itertools.cycle(general_values(parameters)), in_every_case(signed_values(symbols), claims)
    ):
        for symbol, claim, parts in zip(estimates, claims, coefficients):
            claimed = number_at(claim, values | others, f"the right-hand side for {symbol}")
            terms = [
                number_at(part, values, "a coefficient") * others[s]
                for part, s in zip(parts, symbols)
            ]
            if not abs(claimed - sum(terms)) <= 1e-9 * (abs(claimed) + sum(map(abs, terms))):
                raise Wrong(
                    f"the right-hand side for {symbol} is not linear in "
                    f"{', '.join(map(str, symbols))}"
                )


def _hold_same(claimed, true, values, left_open, what, names):
    found, wanted = (
        np.array(m.subs(values).evalf(30).tolist(), dtype=complex).reshape(m.shape)
        for m in (claimed, true)
    )
    wrong = ~(
        abs(found - wanted)
        <= left_open + EXACT * (abs(wanted).max(initial=0) + abs(found).max(initial=0) + 1)
    )
    if wrong.any():
        i, k = np.argwhere(wrong)[0]
        raise Wrong(
            f"{what}{where_text(values)}: in equation {i + 1} the part of {names[k]} adds up to "
            f"{number_text(found[i, k])}"
        )
