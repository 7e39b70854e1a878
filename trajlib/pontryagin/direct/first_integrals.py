"""Polynomial first integrals: quantities of a nonlinear plant that no control changes.

A polynomial p with dp/dy f(y, u) = 0 for all y and u keeps its initial value along every process. Its
coefficients solve linear equations, one for each product of powers (of y, u and the functions that f
contains) in dp/dy f. With the polynomials g of the target, let

    sum w_j p_j + sum v_i g_i = r(y)

hold on the states that satisfy the linear equations of the target. On the target this is sum w_j p_j(y(0)): if
r is a constant, or a quadratic polynomial with a minimum or a maximum, and does not take this value,
the target cannot be reached.

An initial state at which f vanishes for every control is never left; this is checked as well.
"""

from itertools import combinations_with_replacement

import numpy as np
import sympy as sp

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.problem.errors import Infeasible
from trajlib.pontryagin.problem.hypotheses import (
    GIVEN_START,
    LINEAR_PLANT,
    LINEAR_TARGET,
    TARGET,
)
from trajlib.pontryagin.problem.steps import Hypothesis, Refusal

# Highest degree of p, the first that leads to so few coefficients.
DEGREES, MAX_COEFFICIENTS = (3, 2), 90
# Relative size below which a combination of monomials counts as unchanged at random states, which
# decides whether the exact equations are set up.
UNCHANGED = 1e-10
# Difference of values that counts as none, relative to the terms of which they are the sum.
MARGIN = 1e-9


# Where both are linear, `infeasibility` and `free_motion` decide.
NONLINEAR = Hypothesis(
    "the plant or a terminal equation is nonlinear",
    lambda p: not (LINEAR_PLANT.holds(p) and LINEAR_TARGET.holds(p)),
)


def _refuse_first_integrals(numeric):
    problem = numeric.problem
    powers = _powers(numeric.n)
    if powers is None or not _may_have_integrals(numeric, powers):
        return
    integrals = _first_integrals(problem, powers)
    for p, value, r in _restricted(problem, integrals):
        leading = sp.Poly(p, *problem.state).LC()
        p, value, r = (sp.expand(e / leading) for e in (p, value, r))
        low, high = _range(r)
        margin = MARGIN * _size(p, _largest(problem))
        if float(low) - margin <= float(value) <= float(high) + margin:
            continue
        raise Infeasible(
            f"no control leads to the target: {sp.sstr(p)} = {sp.sstr(value)} at all times, whatever the "
            f"control (a first integral of the plant), and the target asks for {_in_words(low, high)}. Choose "
            "a target on which this equation can hold."
        )


def _refuse_fixed_point(numeric):
    problem, start = numeric.problem, dict(numeric.problem.initial)
    if any(sp.expand(f.subs(start)) != 0 for f in problem.field):
        return
    for g in problem.terminal:
        if abs(float(g.subs(start))) > MARGIN * _size(g, start):
            raise Infeasible(
                "no control leads to the target: at the initial state all right-hand sides are zero "
                f"whatever the control, so that it is never left, and {sp.sstr(g)} = 0 does not hold "
                "there. Choose another initial state."
            )


def _size(expression, values):
    """Return the sum of the absolute values of the terms."""
    terms = sp.Add.make_args(sp.expand(expression))
    return sum(abs(float(term.subs(values))) for term in terms)


def _largest(problem):
    """Return for each state the larger absolute value of both ends, as far as they are given."""
    result = {y: abs(value) for y, value in problem.initial.items()}
    for y in problem.state:
        ends = [v for g in problem.terminal for v in (y - g, y + g) if v.is_number]
        result[y] = max([result[y], *map(abs, ends)])
    return result


def _powers(n):
    """Return the powers of n states in all monomials up to a degree, (M, n); None for many states."""
    for degree in DEGREES:
        factors = [
            indices
            for d in range(1, degree + 1)
            for indices in combinations_with_replacement(range(n), d)
        ]
        if len(factors) <= MAX_COEFFICIENTS:
            return np.array([np.bincount(indices, minlength=n) for indices in factors])
    return None


def _may_have_integrals(numeric, powers):
    """Check whether some combination of the monomials has no rate at random states and controls."""
    random, count = np.random.default_rng(0), 2 * len(powers)
    size = 1 + np.abs(numeric.start)[:, None]
    states = numeric.start[:, None] + size * random.uniform(-1, 1, (numeric.n, count))
    low, high = (
        np.where(np.isfinite(bound), bound, default)[:, None]
        for bound, default in ((numeric.lower, -1.0), (numeric.upper, 1.0))
    )
    controls = low + (high - low) * random.uniform(0, 1, (numeric.k, count))
    field = ca.Function("field", [numeric.x, numeric.u], [numeric.field])
    rates = field.map(count)(states, controls).full()
    slopes = np.stack(
        [
            powers[:, i] * np.prod(states.T[:, None] ** np.maximum(powers - unit, 0), axis=2)
            for i, unit in enumerate(np.eye(numeric.n))
        ],
        axis=2,
    )
    # A monomial may be a first integral itself: its size is that of the terms, not of their sum.
    with np.errstate(over="ignore", invalid="ignore"):
        changes = np.einsum("kmi,ik->km", slopes, rates)
        sizes = np.linalg.norm(np.einsum("kmi,ik->km", np.abs(slopes), np.abs(rates)), axis=0)
    if not (np.isfinite(changes).all() and np.isfinite(sizes).all()):
        return False
    changes /= np.maximum(sizes, 1e-300)
    values = np.linalg.svd(changes, compute_uv=False)
    return bool(values[-1] <= UNCHANGED * values[0])


def _first_integrals(problem, powers):
    """Return a basis of the combinations of the monomials whose rate is zero."""
    monomials = [sp.prod(y ** int(d) for y, d in zip(problem.state, row)) for row in powers]
    coefficients = sp.symbols(f"a0:{len(monomials)}", cls=sp.Dummy)
    p = sum((a * m for a, m in zip(coefficients, monomials)), sp.Integer(0))
    rate = sum((sp.diff(p, y) * f for y, f in zip(problem.state, problem.field)), sp.Integer(0))
    numerator = sp.numer(sp.together(rate))
    if numerator == 0:
        return monomials
    generators = [g for g in sp.Poly(numerator).gens if not g.free_symbols & set(coefficients)]
    equations = sp.Poly(numerator, *generators).coeffs()
    matrix, _ = sp.linear_eq_to_matrix(equations, coefficients)
    if not all(entry.is_Rational for entry in matrix):
        return []  # without exact arithmetic in a field, elimination may grow without bound
    rows = matrix.to_DM(sp.QQ).nullspace().to_Matrix().tolist()
    return [sum((a * m for a, m in zip(row, monomials)), sp.Integer(0)) for row in rows]


def _restricted(problem, integrals):
    """Yield (p, p(y(0)), r): r is p on the target, in as few states as possible."""
    y = problem.state
    polynomials = [g for g in problem.terminal if g.is_polynomial(*y)]
    linear = [g for g in polynomials if sp.Poly(g, *y).total_degree() == 1]
    solution = next(iter(sp.solve(linear, y, dict=True)), {})
    equations = [e for g in polynomials if (e := sp.expand(g.subs(solution))) != 0]
    restricted = [sp.expand(p.subs(solution)) for p in integrals]
    values = [p.subs(problem.initial) for p in integrals]
    yield from zip(integrals, values, restricted)
    # Combinations that are constant: the coefficients of all products of powers but 1 cancel.
    columns = [sp.Poly(e, *y).as_dict() for e in (*restricted, *equations)]
    powers = sorted({power for column in columns for power in column if any(power)})
    matrix = sp.Matrix(len(powers), len(columns), lambda i, j: columns[j].get(powers[i], 0))
    for w in matrix.nullspace() if powers else []:
        weights, others = list(w)[: len(restricted)], list(w)[len(restricted) :]
        p, value, r = (
            sum((a * e for a, e in zip(weights, terms)), sp.Integer(0))
            for terms in (integrals, values, restricted)
        )
        r += sum((a * e for a, e in zip(others, equations)), sp.Integer(0))
        if p != 0:
            yield p, value, sp.expand(r)


def _range(r):
    """Return the least and the largest value of a polynomial, infinite where not decided."""
    symbols = sorted(r.free_symbols, key=str)
    if not symbols:
        return r, r
    hessian = sp.hessian(r, symbols)
    if hessian.free_symbols or hessian.det() == 0:
        return -sp.oo, sp.oo
    slope = sp.Matrix([r]).jacobian(symbols).T
    extreme = r.subs(dict(zip(symbols, -hessian.LUsolve(slope.subs(dict.fromkeys(symbols, 0))))))
    if hessian.is_positive_definite:
        return extreme, sp.oo
    return (-sp.oo, extreme) if hessian.is_negative_definite else (-sp.oo, sp.oo)


def _in_words(low, high):
    """Return the values from low to high, one of which is finite, as text."""
    if low == high:
        return sp.sstr(low)
    return f"at least {sp.sstr(low)}" if low != -sp.oo else f"at most {sp.sstr(high)}"


FIXED_POINT = Refusal(
    "initial state at which all right-hand sides vanish",
    "It is never left, so that the target cannot be reached from it.",
    "uniqueness of solutions of differential equations",
    (TARGET, GIVEN_START),
    Infeasible,
    _refuse_fixed_point,
)
FIRST_INTEGRALS = Refusal(
    "polynomial first integrals",
    "A polynomial p(y) that no control changes has a value at the start that the target excludes.",
    "trajlib.pontryagin.direct.first_integrals",
    (TARGET, GIVEN_START, NONLINEAR),
    Infeasible,
    _refuse_first_integrals,
)
