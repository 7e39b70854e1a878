"""Hints on the first day's mistakes, where Python alone shows a bare error.

`k1 > 0 and k2 > 0` raises SymPy's TypeError, `cos(x)` a NameError, `4t` a SyntaxError: `hint_for`
returns what to write instead.
"""

import re

CONDITIONS = """\
Join conditions of SymPy with & (and), | (or), ~ (not), each in brackets of
its own: (k1 > 0) & (k2 < k1); or write sp.And(...), sp.Or(...), sp.Not(...).
A chain such as 0 < k2 < k1 is sp.And(0 < k2, k2 < k1); cases, between which
no `if` can choose, are sp.Piecewise((k1, k2 < 0), (k2, True))."""
POWERS = "A power is x**2: in Python x^2 is another operation, on whole numbers."
FUNCTIONS = "Functions of symbols are SymPy's: sp.sqrt(x), not np.sqrt(x) or math.sqrt(x)."
PRODUCTS = "A product needs its sign: write 4*t, not 4t, and 2*(x + 1), not 2(x + 1)."
DATA_FIRST = "The data cell sets this name: run it first, and again after a restart."
PREFIX_ITSELF = "The notebook imports SymPy as sp: write sp.cos(x), not sympy.cos(x)."
PREFIX = "Write sp.{}: the notebook imports SymPy as sp, so its names begin with sp."
#: What the text of an error begins with, and what to write instead.
HINTS = {
    "cannot determine truth value of Relational": CONDITIONS,
    r"unsupported operand type\(s\) for [&|]: ": CONDITIONS,
    r"unsupported operand type\(s\) for \^: ": POWERS,
    "loop of ufunc does not support argument ": FUNCTIONS,
    "Cannot convert expression to float": FUNCTIONS,
    "name '(np|numpy|math)' is not defined": FUNCTIONS,
    "name 'sympy' is not defined": PREFIX_ITSELF,
    "name '(sp|checks)' is not defined": DATA_FIRST,
    "invalid decimal literal": PRODUCTS,
    r"'(int|float|Symbol|Add|Mul|Pow|Integer|Rational)' object is not callable": PRODUCTS,
}
SYMPY_NAMES = """\
sin cos tan cot asin acos atan atan2 acot sinh cosh tanh coth asinh acosh atanh exp log ln sqrt cbrt
sign Abs Min Max Heaviside pi oo I E Rational Symbol symbols Function Matrix eye zeros ones diag Eq
Ne And Or Not Piecewise diff integrate solve simplify expand factor limit re im Interval FiniteSet"""
#: What a student may write for a name of SymPy.
ALIASES = {
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctan2": "atan2",
    "arcsinh": "asinh",
    "arccosh": "acosh",
    "arctanh": "atanh",
    "tg": "tan",
    "ctg": "cot",
    "sgn": "sign",
    "inf": "oo",
}
UNKNOWN_NAME = re.compile(r"name '(\w+)' is not defined|module 'sympy' has no attribute '(\w+)'")


def hint_for(text):
    """Return what to write instead of code that raised this error, or None without a hint.

    Parameters
    ----------
    text : str
        The text of the error.

    Returns
    -------
    str or None

    Examples
    --------
    >>> hint_for("unsupported operand type(s) for &: 'int' and 'Symbol'")[:29]
    'Join conditions of SymPy with'
    >>> hint_for("name 'arctan' is not defined")[:13]
    'Write sp.atan'
    >>> hint_for("'list' object is not callable")
    """
    if unknown := UNKNOWN_NAME.match(text):
        name = unknown[1] or unknown[2]
        name = ALIASES.get(name, name)
        if name in SYMPY_NAMES.split():
            return PREFIX.format(name)
    return next((hint for pattern, hint in HINTS.items() if re.match(pattern, text)), None)
