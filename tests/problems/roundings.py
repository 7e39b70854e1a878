"""Reference answers with their awkward numbers in decimals.

Rounded they are right, one per cent off they are not. A number is awkward if two digits do not give
it: a root, pi, a third. The numbers in a product are one, its coefficient. Whole numbers stay, and
so do exponents.
"""

import sympy as sp

#: How many of its numbers are changed in one answer, one after the other.
MOST = 2


def roundings(value):
    """Yield (description, answer, verdict due); nothing for an answer without awkward numbers."""
    awkward = list(dict.fromkeys(awkward_numbers(value)))
    for digits in (3, 4, 6) if awkward else ():
        yield (
            f"{digits} digits",
            with_numbers(value, {n: sp.Float(f"{float(n):.{digits - 1}e}") for n in awkward}),
            "right",
        )
    for number in awkward[:MOST]:
        off = sp.Float(f"{1.01 * float(number):.3e}")
        yield f"{number} one per cent larger", with_numbers(value, {number: off}), "wrong"


def awkward_numbers(value):
    if isinstance(value, (list, tuple)):
        for part in value:
            yield from awkward_numbers(part)
    elif isinstance(value, dict):
        yield from awkward_numbers([*value, *value.values()])
    elif isinstance(value, sp.MatrixBase):
        yield from awkward_numbers(list(value))
    elif isinstance(value, sp.Expr) and value.is_number:
        if _awkward(value):
            yield value
    elif isinstance(value, sp.Pow):
        yield from awkward_numbers(value.base)
    elif isinstance(value, sp.Mul):
        yield from awkward_numbers(list(_distributed(value) or _product(value)))
    elif isinstance(value, sp.Add):
        yield from awkward_numbers(_collected(value) or list(value.args))
    elif isinstance(value, sp.Basic):
        yield from awkward_numbers(value.args)


def _awkward(number):
    return bool(
        number.is_real
        and number.is_finite
        and not number.is_integer
        and float(number) != float(f"{float(number):.1e}")
    )


def _collected(value):
    """Return the terms of a sum with those added up that SymPy adds if their numbers are decimals."""
    coefficients = {}
    terms = [part for term in value.args for part in _flat(term)]
    for term in terms:
        number, rest = term.as_independent(*term.free_symbols, as_Add=False)
        coefficients[rest] = coefficients.get(rest, 0) + number
    fewer = len(coefficients) < len(terms)
    return [number * rest for rest, number in coefficients.items()] if fewer else []


def _flat(term):
    """Return the terms that SymPy makes of one with decimals."""
    return [part for one in _distributed(term) for part in _flat(one)] or [term]


def _distributed(value):
    """Return the terms of a number times a sum, which SymPy makes of it if the number is a decimal."""
    number, others = value.as_independent(*value.free_symbols, as_Add=False)
    return [number * term for term in others.args] if others.is_Add and number not in (0, 1) else []


def _product(value):
    """Return the coefficient of a product without its sign, and its other factors."""
    numbers = [factor for factor in value.args if factor.is_number]
    others, coefficient = [f for f in value.args if f not in numbers], sp.Mul(*numbers)
    negative = coefficient.could_extract_minus_sign()
    return (-coefficient, -1, *others) if negative else (coefficient, *others)


def with_numbers(value, decimals):
    if isinstance(value, (list, tuple)):
        return type(value)(with_numbers(part, decimals) for part in value)
    if isinstance(value, dict):
        return {
            with_numbers(key, decimals): with_numbers(part, decimals) for key, part in value.items()
        }
    if isinstance(value, sp.MatrixBase):
        return value.applyfunc(lambda entry: with_numbers(entry, decimals))
    if not isinstance(value, sp.Basic) or value in decimals:
        return decimals.get(value, value) if isinstance(value, sp.Basic) else value
    if (isinstance(value, sp.Expr) and value.is_number) or not value.args:
        return value
    if isinstance(value, sp.Pow):
        return sp.Pow(with_numbers(value.base, decimals), value.exp)
    terms = _distributed(value) if isinstance(value, sp.Mul) else ()
    terms = _collected(value) if isinstance(value, sp.Add) else terms
    if terms:
        return sp.Add(*(with_numbers(term, decimals) for term in terms))
    if isinstance(value, sp.Mul):
        return sp.Mul(*(with_numbers(factor, decimals) for factor in _product(value)))
    return value.func(*(with_numbers(part, decimals) for part in value.args))
