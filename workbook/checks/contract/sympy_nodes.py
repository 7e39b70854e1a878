"""The nodes of SymPy that an answer may hold: the arguments they take, and how they are built."""

from typing import NamedTuple

import sympy as sp
from sympy.core.function import Application, AppliedUndef
from sympy.functions.elementary.piecewise import ExprCondPair
from sympy.logic.boolalg import Boolean
from sympy.matrices.matrixbase import MatrixBase

MAX_ORDER = 100  # of a derivative

# Which arguments a node takes


def scalar(x):
    # SymPy counts immutable matrices and Lambda as Expr.
    return isinstance(x, sp.Expr) and not isinstance(x, (MatrixBase, sp.Lambda))


def boolean(x):
    return isinstance(x, Boolean)


def scalar_or_boolean(x):
    return scalar(x) or boolean(x)


def truth_value(x):
    return x is sp.true or x is sp.false


def symbol(x):
    return type(x) in (sp.Symbol, sp.Dummy)


def symbols(x):
    return symbol(x) or (type(x) is sp.Tuple and all(map(symbols, x)))


def signature(x):
    return type(x) is sp.Tuple and symbols(x)


def is_set(x):
    return isinstance(x, sp.Set)


def is_lambda(x):
    return isinstance(x, sp.Lambda)


def operand(x):
    """Return whether it may be a side of an equation, an element of a set, a value of a Lambda."""
    return isinstance(x, sp.Basic) and not isinstance(x, (sp.Poly, ExprCondPair, sp.NDimArray))


def case(x):
    return isinstance(x, ExprCondPair)


def limits(x):
    return type(x) is sp.Tuple and 1 <= len(x) <= 3 and symbol(x[0]) and all(map(scalar, x))


def finite_range(x):
    return limits(x) and len(x) == 3


def derivation(x):
    """Return whether it is a variable and a number of times to differentiate by it.

    The number is limited, since an expression lists its variable as often.
    """
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
    """A class of SymPy nodes: how one is built, and the arguments that it takes."""

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
    *_each(unevaluated, (operand, operand), sp.Eq, sp.Ne),
    *_each(unevaluated, (scalar, scalar), sp.Lt, sp.Le, sp.Gt, sp.Ge),
    *[Node(cls, connective, (boolean, boolean), boolean) for cls in (sp.And, sp.Or, sp.Xor)],
    Node(sp.Not, unevaluated, (boolean,)),
    Node(sp.Implies, unevaluated, (boolean, boolean)),
    Node(sp.ITE, logical, (boolean, boolean, boolean)),
    Node(ExprCondPair, bare, (scalar_or_boolean, boolean)),
    Node(sp.Contains, bare, (scalar, is_set)),
    Node(sp.Piecewise, bare, (case,), case),
    Node(sp.Tuple, bare, (), operand),
    Node(sp.Lambda, bare, (signature, operand)),
    Node(sp.Derivative, bare, (scalar, derivation), derivation),
    Node(sp.Integral, with_limits, (scalar, limits), limits),
    Node(sp.Sum, with_limits, (scalar, finite_range), finite_range),
    Node(sp.Interval, bare, (scalar, scalar, truth_value, truth_value)),
    Node(sp.FiniteSet, elements, (operand,), operand),
    *[Node(cls, operands, (is_set,), is_set) for cls in (sp.Union, sp.Intersection)],
    Node(sp.Complement, bare, (is_set, is_set)),
    Node(sp.ProductSet, bare, (is_set,), is_set),
    Node(sp.ConditionSet, bare, (symbols, boolean, is_set)),
    Node(sp.ImageSet, bare, (is_lambda, is_set), is_set),
]
NODES = {row.cls.__name__: row for row in _ROWS}

ATOMS = {
    **{"pi": sp.pi, "E": sp.E, "I": sp.I, "oo": sp.oo, "-oo": -sp.oo, "zoo": sp.zoo, "nan": sp.nan},
    **{
        "GoldenRatio": sp.GoldenRatio,
        "EulerGamma": sp.EulerGamma,
        "True": sp.true,
        "False": sp.false,
    },
    **{
        "EmptySet": sp.S.EmptySet,
        "UniversalSet": sp.S.UniversalSet,
        "Reals": sp.S.Reals,
        "Complexes": sp.S.Complexes,
    },
    **{
        "Rationals": sp.S.Rationals,
        "Integers": sp.S.Integers,
        "Naturals": sp.S.Naturals,
        "Naturals0": sp.S.Naturals0,
    },
    "Identity": sp.S.IdentityFunction,
}
