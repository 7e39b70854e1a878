"""Invariant unbiased estimation of a linear functional under a nuisance and noise.

N samples h = y + s + xi of a function y at the times t_n hold a nuisance s and noise xi with the
covariance matrix K. Known are a basis of either,

    y(t) = sum_k Y_k psi_k(t),      s(t) = sum_p c_p theta_p(t),

not the coefficients. Wanted is a number omega{y}: a value, a derivative, an integral. Among all
weights P the estimate P^T h takes those of least variance P^T K P that are

    unbiased, Psi P = o, o_k = omega{psi_k},        invariant, Theta P = 0,

with the matrices Psi (K x N) and Theta (M x N) of the samples of the functions, by rows.
(4.8)-(4.10) of the paper are

    P = Z Psi^T (Psi Z Psi^T)^{-1} o,    sigma^2 = o^T (Psi Z Psi^T)^{-1} o,
    Z = K^{-1} - K^{-1} Theta^T (Theta K^{-1} Theta^T)^{-1} Theta K^{-1}.

The computation uses orthogonal reflections instead of these inverses (`trajlib.invariant.weights`).
Source: Bulychev (2020), with Eliseev (2008).

>>> from trajlib import invariant
>>> "InvariantEstimator" in dir(invariant)
True
"""

from trajlib._lazy import lazy_names

# No module has the name of an export: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "functionals": ["derivative", "integral", "value"],
    "estimator": ["Estimate", "InvariantEstimator", "SlidingWindow"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
