"""Reading of records: measurements with gaps, inputs, and matrices with one for each step."""

import numpy as np

from trajlib._arguments.arrays import raw_array, read_array, read_finite_array, unwrapped
from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import read_matrix


def read_record(z, missing, m):
    """Return measurements and gaps of the shape (S, N, m), and whether it was one series alone.

    Missing measurements, marked in `missing` or by a masked array, are zero.
    """
    z = unwrapped(z)
    if isinstance(z, np.ma.MaskedArray):
        if missing is not None:
            raise ValueError(
                "missing: z is a masked array, which marks missing measurements itself"
            )
        z, missing = z.filled(0), np.ma.getmaskarray(z)
    z = read_array(z, "z", "numbers (mark in `missing` what was not measured)")
    shape = z.shape
    if z.ndim == 1 and m == 1:
        z = z[:, None]
    if z.ndim not in (2, 3) or z.shape[-1] != m or 0 in z.shape:
        raise ValueError(f"z: expected the shape (N, {m}) or (series, N, {m}), got {shape}")
    gaps = np.zeros(z.shape, dtype=bool) if missing is None else _read_gaps(missing, z.shape, shape)
    if not np.isfinite(z[~gaps]).all():
        entry = tuple(int(i) for i in np.argwhere(~np.isfinite(z) & ~gaps)[0])
        raise ValueError(
            f"z: the measurement {entry} is {z[entry]}; mark it in `missing` if there is none"
        )
    z = np.where(gaps, 0.0, z)
    return z.reshape((-1, *z.shape[-2:])), gaps.reshape((-1, *z.shape[-2:])), z.ndim == 2


def _read_gaps(missing, full, given):
    """Return booleans of the shape `full` of the measurements, which were `given` as a record."""
    expected = f"booleans of the shape {given} or {full[:-1]}"
    gaps = raw_array(missing, "missing", expected)
    if gaps.dtype == object and all(isinstance(gap, bool | np.bool_) for gap in gaps.flat):
        gaps = gaps.astype(bool)
    if gaps.dtype != bool or gaps.shape not in (full, full[:-1], given):
        raise ValueError(
            f"missing: expected {expected}, got {gaps.dtype} of the shape {gaps.shape}"
        )
    return np.broadcast_to(gaps if gaps.ndim == len(full) else gaps[..., None], full)


def read_inputs(inputs, count, length, series=1):
    """Return the inputs of each step, of the shape (N, length) or (series, N, length)."""
    array = read_finite_array(
        inputs, "inputs", f"{length} number{'s' * (length != 1)} for each step"
    )
    shape = array.shape
    array = array[..., None] if length == 1 and shape[-1:] == (count,) and array.ndim < 3 else array
    if array.shape not in ((count, length), (series, count, length)):
        several = f" or {(series, count, length)}" * (series > 1)
        raise ValueError(f"inputs: expected the shape {(count, length)}{several}, got {shape}")
    return array


def read_stack(matrices, name, rows, columns, read_stack=None):
    """Return one matrix, or a stack with a matrix for each step."""
    array = read_array(matrices, name, "a matrix of numbers, or one for each step")
    if array.ndim != 3 or not len(array):
        if read_stack is None:
            return read_matrix(array, name, rows, columns, True)
        return read_covariance(array, name, rows, True)
    # The first tells in the words of all other functions what does not fit.
    read_matrix(array[0], name, rows, columns, True)
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite entries")
    return array if read_stack is None else read_stack(array, name)
