"""Copying: what pairs of students share that few others have.

Shared are whole notebooks, wrong answers in the very same form, lines of code of their own, and the
shape of code: runs of statements that are equal but for the names of their variables (syntax trees in
which these names are numbered). What many have is no sign of anything, so only what at most a
twentieth of the class has, or three students, counts. Nothing is decided here: a lecturer looks at
what is shared and at how common it is.
"""

import ast
import hashlib
import json
from collections import Counter, defaultdict
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import combinations

from workbook.checks.contract.verdict import MISSING, WRONG

#: The share of the class, and the number of students, up to which something is rare.
RARE_SHARE, RARE_COUNT = 0.05, 3
#: From this many rare wrong answers or lines on a pair is shown; lines are also most of one's own.
LEAST_ANSWERS, LEAST_LINES, LEAST_LINE_SHARE = 2, 4, 0.6
#: Shorter lines are everybody's.
LEAST_LENGTH = 12
#: Statements in a run, the least number of parts of a run, and characters of it that are shown.
RUN, LEAST_PARTS, MAX_SHOWN = 3, 20, 100
SHAPES = "runs of statements, whatever their variables are called"
#: Statements of a notebook that are compared.
MAX_STATEMENTS = 2000


@dataclass(frozen=True)
class Pair:
    """Two students, and what both have: (problem and name, or line; how many students have it)."""

    students: tuple
    kind: str
    shared: tuple


@dataclass
class OwnCode:
    """What code a student has of their own: lines, and shapes with the first line of each."""

    lines: set = field(default_factory=set)
    shapes: dict = field(default_factory=dict)


def pristine_lines(exercise):
    """Return the lines of code that a notebook is handed out with."""
    return frozenset(_lines(source for _, source in exercise.cells))


def own_lines(sources, pristine):
    """Return the lines of code that a notebook has beyond the pristine ones."""
    return frozenset(line for line in _lines(sources) if len(line) >= LEAST_LENGTH) - pristine


def shapes(content):
    """Return the shapes of the own code in JSON bytes with "cells" and "pristine" cells.

    For a limited process: a cell can be built to explode when it is parsed. A shape is a hash of
    a run of statements; with it comes the first line of the run.
    """
    request = json.loads(content)
    pristine = _pristine_statements(tuple(request["pristine"]))
    known = {token.name for statement in pristine for token in statement if _is_bound(token)}
    own = [
        (statement, line)
        for statement, line in _statements(request["cells"])
        if statement not in pristine
    ]
    bound = {token.name for statement, _ in own for token in statement if _is_bound(token)}
    found = {}
    for run in zip(*(own[k:] for k in range(RUN))):
        parts, numbers = [], {}
        for token in (token for statement, _ in run for token in statement):
            if isinstance(token, _Name):
                renamed = token.name in bound and token.name not in known
                token = numbers.setdefault(token.name, len(numbers)) if renamed else token.name
            parts.append(str(token))
        if len(parts) >= LEAST_PARTS:
            found.setdefault(hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16], run[0][1])
    return found


@lru_cache(maxsize=64)
def _pristine_statements(cells):
    return frozenset(statement for statement, _ in _statements(cells))


@dataclass(frozen=True)
class _Name:
    """A variable in a statement, and whether the statement binds it."""

    name: str
    bound: bool


def _is_bound(token):
    return isinstance(token, _Name) and token.bound


def _statements(cells):
    """Yield (tokens, line) of each statement, those inside others after the head of these."""
    count = 0
    for cell in cells:
        for statement in _parsed(cell):
            count += 1
            if count > MAX_STATEMENTS:
                return
            yield tuple(_tokens(statement)), ast.unparse(statement).split("\n")[0][:MAX_SHOWN]


def _parsed(cell):
    """Return the statements of a cell in order, without commands of the shell and docstrings."""
    lines = ["" if line.lstrip().startswith(("%", "!", "?")) else line for line in cell.split("\n")]
    try:
        waiting, statements = ast.parse("\n".join(lines)).body[::-1], []
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []
    while waiting:
        statement = waiting.pop()
        if not (isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)):
            statements.append(statement)
        inner = [
            part
            for name, value in ast.iter_fields(statement)
            if isinstance(value, list)
            for part in value
            if isinstance(part, ast.stmt)
        ]
        waiting += inner[::-1]
    return statements


def _tokens(node):
    """Yield the kinds, variables and constants of a statement, without the statements inside it."""
    if isinstance(node, ast.Name):
        yield _Name(node.id, not isinstance(node.ctx, ast.Load))
        return
    yield type(node).__name__
    for name, value in ast.iter_fields(node):
        for part in value if isinstance(value, list) else [value]:
            if isinstance(part, ast.AST):
                if not isinstance(part, (ast.stmt, ast.expr_context)):
                    yield from _tokens(part)
            elif isinstance(node, (ast.FunctionDef, ast.ClassDef, ast.arg)) and name in (
                "name",
                "arg",
            ):
                yield _Name(part, True)
            elif part is not None and name != "type_comment":
                yield repr(part)


def pairs(scores, own_code):
    """Return the pairs that share something rare, the longest first.

    Parameters
    ----------
    scores : list of StudentScore
        The scores of the class.
    own_code : dict
        `OwnCode` by student.

    Returns
    -------
    list of Pair
        Of the kinds "identical notebooks", "wrong answers", "lines of code", and, of pairs that
        share no such lines, "runs of statements, whatever their variables are called".
    """
    notebooks, answers = defaultdict(set), defaultdict(set)
    for score in scores:
        for problem, attempt in score.counted.items():
            if any(verdict.status != MISSING for verdict in attempt.verdicts.values()):
                notebooks[score.student].add((problem, attempt.content))
        for answer in score.answers:
            if answer.verdict.status == WRONG and answer.hash:
                name = f"{answer.problem} {answer.answer}"
                answers[score.student].add((name, answer.hash))
    limit = max(RARE_COUNT, RARE_SHARE * len(scores))
    lines = _sharing_most(
        {student: own.lines for student, own in own_code.items()}, "lines of code", limit
    )
    first_lines = {k: line for own in own_code.values() for k, line in own.shapes.items()}
    with_lines = {pair.students for pair in lines}
    shapes = [
        replace(
            pair, shared=tuple((first_lines[shape], students) for shape, students in pair.shared)
        )
        for pair in _sharing_most(
            {student: set(own.shapes) for student, own in own_code.items()}, SHAPES, limit
        )
        if pair.students not in with_lines
    ]
    return [
        *_sharing(notebooks, "identical notebooks", 1, limit),
        *_sharing(answers, "wrong answers", LEAST_ANSWERS, limit),
        *lines,
        *shapes,
    ]


def _sharing_most(items, kind, limit):
    """Return the pairs that share most of what either has of rare lines or shapes."""
    counts = Counter(item for own in items.values() for item in own)
    rare = {student: {k for k in own if counts[k] <= limit} for student, own in items.items()}
    return [
        pair
        for pair in _sharing(rare, kind, LEAST_LINES, limit)
        if len(pair.shared) >= LEAST_LINE_SHARE * min(len(rare[name]) for name in pair.students)
    ]


def _sharing(items, kind, least, limit):
    """Return the pairs that share `least` items or more, which at most `limit` students have."""
    owners = defaultdict(list)
    for student in sorted(items):
        for item in items[student]:
            owners[item].append(student)
    shared = defaultdict(list)
    for item, students in owners.items():
        if 1 < len(students) <= limit:
            name = item if isinstance(item, str) else item[0]
            for pair in combinations(students, 2):
                shared[pair].append((name, len(students)))
    result = [
        Pair(students, kind, tuple(sorted(names, key=lambda entry: (entry[1], entry[0]))))
        for students, names in shared.items()
        if len(names) >= least
    ]
    return sorted(result, key=lambda pair: (-len(pair.shared), pair.students))


def _lines(sources):
    """Yield the lines of code without comments, with single spaces."""
    for source in sources:
        for line in source.splitlines():
            yield " ".join(line.partition("#")[0].split())
