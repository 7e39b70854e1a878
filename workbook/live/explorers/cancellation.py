"""Loss of controllability or observability of a mode as a pole-zero cancellation."""

import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.explorers.blitting import BlittedFigure
from workbook.live.explorers.explorer import Explorer, slider
from workbook.live.worked_problem import WorkedProblem

HORIZON, REACH = 3.0, 3.0


def pole_zero_cancellation():
    """Show when the modes of problem 2.27, x' = Ax + B(beta)u, z = H(alpha)x, are cancelled.

    Left: the states that a control of energy 1 reaches from rest in 3 units of time, an ellipse
    that collapses when a mode is uncontrollable. Middle: the uncertainty of the initial state if
    the output has an error of energy 0.01, an ellipse that is unbounded when a mode is
    unobservable. Right: where the zero of the transfer function meets a pole, the mode is
    uncontrollable or unobservable.
    """
    data = WorkedProblem("2.27").data
    A, alpha, beta = data["A"], data["alpha"], data["beta"]
    control = sp.lambdify([beta], data["B"], "numpy")
    output = sp.lambdify([alpha], data["H"], "numpy")
    matrix = np.array(A, dtype=float)
    poles, vectors = np.linalg.eig(matrix)
    left_vectors = np.linalg.inv(vectors)
    numerator = _numerator(data)

    figure = BlittedFigure(3, height=4.4)
    reachable, uncertainty, complex_plane = figure.axes
    for axes, title in (
        (reachable, "reached with energy 1"),
        (uncertainty, "what $z$ leaves open"),
    ):
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
    zero = figure.line(
        complex_plane,
        "o",
        markerfacecolor="none",
        markeredgecolor=plotting.RED,
        markersize=15,
        markeredgewidth=3,
    )
    reachable_line = figure.line(reachable, "-", color=plotting.BLUE, linewidth=2.6)
    uncertainty_line = figure.line(uncertainty, "-", color=plotting.RED, linewidth=2.6)

    def draw(**values):
        B = np.array(control(values[beta.name]), dtype=float)
        H = np.array(output(values[alpha.name]), dtype=float)
        reachable_line.set_data(*_ellipse(_gramian(matrix, B)))
        uncertainty_line.set_data(
            *_ellipse(0.01 * np.linalg.pinv(_gramian(matrix.T, H.T) + 1e-12 * np.eye(2)))
        )
        leading, constant = numerator(values[alpha.name], values[beta.name])
        zero.set_data(
            [-constant / leading] if abs(leading) > 1e-9 else [], [0] if abs(leading) > 1e-9 else []
        )
        by_control, by_output = np.abs(left_vectors @ B).ravel(), np.abs(H @ vectors).ravel()
        return "; ".join(
            f"mode {pole:g}: control has {_strength(a)}, measurement {_strength(b)}"
            for pole, a, b in sorted(zip(poles, by_control, by_output), reverse=True)
        )

    controls = {
        alpha.name: slider(alpha.name, -3, 3, 0.5),
        beta.name: slider(beta.name, -3, 3, 2.0),
    }
    return Explorer(figure, controls, draw, title="problem 2.27: B = (1, beta), H = (1, alpha)")


def _strength(value):
    return "no hold of it" if value < 1e-9 else f"a hold of {value:.2f}"


def _numerator(data):
    """Return the coefficients of the numerator of z/u, linear in s, for alpha and beta."""
    s = sp.Symbol("s")
    A = data["A"]
    numerator = sp.Poly(sp.expand((data["H"] * (s * sp.eye(2) - A).adjugate() * data["B"])[0]), s)
    return sp.lambdify(
        [data["alpha"], data["beta"]], [numerator.coeff_monomial(s), numerator.coeff_monomial(1)]
    )


def _gramian(A, B):
    """Return the integral of exp(At) B B^T exp(A^T t) over the horizon, by Van Loan's method."""
    from scipy.linalg import expm

    n = len(A)
    blocks = expm(HORIZON * np.block([[-A, B @ B.T], [np.zeros((n, n)), A.T]]))
    return blocks[n:, n:].T @ blocks[:n, n:]


def _ellipse(W):
    """Return points of the ellipse x^T W^-1 x = 1."""
    angles = np.linspace(0, 2 * np.pi, 121)
    values, vectors = np.linalg.eigh((W + W.T) / 2)
    return vectors @ (
        np.sqrt(np.maximum(values, 0))[:, None] * np.array([np.cos(angles), np.sin(angles)])
    )
