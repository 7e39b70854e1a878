"""Fixed ends, cross terms and indefinite costs against integration, other laws and python-control."""

import control
import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
import sympy as sp

from trajlib import feedback, structure
from trajlib.feedback.indefinite_cost import _exact_point

A = np.array([[0.0, 1, 0], [-2, -0.3, 1], [0.5, 0, -1]])
B = np.array([[0.0, 1], [1, 0], [0, 0.5]])
G, N = np.diag([2.0, 0, 1]), np.array([[1.0, 0.2], [0.2, 0.5]])
START, END = np.array([1.0, -2, 0.5]), np.array([0.3, 1.0, -1])


@pytest.mark.parametrize("weight", [0 * G, G])
@pytest.mark.parametrize("duration", [0.5, 3.0])
def test_control_reaches_the_end_at_its_cost(weight, duration):
    best = feedback.fixed_ends_lqr(A, B, weight, N, START, END, duration)
    nodes, quadrature = np.polynomial.legendre.leggauss(30)
    times = duration * (nodes + 1) / 2

    def rate(t, x):
        return A @ x + B @ best.at(t).control

    motion = scipy.integrate.solve_ivp(
        rate, (0, duration), START, t_eval=[*times, duration], rtol=1e-10, atol=1e-11
    ).y.T
    np.testing.assert_allclose(motion[-1], END, atol=1e-8)
    density = []
    for t, x in zip(times, motion):
        state, push = best.at(t)
        np.testing.assert_allclose(state, x, atol=1e-8)
        density.append(state @ weight @ state + push @ N @ push)
    assert best.cost == pytest.approx(duration / 2 * quadrature @ density, rel=1e-9)


def test_no_other_control_between_the_ends_costs_less():
    """Among piecewise constant controls, a quadratic program, the least cost tends to ours."""
    duration, costs = 2.0, []
    for count in (50, 100):
        h = duration / count
        model = control.sample_system(control.ss(A, B, np.eye(3), 0), h)
        # The cost of one step is a quadratic form of its first state and its control.
        joint = scipy.linalg.block_diag(G, N)
        augmented = np.block([[A, B], [np.zeros((2, 5))]])
        form, _ = scipy.integrate.quad_vec(
            lambda s, a=augmented: scipy.linalg.expm(a * s).T @ joint @ scipy.linalg.expm(a * s),
            0,
            h,
        )
        maps, free = [np.zeros((3, 2 * count))], [START]
        for k in range(count):
            following = model.A @ maps[-1]
            following[:, 2 * k : 2 * k + 2] += model.B
            maps.append(following)
            free.append(model.A @ free[-1])
        hessian, linear, constant = np.zeros((2 * count, 2 * count)), np.zeros(2 * count), 0.0
        for k in range(count):
            row = np.vstack([maps[k], np.eye(2, 2 * count, 2 * k)])
            offset = np.append(free[k], [0, 0])
            hessian += row.T @ form @ row
            linear += row.T @ form @ offset
            constant += offset @ form @ offset
        system = np.block([[hessian, maps[-1].T], [maps[-1], np.zeros((3, 3))]])
        u = np.linalg.solve(system, np.append(-linear, END - free[-1]))[: 2 * count]
        costs.append(u @ hessian @ u + 2 * linear @ u + constant)
    best = feedback.fixed_ends_lqr(A, B, G, N, START, END, duration).cost
    assert best < costs[1] < costs[0]
    assert (4 * costs[1] - costs[0]) / 3 == pytest.approx(best, rel=1e-5)


def test_gramian_and_exact_solution():
    energy = feedback.fixed_ends_lqr(A, B, 0 * G, np.eye(2), 0 * START, END, 1.7)
    gramian = structure.controllability_gramian(A, B, 1.7)
    np.testing.assert_allclose(energy.gramian, getattr(gramian, "matrix", gramian), rtol=1e-10)
    assert energy.cost == pytest.approx(END @ np.linalg.solve(energy.gramian, END), rel=1e-10)
    exact = feedback.fixed_ends_lqr(0, 1, 1, 1, 1, 2, 3)  # x'' = x, the cost by parts
    near = feedback.fixed_ends_lqr(0.0, 1, 1, 1, 1, 2, 3)
    t = sp.Symbol("t")
    x = exact.at(t).state[0]
    assert sp.simplify(x.diff(t, 2) - x) == 0
    assert (x.subs(t, 0), sp.simplify(x.subs(t, 3))) == (1, 2)
    assert float(exact.cost) == pytest.approx(near.cost, rel=1e-12)
    assert float(x.subs(t, 1)) == pytest.approx(near.at(1).state[0], rel=1e-12)
    assert float(exact.gramian[0]) == pytest.approx(near.gramian[0, 0], rel=1e-12)


def test_long_durations_lose_no_digits():
    """Far from the ends the motion rests at zero; each end has its own infinite horizon."""
    best = feedback.fixed_ends_lqr(A, B, np.eye(3), N, START, END, 1e4)
    forwards = feedback.lqr(A, B, np.eye(3), N).cost
    backwards = feedback.lqr(-A, -B, np.eye(3), N).cost
    assert best.cost == pytest.approx(START @ forwards @ START + END @ backwards @ END, rel=1e-10)
    np.testing.assert_allclose(best.at(0).state, START, atol=1e-12)
    np.testing.assert_allclose(best.at(10_000).state, END, atol=1e-10)
    assert np.abs(best.at(5000).state).max() < 1e-12


def test_fixed_ends_say_why_not():
    refused = feedback.fixed_ends_lqr([[1, 0], [0, 2]], [1, 0], sp.eye(2), 1, [0, 0], [1, 1], 1)
    assert not refused and "not every end can be reached" in refused.reason
    with pytest.raises(ValueError, match="not every end"):
        refused.at(0)
    with pytest.raises(ValueError, match="duration: expected a positive time"):
        feedback.fixed_ends_lqr(A, B, G, N, START, END, 0)
    with pytest.raises(ValueError, match="t: expected a time from 0 to 2"):
        feedback.fixed_ends_lqr(A, B, G, N, START, END, 2).at(2.5)
    with pytest.raises(ValueError, match="end: expected 3 components"):
        feedback.fixed_ends_lqr(A, B, G, N, START, [1, 2], 2)


CROSS = np.array([[0.3, 0.0], [0.1, -0.2], [0.0, 0.2]])
WEIGHT = np.diag([2.0, 1, 1])


def test_cross_terms_are_those_of_python_control():
    ours = feedback.lqr(A, B, WEIGHT, N, cross=CROSS)
    gain, cost, _ = control.lqr(A, B, WEIGHT, N, CROSS, method="scipy")
    np.testing.assert_allclose(ours.gain, -gain, atol=1e-12)
    np.testing.assert_allclose(ours.cost, cost, atol=1e-12)
    np.testing.assert_allclose(ours.loop, A + B @ ours.gain, atol=1e-12)
    steps = control.ss(A / 3, B, np.eye(3), 0, 0.1)
    ours = feedback.discrete_lqr(steps, Q=WEIGHT, R=N, cross=CROSS)
    gain, cost, _ = control.dlqr(A / 3, B, WEIGHT, N, CROSS, method="scipy")
    np.testing.assert_allclose(ours.gain, -gain, atol=1e-12)
    np.testing.assert_allclose(ours.cost, cost, atol=1e-12)


def test_cross_terms_of_finite_horizons():
    """The laws of long horizons tend to those without end, and S obeys its own equation."""
    end = np.eye(3)
    long = feedback.finite_lqr(A, B, WEIGHT, N, end, 60.0, cross=CROSS)
    forever = feedback.lqr(A, B, WEIGHT, N, cross=CROSS)
    np.testing.assert_allclose(long.gain, forever.gain, atol=1e-10)
    h = 1e-4
    S, later, sooner = (
        feedback.finite_lqr(A, B, WEIGHT, N, end, 0.8 + d, cross=CROSS).cost for d in (0, h, -h)
    )
    K = -np.linalg.solve(N, B.T @ S + CROSS.T)
    right = A.T @ S + S @ A + WEIGHT - K.T @ N @ K
    np.testing.assert_allclose((later - sooner) / (2 * h), right, atol=1e-6)
    laws = feedback.discrete_finite_lqr(A / 3, B, WEIGHT, N, end, 5, cross=CROSS)
    S = end
    for law in reversed(laws):
        form = np.block([[WEIGHT, CROSS], [CROSS.T, N]])
        both = np.hstack([A / 3, B])
        form = form + both.T @ S @ both
        K = -np.linalg.solve(form[3:, 3:], form[3:, :3])
        S = form[:3, :3] + form[:3, 3:] @ K
        np.testing.assert_allclose(law.gain, K, atol=1e-12)
        np.testing.assert_allclose(law.cost, S, atol=1e-12)


def test_cross_terms_are_exact_where_the_rest_is():
    law = feedback.lqr(0, 1, 2, 1, cross=1)  # (x + u)^2 + x^2
    assert (law.cost[0], law.gain[0]) == (sp.sqrt(2) - 1, -sp.sqrt(2))
    with pytest.raises(ValueError, match="cross: expected a matrix 3 x 2"):
        feedback.lqr(A, B, WEIGHT, N, cross=np.ones((2, 3)))


@pytest.mark.parametrize("seed", range(6))
def test_indefinite_cost_has_a_law_or_a_frequency_that_proves_there_is_none(seed):
    rng = np.random.default_rng(seed)
    a, b = rng.normal(size=(4, 4)), rng.normal(size=(4, 2))
    weight = rng.normal(size=(4, 4))
    weight, n = weight + weight.T, np.eye(2) * 10.0 ** (seed % 3)
    law = feedback.lqr(a, b, weight, n)
    response = [
        np.linalg.solve(1j * w * np.eye(4) - a, b)
        for w in np.concatenate([[0], np.geomspace(1e-3, 1e3, 4000)])
    ]
    least = min(np.linalg.eigvalsh(n + r.conj().T @ weight @ r)[0] for r in response)
    assert bool(law) == (least > 0)
    if not law:
        w = float(law.reason.split("frequency ")[1].split()[0])
        r = np.linalg.solve(1j * w * np.eye(4) - a, b)
        assert np.linalg.eigvalsh(n + r.conj().T @ weight @ r)[0] < 0
        return
    assert np.linalg.eigvals(a + b @ law.gain).real.max() < 0
    S = law.cost
    left = a.T @ S + S @ a + weight - S @ b @ np.linalg.solve(n, b.T @ S)
    assert np.abs(left).max() < 1e-9 * np.abs(S).max() * np.abs(a).max()
    for _ in range(10):  # other stabilising laws cost more, from every state
        gain = law.gain + 0.02 * rng.normal(size=(2, 4))
        loop = a + b @ gain
        if np.linalg.eigvals(loop).real.max() < 0:
            other = scipy.linalg.solve_continuous_lyapunov(loop.T, -(weight + gain.T @ n @ gain))
            assert np.linalg.eigvalsh(other - S)[0] > -1e-9 * np.abs(S).max()


def test_verdicts_of_exact_indefinite_costs():
    q = sp.Symbol("q", positive=True)
    assert feedback.lqr(-1, 1, -sp.Rational(3, 4), 1).gain[0] == sp.Rational(1, 2)
    assert "frequency 0 " in feedback.lqr(-1, 1, -2, 1).reason
    assert "approached, by no law" in feedback.lqr(-1, 1, -1, 1).reason
    assert "not stabilisable" in feedback.lqr(sp.diag(1, -1), [0, 1], -sp.eye(2), 1).reason
    law = feedback.lqr(-1, 1, -q, 1)
    assert law and law.where.subs(q, sp.Rational(1, 2)) and not law.where.subs(q, 2)
    # With a cross term the whole form counts: (x - u)^2 - x^2.
    assert feedback.lqr(1, 1, 0, 1, cross=-1).cost[0] == 2 + sp.sqrt(3)
    with pytest.raises(ValueError, match="stable: "):
        feedback.lqr(-1, 1, -2, 1, stable=False)


@pytest.mark.parametrize("seed", range(8))
def test_indefinite_discrete_cost_has_a_law_or_a_frequency(seed):
    rng = np.random.default_rng(seed)
    a, b = rng.normal(size=(4, 4)) / 2, rng.normal(size=(4, 2))
    weight = rng.normal(size=(4, 4))
    weight, n = weight + weight.T, np.eye(2) * 10.0 ** (seed % 4)
    law = feedback.discrete_lqr(a, b, weight, n)

    def popov(w):
        r = np.linalg.solve(np.exp(1j * w) * np.eye(4) - a, b)
        return np.linalg.eigvalsh(n + r.conj().T @ weight @ r)[0]

    assert bool(law) == (min(map(popov, np.linspace(0, np.pi, 2001))) > 0)
    if not law:
        assert popov(float(law.reason.split("frequency ")[1].split()[0])) < 0
        return
    assert np.abs(np.linalg.eigvals(a + b @ law.gain)).max() < 1
    for _ in range(10):  # other stabilising laws cost more, from every state
        gain = law.gain + 0.02 * rng.normal(size=(2, 4))
        loop = a + b @ gain
        if np.abs(np.linalg.eigvals(loop)).max() < 1:
            other = scipy.linalg.solve_discrete_lyapunov(loop.T, weight + gain.T @ n @ gain)
            assert np.linalg.eigvalsh(other - law.cost)[0] > -1e-9 * np.abs(law.cost).max()


def test_verdicts_of_exact_indefinite_discrete_costs():
    half, q = sp.Rational(1, 2), sp.Symbol("q", positive=True)
    assert feedback.discrete_lqr(half, 1, -half / 3, 1).gain[0] == half / 3
    assert "frequency 0 " in feedback.discrete_lqr(half, 1, -half, 1).reason
    assert "frequency 3.14159 " in feedback.discrete_lqr(-half, 1, -half, 1).reason
    assert "approached, by no law" in feedback.discrete_lqr(half, 1, -half / 2, 1).reason
    assert (
        "not stabilisable" in feedback.discrete_lqr(sp.diag(2, half), [0, 1], -sp.eye(2), 1).reason
    )
    # For q > 9/4 the equation has a stabilising solution with 1 + S < 0: no law either.
    law = feedback.discrete_lqr(half, 1, -q, 1)
    values = [law.where.subs(q, value) for value in (sp.Rational(1, 5), sp.Rational(1, 3), 3)]
    assert values == [True, False, False]
    assert not feedback.discrete_lqr(half, 1, -3, 1) and not feedback.discrete_lqr(0.5, 1, -3, 1)


@pytest.mark.parametrize("seed", range(12))
def test_indefinite_cost_up_to_a_final_time(seed):
    """The escape of S is a zero of det X for the linear flow of (X, S X), followed in small steps."""
    rng = np.random.default_rng(seed)
    n = 1 + seed % 4
    a, b = rng.normal(size=(n, n)), rng.normal(size=(n, 1 + seed % 2))
    weight, last = rng.normal(size=(2, n, n)) * rng.uniform(0, 1, size=(2, 1, 1))
    weight, last, final = weight + weight.T, last + last.T, rng.uniform(0.3, 4)
    law = feedback.finite_lqr(a, b, weight, np.eye(b.shape[1]), last, final)
    step = scipy.linalg.expm(-np.block([[a, -b @ b.T], [-weight, -a.T]]) * final / 2000)
    frame, escape = np.vstack([np.eye(n), last]), None
    for k in range(2000):
        frame = step @ frame
        if np.linalg.det(frame[:n]) <= 0:
            escape = final * (k + 0.5) / 2000
            break
        frame = frame @ np.linalg.inv(frame[:n]) if k % 20 == 19 else frame
    assert bool(law) == (escape is None)
    if law:
        assert law.cost == pytest.approx(frame[n:] @ np.linalg.inv(frame[:n]), rel=1e-7, abs=1e-9)
    else:
        assert float(law.reason.split()[-1]) == pytest.approx(escape, abs=final / 1000)


@pytest.mark.parametrize("forever", [np.inf, sp.oo])
def test_an_infinite_time_to_go_is_refused_with_the_function_for_it(forever):
    for one in (1, 1.0):
        with pytest.raises(ValueError, match="time_to_go: expected a finite time, got oo; lqr"):
            feedback.finite_lqr(one, 1, 1, 1, 0, forever)


@pytest.mark.parametrize("beyond, verdict", [(-1e-8, "law"), (1e-8, "escapes to infinity")])
def test_an_escape_near_the_final_time(beyond, verdict):
    """S = -tan(T - t) for x' = u and the cost u^2 - x^2: at pi/2 floats do not decide."""
    escape = np.pi / 2
    assert verdict in feedback.finite_lqr(0.0, 1, -1, 1, 0, escape * (1 + beyond)).reason
    with pytest.raises(np.linalg.LinAlgError, match="floats do not tell"):
        feedback.finite_lqr(0.0, 1, -1, 1, 0, escape * (1 + beyond / 20))


@pytest.mark.parametrize("frequency", [-0.7, 0.3, 2.5])
def test_a_rational_point_of_the_circle_has_the_frequency(frequency):
    point = _exact_point(frequency, True)
    assert sp.expand(point * sp.conjugate(point)) == 1
    assert np.angle(complex(point)) == pytest.approx(frequency, rel=1e-15)


def test_exact_indefinite_cost_up_to_a_final_time():
    """J = int (u^2 - x^2) dt, S = -tan(T - t); and two oscillators with escapes at pi/2 and pi."""
    assert feedback.finite_lqr(0, 1, -1, 1, 0, 1).cost[0].equals(-sp.tan(1))
    assert "time to go 1.5708" in feedback.finite_lqr(0, 1, -1, 1, 0, 2).reason
    with pytest.raises(np.linalg.LinAlgError, match="not found"):
        feedback.finite_lqr(0, 1, -1, 1, 0, sp.pi / 2)
    with pytest.raises(NotImplementedError, match="numbers"):
        feedback.finite_lqr(0, 1, -1, 1, 0, sp.Symbol("left", positive=True))
    two = np.zeros((2, 2)), np.eye(2), np.diag([-1.0, -0.25]), np.eye(2)
    assert "1.5708" in feedback.finite_lqr(*two, np.zeros((2, 2)), 10).reason
    # With the weight tan(1) at the end S = -tan(s - 1); with one above 1 there is no escape for G = 1.
    assert (
        feedback.finite_lqr(0, 1, -1.0, 1, np.tan(1), 2.5)
        and "2.5708" in feedback.finite_lqr(0, 1, -1.0, 1, np.tan(1), 3).reason
    )
    assert feedback.finite_lqr(0, 1, 1.0, 1, -0.9, 100)
    assert "1.47222" in feedback.finite_lqr(0, 1, 1.0, 1, -1 / np.tanh(1.47222), 100).reason
    # A great weight at the end is no escape: S tends to that of the fixed end, cot(s).
    assert feedback.finite_lqr(0, 1, -1.0, 1, 1e14, 1.0).cost[0, 0] == pytest.approx(1 / np.tan(1))
    assert "3.14159" in feedback.finite_lqr(0, 1, -1.0, 1, 1e14, 4.0).reason
    # In units in which the position is 1e6 times as great the verdict is the same.
    a, units = np.array([[0, 1.0], [0, 0]]), np.array([1e6, 1])
    for G in (np.diag([-1.0, 0]), np.diag([-0.01, 0])):
        plain = feedback.finite_lqr(a, [[0], [1.0]], G, 1, np.zeros((2, 2)), 3)
        scaled = feedback.finite_lqr(
            a * units[:, None] / units,
            [[0], [1.0]],
            G / np.outer(units, units),
            1,
            np.zeros((2, 2)),
            3,
        )
        assert plain.reason == scaled.reason


@pytest.mark.parametrize("exact", [True, False])
def test_indefinite_cost_of_some_steps(exact):
    """The quadratic form of all controls decides: it is positive definite, or not."""
    A, B = sp.Matrix([[1, 1], [0, 1]]), sp.Matrix([0, 1])
    G, N, F = sp.diag(-1, 0), sp.Matrix([[4]]), sp.diag(0, -1)
    given = A, B, G, N, F
    laws = feedback.discrete_finite_lqr(
        *(given if exact else (np.array(M, dtype=float) for M in given)), 6
    )
    for k, law in enumerate(laws):
        steps = 6 - k
        blocks = [sp.zeros(2, steps)]
        for i in range(steps):
            blocks.append(A * blocks[-1] + B * sp.eye(steps)[i, :])
        form = 4 * sp.eye(steps) + blocks[-1].T * F * blocks[-1]
        form += sum((x.T * G * x for x in blocks[:-1]), sp.zeros(steps))
        assert bool(law) == bool(form.is_positive_definite)
    assert any(laws) and not all(laws)
    first = 6 - max(k for k, law in enumerate(laws) if not law)
    assert f"with {first} steps to go the cost has no lower bound" in laws[0].reason
    assert "no single law" in feedback.discrete_finite_lqr(1, 1, 0, 1, -1, 1)[0].reason
    with pytest.raises(np.linalg.LinAlgError, match="not found"):
        feedback.discrete_finite_lqr(1.0, 1, 0, 1, -1, 1)
