"""Checks of the research chapters.

Reconstruction (chapter 6), solvability (7), interpolation and invariance (8), information sets (9).
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "infosets": ["common_point", "support_values"],
        "interpolation": ["of_interpolant"],
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
            "bearing_tells_range",
            "bias_of_estimate",
            "breaks_bound",
            "condition_of_nearly_equal",
            "fooling_error",
            "modes_of_range",
            "most_rows",
            "numbers_seen",
            "range_error",
            "stations_insufficient",
            "unseen_by_bearings",
            "worst_of_three",
        ],
    },
)
