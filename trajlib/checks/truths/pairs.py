"""A matrix A and an output z = H x whose entries hold parameters: what the output never shows, at any place of the
parameters.

The property itself is decided at a place, exactly, by `invariant_subspaces`. Kalman's determinant serves only to find
the places where it may fail; for several outputs two random combinations of the minors take the place of all of them.
"""

import functools
import itertools
from fractions import Fraction
from random import Random

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from trajlib.checks.contract import coercion
from trajlib.checks.contract.verdict import Wrong
from trajlib.checks.tools.places import LARGEST_DEGREE, Claim, Rational, allowed, lines, lines_through_meetings, places
from trajlib.checks.tools.semialgebraic import as_text
from trajlib.checks.truths.fields import sample_values
from trajlib.checks.truths.invariant_subspaces import unseen_subspace


@functools.lru_cache(maxsize=64)
def known_pair(A, H, parameters):
    """The `Pair` of the data, given as immutable matrices and a tuple: what has been found of it is kept."""
    return Pair(A, H, parameters)


def pair_of(A, H, parameters=()):
    """The `Pair` of matrices as a data cell gives them."""
    return known_pair(sp.ImmutableMatrix(A), sp.ImmutableMatrix(H), tuple(parameters))


class Pair:
    """A square matrix A and the matrix H of an output, both of rational functions of the parameters."""

    def __init__(self, A, H, parameters):
        if A.rows != A.cols or H.cols != A.cols:
            raise ValueError(f"matrices of the shapes {A.shape} and {H.shape} make no system")
        self.order, self.outputs, self.parameters = A.rows, H.rows, list(parameters)
        self.unknowns = self.order  # what is asked for is the whole state
        self._quotients = [[self._quotient(entry) for entry in matrix] for matrix in (A, H)]

    def _quotient(self, entry):
        entry = sp.nsimplify(entry, rational=True) if entry.has(sp.Float) else sp.sympify(entry)
        polys = [sp.Poly(part, *(self.parameters or [sp.Dummy()]), domain="QQ")
                 for part in sp.fraction(sp.together(entry))]
        return polys

    def at(self, place):
        """(A, H) as lists of rows at a place, or None where an entry is not defined."""
        n, found = self.order, []
        for quotients in self._quotients:
            numbers = []
            for numerator, denominator in quotients:
                below = _value(denominator, place)
                if not below:
                    return None
                numbers.append(_value(numerator, place) / below)
            found.append([numbers[k:k + n] for k in range(0, len(numbers), n)])
        return found

    def unseen_at(self, place):
        """A basis of the states from which the output stays zero, or None where an entry is not defined."""
        rows = self.at(place)
        return None if rows is None else unseen_subspace(*rows)

    def state_of(self, vector):
        """The initial state that a vector of the unknowns stands for."""
        return vector

    @functools.cached_property
    def samples(self):
        """Pairs (values, place) for the parameters in general position, as their assumptions allow; one empty pair
        without parameters."""
        found = [(values, Rational(Fraction(int(values[p].p), int(values[p].q)) for p in self.parameters))
                 for values in general_values(self.parameters)]
        return [(values, place) for values, place in found if self.at(place) is not None]

    @functools.cached_property
    def unseen(self):
        """The basis of the unseen states at every sample."""
        return [self.unseen_at(place) for _, place in self.samples]

    @functools.cached_property
    def boundaries(self):
        """Polynomials in the parameters: only where one of them vanishes can the output show fewer states than in
        general."""
        return [poly for poly in {*self._denominators, self._minors[0]} if not poly.is_ground]

    @functools.cached_property
    def meetings(self):
        """Lines through isolated points of a plane of parameters where all minors vanish."""
        common, *rests = self._minors
        if len(self.parameters) != 2 or not rests or any(rest.is_ground for rest in rests):
            return []
        return list(lines_through_meetings(*rests, self.parameters))

    @functools.cached_property
    def _denominators(self):
        return {denominator for quotients in self._quotients for _, denominator in quotients}

    @functools.cached_property
    def _minors(self):
        """The common factor of combinations of the minors of Kalman's matrix of order n, then what each has besides."""
        told, n = self._derivative_rows(), self.unknowns
        if told.shape[0] == n:
            return [self._determinant(told)]
        random = Random(3)
        found = []
        for _ in range(2):
            mix = DomainMatrix([[told.domain(random.randint(-9, 9)) for _ in range(told.shape[0])] for _ in range(n)],
                               (n, told.shape[0]), told.domain)
            found.append(self._determinant(mix * told))
        if any(poly.is_zero for poly in found):
            return [found[0] + found[1]]
        common = found[0].gcd(found[1])
        return [common, *(poly.quo(common) for poly in found)]

    def _derivative_rows(self):
        """Kalman's matrix: what the output and its derivatives at t = 0 tell of the unknowns, without denominators."""
        A, H = (self._cleared(quotients) for quotients in self._quotients)
        rows = [H]
        while len(rows) < self.order:
            rows.append(rows[-1] * A)
        return rows[0].vstack(*rows[1:])

    def _cleared(self, quotients):
        """The matrix times its common denominator, over the ring of polynomials."""
        ring = sp.QQ[tuple(self.parameters)]
        common = functools.reduce(lambda one, other: one.lcm(other), (below for _, below in quotients))
        entries = [ring.from_sympy((above * common.quo(below)).as_expr()) for above, below in quotients]
        rows = [entries[k:k + self.order] for k in range(0, len(entries), self.order)]
        return DomainMatrix(rows, (len(rows), self.order), ring)

    def _determinant(self, matrix):
        return sp.Poly(matrix.domain.to_sympy(matrix.charpoly()[-1]), *self.parameters, domain="QQ")


def compare_condition(answer, pair, holds_for, told):
    """Compare a condition on the parameters with a property at every place that matters; returns how many were
    compared.

    `holds_for(dimension)` is the property, of the number of independent unseen states; `told(place, claimed,
    dimension)` the words for a place where the claim differs.
    """
    parameters = pair.parameters
    claim = Claim(coercion.as_condition(answer, parameters), parameters)
    boundaries = pair.boundaries + claim.boundaries
    extra, compared = 0 if claim.is_semialgebraic else 60, 0
    meetings = [*pair.meetings, *_crossings(boundaries, parameters)]
    for k, (point, direction) in enumerate([*meetings, *lines(parameters)]):
        for place in places(point, direction, boundaries, extra, irrational=k < len(meetings) + 6):
            if not allowed(place, parameters):
                continue
            unseen = pair.unseen_at(place)
            if unseen is None:
                continue  # no system has been given there
            compared += 1
            if claim.holds(place) != holds_for(len(unseen)):
                raise Wrong(told(place, claim.holds(place), len(unseen)))
    return compared


def _crossings(boundaries, parameters):
    """Lines through rational points of a plane where boundaries may hide an exception: where two cross, or one shrinks
    to a point."""
    if len(parameters) != 2:
        return
    factors = sorted({factor for poly in boundaries for factor, _ in poly.factor_list()[1]},
                     key=lambda poly: str(poly.as_expr()))
    # At an isolated point of a curve, which no other line hits, its derivative vanishes too.
    slopes = [(factor, factor.diff(parameters[0])) for factor in factors if factor.total_degree() > 1]
    for one, other in [*itertools.combinations(factors, 2),
                       *((one, slope) for one, slope in slopes if not slope.is_zero)]:
        if one.total_degree() * other.total_degree() <= LARGEST_DEGREE:
            yield from lines_through_meetings(one, other, parameters)


def place_text(parameters, place):
    """A place for a message."""
    if place.irrational:
        return ", ".join(f"{p} = {float(x):.6g}" for p, x in zip(parameters, place.numbers()))
    return as_text(parameters, place.coordinates)


def general_values(parameters):
    """Rational values for parameters as `sample_values` gives them, but none a small number or a small multiple of
    another."""
    primes = (997, 1009, 1013, 1019, 1021, 1031, 1033, 1039)
    return [{p: value * sp.Rational(prime, 1000) for (p, value), prime in zip(values.items(), itertools.cycle(primes))}
            for values in sample_values(parameters, 6 if parameters else 1)]


def _value(poly, place):
    return place.value(poly) if not poly.is_ground else Fraction(int(poly.LC().p), int(poly.LC().q))
