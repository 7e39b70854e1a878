"""Standard errors of a reconstructed motion: how errors of the samples go over into it.

For a given weight M the motion is a linear function of the samples, x(t) = sum_k L_k(t) h_k, and
L_k is the motion of a record that is 1 at t_k and 0 elsewhere. With independent errors of the
samples

    var x(t) = sum_k L_k(t)^2 sigma_k^2,

and so for velocity and acceleration with the derivatives of L_k. What the smoothing itself changes
in the true motion is no random error and not included.
"""

import numpy as np

from trajlib.reconstruction.splines import cubic_spline
from trajlib.reconstruction.sweep import SweepGains

#: Unit records that are reconstructed together.
BATCH = 256


def standard_deviations(inside, excess, t, sigma, effective, M):
    """Return standard deviations of position, velocity, acceleration, shape (3, times).

    The times are `excess` later than `inside`, a time of the record. The motion was found with the
    `effective` standard errors; the samples have the errors `sigma`.
    """
    variances = np.zeros((3, inside.size))
    for motion, errors in _unit_motions(t, sigma, effective, M):
        x, y, u = (motion(inside, order) for order in range(3))
        parts = x + excess[:, None] * y, y, np.where(excess[:, None] == 0, u, 0.0)
        variances += [(part * errors) ** 2 @ np.ones(errors.size) for part in parts]
    return np.sqrt(variances)


def _unit_motions(t, sigma, effective, M):
    """Yield the motions of some unit records and the errors of their samples."""
    measured = np.flatnonzero(np.isfinite(sigma))
    gains = SweepGains(t, effective, M) if M else None
    for first in range(0, measured.size, BATCH):
        part = measured[first : first + BATCH]
        units = np.zeros((t.size, part.size))
        units[part, np.arange(part.size)] = 1
        if gains is not None:
            yield cubic_spline(t, *gains.apply(units)), sigma[part]
        else:
            yield _interpolating(t[measured], units[measured]), sigma[part]


def _interpolating(t, h):
    """Return the natural spline through samples, uniform motion beyond them, as a function."""
    from scipy.interpolate import CubicSpline

    spline = CubicSpline(t, h, bc_type="natural")

    def motion(times, order):
        inside = np.clip(times, t[0], t[-1])
        past = (times - inside)[:, None]
        if order == 0:
            return spline(inside) + past * spline(inside, 1)
        return spline(inside, order) if order == 1 else np.where(past == 0, spline(inside, 2), 0.0)

    return motion
