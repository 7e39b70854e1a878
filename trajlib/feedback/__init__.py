"""Observers and regulators of linear systems: chapter 3 and section 5.4 of the problem book.

The system is x' = Ax + Bu, z = Hx, the feedback u = Kx (plus sign), the observer e' = Ae + Bu + L(z
- He): closed loop A + BK, errors A - LH. Exact input gives exact output, also with symbols; NumPy
arrays, lists with a float in them and python-control's StateSpace give floating-point numbers. Every
name is loaded on first use, so that importing the package costs nothing.

>>> from trajlib import feedback
>>> "regulator" in dir(feedback)
True
"""

from trajlib._lazy import lazy_names

# No module is called like a name it exports: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "gains": ["GainFamily", "observer", "regulator"],
    "pole_placement": ["Placement", "place"],
    "trajlib.structure.fixed_spectrum": [
        "FixedSpectrum",
        "best_degree",
        "detectability",
        "stabilisability",
    ],
    "gain_regions": ["convergent_gains", "stabilising_gains"],
    "estimate_loop": ["EstimateLoop", "feedback_by_estimate"],
    "margins": ["LoopMargins", "loop_function", "loop_margins"],
    "reduced_order": ["ReducedObserver", "reduced_observer"],
    "discrete_cost": ["discrete_finite_lqr", "discrete_lqr"],
    "fixed_ends": ["FixedEndsControl", "StateAndControl", "fixed_ends_lqr"],
    "quadratic_cost": ["QuadraticRegulator", "finite_lqr", "lqr"],
    "stochastic_regulator": ["StochasticRegulator", "discrete_lqg", "lqg"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
