"""Bounds on the size of an expression without evaluating it: 10**10**9 costs no more than 10**9.

A number is measured as it is, what has symbols where these are 8 or 1/8. There towers of powers
grow already beyond what any value can be computed for: a value of exp or of a sine takes arithmetic
of as many bits as its argument has, and powers and factorials of fractions are written out.
"""

import math

import sympy as sp

MAX_EXPONENT = 4_096  # a number as exponent
SYMBOL_BITS = 3  # size of a symbol
INNER_BITS = 1_000  # size of what stands in exp or in a sine
_EXPONENTIAL = (sp.exp, sp.sinh, sp.cosh, sp.sech, sp.csch)
_PERIODIC = (sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc)
_FACTORIAL = (sp.factorial, sp.gamma, sp.binomial)


def size(node, sizes):
    """Return bounds on log2 of the absolute value of a node.

    Parameters
    ----------
    node : sympy.Expr
        Any expression.
    sizes : dict
        Sizes of subexpressions computed before; it is extended.

    Returns
    -------
    tuple
        (up, down, whether it has symbols) with -down <= log2 |node| <= up, unless a sum cancels.
    """
    if node not in sizes:
        sizes[node] = _measure(node, sizes)
    return sizes[node]


def grows_too_fast(node, bits=SYMBOL_BITS):
    """Return whether a part of an expression or condition is too large to be computed with.

    Parameters
    ----------
    node : sympy.Basic
        The expression or condition.
    bits : int
        The size of its symbols: they are 2**bits or 2**-bits.
    """
    sizes = dict.fromkeys(node.free_symbols, (bits, bits, True))
    for part in node.atoms(sp.Integral, sp.Sum):  # their variables run up to the limits
        for variable, *limits in (limits for limits in part.limits if len(limits) > 1):
            ups, downs, _ = zip(*(size(limit, sizes) for limit in limits))
            sizes[variable] = max(SYMBOL_BITS, *ups), max(SYMBOL_BITS, *downs), True
    return any(
        not _inner(part, sizes) <= 1 and part.free_symbols for part in sp.preorder_traversal(node)
    )


def _inner(node, sizes):
    """Return the bits of an exponent, angle or argument of a factorial, relative to the limit."""
    if isinstance(node, sp.Pow) and node.base is not sp.E:
        return 0 if node.exp.is_Number else size(node.exp, sizes)[0] / math.log2(MAX_EXPONENT)
    if isinstance(node, _FACTORIAL):
        return max(size(arg, sizes)[0] for arg in node.args) / math.log2(MAX_EXPONENT)
    if isinstance(node, (sp.Pow, *_EXPONENTIAL, *_PERIODIC)):
        return size(node.args[-1], sizes)[0] / INNER_BITS
    return 0


def _measure(node, sizes):
    if node.is_Number:
        return log2(node), -log2(node), False
    if not node.args:
        # pi and the like
        return (2, 1, False) if node.is_number else (SYMBOL_BITS, SYMBOL_BITS, True)
    ups, downs, symbolic = zip(*(size(arg, sizes) for arg in node.args))
    return *_composed(node, ups, downs), any(symbolic)


def _composed(node, ups, downs):
    if isinstance(node, sp.Mul):
        return sum(ups), sum(downs)
    if isinstance(node, sp.Pow):
        return _size_of_power(node.exp, (ups[0], downs[0]), ups[1])
    if isinstance(node, _EXPONENTIAL):
        return (1.5 * _exp2(ups[0]),) * 2
    if isinstance(node, (sp.sin, sp.cos, sp.tanh)):
        return 0, max(downs)
    if isinstance(node, _FACTORIAL):
        return (_exp2(max(ups)) * max(1, *ups),) * 2
    if isinstance(node, sp.log):
        return (math.log2(1 + max(abs(ups[0]), abs(downs[0]))) + 1,) * 2
    return max(ups) + len(ups).bit_length(), max(downs)


def _size_of_power(exponent, base_size, exponent_up):
    n = _exp2(exponent_up)
    up, down = base_size
    if not exponent.is_Number:
        return (n * max(up, down, 1),) * 2
    return (n * down, n * up) if exponent.is_negative else (n * up, n * down)


def log2(number):
    """Return log2 |number|; 0 for zero, nan and the infinities."""
    if number.is_Rational and number.p:
        return math.log2(abs(number.p)) - math.log2(number.q)
    if number.is_Float and number._mpf_[1]:
        return int(number._mpf_[2]) + number._mpf_[3]
    return 0.0


def _exp2(x):
    return 2.0**x if x < 1_000 else math.inf
