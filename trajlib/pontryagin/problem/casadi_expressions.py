"""SymPy expressions as CasADi expressions, for speed and exact derivatives."""

from functools import reduce

import sympy as sp

from trajlib._lazy import casadi as ca

_UNARY = {
    sp.exp: "exp",
    sp.log: "log",
    sp.sin: "sin",
    sp.cos: "cos",
    sp.tan: "tan",
    sp.asin: "asin",
    sp.acos: "acos",
    sp.atan: "atan",
    sp.sinh: "sinh",
    sp.cosh: "cosh",
    sp.tanh: "tanh",
    sp.asinh: "asinh",
    sp.acosh: "acosh",
    sp.atanh: "atanh",
    sp.Abs: "fabs",
    sp.sign: "sign",
    sp.erf: "erf",
    sp.floor: "floor",
    sp.ceiling: "ceil",
}
_RELATIONS = {
    sp.StrictLessThan: "lt",
    sp.LessThan: "le",
    sp.Equality: "eq",
    sp.Unequality: "ne",
}


def to_casadi(expressions, table):
    """Translate SymPy expressions to a list of CasADi expressions.

    `table` is {SymPy symbol: CasADi expression}. Equal subexpressions become one node. Raises
    ValueError for a function that CasADi does not have.
    """
    translated = dict(table)

    def walk(e):
        if e not in translated:
            translated[e] = _node(e, walk)
        return translated[e]

    return [walk(sp.sympify(e)) for e in expressions]


def _node(e, walk):
    if e.is_number and e.is_extended_real:
        return ca.SX(float(e))
    if e.is_Add:
        return reduce(lambda a, b: a + b, map(walk, e.args))
    if e.is_Mul:
        # Divisions stay divisions: a*b**(-1) would round twice.
        numerator, denominator = (
            e.as_numer_denom() if any(_is_inverse(a) for a in e.args) else (e, sp.S.One)
        )
        if denominator != 1 and numerator != e:
            return walk(numerator) / walk(denominator)
        return reduce(lambda a, b: a * b, map(walk, e.args))
    if e.is_Pow:
        return _power(walk(e.base), e.exp, walk)
    if isinstance(e, (sp.Max, sp.Min)):
        return reduce(ca.fmax if isinstance(e, sp.Max) else ca.fmin, map(walk, e.args))
    if isinstance(e, sp.atan2):
        return ca.atan2(*map(walk, e.args))
    if isinstance(e, sp.Heaviside):
        return ca.heaviside(walk(e.args[0]))
    if isinstance(e, sp.Piecewise):
        value = ca.SX(ca.nan) if e.args[-1].cond != sp.true else walk(e.args[-1].expr)
        for piece in reversed(e.args[:-1] if e.args[-1].cond == sp.true else e.args):
            value = ca.if_else(_condition(piece.cond, walk), walk(piece.expr), value)
        return value
    if type(e) in _UNARY:
        return getattr(ca, _UNARY[type(e)])(walk(e.args[0]))
    if e.is_Symbol:
        raise ValueError(f"{e} has no value; give one by problem.subs({{{e}: ...}})")
    raise ValueError(f"{e}: this function is not known to the numerical methods")


def _is_inverse(e):
    return e.is_Pow and e.exp.is_number and e.exp.is_negative


def _power(base, exponent, walk):
    if exponent == sp.Rational(1, 2):
        return ca.sqrt(base)
    if exponent.is_Integer and exponent < 0:
        return 1 / (base if exponent == -1 else base ** int(-exponent))
    return base ** int(exponent) if exponent.is_Integer else base ** walk(exponent)


def _condition(cond, walk):
    if isinstance(cond, (sp.And, sp.Or)):
        join = ca.logic_and if isinstance(cond, sp.And) else ca.logic_or
        return reduce(join, (_condition(c, walk) for c in cond.args))
    if isinstance(cond, sp.Not):
        return ca.logic_not(_condition(cond.args[0], walk))
    if cond in (sp.true, sp.false):
        return ca.SX(1.0 if cond == sp.true else 0.0)
    cond = cond.canonical if not isinstance(cond, (sp.Equality, sp.Unequality)) else cond
    if isinstance(cond, (sp.GreaterThan, sp.StrictGreaterThan)):
        cond = cond.reversed
    return getattr(ca, _RELATIONS[type(cond)])(walk(cond.lhs), walk(cond.rhs))
