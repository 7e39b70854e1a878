"""Answers as bytes: the one way a student's values leave the sandbox.

A notebook runs in a sandboxed worker; its answers reach the judge only as the text that `encode`
writes, and `decode` builds values from that text without executing anything of the student's: no
pickle, no `eval`, no `sympify` of strings, no attribute looked up by a name from the wire. What may
cross is a closed list, the same in both directions:

- bool, int, float (with nan and the infinities), complex, str, and the untouched stub `...`;
- NumPy scalars (they become Python numbers and strings) and arrays of bool, int, float or complex;
  CasADi `DM` (becomes a float array);
- SymPy numbers, expressions, relations, conditions, sets, Piecewise laws, matrices and polynomials
  (`sympy_codec` lists the nodes);
- `Fraction` and mpmath's numbers (they become SymPy's);
- lists, tuples, sets and frozensets of these, and dicts of these keyed by strings, numbers or
  SymPy;
- NumPy arrays of these (dtype object) or of strings, and `sympy.Array` (they become nested lists).

Types are compared by identity, never by `isinstance`: a subclass of an allowed type may carry
foreign code, so it is refused unread. A check in a notebook first sends the answer through here too
(`verdict.judged`), so that a student reads there what a grader would say.

The text is UTF-8 JSON in one canonical form. Booleans, finite numbers, strings and lists are
themselves; everything else is an object with a "kind". Equal sets and dicts give equal bytes,
whatever their order. Limits (below) bound the time and memory of both directions.

>>> encode({"gain": [1.5, 2], "stable": True})
b'{"items":[["gain",[1.5,2]],["stable",true]],"kind":"dict"}'
>>> decode(_)
{'gain': [1.5, 2], 'stable': True}
"""

import base64
import functools
import itertools
import json
import math
import sys

MAX_BYTES = 2_000_000  # of the whole text
MAX_NODES = 20_000  # values met, at any depth
# in the text: few values need as many, and parsing makes an object of each
MAX_BRACKETS = 4 * MAX_NODES
MAX_DEPTH = 100  # values inside one another, far below Python's recursion limit
# of an integer, a numerator or a denominator; the magnitude of any number, too
MAX_DIGITS = 2_000
MAX_TEXT = 20_000  # characters of a string
MAX_ELEMENTS = 100_000  # of an array
MAX_AXES = 8  # of an array
MAX_DESCRIPTION = 300  # characters that `describe` returns

ALLOWED = (
    "An answer may be a number, a string, an array, a SymPy expression, relation, set or matrix, "
    "or a list or dict of these."
)


class EncodingError(ValueError):
    """What was met, where in the answer (`answer[2]['x']`), and what is allowed; written to be
    shown to the student."""


def encode(value):
    """Return `value` as canonical UTF-8 JSON bytes.

    Accepts the values listed in the module's docstring, within its limits. Raises `EncodingError`
    for anything else, without calling any method of it.

    >>> encode([1, 2.5, float("nan")])
    b'[1,2.5,{"kind":"float","value":"nan"}]'
    >>> encode({3, 1, 2}) == encode({2, 3, 1})
    True
    >>> encode([0, {"x": lambda t: t}])
    Traceback (most recent call last):
    workbook.checks.contract.encoding.EncodingError: answer[1]['x'] is a function, and functions are not data: \
write its formula in SymPy, or `sympy.Lambda((x1, x2), formula)`. An answer may be a number, a string, an array, \
a SymPy expression, relation, set or matrix, or a list or dict of these.
    """
    walk = _Encoder()
    try:
        data = _dumps(walk.finish(walk.visit(value))).encode("utf-8")
    except EncodingError:
        raise
    # a value that breaks on being read, such as a half-built SymPy object
    except Exception as error:
        raise walk.error(f"cannot be read ({_type_name(error)})") from None
    _check_length(data)
    return data


def decode(data):
    """Return the value that `encode` turned into `data`.

    The result equals what was encoded, in form too: nothing is computed, and what was left
    unevaluated stays so. Intended differences: NumPy scalars come back as Python numbers and
    strings, a Fraction and mpmath's numbers as SymPy's, a Float of few digits as one of double
    precision, DM and sparse matrices as dense arrays and matrices, arrays of objects and
    `sympy.Array` as nested lists, `UnevaluatedExpr(x)` as `x`, a Poly over the domain that its
    coefficients suggest, and a Dummy as one that equals only Dummies decoded with the same name and
    number.

    Raises `EncodingError`, and nothing else, for bytes that `encode` would not have written and for
    numbers too large to work with.

    >>> decode(b'{"items":[1,2],"kind":"tuple"}')
    (1, 2)
    >>> decode(b'{"kind":"__class__"}')
    Traceback (most recent call last):
    workbook.checks.contract.encoding.EncodingError: answer is of the unknown kind '__class__'
    """
    walk = _Decoder()
    try:
        return walk.visit(_loads(data))
    except EncodingError:
        raise
    # a constructor's own: contradictory assumptions, an unhashable element, a wrong count of
    # arguments
    except Exception as error:
        raise walk.error(f"cannot be built ({_type_name(error)})") from None


def describe(value):
    """Return a short readable text of any object, for feedback; of an object that is no answer,
    only the name of its type.

    Never raises, never calls a foreign `__repr__` or `__str__`, and is at most `MAX_DESCRIPTION`
    characters long.

    >>> describe([1, 2.5, ...])
    '[1, 2.5, ...]'
    >>> describe(object())
    '<object>'
    """
    text = _text(value, depth=0)
    return text if len(text) <= MAX_DESCRIPTION else text[: MAX_DESCRIPTION - 3] + "..."


def _check_length(data):
    if len(data) > MAX_BYTES or data.count(b"[") + data.count(b"{") > MAX_BRACKETS:
        raise EncodingError(
            f"answer takes {len(data)} bytes; up to {MAX_BYTES}, with {MAX_BRACKETS} brackets, are "
            f"allowed"
        )


# The walk: where we are in a value and how much of it has been met, counted alike in both
# directions.


class _Walk:
    def __init__(self):
        self.path = []
        self.nodes = 0
        self.sizes = {}  # what `sympy_codec` has found about the size of each SymPy node

    def child(self, step, item):
        """Visit `item`, which stands at `step` below the current value."""
        self.path.append(step)
        if len(self.path) > MAX_DEPTH:
            raise self.error(f"lies deeper than the {MAX_DEPTH} levels allowed")
        result = self.visit(item)
        self.path.pop()
        return result

    def children(self, items, step="[{}]"):
        return [self.child(step.format(i), item) for i, item in enumerate(items)]

    def spend(self, nodes):
        self.nodes += nodes
        if self.nodes > MAX_NODES:
            raise self.error(f"makes the answer too large: up to {MAX_NODES} values are allowed")

    def error(self, message):
        steps = self.path if len(self.path) <= 12 else [*self.path[:6], " ... ", *self.path[-6:]]
        return EncodingError(f"answer{''.join(steps)} {message}")

    # The checks of plain values that both directions share; each returns its argument.

    def integer(self, value):
        if type(value) is not int:
            raise self.error("should be an integer here")
        if abs(value) >= _TOO_LARGE:
            raise self.error(f"is an integer of more than the {MAX_DIGITS} digits allowed")
        return value

    def text(self, value, limit=MAX_TEXT):
        if type(value) is not str:
            raise self.error("should be a string here")
        if len(value) > limit:
            raise self.error(f"is a string of {len(value)} characters; up to {limit} are allowed")
        try:
            value.encode("utf-8")
        except UnicodeEncodeError:
            raise self.error("is a string with half a character (a lone surrogate)") from None
        return value


_TOO_LARGE = 10**MAX_DIGITS


def _type_name(value):
    # The descriptor of `type` itself, since a metaclass may define a `__name__` of its own.
    return type.__dict__["__name__"].__get__(type(value))[:60]


def _dumps(node):
    return json.dumps(
        node, ensure_ascii=False, allow_nan=False, sort_keys=True, separators=(",", ":")
    )


# Encoding


class _Encoder(_Walk):
    def __init__(self):
        super().__init__()
        self.dummies = []  # nodes written for Dummy symbols, numbered at the end

    def visit(self, value):
        self.spend(1)
        # Keyed by id, since looking a class up in a dict would call `__hash__` and `__eq__` of its
        # metaclass.
        write = _PLAIN.get(id(type(value))) or _library_encoder(value)
        if write is None:
            raise self.error(_refusal(value))
        return write(self, value)

    def finish(self, node):
        """Number the Dummies 0, 1, ... in the order of their creation, which unlike SymPy's own
        index is the same in every process."""
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
    name = _type_name(value)
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
    return {"kind": _KIND_OF_SET[id(type(value))], "items": sorted(items, key=_dumps)}


def _write_dict(walk, value):
    items = []
    for i, (key, item) in enumerate(value.items()):
        written = walk.child(f".keys[{i}]", key)
        if not _is_key(written):
            raise walk.error(
                f"has the key {describe(key)}; keys may be strings, numbers or SymPy expressions"
            )
        items.append([written, walk.child(_step(key, i), item)])
    return {"kind": "dict", "items": sorted(items, key=lambda pair: _dumps(pair[0]))}


def _step(key, i):
    """The path to a dict's value: by its key where that is short and plain."""
    plain = (type(key) is str and len(key) <= 40) or (type(key) is int and abs(key) < 10**9)
    return f"[{key!r}]" if plain else f".values[{i}]"


def _is_key(node):
    # What may not be a key: collections and arrays. (A mutable SymPy Matrix is unhashable, so it
    # never is one.)
    return type(node) is not list and (type(node) is not dict or node["kind"] not in _NOT_KEYS)


_NOT_KEYS = {"tuple", "set", "frozenset", "dict", "array", "ellipsis"}
_KIND_OF_SET = {id(set): "set", id(frozenset): "frozenset"}

_PLAIN = {
    id(bool): lambda walk, value: value,
    id(int): _Walk.integer,
    id(float): _write_float,
    id(complex): _write_complex,
    id(str): _Walk.text,
    id(type(...)): lambda walk, value: {"kind": "ellipsis"},
    id(list): _Walk.children,
    id(tuple): lambda walk, value: {"kind": "tuple", "items": walk.children(value)},
    id(set): _write_set,
    id(frozenset): _write_set,
    id(dict): _write_dict,
}

# NumPy's and CasADi's types exist only where these are loaded; a plain answer must not load them.

_DTYPES = {"bool": "?", "int": "<i8", "float": "<f8", "complex": "<c16"}
_KIND_OF_DTYPE = {"b": "bool", "i": "int", "u": "int", "f": "float", "c": "complex", "U": "str"}
_PYTHON = {"bool": bool, "int": int, "float": float, "complex": complex, "str": str}
_AS_LISTS = "OU"  # arrays of these kinds are written as nested lists
_KNOWN_TO_SYMPY = ("sympy", "mpmath", "fractions")


def _library_encoder(value):
    if numpy := sys.modules.get("numpy"):
        if type(value) is numpy.ndarray:
            return _write_array
        if id(type(value)) in _numpy_scalars(numpy):
            return _write_scalar
    if (casadi := sys.modules.get("casadi")) and type(value) is casadi.DM:
        return _write_dm
    if any(name in sys.modules for name in _KNOWN_TO_SYMPY):
        from workbook.checks.contract import sympy_codec

        return sympy_codec.encoder(value)
    return None


@functools.cache
def _numpy_scalars(numpy):
    return {id(cls) for cls in numpy.sctypeDict.values()}


def _dtype_name(walk, value):
    name = _KIND_OF_DTYPE.get(value.dtype.kind)
    if name is None:
        raise walk.error(
            f"is of NumPy's kind {value.dtype.kind!r}; arrays may hold numbers, booleans, strings "
            "or SymPy"
        )
    return name


def _write_scalar(walk, value):
    return _PLAIN[id(cls := _PYTHON[_dtype_name(walk, value)])](walk, cls(value))


def _write_array(walk, value):
    if value.dtype.kind in _AS_LISTS:
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
    """An array by its elements, which are visited like those of nested lists."""
    if math.prod(max(1, size) for size in array.shape) > MAX_NODES:  # before the lists are made
        raise walk.error(
            f"is an array of shape {array.shape}; up to {MAX_NODES} elements that are no plain "
            "numbers are allowed"
        )
    return walk.visit(array.tolist()) if array.shape else walk.child("[()]", array[()])


def _write_dm(walk, value):
    import numpy

    if math.prod(value.shape) > MAX_ELEMENTS:  # before a sparse one is made dense
        raise walk.error(
            f"is a DM of {math.prod(value.shape)} elements; up to {MAX_ELEMENTS} are allowed"
        )
    return _write_array(walk, numpy.array(value.full()))


# Decoding


def _loads(data):
    """The JSON value in `data`, which must be written exactly as `encode` writes it.

    Comparing with the canonical text refuses, all at once, duplicate keys, blanks, trailing bytes,
    numbers in another notation, and escapes for what needs none.
    """
    if type(data) is not bytes:
        raise EncodingError("answer should be bytes")
    _check_length(data)
    try:
        text = data.decode("utf-8")
        node = json.loads(text)
        canonical = _dumps(node) == text
    except (ValueError, RecursionError) as error:
        raise EncodingError(f"answer is not JSON text in UTF-8 ({_type_name(error)})") from None
    if not canonical:
        raise EncodingError("answer is not written in the canonical form of an encoded answer")
    return node


class _Decoder(_Walk):
    def __init__(self):
        super().__init__()
        self.functions = {}  # the undefined functions of SymPy met so far

    def visit(self, node):
        self.spend(1)
        cls = type(node)
        if cls is dict:
            return self.kind(node)
        if cls is type(None):
            raise self.error("is null, which is not an answer")
        # JSON's other types are their own encoding, under the same limits
        return _PLAIN[id(cls)](self, node)

    def kind(self, node):
        kind = node.get("kind")
        readers = _READERS
        if type(kind) is str and kind not in readers:
            from workbook.checks.contract import sympy_codec

            readers = sympy_codec.READERS
        if type(kind) is not str or kind not in readers:
            raise self.error(f"is of the unknown kind {describe(kind)[:60]}")
        fields, read = readers[kind]
        if node.keys() != {"kind", *fields}:
            raise self.error(
                f"should have exactly the fields {sorted(fields)}, as a value of kind {kind!r}"
            )
        return read(self, **{field: node[field] for field in fields})

    def as_list(self, value):
        if type(value) is not list:
            raise self.error("should hold a list here")
        return value

    def items(self, value, step="[{}]"):
        return self.children(self.as_list(value), step)


def _read_float(walk, value):
    if type(value) is not str or value not in ("nan", "inf", "-inf"):
        raise walk.error("should be nan, inf or -inf here")
    return float(value)


def _read_complex(walk, real, imag):
    parts = [walk.child(".real", real), walk.child(".imag", imag)]
    if any(type(part) is not float for part in parts):
        raise walk.error("should have floats as its real and imaginary part")
    return complex(*parts)


def _read_set(collection):
    def read(walk, items):
        result = collection(walk.items(items))
        if len(result) != len(items):
            raise walk.error("is a set with an element given twice")
        return result

    return read


def _read_dict(walk, items):
    result = {}
    for i, pair in enumerate(walk.as_list(items)):
        if len(walk.as_list(pair)) != 2 or not _is_key(pair[0]):
            raise walk.error("is a dict whose items should be pairs of a plain key and a value")
        key = walk.child(f".keys[{i}]", pair[0])
        if key in result:
            raise walk.error("is a dict with a key given twice")
        result[key] = walk.child(_step(key, i), pair[1])
    return result


def _read_array(walk, dtype, shape, data):
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


_READERS = {
    "ellipsis": ((), lambda walk: ...),
    "float": (("value",), _read_float),
    "complex": (("real", "imag"), _read_complex),
    "tuple": (("items",), lambda walk, items: tuple(walk.items(items))),
    "set": (("items",), _read_set(set)),
    "frozenset": (("items",), _read_set(frozenset)),
    "dict": (("items",), _read_dict),
    "array": (("dtype", "shape", "data"), _read_array),
}

# Describing


def _text(value, depth):
    write = _TEXTS.get(id(type(value)))
    if write:
        return write(value, depth)
    try:
        # so that all of it is known, and nothing foreign is asked to print itself
        data = encode(value)
        return _LIBRARY_TEXTS.get(_library_encoder(value), _text_of_sympy)(value, data)
    # not only a refusal: a printer may fail on odd but legal objects, a description must not
    except Exception:
        return f"<{_type_name(value)}>"


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

    if value.dtype.kind in _AS_LISTS:
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
    _write_scalar: lambda value, data: str(value),
    _write_array: _text_of_array,
    _write_dm: lambda value, data: _text_of_array(value.full(), data),
}
