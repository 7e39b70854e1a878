"""Traversal of an answer while it is encoded or decoded: position, limits and errors."""

from workbook.checks.contract.limits import MAX_DEPTH, MAX_DIGITS, MAX_NODES, MAX_TEXT

_TOO_LARGE = 10**MAX_DIGITS


class EncodingError(ValueError):
    """An answer that cannot be encoded or decoded.

    The message, written to be shown to the student, says what was met, at which position of the
    answer (`answer[2]['x']`), and what is allowed.
    """


def type_name(value):
    """Return the name of a value's type without running foreign code."""
    # The descriptor of `type` itself, since a metaclass may define a `__name__` of its own.
    return type.__dict__["__name__"].__get__(type(value))[:60]


class Traversal:
    """The position within an answer and how much of it has been visited.

    The encoder and the decoder derive from it: both count and limit alike, so that nothing is
    written that cannot be read. They define `visit(item)`.
    """

    def __init__(self):
        self.path = []
        self.nodes = 0
        self.sizes = {}  # of SymPy nodes, as `magnitude.size` found them

    def child(self, step, item):
        """Visit `item`, which is at `step` below the current value."""
        self.path.append(step)
        if len(self.path) > MAX_DEPTH:
            raise self.error(f"lies deeper than the {MAX_DEPTH} levels allowed")
        result = self.visit(item)
        self.path.pop()
        return result

    def children(self, items, step="[{}]"):
        """Visit items that are at `step`, formatted with their index."""
        return [self.child(step.format(i), item) for i, item in enumerate(items)]

    def spend(self, nodes):
        """Count values against the limit of all that an answer may have."""
        self.nodes += nodes
        if self.nodes > MAX_NODES:
            raise self.error(f"makes the answer too large: up to {MAX_NODES} values are allowed")

    def error(self, message):
        """Return an `EncodingError` on the current value."""
        steps = self.path if len(self.path) <= 12 else [*self.path[:6], " ... ", *self.path[-6:]]
        return EncodingError(f"answer{''.join(steps)} {message}")

    def integer(self, value):
        """Return an integer after checking its type and size."""
        if type(value) is not int:
            raise self.error("should be an integer here")
        if abs(value) >= _TOO_LARGE:
            raise self.error(f"is an integer of more than the {MAX_DIGITS} digits allowed")
        return value

    def text(self, value, limit=MAX_TEXT):
        """Return a string after checking its type, length and code points."""
        if type(value) is not str:
            raise self.error("should be a string here")
        if len(value) > limit:
            raise self.error(f"is a string of {len(value)} characters; up to {limit} are allowed")
        try:
            value.encode("utf-8")
        except UnicodeEncodeError:
            raise self.error("is a string with half a character (a lone surrogate)") from None
        return value
