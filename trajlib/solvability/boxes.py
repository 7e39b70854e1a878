"""A guaranteed smallest singular value for a whole class of motions: all parameters of a box.

Take a cell with the centre p0 and half sides r_k, C = A(p0) and a matrix G with G C = E, nearly. By
the mean value theorem, entry by entry, G A(p) = E + F with |F| <= sum_k r_k |G dA/dp_k| for all p
of the cell, and from |A v| >= |G A v|/|G|

    s_min(A(p)) >= (1 - |F|)/|G|,        |G| = 1/s_min(C).

The derivatives are enclosed by intervals rounded outwards, and what rounding may do to G C, to the
products and to |G| is added. Cells whose bound is not good enough are halved. What comes out is a
proof by computer, as far as the libraries keep their promises.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib.solvability.intervals import FUNCTIONS, Interval
from trajlib.solvability.rounding import EPS, threshold

#: Cells that are treated together.
BATCH = 256


@dataclass(frozen=True, repr=False)
class Guarantee:
    """`lower`: no matrix of the box has a smaller singular value below it. `upper`: the smallest
    one met at the centre of a cell, at the parameters `where`. `proved`: whether lower > 0, so that
    the problem is solvable in the whole box. `cells`: how many were looked at."""

    lower: float
    upper: float
    where: dict
    cells: int

    @property
    def proved(self):
        return self.lower > 0

    def __repr__(self):
        at = ", ".join(f"{name} = {value:.6g}" for name, value in self.where.items())
        if self.proved:
            return (
                "solvable in the whole box: the smallest singular value is at least "
                f"{self.lower:.4g} ({self.cells} cells; {self.upper:.4g} at {at})"
            )
        return (
            f"not proved: with {self.cells} cells only {self.lower:.4g} is certain; the smallest "
            f"singular value found is {self.upper:.4g}, at {at}"
        )


def guarantee(matrix, box, *, scaling=None, ratio=0.5, cells=20000):
    """Lower bound of the smallest singular value of a SymPy matrix for all parameters in a box.

    `matrix`: n x m, in the symbols of `box`, made of + - * /, whole powers, sqrt, sin, cos, exp,
    log; weight it first. `box`: symbol -> (low, high). `scaling`: m numbers by which the columns
    are divided; their norms at the middle of the box if left out. The search ends when lower >=
    ratio*upper, or after so many `cells`.

    >>> a = sp.Symbol("a")
    >>> found = guarantee(sp.Matrix([[1, 0], [0, a]]), {a: (1, 3)}, scaling=[1, 1])
    >>> found.proved, 0.5 <= found.lower <= 1
    (True, True)
    """
    matrix = sp.Matrix(matrix)
    low, high = _ends(box)
    strangers = matrix.free_symbols - set(box)
    if strangers:
        raise ValueError(f"box: no interval for {', '.join(sorted(map(str, strangers)))}")
    n, m = matrix.shape
    if n < m or m == 0:
        raise ValueError(f"matrix: {n} rows cannot determine {m} unknowns")
    if not 0 < ratio < 1:
        raise ValueError(f"ratio: expected a number between 0 and 1, got {ratio}")
    symbols = list(box)
    values, slopes = (
        _enclosed([matrix], symbols),
        _enclosed([matrix.diff(symbol) for symbol in symbols], symbols),
    )
    if scaling is None:
        middle = values(low[None] / 2 + high[None] / 2, low[None] / 2 + high[None] / 2)
        scaling = np.linalg.norm(middle.low[0, 0], axis=0)
    scaling = np.asarray(scaling, dtype=float)
    if scaling.shape != (m,) or not ((scaling > 0) & np.isfinite(scaling)).all():
        raise ValueError(
            f"scaling: expected {m} positive numbers, got {scaling}; a column that is zero at the "
            "middle of the box needs one"
        )

    begin, end = low[None], high[None]
    accepted, best, where, count = np.inf, np.inf, low / 2 + high / 2, 0
    bounds = np.array([-np.inf])
    while begin.size:
        some = slice(0, BATCH)
        a, b = begin[some], end[some]
        certain, found, sides = _judged(values, slopes, a, b, scaling)
        count += len(a)
        if found.min() < best:
            k = int(np.argmin(found))
            best, where = found[k], a[k] / 2 + b[k] / 2
        enough = certain >= ratio * best
        if enough.any():
            accepted = min(accepted, certain[enough].min())
        a, b, certain, sides = a[~enough], b[~enough], certain[~enough], sides[~enough]
        begin, end, bounds = begin[BATCH:], end[BATCH:], bounds[BATCH:]
        if count >= cells or best == 0:
            # the cells that are left keep the bounds of the cells they come from
            accepted = min([accepted, *bounds, *certain])
            break
        rows, middle = np.arange(len(a)), a / 2 + b / 2
        left, right = b.copy(), a.copy()
        left[rows, sides] = right[rows, sides] = middle[rows, sides]
        begin, end = np.concatenate([begin, a, right]), np.concatenate([end, left, b])
        bounds = np.concatenate([bounds, certain, certain])
    return Guarantee(
        float(accepted), float(best), dict(zip(map(str, symbols), where.tolist())), count
    )


def _judged(values, slopes, a, b, scaling):
    """For each cell: a lower bound of s_min in it, s_min at its centre, and the side whose halving
    helps most."""
    centre = a / 2 + b / 2
    half = np.nextafter(np.maximum(b - centre, centre - a), np.inf)
    at = values(centre, centre)
    C, C_radius = _middle_and_radius(at, scaling)
    D, D_radius = _middle_and_radius(slopes(a, b), scaling)
    C, C_radius = C[:, 0], C_radius[:, 0]
    _, n, m = C.shape
    usable = (
        np.isfinite(C).all(axis=(1, 2))
        & np.isfinite(D).all(axis=(1, 2, 3))
        & np.isfinite(D_radius).all(axis=(1, 2, 3))
    )
    found = np.full(len(a), np.inf)
    defined = np.isfinite(C).all(axis=(1, 2))
    s = np.linalg.svd(C[defined], compute_uv=False)
    found[defined] = s[:, -1]
    certain, sides = (
        np.full(len(a), -np.inf),
        np.argmax((b - a) / (np.abs(a) + np.abs(b) + 1e-300), axis=1),
    )
    usable[usable] &= found[usable] > EPS * n
    if usable.any():
        C, C_radius, D, D_radius, half = (
            C[usable],
            C_radius[usable],
            D[usable],
            D_radius[usable],
            half[usable],
        )
        G = np.linalg.pinv(C)
        size = np.abs(G)
        # of a sum of n products
        slack = 2 * n * EPS
        wrong = np.abs(G @ C - np.eye(m)) + size @ (C_radius + slack * np.abs(C))
        parts = half[:, :, None, None] * (
            np.abs(G[:, None] @ D) + size[:, None] @ (D_radius + slack * np.abs(D))
        )
        beta = np.linalg.norm(wrong + parts.sum(axis=1), axis=(1, 2)) * (1 + slack)
        norm = np.linalg.norm(G, 2, axis=(1, 2)) * (1 + 1 / threshold(max(m, 2), max(n, 2)))
        certain[usable] = (1 - beta) / norm * (1 - 8 * EPS)
        sides[usable] = np.argmax(np.linalg.norm(parts, axis=(2, 3)), axis=1)
    return certain, found, sides


def _middle_and_radius(enclosure, scaling):
    with np.errstate(invalid="ignore", over="ignore"):
        middle = (enclosure.low / 2 + enclosure.high / 2) / scaling
        reach = np.maximum(enclosure.high / scaling - middle, middle - enclosure.low / scaling)
        return middle, np.nextafter(reach * (1 + 4 * EPS) + 4 * EPS * np.abs(middle), np.inf)


def _ends(box):
    ends = []
    for symbol, pair in box.items():
        low, high = (float(end) for end in pair)
        if not (np.isfinite([low, high]).all() and low < high):
            raise ValueError(
                f"box: expected finite (low, high) with low < high for {symbol}, got {pair}"
            )
        ends.append((low, high))
    if not ends:
        raise ValueError("box: it has no parameters; use `analyse` for a single matrix")
    return np.array(ends).T


def _enclosed(matrices, symbols):
    """A function (low, high), shapes (cells, parameters) -> Interval of shape (cells, matrices, n,
    m)."""
    shape = matrices[0].shape
    common, reduced = sp.cse(
        [entry for matrix in matrices for entry in matrix], symbols=sp.numbered_symbols("common_")
    )
    known, steps = list(symbols), []
    for symbol, expression in common:
        steps.append(_function(expression, known))
        known.append(symbol)
    last = [_function(entry, known) for entry in reduced]

    def enclosure(low, high):
        values = [Interval(a, b) for a, b in zip(low.T, high.T)]
        for step in steps:
            values.append(step(*values))
        found = [entry(*values) for entry in last]
        found = [value if isinstance(value, Interval) else Interval(value) for value in found]
        cells = len(low)
        ends = (
            np.stack([np.broadcast_to(getattr(value, end), cells) for value in found], axis=1)
            for end in ("low", "high")
        )
        return Interval(*(part.reshape(cells, len(matrices), *shape) for part in ends))

    return enclosure


def _applied(name):
    return lambda value: getattr(value if isinstance(value, Interval) else Interval(value), name)()


_ALLOWED = {name: _applied(name) for name in FUNCTIONS}


def _function(expression, symbols):
    foreign = {f.func.__name__ for f in expression.atoms(sp.Function)} - set(FUNCTIONS)
    if foreign:
        raise ValueError(
            f"matrix: {', '.join(sorted(foreign))} is not among the functions "
            f"{', '.join(FUNCTIONS)}"
        )
    enclosures = {}
    for number in expression.atoms(sp.Number, sp.NumberSymbol):
        # the others are no machine numbers
        if not (number.is_Integer or abs(number) == sp.S.Half):
            value = float(number)
            enclosures[number] = Interval(np.nextafter(value, -np.inf), np.nextafter(value, np.inf))
    names = {number: sp.Symbol(f"number_{k}") for k, number in enumerate(enclosures)}
    function = sp.lambdify(
        [*symbols, *names.values()], expression.xreplace(names), modules=[_ALLOWED], cse=False
    )
    return lambda *values: function(*values, *enclosures.values())
