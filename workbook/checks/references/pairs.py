"""Pairs of a matrix A and an output z = H x with parameters: their unobservable states.

For all values at once observability means that the Kalman determinant is not zero, or for several
outputs the sum of the squares of all its minors; at one point it is decided, exactly, by
`invariant_subspaces`.
"""

import functools
from fractions import Fraction

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.invariant_subspaces import chain, to_floats, unobservable_subspace
from workbook.checks.tools.conditions import Case, ReferenceCondition, allowed
from workbook.checks.tools.samples import cases, general_values, in_every_case


def pair_of(A, H, parameters=()):
    """Return the `Pair` of matrices as a data cell gives them."""
    return _pair(sp.ImmutableMatrix(A), sp.ImmutableMatrix(H), tuple(parameters))


class Pair:
    """A square matrix A and the matrix H of an output, rational functions of the parameters."""

    def __init__(self, A, H, parameters):
        if A.rows != A.cols or H.cols != A.cols:
            raise UnsuitableData(f"matrices of the shapes {A.shape} and {H.shape} make no system")
        self.order, self.outputs, self.parameters = A.rows, H.rows, list(parameters)
        self.unknowns = self.order  # what is asked for is the whole state
        self._quotients = [[self._quotient(entry) for entry in matrix] for matrix in (A, H)]

    def _quotient(self, entry):
        entry = sp.nsimplify(entry, rational=True) if entry.has(sp.Float) else sp.sympify(entry)
        return [
            sp.Poly(part, *(self.parameters or [sp.Dummy()]), domain="QQ")
            for part in sp.fraction(sp.together(entry))
        ]

    def at(self, point):
        """Return (A, H) as lists of rows at a point, or None where an entry is not defined."""
        n, matrices = self.order, []
        for quotients in self._quotients:
            numbers = []
            for numerator, denominator in quotients:
                below = _value(denominator, point)
                if not below:
                    return None
                numbers.append(_value(numerator, point) / below)
            matrices.append([numbers[k : k + n] for k in range(0, len(numbers), n)])
        return matrices

    def unobservable_at(self, point):
        """Return a basis of the unobservable states at a point; None if an entry is undefined."""
        rows = self.at(point)
        return None if rows is None else unobservable_subspace(*rows)

    def state_of(self, vector):
        """Return the initial state of a vector of the unknowns."""
        return vector

    @functools.cached_property
    def samples(self):
        """Pairs (values, point) for parameters in general position; one empty pair without them."""
        samples = [(values, point_of(values)) for values in general_values(self.parameters)]
        return [(values, point) for values, point in samples if self.at(point) is not None]

    def samples_for(self, claim):
        """Return (values, point, unobservable) at samples, and more for cases of an answer."""
        samples = [
            (values, point, unobservable)
            for (values, point), unobservable in zip(self.samples, self.unobservable)
        ]
        if not cases(claim):
            return samples
        sampled_values = [values for values, _ in self.samples]
        added = in_every_case(sampled_values, claim, self.generic_condition)[len(sampled_values) :]
        return samples + [
            (values, point, self.unobservable_at(point))
            for values, point in ((values, point_of(values)) for values in added)
            if self.at(point) is not None
        ]

    @functools.cached_property
    def unobservable(self):
        """The basis of the unobservable states at every sample."""
        return [self.unobservable_at(point) for _, point in self.samples]

    @functools.cached_property
    def generic_condition(self):
        """The condition that the matrices are defined and as many states unobservable as in general."""
        dimensions = set(map(len, self.unobservable))
        rank = self.unknowns - min(dimensions)
        rows = self._derivative_rows()
        # This coefficient is the sum of the squares of all minors of that size.
        minors = (rows.transpose() * rows).charpoly()[rank]
        return sp.And(
            *(sp.Ne(poly.as_expr(), 0) for poly in self._denominators),
            sp.Ne(rows.domain.to_sympy(minors), 0),
        )

    @functools.cached_property
    def systems(self):
        """(values, A, H, basis of unobservable states in rows) at every sample, as floats."""
        return self.systems_for(())

    def systems_for(self, claim):
        """Return (values, A, H, unobservable basis) at every one of `samples_for` an answer."""
        return [
            (
                values,
                *(to_floats(rows, self.order) for rows in self.at(point)),
                to_floats(unobservable, self.unknowns),
            )
            for values, point, unobservable in self.samples_for(claim)
        ]

    @functools.cached_property
    def boundaries(self):
        """Polynomials of which one vanishes wherever more states are unobservable."""
        return [poly for poly in {*self._denominators, self._determinant} if not poly.is_ground]

    @functools.cached_property
    def _denominators(self):
        return {denominator for quotients in self._quotients for _, denominator in quotients}

    @functools.cached_property
    def _determinant(self):
        """The Kalman determinant, or the sum of the squares of all minors; zero if not observable."""
        rows = self._derivative_rows()
        square = rows if rows.shape[0] == rows.shape[1] else rows.transpose() * rows
        return sp.Poly(square.domain.to_sympy(square.charpoly()[-1]), *self.parameters, domain="QQ")

    def reference(self, holds):
        """Return the `ReferenceCondition` that all unknowns are observable, or are not."""
        observable_case, unobservable_case = self._observability_cases
        inside, outside = (
            (observable_case, unobservable_case) if holds else (unobservable_case, observable_case)
        )

        def at(values):
            return (
                None
                if self._defined.subs(values) is sp.false
                else (self.dimension_at(values) == 0) == holds
            )

        return ReferenceCondition((inside,), (outside,), at)

    @functools.cached_property
    def _defined(self):
        """The condition that the matrices are defined."""
        return sp.And(*(sp.Ne(poly.as_expr(), 0) for poly in self._denominators))

    @functools.cached_property
    def _observability_cases(self):
        """The `Case` in which all unknowns are observable, and the one in which something is not."""
        return self._cases_where(sp.Eq(self._determinant.as_expr(), 0))

    def _cases_where(self, unobservable):
        """Return both cases of a condition on the parameters, where the matrices are defined."""
        return [Case(sp.And(self._defined, part)) for part in (sp.Not(unobservable), unobservable)]

    def dimension_at(self, values):
        """Return the number of independent unobservable states at exact values of the parameters."""
        if all(value.is_Rational for value in values.values()):
            return len(self.unobservable_at(point_of(values)))
        return self.unknowns - int(np.linalg.matrix_rank(self._rows_at(values), tol=1e-9))

    def _rows_at(self, values):
        rows = np.array(self._derivative_rows().to_Matrix().subs(values).evalf(30), dtype=float)
        return rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-300)

    def _derivative_rows(self):
        """Return the Kalman matrix, of the derivatives of the output at t = 0, without denominators."""
        A, H = (self._cleared(quotients) for quotients in self._quotients)
        first, *others = chain(H, A, self.order)
        return first.vstack(*others)

    def _cleared(self, quotients):
        """Return the matrix times its common denominator, over the ring of polynomials."""
        ring = sp.QQ[tuple(self.parameters)]
        common = functools.reduce(
            lambda multiple, denominator: multiple.lcm(denominator),
            (denominator for _, denominator in quotients),
        )
        entries = [
            ring.from_sympy((numerator * common.quo(denominator)).as_expr())
            for numerator, denominator in quotients
        ]
        rows = [entries[k : k + self.order] for k in range(0, len(entries), self.order)]
        return DomainMatrix(rows, (len(rows), self.order), ring)


def point_of(values):
    """Return rational values of the parameters as a point: fractions in a row."""
    return tuple(Fraction(int(x.p), int(x.q)) for x in values.values())


def special_values(polynomials, parameter):
    """Return the rational values of a parameter at which one of the polynomials vanishes."""
    roots = {root for poly in polynomials if not poly.is_ground for root in poly.ground_roots()}
    return sorted(root for root in roots if allowed(parameter, int(sp.sign(root))))


_pair = functools.lru_cache(maxsize=64)(Pair)


def _value(poly, point):
    factor, numerator = _compiled(poly)
    return (numerator if isinstance(numerator, Fraction) else Fraction(numerator(*point))) / factor


@functools.lru_cache(maxsize=512)
def _compiled(poly):
    """Return a rational polynomial as (a number, an integer polynomial as a function).

    Fractions stay fractions in its code.
    """
    factor, integer_poly = poly.clear_denoms(convert=True)
    return Fraction(int(factor)), Fraction(
        int(integer_poly.LC())
    ) if integer_poly.is_ground else sp.lambdify(poly.gens, integer_poly.as_expr(), [])
