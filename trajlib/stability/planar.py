"""Planar systems: types of equilibria, and the Bendixson-Dulac test for closed trajectories.

The type follows from the trace, the determinant and the discriminant tr^2 - 4 det of the matrix of
the linearisation. For a nonlinear field the types of a hyperbolic point carry over; "centre" and
the lines of equilibria do not: there the linearisation leaves the question open.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import has_floats, read_exact_matrix, read_float_matrix
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import exact_decimals, read_expression, read_field
from trajlib._real_symbols import as_real
from trajlib._typing import Expressions, ExprLike, MatrixLike, Symbols
from trajlib.stability.inequalities import equation, positive, sign_of, tidied
from trajlib.stability.real_solutions import definedness
from trajlib.stability.regions import latex_condition
from trajlib.stability.strict_inequalities import TooLarge, solution_point


@dataclass(frozen=True)
class PlanarTypes:
    """The type of the equilibrium x = 0 of x' = Ax over the space of parameters.

    Iterating gives the rows.

    Attributes
    ----------
    matrix : sympy.Matrix, shape (2, 2)
        A.
    rows : tuple of (sympy.Basic, str)
        Pairs (condition, type) that exclude one another and together cover all values for which A
        is real.
    """

    matrix: sp.Matrix
    rows: tuple[tuple[sp.Basic, str], ...]

    def __iter__(self):
        return iter(self.rows)

    def __len__(self):
        return len(self.rows)

    def _repr_latex_(self):
        lines = (
            rf"{latex_condition(condition)} & \text{{{kind}}}" for condition, kind in self.rows
        )
        return r"$\displaystyle \begin{array}{ll} " + r" \\ ".join(lines) + r" \end{array}$"


@accepts_state_space("A", time="continuous", instead="its motion is a sequence of points")
def classify_planar(A: MatrixLike) -> str | PlanarTypes:
    """Return the type of the equilibrium of x' = Ax in the plane.

    Parameters
    ----------
    A : matrix_like, shape (2, 2)
        Numbers or symbols, whose assumptions (positive=True) are used. A StateSpace stands for A.

    Returns
    -------
    str or PlanarTypes
        For numbers the name of the type: "stable node", "stable focus", "stable degenerate node"
        (one eigenvector), "stable star" (every vector is one), the same with "unstable", "saddle",
        "centre", "stable line of equilibria", "unstable line of equilibria", "line of equilibria
        with drift" (A^2 = 0), "plane of equilibria". For symbols a table of (condition, type).

    Raises
    ------
    ValueError
        If A is not 2 x 2 or not real, if a root of parameters stands where no polynomial can be
        read, and for a NumPy array of floats in which the trace, the determinant or the
        discriminant that decides is zero within rounding.

    Notes
    -----
    A "centre" of the linearisation is undecided for a nonlinear system: it may be a focus of either
    kind. Source: Theorems 1.1 and 1.4 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> classify_planar(sp.Matrix([[0, 1], [-2, -1]]))
    'stable focus'
    >>> e = sp.Symbol("epsilon", real=True)
    >>> [kind for condition, kind in classify_planar(sp.Matrix([[0, 1], [-1, e]])) if condition.subs(e, 2) == True]
    ['unstable degenerate node']
    """
    if has_floats(A):
        return _classify_floats(read_float_matrix(A))
    A = read_exact_matrix(A, square=True)
    if A.rows != 2:
        raise ValueError(f"A: expected a 2 x 2 matrix, got shape {A.shape}")
    to_real, from_real = as_real(A)
    real = A.xreplace(to_real)
    exists = [r.reduced({}) for entry in real for r in definedness(entry)]
    rows = []
    for condition, kind in _table(real):
        condition = tidied(sp.And(condition, *exists))
        if condition is not sp.false and not _is_empty(condition):
            rows.append((condition.xreplace(from_real), kind))
    if not A.free_symbols:
        return rows[0][1]
    return PlanarTypes(A, tuple(rows))


def _table(A):
    trace, det = sp.factor(A.trace()), sp.factor(A.det())
    half_difference, upper, lower = A[0, 0] - A[1, 1], A[0, 1], A[1, 0]
    discriminant = sp.factor(trace**2 - 4 * det)
    scalar = sp.And(*(_zero(e) for e in (half_difference, upper, lower)))
    real_roots, complex_roots, on_parabola = (
        positive(discriminant),
        positive(-discriminant),
        _zero(discriminant),
    )
    yield positive(-det), "saddle"
    for side, name in ((positive(-trace), "stable"), (positive(trace), "unstable")):
        yield sp.And(side, positive(det), real_roots), f"{name} node"
        yield sp.And(side, complex_roots), f"{name} focus"
        yield sp.And(side, on_parabola, sp.Not(scalar)), f"{name} degenerate node"
        yield sp.And(side, scalar), f"{name} star"
        yield sp.And(side, _zero(det)), f"{name} line of equilibria"
    yield sp.And(_zero(trace), positive(det)), "centre"
    null = sp.And(_zero(trace), _zero(det))
    yield sp.And(null, sp.Not(scalar)), "line of equilibria with drift"
    yield sp.And(null, scalar), "plane of equilibria"


def _zero(expression):
    """Return the condition expression = 0, solved where it is in one symbol."""
    numerator = sp.numer(sp.together(expression))
    if (sign := sign_of(numerator)) is not None:
        return sp.true if sign == 0 else sp.false
    equations = []
    try:
        factors = sp.factor_list(numerator)[1]
    except sp.PolynomialError:
        raise ValueError(
            f"A: cannot decide where {numerator} vanishes; put a positive symbol in the place "
            "of the root"
        ) from None
    for f, _ in factors:
        if sign_of(f):
            continue
        values = sp.solveset(f, *f.free_symbols, sp.Reals) if len(f.free_symbols) == 1 else None
        if isinstance(values, sp.FiniteSet):
            (x,) = f.free_symbols
            equations += [
                sp.Eq(x, v)
                for v in values
                if not ((x.is_positive and v <= 0) or (x.is_negative and v >= 0))
            ]
        elif values is not sp.S.EmptySet:
            equations.append(equation(f))
    return sp.Or(*equations)


def _is_empty(condition):
    """Whether a condition of strict inequalities alone holds nowhere."""
    parts = sp.And.make_args(condition)
    if not all(isinstance(c, (sp.Gt, sp.Lt)) for c in parts):
        return False
    try:
        return (
            solution_point([c.gts - c.lts for c in parts], sorted(condition.free_symbols, key=str))
            is None
        )
    except TooLarge:
        return False


def _classify_floats(A):
    if A.shape != (2, 2) or not np.all(np.isfinite(A)):
        raise ValueError(f"A: expected a 2 x 2 matrix of finite numbers, got shape {A.shape}")
    size = np.abs(A).max()
    scaled = A / size if size else A
    trace, det = np.trace(scaled), np.linalg.det(scaled)
    discriminant = (scaled[0, 0] - scaled[1, 1]) ** 2 + 4 * scaled[0, 1] * scaled[1, 0]
    rounding = 64 * np.finfo(float).eps
    close = [
        name
        for name, value in (
            ("determinant", det),
            ("discriminant", discriminant if det > 0 else 1),
            ("trace", trace if det > 0 else 1),
        )
        if abs(value) <= rounding
    ]
    if close:
        raise ValueError(
            f"A: the {close[0]} is zero within rounding, so floats cannot tell the type; "
            "give the matrix exactly (SymPy)"
        )
    if det < 0:
        return "saddle"
    return f"{'stable' if trace < 0 else 'unstable'} {'node' if discriminant > 0 else 'focus'}"


@dataclass(frozen=True)
class DulacTest:
    """The result of the Bendixson-Dulac test.

    Attributes
    ----------
    divergence : sympy.Expr
        div(B f).
    sign : str or None
        Its sign on the region: "positive", "negative", "nonnegative", "nonpositive", "zero",
        "changes", or None if not decided.
    excludes_cycles : bool or None
        True if there are no closed trajectories in the region (which must be simply connected),
        None if the test is inconclusive.
    """

    divergence: sp.Expr
    sign: str | None
    excludes_cycles: bool | None

    def _repr_markdown_(self):
        verdict = "no closed trajectories" if self.excludes_cycles else "the test decides nothing"
        return f"$\\mathrm{{div}}(Bf) = {sp.latex(self.divergence)}$, sign: {self.sign or 'not decided'}; {verdict}"


def dulac(
    field: Expressions,
    state: Symbols,
    multiplier: ExprLike = 1,
    region: sp.Basic | None = None,
) -> DulacTest:
    """Apply the Bendixson-Dulac test: no closed trajectories if div(B f) keeps one sign.

    Parameters
    ----------
    field : sequence of 2 sympy.Expr
        Right-hand sides f(x).
    state : sequence of 2 sympy.Symbol
        The state variables; their assumptions (positive=True) restrict the plane.
    multiplier : sympy.Expr, default 1
        The function B.
    region : sympy.Basic, optional
        Inequalities, joined by And, that describe a simply connected region (which is not checked);
        by default the plane.

    Returns
    -------
    DulacTest
        The divergence with its sign, decided exactly.

    Raises
    ------
    ValueError
        If the system is not planar, or if `region` is no conjunction of inequalities.

    Examples
    --------
    >>> import sympy as sp
    >>> rho, b, u = sp.symbols("rho b u", positive=True)
    >>> beta = sp.Symbol("beta", real=True)
    >>> test = dulac([b - sp.cos(beta), sp.sin(beta)/rho + u], [rho, beta], multiplier=rho)
    >>> test.divergence, test.sign, test.excludes_cycles
    (b, 'positive', True)
    """
    field, state = read_field(field, state)
    if len(state) != 2:
        raise ValueError(f"state: expected a planar system, got {len(state)} variables")
    B = exact_decimals(read_expression(multiplier, "multiplier"))
    divergence = sp.simplify(sum(sp.diff(B * exact_decimals(f), x) for f, x in zip(field, state)))
    to_real, _from_real = as_real(
        divergence, *state, *([] if region is None else [sp.sympify(region)])
    )
    assumed_positive = []
    for relation in () if region is None else sp.And.make_args(sp.sympify(region)):
        if not isinstance(relation, (sp.Gt, sp.Ge, sp.Lt, sp.Le)):
            raise ValueError(f"region: expected inequalities joined by And, got {region}")
        assumed_positive.append((relation.gts - relation.lts).xreplace(to_real))
    sign = _sign_on(divergence.xreplace(to_real), assumed_positive)
    return DulacTest(divergence, sign, True if sign not in (None, "zero", "changes") else None)


def _sign_on(expression, assumed_positive):
    if expression == 0:
        return "zero"
    if (sign := sign_of(expression)) is not None:
        return "positive" if sign > 0 else "negative"
    numerator, denominator = sp.fraction(sp.together(expression))
    product = sp.expand(numerator * denominator)
    symbols = sorted(
        set(product.free_symbols).union(*(k.free_symbols for k in assumed_positive)), key=str
    )
    try:
        takes_positive = solution_point([*assumed_positive, product], symbols) is not None
        takes_negative = solution_point([*assumed_positive, -product], symbols) is not None
    except TooLarge:
        if expression.is_nonnegative or expression.is_nonpositive:
            return "nonnegative" if expression.is_nonnegative else "nonpositive"
        return None
    if takes_positive and takes_negative:
        return "changes"
    return "nonnegative" if takes_positive else "nonpositive"
