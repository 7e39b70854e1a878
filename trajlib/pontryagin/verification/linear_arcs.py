"""Exact arcs of a linear plant with a quadratic cost: linear equations for z = (y, psi, 1).

With lambda_0 = 1 the plant y' = A y + B u + c, the adjoint system and dH/du are affine in
(y, psi, u). On an arc every control is affine in (y, psi) too, u = U z: a bound; the zero of dH/du
(interior); or -a/b from the first derivative of dH/du that contains it (singular). So z' = M z, and
an arc is a matrix exponential. All entries are exact SymPy numbers.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib.pontryagin.problem.derivation import conditions
from trajlib.pontryagin.problem.statement import Statement


class NotLinear(ValueError):
    """The arcs are not of the form above; the message names the reason."""


@dataclass(frozen=True)
class LinearArc:
    """An arc as matrices that act on z, N = 2n + 1.

    Attributes
    ----------
    kinds : tuple of str
        One for each control.
    control, rate, slopes : sympy.Matrix
        U (k, N), M (N, N) and dH/du (k, N).
    invariants : dict
        {control: rows} that vanish along a singular arc: dH/du and its derivatives of orders 1 to
        2q-1.
    """

    kinds: tuple[str, ...]
    control: sp.Matrix
    rate: sp.Matrix
    slopes: sp.Matrix
    invariants: dict


class LinearArcs:
    """The arcs of a problem of this form, and its end conditions as rows for z.

    Attributes
    ----------
    target, transversality : sympy.Matrix
        The terminal equations, and products of psi + grad phi_0 with the tangents of the target.
    bounds : list of tuple
        (lower, upper) of the controls.
    size : int
        N.
    """

    def __init__(self, problem: Statement):
        self.problem, derived = problem, conditions(problem)
        y, psi, u = list(problem.state), list(derived.costate), list(problem.control)
        self.n, self.size = len(y), 2 * len(y) + 1
        self.bounds = list(problem.controls.values())
        normal = derived.normal
        rates = [
            *problem.field,
            *(e.subs(derived.multiplier, 1) for e in derived.adjoint.values()),
            sp.Integer(0),
        ]
        rows = _rows([*rates, *(sp.diff(normal, v) for v in u)], [*y, *psi, *u])
        inside = [*range(2 * self.n), rows.cols - 1]
        controls = list(range(2 * self.n, rows.cols - 1))
        self._rate, self._gain = rows[: self.size, inside], rows[: self.size, controls]
        self._slope, self._curvature = rows[self.size :, inside], rows[self.size :, controls]
        self._ends(problem, y, psi)
        self._arcs: dict[tuple[str, ...], LinearArc] = {}

    def _ends(self, problem, y, psi):
        sign = -1 if problem.maximise else 1
        symbols = [*y, *psi]
        self.target = (
            _rows(problem.terminal, symbols) if problem.terminal else sp.zeros(0, self.size)
        )
        tangents = (
            self.target[:, : self.n].nullspace()
            if problem.terminal
            else sp.eye(self.n).columnspace()
        )
        normals = [p + sign * sp.diff(problem.final, s) for p, s in zip(psi, y)]
        products = [
            sum((t * e for t, e in zip(tangent, normals)), sp.Integer(0)) for tangent in tangents
        ]
        self.transversality = _rows(products, symbols) if products else sp.zeros(0, self.size)

    def arc(self, kinds: tuple[str, ...]) -> LinearArc:
        """Return the arc of these kinds. Raises `NotLinear` where the controls are not determined."""
        if kinds not in self._arcs:
            self._arcs[kinds] = self._built(kinds)
        return self._arcs[kinds]

    def _built(self, kinds):
        U = sp.zeros(len(kinds), self.size)
        for j, kind in enumerate(kinds):
            if kind in ("u-", "u+"):
                U[j, self.size - 1] = self.bounds[j][kind == "u+"]
        inside = [j for j, kind in enumerate(kinds) if kind == "interior"]
        singular = [j for j, kind in enumerate(kinds) if kind == "singular"]
        if len(singular) > 1:
            raise NotLinear("several controls are singular at once")
        if inside:
            curvature = self._curvature[inside, inside]
            if curvature.det() == 0:
                raise NotLinear(
                    "the maximum condition does not determine the controls on an interior arc"
                )
            inner = -curvature.LUsolve(self._slope[inside, :] + self._curvature[inside, :] * U)
            for row, j in enumerate(inside):
                U[j, :] = inner[row, :]
        invariants = {}
        for j in singular:
            invariants[j], U[j, :] = self._singular(j, U)
        return LinearArc(
            kinds, U, self._rate + self._gain * U, self._slope + self._curvature * U, invariants
        )

    def _singular(self, j, U):
        """Return dH/du with its derivatives that do not contain the control, and the control."""
        if any(self._curvature[:, j]):
            raise NotLinear("a singular control occurs in the maximum condition of another one")
        rate, gain = self._rate + self._gain * U, self._gain[:, j]
        rows = [self._slope[j, :] + self._curvature[j, :] * U]
        while len(rows) <= self.size:
            derivative, factor = rows[-1] * rate, (rows[-1] * gain)[0]
            if factor != 0:
                return rows, -derivative / factor
            rows.append(derivative)
        raise NotLinear("no derivative of the switching function contains the singular control")

    def hamiltonian(self, arc):
        """Return S with H = z^T S z - 1 on an arc, for the least time."""
        S = sp.zeros(self.size, self.size)
        S[self.n : 2 * self.n, :] = arc.rate[: self.n, :]
        return S

    def running(self, arc):
        """Return P with f_0 = z^T P z on an arc."""
        y, u = list(self.problem.state), list(self.problem.control)
        zero = dict.fromkeys([*y, *u], 0)
        # f_0 = w^T Q w with w = (y, u, 1) = W z.
        f, symbols = self.problem.running, [*y, *u]
        slope = sp.Matrix([sp.diff(f, v).subs(zero) for v in symbols])
        Q = sp.Matrix(
            sp.BlockMatrix(
                [
                    [sp.hessian(f, symbols) / 2, slope / 2],
                    [slope.T / 2, sp.Matrix([[f.subs(zero)]])],
                ]
            )
        )
        last = sp.zeros(1, self.size)
        last[self.size - 1] = 1
        W = sp.Matrix.vstack(sp.eye(self.size)[: self.n, :], arc.control, last)
        return W.T * Q * W


def _rows(expressions, symbols):
    """Return the coefficients of affine expressions, the constants last."""
    matrix, constants = sp.linear_eq_to_matrix(list(expressions), symbols)
    return matrix.row_join(-constants)
