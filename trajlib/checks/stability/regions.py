"""Regions of parameters in which a linear system is stable.

The truth at a point comes from the spectrum there: the roots themselves and, on the boundary, Routh's reduction in
exact fractions. Where the boundary can lie is found from the coefficients and the last but one Hurwitz determinant
(Orlando: it vanishes wherever two roots are opposite), so no narrow piece of the region is missed on a line.
"""

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from trajlib.checks.contract import coercion
from trajlib.checks.contract.verdict import Wrong, judged
from trajlib.checks.tools.exact_polynomials import exact
from trajlib.checks.tools.semialgebraic import Condition, as_text, cells, lines


@judged
def stability_region(answer, system, parameters, margin=0):
    """The set of parameters for which every root has real part below `-margin` (asymptotic stability for 0).

    `system` is a characteristic polynomial in one further symbol or a square matrix. Parameters where the order of
    the equation drops are accepted either way; with a positive margin (Definition 1.5, Re <= -mu) so is the boundary.
    """
    what = "stable" if margin == 0 else "stable with the margin"
    return compare_region(answer, system, parameters, roots_left_of, what, margin)


@judged
def stable_equation(answer, equation, motion, parameters):
    """The parameters for which the zero solution of the linear differential equation `equation` = 0 is asymptotically
    stable.

    `motion` is the unknown x(t). Parameters where the order of the equation drops are accepted either way.
    """
    return compare_region(answer, characteristic_of(equation, motion), parameters, roots_left_of, "stable")


@judged
def instability_region(answer, system, parameters):
    """The set of parameters for which some root has a positive real part (part 2 of Theorems 1.1 and 1.4)."""
    return compare_region(answer, system, parameters, some_root_right, "unstable by a root with positive real part")


def compare_region(answer, system, parameters, holds_for, what, margin=0):
    """Compare a claimed region with the property `holds_for(coefficients)`, called `what` in messages."""
    claim = Condition(coercion.as_condition(answer, parameters), parameters)
    truth = _Spectrum(system, parameters, margin)
    polynomials = truth.boundaries + claim.boundaries
    extra = 0 if claim.is_semialgebraic else 60
    checked = 0
    for point, direction in lines(parameters, count=40 if extra == 0 else 12):
        inside, on = cells(point, direction, polynomials, extra=extra)
        for place in inside + (on if margin == 0 else []):
            coefficients = truth.coefficients(place)
            if coefficients[0] == 0:
                continue  # the order drops here: a convention, not a property
            holds = holds_for(coefficients)
            checked += 1
            if claim.holds(place) != holds:
                says = (f"outside your region, yet it is {what}" if holds
                        else f"inside your region, yet it is not {what}")
                raise Wrong(f"the point {as_text(parameters, place)} lies {says}: {truth.describe(place)}")
    return f"agrees with the roots at {checked} points on both sides of every boundary"


def characteristic_of(equation, motion):
    """The characteristic polynomial of a linear equation: its left-hand side for x(t) = e^(s t), divided by e^(s t)."""
    (time,) = motion.args
    s = sp.Dummy("s")
    return sp.expand(sp.expand(equation.subs(motion, sp.exp(s * time)).doit()) * sp.exp(-s * time))


class _Spectrum:
    """The characteristic polynomial as a function of the parameters, shifted by the margin."""

    def __init__(self, system, parameters, margin):
        self.parameters, self.margin = list(parameters), sp.nsimplify(margin)
        if isinstance(system, sp.MatrixBase):
            characteristic = system.charpoly()
            symbol, polynomial = characteristic.gen, characteristic.as_expr()
        else:
            (symbol,) = system.free_symbols - set(parameters)
            polynomial = sp.sympify(system)
        shifted = sp.Poly(sp.expand(polynomial.subs(symbol, symbol - self.margin)), symbol)
        self._terms = [sp.Poly(c, *parameters, domain="QQ") for c in shifted.all_coeffs()]

    @property
    def boundaries(self):
        """Leading and last coefficient and the Hurwitz determinant of order n - 1."""
        n = len(self._terms) - 1
        found = [self._terms[0], self._terms[-1]]
        if n > 1:
            hurwitz = sp.Matrix(n - 1, n - 1, lambda i, j: self._term(2 * j - i + 1).as_expr())
            matrix = DomainMatrix.from_Matrix(hurwitz)
            found.append(sp.Poly(matrix.domain.to_sympy(matrix.charpoly()[-1]), *self.parameters, domain="QQ"))
        return [poly for poly in found if not poly.is_ground]

    def _term(self, k):
        return self._terms[k] if 0 <= k < len(self._terms) else sp.Poly(0, *self.parameters, domain="QQ")

    def coefficients(self, place):
        return [exact(c).value(place) for c in self._terms]

    def describe(self, place):
        largest = max(np.roots([float(c) for c in self.coefficients(place)]).real)
        # Roots computed in floating point: below this the place lies on the imaginary axis, which Routh has decided.
        on_axis = abs(largest) < 1e-9 and self.margin == 0
        return "the largest real part of a root is " + ("exactly 0" if on_axis
                                                        else f"{largest - float(self.margin):.4g}")


def roots_left_of(coefficients):
    """True if all roots have negative real parts: by Routh's reduction in exact arithmetic, which floats cannot
    fool."""
    current = coefficients if coefficients[0] > 0 else [-c for c in coefficients]
    while len(current) > 1:
        if any(c <= 0 for c in current):
            return False
        ratio = current[0] / current[1]
        current = [c - ratio * (current[k + 1] if k % 2 == 0 and k + 1 < len(current) else 0)
                   for k, c in enumerate(current)][1:]
    return True


def some_root_right(coefficients):
    """True if a root has a positive real part; close to the axis decided by shifting the axis a little."""
    roots = np.roots([float(c) for c in coefficients])
    return bool(max(roots.real) > 1e-7 * (1 + max(abs(roots))))
