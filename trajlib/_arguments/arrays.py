"""Reading of arrays in any of the forms that libraries of Python have for them, without SymPy.

A list, an array, a masked array, a sparse matrix, a data frame, an object array or a SymPy matrix
becomes one array, of floats or of the objects that it held. Text, truth values, dates, complex
numbers and masked entries would pass through the formulas as numbers of no meaning, so they are
refused by the name of the argument.
"""

import reprlib
from datetime import date, timedelta

import numpy as np

COMPLEX = "complex numbers"
#: Types of entries that are no numbers, or none on the real line.
_REFUSED = (
    (bool | np.bool_, "truth values"),
    (str | bytes, "text"),
    (date | timedelta | np.datetime64 | np.timedelta64, "dates or durations"),
    (complex | np.complexfloating, COMPLEX),
    (type(None), "None"),
    (np.void, "records"),
    (list | tuple | np.ndarray, "rows of different lengths"),
)


def plain_array(value, name, expected):
    """Return an array of floats or of objects; `expected` says in the message what was expected."""
    if type(value) is np.ndarray and value.dtype.kind in "fiu":
        return value.astype(float, order="C")
    array = raw_array(value, name, expected)
    if array.dtype.kind in "fiu":
        # in one order of memory, so that equal arrays give equal digits
        return array.astype(float, order="C")
    kinds = set(map(type, array.flat)) if array.dtype.kind == "O" else {array.dtype.type}
    for types, words in _REFUSED:
        if any(issubclass(kind, types) for kind in kinds):
            # A complex number is a number, but not of the values that were expected.
            error = ValueError if words == COMPLEX else TypeError
            raise error(f"{name}: expected {expected}, got {words}: {brief(value)}")
    return array


def read_array(value, name, expected):
    """Return an array of floats of any shape; `expected` says in the message what was expected."""
    array = plain_array(value, name, expected)
    if array.dtype.kind == "f":
        return array
    try:
        return array.astype(float)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected {expected}, got {brief(value)}") from None
    except OverflowError:
        raise ValueError(f"{name}: expected {expected}, got one beyond all floats") from None


def read_finite_array(value, name, expected):
    """Return an array of finite floats."""
    array = read_array(value, name, expected)
    if not np.isfinite(array).all():
        index = ", ".join(map(str, np.argwhere(~np.isfinite(array))[0]))
        where = f"entry ({index})" if array.ndim else "it"
        raise ValueError(f"{name}: expected finite numbers, but {where} is not finite")
    return array


def brief(value):
    """Return a short text that shows a value in a message."""
    shape = getattr(value, "shape", None)
    if isinstance(shape, tuple) and len(shape):
        return f"{type(value).__name__} of the shape {shape}"
    return reprlib.repr(value)


def unwrapped(value):
    """Return the array or list that a sparse matrix, a data frame or a series holds."""
    for method in ("toarray", "to_numpy"):
        if hasattr(value, method):
            return getattr(value, method)()
    return value


def raw_array(value, name, expected):
    """Return an array of whatever this holds; a masked entry is refused."""
    value = unwrapped(value)
    if isinstance(value, np.ma.MaskedArray):
        masked = np.ma.getmaskarray(value)
        if masked.any():
            index = ", ".join(map(str, np.argwhere(masked)[0]))
            raise ValueError(
                f"{name}: expected {expected}, but entry ({index}) is masked; only measurements may "
                "be missing"
            )
        value = np.ma.getdata(value)
    if isinstance(value, np.ndarray | np.generic):
        return np.asarray(value)
    if hasattr(value, "as_explicit"):  # such as SymPy's Identity(2)
        value = value.as_explicit()
    if hasattr(value, "tolist") and hasattr(value, "shape"):
        return np.array(value.tolist(), dtype=object).reshape(tuple(value.shape))
    if hasattr(value, "__array__"):
        return np.asarray(value)
    try:
        return np.array(value, dtype=object)
    except ValueError:
        raise TypeError(f"{name}: expected {expected}, got rows of different lengths") from None
