"""Ranges in which answers about optimal processes are tried, where parameters come as a list."""

import sympy as sp

from workbook.checks.contract.data_kinds import dict_of_ranges
from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.optima.transfer_optima import Transfer, Unknown

#: Sizes of parameters. A process of such a duration ends before the first conjugate point of a
#: problem whose coefficients are of size one.
RANGE = sp.Interval(sp.Rational(1, 2), 2)


def with_ranges(problem, parameters):
    """Return the parameters of a problem with intervals, a dict; those of a transfer as they are.

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem.
    parameters : dict or list of sympy.Symbol or None
        For a list, each parameter gets values of size one and of all signs that its assumptions
        allow. A transfer in least or greatest time whose optimum has a formula finds such values
        itself.

    Raises
    ------
    UnsuitableData
        If controls are bounded: then it depends on the parameters whether there is a process at all.
    """
    if not parameters or isinstance(parameters, dict):
        return parameters
    try:
        Transfer(problem, parameters)
        return parameters
    except Unknown:
        if any(bound.is_finite for pair in problem.controls.values() for bound in pair):
            raise UnsuitableData(
                "parameters: this problem has bounds of its control, so write for which values it has "
                f"a solution: {dict_of_ranges(parameters)}"
            ) from None
        return {p: _range(p) for p in parameters}


def _range(parameter):
    if parameter.is_nonnegative:
        return RANGE
    below = sp.Interval(-RANGE.sup, -RANGE.inf)
    return below if parameter.is_nonpositive else sp.Interval(below.inf, RANGE.sup)
