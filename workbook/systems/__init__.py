"""Systems, processes and functionals as records, as the data cells of problems state them.

>>> from workbook.systems import Mechanical
>>> pendulums = Mechanical(M=[[2, 1], [1, 1]], D=0, K=[[-5, 0], [0, 6]], H1=[[1, 3]])
>>> pendulums.K
Matrix([
[-5, 0],
[ 0, 6]])
>>> pendulums.H2
Matrix([[0, 0]])
"""

from workbook.systems.linear import (
    Deviations,
    Linear,
    Measurements,
    Mechanical,
    Scalar,
    Varying,
    WithError,
)
from workbook.systems.optimal import Controlled, Functional, Quadratic
from workbook.systems.random_processes import Coloured, FilterErrors, Process

__all__ = [
    "Coloured",
    "Controlled",
    "Deviations",
    "FilterErrors",
    "Functional",
    "Linear",
    "Measurements",
    "Mechanical",
    "Process",
    "Quadratic",
    "Scalar",
    "Varying",
    "WithError",
]
