"""Checks of answers: they judge the defining property, never a stored answer.

`checks.report(name=checks.stability_region(name, ...))` is the last line of every check cell.
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(__name__, {
    "reporting": ["NotYet", "collecting", "report"],
    "verdict": ["Unusable", "Verdict", "judged"],
    "regions": ["instability_region", "stability_region", "stable_equation"],
    "equilibrium": ["equilibria", "spectra", "stable_equilibria"],
    "linear": ["first_approximation_stable", "first_approximation_unstable", "linearisation", "zero_stability"],
    "lyapunov": ["basin_estimate", "basin_level", "departure", "lyapunov_derivative", "proved_global", "proved_stable",
                 "vanishing_set"],
    "families": ["deviation_matrices", "growth_rate", "rest_kinds", "rest_values", "saddle_slopes", "single_rest",
                 "stable_rest_values", "unstable_rest_values"],
    "planar": ["cycle_exists", "cycle_period", "cycle_radius", "dulac", "first_integral", "focus_region", "node_region",
               "nullcline", "phase_curve", "stationary_exists", "stationary_linearisation", "stationary_points",
               "stationary_stability", "stationary_type", "stationary_value"],
    "cycles": ["cycle_stability", "limit_cycles", "polar_form", "radial_motion", "return_slope"],
    "critical": ["conserved_form", "critical_stability", "eigenvalue_multiplicities", "growing_motion", "limit_state",
                 "stable_parameters"],
    "motions": ["angle_deviations", "focus_parameters", "input_matrix_along", "linearisation_along", "node_parameters", "program_motion",
                "rest_angles", "rest_angles_exist", "saddle_angles", "stable_angles", "stable_rest_angles", "unstable_rest_angles"],
    "syntheses": ["barrier", "continuous_time", "dispersal_curve", "minimal_time", "other_extremal_time",
                  "other_extremals", "reachable_starts", "reached_part", "switching_crossing", "switching_curve", "switching_points",
                  "time_optimal_law"],
    "smoothing": ["boundary_decay", "bounded_misfit", "digits_lost", "filter_gain", "interpolant_acceleration", "multiple_eigenvalues",
                  "on_unit_circle", "reduced_polynomial", "spline_acceleration", "spline_misfit", "spline_positions",
                  "steady_costate", "transition_polynomial", "weight_for_bound", "weight_of_harmonic"],
    "transfers": ["fastest_control", "fastest_costate", "fastest_meeting", "fastest_motion", "fastest_switching", "fastest_time",
                  "isochrone_radius", "least_rate", "most_switchings", "reached_within", "slowest_control", "slowest_costate",
                  "slowest_meeting", "slowest_motion", "slowest_switching", "slowest_time", "switching_interval", "switchings",
                  "transfer_starts", "turning_rate"],
    "observations": ["bearing_tells_range", "bias_of_estimate", "breaks_bound", "condition_of_nearly_equal", "fooling_error",
                     "measured_motion", "modes_of_range", "most_rows", "numbers_seen", "range_error", "stations_insufficient",
                     "unseen_by_bearings", "unseen_direction", "unseen_motions", "worst_of_three"],
})
