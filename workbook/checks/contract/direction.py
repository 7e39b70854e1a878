"""Whether a message says in which direction a number is wrong.

In practice it does. The check cells of a homework leave it out, since halving an interval finds a
number in ten questions.
"""

from contextlib import contextmanager
from contextvars import ContextVar

_shown = ContextVar("direction shown", default=True)


def directed(message, otherwise):
    """Return a text that says whether a number is too great or too small, or `otherwise`."""
    return message if _shown.get() else otherwise


def hide_direction():
    """Leave out of the following verdicts whether a number is too great or too small.

    It stands above the checks in the check cells of a homework.
    """
    _shown.set(False)


@contextmanager
def separate_direction():
    """Show the direction at first, and undo at the end what cells have hidden.

    Examples
    --------
    >>> with separate_direction():
    ...     hide_direction()
    ...     directed("the time is too short", "it is another time")
    'it is another time'
    >>> directed("the time is too short", "it is another time")
    'the time is too short'
    """
    token = _shown.set(True)
    try:
        yield
    finally:
        _shown.reset(token)
