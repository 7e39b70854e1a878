"""Loss of controllability or observability of a mode as a pole-zero cancellation."""

import sympy as sp

from workbook.display import Explorer
from workbook.live.explorers.built_once import built_once
from workbook.live.worked_problem import WorkedProblem

HORIZON, REACH, SMALL = 3, 3, 1e-12


@built_once
def pole_zero_cancellation():
    """Show when the modes of problem 2.27, x' = Ax + B(beta)u, z = H(alpha)x, are cancelled.

    Left: the states that a control of energy 1 reaches from rest in 3 units of time, an ellipse
    that collapses when a mode is uncontrollable. Middle: the uncertainty of the initial state if
    the output has an error of energy 0.01, an ellipse that is unbounded when a mode is
    unobservable. Right: where the zero of the transfer function meets a pole, the mode is
    uncontrollable or unobservable.
    """
    data = WorkedProblem("2.27").data
    A, B, H, alpha, beta = (data[name] for name in ("A", "B", "H", "alpha", "beta"))
    s, angle, control, output = sp.symbols("s angle control output", real=True)
    figure = Explorer(
        "What happens to the ellipses where the zero meets a pole?",
        "The states reached with energy 1, the uncertainty of a measured initial state, and the "
        "poles and the zero of the transfer function.",
    )
    figure.parameter(alpha, 0.5, (-3, 3), "H = (1, α), α", 0.05)
    figure.parameter(beta, 2, (-3, 3), "B = (1, β), β", 0.05)
    poles = figure.roots((s * sp.eye(2) - A).det(), s)
    zero = figure.roots((H * (s * sp.eye(2) - A).adjugate() * B)[0], s)
    figure.quantity(control, sp.Abs(sp.Matrix.hstack(B, A * B).det()))
    figure.quantity(output, sp.Abs(sp.Matrix.vstack(H, H * A).det()))
    around = figure.curve(angle, 0, 2 * sp.pi)
    reachable, observed = _gramian(A, B), _gramian(A.T, H.T)
    scale = 1 / (100 * (sp.Abs(observed.det()) + SMALL))
    square = (-REACH, REACH)
    for name, matrix, factor, style, label in (
        ("W", reachable, 1, "solid", "reached with energy 1"),
        ("P", observed.adjugate(), scale, "dashed", "left open by the output"),
    ):
        plane = figure.panel("x1", "x2", square, square)
        for _, _, (direction,) in A.eigenvects():
            plane.segments([tuple(-9 * direction), tuple(9 * direction)], "thin")
        plane.line(around, *_ellipse(figure, name, matrix, factor, angle), style, label)
    complex_plane = figure.panel("Re s", "Im s", (-4.5, 1.5), (-3, 3))
    complex_plane.marks(poles, *poles.columns, "cross", "poles")
    complex_plane.marks(zero, *zero.columns, "ring", "zero")
    figure.sentence(
        (control < 1e-9, "A mode is uncontrollable: the reachable states lie on a line."),
        (output < 1e-9, "A mode is unobservable: the output leaves it open."),
        (True, "No mode is cancelled: det (B, AB) = {control}, det (H; HA) = {output}."),
    )
    return figure


def _gramian(A, B):
    """Return the integral of exp(At) B B^T exp(A^T t) over the horizon."""
    t = sp.Symbol("t", real=True)
    return ((A * t).exp() * B * B.T * (A.T * t).exp()).applyfunc(
        lambda entry: sp.integrate(sp.expand(entry), (t, 0, HORIZON))
    )


def _ellipse(figure, name, W, factor, angle):
    """Return a point of the ellipse of a covariance, `factor` W, by its Cholesky factor."""
    first, mixed, last = entries = sp.symbols(f"{name}1:4")
    values = (
        sp.sqrt(factor * W[0, 0]),
        factor * W[0, 1] / first,
        sp.sqrt(sp.Abs(W.det())) * factor / first,
    )
    for entry, value in zip(entries, values):
        figure.quantity(entry, value)
    return first * sp.cos(angle), mixed * sp.cos(angle) + last * sp.sin(angle)
