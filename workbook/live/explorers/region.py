"""A stability region with the roots beside it, which follow the point of the parameters."""

import sympy as sp

from workbook.display import Explorer
from workbook.live.errors import LiveError
from workbook.live.explorers.built_once import built_once
from workbook.live.worked_problem import WorkedProblem

#: Range of the parameters, and of the real and imaginary parts of the roots.
RANGE, REACH = (-2, 4), 3


@built_once
def region_of_stability(problem="1.15", item="a"):
    """Show a stability region in the plane of two parameters, and the roots at a point of it.

    Parameters
    ----------
    problem : str
        A problem whose data have a polynomial `a_poly` or a matrix `a_matrix` with two parameters:
        "1.15", "1.16" or "1.18". Where it sets a degree of stability, the roots are to lie left of
        minus this number.
    item : str
        Its letter.

    Raises
    ------
    LiveError
        If there is no such item.
    """
    polynomial, s, (k1, k2), margin = _data(problem, item)
    greatest = sp.Symbol("greatest")
    figure = Explorer(
        f"{problem} {item}: which roots cross the line, and on which boundary?",
        "A stability region in the plane of two parameters, and the roots at a point of it.",
    )
    figure.parameter(k1, 2, RANGE)
    figure.parameter(k2, 1, RANGE)
    roots = figure.roots(polynomial, s)
    real, imaginary = roots.columns
    roots.largest(greatest, real)
    plane = figure.panel(k1, k2, RANGE, RANGE)
    plane.region(_region(polynomial, (k1, k2), s, margin), "stability region")
    plane.point(k1, k2, "parameters")
    complex_plane = figure.panel("Re s", "Im s", (-REACH, REACH), (-REACH, REACH))
    complex_plane.segments([(-margin, -REACH), (-margin, REACH)], "dashed", "boundary")
    complex_plane.marks(roots, real, imaginary, label="roots")
    figure.sentence(
        # on the line counts as outside
        (
            greatest < -margin - 1e-9,
            "All roots lie left of the line; the greatest real part is {greatest}.",
        ),
        (True, "Not all roots lie left of the line; the greatest real part is {greatest}."),
    )
    return figure


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

    return stability_conditions(polynomial, symbols, degree=margin, symbol=s).region
