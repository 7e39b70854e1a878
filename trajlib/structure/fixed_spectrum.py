"""Fixed eigenvalues: stabilisability, detectability and the greatest degree of stability.

A mode that is uncontrollable keeps its eigenvalue under u = Kx, and one that is unobservable keeps
it in the errors of every observer; the others can be put anywhere (Theorems 3.1 and 3.3 for the
part that is left). So the greatest degree of stability is that of the slowest fixed mode, and infinite if there is
none.

A mode decays if Re lambda < 0, in discrete time if |lambda| < 1; `rate` below is Re lambda or |lambda|
- 1. In floats a rate that is zero within rounding counts as zero.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import is_state_space, read_controlled, read_observed
from trajlib._arguments.state_space import accepts_state_space, is_discrete
from trajlib._typing import MatrixLike
from trajlib.structure.floats import tolerance
from trajlib.structure.pbh import HiddenMode
from trajlib.structure.rank_tests import controllability, observability
from trajlib.structure.scaling import balanced
from trajlib.typesetting import escape_markdown


@dataclass(frozen=True)
class FixedSpectrum:
    """The fixed eigenvalues; true in an `if` if all of them decay.

    Attributes
    ----------
    modes : tuple of HiddenMode
        The fixed eigenvalues, each with its vectors: rows w, no control changes w x, or columns v, the
        output of the motion v exp(lambda t) is zero.
    obstacles : tuple of HiddenMode
        Those of them that do not decay, Re lambda >= 0, in discrete time |lambda| >= 1.
    degree : sympy.Expr or float
        The greatest degree of stability that some gain gives (Definition 1.5: Re lambda <= -degree); `sp.oo` (for
        floats `inf`) if nothing is fixed; zero or negative where there are obstacles. In discrete time
        |lambda| <= 1 - degree, and 1 if nothing is fixed.
    reason : str
        The verdict in words.
    """

    modes: tuple[HiddenMode, ...]
    obstacles: tuple[HiddenMode, ...]
    degree: sp.Expr | float
    reason: str

    def __bool__(self):
        return not self.obstacles

    @property
    def margin(self):
        """Former name of `degree`, refused."""
        raise AttributeError("margin is called degree now")

    def _repr_markdown_(self):
        return escape_markdown(self.reason)


def stabilisability(A: MatrixLike, B: MatrixLike | None = None) -> FixedSpectrum:
    """Decide whether u = Kx can stabilise x' = Ax + Bu, and how fast the loop can be.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Exact or floats, or a StateSpace, which has its own `B` and is judged in its own time,
        continuous or discrete. With symbols the verdict is for general values, and the real parts of
        fixed eigenvalues must have a known sign.
    B : matrix_like, shape (n, s), optional
        Matrix of the control.

    Returns
    -------
    FixedSpectrum
        True in an `if` if the system is stabilisable.

    Raises
    ------
    ValueError
        If shapes do not fit, or if the sign of a real part is not known.

    Notes
    -----
    MATLAB has no word for it; it is the PBH test at the eigenvalues with Re lambda >= 0. Source:
    Definition 3.1, Theorem 3.2 with its remark, examples 5 and 6 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = stabilisability(sp.Matrix([[0, 1], [0, -1]]), sp.Matrix([1, 0]))
    >>> bool(found), found.degree
    (True, 1)
    """
    discrete, (dual, pushed) = is_discrete(A), read_controlled(A, B)
    test = controllability(dual.T, pushed.T)
    return _fixed(test, discrete, rounding(dual, pushed), "stabilisable", "no control changes it")


@accepts_state_space(C="H")
def detectability(A: MatrixLike, H: MatrixLike | None = None) -> FixedSpectrum:
    """Decide whether x' = Ax, z = Hx has an asymptotic observer, and how fast it can be.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Exact or floats, or a StateSpace, which has its own `H`; symbols as in `stabilisability`.
    H : matrix_like, shape (m, n), optional
        Matrix of the output.

    Returns
    -------
    FixedSpectrum
        True in an `if` if the system is detectable.

    Raises
    ------
    ValueError
        If shapes do not fit, or if the sign of a real part is not known.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB has no word for it (PBH test). Source: Theorem 3.1 and example 3 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = detectability(sp.Matrix([[1, 0], [0, -2]]), sp.Matrix([[0, 1]]))
    >>> bool(found), found.degree, found.obstacles[0].vectors.T
    (False, -1, Matrix([[1, 0]]))
    """
    discrete, (A, H) = is_discrete(A), read_observed(A, H)
    test = observability(A, H)
    return _fixed(test, discrete, rounding(A, H), "detectable", "no output shows it")


@accepts_state_space(C="H")
def best_degree(
    A: MatrixLike, B: MatrixLike | None = None, H: MatrixLike | None = None
) -> sp.Expr | float:
    """Return the greatest degree of stability of a regulator, an observer or both.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system, exact or floats, or a StateSpace with its own `B` and `H`, of which both
        are taken unless one is given.
    B : matrix_like, shape (n, s), optional
        Matrix of the control, for u = Kx.
    H : matrix_like, shape (m, n), optional
        Matrix of the output, for an observer; with `B` for a feedback by the estimate.

    Returns
    -------
    sympy.Expr or float
        The degree of stability of Definition 1.5; `sp.oo` if every one is possible.

    Raises
    ------
    ValueError
        If neither `B` nor `H` is given, and as `stabilisability` and `detectability`.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    Source: examples 3, 6 and 9 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> A = sp.Matrix([[-1, 2, 1], [0, 3, 2], [-1, -2, -3]])
    >>> B, H = sp.Matrix([1, 1, -1]), sp.Matrix([[0, 2, 1]])
    >>> best_degree(A, B), best_degree(A, H=H), best_degree(A, B, H)
    (2, 1, 1)
    """
    if is_state_space(A) and B is None and H is None:
        return min(stabilisability(A).degree, detectability(A).degree)
    if B is None and H is None:
        raise ValueError("B, H: expected the matrix of the control, that of the output, or both")
    tests = [
        test(A, matrix)
        for test, matrix in ((stabilisability, B), (detectability, H))
        if matrix is not None
    ]
    return min(test.degree for test in tests)


def rounding(A, H):
    """Return how far rounding may move a rate of a pair of floats from zero; 0 for an exact pair."""
    return 10 * tolerance(len(A)) * balanced(A, H).rate if isinstance(A, np.ndarray) else 0


def _fixed(test, discrete, limit, word, explanation):
    rates = [slowest_rate(mode.eigenvalue, discrete, limit) for mode in test.hidden_modes]
    obstacles = tuple(
        mode for mode, rate in zip(test.hidden_modes, rates) if not _decays(rate, mode)
    )
    if not rates:
        degree = sp.oo if test.margin is None else np.inf
        if discrete:
            return FixedSpectrum((), (), 1.0, f"{word}: no eigenvalue is fixed, all may be zero")
        return FixedSpectrum(
            (), (), degree, f"{word}, with any degree of stability: no eigenvalue is fixed"
        )
    degree = -_greatest(rates)
    names = list(dict.fromkeys(_named(mode.eigenvalue) for mode in obstacles or test.hidden_modes))
    named = ", ".join(names)
    if obstacles:
        reason = f"not {word}: a mode with {named} does not decay, and {explanation}"
    else:
        are = "is" if len(names) == 1 else "are"
        reason = f"{word}, with a degree of stability of at most {degree}: {named} {are} fixed, and {explanation}"
    return FixedSpectrum(tuple(test.hidden_modes), obstacles, degree, reason)


def slowest_rate(eigenvalue, discrete=False, limit=0):
    """Return the rate of an eigenvalue; of several conjugate ones the greatest."""
    if isinstance(eigenvalue, sp.Poly):
        if eigenvalue.domain.is_Composite or eigenvalue.free_symbols_in_domain:
            raise ValueError(
                f"A: the roots of {eigenvalue.as_expr()} are fixed, and their real parts depend on "
                "parameters; give these values"
            )
        roots = eigenvalue.all_roots()
        return _greatest([sp.Abs(root) - 1 if discrete else sp.re(root) for root in roots])
    if isinstance(eigenvalue, sp.Basic):
        return sp.simplify(sp.Abs(eigenvalue) - 1 if discrete else sp.re(eigenvalue))
    rate = float(np.abs(eigenvalue) - 1 if discrete else np.real(eigenvalue))
    return rate if abs(rate) > limit else 0.0


def _greatest(rates):
    if any(isinstance(rate, sp.Basic) and rate.free_symbols for rate in rates):
        return sp.Max(*rates)
    return max(rates, key=lambda rate: float(rate))


def _decays(rate, mode):
    decays = rate < 0
    if decays not in (True, False, sp.true, sp.false):
        raise ValueError(
            f"A: whether the fixed mode with the eigenvalue {mode.eigenvalue} decays depends on "
            "its symbols; give them values or assumptions (positive=True)"
        )
    return bool(decays)


def _named(eigenvalue):
    if isinstance(eigenvalue, sp.Poly):
        return f"a root of {eigenvalue.as_expr()}"
    if isinstance(eigenvalue, sp.Basic):
        return f"lambda = {eigenvalue}"
    return f"lambda = {complex(eigenvalue) if np.imag(eigenvalue) else np.real(eigenvalue):.6g}"
