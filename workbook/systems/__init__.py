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

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "linear": [
            "Deviations",
            "Linear",
            "Measurements",
            "Mechanical",
            "Scalar",
            "Varying",
            "WithError",
        ],
        "optimal": ["Controlled", "Functional", "Quadratic"],
        "random_processes": ["Coloured", "FilterErrors", "Process"],
    },
)
