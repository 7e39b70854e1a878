"""Encoding of arrays and scalars of NumPy and CasADi.

Neither is imported here before an answer has an array: most answers have none.
"""

import base64
import functools
import math

from workbook.checks.contract.limits import MAX_AXES, MAX_BYTES, MAX_ELEMENTS, MAX_NODES

_DTYPES = {"bool": "?", "int": "<i8", "float": "<f8", "complex": "<c16"}
_KIND_OF_DTYPE = {"b": "bool", "i": "int", "u": "int", "f": "float", "c": "complex", "U": "str"}
_PYTHON = {"bool": bool, "int": int, "float": float, "complex": complex, "str": str}
AS_LISTS = "OU"  # NumPy's kinds of arrays that are written as nested lists


@functools.cache
def numpy_scalars(numpy):
    """Return the ids of NumPy's scalar types."""
    return {id(cls) for cls in numpy.sctypeDict.values()}


def _dtype_name(walk, value):
    name = _KIND_OF_DTYPE.get(value.dtype.kind)
    if name is None:
        raise walk.error(
            f"is of NumPy's kind {value.dtype.kind!r}; arrays may hold numbers, booleans, strings "
            "or SymPy"
        )
    return name


def write_scalar(walk, value):
    """Write a NumPy scalar as the Python number, boolean or string that it is."""
    return walk.plain(_PYTHON[_dtype_name(walk, value)](value))


def write_array(walk, value):
    """Write a NumPy array: numbers and booleans as base64 bytes, others by their elements."""
    if value.dtype.kind in AS_LISTS:
        return write_elements(walk, value)
    name = _dtype_name(walk, value)
    if value.size > MAX_ELEMENTS or value.ndim > MAX_AXES:
        raise walk.error(
            f"is an array of {value.size} elements; up to {MAX_ELEMENTS} along {MAX_AXES} axes are "
            f"allowed"
        )
    if value.dtype.kind == "u" and value.size and value.max() >= 2**63:
        raise walk.error("is an array with integers beyond 64 signed bits")
    data = base64.b64encode(value.astype(_DTYPES[name]).tobytes()).decode("ascii")
    return {"kind": "array", "dtype": name, "shape": list(value.shape), "data": data}


def write_elements(walk, array):
    """Write an array by its elements, which are visited like those of nested lists."""
    if math.prod(max(1, size) for size in array.shape) > MAX_NODES:  # before the lists are made
        raise walk.error(
            f"is an array of shape {array.shape}; up to {MAX_NODES} elements that are no plain "
            "numbers are allowed"
        )
    return walk.visit(array.tolist()) if array.shape else walk.child("[()]", array[()])


def write_dm(walk, value):
    """Write a CasADi `DM` as the float array of its entries."""
    import numpy

    if math.prod(value.shape) > MAX_ELEMENTS:  # before a sparse one is made dense
        raise walk.error(
            f"is a DM of {math.prod(value.shape)} elements; up to {MAX_ELEMENTS} are allowed"
        )
    return write_array(walk, numpy.array(value.full()))


def read_array(walk, dtype, shape, data):
    """Read an array of numbers or booleans."""
    import numpy

    if type(dtype) is not str or dtype not in _DTYPES:
        raise walk.error(f"should be an array of one of {list(_DTYPES)}")
    sizes = [walk.integer(size) for size in walk.as_list(shape)]
    if (
        len(sizes) > MAX_AXES
        or not all(0 <= size <= MAX_ELEMENTS for size in sizes)
        or math.prod(sizes) > MAX_ELEMENTS
    ):
        raise walk.error(
            f"should be an array of up to {MAX_ELEMENTS} elements along up to {MAX_AXES} axes"
        )
    raw = base64.b64decode(walk.text(data, MAX_BYTES), validate=True)
    wire = numpy.dtype(_DTYPES[dtype])
    if (
        len(raw) != math.prod(sizes) * wire.itemsize
        or base64.b64encode(raw).decode("ascii") != data
    ):
        raise walk.error("is an array whose data do not fit its shape")
    if dtype == "bool" and raw.strip(b"\0\1"):
        raise walk.error("is an array of booleans with a byte that is neither 0 nor 1")
    # A copy, since an array over bytes is read-only.
    return numpy.frombuffer(raw, wire).reshape(sizes).astype(wire.newbyteorder("="))
