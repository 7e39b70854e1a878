"""Robust weights: residuals beyond some standard errors count linearly (Huber), not by squares.

The cost with Huber's function of the residuals is convex, and its minimum is that of weighted
squares with the weights w_k = min(1, c sigma_k/|x(t_k) - h_k|) of the minimum itself. So the motion
is reconstructed again and again with standard errors sigma_k/sqrt(w_k), until the weights stay.
"""

import numpy as np

#: Reconstructions at most, and the change of the weights at which they end.
ROUNDS, SETTLED = 200, 1e-6


def robust_fit(fit, t, h, sigma, bound):
    """Return the fit of `fit(effective standard errors)` at the fixed point, and the weights."""
    weights, measured = np.ones(t.size), np.isfinite(sigma)
    for _ in range(ROUNDS):
        result = fit(sigma / np.sqrt(weights))
        residuals = np.abs(result[0](t) - np.where(measured, h, 0))[measured] / sigma[measured]
        update = np.ones(t.size)
        update[measured] = bound / np.maximum(residuals, bound)
        change, weights = np.abs(update - weights).max(), update
        if change < SETTLED:
            return result, weights
    raise ArithmeticError(
        f"robust: the weights still change by {change:.1g} after {ROUNDS} reconstructions; take a "
        "larger number of standard errors, or M instead of max_acceleration"
    )
