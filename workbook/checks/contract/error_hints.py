"""Hints on the first day's mistakes, where Python alone shows a bare error.

`k1 > 0 and k2 > 0` raises SymPy's TypeError, `cos(x)` a NameError, `4t` a SyntaxError: `hint_for`
returns what to write instead.
"""

import re

from workbook.checks.contract.typed_code import (
    alphabet,
    compared_name,
    foreign_letters,
    similar_name,
    skeleton,
)

CONDITIONS = """\
Join conditions of SymPy with & (and), | (or), ~ (not), each in brackets of
its own: (p < 7) & (q < p); or write sp.And(...), sp.Or(...), sp.Not(...).
A chain such as 5 < q < p is sp.And(5 < q, q < p); cases, between which
no `if` can choose, are sp.Piecewise((p, q < 5), (q, True))."""
POWERS = "A power is x**2: in Python x^2 is another operation, on whole numbers."
FUNCTIONS = "Functions of symbols are SymPy's: sp.sqrt(x), not np.sqrt(x) or math.sqrt(x)."
NUMPY = (
    FUNCTIONS
    + """
A vector is a list, [1, x], and a matrix a list of rows or sp.Matrix([[1, x], [0, 1]])."""
)
PRODUCTS = "A product needs its sign: write 4*t, not 4t, and 2*(x + 1), not 2(x + 1)."
DATA_FIRST = "The data cell sets this name: run it first, and again after a restart."
PREFIX_ITSELF = "The notebook imports SymPy as sp: write sp.cos(x), not sympy.cos(x)."
PREFIX = "Write sp.{}: the notebook imports SymPy as sp, so its names begin with sp."
OWN_CHECK = """\
It is a check of the course's own, which judges where its checks.py is: in the
folder of the course, and when the homework is graded."""
#: What the text of an error begins with, and what to write instead.
HINTS = {
    "cannot determine truth value of Relational": CONDITIONS,
    r"unsupported operand type\(s\) for [&|]: ": CONDITIONS,
    r"unsupported operand type\(s\) for \^: ": POWERS,
    "loop of ufunc does not support argument ": FUNCTIONS,
    "Cannot convert expression to float": FUNCTIONS,
    "name '(np|numpy)' is not defined": NUMPY,
    "name 'math' is not defined": FUNCTIONS,
    "name 'sympy' is not defined": PREFIX_ITSELF,
    "name '(sp|checks)' is not defined": DATA_FIRST,
    r"there is no check \w+ here": OWN_CHECK,
    "invalid decimal literal": PRODUCTS,
    "invalid character '[∧∨¬]'": CONDITIONS,
    "invalid character '≠'": "Python compares with sp.Ne(x, 7); for symbols x != 7 is True at once.",
    "invalid character '[²³⁰-⁹]'": "A power is x**2, that of a function sp.sin(x)**2.",
    "invalid character '√'": "Write the root with its brackets: sp.sqrt(x**2 + 1).",
    r"unexpected character after line continuation": "A formula is written in Python here, not in LaTeX.",
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
UNKNOWN_NAME = re.compile(r"name '([\w·]+)' is not defined|module 'sympy' has no attribute '(\w+)'")
#: What else a name that Python does not know may stand for.
OTHER_NAMES = {
    "π": "Write sp.pi.",
    "true": "Write True.",
    "false": "Write False.",
    "yes": 'Write True, or "yes" in quotation marks.',
    "no": 'Write False, or "no" in quotation marks.',
}
PRODUCT_DOT = "Python reads {} as one name: a product is written with *, {}."
LOOKALIKE = "`{}` in `{}` is a {} letter: type {} with the Latin alphabet."
DID_YOU_MEAN = "Did you mean {}?"
#: Shorter names are rather those of symbols.
SHORTEST_WORD = 4
ASSIGNMENT = "An assignment has one sign =, a comparison two: {} = ..."
WORD = 'If a word is your answer, it stands in quotation marks: "{}".'


def hint_for(text, source="", names=()):
    """Return what to write instead of code that raised this error, or None without a hint.

    Parameters
    ----------
    text : str
        The text of the error.
    source : str, optional
        The cell.
    names : iterable of str, optional
        The names that are defined.

    Returns
    -------
    str or None

    Examples
    --------
    >>> hint_for("unsupported operand type(s) for &: 'int' and 'Symbol'")[:29]
    'Join conditions of SymPy with'
    >>> hint_for("name 'arctan' is not defined")[:13]
    'Write sp.atan'
    >>> hint_for("name 'к1' is not defined", names=["k1", "k2"])
    '`к` in `к1` is a Cyrillic letter: type k1 with the Latin alphabet.'
    >>> hint_for("name 'k_1' is not defined", names=["k1", "k2"])
    'Did you mean k1?'
    >>> hint_for("'list' object is not callable")
    """
    unknown = UNKNOWN_NAME.match(text)
    if unknown:
        name = unknown[1] or unknown[2]
        name = ALIASES.get(name, name)
        if name in SYMPY_NAMES.split():
            return PREFIX.format(name)
    hint = next((hint for pattern, hint in HINTS.items() if re.match(pattern, text)), None)
    return hint or (_other_name(unknown[1] or unknown[2], source, names) if unknown else None)


def _other_name(name, source, names):
    """Return what to write instead of a name that is not defined."""
    if name in OTHER_NAMES:
        return OTHER_NAMES[name]
    if compared_name(source) == name:
        return ASSIGNMENT.format(name)
    if "·" in name:
        return PRODUCT_DOT.format(name, name.replace("·", "*"))
    if foreign := foreign_letters(name):
        return LOOKALIKE.format(foreign, name, alphabet(foreign[0]), skeleton(name))
    if similar := similar_name(name, [known for known in names if not known.startswith("_")]):
        return DID_YOU_MEAN.format(similar)
    return WORD.format(name) if name.isalpha() and len(name) >= SHORTEST_WORD else None
