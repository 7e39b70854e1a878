"""Strict inequalities, written as short as they can be shown to be.

`positive(e)` is the condition e > 0 with everything of known sign divided out; `conjunction` joins
such conditions and leaves out those that follow from the others.
"""

import itertools

import sympy as sp

from trajlib.stability.strict_inequalities import TooLarge, solution_point


def sign_of(expression):
    """Return 1, 0 or -1 where the assumptions decide the sign of an expression, else None."""
    for form in (expression, sp.factor(expression)):
        if form.is_zero:
            return 0
        if form.is_positive:
            return 1
        if form.is_negative:
            return -1
    return None


def sign_factors(expression):
    """Split an expression into (constant sign, odd factors, even factors) of the same sign.

    An odd factor is an irreducible polynomial of odd multiplicity (in numerator or denominator), an
    even one can only turn the expression to zero. Factors of known sign are taken out.
    """
    sign, odd, even = 1, {}, []
    todo = [expression]
    while todo:
        numerator, denominator = sp.fraction(sp.together(todo.pop()))
        for part in (*sp.Mul.make_args(numerator), *sp.Mul.make_args(denominator)):
            if (inner := _same_sign(part)) is not part:
                todo.append(inner)
                continue
            content, factors = sp.factor_list(part) if part.free_symbols else (part, [])
            sign *= sign_of(content)
            for factor, multiplicity in factors:
                factor_sign = sign_of(factor)
                if factor_sign:
                    sign *= factor_sign**multiplicity
                elif multiplicity % 2 == 0 or isinstance(factor, sp.Abs):
                    even.append(factor.args[0] if isinstance(factor, sp.Abs) else factor)
                elif (inner := _same_sign(factor)) is not factor:
                    todo.append(inner)
                else:
                    odd[factor] = odd.get(factor, 0) + 1
    # The same factor above and below the line is a square.
    even += [f for f, times in odd.items() if times % 2 == 0]
    return sign, [f for f, times in odd.items() if times % 2], even


def _same_sign(factor):
    """Return e for sqrt(e), asin(e) and atan(e), which have its sign wherever they are defined."""
    while isinstance(factor, (sp.asin, sp.atan)) or (
        isinstance(factor, sp.Pow)
        and factor.exp.is_positive is True
        and factor.exp.is_Rational
        and factor.exp.q % 2 == 0
    ):
        factor = factor.args[0]
    return factor


def positive(expression):
    """Return the condition expression > 0, reduced; no value that is not real is positive."""
    if expression.has(sp.I):
        return sp.false
    sign, odd, even = sign_factors(expression)
    if sign == 0:
        return sp.false
    nonzero = [sp.Ne(f, 0) for f in even]
    if not odd:
        return sp.And(*nonzero) if sign > 0 else sp.false
    product = sign * sp.Mul(*odd)
    symbols = product.free_symbols
    if len(symbols) == 1 and not nonzero:
        (symbol,) = symbols
        if product.is_polynomial(symbol) and sp.Poly(product, symbol).domain in (sp.ZZ, sp.QQ):
            return intervals([sp.Poly(product, symbol)], symbol)
    return sp.And(written(product), *nonzero)


def nonnegative(expression):
    """Return the condition expression >= 0, reduced."""
    if expression.has(sp.I):
        return sp.false
    numerator, denominator = sp.fraction(sp.together(expression))
    sign, odd, even = sign_factors(numerator)
    if sign == 0:
        return sp.true
    if not odd and not even:
        return positive(expression)
    strict = positive(expression)
    if strict is sp.true:
        return sp.true
    zero = [sp.Eq(f, 0) for f in (*odd, *even)]
    if isinstance(strict, (sp.Gt, sp.Lt)) and sign_of(denominator):
        return sp.Ge(*strict.args) if isinstance(strict, sp.Gt) else sp.Le(*strict.args)
    if (
        isinstance(strict, sp.And)
        and sign_of(denominator)
        and all(isinstance(c, (sp.Gt, sp.Lt)) for c in strict.args)
    ):
        return sp.And(
            *(sp.Ge(*c.args) if isinstance(c, sp.Gt) else sp.Le(*c.args) for c in strict.args)
        )
    if strict is sp.false and not any(f.free_symbols for f in (*odd, *even)):
        return sp.false
    return sp.Or(strict, sp.And(sp.Or(*zero), sp.Ne(denominator, 0)))


def nonzero(expression):
    """Return the condition expression != 0, factor by factor."""
    sign, odd, even = sign_factors(expression)
    return sp.And(*(sp.Ne(f, 0) for f in (*odd, *even))) if sign else sp.false


def without_implied(condition):
    """Drop f != 0 from a conjunction that also has f > 0 or f < 0."""
    if not isinstance(condition, sp.And):
        return condition
    strict = {
        sp.expand(sign * (c.lhs - c.rhs))
        for c in condition.args
        if isinstance(c, (sp.Gt, sp.Lt))
        for sign in (1, -1)
    }
    return sp.And(
        *(
            c
            for c in condition.args
            if not (isinstance(c, sp.Ne) and sp.expand(c.lhs - c.rhs) in strict)
        )
    )


def tidied(condition):
    """Return a condition in its shortest form; in one symbol, the set of its values."""
    if condition in (sp.true, sp.false):
        return condition
    if len(condition.free_symbols) == 1:
        (symbol,) = condition.free_symbols
        relations = condition.atoms(sp.core.relational.Relational)
        if all(r.lhs.is_polynomial(symbol) and r.rhs.is_polynomial(symbol) for r in relations):
            return _in_one_symbol(condition, symbol)
    return without_implied(condition).simplify()


def _in_one_symbol(condition, symbol):
    real = sp.Dummy(real=True)
    values = condition.xreplace({symbol: real}).as_set()
    if symbol.is_positive:
        values &= sp.Interval.open(0, sp.oo)
    elif symbol.is_negative:
        values &= sp.Interval.open(-sp.oo, 0)
    pieces = []
    for piece in values.args if isinstance(values, sp.Union) else (values,):
        if isinstance(piece, sp.FiniteSet):
            pieces += [sp.Eq(symbol, v) for v in piece]
        elif isinstance(piece, sp.Interval):
            pieces.append(
                _between(symbol, piece.start, piece.end, piece.left_open, piece.right_open)
            )
        elif piece is not sp.S.EmptySet:
            return condition
    return sp.Or(*pieces)


def intervals(polys, symbol):
    """Return the values of `symbol` for which rational polynomials are all positive."""
    roots = sorted({r for p in polys for r in p.real_roots()}, key=lambda r: r.evalf(30))
    ends = [-sp.oo, *roots, sp.oo]
    return sp.Or(
        *(
            _between(symbol, low, high, True, True)
            for low, high in itertools.pairwise(ends)
            if all(p(_inside(low, high)) > 0 for p in polys)
        )
    )


def _between(symbol, low, high, left_open, right_open):
    """Return low < symbol < high without the parts that its assumptions imply."""
    if (high <= 0 and symbol.is_positive) or (low >= 0 and symbol.is_negative):
        return sp.false
    above = (
        sp.true
        if low == -sp.oo or (low <= 0 and symbol.is_positive)
        else symbol > low
        if left_open
        else symbol >= low
    )
    below = (
        sp.true
        if high == sp.oo or (high >= 0 and symbol.is_negative)
        else symbol < high
        if right_open
        else symbol <= high
    )
    return sp.And(above, below)


def _inside(low, high):
    """Return a rational number between two real numbers or infinities."""
    if low == -sp.oo:
        return sp.Integer(0) if high == sp.oo else sp.floor(high) - 1
    if high == sp.oo:
        return sp.ceiling(low) + 1
    digits = 15
    while True:
        middle = sp.Rational(str(((low + high) / 2).evalf(digits)))
        if low < middle < high:
            return middle
        digits *= 2


def written(polynomial):
    """Return polynomial > 0 with negative terms moved: k1*k2 > 1, not k1*k2 - 1 > 0."""
    left, right = _sides(polynomial)
    return _divided(left, right, sp.Gt) if left.free_symbols else _divided(right, left, sp.Lt)


def equation(polynomial):
    """Return polynomial = 0, written as Eq(8*b, u**2) rather than Eq(8*b - u**2, 0)."""
    left, right = _sides(polynomial)
    return sp.Eq(left, right) if left.free_symbols else sp.Eq(right, left)


def _sides(polynomial):
    """Return the positive and the negative terms; a constant joins an empty side."""
    _, polynomial = sp.expand(polynomial).as_content_primitive()
    constant, polynomial_part = polynomial.as_independent(*polynomial.free_symbols, as_Add=True)
    terms = sp.Add.make_args(polynomial_part)
    left = sp.Add(*[t for t in terms if not t.could_extract_minus_sign()])
    right = sp.Add(*[-t for t in terms if t.could_extract_minus_sign()])
    if left == 0:
        return constant, right
    if right == 0:
        return left, -constant
    return (left + constant, right) if constant > 0 else (left, right - constant)


def _divided(varying, opposite, relation):
    """Return k > 3/2 for 2*k > 3."""
    content, varying = varying.as_content_primitive()
    return (
        relation(varying, opposite / content)
        if not opposite.free_symbols
        else relation(content * varying, opposite)
    )


def conjunction(expressions, symbols):
    """Return the reduced condition that all expressions are positive, and if it is decided.

    The condition is `sp.false` if the set can be shown to be empty; the second value is False where
    emptiness could not be decided.
    """
    factored = [sign_factors(e) for e in expressions]
    if any(sign == 0 or (sign < 0 and not odd) for sign, odd, _ in factored):
        return sp.false, True
    nonzero = [sp.Ne(f, 0) for _, _, even in factored for f in even]
    products = _divide_by_known([(sign, frozenset(odd)) for sign, odd, _ in factored if odd])
    if products is None:
        return sp.false, True
    polys = [sign * sp.Mul(*odd) for sign, odd in products]
    if not polys:
        return sp.And(*nonzero), not nonzero
    free = set().union(*(p.free_symbols for p in polys))
    if len(free) == 1 and all(
        p.is_polynomial() and sp.Poly(p).domain in (sp.ZZ, sp.QQ) for p in polys
    ):
        (symbol,) = free
        return sp.And(intervals([sp.Poly(p, symbol) for p in polys], symbol), *nonzero), not nonzero
    decided = True
    try:
        if solution_point(polys, symbols) is None:
            return sp.false, True
    except TooLarge:
        decided = False
    if decided:
        polys = _without_redundant(polys, symbols)
    return sp.And(*(positive(p) for p in polys), *nonzero), decided


def _divide_by_known(products):
    """Divide every product by those factors that another condition makes positive or negative.

    Works on pairs (sign, set of irreducible factors); returns None on a contradiction.
    """
    products = list(dict.fromkeys(products))
    changed = True
    while changed:
        changed = False
        for sign, factors in [p for p in products if len(p[1]) == 1]:
            (factor,) = factors
            if (-sign, factors) in products:
                return None
            for i, (other_sign, other_factors) in enumerate(products):
                if factor in other_factors and len(other_factors) > 1:
                    products[i] = (other_sign * sign, other_factors - factors)
                    changed = True
        products = list(dict.fromkeys(products))
    return products


def _without_redundant(polys, symbols):
    """Leave out conditions p > 0 that follow from the others; the longest first."""
    needed = list(polys)
    for p in sorted(polys, key=lambda q: -q.count_ops()):
        remaining = [q for q in needed if q is not p]
        # Where the others hold p is nowhere negative; it may still touch zero, but only where its
        # gradient vanishes.
        try:
            if (
                remaining
                and not _has_singular_zero(p)
                and solution_point([*remaining, -p], symbols) is None
            ):
                needed = remaining
        except TooLarge:
            continue
    return needed


def _has_singular_zero(p):
    """Whether p = 0, grad p = 0 may have a common solution, also a complex one."""
    symbols = sorted(p.free_symbols, key=str)
    basis = sp.groebner([p, *(sp.diff(p, s) for s in symbols)], *symbols, order="grevlex")
    return basis.exprs != [1]
