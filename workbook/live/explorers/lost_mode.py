"""A mode that is lost to the control, or to the measurement, and comes back, while a parameter
moves."""

import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.explorers.stage import Explorer, Stage, slider
from workbook.live.worked import Worked

HORIZON, REACH = 3.0, 3.0


def losing_a_mode():
    """Problem 2.27, x' = Ax + B(beta)u, z = H(alpha)x: what control reaches, what measurement
    tells, the zero beside the poles.

    Left: the states that a control of energy 1 reaches from rest in 3 units of time, an ellipse
    that collapses when a mode cannot be controlled. Middle: the start is known up to this ellipse
    if the output is known up to an error of energy 0.01; it grows beyond all bounds when a mode is
    not seen. Right: where the zero of the transfer function meets a pole, the mode is lost.
    """
    data = Worked("2.27").data
    A, alpha, beta = data["A"], data["alpha"], data["beta"]
    control = sp.lambdify([beta], data["B"], "numpy")
    output = sp.lambdify([alpha], data["H"], "numpy")
    matrix = np.array(A, dtype=float)
    poles, vectors = np.linalg.eig(matrix)
    rows = np.linalg.inv(vectors)
    numerator = _numerator(data)

    stage = Stage(3, height=4.4)
    reached, known, complex_plane = stage.axes
    for axes, title in ((reached, "reached with energy 1"), (known, "what $z$ leaves open")):
        axes.set(
            xlim=(-REACH, REACH),
            ylim=(-REACH, REACH),
            aspect="equal",
            xlabel="$x_1$",
            ylabel="$x_2$",
            title=title,
        )
        for column, style in zip(vectors.T, ("--", ":")):
            axes.plot(*np.outer(column, [-9, 9]), style, color=plotting.GREY, linewidth=1.2)
    complex_plane.set(
        xlim=(-4.5, 1.5), ylim=(-2, 2), xlabel="Re $s$", title="poles and zero of $z/u$"
    )
    complex_plane.axvline(0, color=plotting.GREY, linewidth=0.8)
    complex_plane.axhline(0, color=plotting.GREY, linewidth=0.8)
    complex_plane.plot(poles, 0 * poles, "x", color=plotting.BLUE, markersize=14, markeredgewidth=3)
    zero = stage.line(
        complex_plane,
        "o",
        markerfacecolor="none",
        markeredgecolor=plotting.RED,
        markersize=15,
        markeredgewidth=3,
    )
    reach = stage.line(reached, "-", color=plotting.BLUE, linewidth=2.6)
    open_ = stage.line(known, "-", color=plotting.RED, linewidth=2.6)

    def draw(**values):
        B = np.array(control(values[beta.name]), dtype=float)
        H = np.array(output(values[alpha.name]), dtype=float)
        reach.set_data(*_ellipse(_gramian(matrix, B)))
        open_.set_data(
            *_ellipse(0.01 * np.linalg.pinv(_gramian(matrix.T, H.T) + 1e-12 * np.eye(2)))
        )
        leading, rest = numerator(values[alpha.name], values[beta.name])
        zero.set_data(
            [-rest / leading] if abs(leading) > 1e-9 else [], [0] if abs(leading) > 1e-9 else []
        )
        held, seen = np.abs(rows @ B).ravel(), np.abs(H @ vectors).ravel()
        return "; ".join(
            f"mode {pole:g}: control has {_hold(a)}, measurement {_hold(b)}"
            for pole, a, b in sorted(zip(poles, held, seen), reverse=True)
        )

    controls = {
        alpha.name: slider(alpha.name, -3, 3, 0.5),
        beta.name: slider(beta.name, -3, 3, 2.0),
    }
    return Explorer(stage, controls, draw, words="problem 2.27: B = (1, beta), H = (1, alpha)")


def _hold(strength):
    return "no hold of it" if strength < 1e-9 else f"a hold of {strength:.2f}"


def _numerator(data):
    """The coefficients of the numerator of z/u, which is linear in s, as functions of alpha and
    beta."""
    s = sp.Symbol("s")
    A = data["A"]
    numerator = sp.Poly(sp.expand((data["H"] * (s * sp.eye(2) - A).adjugate() * data["B"])[0]), s)
    return sp.lambdify(
        [data["alpha"], data["beta"]], [numerator.coeff_monomial(s), numerator.coeff_monomial(1)]
    )


def _gramian(A, B):
    """The integral of exp(At) B B^T exp(A^T t) over the horizon, by Van Loan's exponential of a
    block matrix."""
    from scipy.linalg import expm

    n = len(A)
    blocks = expm(HORIZON * np.block([[-A, B @ B.T], [np.zeros((n, n)), A.T]]))
    return blocks[n:, n:].T @ blocks[:n, n:]


def _ellipse(W):
    """The points x with x^T W^-1 x = 1."""
    turn = np.linspace(0, 2 * np.pi, 121)
    values, vectors = np.linalg.eigh((W + W.T) / 2)
    return vectors @ (
        np.sqrt(np.maximum(values, 0))[:, None] * np.array([np.cos(turn), np.sin(turn)])
    )
