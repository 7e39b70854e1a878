"""Controlled motion: the library of the executable workbook.

`import trajlib` loads nothing heavy; a theme is loaded when it is first used:

>>> import trajlib
>>> "stability" in dir(trajlib)
True
"""

from trajlib._lazy import lazy_modules

__version__ = "0.1.0"
_MODULES = ["checks", "drawings", "estimation", "feedback", "flows", "infosets", "invariant", "masters", "motions",
            "plotting", "pontryagin", "reconstruction", "reference_curves", "showing", "solvability", "stability",
            "structure", "systems"]
__getattr__, __dir__, __all__ = lazy_modules(__name__, _MODULES)
