"""A stability region with the roots beside it, which follow the point of the parameters."""

import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.errors import LiveError
from workbook.live.explorers.blitting import BlittedFigure
from workbook.live.explorers.explorer import Explorer, nearest_value, slider
from workbook.live.worked_problem import WorkedProblem

#: Range of the parameters, and of the real and imaginary parts of the roots.
RANGE, REACH = (-2.0, 4.0), 3.0


def region_of_stability(problem="1.15", item="a"):
    """Show a stability region in the plane of two parameters, and the roots at a point of it.

    Parameters
    ----------
    problem : str
        A problem whose data have a polynomial `a_poly` or a matrix `a_matrix` with two parameters:
        "1.15", "1.16" or "1.18". Where it sets a stability margin, the roots are to lie left of
        minus the margin.
    item : str
        Its letter.

    Raises
    ------
    LiveError
        If there is no such item.
    """
    polynomial, s, (k1, k2), margin = _data(problem, item)
    region = _region(polynomial, (k1, k2), s, margin)
    figure = BlittedFigure(2)
    plane, complex_plane = figure.axes
    plotting.region(region, (k1, k2), RANGE, RANGE, ax=plane)
    plane.set_title(f"problem {problem}, item {item}")
    complex_plane.set(
        xlim=(-REACH, REACH),
        ylim=(-REACH, REACH),
        xlabel="Re $s$",
        ylabel="Im $s$",
        title="the roots",
    )
    complex_plane.axvspan(-REACH, -margin, color=plotting.SKY, alpha=0.2, linewidth=0)
    complex_plane.axvline(-margin, color=plotting.BLACK, linewidth=1.6)
    complex_plane.axhline(0, color=plotting.GREY, linewidth=0.8)
    trail = figure.line(complex_plane, ".", color=plotting.GREY, markersize=3)
    point = figure.line(plane, "o", color=plotting.BLACK, markersize=10)
    stable = figure.line(complex_plane, "o", color=plotting.BLUE, markersize=10)
    unstable = figure.line(complex_plane, "X", color=plotting.RED, markersize=11)
    coefficients = sp.lambdify((k1, k2), sp.Poly(polynomial, s).all_coeffs(), "numpy")
    history = []

    def draw(**values):
        x, y = values.values()
        leading, *lower_coefficients = coefficients(x, y)
        roots = np.roots([leading, *lower_coefficients])
        history.append(roots)
        del history[:-120]
        inside = roots.real < -margin - 1e-9  # on the line counts as outside
        trail.set_data(*_coordinates(np.concatenate(history)))
        point.set_data([x], [y])
        stable.set_data(*_coordinates(roots[inside]))
        unstable.set_data(*_coordinates(roots[~inside]))
        if abs(leading) < 1e-12:
            return "the leading coefficient is 0: a root has gone to infinity"
        return (
            f"{inside.sum()} of {len(roots)} roots lie left of the line; the greatest real part is "
            f"{roots.real.max():.3g}"
        )

    controls = {str(k): slider(str(k), *RANGE, value) for k, value in ((k1, 2.0), (k2, 1.0))}

    def on_stroke(axes, points):
        if axes is plane:
            for control, value in zip(controls.values(), points[-1]):
                control.value = nearest_value(control, value)

    return Explorer(figure, controls, draw, on_stroke)


def _coordinates(numbers):
    return numbers.real, numbers.imag


def _data(problem, item):
    data = WorkedProblem(problem).data
    candidates = [data[name] for name in (f"{item}_poly", f"{item}_matrix") if name in data]
    symbols = sorted(candidates[0].free_symbols - {data.get("s")}, key=str) if candidates else []
    if len(symbols) != 2:
        items = sorted(name[0] for name in data if name[1:] in ("_poly", "_matrix"))
        raise LiveError(
            f"problem {problem} has no item {item} with a polynomial or a matrix in two "
            "parameters; "
            + (f"there is {', '.join(items)}" if items else "1.15, 1.16 and 1.18 have")
        )
    s = data.get("s", sp.Symbol("s"))
    polynomial = (
        candidates[0] if isinstance(candidates[0], sp.Expr) else candidates[0].charpoly(s).as_expr()
    )
    return polynomial, s, symbols, data.get("margin", 0)


def _region(polynomial, symbols, s, margin):
    # loads SymPy, when the first region is asked for
    from trajlib.stability import stability_conditions

    return stability_conditions(polynomial, symbols, margin=margin, symbol=s).region
