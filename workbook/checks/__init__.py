"""Checks of answers: they judge the defining property, never a stored answer.

`checks.report(name=checks.stability_region(name, ...))` is the last line of every check cell.
"""

import sys

from trajlib._lazy import lazy_names
from workbook.checks.contract import first_aid

__getattr__, __dir__, __all__ = lazy_names(__name__, {
    "contract.reporting": ["NotYet", "collecting", "report"],
    "contract.verdict": ["Unusable", "Verdict", "judged"],
    "stability.regions": ["stability_region"],
    "stability.equilibrium": ["equilibria", "spectra", "stable_equilibria"],
    "stability.first_approximation": ["first_approximation_unstable", "zero_stability"],
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
    "stability.programs": ["angle_deviations", "focus_parameters", "input_matrix_along", "linearisation",
        "node_parameters", "program_motion", "rest_angles", "rest_angles_exist", "saddle_angles", "stable_angles",
        "stable_rest_angles", "unstable_rest_angles"],
    "structure.observability": ["observable", "observable_parameters", "unobservable_parameters",
        "unseen_states", "unseen_where_lost"],
    "structure.controllability": ["controllability_matrix", "controllable", "controllable_parameters",
        "uncontrolled_combinations", "uncontrolled_where_lost"],
    "structure.eigenvalues": ["lost_eigenvalues"],
    "structure.mechanical": ["mechanical_roots"],
    "structure.canonical_forms": ["canonical_change", "canonical_matrix", "canonical_part_coordinates",
        "chain_basis_matrix"],
    "structure.decompositions": ["canonical_observable_part", "decomposed_system", "decomposition", "parallel_split",
        "sequential_split", "similarity"],
    "structure.mechanical_equations": ["mechanical_equations"],
    "structure.output_meaning": ["measured_quantity"],
    "structure.measurement_errors": ["amplitude_from_output", "augmented_system"],
    "structure.scalar_equations": ["canonical_coordinate", "scalar_equation"],
    "structure.time_varying": ["derivative_rows", "frozen_determinant", "measured_motion", "output_gramian"],
    "feedback.equations": ["equation_gains", "state_form"],
    "feedback.loops": ["estimate_gains", "feedback_gain", "observer_gain"],
    "feedback.margins": ["gain_region", "observer_obstacle", "possible_margins"],
    "feedback.equilibria": ["rest_gains"],
    "feedback.quadratic_costs": ["best_eigenvalues", "best_gain", "best_rest", "controller_equations", "cost_matrix",
        "cost_rate", "least_quadratic_cost", "steady_cost"],
    "feedback.observers": ["complete_model", "observer_equations"],
    "estimation.moments": ["correlation", "covariance", "expectations", "uncorrelated"],
    "estimation.least_squares": ["error_covariance", "least_squares", "least_sum"],
    "estimation.motions": ["correlation_motion", "covariance_exponents", "covariance_motion", "covariance_rises",
        "mean_motion", "settled_covariance", "settling_region", "shaping_equation", "state_by_noise"],
    "estimation.filters": ["error_eigenvalues", "estimate", "estimate_covariance", "estimate_deviations",
        "filter_equation", "riccati_equation", "steady_covariance", "steady_filter_exists", "steady_gain"],
    "pontryagin.maximum_principle": ["adjoint_equations", "extremal_control", "greatest_hamiltonian",
        "kelley_expression", "kelley_holds", "maximising_control", "pontryagin_function", "singular_control",
        "singular_costates", "singular_order", "singular_surface", "switching_function", "switching_rate",
        "transversality"],
    "pontryagin.control_equations": ["control_equation"],
    "pontryagin.processes": ["held_at_first", "optimal_control", "optimal_cost", "optimal_duration", "optimal_extent",
        "optimal_motion"],
    "pontryagin.duration_equations": ["duration_equation"],
    "pontryagin.costates": ["optimal_costate", "optimal_switching"],
    "pontryagin.optimal_laws": ["optimal_change", "optimal_law"],
    "pontryagin.syntheses": ["barrier", "continuous_time", "dispersal_curve", "minimal_time", "other_extremal_time",
        "other_extremals", "reachable_starts", "reached_part", "switching_crossing", "switching_curve",
        "switching_points", "time_optimal_law"],
    "pontryagin.transfers": ["isochrone_radius", "least_rate", "meeting_time", "most_switchings", "reached_within",
        "switching_interval", "switchings", "transfer_starts", "turning_rate"],
    "pontryagin.given_laws": ["end_under_law", "motion_under_law"],
    "pontryagin.functionals": ["best_motion", "best_motion_exists", "best_value", "stationary_duration"],
    "research.infosets": ["common_point", "support_values"],
    "research.interpolation": ["of_interpolant"],
    "research.invariance": ["invariant_weights"],
    "research.reconstruction": ["boundary_decay", "bounded_misfit", "digits_lost", "filter_gain",
        "multiple_eigenvalues", "spline_acceleration", "spline_misfit", "spline_positions", "transition_polynomial",
        "weight_for_bound", "weight_of_harmonic"],
    "research.solvability": ["bearing_tells_range", "bias_of_estimate", "breaks_bound", "condition_of_nearly_equal",
        "fooling_error", "modes_of_range", "most_rows", "numbers_seen", "range_error",
        "stations_insufficient", "unseen_by_bearings", "worst_of_three"],
})

# The first data or check cell of a notebook that runs imports this package: from then on its cells are watched.
_shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
if _shell is not None:
    first_aid.start(_shell)
