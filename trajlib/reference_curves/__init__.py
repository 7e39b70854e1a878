"""Reference integral curves: a solution as a formula in time, initial state and parameters.

The system x' = f(t, x, p), x(t_0) = x_0, with constant parameters p, is integrated once from every
node of a grid over x_0 and p. The curves are tabulated at nodes in time, and between all nodes the
table is interpolated by the tensor product of the fundamental polynomials of each axis,

    x(t, x_0, p) = sum_k sum_m x(t_k; x_{0,m}, p_m) L_k(t) prod_j L_{m_j}(x_0j) prod_i L_{m_i}(p_i),
    L_k(s) = prod_{q != k} (s - s_q)/(s_k - s_q).

These are (2.8)-(2.11) of the paper with a product over q in (2.11), where a sum is printed. Each
axis is evaluated in barycentric form; the derivative by time differentiates L_k(t). Source:
Bulychev (2020).

>>> from trajlib import reference_curves
>>> "ReferenceCurves" in dir(reference_curves)
True
"""

from trajlib._lazy import lazy_names

# No module has the name of an export: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "interpolation": ["TensorInterpolant", "chebyshev_nodes", "lebesgue_constant"],
    "curves": ["ReferenceCurves"],
    "residuals": ["Residual"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
