"""Observability and controllability of linear systems: chapter 2 of the problem book.

The system is x' = Ax + Bu, z = Hx: A is n x n, B is n x s, H is m x n (a scalar output is a matrix
with one row, `sp.Matrix([[1, 0]])`). Exact input gives exact output, also with symbols; NumPy
arrays and python-control's StateSpace give floating-point numbers. Every name is loaded on first
use, so that importing the package costs nothing.

>>> from trajlib import structure
>>> "observability" in dir(structure)
True
"""

from trajlib._lazy import lazy_names

# No module is called like a name it exports: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "kalman_matrices": ["controllability_matrix", "observability_matrix"],
    "gramian": ["controllability_gramian"],
    "rank_tests": ["HiddenMode", "RankTest", "controllability", "observability"],
    "distance": ["Distance", "distance_to_uncontrollable", "distance_to_unobservable"],
    "subspaces": ["controllable_subspace", "unobservable_subspace"],
    "parameters": ["RankConditions", "controllability_conditions", "observability_conditions"],
    "mechanical": ["first_order_form", "mechanical_controllability", "mechanical_observability"],
    "lagrange": ["SmallMotions", "small_motions"],
    "canonical": ["CanonicalForm", "controller_canonical_form", "observer_canonical_form"],
    "decomposition": [
        "Decomposition",
        "controllability_decomposition",
        "observability_decomposition",
    ],
    "components": ["ComponentDecomposition", "decompose_by_inputs", "decompose_by_outputs"],
    "measurement_errors": [
        "time_varying_conditions",
        "time_varying_observability_matrix",
        "with_measurement_error",
    ],
    "input_derivatives": ["ScalarEquation", "scalar_equation", "state_form"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
