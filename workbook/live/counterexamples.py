"""A wrong region with a point of the plane that speaks against it."""

import numpy as np

#: Half the side of the square that is looked at; the first one in which claim and truth differ is
#: drawn.
WINDOWS = (4, 2, 10, 1)
GRID = 121


def picture(claim, truth):
    """A figure of the claimed condition in two parameters with a point where it is wrong, as deep
    in as can be.

    None where claim and truth are no conditions in the same two real parameters, or differ on lines
    alone.
    """
    symbols = _plane(claim, truth)
    if symbols is None:
        return None
    for half in WINDOWS:
        point = _deepest(claim, truth, symbols, half)
        if point is not None:
            return _drawn(claim, symbols, half, *point)
    return None


def _plane(claim, truth):
    from sympy.logic.boolalg import Boolean

    if not (isinstance(claim, Boolean) and isinstance(truth, Boolean)):
        return None
    symbols = sorted(truth.free_symbols | claim.free_symbols, key=str)
    by_name = {symbol.name for symbol in symbols}
    return symbols if len(symbols) == 2 == len(by_name) else None


def _deepest(claim, truth, symbols, half):
    """(x, y, whether the claim counts it in) of the point of a grid that is farthest from where the
    two agree."""
    from scipy.ndimage import distance_transform_edt

    axis = np.linspace(-half, half, GRID)
    x, y = np.meshgrid(axis, axis)
    claimed, true = _holds(claim, symbols, x, y), _holds(truth, symbols, x, y)
    if claimed is None or true is None:
        return None
    depth = distance_transform_edt(np.pad(claimed != true, 1))[1:-1, 1:-1]
    row, column = np.unravel_index(depth.argmax(), depth.shape)
    if depth[row, column] < 2:  # lines of the grid
        return None
    return axis[column], axis[row], bool(claimed[row, column])


def _holds(condition, symbols, x, y):
    import sympy as sp

    with np.errstate(all="ignore"):
        try:
            values = sp.lambdify(symbols, condition, "numpy")(x, y)
        except (TypeError, NameError, ValueError):  # what NumPy has no word for
            return None
    return np.broadcast_to(np.asarray(values, dtype=bool), x.shape)


def _drawn(claim, symbols, half, x, y, counted_in):
    import matplotlib.pyplot as plt
    import sympy as sp

    from trajlib import plotting

    with plotting.style():
        figure, axes = plt.subplots(figsize=(4.4, 4))
        plotting.region(claim, symbols, (-half, half), (-half, half), ax=axes)
        axes.plot(x, y, "kX", markersize=11)
        said = "counted in" if counted_in else "left out"
        axes.annotate(
            f"({x:.2g}, {y:.2g})\n{said}, wrongly",
            (x, y),
            textcoords="offset points",
            xytext=(9, 9),
            bbox={"boxstyle": "round", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
        )
        names = [sp.latex(symbol) for symbol in symbols]
        axes.set_title(f"the claim in the plane of ${names[0]}$, ${names[1]}$")
        plt.close(figure)
    return figure
