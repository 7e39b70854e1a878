"""Transversality conditions at the end of a process.

`problem` is a `pontryagin.Problem`; `costates` are the symbols psi_1, ..., psi_n in the order of
its states. The cost has the multiplier lambda_0 = 1: H = psi^T f - f_0, or + f_0 if the cost is
maximised.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.members import members
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.pontryagin.sample_points import SAMPLES, ZeroSet, as_difference, shares_of
from workbook.checks.references.optima.units import sample_units
from workbook.checks.tools.domains import random_value
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.samples import cached_points
from workbook.checks.tools.values import number_at
from workbook.checks.tools.wording import rounded_text


@judged(problem="pontryagin.Problem with any number of controls")
def transversality(answer, problem, costates):
    """Check the transversality conditions at the end of the process, with lambda_0 = 1.

    They are a list of expressions or equations in costates, states and parameters, without the
    multipliers of the target. H = 0 does not belong to them.

    Can decide when the target is given by terminal conditions; points on it and costates are
    sampled.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> wall = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 4, v: 0}, [x])
    >>> checks.transversality([p2], wall, [p1, p2]).status
    'right'
    >>> checks.transversality([p1], wall, [p1, p2]).status
    'wrong'
    """
    symbols = [*costates, *problem.state, *problem.parameters]
    claims = [
        as_difference(part, symbols)
        for part in members(
            answer, "a list of expressions that vanish at the end", single=(sp.Expr, sp.Eq)
        )
    ]
    sign = -1 if problem.maximise else 1
    target = real_function(
        [*problem.state, *problem.parameters],
        [sp.diff(g, y) for g in problem.terminal for y in problem.state],
    )
    units = sample_units(problem, costates)
    state_units, costate_units = (
        np.array([float(units[s]) for s in symbols]) for symbols in (problem.state, costates)
    )
    for values in _on_target(problem):
        normals = target(*(float(values[s]) for s in (*problem.state, *problem.parameters)))
        tangents = _kernel(normals.reshape(-1, len(problem.state)) * state_units)
        gradient = [float(sp.diff(problem.final, y).subs(values)) for y in problem.state]
        true = np.column_stack([tangents, sign * tangents @ (gradient / costate_units)])
        claimed = _affine_rows(claims, costates, values) * [*costate_units, 1]
        extra = _rank(claimed) - _rank(true)
        missing = _rank(np.vstack([claimed, true])) - _rank(claimed)
        if (missing and extra >= 0) or extra > 0:
            raise Wrong(
                f"at the end {rounded_text(values)} your conditions require what need not hold: "
                "there are costates that satisfy the transversality condition and not yours"
            )
        if missing:
            raise Wrong(
                f"at the end {rounded_text(values)} your conditions allow costates that are not "
                "orthogonal to the target"
            )
    return "they are equivalent to the transversality condition"


@cached_points
def _on_target(problem):
    """Return states at the end, with parameters, as dicts."""
    units = sample_units(problem)
    zeros = (
        ZeroSet(list(problem.terminal), list(problem.state), list(problem.parameters), units)
        if problem.terminal
        else None
    )
    generator, points, symbols = np.random.default_rng(3), [], (*problem.state, *problem.parameters)
    for k in range(4 * SAMPLES):
        if k % SAMPLES == 0:
            shares = shares_of(symbols, generator)
        values = {
            s: random_value(generator, s, None, shares[s][k % SAMPLES], float(units.get(s, 1)))
            for s in symbols
        }
        point = zeros.zero_near(values) if zeros else values
        if point is not None and len(points) < SAMPLES:
            points.append(point)
    if not points:
        raise RuntimeError("no point of the target was found")
    return points


def _affine_rows(claims, costates, values):
    """Return rows (coefficients of the costates, constant) of the conditions at an end.

    A sum of squares gives a row for each square.
    """
    rows, zero = [], dict.fromkeys(costates, 0)
    for claim in claims:
        expanded = sp.expand(claim.subs(values))
        row = [sp.diff(expanded, psi) for psi in costates]
        if any(sp.diff(c, psi).free_symbols for c in row for psi in costates):
            raise Invalid("expected conditions that are linear in the costates, or sums of squares")
        hessian = np.array(
            [[number_at(sp.diff(c, psi), {}).real for psi in costates] for c in row], dtype=float
        )
        slopes, constant = (
            [number_at(c.subs(zero), {}).real for c in part] for part in (row, [expanded])
        )
        rows += (
            _squares(hessian, np.array(slopes), *constant)
            if hessian.any()
            else [[*slopes, *constant]]
        )
    return np.array(rows, dtype=float).reshape(len(rows), len(costates) + 1)


def _squares(hessian, slopes, constant):
    """Return rows that vanish where psi.hessian.psi/2 + slopes.psi + constant does.

    Zero has to be the least or the greatest value of this expression.
    """
    minimiser = np.linalg.lstsq(hessian, -slopes, rcond=1e-9)[0]
    sizes, _ = np.linalg.eigh(hessian)
    size = np.abs(hessian).max()
    if (
        (sizes.min() < -1e-9 * size and sizes.max() > 1e-9 * size)
        or not np.allclose(hessian @ minimiser, -slopes)
        or not abs(constant + slopes @ minimiser / 2)
        <= 1e-9 * (abs(constant) + abs(slopes) @ abs(minimiser) + size)
    ):
        raise Invalid("expected conditions that are linear in the costates, or sums of squares")
    return np.column_stack([hessian, slopes]).tolist()


def _kernel(rows):
    """Return an orthonormal basis of the kernel of the rows, as rows."""
    _, sizes, basis = np.linalg.svd(rows)
    return basis[int((sizes > 1e-9 * sizes.max(initial=0)).sum()) :]


def _rank(rows):
    if not rows.size:
        return 0
    rows = rows / np.maximum(np.abs(rows).max(axis=1, keepdims=True), 1e-300)
    sizes = np.linalg.svd(rows, compute_uv=False)
    return int((sizes > 1e-6 * max(sizes.max(), 1.0)).sum())
