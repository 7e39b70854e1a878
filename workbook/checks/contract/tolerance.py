"""How far a number of an answer may be off: the only place that knows.

- Exact: what is written without decimals has to be right, up to the rounding of what is computed
  with it.
- Decimals: a number counts to three significant digits, which is half a unit of the third digit of
  the true number. An expression with symbols is as uncertain as such a change of each of its
  decimals makes it (`changed`); where that cannot be followed, and in what is computed from
  numbers, they make each term uncertain by such a share of it.
- Computed: where the truth itself is known to a precision only, as by a search, that stands for
  `EXACT`.

Numbers are compared by `same`, entry by entry; a residual has no digits of its own, and gets a
`share` of its terms.
"""

import numpy as np
import sympy as sp

#: What the rounding of our own arithmetic may make of something exact, as a share of its size.
EXACT = 1e-9
#: The same of an eigenvalue that comes twice: the root of what rounding is.
REPEATED = 1e-7
#: What three digits leave uncertain of a number, at worst: half a unit of the last digit in 1.00.
DECIMALS = 5e-3
#: A number that is a smaller share of those beside it than this has the digits that this share
#: would have.
NEGLIGIBLE = 1e-3
#: The terms of an expression with symbols may cancel to this share of their size.
CANCELLED = 0.1
#: The change of each decimal is followed in expressions that have no more of them.
MOST_FOLLOWED = 12
#: The change of two decimals at once is followed in expressions that have no more of them.
MOST_TOGETHER = 3


def in_decimals(*written):
    """Whether answers, SymPy objects or lists of them, hold decimals; a zero is exact however it is
    written."""
    return any(
        in_decimals(*part)
        if isinstance(part, (list, tuple))
        else any(not number.is_zero for number in sp.sympify(part).atoms(sp.Float))
        for part in written
    )


def changed(*written):
    """Pairs of lists of the SymPy objects with one of their decimals smaller and larger by what
    three digits leave open, the same with either sign; None if there are too many. The exponent of
    a root is exact however it is written.

    That is the share for any number, since SymPy multiplies: of 2*0.318*a it keeps 0.636*a.
    """
    written, decimals = _followed(written)
    if len(decimals) > MOST_FOLLOWED:
        return None
    return [[_moved(written, (number,), side) for side in (-1, 1)] for number in decimals]


def changed_together(*written):
    """The same with two decimals larger: for each of them a list with a change for each that comes
    after it; empty if there are more than `MOST_TOGETHER`."""
    written, decimals = _followed(written)
    return (
        [
            [_moved(written, (one, other), 1) for other in decimals[k + 1 :]]
            for k, one in enumerate(decimals)
        ]
        if len(decimals) <= MOST_TOGETHER
        else []
    )


def _followed(written):
    """The objects without decimals in roots, and the sizes of their decimals."""
    written = [sp.sympify(part) for part in written]
    roots = {
        power: sp.Pow(power.base, sp.nsimplify(power.exp, rational=True))
        for part in written
        for power in part.atoms(sp.Pow)
        if power.exp.is_Float and float(4 * power.exp).is_integer()
    }
    written = [part.xreplace(roots) for part in written]
    return written, sorted(
        {abs(n) for part in written for n in part.atoms(sp.Float) if n != 0}, key=float
    )


def _moved(written, numbers, side):
    factors = {one: one * (1 + side * DECIMALS) for number in numbers for one in (number, -number)}
    return [part.xreplace(factors) for part in written]


def share(*written, computed=EXACT):
    """How large a residual may be, as a share of the size of its terms."""
    return DECIMALS if in_decimals(*written) else computed


def half_unit(size):
    """Half a unit of the third significant digit of a number of this size; zero for zero."""
    with np.errstate(divide="ignore"):
        return 0.5 * (1 + 1e-9) * 10.0 ** (np.floor(np.log10(np.abs(size))) - 2)


def rounds_to(said, true, size=0.0):
    """True if a real number is another to three significant digits; `size` is that of the numbers
    beside it."""
    return bool(
        abs(float(said) - float(true)) <= half_unit(max(abs(float(true)), NEGLIGIBLE * float(size)))
    )


def same(said, true, written, size=0.0, computed=EXACT, uncertain=None):
    """Whether numbers, real or complex, that an answer became are the true ones: a bool, or an
    array of them.

    `written` is the answer, an expression or a matrix of the same shape; `size` that of the numbers
    that were computed with, in an array that of those beside it; `uncertain` by how much its
    decimals leave open what an expression with symbols becomes, nan if not known.
    """
    wrong = np.asarray(said) - true
    beside = NEGLIGIBLE * size if wrong.shape else 0  # a number alone has the digits of its own
    allowed = computed * np.maximum(np.abs(true), size)
    if in_decimals(written):
        has_symbols = np.vectorize(lambda e: bool(sp.sympify(e).free_symbols), otypes=[bool])(
            _entries(written)
        )
        open_ = DECIMALS * np.maximum(np.abs(true), CANCELLED * size)
        if uncertain is not None:
            open_ = np.where(np.isfinite(uncertain), uncertain, open_)
        allowed = np.maximum(
            allowed, np.where(has_symbols, open_, half_unit(np.maximum(np.abs(true), beside)))
        )
    found = (np.abs(wrong.real) <= allowed) & (np.abs(wrong.imag) <= allowed)
    return found if found.shape else bool(found)


def _entries(written):
    if isinstance(written, sp.MatrixBase):
        return np.array(list(written), dtype=object).reshape(written.shape)
    return np.array(written, dtype=object)
