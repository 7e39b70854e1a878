"""Reading of records of measurements with gaps, and of matrices with one for each step."""

import numpy as np

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix


def read_record(z, missing, m):
    """Return measurements and gaps of the shape (S, N, m), and whether it was one series alone.

    Missing measurements, marked in `missing` or by a masked array, are zero.
    """
    if isinstance(z, np.ma.MaskedArray):
        if missing is not None:
            raise ValueError(
                "missing: z is a masked array, which marks missing measurements itself"
            )
        z, missing = np.ma.getdata(z), np.ma.getmaskarray(z)
    z = np.asarray(z, dtype=float)
    shape = z.shape
    if z.ndim == 1 and m == 1:
        z = z[:, None]
    if z.ndim not in (2, 3) or z.shape[-1] != m or 0 in z.shape:
        raise ValueError(f"z: expected the shape (N, {m}) or (series, N, {m}), got {shape}")
    if missing is None:
        gaps = np.zeros(z.shape, dtype=bool)
    else:
        gaps = np.asarray(missing)
        if gaps.dtype != bool or gaps.shape not in (z.shape, z.shape[:-1], shape):
            raise ValueError(
                f"missing: expected booleans of the shape {shape} or {z.shape[:-1]}, got "
                f"{gaps.dtype} of the shape {gaps.shape}"
            )
        gaps = np.broadcast_to(gaps if gaps.ndim == z.ndim else gaps[..., None], z.shape)
    if not np.isfinite(z[~gaps]).all():
        entry = tuple(int(i) for i in np.argwhere(~np.isfinite(z) & ~gaps)[0])
        raise ValueError(
            f"z: the measurement {entry} is {z[entry]}; mark it in `missing` if there is none"
        )
    z = np.where(gaps, 0.0, z)
    return z.reshape((-1, *z.shape[-2:])), gaps.reshape((-1, *z.shape[-2:])), z.ndim == 2


def read_stack(matrices, name, rows, columns, read_stack=None):
    """Return one matrix, or a stack with a matrix for each step."""
    if not (any_floats(matrices) and np.ndim(matrices) == 3):
        if read_stack is None:
            return read_matrix(matrices, name, rows, columns, True)
        return read_covariance(matrices, name, rows, True)
    array = np.asarray(matrices, dtype=float)
    # The first tells in the words of all other functions what does not fit.
    read_matrix(array[0], name, rows, columns, True)
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite entries")
    return array if read_stack is None else read_stack(array, name)
