"""An output z = H x of x' = A x in time: its derivatives, its Gramian, frozen rows.

Where the row H(t) changes, the system is a `Varying`. Unobservable states are asked for in
`observability.py`.

No check here is declared by a reference: each has samples of its own, which would make it longer.
"""

from math import comb

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Matrix
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.tools.comparisons import SameEntries, SameValue
from workbook.checks.tools.samples import in_every_case, signed_values
from workbook.checks.tools.values import uncertainty_at, value_at
from workbook.checks.tools.wording import number_text, prefix_text, rounded_text, tried_text


@judged(Expression("time", "start", "parameters"), system="Linear or Varying with outputs")
def measured_output(claim, system, start, time, parameters=()):
    """Check the output z(t) along the motion from an initial state.

    The output is single, an expression in the symbols of the initial state, the time and the
    parameters; its row may change with the time.

    Can decide when H has values at the sample times; the initial states are random.

    Examples
    --------
    >>> from workbook.systems import Varying
    >>> t = sp.Symbol("t", positive=True)
    >>> pair = Varying(A=[[0, 1], [0, 0]], H=[[1, -t]], time=t)
    >>> a, b = sp.symbols("a b")
    >>> checks.measured_output(a, pair, [a, b], t).status
    'right'
    >>> checks.measured_output(a - b*t, pair, [a, b], t).status
    'wrong'
    """
    from scipy.linalg import expm

    for values in in_every_case(signed_values([time, *start, *parameters], positive=[time]), claim):
        x = np.array([values[symbol] for symbol in start])
        matrix, row = _at(system.A, values), _at(system.H, values)
        z = float((row @ expm(values[time] * matrix) @ x)[0])
        yield SameValue(
            claim, z, "the measurement", values, np.linalg.norm(row) * np.linalg.norm(x)
        )
    return f"it is what is measured{tried_text(parameters, 'initial states', 'times')}"


@judged(Matrix("system.time", "parameters", shape="system.A"), system="Varying")
def observability_matrix(claim, system, parameters):
    """Check the n x n matrix of the rows N0, ..., N(n-1) with z = N0 x, z' = N1 x, ...

    The derivatives are those along all motions (H: 1 x n).

    Can decide when H is differentiable, at sample times and parameters.

    Examples
    --------
    >>> from workbook.systems import Varying
    >>> t = sp.Symbol("t", positive=True)
    >>> pair = Varying(A=[[0, 1], [0, 0]], H=[[1, -t]], time=t)
    >>> checks.observability_matrix([[1, -t], [0, 0]], pair, []).status
    'right'
    >>> checks.observability_matrix([[1, -t], [0, 1]], pair, []).status
    'wrong'
    """
    n = system.A.rows
    slopes = [system.H.diff(system.time, k) if k else system.H for k in range(n)]
    for values in _at_times(claim, system, parameters):
        rows = _at(sp.Matrix.vstack(*slopes), values)
        powers = [_at(system.A**k, values) for k in range(n)]
        # The derivative of order k of the product H(t) x(t), by the Leibniz rule.
        terms = [[comb(k, j) * rows[j] @ powers[k - j] for j in range(k + 1)] for k in range(n)]

        def message(claimed, k, j):
            if k and np.allclose(claimed[k], terms[k][0], rtol=0, atol=1e-6 * sizes[k]):
                return (
                    f"row {k + 1} of your matrix leaves out that H changes with time: the "
                    "derivative of z = H(t) x has one term more"
                )
            order = f" of order {k}" if k > 1 else ""
            derivative = f"the derivative of z{order}" if k else "z itself"
            return (
                f"row {k + 1} times x has to be {derivative}; at {rounded_text(values)} it is not, in "
                f"column {j + 1}: there your matrix has {number_text(claimed[k, j])}"
            )

        sizes = np.array([sum(map(np.linalg.norm, row)) for row in terms])
        yield SameEntries(claim, list(map(sum, terms)), message, values, sizes[:, None])
    return f"the rows times x are z and its derivatives{tried_text(parameters, 'times')}"


@judged(Matrix("parameters", shape="system.A"), system="Varying")
def output_gramian(claim, system, duration, parameters):
    """Check the n x n matrix G with x(0)^T G x(0) = integral of z^2 over 0 <= t <= `duration`.

    The shapes are A: n x n, H: 1 x n; parameters are in general position.

    Can decide when H is continuous: the integrals are computed numerically, at sample values of
    the parameters.

    Examples
    --------
    >>> from workbook.systems import Varying
    >>> t = sp.Symbol("t", positive=True)
    >>> pair = Varying(A=[[0, 1], [0, 0]], H=[[1, -t]], time=t)
    >>> checks.output_gramian([[1, 0], [0, 0]], pair, 1, []).status
    'right'
    >>> checks.output_gramian([[1, 1], [1, 1]], pair, 1, []).status
    'wrong'
    """
    nodes, weights = np.polynomial.legendre.leggauss(160)
    moments, weights = (nodes + 1) / 2 * float(duration), weights / 2 * float(duration)
    for values in in_every_case(signed_values(parameters), claim):
        matrix = _at(system.A, values)
        # of the data, never of an answer
        row = sp.lambdify(system.time, list(system.H.subs(values)), "numpy")
        measured = np.array([np.broadcast_to(entry, moments.shape) for entry in row(moments)]).T
        rows = np.einsum("ti,tij->tj", measured, _exponentials(matrix, moments))
        true = rows.T @ (weights[:, None] * rows)
        yield SameEntries(
            claim,
            true,
            lambda claimed, i, j: (
                f"{prefix_text(values)}the entry ({i + 1}, {j + 1}) of your matrix is "
                f"{number_text(claimed[i, j])}; with it x(0)^T G x(0) is not the integral of z^2"
            ),
            values,
            np.linalg.norm(true),
        )
    return f"the entries are the integrals{tried_text(parameters)}"


@judged(Expression("system.time", "parameters"), system="Varying")
def frozen_determinant(claim, system, parameters):
    """Check the determinant of the rows H(t), H(t) A, ..., H(t) A^(n-1) of one instant.

    The row H is taken as it is at this instant.

    Can decide when H has values at the sample times and parameters.

    Examples
    --------
    >>> from workbook.systems import Varying
    >>> t = sp.Symbol("t", positive=True)
    >>> pair = Varying(A=[[0, 1], [0, 0]], H=[[1, -t]], time=t)
    >>> checks.frozen_determinant(1, pair, []).status
    'right'
    >>> checks.frozen_determinant(0, pair, []).status
    'wrong'
    """
    for values in _at_times(claim, system, parameters):
        matrix, row = _at(system.A, values), _at(system.H, values)
        rows = [(row @ np.linalg.matrix_power(matrix, k))[0] for k in range(system.A.rows)]
        scale = np.prod([np.linalg.norm(r) for r in rows])
        claimed = value_at(claim, values, "this determinant")
        uncertain = uncertainty_at(claim, values)
        if not agree(claimed, np.linalg.det(rows), claim, scale, uncertain=uncertain):
            raise Wrong(
                f"{prefix_text(values)}your expression gives {number_text(claimed)}, and this is not the "
                "determinant of the rows H, HA, ... with A and H as they are then"
            )
    return f"it is the determinant{tried_text(parameters, 'times')}"


def _at_times(claim, system, parameters):
    """Return samples of a positive time and of the parameters, with those for cases of an answer."""
    time = system.time
    return in_every_case(signed_values([time, *parameters], positive=[time]), claim)


def _exponentials(matrix, times):
    """Return e^{At} at many times at once, by Taylor's series for a part of each and squaring.

    SciPy's `expm` takes the times one by one, which costs several times as much.
    """
    squarings = max(0, int(np.ceil(np.log2(2 * np.linalg.norm(matrix) * times.max() + 1e-300))))
    parts = times[:, None, None] * (matrix / 2.0**squarings)  # of norm 1/2 at most
    exponentials = term = np.broadcast_to(np.eye(len(matrix)), parts.shape)
    for k in range(1, 17):
        term = term @ parts / k
        exponentials = exponentials + term
    for _ in range(squarings):
        exponentials = exponentials @ exponentials
    return exponentials


def _at(matrix, values):
    return np.array(sp.Matrix(matrix).subs(values).evalf(), dtype=float)
