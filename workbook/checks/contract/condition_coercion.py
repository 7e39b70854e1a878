"""Read an answer as a condition on symbols, whatever form of one it has."""

import numpy as np
import sympy as sp

from workbook.checks.contract.answer_forms import (
    has_logical_cases,
    is_logical,
    is_vector,
    kind_of,
)
from workbook.checks.contract.coercion import with_symbols
from workbook.checks.contract.magnitude import grows_too_fast
from workbook.checks.contract.verdict import Invalid, remark

#: What a condition looks like, and no condition that any problem has for its answer.
EXAMPLE_OF_CONDITION = "such as `x < y` or `sp.And(x < y, y < z)`"
#: Conditions are tried far out, at numbers of so many bits, and their powers are written out.
FAR_BITS, LARGEST_POWER = 20, 200
#: No answer has nearly as many relations; to work with more takes a time that grows faster than
#: their number.
MOST_WRITTEN_OUT = 200
#: They have no values at points, or none that the checks can compute.
NOT_IN_CONDITIONS = (
    sp.DiracDelta,
    sp.gamma,
    sp.factorial,
    sp.binomial,
    sp.Lambda,
    sp.Sum,
    sp.Derivative,
)


def as_condition(answer, symbols):
    """Return an answer as a SymPy condition (relation, And, Or, ...) on symbols.

    Parameters
    ----------
    answer : object
        A condition; also a list or set of conditions, Python's or SymPy's (all of them hold), a set
        of values of the symbols, a list or an array of the values of a single one, cases that are
        conditions, True and False.
    symbols : list of sympy.Symbol
        The data's own symbols, which replace those of the answer with the same names.

    Returns
    -------
    sympy.logic.boolalg.Boolean

    Raises
    ------
    Invalid
        If it is no condition, contains other symbols, or is too large to be judged.
    """
    if isinstance(answer, (bool, np.bool_)):
        remark(
            f"Your condition is just {bool(answer)}, without symbols. Python replaces `x != y` by True "
            "and `x == y` by False; write `sp.Ne(x, y)` or `sp.Eq(x, y)`"
        )
        return sp.true if answer else sp.false
    if len(symbols) == 1 and (values := _listed_numbers(answer)) is not None:
        if any(sp.sympify(value).has(sp.nan, sp.zoo) for value in values):
            raise Invalid("one of the values is undefined (nan, or a division by zero)")
        answer = sp.FiniteSet(*values)
    if (isinstance(answer, (list, tuple, set, frozenset, sp.Tuple)) and answer) or (
        isinstance(answer, sp.FiniteSet) and all(map(is_logical, answer))
    ):
        if len(answer) > 1:
            remark(
                "A list of conditions means that all of them hold; for one of them write `sp.Or(...)`"
            )
        answer = sp.And(*[as_condition(part, symbols) for part in answer])
    if isinstance(answer, sp.Set):
        answer = _membership(answer, symbols)
    if isinstance(answer, sp.Piecewise) and has_logical_cases(answer):
        answer = _chosen(answer.args)
    if isinstance(answer, sp.Basic) and answer.has(sp.Contains):
        answer = answer.xreplace(
            {part: _membership(part.args[1], part.args[:1]) for part in answer.atoms(sp.Contains)}
        )
    if not isinstance(
        answer, (sp.logic.boolalg.Boolean, sp.core.relational.Relational)
    ) or isinstance(answer, sp.Symbol):
        raise Invalid(f"expected a condition, {EXAMPLE_OF_CONDITION}, got {kind_of(answer)}")
    if _written_out(answer, {})[0] > MOST_WRITTEN_OUT:
        raise Invalid(
            f"written with And and Or alone this condition has more than {MOST_WRITTEN_OUT} "
            "inequalities; give a simpler form of it"
        )
    for relation in answer.atoms(sp.core.relational.Relational):
        if not all(
            isinstance(side, sp.Expr) and not isinstance(side, sp.MatrixBase)
            for side in relation.args
        ):
            raise Invalid(
                "a condition compares numbers, not matrices, other conditions, True or False; "
                f"write the condition itself, {EXAMPLE_OF_CONDITION}"
            )
        if any(has_logical_cases(side) for side in relation.args):
            raise Invalid("the condition compares something with cases that are True or False")
        if any(_is_undefined(side) for side in relation.args):
            raise Invalid(
                "the condition contains an undefined value (nan, a division by zero, or oo - oo)"
            )
    if unsupported := answer.atoms(*NOT_IN_CONDITIONS):
        raise Invalid(
            f"the condition contains {', '.join(sorted({type(part).__name__ for part in unsupported}))}, "
            "which cannot be judged here; write it without"
        )
    if grows_too_fast(answer, FAR_BITS) or any(
        abs(power.exp) > LARGEST_POWER for power in answer.atoms(sp.Pow) if power.exp.is_number
    ):
        raise Invalid(
            "the condition contains a power or an exponential that grows too fast to be computed "
            "with"
        )
    try:
        return with_symbols(answer, symbols)
    # SymPy refuses to compare what is not real, once it knows that the symbols are
    except TypeError:
        raise Invalid(
            "the condition compares numbers that are not real, whatever the symbols are"
        ) from None


def _listed_numbers(answer):
    """Return the numbers in a list, a set, an array or a column, or None if others are in it."""
    parts = (
        list(answer.ravel())
        if isinstance(answer, np.ndarray) and is_vector(answer)
        else list(answer)
        if isinstance(answer, (list, tuple, set, frozenset, sp.Tuple))
        or (isinstance(answer, sp.MatrixBase) and is_vector(answer))
        else [None]
    )
    numbers = (int, float, np.number, sp.Expr)
    return (
        parts
        if all(
            isinstance(part, numbers)
            and not isinstance(part, (bool, np.bool_, sp.MatrixBase))
            and not getattr(part, "free_symbols", None)
            for part in parts
        )
        else None
    )


def _chosen(cases):
    """Return the condition that cases choose: the first that fits, False where none does."""
    value, where = cases[0]
    if not is_logical(value):
        raise Invalid("the cases of a condition have to be conditions, True or False")
    remaining = _chosen(cases[1:]) if cases[1:] else sp.false
    return sp.Or(sp.And(where, value), sp.And(sp.Not(where), remaining))


def _written_out(condition, counts):
    """Count the relations of a condition and of its negation, written with And and Or alone."""
    if condition not in counts:
        parts = [
            _written_out(part, counts)
            for part in condition.args
            if isinstance(part, sp.logic.boolalg.Boolean)
        ]
        if isinstance(condition, sp.core.relational.Relational) or not parts:
            sizes = 1, 1
        elif isinstance(condition, (sp.And, sp.Or)):
            sizes = tuple(map(sum, zip(*parts)))
        elif isinstance(condition, sp.Not):
            sizes = parts[0][::-1]
        elif isinstance(condition, sp.Implies):
            (premise, negated_premise), (conclusion, negated_conclusion) = parts
            sizes = negated_premise + conclusion, premise + negated_conclusion
        else:  # Xor, ITE and the like need each part with its negation
            sizes = parts[0]
            for part in parts[1:]:
                sizes = (sum(sizes) + sum(part),) * 2
        counts[condition] = sizes
    return counts[condition]


def _is_undefined(side):
    """Return whether an expression has no value for any values of its symbols, not even oo."""
    return side.has(sp.nan, sp.zoo) or (
        side.is_number and side.has(sp.oo, -sp.oo, 0) and side.evalf(5) in (sp.nan, sp.zoo)
    )


def _membership(region, symbols):
    """Return the condition that the point with the symbols as coordinates lies in a SymPy set."""
    if region is sp.S.EmptySet:
        return sp.false
    point = symbols[0] if len(symbols) == 1 else sp.Tuple(*symbols)
    if isinstance(region, sp.ConditionSet):
        names = region.sym if isinstance(region.sym, (sp.Tuple, tuple)) else (region.sym,)
        if len(names) != len(symbols):
            raise Invalid(
                f"expected a set of points with {len(symbols)} coordinates, got one with "
                f"{len(names)}"
            )
        return sp.And(
            region.condition.xreplace(dict(zip(names, symbols))),
            _membership(region.base_set, symbols),
        )
    if len(symbols) == 1 and hasattr(region, "as_relational") and region.is_subset(sp.S.Reals):
        return region.as_relational(point)
    if isinstance(region, sp.ProductSet) and len(region.args) == len(symbols):
        return sp.And(*[_membership(part, [symbol]) for part, symbol in zip(region.args, symbols)])
    if isinstance(region, (sp.Union, sp.Intersection)):
        parts = [_membership(part, symbols) for part in region.args]
        return sp.Or(*parts) if isinstance(region, sp.Union) else sp.And(*parts)
    raise Invalid(
        f"expected a condition or a set of values of {', '.join(s.name for s in symbols)}"
    )
