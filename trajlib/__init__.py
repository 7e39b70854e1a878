"""Controlled motion: stability, observers, filters and optimal control, exact where the input is
exact.

`import trajlib` loads nothing heavy; a theme is loaded when it is first used:

>>> import trajlib
>>> "stability" in dir(trajlib)
True
"""

from trajlib._lazy import lazy_modules

__version__ = "0.2.0"
_MODULES = [
    "estimation",
    "feedback",
    "flows",
    "infosets",
    "invariant",
    "plotting",
    "pontryagin",
    "reconstruction",
    "reference_curves",
    "solvability",
    "stability",
    "structure",
]
__getattr__, __dir__, __all__ = lazy_modules(__name__, _MODULES)
