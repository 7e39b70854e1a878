"""Which terms of a claimed right-hand side of an equation are wrong, for a message.

The claim is evaluated at other values of its symbols, which the student can repeat with the answer.
"""

import sympy as sp

from workbook.checks.contract.tolerance import agree
from workbook.checks.tools.values import entry_uncertainties, matrix_at


def wrong_degree_text(claim, values, unknown, terms, size, name):
    """Return which terms of a quadratic right-hand side are wrong, by their degree in symbols.

    Parameters
    ----------
    claim : sympy.Matrix
        The right-hand side of the answer, which is wrong at the values.
    values : dict
        {symbol: value}.
    unknown : sympy.Matrix
        The unknown matrix, of symbols.
    terms : list of numpy.ndarray
        The true terms: two that are linear in it, the one without it, perhaps others.
    size : numpy.ndarray
        The size of the terms of each entry.
    name : str
        The name of the unknown matrix, for the message.
    """
    uncertain, symbols = entry_uncertainties(claim, values), unknown.free_symbols

    def right(numbers, true):
        return agree(numbers, true, claim, size, uncertain=uncertain).all()

    if not right(matrix_at(claim, values | dict.fromkeys(symbols, sp.S.Zero)), terms[2]):
        return f"look at the terms that do not contain {name}"
    opposite = matrix_at(claim, values | {s: -values[s] for s in symbols})
    if not right((matrix_at(claim, values) - opposite) / 2, terms[0] + terms[1]):
        return f"look at the terms that are linear in {name}"
    return f"look at the terms that are quadratic in {name}"


def innovation_text(claim, values, outputs, prediction, expected, size, controlled=False):
    """Return the property in which an equation of a filter fails.

    Parameters
    ----------
    claim : sympy.Matrix
        The right-hand side of the answer, which is wrong at the values.
    values : dict
        {symbol: value}.
    outputs : list of sympy.Symbol
        The measurements z.
    prediction : numpy.ndarray
        Their prediction H y, a column.
    expected : numpy.ndarray
        The rate where the measurements equal their prediction, a column.
    size : numpy.ndarray
        The size of the terms of each component.
    controlled : bool
        Whether a feedback by the estimate acts on the system.
    """
    predicted = values | {z: sp.Float(h, 17) for z, h in zip(outputs, prediction[:, 0])}
    numbers = matrix_at(claim, predicted)
    uncertain = entry_uncertainties(claim, values)
    if agree(numbers, expected, claim, size, uncertain=uncertain).all():
        return "the innovation does not enter with the best gain"
    return (
        "where the innovation is zero, the estimate does not change as the state does without "
        f"noise{' under the best control' if controlled else ''}"
    )
