"""Uncontrollable modes of a linear plant: quantities that no control changes.

A row p with p A = mu p and p B = 0 gives l = p y with l' = mu l + p c, whatever the control:

    l(t) = (l(0) + p c/mu) e^(mu t) - p c/mu,   for mu = 0:  l(0) + p c t.

If the terminal equations prescribe l, they do so at one time, or at all times, or at none. At none,
or at different times for two modes, the target cannot be reached.
"""

import numpy as np
import sympy as sp

from trajlib.pontryagin.problem.errors import Infeasible
from trajlib.pontryagin.problem.hypotheses import (
    FREE_TIME,
    GIVEN_START,
    LINEAR_TARGET,
    RELAXED_LINEAR_PLANT,
)
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.steps import Refusal

# Relative difference of times, or of values, that counts as one.
MARGIN = 1e-9


def _refuse_uncontrollable_modes(numeric: NumericProblem) -> None:
    problem = numeric.angle_relaxation.problem
    times: list[tuple[float, str]] = []
    for p, mu, required in _prescribed_modes(problem):
        y, t = sp.Matrix(problem.state), sp.Symbol("t", positive=True)
        start = (p * sp.Matrix([problem.initial[s] for s in problem.state]))[0]
        drift = (p * sp.Matrix(problem.field).subs(dict.fromkeys(problem.state, 0)))[0]
        drift = drift.subs(dict.fromkeys(problem.control, 0))
        if mu * start + drift == 0:
            continue  # a constant, which is judged at any time
        shift = drift / mu if mu != 0 else sp.Integer(0)
        law = (start + shift) * sp.exp(mu * t) - shift if mu != 0 else start + drift * t
        time = _time(float(start + shift), float(required + shift), float(mu), float(drift))
        text = f"{sp.sstr((p * y)[0])} = {sp.sstr(sp.nsimplify(sp.expand(law)))}"
        if not numeric.shortest * (1 - MARGIN) <= time <= _longest(numeric):
            raise Infeasible(
                f"no control leads to the target: {text} whatever the control (an uncontrollable "
                f"mode with the eigenvalue {sp.sstr(mu)}), and the target asks for {required}"
                f"{_never(time)}. Choose an end that keeps to this equation."
            )
        if times and abs(time - times[0][0]) > MARGIN * max(time, times[0][0]):
            raise Infeasible(
                f"no control leads to the target: whatever the control, {times[0][1]} and {text}, "
                f"which are as the target asks at the times {times[0][0]:.6g} and {time:.6g}. Choose "
                "an end that keeps to these equations."
            )
        times.append((time, text))


def _never(time):
    return ", which it never is" if np.isnan(time) else f", which it is at t = {time:.6g} only"


def _longest(numeric):
    return numeric.longest * (1 + MARGIN) if numeric.time_bounds_given else np.inf


def _prescribed_modes(problem):
    """Yield (p, mu, required) for modes p y that no control changes and the target prescribes."""
    field, y = sp.Matrix(problem.field), list(problem.state)
    A, B = field.jacobian(y), field.jacobian(list(problem.control))
    target = sp.Matrix(problem.terminal)
    G, d = target.jacobian(y), -target.subs(dict.fromkeys(y, 0))
    parts = [B]
    for _ in y[1:]:
        parts.append(A * parts[-1])
    unmoved = sp.Matrix.hstack(*parts).T.nullspace()
    if not unmoved:
        return
    P = sp.Matrix.hstack(*unmoved).T
    M = P * A * P.T * (P * P.T).inv()
    for value in sp.roots(M.charpoly().all_coeffs(), cubics=False, quartics=False):
        if not value.is_real:
            continue
        rows = sp.Matrix.hstack(*(M.T - value * sp.eye(M.rows)).nullspace()).T * P
        # a^T rows = b^T G
        for weights in sp.Matrix.hstack(rows.T, -G.T).nullspace():
            p = weights[: rows.rows, :].T * rows
            leading = next((entry for entry in p if entry != 0), None)
            if leading is not None:
                yield p / leading, value, (weights[rows.rows :, :].T * d)[0] / leading


def _time(start, required, mu, drift):
    """Return when l is as required; nan for never.

    For mu other than zero `start` and `required` are those of l + drift/mu.
    """
    if mu == 0:
        return (required - start) / drift
    ratio = required / start
    return float(np.log(ratio) / mu) if ratio > 0 else np.nan


UNCONTROLLABLE_MODES = Refusal(
    "uncontrollable modes",
    "p^T y with p^T A = mu p^T and p^T B = 0 is a known function of time, which is as the target "
    "asks at no time, or at another than a second one.",
    "Popov-Belevitch-Hautus test; trajlib.pontryagin.direct.uncontrollable_modes",
    (FREE_TIME, LINEAR_TARGET, GIVEN_START, RELAXED_LINEAR_PLANT),
    Infeasible,
    _refuse_uncontrollable_modes,
)
