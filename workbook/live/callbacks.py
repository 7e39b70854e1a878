"""Callbacks of the widgets of a lecture, whose errors are one line in the widget.

ipywidgets prints the traceback of a callback to a log that nobody sees on a slide.
"""

import html
from functools import wraps

import ipywidgets

from workbook.live.errors import error_line


class ErrorLine(ipywidgets.HTML):
    """The place in a widget where the error of its last callback stands."""

    def guard(self, callback):
        """Return the callback with its errors shown here instead of raised.

        Callbacks may call each other: the error of an inner one stays.
        """

        @wraps(callback)
        def guarded(*arguments):
            self.value = ""
            try:
                callback(*arguments)
            except Exception as error:
                self.value = f'<div class="workbook-text">{html.escape(error_line(error))}</div>'

        return guarded
