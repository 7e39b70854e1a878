"""Proofs that no admissible control leads to the target; `Infeasible` names one of them.

1. *A monotone quantity.* l = p^T y with l' = mu l + g(u), p being a left eigenvector of a linear plant, or y_i itself
   if its rate depends on the controls alone. Whatever the control, l stays between the solutions
   for the least and the greatest g, each of which is monotone in time. If the target asks for a
   value beyond them, it cannot be reached.
2. *An uncontrollable quantity.* For a linear plant l = q^T G y, G y = d being the target, with q^T G A^k B = 0 for all
   k: it follows the free motion. If this is not q^T d, the target cannot be reached.

Contradictory linear terminal equations are refused too. Angles count as vectors in discs
(`angle_relaxation`): a plant that is linear in cos u and sin u is linear here. Quantities of other
plants that no control changes: `first_integrals`.
"""

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.free_motion import MISSED_TARGET
from trajlib.pontryagin.direct.uncontrollable_modes import UNCONTROLLABLE_MODES
from trajlib.pontryagin.problem.errors import Infeasible
from trajlib.pontryagin.problem.hypotheses import (
    GIVEN_START,
    LINEAR_TARGET,
    RELAXABLE,
    RELAXED_LINEAR_PLANT,
)
from trajlib.pontryagin.problem.steps import Refusal

# Margin by which a value counts as beyond a bound, relative to the size of the values.
MARGIN = 1e-9
# Rounding errors of weights by least squares, relative to the greatest of them.
ROUNDING = 1e-12


def _refuse_monotone_quantity(numeric):
    G, d = linear_target(numeric.problem)
    for p, mu, drift, gains in _quantities(numeric):
        weights, *_ = np.linalg.lstsq(G.T, p, rcond=None)
        if np.max(np.abs(G.T @ weights - p)) > ROUNDING * np.max(np.abs(p)):
            continue
        value, required = float(p @ numeric.start), float(weights @ d)
        least, greatest = _range(value, mu, drift, gains, numeric)
        size = MARGIN * float(np.abs(p) @ np.abs(numeric.start) + np.abs(weights) @ np.abs(d))
        size += ROUNDING * float(np.abs(weights).max() * np.abs(d).sum())
        # Without a bound of the time a stable quantity approaches its limit and does not reach it.
        asymptotic = mu < 0 and numeric.duration is None and not numeric.time_bounds_given
        below = required < least - size or (asymptotic and required <= least < value)
        above = required > greatest + size or (asymptotic and required >= greatest > value)
        if below or above:
            quantity = sum(
                (
                    sp.Rational(repr(float(c))).limit_denominator(10**6) * y
                    for c, y in zip(p, numeric.problem.state)
                ),
                sp.Integer(0),
            )
            limit = (
                f"remains above {least:.6g}"
                if asymptotic and below
                else f"remains below {greatest:.6g}"
                if asymptotic
                else f"cannot fall below {least:.6g}"
                if below
                else f"cannot exceed {greatest:.6g}"
            )
            when = "" if numeric.duration is None else f" at the time {numeric.duration:.6g}"
            raise Infeasible(
                f"no admissible control leads to the target: {quantity} begins at {value:.6g} and "
                f"{limit}{when}, whatever the control; the target asks for {required:.6g}. The "
                "target cannot be reached from this start."
            )


def _refuse_contradiction(numeric):
    G, d = linear_target(numeric.problem)
    nearest, *_ = np.linalg.lstsq(G, d, rcond=None)
    if np.max(np.abs(G @ nearest - d)) > MARGIN * np.max(np.abs(d)):
        raise Infeasible(
            "the terminal equations contradict one another: no state satisfies all of them. Leave "
            "out what is not asked for."
        )


def _refuse_uncontrollable_quantity(numeric):
    problem = numeric.angle_relaxation.problem
    A, _B, c = linear_plant(problem)
    state, n = sp.Matrix(problem.state), numeric.n
    G = sp.Matrix(problem.terminal).jacobian(problem.state)
    d = -sp.Matrix(problem.terminal).subs(dict.fromkeys(problem.state, 0))
    duration = numeric.duration
    for q in sp.Matrix.hstack(*(G * part for part in _exact_powers(problem))).T.nullspace():
        row, required = (q.T * G), float((q.T * d)[0])
        p = np.array(row.evalf(), dtype=float).ravel()
        if duration is None:
            # At any time: only quantities that the free motion does not change either.
            rates = [np.linalg.matrix_power(A, k) @ (A @ numeric.start + c) for k in range(n)]
            if any(
                abs(p @ rate) > MARGIN * np.abs(p).max() * (1 + np.abs(rate).max())
                for rate in rates
            ):
                continue
            value = float(p @ numeric.start)
        else:
            value = float(p @ _free_motion(A, c, numeric.start, duration))
        if abs(value - required) > MARGIN * (
            np.abs(p) @ np.abs(numeric.start) + abs(value) + abs(required)
        ):
            when = "at all times" if duration is None else f"at the time {duration:.6g}"
            raise Infeasible(
                f"no control leads to the target: {sp.sstr((row * state)[0])} does not depend on "
                f"the control and is {value:.6g} {when}; the target asks for {required:.6g}. The "
                "pair (A, B) of the plant is not controllable; choose an end that keeps to this "
                "combination."
            )


def _exact_powers(problem):
    """Yield B, A B, ..., A^(n-1) B of a linear plant as SymPy matrices."""
    field = sp.Matrix(problem.field)
    A, part = field.jacobian(problem.state), field.jacobian(problem.control)
    for _ in problem.state:
        yield part
        part = (A * part).applyfunc(sp.expand)


def _free_motion(A, c, start, duration):
    """Return the state at the duration without control."""
    from scipy.linalg import expm

    extended = np.zeros((len(A) + 1, len(A) + 1))
    extended[:-1, :-1], extended[:-1, -1] = A, c
    return (expm(extended * duration) @ np.append(start, 1.0))[:-1]


def linear_target(problem):
    """Return (G, d) of the terminal equations G y = d, or None."""
    if not problem.terminal:
        return None
    G = sp.Matrix(problem.terminal).jacobian(problem.state)
    if G.free_symbols:
        return None
    d = -sp.Matrix(problem.terminal).subs(dict.fromkeys(problem.state, 0))
    return np.array(G.evalf(), dtype=float), np.array(d.evalf(), dtype=float).ravel()


def linear_plant(problem):
    """Return (A, B, c) of the plant y' = A y + B u + c, or None."""
    slopes = sp.Matrix(problem.field).jacobian([*problem.state, *problem.control])
    if slopes.free_symbols:
        return None
    c = sp.Matrix(problem.field).subs(dict.fromkeys([*problem.state, *problem.control], 0))
    slopes, n = np.array(slopes.evalf(), dtype=float), len(problem.state)
    return slopes[:, :n], slopes[:, n:], np.array(c.evalf(), dtype=float).ravel()


def _quantities(numeric):
    """Yield (p, mu, drift, gains) of quantities l = p^T y with l' = mu l + drift + gains^T u."""
    problem, n = numeric.angle_relaxation.problem, numeric.n
    plant = linear_plant(problem)
    if plant is not None:
        A, B, c = plant
        for mu, p in zip(*(values.T for values in np.linalg.eig(A.T))):
            p = np.real_if_close(p, 1e4)
            if (
                np.isreal(mu)
                and np.isrealobj(p)
                and np.max(np.abs(p @ A - mu.real * p)) < 1e-13 * (1 + np.max(np.abs(A)))
            ):
                p = p / p[np.argmax(np.abs(p))]
                yield p, float(mu.real), float(p @ c), p @ B
        return
    for i, rate in enumerate(problem.field):
        slopes = [sp.diff(rate, u) for u in problem.control]
        if not (rate.free_symbols - set(problem.control)) and not any(
            s.free_symbols for s in slopes
        ):
            drift = rate.subs(dict.fromkeys(problem.control, 0))
            yield np.eye(n)[i], 0.0, float(drift), np.array([float(s) for s in slopes])


def _range(value, mu, drift, gains, numeric):
    """Return the least and the greatest value of l at the duration, or at any time."""
    least, greatest = numeric.angle_relaxation.least(gains), -numeric.angle_relaxation.least(-gains)
    result = []
    for rate, choose in ((drift + float(least), min), (drift + float(greatest), max)):
        longest = numeric.duration or (numeric.longest if numeric.time_bounds_given else np.inf)
        end = _after(value, mu, rate, longest)
        result.append(end if numeric.duration is not None else choose(value, end))
    return result


def _after(value, mu, drift, time):
    """Return l after a time, for l' = mu l + drift."""
    if np.isinf(drift):
        return drift
    if np.isinf(time):
        growth = mu * value + drift
        return -drift / mu if mu < 0 else value if growth == 0 else np.copysign(np.inf, growth)
    return value * np.exp(mu * time) + drift * (np.expm1(mu * time) / mu if mu else time)


CONTRADICTION = Refusal(
    "contradictory terminal equations",
    "No state satisfies linear terminal equations of which a combination is 0 = 1.",
    "linear algebra",
    (LINEAR_TARGET,),
    Infeasible,
    _refuse_contradiction,
)
MONOTONE_QUANTITY = Refusal(
    "monotone quantity",
    "p^T y with (p^T y)' = mu p^T y + g(u) stays between its values for the least and greatest g, "
    "and the target lies beyond them.",
    "trajlib.pontryagin.direct.infeasibility, 1",
    (LINEAR_TARGET, GIVEN_START, RELAXABLE),
    Infeasible,
    _refuse_monotone_quantity,
)
UNCONTROLLABLE_QUANTITY = Refusal(
    "uncontrollable quantity",
    "q^T y with q^T A^k B = 0 for all k follows the free motion, and the target asks for another "
    "value.",
    "Kalman 1960; trajlib.pontryagin.direct.infeasibility, 2",
    (LINEAR_TARGET, GIVEN_START, RELAXED_LINEAR_PLANT),
    Infeasible,
    _refuse_uncontrollable_quantity,
)
# All that is proved from linear terminal equations before any search, in this order.
LINEAR_TARGETS = (
    CONTRADICTION,
    MONOTONE_QUANTITY,
    UNCONTROLLABLE_MODES,
    UNCONTROLLABLE_QUANTITY,
    MISSED_TARGET,
)
