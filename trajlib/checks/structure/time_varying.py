"""An output z = H(t) x of x' = A x whose row changes with time: what it shows, its derivatives, its Gramian, the trap
of frozen rows.

Where H(t) consists of sines, cosines, exponentials and powers of t, the products of these functions with the
coordinates obey linear equations with constant coefficients. So z is an output of a constant system of higher order,
from known starts for every x(0), and what it never shows is found exactly (`known_starts`), at every exceptional value
of a parameter too. No derivative rows are needed.
"""

from math import comb

import numpy as np
import sympy as sp

from trajlib.checks.contract.claims import Expression, Matrix
from trajlib.checks.contract.tolerance import share
from trajlib.checks.contract.verdict import Wrong, judged
from trajlib.checks.structure.dual_questions import OUTPUT, judge_region
from trajlib.checks.structure.unseen_bases import bases_by_value, judge_where_lost
from trajlib.checks.tools.comparisons import Entries, Same
from trajlib.checks.tools.samples import in_every_case, signed_values
from trajlib.checks.tools.values import value_at
from trajlib.checks.tools.wording import number_text, rounded_text
from trajlib.checks.truths.known_starts import starts_of

#: More functions than this a row H(t) of a problem does not need for its derivatives.
MOST_FUNCTIONS = 16


@judged(Expression("time", "start", "parameters"))
def varying_output(claim, A, H, time, start, parameters):
    """z(t) along the motion from the start, an expression in the symbols of the start, the time and the parameters."""
    from scipy.linalg import expm

    for values in in_every_case(signed_values([time, *start, *parameters], positive=[time]), claim):
        x = np.array([values[symbol] for symbol in start])
        matrix, row = _at(A, values), _at(H, values)
        z = float((row @ expm(values[time] * matrix) @ x)[0])
        yield Same(claim, z, "z", values, np.linalg.norm(row) * np.linalg.norm(x))
    return "it is H(t) x(t) for all starts, moments and parameters tried"


@judged(Matrix("time", "parameters", shape="A"))
def derivative_rows(claim, A, H, time, parameters):
    """The n x n matrix of the rows N0, ..., N(n-1) with z = N0 x, z' = N1 x, ... along all motions (H: 1 x n)."""
    n = A.rows
    slopes = [H.diff(time, k) if k else H for k in range(n)]
    for values in in_every_case(signed_values([time, *parameters], positive=[time]), claim):
        rows, powers = _at(sp.Matrix.vstack(*slopes), values), [_at(A**k, values) for k in range(n)]
        # The derivative of order k of the product H(t) x(t), by the rule of Leibniz.
        terms = [[comb(k, j) * rows[j] @ powers[k - j] for j in range(k + 1)] for k in range(n)]

        def told(said, k, j):
            if k and np.allclose(said[k], terms[k][0], rtol=0, atol=1e-6 * sizes[k]):
                return (f"row {k + 1} of your matrix leaves out that H changes with time: the derivative of z = H(t) x "
                        "has one term more")
            what = "z itself" if k == 0 else "the derivative of z" if k == 1 else f"the derivative of z of order {k}"
            return (f"row {k + 1} times x has to be {what}; at {rounded_text(values)} it is not, in column {j + 1}: "
                    f"there your matrix has {number_text(said[k, j])}")

        sizes = np.array([sum(map(np.linalg.norm, row)) for row in terms])
        yield Entries(claim, list(map(sum, terms)), told, values, sizes[:, None])
    return "the rows times x are z and its derivatives, at all moments and parameters tried"


@judged(Matrix("parameters", shape="A"))
def output_gramian(claim, A, H, time, duration, parameters):
    """The n x n matrix G with x(0)^T G x(0) = the integral of z^2 over 0 <= t <= `duration` (A: n x n, H: 1 x n), for
    parameters in general position."""
    from scipy.linalg import expm

    nodes, weights = np.polynomial.legendre.leggauss(160)
    moments, weights = (nodes + 1) / 2 * float(duration), weights / 2 * float(duration)
    for values in in_every_case(signed_values(parameters), claim):
        matrix = _at(A, values)
        row = sp.lambdify(time, list(H.subs(values)), "numpy")  # of the data, never of an answer
        measured = np.array([np.broadcast_to(entry, moments.shape) for entry in row(moments)]).T
        rows = np.einsum("ti,tij->tj", measured, expm(moments[:, None, None] * matrix))
        true = rows.T @ (weights[:, None] * rows)
        yield Entries(claim, true, lambda said, i, j: (
            f"for {rounded_text(values)} the entry ({i + 1}, {j + 1}) of your matrix is {number_text(said[i, j])}; the "
            f"integral is {true[i, j]:.4g}" if values else  # the true number would be the answer itself
            f"the entry ({i + 1}, {j + 1}) of your matrix is {number_text(said[i, j])}, and the integral is not"),
            values, np.linalg.norm(true))
    return "the entries are the integrals, for all parameters tried"


@judged(Expression("time", "parameters"))
def frozen_determinant(claim, A, H, time, parameters):
    """The determinant of the rows H(t), H(t) A, ..., H(t) A^(n-1) of one moment, with H taken as it is then."""
    for values in in_every_case(signed_values([time, *parameters], positive=[time]), claim):
        matrix, row = _at(A, values), _at(H, values)
        rows = [(row @ np.linalg.matrix_power(matrix, k))[0] for k in range(A.rows)]
        scale, said = np.prod([np.linalg.norm(r) for r in rows]), value_at(claim, values, "this determinant")
        if not abs(said - np.linalg.det(rows)) <= share(claim) * scale:
            # The rows and not their determinant, which may be the answer itself.
            told = ", ".join(f"({', '.join(map(number_text, r))})" for r in rows)
            raise Wrong(f"at one of the moments tried the rows are {told}; {number_text(said)}, which your expression "
                        f"gives, is not their determinant")
    return "it is the determinant at all moments and parameters tried"


@judged
def varying_observable_parameters(answer, A, H, time, parameters):
    """The condition on the parameters under which z on an interval determines the state; exact at isolated values."""
    return judge_region(answer, _starts(A, H, time, parameters), OUTPUT)


@judged(bases_by_value(OUTPUT))
def varying_unseen_where_lost(claim, A, H, time, parameter):
    """Every real value of the parameter for which the system is not observable, as {value: basis of the unseen initial
    states}."""
    return judge_where_lost(claim, _starts(A, H, time, (parameter,)), OUTPUT,
                            lambda value: _starts(A.subs(parameter, value), H.subs(parameter, value), time))


def _starts(A, H, time, parameters=()):
    """The products of the functions in H(t) with the coordinates of x as one constant system, from its starts for every
    x(0)."""
    functions, rates, rows = _functions(H, time)
    n, E = A.rows, sp.eye(len(functions))
    matrix = sp.kronecker_product(rates, sp.eye(n)) + sp.kronecker_product(E, A)
    begin = sp.Matrix([f.subs(time, 0) for f in functions])
    return starts_of(matrix, sp.Matrix.hstack(*rows), sp.kronecker_product(begin, sp.eye(n)), parameters)


def _functions(H, time):
    """Functions f of time with f' = R f and H = f1 H1 + f2 H2 + ...: (f, R, [H1, H2, ...])."""
    parts = [_split(entry, time) for entry in H]
    functions = list(dict.fromkeys(f for part in parts for f in part))
    slopes = []
    while len(slopes) < len(functions):
        slopes.append(_split(functions[len(slopes)].diff(time), time))
        functions += [f for f in slopes[-1] if f not in functions]
        if len(functions) > MOST_FUNCTIONS:
            raise ValueError("H(t) has to consist of sines, cosines, exponentials and powers of the time")
    rates = sp.Matrix(len(functions), len(functions), lambda i, j: slopes[i].get(functions[j], 0))
    return functions, rates, [sp.Matrix(*H.shape, [part.get(f, 0) for part in parts]) for f in functions]


def _split(expression, time):
    """{function of time: its coefficient} of a sum."""
    found = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        coefficient, function = term.as_independent(time, as_Add=False)
        if coefficient != 0:
            found[function] = found.get(function, 0) + coefficient
    return found


def _at(matrix, values):
    return np.array(sp.Matrix(matrix).subs(values).evalf(), dtype=float)
