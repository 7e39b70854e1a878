"""Read the trials of a master: answers that its checks refuse or accept.

They are in `p15.trials.py` beside `p15.md`:

    # %% wrong
    a_region = p > 0  # Is it enough that one of them is positive? (hint 1)

    # %% right
    # as one minimum
    least = sp.Min(p, q)
    a_region = least > 0

A trial ends with a statement that assigns an answer. Statements before it, back to the end of the
previous trial, belong to it and are seen by no other. Its comment stands above that statement or
behind its end; the comment of a wrong trial is for the student who made the mistake
(`workbook.authoring.mistakes`). A section `# %% numbers` is read by `workbook.authoring.numbers`.
"""

import ast
import re
from typing import NamedTuple

from workbook.authoring.errors import MasterError
from workbook.authoring.statements import assigned_by

#: Roles: typical wrong answers, and right ones that differ mathematically from the worked one.
TRIALS = ("wrong", "right")
MARK = re.compile(r"# %% *(.*)")
NUMBERS = re.compile(r"^# %% numbers *$\n(.*?)(?=^# %% |\Z)", re.MULTILINE | re.DOTALL)


class Trial(NamedTuple):
    """A trial.

    Attributes
    ----------
    name : str
        The answer that it assigns.
    source : str
        Its code, which uses the names of the data and of the worked answers.
    comment : str
        Its comment.
    """

    name: str
    source: str
    comment: str


def trials_file(path):
    """Return the file of the trials of a master: p15.trials.py beside p15.md."""
    return path.with_suffix(".trials.py")


def read_trials(path, names):
    """Return {"wrong": trials, "right": trials} of a file, for the answers `names`.

    Raises
    ------
    MasterError
        If a trial has no role, no comment, two answers or none.
    """
    if not path.is_file():
        raise MasterError(
            path, 1, "the trials of a master stand beside it, and this file is not there"
        )
    text = path.read_text(encoding="utf-8")
    try:
        # lines stay where they are, for the messages
        text = NUMBERS.sub(lambda section: "\n" * section[0].count("\n"), text)
        statements = ast.parse(text).body
    except SyntaxError as error:
        raise MasterError(path, error.lineno, f"no Python: {error.msg}") from None
    trials, role, end = {role: [] for role in TRIALS}, None, 0
    lines, statements_of_trial = text.split("\n"), []
    for statement in statements:
        statements_of_trial.append(statement)
        answers = assigned_by(statement, names)
        if not answers:
            continue
        role, comment_above, code = _parts(path, lines[end : statement.end_lineno], end, role)
        trailing = code[-1].encode()[statement.end_col_offset :].decode().strip()
        code[-1] = code[-1].encode()[: statement.end_col_offset].decode()
        end = statement.end_lineno
        comment = comment_above or trailing.lstrip("# ")
        if len(answers) > 1 or not comment or trailing.startswith(";"):
            raise MasterError(
                path, end, "a trial assigns one answer, under a comment or with one behind it"
            )
        _validate_use(path, statements_of_trial)
        trials[role].append(Trial(answers[0], "\n".join(code), comment))
        statements_of_trial = []
    if statements_of_trial:
        raise MasterError(
            path,
            statements_of_trial[0].lineno,
            "a trial ends by assigning an answer; this assigns none",
        )
    return trials


def numbers_section(path):
    """Return the source of the section `# %% numbers` of a file, "" if there is none.

    Raises
    ------
    MasterError
        If it is no Python.
    """
    text = path.read_text(encoding="utf-8")
    match = NUMBERS.search(text)
    if match is None:
        return ""
    try:
        ast.parse(match[1])
    except SyntaxError as error:
        line = text[: match.start(1)].count("\n") + error.lineno
        raise MasterError(path, line, f"no Python: {error.msg}") from None
    return match[1]


def _parts(path, block, before, role):
    """Return (role, comment above, lines of code) of a trial from its block of lines."""
    first = next(k for k, line in enumerate(block) if line.strip() and not line.startswith("#"))
    comment_lines = []
    for k, line in enumerate(block):
        if mark := MARK.fullmatch(line.rstrip()):
            role = mark[1]
            if role not in TRIALS or k > first:
                raise MasterError(
                    path, before + k + 1, "a line # %% wrong or # %% right stands before a trial"
                )
        elif k < first:
            comment_lines = (
                [*comment_lines, line.lstrip("# ").rstrip()] if line.startswith("#") else []
            )
    if role is None:
        raise MasterError(
            path, before + first + 1, "a trial stands under a line # %% wrong or # %% right"
        )
    return role, " ".join(comment_lines), block[first:]


def _validate_use(path, statements):
    """Validate that a trial uses what it assigns; otherwise the name of an answer is misspelt."""
    used = {name for statement in statements for name in _names(statement, ast.Load)}
    for statement in statements[:-1]:
        assigned = _names(statement, ast.Store)
        if isinstance(statement, ast.Assign) and assigned and not assigned & used:
            names = ", ".join(sorted(assigned))
            raise MasterError(
                path, statement.lineno, f"{names} is no answer, and the trial does not use it"
            )


def _names(statement, context):
    return {
        node.id
        for node in ast.walk(statement)
        if isinstance(node, ast.Name) and isinstance(node.ctx, context)
    }
