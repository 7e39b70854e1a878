"""Uncontrollable states of a linear plant with a free final time: do they ever meet the target?

States w = P y with P A^k B = 0 for all k follow w' = M w + P c, whatever the control. Those terminal
equations that only contain w are functions of time alone,

    f_i(t) = sum of c_ijk t^j e^(mu_k t),

whose coefficients follow from the derivatives at t = 0. The target can be reached at a common zero
only. After some time the terms that grow fastest (decay slowest) outweigh all others; until then
intervals of time are excluded one by one, by the value of an f_i in their middle and a bound of its
derivative.
"""

from itertools import product

import mpmath
import numpy as np
import sympy as sp

from trajlib.pontryagin.problem.errors import Infeasible
from trajlib.pontryagin.problem.hypotheses import (
    FREE_TIME,
    GIVEN_START,
    LINEAR_TARGET,
    RELAXED_LINEAR_PLANT,
)
from trajlib.pontryagin.problem.steps import Refusal

# Decimal digits of the coefficients; those below CANCELS, relative to the largest, are zero.
DIGITS, CANCELS = 50, 1e-30
# Rounding errors of f_i, relative to its terms; angles at which the fastest terms are compared.
ROUNDING, ANGLES = 1e-12, 720
# Most intervals of time, and longest time as a multiple of the time constants.
MAX_INTERVALS, MAX_DOUBLINGS = 4000, 40


def _refuse_missed_target(numeric):
    rows, motion, start = _prescribed_motion(numeric.angle_relaxation.problem)
    # Plants with other than rational coefficients are left aside.
    if not rows or not all(e.is_Rational for e in (*motion, *start)):
        return
    terms = _terms(sp.Matrix.vstack(*(row for _, row in rows)), motion, start)
    if not terms:
        return  # the target is met at all times
    shortest, longest = (
        (numeric.shortest, numeric.longest)
        if numeric.time_bounds_given
        else (0.0, _last_time(terms))
    )
    if longest is None or not _no_common_zero(terms, shortest, longest):
        return
    equations = ", ".join(sp.sstr(equation) + " = 0" for equation, _ in rows)
    modes = motion[:-1, :-1].charpoly().nroots(maxsteps=500)
    values = ", ".join(
        dict.fromkeys(sp.sstr(mu.evalf(4, chop=True), full_prec=False) for mu in modes)
    )
    raise Infeasible(
        "no control leads to the target: it asks for "
        f"{equations}, which does not depend on the control and holds at no time"
        f"{' at once' if len(rows) > 1 else ''} (uncontrollable modes, eigenvalues {values}). "
        "Choose an end that the free motion of these states meets."
    )


def _prescribed_motion(problem):
    """Return [(terminal equation of w, its row for (w, 1))], N of (w, 1)' = N (w, 1), and (w, 1) at 0."""
    y = sp.Matrix(problem.state)
    zero = dict.fromkeys((*problem.state, *problem.control), 0)
    field, target = sp.Matrix(problem.field), sp.Matrix(problem.terminal)
    A, B, c = field.jacobian(y), field.jacobian(problem.control), field.subs(zero)
    G = target.jacobian(y)
    parts = [B]
    for _ in y[1:]:
        parts.append(A * parts[-1])
    unmoved = sp.Matrix.hstack(*parts).T.nullspace()
    if not unmoved:
        return [], sp.zeros(1), sp.zeros(1)
    P = sp.Matrix.hstack(*unmoved).T
    right = P.T * (P * P.T).inv()
    motion = sp.Matrix.vstack(sp.Matrix.hstack(P * A * right, P * c), sp.zeros(1, P.rows + 1))
    start = sp.Matrix.vstack(
        P * sp.Matrix([problem.initial[s] for s in problem.state]), sp.ones(1, 1)
    )
    rows = []
    # Combinations b^T (G y - d) with b^T G = a^T P.
    for weights in sp.Matrix.hstack(P.T, -G.T).nullspace():
        a, b = weights[: P.rows, :], weights[P.rows :, :]
        if any(a):
            constant = (b.T * target.subs(zero))[0]
            rows.append(((a.T * P * y)[0] + constant, a.T.row_join(sp.Matrix([[constant]]))))
    return rows, motion, start


def _terms(rows, motion, start):
    """Return [(mu, j, coefficients c_i)] of f(t) = rows e^(motion t) start, without those that are zero."""
    with mpmath.workdps(DIGITS):
        exponents = [
            (mpmath.mpmathify(mu), j)
            for factor, multiplicity in motion.charpoly().sqf_list()[1]
            for mu in factor.nroots(n=DIGITS, maxsteps=500)
            for j in range(multiplicity)
        ]
        count = len(exponents)
        # d^i/dt^i of t^j e^(mu t) at zero is i!/(i-j)! mu^(i-j).
        table = mpmath.matrix(count, count)
        for i, (column, (mu, j)) in product(range(count), enumerate(exponents)):
            table[i, column] = mpmath.ff(i, j) * mu ** (i - j) if i >= j else 0
        derivatives, vector = [], start
        for _ in range(count):
            derivatives.append((rows * vector).T)
            vector = motion * vector
        values = mpmath.matrix(sp.Matrix.vstack(*derivatives).evalf(DIGITS).tolist())
        coefficients = mpmath.inverse(table) * values
        largest = max(abs(value) for value in coefficients)
        return [
            (complex(mu), j, np.array([complex(v) for v in coefficients[k, :]]))
            for k, (mu, j) in enumerate(exponents)
            if max(abs(v) for v in coefficients[k, :]) > CANCELS * largest
        ]


def _last_time(terms):
    """Return a time after which f has no zero; None if that is not certain."""
    rate = max(mu.real for mu, _, _ in terms)
    power = max(j for mu, j, _ in terms if _same(mu.real, rate))
    fastest = [(mu, c) for mu, j, c in terms if _same(mu.real, rate) and j == power]
    turning = [(mu, c) for mu, c in fastest if mu.imag > ROUNDING]
    if len(turning) > 1:
        return None
    constant = sum((c.real for mu, c in fastest if abs(mu.imag) <= ROUNDING), 0.0)
    amplitude = 2 * turning[0][1] if turning else np.zeros(len(terms[0][2]))
    angles = 2 * np.pi * np.arange(ANGLES) / ANGLES
    vectors = constant + np.real(np.exp(1j * angles)[:, None] * amplitude)
    size = float(np.linalg.norm(np.abs(amplitude))) + float(np.linalg.norm(constant))
    least = float(np.min(np.linalg.norm(vectors, axis=1))) - np.pi / ANGLES * size * bool(turning)
    if least <= ROUNDING * size:
        return None
    others = [
        (mu.real - rate, j - power, float(np.linalg.norm(c)))
        for mu, j, c in terms
        if not (_same(mu.real, rate) and j == power)
    ]
    # From here on every other term decreases, relative to the fastest.
    time = max([1.0, *(j / -decay for decay, j, _ in others if j > 0)])
    for _ in range(MAX_DOUBLINGS):
        if sum(c * time**j * np.exp(decay * time) for decay, j, c in others) < least / 2:
            return time
        time *= 2
    return None


def _same(a, b):
    return abs(a - b) <= ROUNDING * (1 + abs(a) + abs(b))


def _no_common_zero(terms, shortest, longest):
    """Check that on no part of [shortest, longest] all f_i may vanish."""
    remaining, count = [(shortest, longest)], 0
    while remaining and count < MAX_INTERVALS:
        begin, end = remaining.pop()
        count += 1
        middle = (begin + end) / 2
        value, slope, size = 0, 0.0, 0.0
        for mu, j, c in terms:
            value = value + (c * middle**j * np.exp(mu * middle)).real
            growth = np.exp(mu.real * (end if mu.real > 0 else begin))
            steep = abs(mu) * end**j + (j * end ** (j - 1) if j else 0.0)
            slope = slope + np.abs(c) * growth * steep
            size = size + np.abs(c) * growth * end**j
        if not np.any(np.abs(value) > slope * (end - begin) / 2 + ROUNDING * size):
            remaining += [(begin, middle), (middle, end)]
    return not remaining


MISSED_TARGET = Refusal(
    "free motion that misses the target",
    "Uncontrollable states follow a known function of time, which meets the target at no time.",
    "trajlib.pontryagin.direct.free_motion",
    (FREE_TIME, LINEAR_TARGET, GIVEN_START, RELAXED_LINEAR_PLANT),
    Infeasible,
    _refuse_missed_target,
)
