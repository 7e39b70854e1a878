"""`checks.report`: the last line of every check cell."""

import html
import sys
from contextlib import contextmanager
from contextvars import ContextVar

from trajlib.checks.contract.verdict import INVALID, MISSING, RIGHT, UNCHECKED, WRONG, Verdict

MARKS = {RIGHT: "✓", WRONG: "✗", MISSING: "…", INVALID: "?", UNCHECKED: "!"}

_collected = ContextVar("collected verdicts", default=None)


class NotYet(Exception):
    """Raised when not every answer of a check cell is right; the message is the report itself."""

    def __init__(self, verdicts):
        super().__init__(_as_text(verdicts))
        self.verdicts = verdicts

    def _render_traceback_(self):
        # Jupyter asks for this instead of the traceback: the student reads the verdicts and nothing else.
        return str(self).split("\n")


def report(**verdicts):
    """Show a line for each answer; raise `NotYet` unless all are right.

    `report(a_region=checks.stability_region(a_region, ...), ...)`: the names are those of the answer variables, the
    values what the checks return. An error for nbgrader and for the site's build, a polite message in Jupyter.

    >>> report(a=Verdict("right", "it solves the equation"))
    ✓ a: right: it solves the equation
    """
    for name, verdict in verdicts.items():
        if not isinstance(verdict, Verdict):
            verdicts[name] = Verdict(UNCHECKED, "the check cell was changed: it hands over no verdict")
    collected = _collected.get()
    if collected is not None:
        collected.update(verdicts)
        return
    if all(verdict.status == RIGHT for verdict in verdicts.values()):
        _show(verdicts)
    else:
        raise NotYet(verdicts)


@contextmanager
def collecting():
    """Inside this context `report` neither shows nor raises: it adds its verdicts to the dict given back.

    >>> with collecting() as verdicts:
    ...     report(a=Verdict("missing", "not answered yet"))
    >>> verdicts["a"].status
    'missing'
    """
    token = _collected.set({})
    try:
        yield _collected.get()
    finally:
        _collected.reset(token)


def _as_text(verdicts):
    return "\n".join(f"{MARKS[v.status]} {name}: {v.status}: {v.message}" for name, v in verdicts.items())


def _as_html(verdicts):
    lines = (f'<div class="trajlib-verdict {v.status}"><span class="mark">{MARKS[v.status]}</span> '
             f"<code>{html.escape(name)}</code> <span>{v.status}: {html.escape(v.message)}</span></div>"
             for name, v in verdicts.items())
    return f'<div class="trajlib-report">{"".join(lines)}</div>'


def _show(verdicts):
    # IPython is not imported for this: outside a notebook the text is printed.
    ipython = sys.modules.get("IPython")
    if ipython is not None and getattr(ipython.get_ipython(), "kernel", None) is not None:
        from IPython.display import display
        display({"text/plain": _as_text(verdicts), "text/html": _as_html(verdicts)}, raw=True)
    else:
        print(_as_text(verdicts))
