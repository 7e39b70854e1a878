"""Mechanical systems M x'' + D x' + K x = L u, z = H1 x + H2 x', given as a record `trajlib.systems.Mechanical`.

The rank of Theorem 2.5 falls exactly where all maximal minors of its matrix vanish together, so the values of lambda
are the roots of their greatest common divisor, a polynomial with rational coefficients. That holds for a singular M
too. What depends on parameters is decided at every exceptional value of theirs by the states (x, x') that stay unseen;
the roots and the motions that no output shows are found in these states as well.
"""

import dataclasses
import functools
import itertools

import numpy as np
import sympy as sp

from trajlib.checks.contract.claims import Vectors, YesNo
from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.dual_questions import (
    CONTROL,
    EIGENVALUES,
    OUTPUT,
    compare_eigenvalues,
    judge_region,
    judge_yes_no,
    known_roots,
)
from trajlib.checks.structure.unseen_bases import judge_basis
from trajlib.checks.tools.comparisons import Word
from trajlib.checks.tools.samples import general_values, in_every_case
from trajlib.checks.truths.invariant_subspaces import characteristic_coefficients, different_roots
from trajlib.checks.truths.pairs import pair_of
from trajlib.systems import Mechanical

LAMBDA = sp.Symbol("lambda")
PENCIL = "root of det(M lambda^2 + D lambda + K) = 0"
SEEN = dataclasses.replace(OUTPUT, pencil="(M lambda^2 + D lambda + K; H1 + lambda H2)", spectrum=PENCIL,
                           vector="vector v other than 0 with (M lambda^2 + D lambda + K) v = 0 and (H1 + lambda H2) "
                                  "v = 0")
DRIVEN = dataclasses.replace(CONTROL, pencil="(M lambda^2 + D lambda + K, L)", spectrum=PENCIL,
                             vector="row w other than 0 with w (M lambda^2 + D lambda + K) = 0 and w L = 0")
#: A root is a value at which the square matrix loses its rank: the question of Theorem 2.5 with an output that shows
#: nothing.
ALONE = dataclasses.replace(OUTPUT, pencil="M lambda^2 + D lambda + K", spectrum=PENCIL,
                            vector="vector v other than 0 with (M lambda^2 + D lambda + K) v = 0")


@judged(YesNo())
def mechanical_observable(claim, system, parameters=()):
    """Whether the `Mechanical` system is observable by Theorem 2.5; with parameters, for all values that their
    assumptions allow."""
    return _judge_yes_no(claim, system, parameters, SEEN)


@judged(YesNo())
def mechanical_controllable(claim, system, parameters=()):
    """Whether the `Mechanical` system is controllable by Theorem 2.6; with parameters, for all values that their
    assumptions allow."""
    return _judge_yes_no(claim, _dual(system), parameters, DRIVEN)


@judged
def mechanical_controllable_parameters(answer, system, parameters):
    """The condition on the parameters under which the `Mechanical` system is controllable: true exactly there, at
    isolated values too.

    Where M becomes singular the order of the equations drops; what is said of these values does not count.
    """
    return judge_region(answer, _in_states(_dual(system), parameters), CONTROL)


@judged(EIGENVALUES)
def mechanical_lost_eigenvalues(claim, system, parameters=()):
    """The different values of lambda at which the rank of Theorem 2.5 falls; an empty list or set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    return compare_eigenvalues(claim, _spectra(system, parameters), SEEN, (LAMBDA, _polynomials(system)[0]))


@judged(EIGENVALUES)
def mechanical_uncontrolled_eigenvalues(claim, system, parameters=()):
    """The different values of lambda at which the rank of Theorem 2.6 falls; an empty list or set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    return compare_eigenvalues(claim, _spectra(_dual(system), parameters, claim), DRIVEN,
                               (LAMBDA, _polynomials(_dual(system))[0]))


@judged(EIGENVALUES)
def mechanical_roots(claim, system, parameters=()):
    """The different roots of det(M lambda^2 + D lambda + K), also complex ones, with invertible M; with parameters for
    their values in general position."""
    pair = _in_states(system, parameters)
    samples = pair.samples_for(claim)
    roots = [different_roots(characteristic_coefficients(pair.at(place)[0])) for _, place, _ in samples]
    spectra = [(values, found, found) for (values, *_), found in zip(samples, roots)]
    yield from compare_eigenvalues(claim, spectra, ALONE)
    known = known_roots(claim, LAMBDA, _pencil(system).det())
    return f"the determinant vanishes at each of them and nowhere else: {known}"


@judged(Vectors(size=lambda data: 2 * data["system"].M.rows))
def mechanical_unseen_states(claim, system):
    """A basis of the initial states (x, x') whose motions give z = H1 x + H2 x' = 0 for all time, with invertible M; an
    empty list if zero is the only one."""
    return judge_basis(claim, _in_states(system, ()), OUTPUT)


def _judge_yes_no(claim, system, parameters, side):
    if parameters:
        return (yield from judge_yes_no(claim, _in_states(system, parameters), OUTPUT if side is SEEN else CONTROL))
    ((_, lost, _),) = _spectra(system, ())
    falls = "falls at some lambda" if len(lost) else f"is full at every {side.spectrum}"
    return (yield Word(claim, not len(lost), f"the rank of {side.pencil} {falls}"))


def _spectra(system, parameters, claim=()):
    """(values, those of lambda where the rank of Theorem 2.5 falls, all roots of the characteristic equation), each
    once."""
    samples = in_every_case(general_values(parameters), claim)
    return [(values, *_known_spectra(system.subs(values))) for values in samples]


@functools.lru_cache(maxsize=64)
def _known_spectra(system):
    return tuple(map(_roots, _polynomials(system)))


@functools.lru_cache(maxsize=64)
def _polynomials(system):
    """The polynomials in lambda that vanish where the rank of Theorem 2.5 falls, and where the square matrix alone
    loses its rank."""
    rows = _pencil(system).col_join((system.H1 + LAMBDA * system.H2).applyfunc(_exact))
    minors = [sp.Poly(rows.extract(list(chosen), list(range(rows.cols))).det(method="berkowitz"), LAMBDA)
              for chosen in itertools.combinations(range(rows.rows), rows.cols)]
    if minors[0].is_zero:
        raise ValueError("det(M lambda^2 + D lambda + K) vanishes identically: the equations do not determine a motion")
    return functools.reduce(sp.gcd, minors), minors[0]


def _pencil(system):
    return (system.M * LAMBDA**2 + system.D * LAMBDA + system.K).applyfunc(_exact)


def _exact(x):
    return sp.nsimplify(x, rational=True)


def _roots(poly):
    return (np.array([complex(root) for root in poly.sqf_part().nroots(n=20, maxsteps=200)]) if poly.degree() > 0
            else np.array([]))


def _dual(system):
    """The system whose output shows what the control of this one reaches."""
    return Mechanical(system.M.T, system.D.T, system.K.T, H1=system.L.T)


def _in_states(system, parameters):
    """The `Pair` in the state (x, x')."""
    n, inverse = system.M.rows, system.M.inv(method="ADJ")
    A = sp.zeros(n).row_join(sp.eye(n)).col_join((-inverse * system.K).row_join(-inverse * system.D))
    return pair_of(A, system.H1.row_join(system.H2), parameters)
