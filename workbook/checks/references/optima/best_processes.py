"""The best processes of a `pontryagin.Problem`, found without the maximum principle: in the way
that suits the problem.

Of a transfer in least or greatest time whose kind `transfer_optima` or `thrust_optima` knows the
optimum has a formula or a search of its own; of any other problem it comes from `direct_optimum`,
or, with more than one control, from `several_controls`, which tells durations and arcs alone. The
others give it with the same attributes: `duration`, `cost`, `times`, `states` (a column for each
time), `controls`, `start`, `bounds`, `field`, `gap`, `total`, `jacobians`.
"""

from workbook.checks.references.optima.direct_optimum import optima
from workbook.checks.references.optima.several_controls import optima as optima_of_several
from workbook.checks.references.optima.thrust_optima import thrust_optima
from workbook.checks.references.optima.transfer_optima import SAMPLES, Transfer, Unknown


def best_processes(problem, parameters=None, count=SAMPLES):
    """Pairs ({parameter: value}, optimum).

    `parameters` is a dict from symbols to the intervals in which answers are tried, or, where
    `transfer_optima` knows the optimum, a list of symbols: then it draws `count` sets of values for
    which the target can be reached.
    """
    if len(problem.controls) > 1:
        return optima_of_several(problem, parameters)
    found = thrust_optima(problem, parameters) if isinstance(parameters or {}, dict) else None
    if found is not None:
        return found
    if not isinstance(parameters, dict):
        try:
            return Transfer(problem, parameters or ()).samples(count)
        except Unknown:
            if parameters:
                raise
    return optima(problem, parameters)


def best_processes_at(problem, parameters, places):
    """The same at given places, dicts from the parameters to numbers between the bounds of their
    intervals."""
    if len(problem.controls) > 1:
        return optima_of_several(problem, parameters, places)
    found = thrust_optima(problem, parameters, places)
    return optima(problem, parameters, places) if found is None else found


def free_at_the_start(problem, parameters=None):
    """For each state whether its start is to be chosen: it is neither given nor a parameter."""
    return [value is None and x not in (parameters or ()) for x, value in problem.initial.items()]
