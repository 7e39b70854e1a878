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

from workbook.checks.contract import former_names
from workbook.checks.contract.check_cells import checked_names
from workbook.checks.contract.error_hints import hint_for
from workbook.checks.contract.typed_code import (
    compared_name,
    expression_in,
    read_typed,
    similar_name,
    skeleton,
)

#: {name of a variable: the error that ended the last cell meant to assign it}
stopped: dict = {}
#: {name of a variable: the names of the data that were overwritten when its cell had run}
overwritten: dict = {}
#: {answer without a value: what a cell assigns instead, or the answer itself where one compares it}
meant: dict = {}
_data: dict = {}
_before: dict = {}
_student_values: dict = {}
#: Names to which cells gave values, and names that they compared (`a == k1`) in place of that.
_assigned_names: dict = {}
_compared_names: dict = {}
#: [(code, value)] of the cells since the last check that are one expression.
_expressions: list = []
#: {id of a cell: the answer whose stub it was}
_stubs: dict = {}
#: The answers that checks have reported or stubs have named.
_answers: dict = {}

ASSIGNED = re.compile(r"^([^\W\d]\w*(?: *, *[^\W\d]\w*)*) *(?::[^=\n]+)?=(?!=)", re.M)
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


def after_cell(namespace, source, error, value=None, answer=""):
    """List the answers of a cell that stopped, or after which data are overwritten.

    Parameters
    ----------
    namespace : dict
        The notebook's names.
    source : str
        The cell.
    error : BaseException or None
        The error that ended it.
    value : object, optional
        The value of its last line.
    answer : str, optional
        The answer that belongs into this cell, if it is known. Without a value it is given that of a
        cell that is one expression.

    Returns
    -------
    str
        The assignment that the cell was taken for, or "".
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
        if name not in _data and not _is_open(namespace, name):
            _assigned_names[name] = True
    if compared := compared_name(source):
        _compared_names[compared] = True
    if value is None or value is ... or not (code := expression_in(source)):
        return ""
    if answer:
        return (
            _assigned_value(namespace, answer, code, value) if _is_open(namespace, answer) else ""
        )
    _expressions.append((code, value))
    return ""


def take_expressions(namespace, names):
    """Assign the cells since the last check that are one expression to its answers without a name.

    A stub that still stands has been run, and its name exists; only where as many answers do not as
    there are such cells is it plain which is which.

    Parameters
    ----------
    namespace : dict
        The notebook's names.
    names : list of str
        The answers of the check.

    Returns
    -------
    list of str
        The assignments that the cells were taken for.
    """
    absent = [name for name in names if name not in namespace]
    taken = zip(absent, _expressions) if len(absent) == len(_expressions) else ()
    lines = [_assigned_value(namespace, name, *expression) for name, expression in taken]
    _expressions.clear()
    return lines


def note_slips(namespace, names, answers=()):
    """List in `meant` the answers without a value whose names are misspelt in a cell, or compared.

    Parameters
    ----------
    namespace : dict
        The notebook's names.
    names : iterable of str
        The answers.
    answers : iterable of str, optional
        All answers of the problem, as far as they are known: none of them is a slip for another.
    """
    open_names = [name for name in names if _is_open(namespace, name)]
    for name in names:
        meant.pop(name, None)
    meant.update({name: name for name in open_names if name in _compared_names})
    for typed in _assigned_names:
        if typed not in answers and (name := similar_name(typed, open_names)):
            meant[name] = typed


def _is_open(namespace, name):
    return namespace.get(name, ...) is ...


def _assigned_value(namespace, name, code, value):
    namespace[name] = value
    return f"{name} = {code}"


def before_check(namespace, source):
    """Prepare the names that a check cell reads, until `after_check`.

    Parameters
    ----------
    namespace : dict
        The notebook's names. Answers that do not exist yet are set to stubs, and names of the data
        that were overwritten to what the data cell set, as in a grader.
    source : str
        The cell; nothing happens unless it is a check cell.

    Returns
    -------
    list of str
        The assignments that cells without a name were taken for.
    """
    names = checked_names(source)
    if not names:
        return []
    former_names.adopt(namespace, names)
    lines = take_expressions(namespace, names)
    _answers.update(dict.fromkeys(names))
    note_slips(namespace, names, _answers)
    for name in names:
        namespace.setdefault(name, ...)
    overwritten_data = _overwritten_data(namespace)
    _student_values.update(
        {name: namespace[name] for name in overwritten_data if name in namespace}
    )
    namespace.update({name: _data[name] for name in overwritten_data})
    return lines


def after_check(namespace):
    """Put the names back that a student had given other values than the data cell."""
    namespace.update(_student_values)
    _student_values.clear()


def forget():
    """Forget all cells that have run, for a new namespace."""
    for kept in (
        *(stopped, overwritten, meant, _data, _before, _student_values),
        *(_assigned_names, _compared_names, _answers, _expressions, _stubs),
    ):
        kept.clear()


def recall(stopped_cells, overwritten_names, meant_names):
    """Let `report` know what was listed in another process.

    Parameters
    ----------
    stopped_cells, overwritten_names, meant_names : dict
        `stopped`, `overwritten` and `meant` there. A student's code may have changed them: what is
        not made of names is left out, so that it cannot forge a message.
    """
    meant.clear()
    meant.update(
        {
            name: typed
            for name, typed in meant_names.items()
            if type(typed) is str and _is_word(skeleton(typed)) and typed.isidentifier()
        }
    )
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
    read_typed_cells(shell)
    shell.events.register("pre_run_cell", lambda info: _before_cell(shell, info.raw_cell))
    shell.events.register("post_run_cell", lambda result: _after_cell(shell, result))
    if not shell.custom_exceptions:
        shell.set_custom_exc((TypeError, NameError, AttributeError, SyntaxError), _show_error)


def read_typed_cells(shell):
    """Let an IPython shell run what was meant by cells that Python cannot read."""

    def read(lines):
        return read_typed("".join(lines)).splitlines(keepends=True)

    shell.input_transformers_post.append(read)


def _before_cell(shell, source):
    if (read := read_typed(source)) != source:
        _say_read([read])
    before_cell(shell.user_ns, source)
    _say_read(before_check(shell.user_ns, source))


def _after_cell(shell, result):
    cell, source = getattr(result.info, "cell_id", None), result.info.raw_cell
    after_check(shell.user_ns)
    read = after_cell(
        shell.user_ns,
        read_typed(source),
        result.error_before_exec or result.error_in_exec,
        result.result,
        _stubs.get(cell, ""),
    )
    _say_read([read] if read else [])
    # the id is None in a program that does not tell it
    for name in _before if cell else ():
        if shell.user_ns.get(name) is ...:
            _stubs[cell] = name
            _answers[name] = None


def _say_read(codes):
    for code in codes:
        print(f"Read as: {code}")


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


def _show_error(shell, kind, error, trace, tb_offset=None):
    hint = ABOVE if isinstance(error, NameError) and _is_check(trace) else _hint(shell, error)
    if hint is None:
        shell.showtraceback((kind, error, trace), tb_offset=tb_offset)
    else:
        shell._showtraceback(kind, error, [f"{kind.__name__}: {error}", hint])


def _hint(shell, error):
    return hint_for(str(error), shell.history_manager.input_hist_raw[-1], shell.user_ns)


def _is_check(trace):
    """Return whether an error comes from a line of a check cell itself."""
    while trace.tb_next:
        trace = trace.tb_next
    return "checks.report(" in "".join(linecache.getlines(trace.tb_frame.f_code.co_filename))
