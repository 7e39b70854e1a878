"""Hints on the first day's mistakes, where Jupyter alone shows a bare error or an old verdict.

`k1 > 0 and k2 > 0` raises SymPy's TypeError: `hint_for` returns what to write instead. After a cell
that fails, its answers keep their values of an earlier run: they are listed in `stopped`, so that
`report` does not judge the old value again. For a check cell that runs before its answer cell,
names that do not exist yet are set to stubs. One that runs before its data cell, as after a
restart, imports this package by itself; then the hint says what to run. `start` sets this up in
Jupyter.
"""

import linecache
import re

from workbook.checks.contract.check_cells import reported_names

#: {name of a variable: the error that ended the last cell meant to assign it}
stopped = {}

ASSIGNED = re.compile(r"^([A-Za-z_][\w, ]*?)\s*(?::[^=\n]+)?=(?!=)", re.M)
CONDITIONS = """\
Join conditions of SymPy with & (and), | (or), ~ (not), each in brackets of
its own: (k1 > 0) & (k2 < k1); or write sp.And(...), sp.Or(...), sp.Not(...).
A chain such as 0 < k2 < k1 is sp.And(0 < k2, k2 < k1); cases, between which
no `if` can choose, are sp.Piecewise((k1, k2 < 0), (k2, True))."""
POWERS = "A power is x**2: in Python x^2 is another operation, on whole numbers."
FUNCTIONS = "Functions of symbols are SymPy's: sp.sqrt(x), not np.sqrt(x) or math.sqrt(x)."
#: What the text of an error begins with, and what to write instead.
HINTS = {
    "cannot determine truth value of Relational": CONDITIONS,
    "unsupported operand type(s) for &: ": CONDITIONS,
    "unsupported operand type(s) for |: ": CONDITIONS,
    "unsupported operand type(s) for ^: ": POWERS,
    "loop of ufunc does not support argument ": FUNCTIONS,
    "Cannot convert expression to float": FUNCTIONS,
}
ABOVE = """\
This check needs what stands above it: run the data cell, then the cell with
your answer, then this one. A restart forgets all cells that have run."""
_before = {}


def hint_for(text):
    """Return what to write instead of code that raised this error, or None without a hint.

    Parameters
    ----------
    text : str
        The text of the error.

    Returns
    -------
    str or None

    Examples
    --------
    >>> hint_for("unsupported operand type(s) for &: 'int' and 'Symbol'")[:29]
    'Join conditions of SymPy with'
    >>> hint_for("'int' object is not callable")
    """
    return next((hint for beginning, hint in HINTS.items() if text.startswith(beginning)), None)


def start(shell):
    """Watch the cells of an IPython shell; a second call changes nothing."""
    if getattr(shell, "workbook_watches", False):
        return
    shell.workbook_watches = True
    shell.events.register("pre_run_cell", lambda info: _before_cell(shell, info.raw_cell))
    shell.events.register("post_run_cell", lambda result: _after_cell(shell, result))
    if not shell.custom_exceptions:
        shell.set_custom_exc((TypeError, NameError), _show_error)


def _before_cell(shell, source):
    for name in _reported(source):
        shell.user_ns.setdefault(name, ...)
    _before.clear()
    _before.update({name: shell.user_ns.get(name) for name in _assigned(source)})


def _after_cell(shell, result):
    error = result.error_before_exec or result.error_in_exec
    for name, value in _before.items():
        if error is not None and shell.user_ns.get(name) is value:
            stopped[name] = type(error).__name__
        else:
            stopped.pop(name, None)


def _assigned(source):
    """Return the names before a = at the beginning of a line, also of a cell with wrong syntax."""
    return {name.strip() for names in ASSIGNED.findall(source) for name in names.split(",")}


def _reported(source):
    try:
        return reported_names(source) if "checks.report(" in source else []
    except SyntaxError:  # a changed check cell
        return []


def _show_error(shell, kind, error, trace, tb_offset=None):
    hint = ABOVE if isinstance(error, NameError) and _is_check(trace) else hint_for(str(error))
    if hint is None:
        shell.showtraceback((kind, error, trace), tb_offset=tb_offset)
    else:
        shell._showtraceback(kind, error, [f"{kind.__name__}: {error}", hint])


def _is_check(trace):
    """Return whether an error comes from a line of a check cell itself."""
    while trace.tb_next:
        trace = trace.tb_next
    return "checks.report(" in "".join(linecache.getlines(trace.tb_frame.f_code.co_filename))
