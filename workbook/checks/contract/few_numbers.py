"""At most four numbers in a message: a point of many coordinates is shortened.

A counterexample names the values of all symbols, `for h = 1, v = 2, m = 3, g = 4, k = 5`, of which
a reader looks first for those in his own answer. Checks write the whole list; `judged` shortens it.
"""

import re

MOST_NUMBERS = 4
NUMBER = r"-?\d+\.?\d*(?:e[+-]?\d+)?(?:/\d+)?(?:i\b)?"
COMPLEX = rf"{NUMBER}(?: (?:[+-]|\+/-) [\d.]+(?:e[+-]?\d+)?i\b)?"
#: Numbers of a text, but for digits of names and exponents.
FREE_NUMBER = re.compile(rf"(?<![\w.^]){COMPLEX}(?![\w'])")
#: Code, indices and zeros, which are no numbers to keep in mind.
UNCOUNTED = re.compile(
    r"`[^`]*`|\b(?:change|column|combination|component|direction|entry|entries|measurement|order|row|side|"
    r"vector) (?:\d+|\(\d+, \d+\))|(?<![\w.])-?0(?![\w.])"
)
VALUE = re.compile(rf"\w+'* = {COMPLEX}(?![\w/^])")
#: Values of several symbols, and coordinates of which there are three or more.
POINT = re.compile(
    rf"{VALUE.pattern}(?:, {VALUE.pattern})+|(?<=\(){COMPLEX}(?:, {COMPLEX}){{2,}}(?=\))"
)


def numbers_in(text):
    """Return the numbers that a reader of a text has to keep in mind.

    Examples
    --------
    >>> numbers_in("for k1 = 2/3, k2 = 1e-05 the roots of x^2 + k1 = 0 are 1 + 2i and `sp.Eq(x, 3)`")
    ['2/3', '1e-05', '1 + 2i']
    """
    return FREE_NUMBER.findall(UNCOUNTED.sub("", text))


def with_few_numbers(message, answer):
    """Return a message whose points show fewer values, so that it holds at most four numbers.

    Parameters
    ----------
    message : str
        The message on an answer.
    answer : object
        The answer; values of the symbols in it are kept before others.

    Returns
    -------
    str
        The message; each point keeps at least one value.

    Examples
    --------
    >>> from sympy.abc import b, d
    >>> with_few_numbers("for a = 1, b = 2, c = 3, d = 4 your H is 5", b + d)
    'for a = 1, b = 2, d = 4, ... your H is 5'
    """
    points = POINT.findall(message)
    if not points or len(numbers_in(message)) <= MOST_NUMBERS:
        return message
    count_outside = len(numbers_in(POINT.sub("", message)))
    share = max((MOST_NUMBERS - count_outside) // len(points), 1)
    names = _symbol_names(answer)
    return POINT.sub(lambda point: _shortened(point[0].split(", "), names, share), message)


def _symbol_names(answer):
    if isinstance(answer, dict):
        answer = [*answer, *answer.values()]
    if isinstance(answer, (list, tuple, set, frozenset)):
        return set().union(*map(_symbol_names, answer))
    return {symbol.name for symbol in getattr(answer, "free_symbols", ())}


def _shortened(values, names, share):
    by_use = sorted(values, key=lambda value: value.partition(" ")[0] not in names)
    shown = [value for value in values if value in by_use[:share]]
    return ", ".join(shown if len(shown) == len(values) else [*shown, "..."])
