"""python-control's StateSpace in place of matrices, its keywords, and lists of floats."""

import inspect

import control
import numpy as np
import pytest
import sympy as sp

from trajlib import estimation, feedback, stability, structure
from trajlib.estimation import Moments

A, B, C = np.array([[0.0, 1], [-2, -3]]), np.array([[0.0], [1]]), np.array([[1.0, 0]])
SYSTEM = control.ss(A, B, C, 0)
STEPS = control.ss(A / 4, B, C, 0, 0.5)
ONE, TWO = np.eye(1), np.eye(2)
START = Moments([0.0, 0], TWO)
TIMES = np.linspace(0, 1, 5)

# A function, its arguments after the system, and the matrices of the system that it takes.
CONTINUOUS = [
    (feedback.lqr, (TWO, ONE), (A, B)),
    (feedback.finite_lqr, (TWO, ONE, TWO, 0.5), (A, B)),
    (feedback.lqg, (TWO, ONE, TWO, ONE), (A, B, C)),
    (feedback.fixed_ends_lqr, (TWO, ONE, [0.0, 1], [1.0, 0], 2.0), (A, B)),
    (estimation.ContinuousFilter, (TWO, ONE), (A, C)),
    (estimation.stationary_filter, (TWO, ONE), (A, C)),
    (estimation.stationary_covariance, (TWO,), (A,)),
    (estimation.error_covariance, (TWO, ONE, [[1.0], [1.0]]), (A, C)),
    (estimation.continuous_moments, (TWO, START, 1.0), (A,)),
    (estimation.discretise, (TWO, 0.1), (A,)),
    (estimation.discretise_with_input, (TWO, 0.1), (A, B)),
    (estimation.simulate_continuous, (TWO, START, TIMES, 2, 1), (A,)),
    (structure.controllability_gramian, (1.0,), (A, B)),
    (stability.linear_stability, (), (A,)),
    (stability.classify_planar, (), (A,)),
    (stability.stability_conditions, ([],), (A,)),
]
DISCRETE = [
    (feedback.discrete_lqr, (TWO, ONE), (A / 4, B)),
    (feedback.discrete_finite_lqr, (TWO, ONE, TWO, 3), (A / 4, B)),
    (feedback.discrete_lqg, (TWO, ONE, TWO, ONE), (A / 4, B, C)),
    (estimation.KalmanFilter, (TWO, ONE), (A / 4, C)),
    (estimation.discrete_stationary_filter, (TWO, ONE), (A / 4, C)),
    (estimation.discrete_stationary_covariance, (TWO,), (A / 4,)),
    (estimation.discrete_moments, (TWO, START, 3), (A / 4,)),
    (estimation.simulate_discrete, (TWO, START, 3, 2, 1), (A / 4,)),
]
EITHER = [
    (feedback.place, ([-1, -2],), (A, B)),
    (feedback.stabilisability, (), (A, B)),
    (feedback.detectability, (), (A, C)),
    (feedback.best_degree, (), (A, B, C)),
    (structure.observability, (), (A, C)),
    (structure.controllability, (), (A, B)),
    (structure.controllability_matrix, (), (A, B)),
    (structure.observability_matrix, (), (A, C)),
    (structure.controllable_subspace, (), (A, B)),
    (structure.unobservable_subspace, (), (A, C)),
    (structure.controllability_decomposition, (), (A, B)),
    (structure.observability_decomposition, (), (A, C)),
    (structure.controller_canonical_form, (), (A, B)),
    (structure.observer_canonical_form, (), (A, C)),
    (structure.distance_to_uncontrollable, (), (A, B)),
    (structure.distance_to_unobservable, (), (A, C)),
    (structure.with_measurement_error, ([[0]], [[1]]), (A, C)),
    (stability.characteristic_polynomial, (sp.Symbol("s"),), (A,)),
]


def shown(value):
    """Return what a result holds, to be compared."""
    return [shown(part) for part in value] if isinstance(value, tuple) else repr(value)


@pytest.mark.parametrize(
    "function, rest, matrices, system",
    [(*row, SYSTEM) for row in CONTINUOUS + EITHER] + [(*row, STEPS) for row in DISCRETE],
)
def test_system_stands_in_the_place_of_its_matrices(function, rest, matrices, system):
    assert shown(function(system, *rest)) == shown(function(*matrices, *rest))


@pytest.mark.parametrize(
    "function, rest, system",
    [(function, rest, STEPS) for function, rest, _ in CONTINUOUS]
    + [(function, rest, SYSTEM) for function, rest, _ in DISCRETE],
)
def test_system_in_the_other_time_is_refused(function, rest, system):
    name = next(iter(inspect.signature(function).parameters))
    expected = rf"{name}: expected a system in .* time, got .* time \(dt = .*; "
    with pytest.raises(ValueError, match=expected):
        function(system, *rest)


@pytest.mark.parametrize(
    "function, rest, sister",
    [
        (feedback.observer, ([-1, -2],), "place"),
        (feedback.regulator, ([-1, -2],), "place"),
        (feedback.reduced_observer, ([-1],), "place"),
        (feedback.stabilising_gains, ([[1, 1]],), "place"),
        (feedback.convergent_gains, ([1, 1],), "place"),
        (feedback.feedback_by_estimate, ([[1, 1]], [1, 1]), "numpy.block"),
        (estimation.with_shaping, (None,), "numpy.block"),
    ],
)
def test_exact_functions_name_what_is_for_floats(function, rest, sister):
    with pytest.raises(ValueError, match=f"expected exact entries .* for floats .*{sister}"):
        function(SYSTEM, *rest)


def test_advice_of_the_observer_is_right():
    L = -feedback.place(A.T, C.T, [-4, -5]).gain.T
    np.testing.assert_allclose(np.sort(np.linalg.eigvals(A - L @ C)), [-5, -4])
    exact = feedback.observer([[0, 1], [-2, -3]], [[1, 0]], eigenvalues=[-4, -5])
    np.testing.assert_allclose(np.array(exact.gain, dtype=float), L)


@pytest.mark.parametrize(
    "poles, inputs, stabilisable, margin",
    [
        ([0.5, 0.9], [1, 0], True, 0.1),
        ([0.5, -1.5], [1, 0], False, -0.5),
        ([-2.0, 0.25], [1, 0], True, 0.75),
        ([0.5, -1.0], [1, 0], False, 0.0),
        ([3.0, -2.0], [1, 1], True, 1.0),
    ],
)
@pytest.mark.parametrize("dt", [True, 0.1])
def test_discrete_modes_are_judged_by_the_unit_circle(poles, inputs, stabilisable, margin, dt):
    column = np.array(inputs, dtype=float)[:, None]
    T = np.array([[1.0, 2], [-1, 1]])
    matrix, back = T @ np.diag(poles) @ np.linalg.inv(T), np.linalg.inv(T)
    system = control.ss(matrix, T @ column, column.T @ back, 0, dt)
    for test in (feedback.stabilisability, feedback.detectability):
        found = test(system)
        assert bool(found) == stabilisable and found.degree == pytest.approx(margin, abs=1e-12)
    assert feedback.best_degree(system) == pytest.approx(margin, abs=1e-12)
    assert len(found.obstacles) == (not stabilisable)


def test_system_without_a_time_base_is_continuous():
    assert feedback.stabilisability(control.ss(-2, 0, 1, 0, None)).degree == 2


def test_fixed_mode_on_the_axis_is_an_obstacle_within_rounding():
    T = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0]
    found = feedback.stabilisability(T @ np.diag([0.0, -1, 2]) @ T.T, T @ [[0.0], [0], [1]])
    assert not found and found.degree == 0


END = {"F": TWO, "time_to_go": 1.0}
THEIR_NOISES = {"Q": 2 * TWO, "R": 3 * ONE, "QN": TWO, "RN": ONE}
OUR_NOISES = {"G": 2 * TWO, "N": 3 * ONE, "Q": TWO, "R": ONE}
KEYWORDS = [
    (feedback.lqr, (A, B), {"Q": TWO, "R": ONE}, {"G": TWO, "N": ONE}),
    (estimation.stationary_filter, (A,), {"C": C, "QN": TWO, "RN": ONE}, {"H": C, "Q": TWO, "R": ONE}),
    (feedback.place, (A, B), {"p": [-1, -2]}, {"eigenvalues": [-1, -2]}),
    (estimation.KalmanFilter, (A,), {"C": C, "QN": TWO, "RN": ONE}, {"H": C, "Q": TWO, "R": ONE}),
    (estimation.KalmanFilter, (), {"F": A, "H": C, "Q": TWO, "R": ONE}, {"Phi": A, "H": C, "Q": TWO, "R": ONE}),
    (feedback.lqr, (A, B), {"Q": TWO, "R": ONE, "N": B / 4}, {"G": TWO, "N": ONE, "cross": B / 4}),
    (feedback.finite_lqr, (A, B), {"Q": TWO, "R": ONE, "N": B / 4, **END}, {"G": TWO, "N": ONE, "cross": B / 4, **END}),
    (feedback.discrete_lqr, (A / 4, B), {"Q": TWO, "R": ONE, "N": B / 4}, {"G": TWO, "N": ONE, "cross": B / 4}),
    (feedback.lqg, (A, B, C), THEIR_NOISES, OUR_NOISES),
    (feedback.discrete_lqg, (A / 4, B), {"C": C, **THEIR_NOISES}, {"H": C, **OUR_NOISES}),
    (structure.observability, (A,), {"C": C}, {"H": C}),
    (structure.observer_canonical_form, (A,), {"C": C}, {"h": C}),
]  # fmt: skip


@pytest.mark.parametrize("function, matrices, theirs, ours", KEYWORDS)
def test_keywords_of_python_control_are_accepted(function, matrices, theirs, ours):
    assert shown(function(*matrices, **theirs)) == shown(function(*matrices, **ours))
    with pytest.raises(TypeError, match="are one argument"):
        function(*matrices, **(theirs | ours))


def test_lqr_is_written_as_python_control_users_write_it():
    gain, _, _ = control.lqr(SYSTEM, TWO, ONE, method="scipy")
    np.testing.assert_allclose(feedback.lqr(SYSTEM, TWO, ONE).gain, -gain)
    np.testing.assert_allclose(feedback.lqr(SYSTEM, Q=TWO, R=ONE).gain, -gain)


def test_noises_of_lqg_keep_their_names_beside_given_weights():
    named = feedback.lqg(SYSTEM, TWO, ONE, QN=2 * TWO, RN=3 * ONE)
    assert shown(named) == shown(feedback.lqg(SYSTEM, TWO, ONE, 2 * TWO, 3 * ONE))


@pytest.mark.parametrize(
    "regulator, theirs", [(feedback.lqr, control.lqr), (feedback.discrete_lqr, control.dlqr)]
)
def test_cross_term_is_in_the_place_of_python_control(regulator, theirs):
    law = regulator(A / 4, B, TWO, ONE, B / 4)
    gain, _, _ = theirs(A / 4, B, TWO, ONE, B / 4, method="scipy")
    np.testing.assert_allclose(law.gain, -gain, atol=1e-12)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: feedback.lqr(A, B, TWO, ONE, stable="no"), "stable: expected True or False"),
        (lambda: feedback.lqr(A, B, TWO, ONE, False), "cross: expected a matrix, got False"),
        (lambda: feedback.discrete_lqr(1, 1, 1, 1, True), "cross: expected a matrix, got True"),
        (lambda: feedback.lqr(A, B, TWO, ONE, B.T), "cross: expected a matrix 2 x 1"),
        (lambda: feedback.lqr(A, B, TWO, ONE, None, False), "positional arguments"),
        (lambda: feedback.discrete_lqr(A, B, TWO, ONE, stable=True), "argument 'stable'"),
    ],
)
def test_what_is_no_option_of_a_regulator_is_refused_by_name(call, message):
    with pytest.raises((TypeError, ValueError), match=message):
        call()


LISTS = [
    lambda a: feedback.lqr([[0, 1], [a, 0]], [0, 1], [[1, 0], [0, 1]], 1).gain,
    lambda a: estimation.stationary_filter([[0, 1], [a, 0]], [1, 0], [[1, 0], [0, 1]], 1).gain,
    lambda a: structure.observability_matrix([[0, 1], [a, 0]], [1, 0]),
    lambda a: structure.controllability_matrix([[0, 1], [a, 0]], [0, 1]),
    lambda a: estimation.stationary_covariance([[0, 1], [-a, -1]], [[1, 0], [0, 1]]).covariance,
]


@pytest.mark.parametrize("function", LISTS)
def test_decimals_in_lists_stay_floats(function):
    floats, exact = function(9.81), function(sp.Rational(981, 100))
    assert isinstance(floats, np.ndarray) and isinstance(exact, sp.MatrixBase)
    np.testing.assert_allclose(floats, np.array(exact, dtype=float), rtol=1e-12)
    assert isinstance(function(9), sp.MatrixBase)


def test_decimal_beside_a_symbol_is_the_number_that_was_written():
    a = sp.Symbol("a")
    assert structure.observability_matrix([[0.1, 0], [a, 0]], [1, 0])[1, 0] == sp.Rational(1, 10)
    assert (
        stability.linear_stability([[-0.1, 0], [0, -1]]).reason == "all real parts are at most -0.1"
    )
    with pytest.raises(ValueError, match="floats and exact symbols"):
        feedback.lqr([[0.5]], [[a]], 1, 1)
