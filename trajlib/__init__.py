"""Controlled motion: stability, observers, filters and optimal control.

Exact input gives exact results.

`import trajlib` loads nothing heavy; each package loads on first use:

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
