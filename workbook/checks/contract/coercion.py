"""Read an answer as the type that was asked, generously in form and strictly in kind.

Ints for floats, lists for arrays, `(n, 1)` for `(n,)`, NumPy scalars, CasADi DM and SymPy numbers
are all fine, and symbols match by name, whatever their assumptions. What cannot be read raises
`Invalid` with a kind sentence.
"""

import numpy as np
import sympy as sp
from sympy.core.function import AppliedUndef

from workbook.checks.contract.answer_forms import (
    counted,
    has_logical_cases,
    kind_of,
    unwrapped,
    vector_entries,
)
from workbook.checks.contract.magnitude import SYMBOL_BITS, grows_too_fast
from workbook.checks.contract.verdict import Invalid

YES = {True, "yes", "true", "y"}
NO = {False, "no", "false", "n"}
#: Numbers from here on count as infinite: where a tolerance grows with the answer, the square of
#: one would make it so.
LARGEST = 1e50
#: How many terms of a sum are added up, and how often an expression is differentiated.
MOST_ADDED, MOST_DERIVED = 1000, 6
#: SymPy asks of any two terms of a Max which one is greater, and of each case whether it is one of
#: those before.
MOST_COMPARED, MOST_CASES = 6, 100


def as_expression(answer, symbols=()):
    """Return an answer as a SymPy expression.

    Parameters
    ----------
    answer : object
        A number of any kind, an expression, an `sp.Poly`, or an `sp.Lambda` of the symbols.
    symbols : list of sympy.Symbol
        The data's own symbols, which replace those of the answer with the same names.

    Returns
    -------
    sympy.Expr

    Raises
    ------
    Invalid
        If it is of another kind, has an undefined value, or contains other symbols.
    """
    answer = unwrapped(answer)
    if isinstance(answer, (bool, np.bool_, str)) or answer is None:
        raise Invalid(f"expected an expression, got {kind_of(answer)}")
    if isinstance(answer, (int, float, complex, np.number)):
        answer = sp.sympify(answer.item() if isinstance(answer, np.number) else answer)
    if isinstance(answer, sp.Poly):
        answer = answer.as_expr()
    if isinstance(answer, sp.Eq):
        raise Invalid("expected an expression, got an equation: of `x = 2*y` give `2*y` alone")
    if not isinstance(answer, sp.Expr):
        raise Invalid(f"expected an expression, got {kind_of(answer)}")
    if isinstance(answer, sp.Lambda):
        answer = _applied(answer, symbols)
    if answer.has(sp.Lambda):
        raise Invalid(
            "expected an expression, got one with a function in it: write its value, `x**2` "
            "and not `Lambda(x, x**2)`"
        )
    if has_logical_cases(answer):
        raise Invalid("expected an expression, got one with cases that are True or False")
    if answer.has(sp.sinc):
        answer = answer.replace(
            sp.sinc, lambda x: sp.Piecewise((sp.sin(x) / x, sp.Ne(x, 0)), (1, True))
        )
    if answer.has(sp.nan):
        answer = answer.replace(_ends_undefined, lambda cases: sp.Piecewise(*cases.args[:-1]))
    if answer.has(sp.nan, sp.zoo):
        raise Invalid("the expression contains an undefined value (nan or a division by zero)")
    return with_symbols(answer, symbols)


def _ends_undefined(part):
    """Return whether the last case is nan, as SymPy writes it where none is given."""
    return isinstance(part, sp.Piecewise) and len(part.args) > 1 and part.args[-1] == (sp.nan, True)


def _applied(function, symbols):
    """Return the value of a `Lambda` at the symbols of its names, or else the first ones."""
    by_name = {symbol.name: symbol for symbol in symbols}
    variables = function.signature
    if not all(isinstance(variable, sp.Symbol) for variable in variables) or len(variables) > len(
        symbols
    ):
        raise Invalid(
            f"expected an expression, or `sp.Lambda` of {', '.join(by_name)}"
            if by_name
            else "expected a number, got an `sp.Lambda`"
        )
    named = all(variable.name in by_name for variable in variables)
    at = [by_name[v.name] for v in variables] if named else list(symbols)[: len(variables)]
    value = function.expr.xreplace(dict(zip(variables, at)))
    if not isinstance(value, sp.Expr) or isinstance(value, sp.MatrixBase):
        raise Invalid("expected an expression, or `sp.Lambda` with one as its value")
    return value


def with_symbols(answer, symbols):
    """Return a SymPy object with its symbols replaced by the data's symbols of the same names.

    Raises
    ------
    Invalid
        If it contains other symbols or functions, or what is too large to be computed with.
    """
    by_name = {symbol.name: symbol for symbol in symbols}
    limited = answer.atoms(  # in one traversal of what may be a large expression
        AppliedUndef, sp.Integral, sp.Sum, sp.Derivative, sp.Max, sp.Min, sp.Piecewise
    )

    def parts(*kinds):
        return (part for part in limited if isinstance(part, kinds))

    functions = {str(f.func) for f in parts(AppliedUndef)}
    foreign = sorted({s.name for s in answer.free_symbols if s.name not in by_name} | functions)
    if foreign:
        raise Invalid(
            f"the answer contains {', '.join(foreign)}; expected only "
            + (", ".join(sorted(by_name)) if by_name else "numbers")
        )
    if any(len(limits) < 3 for integral in parts(sp.Integral) for limits in integral.limits):
        raise Invalid(
            "the answer contains an integral without limits, which has no value at a point; work "
            "it out"
        )
    if any(
        last - first > MOST_ADDED
        for part in parts(sp.Sum)
        for _, first, last in part.limits
        if first.is_Integer and last.is_Integer
    ):
        raise Invalid(
            f"the answer contains a sum of more than {MOST_ADDED} terms; write it without `sp.Sum`"
        )
    if any(
        sum(order for _, order in part.variable_count if order.is_Integer) > MOST_DERIVED
        for part in parts(sp.Derivative)
    ):
        raise Invalid(
            "the answer contains a derivative that is still to be worked out, of an order beyond "
            f"{MOST_DERIVED}; work it out"
        )
    if any(len(part.args) > MOST_COMPARED for part in parts(sp.Max, sp.Min)):
        raise Invalid(
            f"the answer contains the greatest or the least of more than {MOST_COMPARED} terms; "
            "give a simpler form of it"
        )
    if sum(len(part.args) for part in parts(sp.Piecewise)) > MOST_CASES:
        raise Invalid(
            f"the answer distinguishes more than {MOST_CASES} cases; give a simpler form of it"
        )
    if grows_too_fast(answer):
        raise Invalid(
            "the answer grows too fast to be computed with: an exponent, an angle or the argument "
            f"of a factorial is too large already where the symbols are {2**SYMBOL_BITS}"
        )
    return answer.xreplace({s: by_name[s.name] for s in answer.free_symbols})


def as_number(answer):
    """Return a real number, exact if the answer is: an expression without symbols."""
    value = as_expression(answer)
    try:
        number = complex(value.evalf(30))
    except TypeError:
        raise Invalid("expected a single real number") from None
    if value.is_finite and abs(number) >= LARGEST:
        raise Invalid(f"expected a number below {LARGEST:g}")
    if not abs(number) < LARGEST or abs(number.imag) > 1e-12 * (1 + abs(number.real)):
        raise Invalid("expected a finite real number")
    return sp.re(value) if value.is_real is not True else value


def as_integer(answer):
    """Return a whole number: `3`, `3.0` and `Integer(3)` are the same."""
    value = as_number(answer)
    nearest = int(sp.floor(value + sp.Rational(1, 2)))
    # a difference, since SymPy holds Float(3) and Integer(3) for two numbers
    if value - nearest != 0:
        raise Invalid(f"expected a whole number, got {sp.N(value, 6)}")
    return nearest


def as_expressions(answer, symbols=(), length=None):
    """Return a list of expressions from a list, tuple, array, row or column.

    Parameters
    ----------
    answer : object
        The components of a vector in any of the usual forms.
    symbols : list of sympy.Symbol
        The data's own symbols.
    length : int, optional
        The number of components that is expected.

    Returns
    -------
    list of sympy.Expr
    """
    entries = vector_entries(answer)
    if entries is None:
        raise Invalid(f"expected a list of {counted(length, 'expression')}, got {kind_of(answer)}")
    if length is not None and len(entries) != length:
        raise Invalid(f"expected {counted(length, 'component')}, got {len(entries)}")
    return [as_expression(entry, symbols) for entry in entries]


def as_matrix(answer, symbols=(), shape=None, *other_shapes):
    """Return a SymPy matrix from a Matrix, nested lists, an array or a DM; a vector is a column.

    Parameters
    ----------
    answer : object
        The matrix in any of these forms.
    symbols : list of sympy.Symbol
        The data's own symbols.
    shape : tuple of int, optional
        The shape that is expected.
    *other_shapes : tuple of int
        Shapes that are accepted, too.

    Returns
    -------
    sympy.ImmutableMatrix
    """
    answer, shapes = unwrapped(answer), [shape, *other_shapes]
    if isinstance(answer, (list, tuple)):
        rows = [vector_entries(row) for row in answer]
        if any(row is None for row in rows):
            rows = [[entry] for entry in answer]
        if len({len(row) for row in rows}) > 1:
            raise Invalid("the rows of the matrix have different lengths")
        _require_shape((len(rows), len(rows[0]) if rows else 0), shapes)
        answer = sp.Matrix([[as_expression(entry, symbols) for entry in row] for row in rows])
    elif isinstance(answer, np.ndarray):
        if answer.ndim > 2:
            raise Invalid(f"expected a matrix, got an array with {answer.ndim} axes")
        _require_shape((*answer.shape, 1)[:2], shapes)
        answer = sp.Matrix(answer.tolist())
    if not isinstance(answer, sp.MatrixBase):
        raise Invalid(f"expected a matrix, got {kind_of(answer)}")
    _require_shape(answer.shape, shapes)
    return answer.applyfunc(lambda entry: as_expression(entry, symbols)).as_immutable()


def _require_shape(shape, expected):
    """Refuse a matrix of another shape, before its entries are read, which may be thousands."""
    if expected != [None] and shape not in map(tuple, expected):
        raise Invalid(f"expected {_shaped(tuple(expected[0]))}, got {_shaped(shape)}")


def _shaped(shape):
    return "a single expression" if shape == (1, 1) else f"a matrix of shape {shape}"


def as_choice(answer, choices):
    """Return one of the words offered, in any case and with spaces, hyphens or underscores."""
    if not isinstance(answer, str):
        raise Invalid(
            f"expected one of the words {', '.join(map(repr, choices))}, got {kind_of(answer)}"
        )
    words = {_plain(choice): choice for choice in choices}
    if _plain(answer) not in words:
        raise Invalid(f"expected one of the words {', '.join(map(repr, choices))}")
    return words[_plain(answer)]


def as_yes_no(answer):
    """Return True or False from a bool or one of the words yes, no."""
    if isinstance(answer, sp.logic.boolalg.BooleanAtom):
        answer = bool(answer)
    if isinstance(answer, np.bool_):
        answer = bool(answer)
    word = answer.strip().lower() if isinstance(answer, str) else answer
    if isinstance(word, (bool, str)) and word in YES | NO:
        return word in YES
    raise Invalid(
        "expected yes or no (True or False)"
        + ("" if isinstance(answer, str) else f", got {kind_of(answer)}")
    )


def _plain(word):
    return " ".join(word.lower().replace("-", " ").replace("_", " ").split())
