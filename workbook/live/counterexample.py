"""Draw a wrong stability region with a point of the plane where it is wrong."""

import numpy as np
import sympy as sp
from sympy.logic.boolalg import Boolean

from trajlib import plotting

#: Half the sides of the squares that are searched; the first one with a counterexample is drawn.
HALF_WIDTHS = (4, 2, 10, 1)
GRID = 121


def counterexample_figure(claim, reference):
    """Return a figure of a claimed condition with the point farthest inside the wrong part.

    Parameters
    ----------
    claim, truth : sympy Boolean
        The claimed and the true condition.

    Returns
    -------
    matplotlib.figure.Figure or None
        None if these are no conditions in the same two real parameters, or differ on curves only.
    """
    symbols = _plane(claim, reference)
    if symbols is None:
        return None
    for half_width in HALF_WIDTHS:
        point = _deepest_point(claim, reference, symbols, half_width)
        if point is not None:
            return _figure(claim, symbols, half_width, *point)
    return None


def _plane(claim, reference):
    """Return the two symbols of both conditions, or None."""
    if not (isinstance(claim, Boolean) and isinstance(reference, Boolean)):
        return None
    symbols = sorted(reference.free_symbols | claim.free_symbols, key=str)
    by_name = {symbol.name for symbol in symbols}
    return symbols if len(symbols) == 2 == len(by_name) else None


def _deepest_point(claim, reference, symbols, half_width):
    """Return (x, y, value of the claim) of the grid point farthest from where both agree."""
    from scipy.ndimage import distance_transform_edt

    axis = np.linspace(-half_width, half_width, GRID)
    x, y = np.meshgrid(axis, axis)
    claimed, expected = _evaluate(claim, symbols, x, y), _evaluate(reference, symbols, x, y)
    if claimed is None or expected is None:
        return None
    depth = distance_transform_edt(np.pad(claimed != expected, 1))[1:-1, 1:-1]
    row, column = np.unravel_index(depth.argmax(), depth.shape)
    if depth[row, column] < 2:  # they differ on a line of the grid only
        return None
    return axis[column], axis[row], bool(claimed[row, column])


def _evaluate(condition, symbols, x, y):
    with np.errstate(all="ignore"):
        try:
            values = sp.lambdify(symbols, condition, "numpy")(x, y)
        except (TypeError, NameError, ValueError):  # a function that NumPy does not have
            return None
    return np.broadcast_to(np.asarray(values, dtype=bool), x.shape)


def _figure(claim, symbols, half_width, x, y, is_claimed):
    # for a figure only: most verdicts have none
    import matplotlib.pyplot as plt

    with plotting.style():
        figure, axes = plt.subplots(figsize=(4.4, 4))
        plotting.region(claim, symbols, *[(-half_width, half_width)] * 2, ax=axes)
        axes.plot(x, y, "kX", markersize=11)
        axes.annotate(
            f"({x:.2g}, {y:.2g})\n{'counted in' if is_claimed else 'left out'}, wrongly",
            (x, y),
            textcoords="offset points",
            xytext=(9, 9),
            bbox={"boxstyle": "round", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
        )
        names = [sp.latex(symbol) for symbol in symbols]
        axes.set_title(f"the claim in the plane of ${names[0]}$, ${names[1]}$")
        plt.close(figure)
    return figure
