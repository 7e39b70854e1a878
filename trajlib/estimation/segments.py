"""Kalman recursions of long records in segments beside each other.

All segments take their steps together, one NumPy call for all of them. The covariance before each
segment comes from the maps of the segments before it (S. Särkkä, A. F. García-Fernández, IEEE
Transactions on Automatic Control 66, 2021):

    P -> C + A (E + P J)^-1 P A^T,

where C is the end of the recursion from P = 0, A the product of its closed-loop matrices, and J its
information on the initial state. The means, and backwards the smoother, are affine recursions:
their segments start from zero as well, with the product of their matrices.
"""

import numpy as np

#: From so many steps on segments take less time than steps one by one.
LEAST_STEPS = 1000
#: The map of a segment is composed of those of so many parts, until earlier ones have no influence.
PARTS = 8
#: Rows of the matrices of all segments, so many that a call of NumPy takes little of the time.
ROWS, FEWEST_SEGMENTS, MOST_SEGMENTS = 1024, 32, 128
#: Share of the variances that an earlier part may change, and what rounding may.
NEGLIGIBLE, ROUNDING = 1e-15, 1e-11


def number_of_segments(count, n):
    """Return the number of segments of a record of n states; 1 if it is short."""
    most = min(max(ROWS // n, FEWEST_SEGMENTS), MOST_SEGMENTS)
    return min(int(np.sqrt(count)), most) if count >= LEAST_STEPS else 1


def in_segments(array, dimensions, segments):
    """Return a matrix, or a stack with one for each step, as a view: segments x steps x matrix."""
    if array.ndim == dimensions:
        return np.broadcast_to(array, (segments, 1, *array.shape))
    return array.reshape(segments, -1, *array.shape[1:])


def _at(array, k):
    return array[:, k if array.shape[1] > 1 else 0]


def transposed(array):
    """Return the transposes as an array of their own, which products need to be fast."""
    return np.ascontiguousarray(np.swapaxes(array, -1, -2))


def covariance_segments(matrices, P, missing, segments, results):
    """Write P-, P+ and K of each step; whether rounding leaves the maps of the segments right.

    `matrices` are Phi, H, Q, R, each one or a stack; `missing` has a multiple of `segments` rows.
    """
    Phi, H, Q, R = matrices
    uniform = all(M.ndim == 2 for M in matrices) and not missing.any()
    if missing.any():
        # A missing component has a row of zeros in H and of the unit matrix in R.
        measured = (~missing).astype(float)
        H = H * measured[:, :, None]
        R = R * (measured[:, :, None] * measured[:, None, :])
        np.einsum("kii->ki", R)[:] += missing
    terms = [in_segments(M, 2, segments) for M in (Phi, transposed(Phi), H, transposed(H), Q, R)]
    length = len(missing) // segments
    views = [part.reshape(segments, length, *part.shape[1:]) for part in results]
    # The last segment has no successor; the maps of equal ones are equal.
    mapped = [term[: 1 if uniform else -1] for term in terms]
    try:
        for forget in (True, False):
            starts = _starts(_segment_map(mapped, length, P, forget), P, segments)
            ends = _filter(terms, starts, views)
            if _near(ends[:-1], starts[1:]):
                return True
    except np.linalg.LinAlgError:
        pass
    return False


def _correct(P, H, HT, R):
    """Return P+, K and the inverse of S."""
    HP = H @ P
    inverse = np.linalg.inv(HP @ HT + R)
    solution = inverse @ HP
    K = transposed(solution)
    # Joseph's form by two changes of rank m.
    once = P - K @ HP
    once += (K @ R - once @ HT) @ solution
    return _symmetric(once), K, inverse


def _symmetric(P):
    P = P + P.swapaxes(-1, -2)
    P *= 0.5
    return P


def _filter(terms, P, views):
    """Write P-, P+, K of all steps of the segments that start from P; return their ends."""
    before, after, gains = views
    for k in range(before.shape[1]):
        Phi, PhiT, H, HT, Q, R = (_at(term, k) for term in terms)
        before[:, k] = P
        P, gains[:, k], _ = _correct(P, H, HT, R)
        after[:, k] = P
        P = Phi @ P @ PhiT + Q
    return P


def _segment_map(terms, length, P, forget):
    """Return A, C, J of whole segments, or of an end so long that what was before has no influence."""
    bounds, total = np.linspace(0, length, PARTS + 1).astype(int), None
    for first, last in zip(bounds[-2::-1], bounds[:0:-1]):
        part = _map_of_steps(terms, first, last, P.shape)
        total = part if total is None else _composed(part, total)
        A, C, _ = total
        influence = np.einsum("sij,sjk,sik->si", A, P + C, A)
        if forget and (influence <= NEGLIGIBLE * np.einsum("sii->si", C)).all():
            return np.zeros_like(A), C, total[2]
    return total


def _map_of_steps(terms, first, last, shape):
    C, J = np.zeros((2, len(terms[0]), *shape))
    A = J + np.eye(len(C[0]))
    for k in range(first, last):
        Phi, PhiT, H, HT, Q, R = (_at(term, k) for term in terms)
        after, K, inverse = _correct(C, H, HT, R)
        HA = H @ A
        J += transposed(HA) @ (inverse @ HA)
        A = Phi @ (A - K @ HA)
        C = Phi @ after @ PhiT + Q
    return A, C, J


def _composed(first, second):
    A, C, J = first
    next_A, next_C, next_J = second
    n = A.shape[-1]
    solution = np.linalg.solve(np.eye(n) + C @ next_J, np.concatenate([A, C], axis=-1))
    passed_A, passed_C = solution[..., :n], solution[..., n:]
    return (
        next_A @ passed_A,
        _symmetric(next_C + next_A @ passed_C @ next_A.swapaxes(-1, -2)),
        _symmetric(J + A.swapaxes(-1, -2) @ next_J @ passed_A),
    )


def _starts(segment_map, P, segments):
    """Return P- at the start of each segment."""
    A, C, J = (np.broadcast_to(part, (segments - 1, *P.shape)) for part in segment_map)
    starts = np.empty((segments, *P.shape))
    starts[0] = P
    if not A.any():
        starts[1:] = C
        return starts
    unit = np.eye(len(P))
    for s in range(segments - 1):
        P = C[s] + A[s] @ np.linalg.solve(unit + P @ J[s], P) @ A[s].T
        starts[s + 1] = P = (P + P.T) / 2
    return starts


def _near(covariances, others):
    units = np.sqrt(np.maximum(np.einsum("kii->ki", others), 0))
    limit = ROUNDING * units[:, :, None] * units[:, None, :]
    return (np.abs(covariances - others) <= limit).all()


def mean_segments(Phi, H, gains, z, inputs, x, segments):
    """Return x_0, ..., x_N of x_{k+1} = Phi (x_k + K_k (z_k - H x_k)) + u_k for several series.

    z is S x N x m, `inputs` S x N x n or None, x S x n, and the result S x (N + 1) x n.
    """
    series, count, n = len(z), z.shape[1], x.shape[1]
    states = np.empty((count + 1, n, series))
    states[0] = x.T
    head = count % segments
    for first, last, parts in ((0, head, 1), (head, count, segments)):
        if first == last:
            continue
        matrices = [M if M.ndim == 2 else M[first:last] for M in (Phi, H, Phi @ gains)]
        terms = [in_segments(M, 2, parts) for M in matrices]
        data = [
            None if d is None else in_segments(d[:, first:last].transpose(1, 2, 0), 2, parts)
            for d in (z, inputs)
        ]
        starts = np.empty((parts, n, series))
        starts[0] = states[first]
        if parts > 1:
            maps = _means(terms, data, np.eye(n, n + series))
            for s in range(parts - 1):
                starts[s + 1] = maps[s, :, :n] @ starts[s] + maps[s, :, n:]
        _means(terms, data, starts, states[first + 1 : last + 1].reshape(parts, -1, n, series))
    return states.transpose(2, 0, 1)


def _means(terms, data, x, following=None):
    """Take all steps of the segments, and write what follows each; only the last columns have data."""
    z, inputs = data
    own = slice(x.shape[-1] - z.shape[-1], None)
    for k in range(z.shape[1]):
        Phi, H, PhiK = (_at(term, k) for term in terms)
        innovation = -(H @ x)
        innovation[..., own] += z[:, k]
        x = Phi @ x + PhiK @ innovation
        if inputs is not None:
            x[..., own] += inputs[:, k]
        if following is not None:
            following[:, k] = x
    return x


def smoothed_segments(Phi, H, gains, inverses, innovations, after, estimates, segments):
    """Return smoothed estimates (S x N x n) and covariances by the recursion of Bryson and Frazier.

    Backwards from zero, with F_k = Phi_k (E - K_k H_k) and the inverses of the S_k,

        r_k = F_k^T r_{k+1} + H_k^T S_k^-1 nu_k,        x_k = x_k^+ + P_k^+ Phi_k^T r_{k+1},
        N_k = F_k^T N_{k+1} F_k + H_k^T S_k^-1 H_k,     P_k = P_k^+ - P_k^+ Phi_k^T N_{k+1} Phi_k P_k^+.

    The number of steps is a multiple of `segments`.
    """
    series, count, n = estimates.shape
    terms = [in_segments(M, 2, segments) for M in (Phi, H, Phi @ gains)]
    weighted = np.swapaxes(H, -1, -2) @ inverses
    shown = [
        in_segments(part, 2, segments)
        for part in (weighted @ H, weighted @ innovations.transpose(1, 2, 0))
    ]
    N, r = np.zeros((segments, n, n)), np.zeros((segments, n, series))
    starts = _backwards(terms, shown, N, np.eye(n, n + series, series))
    for s in range(segments - 1, 0, -1):
        AT = starts[1][s, :, series:]
        N[s - 1] = AT @ N[s] @ AT.T + starts[0][s]
        r[s - 1] = AT @ r[s] + starts[1][s, :, :series]
    covariances, states = np.empty((count, n, n)), np.empty((count, n, series))
    filtered = after, estimates.transpose(1, 2, 0)
    results = [in_segments(M, 2, segments) for M in (*filtered, covariances, states)]
    _backwards(terms, shown, N, r, results)
    return states.transpose(2, 0, 1), covariances


def _backwards(terms, shown, N, r, results=None):
    """Take all steps of the segments backwards, and write what is smoothed at each.

    Only the first columns of r have data, those beside them give the products of the F_k^T.
    """
    own = slice(shown[1].shape[-1])
    for k in range(shown[0].shape[1] - 1, -1, -1):
        Phi, H, PhiK, information, weighted = (_at(term, k) for term in (*terms, *shown))
        if results is not None:
            after, estimates, covariances, states = (part[:, k] for part in results)
            carried = Phi @ after
            back = transposed(carried)
            covariances[:] = _symmetric(after - back @ (N @ carried))
            np.add(estimates, back @ r, out=states)
        F = Phi - PhiK @ H
        back = transposed(F)
        N = back @ N @ F + information
        r = back @ r
        r[..., own] += weighted
    return N, r
