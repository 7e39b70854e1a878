# Written by `python -m trajlib._stubs`.
from trajlib.estimation.bearing_fixes import BearingFix as BearingFix
from trajlib.estimation.bearing_fixes import bearing_fix as bearing_fix
from trajlib.estimation.continuous_discrete import ContinuousDiscreteRun as ContinuousDiscreteRun
from trajlib.estimation.continuous_discrete import Measurement as Measurement
from trajlib.estimation.continuous_discrete import filter_measurements as filter_measurements
from trajlib.estimation.continuous_filter import ContinuousFilter as ContinuousFilter
from trajlib.estimation.continuous_filter import ContinuousRun as ContinuousRun
from trajlib.estimation.correction import Correction as Correction
from trajlib.estimation.correction import corrected as corrected
from trajlib.estimation.covariances import Moments as Moments
from trajlib.estimation.discrete_filter import KalmanFilter as KalmanFilter
from trajlib.estimation.filter_run import FilterRun as FilterRun
from trajlib.estimation.fix_observability import FixTest as FixTest
from trajlib.estimation.fix_observability import bearing_observability as bearing_observability
from trajlib.estimation.fix_observability import satellite_observability as satellite_observability
from trajlib.estimation.fixed_gain import LeastGain as LeastGain
from trajlib.estimation.fixed_gain import error_covariance as error_covariance
from trajlib.estimation.fixed_gain import least_gain as least_gain
from trajlib.estimation.interpolation import OptimalWeights as OptimalWeights
from trajlib.estimation.interpolation import optimal_weights as optimal_weights
from trajlib.estimation.linear_fit import LeastSquares as LeastSquares
from trajlib.estimation.linear_fit import least_squares as least_squares
from trajlib.estimation.markov import DiscreteModel as DiscreteModel
from trajlib.estimation.markov import DrivenModel as DrivenModel
from trajlib.estimation.markov import continuous_moments as continuous_moments
from trajlib.estimation.markov import discrete_moments as discrete_moments
from trajlib.estimation.markov import discretise as discretise
from trajlib.estimation.markov import discretise_with_input as discretise_with_input
from trajlib.estimation.nonlinear_filters import ExtendedKalmanFilter as ExtendedKalmanFilter
from trajlib.estimation.nonlinear_filters import UnscentedKalmanFilter as UnscentedKalmanFilter
from trajlib.estimation.nonlinear_fit import GaussNewton as GaussNewton
from trajlib.estimation.nonlinear_fit import gauss_newton as gauss_newton
from trajlib.estimation.satellite_fixes import SatelliteFix as SatelliteFix
from trajlib.estimation.satellite_fixes import satellite_fix as satellite_fix
from trajlib.estimation.shaping import ShapedProcess as ShapedProcess
from trajlib.estimation.shaping import ShapingFilter as ShapingFilter
from trajlib.estimation.shaping import shaping_filter as shaping_filter
from trajlib.estimation.shaping import with_shaping as with_shaping
from trajlib.estimation.simulation import Consistency as Consistency
from trajlib.estimation.simulation import Paths as Paths
from trajlib.estimation.simulation import covariance_consistency as covariance_consistency
from trajlib.estimation.simulation import innovation_consistency as innovation_consistency
from trajlib.estimation.simulation import simulate_continuous as simulate_continuous
from trajlib.estimation.simulation import simulate_discrete as simulate_discrete
from trajlib.estimation.smoother import SmoothedRun as SmoothedRun
from trajlib.estimation.stationary_covariances import StationaryCovariance as StationaryCovariance
from trajlib.estimation.stationary_covariances import (
    discrete_stationary_covariance as discrete_stationary_covariance,
)
from trajlib.estimation.stationary_covariances import (
    stationary_covariance as stationary_covariance,
)
from trajlib.estimation.stationary_filters import StationaryFilter as StationaryFilter
from trajlib.estimation.stationary_filters import (
    discrete_stationary_filter as discrete_stationary_filter,
)
from trajlib.estimation.stationary_filters import stationary_filter as stationary_filter
