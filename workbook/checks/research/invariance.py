"""Weights of estimates that are unbiased and do not see a nuisance."""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expressions
from workbook.checks.contract.verdict import judged
from workbook.checks.tools.comparisons import SameEntries
from workbook.checks.tools.samples import in_every_case, random_values
from workbook.checks.tools.wording import prefix_text


@judged(Expressions("signal", "nuisance", length=lambda data: len(data["signal"][0])))
def invariant_weights(claims, signal, nuisance, functional):
    """Check the weights of least sum of squares that make an estimate unbiased.

    The estimated number is linear in the coefficients of the signal, and the estimate is
    unbiased whatever the coefficients of signal and nuisance are. `functional`: that number for
    each function of the signal.
    """
    claim = sp.Matrix(list(claims))
    symbols = sorted(sp.Matrix([*signal, *nuisance]).free_symbols, key=str)
    for values in in_every_case(random_values(symbols, 82), claim):
        psi, theta = (
            np.array(sp.Matrix(rows).subs(values).evalf(), dtype=float).reshape(
                len(rows), claim.rows
            )
            for rows in (signal, nuisance)
        )
        functional_values = np.array(
            [float(sp.sympify(number).subs(values)) for number in functional]
        )
        conditions = np.vstack([psi, theta])
        right = np.append(functional_values, np.zeros(len(theta)))
        true = np.linalg.pinv(conditions) @ right

        def message(claimed, i, j):
            weights, where = claimed[:, 0].real, prefix_text(values)
            means, nuisance_factors = psi @ weights, theta @ weights
            slack = 1e-6 * np.abs(conditions) @ np.abs(weights)
            for k in np.flatnonzero(np.abs(means - functional_values) > slack[: len(psi)])[:1]:
                return (
                    f"{where}function {k + 1} of the signal comes out of your weights as "
                    f"{means[k]:.4g}, not as it should: the estimate is biased"
                )
            for k in np.flatnonzero(np.abs(nuisance_factors) > slack[len(psi) :])[:1]:
                return (
                    f"{where}function {k + 1} of the nuisance comes through your weights "
                    f"with the factor {nuisance_factors[k]:.4g}"
                )
            return (
                f"{where}your weights are unbiased and ignore the nuisance, but their sum of "
                f"squares {weights @ weights:.4g} is not the least"
            )

        yield SameEntries(
            claim, true[:, None], message, values, np.full((true.size, 1), np.abs(true).max())
        )
    return "unbiased, unaffected by the nuisance and of least variance, for random values of the symbols"
