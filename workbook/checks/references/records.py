"""The observable and the controllable part of systems given as records, as pairs of matrices."""

import sympy as sp
from sympy.matrices.exceptions import NonInvertibleMatrixError

from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.constant_unknowns import constants_of
from workbook.checks.references.initial_states import initial_states_of, initial_states_of_varying
from workbook.checks.references.pairs import pair_of
from workbook.systems import (
    Deviations,
    Linear,
    Measurements,
    Mechanical,
    Process,
    Varying,
    WithError,
)


def observed_pair(system, parameters=(), selected=None):
    """Return the `Pair` of a system with an output; its unknowns are those of an initial state.

    Of a system `WithError` `selected` are the indices of the unknowns whose observability is asked
    for, by default all.
    """
    if isinstance(system, Varying):
        return initial_states_of_varying(system.A, system.H, system.time, parameters)
    if isinstance(system, Measurements):
        return constants_of(system.jacobian, tuple(parameters))
    joint = augmented(_in_states(system))
    if isinstance(system, WithError) and system.start:
        start = sp.diag(sp.eye(system.A.rows), system.start)
        return initial_states_of(joint.A, joint.H, start, parameters, selected)
    if isinstance(joint, (Linear, Process)):
        return pair_of(joint.A, joint.H, parameters)
    raise UnsuitableData(
        f"system: expected a record of a system with an output, got {type(system).__name__}"
    )


def controlled_pair(system, parameters=()):
    """Return the `Pair` of the controllable part: that of the transposed matrices."""
    return observed_pair(_in_states(system).dual, parameters)


def augmented(system):
    """Return the `Linear` system of x and the error w; without an error the system itself."""
    if not isinstance(system, WithError):
        return system
    k, s = system.S.rows, system.B.cols
    return Linear(
        sp.diag(system.A, system.S), system.B.col_join(sp.zeros(k, s)), system.H.row_join(system.c)
    )


def matrix_of(system, parameters=()):
    """Return the matrix of the equations."""
    if not isinstance(system, Deviations):
        return system.A
    return row_of(system, *system.field, parameters=parameters)


def row_of(system, *quantities, parameters=()):
    """Return quantities of the state as rows of numbers in x.

    For `Deviations` they are expressions, and the rows their derivatives on the motion, which hold the
    parameters alone.
    """
    if not isinstance(system, Deviations):
        if not all(isinstance(row, sp.MatrixBase) for row in quantities):
            raise UnsuitableData("quantities: expected rows of numbers for this system")
        return sp.Matrix.vstack(*quantities)
    slopes = sp.Matrix(quantities).jacobian(list(system.state))
    rows = slopes.subs(system.motion).applyfunc(sp.simplify)
    if not rows.free_symbols <= set(parameters):
        raise UnsuitableData("the deviation equations are not constant")
    return rows


def has_control(system):
    """Return whether a system, which has a control or an output, has a control."""
    if isinstance(system, Mechanical):
        control, output = any(system.L), any(system.H1) or any(system.H2)
    else:
        control, output = bool(getattr(system, "B", ())), bool(system.H)
    if control == output:
        raise UnsuitableData("system: expected one with either a control or an output")
    return control


def _in_states(system):
    """Return a `Mechanical` system as the `Linear` one of (x, x'); others unchanged."""
    if not isinstance(system, Mechanical):
        return system
    try:
        n, inverse = system.M.rows, system.M.inv(method="ADJ")
    except NonInvertibleMatrixError:
        raise UnsuitableData("system: expected an M that has an inverse") from None
    A = sp.Matrix([[sp.zeros(n), sp.eye(n)], [-inverse * system.K, -inverse * system.D]])
    B = sp.zeros(n, system.L.cols).col_join(inverse * system.L)
    return Linear(A, B, system.H1.row_join(system.H2))
