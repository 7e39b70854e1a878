"""Reading what the user writes: a vector field with its state, symbols, points.

Symbols stand for real numbers throughout the package. A symbol declared without assumptions is
replaced by a real one of the same name while an answer is computed (`as_real`), and put back at the
end, so that students need not write `real=True` to get a correct answer.
"""

import re
from collections.abc import Iterable, Mapping

import sympy as sp


def read_symbols(symbols, name):
    """Return `symbols` as a tuple of distinct SymPy symbols; one symbol alone is allowed."""
    if isinstance(symbols, sp.Symbol):
        symbols = (symbols,)
    if isinstance(symbols, str) or not isinstance(symbols, Iterable):
        raise TypeError(f"{name}: expected SymPy symbols, got {symbols!r}")
    symbols = tuple(symbols)
    strangers = [s for s in symbols if not isinstance(s, sp.Symbol)]
    if strangers:
        raise TypeError(f"{name}: expected SymPy symbols, got {strangers[0]!r}")
    if len(set(symbols)) < len(symbols):
        raise ValueError(f"{name}: the same symbol stands twice in {list(symbols)}")
    return symbols


def read_expression(expression, name):
    """Return `expression` as a SymPy expression; text is refused, since parsing it would evaluate
    it."""
    if isinstance(expression, str):
        raise TypeError(f"{name}: expected a SymPy expression, got the text {expression!r}")
    try:
        result = sp.sympify(expression)
    except (sp.SympifyError, TypeError, AttributeError):
        raise TypeError(f"{name}: expected a SymPy expression, got {expression!r}") from None
    if not isinstance(result, sp.Expr):
        raise TypeError(f"{name}: expected a SymPy expression, got {expression!r}")
    if result.has(sp.nan, sp.zoo):
        raise ValueError(f"{name}: {result} is not defined")
    return result


def read_vector(values, length, name):
    """Return `values` (list, tuple, one-column matrix or array) as a tuple of `length` SymPy
    expressions."""
    # A SymPy matrix is a sequence of its entries, but does not call itself iterable.
    if isinstance(values, (str, Mapping)) or not isinstance(values, (Iterable, sp.MatrixBase)):
        raise TypeError(f"{name}: expected a list of {length} expressions, got {values!r}")
    shape = getattr(values, "shape", None)
    if shape is not None and len(shape) == 2 and 1 not in shape:
        raise ValueError(
            f"{name}: expected a vector of length {length}, got a matrix of shape {tuple(shape)}"
        )
    flat = values.ravel() if hasattr(values, "ravel") else values
    result = tuple(read_expression(value, name) for value in flat)
    if len(result) != length:
        raise ValueError(
            f"{name}: expected {length} components, one for each state variable, got {len(result)}"
        )
    return result


def read_field(field, state):
    """Return the right-hand sides and the state variables of x' = f(x), checked against one
    another."""
    state = read_symbols(state, "state")
    if not state:
        raise ValueError("state: expected at least one state variable")
    return read_vector(field, len(state), "field"), state


def as_real(*expressions):
    """Two dictionaries: symbols that are not known to be real to real ones of the same name, and
    back."""
    unknown = {s for e in expressions for s in e.free_symbols if s.is_real is None}
    there = {s: sp.Dummy(s.name, real=True) for s in sorted(unknown, key=lambda s: s.name)}
    return there, {new: old for old, new in there.items()}


def with_names(text, back):
    """A message in which the stand-ins of `as_real` have the names of the user's symbols again."""
    for stand_in, symbol in back.items():
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


def exact_decimals(expression):
    """Read each decimal in an expression as the number that was written: 0.1 becomes 1/10."""
    if not expression.has(sp.Float):
        return expression
    return expression.xreplace({f: sp.Rational(str(f)) for f in expression.atoms(sp.Float)})


def as_prose(text):
    """Words for a notebook's Markdown: x1*x2 keeps its star."""
    return text.replace("*", r"\*").replace("_", r"\_")
