"""Measurements with an error of a known kind and an unknown size, as `WithError`.

The measurement is z = H x + c w, w' = S w, w(0) = C (start). The checks judge the augmented system
of x and w, and C as a function of the output.

Whether z determines x(0) and C is judged in `observability.py`: a pair (x(0), C) that gives z = 0
for all time cannot be distinguished from zero. These pairs come from the largest unobservable
invariant subspace (`known_starts`), not from the rank of an augmented matrix, which allows errors
of any initial state w(0).

No check here is declared by a reference: any coordinates of the error are right.
"""

import numpy as np

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression
from workbook.checks.contract.tolerance import EXACT, agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.invariant_subspaces import echelon, product, to_floats
from workbook.checks.references.records import augmented, observed_pair
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.samples import in_every_case
from workbook.checks.tools.values import entry_uncertainties, matrix_at, perturbed_arrays
from workbook.checks.tools.wording import number_text, where_text


@judged(system="WithError")
def augmented_system(answer, system, parameters=(), own=False):
    """Check the system [A', H'] of x together with coordinates of the measurement error.

    The error has as few coordinates as possible, in any scale and combination; or those of S
    and c themselves, where these are the error's `own`.

    Can decide when the entries are exact numbers, or rational functions of the parameters. Any
    coordinates of the error are accepted.

    Examples
    --------
    >>> from workbook.systems import WithError
    >>> biased = WithError(A=[[0, 1], [0, 0]], H=[[1, 0]], S=[[0]], c=[[1]], start=[[1]])
    >>> checks.augmented_system([[[0, 1, 0], [0, 0, 0], [0, 0, 0]], [[1, 0, 1]]], biased).status
    'right'
    >>> checks.augmented_system([[[0, 1, 1], [0, 0, 0], [0, 0, 0]], [[1, 0, 1]]], biased).status
    'wrong'
    """
    if not isinstance(answer, (list, tuple)) or len(answer) != 2:
        raise Invalid(
            "expected a list [A', H'] of the matrix of the augmented system and the row of its "
            "output"
        )
    n, outputs, pair = system.A.rows, system.H.rows, observed_pair(system, parameters)
    matrix = coercion.as_matrix(answer[0], parameters)
    if matrix.rows != matrix.cols or matrix.rows <= n:
        raise Invalid(
            f"expected a square matrix A' of more than {n} rows, since the coordinates of the "
            f"error come after those of x; the shape of yours is {matrix.shape}"
        )
    row = coercion.as_matrix(answer[1], parameters)
    # A single row is a vector, whichever way it is written.
    row = coercion.as_matrix(
        row.T if outputs == 1 == row.cols else row, parameters, (outputs, matrix.rows)
    )
    for values, point, _ in pair.samples_for([matrix, row]):
        true_A, true_H = (to_floats(rows, pair.order) for rows in pair.at(point))
        claimed_A, claimed_H = matrix_at(matrix, values), matrix_at(row, values)
        x, w = slice(0, n), slice(n, None)
        outputs, itself = slice(None), "the last coordinate is the error itself"
        blocks = [
            (matrix, (x, x), true_A[x, x], "the rows and columns of x in A' are those of A"),
            (matrix, (x, w), 0, "the error does not act on the motion: this part of A' is zero"),
            (matrix, (w, x), 0, "the motion does not act on the error: this part of A' is zero"),
            (row, (outputs, x), true_H[:, x], "the columns of x in H' are those of H"),
        ]
        if own and matrix.rows == pair.order:
            blocks.append((matrix, (w, w), true_A[w, w], itself))
            blocks.append((row, (outputs, w), true_H[:, w], itself))
        for claim, block, true, property_text in blocks:
            claimed = (claimed_A if claim is matrix else claimed_H)[block]
            _compare_block(claimed, true + 0 * claimed, claim[block], property_text, values)
        _compare_errors(
            claimed_A[w, w],
            claimed_H[:, w],
            [entry_uncertainties(part, values) for part in (matrix[w, w], row[:, w])],
            _error_derivatives(pair, point, matrix.rows),
            where_text(values),
        )
    return (
        "its outputs are those of the motions with every error of the kind, and no coordinate of "
        "the error can be spared"
    )


@judged(Expression("outputs", "time"), system="WithError")
def amplitude_from_output(claim, system, outputs, time):
    """Check C as an expression in z, its derivatives at one instant and the time.

    The symbols of z and of its derivatives are the `outputs`.

    Can decide when the matrices are numbers; C is compared at six times of motions from random
    initial states.

    Examples
    --------
    >>> from workbook.systems import WithError
    >>> biased = WithError(A=[[1]], H=[[1]], S=[[0]], c=[[1]], start=[[1]])
    >>> z, dz, t = sp.symbols("z dz t")
    >>> checks.amplitude_from_output(z - dz, biased, [z, dz], t).status
    'right'
    >>> checks.amplitude_from_output(z + dz, biased, [z, dz], t).status
    'wrong'
    """
    from scipy.linalg import expm

    combined = augmented(system)
    matrix, row = np.array(combined.A, dtype=float), np.array(combined.H, dtype=float)[0]
    random = np.random.default_rng(17)
    instants = [{time: instant} for instant in (0.2, 0.55, 0.9, 1.3, 1.7, 2.4)]
    for instant in (values[time] for values in in_every_case(instants, claim, time >= 0)):
        x = random.normal(size=system.A.rows)
        amplitude = random.choice([-1, 1]) * random.uniform(0.5, 3)
        state = expm(instant * matrix) @ [*x, *(amplitude * float(s) for s in system.start)]
        values = {time: instant}
        for symbol in outputs:
            values[symbol] = float(row @ state)
            state = matrix @ state
        yield SameValue(
            claim, amplitude, "C", values, 1e-2 * sum(abs(v) for v in values.values()), 1e-8
        )
    return "it gives C at every time of motions from various initial states and with various errors"


def _compare_block(claimed, true, claim, property_text, values):
    uncertain, where = entry_uncertainties(claim, values), where_text(values)
    size = max(abs(true).max(initial=0), 1.0)
    mismatched = ~agree(claimed, true, claim, size, uncertain=uncertain)
    if mismatched.any():
        i, j = np.argwhere(mismatched)[0]
        raise Wrong(f"{property_text}{where}; yours has {number_text(claimed[i, j])} there")


def _error_derivatives(pair, point, count):
    """Return the exact derivatives of the error with C = 1 at t = 0.

    There are enough of them to distinguish two equations of these orders.
    """
    A, H = pair.at(point)
    state, derivatives = [row[-1] for row in pair.starts], []
    for _ in range(count + pair.order):
        derivatives.append(product(H, state))
        state = product(A, state)
    return derivatives


def _compare_errors(S, c, uncertainties, derivatives, where):
    """Judge that w' = S w, z = c w gives the error from some w(0), and needs all its coordinates.

    `uncertainties` are the rounding errors of the decimals of S and c.
    """
    size, count = len(S), len(derivatives)
    half = count // 2
    hankel = [sum(derivatives[i : i + half], []) for i in range(half)]
    if size > len(echelon(hankel)[1]):
        raise Wrong(
            f"your error has {size} coordinates, but it satisfies a linear equation of lower "
            f"order{where}; fewer coordinates are enough"
        )
    rate = max(1.0, np.linalg.norm(S, 2))
    weights = np.repeat(rate ** -np.arange(count, dtype=float), len(c))
    reference = np.array([float(x) for entry in derivatives for x in entry]) * weights

    def residual(S, c):
        rows = [c]
        while len(rows) < count:
            rows.append(rows[-1] @ S)
        outputs = np.vstack(rows) * weights[:, None]
        if not np.isfinite(outputs).all():
            raise Wrong(f"the derivatives of your error are not finite{where}")
        start = np.linalg.lstsq(outputs, reference.astype(complex), rcond=1e-12)[0]
        return outputs @ start - reference

    mismatch = residual(S, c)
    allowed = sum(
        np.linalg.norm(residual(*perturbed) - mismatch)
        for perturbed in perturbed_arrays((S, c), uncertainties)
    )
    if not np.linalg.norm(mismatch) <= 10 * EXACT * np.linalg.norm(reference) + allowed:
        raise Wrong(
            "from no initial state do your coordinates of the error give the error of the "
            f"statement{where}: the derivatives of z at t = 0 do not agree"
        )
