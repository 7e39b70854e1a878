"""Margins of loops against closed forms, the roots of the closed loop and a fine grid of frequencies."""

import control
import numpy as np
import pytest
import sympy as sp

from trajlib import feedback
from trajlib.feedback import loop_function, loop_margins

s = sp.Symbol("s")
# Doyle's plant with an optimal regulator and an optimal filter
DOYLE = sp.Matrix([[1, 1], [0, 1]]), sp.Matrix([0, 1]), sp.Matrix([[1, 0]])


def doyle(q):
    """The loop for the weights q and the intensities q, with both gains from the Riccati equations."""
    A, B, H = DOYLE
    K = feedback.lqr(A, B, q * sp.ones(2), 1).gain
    L = -feedback.lqr(A.T, H.T, q * sp.ones(2), 1).gain.T
    return loop_function(A, B, K, H, L), K, L


def test_doyle_has_margins_as_small_as_one_likes():
    loop, K, L = doyle(60)
    assert (K, L) == (sp.Matrix([[-10, -10]]), sp.Matrix([10, 10]))
    margins = loop_margins(loop)
    assert margins.gain == ((97 - 8 * sp.sqrt(85)) / 25, sp.Rational(101, 100))
    assert (margins.disk, margins.disk_frequency) == (sp.Rational(1, 101), 0)
    assert float(sp.deg(margins.phase)) == pytest.approx(0.9227, abs=1e-4)
    state = loop_margins(loop_function(*DOYLE[:2], K))
    assert state.gain == (sp.Rational(1, 5), sp.oo)


def test_the_regulator_keeps_half_to_infinity_and_sixty_degrees():
    for A, B, G in (
        (sp.Matrix([[0, 1], [0, 0]]), sp.Matrix([0, 1]), sp.diag(1, 0)),
        (sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([0, 1]), sp.eye(2)),
        (sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([0, 1]), sp.zeros(2)),
    ):
        margins = loop_margins(loop_function(A, B, feedback.lqr(A, B, G, 1).gain))
        assert float(margins.gain[0]) <= 0.5 and margins.gain[1] == sp.oo
        assert float(margins.phase) >= np.pi / 3 - 1e-12
        assert margins.disk == 1
    assert margins.gain[0] == sp.Rational(1, 2)  # attained without a weight on the state


def test_the_carriage_with_a_delay():
    A, B = sp.Matrix([[0, 1], [0, 0]]), sp.Matrix([0, 1])
    margins = loop_margins(loop_function(A, B, sp.Matrix([[-1, -sp.sqrt(2)]])))
    assert sp.simplify(margins.phase_frequency**2 - 1 - sp.sqrt(2)) == 0
    assert sp.N(margins.phase - sp.atan(sp.sqrt(2 + 2 * sp.sqrt(2))), 20) == pytest.approx(0)
    assert float(margins.delay) == pytest.approx(0.7361, abs=5e-5)


def stable_loops(count, seed):
    """Random systems of floats whose closed loop 1/(1 + L) is stable."""
    random = np.random.default_rng(seed)
    while count:
        n = int(random.integers(1, 6))
        A, B, C = random.normal(size=(n, n)), random.normal(size=(n, 1)), random.normal(size=(1, n))
        D = random.choice([0.0, 0.0, 0.4])
        closed = A - B @ C / (1 + D)
        if np.linalg.eigvals(closed).real.max() < -0.02:
            count -= 1
            yield A, B, C, D


@pytest.mark.parametrize("A, B, C, D", [*stable_loops(12, seed=7)])
def test_random_loops(A, B, C, D):
    margins = loop_margins(control.ss(A, B, C, D))

    def stable(factor):
        return np.linalg.eigvals(A - factor * B @ C / (1 + factor * D)).real.max() < 0

    low, high = margins.gain
    assert low < 1 < high
    for factor in np.linspace(low + 1e-6, min(high, 50) - 1e-6, 25):
        assert stable(factor)
    assert low == 0 or not stable(low - 1e-6 * max(1, low))
    assert high == np.inf or not stable(high + 1e-6 * high)

    omega = np.concatenate([[0], np.geomspace(1e-4, 1e4, 40001)])
    value = np.array(
        [(C @ np.linalg.solve(1j * w * np.eye(len(A)) - A, B))[0, 0] + D for w in omega]
    )
    distance = abs(1 + value)
    assert distance.min() == pytest.approx(margins.disk, rel=1e-5)
    assert margins.disk <= distance.min() * (1 + 1e-12)
    turned = abs(np.angle(-value))[:-1][np.diff(np.sign(abs(value) - 1)) != 0]
    assert margins.phase == pytest.approx(turned.min(initial=np.inf), abs=1e-2)
    assert margins.guaranteed_phase <= margins.phase + 1e-12
    if np.isfinite(margins.delay) and margins.delay > 0:
        w = margins.delay_frequency
        at = (C @ np.linalg.solve(1j * w * np.eye(len(A)) - A, B))[0, 0] + D
        assert 1 + at * np.exp(-1j * w * margins.delay) == pytest.approx(0, abs=1e-8)


@pytest.mark.parametrize("A, B, C, D", [*stable_loops(12, seed=11)])
def test_python_control_finds_the_same(A, B, C, D):
    loop = control.ss(A, B, C, D)
    margins = loop_margins(loop)
    factors, degrees, distance, _, phase_frequencies, disk_frequencies = control.stability_margins(
        loop, returnall=True
    )
    # it gives no factor for the limit of high frequencies
    limit = [-1 / D] if D else []
    assert margins.gain[1] == pytest.approx(
        min([f for f in [*factors, *limit] if f > 1] + [np.inf])
    )
    assert margins.gain[0] == pytest.approx(max([f for f in [*factors, *limit] if 0 < f < 1] + [0]))
    assert margins.phase == pytest.approx(min(np.radians(abs(degrees)), default=np.inf))
    delays = np.radians(degrees % 360) / phase_frequencies
    assert margins.delay == pytest.approx(min(delays, default=np.inf))
    # it leaves out the ends of the axis
    ends = [abs(1 + D), abs(1 + D - (C @ np.linalg.solve(A, B)).item())]
    assert margins.disk == pytest.approx(min([*distance, *ends]), rel=1e-6)
    omega = np.concatenate([[1e-9], np.geomspace(1e-3, 1e3, 4001), disk_frequencies, [1e9]])
    assert margins.disk == pytest.approx(control.disk_margins(loop, omega, skew=1.0)[0], rel=1e-6)
    assert 0 < margins.error < 1e-9


def test_matrices_of_floats_give_a_system_with_the_same_margins():
    _, K, L = doyle(60)
    floats = [np.array(matrix, dtype=float) for matrix in (*DOYLE, K, L)]
    A, B, H, K_floats, L_floats = floats
    exact, found = (
        loop_margins(loop_function(*arguments))
        for arguments in ((*DOYLE[:2], K, DOYLE[2], L), (A, B, K_floats, H, L_floats))
    )
    from_system = loop_margins(loop_function(control.ss(A, B, H, 0), K_floats, H, [10.0, 10.0]))
    for name in ("gain", "phase", "delay", "disk"):
        true = np.array(getattr(exact, name), dtype=float)
        # the matrices are whole numbers, so that only the result is rounded
        assert getattr(found, name) == pytest.approx(true, rel=1e-14)
        assert getattr(from_system, name) == getattr(found, name)
    assert exact.error == 0 < found.error < 1e-12
    mixed = loop_function(np.array([[1, 1], [0, 1]]), [0, 1], [[-10.0, -10.0]])
    assert loop_margins(mixed).gain == (pytest.approx(0.2), np.inf)


def test_the_error_of_a_loop_close_to_instability():
    # 1 + L has the root -1e-9: the distance from -1 is lost to nine digits
    found = loop_margins(control.tf([-1 + 1e-9], [1, 1]))
    assert found.disk == pytest.approx(1e-9, rel=1e-6)
    assert 1e-8 < found.error < 1e-6


@pytest.mark.parametrize("zeros", [s**4 + 3 * s**2 + 1, s**2 + sp.sqrt(5)])
def test_a_zero_on_the_axis_bounds_no_factor(zeros):
    # there the curve passes through 0, which no factor moves
    loop = zeros / (s + 1) ** sp.degree(zeros, s)
    assert loop_margins(loop).gain == (0, sp.oo)
    assert loop_margins(
        control.tf(
            *([float(c) for c in sp.Poly(part, s).all_coeffs()] for part in sp.fraction(loop))
        )
    ).gain == (0, np.inf)


def test_margins_show_themselves():
    shown = loop_margins(1 / (s * (s + 1) * (s + 2)))._repr_markdown_()
    assert (
        "| gain | $0$ to $6$ | |" in shown
        and r"| phase | $\approx 0.932194$ | $\approx 0.445748$ |" in shown
    )
    assert loop_margins(1 / (s + 1))._repr_markdown_().count(r"$\infty$") == 4


def test_what_the_disk_guarantees():
    """|1 + L| >= 1 for an optimal regulator: its gain may be halved or grow, its phase lag by pi/3."""
    A, B = sp.Matrix([[0, 1], [0, 0]]), sp.Matrix([0, 1])
    optimal = loop_margins(loop_function(A, B, feedback.lqr(A, B, sp.eye(2), 1).gain))
    assert (optimal.disk, optimal.guaranteed_gain) == (1, (sp.Rational(1, 2), sp.oo))
    assert optimal.guaranteed_phase == sp.pi / 3
    third = loop_margins(4 / (s + 1) ** 3)
    assert third.disk == sp.Rational(1, 3)
    assert third.guaranteed_gain == (sp.Rational(3, 4), sp.Rational(3, 2))
    assert third.guaranteed_phase == 2 * sp.asin(sp.Rational(1, 6))


@pytest.mark.parametrize(
    "loop, message",
    [
        (1 / (s - 3), "asymptotically stable"),
        (sp.Symbol("k") / (s + 1), "one symbol"),
        (sp.Integer(2), "one symbol"),
        (s**2 / (s + 1), "more zeros than poles"),
        (sp.exp(-s) / (s + 1), "rational function"),
        ((2 - s) / (2 + s), "asymptotically stable"),
        (control.ss([[0.5]], [[1]], [[1]], 0, True), "continuous time"),
        (control.ss(-np.eye(2), np.eye(2), np.eye(2), 0), "one input and one output"),
    ],
)
def test_loops_without_margins(loop, message):
    with pytest.raises(ValueError, match=message) as error:
        loop_margins(loop)
    assert str(error.value).startswith("loop: ")


@pytest.mark.parametrize(
    "arguments, message",
    [
        ((sp.eye(2), sp.eye(2), [[-1, -1]]), "B: expected one control"),
        ((sp.eye(2), [0, 1], [[-1]]), "K: expected a matrix 1 x 2"),
        ((sp.eye(2), [0, 1], [[-1, -1]], [[1, 0]]), "L: expected with an observer"),
    ],
)
def test_arguments_of_the_loop_function(arguments, message):
    with pytest.raises(ValueError, match=message):
        loop_function(*arguments)


def test_the_picture_has_the_disk_and_the_point():
    from matplotlib import pyplot as plt

    ax = loop_margins(1 / (s * (s + 1) * (s + 2))).plot()
    assert [line.get_label() for line in ax.lines][-1] == "$-1$"
    assert ax.patches
    plt.close(ax.figure)
    # outside the unit circle at high frequencies: the delay margin 0 belongs to an infinite one
    ax = loop_margins((2 * s + 1) / (s + 3)).plot()
    assert np.isfinite(ax.lines[0].get_xydata()).all()
    plt.close(ax.figure)
