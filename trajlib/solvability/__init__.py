"""Solvability of inverse problems: how well measurements determine a motion.

The motion is linearised about a reference, x' = A x, z = H x + r, and all measurements are stacked
into one system of linear equations for the state at a reference time t_s,

    Z = Htilde x_s + e,        Htilde = [H_1 Phi(t_1, t_s); ...; H_n Phi(t_n, t_s)],        W = E[e e^T].

The singular values of W^{-1/2} Htilde D^{-1}, with D the norms of the columns, decide what is
determined; constants of the rounding errors of orthogonal reflections and the error of Htilde
itself decide which of these values are reliable. Source: Kryzhko and Glushakova (2006), with the
corrections listed in chapter 7 of the book.

>>> from trajlib import solvability
>>> "analyse" in dir(solvability)
True
"""

from trajlib._lazy import lazy_names

# No module is called like a name it exports: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "variational": ["Linearisation", "linearise"],
    "transitions": ["clohessy_wiltshire", "stack", "transition"],
    "rounding": ["reflection_constant", "rounding_bound", "threshold"],
    "analysis": ["analyse"],
    "result": ["Solvability"],
    "householder": ["Estimate", "solve"],
    "boxes": ["Guarantee", "guarantee"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
