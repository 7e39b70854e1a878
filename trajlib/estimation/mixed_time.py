"""A continuous process measured at moments: prediction by (4.6), (4.7) from one to the next,
correction at each.

The moments may come at any distance, several at one time, and with components missing.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib._arguments.symbols import exact_decimals
from trajlib.estimation.correction import corrected
from trajlib.estimation.covariances import Moments
from trajlib.estimation.markov import continuous_moments


@dataclass(frozen=True)
class Measurement:
    """z = H x(time) + r: `z`: m numbers, None for each that is missing (or None for all); `H`: m x
    n; `R`: m x m."""

    time: object
    z: object
    H: object
    R: object


@dataclass(frozen=True)
class MixedRun:
    """What a filter with measurements at moments found.

    - `times`: the moments, rising; `before` and `after`: `Moments` of x there, before and after the
      measurement;
    - `corrections`: for each `Correction`, None where all was missing;
    - `at(t)`: `Moments` of x(t) given the measurements up to t, those at t included.
    """

    times: tuple
    before: tuple
    after: tuple
    corrections: tuple
    _process: tuple

    def at(self, t):
        """`Moments` at a time from the beginning on; if symbols stand in it, it is one after the
        last measurement.

        Raises ValueError for a time before the beginning, and for a number where the measurements
        have symbols.
        """
        A, Q, start, begin = self._process
        t = exact_decimals(sp.sympify(t))
        passed = len(self.times) if t.free_symbols else sum(_passed(time, t) for time in self.times)
        known, since = (
            (self.after[passed - 1], self.times[passed - 1]) if passed else (start, begin)
        )
        return continuous_moments(A, Q, known, t - since)

    def path(self, until, component=0, count=100):
        """Estimate of one component and the standard deviation of its error from the beginning
        `until` a time.

        Three arrays for a picture: times, `count` for each stretch between measurements, estimates
        and deviations; a moment of measurement stands there twice, before it and after it. For
        numbers only.
        """
        A, Q, start, begin = self._process
        A, Q = (
            np.asarray(matrix, dtype=float).reshape(A.shape)
            for matrix in (A, read_square(Q, "Q", False))
        )
        passed = [time for time in self.times if time <= until]
        edges, found = [begin, *passed, until], []
        for low, high, known in zip(edges, edges[1:], (start, *self.after)):
            known = Moments(
                np.array(known.mean, dtype=float).ravel(), np.array(known.covariance, dtype=float)
            )
            for time in np.linspace(float(low), float(high), count):
                moments = continuous_moments(A, Q, known, time - float(low))
                found.append((time, moments.mean[component], moments.deviations[component]))
        return tuple(np.array(found).T)

    def _repr_latex_(self):
        last = self.after[-1]._repr_latex_() if self.after else "$$"
        return (
            rf"$\displaystyle t = {sp.latex(self.times[-1])}:\quad "
            + last[len(r"$\displaystyle ") :]
        )


def filter_measurements(A, Q, start, measurements, begin=0):
    """The optimal estimate of x' = Ax + q from measurements at moments (continuous-discrete Kalman
    filter).

    `A`: n x n; `Q`: n x n, the intensity of q; `start`: `Moments` of x at the time `begin`;
    `measurements`: of `Measurement`, in any order (times with symbols: as they follow), whose
    errors do not correlate with one another. Exact, also with symbols, or floats. Returns
    `MixedRun`. Raises ValueError for a measurement before the beginning, for shapes that do not
    fit, covariances that are none, and nan, which does not mean "missing" here. Source: the remarks
    after Theorem 4.2, example 3, problems 4.26, 4.28 - 4.32.

    >>> from trajlib.estimation import Moments
    >>> run = filter_measurements(-1, 1, Moments(1, 1), [Measurement(0, 2, 1, 1)])    # example 3
    >>> run.at(1).mean[0], run.at(1).covariance[0]
    (3*exp(-1)/2, 1/2)
    """
    floats = any_floats(A, Q, start.mean, start.covariance)
    A = read_square(A, "A", floats)
    begin = exact_decimals(sp.sympify(begin))
    ordered = [(exact_decimals(sp.sympify(one.time)), one) for one in measurements]
    if all(time.is_number for time, _ in ordered):
        ordered.sort(key=lambda entry: float(entry[0]))
    known, since, found = start, begin, []
    for time, one in ordered:
        # With symbols the order is believed unless it is known to be wrong.
        if sp.sympify(time >= since) == sp.false:
            raise ValueError(
                f"measurements: the one at {time} comes before {since}"
                + ", the beginning" * (since == begin)
            )
        before = continuous_moments(A, Q, known, time - since)
        correction = _corrected(before, one)
        after = before if correction is None else correction.moments
        found.append((time, before, after, correction))
        known, since = Moments(after.mean, after.covariance), time
    columns = zip(*found) if found else ((), (), (), ())
    return MixedRun(*(tuple(column) for column in columns), (A, Q, start, begin))


def _passed(time, t):
    if not time.is_number:
        raise ValueError(
            f"t: whether {t} comes after {time} is not known; ask for {time} + t instead"
        )
    return bool(time <= t)


def _corrected(before, one):
    if one.z is None:
        return None
    z = one.z if isinstance(one.z, (list, tuple, np.ndarray, sp.MatrixBase)) else [one.z]
    there = [k for k, value in enumerate(z) if value is not None]
    if len(there) == len(z):
        return corrected(before, z, one.H, one.R)
    if not there:
        return None
    floats = any_floats(one.H, one.R)
    H, R = (
        read_matrix(one.H, "H", len(z), None, floats),
        read_matrix(one.R, "R", len(z), len(z), floats),
    )
    part = [[R[i, j] for j in there] for i in there]
    rows = [[H[i, j] for j in range(H.shape[1])] for i in there]
    make = np.array if floats else sp.Matrix
    return corrected(before, [z[k] for k in there], make(rows), make(part))
