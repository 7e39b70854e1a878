"""Symbols as real numbers: stand-ins for undeclared symbols, and a test whether a formula is zero.

Symbols stand for real numbers throughout the library. A symbol declared without assumptions is
replaced by a real one of the same name while an answer is computed (`as_real`), and put back at the
end, so that students need not write `real=True` to get a correct answer.
"""

import re

import sympy as sp


def as_real(*expressions):
    """Return two dicts: from symbols not known to be real to real stand-ins, and back."""
    unknown = {s for e in expressions for s in e.free_symbols if s.is_real is None}
    to_real = {s: sp.Dummy(s.name, real=True) for s in sorted(unknown, key=lambda s: s.name)}
    return to_real, {new: old for old, new in to_real.items()}


def restore_names(text, from_real):
    """Return a message with the names of the user's symbols for the stand-ins of `as_real`."""
    for stand_in, symbol in from_real.items():
        text = re.sub(rf"(?<!\w){re.escape(str(stand_in))}(?!\w)", lambda _: str(symbol), text)
    return text


def vanishes(expression):
    """Whether an expression is zero for all values of its symbols.

    A number with radicals or roots of polynomials counts as zero if its first 30 digits are: exact
    methods take minutes.
    """
    if expression == 0:
        return True
    if expression.has(sp.nan, sp.zoo, sp.oo):
        return False
    if expression.free_symbols:
        return sp.simplify(expression.xreplace(as_real(expression)[0])) == 0
    digits = {root: root.evalf(50) for root in expression.atoms(sp.CRootOf)}
    return bool(abs(expression.xreplace(digits).evalf(40, maxn=50)) < sp.Float("1e-30"))


def sign_of_number(value):
    """Return -1, 0 or 1 for a number; one that is not rational is zero if 200 digits are."""
    value = sp.sympify(value)
    if not value.is_Rational:
        value = sp.N(value, 30, maxn=400)
        if abs(value) < sp.Float("1e-200"):
            return 0
    return int(sp.sign(value))
