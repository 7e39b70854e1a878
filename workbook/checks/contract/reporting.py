"""What becomes of the verdicts of a check cell: they are shown, or collected for a grader.

In Jupyter each line has the mark and the colours of its own verdict. No error follows where a person
runs the cells, so that "Run All" goes on to the next ones. Where a program does (nbgrader, the
build), an error of one line follows unless all are right, by which it knows.
`contract.report` calls `deliver`.
"""

import html
from contextlib import contextmanager
from contextvars import ContextVar

from trajlib.typesetting import typeset
from workbook.checks.contract.direction import separate_direction
from workbook.checks.contract.verdict import INVALID, MISSING, RIGHT, UNCHECKED, WRONG
from workbook.jupyter import runs_for_a_person, runs_in_notebook

MARKS = {RIGHT: "✓", WRONG: "✗", MISSING: "…", INVALID: "?", UNCHECKED: "!"}
#: Ink and ground of a line, with a contrast of at least 4.5.
COLOURS = {
    RIGHT: ("#17683a", "#eaf6ee"),
    WRONG: ("#a3262c", "#fdefee"),
    MISSING: ("#6a5a00", "#fbf6de"),
    INVALID: ("#74379a", "#f7effc"),
    UNCHECKED: ("#0f5a86", "#eaf4fb"),
}

_collected = ContextVar("collected verdicts", default=None)


class NotYet(Exception):
    """Raised when not every answer of a check cell is right; the message is the report itself.

    Parameters
    ----------
    verdicts : dict
        A `Verdict` for each name of an answer.
    """

    def __init__(self, verdicts):
        super().__init__(as_text(verdicts))
        self.verdicts = verdicts

    def _render_traceback_(self):
        # Jupyter asks for this instead of the traceback: the student reads the verdicts and nothing
        # else.
        if not runs_in_notebook():
            return str(self).split("\n")
        right = sum(verdict.status == RIGHT for verdict in self.verdicts.values())
        return [f"Not yet: {right} of {len(self.verdicts)} right."]


def deliver(verdicts):
    """Collect the verdicts of a check cell, or show them.

    Raises
    ------
    NotYet
        If not all are right, but not where a person at a notebook reads them.
    """
    collected = _collected.get()
    if collected is not None:
        collected.update(verdicts)
        return
    right = all(verdict.status == RIGHT for verdict in verdicts.values())
    if runs_in_notebook():
        _display(verdicts)
    elif right:
        print(as_text(verdicts))
    if not right and not runs_for_a_person():
        raise NotYet(verdicts)


@contextmanager
def collecting():
    """Collect the verdicts of all reports in this context, which neither show nor raise.

    Yields
    ------
    dict
        A `Verdict` for each name of an answer, filled as the reports run.

    Examples
    --------
    >>> from workbook.checks.contract.verdict import Verdict
    >>> with collecting() as verdicts:
    ...     deliver({"a": Verdict("missing", "not answered yet")})
    >>> verdicts["a"].status
    'missing'
    """
    token = _collected.set({})
    try:
        with separate_direction():
            yield _collected.get()
    finally:
        _collected.reset(token)


def as_text(verdicts):
    """Return the verdicts on the answers of a check cell as lines of text."""
    return "\n".join(
        line
        for name, v in verdicts.items()
        for line in (
            f"{MARKS[v.status]} {name}: {v.status}: {v.message}",
            *(f"  {line}" for line in v.mistake.splitlines()),
        )
    )


def as_html(verdicts):
    """Return the verdicts as HTML, with the mark and the colours of each."""
    lines = (
        f'<div class="workbook-verdict {v.status}" style="{_style(v.status)}"><span '
        f'class="mark">{MARKS[v.status]}'
        f'</span> <code style="color: inherit; background: none">{html.escape(name)}</code> '
        f"<span>{v.status}: {typeset(v.message)}</span>"
        + "".join(
            f'<div class="mistake" style="margin-top: .3em">{typeset(line)}</div>'
            for line in v.mistake.splitlines()
        )
        + "</div>"
        for name, v in verdicts.items()
    )
    return f'<div class="workbook-report">{"".join(lines)}</div>'


def _style(status):
    """Return the colours of a line, dark on light in any theme; the site overrides them."""
    ink, ground = COLOURS[status]
    return (
        f"color: var(--{status}, {ink}); background: var(--{status}-ground, {ground}); padding: "
        ".4em .8em; margin: .3em 0; border-radius: .4em; overflow-wrap: break-word"
    )


def _display(verdicts):
    from IPython.display import display

    display({"text/plain": as_text(verdicts), "text/html": as_html(verdicts)}, raw=True)
