"""Solvability: what measurements along a motion determine, and how well.

Motions are found by the matrix exponential at random values of the symbols, errors by solving small
systems of equations, and what is unobservable by applying the measurements to it; conditions are decided
in exact rational arithmetic, on and off the surfaces where they change.
"""

import functools
import itertools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression, Expressions
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.exceptional_values import judge_everywhere
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.conditions import compare, exactly
from workbook.checks.tools.samples import in_every_case, random_values
from workbook.checks.tools.values import value_at
from workbook.checks.tools.wording import rounded_text, values_text

MOMENTS = 12
#: What counts as nothing beside numbers of size one.
ZERO = 1e-8


@judged(Expression("system.A", "neglected"))
def bias_of_estimate(claim, system, unknowns, estimated, neglected):
    """Check the error of the estimate of the unknown `estimated` if `neglected` is set to zero.

    `neglected` is a constant unknown.
    """
    j, k = list(unknowns).index(estimated), list(unknowns).index(neglected)
    remaining = [i for i in range(system.A.rows) if i != k]
    for values in in_every_case(random_values([*_symbols(system.A), neglected], 73), claim):
        rows = _rows(system.A, system.H, values, np.linspace(0, 4, 3 * MOMENTS))
        bias = np.linalg.lstsq(rows[:, remaining], rows[:, k] * values[neglected], rcond=None)[0]
        quantity, size = f"the error of the estimate of {estimated}", abs(values[neglected])
        yield SameValue(claim, bias[remaining.index(j)], quantity, values, size, 1e-7)
    return "least squares without this unknown is wrong by it, for random values of the symbols"


@judged(Expression("system.A", "tau", "delta"))
def worst_case_error(claim, system, unknowns, estimated, tau, delta):
    """Check the greatest error of the unknown `estimated` from three measurements with errors up to delta.

    The measurements are taken at 0, tau, 2 tau.
    """
    j = list(unknowns).index(estimated)
    for values in in_every_case(random_values([*_symbols(system.A), tau, delta], 74), claim):
        fastest = np.abs(np.linalg.eigvals(_array(system.A, values))).max()
        # between an eighth and seven eighths of half a period
        values[tau] *= 1.1 / fastest
        rows = _rows(system.A, system.H, values, values[tau] * np.arange(3))
        corners = values[delta] * np.array([*itertools.product((-1, 1), repeat=3)]).T
        true = abs(np.linalg.solve(rows, corners)[j]).max()
        yield SameValue(claim, true, f"the greatest error of {estimated}", values, 0, 1e-7)
    return "no errors up to delta give a greater error, and some give this one, for random values of the symbols"


@judged
def unobservable_by_bearings(answer, relative, t):
    """Check a change of a uniform motion that changes no bearing to first order.

    The change is (dx0, dy0, dvx, dvy).
    """
    claim = coercion.as_expressions(answer, _symbols(sp.Matrix(relative), t), 4)
    for values in random_values(_symbols(sp.Matrix(relative), t), 75):
        direction = _direction(claim, values)
        for time in np.linspace(0, 2.5, MOMENTS):
            x, y = (float(part.subs(values | {t: time})) for part in relative)
            dx, dy = direction[:2] + time * direction[2:]
            bearing_rate = (x * dy - y * dx) / (x * x + y * y)
            if not abs(bearing_rate) <= ZERO:
                raise Wrong(
                    f"for {rounded_text(values)}, scaled to length 1, your change turns the "
                    f"bearing at t = {time:.3g} by {bearing_rate:.3g} rad per unit"
                )
    (x, y), (dx, dy) = relative, (sp.diff(part, t) for part in relative)
    judge_everywhere(
        sp.Matrix(claim),
        _symbols(sp.Matrix(relative), t),
        lambda: sp.Ne(sp.expand(x * dy - y * dx), 0),
        "your change is undefined",
        "your change is zero",
    )
    return "it changes no bearing to first order, for random motions"


@judged
def range_observable(answer, relative, t, T, turn):
    """Check the condition that one bearing after the observer's turn determines the range.

    The bearing is taken at t > T, after the observer's velocity has changed by `turn`.
    """
    symbols = [*_symbols(sp.Matrix(relative), t), t, T, *turn]
    after = [part - change * (t - T) for part, change in zip(relative, turn)]
    # the bearings before T leave the relative motion open up to a factor of `relative`
    bearing_change = _without_positive_factor(
        after[0] * relative[1] - after[1] * relative[0], t - T
    )
    domain = sp.And(t > T, sp.Or(*(sp.Ne(part, 0) for part in after)))

    def reason(values, holds):
        return f"for {values_text(values)} a small change of the range " + (
            "turns the bearing, yet your condition fails"
            if holds
            else "does not change the bearing, yet your condition holds"
        )

    agreement = compare(answer, symbols, exactly(sp.Ne(bearing_change, 0), domain), reason)
    return f"it agrees with the change of the bearing: {agreement}"


@functools.lru_cache(maxsize=16)
def _without_positive_factor(expression, positive):
    """Return an expression without a positive factor, for fewer terms; cached for all answers."""
    factors = sp.Mul.make_args(sp.factor(sp.expand(expression)))
    return sp.Mul(*(factor for factor in factors if factor not in (positive, -positive)))


@judged(Expression("relative", "t", "T", "turn", "delta"))
def range_error(claim, relative, t, T, turn, delta):
    """Check the relative error of the range that a bearing error delta after the turn causes.

    Its size to first order is meant.
    """
    symbols = [*_symbols(sp.Matrix(relative), t), t, T, *turn, delta]
    random = np.random.default_rng(77)
    for values in in_every_case(random_values(symbols, 78), claim):
        signed = (s for s in symbols if s not in (t, T, delta))
        values |= {s: values[s] * float(random.choice((-1, 1))) for s in signed}
        values[t] += values[T]
        before = np.array([float(part.subs(values)) for part in relative])
        after = before - np.array([values[s] for s in turn]) * (values[t] - values[T])
        slope = (after[0] * before[1] - after[1] * before[0]) / (after @ after)
        claimed = value_at(claim, values, "the error")
        if claimed < 0:
            where = rounded_text(values)
            raise Wrong(f"for {where} your expression is negative; its size was asked for")
        true = values[delta] / abs(slope)
        yield SameValue(claim, true, "the relative error of the range", values)
    return (
        "it is delta over the sensitivity of the bearing to the range, for random motions and turns"
    )


@judged(Expressions("matrix", "sight", "initial", length=4))
def range_modes(claims, matrix, sight, initial, rate, t):
    """Check the four coefficients of 1, t, cos(rate t), sin(rate t) in the deviation of a range."""
    symbols = [*_symbols(matrix), *sight, *initial]
    for values in in_every_case(random_values(symbols, 79), claims):
        coefficients = [value_at(claim, values, "a coefficient") for claim in claims]
        w, start = values[rate], np.array([values[s] for s in initial])
        times, direction = np.linspace(0.1, 7, MOMENTS), np.array([values[s] for s in sight])
        for time, transition in zip(times, _transitions(matrix, values, times)):
            true = direction @ (transition @ start)[: len(sight)]
            claimed = np.dot(coefficients, [1, time, math.cos(w * time), math.sin(w * time)])
            if not abs(claimed - true) <= ZERO * (abs(true) + np.abs(start).max() * (1 + time)):
                raise Wrong(
                    f"for {rounded_text(values)} your four terms sum up to {claimed:.5g} at {t} = "
                    f"{time:.3g}, which is not the deviation of the range"
                )
    return "the four terms sum up to the deviation of the range at all times, for random directions and motions"


@judged(Expressions(length=lambda data: len(data["sights"])))
def observability_ranks(claims, matrix, sights):
    """Check how many combinations of the unknowns ranges along each direction determine."""
    values = next(random_values(_symbols(matrix), 81))
    for number, (claim, sight) in enumerate(zip(claims, sights), 1):
        claim = coercion.as_integer(claim)
        output = sp.Matrix([[*sight, *[0] * (matrix.rows - len(sight))]])
        rows = _rows(matrix, output, values, np.linspace(0, 9, 5 * MOMENTS))
        rows /= np.maximum(np.linalg.norm(rows, axis=0), 1e-300)
        if claim != np.linalg.matrix_rank(rows, rtol=1e-9):
            raise Wrong(
                f"direction number {number}: the rank of the stacked matrix of many ranges is not "
                f"{claim}"
            )
    return "the stacked matrices of many ranges have these ranks"


@judged
def stations_insufficient(answer, matrix, first, second):
    """Check the condition on two unit vectors for ranges along both to be insufficient.

    Insufficient means that something is unobservable; none of the components of the vectors
    vanish.
    """
    symbols = [*first, *second]
    domain = sp.And(
        *(sp.Eq(sum(n**2 for n in sight), 1) for sight in (first, second)),
        *(sp.Ne(n, 0) for n in symbols),
    )
    unobservable = _unobservable_along(
        matrix.subs({s: sp.Rational(2, 3) for s in _symbols(matrix)}), first, second
    )

    def message(values, holds):
        return f"for {values_text(values)} the ranges determine " + (
            "not all unknowns, yet your condition fails"
            if holds
            else "everything, yet your condition holds"
        )

    reference = exactly(
        unobservable,
        domain,
        points=lambda: (dict(zip(symbols, pair)) for pair in _pairs_of_directions()),
    )
    agreement = compare(answer, symbols, reference, message)
    return f"it agrees with the rank, for directions in general position and in special ones: {agreement}"


def _unobservable_along(matrix, *sights):
    """Return the condition that ranges along all directions leave a motion of x' = A x unobservable.

    By the PBH test.
    """
    rows = sp.Matrix([[*sight, *[0] * (matrix.rows - len(sight))] for sight in sights])
    conditions = []
    for _, _, vectors in matrix.eigenvects():
        outputs = rows * sp.Matrix.hstack(*vectors)
        minors = [
            outputs.extract(list(chosen), list(range(outputs.cols))).det()
            for chosen in itertools.combinations(range(outputs.rows), outputs.cols)
        ]
        parts = (part for minor in minors for part in sp.expand(minor).as_real_imag())
        conditions.append(sp.And(*(sp.Eq(part, 0) for part in parts)))
    return sp.Or(*conditions)


def _pairs_of_directions(count=48):
    """Yield pairs of rational unit vectors without zero components, each pair in one list.

    General pairs, equal and opposite directions, mirrored and perpendicular ones, close ones, and
    pairs with two components in proportion.
    """
    random = np.random.default_rng(82)

    def unit(a, b):
        """Stereographic coordinates."""
        size = 1 + a * a + b * b
        return [2 * a / size, 2 * b / size, (2 - size) / size]

    def random_fraction():
        numerator = random.choice((-1, 1)) * random.integers(1, 12)
        return sp.Rational(int(numerator), int(random.integers(13, 17)))

    for number in range(count):
        a, b, factor, k = random_fraction(), random_fraction(), random_fraction(), number // 8 % 3
        first = unit(a, b)
        mirror = [-n if i == k else n for i, n in enumerate(first)]
        # orthonormal with `first`
        perpendicular = [1 - a * first[0], -b * first[0], -first[0]]
        second = [
            first,
            [-n for n in first],
            mirror,
            [-n for n in mirror],
            perpendicular,
            unit(a * sp.Rational(101, 100), b),
            unit(factor * a, factor * b),
            unit(random_fraction(), random_fraction()),
        ][number % 8]
        rotated = [*first[k:], *first[:k]], [*second[k:], *second[:k]]
        if all(rotated[0]) and all(rotated[1]):
            yield rotated[0] + rotated[1]


def _rows(matrix, output, values, times):
    """Return the stacked matrix of the measurements at times."""
    return np.concatenate(_array(output, values) @ _transitions(matrix, values, times))


def _transitions(matrix, values, times):
    """Return the state-transition matrices at times, stacked along the first axis."""
    from scipy.linalg import expm

    return expm(_array(matrix, values) * times[:, None, None])


def _direction(claim, values):
    """Return the vector at values of the symbols, scaled to length 1."""
    numbers = np.array(
        [value_at(part, values, f"component {k}") for k, part in enumerate(claim, 1)]
    )
    if not np.abs(numbers).max() > 0:
        raise Wrong(f"for {rounded_text(values)} it is zero: a change that changes nothing")
    # a square of what is very large would be infinite
    numbers = numbers / np.abs(numbers).max()
    return numbers / np.linalg.norm(numbers)


def _symbols(matrix, *excluded):
    return sorted(matrix.free_symbols - set(excluded), key=str)


def _array(matrix, values):
    matrix = sp.ImmutableMatrix(matrix)
    symbols = tuple(_symbols(matrix))
    return np.array(_compiled(matrix, symbols)(*(float(values[s]) for s in symbols)), dtype=float)


@functools.lru_cache(maxsize=32)
def _compiled(matrix, symbols):
    # Only matrices of the data come here, never an answer.
    return sp.lambdify(symbols, matrix, "numpy")
