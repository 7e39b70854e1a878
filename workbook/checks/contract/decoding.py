"""Decoding of answers: values built from the bytes that `encoding.encode` wrote.

Nothing of the student's is executed: names from the text are looked up in closed lists only.
"""

import json

from workbook.checks.contract.arrays import read_array
from workbook.checks.contract.encoding import (
    PLAIN_WRITERS,
    canonical_json,
    check_length,
    describe,
    is_plain_key,
    key_step,
)
from workbook.checks.contract.limits import DOUBLE_BITS
from workbook.checks.contract.traversal import EncodingError, Traversal, type_name


def decode(data):
    """Return the value that `encode` turned into bytes.

    Parameters
    ----------
    data : bytes
        Text that `encode` wrote, or foreign bytes.

    Returns
    -------
    object
        A value equal to the encoded one.

    Raises
    ------
    EncodingError
        For bytes that `encode` would not have written and for numbers too large to work with; no
        other error is raised.

    Notes
    -----
    The result has the form of the encoded value, too: nothing is computed, and what was left
    unevaluated stays so. Intended differences: NumPy scalars come back as Python numbers and
    strings, a Fraction and mpmath's numbers as SymPy's, a Float of few digits as one of double
    precision, DM and sparse matrices as dense arrays and matrices, arrays of objects and
    `sympy.Array` as nested lists, `UnevaluatedExpr(x)` as `x`, a Poly over the domain that its
    coefficients suggest, and a Dummy as one that equals only Dummies decoded with the same name and
    number.

    Examples
    --------
    >>> decode(b'{"items":[1,2],"kind":"tuple"}')
    (1, 2)
    >>> decode(b'{"kind":"__class__"}')
    Traceback (most recent call last):
    workbook.checks.contract.traversal.EncodingError: answer is of the unknown kind '__class__'
    """
    return _built(Decoder(), data)


def describe_encoded(data):
    """Return a short readable text of an encoded answer.

    Parameters
    ----------
    data : bytes
        As for `decode`.

    Returns
    -------
    str
        The text that `describe` gives of the encoded value: a Float shows the digits that it had,
        not those of a double.

    Raises
    ------
    EncodingError
        As for `decode`.

    Examples
    --------
    >>> import sympy as sp
    >>> from workbook.checks.contract.encoding import encode
    >>> describe_encoded(encode([sp.Float("18.2574", 6)]))
    '[18.2574]'
    """
    decoder = Decoder()
    decoder.least_precision = 1
    return describe(_built(decoder, data))


def _built(decoder, data):
    try:
        return decoder.visit(_loads(data))
    except EncodingError:
        raise
    # a constructor's own: contradictory assumptions, an unhashable element, a wrong count of
    # arguments
    except Exception as error:
        raise decoder.error(f"cannot be built ({type_name(error)})") from None


def _loads(data):
    """Return the JSON value of a text that is written exactly as `encode` writes it.

    Comparing with the canonical text refuses, all at once, duplicate keys, blanks, trailing bytes,
    numbers in another notation, and escapes for what needs none.
    """
    if type(data) is not bytes:
        raise EncodingError("answer should be bytes")
    check_length(data)
    try:
        text = data.decode("utf-8")
        node = json.loads(text)
        canonical = canonical_json(node) == text
    except (ValueError, RecursionError) as error:
        raise EncodingError(f"answer is not JSON text in UTF-8 ({type_name(error)})") from None
    if not canonical:
        raise EncodingError("answer is not written in the canonical form of an encoded answer")
    return node


class Decoder(Traversal):
    """Builds values from the nodes of a JSON text."""

    def __init__(self):
        super().__init__()
        self.functions = {}  # the undefined functions of SymPy met so far
        # As a number compares, so it is judged: a Float of a single bit would equal all that
        # rounds to it.
        self.least_precision = DOUBLE_BITS

    def visit(self, node):
        self.spend(1)
        cls = type(node)
        if cls is dict:
            return self.kind(node)
        if cls is type(None):
            raise self.error("is null, which is not an answer")
        # JSON's other types are their own encoding, under the same limits
        return PLAIN_WRITERS[id(cls)](self, node)

    def kind(self, node):
        """Build the value of an object by its "kind"."""
        kind = node.get("kind")
        readers = READERS
        if type(kind) is str and kind not in readers:
            from workbook.checks.contract import sympy_codec  # imports SymPy

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
        """Return a list after checking that it is one."""
        if type(value) is not list:
            raise self.error("should hold a list here")
        return value

    def items(self, value, step="[{}]"):
        """Build the values of a list of nodes."""
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
        if len(walk.as_list(pair)) != 2 or not is_plain_key(pair[0]):
            raise walk.error("is a dict whose items should be pairs of a plain key and a value")
        key = walk.child(f".keys[{i}]", pair[0])
        if key in result:
            raise walk.error("is a dict with a key given twice")
        result[key] = walk.child(key_step(key, i), pair[1])
    return result


READERS = {
    "ellipsis": ((), lambda walk: ...),
    "float": (("value",), _read_float),
    "complex": (("real", "imag"), _read_complex),
    "tuple": (("items",), lambda walk, items: tuple(walk.items(items))),
    "set": (("items",), _read_set(set)),
    "frozenset": (("items",), _read_set(frozenset)),
    "dict": (("items",), _read_dict),
    "array": (("dtype", "shape", "data"), read_array),
}
