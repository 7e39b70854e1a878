"""The code of check cells."""

import ast
import re


def reported_names(source):
    """Return the names of the answers that a cell hands to `checks.report`, in order."""
    calls = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    return [
        keyword.arg
        for call in calls
        if ast.unparse(call.func) == "checks.report"
        for keyword in call.keywords
    ]


#: Stands where a check cell need not run, since its answers are judged elsewhere.
MARK = "# check of "


def marked(source):
    """Return a comment in place of a check cell, which names its answers.

    >>> marked("checks.report(a=checks.set_of(a, [1, 2]))")
    '# check of a'
    """
    return MARK + ", ".join(reported_names(source))


def checked_names(source):
    """Return the answers of a check cell, changed or not, or of its mark; [] for another cell."""
    if source.startswith(MARK):
        return source.removeprefix(MARK).split(", ")
    try:
        return reported_names(source) if "checks.report(" in source else []
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []


def check_calls(source):
    """Return {answer: the text of its check} of a check cell.

    >>> check_calls("checks.report(a=checks.set_of(a, [1, 2]))")
    {'a': 'checks.set_of(a, [1, 2])'}
    """
    report = ast.parse(source).body[-1].value
    return {
        keyword.arg: ast.get_source_segment(source, keyword.value) for keyword in report.keywords
    }


def with_one_answer(source, name):
    """Return a check cell that reports on one of its answers alone."""
    tree = ast.parse(source)
    report = tree.body[-1].value
    report.keywords = [keyword for keyword in report.keywords if keyword.arg == name]
    return ast.unparse(tree)


def with_problem(source, number):
    """Return a check cell with the number of its problem, unless it has one or `number` is ""."""
    if not number:
        return source
    return re.sub(
        r"(checks\.report\()(\s*)(?=\w)",
        lambda m: f'{m[1]}{m[2]}"{number}",{m[2] or chr(10) + " " * len(m[1])}',
        source,
        count=1,
    )
