"""Observable and unobservable states in floating-point numbers.

The pair is brought to balanced units (`scaling`), the staircase splits off the states that its
steps do not observe (`staircase`), and in the rest the least singular value of the PBH test is
sought (`nearest`): one that is zero within rounding belongs to a state that many small steps of the
staircase hid. It is split off by an orthogonal transformation, and so on in the remaining part. The
unobservable states are counted and spanned in this way without any power of A, and each number
taken for zero is the distance to the nearest such system.
"""

import warnings
from dataclasses import dataclass

import numpy as np

from trajlib._numerical_rank import zero_level
from trajlib.structure.nearest import nearest, smallest
from trajlib.structure.scaling import Scaled, balanced
from trajlib.structure.staircase import staircase

_EPS = np.finfo(float).eps
#: Unobservable directions are split off together if they are as independent as this.
_APART = 0.3
# A margin below this is reported: data known to eight digits would not decide.
DOUBTFUL = np.sqrt(_EPS)


def tolerance(n):
    """Return the size, in balanced units, of a zero after rounding of the data."""
    return zero_level(n)


@dataclass(frozen=True)
class Split:
    """The observable and the unobservable states of a pair.

    Attributes
    ----------
    scaled : Scaled
        The pair in balanced units.
    observable_axes, unobservable_axes : numpy.ndarray
        Orthonormal columns in the balanced units of `scaled`, together a basis.
    margin : float
        The least singular value found in the PBH test for the whole pair, in balanced units.
    """

    scaled: Scaled
    observable_axes: np.ndarray
    unobservable_axes: np.ndarray
    margin: float

    @property
    def rank(self):
        return self.observable_axes.shape[1]

    @property
    def unobservable(self):
        """Return an orthonormal basis of the unobservable states, in the units given."""
        return np.linalg.qr(self.scaled.units[:, None] * self.unobservable_axes)[0]

    @property
    def complement(self):
        """Return an orthonormal basis of their orthogonal complement, in the units given."""
        return np.linalg.qr(self.observable_axes / self.scaled.units[:, None])[0]

    @property
    def rows(self):
        """Return T of (xi; eta) = T x, orthogonal in balanced units, xi observable."""
        return np.hstack([self.observable_axes, self.unobservable_axes]).T / self.scaled.units


def split(A, H):
    """Return the `Split` of a pair of float matrices."""
    import scipy.linalg

    scaled, n = balanced(A, H), len(A)
    observable, unobservable, margin, limit = np.eye(n), np.zeros((n, 0)), None, tolerance(n)
    for round_ in range(n):
        inner, outer = observable.T @ scaled.A @ observable, scaled.H @ observable
        stairs = staircase(inner, outer, limit)
        observable = observable @ stairs.basis
        observable, dropped = observable[:, : stairs.rank], observable[:, stairs.rank :]
        unobservable = np.hstack([unobservable, dropped])
        if not stairs.rank:
            break
        inner, outer = stairs.matrix[: stairs.rank, : stairs.rank], scaled.H @ observable
        minima = nearest(inner, outer, stairs)
        sigma = minima[0][0]
        margin = sigma if margin is None and not unobservable.shape[1] else margin
        if sigma > limit:
            break
        plane = _unobservable_plane(inner, outer, minima, limit)
        unobservable = np.hstack([unobservable, observable @ plane])
        observable = observable @ scipy.linalg.null_space(plane.T)
        if not observable.shape[1]:
            break
        # The error of what is split off adds to the data of what remains.
        limit = tolerance(n) * 10 ** min(round_ + 1, 4)
    return Split(
        scaled,
        observable,
        unobservable,
        _whole_margin(scaled, unobservable) if margin is None else margin,
    )


def _unobservable_plane(A, H, minima, limit):
    """Return a real orthonormal basis of the vectors of the minima that are zero."""
    planes, values = [], []
    for sigma, value, _ in minima:
        if np.imag(value) and smallest(A, H, np.real(value))[0] <= limit:
            value = np.real(value)
            sigma = smallest(A, H, value)[0]
        if sigma <= limit and all(abs(value - previous) > 1e-3 for previous in values):
            values.append(value)
            planes.append(_plane(_kernel(A, H, value, max(2 * sigma, 20 * _EPS))))
    # Directions that nearly depend on the others are too inaccurate here; the next search finds
    # them.
    axes, weights, _ = np.linalg.svd(np.hstack(planes), full_matrices=False)
    return axes[:, weights > _APART] if len(planes) > 1 else planes[0]


def split_with_warning(A, H):
    """Return the `Split`, with a warning where the verdict is doubtful."""
    result = split(A, H)
    if result.rank == len(A) and result.margin < DOUBTFUL:
        warnings.warn(
            f"nothing is split off, but a change of the entries by {result.margin:.1e} of their "
            "size would take a state away; exact entries (SymPy) would decide",
            stacklevel=4,
        )
    return result


def hidden_modes(split):
    """Return pairs (lambda, columns v with A v = lambda v, H v = 0), in the units given."""
    axes, scaled, modes = split.unobservable_axes, split.scaled, []
    block, limit = axes.T @ scaled.A @ axes, 10 * tolerance(len(scaled.A))
    for value in _numbers(block):
        vectors = _kernel(block, np.zeros((0, len(block))), value, limit)
        vectors = scaled.units[:, None] * (axes @ vectors)
        vectors = vectors / np.linalg.norm(vectors, axis=0)
        modes.append((value * scaled.rate, vectors))
        if np.imag(value):
            modes.append((value.conjugate() * scaled.rate, vectors.conj()))
    return modes


def _numbers(block):
    """Return the eigenvalues with Im >= 0: the mean of a ring made by rounding, zero for less than that."""
    remaining, limit, values = list(np.linalg.eigvals(block)), tolerance(len(block)), []
    while remaining:
        # A multiple number of order k comes as a ring of the radius of the k-th root of rounding.
        distances = np.abs(np.array(remaining) - remaining[0])
        order = np.argsort(distances)
        for count in range(len(remaining), 0, -1):
            ring = order[:count]
            mean = np.mean([remaining[i] for i in ring])
            real, imaginary = (
                part if abs(part) > limit else 0.0 for part in (mean.real, mean.imag)
            )
            mean = complex(real, imaginary) if imaginary else float(real)
            if count == 1 or (
                distances[ring[-1]] <= 2 * limit ** (1 / count) and _singular(block, mean) <= limit
            ):
                break
        if np.imag(mean) and _singular(block, np.real(mean)) <= limit:
            mean = float(np.real(mean))
        values.append(mean)
        remaining = [remaining[i] for i in range(len(remaining)) if i not in ring]
    return sorted((f for f in values if np.imag(f) >= 0), key=lambda f: (np.real(f), np.imag(f)))


def _singular(block, value):
    return np.linalg.svd(block - value * np.eye(len(block)), compute_uv=False)[-1]


def _kernel(A, H, value, limit):
    """Return the vectors, one at least, at which (A - lambda I; H) is at most `limit`."""
    _, values, right = np.linalg.svd(np.vstack([A - value * np.eye(len(A)), H]))
    return right[values <= max(limit, values[-1])].conj().T


def _plane(vectors):
    """Return a real orthonormal basis of the span of complex vectors and their conjugates."""
    import scipy.linalg

    return scipy.linalg.orth(np.hstack([vectors.real, vectors.imag]), rcond=1e-8)


def _whole_margin(scaled, unobservable):
    """Return the least PBH singular value at the eigenvalues of the part split off."""
    values = np.linalg.eigvals(unobservable.T @ scaled.A @ unobservable)
    return float(min(smallest(scaled.A, scaled.H, value)[0] for value in values))
