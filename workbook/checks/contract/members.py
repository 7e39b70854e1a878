"""Answers that are one thing or several, read into lists, whatever a student keeps them in: lists,
sets, arrays, what SymPy's solvers give."""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.verdict import Invalid

VECTORS = (list, tuple, sp.Tuple, sp.MatrixBase, np.ndarray)
NUMBERS = (int, float, complex, sp.Expr)


def members(answer, expected, single=()):
    """The members of a collection as a list; one alone, of the types `single`, is a list of it.

    Of a matrix or an array they are its numbers. Anything else is `Invalid`, which says what was
    `expected`.
    """
    if isinstance(answer, np.ndarray):
        return answer.ravel().tolist()
    if isinstance(answer, sp.MatrixBase) and (1 in answer.shape or 0 in answer.shape):
        return list(answer)
    if (
        isinstance(answer, (list, tuple, set, frozenset, sp.Tuple, sp.FiniteSet))
        or answer is sp.S.EmptySet
    ):
        return list(answer)
    if isinstance(answer, sp.And):  # equations that hold together
        return list(answer.args)
    if isinstance(answer, single) and not isinstance(answer, bool):
        return [answer]
    raise Invalid(f"expected {expected}")


def families(answer, integer, expected):
    """The members of an answer that repeat periodically: expressions in `integer`, also for a set
    that `solveset` gives."""
    if isinstance(answer, (dict, np.ndarray)):
        answer = list(answer.values()) if isinstance(answer, dict) else answer.tolist()
    if isinstance(answer, sp.ConditionSet) and answer.sym not in answer.condition.free_symbols:
        # there are solutions for some parameters only, as the problem says
        answer = answer.base_set
    if isinstance(answer, sp.Intersection):
        real, *others = [part for part in answer.args if part != sp.S.Reals]
        answer = answer if others else real
    if isinstance(answer, sp.Union):
        return [part for one in answer.args for part in families(one, integer, expected)]
    if (
        isinstance(answer, sp.ImageSet)
        and answer.base_sets == (sp.S.Integers,)
        and integer is not None
        and len(answer.lamda.variables) == 1
    ):
        return [answer.lamda.expr.xreplace({answer.lamda.variables[0]: integer})]
    return members(answer, expected, single=NUMBERS)


def in_order(answer, names):
    """The values of a dict, whose keys are names or symbols, in the order of `names`; other answers
    as they are."""
    if not isinstance(answer, dict):
        return answer
    by_name, names = {str(key): value for key, value in answer.items()}, list(map(str, names))
    if set(by_name) != set(names):
        raise Invalid(f"expected a value for each of {', '.join(names)}")
    return [by_name[name] for name in names]


def vectors(answer, n, symbols, names=()):
    """A list of vectors from a list, a set, a matrix whose columns they are; none of them from
    anything empty. One that is a dict has a key for each of the `names`."""
    if isinstance(answer, np.ndarray) and answer.ndim == 2:
        answer = sp.Matrix(*answer.shape, [sp.sympify(x) for x in answer.ravel().tolist()])
    if isinstance(answer, np.ndarray):
        answer = answer.tolist()  # one vector, or none
    if isinstance(answer, sp.MatrixBase):
        if 0 in answer.shape:
            return []
        if n not in answer.shape:
            raise Invalid(
                f"expected a list of vectors with {n} components each, or a matrix whose columns "
                f"they are; the shape of yours is {answer.shape}"
            )
        if answer.rows != n:
            answer = answer.T  # an array made of a list of vectors has them as rows
        answer = [list(answer.col(j)) for j in range(answer.cols)]
    if answer is sp.S.EmptySet:
        return []
    if names and isinstance(answer, dict):
        answer = [answer]
    if not isinstance(answer, (list, tuple, set, frozenset, sp.FiniteSet, sp.Tuple)):
        raise Invalid(f"expected a list of vectors with {n} components each")
    parts = list(answer)
    if (
        parts
        and n > 1
        and all(
            isinstance(part, (int, float, complex, sp.Expr)) and not isinstance(part, bool)
            for part in parts
        )
    ):
        parts = [parts]  # a single vector, written without the outer list
    if (
        n > 1
        and len(parts) == n
        and all(isinstance(part, (list, tuple)) and len(part) == 1 for part in parts)
    ):
        parts = [[part[0] for part in parts]]  # a single column
    return [
        coercion.as_expressions(in_order(part, names) if names else part, symbols, n)
        for part in parts
    ]
