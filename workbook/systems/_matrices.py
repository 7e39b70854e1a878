"""Matrices of records, read from numbers, lists and arrays."""

import sympy as sp


def set_matrices(record, shapes, determined_by, symmetric=(), meaning=""):
    """Make the named fields of a record matrices of these shapes, after checking them.

    Parameters
    ----------
    record : object
        A frozen dataclass, whose fields are replaced.
    shapes : dict
        The shape of each field, by name.
    determined_by : str
        The fields that determine the shapes, for the message.
    symmetric : tuple of str
        The fields that have to be symmetric.
    meaning : str
        What these are, for the message.
    """
    for name, shape in shapes.items():
        matrix = to_matrix(getattr(record, name), shape) if 0 not in shape else sp.zeros(*shape)
        if matrix.shape != shape:
            raise ValueError(
                f"{name} has the shape {matrix.shape}; with this {determined_by} it has to have {shape}"
            )
        if name in symmetric and sp.expand(matrix - matrix.T) != sp.zeros(*shape):
            raise ValueError(f"{name} is {meaning}, so it has to be symmetric")
        object.__setattr__(record, name, matrix.as_immutable())


def to_matrix(value, shape):
    """Return a matrix of a value; a number is 1 x 1, and 0 a zero matrix of the shape."""
    if _is_array(value):
        return sp.Matrix(value)
    return sp.zeros(*shape) if shape is not None and value == 0 else sp.Matrix([[value]])


def is_zero(value):
    """Return whether this is the number 0, which stands for a zero matrix of any shape."""
    return not _is_array(value) and value == 0


def _is_array(value):
    return isinstance(value, (list, tuple)) or bool(getattr(value, "shape", ()))
