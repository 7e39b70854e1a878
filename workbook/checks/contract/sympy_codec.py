"""Encoding of SymPy objects: how each node is written and built again within bounds.

A node is written as its kind and its arguments. `sympy_nodes.NODES` is the whole list; `READERS` adds the
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

import math
from fractions import Fraction

import mpmath
import sympy as sp
from sympy.core.assumptions import _assume_defined
from sympy.core.function import AppliedUndef, UndefinedFunction

from workbook.checks.contract.arrays import write_elements
from workbook.checks.contract.limits import DOUBLE_BITS, MAX_NODES
from workbook.checks.contract.sympy_checks import (
    check_args,
    check_assumptions,
    check_float,
    check_function_name,
    check_name,
    check_size,
    spend_on_powers,
)
from workbook.checks.contract.sympy_nodes import ATOMS, NODES, scalar

MAX_FUNCTIONS = 100  # different undefined functions in an answer: each is a Python class
ROOT_DIGITS = 50  # of a root of a polynomial that has no formula


# Writing


def encoder(value):
    """Return the function that writes a SymPy object as `write(walk, value)`, or None."""
    cls = type(value)
    if type(cls) is UndefinedFunction:
        return _write_applied if _is_plain_function(cls) else None
    return _WRITERS.get(id(cls))


_FUNCTION_ATTRIBUTES = set(vars(sp.Function("f")))
_FUNCTION_ASSUMPTIONS = {f"is_{name}" for name in _assume_defined}


def _is_plain_function(cls):
    """Return whether a class of `Function("f")` has no bases or methods of the student's own."""
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
        check_args(walk, row, value.args)
        check_size(walk, value)
        return {"kind": row.cls.__name__, "args": args}

    return write


def _write_integer(walk, value):
    return {"kind": "Integer", "value": walk.integer(int(value.p))}


def _write_rational(walk, value):
    return {"kind": "Rational", "p": walk.integer(int(value.p)), "q": walk.integer(int(value.q))}


def _write_float(walk, value):
    sign, mantissa, exponent, bits = value._mpf_
    check_float(walk, int(exponent) + bits, value._prec)
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
    return walk.visit(real + sp.S.ImaginaryUnit * imag)


def _number(mpf):
    """Return the Float with all digits of mpmath's tuple, also nan or an infinity."""
    return sp.Float._new(mpf, max(DOUBLE_BITS, mpf[3]), zero=False)


def _write_symbol(walk, value):
    return {
        "kind": "Symbol",
        "name": check_name(walk, value.name),
        "assumptions": check_assumptions(walk, value._assumptions_orig),
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
    name, assumptions = (
        check_function_name(walk, cls.__name__),
        check_assumptions(walk, cls._kwargs),
    )
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
        spend_on_powers(walk, value.monoms())
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
        for number in (sp.Integer(2), sp.S.Zero, sp.S.One, sp.S.NegativeOne)
    },
    **{id(type(number)): _write_rational for number in (sp.Rational(1, 3), sp.S.Half)},
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


# Reading


def _read_node(row):
    def read(walk, args):
        args = walk.items(args, ".args[{}]")
        check_args(walk, row, args)
        node = row.build(row.cls, *args)
        check_size(walk, node)
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
    check_float(walk, walk.integer(exponent) + bits, precision)
    if bits > precision:
        raise walk.error("is a Float with more digits than its precision")
    precision = max(precision, walk.least_precision)
    # `_new` normalises, as it does for every Float; `zero=False` keeps 0.0 a Float.
    return sp.Float._new((int(mantissa < 0), abs(mantissa), exponent, bits), precision, zero=False)


def _read_symbol(walk, name, assumptions):
    return sp.Symbol(check_name(walk, name), **check_assumptions(walk, assumptions))


def _read_dummy(walk, name, assumptions, index):
    # SymPy counts its own Dummies from a million on, so none of them is taken for this one.
    if not 0 <= walk.integer(index) < MAX_NODES:
        raise walk.error("is a Dummy with a number out of range")
    return sp.Dummy(
        check_name(walk, name), dummy_index=index, **check_assumptions(walk, assumptions)
    )


def _read_applied(walk, name, assumptions, args):
    key = (
        check_function_name(walk, name),
        tuple(sorted(check_assumptions(walk, assumptions).items())),
    )
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
        spend_on_powers(walk, coefficients)
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
