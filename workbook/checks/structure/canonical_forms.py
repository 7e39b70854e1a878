"""The observable (2.5) and the controllable (2.4) canonical form, and the changes to them.

Also the matrix in the basis b, A b, A^2 b, ...

A form is judged by its shape and by its characteristic polynomial; a change of variables by the
transformed equations. The controllable canonical form is the observable one of the transposed
matrix, with rows and columns in reverse order; the matrix in the basis of the chain is the
observable canonical form with rows and columns in reverse order.

Coordinates of the observable part alone are judged by the equations that the form stands for, z =
xi1 and xi_k' = (a multiple of z) + xi_(k+1), the last one without its second term. With as many
rows as the observable part has, the multiples are determined.

No check here is declared by a reference: a form is judged by its shape, and at all values of the parameters.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from workbook.checks.contract.claims import Matrix
from workbook.checks.contract.tolerance import EXACT, agree, relative_tolerance
from workbook.checks.contract.verdict import Invalid, UnsuitableData, Wrong, judged
from workbook.checks.references.exceptional_values import judge_where_generic
from workbook.checks.references.invariant_subspaces import characteristic_coefficients
from workbook.checks.references.records import controlled_pair, has_control, observed_pair
from workbook.checks.structure.similar_systems import point_of_difference
from workbook.checks.tools.comparisons import SameEntries
from workbook.checks.tools.values import entry_uncertainties, matrix_at, uncertainty_at
from workbook.checks.tools.wording import number_text, where_text


@dataclass(frozen=True)
class _Form:
    """The wording for one of the forms.

    `entry` maps the position (i, j) in the observable form of order n to that in this form.
    """

    shape: str
    ones_and_zeros: str
    entry: Callable
    # messages on a matrix that has the shape once it is flipped, transposed, or has its rows and
    # columns reversed
    relatives: tuple


_BELOW = "your matrix has its ones below the diagonal"
BY_OBSERVATION = _Form(
    "the shape (2.5)",
    "ones above the diagonal and zeros elsewhere, but for the first column",
    lambda i, j, n: (i + 1, j + 1),
    ("this has the shape (2.4)", _BELOW, _BELOW),
)
BY_CONTROL = _Form(
    "the shape (2.4)",
    "ones above the diagonal and zeros elsewhere, but for the last row",
    lambda i, j, n: (n - j, n - i),
    ("this has the shape (2.5)", _BELOW, _BELOW),
)
OF_CHAIN = _Form(
    "the shape that A g^i = g^(i+1) gives",
    "ones below the diagonal and zeros elsewhere, but for the last column",
    lambda i, j, n: (n - i, n - j),
    (
        "your matrix has its coefficients in the first row",
        "this has the shape (2.4)",
        "this has the shape (2.5)",
    ),
)


@judged(Matrix("parameters", shape="system.A"))
def canonical_matrix(claim, system, parameters=()):
    """Check the n x n matrix of the canonical form of a system.

    With an output the form is that by observation (2.5), determined by its first column; with a
    control that by control (2.4), determined by its last row: ones above the diagonal, and the
    eigenvalues of A.

    Can decide when the entries are exact numbers, or rational functions of the parameters.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[0, 1], [2, 1]], H=[[1, 1]])
    >>> checks.canonical_matrix([[1, 1], [2, 0]], pair).status
    'right'
    >>> checks.canonical_matrix([[1, 1], [-2, 0]], pair).status
    'wrong'
    """
    if has_control(system):
        return judge_form(claim.T[::-1, ::-1], controlled_pair(system, parameters), BY_CONTROL)
    return judge_form(claim, observed_pair(system, parameters), BY_OBSERVATION)


@judged(Matrix("parameters", shape="system.A"))
def canonical_change(claim, system, parameters=()):
    """Check the change of coordinates to the canonical form, with one output or one control.

    By observation (2.5) it is T of xi = T x: z = xi1, xi1' = alpha_n xi1 + xi2, and so on; by
    control (2.4) it is P of x = P xi: its last column is b, and A P = P A0.

    Can decide when the entries are exact numbers, or rational functions of the parameters.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[0, 1], [2, 1]], H=[[1, 0]])
    >>> checks.canonical_change([[1, 0], [-1, 1]], pair).status
    'right'
    >>> checks.canonical_change([[1, 0], [0, 1]], pair).status
    'wrong'
    """
    orders = range(1, system.A.rows + 1)
    if has_control(system):
        names = [f"column {k}" for k in orders[::-1]]
        return _judge_change(claim.T[::-1, :], controlled_pair(system, parameters), names, False)
    names = [f"xi{k}" for k in orders]
    return _judge_change(claim, observed_pair(system, parameters), names, True)


@judged(Matrix("parameters", shape="system.A"))
def chain_basis_matrix(claim, system, parameters=()):
    """Check the matrix of a controllable system in the basis b, A b, ..., A^(n-1) b.

    The system has one control (A: n x n, B: n x 1); g^1 = b, g^2 = A b, ..., g^n = A^(n-1) b.

    Column i holds the coordinates of A g^i: ones below the diagonal, and the last column as the
    eigenvalues of A demand.

    Can decide when the entries are exact numbers, or rational functions of the parameters.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> plant = Linear(A=[[0, 1], [2, 1]], B=[[0], [1]])
    >>> checks.chain_basis_matrix([[0, 2], [1, 1]], plant).status
    'right'
    >>> checks.chain_basis_matrix([[0, 2], [1, -1]], plant).status
    'wrong'
    """
    pair = controlled_pair(system, parameters)
    if pair.outputs != 1 or any(pair.unobservable):
        raise UnsuitableData("b, A b, A^2 b, ... are no basis")
    return judge_form(claim[::-1, ::-1], pair, OF_CHAIN)


@judged(Matrix("parameters"))
def canonical_part_coordinates(claim, system, parameters=()):
    """Check the coordinates xi = F x of the observable part in the canonical form (2.5).

    F has as many rows as N has rank (F: rank N x n, A: n x n, H: 1 x n).

    Can decide when the entries are exact numbers, or rational functions of the parameters.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[4, 0], [0, 7]], H=[[1, 0]])
    >>> checks.canonical_part_coordinates([[1, 0]], pair).status
    'right'
    >>> checks.canonical_part_coordinates([[0, 1]], pair).status
    'wrong'
    """
    if claim.cols != system.A.rows:
        raise Invalid(
            f"expected a matrix with {system.A.rows} columns, one for each coordinate of x; the "
            f"shape of yours is {claim.shape}"
        )
    pair = observed_pair(system, parameters)
    if pair.outputs != 1:
        raise UnsuitableData("the canonical form belongs to one output")
    for values, A, (h,), unobservable in pair.systems_for(claim):
        where, order = where_text(values), pair.order - len(unobservable)
        if claim.rows > order:
            raise Wrong(
                f"the output and its derivatives do not hold {claim.rows} independent combinations "
                f"of the coordinates{where}, so not all of yours are observable"
            )
        if claim.rows < order:
            plural = "s" if claim.rows != 1 else ""
            raise Wrong(
                f"the output and its derivatives hold more than {claim.rows} independent "
                f"combination{plural} of the coordinates{where}; yours are too few for them"
            )
        yield SameEntries(
            claim[0, :],
            h[None, :],
            lambda claimed, _, j: (
                f"z has to be xi1 alone{where}; your xi1 holds {number_text(claimed[0, j])} x{j + 1}"
            ),
            values,
            np.linalg.norm(h),
        )
        claimed = matrix_at(claim, values)
        projection = np.eye(len(h)) - np.outer(h, h) / (h @ h)
        uncertainties = [*entry_uncertainties(claim, values), 0 * h]
        for k, (row, following) in enumerate(zip(claimed, [*claimed[1:], 0 * h])):
            rate = row @ A
            residual = (rate - following) @ projection
            uncertainty = uncertainties[k] @ abs(A @ projection)
            uncertainty = uncertainty + uncertainties[k + 1] @ abs(projection)
            size = np.linalg.norm(rate) + np.linalg.norm(following)
            if not np.linalg.norm(residual) <= np.linalg.norm(uncertainty) + EXACT * size:
                j = int(np.argmax(abs(residual)))
                expression_text = f"xi{k + 1}' - xi{k + 2}" if k + 1 < order else f"xi{k + 1}'"
                raise Wrong(
                    f"{expression_text} has to be a multiple of z{where}; by your rows it differs from the "
                    f"nearest multiple by terms such as {number_text(residual[j])} x{j + 1}"
                )
    judge_where_generic(claim, pair, "your matrix is undefined")
    return "z = xi1, and the derivatives are those of the form (2.5)"


def judge_form(claim, pair, form):
    """Judge the shape and the characteristic polynomial of an observable canonical form of the pair's A."""
    tolerance = relative_tolerance(claim)
    for values, point, _ in pair.samples_for(claim):
        claimed = matrix_at(claim, values)
        shape_of_form(claimed, tolerance, form, where_text(values))
        true = np.array(characteristic_coefficients(pair.at(point)[0]), dtype=float)
        polynomial = np.array([1, *(0 - claimed[:, 0])])  # not -claimed, which turns 0 into -0
        column = list(claim[:, 0])
        uncertain = [uncertainty_at(entry, values) for entry in column]
        if not agree(polynomial[1:], true[1:], column, max(abs(true)), uncertain=uncertain).all():
            point = point_of_difference(polynomial, true)
            raise Wrong(
                f"the characteristic polynomials differ{where_text(values)}: at lambda = {point} "
                f"that of your matrix is {number_text(np.polyval(polynomial, point))}, and that of "
                "A is not"
            )
    judge_where_generic(claim, pair, "your matrix is undefined")
    return f"it has {form.shape} and the characteristic polynomial of A"


def shape_of_form(claimed, tolerance, form, where):
    """Raise `Wrong` unless a matrix of numbers, turned so that it should be the form by
    observation, has ones above the diagonal and zeros outside its first column."""
    n = len(claimed)
    pattern = np.eye(n, k=1)
    if _has_shape(claimed, pattern, tolerance):
        return
    for view, relative in zip(
        (claimed.T[::-1, ::-1], claimed.T, claimed[::-1, ::-1]), form.relatives
    ):
        if _has_shape(view, pattern, tolerance):
            raise Wrong(f"{relative}{where}; asked is {form.shape}: {form.ones_and_zeros}")
    off = abs(claimed - pattern) * (np.arange(n) > 0)
    i, j = map(int, np.unravel_index(np.argmax(off), off.shape))
    raise Wrong(
        f"the entry {form.entry(i, j, n)} of your matrix is {number_text(claimed[i, j])}{where}; "
        f"{form.shape} has {form.ones_and_zeros}"
    )


def _has_shape(matrix, pattern, tolerance):
    return bool((abs(matrix - pattern)[:, 1:] <= min(tolerance, 1e-6)).all())


def _judge_change(claim, pair, row_names, by_rows):
    """Judge the rows r of a change of variables: r1 = h and r_k A = alpha r1 + r_(k+1).

    The alpha are the coefficients of the characteristic polynomial of A.
    """
    n = pair.order
    if any(pair.unobservable):
        raise UnsuitableData("there is no canonical form: the system loses an eigenvalue")
    samples = zip(pair.systems_for(claim), pair.samples_for(claim))
    for (values, A, (h,), _), (_, point, _) in samples:
        where, true = where_text(values), [h]
        for coefficient in characteristic_coefficients(pair.at(point)[0])[1:-1]:
            true.append(true[-1] @ A + float(coefficient) * h)
        true = np.array(true)

        def message(claimed, k, j):
            candidate, reference = (claimed, true) if by_rows else (claimed[::-1].T, true[::-1].T)
            off = np.linalg.norm(candidate @ reference - np.eye(n))
            if np.linalg.cond(reference) < 1e12 and off <= 10 * relative_tolerance(claim):
                return "this is the inverse of the matrix asked: it gives " + (
                    "x from xi; asked is T in xi = T x"
                    if by_rows
                    else "xi from x; asked is P in x = P xi"
                )
            if k == 0:
                return (
                    f"z has to be xi1 alone{where}, so the first row of T times x has to be z"
                    if by_rows
                    else f"the control has to enter xi{n}' alone, with the coefficient 1, which determines the last "
                    f"column{where}"
                ) + f"; the entry {j + 1} of yours does not fit"
            previous, current, alpha = row_names[k - 1], row_names[k], f"alpha_{n + 1 - k}"
            if by_rows:
                return (
                    f"by {previous}' = {alpha} xi1 + {current}, {current} as a combination of x is "
                    f"determined by {previous}{where}; "
                    f"the coefficient of x{j + 1} in your row {k + 1} does not fit"
                )
            return (
                f"A times {previous} has to be {current} + {alpha} ({row_names[0]}){where}; the entry "
                f"{j + 1} of your {current} does not fit"
            )

        yield SameEntries(claim, true, message, values, np.linalg.norm(true, axis=1)[:, None])
    judge_where_generic(claim, pair, "your matrix is undefined")
    return (
        "z = xi1 and each derivative is that of the form"
        if by_rows
        else "the control enters the last equation alone and the equations are those of the form"
    )
