"""Read an answer as the type that was asked, generously in form and strictly in kind.

Ints for floats, lists for arrays, `(n, 1)` for `(n,)`, NumPy scalars, CasADi DM and SymPy numbers
are all fine, and symbols match by name, whatever their assumptions. What cannot be read raises
`Invalid` with a kind sentence.
"""

import sys

import numpy as np
import sympy as sp

from workbook.checks.contract.magnitude import SYMBOL_BITS, grows_too_fast
from workbook.checks.contract.verdict import Invalid, remark

YES = {True, "yes", "true", "y"}
NO = {False, "no", "false", "n"}
#: Numbers from here on count as infinite: where a tolerance grows with the answer, the square of
#: one would make it so.
LARGEST = 1e50
#: What a condition looks like, and no condition that any problem has for its answer.
EXAMPLE_OF_CONDITION = "such as `x + 77 < y` or `sp.And(x + 77 < y, y < 99)`"
#: How many terms of a sum are added up, and how often an expression is differentiated.
MOST_ADDED, MOST_DERIVED = 1000, 6
#: Conditions are tried far out, at numbers of so many bits, and their powers are written out.
FAR_BITS, LARGEST_POWER = 20, 200
#: SymPy asks of any two terms of a Max which one is greater, and of each case whether it is one of
#: those before.
MOST_COMPARED, MOST_CASES = 6, 100
#: No answer has nearly as many relations; to work with more takes a time that grows faster than
#: their number.
MOST_WRITTEN_OUT = 200
#: What an answer is called that is of another kind than asked; the first that fits.
KINDS = (
    ((bool, np.bool_), "a truth value"),
    (str, "a text: leave its quotation marks out"),
    ((int, float, complex, np.number), "a number"),
    (sp.MatrixBase, "a matrix"),
    (np.ndarray, "an array"),
    (sp.Lambda, "an `sp.Lambda`"),
    (sp.Expr, "an expression"),
    (sp.logic.boolalg.Boolean, "a condition"),
    ((sp.Set, set, frozenset), "a set"),
    ((list, tuple, sp.Tuple), "a list"),
    (dict, "a dict"),
)
#: They have no values at points, or none that the checks can compute.
NOT_IN_CONDITIONS = (
    sp.DiracDelta,
    sp.gamma,
    sp.factorial,
    sp.binomial,
    sp.Lambda,
    sp.Sum,
    sp.Derivative,
)


def as_expression(answer, symbols=()):
    """A SymPy expression in the given symbols (the data's own, matched by name); other symbols are
    refused."""
    answer = _unwrapped(answer)
    if isinstance(answer, (bool, np.bool_, str)) or answer is None:
        raise Invalid(f"expected an expression, got {_named(answer)}")
    if isinstance(answer, (int, float, complex, np.number)):
        answer = sp.sympify(answer.item() if isinstance(answer, np.number) else answer)
    if isinstance(answer, sp.Eq):
        raise Invalid("expected an expression, got an equation: of `x = 2*y` give `2*y` alone")
    if not isinstance(answer, sp.Expr):
        raise Invalid(f"expected an expression, got {_named(answer)}")
    if isinstance(answer, sp.Lambda):
        answer = _applied(answer, symbols)
    if answer.has(sp.Lambda):
        raise Invalid(
            "expected an expression, got one with a function in it: write its value, `x**2` "
            "and not `Lambda(x, x**2)`"
        )
    if _has_logical_cases(answer):
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
    """Whether the last case is nan, as SymPy writes it where none is given."""
    return isinstance(part, sp.Piecewise) and len(part.args) > 1 and part.args[-1] == (sp.nan, True)


def _applied(function, symbols):
    """The value of a `Lambda` at the symbols: those of the names of its variables, or else the
    first ones in order."""
    known = {symbol.name: symbol for symbol in symbols}
    variables = function.signature
    if not all(isinstance(variable, sp.Symbol) for variable in variables) or len(variables) > len(
        symbols
    ):
        raise Invalid(
            f"expected an expression, or `sp.Lambda` of {', '.join(known)}"
            if known
            else "expected a number, got an `sp.Lambda`"
        )
    named = all(variable.name in known for variable in variables)
    at = [known[v.name] for v in variables] if named else list(symbols)[: len(variables)]
    value = function.expr.xreplace(dict(zip(variables, at)))
    if not isinstance(value, sp.Expr) or isinstance(value, sp.MatrixBase):
        raise Invalid("expected an expression, or `sp.Lambda` with one as its value")
    return value


def _has_logical_cases(answer):
    return any(
        _is_logical(pair.expr)
        for piecewise in answer.atoms(sp.Piecewise)
        for pair in piecewise.args
    )


def _is_logical(part):
    # a symbol is both
    return isinstance(part, sp.logic.boolalg.Boolean) and not isinstance(part, sp.Expr)


def with_symbols(answer, symbols):
    """The same SymPy object with its symbols replaced by the data's symbols of the same name."""
    known = {symbol.name: symbol for symbol in symbols}
    functions = {str(f.func) for f in answer.atoms(sp.core.function.AppliedUndef)}
    foreign = sorted({s.name for s in answer.free_symbols if s.name not in known} | functions)
    if foreign:
        raise Invalid(
            f"the answer contains {', '.join(foreign)}; expected only "
            + (", ".join(sorted(known)) if known else "numbers")
        )
    if any(len(limits) < 3 for integral in answer.atoms(sp.Integral) for limits in integral.limits):
        raise Invalid(
            "the answer contains an integral without limits, which has no value at a point; work "
            "it out"
        )
    if any(
        last - first > MOST_ADDED
        for part in answer.atoms(sp.Sum)
        for _, first, last in part.limits
        if first.is_Integer and last.is_Integer
    ):
        raise Invalid(
            f"the answer contains a sum of more than {MOST_ADDED} terms; write it without `sp.Sum`"
        )
    if any(
        sum(order for _, order in part.variable_count if order.is_Integer) > MOST_DERIVED
        for part in answer.atoms(sp.Derivative)
    ):
        raise Invalid(
            "the answer contains a derivative that is still to be worked out, of an order beyond "
            f"{MOST_DERIVED}; work it out"
        )
    if any(len(part.args) > MOST_COMPARED for part in answer.atoms(sp.Max, sp.Min)):
        raise Invalid(
            f"the answer contains the greatest or the least of more than {MOST_COMPARED} terms; "
            "give a simpler form of it"
        )
    if sum(len(part.args) for part in answer.atoms(sp.Piecewise)) > MOST_CASES:
        raise Invalid(
            f"the answer distinguishes more than {MOST_CASES} cases; give a simpler form of it"
        )
    if grows_too_fast(answer):
        raise Invalid(
            "the answer grows too fast to be computed with: an exponent, an angle or the argument "
            f"of a factorial is too large already where the symbols are {2**SYMBOL_BITS}"
        )
    return answer.xreplace({s: known[s.name] for s in answer.free_symbols})


def as_number(answer):
    """A real number, exact where the answer is (an `Expr` without symbols)."""
    value = as_expression(answer)
    try:
        number = complex(value.evalf(30))
    except TypeError:
        raise Invalid("expected a single real number") from None
    if not abs(number) < LARGEST or abs(number.imag) > 1e-12 * (1 + abs(number.real)):
        raise Invalid("expected a finite real number")
    return sp.re(value) if value.is_real is not True else value


def as_integer(answer):
    """A whole number: `3`, `3.0` and `Integer(3)` are the same."""
    value = as_number(answer)
    whole = int(sp.floor(value + sp.Rational(1, 2)))
    # a difference, since SymPy holds Float(3) and Integer(3) for two numbers
    if value - whole != 0:
        raise Invalid(f"expected a whole number, got {sp.N(value, 6)}")
    return whole


def as_expressions(answer, symbols=(), length=None):
    """A list of expressions from a list, tuple, array, row or column."""
    entries = _entries(answer)
    if entries is None:
        raise Invalid(f"expected a list of {_count(length, 'expression')}, got {_named(answer)}")
    if length is not None and len(entries) != length:
        raise Invalid(f"expected {_count(length, 'component')}, got {len(entries)}")
    return [as_expression(entry, symbols) for entry in entries]


def as_points(answer, dimension):
    """A list of points: lists, tuples, arrays, SymPy columns, a FiniteSet, or dicts like those of
    `solve`."""
    if isinstance(answer, sp.MatrixBase) and answer.cols == dimension != 1:
        answer = [list(answer.row(i)) for i in range(answer.rows)]
    elif isinstance(answer, sp.MatrixBase) and answer.shape == (dimension, 1):
        answer = [list(answer)]
    points = (
        list(answer)
        if isinstance(answer, (list, tuple, set, frozenset, sp.FiniteSet, sp.Tuple, np.ndarray))
        else None
    )
    if answer is sp.S.EmptySet:
        points = []
    if points is None:
        raise Invalid(
            f"expected a list of points with {_count(dimension, 'coordinate')} each, got "
            f"{_named(answer)}"
        )
    if (
        points
        and dimension > 1
        and all(_entries(point) is None for point in points)
        and len(points) == dimension
    ):
        points = [points]  # a single point, written without the outer list
    return [
        [as_number(value) for value in as_expressions(point, (), dimension)] for point in points
    ]


def as_matrix(answer, symbols=(), shape=None):
    """A SymPy matrix from a Matrix, nested lists, an array or a DM; a vector counts as a column."""
    answer = _unwrapped(answer)
    if isinstance(answer, (list, tuple)):
        rows = [_entries(row) for row in answer]
        if any(row is None for row in rows):
            rows = [[entry] for entry in answer]
        if len({len(row) for row in rows}) > 1:
            raise Invalid("the rows of the matrix have different lengths")
        answer = sp.Matrix([[as_expression(entry, symbols) for entry in row] for row in rows])
    elif isinstance(answer, np.ndarray):
        if answer.ndim > 2:
            raise Invalid(f"expected a matrix, got an array with {answer.ndim} axes")
        answer = sp.Matrix(answer.tolist())
    if not isinstance(answer, sp.MatrixBase):
        raise Invalid(f"expected a matrix, got {_named(answer)}")
    if shape is not None and answer.shape != tuple(shape):
        raise Invalid(f"expected {_shaped(tuple(shape))}, got {_shaped(answer.shape)}")
    return answer.applyfunc(lambda entry: as_expression(entry, symbols)).as_immutable()


def _shaped(shape):
    return "a single expression" if shape == (1, 1) else f"a matrix of shape {shape}"


def as_condition(answer, symbols):
    """A SymPy condition (relation, And, Or, ...) in the given symbols.

    Also accepted: a list or set of conditions, Python's or SymPy's (all of them hold), a set of
    values of the symbols, a list or an array of the values of a single one, cases that are
    conditions, True and False.
    """
    if isinstance(answer, (bool, np.bool_)):
        remark(
            f"What was handed over is a bare {bool(answer)}: in Python `x != 77` is True and `x == "
            "77` is False at once; write `sp.Ne(x, 77)` and `sp.Eq(x, 77)`"
        )
        return sp.true if answer else sp.false
    if len(symbols) == 1 and (values := _listed_numbers(answer)) is not None:
        if any(sp.sympify(value).has(sp.nan, sp.zoo) for value in values):
            raise Invalid("one of the values is undefined (nan, or a division by zero)")
        answer = sp.FiniteSet(*values)
    if (isinstance(answer, (list, tuple, set, frozenset, sp.Tuple)) and answer) or (
        isinstance(answer, sp.FiniteSet) and all(map(_is_logical, answer))
    ):
        answer = sp.And(*[as_condition(part, symbols) for part in answer])
    if isinstance(answer, sp.Set):
        answer = _membership(answer, symbols)
    if isinstance(answer, sp.Piecewise) and _has_logical_cases(answer):
        answer = _chosen(answer.args)
    if isinstance(answer, sp.Basic) and answer.has(sp.Contains):
        answer = answer.xreplace(
            {part: _membership(part.args[1], part.args[:1]) for part in answer.atoms(sp.Contains)}
        )
    if not isinstance(
        answer, (sp.logic.boolalg.Boolean, sp.core.relational.Relational)
    ) or isinstance(answer, sp.Symbol):
        raise Invalid(f"expected a condition, {EXAMPLE_OF_CONDITION}, got {_named(answer)}")
    if _written_out(answer, {})[0] > MOST_WRITTEN_OUT:
        raise Invalid(
            f"written with And and Or alone this condition has more than {MOST_WRITTEN_OUT} "
            "inequalities; give a simpler form of it"
        )
    for relation in answer.atoms(sp.core.relational.Relational):
        if not all(
            isinstance(side, sp.Expr) and not isinstance(side, sp.MatrixBase)
            for side in relation.args
        ):
            raise Invalid(
                "a condition compares numbers, not matrices, other conditions, True or False; "
                f"write the condition itself, {EXAMPLE_OF_CONDITION}"
            )
        if any(_has_logical_cases(side) for side in relation.args):
            raise Invalid("the condition compares something with cases that are True or False")
        if any(_is_undefined(side) for side in relation.args):
            raise Invalid(
                "the condition contains an undefined value (nan, a division by zero, or oo - oo)"
            )
    if odd := answer.atoms(*NOT_IN_CONDITIONS):
        raise Invalid(
            f"the condition contains {', '.join(sorted({type(part).__name__ for part in odd}))}, "
            "which cannot be judged here; write it without"
        )
    if grows_too_fast(answer, FAR_BITS) or any(
        abs(power.exp) > LARGEST_POWER for power in answer.atoms(sp.Pow) if power.exp.is_number
    ):
        raise Invalid(
            "the condition contains a power or an exponential that grows too fast to be computed "
            "with"
        )
    try:
        return with_symbols(answer, symbols)
    # SymPy refuses to compare what is not real, once it knows that the symbols are
    except TypeError:
        raise Invalid(
            "the condition compares numbers that are not real, whatever the symbols are"
        ) from None


def _listed_numbers(answer):
    """The numbers in a list, a set, an array or a column, or None for what is not made of
    numbers."""
    parts = (
        list(answer.ravel())
        if isinstance(answer, np.ndarray)
        else list(answer)
        if isinstance(answer, (list, tuple, set, frozenset, sp.Tuple, sp.MatrixBase))
        else [None]
    )
    numbers = (int, float, np.number, sp.Expr)
    return (
        parts
        if all(
            isinstance(part, numbers)
            and not isinstance(part, (bool, np.bool_, sp.MatrixBase))
            and not getattr(part, "free_symbols", None)
            for part in parts
        )
        else None
    )


def _chosen(cases):
    """The condition that cases (condition, where) choose: the first that fits, and False where none
    does."""
    value, where = cases[0]
    if not _is_logical(value):
        raise Invalid("the cases of a condition have to be conditions, True or False")
    rest = _chosen(cases[1:]) if cases[1:] else sp.false
    return sp.Or(sp.And(where, value), sp.And(sp.Not(where), rest))


def _written_out(condition, known):
    """How many relations a condition and its negation have once they are written with And, Or and
    relations alone."""
    if condition not in known:
        parts = [
            _written_out(part, known)
            for part in condition.args
            if isinstance(part, sp.logic.boolalg.Boolean)
        ]
        if isinstance(condition, sp.core.relational.Relational) or not parts:
            sizes = 1, 1
        elif isinstance(condition, (sp.And, sp.Or)):
            sizes = tuple(map(sum, zip(*parts)))
        elif isinstance(condition, sp.Not):
            sizes = parts[0][::-1]
        elif isinstance(condition, sp.Implies):
            (was, was_not), (then, then_not) = parts
            sizes = was_not + then, was + then_not
        else:  # Xor, ITE and the like need each part with its negation
            sizes = parts[0]
            for part in parts[1:]:
                sizes = (sum(sizes) + sum(part),) * 2
        known[condition] = sizes
    return known[condition]


def as_choice(answer, choices):
    """One of the words offered, in any case and with spaces, hyphens or underscores."""
    if not isinstance(answer, str):
        raise Invalid(
            f"expected one of the words {', '.join(map(repr, choices))}, got {_named(answer)}"
        )
    words = {_plain(choice): choice for choice in choices}
    if _plain(answer) not in words:
        raise Invalid(f"expected one of the words {', '.join(map(repr, choices))}")
    return words[_plain(answer)]


def as_yes_no(answer):
    """True or False from a bool or one of the words yes, no."""
    if isinstance(answer, sp.logic.boolalg.BooleanAtom):
        answer = bool(answer)
    if isinstance(answer, np.bool_):
        answer = bool(answer)
    word = answer.strip().lower() if isinstance(answer, str) else answer
    if isinstance(word, (bool, str)) and word in YES | NO:
        return word in YES
    raise Invalid(
        "expected yes or no (True or False)"
        + ("" if isinstance(answer, str) else f", got {_named(answer)}")
    )


def _is_undefined(side):
    """True for an expression that has no value whatever its symbols are; oo has one, where numbers
    are compared."""
    return side.has(sp.nan, sp.zoo) or (
        side.is_number and side.has(sp.oo, -sp.oo, 0) and side.evalf(5) in (sp.nan, sp.zoo)
    )


def _membership(region, symbols):
    """The condition that the point `symbols` lies in a SymPy set."""
    if region is sp.S.EmptySet:
        return sp.false
    point = symbols[0] if len(symbols) == 1 else sp.Tuple(*symbols)
    if isinstance(region, sp.ConditionSet):
        names = region.sym if isinstance(region.sym, (sp.Tuple, tuple)) else (region.sym,)
        if len(names) != len(symbols):
            raise Invalid(
                f"expected a set of points with {len(symbols)} coordinates, got one with "
                f"{len(names)}"
            )
        return sp.And(
            region.condition.xreplace(dict(zip(names, symbols))),
            _membership(region.base_set, symbols),
        )
    if len(symbols) == 1 and hasattr(region, "as_relational") and region.is_subset(sp.S.Reals):
        return region.as_relational(point)
    if isinstance(region, sp.ProductSet) and len(region.args) == len(symbols):
        return sp.And(*[_membership(part, [symbol]) for part, symbol in zip(region.args, symbols)])
    if isinstance(region, (sp.Union, sp.Intersection)):
        parts = [_membership(part, symbols) for part in region.args]
        return sp.Or(*parts) if isinstance(region, sp.Union) else sp.And(*parts)
    raise Invalid(
        f"expected a condition or a set of values of {', '.join(s.name for s in symbols)}"
    )


def _entries(answer):
    """The components of a vector in any of its usual forms, or None."""
    answer = _unwrapped(answer)
    if isinstance(answer, np.ndarray):
        return list(answer.ravel()) if answer.ndim <= 1 or 1 in answer.shape else None
    if isinstance(answer, sp.MatrixBase):
        return list(answer) if 1 in answer.shape else None
    if isinstance(answer, dict):
        return list(answer.values())
    if isinstance(answer, (list, tuple, sp.Tuple)):
        nested = [_entries(entry) for entry in answer]
        if nested and all(entry is not None and len(entry) == 1 for entry in nested):
            return [entry[0] for entry in nested]  # a column
        if len(nested) == 1 and nested[0] is not None:
            return nested[0]  # a row
        return list(answer)
    return None


def _unwrapped(answer):
    """CasADi DM as an array; an array with a single entry as this entry where an array makes no
    sense."""
    casadi = sys.modules.get("casadi")
    if casadi is not None and isinstance(answer, casadi.DM):
        answer = answer.full()
    if isinstance(answer, np.ndarray) and answer.ndim == 0:
        return answer.item()
    return answer


def _plain(word):
    return " ".join(word.lower().replace("-", " ").replace("_", " ").split())


def _count(number, noun):
    return f"{number} {noun}{'s' if number != 1 else ''}" if number is not None else f"{noun}s"


def _named(answer):
    """What an answer is, in a word, without trusting its own repr."""
    if answer is None:
        return "None (was the value computed but not assigned?)"
    if callable(answer) and not isinstance(answer, sp.Basic):
        return "a function"
    words = (word for types, word in KINDS if isinstance(answer, types))
    return next(words, f"a value of type {type(answer).__name__}")
