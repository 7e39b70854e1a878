"""Limits of an encoded answer, which bound the time and memory of writing and reading it."""

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
DOUBLE_BITS = 53  # precision of a float
