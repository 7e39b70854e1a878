"""Oracles of gains and of observers: SymPy's characteristic polynomials, their roots at values of
the parameters."""

import functools
import itertools
from fractions import Fraction

import sympy as sp
from sympy.core.relational import Relational

from oracles.sameness import LOGIC, holds, vanishes
from oracles.structure.records import kalman
from workbook.systems import Linear, Scalar, WithError

VALUES = (sp.Rational(1, 7), sp.Rational(3, 5), sp.Rational(13, 9), sp.Integer(4), sp.Integer(31))


def _meets(matrix, parameters, degree, polynomial, symbol, given):
    """Whether the spectrum is as required; with parameters at values of either sign, as they may
    be."""
    s = sp.Dummy("s")
    found = sp.expand((s * sp.eye(matrix.rows) - matrix).det(method="berkowitz"))
    if polynomial is not None:
        difference = found - sp.sympify(polynomial).subs(symbol, s)
        return vanishes(difference)
    for sign in (1, -1):
        for k in range(len(VALUES)):
            values = {
                p: (1 if p.is_positive else sign) * VALUES[(k + 2 * j) % len(VALUES)]
                for j, p in enumerate(parameters)
            }
            if sp.sympify(given).subs(values) is sp.false:
                continue
            there = sp.Poly(found.subs(values), s)
            if not there.free_symbols_in_domain and all(
                c.is_Rational or c.is_Float for c in there.all_coeffs()
            ):
                # Multiple roots, at which the search for all of them gets stuck, count once.
                there = sp.Poly([sp.Rational(c) for c in there.all_coeffs()], s).sqf_part()
            roots = there.nroots(n=30, maxsteps=500)
            worst = max(sp.re(root) for root in roots)
            if not (worst < 0 if degree == 0 else worst <= -degree + sp.Rational(1, 10**9)):
                return False
    return True


def _of_shape(mutant, rows, columns):
    gain = sp.Matrix(mutant)
    return gain.T if gain.shape == (columns, rows) != (rows, columns) else gain


def _empty(*answers):
    return any(isinstance(answer, (list, tuple)) and not answer for answer in answers)


def observer_gain(mutant, reference, system, *parameters, **required):
    return _is_gain(mutant, reference, system.A, system.H, *parameters, **required)


def _is_gain(
    mutant, reference, A, H, parameters=(), given=sp.true, degree=0, polynomial=None, symbol=None
):
    if _empty(mutant, reference):
        return _empty(mutant) and _empty(reference)
    L = _of_shape(mutant, A.rows, H.rows)
    return L.shape == (A.rows, H.rows) and _meets(
        A - L * H, parameters, degree, polynomial, symbol, given
    )


def feedback_gain(mutant, reference, system, **required):
    """Of a system with an output the static feedback."""
    return _is_feedback(
        mutant, reference, system.A, system.B, system.H if system.H.rows else None, **required
    )


def _is_feedback(mutant, reference, A, B, H=None, **required):
    H = sp.eye(A.rows) if H is None else H
    if _empty(mutant, reference):
        return _empty(mutant) and _empty(reference)
    K = _of_shape(mutant, B.cols, H.rows)
    # A + BKH = A - (-B)(KH): -B as a gain for the output KH
    return K.shape == (B.cols, H.rows) and _is_gain(-B, None, A, K * H, **required)


def observer_feedback_gains(mutant, reference, system, **required):
    if _empty(mutant, reference):
        return _empty(mutant) and _empty(reference)
    return (
        len(mutant) == 2
        and _is_feedback(mutant[0], None, system.A, system.B, **required)
        and _is_gain(mutant[1], None, *_observed(system), **required)
    )


def _observed(system):
    """(A, H), with the error of a measurement below the state."""
    if not isinstance(system, WithError):
        return system.A, system.H
    return sp.diag(system.A, system.S), system.H.row_join(system.c)


def state_space_form(mutant, reference, equation):
    """The adjugate gives numerator and denominator, and they keep a common root; x and its
    derivatives tell the state."""
    n, s = equation.order, equation.symbol
    A, *others = map(sp.Matrix, mutant)
    if A.shape != (n, n) or len(others) != 3 or any(len(part) != n for part in others):
        return False
    B, C, H = (part.reshape(*shape) for part, shape in zip(others, ((n, 1), (1, n), (1, n))))
    measured = sum((a * C * A**k for k, a in enumerate(equation.coefficients[2])), sp.zeros(1, n))
    pencil = s * sp.eye(n) - A
    same = [
        pencil.det() - equation.left,
        (C * pencil.adjugate() * B)[0] - equation.right,
        *(H - measured),
    ]
    return (
        all(sp.expand(difference) == 0 for difference in same)
        and sp.Matrix.vstack(*(C * A**k for k in range(n))).det() != 0
    )


def equation_gains(mutant, reference, equation):
    """The degree asked for is that of the greatest common divisors, as SymPy factors them."""
    common = [
        root
        for side in (equation.right, equation.measured)
        for root in sp.roots(sp.gcd(equation.left, side), equation.symbol)
    ]
    degree = -max(map(sp.re, common)) if common else 0
    return (
        len(mutant) == 6
        and state_space_form(mutant[:4], None, equation)
        and observer_feedback_gains(
            mutant[4:],
            [1],
            Linear(
                mutant[0],
                _of_shape(mutant[1], equation.order, 1),
                _of_shape(mutant[3], 1, equation.order),
            ),
            degree=degree,
        )
    )


def _equation_region(mutant, equation, gain, parameters):
    """At all roots of Hurwitz's minors and of the terms of the mutant, and between them, for a
    single parameter."""
    if not isinstance(mutant, LOGIC):
        return False
    (p,) = parameters
    minors = _minors(equation.left - gain * equation.right * equation.measured, equation.symbol)
    turns = set().union(
        *(
            sp.Poly(turn, p).real_roots()
            for turn in (*minors, *(atom.lhs - atom.rhs for atom in mutant.atoms(Relational)))
            if turn.has(p)
        )
    )
    turns = sorted(turns, key=float)
    between = [
        (sp.Rational(float(one)) + sp.Rational(float(other))) / 2
        for one, other in itertools.pairwise(turns)
    ]
    ends = [sp.floor(turns[0]) - 1, sp.ceiling(turns[-1]) + 1] if turns else [sp.Integer(0)]
    return all(
        (mutant.subs(p, place) == sp.true)
        == all(sp.simplify(minor.subs(p, place)) > 0 for minor in minors)
        for place in (*turns, *between, *ends)
    )


def observer_equations(
    mutant,
    reference,
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
    """The rate of d = x - e is computed with symbols: it must not hold x and u."""
    A, B, H = system.A, system.B, system.H
    state = sp.Matrix(sp.symbols(f"x1:{A.rows + 1}", cls=sp.Dummy))
    error = sp.Matrix(sp.symbols(f"d1:{A.rows + 1}", cls=sp.Dummy))
    if len(list(mutant)) != A.rows:
        return False
    names = {symbol.name: symbol for symbol in (*estimates, *outputs, *controls, *parameters)}
    mutant = [
        right.subs({s: names.get(s.name, s) for s in right.free_symbols})
        for right in map(sp.sympify, mutant)
    ]
    known = dict(zip(estimates, state - error)) | dict(zip(outputs, H * state))
    pushed = A * state + (B * sp.Matrix(controls) if controls else sp.zeros(A.rows, 1))
    rate = (pushed - sp.Matrix(mutant).subs(known, simultaneous=True)).expand()
    matrix = rate.jacobian(list(error))
    if matrix.free_symbols & {*state, *error} or (rate - matrix * error).expand() != sp.zeros(
        A.rows, 1
    ):
        return False
    return _meets(matrix, parameters, degree, polynomial, symbol, given)


def _region(mutant, matrix, parameters, degree):
    """Hurwitz's minors in fractions on a fine grid, and where a term of the mutant vanishes on its
    lines; the border of a degree is left out."""
    if not isinstance(mutant, LOGIC):
        return False
    least = _least_minor(sp.ImmutableMatrix(matrix), tuple(parameters), degree)
    said = sp.lambdify(parameters, mutant, "math")
    grid = (point for _, line in _lines(len(parameters)) for point in line)
    # most mutants differ on the grid already
    for point in itertools.chain(grid, _zeros(mutant, parameters)):
        if any(p.is_positive and not x > 0 for p, x in zip(parameters, point)):
            continue
        sign = least(point)
        if degree and sign == 0:
            continue
        if all(x.denominator in (1, 2, 4) for x in point):
            there = holds(said, point)
        else:  # a zero of a term, which floating-point numbers would miss
            there = mutant.subs(dict(zip(parameters, map(sp.Rational, point)))) is sp.true
        if there != (sign > 0):
            return False
    return True


@functools.lru_cache(maxsize=8)
def _least_minor(matrix, parameters, degree):
    """The least of Hurwitz's minors as a function of a point: the same for all mutants of a
    region."""
    s = sp.Dummy("s")
    polynomial = ((s - degree) * sp.eye(matrix.rows) - matrix).det(method="berkowitz")
    minors = sp.lambdify(parameters, _minors(polynomial, s), [])
    return functools.lru_cache(maxsize=None)(lambda point: min(minors(*point)))


def _minors(polynomial, symbol):
    terms = sp.Poly(polynomial, symbol).all_coeffs()
    n = len(terms) - 1
    table = sp.Matrix(n, n, lambda i, j: terms[2 * j - i + 1] if 0 <= 2 * j - i + 1 <= n else 0)
    return [sp.expand(table[:k, :k].det(method="berkowitz")) for k in range(1, n + 1)]


@functools.cache
def _lines(count):
    """Lines of a grid: pairs of the number of the parameter that varies and the points, `count`
    fractions each."""
    grid = [Fraction(k, 4) for k in range(-20, 21)]
    return [
        (k, [(*others[:k], x, *others[k : count - 1]) for x in grid])
        for k, others in itertools.product(
            range(count), zip(*[grid[5 * j :] + grid[: 5 * j] for j in range(max(count - 1, 1))])
        )
    ]


def _zeros(mutant, parameters):
    """The rational zeros of the terms of a condition on the lines of the grid."""
    for k, line in _lines(len(parameters)):
        fixed = dict(zip(parameters, map(sp.Rational, line[0])))
        del fixed[parameters[k]]
        for atom in mutant.atoms(Relational):
            term = sp.numer(sp.together((atom.lhs - atom.rhs).subs(fixed)))
            if term.has(parameters[k]):
                yield from (
                    (*line[0][:k], Fraction(int(root.p), int(root.q)), *line[0][k + 1 :])
                    for root in sp.Poly(term, parameters[k]).ground_roots()
                )


def gain_region(mutant, reference, system, gain, parameters, degree=0):
    if isinstance(system, Scalar):
        return _equation_region(mutant, system, gain, parameters)
    A, B, H = system.A, system.B, system.H
    loop = A - gain * H if not B.cols else A + B * gain * H if H.rows else A + B * gain
    return _region(mutant, loop, parameters, degree)


@functools.lru_cache(maxsize=256)
def _hidden(matrix, output):
    """The eigenvalues of modes that the output does not show."""
    if kalman(matrix, output).rank() == matrix.rows:
        return []
    return [
        root
        for root in matrix.eigenvals()
        if (matrix - root * sp.eye(matrix.rows)).col_join(output).rank() < matrix.rows
    ]


def possible_degrees(mutant, reference, system, mu, parameters=()):
    """On a grid of the parameters, by the rank of (A - lambda E; H) at each eigenvalue; at every
    place about the degree found and about the roots of the mutant's terms in mu."""
    if not isinstance(mutant, LOGIC):
        return False
    mutant = mutant.subs(
        {
            symbol: named
            for symbol in mutant.free_symbols
            for named in (*parameters, mu)
            if symbol.name == named.name
        }
    )
    grid = [sp.Rational(k, 2) for k in range(-4, 5)]
    for place in itertools.product(grid, repeat=len(parameters)):
        values = dict(zip(parameters, place))
        said, hidden = mutant.subs(values), _out_of_reach(system, values)
        best = min((-sp.re(root) for root in hidden), default=None)
        turns = [
            root
            for atom in said.atoms(Relational)
            for root in sp.Poly(atom.lhs - atom.rhs, mu).real_roots()
        ]
        turns += [best] if hidden else []
        for degree in {
            turn + step
            for turn in turns
            for step in (sp.Rational(-1, 1000), 0, sp.Rational(1, 1000))
        } | {sp.Rational(1, 7), sp.Integer(50)}:
            if degree > 0 and (said.subs(mu, degree) == sp.true) != (not hidden or degree <= best):
                return False
    return True


def _out_of_reach(system, values):
    """The eigenvalues that no gain changes; of a `Scalar` the common roots of its sides."""
    if isinstance(system, Scalar):
        return [
            root
            for side in (system.right, system.measured)
            for root in sp.roots(sp.gcd(system.left, side), system.symbol)
        ]
    pairs = [(system.A.T, system.B.T)] * (system.B.cols > 0) + [_observed(system)] * (
        system.H.rows > 0
    )
    return [
        root
        for pair in pairs
        for root in _hidden(*(sp.ImmutableMatrix(part.subs(values)) for part in pair))
    ]


def undetectable_mode(mutant, reference, system, parameters=()):
    A, H = system.A, system.H
    if not mutant or not reference:
        return not mutant and not reference
    places = [dict.fromkeys(parameters, value) for value in (0, *VALUES)]
    for value, vector in mutant.items():
        v = sp.Matrix(list(vector))
        if v.rows != A.rows:
            return False
        if not sp.re(value) >= 0 or not all(
            sp.simplify(part).is_zero_matrix for part in (A * v - value * v, H * v)
        ):
            return False
        if any(
            v.subs(values).is_zero_matrix or v.subs(values).has(sp.zoo, sp.nan) for values in places
        ):
            return False
    return True


ORACLES = {
    "observer_gain": observer_gain,
    "feedback_gain": feedback_gain,
    "observer_feedback_gains": observer_feedback_gains,
    "state_space_form": state_space_form,
    "equation_gains": equation_gains,
    "observer_equations": observer_equations,
    "gain_region": gain_region,
    "possible_degrees": possible_degrees,
    "undetectable_mode": undetectable_mode,
}
