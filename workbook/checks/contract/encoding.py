"""Answers as bytes: the one way a student's values leave the sandbox.

A notebook runs in a sandboxed worker; its answers reach the judge only as the text that `encode`
writes, and `decoding.decode` builds values from that text without executing anything of the student's: no
pickle, no `eval`, no `sympify` of strings, no attribute looked up by a name from the wire. What may
cross is a closed list, the same in both directions:

- bool, int, float (with nan and the infinities), complex, str, and the untouched stub `...`;
- NumPy scalars (they become Python numbers and strings) and arrays of bool, int, float or complex;
  CasADi `DM` (becomes a float array);
- SymPy numbers, expressions, relations, conditions, sets, Piecewise laws, matrices and polynomials
  (`sympy_nodes` lists them);
- `Fraction` and mpmath's numbers (they become SymPy's);
- lists, tuples, sets and frozensets of these, and dicts of these keyed by strings, numbers or
  SymPy;
- NumPy arrays of these (dtype object) or of strings, and `sympy.Array` (they become nested lists).

Types are compared by identity, never by `isinstance`: a subclass of an allowed type may carry
foreign code, so it is refused unread. A check in a notebook first sends the answer through here too
(`verdict.judged`), so that a student reads there what a grader would say.

The text is UTF-8 JSON in one canonical form. Booleans, finite numbers, strings and lists are
themselves; everything else is an object with a "kind". Equal sets and dicts give equal bytes,
whatever their order. Limits (`limits`) bound the time and memory of both directions.

>>> encode({"gain": [1.5, 2], "stable": True})
b'{"items":[["gain",[1.5,2]],["stable",true]],"kind":"dict"}'
>>> from workbook.checks.contract.decoding import decode
>>> decode(_)
{'gain': [1.5, 2], 'stable': True}
"""

import itertools
import json
import math
import sys

from workbook.checks.contract.arrays import (
    AS_LISTS,
    numpy_scalars,
    write_array,
    write_dm,
    write_scalar,
)
from workbook.checks.contract.limits import MAX_BRACKETS, MAX_BYTES, MAX_DESCRIPTION
from workbook.checks.contract.traversal import EncodingError, Traversal, type_name

ALLOWED = (
    "An answer may be a number, a string, an array, a SymPy expression, relation, set or matrix, "
    "or a list or dict of these."
)


def encode(value):
    """Return an answer as canonical UTF-8 JSON bytes.

    Parameters
    ----------
    value : object
        One of the values that the module's docstring lists, within the limits.

    Returns
    -------
    bytes
        Equal for equal sets and dicts, whatever their order.

    Raises
    ------
    EncodingError
        For any other value, without calling a method of it.

    Examples
    --------
    >>> encode([1, 2.5, float("nan")])
    b'[1,2.5,{"kind":"float","value":"nan"}]'
    >>> encode({3, 1, 2}) == encode({2, 3, 1})
    True
    >>> encode([0, {"x": lambda t: t}])
    Traceback (most recent call last):
    workbook.checks.contract.traversal.EncodingError: answer[1]['x'] is a function, and functions are not data: \
write its formula in SymPy, or `sympy.Lambda((x1, x2), formula)`. An answer may be a number, a string, an array, \
a SymPy expression, relation, set or matrix, or a list or dict of these.
    """
    encoder = Encoder()
    try:
        data = canonical_json(encoder.finish(encoder.visit(value))).encode("utf-8")
    except EncodingError:
        raise
    # a value that breaks on being read, such as a half-built SymPy object
    except Exception as error:
        raise encoder.error(f"cannot be read ({type_name(error)})") from None
    check_length(data)
    return data


def describe(value):
    """Return a short readable text of any object, for feedback.

    Parameters
    ----------
    value : object
        An answer; of an object that is none only the name of its type is shown.

    Returns
    -------
    str
        At most `MAX_DESCRIPTION` characters.

    Notes
    -----
    Never raises and never calls a foreign `__repr__` or `__str__`.

    Examples
    --------
    >>> describe([1, 2.5, ...])
    '[1, 2.5, ...]'
    >>> describe(object())
    '<object>'
    """
    text = _text(value, depth=0)
    return text if len(text) <= MAX_DESCRIPTION else text[: MAX_DESCRIPTION - 3] + "..."


def check_length(data):
    """Refuse a text that is too long or too deeply bracketed."""
    if len(data) > MAX_BYTES or data.count(b"[") + data.count(b"{") > MAX_BRACKETS:
        raise EncodingError(
            f"answer takes {len(data)} bytes; up to {MAX_BYTES}, with {MAX_BRACKETS} brackets, are "
            f"allowed"
        )


def canonical_json(node):
    """Return the one JSON text of a node: keys sorted, no blanks, no escapes without need."""
    return json.dumps(
        node, ensure_ascii=False, allow_nan=False, sort_keys=True, separators=(",", ":")
    )


# Encoding


class Encoder(Traversal):
    """Writes values as the nodes of a JSON text."""

    def __init__(self):
        super().__init__()
        self.dummies = []  # nodes written for Dummy symbols, numbered at the end

    def visit(self, value):
        self.spend(1)
        # Keyed by id, since looking a class up in a dict would call `__hash__` and `__eq__` of its
        # metaclass.
        write = PLAIN_WRITERS.get(id(type(value))) or library_encoder(value)
        if write is None:
            raise self.error(_refusal(value))
        return write(self, value)

    def plain(self, value):
        """Write a value of one of Python's own types without counting it again."""
        return PLAIN_WRITERS[id(type(value))](self, value)

    def finish(self, node):
        """Number the Dummies 0, 1, ... in the order of their creation.

        SymPy's own index differs between processes, this number does not.
        """
        rank = {
            index: i for i, index in enumerate(sorted({dummy["index"] for dummy in self.dummies}))
        }
        for dummy in self.dummies:
            dummy["index"] = rank[dummy["index"]]
        return node


_HINTS = {
    "NoneType": "is None: was a value assigned, and does each function return one?",
    "Decimal": "is a Decimal: write a float or a `sympy.Rational`",
    "SX": "is a CasADi symbol: write the expression in SymPy",
    "MX": "is a CasADi symbol: write the expression in SymPy",
    "matrix": "is a matrix of NumPy or mpmath: write `sympy.Matrix(...)` or `numpy.array(...)`",
    **{
        f"{form}_{kind}": "is a sparse matrix: write `A.toarray()`"
        for form in ("csr", "csc", "coo", "dok", "lil", "dia", "bsr")
        for kind in ("matrix", "array")
    },
    **dict.fromkeys(
        ("OrderedDict", "defaultdict", "Counter", "Dict"),
        "is a dict of a kind of its own: write `dict(...)`",
    ),
    "constant": "is a constant of mpmath: write that of SymPy, such as `sympy.pi`",
    "UndefinedFunction": "is a function without its argument: write `x(t)`, not `x`",
}


def _refusal(value):
    name = type_name(value)
    if hint := _HINTS.get(name):
        return f"{hint}{'' if hint.endswith('?') else '.'} {ALLOWED}"
    if callable(value):
        return (
            f"is a {name}, and functions are not data: write its formula in SymPy, or "
            f"`sympy.Lambda((x1, x2), formula)`. {ALLOWED}"
        )
    return (
        f"is of the type {name}, which is not an answer (nor is a subclass of an allowed type: "
        f"write `list(...)` or the like). {ALLOWED}"
    )


def _write_float(walk, value):
    return value if math.isfinite(value) else {"kind": "float", "value": str(value)}


def _write_complex(walk, value):
    return {
        "kind": "complex",
        "real": walk.child(".real", value.real),
        "imag": walk.child(".imag", value.imag),
    }


def _write_set(walk, value):
    items = [walk.child("{...}", item) for item in value]
    return {"kind": _KIND_OF_SET[id(type(value))], "items": sorted(items, key=canonical_json)}


def _write_dict(walk, value):
    items = []
    for i, (key, item) in enumerate(value.items()):
        written = walk.child(f".keys[{i}]", key)
        if not is_plain_key(written):
            raise walk.error(
                f"has the key {describe(key)}; keys may be strings, numbers or SymPy expressions"
            )
        items.append([written, walk.child(key_step(key, i), item)])
    return {"kind": "dict", "items": sorted(items, key=lambda pair: canonical_json(pair[0]))}


def key_step(key, i):
    """Return the step to a value of a dict: its key if that is short and plain."""
    is_plain = (type(key) is str and len(key) <= 40) or (type(key) is int and abs(key) < 10**9)
    return f"[{key!r}]" if is_plain else f".values[{i}]"


def is_plain_key(node):
    """Return whether an encoded value may be a key of a dict: no collection, no array.

    A mutable SymPy Matrix is unhashable, so it never is a key.
    """
    return type(node) is not list and (type(node) is not dict or node["kind"] not in _NOT_KEYS)


_NOT_KEYS = {"tuple", "set", "frozenset", "dict", "array", "ellipsis"}
_KIND_OF_SET = {id(set): "set", id(frozenset): "frozenset"}

PLAIN_WRITERS = {
    id(bool): lambda walk, value: value,
    id(int): Traversal.integer,
    id(float): _write_float,
    id(complex): _write_complex,
    id(str): Traversal.text,
    id(type(...)): lambda walk, value: {"kind": "ellipsis"},
    id(list): Traversal.children,
    id(tuple): lambda walk, value: {"kind": "tuple", "items": walk.children(value)},
    id(set): _write_set,
    id(frozenset): _write_set,
    id(dict): _write_dict,
}

_KNOWN_TO_SYMPY = ("sympy", "mpmath", "fractions")


def library_encoder(value):
    """Return the function that writes a value of NumPy, CasADi or SymPy, or None."""
    if numpy := sys.modules.get("numpy"):
        if type(value) is numpy.ndarray:
            return write_array
        if id(type(value)) in numpy_scalars(numpy):
            return write_scalar
    if (casadi := sys.modules.get("casadi")) and type(value) is casadi.DM:
        return write_dm
    if any(name in sys.modules for name in _KNOWN_TO_SYMPY):
        # imports SymPy, which an answer of plain values does not need
        from workbook.checks.contract import sympy_codec

        return sympy_codec.encoder(value)
    return None


# Describing


def _text(value, depth):
    write = _TEXTS.get(id(type(value)))
    if write:
        return write(value, depth)
    try:
        # so that all of it is known, and nothing foreign is asked to print itself
        data = encode(value)
        return _LIBRARY_TEXTS.get(library_encoder(value), _text_of_sympy)(value, data)
    # not only a refusal: a printer may fail on odd but legal objects, a description must not
    except Exception:
        return f"<{type_name(value)}>"


def _text_of_integer(value, depth):
    return (
        str(value)
        if value.bit_length() < 200
        else f"an integer of about {int(value.bit_length() * math.log10(2))} digits"
    )


def _text_of_items(opening, closing):
    def write(value, depth):
        shown = [_text(item, depth + 1) for item in _first(value, depth)]
        return _joined(
            opening,
            sorted(shown) if type(value) in (set, frozenset) else shown,
            len(value),
            closing,
        )

    return write


def _text_of_dict(value, depth):
    shown = [
        f"{_text(key, depth + 1)}: {_text(item, depth + 1)}"
        for key, item in _first(value.items(), depth)
    ]
    return _joined("{", shown, len(value), "}")


def _first(items, depth):
    return itertools.islice(items, (20, 6, 3, 0)[min(depth, 3)])


def _joined(opening, shown, length, closing):
    return opening + ", ".join(shown + ["..."] * (length > len(shown))) + closing


def _text_of_array(value, data):
    import numpy

    if value.dtype.kind in AS_LISTS:
        return _text(value.tolist(), 0)
    shown = numpy.array2string(value, threshold=20, edgeitems=2, precision=6, separator=", ")
    return f"array of shape {value.shape}: {shown}"


def _text_of_sympy(value, data):
    import sympy

    # Sorting terms for print evaluates the numbers among them, integrals and sums too; so only what
    # is small and has none is sorted.
    slow = len(data) > 20_000 or b'"Integral"' in data or b'"Sum"' in data
    return sympy.sstr(value, order="none" if slow else None)


_TEXTS = {
    id(bool): lambda value, depth: repr(value),
    id(int): _text_of_integer,
    id(float): lambda value, depth: repr(value),
    id(complex): lambda value, depth: repr(value),
    id(str): lambda value, depth: repr(value[:MAX_DESCRIPTION]),
    id(type(None)): lambda value, depth: "None",
    id(type(...)): lambda value, depth: "...",
    id(list): _text_of_items("[", "]"),
    id(tuple): _text_of_items("(", ")"),
    id(set): _text_of_items("{", "}"),
    id(frozenset): _text_of_items("{", "}"),
    id(dict): _text_of_dict,
}
_LIBRARY_TEXTS = {
    write_scalar: lambda value, data: str(value),
    write_array: _text_of_array,
    write_dm: lambda value, data: _text_of_array(value.full(), data),
}
