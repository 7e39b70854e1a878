"""Equilibria of x' = f(x), exactly, and whether they are all.

The pendulum x1' = x2, x2' = -d x2 - w^2 sin x1 has the two families (2 pi n, 0) and (2 pi n + pi,
0); they are returned as points that contain an integer symbol n, one point for each class of points
on which the linearisation is the same.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.symbols import exact_decimals, join_names, read_field, read_symbols
from trajlib._real_symbols import as_real
from trajlib._typing import Expressions, Symbols
from trajlib.stability.inequalities import nonnegative, positive, tidied
from trajlib.stability.real_solutions import solve_real


@dataclass(frozen=True)
class Equilibria(Sequence):
    """A sequence of exact points (tuples in the order of `state`).

    A state variable that stands in its own position in a point is free: every value of it belongs
    to an equilibrium.

    Attributes
    ----------
    state : tuple of sympy.Symbol
        The state variables.
    points : tuple of tuple
        The points.
    conditions : tuple of sympy.Basic
        The condition on the parameters under which each point exists (`sp.true` if it always does).
    integers : tuple of sympy.Symbol
        The integer symbols in the points of periodic families.
    complete : bool
        Whether these are all equilibria.
    reason : str
        Why they are, or are not, all.
    """

    state: tuple[sp.Symbol, ...]
    points: tuple[tuple[sp.Expr, ...], ...]
    conditions: tuple[sp.Basic, ...]
    integers: tuple[sp.Symbol, ...]
    complete: bool
    reason: str

    def __len__(self):
        return len(self.points)

    def __getitem__(self, index):
        return self.points[index]

    def _repr_latex_(self):
        if not self.points:
            return rf"$\text{{no equilibria ({self.reason})}}$"
        lines = []
        for point, condition in zip(self.points, self.conditions):
            coordinates = r",\; ".join(
                f"{sp.latex(x)} = {sp.latex(v)}" for x, v in zip(self.state, point)
            )
            lines.append(
                coordinates
                + ("" if condition is sp.true else rf"\quad\text{{if }} {sp.latex(condition)}")
            )
        if self.integers:
            lines.append(", ".join(map(sp.latex, self.integers)) + r" \in \mathbb{Z}")
        return r"$\displaystyle \begin{array}{l} " + r" \\ ".join(lines) + r" \end{array}$"


def equilibria(
    field: Expressions,
    state: Symbols,
    parameters: Symbols = (),
    domain: Mapping[sp.Symbol, sp.Interval] | None = None,
) -> Equilibria:
    """Return all real equilibria of x' = f(x), exactly, with conditions on the parameters.

    Points at which the field is not defined are left out.

    Parameters
    ----------
    field : sequence of n sympy.Expr
        Right-hand sides f(x).
    state : sequence of n sympy.Symbol
        The state variables x.
    parameters : sequence of sympy.Symbol, optional
        The other symbols of the field: real and generic (one that is a factor of a right-hand side
        is taken to be nonzero, which `reason` then states); their assumptions and those of the
        state (positive=True) are used.
    domain : dict, optional
        From state variables to SymPy Interval: keeps only the equilibria inside; it turns a
        periodic family into the finitely many points of a window.

    Returns
    -------
    Equilibria
        The points with their conditions.

    Raises
    ------
    ValueError
        For a symbol that is neither in `state` nor in `parameters`.
    TypeError
        If `domain` is no dict of intervals.

    Examples
    --------
    >>> import sympy as sp
    >>> x, v, a, b = sp.symbols("x v a b")
    >>> found = equilibria([v, -a*v - x - b*x**3], [x, v], [a, b])
    >>> list(zip(found, found.conditions))
    [((0, 0), True), ((sqrt(-1/b), 0), b < 0), ((-sqrt(-1/b), 0), b < 0)]
    >>> found.complete
    True
    """
    field, state = read_field(field, state)
    parameters = read_symbols(parameters, "parameters")
    undeclared = set().union(*(f.free_symbols for f in field)) - set(state) - set(parameters)
    if undeclared:
        raise ValueError(
            f"parameters: the field also has {join_names(undeclared)}; "
            "name every symbol that is not a state variable"
        )
    field = [exact_decimals(f) for f in field]
    to_real, from_real = as_real(*field, *state)
    unknowns = [to_real.get(x, x) for x in state]
    windows = _read_domain(domain, state)
    solutions = solve_real([f.xreplace(to_real) for f in field], unknowns)

    points, conditions = [], []
    for values, condition in solutions.branches:
        point = tuple(values.get(x, x) for x in unknowns)
        for inside, window_condition in _within(point, windows, solutions.integers):
            joined = tidied(sp.And(condition, window_condition))
            if joined is not sp.false:
                points.append(tuple(_shortest(v).xreplace(from_real) for v in inside))
                conditions.append(joined.xreplace(from_real))
    order = sorted(
        range(len(points)), key=lambda i: (conditions[i] is not sp.true, _position(points[i]))
    )
    integers = tuple(n for n in solutions.integers if any(v.has(n) for p in points for v in p))
    return Equilibria(
        state,
        tuple(points[i] for i in order),
        tuple(conditions[i] for i in order),
        integers,
        not solutions.unsolved,
        _reason(solutions, from_real),
    )


def _reason(solutions, from_real):
    if solutions.unsolved:
        equations = (
            f"{e.xreplace(from_real)} = 0 for {x.xreplace(from_real)}"
            for e, x in solutions.unsolved
        )
        return (
            "not all were found; no closed form is known here for the real roots of "
            + ", ".join(equations)
        )
    exceptions = sorted(f"{e.xreplace(from_real)} != 0" for e in solutions.nonzero)
    exceptions += ["parameters in general position"] * solutions.generic
    if exceptions:
        return "every equation was solved exactly, for " + ", ".join(exceptions)
    return "every equation was solved exactly"


def _shortest(value):
    return value if value.has(sp.CRootOf) else min((value, sp.simplify(value)), key=sp.count_ops)


def _position(point):
    """Return a sort key: the origin first, then by size."""
    return (
        any(v != 0 for v in point),
        [v.count_ops() for v in point],
        [sp.default_sort_key(v) for v in point],
    )


def _read_domain(domain, state):
    if domain is None:
        return {}
    if not isinstance(domain, Mapping) or not all(
        isinstance(s, sp.Interval) for s in domain.values()
    ):
        raise TypeError(
            "domain: expected a dict from state symbols to SymPy Interval, "
            f"such as {{{state[0]}: Interval(0, 1)}}; got {domain!r}"
        )
    undeclared = set(domain) - set(state)
    if undeclared:
        raise ValueError(f"domain: {join_names(undeclared)} is not a state variable")
    return {state.index(x): interval for x, interval in domain.items()}


def _within(point, windows, integers):
    """Yield pairs (point, condition): the members of a point or family inside the windows."""
    candidates = [point]
    for index, window in windows.items():
        candidates = [member for p in candidates for member in _members(p, index, window, integers)]
    for member in candidates:
        yield (
            member,
            sp.And(*(_contains(window, member[index]) for index, window in windows.items())),
        )


def _members(point, index, window, integers):
    """Replace the integer of a family by the values that can bring a coordinate into the window."""
    coordinate = sp.expand(point[index])
    n = next((n for n in integers if coordinate.has(n)), None)
    if n is None or not (window.start.is_finite and window.end.is_finite):
        return [point]
    step = coordinate.coeff(n)
    low, high = _range_of(coordinate.subs(n, 0))
    first, last = (
        sorted(((window.start - high) / step, (window.end - low) / step))
        if step > 0
        else sorted(((window.end - low) / step, (window.start - high) / step))
    )
    return [
        tuple(v.subs(n, k) for v in point) for k in range(sp.ceiling(first), sp.floor(last) + 1)
    ]


def _range_of(angle):
    """Return bounds of an angle such as pi - asin(k)/2, from the ranges of the inverses."""
    ranges = {
        sp.asin: (-sp.pi / 2, sp.pi / 2),
        sp.acos: (0, sp.pi),
        sp.atan: (-sp.pi / 2, sp.pi / 2),
    }
    low = high = sp.Integer(0)
    for term in sp.Add.make_args(angle):
        inverse = next(iter(term.atoms(*ranges)), sp.Integer(1))
        coefficient = term / inverse
        if not coefficient.is_number:
            raise ValueError(f"domain: cannot tell which members of the family {angle} lie inside")
        ends = sorted(coefficient * end for end in ranges.get(type(inverse), (1, 1)))
        low, high = low + ends[0], high + ends[1]
    return low, high


def _contains(window, value):
    """Return the condition under which `value` lies in the window."""
    if value.is_number:
        return sp.sympify(window.contains(value))
    if value.atoms(sp.asin, sp.acos, sp.atan):
        # The ranges of the inverse functions often decide it for all values of the parameters.
        low, high = _range_of(sp.expand(value))
        certain_low, certain_high = low > window.start, high < window.end
        if high < window.start or low > window.end:
            return sp.false
    else:
        certain_low, certain_high = window.start == -sp.oo, window.end == sp.oo
    above = (
        sp.true
        if certain_low
        else (positive if window.left_open else nonnegative)(value - window.start)
    )
    below = (
        sp.true
        if certain_high
        else (positive if window.right_open else nonnegative)(window.end - value)
    )
    return sp.And(above, below)
