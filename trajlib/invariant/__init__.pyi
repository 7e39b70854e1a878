# Written by `python -m trajlib._stubs`.
from trajlib.invariant.estimator import Estimate as Estimate
from trajlib.invariant.estimator import InvariantEstimator as InvariantEstimator
from trajlib.invariant.estimator import SlidingWindow as SlidingWindow
from trajlib.invariant.functionals import derivative as derivative
from trajlib.invariant.functionals import integral as integral
from trajlib.invariant.functionals import value as value
