"""Read the section `# %% numbers` of a trials file: the rows of numbers of a problem that can vary.

    # %% numbers
    friction, stiffness = [(3, 2), (4, 3), (5, 6)]
    shown = [r"\\ddot x + «friction*»\\dot x + «stiffness*»x = 0"]
    p, q = sorted(-root for root in b_matrix.eigenvals())
    b_unobservable = sp.Or(sp.Eq(h, p), sp.Eq(h, q))

The first statement with names of the data cells lists the rows; row 0 is the page's. `shown` lists
the phrases of the page that hold numbers. All other statements run after the data cells: they
compute right answers from the data, and names that phrases may use. In a phrase `«n»` stands for
the value of `n`, `«n*»` for a coefficient (2, -, or nothing for 1), `«+n*»` for one with its sign
before it.
"""

import ast
import re
from dataclasses import dataclass
from itertools import permutations, product

import sympy as sp

from workbook.authoring.errors import MasterError
from workbook.authoring.trials import trials_file

FIELD = re.compile(r"«(\+?)(.*?)(\*?)»", re.DOTALL)


class NumbersError(ValueError):
    """Numbers of a row cannot be shown as the page shows its own."""


@dataclass(frozen=True)
class Numbers:
    """The section of one problem.

    Attributes
    ----------
    names : tuple of str
        Names of the data cells whose values vary.
    rows : tuple of tuple
        Their values by row; row 0 is the page's.
    source : str
        The other statements: phrases, right answers and what both need.
    """

    names: tuple
    rows: tuple
    source: str


def read_numbers(master):
    """Return the `Numbers` of a master, whose data cells are run for it.

    Raises
    ------
    MasterError
        If it has none, no statement lists rows, row 0 is not the page's, or two rows are the same.
    """
    path, data = trials_file(master.path), master.code("data")
    if not master.numbers:
        raise MasterError(path, 1, "this problem has no section # %% numbers, so it cannot vary")
    statements = ast.parse(master.numbers).body
    assigned = {name for cell in data for s in ast.parse(cell).body for name in _targets(s)}
    rows_statement = next((s for s in statements if _targets(s) and _targets(s) <= assigned), None)
    if rows_statement is None:
        raise MasterError(path, 1, "the numbers begin with rows of names of the data cell")
    target, line = rows_statement.targets[0], rows_statement.lineno
    names = tuple(node.id for node in getattr(target, "elts", [target]))
    others = [s for s in statements if s is not rows_statement]
    namespace = run_cells(data)
    for statement in statements[: statements.index(rows_statement)]:
        _execute(statement, namespace)
    rows = eval(compile(ast.Expression(rows_statement.value), str(path), "eval"), namespace)
    rows = tuple(tuple(row) if len(names) > 1 else (row,) for row in rows)
    texts = [row_texts(row) for row in rows]
    if any(len(row) != len(names) for row in rows):
        raise MasterError(path, line, f"each row has {len(names)} values: {', '.join(names)}")
    if len(set(texts)) < len(texts):
        raise MasterError(path, line, "two rows have the same numbers")
    numbers = Numbers(names, rows, "\n".join(map(ast.unparse, others)))
    if [with_row(cell, numbers, 0) for cell in data] != data:
        raise MasterError(path, line, "row 0 is not written as in the data cell of the page")
    return numbers


def run_cells(sources):
    """Return the names after running data cells."""
    namespace = {"__name__": "exercise"}
    for source in sources:
        exec(compile(source, "<data cell>", "exec"), namespace)
    return namespace


def with_row(cell, numbers, row):
    """Return a data cell with the numbers of a row; everything else is kept letter by letter."""
    values = dict(zip(numbers.names, numbers.rows[row]))
    lines = cell.encode().splitlines(keepends=True)
    starts = [sum(map(len, lines[:k])) for k in range(len(lines) + 1)]
    changed = cell.encode()
    for statement in reversed(ast.parse(cell).body):
        if not _targets(statement) or not _targets(statement) <= set(values):
            continue
        target = statement.targets[0]
        names = [node.id for node in getattr(target, "elts", [target])]
        value = statement.value
        start = starts[value.lineno - 1] + value.col_offset
        end = starts[value.end_lineno - 1] + value.end_col_offset
        text = ", ".join(row_texts([values[name] for name in names]))
        changed = changed[:start] + text.encode() + changed[end:]
    return changed.decode()


def row_texts(row):
    """Return the values of a row as Python."""
    return tuple(map(_as_source, row))


def phrases(namespace):
    """Return the phrases of a problem with the numbers of a row, in the order of `shown`.

    Parameters
    ----------
    namespace : dict
        The names after the data cells with the numbers of the row, and after `numbers.source`.

    Raises
    ------
    NumbersError
        If a coefficient is 0.
    """

    def field(match):
        sign, expression, is_coefficient = match.groups()
        value = eval(expression, namespace)
        text = value if isinstance(value, str) else sp.latex(sp.sympify(value))
        if is_coefficient and value == 0:
            raise NumbersError(f"the coefficient {expression} is 0")
        if is_coefficient and value in (1, -1):
            text = text.removesuffix("1")
        return f"{'-' if text[:1] == '-' else '+'} {text.removeprefix('-')}" if sign else text

    return [FIELD.sub(field, phrase) for phrase in namespace.get("shown", ())]


def linear_form(coefficients, names):
    r"""Return a sum of products as the pages write it.

    >>> linear_form([2, 0, -1, sp.Symbol("alpha")], ["x_1", "x_2", "x_3", "u"])
    '2x_1 - x_3 + \\alpha u'
    """
    terms = []
    for coefficient, name in zip(coefficients, names):
        text = sp.latex(sp.sympify(coefficient))
        sign, size = ("-", text[1:]) if text.startswith("-") else ("+", text)
        space = " " if size.startswith("\\") else ""
        terms += [(sign, ("" if size == "1" else size + space) + name)] if text != "0" else []
    first, *others = terms
    return " ".join([first[0].replace("+", "") + first[1], *(f"{s} {term}" for s, term in others)])


def signed_permutations(size):
    """Return the matrices with one 1 or -1 in each row and column: changes of coordinates."""
    return [
        sp.diag(*signs) * sp.Matrix(size, size, lambda i, k: int(order[i] == k))
        for order in permutations(range(size))
        for signs in product((1, -1), repeat=size)
    ]


def _targets(statement):
    """Return the names of a plain assignment to names, {} for any other statement."""
    if not isinstance(statement, ast.Assign) or len(statement.targets) != 1:
        return set()
    nodes = getattr(statement.targets[0], "elts", statement.targets)
    return {node.id for node in nodes} if all(isinstance(n, ast.Name) for n in nodes) else set()


def _execute(statement, namespace):
    exec(compile(ast.Module([statement], []), "<numbers>", "exec"), namespace)


def _as_source(value):
    if isinstance(value, (list, tuple)):
        text = ", ".join(map(_as_source, value))
        return f"[{text}]" if isinstance(value, list) else f"({text})"
    if isinstance(value, sp.MatrixBase):
        entries = value.flat() if value.cols == 1 else value.tolist()
        return f"sp.Matrix({_as_source(entries)})"
    if isinstance(value, sp.Rational) and not value.is_integer:
        return f"sp.Rational({value.p}, {value.q})"
    return str(value)
