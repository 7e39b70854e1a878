"""The linear boundary value problem of a linear plant with a quadratic cost; see `linear_quadratic`."""

from dataclasses import dataclass

import mpmath
import sympy as sp


@dataclass(frozen=True)
class BoundaryProblem:
    """z' = K z for z = (y, psi, 1, s), with `initial` z(0) = 0 and `final` z(T) + `normals` nu = 0.

    SymPy matrices; s is the integral of 2 f_0 - d/dt psi^T y, and the control is `feedback` z.
    `rows`: the terminal equations to which nu belongs, of which none follows from the others for
    the states that can be reached. `terminal_cost` is phi_0 at zero, its gradient and its Hessian.
    """

    K: sp.Matrix
    initial: sp.Matrix
    final: sp.Matrix
    normals: sp.Matrix
    feedback: sp.Matrix
    terminal_cost: tuple
    rows: tuple[int, ...]


def boundary_problem(problem):
    """Return the `BoundaryProblem`; None where R is not positive definite."""
    y, u = list(problem.state), list(problem.control)
    n, sign = len(y), -1 if problem.maximise else 1
    zero = dict.fromkeys([*y, *u], 0)
    field = sp.Matrix(problem.field)
    A, B, c = field.jacobian(y), field.jacobian(u), field.subs(zero)
    running, final = sign * problem.running, sign * problem.final
    R = sp.hessian(running, u)
    if not R.is_positive_definite:
        return None
    gradient = sp.Matrix([running]).jacobian([*y, *u]).T
    Q, S = gradient[:n, :].jacobian(y), gradient[:n, :].jacobian(u)
    q, r = gradient[:n, :].subs(zero), gradient[n:, :].subs(zero)
    constant = sp.Matrix([2 * running.subs(zero)])
    feedback = R.LUsolve(sp.Matrix.hstack(-S.T, B.T, -r))
    K = sp.Matrix.vstack(
        sp.Matrix.hstack(A, sp.zeros(n, n), c) + B * feedback,
        sp.Matrix.hstack(Q, -A.T, q) + S * feedback,
        sp.zeros(1, 2 * n + 1),
        sp.Matrix.hstack(q.T, -c.T, constant) + r.T * feedback,
    ).row_join(sp.zeros(2 * n + 2, 1))
    initial = sp.zeros(n, 2 * n + 1)
    for i, value in enumerate(problem.initial.values()):
        initial[i, i if value is not None else n + i] = 1
        initial[i, 2 * n] = 0 if value is None else -value
    slope = sp.Matrix([final]).jacobian(y).T
    ends = sp.Matrix.hstack(slope.jacobian(y), sp.eye(n), slope.subs(zero))
    rows, normals = (), sp.zeros(n, 0)
    if problem.terminal:
        target = sp.Matrix(problem.terminal)
        G = target.jacobian(y)
        rows = _independent_rows(problem, G, A, B)
        targets = sp.Matrix.hstack(G, sp.zeros(G.rows, n), target.subs(zero))
        normals = sp.Matrix.vstack(sp.zeros(len(rows), len(rows)), G.extract(rows, range(n)).T)
        ends = sp.Matrix.vstack(targets.extract(rows, range(2 * n + 1)), ends)
    terminal_cost = final.subs(zero), slope.subs(zero), slope.jacobian(y)
    return BoundaryProblem(K, initial, ends, normals, feedback, terminal_cost, tuple(rows))


def _independent_rows(problem, G, A, B):
    """Return the rows of G that no other rows imply on the states that can be reached.

    Their differences span the columns of B, A B, ..., and of A^j e_i for free initial states y_i.
    """
    n = len(problem.state)
    free = [i for i, value in enumerate(problem.initial.values()) if value is None]
    part = sp.Matrix.hstack(B, sp.eye(n).extract(range(n), free))
    parts = [part]
    for _ in range(n - 1):
        part = A * part
        parts.append(part)
    return list((G * sp.Matrix.hstack(*parts)).T.rref()[1])


def evaluated(matrix):
    """Return a SymPy matrix with the digits of the arithmetic."""
    if 0 in matrix.shape:
        return mpmath.zeros(*matrix.shape)
    return mpmath.matrix(matrix.evalf(mpmath.mp.dps).tolist())


def linear_equations(boundary, duration, count):
    """Return the fundamental matrix of one of `count` steps, and the equations for (z(0), nu).

    They are (step, matrix, right), matrix (z(0), nu) = right, with the digits of the arithmetic.
    """
    m, unknown = boundary.normals.cols, boundary.final.cols - 1
    step = mpmath.expm(evaluated(boundary.K * duration / count), method="taylor")
    start = evaluated(boundary.initial)
    end = evaluated(boundary.final) * (step**count)[: unknown + 1, : unknown + 1]
    matrix, right = mpmath.zeros(unknown + m), mpmath.zeros(unknown + m, 1)
    for offset, block in ((0, start), (start.rows, end)):
        rows = slice(offset, offset + block.rows)
        matrix[rows, :unknown], right[rows, 0] = block[:, :unknown], -block[:, unknown]
    if m:
        matrix[start.rows :, unknown:] = evaluated(boundary.normals)
    return step, matrix, right
