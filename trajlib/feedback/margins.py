r"""Gain, phase, delay and disk margin of a loop with one control.

Cut the loop at the control. What comes back is -L(s) times what was fed in, with the loop function

    L(s) = -K (sI - A)^-1 B                                         feedback of the state, u = Kx
    L(s) = -K (sI - A - BK + L_o H)^-1 L_o H (sI - A)^-1 B          feedback of an estimate

Let o(s) be the denominator of L and c(s) = o(s) + n(s) the polynomial of the closed loop, so that 1 + L = c/o.
All margins are decided on the imaginary axis, where the squares of moduli are polynomials in w = omega^2:

    gain    m with o + m n = 0                      Im(n conj o) = 0
    phase   phi with e^(-i phi) L = -1              |n|^2 = |o|^2, cos phi = -Re L = 1 - |c|^2/(2 |o|^2)
    delay   tau with e^(-i omega tau) L = -1        the same, tau = phi/omega with 0 < phi < 2 pi
    disk    the minimum of |1 + L|^2 = |c|^2/|o|^2  its derivative by w vanishes, or w is 0 or infinite
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp

from trajlib import plotting
from trajlib._arguments.matrices import (
    any_floats,
    is_state_space,
    read_controlled,
    read_matrix,
    read_observed,
)
from trajlib._arguments.state_space import accepts_state_space, is_discrete
from trajlib._arguments.symbols import exact_decimals
from trajlib._typing import ExprLike, MatrixLike, Scalar
from trajlib.stability.hurwitz import characteristic_polynomial, hurwitz_minors

if TYPE_CHECKING:
    from control import StateSpace
    from matplotlib.axes import Axes

_S, _W = sp.Symbol("s"), sp.Symbol("w")
#: Digits to which candidates are compared with one another.
_DIGITS = 30
#: By this share the numbers of a system of floats are changed to estimate the error.
_UNIT = sp.Rational(1, 2**52)
_MARGINS = ("gain", "phase", "delay", "disk")


@accepts_state_space("A", "B", time="continuous", instead="margins are those of continuous time")
def loop_function(
    A: MatrixLike,
    B: MatrixLike,
    K: MatrixLike,
    H: MatrixLike | None = None,
    L: MatrixLike | None = None,
    symbol: sp.Symbol | None = None,
) -> sp.Expr | StateSpace:
    """Return the loop function of u = Kx, or of u = Ke with an observer, cut at the control.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; or a python-control StateSpace, in place of `A` and `B`.
    B : matrix_like, shape (n, 1)
        Matrix of the single control.
    K : matrix_like, shape (1, n)
        The gain of u = Kx (plus sign).
    H : matrix_like, shape (m, n), optional
        Matrix of the output z = Hx, if an observer estimates the state.
    L : matrix_like, shape (n, m), optional
        Its gain in e' = Ae + Bu + L(z - He); `H` and `L` are given together.
    symbol : sympy.Symbol, optional
        The variable, by default `Symbol("s")`.

    Returns
    -------
    sympy.Expr or control.StateSpace
        A rational function, or of matrices with floats a system. The closed loop has the roots of 1 + L(s) = 0 (and
        modes that L does not contain).

    Raises
    ------
    ValueError
        If shapes do not fit, if only one of `H` and `L` is given, or if a system is in discrete time.

    Notes
    -----
    Source: Anderson and Moore, Optimal Control: Linear Quadratic Methods, chapters 5 and 8.

    Examples
    --------
    >>> import sympy as sp
    >>> loop_function(sp.Matrix([[0, 1], [0, 0]]), [0, 1], [[-1, -2]])
    (2*s + 1)/s**2
    """
    floats = any_floats(A, B, K, H, L)
    A, B = (matrix.T for matrix in read_controlled(A, B))
    n, controls = B.shape
    if controls != 1:
        raise ValueError(f"B: expected one control, that is one column, got {controls}")
    K = read_matrix(K, "K", 1, n, floats)
    if (H is None) != (L is None):
        raise ValueError(
            f"{'H' if H is None else 'L'}: expected with an observer, H and L together"
        )
    if H is not None:
        A, H = read_observed(A, H)
        L = read_matrix(L, "L", n, H.shape[0], floats, flat="column" if n > 1 else "row")
    if floats:
        return _system_of_loop(A, B, K, H, L)
    symbol = _S if symbol is None else symbol
    regulator, opened = A + B * K, characteristic_polynomial(A, symbol)
    closed = characteristic_polynomial(regulator, symbol)
    if H is not None:
        opened = opened * characteristic_polynomial(regulator - L * H, symbol)
        closed = closed * characteristic_polynomial(A - L * H, symbol)
    return sp.factor(sp.cancel((closed - opened) / opened))


def _system_of_loop(A, B, K, H, L):
    # python-control takes a second to load
    from control import ss

    A, B = (np.array(matrix, dtype=float) for matrix in (A, B))
    if H is None:
        return ss(A, B, -K, 0)
    H = np.array(H, dtype=float)
    whole = np.block([[A, 0 * A], [L @ H, A + B @ K - L @ H]])
    return ss(whole, np.vstack([B, 0 * B]), np.hstack([0 * K, -K]), 0)


@dataclass(frozen=True)
class LoopMargins:
    """The margins of a stable loop, exact for an exact loop function and floats otherwise.

    Attributes
    ----------
    gain : tuple of scalar
        The interval (low, high) of factors m > 0 of the control for which the loop stays asymptotically
        stable; 1 lies inside. `high` may be infinite, `low` zero.
    phase : scalar
        The least phase shift in radians, to either side, that brings the curve of L to -1; infinite if none does.
    phase_frequency : scalar or None
        The frequency at which it does so, in radians per unit of time.
    delay : scalar
        The least delay of the control that makes the loop lose its stability; infinite if none does.
    delay_frequency : scalar or None
        The frequency of the oscillation that then appears.
    disk : scalar
        The distance min |1 + L(i omega)| of the curve from -1; its inverse is the peak of the sensitivity 1/(1 + L).
    disk_frequency : scalar
        The frequency of the minimum, which may be infinite.
    loop : sympy.Expr
        The loop function as a function of s.
    error : float
        Zero for an exact loop. Of floats, an estimate of the relative error of the margins: how far they change if
        the numbers of the system change by a unit of their last binary digit, in two patterns of signs; infinite if
        a margin appears or vanishes.
    """

    gain: tuple[Scalar, Scalar]
    phase: Scalar
    phase_frequency: Scalar | None
    delay: Scalar
    delay_frequency: Scalar | None
    disk: Scalar
    disk_frequency: Scalar
    loop: sp.Expr
    error: float = 0.0

    def _repr_markdown_(self):
        low, high = map(_shown, self.gain)
        rows = [f"| gain | {low} to {high} | |"]
        rows += [
            f"| {name} | {_shown(getattr(self, name))} | {_shown(getattr(self, f'{name}_frequency'))} |"
            for name in _MARGINS[1:]
        ]
        return "\n".join(["| margin | | frequency |", "|---|---|---|", *rows])

    @property
    def guaranteed_gain(self) -> tuple[Scalar, Scalar]:
        """The factors 1/(1 + d) < m < 1/(1 - d) that the disk of radius d alone guarantees."""
        d = self.disk
        return 1 / (1 + d), sp.oo if d >= 1 else 1 / (1 - d)

    @property
    def guaranteed_phase(self) -> Scalar:
        """The phase shift 2 arcsin(d/2), in radians, that the disk of radius d alone guarantees."""
        return 2 * (
            sp.asin(self.disk / 2) if isinstance(self.disk, sp.Basic) else np.arcsin(self.disk / 2)
        )

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the Nyquist curve of L with the point -1 and the disk that the curve does not enter.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            The axes to draw on; new ones by default.

        Returns
        -------
        matplotlib.axes.Axes
            The axes.
        """
        # Matplotlib, for a plot only
        import matplotlib.pyplot as plt

        (symbol,) = self.loop.free_symbols
        value = sp.lambdify(symbol, self.loop, "numpy")
        crossings = (self.phase_frequency, self.delay_frequency)
        scale = max([float(w) for w in crossings if w and w != sp.oo], default=1.0)
        curve = value(1j * scale * np.geomspace(1e-3, 1e3, 4000))
        with plotting.style():
            ax = plt.subplots()[1] if ax is None else ax
            ax.plot(
                curve.real, curve.imag, color=plotting.BLUE, label=r"$L(i\omega)$, $\omega > 0$"
            )
            ax.plot(
                curve.real,
                -curve.imag,
                "--",
                color=plotting.BLUE,
                label=r"$L(i\omega)$, $\omega < 0$",
            )
            around = float(self.disk) * np.exp(1j * np.linspace(0, 2 * np.pi, 200)) - 1
            ax.fill(around.real, around.imag, color=plotting.GREY, alpha=0.4, label="disk margin")
            ax.plot(-1, 0, "+", color=plotting.RED, ms=10, label="$-1$")
            ax.set(
                xlim=(-3.2, 1.2),
                ylim=(-2.2, 2.2),
                xlabel=r"$\mathrm{Re}\,L$",
                ylabel=r"$\mathrm{Im}\,L$",
            )
            ax.set_aspect("equal")
            # below: the curve may pass through any corner
            ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), ncol=2)
        return ax


def loop_margins(loop: ExprLike) -> LoopMargins:
    """Return the gain, phase, delay and disk margin of a loop with negative feedback.

    Parameters
    ----------
    loop : sympy.Expr, or a python-control StateSpace or TransferFunction
        The loop function L(s), a rational function of one symbol with numbers as coefficients; or a system in
        continuous time with one input and one output. The closed loop is 1/(1 + L).

    Returns
    -------
    LoopMargins
        Exact for an expression (roots of polynomials in radicals or as `CRootOf`), floats for a system.

    Raises
    ------
    TypeError
        If `loop` is none of these.
    ValueError
        If it has parameters, several inputs or outputs, discrete time, more zeros than poles, or if the closed loop
        is not asymptotically stable, so that it has no margins.

    Notes
    -----
    MATLAB: allmargin, diskmargin. python-control: stability_margins, disk_margins.
    Source: Seiler, Packard and Gahinet, An introduction to disk margins, IEEE Control Systems 40 (2020),
    78-95; the disk here is theirs for the sensitivity (skew 1).

    Examples
    --------
    >>> import sympy as sp
    >>> s = sp.Symbol("s")
    >>> margins = loop_margins(1/(s*(s + 1)*(s + 2)))
    >>> margins.gain
    (0, 6)
    >>> round(float(margins.phase), 4), round(float(margins.disk), 4)
    (0.9322, 0.6376)
    """
    opened, numerator, exact = _read_loop(loop)
    results = _margins_of(opened, numerator, exact)
    value = numerator.as_expr() / opened.as_expr()
    if exact:
        return LoopMargins(**results, loop=value)
    results = _in_floats(results)
    error = max(_difference(results, loop, pattern) for pattern in (1, 2))
    return LoopMargins(**results, loop=value, error=max(error, float(_UNIT / 2)))


def _difference(results, loop, pattern):
    """Return how far the margins change, relatively, with the numbers of a system of floats."""
    try:
        others = _in_floats(_margins_of(*_read_loop(loop, pattern)))
    except ValueError:
        return np.inf
    pairs = np.transpose(
        [np.hstack([found[name] for name in _MARGINS]) for found in (results, others)]
    )
    return max(
        0.0 if a == b else abs(a - b) / max(a, b) if np.isfinite(a + b) else np.inf
        for a, b in pairs.tolist()
    )


def _margins_of(opened, numerator, exact):
    """Return the attributes of `LoopMargins` as numbers of SymPy."""
    closed = opened + numerator
    if closed.degree() < opened.degree() or not all(
        sp.N(minor, _DIGITS) > 0 for minor in hurwitz_minors(closed.as_expr() / closed.LC(), _S)
    ):
        raise ValueError(
            "loop: expected a closed loop that is asymptotically stable; others have no margins"
        )
    (o_even, o_odd), (n_even, n_odd) = _on_the_axis(opened), _on_the_axis(numerator)
    at_o, at_n = _squared_modulus(o_even, o_odd), _squared_modulus(n_even, n_odd)
    at_c = _squared_modulus(o_even + n_even, o_odd + n_odd)
    # o conj n = real + i omega turned, and turned has the sign of Im(-L) for omega > 0.
    real = o_even * n_even + sp.Poly(_W, _W) * o_odd * n_odd
    turned = o_odd * n_even - o_even * n_odd
    at_infinity = numerator.coeff_monomial(_S ** opened.degree()) / opened.LC()
    phases, delays = _crossings(_squares(at_n - at_o, exact), at_c, at_o, turned)
    if abs(at_infinity) >= 1:
        delays = [(sp.Integer(0), sp.oo)]
    slope = at_c.diff() * at_o - at_c * at_o.diff()
    results = {
        "gain": _gain_interval(real, at_n, _squares(turned, exact, at_n), at_infinity),
        "disk": _disk(at_c, at_o, _squares(slope, exact, at_o)),
        "phase": _least(phases),
        "delay": _least(delays),
    }
    for name in _MARGINS[1:]:
        results[name], results[f"{name}_frequency"] = results[name]
    return results


def _in_floats(results):
    return {
        name: tuple(map(float, found))
        if isinstance(found, tuple)
        else found
        if found is None
        else float(found)
        for name, found in results.items()
    }


def _read_loop(loop, pattern=0):
    """Return denominator and numerator without common roots, and whether they are exact.

    With a pattern 1 or 2 each number of a system of floats is changed by a unit of its last binary digit, up
    or down by this bit of its index.
    """
    exact = not (is_state_space(loop) or hasattr(loop, "num"))
    if exact:
        if not isinstance(loop, (sp.Expr, int)):
            raise TypeError(
                f"loop: expected a rational function or a system of python-control, got {loop!r}"
            )
        loop = exact_decimals(sp.sympify(loop))
        symbols = loop.free_symbols
        if len(symbols) != 1:
            raise ValueError(
                f"loop: expected a function of one symbol with numbers as coefficients, got {sorted(map(str, symbols))}"
            )
        numerator, opened = sp.fraction(sp.cancel(sp.together(loop.subs(symbols.pop(), _S))))
    else:
        if is_discrete(loop) or loop.dt:
            raise ValueError(f"loop: expected a system in continuous time, got dt = {loop.dt}")
        if (loop.ninputs, loop.noutputs) != (1, 1):
            raise ValueError(
                f"loop: expected one input and one output, got {loop.ninputs} and {loop.noutputs}"
            )
        numerator, opened = _polynomials_of(loop, pattern)
    if not (numerator.is_polynomial(_S) and opened.is_polynomial(_S)):
        raise ValueError(f"loop: expected a rational function, got {loop}")
    numerator, opened = (sp.Poly(part, _S, extension=True) for part in (numerator, opened))
    if numerator.is_zero or not 0 < opened.degree() >= numerator.degree():
        raise ValueError("loop: expected a loop function with poles, and no more zeros than poles")
    common = sp.gcd(numerator, opened)
    return sp.quo(opened, common), sp.quo(numerator, common), exact


def _polynomials_of(system, pattern):
    """Return numerator and denominator of a system of floats, with the exact values of its floats."""
    index = itertools.count()

    def exact(number):
        change = _UNIT if next(index) & pattern else -_UNIT
        return sp.Rational(float(number)) * (1 + change if pattern else 1)

    if is_state_space(system):
        A, B, C, D = (
            sp.Matrix(np.asarray(m)).applyfunc(exact)
            for m in (system.A, system.B, system.C, system.D)
        )
        opened = characteristic_polynomial(A, _S)
        return characteristic_polynomial(A - B * C, _S) - opened + D[0] * opened, opened
    return tuple(
        sp.Poly([exact(c) for c in part[0][0]], _S).as_expr() for part in (system.num, system.den)
    )


def _on_the_axis(polynomial):
    """Return (even, odd), polynomials in w, with p(i omega) = even + i omega odd and w = omega^2."""
    parts = [[], []]
    for power, coefficient in enumerate(reversed(polynomial.all_coeffs())):
        parts[power % 2].append(coefficient * (-1) ** (power // 2))
    return tuple(sp.Poly(part[::-1] or [0], _W, extension=True) for part in parts)


def _squared_modulus(even, odd):
    return even**2 + sp.Poly(_W, _W) * odd**2


def _squares(polynomial, exact, divisor=None):
    """Return the roots w = omega^2 > 0 of a polynomial; as long decimals if it comes from floats.

    With a `divisor`, its roots do not count, and w = 0 does: a quotient by it is looked for there.
    """
    roots = []
    if divisor is not None:
        roots = [sp.Integer(0)] if divisor.eval(0) else []
        if polynomial:
            polynomial = sp.quo(polynomial.sqf_part(), sp.gcd(polynomial.sqf_part(), divisor))
    if polynomial.degree() > 0:
        found = [root for root in polynomial.sqf_part().real_roots() if sp.N(root, _DIGITS) > 0]
        roots += found if exact else [sp.N(root, 2 * _DIGITS) for root in found]
    return roots


def _gain_interval(real, at_n, squares, at_infinity):
    """Return the interval about 1 of the factors m for which o + m n has no root on the axis.

    On the axis m = -Re(o conj n)/|n|^2, with `real` and `at_n` as polynomials in w.
    """
    factors = [_simple(-real.eval(w) / at_n.eval(w)) for w in squares]
    if at_infinity:
        factors.append(-1 / at_infinity)
    below = [m for m in factors if 0 < _number(m) < 1]
    above = [m for m in factors if _number(m) > 1]
    return max(below, key=_number, default=sp.Integer(0)), min(above, key=_number, default=sp.oo)


def _crossings(squares, at_c, at_o, turned):
    """Return the pairs (phase, frequency) and (delay, frequency) where |L| = 1."""
    phases, delays = [], []
    for w in squares:
        frequency = sp.sqrt(w)
        phase = sp.acos(_simple(1 - at_c.eval(w) / (2 * at_o.eval(w))))
        lag = phase if sp.N(turned.eval(w), _DIGITS) > 0 else 2 * sp.pi - phase
        phases.append((phase, frequency))
        delays.append((lag / frequency, frequency))
    return phases, delays


def _disk(at_c, at_o, squares):
    """Return the minimum of |c|/|o| over the frequencies, and where it is."""
    values = [(sp.sqrt(_simple(at_c.eval(w) / at_o.eval(w))), sp.sqrt(w)) for w in squares]
    return _least([*values, (sp.sqrt(at_c.LC() / at_o.LC()), sp.oo)])


def _least(pairs):
    return min(pairs, key=lambda pair: _number(pair[0])) if pairs else (sp.oo, None)


def _simple(expression):
    """Simplify radicals; an expression in roots of a polynomial stays as it is."""
    return expression if expression.has(sp.CRootOf) else sp.radsimp(sp.simplify(expression))


def _number(expression):
    return float(sp.N(expression, _DIGITS))


def _shown(number):
    """Return LaTeX of a number; of roots without radicals the decimals."""
    if number is None:
        return ""
    number = sp.sympify(number)
    if not number.has(sp.CRootOf):
        return f"${sp.latex(sp.N(number, 6) if number.has(sp.Float) else number)}$"
    return rf"$\approx {sp.N(number, 6)}$"
