"""`checks.report`: the last line of every check cell.

In Jupyter the report is shown as HTML, each line with the mark and the colours of its own verdict;
the error that follows unless all are right (nbgrader and the build want one) is then a single line
that counts.
"""

import html
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import replace

from trajlib.typesetting import typeset
from workbook.checks.contract import error_hints
from workbook.checks.contract.verdict import INVALID, MISSING, RIGHT, UNCHECKED, WRONG, Verdict
from workbook.display.results import runs_in_notebook

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
    """Raised when not every answer of a check cell is right; the message is the report itself."""

    def __init__(self, verdicts):
        super().__init__(_as_text(verdicts))
        self.verdicts = verdicts

    def _render_traceback_(self):
        # Jupyter asks for this instead of the traceback: the student reads the verdicts and nothing
        # else.
        if not runs_in_notebook():
            return str(self).split("\n")
        right = sum(verdict.status == RIGHT for verdict in self.verdicts.values())
        return [f"Not yet: {right} of {len(self.verdicts)} right."]


def report(problem="", /, **verdicts):
    """Show a line for each answer; raise `NotYet` unless all are right.

    `report(a_region=checks.stability_region(a_region, ...), ...)`: the names are those of the
    answer variables, the values what the checks return. An error for nbgrader and for the site's
    build, a polite message in Jupyter. A wrong answer to a `problem`, whose number stands first in
    the students' notebooks, is told the mistake if that is known.

    >>> report(a=Verdict("right", "it solves the equation"))
    ✓ a: right: it solves the equation
    """
    for name, verdict in verdicts.items():
        if not isinstance(verdict, Verdict):
            verdicts[name] = Verdict(
                UNCHECKED, "the check cell was changed: it hands over no verdict"
            )
        elif name in error_hints.stopped:
            verdicts[name] = Verdict(
                MISSING,
                "not judged: the cell that assigns it stopped with "
                f"{error_hints.stopped[name]}; mend that first",
            )
        elif problem and verdict.status == WRONG:
            verdicts[name] = replace(
                verdict, mistake=_mistake(problem, name, verdict.answer), answer=None
            )
    collected = _collected.get()
    if collected is not None:
        collected.update(verdicts)
        return
    right = all(verdict.status == RIGHT for verdict in verdicts.values())
    if runs_in_notebook():
        _display(verdicts)
    elif right:
        print(_as_text(verdicts))
    if not right:
        raise NotYet(verdicts)


@contextmanager
def collecting():
    """Inside this context `report` neither shows nor raises: it adds its verdicts to the dict given
    back.

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


def _mistake(problem, name, answer):
    from workbook.mistakes import find_mistake
    from workbook.notebooks.exercises import UnknownExercise

    try:
        return find_mistake(problem, name, answer)
    except UnknownExercise:  # a notebook of another edition
        return ""


def _as_text(verdicts):
    return "\n".join(
        line
        for name, v in verdicts.items()
        for line in (
            f"{MARKS[v.status]} {name}: {v.status}: {v.message}",
            *(f"  {line}" for line in v.mistake.splitlines()),
        )
    )


def _as_html(verdicts):
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
    """Ink on ground, dark on light in any theme; the site has colours of its own, for its dark
    pages too."""
    ink, ground = COLOURS[status]
    return (
        f"color: var(--{status}, {ink}); background: var(--{status}-ground, {ground}); padding: "
        ".4em .8em; margin: .3em 0; border-radius: .4em; overflow-wrap: break-word"
    )


def _display(verdicts):
    from IPython.display import display

    display({"text/plain": _as_text(verdicts), "text/html": _as_html(verdicts)}, raw=True)
