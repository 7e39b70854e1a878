"""What a record shows and what its control reaches, against Kalman's matrices of SymPy on systems
of every kind."""

import pytest
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.records import (
    augmented,
    controlled_pair,
    has_control,
    matrix_of,
    observed_pair,
)
from workbook.systems import (
    Deviations,
    Linear,
    Measurements,
    Mechanical,
    Process,
    Varying,
    WithError,
)

k, t, x, y = sp.symbols("k t x y", real=True)
# M is not symmetric, so that the dual system is not the system of the transposed states.
BODIES = Mechanical(
    [[2, 1], [0, 1]], [[0, 1], [-1, 0]], [[1, 0], [3, 1]], L=[1, 0], H1=[[1, 0]], H2=[[0, 2]]
)


def kalman(A, H):
    return sp.Matrix.vstack(*(H * A**j for j in range(A.rows)))


def in_states(system):
    z, inverse = sp.zeros(2), system.M.inv()
    A = sp.Matrix(sp.BlockMatrix([[z, sp.eye(2)], [-inverse * system.K, -inverse * system.D]]))
    return A, sp.zeros(2, 1).col_join(inverse * system.L), system.H1.row_join(system.H2)


@pytest.mark.parametrize(
    "stiffness", [[[1, 0], [3, 1]], [[1, 2], [0, 1]], [[4, 0], [0, 1]], [[0, 0], [0, 0]]]
)
def test_a_mechanical_system_is_that_of_its_states(stiffness):
    system = Mechanical(BODIES.M, BODIES.D * 0, stiffness, BODIES.L, BODIES.H1)
    A, B, H = in_states(system)
    for pair, rows in (
        (observed_pair(system), kalman(A, H)),
        (controlled_pair(system), kalman(A.T, B.T)),
    ):
        (unobservable,) = pair.unobservable
        vectors = sp.Matrix(
            len(unobservable),
            4,
            [
                sp.Rational(int(v.numerator), int(v.denominator))
                for row in unobservable
                for v in row
            ],
        )
        assert (rows * vectors.T).is_zero_matrix and len(unobservable) == 4 - rows.rank()


def test_what_the_control_of_bodies_reaches_is_what_the_output_of_the_dual_shows():
    assert [
        len(pair.unobservable[0]) for pair in (controlled_pair(BODIES), observed_pair(BODIES.dual))
    ] == [0, 0]
    free = Mechanical(sp.eye(2), 0, sp.eye(2), L=[1, 1])
    assert [
        len(pair.unobservable[0]) for pair in (controlled_pair(free), observed_pair(free.dual))
    ] == [2, 2]


def test_a_process_is_seen_as_a_linear_system_is():
    A, H = sp.Matrix([[0, 1], [0, 0]]), sp.Matrix([[0, 1]])
    assert observed_pair(Process(A=A, H=H, R=1)) is observed_pair(Linear(A, H=H))


def test_an_error_hides_what_it_can_imitate():
    position = Linear([[0, 1], [0, 0]], [0, 1], [[1, 0]])
    biased = WithError(position.A, position.B, position.H, S=[[0]], c=[[1]], start=[1])
    assert augmented(position) is position
    assert augmented(biased) == Linear(sp.diag(position.A, 0), [0, 1, 0], [[1, 0, 1]])
    assert [len(observed_pair(biased, (), of).unobservable[0]) for of in (None, (0, 1), (2,))] == [
        1,
        1,
        1,
    ]
    # An error whose start is not known is as many unknowns as it has coordinates.
    free = WithError(position.A, H=position.H, S=sp.zeros(2), c=[[1, 0]])
    assert (free.unknowns, len(observed_pair(free).unobservable[0])) == (4, 2)


def test_rows_that_change_and_measurements_of_constants():
    assert observed_pair(Varying([[0, 1], [0, 0]], [[1, -t]], t)).unobservable == [[[0, -1]]]
    ring = Measurements([sp.sqrt(x**2 + y**2)], [x, y])
    (positions, *_), (unobservable, *_) = (
        zip(*observed_pair(ring, [x, y]).samples),
        observed_pair(ring, [x, y]).unobservable,
    )
    assert len(unobservable) == 1 and positions[0]


def test_deviations_are_constant_or_refused():
    turning = Deviations([y, -k * sp.sin(x)], [x, y], {x: sp.pi, y: 0})
    assert matrix_of(turning, [k]) == sp.Matrix([[0, 1], [k, 0]])
    for system, parameters in (
        (turning, ()),
        (Deviations([y, sp.sin(x)], [x, y], {x: t, y: 1}), [k]),
    ):
        with pytest.raises(ValueError, match="not constant"):
            matrix_of(system, parameters)


def test_a_record_with_one_side_says_which():
    pair = sp.eye(2), [1, 0]
    assert has_control(Linear(*pair)) and has_control(Mechanical(pair[0], 0, 0, L=pair[1]))
    assert not has_control(Linear(pair[0], H=[pair[1]])) and not has_control(
        Mechanical(pair[0], 0, 0, H2=[pair[1]])
    )
    for unclear in (Linear(pair[0]), Linear(*pair, [pair[1]]), BODIES):
        with pytest.raises(UnsuitableData, match="either a control or an output"):
            has_control(unclear)
    with pytest.raises(UnsuitableData, match="a record of a system with an output, got int"):
        observed_pair(3)
