"""Chain of steps: each has to follow from the one before it, whatever the problem is.

Expressions and matrices are compared entry by entry, conditions for all values of their symbols, and
equations by their solutions. Two equations have the same real solutions if their numerators have the
same factors, but for factors without real zeros.
"""

import cmath

import numpy as np
import sympy as sp
from sympy.logic.boolalg import Boolean

from workbook.checks.contract import coercion, condition_coercion
from workbook.checks.contract.tolerance import agree, in_decimals
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.tools.conditions import compare, exactly
from workbook.checks.tools.samples import general_values
from workbook.checks.tools.substitution import evaluated
from workbook.checks.tools.values import uncertainty_at
from workbook.checks.tools.wording import number_text, values_text, where_text

ORDINALS = [
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth",
    "eleventh", "twelfth", "thirteenth", "fourteenth", "fifteenth", "sixteenth", "seventeenth",
    "eighteenth", "nineteenth", "twentieth",
]  # fmt: skip
OPERATIONS = """\
("derivative", t), ("integral", t), ("substitute", {x: 2*y}) and ("Laplace", t, s)"""
PROVED = "proved for all values"


@judged
def steps(answer):
    """Check that each step of a chain follows from the one before it.

    The chain is a list of expressions, matrices, conditions or equations `sp.Eq(left, right)`. Each
    is equal to the one before it; a condition is equivalent; an equation has the same solutions. An
    operation between two steps says how the later one is made: `("derivative", t)`, `("integral", t)`,
    `("substitute", {x: 2*y})`, where the later step is the former one with other variables, or
    `("Laplace", t, s)`.

    The verdict names the first step that does not follow and a point where the two differ. It needs
    no data of the problem and says nothing about the right way.

    Can decide when the steps are rational functions without decimals, polynomial equations or
    polynomial conditions; others are compared at points, which the verdict says.

    Examples
    --------
    >>> x = sp.Symbol("x")
    >>> checks.steps([(x + 1)**2, x**2 + 2*x + 1]).message
    'each of your 2 steps follows from the one before it, proved for all values'
    >>> checks.steps([(x + 1)**2, x**2 + 1]).status
    'wrong'
    """
    evidence = set()
    chain = _read(answer)
    for (former, _), (later, operation), number in zip(chain, chain[1:], range(2, len(chain) + 1)):
        if operation is not None:
            former, later = _operated(former, later, operation, number)
        evidence.add(_follows(former, later, number))
    how = evidence.pop() if len(evidence) == 1 else "in part compared at points only"
    return f"each of your {len(chain)} steps follows from the one before it, {how}"


def _read(answer):
    """Return the pairs (step, operation that leads to it or None)."""
    if not isinstance(answer, (list, tuple)) or len(answer) < 2:
        raise Invalid("expected a list of at least two steps, [step 1, step 2, ...]")
    if len(answer) > len(ORDINALS):
        raise Invalid(f"expected at most {len(ORDINALS)} steps and operations")
    chain, operation = [], None
    for part in answer:
        if _is_operation(part):
            if operation is not None or not chain:
                raise Invalid("an operation stands between two steps")
            operation = part
        else:
            chain.append((_read_step(part, len(chain) + 1), operation))
            operation = None
    if operation is not None or len(chain) < 2:
        raise Invalid("an operation stands between two steps")
    return chain


def _is_condition(part):
    # SymPy takes each symbol for a Boolean, too
    return isinstance(part, (bool, Boolean)) and not isinstance(part, sp.Symbol)


def _is_operation(part):
    return isinstance(part, (list, tuple)) and len(part) > 1 and isinstance(part[0], str)


def _read_step(part, number):
    try:
        if isinstance(part, (list, tuple, sp.MatrixBase, np.ndarray)):
            return coercion.as_matrix(part, _symbols(part))
        if _is_condition(part):
            return condition_coercion.as_condition(part, _symbols(part))
        return coercion.as_expression(part, _symbols(part))
    except Invalid as reason:
        raise Invalid(f"{_name(number)}: {reason}") from None


def _symbols(*parts):
    found = set()
    for part in parts:
        if isinstance(part, (list, tuple)):
            found.update(_symbols(*part))
        elif hasattr(part, "free_symbols"):
            found |= part.free_symbols
    return sorted(found, key=str)


def _operated(former, later, operation, number):
    """Return two steps that have to be equal if the later one is made by the operation."""
    name, *arguments = operation
    if _is_condition(former) and not isinstance(former, sp.Eq):
        raise Invalid(f"{_name(number)}: an operation is for expressions, matrices and equations")
    match name, arguments:
        case "derivative", [sp.Symbol() as variable]:
            return _on_parts(former, lambda part: sp.diff(part, variable)), later
        case "integral", [sp.Symbol() as variable]:
            return former, _on_parts(later, lambda part: sp.diff(part, variable))
        case "substitute", [dict() as values]:
            return _on_parts(former, lambda part: part.subs(values, simultaneous=True)), later
        case "Laplace", [sp.Symbol() as time, sp.Symbol() as variable]:
            image = _on_parts(
                former, lambda part: sp.laplace_transform(part, time, variable, noconds=True)
            )
            if image.has(sp.LaplaceTransform):
                raise Invalid(f"{_name(number)}: this Laplace transform is not known here")
            return image, later
    raise Invalid(f"{_name(number)}: the operations are {OPERATIONS}")


def _on_parts(step, function):
    """Apply a function to an expression, the entries of a matrix, or both sides of an equation."""
    if isinstance(step, sp.MatrixBase):
        return step.applyfunc(function)
    return (
        sp.Eq(function(step.lhs), function(step.rhs)) if isinstance(step, sp.Eq) else function(step)
    )


def _follows(former, later, number):
    """Return how it is known that a step follows; raise `Wrong` if it does not."""
    if isinstance(former, sp.MatrixBase) and isinstance(later, sp.MatrixBase):
        return _same_matrix(former, later, number)
    if isinstance(former, sp.Expr) and isinstance(later, sp.Expr):
        return _same_expression(former, later, number)
    if isinstance(former, sp.Eq) and isinstance(later, sp.Eq):
        return _same_solutions(former, later, number)
    if _is_condition(former) and _is_condition(later):
        return _same_condition(former, later, number)
    raise Invalid(
        f"{_name(number)} is of another kind than the one before it: expressions, matrices, conditions "
        "and equations follow from their own kind"
    )


def _name(number):
    return f"your {ORDINALS[number - 1]} step"


def _does_not_follow(number, difference):
    return Wrong(f"{_name(number)} does not follow from the one before it: {difference}")


def _same_matrix(former, later, number):
    if former.shape != later.shape:
        raise _does_not_follow(number, f"it has the shape {later.shape} and not {former.shape}")
    return max(
        _same_expression(former[i, j], later[i, j], number, (i + 1, j + 1))
        for i in range(former.rows)
        for j in range(former.cols)
    )


def _same_expression(former, later, number, entry=()):
    if not (in_decimals(former) or in_decimals(later)):
        numerator, _ = sp.fraction(sp.together(former - later))
        if sp.expand(numerator) == 0:
            return PROVED
    points = 0
    for values in general_values(_symbols(former, later)):
        before, after = (_value(step, values) for step in (former, later))
        if before is None and after is None:
            continue
        points += 1
        if None in (before, after) or not _agree(former, before, later, after, values):
            texts = ["undefined" if v is None else number_text(v) for v in (before, after)]
            at = where_text(values)
            raise _does_not_follow(
                number,
                f"its entry {entry} is {texts[1]}{at}, and there another number before"
                if entry
                else f"it is {texts[1]}{at}, and the one before is {texts[0]}",
            )
    if not points:
        raise Invalid(
            f"{_name(number)}: no point was found where it and the step before it are defined"
        )
    return f"compared at {points} points" if _symbols(former, later) else "compared as numbers"


def _agree(former, before, later, after, values):
    """Return whether two numbers agree to the digits in which either step is written."""
    return agree(after, before, later, uncertain=uncertainty_at(later, values)) or (
        in_decimals(former)
        and agree(before, after, former, uncertain=uncertainty_at(former, values))
    )


def _value(step, values):
    """Return the number that an expression is at a point, or None."""
    number = evaluated(step, values)
    try:
        number = complex(number)
    except TypeError:
        return None
    return number if cmath.isfinite(number) else None


def _same_condition(former, later, number):
    def message(values, holds):
        one, other = ("the one before", "it") if holds else ("it", "the one before")
        holding = f"for {values_text(values)} {one} holds and {other} does not"
        return str(_does_not_follow(number, holding))

    return compare(later, _symbols(former, later), exactly(former), message)


def _same_solutions(former, later, number):
    sides = [step.lhs - step.rhs for step in (former, later)]
    factors = [_factors(side) for side in sides]
    if None in factors:
        return _multiples(*sides, number)
    names = "the one before", "it"
    for (own, other), (one, another) in ((factors, names), (factors[::-1], names[::-1])):
        for factor in own - other:
            point = _zero(factor, other, _symbols(former, later))
            if point is not None:
                holding = f"for {values_text(point)} {one} holds and {another} does not"
                raise _does_not_follow(number, holding)
    return PROVED


def _factors(side):
    """Return the factors of a numerator that may be zero; None if it is not a polynomial."""
    numerator, _ = sp.fraction(sp.cancel(sp.together(sp.nsimplify(side, rational=True))))
    if not numerator.is_polynomial(*_symbols(side)):
        return None
    _, factors = sp.factor_list(numerator)
    return {
        sp.Poly(factor, *_symbols(factor)).monic().as_expr()
        for factor, _ in factors
        if factor.is_nonzero is not True
    }


def _zero(factor, other_factors, symbols):
    """Return a real point where a factor is zero and none of the others is, or None."""
    for variable in _symbols(factor):
        for values in general_values([s for s in symbols if s != variable]):
            polynomial = sp.Poly(factor.subs(values), variable)
            for root in polynomial.nroots() if polynomial.degree() > 0 else ():
                point = {**values, variable: sp.re(root)}
                if abs(sp.im(root)) > 1e-12 * (1 + abs(root)) or not _allowed(variable, root):
                    continue
                if all(abs(evaluated(other, point)) > 1e-9 for other in other_factors):
                    return point
    return None


def _allowed(variable, root):
    return not (
        (variable.is_positive and root <= 0)
        or (variable.is_nonnegative and root < 0)
        or (variable.is_negative and root >= 0)
        or (variable.is_nonzero and abs(root) < 1e-12)
    )


def _multiples(former, later, number):
    """Compare equations that are no polynomials: one side difference is a multiple of the other."""
    ratios = []
    for values in general_values(_symbols(former, later)):
        before, after = (_value(side, values) for side in (former, later))
        if before and after:
            ratios.append(after / before)
    if len(ratios) > 2 and all(abs(ratio - ratios[0]) <= 1e-9 * abs(ratios[0]) for ratio in ratios):
        return f"compared at {len(ratios)} points"
    raise Invalid(
        f"{_name(number)}: equations are compared if they are polynomials or multiples of one another; "
        "write the sides as expressions"
    )
