"""Read answers that are one thing or several into lists: from sets, arrays, results of solvers."""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.answer_forms import is_vector
from workbook.checks.contract.verdict import Invalid

VECTORS = (list, tuple, sp.Tuple, sp.MatrixBase, np.ndarray)
NUMBERS = (int, float, complex, sp.Expr)


def members(answer, expected, single=()):
    """Return the members of a collection as a list.

    Parameters
    ----------
    answer : object
        A list, set or array, equations joined by And, or a matrix, whose numbers are the members.
    expected : str
        Description of the answer for a student.
    single : tuple of type
        Types of a single member that is accepted without a collection.

    Raises
    ------
    Invalid
        If it is anything else.
    """
    if isinstance(answer, np.ndarray) and is_vector(answer):
        return answer.ravel().tolist()
    if isinstance(answer, sp.MatrixBase) and is_vector(answer):
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
    """Return the members of an answer that repeat periodically, as expressions in `integer`.

    Parameters
    ----------
    answer : object
        A collection as for `members`, or a set of the form that `solveset` returns.
    integer : sympy.Symbol or None
        The symbol that runs over all integers.
    expected : str
        Description of the answer for a student.
    """
    if isinstance(answer, (dict, np.ndarray)):
        answer = list(answer.values()) if isinstance(answer, dict) else answer.tolist()
    if isinstance(answer, sp.ConditionSet) and answer.sym not in answer.condition.free_symbols:
        # there are solutions for some parameters only, as the problem says
        answer = answer.base_set
    if isinstance(answer, sp.Intersection):
        real, *other_sets = [part for part in answer.args if part != sp.S.Reals]
        answer = answer if other_sets else real
    if isinstance(answer, sp.Union):
        return [part for member in answer.args for part in families(member, integer, expected)]
    if (
        isinstance(answer, sp.ImageSet)
        and answer.base_sets == (sp.S.Integers,)
        and integer is not None
        and len(answer.lamda.variables) == 1
    ):
        return [answer.lamda.expr.xreplace({answer.lamda.variables[0]: integer})]
    return members(answer, expected, single=NUMBERS)


def in_order(answer, names):
    """Return the values of a dict in the order of the names; other answers unchanged."""
    if not isinstance(answer, dict):
        return answer
    by_name, names = {str(key): value for key, value in answer.items()}, list(map(str, names))
    if set(by_name) != set(names):
        raise Invalid(f"expected a value for each of {', '.join(names)}")
    return [by_name[name] for name in names]


def vectors(answer, n, symbols, names=()):
    """Return a list of vectors.

    Parameters
    ----------
    answer : object
        A list or set of vectors, or a matrix whose columns they are; anything empty has none.
    n : int
        The number of components.
    symbols : list of sympy.Symbol
        The data's own symbols.
    names : list, optional
        The keys of a vector that is a dict, in the order of the components.

    Returns
    -------
    list of list of sympy.Expr
    """
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
