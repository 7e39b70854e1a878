"""Checks of answers: they judge the defining property, never a stored answer.

`checks.report(name=checks.stability_region(name, ...))` is the last line of every check cell.
"""

import sys

from trajlib._lazy import lazy_names
from trajlib.checks.contract import first_aid

__getattr__, __dir__, __all__ = lazy_names(__name__, {
    "contract.reporting": ["NotYet", "collecting", "report"],
    "contract.verdict": ["Unusable", "Verdict", "judged"],
    "stability.regions": ["stability_region", "stable_equation"],
    "stability.equilibrium": ["equilibria", "spectra", "stable_equilibria"],
    "stability.first_approximation": ["first_approximation_stable", "first_approximation_unstable", "linearisation",
        "zero_stability"],
    "stability.lyapunov": ["basin_estimate", "basin_level", "departure", "lyapunov_derivative", "proved_global",
        "proved_stable", "vanishing_set"],
    "stability.rest_families": ["deviation_matrices", "growth_rate", "rest_kinds", "rest_values", "saddle_slopes",
        "single_rest", "stable_rest_values", "unstable_rest_values"],
    "stability.stationary": ["cycle_exists", "cycle_period", "cycle_radius", "dulac", "first_integral", "focus_region",
        "node_region", "nullcline", "phase_curve", "stationary_exists", "stationary_linearisation", "stationary_points",
        "stationary_stability", "stationary_type", "stationary_value"],
    "stability.cycles": ["cycle_stability", "limit_cycles", "polar_form", "radial_motion", "return_slope"],
    "stability.critical": ["conserved_form", "critical_stability", "eigenvalue_multiplicities", "growing_motion",
        "limit_state", "stable_parameters"],
    "stability.programs": ["angle_deviations", "focus_parameters", "input_matrix_along", "linearisation_along",
        "node_parameters", "program_motion", "rest_angles", "rest_angles_exist", "saddle_angles", "stable_angles",
        "stable_rest_angles", "unstable_rest_angles"],
    "structure.observability": ["lost_eigenvalues", "observable", "observable_parameters",
        "unobservable_parameters", "unseen_states", "unseen_where_lost"],
    "structure.controllability": ["controllability_matrix", "controllable", "controllable_parameters",
        "uncontrolled_combinations", "uncontrolled_eigenvalues", "uncontrolled_where_lost"],
    "structure.mechanical": ["mechanical_controllable", "mechanical_controllable_parameters",
        "mechanical_lost_eigenvalues", "mechanical_observable", "mechanical_roots",
        "mechanical_uncontrolled_eigenvalues", "mechanical_unseen_states"],
    "structure.canonical_forms": ["canonical_part_coordinates", "chain_basis_matrix", "controller_canonical_basis",
        "controller_canonical_matrix", "observer_canonical_matrix", "observer_canonical_transformation"],
    "structure.decompositions": ["canonical_observable_part", "controllability_split", "controllability_split_system",
        "observability_split", "observability_split_system", "parallel_inputs", "parallel_outputs",
        "sequential_inputs", "sequential_outputs", "similarity"],
    "structure.local_observability": ["locally_determined", "unseen_changes"],
    "structure.mechanical_equations": ["mechanical_equations"],
    "structure.deviation_models": ["change_to_deviations", "measured_quantity"],
    "structure.output_meaning": ["measured_coordinate"],
    "structure.measurement_errors": ["amplitude_found_parameters", "amplitude_from_output", "augmented_system",
        "observable_with_error", "observable_with_error_parameters", "state_found_parameters", "unseen_with_error",
        "unseen_with_error_where_lost"],
    "structure.scalar_equations": ["canonical_coordinate", "canonical_equation", "scalar_equation"],
    "structure.time_varying": ["derivative_rows", "frozen_determinant", "output_gramian",
        "varying_observable_parameters", "varying_output", "varying_unseen_where_lost"],
    "feedback.equations": ["equation_gains", "equation_margins", "equation_region", "state_form"],
    "feedback.loops": ["estimate_gains", "feedback_gain", "observer_gain"],
    "feedback.margins": ["estimate_margins", "feedback_margins", "feedback_region",
        "observer_margins", "observer_obstacle", "observer_region"],
    "feedback.equilibria": ["rest_gains"],
    "feedback.observers": ["complete_model", "observer_equations"],
    "estimation.moments": ["correlation", "covariance", "covariance_matrix", "expectations", "uncorrelated"],
    "estimation.least_squares": ["error_covariance", "least_squares", "least_sum"],
    "estimation.motions": ["correlation_motion", "covariance_exponents", "covariance_motion", "covariance_rises",
        "mean_motion", "settled_covariance", "settling_region", "shaping_equation", "state_by_noise"],
    "estimation.filters": ["covariance_with_gain", "decaying_gains", "error_eigenvalues", "estimate",
        "estimate_covariance", "estimate_deviations", "filter_equation", "riccati_equation",
        "steady_covariance", "steady_filter_exists", "steady_gain"],
    "pontryagin.processes": ["optimal_control", "optimal_cost", "optimal_costate", "optimal_duration",
        "optimal_motion"],
    "pontryagin.optimal_laws": ["optimal_change", "optimal_law"],
    "pontryagin.syntheses": ["barrier", "continuous_time", "dispersal_curve", "minimal_time", "other_extremal_time",
        "other_extremals", "reachable_starts", "reached_part", "switching_crossing", "switching_curve",
        "switching_points", "time_optimal_law"],
    "pontryagin.transfers": ["fastest_control", "fastest_costate", "fastest_meeting", "fastest_motion",
        "fastest_switching", "fastest_time", "isochrone_radius", "least_rate", "most_switchings", "reached_within",
        "slowest_control", "slowest_costate", "slowest_meeting", "slowest_motion", "slowest_switching", "slowest_time",
        "switching_interval", "switchings", "transfer_starts", "turning_rate"],
    "pontryagin.functionals": ["best_motion", "best_motion_exists", "best_value", "stationary_duration"],
    "research.reconstruction": ["boundary_decay", "bounded_misfit", "digits_lost", "filter_gain",
        "interpolant_acceleration", "multiple_eigenvalues", "on_unit_circle", "reduced_polynomial",
        "spline_acceleration", "spline_misfit", "spline_positions", "steady_costate", "transition_polynomial",
        "weight_for_bound", "weight_of_harmonic"],
    "research.solvability": ["bearing_tells_range", "bias_of_estimate", "breaks_bound", "condition_of_nearly_equal",
        "fooling_error", "measured_motion", "modes_of_range", "most_rows", "numbers_seen", "range_error",
        "stations_insufficient", "unseen_by_bearings", "unseen_direction", "unseen_motions", "worst_of_three"],
})

# The data cell of a notebook imports this package: from then on its cells are watched.
_shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
if _shell is not None:
    first_aid.start(_shell)
