"""Loop functions L = n/o of loops with one control, at values of their symbols, and their margins.

The loop is cut at the control, and the closed loop has the polynomial o + n. Where |L| = 1, where L is
real and where |1 + L| is stationary are roots of polynomials in the frequency.
"""

import math
from functools import cached_property

import mpmath
import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references import processes
from workbook.checks.references.regulators import Regulator
from workbook.systems import Linear, Quadratic

_S, _OMEGA = sp.Symbol("s"), sp.Symbol("omega", real=True)
#: Coefficients smaller than this share of their terms are zero up to the rounding of a gain.
ROUNDED = 1e-12
#: Digits of roots, and the share of its modulus up to which the imaginary part of one is zero.
DIGITS, REAL = 30, 1e-9


def loop_at(values, loop, K=None, L=None, process=None):
    """Return the `LoopFunction` of a loop at values of its symbols.

    Parameters
    ----------
    values : dict
        {symbol: value}.
    loop : sympy.Expr, Linear or Quadratic
        The loop function itself; a plant; or a plant with the cost that the gain K minimises.
    K, L : sympy.Matrix, optional
        The gains of u = Kx, or u = Ke with an observer, of a plant.
    process : Process, optional
        What the filter that estimates the state of a `Quadratic` is made for.

    Raises
    ------
    UnsuitableData
        If the loop is not asymptotically stable, or no loop with one control.
    """
    if isinstance(loop, sp.Expr):
        numerator, opened = sp.fraction(sp.cancel(sp.together(loop.subs(values))))
        symbols = numerator.free_symbols | opened.free_symbols
        if len(symbols) != 1:
            raise UnsuitableData("loop: expected a function of one symbol beside the parameters")
        return LoopFunction(*(_exact(part, *symbols) for part in (numerator, opened)))
    if loop.B.cols != 1:
        raise UnsuitableData("loop: expected a plant with one control")
    plant, H = Linear(loop.A, loop.B).subs(values), getattr(loop, "H", None)
    if isinstance(loop, Quadratic):
        regulator = Regulator(loop, values)
        K = sp.Matrix(regulator.gain_for(regulator.least())).applyfunc(sp.Rational)
        if process is not None:
            noise, H = processes.at_values(process, values, start=False), process.H
            gain = processes.filter_gain(noise, processes.steady_covariances(noise)[0])
            L = sp.Matrix(gain).applyfunc(sp.Rational)
    elif K is None:
        raise UnsuitableData("K: expected the gain of the control beside a plant")
    K, L = (gain if gain is None else sp.Matrix(gain).subs(values) for gain in (K, L))
    opened = _polynomial(plant.A)
    regulated = plant.A + plant.B * K
    closed = _polynomial(regulated)
    if L is not None:
        output = L * H.subs(values)
        opened *= _polynomial(regulated - output)
        closed *= _polynomial(plant.A - output)
    return LoopFunction(_trimmed(closed - opened, opened), opened)


def _polynomial(matrix):
    return _exact(matrix.charpoly(_S).as_expr(), _S)


def _exact(expression, symbol):
    """Return a polynomial with fractions for coefficients, to many digits."""
    coefficients = sp.Poly(expression, symbol).all_coeffs()
    return sp.Poly(
        [sp.Rational(str(c.evalf(2 * DIGITS))) if not c.is_Rational else c for c in coefficients],
        _S,
    )


def _trimmed(polynomial, size):
    """Return a polynomial without coefficients that are small beside the largest of another one."""
    largest = ROUNDED * max(abs(c) for c in size.all_coeffs())
    return sp.Poly([c if abs(c) > largest else 0 for c in polynomial.all_coeffs()], polynomial.gen)


class LoopFunction:
    """A stable loop with the loop function numerator/opened, two polynomials in s with numbers."""

    def __init__(self, numerator, opened):
        if not 0 < opened.degree() >= numerator.degree() or numerator.is_zero:
            raise UnsuitableData(
                "loop: expected a function with poles, not zero, and no more zeros than poles"
            )
        self.numerator, self.opened = numerator, opened
        if not self.rightmost().real < -REAL:
            raise UnsuitableData(
                "loop: expected an asymptotically stable loop; others have no margins"
            )
        (a, b), (c, d) = map(_on_axis, (numerator, opened))
        self._open, self._numerator = c**2 + d**2, a**2 + b**2
        self._closed = (a + c) ** 2 + (b + d) ** 2
        # n conj o = in phase + i turned
        self._in_phase, self._turned = a * c + b * d, _difference(b, c, a, d)

    def rightmost(self, factor=1.0):
        """Return the root of 1 + factor L = 0 with the largest real part, for a complex factor."""
        numerator, opened = (
            np.array(part.all_coeffs(), dtype=complex) for part in (self.numerator, self.opened)
        )
        opened[len(opened) - len(numerator) :] += factor * numerator
        return max(np.roots(opened), key=lambda root: root.real)

    def roots_with_delay(self, delay):
        """Yield roots of 1 + L e^(-s delay) = 0 that were on the axis with a smaller delay."""
        numerator, opened = (
            np.poly1d([float(c) for c in part.all_coeffs()])
            for part in (self.numerator, self.opened)
        )
        for omega, angle in self.crossings:
            first = angle / omega
            if first < delay:
                root = 1j * omega
                for step in np.linspace(first, min(delay, 2 * first), 101)[1:]:
                    for _ in range(3):  # Newton's method
                        lag = np.exp(-root * step)
                        slope = opened.deriv()(root) + lag * (
                            numerator.deriv()(root) - step * numerator(root)
                        )
                        root -= (opened(root) + lag * numerator(root)) / slope
                yield root

    def frequency_within(self, distance):
        """Return a frequency at which the curve is nearer to -1 than `distance`, or None.

        It lies on a grid, and away from the frequency of the smallest distance.
        """
        grid = np.concatenate([[0.0], np.geomspace(1e-3, 1e3, 601)])
        numerator, opened = (
            np.polyval([float(c) for c in part.all_coeffs()], 1j * grid)
            for part in (self.numerator, self.opened)
        )
        (near,) = np.nonzero(abs(opened + numerator) < distance * abs(opened))
        return float(grid[near[(3 * len(near)) // 4]]) if len(near) else None

    @cached_property
    def gain(self):
        """The ends (low, high) of the interval about 1 of factors for which the loop is stable."""
        factors = [
            -float(self._in_phase.eval(w) / self._numerator.eval(w))
            for w in _frequencies(self._turned, self._numerator)
        ]
        high_frequency = self._at_infinity()
        factors += [-1 / high_frequency] if high_frequency else []
        return (
            max((m for m in factors if 0 < m < 1), default=0.0),
            min((m for m in factors if m > 1), default=math.inf),
        )

    @cached_property
    def crossings(self):
        """Pairs (frequency, angle) where |L| = 1: clockwise by the angle, below 2 pi, L comes to -1."""
        pairs, one = [], sp.Poly(1, _OMEGA)
        for w in _frequencies(_difference(self._numerator, one, self._open, one)):
            in_phase, turned = (
                float(part.eval(w) / self._open.eval(w)) for part in (self._in_phase, self._turned)
            )
            pairs.append((float(w), math.atan2(-turned, -in_phase) % (2 * math.pi)))
        return pairs

    @property
    def phase(self):
        """The smallest angle by which the curve, turned to either side, comes to -1."""
        return min(
            (min(angle, 2 * math.pi - angle) for _, angle in self.crossings), default=math.inf
        )

    @property
    def delay(self):
        """The smallest delay with which the loop is not asymptotically stable."""
        if abs(self._at_infinity()) >= 1:
            return 0.0
        return min((angle / w for w, angle in self.crossings), default=math.inf)

    @cached_property
    def disk(self):
        """The distance of the curve from -1."""
        slope = _difference(self._closed.diff(), self._open, self._closed, self._open.diff())
        distances = [
            float(sp.sqrt(self._closed.eval(w) / self._open.eval(w)))
            for w in _frequencies(slope, self._open)
        ]
        return min([*distances, abs(1 + self._at_infinity())])

    def _at_infinity(self):
        return float(self.numerator.coeff_monomial(_S ** self.opened.degree()) / self.opened.LC())


def _on_axis(polynomial):
    """Return the real and the imaginary part of a polynomial at i omega."""
    parts = {}, {}
    for (power,), value in polynomial.as_dict().items():
        parts[power % 2][(power,)] = value * (-1) ** (power // 2)
    return [sp.Poly(part or {(0,): 0}, _OMEGA) for part in parts]


def _difference(a, b, c, d):
    """Return ab - cd without coefficients that are zero up to rounding."""
    product = a * b - c * d
    a, b, c, d = (
        sp.Poly([abs(value) for value in part.all_coeffs()], _OMEGA) for part in (a, b, c, d)
    )
    size = a * b + c * d
    terms = {
        power: value
        for power, value in product.as_dict().items()
        if abs(value) > ROUNDED * size.coeff_monomial(_OMEGA ** power[0])
    }
    return sp.Poly(terms or {(0,): 0}, _OMEGA)


def _frequencies(polynomial, divisor=None):
    """Return the positive roots of a polynomial in the frequency.

    With a `divisor`, its roots do not count, and 0 does.
    """
    zero = [sp.Integer(0)] if divisor is not None and divisor.eval(0) else []
    if polynomial.degree() < 1:
        return zero
    polynomial = polynomial.sqf_part()
    if divisor is not None:
        polynomial = sp.quo(polynomial, sp.gcd(polynomial, divisor))
    if polynomial.degree() < 1:
        return zero
    try:
        roots = map(complex, polynomial.nroots(n=DIGITS, maxsteps=200))
    except mpmath.libmp.NoConvergence:  # several roots that rounding alone keeps apart
        roots = np.roots([float(c) for c in polynomial.monic().all_coeffs()])
    return zero + [
        sp.Float(root.real)
        for root in roots
        if root.real > REAL and abs(root.imag) < REAL * abs(root)
    ]
