"""The trials of a master: `p15.trials.py` beside `p15.md` says which answers its checks refuse and which they let pass.

    # %% wrong
    a_region = p > 0  # Is it enough that one of them is positive? (hint 1)

    # %% right
    # as one minimum
    least = sp.Min(p, q)
    a_region = least > 0

A statement that assigns an answer ends a trial. What stands before it, back to the end of the trial before, is its own
and is seen by no other. Its comment stands above it or behind its end; that of a wrong one is
for the student who has it (`workbook.authoring.mistakes`).
"""

import ast
import re
from typing import NamedTuple

from workbook.authoring.errors import MasterError
from workbook.authoring.statements import assigned_by

#: Typical wrong answers, and right ones that differ mathematically from the worked one.
TRIALS = ("wrong", "right")
MARK = re.compile(r"# %% *(.*)")


class Trial(NamedTuple):
    """The answer it is for, the code that assigns it (beginning from data and reference), and its comment."""

    name: str
    source: str
    comment: str


def trials_file(path):
    """Where the trials of the master at `path` stand: beside it, p15.trials.py for p15.md."""
    return path.with_suffix(".trials.py")


def read_trials(path, names):
    """{"wrong": trials, "right": trials} from the file at `path`, for the answers `names`.

    Raises `MasterError` with the line where a trial has no role, no comment, two answers or none.
    """
    if not path.is_file():
        raise MasterError(
            path, 1, "the trials of a master stand beside it, and this file is not there"
        )
    text = path.read_text(encoding="utf-8")
    try:
        statements = ast.parse(text).body
    except SyntaxError as error:
        raise MasterError(path, error.lineno, f"no Python: {error.msg}") from None
    found, role, end = {role: [] for role in TRIALS}, None, 0
    lines, own = text.split("\n"), []
    for statement in statements:
        own.append(statement)
        answers = assigned_by(statement, names)
        if not answers:
            continue
        role, above, code = _parts(path, lines[end : statement.end_lineno], end, role)
        behind = code[-1].encode()[statement.end_col_offset :].decode().strip()
        code[-1] = code[-1].encode()[: statement.end_col_offset].decode()
        end = statement.end_lineno
        comment = above or behind.lstrip("# ")
        if len(answers) > 1 or not comment or behind.startswith(";"):
            raise MasterError(
                path, end, "a trial assigns one answer, under a comment or with one behind it"
            )
        _hold_to_use(path, own)
        found[role].append(Trial(answers[0], "\n".join(code), comment))
        own = []
    if own:
        raise MasterError(
            path, own[0].lineno, "a trial ends by assigning an answer; this assigns none"
        )
    return found


def _parts(path, block, before, role):
    """(role, comment above, lines of code) of a trial; its `block` of lines begins where the trial before ended."""
    first = next(k for k, line in enumerate(block) if line.strip() and not line.startswith("#"))
    above = []
    for k, line in enumerate(block):
        if mark := MARK.fullmatch(line.rstrip()):
            role = mark[1]
            if role not in TRIALS or k > first:
                raise MasterError(
                    path, before + k + 1, "a line # %% wrong or # %% right stands before a trial"
                )
        elif k < first:
            above = [*above, line.lstrip("# ").rstrip()] if line.startswith("#") else []
    if role is None:
        raise MasterError(
            path, before + first + 1, "a trial stands under a line # %% wrong or # %% right"
        )
    return role, " ".join(above), block[first:]


def _hold_to_use(path, statements):
    """What stands before the answer's statement is used: else it is a trial of an answer whose name is misspelt."""
    used = {name for statement in statements for name in _names(statement, ast.Load)}
    for statement in statements[:-1]:
        given = _names(statement, ast.Store)
        if isinstance(statement, ast.Assign) and given and not given & used:
            names = ", ".join(sorted(given))
            raise MasterError(
                path, statement.lineno, f"{names} is no answer, and the trial does not use it"
            )


def _names(statement, context):
    return {
        node.id
        for node in ast.walk(statement)
        if isinstance(node, ast.Name) and isinstance(node.ctx, context)
    }
