"""Answers with symbols, judged at values of them: what an expression or a condition becomes there,
and whether it is what it should be.

A comparison with nan is False, so one that looks for a difference finds none. Hence what comes from
an answer is read here, and no number leaves that is not finite: an answer that is undefined or
infinite where it should have a value is `Wrong`, with the place. Only `real_function` gives nan, to
be used on whole arrays; a check compares such values by `not difference <= tolerance`.
"""

import builtins
import cmath
import dis
import functools
from contextlib import suppress

import mpmath
import numpy as np
import sympy as sp

from workbook.checks.contract.coercion import LARGEST, MOST_ADDED
from workbook.checks.contract.tolerance import DECIMALS, half_unit, in_decimals, perturbed
from workbook.checks.contract.verdict import Invalid, Wrong
from workbook.checks.tools.wording import rounded_text

#: At how many places integrals are computed for one verdict.
MOST_INTEGRATED = 400
#: The digits to which a series is summed, and those of numbers of any size.
DIGITS, LONG = 25, 100


def number_at(claim, values, what="your expression"):
    """The finite number, real or complex, that an expression becomes; `what` names the expression
    in a message."""
    number = _put(claim, values)
    if number.free_symbols or not number.is_number:
        raise Invalid(f"{what} does not become a number when all symbols have values")
    try:
        found = complex(number)
    except TypeError:
        raise Invalid(
            f"{what} does not become a single number when all symbols have values"
        ) from None
    # Python's modulus of what is no number may raise: it minds an error of the computation before
    # it.
    if not (cmath.isfinite(found) and abs(found) < LARGEST):
        how = (
            "undefined"
            if cmath.isnan(found)
            else f"larger than {LARGEST:g}"
            if cmath.isfinite(found)
            else "infinite"
        )
        raise Wrong(
            f"{what} is {how}"
            + (
                f" at {rounded_text(values)}, where it should have a value"
                if values
                else "; it should have a value"
            )
        )
    return found


def numbers_at(claims, values, names=None):
    """The numbers that several expressions become, as a complex array; `names` are what they stand
    for, such as symbols."""
    names = [f"component {k}" for k in range(1, len(claims) + 1)] if names is None else names
    return np.array(
        [number_at(claim, values, f"your {name}") for name, claim in zip(names, claims)]
    )


def matrix_at(claim, values):
    """The numbers that a matrix becomes, as a complex array."""
    return np.array(
        [
            [
                number_at(claim[i, j], values, f"the entry ({i + 1}, {j + 1}) of your matrix")
                for j in range(claim.cols)
            ]
            for i in range(claim.rows)
        ]
    ).reshape(claim.shape)


def value_at(claim, values, what):
    """The real number that an expression becomes; `what` says of which quantity, for a message."""
    number = number_at(claim, values, f"your expression for {what}")
    if abs(number.imag) > 1e-12 * (1 + abs(number)):
        raise Wrong(f"for {rounded_text(values)} your expression gives no real number for {what}")
    return number.real


def values_at_all(claim, places, what):
    """The same at many places, dicts from the same symbols to real numbers: all at once, in the
    digits of floats."""
    if _binds(claim) or not places[0]:
        return [value_at(claim, values, what) for values in places]
    numbers = np.array([[float(value) for value in values.values()] for values in places]).T
    found = np.broadcast_to(real_function(list(places[0]), [claim])(*numbers)[0], len(places))
    return [
        number if np.isfinite(number) else value_at(claim, values, what)
        for values, number in zip(places, found)
    ]


def uncertain_at(claim, values):
    """By how much the decimals of an expression leave open what it becomes; nan where that cannot
    be followed."""
    followed = perturbed(claim) if in_decimals(claim) and sp.sympify(claim).free_symbols else None
    if followed is None:
        return np.nan
    try:
        here = complex(_put(claim, values))
        return sum(
            max(abs(complex(_put(part, values)) - here) for (part,) in sides) for sides in followed
        )
    except TypeError:
        return np.nan


def uncertain_at_all(claim, places):
    """The same at many places, dicts from the same symbols to real numbers: all of them at once."""
    symbols = list(places[0])
    if not (in_decimals(claim) and claim.free_symbols) or _binds(claim):
        return [uncertain_at(claim, values) for values in places]
    followed = perturbed(claim)
    if followed is None:
        return [np.nan] * len(places)
    numbers = np.array([[float(values[s]) for s in symbols] for values in places]).T
    here, *sides = real_function(
        symbols, [claim, *(part for pair in followed for (part,) in pair)]
    )(*numbers)
    return sum(
        (
            np.fmax(abs(one - here), abs(other - here))
            for one, other in zip(sides[::2], sides[1::2])
        ),
        np.zeros(len(places)),
    )


def uncertain_entries(claim, values):
    """By how much its decimals leave open each entry of a matrix of expressions; zero where there
    are none."""

    def entry(part):
        if not in_decimals(part):
            return 0.0
        if not part.free_symbols:
            return half_unit(abs(number_at(part, values)))
        known = uncertain_at(part, values)
        return known if np.isfinite(known) else DECIMALS * abs(number_at(part, values))

    return np.array(
        [[entry(claim[i, j]) for j in range(claim.cols)] for i in range(claim.rows)]
    ).reshape(claim.shape)


def moved(parts, left_open):
    """The arrays `parts` with one entry larger by what is left open of it, for each entry that is
    not exact."""
    for k, open_ in enumerate(left_open):
        for place in zip(*np.nonzero(open_)):
            other = parts[k].copy()
            other[place] += open_[place]
            yield (*parts[:k], other, *parts[k + 1 :])


def real_at(claim, values):
    """The real number that an expression becomes, or None where it is not real, or not defined."""
    try:
        number = complex(_put(claim, values))
    except TypeError:
        return None
    within = cmath.isfinite(number) and abs(number) < LARGEST
    return number.real if within and abs(number.imag) < 1e-12 * (1 + abs(number)) else None


def truth_at(claim, values):
    """Whether a condition holds; where a term of it is undefined it does not."""
    try:
        said = at_once(claim, values)
    except TypeError:  # it asks which of two numbers is greater, and one is not real
        return False
    if said not in (sp.true, sp.false):
        raise Invalid("the condition does not become true or false when all symbols have values")
    return bool(said)


def real_function(symbols, expressions):
    """Several expressions as a function of numbers or arrays, to an array with a row for each; nan
    where one is not a real number."""
    # Only SymPy functions of the data's own symbols come here (coercion.with_symbols), so the code
    # made is ours. A docstring would take as long as the code.
    compiled = [_compiled(symbols, e) for e in expressions]

    def one(function, numbers, shape):
        try:
            values = function(*numbers)
            # the way through arrays takes ten times as long, and a motion asks thousands of times
            if not shape:
                number = complex(values)
                return (
                    number.real
                    if cmath.isfinite(number) and abs(number.imag) < 1e-9 * (1 + abs(number))
                    else np.nan
                )
            if isinstance(values, np.ndarray) and values.dtype == float and values.shape == shape:
                return np.where(np.isfinite(values), values, np.nan)
            values = np.broadcast_to(np.asarray(values, dtype=complex), shape)
        except (ZeroDivisionError, OverflowError):  # of the numbers in the expression itself
            return np.full(shape, np.nan)
        except (TypeError, ValueError, AttributeError, NameError):
            raise Invalid(
                "your answer cannot be evaluated at numbers: write it with functions such as "
                "sqrt, sin, Abs, sign or Piecewise"
            ) from None
        return np.where(
            np.isfinite(values) & (abs(values.imag) < 1e-9 * (1 + abs(values))), values.real, np.nan
        )

    def evaluate(*numbers):
        # NumPy's numbers divide by zero without an error.
        numbers = [np.asarray(number, dtype=float)[()] for number in numbers]
        single = all(type(number) is np.float64 for number in numbers)
        shape = () if single else np.broadcast_shapes(*(number.shape for number in numbers))
        with np.errstate(all="ignore"):
            return np.array([one(function, numbers, shape) for function in compiled])

    return evaluate


def wide_function(symbols, expressions):
    """`real_function` one place after the other, in numbers of any size, with digits to spare.

    It is slow: to be asked where an answer would be wrong because floats on the way are too large,
    or all alike.
    """

    def evaluate(*numbers):
        places = [
            {s: sp.Float(number, LONG) for s, number in zip(symbols, place)}
            for place in np.broadcast(*numbers)
        ]
        return np.array(
            [[real_at(e, place) for place in places] for e in expressions], dtype=float
        ).reshape(len(expressions), *np.broadcast_shapes(*map(np.shape, numbers)))

    return evaluate


def is_slow(e):
    """Whether an expression holds an integral or a sum, and has to be computed one place after the
    other."""
    return e.has(sp.Integral, sp.Sum)


def _compiled(symbols, e):
    """One expression as a function of arrays: by NumPy, with SciPy's special functions where it has
    such ones."""
    for libraries in () if is_slow(e) else (["numpy"], ["scipy", "numpy"]):
        function = sp.lambdify(
            symbols, _printable(e), [{"select": _first_of}, *libraries], docstring_limit=0
        )
        known = {
            name: function.__globals__.get(name, getattr(builtins, name, None))
            for name in function.__code__.co_names
        }
        odd = {
            name
            for name, one in known.items()
            if one is None or getattr(one, "__module__", None) == "math"
        }
        # Some of these are attributes, as in `logical_and.reduce`.
        if not odd or not any(
            step.opname == "LOAD_GLOBAL" and step.argval in odd
            for step in dis.get_instructions(function)
        ):
            return function
    return _one_by_one(symbols, e)


def _one_by_one(symbols, e):
    """An expression with integrals, sums, or functions that neither NumPy nor SciPy knows, one
    place after the other; slow, so not for a law."""
    places = 0

    def value(*numbers):
        nonlocal places
        places += 1
        if places > MOST_INTEGRATED:
            raise Invalid(
                "your answer holds an integral, a sum or a special function and is asked for at "
                "many places; write it without"
            )
        found = real_at(e, dict(zip(symbols, map(sp.Float, numbers))))
        return np.nan if found is None else found

    return np.vectorize(value, otypes=[float])


def _printable(e):
    """The expression as SymPy makes code of it at once: a choice between conditions it would
    simplify first, for seconds."""
    if e.has(sp.nan, sp.zoo):
        return sp.nan
    if e.has(sp.Heaviside):
        e = e.rewrite(sp.Piecewise)
    return (
        e.replace(sp.ITE, lambda a, b, c: sp.Or(sp.And(a, b), sp.And(sp.Not(a), c)))
        if e.has(sp.ITE)
        else e
    )


def _first_of(conditions, values, default):
    """NumPy's `select`, which a Piecewise becomes, in a fraction of its time: a law is asked at a
    few states thousands of times."""
    found = default
    for condition, value in zip(conditions[::-1], values[::-1]):
        if not (isinstance(condition, bool) or condition.dtype == bool):
            raise TypeError("a case has to be given by a condition")
        found = np.where(condition, value, found)
    return found


def at_once(claim, values):
    """The condition with its values. `subs` puts them in one after the other and thinks about every
    step."""
    if _binds(claim):
        return claim.subs(values)
    return claim.xreplace({symbol: sp.sympify(value) for symbol, value in values.items()})


def _put(claim, values):
    """The claim with its values, evaluated; nan where this asks whether a number that is not real
    is greater than another."""
    claim = sp.sympify(claim)
    if not _binds(claim):
        # All values at once take a third of the time. What comes out finite is the number; where a
        # factor vanishes beside an infinite one, or a case that is not reached has no value, the
        # order matters and `subs` is asked.
        with suppress(TypeError, ValueError, AttributeError, ArithmeticError):
            numbers = {symbol: sp.sympify(value) for symbol, value in values.items()}
            number = _without_extremes(claim, numbers).xreplace(numbers).evalf(20)
            if cmath.isfinite(complex(number)):
                return number
    try:
        return _added(claim.subs(values)).evalf(20)
    except (TypeError, ValueError, ArithmeticError):
        # ValueError: the greater of two such numbers, in Max or Min; ArithmeticError: all digits of
        # a floor cancel.
        return sp.nan


def _without_extremes(claim, numbers):
    """The claim with that argument in the place of each Max and Min which clearly is the
    greatest or least with these numbers: SymPy compares exact ones, such as an angle with zero,
    by thinking."""
    chosen = {}
    # those within others first
    for part in sorted(claim.atoms(sp.Max, sp.Min), key=sp.count_ops):
        sign = 1 if isinstance(part, sp.Max) else -1
        sizes = {
            other: sign * complex(other.xreplace(numbers).evalf(20))
            for arg in part.args
            for other in [arg.xreplace(chosen)]
        }
        first, second, *_ = sorted(sizes, key=lambda arg: -sizes[arg].real)
        if not any(size.imag for size in sizes.values()) and (
            sizes[first] - sizes[second]
        ).real > 1e-9 * (1 + abs(sizes[first])):
            chosen[part] = first
    return claim.xreplace(chosen)


def _added(claim):
    """The claim with its sums added up term by term: what SymPy makes of a long one may take
    minutes."""

    def added(term, limits, *others):
        index, first, last = limits
        whole = not others and first.is_number and first == sp.floor(first)
        if whole and last is sp.oo:
            return _series(lambda k: term.xreplace({index: sp.Integer(int(k))}), int(first))
        if not (whole and last.is_number and last == sp.floor(last) and last - first < MOST_ADDED):
            raise Invalid(
                f"a sum is added up term by term, between whole numbers and up to {MOST_ADDED} "
                "terms; yours cannot be: write it without `sp.Sum`"
            )
        return sp.Add(
            *(term.xreplace({index: sp.Integer(k)}) for k in range(int(first), int(last) + 1))
        )

    return claim.replace(sp.Sum, added) if claim.has(sp.Sum) else claim


def _series(term, first):
    """The sum of the terms term(first), term(first + 1), ... by extrapolation. That would give a
    diverging series a sum too, so the terms have to fall faster than those of the harmonic one."""

    def number(k):
        # of which nsum wants more and more
        return mpmath.mpmathify(term(k).evalf(mpmath.mp.dps))

    with mpmath.workdps(DIGITS):
        near, far = (
            max(abs(number(first + count + k)) for k in range(8))
            for count in (MOST_ADDED // 4, MOST_ADDED // 2)
        )
        if not (far <= 0.48 * near or far == 0):
            raise Invalid(
                "your answer holds an infinite sum that does not converge fast enough to be "
                "computed: write it without `sp.Sum`"
            )
        return sp.sympify(mpmath.nsum(number, [first, mpmath.inf]))


@functools.lru_cache(maxsize=256)
def _binds(claim):
    """Whether the claim has symbols that are not to be replaced everywhere: an integral over one of
    them, say."""
    return any(
        getattr(part, "bound_symbols", None) or isinstance(part, sp.Derivative)
        for part in sp.preorder_traversal(claim)
    )
