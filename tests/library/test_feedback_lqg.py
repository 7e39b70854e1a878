"""LQG controllers closed with the plant by python-control, against Lyapunov equations and others."""

import control
import numpy as np
import pytest
import scipy.linalg
import sympy as sp

from trajlib.feedback import discrete_lqg, lqg

WEIGHTS = np.diag([2.0, 1, 0.5]), np.diag([1.0, 0.3])
NOISES = np.diag([0.5, 0.2, 1.0]), np.diag([0.1, 0.4])


def plant(seed, dt):
    rng = np.random.default_rng(seed)
    A = rng.normal(size=(3, 3))
    A = A / np.abs(np.linalg.eigvals(A)).max() * 1.2 if dt else A
    return control.ss(A, rng.normal(size=(3, 2)), rng.normal(size=(2, 3)), 0, dt)


def cost_of_loop(system, controller):
    """Return the mean cost of plant and controller from the covariance of all their states."""
    A, B, H = system.A, system.B, system.C
    a, b, c, d = controller.A, controller.B, controller.C, controller.D
    loop = np.block([[A + B @ d @ H, B @ c], [b @ H, a]])
    push = np.block([[np.eye(3), B @ d], [np.zeros((3, 3)), b]])
    noise = push @ scipy.linalg.block_diag(*NOISES) @ push.T
    if system.dt:
        P = scipy.linalg.solve_discrete_lyapunov(loop, noise)
    else:
        P = scipy.linalg.solve_continuous_lyapunov(loop, -noise)
    control_map = np.hstack([d @ H, c])
    control_covariance = control_map @ P @ control_map.T + d @ NOISES[1] @ d.T
    return np.trace(WEIGHTS[0] @ P[:3, :3]) + np.trace(WEIGHTS[1] @ control_covariance)


@pytest.mark.parametrize("function, dt", [(lqg, 0), (discrete_lqg, 0.25)])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_controller_closes_the_loop(function, dt, seed):
    system = plant(seed, dt)
    feedback = function(system, *WEIGHTS, *NOISES)
    closed = control.feedback(system, feedback.controller, sign=1)
    assert np.array_equal(closed.A, control.feedback(system, -feedback.controller).A)
    assert closed.dt == dt
    poles = np.concatenate(
        [np.linalg.eigvals(part) for part in (feedback.regulator.loop, feedback.filter.errors)]
    )
    np.testing.assert_allclose(np.poly(closed.A), np.poly(poles), rtol=1e-8, atol=1e-9)
    assert feedback.cost == pytest.approx(cost_of_loop(system, feedback.controller), rel=1e-9)


@pytest.mark.parametrize("function, dt", [(lqg, 0), (discrete_lqg, True)])
def test_no_other_controller_costs_less(function, dt):
    system, rng = plant(4, dt), np.random.default_rng(5)
    feedback = function(system, *WEIGHTS, *NOISES)
    best = feedback.controller
    least = cost_of_loop(system, best)
    for _ in range(20):
        matrices = [
            M + 1e-3 * rng.normal(size=M.shape) * (name != "D" or bool(dt))
            for name, M in zip("ABCD", (best.A, best.B, best.C, best.D))
        ]
        assert cost_of_loop(system, control.ss(*matrices, dt)) > least


def test_exact_controller_and_its_refusals():
    exact = discrete_lqg(sp.Rational(3, 2), 1, 1, 1, 1, 1, 1)
    K, L = exact.regulator.gain, exact.filter.gain
    assert sp.simplify(exact.matrices[3][0] - K[0] * L[0]) == 0
    assert not lqg([[1.0]], [[0.0]], 1, 1, 1, 1, 1).matrices
    floats = discrete_lqg(1.5, 1, 1, 1, 1, 1, 1)
    assert float(exact.cost) == pytest.approx(floats.cost, rel=1e-12)
    np.testing.assert_allclose(exact.controller.D, floats.controller.D, rtol=1e-12)
    a = sp.Symbol("a", positive=True)
    with pytest.raises(ValueError, match="substitute numbers"):
        _ = lqg(a, 1, 1, 1, 1, 1, 1).controller
    with pytest.raises(ValueError, match="there is no feedback: .*not stabilisable"):
        _ = lqg([[1.0]], [[0.0]], 1, 1, 1, 1, 1).controller
