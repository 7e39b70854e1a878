"""How far a vehicle gets in a direction while it turns as fast as it may.

Let the heading differ from a direction phi by the angle d, 0 <= d <= pi, and turn at a rate of at
most kappa. Then at the time s the difference is at least max(d - kappa s, 0) =: x(s), so that

    cos(psi(s) - phi) <= c(s) = cos x(s),

with equality for all s at once if the vehicle turns towards phi as fast as it may and then goes
straight. Its positive and negative parts c = c+ - c- have integrals in closed form, since x falls
at the rate kappa until it is zero.
"""

import numpy as np


def cosine_parts(angle, rate, time):
    """Integrals of c+ and c- from 0 to `time`, two arrays; `angle` = d may be negative, `rate` =
    kappa.

    >>> import numpy as np
    >>> plus, minus = cosine_parts(np.pi, 1.0, np.pi)                     # a half turn
    >>> round(float(plus), 12), round(float(minus), 12)
    (1.0, 1.0)
    """
    first, last = np.maximum(angle, 0), np.maximum(angle - rate * time, 0)
    (ahead, behind), (ahead_then, behind_then) = _sines(first), _sines(last)
    return (ahead - ahead_then - (first - last)) / rate + time, (behind_then - behind) / rate


def _sines(angle):
    """Sines of the angles, but 1 in the first where they are obtuse, in the second where they are
    acute."""
    sine, acute = np.sin(angle), angle < np.pi / 2
    return np.where(acute, sine, 1.0), np.where(acute, 1.0, sine)


def apart(angle):
    """The angle between two directions that differ by `angle`, in [0, pi]."""
    return np.abs((np.asarray(angle) + np.pi) % (2 * np.pi) - np.pi)
