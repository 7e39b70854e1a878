"""The best processes of a `pontryagin.Problem`, found without the maximum principle.

Of a transfer in least or greatest time of a kind known to `transfer_optima` or `thrust_optima` the
optimum has a formula or a search of its own; of any other problem it comes from `direct_optimum`.
All are an `optimum.Optimum`; with more than one control it has `duration` and `arcs` alone. All search
in the units of `units.scaled_problem`; a constant of the cost is in none of their numbers.
"""

from trajlib._arguments.symbols import join_names
from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.optima.direct_optimum import optima
from workbook.checks.references.optima.thrust_optima import thrust_optima
from workbook.checks.references.optima.transfer_optima import SAMPLES, Transfer, Unknown
from workbook.checks.references.optima.units import in_scaled_units


def best_processes(problem, parameters=None, count=SAMPLES):
    """Return pairs ({parameter: value}, optimum).

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem.
    parameters : dict or list of sympy.Symbol, optional
        {symbol: interval in which answers are tried}, or, for transfers of `transfer_optima`, a list:
        then `count` sets of values are drawn for which the target can be reached.
    count : int
        Their number.
    """
    if unnamed := set(problem.parameters) - set(parameters or ()):
        raise UnsuitableData(
            f"parameters: expected intervals of all symbols, got none of {join_names(unnamed)}"
        )
    if not isinstance(parameters, dict):
        try:
            return Transfer(problem, parameters or ()).samples(count)
        except Unknown:
            if parameters:
                raise UnsuitableData(
                    "parameters: expected a dict from symbols to intervals for this problem, got a list"
                ) from None
    return best_processes_at(problem, parameters)


@in_scaled_units
def best_processes_at(problem, parameters, points=None):
    """Return pairs (point, optimum) at points, dicts from the parameters to numbers, or at samples."""
    pairs = thrust_optima(problem, parameters, points)
    return optima(problem, parameters, points) if pairs is None else pairs


def free_at_the_start(problem, parameters=None):
    """Return for each state whether its initial value is free: neither given nor a parameter."""
    return [value is None and x not in (parameters or ()) for x, value in problem.initial.items()]
