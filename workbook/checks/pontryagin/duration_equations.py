"""Equations for the duration of a shortest process, where it has no formula."""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.shapes import LIST_OR_RANGES
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.pontryagin.parameter_ranges import with_ranges
from workbook.checks.references.optima.best_processes import best_processes
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import left_open
from workbook.checks.tools.wording import rounded_text, tried_text

#: Number of shorter durations at which an equation is evaluated; the longest of them and the step
#: around the shortest duration, as fractions of it.
SHORTER, ALMOST, NEXT = 400, 0.99, 1e-2


@judged(parameters=LIST_OR_RANGES)
def duration_equation(answer, problem, duration, parameters):
    """Check an equation whose least positive root is the shortest duration.

    In it `duration` is the symbol of the duration; `parameters` is a dict from the other
    symbols to intervals.
    """
    parameters = with_ranges(problem, parameters)
    symbols = [duration, *parameters]
    sides = answer.args if isinstance(answer, sp.Eq) else (answer, sp.S.Zero)
    left, right = (coercion.as_expression(side, symbols) for side in sides)
    claim = left - right
    if duration not in claim.free_symbols:
        raise Invalid(f"expected an equation for {duration}")
    function = real_function(symbols, [claim])
    for values, best in best_processes(problem, parameters):
        T, numbers, where = best.duration, [float(v) for v in values.values()], rounded_text(values)
        value, *nearby = function(T * np.array([1, 1 - NEXT, 1 + NEXT]), *numbers)[0]
        if not np.isfinite([value, *nearby]).all():
            raise Wrong(f"for {where} your equation is not defined next to the shortest duration")
        uncertainty = left_open(
            [claim], lambda parts, at=(T, *numbers): real_function(symbols, parts)(*at)[0]
        )
        if not abs(value) <= 1e-6 * np.abs(nearby).max() + uncertainty or value == max(
            nearby, key=abs
        ):
            raise Wrong(f"for {where} the shortest duration does not satisfy your equation")
        shorter = T * ALMOST * np.arange(1, SHORTER + 1) / SHORTER
        values_below = function(shorter, *numbers)[0]
        roots = np.flatnonzero(~(values_below[1:] * values_below[:-1] > 0))
        if roots.size:
            raise Wrong(
                f"for {where} your equation has a root near {duration} = {shorter[roots[0]]:.4g}, "
                "and no admissible process is so short"
            )
    return f"its least positive root is the shortest duration{tried_text(parameters)}"
