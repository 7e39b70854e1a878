"""Guaranteed lower bound of the smallest singular value for all parameters in a box.

Take a cell with the centre p0 and half sides r_k, C = A(p0) and a matrix G with G C = E, nearly. By
the mean value theorem, entry by entry, G A(p) = E + F with |F| <= sum_k r_k |G dA/dp_k| for all p
of the cell, and from |A v| >= |G A v|/|G|

    s_min(A(p)) >= (1 - |F|)/|G|,        |G| = 1/s_min(C).

The derivatives are enclosed by intervals rounded outwards, and bounds on the rounding errors of G
C, of the products and of |G| are added. Cells whose bound is not sufficient are halved. The result
is a proof by computer, provided that the libraries round as documented.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.arrays import read_array
from trajlib._typing import ArrayLike
from trajlib.solvability.intervals import FUNCTIONS, Interval, as_interval
from trajlib.solvability.rounding import EPS, threshold

#: Cells that are treated together.
BATCH = 256


@dataclass(frozen=True, repr=False)
class Guarantee:
    """Bounds of the smallest singular value in a box of parameters, the result of `guarantee`.

    Attributes
    ----------
    lower : float
        Lower bound for all parameters in the box.
    upper : float
        Smallest value found at the centre of a cell.
    where : dict
        Parameters of that centre by name.
    cells : int
        Number of cells examined.
    undefined : dict or None
        Parameters by name near which the matrix or its derivative was not found to be finite: a pole, or the root or
        logarithm of a number that is not positive. Nothing is proved then.
    """

    lower: float
    upper: float
    where: dict
    cells: int
    undefined: dict | None = None

    @property
    def proved(self) -> bool:
        """Whether lower > 0, so that the problem is solvable in the whole box."""
        return self.lower > 0

    def __repr__(self):
        at = _in_words(self.where)
        if self.undefined is not None:
            elsewhere = (
                f"; the smallest singular value found elsewhere is {self.upper:.4g}, at {at}"
            )
            return (
                f"not proved: near {_in_words(self.undefined)} the matrix or its derivative is not "
                "finite (a pole, or the root or logarithm of a number that is not positive); leave such parameters out "
                f"of the box{elsewhere if np.isfinite(self.upper) else ''}"
            )
        if self.proved:
            return (
                "solvable in the whole box: the smallest singular value is at least "
                f"{self.lower:.4g} ({self.cells} cells; {self.upper:.4g} at {at})"
            )
        return (
            f"not proved: with {self.cells} cells only {self.lower:.4g} is certain; the smallest "
            f"singular value found is {self.upper:.4g}, at {at}"
        )


def guarantee(
    matrix: sp.Matrix,
    box: Mapping,
    *,
    scaling: ArrayLike | None = None,
    ratio: float = 0.5,
    cells: int = 20000,
) -> Guarantee:
    """Return a lower bound of the smallest singular value of a matrix over a box.

    Parameters
    ----------
    matrix : sympy.Matrix, shape (n, m)
        Matrix in the symbols of `box`, made of + - * /, integer powers, sqrt, sin, cos, exp, log;
        weighted, if weights are wanted.
    box : mapping
        Interval (low, high) of each symbol.
    scaling : array_like, shape (m,), optional
        Numbers by which the columns are divided; their norms at the middle of the box if left out.
    ratio : float
        The search ends when lower >= ratio*upper; 0 < ratio < 1.
    cells : int
        The search ends after this number of cells.

    Returns
    -------
    Guarantee

    Raises
    ------
    ValueError
        If arguments do not fit or the matrix has other symbols or functions.

    Examples
    --------
    >>> a = sp.Symbol("a")
    >>> bounds = guarantee(sp.Matrix([[1, 0], [0, a]]), {a: (1, 3)}, scaling=[1, 1])
    >>> bounds.proved, 0.5 <= bounds.lower <= 1
    (True, True)
    """
    matrix = sp.Matrix(matrix)
    box_low, box_high = _box_ends(box)
    undeclared = matrix.free_symbols - set(box)
    if undeclared:
        raise ValueError(f"box: no interval for {', '.join(sorted(map(str, undeclared)))}")
    n, m = matrix.shape
    if n < m or m == 0:
        raise ValueError(f"matrix: {n} rows cannot determine {m} unknowns")
    if not 0 < ratio < 1:
        raise ValueError(f"ratio: expected a number between 0 and 1, got {ratio}")
    symbols = list(box)
    values, slopes = (
        _enclosure([matrix], symbols),
        _enclosure([matrix.diff(symbol) for symbol in symbols], symbols),
    )
    if scaling is None:
        middle = values(
            box_low[None] / 2 + box_high[None] / 2, box_low[None] / 2 + box_high[None] / 2
        )
        scaling = np.linalg.norm(middle.low[0, 0], axis=0)
        if not (np.isfinite(middle.low).all() and np.isfinite(middle.high).all()):
            # the first cell says so
            scaling = np.ones(m)
    scaling = read_array(scaling, "scaling", f"{m} positive numbers")
    if scaling.shape != (m,) or not ((scaling > 0) & np.isfinite(scaling)).all():
        raise ValueError(
            f"scaling: expected {m} positive numbers, got {scaling}; a column that is zero at the "
            "middle of the box needs one"
        )

    lows, highs = box_low[None], box_high[None]
    accepted, best, where, count = np.inf, np.inf, box_low / 2 + box_high / 2, 0
    undefined_size, undefined = np.inf, None
    bounds = np.array([-np.inf])
    while lows.size:
        batch = slice(0, BATCH)
        a, b = lows[batch], highs[batch]
        new_bounds, smallest, sides, finite = _cell_bounds(values, slopes, a, b, scaling)
        count += len(a)
        if not finite.all():
            # Of these cells the smallest so far; at a centre that is undefined itself the search ends.
            sizes = np.where(finite, np.inf, ((b - a) / (box_high - box_low)).max(axis=1))
            sizes[np.isinf(smallest)] = 0
            k = int(np.argmin(sizes))
            if sizes[k] < undefined_size:
                undefined_size, undefined = sizes[k], a[k] / 2 + b[k] / 2
            if undefined_size == 0:
                accepted = -np.inf
                break
        if smallest.min() < best:
            k = int(np.argmin(smallest))
            best, where = smallest[k], a[k] / 2 + b[k] / 2
        sufficient = new_bounds >= ratio * best
        if sufficient.any():
            accepted = min(accepted, new_bounds[sufficient].min())
        a, b, new_bounds, sides = (part[~sufficient] for part in (a, b, new_bounds, sides))
        lows, highs, bounds = lows[BATCH:], highs[BATCH:], bounds[BATCH:]
        if count >= cells or best == 0:
            # the cells that are left keep the bounds of the cells they come from
            accepted = min([accepted, *bounds, *new_bounds])
            break
        rows, middle = np.arange(len(a)), a / 2 + b / 2
        lower_half, upper_half = b.copy(), a.copy()
        lower_half[rows, sides] = upper_half[rows, sides] = middle[rows, sides]
        lows, highs = np.concatenate([lows, a, upper_half]), np.concatenate([highs, lower_half, b])
        bounds = np.concatenate([bounds, new_bounds, new_bounds])
    names = [str(symbol) for symbol in symbols]
    return Guarantee(
        float(accepted),
        float(best),
        dict(zip(names, where.tolist())),
        count,
        dict(zip(names, undefined.tolist()))
        if undefined is not None and best and not np.isfinite(accepted)
        else None,
    )


def _cell_bounds(values, slopes, a, b, scaling):
    """Return for each cell a lower bound of s_min, s_min at its centre, the side to halve.

    And whether the matrix and its derivatives have finite enclosures there.
    """
    centre = a / 2 + b / 2
    half = np.nextafter(np.maximum(b - centre, centre - a), np.inf)
    centre_values = values(centre, centre)
    C, C_radius = _centre_and_radius(centre_values, scaling)
    D, D_radius = _centre_and_radius(slopes(a, b), scaling)
    C, C_radius = C[:, 0], C_radius[:, 0]
    _, n, m = C.shape
    usable = (
        np.isfinite(C).all(axis=(1, 2))
        & np.isfinite(D).all(axis=(1, 2, 3))
        & np.isfinite(D_radius).all(axis=(1, 2, 3))
    )
    finite, smallest = usable.copy(), np.full(len(a), np.inf)
    defined = np.isfinite(C).all(axis=(1, 2))
    s = np.linalg.svd(C[defined], compute_uv=False)
    smallest[defined] = s[:, -1]
    bounds, sides = (
        np.full(len(a), -np.inf),
        np.argmax((b - a) / (np.abs(a) + np.abs(b) + 1e-300), axis=1),
    )
    usable[usable] &= smallest[usable] > EPS * n
    if usable.any():
        C, C_radius, D, D_radius, half = (part[usable] for part in (C, C_radius, D, D_radius, half))
        G = np.linalg.pinv(C)
        size = np.abs(G)
        # of a sum of n products
        slack = 2 * n * EPS
        defect = np.abs(G @ C - np.eye(m)) + size @ (C_radius + slack * np.abs(C))
        parts = half[:, :, None, None] * (
            np.abs(G[:, None] @ D) + size[:, None] @ (D_radius + slack * np.abs(D))
        )
        beta = np.linalg.norm(defect + parts.sum(axis=1), axis=(1, 2)) * (1 + slack)
        norm = np.linalg.norm(G, 2, axis=(1, 2)) * (1 + 1 / threshold(max(m, 2), max(n, 2)))
        bounds[usable] = (1 - beta) / norm * (1 - 8 * EPS)
        sides[usable] = np.argmax(np.linalg.norm(parts, axis=(2, 3)), axis=1)
    return bounds, smallest, sides, finite


def _in_words(parameters):
    return ", ".join(f"{name} = {value:.6g}" for name, value in parameters.items())


def _centre_and_radius(enclosure, scaling):
    with np.errstate(invalid="ignore", over="ignore"):
        middle = (enclosure.low / 2 + enclosure.high / 2) / scaling
        radius = np.maximum(enclosure.high / scaling - middle, middle - enclosure.low / scaling)
        return middle, np.nextafter(radius * (1 + 4 * EPS) + 4 * EPS * np.abs(middle), np.inf)


def _box_ends(box):
    ends = []
    for symbol, interval in box.items():
        low, high = (float(end) for end in interval)
        if not (np.isfinite([low, high]).all() and low < high):
            raise ValueError(
                f"box: expected finite (low, high) with low < high for {symbol}, got {interval}"
            )
        ends.append((low, high))
    if not ends:
        raise ValueError("box: it has no parameters; use `analyse` for a single matrix")
    return np.array(ends).T


def _enclosure(matrices, symbols):
    """Return a function (low, high) of shapes (cells, parameters) to Intervals.

    Their shape is (cells, matrices, n, m).
    """
    shape = matrices[0].shape
    subexpressions, reduced = sp.cse(
        [entry for matrix in matrices for entry in matrix], symbols=sp.numbered_symbols("common_")
    )
    symbols_so_far, steps = list(symbols), []
    for symbol, expression in subexpressions:
        steps.append(_function(expression, symbols_so_far))
        symbols_so_far.append(symbol)
    entries = [_function(entry, symbols_so_far) for entry in reduced]

    def enclosure(low, high):
        values = [Interval(a, b) for a, b in zip(low.T, high.T)]
        for step in steps:
            values.append(step(*values))
        enclosures = [as_interval(entry(*values)) for entry in entries]
        cells = len(low)
        ends = (
            np.stack([np.broadcast_to(getattr(value, end), cells) for value in enclosures], axis=1)
            for end in ("low", "high")
        )
        return Interval(*(part.reshape(cells, len(matrices), *shape) for part in ends))

    return enclosure


def _applied(name):
    return lambda value: getattr(as_interval(value), name)()


_ALLOWED = {name: _applied(name) for name in FUNCTIONS}


def _function(expression, symbols):
    unsupported = {f.func.__name__ for f in expression.atoms(sp.Function)} - set(FUNCTIONS)
    if unsupported:
        raise ValueError(
            f"matrix: {', '.join(sorted(unsupported))} is not among the functions "
            f"{', '.join(FUNCTIONS)}"
        )
    enclosures = {}
    for number in expression.atoms(sp.Number, sp.NumberSymbol):
        # the others are no machine numbers
        if not ((2 * number).is_Integer and number == sp.Rational(float(number))):
            value = float(number)
            enclosures[number] = Interval(np.nextafter(value, -np.inf), np.nextafter(value, np.inf))
    names = {number: sp.Symbol(f"number_{k}") for k, number in enumerate(enclosures)}
    function = sp.lambdify(
        [*symbols, *names.values()], expression.xreplace(names), modules=[_ALLOWED], cse=False
    )
    return lambda *values: function(*values, *enclosures.values())
