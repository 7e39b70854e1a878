"""Oracles of observability and controllability: SymPy's ranks, null spaces and solutions of linear
equations, on Kalman's matrix."""

import functools
import itertools

import sympy as sp
from sympy.core.relational import Relational

from oracles.sameness import LOGIC, same_value
from oracles.structure.records import kalman, reached, seen
from workbook.systems import Deviations, Linear, Measurements, Varying, WithError


@functools.lru_cache(maxsize=32)
def _simplified_rank(matrix):
    return matrix.rank(simplify=True)


def region(rows, holds=True):
    """As the minors of Kalman's matrix say, along lines on which one parameter varies: at every
    root of theirs and of the mutant's terms, irrational ones too, and between them; where the data
    allow the value."""
    return lambda mutant, reference, system, parameters: _as_minors_say(
        mutant, rows(system), parameters, holds
    )


def observable_parameters(mutant, reference, system, parameters, part=None):
    """The same, of constants by the Jacobian, and for an error in the measurement by what the
    vectors that are not seen have of the state, or of C."""
    if isinstance(system, Measurements):
        return _as_minors_say(mutant, _jacobian(system), parameters, True)
    n = system.unknowns - 1
    found = {
        None: lambda v: False,
        "state": lambda v: not any(v[:n]),
        "error": lambda v: v[n] == 0,
    }[part]
    if not isinstance(system, (WithError, Varying)):
        return _as_minors_say(mutant, seen(system), parameters, True)
    return _where(mutant, seen(system), *parameters, found)


def _where(mutant, N, parameter, found):
    """Whether a condition holds exactly at those values where `found` is true of all vectors of the
    null space."""
    if not isinstance(mutant, LOGIC):
        return False
    rows = [N.row(i) for i in range(N.rows) if any(N.row(i))]
    minors = (
        sp.Poly(sp.Matrix.vstack(*chosen).det(), parameter)
        for chosen in itertools.combinations(rows[:8], N.cols)
    )
    common = functools.reduce(sp.gcd, (minor for minor in minors if not minor.is_zero))
    return all(
        _holds(mutant, parameter, value)
        == all(found(v) for v in N.subs(parameter, value).applyfunc(sp.simplify).nullspace())
        for value in _values(parameter, common, mutant)
    )


def _jacobian(system):
    """Its roots and denominators left out: a row has them in common."""
    found = (
        sp.Matrix(system.quantities)
        .jacobian(system.unknown)
        .applyfunc(lambda entry: sp.numer(sp.together(entry)))
    )
    return found.subs(system.at, simultaneous=True)


def _as_minors_say(mutant, N, parameters, holds):
    if isinstance(mutant, list) and len(parameters) == 1:
        mutant = sp.Or(*[sp.Eq(parameters[0], value) for value in mutant])
    if not isinstance(mutant, LOGIC):
        return False
    for fixed, free, common in _minors_on_lines(N.as_immutable(), tuple(parameters)):
        condition = mutant.subs(fixed)
        for value in _values(free, common, condition):
            lost = sp.simplify(common.as_expr().subs(free, value)) == 0
            if _holds(condition, free, value) != ((not lost) == holds):
                return False
    return True


@functools.lru_cache(maxsize=8)
def _minors_on_lines(N, parameters):
    """For all mutants of an answer: (what is fixed, what varies, the common divisor of the minors
    there)."""
    minors = {
        sp.numer(sp.together(N.extract(list(rows), list(range(N.cols))).det()))
        for rows in itertools.combinations(range(N.rows), N.cols)
    }
    found = []
    for fixed in _lines(parameters):
        (free,) = set(parameters) - set(fixed)
        found.append(
            (
                fixed,
                free,
                functools.reduce(sp.gcd, [sp.Poly(minor.subs(fixed), free) for minor in minors]),
            )
        )
    return found


def unobservable_states(mutant, reference, system, parameters=(), start=()):
    """Of constants independent combinations of the vectors of the reference, as many; a single
    vector may be itself."""
    if (
        isinstance(mutant, list)
        and mutant
        and all(isinstance(part, (int, sp.Expr)) for part in mutant)
    ):
        mutant = [mutant]
    if not isinstance(system, Measurements):
        return is_basis(mutant, seen(system).as_immutable())
    size = system.unknowns
    if (
        not isinstance(mutant, (list, tuple))
        or len(mutant) != len(reference)
        or any(not isinstance(v, (list, tuple)) or len(v) != size for v in mutant)
    ):
        return False
    both = [sp.Matrix(vectors).T for vectors in (mutant, reference)]
    return (
        both[0].rank(simplify=True) == sp.Matrix.hstack(*both).rank(simplify=True) == len(reference)
    )


def uncontrollable_combinations(mutant, reference, system, parameters=()):
    return is_basis(mutant, reached(system).as_immutable())


def is_basis(vectors, N):
    """True for independent vectors of the null space of N, as many as it has dimensions."""
    if not isinstance(vectors, (list, tuple)) or any(
        not isinstance(v, (list, tuple, sp.MatrixBase)) or len(v) != N.cols for v in vectors
    ):
        return False
    vectors = [sp.Matrix(list(vector)) for vector in vectors]
    count = N.cols - _simplified_rank(N)
    return (
        all(_is_zero(N * v) for v in vectors)
        and len(vectors) == count
        and (not vectors or sp.Matrix.hstack(*vectors).rank(simplify=True) == count)
    )


def same_numbers(mutant, reference, *_):
    """True if two lists hold the same numbers, in any order and counted as often as one likes; or
    if two numbers, for which no list was made, are the same."""
    mutant, reference = (
        [numbers] if isinstance(numbers, sp.Expr) else numbers for numbers in (mutant, reference)
    )
    return all(any(same_value(a, b) for b in reference) for a in mutant) and all(
        any(same_value(a, b) for a in mutant) for b in reference
    )


def decomposition(mutant, reference, system, parameters=()):
    if system.B.cols:
        return _is_split(sp.Matrix(mutant).T, system.A.T, system.B.T, parameters)
    return _is_split(mutant, system.A, system.H, parameters)


def _is_split(mutant, A, H, parameters):
    """True if T is invertible and T A T^-1, H T^-1 have the zeros of the form (2.7)."""
    T = sp.Matrix(mutant)
    if T.shape != A.shape or sp.simplify(T.det()) == 0 or not _keeps_rank(T, A, H, parameters):
        return False
    return _has_blocks(T * A * T.inv(), H * T.inv(), _simplified_rank(kalman(A, H)))


def decomposed_system(mutant, reference, system, parameters=()):
    if len(mutant) != 2:
        return False
    if system.B.cols:
        return _is_split_system(
            [sp.Matrix(part).T for part in mutant], system.A.T, system.B.T, parameters
        )
    return _is_split_system(mutant, system.A, system.H, parameters)


def parallel_system(mutant, reference, system):
    """True if it is an image of the system, and the unit matrix its parallel decomposition."""
    if not decomposed_system(mutant, reference, system):
        return False
    A, coupling = map(sp.Matrix, mutant)
    claimed = Linear(A, coupling) if system.B.cols else Linear(A, H=coupling)
    return by_components(parallel)(sp.eye(A.rows), reference, claimed)


def _is_split_system(mutant, A, H, parameters):
    """True if the blocks are zero and some invertible T has T A = A' T and H = H' T."""
    if sp.Matrix(mutant[0]).shape != A.shape or sp.Matrix(mutant[1]).shape != H.shape:
        return False
    new_A, new_H = map(sp.Matrix, mutant)
    if not _keeps_rank(kalman(new_A, new_H), A, H, parameters):
        return False
    return _has_blocks(new_A, new_H, _simplified_rank(kalman(A, H))) and _is_image(
        A, H, new_A, new_H
    )


def by_components(oracle):
    """Of a system with a control the transposed matrices."""
    return lambda mutant, reference, system: (
        oracle(sp.Matrix(mutant).T, system.A.T, system.B.T)
        if system.B.cols
        else oracle(sp.Matrix(mutant), system.A, system.H)
    )


def sequential(T, A, H):
    """True if the parts of T are invariant one after the other and each output shows its own part
    alone."""
    if T.shape != A.shape or T.det() == 0:
        return False
    new_A, new_H = T * A * T.inv(), H * T.inv()
    ends = [0, *(kalman(A, H[:k, :]).rank() for k in range(1, H.rows + 1))]
    for k, (begin, end) in enumerate(itertools.pairwise(ends)):
        if not new_A[begin:end, end:].is_zero_matrix or not new_H[k, end:].is_zero_matrix:
            return False
        if end > begin and not new_H[k, :begin].is_zero_matrix:
            return False
    return True


def parallel(T, A, H):
    """True if every part of T lies, power by power, in the span of its own chain and of lower
    powers."""
    n = A.rows
    if T.shape != A.shape or T.det() == 0:
        return False
    levels = [sp.Matrix.vstack(*[H * A**j for j in range(k + 1)]) for k in range(n)]
    # A row of a chain counts if it is independent of those with lower powers and, at its own power,
    # of earlier chains.
    sizes = [
        sum(
            _rank(before, H[: k + 1, :] * A**j) > _rank(before, H[:k, :] * A**j)
            for j in range(n)
            for before in [levels[j - 1] if j else sp.zeros(1, n)]
        )
        for k in range(H.rows)
    ]
    first = 0
    for k, size in enumerate(sizes):
        part, first = T[first : first + size, :], first + size
        for j in range(size):
            inside = _meeting(part, levels[j])
            own = [levels[j - 1]] * (j > 0) + [H[k, :] * A**j]
            if inside.rows != j + 1 or _rank(*own, inside) > _rank(*own):
                return False
    return True


def similarity_matrix(mutant, reference, system, other, parameters=()):
    """True if S is invertible and turns A into the other matrix, in deviations the derivatives of
    the field along the motion, taken one by one."""
    S, A_from = sp.Matrix(mutant), system.A
    n = A_from.rows
    A_to = (
        other.A
        if not isinstance(other, Deviations)
        else sp.Matrix(
            n, n, lambda i, j: sp.diff(other.field[i], other.state[j]).subs(other.motion)
        )
    )
    return S.shape == A_from.shape and sp.simplify(S.det()) != 0 and _is_zero(S * A_from - A_to * S)


def _keeps_rank(matrix, A, H, parameters):
    """Whether the rank of a matrix falls nowhere at values of a single parameter at which that of
    the system does not.
    """
    if len(parameters) != 1 or not matrix.free_symbols:
        return True
    (p,), rank = parameters, matrix.rank(simplify=True)
    minors = [
        sp.numer(sp.together(matrix.extract(list(rows), list(columns)).det()))
        for rows in itertools.combinations(range(matrix.rows), rank)
        for columns in itertools.combinations(range(matrix.cols), rank)
    ]
    common = sp.Poly(functools.reduce(sp.gcd, minors), p)
    roots = [
        root
        for root in (common.real_roots() if common.degree() > 0 else ())
        if not ((p.is_positive and root <= 0) or (p.is_nonzero and root == 0))
    ]
    N = kalman(A, H)
    return all(N.subs(p, root).rank(simplify=True) < _simplified_rank(N) for root in roots)


def _is_zero(matrix):
    return matrix.applyfunc(sp.simplify).is_zero_matrix


def _has_blocks(new_A, new_H, order):
    return _is_zero(new_A[:order, order:]) and _is_zero(new_H[:, order:])


def _is_image(A, H, new_A, new_H):
    """Whether T A = A' T, H = H' T has a solution T of full rank: one with random values for what
    is left free."""
    new_A, new_H = (
        part.applyfunc(lambda x: sp.nsimplify(x, rational=True)) for part in (new_A, new_H)
    )
    T = sp.Matrix(new_A.rows, A.rows, lambda i, j: sp.Symbol(f"t{i}_{j}"))
    equations = [e for e in [*(T * A - new_A * T), *(H - new_H * T)] if e != 0]
    for solution in sp.linsolve(equations, list(T)):
        solved = sp.Matrix(T.rows, T.cols, list(solution))
        left = sorted(solved.free_symbols & set(T), key=str)
        values = {
            symbol: sp.Integer(3 + 7 * k**2 % 23 - 11 * (k % 2)) for k, symbol in enumerate(left)
        }
        return solved.subs(values).rank(simplify=True) == T.rows
    return False


def _rank(*parts):
    return sp.Matrix.vstack(*parts).rank()


def _meeting(one, other):
    """The rows that span the intersection of two row spaces; the first one has independent rows."""
    independent = [other.row(i) for i in other.T.rref()[1]]
    relations = sp.Matrix.vstack(one, *independent).T.nullspace()
    return sp.Matrix.vstack(
        sp.zeros(0, one.cols), *[relation[: one.rows, :].T * one for relation in relations]
    )


def _lines(parameters):
    """Values of all parameters but one, each of them in turn left free."""
    for free in parameters:
        others = [p for p in parameters if p != free]
        sets = ((3, 7, 11), (5, -2, 13), (-4, 9, -6), (0, 0, 0), (1, 1, 1)) if others else ((),)
        for numbers in sets:
            fixed = {p: sp.Rational(x, 2) for p, x in zip(others, itertools.cycle(numbers))}
            if all(_allowed(p, x) for p, x in fixed.items()):
                yield fixed


def _values(free, common, condition):
    """The real roots of the minors and of the condition's terms, and numbers between and beside
    them, as the data allow."""
    polys = [common] + [
        sp.Poly(sp.numer(sp.together(atom.lhs - atom.rhs)), free)
        for atom in condition.atoms(Relational)
        if atom.has(free) and sp.numer(sp.together(atom.lhs - atom.rhs)).is_polynomial(free)
    ]
    roots = {sp.Integer(0)} | {
        root for poly in polys if poly.degree() > 0 for root in _real_roots(poly)
    }
    ordered = sorted(roots, key=lambda root: root.evalf(30))
    between = [
        sp.nsimplify(((a + b) / 2).evalf(15), rational=True) for a, b in itertools.pairwise(ordered)
    ]
    beside = [sp.floor(ordered[0]) - 1, sp.ceiling(ordered[-1]) + 1]
    return [value for value in [*ordered, *between, *beside] if _allowed(free, value)]


def _real_roots(poly):
    try:
        return sp.real_roots(poly)
    except NotImplementedError:  # its coefficients are irrational
        return [root for root in sp.roots(poly) if root.is_real]


def _holds(condition, free, value):
    """The truth value at one place, whose number may be irrational; False where a term is
    undefined."""
    try:
        put = condition.replace(
            lambda node: isinstance(node, Relational),
            lambda node: node.func(sp.simplify((node.lhs - node.rhs).subs(free, value)), 0),
        )
        return bool(put)
    except TypeError:
        return False


def _allowed(symbol, value):
    return not (
        (symbol.is_positive and not value > 0)
        or (symbol.is_negative and not value < 0)
        or (symbol.is_nonzero and value == 0)
    )


ORACLES = {
    "observable_parameters": observable_parameters,
    "unobservable_parameters": region(seen, holds=False),
    "controllable_parameters": region(reached),
    "unobservable_states": unobservable_states,
    "uncontrollable_combinations": uncontrollable_combinations,
    "fixed_eigenvalues": same_numbers,
    "decomposition": decomposition,
    "decomposed_system": decomposed_system,
    "sequential_decomposition": by_components(sequential),
    "parallel_decomposition": by_components(parallel),
    "parallel_system": parallel_system,
    "similarity_matrix": similarity_matrix,
}
