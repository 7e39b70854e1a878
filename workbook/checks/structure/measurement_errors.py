"""Measurements with an error of a known kind and an unknown size, as `WithError`.

The measurement is z = H x + c w, w' = S w, w(0) = C (start): the system of both together, and C by
the output.

What z determines of x(0) and C is asked in `observability.py`: a pair (x(0), C) that gives z = 0
for all time cannot be told from nothing at all. These pairs come from the largest invariant
subspace that z does not show (`known_starts`), and not from the rank of an augmented matrix, which
allows errors of any start w(0).
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


@judged
def augmented_system(answer, system, parameters=(), own=False):
    """Check the system [A', H'] of x together with coordinates of the measurement error.

    The error has as few coordinates as possible, in any scale and combination; or those of S
    and c themselves, where these are the error's `own`.
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
        said_A, said_H = matrix_at(matrix, values), matrix_at(row, values)
        x, w = slice(0, n), slice(n, None)
        for claim, block, true, what in (
            (matrix, (x, x), true_A[x, x], "the rows and columns of x in A' are those of A"),
            (matrix, (x, w), 0, "the error does not act on the motion: this part of A' is zero"),
            (matrix, (w, x), 0, "the motion does not act on the error: this part of A' is zero"),
            (row, (slice(None), x), true_H[:, x], "the columns of x in H' are those of H"),
        ):
            claimed = (said_A if claim is matrix else said_H)[block]
            _compare_block(claimed, true + 0 * claimed, claim[block], what, values)
        if own and matrix.rows == pair.order:
            _compare_block(
                said_A[w, w],
                true_A[w, w],
                matrix[w, w],
                "the last coordinate is the error itself",
                values,
            )
            _compare_block(
                said_H[:, w],
                true_H[:, w],
                row[:, w],
                "the last coordinate is the error itself",
                values,
            )
        open_ = entry_uncertainties(matrix, values)[w, w], entry_uncertainties(row, values)[:, w]
        _compare_errors(
            said_A[w, w],
            said_H[:, w],
            open_,
            _error_derivatives(pair, point, n, matrix.rows),
            values,
        )
    return (
        "its outputs are those of the motions with every error of the kind, and no coordinate of "
        "the error can be spared"
    )


@judged(Expression("outputs", "time"))
def amplitude_from_output(claim, system, outputs, time):
    """Check C as an expression in z, its derivatives at one instant and the time.

    The symbols of z and of its derivatives are the `outputs`.
    """
    from scipy.linalg import expm

    both = augmented(system)
    matrix, row = np.array(both.A, dtype=float), np.array(both.H, dtype=float)[0]
    random = np.random.default_rng(17)
    moments = [{time: moment} for moment in (0.2, 0.55, 0.9, 1.3, 1.7, 2.4)]
    for moment in (values[time] for values in in_every_case(moments, claim, time >= 0)):
        x, amplitude = (
            random.normal(size=system.A.rows),
            random.choice([-1, 1]) * random.uniform(0.5, 3),
        )
        state = expm(moment * matrix) @ [*x, *(amplitude * float(s) for s in system.start)]
        values = {time: moment}
        for symbol in outputs:
            values[symbol] = float(row @ state)
            state = matrix @ state
        yield SameValue(
            claim, amplitude, "C", values, 1e-2 * sum(abs(v) for v in values.values()), 1e-8
        )
    return "it gives C at every moment of motions with all kinds of starts and errors"


def _compare_block(claimed, true, claim, what, values):
    uncertain, where = entry_uncertainties(claim, values), where_text(values)
    bad = ~agree(claimed, true, claim, max(abs(true).max(initial=0), 1.0), uncertain=uncertain)
    if bad.any():
        i, j = np.argwhere(bad)[0]
        raise Wrong(f"{what}{where}; yours has {number_text(claimed[i, j])} there")


def _error_derivatives(pair, point, n, count):
    """The derivatives of the error with C = 1 at t = 0, exact: as many as tell two equations of
    these orders apart."""
    A, H = pair.at(point)
    state, found = [row[-1] for row in pair.starts], []
    for _ in range(count + pair.order):
        found.append(product(H, state))
        state = product(A, state)
    return found


def _compare_errors(S, c, left_open, derivatives, where):
    """Whether w' = S w, z = c w makes the error from some start, and whether it needs all its
    coordinates; `left_open` is by how much the decimals of S and c leave them open."""
    size, count = len(S), len(derivatives)
    half = count // 2
    order = len(
        echelon([[x for entry in derivatives[i : i + half] for x in entry] for i in range(half)])[1]
    )
    if size > order:
        raise Wrong(
            f"your error has {size} coordinates, but fewer are enough for a linear equation of its "
            f"own{where}; what is superfluous could not be observed, and would not matter"
        )
    rate = max(1.0, np.linalg.norm(S, 2))
    weights = np.repeat(rate ** -np.arange(count, dtype=float), len(c))
    wanted = np.array([float(x) for entry in derivatives for x in entry]) * weights

    def rest(S, c):
        rows = [c]
        while len(rows) < count:
            rows.append(rows[-1] @ S)
        message = np.vstack(rows) * weights[:, None]
        if not np.isfinite(message).all():
            raise Wrong(f"the derivatives of your error are not finite{where}")
        start = np.linalg.lstsq(message, wanted.astype(complex), rcond=1e-12)[0]
        return message @ start - wanted

    here = rest(S, c)
    allowed = sum(
        np.linalg.norm(rest(*other) - here) for other in perturbed_arrays((S, c), left_open)
    )
    if not np.linalg.norm(here) <= 10 * EXACT * np.linalg.norm(wanted) + allowed:
        raise Wrong(
            "from no start do your coordinates of the error give the error of the "
            f"statement{where}: the derivatives of z at t = 0 do not agree"
        )
