"""Estimation in stochastic systems: chapter 4 of the problem book as functions.

Exact input gives exact output, also with symbols; as soon as one of the arguments is a NumPy array,
a list with a float in it or python-control's StateSpace, all is computed in floats. A scalar stands
for a 1 x 1 matrix. Every name is loaded on first use, so that importing the package costs nothing.

>>> from trajlib import estimation
>>> "least_squares" in dir(estimation)
True
"""

from trajlib._lazy import lazy_names

# No module is called like a name it exports: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "covariances": ["Moments"],
    "linear_fit": ["LeastSquares", "least_squares"],
    "nonlinear_fit": ["GaussNewton", "gauss_newton"],
    "fix_observability": ["FixTest", "bearing_observability", "satellite_observability"],
    "satellite_fixes": ["SatelliteFix", "satellite_fix"],
    "bearing_fixes": ["BearingFix", "bearing_fix"],
    "markov": [
        "DiscreteModel",
        "DrivenModel",
        "continuous_moments",
        "discrete_moments",
        "discretise",
        "discretise_with_input",
    ],
    "stationary_covariances": [
        "StationaryCovariance",
        "discrete_stationary_covariance",
        "stationary_covariance",
    ],
    "correction": ["Correction", "corrected"],
    "discrete_filter": ["KalmanFilter"],
    "filter_run": ["FilterRun"],
    "nonlinear_filters": ["ExtendedKalmanFilter", "UnscentedKalmanFilter"],
    "smoother": ["SmoothedRun"],
    "continuous_filter": ["ContinuousFilter", "ContinuousRun"],
    "continuous_discrete": ["ContinuousDiscreteRun", "Measurement", "filter_measurements"],
    "stationary_filters": ["StationaryFilter", "discrete_stationary_filter", "stationary_filter"],
    "fixed_gain": ["LeastGain", "error_covariance", "least_gain"],
    "shaping": ["ShapedProcess", "ShapingFilter", "shaping_filter", "with_shaping"],
    "interpolation": ["OptimalWeights", "optimal_weights"],
    "simulation": [
        "Consistency",
        "Paths",
        "covariance_consistency",
        "innovation_consistency",
        "simulate_continuous",
        "simulate_discrete",
    ],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
