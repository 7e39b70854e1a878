"""Reading of numbers, times, names and arrays of floats, without SymPy."""

import operator
from datetime import date

import numpy as np

from trajlib._arguments.arrays import brief, raw_array, read_array, read_finite_array

#: What times of a record are, for messages.
TIMES = "a list of times, numbers or dates"


def read_number(value, name):
    """Return a finite float."""
    number = read_array(value, name, "a number")
    if number.ndim:
        raise TypeError(f"{name}: expected a number, got {brief(value)}")
    if not np.isfinite(number):
        raise ValueError(f"{name}: expected a finite number, got {number}")
    return float(number)


def read_positive(value, name, unit):
    """Return a positive finite float; `unit` is its unit in words, for the message."""
    value = read_number(value, name)
    if value <= 0:
        raise ValueError(f"{name}: expected a positive number ({unit}), got {value:g}")
    return value


def read_count(value, name, least):
    """Return an integer that is at least `least`."""
    try:
        if isinstance(value, bool | np.bool_ | np.timedelta64):
            raise TypeError
        value = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected a whole number, got {brief(value)}") from None
    if value < least:
        raise ValueError(f"{name}: expected {least} or more, got {value}")
    return value


def read_interval(value, name, meaning="(low, high)"):
    """Return two finite floats, the first not above the second."""
    ends = read_array(value, name, meaning)
    if ends.shape != (2,) or not np.isfinite(ends).all() or ends[0] > ends[1]:
        raise ValueError(f"{name}: expected {meaning} with low <= high, got {brief(value)}")
    return float(ends[0]), float(ends[1])


def read_points(value, name, length=2):
    """Return finite points of `length` coordinates as an array of shape (..., length)."""
    value = read_finite_array(value, name, f"numbers of shape (..., {length})")
    if value.ndim == 0 or value.shape[-1] != length:
        raise ValueError(f"{name}: expected shape (..., {length}), got {value.shape}")
    return value


def read_seconds(value, name):
    """Return an array of finite times that belong to a record read by `read_times`.

    Dates are refused: what they count from is the first time of the record, which is not known
    here.
    """
    return read_finite_array(
        value, name, "times as numbers (of dates: seconds since the first of them)"
    )


def read_times(
    times,
    name="times",
    least=1,
    repeated="put the measurements of one time into one function or matrix H",
):
    """Return `least` or more (one or two) finite times in order as a flat array.

    Dates (datetime64, datetime, pandas.Timestamp) become seconds since the first of them.
    `repeated` is the advice where two times are equal; None if that is allowed.
    """
    times = _numbers(times, name)
    if times.ndim != 1 or times.size < least:
        got = times.size if times.ndim == 1 and times.size else f"shape {times.shape}"
        raise ValueError(
            f"{name}: expected a list of {'two or more ' * (least == 2)}times, got {got}"
        )
    if not np.isfinite(times).all():
        k = np.flatnonzero(~np.isfinite(times))[0]
        raise ValueError(f"{name}: expected a list of finite times, but entry {k} is not finite")
    steps = np.diff(times)
    wrong = np.flatnonzero(steps < 0 if repeated is None else steps <= 0)
    if not wrong.size:
        return times
    k = wrong[0]
    if steps[k] == 0:
        raise ValueError(
            f"{name}: the time {times[k]:g} is repeated (entries {k} and {k + 1}); {repeated}"
        )
    order = "increase" if repeated is not None else "not decrease"
    raise ValueError(
        f"{name}: the times must {order}, but {times[k]:g} is followed by {times[k + 1]:g} "
        f"(entries {k} and {k + 1}); sort them, with their measurements"
    )


def _numbers(times, name):
    """Return times as floats, dates as seconds since the first of them."""
    array = raw_array(times, name, TIMES)
    if array.dtype.kind == "O" and all(isinstance(t, np.datetime64) for t in array.flat):
        array = np.array(list(array.flat)).reshape(array.shape)
    if array.dtype.kind == "M":
        # Years and months have no length in seconds, their first days do.
        unit = np.datetime_data(array.dtype)[0]
        days = array.astype("datetime64[D]") if unit in ("Y", "M") else array
        return (days - days.reshape(-1)[:1]) / np.timedelta64(1, "s")
    if array.dtype.kind == "O" and array.size and all(isinstance(t, date) for t in array.flat):
        try:
            since = [(t - array.flat[0]).total_seconds() for t in array.flat]
        except TypeError as reason:
            raise TypeError(f"{name}: dates of different kinds ({reason})") from None
        return np.array(since).reshape(array.shape)
    return read_array(array, name, TIMES)


def read_numeric_matrix(matrix, name):
    """Return a two-dimensional array of finite floats."""
    matrix = read_array(matrix, name, "a matrix of numbers (substitute them for symbols first)")
    if matrix.ndim != 2:
        raise ValueError(f"{name}: expected a matrix, got shape {matrix.shape}")
    if not np.isfinite(matrix).all():
        row, column = np.argwhere(~np.isfinite(matrix))[0]
        raise ValueError(f"{name}: the entry ({row}, {column}) is not finite")
    return matrix


def read_names(names, m, argument="names"):
    """Return m names of unknowns; x0, x1, ... if None."""
    if names is None:
        return tuple(f"x{j}" for j in range(m)) if argument == "names" else ("",) * m
    names = tuple(str(name) for name in ([names] if isinstance(names, str) else names))
    if len(names) != m:
        raise ValueError(f"{argument}: expected {m}, one for each unknown, got {len(names)}")
    return names
