import numpy as np
import pytest
import sympy as sp

from workbook.systems import (
    Coloured,
    Controlled,
    Deviations,
    FilterErrors,
    Linear,
    Mechanical,
    Process,
    Scalar,
    Varying,
    WithError,
)

k = sp.Symbol("k")
STATED = Mechanical(M=[[2, 1], [1, k]], D=0, K=sp.diag(1, 2), L=[1, k], H2=[[1, 0], [0, 1]])


def test_what_is_left_out_is_zero_in_the_right_shape():
    assert STATED.D == sp.zeros(2) and STATED.L == sp.Matrix([1, k])
    assert STATED.H1 == sp.zeros(2) and STATED.H2 == sp.eye(2)
    assert Mechanical([[1]], 0, [[1]]).L == Mechanical([[1]], 0, [[1]]).H1 == sp.zeros(1)


def test_a_linear_system_has_what_is_stated():
    plant = Linear([[0, 1], [k, 0]], [0, 1], [[1, 0]])
    assert (plant.B, plant.H, plant.unknowns) == (sp.Matrix([0, 1]), sp.Matrix([[1, 0]]), 2)
    assert Linear(plant.A).B.shape == (2, 0) and Linear(plant.A).H.shape == (0, 2)
    assert plant.dual == Linear(plant.A.T, [1, 0], [[0, 1]]) and plant.dual.dual == plant
    assert plant.subs(k, 3) == plant.subs({k: 3}) == Linear([[0, 1], [3, 0]], [0, 1], [[1, 0]])


def test_an_error_of_a_measurement_begins_as_stated_or_as_it_likes():
    known = WithError([[0]], H=[[1]], S=sp.diag(k, 1), c=[[1, 0]], start=[1, 2])
    free = WithError([[0]], H=[[1]], S=sp.diag(k, 1), c=[[1, 0]])
    assert (known.unknowns, free.unknowns) == (2, 3)
    assert known.subs(k, 2).S == sp.diag(2, 1) and known.subs(k, 2).start == sp.Matrix([1, 2])


def test_a_row_that_changes_with_time_and_a_motion():
    t, x = sp.symbols("t x")
    assert Varying([[0]], [[k * t]], t).subs(k, 2) == Varying([[0]], [[2 * t]], t)
    assert STATED.dual.H1 == STATED.L.T and STATED.unknowns == 4
    with pytest.raises(ValueError, match="as many of each, got 2, 1, 1"):
        Deviations([x, x], [x], {x: t})


@pytest.mark.parametrize(
    "record, part, given",
    [
        (Linear, "A", {"A": [[1, 2]]}),
        (Linear, "B", {"B": [1, 2, 3]}),
        (Linear, "H", {"H": [1, 0]}),
        (WithError, "S", {"H": [[1, 0]], "S": [[1, 2]], "c": [[1]]}),
        (WithError, "c", {"H": [[1, 0]], "S": [[1]]}),
        (WithError, "start", {"H": [[1, 0]], "S": [[1]], "c": [[1]], "start": [1, 2]}),
        (Varying, "H", {"H": [[1]], "time": k}),
    ],
)
def test_matrices_that_do_not_fit_a_linear_system_are_refused(record, part, given):
    with pytest.raises(ValueError, match=rf"{part} has the shape"):
        record(**({"A": sp.eye(2)} | given))


def test_a_controlled_system_is_stated_by_its_equations_and_bounds():
    x1, x2, u = sp.symbols("x1 x2 u")
    system = Controlled({x1: x2, x2: u - k * x1}, {u: [0, k]})
    assert (system.state, system.field, system.control, system.bounds) == (
        [x1, x2],
        [x2, u - k * x1],
        u,
        (0, k),
    )
    dynamics, controls = system
    assert dynamics == {x1: x2, x2: u - k * x1} and controls == {u: [0, k]}


@pytest.mark.parametrize("controls", [{}, {k: (0, 1), sp.Symbol("u"): (0, 1)}, {k: (0, 1, 2)}])
def test_a_controlled_system_has_one_control_with_two_bounds(controls):
    with pytest.raises(ValueError, match="one control with two bounds"):
        Controlled({sp.Symbol("x"): k}, controls)


def test_matrices_may_be_arrays_of_numpy():
    A, B, H = [[0, 1], [-2, -3]], [[0], [1]], [[1, 0]]
    arrays = [np.array(matrix) for matrix in (A, B, H)]
    assert Linear(*arrays) == Linear(A, B, H)
    assert Mechanical(*[np.eye(2, dtype=int)] * 3, H1=arrays[2]) == Mechanical(
        *[sp.eye(2)] * 3, H1=H
    )
    assert Process(arrays[0], Q=np.eye(2, dtype=int), H=arrays[2], R=1) == Process(
        A, Q=sp.eye(2), H=H, R=1
    )


def test_values_go_everywhere():
    assert STATED.subs(k, 3) == Mechanical(
        M=[[2, 1], [1, 3]], D=0, K=sp.diag(1, 2), L=[1, 3], H2=sp.eye(2)
    )
    assert len({STATED, STATED.subs({k: 3}), STATED.subs(k, 3)}) == 2


@pytest.mark.parametrize(
    "part, given", [("K", [[1, 2]]), ("L", [[1, 2]]), ("H1", [[1, 2, 3]]), ("M", [[1, 2]])]
)
def test_shapes_that_do_not_fit_are_refused(part, given):
    with pytest.raises(ValueError, match=rf"{part} has the shape"):
        Mechanical(**({"M": sp.eye(2), "D": 0, "K": sp.eye(2)} | {part: given}))


def test_a_process_takes_numbers_where_matrices_are_single():
    wiener = Process(A=0, Q=k, H=1, R=2, mean=1)
    assert (
        wiener.A == wiener.covariance == sp.zeros(1)
        and wiener.Q == sp.Matrix([[k]])
        and wiener.mean == sp.eye(1)
    )
    assert wiener.subs(k, 3) == Process(A=0, Q=3, H=1, R=2, mean=1) and not wiener.discrete
    cart = Process(A=[[0, 1], [0, 0]], Q=sp.diag(0, k), H=[[1, 0]], R=1, mean=[1, 0], discrete=True)
    assert cart.covariance == sp.zeros(2) and cart.subs(k, 1).discrete and cart.H.shape == (1, 2)
    assert Process(A=[[0, 1], [0, 0]]).H.shape == (0, 2)


def test_a_coloured_noise_stands_alone_or_enters_a_system():
    tau = sp.Symbol("tau", nonnegative=True)
    alone = Coloured(k * sp.exp(-tau), tau, C=1, R=2)
    assert alone.A.shape == (0, 0) and alone.H.shape == (1, 0) and alone.C == sp.eye(1)
    cart = Coloured(k, tau, A=[[0, 1], [0, 0]], B=[0, 1], H=[[0, 1]], R=1)
    assert (
        cart.covariance == sp.zeros(2)
        and cart.C == sp.zeros(1)
        and cart.subs(k, 3).correlation == 3
    )
    with pytest.raises(ValueError, match="B has the shape"):
        Coloured(k, tau, A=[[0, 1], [0, 0]], B=[1], H=[[0, 1]], R=1)


def test_the_gain_of_a_filter_has_a_column_for_each_measurement():
    tau = sp.Symbol("tau", nonnegative=True)
    made = Coloured(k * sp.exp(-tau), tau, A=-1, B=1, H=1, R=2)
    assert FilterErrors(made, [1, k]).gain.shape == (2, 1)
    assert FilterErrors(Process(A=-1, H=1), k).gain == sp.Matrix([[k]])
    with pytest.raises(ValueError, match="gain has the shape"):
        FilterErrors(made, [[1, k]])


@pytest.mark.parametrize(
    "part, given, words",
    [
        ("Q", [[1, 2]], "Q has the shape"),
        ("H", [[1, 0, 0]], "H has the shape"),
        ("mean", [1], "mean has the shape"),
        ("R", sp.eye(2), "R has the shape"),
        ("Q", [[1, 1], [0, 1]], "symmetric"),
        ("A", [[1, 2]], "A has the shape"),
    ],
)
def test_processes_that_do_not_fit_are_refused(part, given, words):
    with pytest.raises(ValueError, match=words):
        Process(**({"A": sp.zeros(2), "Q": sp.eye(2), "H": [[1, 0]], "R": 1} | {part: given}))


def test_one_equation_tells_its_order_and_coefficients():
    s = sp.Symbol("s")
    equation = Scalar(s**3 - k * s + 6, s + 3, 3 + s, s)
    assert equation.order == 3 and equation.coefficients == [[6, -k, 0, 1], [3, 1], [3, 1]]
    assert Scalar(s**2, 0, 1, s).coefficients[1] == [0]


@pytest.mark.parametrize(
    "right, measured, words",
    [
        ("s**2", "1", "right: expected a lower degree"),
        ("1", "s**2 + 1", "measured: expected a lower degree"),
        ("s", "s", "z holds the control itself"),
    ],
)
def test_equations_whose_output_holds_the_control_are_refused(right, measured, words):
    with pytest.raises(ValueError, match=words):
        Scalar(*map(sp.sympify, ("s**2 - 1", right, measured)), sp.Symbol("s"))
