"""Colours, style and empty axes of all pictures."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

BLACK, BLUE, RED, GREEN, ORANGE, SKY, PURPLE, GREY = (
    "#000000",
    "#0072B2",
    "#D55E00",
    "#009E73",
    "#8A5307",
    "#3D97CE",
    "#C4709A",
    "#8C8C8C",
)


@contextmanager
def style() -> Iterator[None]:
    """Apply the style of the workbook to everything drawn inside the `with` block.

    Examples
    --------
    >>> import matplotlib
    >>> before = matplotlib.rcParams["font.size"]
    >>> with style():
    ...     inside = matplotlib.rcParams["font.size"]
    >>> inside, matplotlib.rcParams["font.size"] == before
    (12.0, True)
    """
    import matplotlib.pyplot as plt
    from cycler import cycler

    colours = cycler(color=[BLUE, RED, GREEN, PURPLE, ORANGE, BLACK])
    lines = cycler(linestyle=["-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2))])
    settings: dict[Any, Any] = {
        "figure.figsize": (5.2, 4.2),
        "figure.dpi": 110,
        "figure.constrained_layout.use": True,
        "savefig.dpi": 110,
        "font.size": 12.0,
        "axes.labelsize": 14,
        "axes.titlesize": 13,
        "axes.prop_cycle": colours + lines,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "lines.linewidth": 1.8,
        "hatch.linewidth": 0.7,
        "legend.fontsize": 11,
        "legend.frameon": True,
        "legend.framealpha": 0.9,
        "mathtext.fontset": "cm",
    }
    # Only these settings are restored: rc_context would also undo those of a notebook's backend
    # that loads inside.
    previous = {name: plt.rcParams[name] for name in settings}
    plt.rcParams.update(settings)
    try:
        yield
    finally:
        plt.rcParams.update(previous)


def new_axes():
    import matplotlib.pyplot as plt

    with style():
        return plt.subplots()[1]


def add_legend(ax):
    ax.legend(loc="best")
