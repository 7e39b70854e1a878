"""Texts of numbers and of values of symbols in messages, such as counterexamples."""

import math

import numpy as np
import sympy as sp

from workbook.checks.contract.direction import directed

#: What an expression gives where `real_function` has nan and `real_at` None.
NO_NUMBER = "no real number, or one too large to be computed with"

#: The least number of instants of a process that may be named. More would show its duration.
INSTANTS = 10


def value_text(number):
    """Return a float for a message; nan is what has no number."""
    return f"{number:.4g}" if math.isfinite(number) else NO_NUMBER


def number_text(number):
    """Return a real or complex number for a message: `0.5`, `-1 + 2i`."""
    z = complex(number)
    if abs(z.imag) < 1e-12 * (1 + abs(z)):
        return f"{z.real:.4g}"
    if abs(z.real) < 1e-12 * abs(z):
        return f"{z.imag:.4g}i"
    return f"{z.real:.4g} {'+' if z.imag > 0 else '-'} {abs(z.imag):.4g}i"


def other_text(quantity, value, true):
    """Return the text on a wrong quantity, which shows only the answer's number.

    The text is `the cost is less than 7.249, which your expression gives`, or without the direction
    `the cost is not 7.249, which ...`. The number has as many digits as distinguish it from the true
    one, at least four.
    """
    text = next(
        (t for t in (f"{value:.{n}g}" for n in range(4, 17)) if float(t) != float(true)), value
    )
    comparison = directed("greater than" if true > value else "less than", "not")
    return f"{quantity} is {comparison} {text}, which your expression gives"


def roots_text(roots):
    """Return the roots of an equation for a message, without imaginary parts of rounding.

    >>> roots_text([-1 + 2j, -1 - 2j, -3 + 1e-15j])
    '-1 +/- 2i and -3'
    >>> roots_text([2j, -2j])
    '+/- 2i'
    """
    texts = {}
    for z in map(complex, roots):
        text = number_text(z.real if abs(z.imag) < 1e-9 * (1 + abs(z)) else z)
        pure = text.endswith("i") and " " not in text
        pair = f"+ {text.removeprefix('-')}" if pure else text.replace(" - ", " + ")
        texts.setdefault(pair, []).append(text)
    return " and ".join(
        pair.replace("+ ", "+/- ") if len(set(root_texts)) > 1 else " and ".join(root_texts)
        for pair, root_texts in texts.items()
    )


def values_text(values):
    """Return values of symbols: `k = 1/3, omega = 2`, in decimals if not simple fractions."""

    def text(x):
        if x.is_Rational and x.q < 1000 and abs(x) < 10**6:
            return str(x)
        return f"{float(x):.6g}" if abs(x) < 10**300 else str(sp.N(x, 6))

    return ", ".join(f"{symbol} = {text(x)}" for symbol, x in values.items())


def entry_text(values, i, j):
    """Return the position and value of a wrong entry; of a single number the value only."""
    entry = "yours" if values.size == 1 else f"look at the entry ({i + 1}, {j + 1}), where yours"
    return f"{entry} is {number_text(values[i, j])}"


def with_article(noun):
    """Return a noun with its indefinite article, for a message."""
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def part_text(quantity, values, i):
    """Return the text on a wrong component: `component 2 of your estimate is 0.5`."""
    return (
        f"component {i + 1} of " if values.size > 1 else ""
    ) + f"your {quantity} is {number_text(values[i, 0])}"


def where_text(values):
    """Return the values of a sample for the end of a message; empty without values."""
    return f" for {values_text(values)}" if values else ""


def rounded_text(values):
    """Return values of symbols rounded to three digits: `M = 0.713, rho = 2.4`."""
    return ", ".join(f"{symbol} = {float(value):.3g}" for symbol, value in values.items())


def prefix_text(values):
    """Return values of symbols for the beginning of a sentence: `for M = 0.713 `."""
    return f"for {rounded_text(values)} " if values else ""


def deviation_rate_text(symbol, values, true):
    """Return the message on a wrong column of deviation equations: which entry, and its value."""
    k = max(range(len(values)), key=lambda i: abs(values[i] - true[i]))
    right_hand_side = "the right-hand side" if len(values) == 1 else f"right-hand side {k + 1}"
    return (
        f"the partial derivative of {right_hand_side} with respect to {symbol} is not "
        f"{number_text(values[k])}, which your answer gives"
    )


def sample_text(values):
    """Return values of parameters for the beginning of a sentence: `for k = 2/3 `."""
    texts = (f"{p} = {v if v.q < 20 else f'{float(v):.4g}'}" for p, v in values.items())
    return f"for {', '.join(texts)} " if values else ""


def process_part_text(t, duration):
    """Return in words where in a process something fails.

    Of an instant on a grid, and of the value of an answer there, the duration could be computed.
    """
    share = t / duration
    if not 0.02 < share < 0.98:
        return "at the beginning" if share < 0.5 else "at the end"
    part = "early" if share < 1 / 3 else "in the middle" if share < 2 / 3 else "late"
    return f"{part} in the process" if part != "in the middle" else f"{part} of the process"


def round_instants(duration):
    """Return instants of a process that may be named: multiples of 0.1, 0.2, 0.5, 1 and the like.

    Of the duration they show no more than the order of its size.
    """
    power = 10.0 ** np.floor(np.log10(duration / INSTANTS))
    step = power * max(m for m in (1, 2, 5) if m * power <= duration / INSTANTS * (1 + 1e-9))
    return step * np.arange(1, int(duration / step * (1 - 1e-9)) + 1)


def tried_text(parameters, *kinds):
    """Return the clause on the sample values used: `, at all times and parameters tried`."""
    sampled = [*kinds, *(["parameters"] if parameters else [])]
    return f", at all {' and '.join(sampled)} tried" if sampled else ""


def point_text(point):
    """Return the coordinates of a point: `(1, -0.5)`, with 0 for mere rounding."""
    numbers = [float(x) for x in point]
    least = max([1e-12, *(1e-8 * abs(x) for x in numbers if math.isfinite(x))])
    return "(" + ", ".join(f"{0 if abs(x) < least else x:.4g}" for x in numbers) + ")"
