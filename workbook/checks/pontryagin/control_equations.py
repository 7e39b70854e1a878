"""Differential equation of a control that maximises H inside its bounds.

There H_u = 0, and so is its derivative along the equations of motion and of the costates:

    u' = -(the derivative of H_u for a fixed u) / H_uu.

H_u and H_uu are linear in the costates. The costates can be eliminated if H_u = 0 and transversality
determine them up to a factor, which cancels. Otherwise H = 0 may help if the final time is free.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.tolerance import EXACT, agree
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.references.optima.units import sample_units
from workbook.checks.references.singular_arcs import hamiltonian, known_costates
from workbook.checks.tools.domains import random_value
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import uncertainty_at, value_at
from workbook.checks.tools.wording import rounded_text

#: Number of points (states, control, parameters) at which an equation is compared, and of attempts
#: to find them.
SAMPLES, ATTEMPTS = 8, 60
#: Number of costates that are tried at each point, and the relative tolerance to which u' is the
#: same for all of them.
COSTATES, DETERMINED = 6, 1e-7
#: If H_uu is smaller than this relative to its terms, u' has lost its digits.
CURVED = 1e-3


@judged(Expression("problem.state", "problem.control", "problem.parameters"))
def control_equation(claim, problem, domain=None):
    """Check the right-hand side of u' = ... for a control inside its bounds that maximises H.

    It is an expression in states, control and parameters, the costates eliminated; for problems
    with one control.

    Can decide when the problem has one control that can be inside its bounds, at sample states
    where it is.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> tracking = Problem({x: u}, {u: (-9, 9)}, {x: 1}, running=x**2 + u**2, duration=1)
    >>> checks.control_equation(x, tracking).status
    'right'
    >>> checks.control_equation(-x, tracking).status
    'wrong'
    """
    reference = _Rate(problem)
    samples = list(reference.samples(domain))
    # A single true number would be the answer itself.
    varies = len({round(true, 6) for _, true, _ in samples}) > 1
    u = problem.control[0]
    for values, true, size in samples:
        claimed = value_at(claim, values, f"{u}'")
        if agree(claimed, true, claim, size, EXACT, uncertainty_at(claim, values)):
            continue
        if not varies:
            raise Wrong(
                f"dH/d{u} does not stay zero where your expression gives {u}' the value {claimed:.4g}"
            )
        symbols = reference.symbols | claim.free_symbols
        shown = {s: value for s, value in values.items() if s in symbols}
        raise Wrong(
            f"for {rounded_text(shown)} your expression gives {u}' the value {claimed:.4g}, with "
            f"which dH/d{u} does not stay zero"
        )
    return f"under it dH/d{u} stays zero, tried at {SAMPLES} points"


class _Rate:
    """The rate of the control of a problem, computed with costates as numbers."""

    def __init__(self, problem):
        if len(problem.control) != 1:
            raise UnsuitableData("problem: expected one control")
        self._problem, (u,) = problem, problem.control
        costates = sp.symbols(f"psi:{len(problem.state)}", cls=sp.Dummy, real=True)
        H, costate_values = hamiltonian(problem, costates), known_costates(problem, costates)
        slope = sp.diff(H, u)
        drift = sum(
            (
                sp.diff(slope, y) * f - sp.diff(slope, psi) * sp.diff(H, y)
                for y, f, psi in zip(problem.state, problem.field, costates)
            ),
            sp.S.Zero,
        )
        free = [psi for psi in costates if psi not in costate_values]
        self._count = len(free) + 1
        self._symbols = [*problem.state, u, *problem.parameters]
        affine = [
            part
            for e in (slope, H, drift, sp.diff(slope, u))
            for part in _affine(e.subs(costate_values), free)
        ]
        #: The symbols that the rate depends on.
        self.symbols = set().union(*(part.free_symbols for part in affine))
        self._parts = real_function(self._symbols, affine)

    def samples(self, domain):
        """Yield (values of all symbols, rate of the control, size of its terms).

        At each of these points some costate makes H greatest.
        """
        generator, count = np.random.default_rng(31), 0
        low, high = self._problem.controls[self._problem.control[0]]
        if low.is_number and high.is_number and low.is_finite and high.is_finite:
            domain = {self._problem.control[0]: sp.Interval(low, high)} | (domain or {})
        units = sample_units(self._problem, domain=domain)
        for _ in range(ATTEMPTS):
            values = {
                s: random_value(generator, s, domain, unit=float(units.get(s, 1)))
                for s in self._symbols
            }
            rate = self._rate_at(values, generator)
            if rate is not None:
                yield values, *rate
                count += 1
            if count == SAMPLES:
                return
        raise RuntimeError("too few places were found where a costate makes H greatest")

    def _rate_at(self, values, generator):
        """Return the rate and the size of its terms, or None if no costate makes H greatest."""
        parts = self._parts(*values.values()).reshape(4, self._count)
        if not np.isfinite(parts).all():
            return None
        slope, H, drift, curvature = parts
        for rows in [slope[None]] + ([np.vstack([slope, H])] if self._problem.free_time else []):
            costates = _solutions(rows, generator)
            if costates is None:
                return None
            curvatures, sizes = costates @ curvature, np.abs(costates) @ np.abs(curvature)
            significant = np.abs(curvatures) > CURVED * sizes
            if not (curvatures[significant] < 0).any():
                return None
            costates, curvatures = costates[significant], curvatures[significant]
            rates = -(costates @ drift) / curvatures
            terms = np.abs(costates) @ np.abs(drift) / np.abs(curvatures)
            if np.ptp(rates) <= DETERMINED * terms.max():
                return float(rates[0]), float(terms[0])
        raise UnsuitableData(
            "problem: the costates cannot be eliminated from the equation of the control"
        )


def _affine(e, symbols):
    """Return the constant term and the coefficients of an expression that is linear in symbols."""
    return [e.subs(dict.fromkeys(symbols, 0)), *(sp.diff(e, s) for s in symbols)]


def _solutions(rows, generator):
    """Return some vectors (1, psi) with rows @ (1, psi) = 0; None if none has psi other than 0."""
    constant, matrix = rows[:, 0], rows[:, 1:]
    _, sizes, basis = np.linalg.svd(matrix)
    rank = int((sizes > 1e-9 * max(sizes.max(initial=0), np.abs(constant).max())).sum())
    particular = np.linalg.lstsq(matrix, -constant, rcond=1e-9)[0]
    if (
        np.abs(matrix @ particular + constant).max()
        > 1e-9 * (np.abs(constant) + np.abs(matrix) @ np.abs(particular)).max()
    ):
        return None
    homogeneous = generator.normal(size=(COSTATES, len(basis) - rank)) @ basis[rank:]
    homogeneous = np.vstack([homogeneous, -homogeneous])  # one of the two signs makes H greatest
    return (
        np.column_stack([np.ones(len(homogeneous)), particular + homogeneous])
        if (particular + homogeneous).any()
        else None
    )
