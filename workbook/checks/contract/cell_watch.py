"""Names of a notebook that cells failed to assign or have overwritten, for `report`.

After a cell that fails, its answers keep their values of an earlier run: they are listed in
`stopped`, so that `report` does not judge the old value again. `b_null = x2 = 0` overwrites the
symbol x2 of the data cell: then every answer with x2 is wrong until the data
cell runs again. Such names are listed in `overwritten`.

In Jupyter `start` watches the cells; a page of the site calls the same functions (`workbook.page`).
For a check cell that runs before its answer cell, names that do not exist yet are set to stubs. One
that runs before its data cell, as after a restart, imports
this package by itself; then the hint says what to run. Where cells run in one process and answers
are judged in another, `notebooks.cells` watches them and the judge calls `recall`.
"""

import ast
import linecache
import re

from workbook.checks.contract.check_cells import reported_names
from workbook.checks.contract.error_hints import hint_for

#: {name of a variable: the error that ended the last cell meant to assign it}
stopped = {}
#: {name of a variable: the names of the data that were overwritten when its cell had run}
overwritten = {}
_data = {}
_before = {}
_student_values = {}

ASSIGNED = re.compile(r"^([A-Za-z_][\w, ]*?)\s*(?::[^=\n]+)?=(?!=)", re.M)
MAX_NAME = 60
IMPORT = "from workbook import checks"
#: Code with variables of its own.
SCOPES = (
    ast.FunctionDef,
    ast.ClassDef,
    ast.Lambda,
    ast.ListComp,
    ast.SetComp,
    ast.DictComp,
    ast.GeneratorExp,
)
ABOVE = """\
This check needs what stands above it: run the data cell, then the cell with
your answer, then this one. A restart forgets all cells that have run."""


def before_cell(namespace, source):
    """Note the values of the names that a cell is about to assign.

    Parameters
    ----------
    namespace : dict
        The notebook's names.
    source : str
        The cell.
    """
    _before.clear()
    _before.update({name: namespace.get(name) for name in _assigned(source)})


def after_cell(namespace, source, error):
    """List the answers of a cell that stopped, or after which data are overwritten.

    Parameters
    ----------
    namespace : dict
        The notebook's names.
    source : str
        The cell.
    error : BaseException or None
        The error that ended it.
    """
    if error is None and IMPORT in source and "checks.report(" not in source:
        _data.update({name: namespace[name] for name in _bound(source) if name in namespace})
    overwritten_data = _overwritten_data(namespace)
    for name, value in _before.items():
        stopped.pop(name, None)
        overwritten.pop(name, None)
        if error is not None and namespace.get(name) is value:
            # a metaclass of the student's may hide the name
            stopped[name] = type.__dict__["__name__"].__get__(type(error))
        elif overwritten_data:
            overwritten[name] = overwritten_data


def before_check(namespace, source):
    """Prepare the names that a check cell reads, until `after_check`.

    Parameters
    ----------
    namespace : dict
        The notebook's names. Answers that do not exist yet are set to stubs, and names of the data
        that were overwritten to what the data cell set, as in a grader.
    source : str
        The cell; nothing happens unless it is a check cell.
    """
    if names := _reported(source):
        for name in names:
            namespace.setdefault(name, ...)
        overwritten_data = _overwritten_data(namespace)
        _student_values.update(
            {name: namespace[name] for name in overwritten_data if name in namespace}
        )
        namespace.update({name: _data[name] for name in overwritten_data})


def after_check(namespace):
    """Put the names back that a student had given other values than the data cell."""
    namespace.update(_student_values)
    _student_values.clear()


def forget():
    """Forget all cells that have run, for a new namespace."""
    for names in (stopped, overwritten, _data, _before, _student_values):
        names.clear()


def recall(stopped_cells, overwritten_names):
    """Let `report` know what `after_cell` listed in another process.

    Parameters
    ----------
    stopped_cells, overwritten_names : dict
        `stopped` and `overwritten` there. A student's code may have changed them: what is not made
        of names is left out, so that it cannot forge a message.
    """
    stopped.clear()
    stopped.update({name: error for name, error in stopped_cells.items() if _is_word(error)})
    overwritten.clear()
    overwritten.update(
        {
            name: names
            for name, names in overwritten_names.items()
            if type(names) is list and all(map(_is_word, names))
        }
    )


def start(shell):
    """Watch the cells of an IPython shell; a second call changes nothing."""
    if getattr(shell, "workbook_watches", False):
        return
    shell.workbook_watches = True
    shell.events.register("pre_run_cell", lambda info: _before_cell(shell, info.raw_cell))
    shell.events.register("post_run_cell", lambda result: _after_cell(shell, result))
    if not shell.custom_exceptions:
        shell.set_custom_exc((TypeError, NameError, AttributeError, SyntaxError), _show_error)


def _before_cell(shell, source):
    before_cell(shell.user_ns, source)
    before_check(shell.user_ns, source)


def _after_cell(shell, result):
    after_check(shell.user_ns)
    after_cell(
        shell.user_ns, result.info.raw_cell, result.error_before_exec or result.error_in_exec
    )


def _is_word(name):
    return type(name) is str and len(name) <= MAX_NAME and name.isascii() and name.isidentifier()


def _overwritten_data(namespace):
    return [name for name, value in _data.items() if not _same(value, namespace.get(name))]


def _same(value, other):
    try:
        return value is other or bool(value == other)
    except Exception:  # arrays, whose comparison has no truth value
        return False


def _assigned(source):
    """Return the names before a = at the beginning of a line, also of a cell with wrong syntax."""
    return {name.strip() for names in ASSIGNED.findall(source) for name in names.split(",")}


def _bound(source):
    """Return the names that a data cell assigns."""
    try:
        return list(_stored(ast.parse(source)))
    except (SyntaxError, ValueError):  # a changed data cell, with a magic or the like
        return []


def _stored(node):
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Name) and isinstance(child.ctx, ast.Store):
            yield child.id
        elif not isinstance(child, SCOPES):
            yield from _stored(child)


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
