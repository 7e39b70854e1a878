"""Observability and controllability of mechanical systems M x'' + D x' + K x = L u, z = H1 x + H2 x'.

The rank of Theorem 2.5 falls exactly where all maximal minors of its matrix vanish together, so the values of lambda
are the roots of their greatest common divisor, a polynomial with rational coefficients. That holds for a singular M
too. What depends on parameters is decided at every exceptional value of theirs by the states (x, x') that stay unseen.
"""

import dataclasses
import functools
import itertools

import numpy as np
import sympy as sp

from trajlib.checks.contract import coercion
from trajlib.checks.contract.verdict import Wrong, judged
from trajlib.checks.structure.dual_questions import CONTROL, OUTPUT, compare_eigenvalues, judge_region, judge_yes_no
from trajlib.checks.tools.samples import general_values
from trajlib.checks.truths.pairs import pair_of

LAMBDA = sp.Symbol("lambda")
PENCIL = "root of det(M lambda^2 + D lambda + K) = 0"
SEEN = dataclasses.replace(OUTPUT, pencil="(M lambda^2 + D lambda + K; H1 + lambda H2)", spectrum=PENCIL,
                           vector="vector v other than 0 with (M lambda^2 + D lambda + K) v = 0 and (H1 + lambda H2) "
                                  "v = 0")
DRIVEN = dataclasses.replace(CONTROL, pencil="(M lambda^2 + D lambda + K, L)", spectrum=PENCIL,
                             vector="row w other than 0 with w (M lambda^2 + D lambda + K) = 0 and w L = 0")


@judged
def mechanical_observable(answer, M, D, K, H1, H2, parameters=()):
    """Whether the mechanical system is observable by Theorem 2.5; with parameters, for all values that their
    assumptions allow."""
    return _judge_yes_no(answer, (M, D, K, H1, H2), parameters, SEEN)


@judged
def mechanical_controllable(answer, M, D, K, L, parameters=()):
    """Whether the mechanical system is controllable by Theorem 2.6; with parameters, for all values that their
    assumptions allow."""
    return _judge_yes_no(answer, _transposed(M, D, K, L), parameters, DRIVEN)


@judged
def mechanical_controllable_parameters(answer, M, D, K, L, parameters):
    """The condition on the parameters under which the mechanical system is controllable: true exactly there, at
    isolated values too.

    Where M becomes singular the order of the equations drops; what is said of these values does not count.
    """
    return judge_region(answer, first_order(*_transposed(M, D, K, L), parameters), CONTROL, holds=True)


@judged
def mechanical_lost_eigenvalues(answer, M, D, K, H1, H2, parameters=()):
    """The different values of lambda at which the rank of Theorem 2.5 falls; an empty list or set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    return _judge_eigenvalues(answer, (M, D, K, H1, H2), parameters, SEEN)


@judged
def mechanical_uncontrolled_eigenvalues(answer, M, D, K, L, parameters=()):
    """The different values of lambda at which the rank of Theorem 2.6 falls; an empty list or set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    return _judge_eigenvalues(answer, _transposed(M, D, K, L), parameters, DRIVEN)


def _judge_yes_no(answer, system, parameters, side):
    if parameters:
        return judge_yes_no(answer, first_order(*system, parameters), OUTPUT if side is SEEN else CONTROL)
    claim = coercion.as_yes_no(answer)
    lost, _ = _spectra(system, {})
    reason = (f"the rank of {side.pencil} falls at {len(lost)} value{'s' if len(lost) > 1 else ''} of lambda"
              if len(lost) else \
         f"the rank of {side.pencil} is full at every {side.spectrum}")
    if claim != (not len(lost)):
        raise Wrong(reason)
    return reason


def _judge_eigenvalues(answer, system, parameters, side):
    samples = general_values(parameters)
    lost, every = zip(*(_spectra(system, values) for values in samples))
    return compare_eigenvalues(answer, parameters, samples, lost, every, side)


def _spectra(system, values):
    """(the values of lambda where the rank of Theorem 2.5 falls, all roots of the characteristic equation), each
    once."""
    return _known_spectra(tuple(sp.ImmutableMatrix(part).subs(values) for part in system))


@functools.lru_cache(maxsize=64)
def _known_spectra(system):
    M, D, K, H1, H2 = (part.applyfunc(lambda x: sp.nsimplify(x, rational=True)) for part in system)
    n = M.rows
    rows = (M * LAMBDA**2 + D * LAMBDA + K).col_join(H1 + LAMBDA * H2)
    minors = [sp.Poly(rows.extract(list(chosen), list(range(n))).det(method="berkowitz"), LAMBDA, domain="QQ")
              for chosen in itertools.combinations(range(rows.rows), n)]
    if minors[0].is_zero:
        raise ValueError("det(M lambda^2 + D lambda + K) vanishes identically: the equations do not determine a motion")
    return _roots(functools.reduce(sp.gcd, minors)), _roots(minors[0])


def _roots(poly):
    return (np.array([complex(root) for root in poly.sqf_part().nroots(n=20, maxsteps=200)]) if poly.degree() > 0
            else np.array([]))


def _transposed(M, D, K, L):
    return M.T, D.T, K.T, L.T, sp.zeros(L.cols, L.rows)


def first_order(M, D, K, H1, H2, parameters):
    """The `Pair` in the state (x, x')."""
    n, inverse = M.rows, M.inv(method="ADJ")
    A = sp.zeros(n).row_join(sp.eye(n)).col_join((-inverse * K).row_join(-inverse * D))
    return pair_of(A, H1.row_join(H2), parameters)
