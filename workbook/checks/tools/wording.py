"""How messages write numbers and the values of symbols."""

import math


def number_text(number):
    """A real or complex number for a message: `0.5`, `-1 + 2i`."""
    z = complex(number)
    return (
        f"{z.real:.4g}"
        if abs(z.imag) < 1e-12 * (1 + abs(z))
        else f"{z.real:.4g} {'+' if z.imag > 0 else '-'} {abs(z.imag):.4g}i"
    )


def apart(*numbers):
    """Different real numbers for a message, with as many digits, four at least, as tell them
    apart."""
    told = [f"{number:.4g}" for number in numbers]
    for digits in range(5, 16):
        if len(set(told)) > 1:
            break
        told = [f"{number:.{digits}g}" for number in numbers]
    return told


def roots_text(roots):
    """The roots of an equation for a message; what rounding leaves of a zero imaginary part is
    none."""
    return " and ".join(
        number_text(z.real if abs(z.imag) < 1e-9 * (1 + abs(z)) else z) for z in map(complex, roots)
    )


def values_text(values):
    """Values of symbols for a message: `k = 1/3, omega = 2`, in decimals where they are no simple
    fractions."""
    return ", ".join(
        f"{symbol} = {x if x.is_Rational and x.q < 1000 else f'{float(x):.6g}'}"
        for symbol, x in values.items()
    )


def entry_text(said, i, j):
    """Where a matrix is wrong and what it says there; of a single number only that."""
    place = "yours" if said.size == 1 else f"look at the entry ({i + 1}, {j + 1}), where yours"
    return f"{place} is {number_text(said[i, j])}"


def part_text(what, said, i):
    """What is wrong in a column: `component 2 of your estimate is 0.5`; of a single number `your
    estimate is 0.5`."""
    return (
        f"component {i + 1} of " if said.size > 1 else ""
    ) + f"your {what} is {number_text(said[i, 0])}"


def where_text(values):
    """The values of a sample for the end of a message; nothing where there are none."""
    return f" for {values_text(values)}" if values else ""


def rounded_text(values):
    """Values of symbols that nobody has to see in full: `M = 0.713, rho = 2.4`."""
    return ", ".join(f"{symbol} = {float(value):.3g}" for symbol, value in values.items())


def told_for(values):
    """The beginning of a sentence that holds for values of symbols: `for M = 0.713 `."""
    return f"for {rounded_text(values)} " if values else ""


def other_rate(symbol, said, true):
    """That a matrix of equations in deviations is wrong in a column: where, and what it says there,
    not what is right."""
    k = max(range(len(said)), key=lambda i: abs(said[i] - true[i]))
    which = "the right-hand side" if len(said) == 1 else f"right-hand side {k + 1}"
    return f"a small deviation of {symbol} alone changes {which} at another rate than yours, {number_text(said[k])}"


def sample_text(values):
    """Values of parameters for a message, as fractions where they are simple."""
    return (
        ", ".join(f"{p} = {v if v.q < 20 else f'{float(v):.4g}'}" for p, v in values.items())
        or "the system given"
    )


def point_text(point):
    """Numbers for a message: `(1, -0.5)`. What is mere rounding beside the others is told as 0."""
    numbers = [float(x) for x in point]
    least = max([1e-12, *(1e-8 * abs(x) for x in numbers if math.isfinite(x))])
    return "(" + ", ".join(f"{0 if abs(x) < least else x:.4g}" for x in numbers) + ")"
