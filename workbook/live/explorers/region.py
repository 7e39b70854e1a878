"""A region of stability with the roots moving beside it: the point of the plane is pulled, the
roots follow."""

import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.explorers.stage import Explorer, Stage, near, slider
from workbook.live.subjects import LiveError
from workbook.live.worked import Worked

#: How far parameters and roots are shown.
RANGE, REACH = (-2.0, 4.0), 3.0


def region_of_stability(problem="1.15", item="a"):
    """The region of an item in the plane of its two parameters; click into it, or move the sliders.

    `problem`: a number whose data have a polynomial `a_poly` or a matrix `a_matrix` with two
    parameters, such as "1.15", "1.16", "1.18"; `item`: its letter. Where the problem sets a margin,
    the line that the roots must not cross is moved by it.
    """
    polynomial, s, (k1, k2), margin = _asked(problem, item)
    holds = _region(polynomial, (k1, k2), s, margin)
    stage = Stage(2)
    plane, complex_plane = stage.axes
    plotting.region(holds, (k1, k2), RANGE, RANGE, ax=plane)
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
    trail = stage.line(complex_plane, ".", color=plotting.GREY, markersize=3)
    point = stage.line(plane, "o", color=plotting.BLACK, markersize=10)
    stable = stage.line(complex_plane, "o", color=plotting.BLUE, markersize=10)
    unstable = stage.line(complex_plane, "X", color=plotting.RED, markersize=11)
    coefficients = sp.lambdify((k1, k2), sp.Poly(polynomial, s).all_coeffs(), "numpy")
    seen = []

    def draw(**values):
        x, y = values.values()
        leading, *rest = coefficients(x, y)
        roots = np.roots([leading, *rest])
        seen.append(roots)
        del seen[:-120]
        inside = roots.real < -margin - 1e-9  # on the line counts as outside
        trail.set_data(*_parts(np.concatenate(seen)))
        point.set_data([x], [y])
        stable.set_data(*_parts(roots[inside]))
        unstable.set_data(*_parts(roots[~inside]))
        if abs(leading) < 1e-12:
            return "the leading coefficient is 0: a root has gone to infinity"
        return (
            f"{inside.sum()} of {len(roots)} roots lie left of the line; the greatest real part is "
            f"{roots.real.max():.3g}"
        )

    controls = {str(k): slider(str(k), *RANGE, value) for k, value in ((k1, 2.0), (k2, 1.0))}

    def pointed(axes, points):
        if axes is plane:
            for control, value in zip(controls.values(), points[-1]):
                control.value = near(control, value)

    return Explorer(stage, controls, draw, pointed)


def _parts(numbers):
    return numbers.real, numbers.imag


def _asked(problem, item):
    data = Worked(problem).data
    given = [data[name] for name in (f"{item}_poly", f"{item}_matrix") if name in data]
    symbols = sorted(given[0].free_symbols - {data.get("s")}, key=str) if given else []
    if len(symbols) != 2:
        items = sorted(name[0] for name in data if name[1:] in ("_poly", "_matrix"))
        raise LiveError(
            f"problem {problem} has no item {item} with a polynomial or a matrix in two "
            "parameters; "
            + (f"there is {', '.join(items)}" if items else "1.15, 1.16 and 1.18 have")
        )
    s = data.get("s", sp.Symbol("s"))
    polynomial = given[0] if isinstance(given[0], sp.Expr) else given[0].charpoly(s).as_expr()
    return polynomial, s, symbols, data.get("margin", 0)


def _region(polynomial, symbols, s, margin):
    from trajlib.stability import stability_conditions

    return stability_conditions(polynomial, symbols, margin=margin, symbol=s).region
