"""Largest displacement of a vehicle in a direction while it turns as fast as possible.

Let the heading differ from a direction phi by the angle d, 0 <= d <= pi, and turn at a rate of at
most kappa. Then at the time s the difference is at least max(d - kappa s, 0) =: x(s), so that

    cos(psi(s) - phi) <= c(s) = cos x(s),

with equality for all s at once if the vehicle turns towards phi as fast as possible and then goes
straight. The positive and negative parts c = c+ - c- have integrals in closed form, since x
decreases at the rate kappa until it is zero.
"""

import numpy as np


def cosine_parts(angle, rate, time):
    """Return the integrals of c+ and c- from 0 to `time`.

    `angle` = d may be negative; `rate` = kappa.

    Examples
    --------
    >>> import numpy as np
    >>> plus, minus = cosine_parts(np.pi, 1.0, np.pi)                     # a half turn
    >>> round(float(plus), 12), round(float(minus), 12)
    (1.0, 1.0)
    """
    angle_before, angle_after = np.maximum(angle, 0), np.maximum(angle - rate * time, 0)
    (ahead, behind), (ahead_after, behind_after) = _sines(angle_before), _sines(angle_after)
    return (ahead - ahead_after - (angle_before - angle_after)) / rate + time, (
        behind_after - behind
    ) / rate


def _sines(angle):
    """Return sines of the angles, but 1 in the first where obtuse, in the second where acute."""
    sine, acute = np.sin(angle), angle < np.pi / 2
    return np.where(acute, sine, 1.0), np.where(acute, 1.0, sine)


def angle_between(angle):
    """Return the angle between two directions that differ by `angle`, in [0, pi]."""
    return np.abs((np.asarray(angle) + np.pi) % (2 * np.pi) - np.pi)
