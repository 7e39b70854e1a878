"""Identification of a scalar measurement with one of several known quantities.

A measurement z = H x along the motions of x' = A x is a solution of a linear equation p(d/dt) z =
0, and every solution of the equation of lowest order occurs. So a measurement and a coordinate of
another system can be the same quantity only if these equations agree; they are found as the first
dependence among the rows H, H A, H A^2, ..., in exact arithmetic.

No check here is declared by a reference: the answer is a word.
"""

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from workbook.checks.contract.claims import Choice
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.references.invariant_subspaces import chain
from workbook.checks.references.records import matrix_of, row_of


@judged(Choice(words="quantities"))
def measured_quantity(claim, system, known, quantities):
    """Check which of the `quantities` {name: row} the measurement z = H x of x' = A x is.

    The rows are those of the system `known`; of one in `Deviations` they are {name: expression
    in its state} and stand for the deviations of these.

    Can decide when no two of the quantities satisfy the same equation of least order.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> drag = Linear(A=[[0, 1], [0, -2]])
    >>> measured = Linear(A=[[-2, 0], [1, 0]], H=[[0, 1]])
    >>> rows = {"position": sp.Matrix([[1, 0]]), "speed": sp.Matrix([[0, 1]])}
    >>> checks.measured_quantity("position", measured, drag, rows).status
    'right'
    >>> checks.measured_quantity("speed", measured, drag, rows).status
    'wrong'
    """
    equations = {
        name: _equation(matrix_of(known), row_of(known, quantity))
        for name, quantity in quantities.items()
    }
    A, H = system.A, system.H
    measured = _equation(A, H)
    if list(equations.values()).count(measured) != 1:
        raise UnsuitableData("quantities: the equations do not tell them apart")
    if equations[claim] != measured:
        raise Wrong(
            f"the {claim} satisfies the linear equation {_text(equations[claim])} and none of "
            "lower order, in all motions; what is measured has motions that do not"
            if _violates(equations[claim], A, H)
            else f"the {claim} has motions that break {_text(measured)}, an equation that holds for what is measured "
            f"in all motions"
        )
    return f"both satisfy {_text(measured)} and no equation of lower order, and no other of the quantities does"


def _equation(A, H):
    """Return the coefficients c0, c1, ..., 1 of lowest order with c0 H + c1 H A + ... + H A^k = 0."""
    rows = [sp.Matrix(H)]
    while True:
        following = rows[-1] * sp.Matrix(A)
        columns = DomainMatrix.from_Matrix(sp.Matrix.vstack(*rows, following).T)
        relations = columns.to_field().nullspace().to_Matrix()
        if relations.rows:
            return tuple(relations[0, :] / relations[0, len(rows)])
        rows.append(following)


def _violates(equation, A, H):
    """Return whether some motion of the system does not satisfy the equation."""
    rows = sp.Matrix.vstack(*chain(sp.Matrix(H), A, len(equation)))
    return not (sp.Matrix([equation]) * rows).is_zero_matrix


def _text(equation):
    """Return the equation for z as text, with primes for derivatives."""
    terms = [f"{'' if c == 1 else f'{c} '}z" + "'" * k for k, c in enumerate(equation) if c][::-1]
    return " + ".join(terms).replace("+ -", "- ") + " = 0"
