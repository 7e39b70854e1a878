"""Decides, without the check, whether a mutant is right after all: the same answer in another form.

The default compares with the reference answer by value; a check with room for several answers has an oracle of its
own under its name in `ORACLES`. What no oracle proves right, the check has to reject.
"""

import math
from fractions import Fraction
from itertools import permutations
from random import Random

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

LOGIC = (Relational, sp.And, sp.Or, sp.Not, sp.logic.boolalg.BooleanAtom)


def is_right(mutant, reference, check, arguments, options, kind):
    """True if the mutant is proved right."""
    oracle = ORACLES.get(check)
    return oracle(mutant, reference, *arguments, **options) if oracle else same_value(mutant, reference, kind)


def same_value(one, other, kind=""):
    """True if two answers are the same value, whatever their form; sets and lists of points have no order."""
    if isinstance(one, (list, tuple)) or isinstance(other, (list, tuple)):
        if not (isinstance(one, (list, tuple)) and isinstance(other, (list, tuple))):
            return False
        if kind.startswith(("list of vector", "set")):
            return (all(any(same_value(a, b) for b in other) for a in one)
                    and all(any(same_value(a, b) for a in one) for b in other))
        return len(one) == len(other) and all(map(same_value, one, other))
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(same_value(one[key], other[key]) for key in one)
    if isinstance(one, str) or isinstance(other, str) or isinstance(one, bool):
        return one == other
    if isinstance(one, LOGIC) or isinstance(other, LOGIC):
        return same_condition(one, other)
    if isinstance(one, sp.MatrixBase) or isinstance(other, sp.MatrixBase):
        return sp.Matrix(one).shape == sp.Matrix(other).shape and all(map(same_value, sp.Matrix(one), sp.Matrix(other)))
    return sp.simplify(sp.sympify(one) - sp.sympify(other)) == 0


def same_condition(one, other, leave_out=lambda point: False):
    """True if two conditions agree at many rational points, those on the boundaries of both among them."""
    symbols = sorted(one.free_symbols | other.free_symbols, key=str)
    tests = [sp.lambdify(symbols, condition, modules="math") for condition in (one, other)]
    return all(_holds(tests[0], point) == _holds(tests[1], point) or leave_out(dict(zip(symbols, point)))
               for point in _points(symbols, one, other))


def _points(symbols, *conditions):
    random = Random(11)

    def anywhere():
        return [Fraction(random.randint(-80, 80), random.choice((1, 2, 7, 20, 40))) for _ in symbols]

    yield from (anywhere() for _ in range(600))
    for atom in sorted(set().union(*(condition.atoms(Relational) for condition in conditions)), key=str):
        difference = atom.lhs - atom.rhs
        for symbol in sorted(difference.free_symbols, key=str):
            for _ in range(12):
                point = dict(zip(symbols, anywhere()))
                others = {s: sp.Rational(v.numerator, v.denominator) for s, v in point.items() if s != symbol}
                line = sp.numer(sp.together(difference.xreplace(others)))
                for root in sp.Poly(line, symbol).ground_roots() if line.is_polynomial(symbol) and line.has(symbol) else []:
                    if root.is_Rational:
                        at = Fraction(int(root.p), int(root.q))
                        for value in (at, at + Fraction(1, 10**4), at - Fraction(1, 10**4)):
                            yield [value if s == symbol else point[s] for s in symbols]


def _holds(test, point):
    try:
        return bool(test(*point))
    except (ZeroDivisionError, ValueError, TypeError):
        return False


def stability_region(mutant, reference, system, parameters, margin=0):
    """As `same_condition`, with the two conventions: where the order drops, and on the boundary of a margin."""
    if not isinstance(mutant, LOGIC):
        return False
    if isinstance(system, sp.MatrixBase):
        leading, polynomial = sp.S.One, system.charpoly()
    else:
        (symbol,) = sp.sympify(system).free_symbols - set(parameters)
        polynomial = sp.Poly(system, symbol)
        leading = polynomial.LC()

    def convention(point):
        # A condition that is true or false everywhere has no symbols: any values will do for it.
        values = dict.fromkeys(parameters, 0) | {p: sp.Rational(v.numerator, v.denominator) for p, v in point.items()}
        if leading.xreplace(values) == 0:
            return True
        if margin == 0:
            return False
        roots = sp.Poly(polynomial.as_expr().xreplace(values), polynomial.gen).nroots(n=20)
        return abs(max(sp.re(root) for root in roots) + margin) < 1e-9

    return same_condition(mutant, reference, convention)


def basin_estimate(mutant, reference, function, field, state, parameters=(), given=()):
    """As `same_condition`, but the border itself is a convention: {V < c} and {V <= c} are the same estimate.

    Parameters that the problem excludes count for nothing.
    """
    return isinstance(mutant, LOGIC) and same_condition(_closed(mutant), _closed(reference), _excluded(given))


def _excluded(given):
    """The test whether a point violates the condition or conditions that a problem takes for granted."""
    given = sp.And(*given) if isinstance(given, (list, tuple)) else given
    return lambda point: given.subs({s: sp.Rational(v.numerator, v.denominator) for s, v in point.items()}) == False  # noqa: E712


def _closed(condition):
    return condition.replace(lambda node: isinstance(node, (sp.StrictLessThan, sp.StrictGreaterThan)),
                             lambda node: (sp.Le if isinstance(node, sp.StrictLessThan) else sp.Ge)(node.lhs, node.rhs))


def same_family(mutant, reference, field, state, parameters=(), given=(), integer=None):
    """True if two lists of expressions in an integer have the same members, whatever their order and counting."""
    random, excluded, compared = Random(12), _excluded(given), 0
    while compared < 3:
        point = {p: Fraction(random.randint(1, 40), 12) * (1 if p.is_positive else random.choice((-1, 1))) for p in parameters}
        if excluded(point):
            continue
        compared += 1
        values = {p: sp.Rational(x.numerator, x.denominator) for p, x in point.items()}
        one, other = (_family_members(answer, values, integer) for answer in (mutant, reference))
        if one != other:
            return False
    return True


def _family_members(answer, values, integer):
    """The members between -20 and 20, rounded."""
    numbers = {complex(sp.sympify(family).subs(values | ({} if integer is None else {integer: k})).evalf()) for family in answer
               for k in (range(-40, 41) if integer is not None else (0,))}
    return {(round(x.real, 6) + 0.0, round(x.imag, 6) + 0.0) for x in numbers if abs(x) < 20}


def same_matrices(mutant, reference, *_):
    """True if two lists hold the same matrices, in any order."""
    return all(any(same_value(a, b) for b in reference) for a in mutant) and all(any(same_value(a, b) for a in mutant) for b in reference)


def stable_equation(mutant, reference, equation, motion, parameters):
    """As `stability_region` for the polynomial of a linear equation."""
    time, s = motion.args[0], sp.Symbol("s")
    order = max((d.derivative_count for d in equation.atoms(sp.Derivative)), default=0)
    terms = [sp.diff(equation, sp.Derivative(motion, (time, k)) if k else motion) * s**k for k in range(order + 1)]
    return stability_region(mutant, reference, sp.Add(*terms), parameters)


def spectra(mutant, reference, field, state):
    """As `same_value` for rows of a point and its eigenvalues: rows and the eigenvalues of one row have no order."""
    n = len(state)

    def same_row(one, other):
        return (len(one) == len(other) and same_value(one[:n], other[:n])
                and any(same_value(list(order), other[n:]) for order in permutations(one[n:])))

    return all(any(same_row(a, b) for b in reference) for a in mutant) and all(any(same_row(a, b) for a in mutant) for b in reference)


def first_integral(mutant, reference, field, state, *_):
    """True for every function of the state, not constant, whose derivative along the motions is identically zero."""
    rate = sum(sp.diff(mutant, x) * f for x, f in zip(state, field))
    return bool(mutant.free_symbols & set(state)) and sp.simplify(rate) == 0


def planar_region(mutant, reference, field, state, parameters, domain=None):
    """As `same_condition`, for parameters inside their domain alone; small values are tried as well as large ones."""
    intervals = {p: (domain or {}).get(p, sp.Interval.open(0, sp.oo) if p.is_positive else sp.S.Reals) for p in parameters}

    def outside(point):
        return any(intervals[p].contains(sp.Rational(v.numerator, v.denominator)) == False for p, v in point.items())  # noqa: E712

    if not same_condition(mutant, reference, outside):
        return False
    symbols, random = sorted(intervals, key=str), Random(14)
    tests = [sp.lambdify(symbols, condition, modules="math") for condition in (mutant, reference)]
    points = ([10 ** random.uniform(-2, 1.5) * (1 if p.is_positive else random.choice((-1, 1))) for p in symbols] for _ in range(4000))
    ends = [(float(intervals[p].start), float(intervals[p].end)) for p in symbols]
    return all(_holds(tests[0], point) == _holds(tests[1], point) for point in points
               if all(low < x < high for x, (low, high) in zip(point, ends)))


def growing_motion(mutant, reference, field, state, parameters, time, constants=(), program=None, part=None):
    """True for every motion of the linear system whose distance from zero has no bound."""
    matrix, motion = _linear_part(field, state, program, part), sp.Matrix(list(mutant))
    if len(motion) != matrix.rows or not (motion.diff(time) - matrix * motion).applyfunc(sp.simplify).is_zero_matrix:
        return False
    return sp.limit(sp.expand(motion.dot(motion)), time, sp.oo) == sp.oo


def conserved_form(mutant, reference, field, state, parameters, program=None, part=None):
    """True for every positive definite quadratic form whose derivative along the motions is identically zero."""
    part = list(part or state)
    velocity = _linear_part(field, state, program, part) * sp.Matrix(part)
    weights = sp.hessian(mutant, part)
    form, rate = sp.Matrix(part).dot(weights * sp.Matrix(part)) / 2, sp.Matrix([mutant]).jacobian(part).dot(velocity)
    if sp.expand(mutant - form) != 0 or sp.expand(rate) != 0:
        return False
    return bool(weights.subs({p: sp.Rational(3 + j, 2) for j, p in enumerate(parameters)}).is_positive_definite)


def _linear_part(field, state, program, part):
    rest = dict.fromkeys(state, 0) | (program or {})
    chosen = [list(state).index(s) for s in part or state]
    return sp.Matrix(field).jacobian(state).subs(rest).extract(chosen, chosen)


def same_angles(mutant, reference, field, state, parameters, integer):
    """True if two lists of angles are the same on the circle, for several values of the parameters."""
    samples = [{p: -sp.Rational(j, 7) if p.is_negative else sp.Rational(j + 2, 3) for p in parameters} for j in (1, 2, 4)]
    return all(_on_circle(mutant, values, integer) == _on_circle(reference, values, integer) for values in samples)


def _on_circle(angles, values, integer):
    """Points of the circle, rounded; an angle that is not real is a point of its own."""
    numbers = [complex(a.subs(values).subs(integer, j).evalf()) for a in map(sp.sympify, angles) for j in range(-6, 7)]
    return {"not real" if abs(x.imag) > 1e-9 else (round(math.cos(x.real), 6) + 0.0, round(math.sin(x.real), 6) + 0.0) for x in numbers}


def angle_condition(mutant, reference, field, state, parameters, angle):
    """As `same_condition`, at the multiples of an eighth of pi too, where equalities can hold."""
    if not isinstance(mutant, LOGIC):
        return False
    eighths = [sp.pi * j / 8 for j in range(16)]
    return all(mutant.subs(angle, x) == reference.subs(angle, x) for x in eighths) and same_condition(mutant, reference)


def kind_of_angles(mutant, reference, field, state, parameters):
    """True if two conditions agree wherever there are stationary angles, at many values in general position."""
    symbols = sorted(set(mutant.free_symbols | reference.free_symbols), key=str)
    tests = [sp.lambdify(symbols, condition, modules="math") for condition in (mutant, reference)]
    random, angles = np.random.default_rng(17), np.linspace(0, 2 * np.pi, 120)
    sizes = random.uniform(0, 2, size=(len(parameters), 4000, 1))
    signs = [-1 if p.is_negative else 1 if p.is_positive else random.choice((-1, 1), size=(4000, 1)) for p in parameters]
    values = dict(zip(parameters, (sign * size for sign, size in zip(signs, sizes))))
    force = sp.lambdify([state[0], *parameters], field[1].subs(state[1], 0))(angles, *values.values())
    at_rest = np.flatnonzero((force.min(axis=1) < 0) & (force.max(axis=1) > 0))
    points = np.column_stack([values[p] for p in symbols])[at_rest].tolist() if symbols else [[]]
    return all(_holds(tests[0], point) == _holds(tests[1], point) for point in points)


def breaks_bound(mutant, reference, matrix, state, factor):
    """True for every error for which |dx|^2 |H x + e|^2 >= factor^2 mu^2 |e|^2 |x|^2, in exact arithmetic."""
    if len(mutant) != matrix.rows:
        return False
    e, x = sp.Matrix(mutant).applyfunc(sp.nsimplify), sp.Matrix(state)
    change = (matrix.T * matrix).inv() * matrix.T * e
    squares = [abs(value) for value in (matrix.T * matrix).eigenvals()]
    left = change.dot(change) * (matrix * x + e).dot(matrix * x + e)
    right = sp.Integer(factor) ** 2 * max(squares) / min(squares) * e.dot(e) * x.dot(x)
    return e.dot(e) > 0 and bool(left >= right)


def stations_insufficient(mutant, reference, matrix, first, second):
    """As `same_condition`, at parallel directions and at those parallel in two components too, which chance does not meet."""
    if not isinstance(mutant, LOGIC) or not same_condition(mutant, reference):
        return False
    random = Random(18)
    for number in range(60):
        one = [random.choice((-1, 1)) * sp.Rational(random.randint(1, 40), 7) for _ in first]
        factor = sp.Rational(random.randint(1, 40), 9)
        other = [factor * part for part in one]
        if number % 4:
            other[number % 3] += sp.Rational(random.randint(1, 9), 2)
        values = dict(zip([*first, *second], [*one, *other]))
        if mutant.subs(values) != reference.subs(values):
            return False
    return True


def same_synthesis(mutant, reference, field, state, control, bounds, target, parameters=None, start=None, curve=None):
    """True if two laws, or two conditions on the start, agree at random starts: on curves they may differ."""
    parameters = parameters or {}
    return _agree_at_random(mutant, reference, {**dict.fromkeys([*state, *([curve[0]] if curve else [])], sp.S.Reals), **parameters}, start)


def same_extremals(mutant, reference, field, state, control, bounds, target, start=None):
    """True if two conditions on the start, or two times, agree at random starts."""
    return _agree_at_random(mutant, reference, dict.fromkeys(state, sp.S.Reals), start)


def same_arcs(mutant, reference, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """True if two conditions on the end points or parameters agree at random values: at single values they may differ."""
    return _agree_at_random(mutant, reference, {variable: sp.S.Reals, **(parameters or {})})


def same_curve(mutant, reference, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """True if two lists of expressions have the same values at random places: quicker than to simplify trigonometric functions."""
    if not isinstance(mutant, (list, tuple)) or len(mutant) != len(reference):
        return False
    return all(_agree_at_random(a, b, {variable: sp.S.Reals, **(parameters or {})}) for a, b in zip(mutant, reference))


def _agree_at_random(one, other, domain, given=None, count=6000):
    random, symbols = np.random.default_rng(23), list(domain)
    columns = []
    for interval in domain.values():
        low, high = (float(end) for end in (interval.inf, interval.sup))
        spread = random.normal(size=count) * random.choice((0.3, 1, 3), size=count)
        columns.append(random.uniform(low, high, count) if math.isfinite(high - low) else low + abs(spread) if math.isfinite(low)
                       else high - abs(spread) if math.isfinite(high) else spread)
    with np.errstate(all="ignore"):
        values = [np.broadcast_to(np.asarray(sp.lambdify(symbols, answer, "numpy")(*columns), dtype=float), count) for answer in (one, other)]
        keep = np.ones(count, dtype=bool) if given is None else np.asarray(sp.lambdify(symbols, given, "numpy")(*columns), dtype=bool)
    one, other = (value[keep] for value in values)
    return np.allclose(one, other, rtol=1e-9, equal_nan=True)


def same_transfer(mutant, reference, *_):
    """True if two functions of time and parameters agree at random values: at single instants, of switchings, they may differ."""
    if isinstance(mutant, (list, tuple)) or isinstance(reference, (list, tuple)):
        return same_value(mutant, reference)
    random, symbols = np.random.default_rng(29), sorted(mutant.free_symbols | reference.free_symbols, key=str)
    for _ in range(60):
        values = [int(random.integers(1, 9)) if s.is_integer else random.uniform(0.05, 4) * (1 if s.is_positive else random.choice((-1, 1)))
                  for s in symbols]
        with np.errstate(all="ignore"):
            one, other = (complex(sp.lambdify(symbols, e, "numpy")(*values)) for e in (mutant, reference))
        if not (np.isclose(one, other, rtol=1e-9, atol=1e-9) or np.isnan(one) and np.isnan(other)):
            return False
    return True


TRANSFERS = ("fastest_time", "slowest_time", "fastest_control", "slowest_control", "fastest_motion", "slowest_motion", "fastest_switching",
             "slowest_switching", "fastest_meeting", "slowest_meeting", "switchings", "isochrone_radius", "least_rate", "turning_rate")
ORACLES = {**dict.fromkeys(TRANSFERS, same_transfer), "minimal_time": same_synthesis,
           "time_optimal_law": same_synthesis, "other_extremals": same_extremals, "other_extremal_time": same_extremals, "reachable_starts": same_synthesis,
           "reached_part": same_arcs, "continuous_time": same_arcs, "switching_points": same_curve, "switching_crossing": same_curve,
           "breaks_bound": breaks_bound, "stations_insufficient": stations_insufficient, "growing_motion": growing_motion, "conserved_form": conserved_form,
           "rest_angles": same_angles, "stable_rest_angles": same_angles, "unstable_rest_angles": same_angles,
           "stable_angles": angle_condition, "saddle_angles": angle_condition,
           "focus_parameters": kind_of_angles, "node_parameters": kind_of_angles,
           "first_integral": first_integral, "focus_region": planar_region, "node_region": planar_region,
           "stationary_exists": planar_region,
           "spectra": spectra, "basin_estimate": basin_estimate, "stability_region": stability_region, "stable_equation": stable_equation,
           "rest_values": same_family, "stable_rest_values": same_family, "unstable_rest_values": same_family,
           "deviation_matrices": same_matrices}
