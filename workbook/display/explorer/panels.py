"""A panel of an `Explorer`: axes, and the parts that are drawn on them."""

from dataclasses import dataclass

import sympy as sp

from workbook.display.explorer.formulas import pretty

__all__ = ["Panel", "Part"]

#: Each style has a line and a mark of its own, so that parts differ without colours too.
LINES = ("solid", "dashed", "dotted", "thin")
MARKS = ("cross", "dot", "ring")


@dataclass(frozen=True)
class Part:
    """Something drawn: its kind, its formulas by role, its style."""

    kind: str
    formulas: dict
    style: str
    label: str
    inputs: frozenset
    series: int | None = None
    dragged: tuple = ()  # names of the parameters that dragging sets, None for fixed coordinates


class Panel:
    """A panel with two axes, made by `Explorer.panel`.

    Coordinates are those of the axes. Every method raises ValueError if an expression contains an
    unknown symbol.
    """

    def __init__(self, explorer, names, ranges, height, below):
        self._explorer = explorer
        self.axes = tuple(sp.Symbol(name) if isinstance(name, str) else name for name in names)
        self.names = tuple(pretty(axis) for axis in self.axes)
        self.x_range, self.y_range = (tuple(map(float, limits)) for limits in ranges)
        for argument, (low, high) in (("x_range", self.x_range), ("y_range", self.y_range)):
            if not low < high:
                raise ValueError(f"{argument}: expected (low, high) with low < high")
        self.height, self.below, self.parts = float(height), below, []

    @property
    def dragged(self):
        """The names of the parameters that are set by a point of this panel."""
        return {name for part in self.parts for name in part.dragged if name is not None}

    def line(self, series, x, y, style="solid", label=""):
        """Draw a line through the rows of a series.

        Parameters
        ----------
        series : Series
            The series.
        x, y : sympy.Expr
            Coordinates, in the columns of the series and the scalars.
        style : str
            "solid", "dashed", "dotted" or "thin".
        label : str
            Text in the legend.

        Raises
        ------
        ValueError
            If there is no such style, or an expression contains an unknown symbol.
        """
        self._along(series, "line", x, y, _style(style, LINES), label)

    def marks(self, series, x, y, style="cross", label=""):
        """Mark the rows of a series.

        Parameters
        ----------
        series : Series
            The series.
        x, y : sympy.Expr
            Coordinates, in the columns of the series and the scalars.
        style : str
            "cross", "dot" or "ring".
        label : str
            Text in the legend.

        Raises
        ------
        ValueError
            If there is no such style, or an expression contains an unknown symbol.
        """
        self._along(series, "marks", x, y, _style(style, MARKS), label)

    def point(self, x, y, label=""):
        """Draw a point. Where a coordinate is a parameter, the reader drags it.

        Parameters
        ----------
        x, y : sympy.Symbol or sympy.Expr
            Coordinates, in the scalars.
        label : str
            What the point is, in the legend and for screen readers.
        """
        parameters = {str(parameter.symbol) for parameter in self._explorer.parameters}
        dragged = tuple(str(value) if str(value) in parameters else None for value in (x, y))
        self._add("point", {"x": [x], "y": [y]}, "point", label, dragged=dragged)

    def segments(self, points, style="solid", label=""):
        """Draw straight lines from point to point, such as a rod.

        Parameters
        ----------
        points : sequence of (sympy.Expr, sympy.Expr)
            The points, in the scalars.
        style : str
            "solid", "dashed", "dotted" or "thin".
        label : str
            Text in the legend.

        Raises
        ------
        ValueError
            If there is no such style, or an expression contains an unknown symbol.
        """
        x, y = zip(*points)
        self._add("segments", {"x": x, "y": y}, _style(style, LINES), label)

    def region(self, condition, label=""):
        """Fill the part of the panel in which a condition holds.

        Parameters
        ----------
        condition : sympy.Boolean
            The condition, in the axes of the panel and the scalars.
        label : str
            Text in the legend.
        """
        self._add("region", {"condition": [condition]}, "region", label, self.axes)

    def field(self, x_rate, y_rate):
        """Draw the directions of a vector field by small arrows.

        Parameters
        ----------
        x_rate, y_rate : sympy.Expr
            Its components, in the axes of the panel and the scalars.
        """
        self._add("field", {"x": [x_rate], "y": [y_rate]}, "field", "", self.axes)

    def _along(self, series, kind, x, y, style, label):
        self._add(kind, {"x": [x], "y": [y]}, style, label, series.columns, series)

    def _add(self, kind, formulas, style, label, columns=(), series=None, dragged=()):
        explorer = self._explorer
        formulas = {
            role: [explorer._formula(role, value, columns) for value in values]
            for role, values in formulas.items()
        }
        inputs = explorer._inputs_of(formulas, [] if series is None else [series])
        index = None if series is None else series.index
        self.parts.append(Part(kind, formulas, style, label, inputs, index, dragged))


def _style(style, styles):
    if style not in styles:
        raise ValueError(f"style: expected one of {', '.join(styles)}, got {style!r}")
    return style
