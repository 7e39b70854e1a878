"""Linearisation at an equilibrium, and the stability that follows from it."""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Choice
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.fields import cached_field
from workbook.checks.references.near_equilibrium import stability_from_motions
from workbook.checks.references.records import matrix_of
from workbook.checks.references.spectra import compare_region
from workbook.checks.tools.comparisons import SameWord
from workbook.checks.tools.values import matrix_at
from workbook.checks.tools.wording import deviation_rate_text, where_text

STABILITY = ("asymptotically stable", "stable", "unstable")
#: Below this a derivative is zero: the error of complex steps by terms of higher order.
FLOOR = 1e-25


@dataclass
class Rates:
    """Compare a matrix with the derivatives of the right-hand sides by each of the symbols."""

    claim: sp.MatrixBase
    true: np.ndarray
    symbols: list
    values: dict

    def judge(self):
        claimed, size = matrix_at(self.claim, self.values), max(np.linalg.norm(self.true), FLOOR)
        for symbol, claimed_column, true_column in zip(self.symbols, claimed.T, self.true.T):
            if not np.linalg.norm(claimed_column - true_column) <= 1e-9 * size:
                raise Wrong(
                    f"{deviation_rate_text(symbol, claimed_column, true_column)}{where_text(self.values)}"
                )


@judged(system="Deviations")
def linearisation_unstable(answer, system, parameters):
    """Check the parameters for which a linearisation has an eigenvalue with positive real part.

    The linearisation is that of the equations in `Deviations`.

    Can decide when the coefficients of the linearisation are polynomials in the parameters;
    elsewhere the condition is compared with the roots at points.

    Examples
    --------
    >>> from workbook.systems import Deviations
    >>> x, y = sp.symbols("x y", real=True)
    >>> e = sp.Symbol("e", real=True)
    >>> origin = Deviations([y, e*y - x], [x, y], {x: 0, y: 0})
    >>> checks.linearisation_unstable(e > 0, origin, [e]).status
    'right'
    >>> checks.linearisation_unstable(e >= 0, origin, [e]).status
    'wrong'
    """
    return compare_region(
        answer,
        matrix_of(system, parameters),
        parameters,
        "unstable by a root with positive real part",
        unstable=True,
    )


@judged(Choice(words=STABILITY))
def zero_solution_stability(claim, field, state):
    """Check whether x = 0 is asymptotically stable, stable or unstable.

    The word "stable" means stable but not asymptotically.

    Decided by the spectrum of the linearisation; where that is inconclusive, by motions that
    start close to zero.

    Can decide when the linearisation has no eigenvalue on the imaginary axis; elsewhere motions
    that start close to zero are followed.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.zero_solution_stability("asymptotically stable", [y, -x - y], [x, y]).status
    'right'
    >>> checks.zero_solution_stability("unstable", [y, -x - y], [x, y]).status
    'wrong'
    """
    flow = cached_field(tuple(field), tuple(state))
    real_part = max(np.linalg.eigvals(flow.jacobian([0.0] * len(state))).real)
    if abs(real_part) > 1e-9:
        reference = "unstable" if real_part > 0 else "asymptotically stable"
        reason = (
            f"the linearisation has an eigenvalue with real part {real_part:.4g}"
            if real_part > 0
            else f"all eigenvalues of the linearisation have real parts of at most {real_part:.4g}"
        )
    else:
        reference, reason = stability_from_motions(flow)
    return (
        yield SameWord(claim, reference, reason, "this does not agree with the motions near zero: ")
    )
