"""Stability of motion: chapter 1 of the problem book as functions.

Exact input gives exact output: SymPy expressions and matrices lead to conditions on their
parameters, NumPy arrays to floating-point numbers. Every name is loaded on first use, so that
importing the package costs nothing.

>>> from trajlib import stability
>>> "stability_conditions" in dir(stability)
True
"""

from trajlib._lazy import lazy_names

# No module is called like a name it exports: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "hurwitz": ["characteristic_polynomial", "hurwitz_matrix", "hurwitz_minors"],
    "regions": ["StabilityConditions", "stability_conditions"],
    "jury": ["jury_conditions"],
    "shifted_polynomials": ["shift"],
    "critical": ["LinearStability", "linear_stability"],
    "equilibrium": ["Equilibria", "equilibria"],
    "linearisation": ["linearise", "linearise_along"],
    "lyapunov": [
        "Definiteness",
        "ZeroDerivativeSet",
        "barbashin_krasovskii",
        "is_positive_definite",
        "lyapunov_derivative",
    ],
    "basin": ["BasinEstimate", "basin_estimate"],
    "planar": ["DulacTest", "PlanarTypes", "classify_planar", "dulac"],
    "polar": ["LimitCycle", "limit_cycles", "polar_form"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
