"""Checks of answers: they judge the defining property, never a stored answer.

`checks.report(name=checks.stability_region(name, ...))` is the last line of every check cell. Besides
the checks listed here it calls those in the `checks.py` of the course that is here (`course_checks`).
"""

import sys
from importlib.util import find_spec

from trajlib._lazy import lazy_names
from workbook.checks import research as research  # `checks.research.*`, lazy itself
from workbook.checks.contract import cell_watch
from workbook.checks.contract.former_checks import FORMER, former_check

_present, __dir__, __all__ = lazy_names(
    __name__,
    {
        "contract.reporting": ["NotYet", "collecting"],
        "contract.report": ["report"],
        "contract.direction": ["hide_direction"],
        "contract.kept": ["kept_for_grading"],
        "contract.verdict": ["Unusable", "Verdict", "judged"],
        "algebra.same": ["same_expression", "same_matrix", "same_value"],
        "algebra.steps": ["steps"],
        "stability.regions": ["stability_region"],
        "stability.equilibria": ["equilibria"],
        "stability.equilibrium_conditions": ["equilibrium_condition"],
        "stability.equilibrium_linearisations": [
            "angle_linearisation",
            "equilibrium_linearisation",
            "equilibrium_value",
            "spectra",
        ],
        "stability.equilibrium_types": [
            "equilibrium_stability",
            "equilibrium_type",
            "saddle_slopes",
        ],
        "stability.equilibrium_values": ["equilibrium_values", "growth_rate"],
        "stability.linearisation": ["linearisation_unstable", "zero_solution_stability"],
        "stability.lyapunov": [
            "asymptotic_stability_by_lyapunov",
            "global_stability_by_lyapunov",
            "lyapunov_derivative",
            "rate_on_vanishing_set",
            "vanishing_set",
        ],
        "stability.cycles": [
            "cycle_period",
            "cycle_stability",
            "limit_cycles",
            "polar_form",
            "radial_motion",
            "return_map_slope",
        ],
        "stability.critical": [
            "conserved_quadratic_form",
            "critical_stability",
            "eigenvalue_multiplicities",
            "limit_state",
            "stable_parameters",
            "unbounded_motion",
        ],
        "stability.nominal_motions": ["input_matrix", "linearisation", "nominal_motion"],
        "stability.basins": ["basin_estimate", "basin_level"],
        "stability.phase_plane": ["dulac_function", "first_integral", "phase_curve"],
        "structure.observability": [
            "observable",
            "observable_parameters",
            "unobservable_parameters",
            "unobservable_states",
            "unobservable_states_at",
        ],
        "structure.controllability": [
            "controllability_matrix",
            "controllable",
            "controllable_parameters",
            "uncontrollable_combinations",
            "uncontrollable_combinations_at",
        ],
        "structure.eigenvalues": ["fixed_eigenvalues"],
        "structure.mechanical": ["mechanical_eigenvalues"],
        "structure.canonical_forms": [
            "canonical_change",
            "canonical_matrix",
            "canonical_part_coordinates",
            "chain_basis_matrix",
        ],
        "structure.decompositions": [
            "canonical_observable_part",
            "decomposed_system",
            "decomposition",
            "similarity_matrix",
        ],
        "structure.mechanical_equations": ["mechanical_equations"],
        "structure.output_meaning": ["measured_quantity"],
        "structure.measurement_errors": ["amplitude_from_output", "augmented_system"],
        "structure.scalar_equations": ["canonical_coordinate", "scalar_equation"],
        "structure.time_varying": [
            "frozen_determinant",
            "measured_output",
            "observability_matrix",
            "output_gramian",
        ],
        "structure.component_decompositions": [
            "parallel_decomposition",
            "parallel_system",
            "sequential_decomposition",
        ],
        "feedback.equations": ["equation_gains", "state_space_form"],
        "feedback.loops": ["feedback_gain", "observer_feedback_gains", "observer_gain"],
        "feedback.margins": ["gain_region", "possible_degrees", "undetectable_mode"],
        "feedback.equilibria": ["equilibrium_gains"],
        "feedback.quadratic_costs": [
            "controller_equations",
            "cost_matrix",
            "cost_riccati_equation",
            "least_quadratic_cost",
            "optimal_eigenvalues",
            "optimal_gain",
            "optimal_limit_state",
            "steady_cost",
        ],
        "feedback.robustness": ["gain_margins", "loop_margin"],
        "feedback.observers": ["closed_loop_equations", "observer_equations"],
        "estimation.moments": ["correlation", "covariance", "expectations", "uncorrelated"],
        "estimation.least_squares": ["error_covariance", "least_squares", "least_sum_of_squares"],
        "estimation.process_moments": [
            "correlation_at_time",
            "covariance_at_time",
            "covariance_exponents",
            "covariance_increases",
            "mean_at_time",
            "shaping_filter",
            "state_after_steps",
            "stationary_covariance",
            "stationary_covariance_exists",
        ],
        "estimation.filters": [
            "error_eigenvalues",
            "estimate",
            "estimate_covariance",
            "estimate_standard_deviations",
            "filter_equation",
            "riccati_equation",
            "steady_covariance",
            "steady_filter_exists",
            "steady_gain",
        ],
        "pontryagin.maximum_principle": [
            "adjoint_equations",
            "maximised_hamiltonian",
            "maximising_control",
            "pontryagin_function",
            "switching_function",
            "switching_rate",
        ],
        "pontryagin.control_equations": ["control_equation"],
        "pontryagin.duration_equations": ["duration_equation"],
        "pontryagin.costates": ["optimal_costate", "optimal_switching"],
        "pontryagin.optimal_laws": ["arc_transition_curve", "optimal_law"],
        "pontryagin.syntheses": ["minimal_time", "reachable_initial_states", "time_optimal_law"],
        "pontryagin.transfers": [
            "isochrone_radius",
            "least_rate",
            "meeting_time",
            "polar_angle_rate",
            "reachable_in_time",
            "switching_count",
            "switching_interval",
            "transferable_initial_states",
        ],
        "pontryagin.given_laws": ["final_value_under_law", "motion_under_law"],
        "pontryagin.functionals": [
            "extremum_exists",
            "extremum_motion",
            "extremum_value",
            "stationary_duration",
        ],
        "pontryagin.extremal_controls": ["extremal_control"],
        "pontryagin.line_extremals": ["other_extremal_exists", "other_extremal_time"],
        "pontryagin.optimal_controls": ["optimal_control"],
        "pontryagin.optimal_motions": ["optimal_motion"],
        "pontryagin.optimal_values": [
            "initial_arc_duration",
            "optimal_cost",
            "optimal_duration",
            "optimal_range",
        ],
        "pontryagin.singular_arcs": [
            "kelley_expression",
            "kelley_holds",
            "singular_control",
            "singular_costates",
            "singular_order",
            "singular_surface",
        ],
        "pontryagin.switching_curves": ["switching_curve"],
        "pontryagin.target_points": [
            "minimal_time_continuous",
            "reached_target_points",
            "switching_curve_crossing",
            "switching_points",
        ],
        "pontryagin.transversality": ["transversality"],
    },
)


def is_of_workbook(name):
    """Return whether a name is of this package, so that no check of a course's own may have it."""
    return (
        name.startswith("_")
        or name in {*__dir__(), *FORMER}
        or find_spec(f"{__name__}.{name}") is not None  # asked for by `from workbook.checks import`
    )


def __getattr__(name):
    if name in FORMER:
        return former_check(name, _present)
    if is_of_workbook(name):
        return _present(name)
    from workbook.checks.course_checks import own_check  # few notebooks need one

    return own_check(name)


# The first data or check cell of a notebook that runs imports this package: from then on its cells
# are watched.
_shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
if _shell is not None:
    cell_watch.start(_shell)
