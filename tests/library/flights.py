"""True motions of the planar vehicle for tests, independent of the library, exact to rounding."""

import numpy as np

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(16)


def fly(start, pieces, k):
    """States (x, y, psi, V) at the start and after each piece (duration, u, w) of constant
    controls.

    V is linear, psi a logarithm of it; x and y are integrals by Gauss's rule with 16 points a
    piece, which for turns of less than a radian is exact to rounding."""
    states = [np.array(start, dtype=float)]
    for duration, u, w in pieces:
        x, y, psi, V = states[-1]

        def heading(s):
            return psi + (k * u / w * np.log1p(w * s / V) if w else k * u * s / V)

        s = duration * (POINTS + 1) / 2
        lengths = duration / 2 * WEIGHTS * (V + w * s)
        states.append(
            np.array(
                [
                    x + lengths @ np.sin(heading(s)),
                    y + lengths @ np.cos(heading(s)),
                    heading(duration),
                    V + w * duration,
                ]
            )
        )
    return np.array(states)


def seconds(*phases):
    """Pieces of one second: phases are (seconds, u, w)."""
    return [(1.0, u, w) for count, u, w in phases for _ in range(count)]


#: The motion of the paper's section 5: straight ahead, a turn to the left, one to the right; w = 3,
#: then 0, then -1. The heading at the start is not printed; east fits the heading at 53 s that is.
PUBLISHED = seconds((10, 0, 3), (20, -1, 3), (10, -1, 0), (80, 1, -1))
START = (0.0, 0.0, np.pi / 2, 200.0)
