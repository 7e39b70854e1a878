"""Values of answers with symbols at values of these symbols.

A comparison with nan is False, so one that looks for a difference finds none. Hence answers are
evaluated here, and no number is returned that is not finite: an answer that is undefined or infinite
where it should have a value is `Wrong`, with the point. Only `real_function` returns nan, to be used
on whole arrays; a check compares such values by `not difference <= tolerance`.
"""

import cmath

import numpy as np
import sympy as sp

from workbook.checks.contract.coercion import LARGEST
from workbook.checks.contract.tolerance import (
    DECIMALS,
    MOST_EVALUATED,
    half_unit,
    in_decimals,
    perturbed,
)
from workbook.checks.contract.verdict import Invalid, Wrong
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.substitution import binds_symbols, evaluated, substituted
from workbook.checks.tools.wording import rounded_text


def number_at(claim, values, name="your expression"):
    """Return the finite number, real or complex, of an expression at values of its symbols.

    Parameters
    ----------
    claim : sympy.Expr
        The expression.
    values : dict
        {symbol: value}.
    name : str
        Its name in a message.

    Raises
    ------
    Invalid
        If it does not become a number.
    Wrong
        If it is undefined or infinite there.
    """
    number = evaluated(claim, values)
    if number.free_symbols or not number.is_number:
        raise Invalid(f"{name} does not become a number when all symbols have values")
    try:
        value = complex(number)
    except TypeError:
        raise Invalid(
            f"{name} does not become a single number when all symbols have values"
        ) from None
    # Finiteness first: abs of a complex nan may raise the OverflowError of an earlier operation.
    if not (cmath.isfinite(value) and abs(value) < LARGEST):
        failure = (
            "undefined"
            if cmath.isnan(value)
            else "infinite"
            if number.has(sp.oo, -sp.oo, sp.zoo)
            else f"larger than {LARGEST:g}"
        )
        raise Wrong(
            f"{name} is {failure}"
            + (
                f" at {rounded_text(values)}, where it should have a value"
                if values
                else "; it should have a value"
            )
        )
    return value


def numbers_at(claims, values, names=None):
    """Return the numbers that several expressions become, as a complex array.

    Parameters
    ----------
    claims : list of sympy.Expr
        The expressions.
    values : dict
        {symbol: value}.
    names : list, optional
        What they stand for, such as symbols, for messages.
    """
    names = [f"component {k}" for k in range(1, len(claims) + 1)] if names is None else names
    return np.array(
        [number_at(claim, values, f"your {name}") for name, claim in zip(names, claims)]
    )


def matrix_at(claim, values):
    """Return the numbers that a matrix becomes, as a complex array."""
    return np.array(
        [
            [
                number_at(claim[i, j], values, f"the entry ({i + 1}, {j + 1}) of your matrix")
                for j in range(claim.cols)
            ]
            for i in range(claim.rows)
        ]
    ).reshape(claim.shape)


def value_at(claim, values, quantity):
    """Return the real number that an expression becomes; `quantity` is its name, for a message."""
    number = number_at(claim, values, f"your expression for {quantity}")
    if abs(number.imag) > 1e-12 * (1 + abs(number)):
        raise Wrong(
            f"for {rounded_text(values)} your expression gives no real number for {quantity}"
        )
    return number.real


def values_at(claim, points, quantity):
    """Return the real numbers of an expression at many points, all at once in floats.

    Parameters
    ----------
    claim : sympy.Expr
        The expression.
    points : list of dict
        {symbol: real number} each, of the same symbols.
    quantity : str
        The quantity, for a message.
    """
    if binds_symbols(claim) or not points[0]:
        return [value_at(claim, values, quantity) for values in points]
    numbers = np.array([[float(value) for value in values.values()] for values in points]).T
    numbers_found = np.broadcast_to(
        real_function(list(points[0]), [claim])(*numbers)[0], len(points)
    )
    return [
        number if np.isfinite(number) else value_at(claim, values, quantity)
        for values, number in zip(points, numbers_found)
    ]


def no_number_text(claim, values):
    """Return why an expression has no usable value: it is too large, or no real number."""
    number = evaluated(claim, values)
    if number.is_number and number.is_extended_real and abs(number) > LARGEST:
        return "too large to be computed with"
    return "no real number, or not defined"


def uncertainty_at(claim, values):
    """Return by how much the decimals of an expression change its value; nan if not known."""
    variants = (
        perturbed(claim, max_count=MOST_EVALUATED)
        if in_decimals(claim) and sp.sympify(claim).free_symbols
        else None
    )
    if variants is None:
        return np.nan
    try:
        value = complex(evaluated(claim, values))
        return sum(
            max(abs(complex(evaluated(part, values)) - value) for (part,) in sides)
            for sides in variants
        )
    except TypeError:
        return np.nan


def uncertainties_at(claim, points):
    """Return `uncertainty_at` at many points, dicts of the same symbols, all at once."""
    if not points:
        return []
    symbols = list(points[0])
    if not (in_decimals(claim) and claim.free_symbols) or binds_symbols(claim):
        return [uncertainty_at(claim, values) for values in points]
    variants = perturbed(claim, max_count=MOST_EVALUATED)
    if variants is None:
        return [np.nan] * len(points)
    numbers = np.array([[float(values[s]) for s in symbols] for values in points]).T
    unperturbed, *sides = real_function(
        symbols, [claim, *(part for pair in variants for (part,) in pair)]
    )(*numbers)
    return summed_changes(unperturbed, zip(sides[::2], sides[1::2]))


def entry_uncertainties(claim, values):
    """Return by how much its decimals change each entry of a matrix; zero without decimals."""

    def entry(part):
        if not in_decimals(part):
            return 0.0
        if not part.free_symbols:
            return half_unit(abs(number_at(part, values)))
        uncertainty = uncertainty_at(part, values)
        return uncertainty if np.isfinite(uncertainty) else DECIMALS * abs(number_at(part, values))

    return np.array(
        [[entry(claim[i, j]) for j in range(claim.cols)] for i in range(claim.rows)]
    ).reshape(claim.shape)


def left_open(claims, quantity):
    """Return by how much the decimals of answers leave open a quantity that depends on them.

    Parameters
    ----------
    claims : list of sympy.Basic
        The answers.
    quantity : callable
        `quantity(claims)` is a number or an array.

    Returns
    -------
    float or numpy.ndarray
        The sum over the decimals.

    Raises
    ------
    Invalid
        If there are too many decimals to be followed.
    """
    followed = perturbed(*claims, max_count=MOST_EVALUATED) if in_decimals(*claims) else []
    if followed is None:
        raise Invalid("your answer holds more decimals than can be followed; write exact numbers")
    value = quantity(claims) if followed else 0.0
    return summed_changes(value, ((quantity(side) for side in pair) for pair in followed))


def summed_changes(value, pairs):
    """Return the sum, over pairs, of the larger distance of the two from a value."""
    changes = (np.fmax(*(abs(side - value) for side in pair)) for pair in pairs)
    return sum(changes, np.zeros(np.shape(value)))


def perturbed_arrays(parts, left_open):
    """Yield the arrays with one entry larger by its uncertainty, for each inexact entry."""
    for k, uncertainty in enumerate(left_open):
        for index in zip(*np.nonzero(uncertainty)):
            perturbed_part = parts[k].copy()
            perturbed_part[index] += uncertainty[index]
            yield (*parts[:k], perturbed_part, *parts[k + 1 :])


def truth_at(claim, values):
    """Return whether a condition holds; where a term of it is undefined it does not."""
    try:
        outcome = substituted(claim, values)
    except TypeError:  # it asks which of two numbers is greater, and one is not real
        return False
    if outcome not in (sp.true, sp.false):
        raise Invalid("the condition does not become true or false when all symbols have values")
    return bool(outcome)
