"""Stabilising gains: their region, the degrees of stability that can be attained, and obstacles.

A degree of stability mu is that of Definition 1.5, Re lambda <= -mu for all eigenvalues.

No check here is declared by a reference: conditions are decided for all parameters.
"""

import sympy as sp

from workbook.checks.contract.claims import Expression, Expressions, Table
from workbook.checks.contract.tolerance import EXACT
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.feedback.loops import loop_of
from workbook.checks.references.exceptional_values import judge_everywhere
from workbook.checks.references.fixed_modes import (
    ON_BORDER,
    common_degree,
    degrees_with_parameters,
    greatest_degree,
    slower_than,
)
from workbook.checks.references.records import (
    augmented,
    controlled_pair,
    has_control,
    observed_pair,
)
from workbook.checks.references.spectra import compare_region
from workbook.checks.tools.conditions import compare, exactly
from workbook.checks.tools.samples import in_every_case
from workbook.checks.tools.values import entry_uncertainties, matrix_at, number_at
from workbook.checks.tools.wording import number_text, values_text, where_text
from workbook.systems import Scalar


@judged(system="Linear or Scalar")
def gain_region(answer, system, gain, parameters, degree=0):
    """Check the condition on `parameters` under which the `gain` stabilises.

    The gain is a matrix of symbols: with a control u = Kx, or with an output too u = Kz,
    stabilises the system; without a control the errors of the observer decay, A - LH.

    Of one equation, `Scalar`, u = `gain` z. With a `degree` of stability its border counts either way.

    Can decide when the characteristic polynomial has rational coefficients in the gains: then for
    all of them at once. Elsewhere the condition is compared with the roots at points.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> k1, k2 = sp.symbols("k1 k2", real=True)
    >>> cart = Linear(A=[[0, 1], [0, 0]], B=[[0], [1]])
    >>> checks.gain_region((k1 < 0) & (k2 < 0), cart, [[k1, k2]], [k1, k2]).status
    'right'
    >>> checks.gain_region(k1 < 0, cart, [[k1, k2]], [k1, k2]).status
    'wrong'
    """
    loop, _ = loop_of(system)
    gain = sp.Matrix(gain) if isinstance(gain, list) else gain
    property_name = "stable" if isinstance(system, Scalar) or system.B else "convergent"
    return compare_region(answer, loop(gain), parameters, property_name, degree)


@judged(system="Linear, WithError or Scalar")
def possible_degrees(answer, system, mu, parameters=()):
    """Check the condition on mu > 0 under which the degree of stability mu can be attained.

    The condition is false if none can: with an output alone by some observer, with a
    control alone by some feedback u = Kx, with both, or for a `Scalar` equation of its full
    order, by some feedback by an estimate, whose errors are included, and an error of the
    measurement if it has one.

    With parameters the condition is on mu and these, so it also says for which values there is
    none.

    Can decide when the entries are polynomials in the parameters, for all mu and all parameters;
    elsewhere the condition is compared at points.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> mu = sp.Symbol("mu", positive=True)
    >>> plant = Linear(A=[[1, 0], [0, -3]], B=[[1], [0]])
    >>> checks.possible_degrees(mu <= 3, plant, mu).status
    'right'
    >>> checks.possible_degrees(mu < 3, plant, mu).status
    'wrong'
    """
    if isinstance(system, Scalar):
        device, reference = "feedback by an estimate", up_to(mu, common_degree(system))
    elif not parameters:
        device = "observer"
        if system.B:
            device = "feedback by an estimate" if system.H else "feedback"
        pairs = [controlled_pair(system)] if system.B else []
        pairs += [observed_pair(augmented(system))] if system.H else []
        reference = up_to(mu, *map(greatest_degree, pairs))
    else:
        device, observed = (
            ("feedback", system.dual) if has_control(system) else ("observer", system)
        )
        reference = degrees_with_parameters(observed.A, observed.H, mu, parameters)
    return compare_degrees(answer, [*parameters, mu], reference, device)


def up_to(mu, *greatest):
    """Return the `ReferenceCondition` that mu is at most each degree; None sets no bound."""
    bounds = [degree for degree in greatest if degree is not None]
    return exactly(mu <= min(bounds, key=float) if bounds else sp.true)


def compare_degrees(answer, symbols, reference, device):
    def message(values, holds):
        verb, some = ("does not hold", "some") if holds else ("holds", "no")
        return (
            f"your condition {verb} for {values_text(values)}, yet {some} {device} has this degree "
            "of stability"
        )

    agreement = compare(answer, symbols, reference, message)
    return f"these are the degrees of stability that some {device} has: {agreement}"


@judged(
    Table(
        Expression("parameters"),
        Expressions("parameters", length="system.A"),
        "a dictionary {lambda: v}, an empty one if nothing stands in the way",
    ),
    system="Linear with outputs",
)
def undetectable_mode(claim, system, parameters=()):
    """Check a motion that excludes an asymptotic observer, {lambda: v}; {} if there is none.

    It satisfies A v = lambda v, H v = 0, Re lambda >= 0.

    With parameters: for all their values, zero too where it is allowed.

    Can decide when the entries are exact numbers, or rational functions of the parameters.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[1, 0], [0, -2]], H=[[0, 1]])
    >>> checks.undetectable_mode({1: [1, 0]}, pair).status
    'right'
    >>> checks.undetectable_mode({}, pair).status
    'wrong'
    """
    A, H, pair = system.A, system.H, observed_pair(system, parameters)
    if not claim:
        if slower_than(0, pair):
            raise Wrong("there is a mode that does not decay and that no gain changes")
        return "every mode that no gain changes decays"
    points = [values for values, _ in pair.samples]
    zero = {p: sp.Integer(0) for p in parameters}
    if (
        parameters
        and not any(p.is_nonzero for p in parameters)
        and not sp.Matrix.vstack(A, H).subs(zero).has(sp.zoo)
    ):
        points.append(zero)
    for value, vector in ((value, sp.Matrix(entries)) for value, entries in claim):
        for values in in_every_case(points, [value, vector]):
            _judge_mode(value, vector, A, H, values, where_text(values))
        undefined, zero_vector = "your vector v is undefined", "your vector v is zero"
        judge_everywhere(vector, parameters, lambda: sp.true, undefined, zero_vector)
    return "it is a mode that does not decay, and no gain changes it: A v = lambda v"


def _judge_mode(value, vector, A, H, values, where):
    root, column = number_at(value, values, "your lambda"), matrix_at(vector, values)
    matrix, output = matrix_at(A, values), matrix_at(H, values)
    if not abs(column).max() > 0:
        raise Wrong(f"your vector v is zero{where}")
    vector_uncertainty = entry_uncertainties(vector, values)
    ((root_uncertainty,),) = entry_uncertainties(sp.Matrix([value]), values)
    image = matrix @ column
    size = (abs(matrix) @ abs(column)).max() + abs(root) * abs(column).max()
    uncertainty = abs(matrix) @ vector_uncertainty + abs(root) * vector_uncertainty
    uncertainty = uncertainty + root_uncertainty * abs(column)
    if not (abs(image - root * column) <= EXACT * size + uncertainty).all():
        raise Wrong(f"v and lambda = {number_text(root)} do not satisfy A v = lambda v{where}")
    shown, allowed = output @ column, abs(output) @ (EXACT * abs(column) + vector_uncertainty)
    if not (abs(shown) <= allowed).all():
        raise Wrong(
            "the mode is not unobservable: H v has the component "
            f"{number_text(shown[abs(shown).argmax(), 0])}{where}, not 0"
        )
    if not root.real > -ON_BORDER:
        raise Wrong(
            f"a mode with lambda = {number_text(root)} decays{where}, so that it does not prevent detectability"
        )
