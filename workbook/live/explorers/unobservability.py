"""Distance to the nearest unobservable pair by the PBH test, over a parameter of the output."""

import numpy as np
import sympy as sp

from trajlib import structure
from workbook.display import Explorer
from workbook.live.errors import LiveError
from workbook.live.explorers.built_once import built_once
from workbook.live.worked_problem import WorkedProblem

#: Range of the parameter and its step, width of the enclosure, half the side of the plane of lambda.
RANGE, STEP, WITHIN, REACH = (-4, 4), sp.Rational(1, 10), 0.05, 3.2


@built_once
def distance_to_unobservable(problem="2.5", item="g"):
    """Show the distance of A, H(alpha) to unobservability: the least sigma(lambda) in the plane.

    Left: where sigma, the least singular value of (A - lambda I; H), is below a level, with the
    eigenvalues and the unobservable eigenvalue of the nearest pair. Right: the least value over
    alpha. The distances are computed beforehand, by the library.

    Parameters
    ----------
    problem, item : str
        A problem whose data have a matrix `A_g` and `H_g` with one parameter: "2.5" g to j.

    Raises
    ------
    LiveError
        If there is no such item.
    """
    A, H, alpha = _pair(problem, item)
    at, level, p, q, a, lower, upper, re, im = sp.symbols(
        "at level p q a lower upper re im", real=True
    )
    values = np.arange(RANGE[0], RANGE[1] + float(STEP) / 2, float(STEP))
    results = [
        structure.distance_to_unobservable(
            np.array(A, dtype=float), np.array(H.subs(alpha, value), dtype=float), within=WITHIN
        )
        for value in values
    ]
    figure = Explorer(
        f"{problem} {item}: where does the region end as the level falls, and at which level?",
        "The plane of lambda with the region in which the least singular value is below a level, "
        "and the distance to the nearest unobservable pair over a parameter.",
    )
    figure.parameter(alpha, 1, RANGE, step=float(STEP))
    figure.parameter(level, 0.8, (0.01, 2), "level of σ")
    figure.quantity(at, STEP * sp.floor(alpha / STEP + sp.Rational(1, 2)))
    table = figure.table(
        {
            a: values,
            lower: [result.lower for result in results],
            upper: [result.upper for result in results],
            re: [result.eigenvalue.real for result in results],
            im: [abs(result.eigenvalue.imag) for result in results],
        }
    )
    here = sp.Abs(a - at) < STEP / 2
    for symbol, column in zip(sp.symbols("least most real imaginary"), (lower, upper, re, im)):
        table.largest(symbol, sp.Piecewise((column, here), (-1000, True)))
    eigenvalues = figure.roots(A.charpoly().as_expr(), A.charpoly().gen)
    plane = figure.panel("p", "q", (-REACH, REACH), (-REACH, REACH))
    plane.names = ("Re λ", "Im λ")
    output = H.subs(alpha, at)
    # sigma < level where pencil* pencil + H* H - level^2 I is not positive definite
    pencil = A - (p + sp.I * q) * sp.eye(A.rows)
    form = pencil.H * pencil + output.T * output - level**2 * sp.eye(A.rows)
    minors = [form[:k, :k].det(method="berkowitz").expand() for k in range(1, A.rows + 1)]
    plane.region(sp.Or(*(minor < 0 for minor in minors)), "σ below the level")
    plane.marks(eigenvalues, *eigenvalues.columns, "cross", "eigenvalues")
    for sign, label in ((1, "nearest pair"), (-1, "")):
        plane.marks(table, sp.Piecewise((re, here), (sp.nan, True)), sign * im, "ring", label)
    curve = figure.panel(alpha, "distance", RANGE, (0, 1.1 * max(r.upper for r in results)))
    curve.line(table, a, upper)
    curve.marks(table, sp.Piecewise((a, here), (sp.nan, True)), upper, "ring")
    said = (
        "The distance is between {least} and {most}, proved; the nearest unobservable pair has the "
        "unobservable eigenvalue "
    )
    imaginary = sp.Symbol("imaginary")
    figure.sentence((imaginary < 1e-6, said + "{real}."), (True, said + "{real} ± {imaginary}i."))
    return figure


def _pair(problem, item):
    data = WorkedProblem(problem).data
    A, H = data.get(f"A_{item}"), data.get(f"H_{item}")
    parameters = (
        sorted(H.free_symbols, key=str)
        if A is not None and H is not None and not A.free_symbols
        else []
    )
    if len(parameters) != 1:
        raise LiveError(
            f"problem {problem} has no item {item} with numbers A_{item} and one parameter in "
            f"H_{item}; 2.5 has g, h, i, j"
        )
    return A, H, parameters[0]
