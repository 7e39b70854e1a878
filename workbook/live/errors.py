"""Errors of a lecture in one line: the class watches, and a traceback helps nobody there."""


class LiveError(ValueError):
    """An error of one line that a lecturer can fix; a cell shows the line without a traceback."""

    def _render_traceback_(self):
        return [str(self)]


def error_line(error):
    """Return an error as one line, with its type unless the lecturer can fix it.

    >>> error_line(LiveError("there is no explorer maze"))
    'there is no explorer maze'
    >>> error_line(ZeroDivisionError("division by zero"))
    'this does not work: ZeroDivisionError: division by zero'
    """
    message = str(error).partition("\n")[0]
    if isinstance(error, LiveError):
        return message
    return f"this does not work: {type(error).__name__}: {message}".removesuffix(": ")
