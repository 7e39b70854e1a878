"""Equations with one small singular value: their solution along a curved valley.

Where a process may nearly begin at any time (a slow passage by a saddle), the residual r(z) hardly
changes along a curve, on which Newton's method takes ever shorter steps. With the singular vectors u
and v of the smallest singular value of r'(z), the equations

    r(z) + mu u = 0,   v^T z = t

determine z(t) and mu(t) well. The curve is followed, u and v being renewed at each point, to mu = 0.
"""

import numpy as np

# Smallest singular value, relative to the largest, at which there is a valley.
SMALL = 1e-4
# First and least longest step, and most steps.
FIRST, LEAST, STEPS = 0.2, 1e-4, 40
# Most corrections of a point, and how small the last one is; fewer than EASY lengthen the steps.
CORRECTIONS, CORRECTED, EASY = 8, 1e-9, 5
# Distance from the solution at which Newton's method takes over.
NEAR = 1e-4


def follow_valley(equations, z: np.ndarray) -> np.ndarray | None:
    """Return a point next to the solution on the valley through z; None if there is none.

    `equations.residual(z)` returns (r, r'), which must be square.
    """
    u, v, share = _softest(equations, z)
    if not share < SMALL:
        return None
    point, longest = _corrected(equations, z, u, v, 2 * CORRECTIONS), FIRST
    for _ in range(STEPS):
        if point is None or longest < LEAST:
            return None
        z, mu, tangent, slope, _ = point
        if abs(mu) < NEAR * abs(slope):
            return z
        step = np.clip(-mu / slope, -longest, longest) if slope else longest
        trial = _corrected(equations, z + step * tangent, u, v, CORRECTIONS)
        if trial is None:
            longest /= 2
            continue
        longest *= 1.5 if trial[-1] < EASY else 1
        u, v, _ = _softest(equations, trial[0])
        point = _corrected(equations, trial[0], u, v, CORRECTIONS)
    return None


def _softest(equations, z):
    """Return the singular vectors (u, v) of the smallest singular value, and its relative size.

    The size is infinite where r' is not square, or not finite.
    """
    _, J = equations.residual(z)
    if J.shape[0] != J.shape[1] or not np.isfinite(J).all():
        return z, z, np.inf
    left, values, right = np.linalg.svd(J)
    return left[:, -1], right[-1], values[-1] / values[0]


def _corrected(equations, z, u, v, most):
    """Return (z, mu, dz/dt, dmu/dt, corrections) on the valley at t = v^T z, or None."""
    t, mu, size = v @ z, 0.0, np.inf
    for count in range(most):
        if not np.all(z[equations.lengths] > 0):
            return None
        # Far from a solution values overflow: such a point is refused.
        with np.errstate(invalid="ignore"):
            r, J = equations.residual(z)
        if not (np.isfinite(r).all() and np.isfinite(J).all()):
            return None
        bordered = np.block([[J, u[:, None]], [v, np.zeros(1)]])
        right = np.stack([np.append(-r - mu * u, t - v @ z), np.append(0 * r, 1.0)], axis=1)
        try:
            step, tangent = np.linalg.solve(bordered, right).T
        except np.linalg.LinAlgError:
            return None
        z, mu, before, size = z + step[:-1], mu + step[-1], size, np.linalg.norm(step)
        if size < CORRECTED * (1 + np.linalg.norm(z)):
            return z, mu, tangent[:-1], tangent[-1], count
        if count > 2 and size > before:
            return None
    return None
