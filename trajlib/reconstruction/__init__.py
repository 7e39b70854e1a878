"""Reconstruction of a trajectory from noisy samples under an acceleration bound.

A point moves along a line, x' = y, y' = u, |u| <= D. Samples h_k of x with standard errors sigma_k
are given at the times t_0 < ... < t_N. With rho_k = 1/sigma_k^2 the motion minimises

    J = 1/2 sum_k rho_k (x(t_k) - h_k)^2 + M/2 integral u^2 dt,        both ends free,

and the weight M > 0 is chosen so that max |u| = D. The motion is a natural cubic spline (u is
linear between samples and vanishes at both ends), so max |u| is attained at a sample. Several
coordinates are separate problems. Source: Kirgetov and Chernousko (1995).

>>> from trajlib import reconstruction
>>> "reconstruct" in dir(reconstruction)
True
"""

from trajlib._lazy import lazy_names

# No module has the name of an export: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "fitting": ["Reconstruction", "reconstruct"],
    "sweep": ["SweepGains", "sweep_eigenvalues"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
