# Written by `python -m workbook._stubs`.
from typing import Any

from workbook.checks import research as research
from workbook.checks.contract.direction import hide_direction as hide_direction
from workbook.checks.contract.kept import kept_for_grading as kept_for_grading
from workbook.checks.contract.report import report as report
from workbook.checks.contract.reporting import NotYet as NotYet
from workbook.checks.contract.reporting import collecting as collecting
from workbook.checks.contract.verdict import Unusable as Unusable
from workbook.checks.contract.verdict import Verdict as Verdict
from workbook.checks.contract.verdict import judged as judged

def is_of_workbook(name: str) -> bool:
    """Return whether a name is taken."""

def adjoint_equations(claims: Any, problem: Any, costates: Any, domain: Any = ...) -> Verdict:
    """Check the right-hand sides of the adjoint equations with lambda_0 = 1."""

def amplitude_from_output(claim: Any, system: Any, outputs: Any, time: Any) -> Verdict:
    """Check C as an expression in z, its derivatives at one instant and the time."""

def angle_linearisation(
    claim: Any,
    field: Any,
    state: Any,
    parameters: Any,
    angle: Any,
    deviations: Any,
) -> Verdict:
    """Check the linearisation psi'' = ... at an equilibrium (angle, 0), linear in psi and psi'."""

def arc_transition_curve(
    claim: Any,
    problem: Any,
    change: Any,
    domain: Any,
    parameters: Any,
) -> Verdict:
    """Check the curve on which optimal controls change from one kind of arc to another."""

def asymptotic_stability_by_lyapunov(
    answer: Any,
    function: Any,
    field: Any,
    state: Any,
    parameters: Any,
) -> Verdict:
    """Check the parameters for which V proves asymptotic stability of zero (Theorem 1.5)."""

def augmented_system(answer: Any, system: Any, parameters: Any = ..., own: Any = ...) -> Verdict:
    """Check the system [A', H'] of x together with coordinates of the measurement error."""

def basin_estimate(
    condition: Any,
    function: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the largest set {V < c} that V proves to belong to the basin of attraction of zero."""

def basin_level(
    claim: Any,
    function: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the largest level c that V proves for the basin of attraction."""

def canonical_change(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the change of coordinates to the canonical form, with one output or one control."""

def canonical_coordinate(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the row c for which y = c x is the first coordinate of the canonical form (2.4)."""

def canonical_matrix(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the n x n matrix of the canonical form of a system."""

def canonical_observable_part(answer: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the observable subsystem [A11, H1] in the canonical form (2.5), H1 = (1 0 ... 0)."""

def canonical_part_coordinates(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the coordinates xi = F x of the observable part in the canonical form (2.5)."""

def chain_basis_matrix(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the matrix of a controllable system in the basis b, A b, ..., A^(n-1) b."""

def closed_loop_equations(
    claims: Any,
    field: Any,
    state: Any,
    controls: Any,
    desired: Any,
    H: Any,
    K: Any,
    L: Any,
    estimates: Any,
    time: Any,
) -> Verdict:
    """Check the right-hand sides for the state x and for the estimates e of its deviations."""

def conserved_quadratic_form(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    program: Any = ...,
    part: Any = ...,
) -> Verdict:
    """Check a positive definite quadratic form that is constant along all motions."""

def control_equation(claim: Any, problem: Any, domain: Any = ...) -> Verdict:
    """Check the right-hand side of u' = ... for a control inside its bounds that maximises H."""

def controllability_matrix(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the controllability matrix W = (B, A B, ..., A^(n-1) B) of Definition 2.4."""

def controllable(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check whether the system is controllable."""

def controllable_parameters(answer: Any, system: Any, parameters: Any) -> Verdict:
    """Check the condition on the parameters under which the system is controllable."""

def controller_equations(
    claim: Any,
    problem: Any,
    process: Any,
    estimates: Any,
    outputs: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the right-hand sides e' = ... of the best feedback by measurements."""

def correlation(
    claim: Any,
    first: Any,
    second: Any,
    vector: Any,
    law: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the correlation coefficient of two quantities."""

def correlation_at_time(
    claim: Any,
    process: Any,
    time: Any,
    of: Any,
    parameters: Any = ...,
    given: Any = ...,
    times: Any = ...,
) -> Verdict:
    """Check the correlation coefficient at the time t of two quantities, with the rows `of`."""

def cost_matrix(
    claim: Any,
    problem: Any,
    time: Any = ...,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the matrix S of the least cost from x, factor x^T S x."""

def cost_riccati_equation(claim: Any, problem: Any, cost: Any, parameters: Any = ...) -> Verdict:
    """Check the right-hand side of the Riccati equation S' = ... of the cost."""

def covariance(
    claim: Any,
    first: Any,
    second: Any,
    vector: Any,
    law: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the covariance of two quantities."""

def covariance_at_time(
    claim: Any,
    process: Any,
    time: Any,
    parameters: Any = ...,
    given: Any = ...,
    times: Any = ...,
) -> Verdict:
    """Check the covariance matrix of the process at the time t."""

def covariance_exponents(
    claim: Any,
    process: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the different l with e^(l t), in discrete time l^k, in the covariance of a process."""

def covariance_increases(answer: Any, process: Any, parameters: Any, given: Any = ...) -> Verdict:
    """Check the condition under which the variance of every combination increases all the time."""

def critical_stability(
    claim: Any,
    field: Any,
    state: Any,
    parameters: Any,
    program: Any = ...,
    part: Any = ...,
) -> Verdict:
    """Check whether x = 0 of a linear system is asymptotically stable, stable or unstable."""

def cycle_period(claim: Any, radial: Any, angular: Any, radius: Any, parameters: Any) -> Verdict:
    """Check the period of the closed orbit of r' = R(r), phi' = W(r)."""

def cycle_stability(answer: Any, field: Any, state: Any, radius: Any = ...) -> Verdict:
    """Check whether a limit cycle is stable, unstable or semistable."""

def decomposed_system(answer: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the system [A', H'] or [A', B'] in coordinates (xi; eta), as in (2.7) or (2.6)."""

def decomposition(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the change of variables of a decomposition into (xi; eta)."""

def dulac_function(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    domain: Any = ...,
) -> Verdict:
    """Check a pair (B, div(B f)) whose second member has one sign in the domain."""

def duration_equation(answer: Any, problem: Any, duration: Any, parameters: Any) -> Verdict:
    """Check an equation whose least positive root is the shortest duration."""

def eigenvalue_multiplicities(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    program: Any = ...,
    part: Any = ...,
) -> Verdict:
    """Check all eigenvalues as [value, algebraic multiplicity, geometric multiplicity]."""

def equation_gains(claim: Any, equation: Any) -> Verdict:
    """Check a state-space form with gains, the list [A, B, C, H, K, L]."""

def equilibria(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
    domain: Any = ...,
    zeros: Any = ...,
    kind: Any = ...,
) -> Verdict:
    """Check all equilibria in the domain, or those of a kind, as expressions in the parameters."""

def equilibrium_condition(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    domain: Any = ...,
    kind: Any = ...,
    angle: Any = ...,
) -> Verdict:
    """Check the parameters for which there is an equilibrium, one alone, or one of a kind."""

def equilibrium_gains(
    claim: Any,
    field: Any,
    state: Any,
    controls: Any,
    domain: Any = ...,
    zeros: Any = ...,
) -> Verdict:
    """Check pairs [y*, K] for all equilibria y* in the domain that need no control."""

def equilibrium_linearisation(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
    domain: Any = ...,
    given: Any = ...,
    integer: Any = ...,
    zeros: Any = ...,
) -> Verdict:
    """Check the matrices A of y' = A y that occur at the equilibria in the domain."""

def equilibrium_stability(
    claim: Any,
    field: Any,
    state: Any,
    parameters: Any,
    domain: Any = ...,
) -> Verdict:
    """Check whether the equilibrium is asymptotically stable, stable or unstable."""

def equilibrium_type(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
    domain: Any = ...,
) -> Verdict:
    """Check the type of the equilibrium of a planar system, the only one in the domain, or of all."""

def equilibrium_value(
    claim: Any,
    expression: Any,
    field: Any,
    state: Any,
    parameters: Any,
    domain: Any = ...,
) -> Verdict:
    """Check the value of an expression of the state at the equilibrium, the only one in the domain."""

def equilibrium_values(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
    given: Any = ...,
    integer: Any = ...,
    kind: Any = ...,
) -> Verdict:
    """Check the values x* of all equilibria x(t) = x* of an equation, or of those of a kind."""

def error_covariance(
    claim: Any,
    measured: Any,
    unknowns: Any,
    deviations: Any = ...,
    parameters: Any = ...,
) -> Verdict:
    """Check the covariance matrix of the errors of the estimate."""

def error_eigenvalues(claim: Any, process: Any, parameters: Any = ..., given: Any = ...) -> Verdict:
    """Check the different eigenvalues of the error matrix of the steady filter."""

def estimate(
    claim: Any,
    process: Any,
    measured: Any,
    at: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the best estimate of the state at a time from the measurements."""

def estimate_covariance(
    claim: Any,
    process: Any,
    measured: Any,
    at: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the covariance matrix of the errors of the best estimate at a time."""

def estimate_standard_deviations(
    claim: Any,
    process: Any,
    measured: Any,
    at: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the standard deviations of the errors of the best estimate at a time."""

def expectations(
    claims: Any,
    quantities: Any,
    vector: Any,
    law: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the means of quantities under the law {value: probability}."""

def extremal_control(
    answer: Any,
    problem: Any,
    time: Any,
    parameters: Any = ...,
    start: Any = ...,
) -> Verdict:
    """Check a control in time under which the maximum principle holds, optimal or not."""

def extremum_exists(claim: Any, functional: Any, duration: Any = ...) -> Verdict:
    """Check whether a functional has a best motion."""

def extremum_motion(claim: Any, functional: Any, parameters: Any = ...) -> Verdict:
    """Check the motion x(t) on which a functional is least, or greatest."""

def extremum_value(claim: Any, functional: Any, parameters: Any = ...) -> Verdict:
    """Check the least, or greatest, value of a functional, as an expression in the parameters."""

def feedback_gain(
    gain: Any,
    system: Any,
    parameters: Any = ...,
    given: Any = ...,
    degree: Any = ...,
    polynomial: Any = ...,
    symbol: Any = ...,
) -> Verdict:
    """Check a gain K of the feedback u = Kx, or an empty list if there is none."""

def filter_equation(
    claim: Any,
    process: Any,
    estimates: Any,
    outputs: Any,
    covariance: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the right-hand side y' = ... of the equation of the filter in continuous time."""

def final_value_under_law(
    claim: Any,
    quantity: Any,
    problem: Any,
    law: Any,
    time: Any,
    unknown: Any,
    parameters: Any,
) -> Verdict:
    """Check a final quantity in the final states, the constants of the law and the parameters."""

def first_integral(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    domain: Any = ...,
) -> Verdict:
    """Check a function of the state that is constant along the motions and not constant itself."""

def fixed_eigenvalues(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the different eigenvalues that are unobservable or, with a control, uncontrollable."""

def frozen_determinant(claim: Any, system: Any, parameters: Any) -> Verdict:
    """Check the determinant of the rows H(t), H(t) A, ..., H(t) A^(n-1) of one instant."""

def gain_margins(
    claims: Any,
    loop: Any,
    K: Any = ...,
    L: Any = ...,
    process: Any = ...,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the ends [low, high] of the interval of factors m > 0 of the control."""

def gain_region(answer: Any, system: Any, gain: Any, parameters: Any, degree: Any = ...) -> Verdict:
    """Check the condition on `parameters` under which the `gain` stabilises."""

def global_stability_by_lyapunov(
    answer: Any,
    function: Any,
    field: Any,
    state: Any,
    parameters: Any,
    given: Any = ...,
) -> Verdict:
    """Check the values of `parameters` for which V proves global asymptotic stability of zero."""

def growth_rate(
    claim: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the positive eigenvalue at the unstable equilibria."""

def initial_arc_duration(
    claim: Any,
    problem: Any,
    control: Any,
    value: Any,
    parameters: Any,
) -> Verdict:
    """Check how long the optimal process keeps a control at a value from the beginning."""

def input_matrix(
    claim: Any,
    field: Any,
    state: Any,
    parameters: Any,
    program: Any,
    controls: Any,
) -> Verdict:
    """Check the n x s matrix B of the deviation equations x' = A x + B w from a nominal motion."""

def isochrone_radius(claim: Any, problem: Any, duration: Any, count: Any) -> Verdict:
    """Check the radius of the circle of initial states whose least time is `duration`."""

def kelley_expression(
    claim: Any,
    problem: Any,
    costates: Any,
    control: Any = ...,
    domain: Any = ...,
) -> Verdict:
    """Check the left-hand side of the Kelley condition on singular arcs."""

def kelley_holds(
    claim: Any,
    problem: Any,
    costates: Any,
    control: Any = ...,
    domain: Any = ...,
) -> Verdict:
    """Check whether the Kelley condition holds on the singular arcs."""

def least_quadratic_cost(
    claim: Any,
    problem: Any,
    start: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the least cost from an initial state at the time 0, in its symbols."""

def least_rate(claim: Any, quantity: Any, problem: Any) -> Verdict:
    """Check the least rate of change of a quantity that an admissible control can give."""

def least_squares(
    claims: Any,
    measured: Any,
    unknowns: Any,
    deviations: Any = ...,
    parameters: Any = ...,
) -> Verdict:
    """Check the estimate of the unknowns, in their order."""

def least_sum_of_squares(
    claim: Any,
    measured: Any,
    unknowns: Any,
    deviations: Any = ...,
    parameters: Any = ...,
) -> Verdict:
    """Check the least value of the weighted sum of the squared residuals."""

def limit_cycles(answer: Any, field: Any, state: Any) -> Verdict:
    """Check the radii of all limit cycles that are circles around zero."""

def limit_state(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    start: Any,
    program: Any = ...,
    part: Any = ...,
) -> Verdict:
    """Check the limit of x(t) for t to infinity, a linear function of the initial state `start`."""

def linearisation(claim: Any, field: Any, state: Any, at: Any, parameters: Any = ...) -> Verdict:
    """Check the n x n matrix A of the deviation equations x' = A x + B w from the motion `at`."""

def linearisation_unstable(answer: Any, system: Any, parameters: Any) -> Verdict:
    """Check the parameters for which a linearisation has an eigenvalue with positive real part."""

def loop_margin(
    claim: Any,
    loop: Any,
    K: Any = ...,
    L: Any = ...,
    process: Any = ...,
    parameters: Any = ...,
    given: Any = ...,
    kind: Any = ...,
) -> Verdict:
    """Check the phase, delay or disk margin of a loop, as the `kind` says."""

def lyapunov_derivative(
    claim: Any,
    function: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the derivative of V along the motions of x' = f(x), in the state (Definition 1.4)."""

def maximised_hamiltonian(claim: Any, problem: Any, costates: Any, domain: Any = ...) -> Verdict:
    """Check the greatest value of H over the admissible controls with lambda_0 = 1."""

def maximising_control(answer: Any, problem: Any, costates: Any, domain: Any = ...) -> Verdict:
    """Check the control that maximises H, in states, costates and parameters."""

def mean_at_time(
    claim: Any,
    process: Any,
    time: Any,
    parameters: Any = ...,
    given: Any = ...,
    times: Any = ...,
) -> Verdict:
    """Check the mean of the process at the time t."""

def measured_output(
    claim: Any,
    system: Any,
    start: Any,
    time: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the output z(t) along the motion from an initial state."""

def measured_quantity(claim: Any, system: Any, known: Any, quantities: Any) -> Verdict:
    """Check which of the `quantities` {name: row} the measurement z = H x of x' = A x is."""

def mechanical_eigenvalues(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the different roots of det(M lambda^2 + D lambda + K), also complex ones."""

def mechanical_equations(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check the matrices [M, K, L] of the equations M q'' + K q = L u of a `Mechanical` system."""

def meeting_time(claim: Any, problem: Any, count: Any) -> Verdict:
    """Check the least, or greatest, time of the meeting number `count` with the target."""

def minimal_time(
    claim: Any,
    system: Any,
    target: Any,
    parameters: Any = ...,
    start: Any = ...,
) -> Verdict:
    """Check the shortest time to the target as an expression in the initial state."""

def minimal_time_continuous(
    answer: Any,
    system: Any,
    target: Any,
    ends: Any,
    variable: Any,
    parameters: Any,
    start: Any = ...,
) -> Verdict:
    """Check the values of a parameter for which the fastest time is continuous."""

def motion_under_law(
    claims: Any,
    problem: Any,
    law: Any,
    time: Any,
    parameters: Any,
    by: Any = ...,
) -> Verdict:
    """Check all states of the motion under a law as functions of time."""

def nominal_motion(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    program: Any,
    controls: Any,
    time: Any,
) -> Verdict:
    """Check a nominal motion and its controls as functions of time."""

def observability_matrix(claim: Any, system: Any, parameters: Any) -> Verdict:
    """Check the n x n matrix of the rows N0, ..., N(n-1) with z = N0 x, z' = N1 x, ..."""

def observable(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check whether z determines every initial state."""

def observable_parameters(answer: Any, system: Any, parameters: Any, part: Any = ...) -> Verdict:
    """Check the condition on the parameters under which the system is observable."""

def observer_equations(
    claims: Any,
    system: Any,
    estimates: Any,
    outputs: Any,
    controls: Any = ...,
    parameters: Any = ...,
    given: Any = ...,
    degree: Any = ...,
    polynomial: Any = ...,
    symbol: Any = ...,
) -> Verdict:
    """Check the right-hand sides of the equations of an observer of x' = Ax + Bu, z = Hx."""

def observer_feedback_gains(
    gains: Any,
    system: Any,
    parameters: Any = ...,
    given: Any = ...,
    degree: Any = ...,
) -> Verdict:
    """Check the gains [K, L] of a feedback u = K e by the estimate e of an observer."""

def observer_gain(
    gain: Any,
    system: Any,
    parameters: Any = ...,
    given: Any = ...,
    degree: Any = ...,
    polynomial: Any = ...,
    symbol: Any = ...,
) -> Verdict:
    """Check a gain L of an observer, or an empty list if there is none."""

def optimal_control(claim: Any, problem: Any, time: Any, parameters: Any = ...) -> Verdict:
    """Check the control of an optimal process."""

def optimal_cost(claim: Any, problem: Any, parameters: Any = ...) -> Verdict:
    """Check the cost of the optimal process, as an expression in the parameters."""

def optimal_costate(claims: Any, problem: Any, time: Any, parameters: Any = ...) -> Verdict:
    """Check costates along the optimal process with lambda_0 = 1."""

def optimal_duration(claim: Any, problem: Any, parameters: Any = ...) -> Verdict:
    """Check the duration of the optimal process, as an expression in the parameters."""

def optimal_eigenvalues(
    claim: Any,
    problem: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the different eigenvalues of A + BK under the law of least cost for infinite time."""

def optimal_gain(
    claim: Any,
    problem: Any,
    time: Any = ...,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the gain K of the law u = Kx of least cost."""

def optimal_law(answer: Any, problem: Any, parameters: Any, time: Any = ...) -> Verdict:
    """Check a law under which every initial state gives an optimal process."""

def optimal_limit_state(
    claim: Any,
    problem: Any,
    start: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the limit of the state under the law of least cost."""

def optimal_motion(claims: Any, problem: Any, time: Any, parameters: Any = ...) -> Verdict:
    """Check an optimal motion, all states as functions of time and parameters."""

def optimal_range(claim: Any, problem: Any, quantity: Any, parameters: Any = ...) -> Verdict:
    """Check the range of a quantity along the optimal process."""

def optimal_switching(claim: Any, problem: Any, time: Any) -> Verdict:
    """Check the switching function dH/du along a transfer to a line, with lambda_0 = 1."""

def other_extremal_exists(answer: Any, system: Any, target: Any, start: Any = ...) -> Verdict:
    """Check the condition on the initial state for an extremal that is not the fastest one."""

def other_extremal_time(claim: Any, system: Any, target: Any, start: Any = ...) -> Verdict:
    """Check the time that the extremal of `other_extremal_exists` takes, where there is one."""

def output_gramian(claim: Any, system: Any, duration: Any, parameters: Any) -> Verdict:
    """Check the n x n matrix G with x(0)^T G x(0) = integral of z^2 over 0 <= t <= `duration`."""

def parallel_decomposition(claim: Any, system: Any) -> Verdict:
    """Check new coordinates in parts, one for each component, the rest last."""

def parallel_system(answer: Any, system: Any) -> Verdict:
    """Check the system [A', H'] or [A', B'] in coordinates of a parallel decomposition."""

def phase_curve(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    through: Any,
    domain: Any = ...,
) -> Verdict:
    """Check the phase curve through given points of the border of the domain."""

def polar_angle_rate(claim: Any, problem: Any, angle: Any) -> Verdict:
    """Check the rate of the polar angle of a planar state, in the angle and the control."""

def polar_form(rates: Any, field: Any, state: Any, polar: Any) -> Verdict:
    """Check the pair (r', phi') of a planar system, in the polar coordinates `polar`."""

def pontryagin_function(claim: Any, problem: Any, costates: Any, domain: Any = ...) -> Verdict:
    """Check the Pontryagin function H with lambda_0 = 1."""

def possible_degrees(answer: Any, system: Any, mu: Any, parameters: Any = ...) -> Verdict:
    """Check the condition on mu > 0 under which the degree of stability mu can be attained."""

def radial_motion(claim: Any, field: Any, state: Any, time: Any, start: Any) -> Verdict:
    """Check the distance r(t) from zero of the motion with r(0) = r0."""

def rate_on_vanishing_set(
    answer: Any,
    function: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the rate of the last state variable on the set where V' vanishes."""

def reachable_in_time(answer: Any, problem: Any, duration: Any, parameters: Any) -> Verdict:
    """Check the condition for the target to be reached in a time not longer than `duration`."""

def reachable_initial_states(
    claim: Any,
    system: Any,
    target: Any,
    parameters: Any = ...,
    start: Any = ...,
) -> Verdict:
    """Check the condition on the initial state under which the target can be reached."""

def reached_target_points(
    answer: Any,
    system: Any,
    target: Any,
    ends: Any,
    variable: Any,
    parameters: Any = ...,
    start: Any = ...,
) -> Verdict:
    """Check the points of the target at which optimal motions end."""

def return_map_slope(claim: Any, field: Any, state: Any, radius: Any = ...) -> Verdict:
    """Check the slope of the return map r -> P(r) at a limit cycle."""

def riccati_equation(claim: Any, process: Any, covariance: Any, parameters: Any = ...) -> Verdict:
    """Check the right-hand side of the Riccati equation of the filter."""

def saddle_slopes(answer: Any, field: Any, state: Any) -> Verdict:
    """Check the slopes of the motions through the saddles of a second-order equation."""

def same_expression(claim: Any, reference: Any, parameters: Any = ..., given: Any = ...) -> Verdict:
    """Check an expression against the expression that is its reference."""

def same_matrix(claim: Any, reference: Any, parameters: Any = ..., given: Any = ...) -> Verdict:
    """Check a matrix against the matrix that is its reference, entry by entry."""

def same_value(claim: Any, reference: Any) -> Verdict:
    """Check a real number against the number that is its reference."""

def scalar_equation(
    answer: Any,
    system: Any,
    motion: Any,
    control: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the equation of order n between the control and y."""

def sequential_decomposition(claim: Any, system: Any) -> Verdict:
    """Check new coordinates in parts that the components determine one after the other."""

def shaping_filter(claims: Any, process: Any, parameters: Any = ..., given: Any = ...) -> Verdict:
    """Check the shaping filter [a, Q, D] of the noise of a `Coloured` process."""

def similarity_matrix(claim: Any, system: Any, other: Any, parameters: Any = ...) -> Verdict:
    """Check a matrix S of y = S x that turns x' = A x into the `other` system y' = A' y."""

def singular_control(
    claim: Any,
    problem: Any,
    costates: Any,
    control: Any = ...,
    domain: Any = ...,
) -> Verdict:
    """Check the control on singular arcs, in states and parameters."""

def singular_costates(
    claims: Any,
    problem: Any,
    costates: Any,
    control: Any = ...,
    domain: Any = ...,
) -> Verdict:
    """Check the costates with lambda_0 = 1 as long as one control is singular."""

def singular_order(claim: Any, problem: Any, costates: Any, control: Any = ...) -> Verdict:
    """Check the order q of the singular arcs."""

def singular_surface(
    answer: Any,
    problem: Any,
    costates: Any,
    control: Any = ...,
    domain: Any = ...,
) -> Verdict:
    """Check the surface of the singular arcs in states and parameters."""

def spectra(answer: Any, field: Any, state: Any) -> Verdict:
    """Check the eigenvalues of the linearisation at every equilibrium."""

def stability_region(answer: Any, system: Any, parameters: Any, degree: Any = ...) -> Verdict:
    """Check the parameters for which every root has real part below `-degree`."""

def stable_parameters(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    program: Any = ...,
    part: Any = ...,
) -> Verdict:
    """Check the parameters for which x = 0 of a linear system is stable."""

def state_after_steps(
    claim: Any,
    process: Any,
    start: Any,
    noises: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the state of a process in discrete time after as many steps as there are noises."""

def state_space_form(claim: Any, equation: Any) -> Verdict:
    """Check a state-space form [A, B, C, H] of one equation."""

def stationary_covariance(
    claim: Any,
    process: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the covariance matrix that the process converges to from every initial covariance."""

def stationary_covariance_exists(
    answer: Any,
    process: Any,
    parameters: Any,
    given: Any = ...,
) -> Verdict:
    """Check the parameters for which the covariance converges whatever it is initially."""

def stationary_duration(claim: Any, functional: Any, duration: Any) -> Verdict:
    """Check a duration at which the best value of a functional is stationary, optimal or not."""

def steady_cost(
    claim: Any,
    problem: Any,
    process: Any,
    parameters: Any = ...,
    given: Any = ...,
) -> Verdict:
    """Check the least limit of factor E[x^T G x + u^T N u] with a noise that drives the system."""

def steady_covariance(
    claim: Any,
    process: Any,
    parameters: Any = ...,
    given: Any = ...,
    moment: Any = ...,
) -> Verdict:
    """Check the covariance matrix of the errors of the steady filter."""

def steady_filter_exists(answer: Any, process: Any, parameters: Any) -> Verdict:
    """Check the condition under which there is a steady filter whose errors decay."""

def steady_gain(claim: Any, process: Any, parameters: Any = ..., given: Any = ...) -> Verdict:
    """Check the gain K of the steady filter, a column for each measurement."""

def steps(answer: Any) -> Verdict:
    """Check that each step of a chain follows from the one before it."""

def switching_count(answer: Any, problem: Any, parameters: Any = ...) -> Verdict:
    """Check how often the fastest control switches, as an expression in the parameters."""

def switching_curve(
    claim: Any,
    system: Any,
    target: Any,
    domain: Any,
    parameters: Any = ...,
    start: Any = ...,
    kind: Any = ...,
) -> Verdict:
    """Check a curve of a time-optimal synthesis over the interval that `domain` gives."""

def switching_curve_crossing(
    claim: Any,
    system: Any,
    target: Any,
    ends: Any,
    variable: Any,
    parameters: Any = ...,
    start: Any = ...,
) -> Verdict:
    """Check the determinants of (dP/ds, velocity) on the switching curve P(s), [before, after]."""

def switching_function(
    claim: Any,
    problem: Any,
    costates: Any,
    control: Any = ...,
    domain: Any = ...,
) -> Verdict:
    """Check the switching function dH/du, up to a positive factor."""

def switching_interval(claim: Any, problem: Any, parameters: Any) -> Verdict:
    """Check the time between two switchings of fastest controls, where it is always the same."""

def switching_points(
    claim: Any,
    system: Any,
    target: Any,
    ends: Any,
    variable: Any,
    parameters: Any = ...,
    start: Any = ...,
) -> Verdict:
    """Check the switching curve [x1, x2] by the end points of the optimal motions."""

def switching_rate(
    claim: Any,
    problem: Any,
    costates: Any,
    control: Any = ...,
    domain: Any = ...,
) -> Verdict:
    """Check the time derivative of dH/du along the trajectories and the adjoint equations."""

def time_optimal_law(
    claim: Any,
    system: Any,
    target: Any,
    parameters: Any = ...,
    start: Any = ...,
    curve: Any = ...,
) -> Verdict:
    """Check a time-optimal law u(state)."""

def transferable_initial_states(answer: Any, problem: Any, parameters: Any) -> Verdict:
    """Check the initial states, or parameters, for which the target can be reached."""

def transversality(answer: Any, problem: Any, costates: Any) -> Verdict:
    """Check the transversality conditions at the end of the process, with lambda_0 = 1."""

def unbounded_motion(
    answer: Any,
    field: Any,
    state: Any,
    parameters: Any,
    time: Any,
    constants: Any = ...,
    program: Any = ...,
    part: Any = ...,
) -> Verdict:
    """Check a motion x(t) of x' = A x that grows without bound and so proves instability."""

def uncontrollable_combinations(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check a basis of the rows w whose combinations w x no control changes."""

def uncontrollable_combinations_at(claim: Any, system: Any, parameter: Any) -> Verdict:
    """Check the parameter values without controllability, as {value: basis of the rows w}."""

def uncorrelated(
    claims: Any,
    first: Any,
    second: Any,
    vector: Any,
    law: Any,
    angle: Any,
) -> Verdict:
    """Check all angles at which two quantities, linear in the vector, are not correlated."""

def undetectable_mode(claim: Any, system: Any, parameters: Any = ...) -> Verdict:
    """Check a motion that excludes an asymptotic observer, {lambda: v}; {} if there is none."""

def unobservable_parameters(answer: Any, system: Any, parameters: Any) -> Verdict:
    """Check the condition on the parameters under which the system is not observable."""

def unobservable_states(
    claim: Any,
    system: Any,
    parameters: Any = ...,
    start: Any = ...,
) -> Verdict:
    """Check a basis of the initial states whose motions give z = 0 for all time."""

def unobservable_states_at(claim: Any, system: Any, parameter: Any) -> Verdict:
    """Check the parameter values without observability, as {value: basis of initial states}."""

def vanishing_set(
    answer: Any,
    function: Any,
    field: Any,
    state: Any,
    parameters: Any = ...,
) -> Verdict:
    """Check the set of states where the derivative of V along the motions is zero."""

def zero_solution_stability(claim: Any, field: Any, state: Any) -> Verdict:
    """Check whether x = 0 is asymptotically stable, stable or unstable."""
