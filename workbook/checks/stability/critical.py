"""Stability of x' = A x with roots on the imaginary axis.

Multiplicities, motions that grow without bound, and conserved quadratic forms.

The matrix is that of the deviation equations from zero, or, where a `program` is given, from a
nominal motion (`workbook.checks.stability.nominal_motions`); a `part` of the state picks a subsystem that
does not depend on the others. The verdict is computed from the matrix at sampled values of the
parameters: clusters of eigenvalues and ranks of A - lambda I, by singular values.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Choice
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.stability.linearisation import STABILITY
from workbook.checks.stability.nominal_motions import Motion
from workbook.checks.tools.comparisons import SameWord
from workbook.checks.tools.conditions import (
    ReferenceCondition,
    compare,
    contradiction_message,
    decide,
    exactly,
)
from workbook.checks.tools.samples import in_every_case, sample_values
from workbook.checks.tools.values import matrix_at, number_at, numbers_at
from workbook.checks.tools.wording import (
    number_text,
    point_text,
    rounded_text,
    values_text,
    where_text,
)

#: Eigenvalues closer together than this, relative to the size of the matrix, are one eigenvalue: a
#: Jordan block of order m spreads its eigenvalue by the m-th root of the rounding error.
SPREAD = 2e-5


@judged
def eigenvalue_multiplicities(answer, field, state, parameters, program=None, part=None):
    """Check all eigenvalues as [value, algebraic multiplicity, geometric multiplicity].

    The values are judged by the characteristic polynomial, the last number by the rank of A -
    lambda I.

    Can decide when the coefficients are constant and exact.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.eigenvalue_multiplicities([[0, 2, 1]], [y, 0], [x, y], []).status
    'right'
    >>> checks.eigenvalue_multiplicities([[0, 2, 2]], [y, 0], [x, y], []).status
    'wrong'
    """
    rows = _rows(answer, parameters)
    for values, matrix in _matrices(
        field, state, parameters, program, part, [list(row) for row in rows]
    ):
        n, size = len(matrix), np.linalg.norm(matrix)
        numbers = [
            number_at(value, values, f"your eigenvalue number {k}")
            for k, (value, _, _) in enumerate(rows, 1)
        ]
        for k, number in enumerate(numbers):
            smallest = min(np.linalg.svd(matrix - number * np.eye(n), compute_uv=False))
            if not smallest <= 1e-9 * size:
                raise Wrong(
                    f"your {number_text(number)} is no eigenvalue{where_text(values)}: A - lambda "
                    "I has an inverse there"
                )
            if any(abs(number - previous) < SPREAD * size for previous in numbers[:k]):
                raise Wrong(
                    f"the eigenvalue {number_text(number)} is listed twice{where_text(values)}; "
                    "give each eigenvalue once, with its multiplicities"
                )
        if sum(algebraic for _, algebraic, _ in rows) != n:
            raise Wrong(
                "the algebraic multiplicities that you give add up to "
                f"{sum(a for _, a, _ in rows)}, and the characteristic polynomial is of degree {n}"
            )
        eigenvalues = np.linalg.eigvals(matrix)
        for number, (_, algebraic, geometric) in zip(numbers, rows):
            if sum(abs(eigenvalues - number) < SPREAD * size) != algebraic:
                raise Wrong(
                    f"{number_text(number)} is a root of the characteristic equation, but not of "
                    f"the multiplicity {algebraic}{where_text(values)}"
                )
            if _eigenvectors(matrix, number) != geometric:
                raise Wrong(
                    f"the number of independent eigenvectors for {number_text(number)} is not "
                    f"{geometric}{where_text(values)}: look at the rank of A - lambda I"
                )
    return (
        "they are all roots of the characteristic equation, with your multiplicities, and A - lambda I "
        "has the ranks that go with your numbers of eigenvectors"
    )


@judged(Choice(words=STABILITY))
def critical_stability(claim, field, state, parameters, program=None, part=None):
    """Check whether x = 0 of a linear system is asymptotically stable, stable or unstable.

    The word "stable" means stable but not asymptotically.

    Can decide when the system is linear, with constant or given time-varying coefficients; its
    motions are followed for long times.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.critical_stability("stable", [y, -x], [x, y], []).status
    'right'
    >>> checks.critical_stability("unstable", [y, -x], [x, y], []).status
    'wrong'
    """
    verdicts = [
        (values, matrix, stability(matrix))
        for values, matrix in _matrices(field, state, parameters, program, part)
    ]
    if len({verdict for _, _, verdict in verdicts}) > 1:
        raise RuntimeError("the verdict depends on the parameters")
    values, matrix, reference = verdicts[0]
    duration = 20 / np.linalg.norm(matrix)
    message = (
        "among the motions that start at distance one from zero, the farthest is at the distance "
        f"{_distance(matrix, duration)} at t = {duration:.4g}, and {_distance(matrix, 100 * duration)} "
        f"after a hundred times as long{where_text(values)}"
    )
    return (yield SameWord(claim, reference, message, "this does not agree with the motions: "))


@judged
def stable_parameters(answer, field, state, parameters, program=None, part=None):
    """Check the parameters for which x = 0 of a linear system is stable.

    This includes asymptotic stability.

    Can decide when the coefficients are constant; the condition is compared with the motions at
    sample parameters, and on its border.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> b = sp.Symbol("b", real=True)
    >>> checks.stable_parameters(b >= 0, [y, -x - b*y], [x, y], [b]).status
    'right'
    >>> checks.stable_parameters(b > 0, [y, -x - b*y], [x, y], [b]).status
    'wrong'
    """
    at = _linear_part(field, state, parameters, program, part)

    def message(values):
        matrix = at(values)
        duration = 2000 / np.linalg.norm(matrix)
        return (
            "there, among the motions that start at distance one from zero, the farthest is at the "
            f"distance {_distance(matrix, duration)} at t = {duration:.4g}"
        )

    reference = ReferenceCondition(at=lambda values: stability(at(values)) != "unstable")
    agreement = compare(answer, parameters, reference, contradiction_message(message))
    return f"for these parameters, and for no others, all motions stay bounded: {agreement}"


@judged
def unbounded_motion(answer, field, state, parameters, time, constants=(), program=None, part=None):
    """Check a motion x(t) of x' = A x that grows without bound and so proves instability.

    Can decide when the system is linear: the equations are tried at sample times, the growth far
    out.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> t = sp.Symbol("t", positive=True)
    >>> checks.unbounded_motion([t, 1], [y, 0], [x, y], [], t).status
    'right'
    >>> checks.unbounded_motion([t, 2], [y, 0], [x, y], [], t).status
    'wrong'
    """
    part = list(state if part is None else part)
    motion = coercion.as_expressions(answer, [time, *constants, *parameters], len(part))
    rates = [sp.diff(component, time) for component in motion]
    random = np.random.default_rng(13)
    for values, matrix in _matrices(field, state, parameters, program, part, motion):
        values = values | {c: sp.Rational(int(random.integers(3, 30)), 11) for c in constants}
        moments = [
            values | {time: moment}
            for moment in (sp.Rational(3, 7), sp.Rational(29, 11), sp.Rational(-13, 9))
        ]
        for at in in_every_case(moments, motion):
            moment = at[time]
            x, rate = numbers_at(motion, at, part), numbers_at(rates, at, [f"{s}'" for s in part])
            if not np.linalg.norm(x.imag) <= 1e-9 * (1 + np.linalg.norm(x)):
                raise Wrong(f"this motion is not real{where_text(values)}, {time} = {moment}")
            if np.linalg.norm(x) == 0:
                raise Wrong("this is the equilibrium; it does not grow")
            residuals = abs(matrix @ x - rate)
            if (
                not max(residuals)
                <= 1e-9 * (np.linalg.norm(matrix) * np.linalg.norm(x) + np.linalg.norm(rate))
                < np.inf
            ):
                k = int(np.argmax(residuals))
                raise Wrong(
                    f"the equation for {part[k]}' does not hold{where_text(values)} at {time} = "
                    f"{moment}: the derivative of your {part[k]} is {rate[k].real:.4g}, and the "
                    "right-hand side is not"
                )
        early, late = (
            max(_logarithm(motion, values | {time: sp.Integer(moment)}) for moment in moments)
            for moments in ((0, 1, 7, 10), (10**6, 10**6 + 1))
        )
        if not late > early + np.log(1e3):
            raise Wrong(
                f"it satisfies the equations but does not grow: its distance from zero is up to "
                f"{np.exp(early):.4g} at first and {np.exp(late):.4g} at {time} = 1000000"
                f"{where_text(values)}"
            )
    return (
        "it satisfies the equations, and its distance from zero exceeds every bound; so does "
        "every multiple of it, however small its initial state"
    )


@judged
def limit_state(answer, field, state, parameters, start, program=None, part=None):
    """Check the limit of x(t) for t to infinity, a linear function of the initial state `start`.

    Can decide when the linear system has a limit for every initial state; with parameters at
    sample values.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> x0, y0 = sp.symbols("x0 y0", real=True)
    >>> checks.limit_state([x0 + y0, 0], [y, -y], [x, y], [], [x0, y0]).status
    'right'
    >>> checks.limit_state([x0, 0], [y, -y], [x, y], [], [x0, y0]).status
    'wrong'
    """
    part = list(state if part is None else part)
    limit = coercion.as_expressions(answer, [*start, *parameters], len(part))
    for values, matrix in _matrices(field, state, parameters, program, part, limit):
        late, later = (
            _exponential(matrix * duration / np.linalg.norm(matrix)) for duration in (3e3, 6e3)
        )
        if np.linalg.norm(later - late) > 1e-8 * np.linalg.norm(late):
            raise RuntimeError("these motions do not settle")
        samples = [
            values | {s: sp.Integer(int(x)) for s, x in zip(start, initial)}
            for initial in (*np.eye(len(part)), np.arange(1, len(part) + 1))
        ]
        for at in in_every_case(samples, limit):
            initial = np.array([float(at[s]) for s in start])
            claimed = numbers_at(limit, at, [f"limit of {s}" for s in part])
            true = late @ initial
            if not np.linalg.norm(claimed - true) <= 1e-7 * np.linalg.norm(initial):
                raise Wrong(
                    f"the motion from {point_text(initial)} does not come to your limit "
                    f"{point_text(claimed.real)}{where_text(values)}"
                )
    return "motions from several initial states come to these states"


@judged
def conserved_quadratic_form(answer, field, state, parameters, program=None, part=None):
    """Check a positive definite quadratic form that is constant along all motions.

    The motions are those of the linear system.

    Can decide when the system is linear: the derivative along the motions is compared as an
    identity.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.conserved_quadratic_form(x**2 + y**2, [y, -x], [x, y], []).status
    'right'
    >>> checks.conserved_quadratic_form(x**2 + 2*y**2, [y, -x], [x, y], []).status
    'wrong'
    """
    part = list(state if part is None else part)
    form = coercion.as_expression(answer, [*part, *parameters])
    for values, matrix in _matrices(field, state, parameters, program, part):
        expanded = sp.expand(form.xreplace(values))
        if not expanded.is_polynomial(*part) or any(
            sum(powers) != 2 for powers in sp.Poly(expanded, *part).monoms()
        ):
            raise Wrong(
                f"this is no quadratic form in {', '.join(s.name for s in part)}: every term has "
                "to be of second order in them"
            )
        weights = matrix_at(sp.hessian(expanded, part), {})
        if abs(weights.imag).max() > 0:
            raise Wrong(f"its coefficients are not real{where_text(values)}")
        weights = weights.real
        rate = weights @ matrix + (weights @ matrix).T
        if not np.linalg.norm(rate) <= 1e-9 * np.linalg.norm(weights) * np.linalg.norm(matrix):
            row, column = np.unravel_index(np.argmax(abs(rate)), rate.shape)
            raise Wrong(
                f"it is not conserved: its derivative along the motions has the term "
                f"{part[row]}*{part[column]} with the "
                f"coefficient {rate[row, column] / (2 if row == column else 1):.4g}{where_text(values)}"
            )
        lowest = np.linalg.eigvalsh(weights)
        if not lowest[0] > 1e-9 * lowest[-1]:
            direction = np.linalg.eigh(weights)[1][:, 0]
            direction = np.where(abs(direction) < 1e-9, 0, direction)
            direction_text = ", ".join(f"{s} = {x:.3g}" for s, x in zip(part, direction))
            value_text = (
                "zero"
                if lowest[0] >= -1e-9 * lowest[-1]
                else f"{direction @ weights @ direction / 2:.3g}"
            )
            raise Wrong(
                f"it is conserved but not positive definite: it is {value_text} at "
                f"{direction_text}{where_text(values)}"
            )
    minors = [
        sp.hessian(sp.expand(form), part)[:k, :k].det(method="berkowitz")
        for k in range(1, len(part) + 1)
    ]
    _, point = decide(sp.And(*(minor > 0 for minor in minors)), parameters, exactly(sp.true))
    if point:
        raise Wrong(f"it is conserved, but for {values_text(point[0])} it is not positive definite")
    return (
        "it is positive away from zero, and its derivative along the motions vanishes identically"
    )


def stability(matrix):
    """Return the stability of x' = A x; on the imaginary axis the ranks of A - lambda I decide."""
    size = np.linalg.norm(matrix)
    remaining, verdict = list(np.linalg.eigvals(matrix)), "asymptotically stable"
    while remaining:
        cluster = [z for z in remaining if abs(z - remaining[0]) <= SPREAD * size]
        remaining = [z for z in remaining if abs(z - remaining[0]) > SPREAD * size]
        # The mean of a cluster is far more accurate than its members, which a Jordan block spreads.
        centre = np.mean(cluster)
        if centre.real > 1e-11 * size or (
            abs(centre.real) <= 1e-11 * size
            and _eigenvectors(matrix, 1j * centre.imag) < len(cluster)
        ):
            return "unstable"
        if centre.real >= -1e-11 * size:
            verdict = "stable"
    return verdict


def _eigenvectors(matrix, number):
    """Return the number of independent eigenvectors of an eigenvalue."""
    singular = np.linalg.svd(matrix - number * np.eye(len(matrix)), compute_uv=False)
    return int(sum(singular <= 1e-9 * np.linalg.norm(matrix)))


def _matrices(field, state, parameters, program, part, claim=()):
    at = _linear_part(field, state, parameters, program, part)
    for values in in_every_case(sample_values(parameters), claim) if parameters else [{}]:
        yield values, at(values)


def _linear_part(field, state, parameters, program, part):
    """Return the matrix of the deviation equations, or of a part, as a function of parameters."""
    motion = Motion(
        field, state, parameters, dict.fromkeys(state, 0) if program is None else program
    )
    chosen = [list(state).index(s) for s in (state if part is None else part)]
    excluded = [k for k in range(len(state)) if k not in chosen]

    def at(values):
        matrix = motion.matrix(values)
        if np.any(abs(matrix[np.ix_(chosen, excluded)]) > 1e-12 * np.linalg.norm(matrix)):
            raise RuntimeError("this part of the state is no subsystem")
        return matrix[np.ix_(chosen, chosen)]

    return at


def _distance(matrix, duration):
    """Return a text on the largest distance after some time from the unit sphere."""
    distance = np.linalg.norm(_exponential(matrix * duration), 2)
    return f"{distance:.4g}" if distance < 1e9 else "more than 1e9"


def _rows(answer, parameters):
    """Return triples (value, algebraic, geometric) from an answer.

    It is a list of rows, a matrix, a dict {value: (algebraic, geometric)}, or the result of
    SymPy's `eigenvects`, whose third entries are the eigenvectors themselves.
    """
    if isinstance(answer, dict):
        answer = [
            [value, *(numbers if isinstance(numbers, (list, tuple)) else [numbers])]
            for value, numbers in answer.items()
        ]
    if isinstance(answer, (sp.MatrixBase, np.ndarray)):
        answer = answer.tolist()
    if not isinstance(answer, (list, tuple, set, frozenset, sp.FiniteSet)) or not answer:
        raise Invalid(
            "expected a list of rows [eigenvalue, algebraic multiplicity, geometric multiplicity]"
        )
    if (
        all(
            not isinstance(row, (list, tuple, sp.Tuple, sp.MatrixBase, np.ndarray))
            for row in answer
        )
        and len(answer) == 3
    ):
        answer = [answer]
    rows = []
    for row in answer:
        if isinstance(row, (list, tuple)) and len(row) == 3 and isinstance(row[2], (list, tuple)):
            row = [*row[:2], len(row[2])]
        rows.append(coercion.as_expressions(row, parameters, 3))
    return [
        (value, *(coercion.as_integer(sp.nsimplify(count, rational=True)) for count in counts))
        for value, *counts in rows
    ]


def _exponential(matrix):
    """Return exp(A) by scaling and squaring of the power series; 1e300 where it overflows."""
    squarings = max(0, int(np.ceil(np.log2(np.linalg.norm(matrix) + 1))) + 3)
    scaled, result, term = matrix / 2.0**squarings, np.eye(len(matrix)), np.eye(len(matrix))
    for k in range(1, 16):
        term = term @ scaled / k
        result = result + term
    with np.errstate(all="ignore"):
        for _ in range(squarings):
            result = result @ result
            if not np.all(np.isfinite(result)):
                return np.full_like(result, 1e300)
    return result


def _logarithm(motion, at):
    """Return the logarithm of the distance from zero, which may itself overflow a float."""
    length = sp.sqrt(sum(sp.Abs(e.subs(at).evalf(20)) ** 2 for e in motion))
    if length.is_finite is not True:
        raise Wrong(
            f"your motion is infinite or undefined at {rounded_text(at)}, where it should have a "
            "value"
        )
    return float(sp.log(length)) if length != 0 else -np.inf
