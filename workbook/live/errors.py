"""The error that a lecturer can fix."""


class LiveError(ValueError):
    """An error of one line that a lecturer can fix; a cell shows the line without a traceback."""

    def _render_traceback_(self):
        return [str(self)]
