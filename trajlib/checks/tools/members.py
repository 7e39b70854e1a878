"""Answers that are one thing or several, read into lists, whatever a student keeps them in: lists, sets, arrays, what
SymPy's solvers give."""

import numpy as np
import sympy as sp

from trajlib.checks.contract.verdict import Invalid

VECTORS = (list, tuple, sp.Tuple, sp.MatrixBase, np.ndarray)
NUMBERS = (int, float, complex, sp.Expr)


def members(answer, expected, single=()):
    """The members of a collection as a list; one alone, of the types `single`, is a list of it.

    Of a matrix or an array they are its numbers. Anything else is `Invalid`, which says what was `expected`.
    """
    if isinstance(answer, np.ndarray):
        return answer.ravel().tolist()
    if isinstance(answer, sp.MatrixBase) and (1 in answer.shape or 0 in answer.shape):
        return list(answer)
    if isinstance(answer, (list, tuple, set, frozenset, sp.Tuple, sp.FiniteSet)) or answer is sp.S.EmptySet:
        return list(answer)
    if isinstance(answer, single) and not isinstance(answer, bool):
        return [answer]
    raise Invalid(f"expected {expected}")


def families(answer, integer, expected):
    """The members of an answer that repeat periodically: expressions in `integer`, also for a set that `solveset`
    gives."""
    if isinstance(answer, (dict, np.ndarray)):
        answer = list(answer.values()) if isinstance(answer, dict) else answer.tolist()
    if isinstance(answer, sp.Union):
        return [part for one in answer.args for part in families(one, integer, expected)]
    if (isinstance(answer, sp.ImageSet) and answer.base_sets == (sp.S.Integers,) and integer is not None
            and len(answer.lamda.variables) == 1):
        return [answer.lamda.expr.xreplace({answer.lamda.variables[0]: integer})]
    return members(answer, expected, single=NUMBERS)


def in_order(answer, names):
    """The values of a dict, whose keys are names or symbols, in the order of `names`; other answers as they are."""
    if not isinstance(answer, dict):
        return answer
    by_name, names = {str(key): value for key, value in answer.items()}, list(map(str, names))
    if set(by_name) != set(names):
        raise Invalid(f"expected a value for each of {', '.join(names)}")
    return [by_name[name] for name in names]
