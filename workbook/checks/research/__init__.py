"""Checks of the research chapters.

Reconstruction (chapter 6), solvability (7), interpolation and invariance (8), information sets (9).
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "conditioning": [
            "bound_violating_error",
            "dependence_hiding_error",
            "greatest_row_count",
            "nearly_dependent_condition_number",
        ],
        "infosets": [
            "common_point_exists",
            "greatest_distance",
            "section_meets",
            "section_values",
            "support_values",
        ],
        "interpolation": ["greatest_magnitude", "interpolant_quantity"],
        "invariance": ["invariant_weights"],
        "reconstruction": [
            "boundary_decay",
            "bounded_misfit",
            "digits_lost",
            "filter_gain",
            "multiple_eigenvalues",
            "spline_acceleration",
            "spline_misfit",
            "spline_positions",
            "transition_polynomial",
            "weight_for_bound",
            "weight_of_harmonic",
        ],
        "solvability": [
            "bias_of_estimate",
            "observability_ranks",
            "range_error",
            "range_modes",
            "range_observable",
            "stations_insufficient",
            "unobservable_by_bearings",
            "worst_case_error",
        ],
    },
)
