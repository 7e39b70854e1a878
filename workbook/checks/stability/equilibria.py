"""Equilibria of fields that may contain parameters: all in a domain, or those of a kind.

`domain` is a dict from symbols of the state or parameters to SymPy intervals, as in
`trajlib.stability.equilibria`; an interval of length 2 pi makes a state variable an angle, for
which values modulo 2 pi are the same. What `domain` does not name ranges over all numbers that the
assumptions of the symbol allow. The reference is found from the field alone, for sample values of
the parameters, by Newton's method from many initial points at once. A circular cycle is an
equilibrium of the radial equation r' = R(r), r > 0.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.members import VECTORS, in_order
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import uncertainty_at
from workbook.checks.tools.wording import (
    NO_NUMBER,
    point_text,
    sample_text,
    tried_text,
    with_article,
)


@judged
def equilibria(answer, field, state, parameters=(), domain=None, zeros=None, kind=None):
    """Check all equilibria in the domain, or those of a kind, as expressions in the parameters.

    The answer is one point, or a list of points. A point whose formula is not real, or leaves the
    domain, for some values of the parameters stands for no point there. Where derivatives vanish
    at a point as well, `zeros` are functions that have the same zeros, all simple. The kind is
    decided by linearisation. Of one right-hand side and one symbol, both without a list, it is a
    nullcline: the curve on which the rate vanishes, solved for the symbol.

    Can decide when the equilibria are simple zeros of the field, or of the `zeros`; with
    parameters at sample values in the domain.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> field = [y, x*(6*x - 43)]
    >>> checks.equilibria([[0, 0], [sp.Rational(43, 6), 0]], field, [x, y]).status
    'right'
    >>> checks.equilibria([[0, 0]], field, [x, y]).message
    'there is an equilibrium that your answer does not give'
    >>> v, p = sp.symbols("v p", positive=True)
    >>> checks.equilibria(sp.sqrt(p), p - v**2, v, [p]).status
    'right'
    """
    noun = "equilibrium" if kind is None else f"{kind} equilibrium"
    if isinstance(state, sp.Symbol):
        noun, field, state = "point of the curve", [field], [state]
    family = equilibria_of(field, state, parameters, domain)
    searched = family if zeros is None else equilibria_of(zeros, state, parameters, domain)
    claims = _points(answer, family)
    in_domain, place = [False] * len(claims), " in the domain" if family.domain else ""
    for values, numbers, points in searched.samples(claims, alone=False):
        if kind is not None:
            for point in points:
                family.growth(point, numbers)  # raises where the linearisation does not decide
        expected = family.of_kind(kind, points, numbers)
        missed, outside = list(expected), ""
        for k, claim in enumerate(claims):
            position = [real_at(coordinate, values) for coordinate in claim]
            if any(coordinate is None for coordinate in position):
                outside = f"; your answer gives {NO_NUMBER}"
                continue
            position = family.rounded_inside(np.array(position, dtype=float), claim)
            where = f"{_position_text(family.state, position)}"
            if not family.inside(position):
                outside = f"; {where}, which your answer gives, lies outside the domain"
                continue
            in_domain[k] = True
            uncertain = [uncertainty_at(coordinate, values) for coordinate in claim]

            def matching(points, position=position, claim=claim, uncertain=uncertain):
                return [
                    j
                    for j, point in enumerate(points)
                    if family.is_same_point(position, point, claim, uncertain)
                ]

            if matches := matching(missed):
                del missed[matches[0]]
            elif matching(expected):
                # numbers are read as a set, as a solver gives it
                if family.parameters or family.domain:
                    raise Wrong(f"{sample_text(values)}two of your points are the same")
            else:
                refined = searched.refined(position, numbers)
                if refined is None or not matching([refined]):
                    raise Wrong(
                        f"{sample_text(values)}your answer gives {where}; "
                        f"{rates_text(family(position, numbers))}"
                    )
                if not family.of_kind(kind, [refined], numbers):
                    raise Wrong(
                        f"{sample_text(values)}{where} is an equilibrium, but not {kind}: "
                        "look at the real parts of the eigenvalues of the linearisation there"
                    )
        if missed:
            raise Wrong(
                f"{sample_text(values)}there is {with_article(noun)}{place} that your answer does "
                f"not give{outside}"
            )
    if not all(in_domain):
        raise Wrong(
            f"point {in_domain.index(False) + 1} of your list lies outside the domain"
            + (" for all sample values of the parameters" if family.parameters else "")
        )
    return f"it gives every {noun}{place} and nothing else{tried_text(family.parameters)}"


def _points(answer, family):
    """Return a list of points, each a list of expressions, from one point or a list of them."""
    n = len(family.state)

    def single(point):
        point = in_order(point, family.state)
        if n == 1 and not isinstance(point, VECTORS):
            point = [point]
        point = coercion.as_expressions(point, family.parameters, length=n)
        return point if family.parameters else list(map(coercion.as_number, point))

    if isinstance(answer, sp.MatrixBase) and 1 not in answer.shape:
        answer = [list(answer.row(k)) for k in range(answer.rows)]
    if isinstance(answer, np.ndarray):
        answer = answer.tolist()
    if isinstance(answer, (set, frozenset, sp.FiniteSet)) or answer is sp.S.EmptySet:
        return [single(point) for point in answer]
    if isinstance(answer, (list, tuple)) and (
        n == 1 or not answer or any(isinstance(point, (dict, *VECTORS)) for point in answer)
    ):
        if (
            n > 1
            and len(answer) == n
            and all(isinstance(p, (list, tuple)) and len(p) == 1 for p in answer)
        ):
            return [single(answer)]  # a column
        return [single(point) for point in answer]
    return [single(answer)]


def _position_text(state, position):
    return ", ".join(f"{s} = {x:.4g}" for s, x in zip(state, position))


def rates_text(rates):
    """Return the right-hand sides at a point; rounding errors of a zero are shown as zero."""
    if not np.isfinite(rates).all():
        return "the right-hand sides are not defined there"
    if len(rates) == 1:
        return f"the right-hand side is {rates[0]:.4g} there, not zero"
    shown = np.where(abs(rates) > 1e-12 * abs(rates).max(), rates, 0)
    return f"the right-hand sides are {point_text(shown)} there, not zero"
