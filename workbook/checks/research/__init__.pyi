# Written by `python -m workbook._stubs`.
from typing import Any

from workbook.checks.contract.verdict import Verdict

def bias_of_estimate(
    claim: Any,
    system: Any,
    unknowns: Any,
    estimated: Any,
    neglected: Any,
) -> Verdict:
    """Check the error of the estimate of the unknown `estimated` if `neglected` is set to zero."""

def bound_violating_error(claim: Any, matrix: Any, state: Any, factor: Any) -> Verdict:
    """Check a measurement error e that violates the bound mu |e| |x|/|Z| of |dx|."""

def boundary_decay(claim: Any, rho: Any, M: Any) -> Verdict:
    """Check the rate at which the influence of an end decays."""

def bounded_misfit(claim: Any, times: Any, samples: Any, rho: Any, D: Any) -> Verdict:
    """Check the least misfit rho sum (x_k - h_k)^2 among all motions with |u| <= D."""

def common_point_exists(answer: Any, sides: Any, bounds: Any) -> Verdict:
    """Check the condition for {p: sides p <= bounds} to have a point."""

def dependence_hiding_error(claim: Any, M: Any) -> Verdict:
    """Check the error of a column from which on the condition number is below M."""

def digits_lost(number: Any, transition: Any, kappa: Any, value: Any) -> Verdict:
    """Check by how many decimal digits the error of the forward recursion grows each sample."""

def filter_gain(claim: Any, omega: Any, rho: Any, M: Any) -> Verdict:
    """Check the factor g with which x = g cos(omega t) solves the filter equation."""

def greatest_distance(
    claim: Any,
    duration: Any,
    direction: Any,
    given: Any,
    final: Any = ...,
) -> Verdict:
    """Check how far a vehicle with the turning radius 1 comes in a direction."""

def greatest_magnitude(claim: Any, quantity: Any, box: Any) -> Verdict:
    """Check the greatest absolute value of a quantity in a box."""

def greatest_row_count(n: Any, m: Any, mu: Any, eps: Any) -> Verdict:
    """Check the greatest number n of rows with a condition number mu below the threshold mu*."""

def interpolant_quantity(
    claim: Any,
    quantity: Any,
    motion: Any,
    nodes: Any,
    level: Any,
    slope: Any = ...,
    places: Any = ...,
) -> Verdict:
    """Check a quantity of the polynomial that agrees with a motion at all nodes."""

def invariant_weights(claims: Any, signal: Any, nuisance: Any, functional: Any) -> Verdict:
    """Check the weights of least sum of squares that make an estimate unbiased."""

def multiple_eigenvalues(number: Any, transition: Any, kappa: Any) -> Verdict:
    """Check the kappa > 0 for which eigenvalues coincide, to three digits or exactly."""

def nearly_dependent_condition_number(claim: Any, delta: Any) -> Verdict:
    """Check the condition number of two columns along h and h + delta g."""

def observability_ranks(claims: Any, matrix: Any, sights: Any) -> Verdict:
    """Check how many combinations of the unknowns ranges along each direction determine."""

def range_error(claim: Any, relative: Any, t: Any, T: Any, turn: Any, delta: Any) -> Verdict:
    """Check the relative error of the range that a bearing error delta after the turn causes."""

def range_modes(claims: Any, matrix: Any, sight: Any, initial: Any, rate: Any, t: Any) -> Verdict:
    """Check the four coefficients of 1, t, cos(rate t), sin(rate t) in the deviation of a range."""

def range_observable(answer: Any, relative: Any, t: Any, T: Any, turn: Any) -> Verdict:
    """Check the condition that one bearing after the observer's turn determines the range."""

def section_meets(answer: Any, points: Any, directions: Any, sides: Any, bounds: Any) -> Verdict:
    """Check the condition for a section to have a point with sides p <= bounds."""

def section_values(
    claims: Any,
    points: Any,
    directions: Any,
    sides: Any = ...,
    bounds: Any = ...,
) -> Verdict:
    """Check the support function of a section in each direction."""

def spline_acceleration(
    claim: Any,
    times: Any,
    samples: Any,
    rho: Any = ...,
    M: Any = ...,
) -> Verdict:
    """Check the acceleration of the motion of least cost at the middle one of three samples."""

def spline_misfit(claim: Any, times: Any, samples: Any, rho: Any, D: Any) -> Verdict:
    """Check the misfit of the motion of least cost whose greatest acceleration is D."""

def spline_positions(claims: Any, times: Any, samples: Any, rho: Any, M: Any) -> Verdict:
    """Check the positions at the samples of the motion of least cost."""

def stations_insufficient(answer: Any, matrix: Any, first: Any, second: Any) -> Verdict:
    """Check the condition on two unit vectors for ranges along both to be insufficient."""

def support_values(claims: Any, sides: Any, bounds: Any, directions: Any) -> Verdict:
    """Check the support function of {p: sides p <= bounds} in each direction."""

def transition_polynomial(claim: Any, transition: Any, lam: Any, kappa: Any) -> Verdict:
    """Check the characteristic polynomial P(lambda) of a transition matrix."""

def unobservable_by_bearings(answer: Any, relative: Any, t: Any) -> Verdict:
    """Check a change of a uniform motion that changes no bearing to first order."""

def weight_for_bound(claim: Any, times: Any, samples: Any, rho: Any, D: Any) -> Verdict:
    """Check the weight M for which the motion of least cost has the greatest acceleration D."""

def weight_of_harmonic(claim: Any, amplitude: Any, omega: Any, rho: Any, D: Any) -> Verdict:
    """Check the weight M for which a reconstructed harmonic has the greatest acceleration D."""

def worst_case_error(
    claim: Any,
    system: Any,
    unknowns: Any,
    estimated: Any,
    tau: Any,
    delta: Any,
) -> Verdict:
    """Check the greatest error of the unknown `estimated` from three measurements with errors up to delta."""
