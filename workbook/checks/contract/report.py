"""`checks.report`: the last line of every check cell.

On a wrong answer it also shows the sentence that the hook `find_mistake` returns.
"""

from dataclasses import replace

from workbook import hooks
from workbook.checks.contract import cell_watch
from workbook.checks.contract.reporting import deliver
from workbook.checks.contract.typed_code import alphabet, foreign_letters
from workbook.checks.contract.verdict import INVALID, MISSING, UNCHECKED, WRONG, Verdict


def report(problem="", /, **verdicts):
    """Show a line for each answer, and tell programs that run the cell whether all are right.

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
        Unless all are right; an error for nbgrader, the site's build and scripts. None is raised
        where a person runs the cells of a notebook, so that "Run All" goes on.

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
        elif name in cell_watch.stopped:
            verdicts[name] = Verdict(
                MISSING,
                f"not checked: its cell stopped with {cell_watch.stopped[name]}; fix that first",
            )
        elif name in cell_watch.meant and verdict.status == MISSING:
            verdicts[name] = replace(
                verdict, message=f"{verdict.message}; {_slip(name, cell_watch.meant[name])}"
            )
        elif name in cell_watch.overwritten and verdict.status in (WRONG, INVALID):
            verdicts[name] = replace(
                verdict,
                message=f"{verdict.message.rstrip('.')}. {_advice(cell_watch.overwritten[name])}",
            )
        elif problem and verdict.status == WRONG:
            mistake = hooks.find_mistake(problem, name, verdict.answer)
            verdicts[name] = replace(verdict, mistake=mistake, answer=None)
    deliver(verdicts)


def _slip(name, typed):
    """Return what a cell has in place of an assignment to an answer."""
    if typed == name:
        return f"your cell compares, `{name} == ...`: an assignment has one sign ="
    foreign = foreign_letters(typed)
    return (
        f"your code assigns `{typed}`"
        + (f", in which `{foreign}` is a {alphabet(foreign[0])} letter" if foreign else "")
        + f": did you mean `{name}`?"
    )


def _advice(names):
    """Return what to do after an assignment to names of the data cell."""
    is_one = len(names) == 1
    return (
        f"Your code overwrote {', '.join(names)}, {'a name' if is_one else 'names'} of the data "
        f"cell: give yours {'another name' if is_one else 'other names'}, run the data cell again, "
        "then your cell"
    )
