"""`checks.report`: the last line of every check cell.

It stands above the checks, since it names the mistake that may have led to a wrong answer;
`workbook.checks` gives it to notebooks under its own name.
"""

from dataclasses import replace

from workbook.checks.contract import error_hints
from workbook.checks.contract.reporting import deliver
from workbook.checks.contract.verdict import MISSING, UNCHECKED, WRONG, Verdict
from workbook.mistakes import find_mistake
from workbook.notebooks.exercises import UnknownExercise


def report(problem="", /, **verdicts):
    """Show a line for each answer; raise `NotYet` unless all are right.

    Parameters
    ----------
    problem : str, optional
        The problem's number, which stands first in the students' notebooks. With it the mistake that
        may have led to a wrong answer is shown if it is known.
    **verdicts : Verdict
        What the checks return, under the names of the answer variables.

    Raises
    ------
    NotYet
        An error for nbgrader and for the site's build, a short message in Jupyter.

    Notes
    -----
    A check cell ends with `checks.report(a_region=checks.stability_region(a_region, ...), ...)`.

    Examples
    --------
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
                f"not checked: its cell stopped with {error_hints.stopped[name]}; fix that first",
            )
        elif problem and verdict.status == WRONG:
            verdicts[name] = replace(
                verdict, mistake=_mistake(problem, name, verdict.answer), answer=None
            )
    deliver(verdicts)


def _mistake(problem, name, answer):
    try:
        return find_mistake(problem, name, answer)
    except UnknownExercise:  # a notebook of another edition
        return ""
