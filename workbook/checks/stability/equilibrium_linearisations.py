"""Linearisations at equilibria: their matrices, eigenvalues, and what else is evaluated there.

`domain` is as for `equilibria`.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression
from workbook.checks.contract.tolerance import REPEATED, agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.stability.equilibria import rates_text
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import (
    entry_uncertainties,
    matrix_at,
    number_at,
    numbers_at,
    uncertainty_at,
)
from workbook.checks.tools.wording import (
    NO_NUMBER,
    deviation_rate_text,
    number_text,
    other_text,
    point_text,
    sample_text,
    tried_text,
    values_text,
    where_text,
)

#: What rounding leaves of a zero matrix, next to the largest one.
ROUNDING = 1e-12


@judged
def equilibrium_linearisation(
    answer, field, state, parameters=(), domain=None, given=(), integer=None, zeros=None
):
    """Check the matrices A of y' = A y that occur at the equilibria in the domain.

    The answer is one matrix, or a list of them in any order; for one equation it is a number. The
    deviations are y.

    Where A may be singular, `zeros` are functions that have the same zeros as the field, all
    simple: only simple zeros are found reliably.

    Can decide when the equilibria are simple zeros of the field, or of the `zeros`; with
    parameters at sample values.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> field = [y, -sp.sin(x)]
    >>> upright = sp.Matrix([[0, 1], [1, 0]])
    >>> checks.equilibrium_linearisation([upright, sp.Matrix([[0, 1], [-1, 0]])], field, [x, y]).status
    'right'
    >>> checks.equilibrium_linearisation([upright], field, [x, y]).status
    'wrong'
    """
    n, integers = len(state), [] if integer is None else [integer]
    if n == 1 and not isinstance(answer, (list, tuple, sp.MatrixBase, np.ndarray)):
        answer = [[answer]]
    matrices = [
        coercion.as_matrix(matrix, [*parameters, *integers], (n, n))
        for matrix in _list_of_matrices(answer)
    ]
    family = equilibria_of(field, state, parameters, domain, given)
    searched = equilibria_of(field if zeros is None else zeros, state, parameters, domain, given)
    for values, numbers, points in searched.samples(matrices, alone=False):
        true = [family.jacobian(point, numbers) for point in points]
        if len(true) == len(matrices) == 1 and integer is None:
            _judge_columns(matrices[0], true[0], state, values)
        elif true:
            _judge_matrices(matrices, true, values, integers)
    return (
        "to first order the right-hand sides change so with the deviations, at all equilibria found"
    )


def _judge_columns(matrix, true, state, values):
    size = np.linalg.norm(true)
    for k, symbol in enumerate(state):
        column = list(matrix[:, k])
        claimed = [real_at(entry, values) for entry in column]
        if any(value is None for value in claimed):
            raise Wrong(f"{sample_text(values)}an entry of your matrix is {NO_NUMBER}")
        uncertain = [uncertainty_at(entry, values) for entry in column]
        if not agree(claimed, true[:, k], column, size, uncertain=uncertain).all():
            raise Wrong(f"{sample_text(values)}{deviation_rate_text(symbol, claimed, true[:, k])}")


def _judge_matrices(matrices, true, values, integers):
    floor = ROUNDING * max(map(np.linalg.norm, true))
    claimed = [
        (matrix_at(matrix, at), matrix, entry_uncertainties(matrix, at))
        for matrix in matrices
        for k in (range(-2, 3) if matrix.has(*integers) else (0,))
        for at in [values | dict.fromkeys(integers, sp.Integer(k))]
    ]

    def agreeing(numbers, written, uncertain, reference):
        size = np.linalg.norm(reference)
        agrees = agree(numbers, reference, written, size, REPEATED, uncertain)
        return bool(np.all(agrees | (np.abs(numbers - reference) <= floor)))

    for matrix in claimed:
        if not any(agreeing(*matrix, reference) for reference in true):
            rows = "; ".join(point_text(row.real) for row in matrix[0])
            raise Wrong(
                f"the matrix {rows}{where_text(values)} does not consist of the partial derivatives of "
                "the right-hand sides at any equilibrium"
            )
    if not all(any(agreeing(*matrix, reference) for matrix in claimed) for reference in true):
        raise Wrong(
            "a matrix is missing: at one of the equilibria the partial derivatives of the right-hand "
            f"sides form a matrix that is not in your list{where_text(values)}"
        )


def _list_of_matrices(answer):
    """Return the matrices of an answer: a list, a dict of matrices, or a single matrix."""
    if isinstance(answer, dict):
        answer = list(answer.values())
    if isinstance(answer, sp.MatrixBase) or (isinstance(answer, np.ndarray) and answer.ndim == 2):
        return [answer]
    if isinstance(answer, (set, frozenset, np.ndarray, sp.FiniteSet)):
        answer = list(answer)
    if not isinstance(answer, (list, tuple)) or not answer:
        raise Invalid("expected a list of matrices")
    flat = all(
        isinstance(row, (list, tuple))
        and not any(isinstance(entry, (list, tuple)) for entry in row)
        for row in answer
    )
    return [answer] if flat else list(answer)


@judged(Expression("deviations", "angle", "parameters"))
def angle_linearisation(claim, field, state, parameters, angle, deviations):
    """Check the linearisation psi'' = ... at an equilibrium (angle, 0), linear in psi and psi'.

    `angle` is the symbol of the equilibrium, `deviations` those of psi and psi'. It is judged at
    equilibria only, so that the answer may use the equation f(angle, 0) = 0.

    Can decide when the right-hand side is differentiable at the equilibria, for the parameters
    tried.

    Examples
    --------
    >>> phi, rate, phi0, psi, dpsi = sp.symbols("phi rate phi0 psi dpsi", real=True)
    >>> g = sp.Symbol("g", positive=True)
    >>> field = [rate, -rate - g*sp.sin(phi)]
    >>> checks.angle_linearisation(-dpsi - g*psi*sp.cos(phi0), field, [phi, rate], [g], phi0, [psi, dpsi]).status
    'right'
    >>> checks.angle_linearisation(-g*psi*sp.cos(phi0), field, [phi, rate], [g], phi0, [psi, dpsi]).status
    'wrong'
    """
    if not claim.is_polynomial(*deviations) or sp.Poly(claim, *deviations).total_degree() > 1:
        raise Invalid(
            f"expected an expression that is linear in {deviations[0]} and {deviations[1]}"
        )
    family = equilibria_of(field, state, parameters)
    for values, numbers, points in family.samples(claim, count=5, alone=False):
        for point in points:
            slopes = family.jacobian(point, numbers)[1]
            for deviation in ((1, 0), (0, 1), (0, 0), (1, 1)):
                true = slopes @ deviation
                at = values | {angle: sp.Float(point[0], 20)} | dict(zip(deviations, deviation))
                claimed = number_at(claim, at)
                if not abs(claimed - true) <= 1e-8 * abs(slopes).sum():
                    message = ", ".join(
                        f"{symbol} = {value}" for symbol, value in zip(deviations, deviation)
                    )
                    raise Wrong(
                        f"for {values_text(values)}, at an equilibrium, "
                        + other_text(
                            f"the change of phi'' to first order by a deviation {message}",
                            claimed.real,
                            true,
                        )
                    )
    return "to first order the right-hand side changes so, at all equilibria of several sets of parameters"


@judged(Expression("parameters"))
def equilibrium_value(claim, expression, field, state, parameters, domain=None):
    """Check the value of an expression of the state at the equilibrium, the only one in the domain.

    Can decide when the domain holds one equilibrium; with parameters at sample values.

    Examples
    --------
    >>> v = sp.Symbol("v", positive=True)
    >>> k = sp.Symbol("k", positive=True)
    >>> checks.equilibrium_value(k, k*v**2, [1 - k*v**2], [v], [k], {v: sp.Interval.open(0, sp.oo)}).status
    'wrong'
    >>> checks.equilibrium_value(1, k*v**2, [1 - k*v**2], [v], [k], {v: sp.Interval.open(0, sp.oo)}).status
    'right'
    """
    family = equilibria_of(field, state, parameters, domain)
    expression_at = equilibria_of([expression], state, parameters, domain)
    for values, numbers, equilibrium in family.samples(claim):
        true, claimed = float(expression_at(equilibrium, numbers)[0]), real_at(claim, values)
        if claimed is None or not agree(
            claimed,
            true,
            claim,
            _scale(expression, values, state, equilibrium),
            uncertain=uncertainty_at(claim, values),
        ):
            noun = "the value at the equilibrium"
            if claimed is None:
                raise Wrong(f"{sample_text(values)}your expression gives {NO_NUMBER}")
            if not values:
                raise Wrong(f"{noun} is not {claimed:.4g}")
            raise Wrong(f"{sample_text(values)}{other_text(noun, claimed, true)}")
    return f"it is the value at the equilibrium{tried_text(parameters)}"


def _scale(expression, values, state, equilibrium):
    """Return the size of the terms of an expression at a point: their sum may cancel."""
    numbers = values | {x: sp.Float(float(v), 20) for x, v in zip(state, equilibrium)}
    return sum(
        abs(real_at(term, numbers) or 0.0) for term in sp.Add.make_args(sp.expand(expression))
    )


@judged
def spectra(answer, field, state):
    """Check the eigenvalues of the linearisation at every equilibrium.

    The rows are the coordinates of an equilibrium, then the eigenvalues.

    Judged by the characteristic determinant det(lambda I - A) at the numbers given, and by
    their sum, the trace of A.

    Can decide when the equilibria are simple zeros of the field.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.spectra([0, 0, sp.I, -sp.I], [y, -x], [x, y]).status
    'right'
    >>> checks.spectra([0, 0, 1, -1], [y, -x], [x, y]).status
    'wrong'
    """
    family, numbers = equilibria_of(field, state), np.zeros(0)
    (missed,) = family.points(numbers[:, None])
    for written, eigenvalues in _spectra_by_point(answer, state):
        position = np.array(written, dtype=float)
        point = family.refined(position, numbers)
        if point is None or not family.is_same_point(position, point, written):
            raise Wrong(
                f"your point {point_text(position)} is not an equilibrium: "
                f"{rates_text(family(position, numbers))}"
            )
        missed = [other for other in missed if not np.allclose(other, point, rtol=0, atol=1e-6)]
        _judge_spectrum(eigenvalues, family.jacobian(point, numbers), point)
    if missed:
        raise Wrong(
            "your list does not hold all of them: a search finds an equilibrium for which you "
            "give no eigenvalues"
        )
    return "at every equilibrium the numbers are the roots of the characteristic equation, each as often as it is one"


def _spectra_by_point(answer, state):
    """Yield pairs (point, eigenvalues) as they are written, from rows [*coordinates, *eigenvalues].

    A row may also be a pair of two lists.
    """
    n = len(state)
    if isinstance(answer, sp.MatrixBase):
        answer = answer.tolist()
    if not isinstance(answer, (list, tuple, np.ndarray)):
        raise Invalid(
            f"expected a list with a row of {2 * n} numbers for each equilibrium: its coordinates, "
            "then the eigenvalues"
        )
    rows = (
        [answer]
        if len(answer) == 2 * n
        and not any(isinstance(x, (list, tuple, np.ndarray, sp.MatrixBase)) for x in answer)
        else answer
    )
    for row in rows:
        if isinstance(row, (list, tuple)) and len(row) == 2 and n > 1:
            row = [*coercion.as_expressions(row[0], (), n), *coercion.as_expressions(row[1], (), n)]
        numbers = coercion.as_expressions(row, (), 2 * n)
        yield list(map(coercion.as_number, numbers[:n])), numbers[n:]


def _judge_spectrum(written, matrix, point):
    """Match the numbers one to one with the eigenvalues."""
    numbers = numbers_at(
        written, {}, [f"eigenvalue at {point_text(point)}"] * len(written)
    ).tolist()
    eigenvalues = list(np.linalg.eigvals(matrix))
    remaining = list(eigenvalues)
    for number, claim in zip(numbers, written):
        # A computed double eigenvalue has half of the digits of a float.
        matching = [value for value in eigenvalues if agree(number, value, claim, 1, REPEATED)]
        if not matching:
            residual = abs(np.linalg.det(number * np.eye(len(matrix)) - matrix))
            raise Wrong(
                f"at {point_text(point)} your number {number_text(number)} is no eigenvalue of the "
                f"linearisation: det(lambda I - A) has the modulus {residual:.4g} there, not zero"
            )
        unmatched = [value for value in matching if value in remaining]
        if not unmatched:
            raise Wrong(
                f"at {point_text(point)} the sum of your eigenvalues is "
                f"{number_text(sum(numbers))}, which is not the sum of the diagonal elements of A"
            )
        remaining.remove(min(unmatched, key=lambda value: abs(value - number)))
