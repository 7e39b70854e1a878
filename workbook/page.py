"""Run and check one answer box of a page: `run_cell` is what the page's Python calls.

A page has no kernel that remembers earlier cells: each call runs the data cells and the boxes above
once more, in a namespace of its own, so that the order of clicks changes no verdict.
"""

import ast
import contextlib
import dataclasses
import io
import os
import re
import traceback
from importlib.util import find_spec

from workbook import mistakes
from workbook.checks.contract import cell_watch
from workbook.checks.contract.check_cells import with_problem
from workbook.checks.contract.error_hints import hint_for
from workbook.checks.contract.reporting import as_html, as_text, collecting
from workbook.checks.contract.typed_code import read_typed

#: Characters of printed output that a page shows.
MOST_PRINTED = 20_000
NOT_IN_A_PAGE = """\
This library is not here; pages of the site do not have it. If your answer
does not need it, leave the line out; else run it in the notebook."""


def run_cell(cells, check, problem="", names=(), sealed=None):
    """Run the cells above a check cell, then the check cell, in a fresh namespace.

    Parameters
    ----------
    cells : list of str
        The data cells and the answer boxes in the order of the page, this check's own last. One that
        fails does not stop the others.
    check : str
        The check cell.
    problem : str, optional
        The problem's number if the check cell does not name it, as on the pages with solutions: with
        it the mistake that may have led to a wrong answer is named.
    names : list of str, optional
        The answer that belongs into each of the cells, "" for a data cell. With it a box that holds
        one expression is taken as that answer.
    sealed : dict, optional
        The sealed mistakes of problems by number, which a page brings along; without it they are looked
        for beside the notebooks.

    Returns
    -------
    dict
        "printed": what each of the cells printed, and the value of its last line; "read": the code that
        each of the cells was taken for, "" where it is what was typed; "errors": for each
        cell that failed "cell", its position in `cells` (`len(cells)` for the check cell), "line"
        (from 1, or None), "text" and "hint" ("" without one); "verdicts": status by answer; "html"
        and "text": the verdicts as a notebook shows them, "" if the check cell failed; "patches":
        whether a cell may have changed a module, so that the next run is to start anew. It can be
        written as JSON.

    Examples
    --------
    >>> data = "import sympy as sp; from workbook import checks; k = sp.Symbol('k', real=True)"
    >>> check = "checks.report(a=checks.stability_region(a, sp.Symbol('s') + k, [k]))"
    >>> result = run_cell([data, "a = k > 0"], check)
    >>> result["verdicts"], result["errors"]
    ({'a': 'right'}, [])
    >>> result["patches"], run_cell([data, "sp.pi = 3"], check)["patches"]
    (False, True)
    >>> run_cell([data, "print(k)\\na = K > 0"], check)["errors"][0]["line"]
    2
    >>> result = run_cell([data, "k ≥ 0"], check, names=["", "a"])
    >>> result["read"], result["verdicts"]
    (['', 'a = k >= 0'], {'a': 'wrong'})
    """
    os.environ.setdefault("MPLBACKEND", "Agg")
    cell_watch.forget()
    mistakes.brought = sealed or {}
    namespace, errors, read = {"__name__": "__main__"}, [], []
    printed = [_Printed() for _ in cells]
    for position, typed in enumerate(cells):
        source = read_typed(typed)
        cell_watch.before_cell(namespace, source)
        value, error = _run(source, f"<cell {position}>", namespace, printed[position])
        answer = names[position] if names else ""
        assignment = cell_watch.after_cell(namespace, source, error, value, answer)
        read.append(assignment or (source if source != typed else ""))
        if error is not None:
            errors.append(_described(error, position, f"<cell {position}>", source, namespace))
    cell_watch.before_check(namespace, check)
    with collecting() as verdicts:
        _, error = _run(with_problem(check, problem), "<check>", namespace, _Printed())
    if error is not None:
        errors.append(_described(error, len(cells), "<check>", check, namespace))
    cell_watch.forget()
    if find_spec("z3") is None:
        verdicts = {name: _with_reservation(verdict) for name, verdict in verdicts.items()}
    return {
        "printed": [output.getvalue() for output in printed],
        "read": read,
        "errors": errors,
        "verdicts": {name: verdict.status for name, verdict in verdicts.items()},
        "html": as_html(verdicts) if verdicts else "",
        "text": as_text(verdicts),
        "patches": any(map(_patches, cells)),
    }


def _patches(typed):
    """Return whether a cell sets or deletes an attribute or calls what does, as for one of a module."""
    try:
        tree = ast.parse(read_typed(typed))
    except SyntaxError:
        return False
    return any(
        not isinstance(node.ctx, ast.Load) or node.attr == "__dict__"
        if isinstance(node, ast.Attribute)
        else isinstance(node, ast.Name) and node.id in ("setattr", "delattr", "vars")
        for node in ast.walk(tree)
    )


def _with_reservation(verdict):
    """Say that an agreement was only sampled, where a notebook, which has z3, may decide it."""
    message = re.sub(
        r"(agrees at \d+ points)$", r"\1; the notebook can decide more", verdict.message
    )
    return dataclasses.replace(verdict, message=message)


class _Printed(io.StringIO):
    """Keeps the beginning of what is written, which may be endless."""

    def write(self, text):
        remaining = MOST_PRINTED - self.tell()
        if remaining >= 0:
            more = "\n... (more is not shown)" if len(text) > remaining else ""
            super().write(text[:remaining] + more)
        return len(text)


def _run(source, name, namespace, printed):
    """Run a cell and print the value of its last line, as Jupyter does; return (value, error)."""
    value = None
    try:
        with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
            body = ast.parse(source, name).body
            last = body.pop() if body and isinstance(body[-1], ast.Expr) else None
            exec(compile(ast.Module(body, []), name, "exec"), namespace)
            if last is not None:
                value = eval(compile(ast.Expression(last.value), name, "eval"), namespace)
                if value is not None:
                    print(repr(value))
    except BaseException as error:  # a student's sys.exit() too
        return value, error
    return value, None


def _described(error, position, name, source, names):
    """Return where a cell failed, with what, and what to write instead."""
    try:
        message = error.msg if isinstance(error, SyntaxError) else str(error)
    except Exception:  # of a class of the student's
        message = ""
    frames = traceback.extract_tb(error.__traceback__)
    lines = [frame.lineno for frame in frames if frame.filename == name]
    if isinstance(error, SyntaxError) and error.filename == name:
        lines.append(error.lineno)
    missing = NOT_IN_A_PAGE if isinstance(error, ModuleNotFoundError) else ""
    return {
        "cell": position,
        "line": lines[-1] if lines else None,
        "text": f"{type(error).__name__}: {message}".removesuffix(": "),
        "hint": hint_for(message, source, names) or missing,
    }
