"""Errors of the formula against integration, as a table."""

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True, repr=False)
class Residual:
    """Errors of reference curves on a grid, the result of `ReferenceCurves.residual`.

    Attributes
    ----------
    names : tuple of str
        Names of the components.
    axes : tuple of ndarray
        Axes of the grid.
    errors : ndarray, shape (components, times, ...)
        Absolute errors.
    exact : ndarray, shape (components, times, ...)
        Values by integration.
    """

    names: tuple
    axes: tuple
    _n: int = field(repr=False)
    errors: np.ndarray
    exact: np.ndarray

    @property
    def greatest(self) -> tuple:
        """Largest error of each component, its point (t, x_0..., p...), and its percentage."""
        rows = []
        for errors, exact in zip(self.errors, self.exact):
            at = np.unravel_index(errors.argmax(), errors.shape)
            point = tuple(float(axis[k]) for axis, k in zip(self.axes, at))
            percent = 100 * errors[at] / abs(exact[at]) if exact[at] else np.inf
            rows.append((float(errors[at]), point, float(percent)))
        return tuple(rows)

    def _rows(self):
        for name, (error, point, percent) in zip(self.names, self.greatest):
            x0 = ", ".join(f"{value:.5g}" for value in point[1 : 1 + self._n])
            at = f"t = {point[0]:.5g}, x0 = {x0}"
            if point[1 + self._n :]:
                at += f", p = {', '.join(f'{value:.5g}' for value in point[1 + self._n :])}"
            yield [name, f"{error:.4g}", f"{percent:.4g}", at]

    def __repr__(self):
        rows = [["component", "greatest error", "% there", "at"], *self._rows()]
        widths = [max(map(len, column)) for column in zip(*rows)]
        return "\n".join(
            "  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows
        )

    def _repr_markdown_(self):
        heads = ["component", "greatest error", "% there", "at"]
        lines = [heads, [":---", "---:", "---:", ":---"], *self._rows()]
        return "\n".join(f"| {' | '.join(line)} |" for line in lines)
