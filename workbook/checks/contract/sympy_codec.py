"""The SymPy half of `encoding`: which nodes may cross, how each is written, and how each is built
again within bounds.

A node is written as its kind and its arguments. `NODES` is the whole list; `READERS` adds the
leaves (numbers, symbols, undefined functions) and the containers with a layout of their own
(matrices, polynomials). Names from the wire are only ever looked up in these.

Every node is built *as written*: decoding computes nothing. Evaluating again would not be bounded
by any limit on the text, since SymPy's constructors ask for signs and reality (`Abs(x)**2` asks
whether x is real), compare all pairs (`Max`), fold Piecewise functions and solve equations
(`ConditionSet`): an ordinary expression of four kilobytes took five seconds, re((x + I*y)**1000)
eighty. And nothing is lost: whatever SymPy evaluates by itself was evaluated where the answer was
made, and what a student left unevaluated meets the check in the grader as it does in the notebook.

Names need care of another kind. `lambdify` prints an expression as Python code, symbols and
undefined functions by their bare names, so `Symbol("print(1)")` runs in whatever process compiles
it. Hence the narrow alphabet of names, without brackets, quotes and dots, and no undefined function
called like one that Python or NumPy has (`exec`, `chr`, `load`).

Numbers of mpmath and Fractions are written as the SymPy numbers they are, a root of a polynomial
that SymPy only counts (`CRootOf`) in decimals, a `sympy.Array` as nested lists; none of them stays
what it was.

What a check will do with an answer is bounded by the judge's own limits of time and memory, yet
numbers that nobody writes as an answer and that a mere comparison would blow up, such as 10**10**9
or exp(exp(exp(9))), are refused here, by a bound on their size.
"""

import builtins
import math
import re
import unicodedata
from fractions import Fraction
from typing import NamedTuple

import mpmath
import numpy as np
import sympy as sp
from sympy.core.assumptions import _assume_defined
from sympy.core.function import Application, AppliedUndef, UndefinedFunction
from sympy.functions.elementary.piecewise import ExprCondPair
from sympy.logic.boolalg import Boolean
from sympy.matrices.matrixbase import MatrixBase

from workbook.checks.contract.encoding import MAX_DIGITS, MAX_NODES, write_elements
from workbook.checks.contract.magnitude import MAX_EXPONENT, log2, size

MAX_NAME = 100  # characters of a symbol's or function's name
MAX_FUNCTIONS = 100  # different undefined functions in an answer: each is a Python class
MAX_ORDER = 100  # of a derivative
DOUBLE_BITS = 53  # precision of a float
ROOT_DIGITS = 50  # of a root of a polynomial that has no formula
# magnitude of anything without symbols, and the precision of a Float
NUMBER_BITS = int(MAX_DIGITS * math.log2(10))


# Which arguments a node takes


def scalar(x):
    # SymPy counts immutable matrices and Lambda as Expr.
    return isinstance(x, sp.Expr) and not isinstance(x, (MatrixBase, sp.Lambda))


def boolean(x):
    return isinstance(x, Boolean)


def scalar_or_boolean(x):
    return scalar(x) or boolean(x)


def truth(x):
    return x is sp.true or x is sp.false


def symbol(x):
    return type(x) in (sp.Symbol, sp.Dummy)


def symbols(x):
    return symbol(x) or (type(x) is sp.Tuple and all(map(symbols, x)))


def signature(x):
    return type(x) is sp.Tuple and symbols(x)


def a_set(x):
    return isinstance(x, sp.Set)


def a_function(x):
    return isinstance(x, sp.Lambda)


def part(x):
    """A side of an equation, an element of a set, a value of a Lambda."""
    return isinstance(x, sp.Basic) and not isinstance(x, (sp.Poly, ExprCondPair, sp.NDimArray))


def case(x):
    return isinstance(x, ExprCondPair)


def limits(x):
    return type(x) is sp.Tuple and 1 <= len(x) <= 3 and symbol(x[0]) and all(map(scalar, x))


def range_of(x):
    return limits(x) and len(x) == 3


def derivation(x):
    """A variable and how often: differentiated by 10**9 times, an expression would list it as
    often."""
    if (
        type(x) is not sp.Tuple
        or len(x) != 2
        or not (symbol(x[0]) or isinstance(x[0], (AppliedUndef, sp.Derivative)))
    ):
        return False
    return (x[1].is_Integer and 0 < x[1] <= MAX_ORDER) or symbol(x[1])


# How a node is built. Where SymPy's constructor cannot be asked not to compute, the object is put
# together as the constructor does it, with the attributes beside `args` that it sets.


def unevaluated(cls, *args):
    return cls(*args, evaluate=False)


def bare(cls, *args):
    return sp.Basic.__new__(cls, *args)


def operands(cls, *args):
    node = sp.Basic.__new__(cls, *args)
    node._argset = frozenset(args)
    return node


def logical(cls, *args):
    return Application.__new__(cls, *args, evaluate=False)


def connective(cls, *args):
    node = logical(cls, *args)
    node._argset = frozenset(args)
    return node


def elements(cls, *args):
    node = sp.Basic.__new__(cls, *args)
    node._args_set = set(args)
    return node


def with_limits(cls, *args):
    node = sp.Basic.__new__(cls, *args)
    node.is_commutative = True
    return node


class Node(NamedTuple):
    cls: type
    build: object
    takes: tuple  # a predicate for each of the first arguments
    more: object = None  # a predicate for any further ones


def _each(build, takes, *classes):
    return [Node(cls, build, takes) for cls in classes]


_ROWS = [
    Node(sp.Add, unevaluated, (scalar, scalar), scalar),
    Node(sp.Mul, unevaluated, (scalar, scalar), scalar),
    Node(sp.Pow, unevaluated, (scalar, scalar)),
    *_each(unevaluated, (scalar,), sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc),
    *_each(unevaluated, (scalar,), sp.asin, sp.acos, sp.atan, sp.acot, sp.asec, sp.acsc),
    *_each(unevaluated, (scalar,), sp.sinh, sp.cosh, sp.tanh, sp.coth, sp.sech, sp.csch),
    *_each(unevaluated, (scalar,), sp.asinh, sp.acosh, sp.atanh, sp.acoth, sp.asech, sp.acsch),
    *_each(
        unevaluated,
        (scalar,),
        sp.Abs,
        sp.sign,
        sp.re,
        sp.im,
        sp.conjugate,
        sp.arg,
        sp.floor,
        sp.ceiling,
    ),
    *_each(unevaluated, (scalar,), sp.sinc, sp.erf, sp.erfc, sp.factorial, sp.gamma),
    *_each(unevaluated, (scalar, scalar), sp.atan2, sp.Mod, sp.binomial),
    Node(sp.Heaviside, unevaluated, (scalar,), scalar),  # with its value at zero
    Node(sp.DiracDelta, unevaluated, (scalar,), scalar),  # with the order of its derivative
    *[Node(cls, operands, (scalar, scalar), scalar) for cls in (sp.Max, sp.Min)],
    *_each(unevaluated, (part, part), sp.Eq, sp.Ne),
    *_each(unevaluated, (scalar, scalar), sp.Lt, sp.Le, sp.Gt, sp.Ge),
    *[Node(cls, connective, (boolean, boolean), boolean) for cls in (sp.And, sp.Or, sp.Xor)],
    Node(sp.Not, unevaluated, (boolean,)),
    Node(sp.Implies, unevaluated, (boolean, boolean)),
    Node(sp.ITE, logical, (boolean, boolean, boolean)),
    Node(ExprCondPair, bare, (scalar_or_boolean, boolean)),
    Node(sp.Contains, bare, (scalar, a_set)),
    Node(sp.Piecewise, bare, (case,), case),
    Node(sp.Tuple, bare, (), part),
    Node(sp.Lambda, bare, (signature, part)),
    Node(sp.Derivative, bare, (scalar, derivation), derivation),
    Node(sp.Integral, with_limits, (scalar, limits), limits),
    Node(sp.Sum, with_limits, (scalar, range_of), range_of),
    Node(sp.Interval, bare, (scalar, scalar, truth, truth)),
    Node(sp.FiniteSet, elements, (part,), part),
    *[Node(cls, operands, (a_set,), a_set) for cls in (sp.Union, sp.Intersection)],
    Node(sp.Complement, bare, (a_set, a_set)),
    Node(sp.ProductSet, bare, (a_set,), a_set),
    Node(sp.ConditionSet, bare, (symbols, boolean, a_set)),
    Node(sp.ImageSet, bare, (a_function, a_set), a_set),
]
NODES = {row.cls.__name__: row for row in _ROWS}

_S = sp.S
ATOMS = {
    **{"pi": sp.pi, "E": sp.E, "I": sp.I, "oo": sp.oo, "-oo": -sp.oo, "zoo": sp.zoo, "nan": sp.nan},
    **{
        "GoldenRatio": sp.GoldenRatio,
        "EulerGamma": sp.EulerGamma,
        "True": sp.true,
        "False": sp.false,
    },
    **{
        "EmptySet": _S.EmptySet,
        "UniversalSet": _S.UniversalSet,
        "Reals": _S.Reals,
        "Complexes": _S.Complexes,
    },
    **{
        "Rationals": _S.Rationals,
        "Integers": _S.Integers,
        "Naturals": _S.Naturals,
        "Naturals0": _S.Naturals0,
    },
    "Identity": _S.IdentityFunction,
}


# Writing


def encoder(value):
    """The function that writes `value`, called as `write(walk, value)`; None where it is no SymPy
    object that may cross."""
    cls = type(value)
    if type(cls) is UndefinedFunction:
        return _write_applied if _is_plain_function(cls) else None
    return _WRITERS.get(id(cls))


_FUNCTION_ATTRIBUTES = set(vars(sp.Function("f")))
_FUNCTION_ASSUMPTIONS = {f"is_{name}" for name in _assume_defined}


def _is_plain_function(cls):
    """Whether the class that `Function("f")` made has nothing of the student's own (it takes bases
    and methods, too)."""
    bases, attributes = (
        type.__dict__["__bases__"].__get__(cls),
        type.__dict__["__dict__"].__get__(cls),
    )
    return (
        len(bases) == 1
        and bases[0] is AppliedUndef
        and all(
            name in _FUNCTION_ATTRIBUTES
            or (name in _FUNCTION_ASSUMPTIONS and type(attributes[name]) is bool)
            for name in attributes
        )
    )


def _write_node(row):
    def write(walk, value):
        args = walk.children(value.args, ".args[{}]")
        _check_args(walk, row, value.args)
        _check_size(walk, value)
        return {"kind": row.cls.__name__, "args": args}

    return write


def _write_integer(walk, value):
    return {"kind": "Integer", "value": walk.integer(int(value.p))}


def _write_rational(walk, value):
    return {"kind": "Rational", "p": walk.integer(int(value.p)), "q": walk.integer(int(value.q))}


def _write_float(walk, value):
    sign, mantissa, exponent, bits = value._mpf_
    _check_float(walk, int(exponent) + bits, value._prec)
    return {
        "kind": "Float",
        "mantissa": int(-mantissa if sign else mantissa),
        "exponent": int(exponent),
        "precision": value._prec,
    }


def _write_fraction(walk, value):
    p, q = walk.integer(value.numerator), walk.integer(value.denominator)
    return p if q == 1 else {"kind": "Rational", "p": p, "q": q}


def _write_mpf(walk, value):
    return walk.visit(_number(value._mpf_))


def _write_mpc(walk, value):
    real, imag = map(_number, value._mpc_)
    return walk.visit(real + _S.ImaginaryUnit * imag)


def _number(mpf):
    """The Float with all digits of mpmath's tuple; nan or an infinity where it says so."""
    return sp.Float._new(mpf, max(DOUBLE_BITS, mpf[3]), zero=False)


def _write_symbol(walk, value):
    return {
        "kind": "Symbol",
        "name": _name(walk, value.name),
        "assumptions": _assumptions(walk, value._assumptions_orig),
    }


def _write_dummy(walk, value):
    dummy = {
        **_write_symbol(walk, value),
        "kind": "Dummy",
        "index": walk.integer(value.dummy_index),
    }
    walk.dummies.append(dummy)
    return dummy


def _write_applied(walk, value):
    cls = type(value)
    name, assumptions = _function_name(walk, cls.__name__), _assumptions(walk, cls._kwargs)
    return {
        "kind": "apply",
        "name": name,
        "assumptions": assumptions,
        "args": walk.children(value.args, ".args[{}]"),
    }


def _write_matrix(kind):
    def write(walk, value):
        rows, columns = value.shape
        if rows * columns > MAX_NODES:  # before a sparse one is made dense
            raise walk.error(
                f"is a matrix of {rows * columns} entries; up to {MAX_NODES} are allowed"
            )
        entries = [
            walk.child(f"[{i}, {j}]", value[i, j]) for i in range(rows) for j in range(columns)
        ]
        return {"kind": kind, "rows": rows, "columns": columns, "entries": entries}

    return write


def _write_poly(kind):
    def write(walk, value):
        gens = walk.children(value.gens, ".gens[{}]")
        terms = [[list(powers), walk.child(f".coeff{powers}", c)] for powers, c in value.terms()]
        _spend_on_powers(walk, value.monoms())
        return {"kind": kind, "gens": gens, "terms": terms}

    return write


def _write_root(walk, value):
    return walk.visit(value.evalf(ROOT_DIGITS))


def _write_inner(walk, value):
    return walk.visit(value.args[0])  # UnevaluatedExpr(x) is x


_WRITERS = {
    **{id(row.cls): _write_node(row) for row in NODES.values()},
    **{
        id(type(atom)): (lambda walk, value, kind=kind: {"kind": kind})
        for kind, atom in ATOMS.items()
    },
    **{
        id(type(number)): _write_integer
        for number in (sp.Integer(2), _S.Zero, _S.One, _S.NegativeOne)
    },
    **{id(type(number)): _write_rational for number in (sp.Rational(1, 3), _S.Half)},
    **{id(cls): _write_matrix("Matrix") for cls in (sp.MutableDenseMatrix, sp.MutableSparseMatrix)},
    **{
        id(cls): _write_matrix("ImmutableMatrix")
        for cls in (sp.ImmutableDenseMatrix, sp.ImmutableSparseMatrix)
    },
    **{id(cls): write_elements for cls in (sp.ImmutableDenseNDimArray, sp.MutableDenseNDimArray)},
    **{id(cls): write_elements for cls in (sp.ImmutableSparseNDimArray, sp.MutableSparseNDimArray)},
    id(mpmath.mpf): _write_mpf,
    id(mpmath.mpc): _write_mpc,
    id(Fraction): _write_fraction,
    id(sp.Float): _write_float,
    id(sp.Symbol): _write_symbol,
    id(sp.Dummy): _write_dummy,
    id(sp.Poly): _write_poly("Poly"),
    id(sp.PurePoly): _write_poly("PurePoly"),
    id(sp.CRootOf): _write_root,
    id(sp.UnevaluatedExpr): _write_inner,
}


# Checks that both directions share


# \w: letters of any language, digits, _; then accents, and what LaTeX needs
_NAME = re.compile(r"[\w\u0300-\u036f\\{}^*+\-,′ ]+")
_CALLABLE = {*dir(builtins), *dir(np)}


def _name(walk, name):
    if not _NAME.fullmatch(walk.text(name, MAX_NAME)):
        raise walk.error(
            f"has the name {name!r}; names may have letters, digits, spaces and _ {{ }} ^ * + - , "
            "\\"
        )
    return name


def _function_name(walk, name):
    # Python reads identifiers in the form NFKC: a full-width `exec` is `exec`.
    words = re.findall(r"\w+", unicodedata.normalize("NFKC", _name(walk, name)))
    if not _CALLABLE.isdisjoint(words):
        raise walk.error(
            f"is a function called {name!r}, as one of Python's or NumPy's is; choose another name"
        )
    return name


def _assumptions(walk, assumptions):
    """A copy of the assumptions on a symbol or function, each of them one of SymPy's own, true or
    false."""
    if type(assumptions) is not dict:
        raise walk.error("should have its assumptions in a dict")
    for name, value in assumptions.items():
        if type(name) is not str or name not in _assume_defined or type(value) is not bool:
            raise walk.error("has an assumption that is not one of SymPy's")
    if assumptions.get("commutative") is False:
        raise walk.error("is a symbol that does not commute; commuting ones are allowed")
    return dict(assumptions)


def _check_float(walk, magnitude, precision):
    if not 1 <= walk.integer(precision) <= NUMBER_BITS or abs(magnitude) > NUMBER_BITS:
        raise walk.error(f"is a Float beyond {MAX_DIGITS} digits")


def _spend_on_powers(walk, monomials):
    # SymPy stores all powers up to the highest, present or not.
    walk.spend(math.prod(1 + max(powers) for powers in zip(*monomials)))


def _check_args(walk, row, args):
    wanted = row.takes + (row.more,) * (len(args) - len(row.takes)) if row.more else row.takes
    if len(args) != len(wanted) or not all(fits(arg) for fits, arg in zip(wanted, args)):
        given = ", ".join(type(arg).__name__ for arg in args[:4])
        raise walk.error(
            f"is {row.cls.__name__} of ({given}{', ...' * (len(args) > 4)}), which is not an answer"
        )
    if row.cls is sp.Interval:
        _check_interval(walk, *args)


def _check_interval(walk, start, end, left_open, right_open):
    # The constructor's checks, as far as numbers decide them.
    backwards = start.is_Number and end.is_Number and not start < end
    closed_at_infinity = (start is -sp.oo and left_open is sp.false) or (
        end is sp.oo and right_open is sp.false
    )
    if backwards or closed_at_infinity:
        raise walk.error("is an Interval whose ends are not in order, or closed at infinity")


def _check_size(walk, node):
    if not scalar(node):
        return
    if isinstance(node, sp.Pow) and node.exp.is_Number and log2(node.exp) > math.log2(MAX_EXPONENT):
        raise walk.error(f"is a power with an exponent beyond {MAX_EXPONENT}")
    *bits, symbolic = size(node, walk.sizes)
    if not symbolic and not max(bits) <= NUMBER_BITS:
        raise walk.error(
            f"is a number with more than about {MAX_DIGITS} digits before or after the point"
        )


# Reading


def _read_node(row):
    def read(walk, args):
        args = walk.items(args, ".args[{}]")
        _check_args(walk, row, args)
        node = row.build(row.cls, *args)
        _check_size(walk, node)
        return node

    return read


def _read_integer(walk, value):
    return sp.Integer(walk.integer(value))


def _read_rational(walk, p, q):
    if walk.integer(q) < 2 or math.gcd(walk.integer(p), q) != 1:
        raise walk.error("should be a fraction in lowest terms")
    return sp.Rational(p, q)


def _read_float(walk, mantissa, exponent, precision):
    bits = walk.integer(mantissa).bit_length()
    _check_float(walk, walk.integer(exponent) + bits, precision)
    if bits > precision:
        raise walk.error("is a Float with more digits than its precision")
    # As a number compares, so it is judged: one of a single bit would equal all that rounds to it.
    precision = max(precision, DOUBLE_BITS)
    # `_new` normalises, as it does for every Float; `zero=False` keeps 0.0 a Float.
    return sp.Float._new((int(mantissa < 0), abs(mantissa), exponent, bits), precision, zero=False)


def _read_symbol(walk, name, assumptions):
    return sp.Symbol(_name(walk, name), **_assumptions(walk, assumptions))


def _read_dummy(walk, name, assumptions, index):
    # SymPy counts its own Dummies from a million on, so none of them is taken for this one.
    if not 0 <= walk.integer(index) < MAX_NODES:
        raise walk.error("is a Dummy with a number out of range")
    return sp.Dummy(_name(walk, name), dummy_index=index, **_assumptions(walk, assumptions))


def _read_applied(walk, name, assumptions, args):
    key = _function_name(walk, name), tuple(sorted(_assumptions(walk, assumptions).items()))
    if key not in walk.functions:
        if len(walk.functions) == MAX_FUNCTIONS:
            raise walk.error(f"is one undefined function more than the {MAX_FUNCTIONS} allowed")
        walk.functions[key] = sp.Function(name, **assumptions)
    args = walk.items(args, ".args[{}]")
    if not args or not all(map(scalar, args)):
        raise walk.error("is a function of something that is not an expression")
    return walk.functions[key](*args, evaluate=False)


def _read_matrix(cls):
    def read(walk, rows, columns, entries):
        if min(walk.integer(rows), walk.integer(columns)) < 0 or max(rows, columns) > MAX_NODES:
            raise walk.error("is a matrix with impossible dimensions")
        entries = walk.items(entries)
        if len(entries) != rows * columns or not all(map(scalar, entries)):
            raise walk.error(
                "is a matrix whose entries should be expressions, rows times columns of them"
            )
        return cls(rows, columns, entries)

    return read


def _read_poly(cls):
    def read(walk, gens, terms):
        gens = walk.items(gens, ".gens[{}]")
        coefficients = {}
        for term in walk.as_list(terms):
            if len(walk.as_list(term)) != 2 or len(walk.as_list(term[0])) != len(gens):
                raise walk.error(
                    "is a polynomial whose terms should be pairs of powers and coefficient"
                )
            powers = tuple(map(walk.integer, term[0]))
            coefficients[powers] = walk.child(f".coeff{powers}"[:60], term[1])
        if len(coefficients) != len(terms) or not all(map(scalar, [*gens, *coefficients.values()])):
            raise walk.error(
                "is a polynomial with a term given twice or a coefficient that is no expression"
            )
        if any(gen.is_number for gen in gens) or any(min(powers) < 0 for powers in coefficients):
            raise walk.error("is a polynomial in a number or with a negative power")
        _spend_on_powers(walk, coefficients)
        # For a `composite` domain such as ZZ[k] SymPy multiplies the coefficients out, (a + b +
        # c)**1000 too.
        composite = None if all(map(_is_expanded, coefficients.values())) else False
        return cls.from_dict(coefficients, *gens, composite=composite)

    return read


def _is_expanded(coefficient):
    factors = [
        factor for term in sp.Add.make_args(coefficient) for factor in sp.Mul.make_args(term)
    ]
    return all(
        (f.base if isinstance(f, sp.Pow) and f.exp.is_Integer and f.exp > 0 else f).is_Atom
        for f in factors
    )


READERS = {
    **{kind: (("args",), _read_node(row)) for kind, row in NODES.items()},
    **{kind: ((), lambda walk, atom=atom: atom) for kind, atom in ATOMS.items()},
    "Integer": (("value",), _read_integer),
    "Rational": (("p", "q"), _read_rational),
    "Float": (("mantissa", "exponent", "precision"), _read_float),
    "Symbol": (("name", "assumptions"), _read_symbol),
    "Dummy": (("name", "assumptions", "index"), _read_dummy),
    "apply": (("name", "assumptions", "args"), _read_applied),
    "Matrix": (("rows", "columns", "entries"), _read_matrix(sp.Matrix)),
    "ImmutableMatrix": (("rows", "columns", "entries"), _read_matrix(sp.ImmutableMatrix)),
    "Poly": (("gens", "terms"), _read_poly(sp.Poly)),
    "PurePoly": (("gens", "terms"), _read_poly(sp.PurePoly)),
}
