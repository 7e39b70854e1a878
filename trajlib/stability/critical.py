"""Stability of x' = Ax, also with eigenvalues on the imaginary axis (critical cases).

Theorem 1.1 of the problem book settles the cases without roots on the axis. With such roots (and
none to the right) the solution x = 0 is stable if and only if each of them is semisimple: its
Jordan blocks have order one, that is, it has as many independent eigenvectors as its multiplicity.
The characteristic polynomial is factored exactly. An irreducible factor f(s) with a root on the
axis has the opposite number as a root too, so it is even, or f = s.

- If f is even, all its roots lie on the axis, and are simple, exactly when f + f' satisfies the
  Hurwitz criterion (Hermite-Biehler theorem); otherwise it has a root to the right.
- If it is not, the Hurwitz criterion decides.

Its roots are semisimple exactly when the rank of f(A) is n minus the degree of f times its
multiplicity.
"""

from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from trajlib._arguments.matrices import has_floats, read_exact_matrix, read_float_matrix
from trajlib._arguments.state_space import accepts_state_space
from trajlib._real_symbols import as_real, restore_names
from trajlib._typing import MatrixLike
from trajlib.stability.hurwitz import characteristic_polynomial, hurwitz_minors
from trajlib.stability.inequalities import sign_of
from trajlib.typesetting import escape_markdown


@dataclass(frozen=True)
class Mode:
    """An eigenvalue, or the roots of one irreducible factor of the characteristic polynomial.

    Attributes
    ----------
    factor : sympy.Expr
        That polynomial in lambda.
    eigenvalues : tuple
        Its roots where they have a closed form, else empty.
    multiplicity : int
        The algebraic multiplicity of each.
    eigenvectors : int or None
        The geometric multiplicity of each.
    side : str
        "left", "axis", "right" or "unknown".
    semisimple : bool or None
        None where it was not needed or not decided.
    """

    factor: sp.Expr
    eigenvalues: tuple[sp.Expr | complex, ...]
    multiplicity: int
    eigenvectors: int | None
    side: str
    semisimple: bool | None


@dataclass(frozen=True)
class LinearStability:
    """The verdict on x' = Ax.

    Attributes
    ----------
    verdict : str
        "asymptotically stable", "stable" (not asymptotically), "unstable" or "undecided".
    deciding_modes : tuple of Mode
        The modes that decide it.
    reason : str
        The verdict in words.
    degree : float or None
        For floats the computed -max Re lambda, for exact matrices None.
    """

    verdict: str
    deciding_modes: tuple[Mode, ...]
    reason: str
    degree: float | None = None

    def _repr_markdown_(self):
        return f"{self.verdict}: {escape_markdown(self.reason)}"


@accepts_state_space(
    "A",
    time="continuous",
    instead="trajlib.estimation.discrete_stationary_covariance decides by the unit circle",
)
def linear_stability(A: MatrixLike) -> LinearStability:
    """Decide the stability of the solution x = 0 of x' = Ax.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        A SymPy matrix or list of rows is decided exactly; symbols by their assumptions, "undecided"
        where these do not suffice. A NumPy array of floats is decided by the spectrum, "undecided"
        where a perturbation of rounding size can move an eigenvalue to the imaginary axis; then
        give the matrix exactly. A StateSpace stands for A.

    Returns
    -------
    LinearStability
        The verdict with its reason.

    Raises
    ------
    ValueError
        If the matrix is not square or not real.

    Notes
    -----
    MATLAB: ``eig``, ``jordan``. Source: Theorem 1.1 of the problem book, completed by the critical
    cases.

    Examples
    --------
    >>> import sympy as sp
    >>> double_integrator = sp.Matrix([[0, 1], [0, 0]])
    >>> linear_stability(double_integrator).reason
    'the eigenvalue 0 of multiplicity 2 has 1 eigenvector, so it is not semisimple and solutions grow'
    >>> linear_stability(sp.zeros(2, 2)).verdict
    'stable'
    """
    if has_floats(A):
        return _from_floats(read_float_matrix(A, square=True))
    A = read_exact_matrix(A, square=True)
    to_real, from_real = as_real(A)
    modes = _modes(A.xreplace(to_real), sp.Symbol("lambda"))
    verdict, deciding_modes, reason = _verdict(modes)
    return LinearStability(
        verdict,
        tuple(_restored(m, from_real) for m in deciding_modes),
        restore_names(reason, from_real),
    )


def _verdict(modes):
    """Return (verdict, deciding modes, reason): the first case that is present decides."""

    def on_side(side, semisimple=(True, False, None)):
        return [m for m in modes if m.side == side and m.semisimple in semisimple]

    if right := on_side("right"):
        return "unstable", right, f"{_named(right)}: there is a root with positive real part"
    if defective := on_side("axis", (False,)):
        return (
            "unstable",
            defective,
            "; ".join(
                f"the eigenvalue {_named([m])} of multiplicity {m.multiplicity} has {m.eigenvectors} "
                f"eigenvector{'s' * (m.eigenvectors > 1)}, so it is not semisimple and solutions grow"
                for m in defective
            ),
        )
    if unknown := on_side("unknown"):
        return (
            "undecided",
            unknown,
            (
                f"the real part of {_named(unknown)} depends on the parameters; "
                "declare their signs or ask stability_conditions"
            ),
        )
    if doubtful := on_side("axis", (None,)):
        return (
            "undecided",
            doubtful,
            f"whether {_named(doubtful)} is semisimple depends on the parameters",
        )
    if axis := on_side("axis"):
        return (
            "stable",
            axis,
            f"on the imaginary axis stand only semisimple eigenvalues: {_named(axis)}",
        )
    return "asymptotically stable", modes, "all eigenvalues have negative real parts"


def _named(modes):
    return ", ".join(str(e) for m in modes for e in (m.eigenvalues or (f"root of {m.factor}",)))


def _modes(A, s):
    characteristic = characteristic_polynomial(A, s)
    parametric = bool(A.free_symbols)
    if parametric:
        numerator = sp.numer(sp.together(characteristic))
        factors = [(sp.Poly(f, s).monic(), m) for f, m in sp.factor_list(numerator)[1] if f.has(s)]
    else:
        factors = sp.Poly(characteristic, s, extension=True).factor_list()[1]
    sides = [_side(f, parametric) for f, _ in factors]
    on_axis = [f for (f, _), side in zip(factors, sides) if side == "axis"]
    distinct = all(sign_of(sp.resultant(f, g)) for f, g in combinations(on_axis, 2))
    modes = []
    for (f, multiplicity), side in zip(factors, sides):
        eigenvectors = semisimple = None
        if side == "axis":
            eigenvectors, semisimple = _eigenvectors(A, f, multiplicity)
            if semisimple and not distinct:
                semisimple = None
        modes.append(
            Mode(f.as_expr(), _eigenvalues(f, side), multiplicity, eigenvectors, side, semisimple)
        )
    return modes


def _side(f, parametric):
    """Return the side of the roots of an irreducible monic polynomial ("right": at least one)."""
    s = f.gen
    if f.degree() == 1:
        return {1: "right", 0: "axis", -1: "left", None: "unknown"}[sign_of(-f.nth(0))]
    even = sp.expand(f.as_expr() - f.as_expr().subs(s, -s)) == 0
    signs = [sign_of(minor) for minor in hurwitz_minors(f + f.diff() if even else f)]
    if all(sign == 1 for sign in signs):
        return "axis" if even else "left"
    # Minors and coefficients are not negative while no root is to the right; a zero minor alone may
    # be due to roots on the axis, which an irreducible factor with numeric coefficients cannot have
    # unless it is even.
    if -1 in (*signs, *map(sign_of, f.all_coeffs())) or (0 in signs and not parametric):
        return "right"
    return "unknown"


def _eigenvectors(A, f, multiplicity):
    """Return the number of eigenvectors of each root, and whether the roots are semisimple."""
    value = sp.zeros(*A.shape)
    for coefficient in f.all_coeffs():
        value = (value * A + coefficient * sp.eye(A.rows)).applyfunc(sp.expand)
    rank = DomainMatrix.from_Matrix(value).to_field().rank()
    eigenvectors = (A.rows - rank) // f.degree()
    if eigenvectors == multiplicity:
        return eigenvectors, True
    # For special values of parameters the rank may drop; a minor of this order that cannot vanish
    # excludes that.
    certain = not value.free_symbols or any(
        sign_of(value.extract(list(rows), list(columns)).det())
        for rows in combinations(range(A.rows), rank)
        for columns in combinations(range(A.rows), rank)
    )
    return eigenvectors, False if certain else None


def _eigenvalues(f, side):
    """Return the roots in closed form; of long polynomials those on the side in question."""
    if f.degree() <= 2 or (f.degree() == 4 and f.nth(3) == f.nth(1) == 0):
        return tuple(sp.roots(f))
    if not (f.domain.is_ZZ or f.domain.is_QQ):
        return ()
    chosen = {"right": lambda r: sp.re(r.evalf()) > 0}.get(side, lambda r: True)
    return tuple(r for r in f.all_roots() if chosen(r))


def _restored(mode, from_real):
    return replace(
        mode,
        factor=mode.factor.xreplace(from_real),
        eigenvalues=tuple(e.xreplace(from_real) for e in mode.eigenvalues),
    )


def _from_floats(A):
    """Decide by the spectrum unless rounding can move an eigenvalue to the imaginary axis."""
    eigenvalues = np.linalg.eigvals(A)
    degree = float(-eigenvalues.real.max())
    scale = np.linalg.norm(A, 2)
    rounding = 10 * len(A) * np.finfo(float).eps * scale
    # The smallest singular value of A - i w I is the distance to the matrices that have the
    # eigenvalue i w.
    distance = min(
        np.linalg.svd(A - 1j * w * np.eye(len(A)), compute_uv=False)[-1]
        for w in {*eigenvalues.imag, 0.0}
    )
    s = sp.Symbol("lambda")

    def modes(chosen, side):
        return tuple(
            Mode(s - complex(e), (complex(e),), 1, None, side, None) for e in eigenvalues[chosen]
        )

    if distance <= rounding:
        doubtful = np.abs(eigenvalues.real) <= np.sqrt(np.finfo(float).eps) * scale
        return LinearStability(
            "undecided",
            modes(doubtful, "unknown"),
            f"a change of A by {distance:.1e}, within rounding, brings an eigenvalue to the "
            "imaginary axis; give the matrix exactly (SymPy)",
            degree,
        )
    if degree > 0:
        return LinearStability(
            "asymptotically stable",
            modes(eigenvalues.real == -degree, "left"),
            f"all real parts are at most {-degree:.6g}",
            degree,
        )
    return LinearStability(
        "unstable",
        modes(eigenvalues.real > 0, "right"),
        f"the largest real part is {-degree:.6g}",
        degree,
    )
