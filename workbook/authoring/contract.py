"""The contract of a master: complete front matter, every answer assigned and checked once."""

import ast
import re
from collections import Counter
from difflib import get_close_matches

from workbook.authoring.errors import MasterError
from workbook.authoring.statements import assigned_names
from workbook.checks.contract.check_cells import reported_names
from workbook.course import course_of
from workbook.numbering import number_of_file, read_number

TYPES = (
    "number",
    "integer",
    "yes/no",
    "choice",
    "vector",
    "matrix",
    "expression",
    "equation",
    "condition",
    "set",
    "law",
    "function",
    "list of",
    "dict",
)
LEVELS = ("core", "advanced", "starred")
FIELDS = {
    "number": str,
    "title": str,
    "section": str,
    "level": str,
    "topics": list,
    "answers": dict,
    "hints": dict,
}
OPTIONAL = {"core": list}
#: Most answers of a problem at the level core, and of one that need not name its core items.
MAX_CORE_ANSWERS, MAX_WITHOUT_CORE = 12, 15
LIST_TYPE = re.compile(r"(?<=list of )((?:row )?[a-z]+)\b(?![/(])")
ITEM = re.compile(r"([a-z])_")
SOLUTION = re.compile(r"\{solution-(start|end)\}")
FORMS = {str: "a text", list: "a list", dict: "names with what belongs to each"}


def validate_front_matter(path, front, lines):
    """Raise `MasterError` for a part of the front matter that is missing or malformed.

    Parameters
    ----------
    path : pathlib.Path
        File of the master.
    front : dict
        What stands under `problem:`.
    lines : dict
        Line numbers by paths of keys, such as ("answers", "a_region").
    """

    def require(condition, expected, *keys):
        if not condition:
            raise MasterError(path, lines.get(keys, lines[()]), expected)

    require(isinstance(front, dict), f"problem: needs {', '.join(FIELDS)}")
    for field in [*FIELDS, *front]:
        require(
            field in front and field in FIELDS | OPTIONAL,
            f"problem: needs {', '.join(FIELDS)} and no more, but perhaps core; look at {field}",
            field,
        )
    number = read_number(front["number"]) if isinstance(front["number"], str) else None
    require(number and not number.row, 'problem.number is to be quoted, "1.15"', "number")
    require(
        number_of_file(path) == number,
        f"problem {number.base} belongs into {number.file('.md')}",
        "number",
    )
    for field, form in (
        FIELDS | {field: form for field, form in OPTIONAL.items() if field in front}
    ).items():
        require(
            isinstance(front[field], form) and front[field],
            f"problem.{field} is {FORMS[form]}",
            field,
        )
    require(front["level"] in LEVELS, f"problem.level is one of {', '.join(LEVELS)}", "level")
    for name, text in front["answers"].items():
        kind, colon, _ = str(text).partition(":")
        require(
            colon and kind.strip().startswith(TYPES),
            f'answer {name} is to read "TYPE: what it is", TYPE one of {", ".join(TYPES)}',
            "answers",
            name,
        )
        require(
            name in front["hints"], f"every answer needs hints; {name} has none", "answers", name
        )
    for name, texts in front["hints"].items():
        require(
            name in front["answers"],
            f"hints are for answers; {name} is none{suggestion(name, front['answers'])}",
            "hints",
            name,
        )
        require(
            isinstance(texts, list) and texts and all(isinstance(text, str) for text in texts),
            f"the hints for {name} are a list of texts",
            "hints",
            name,
        )
    _validate_core(require, front)


def _validate_core(require, front):
    """Validate the core of a long problem: items with at most half of its answers."""
    items, core = Counter(item_of(name) for name in front["answers"]), front.get("core", [])
    count = items.total()
    require(
        front["level"] != "core" or count <= MAX_CORE_ANSWERS,
        f"with {count} answers, more than a dozen, a problem is advanced at least",
        "level",
    )
    require(
        core or count <= MAX_WITHOUT_CORE or len(items) <= 3,
        f"with {count} answers problem.core names the items that are enough at first, like [a, d]",
        "answers",
    )
    for item in core:
        require(item in items, f"problem.core is a list of items; {item} is none", "core")
    require(
        sum(items[item] for item in core) <= count / 2,
        "the core of a problem is at most half of its answers",
        "core",
    )


def plural_kind(kind):
    """Return the TYPE of an answer with the plural after "list of".

    >>> plural_kind("list of matrix"), plural_kind("list of row vector exact"), plural_kind("number")
    ('list of matrices', 'list of row vectors exact', 'number')
    """
    return LIST_TYPE.sub(lambda match: match[1].replace("matrix", "matrice") + "s", kind)


def item_of(name):
    """Return the item of an answer: "a" for a_region, "" where a problem has no items."""
    match = ITEM.match(name)
    return match[1] if match else ""


def validate_code(master, lines):
    """Raise `MasterError` unless every answer is assigned once and checked once."""
    cells = {
        role: [cell for cell in master.cells if cell.role == role]
        for role in ("data", "answer", "check")
    }
    for cell in cells["data"]:
        for name in assigned_names(cell.source, master.answers):
            raise MasterError(master.path, cell.line, f"a data cell assigns the answer {name}")
    _validate_once(
        master,
        lines,
        "the answer cells assign every answer once",
        [
            (name, cell)
            for cell in cells["answer"]
            for name in assigned_names(cell.source, master.answers)
        ],
    )
    _validate_once(
        master,
        lines,
        "the check cells report every answer once",
        [(name, cell) for cell in cells["check"] for name in reported_names(cell.source)],
    )
    data = {node.id for cell in cells["data"] for node in _nodes(cell, ast.Name)}
    # a check of one's own
    data |= {node.name for cell in cells["data"] for node in _nodes(cell, ast.FunctionDef)}
    for cell in cells["check"]:
        _validate_names(master, cell, {"checks", *data, *master.answers})


def validate_drawings(master):
    """Raise `MasterError` for a drawing inside a solution, or without a caption."""
    last_fence = ""
    for cell, following in zip(master.cells, (*master.cells[1:], None)):
        if cell.role == "":
            last_fence = (SOLUTION.findall(cell.source) or [last_fence])[-1]
        elif cell.role == "drawing":
            if last_fence == "start":
                raise MasterError(
                    master.path,
                    cell.line,
                    "a drawing belongs to the statement; in a solution the role is figure",
                )
            if following is None or following.role or not caption_above(following.source):
                raise MasterError(
                    master.path,
                    cell.line,
                    "under a drawing stands its caption, a paragraph in emphasis",
                )


def validate_blocks(master):
    """Raise `MasterError` for a second heading, or a solution without the label of its exercise."""
    label = f"ex-{read_number(master.number).label}"
    for cell in master.cells:
        if cell.role:
            continue
        for k, text in enumerate(cell.source.split("\n")):
            if re.match(r"##+ ", text):
                raise MasterError(
                    master.path,
                    cell.line + k,
                    "a master has one heading, its title; items are in bold",
                )
            solution = re.match(r"`{3,}\{solution-start\}\s*(.*?)\s*$", text)
            if solution and solution[1] != label:
                raise MasterError(
                    master.path, cell.line + k, f"a solution begins with {{solution-start}} {label}"
                )


def caption_above(text):
    """Return the caption at the beginning of a text, "" if there is none."""
    first = text.strip().split("\n\n")[0]
    return first[1:-1] if re.fullmatch(r"\*[^*\s].*[^*\s]\*", first, re.S) else ""


def _validate_once(master, lines, rule, uses):
    names = [name for name, _ in uses]
    for name, cell in uses:
        if name not in master.answers:
            raise MasterError(
                master.path, cell.line, f"{rule}; {name} is none{suggestion(name, master.answers)}"
            )
        if names.count(name) > 1:
            raise MasterError(master.path, cell.line, f"{rule}; {name} stands here and elsewhere")
    for name in master.answers:
        if name not in names:
            raise MasterError(
                master.path, lines["answers", name], f"{rule}; none does so with {name}"
            )


def _validate_names(master, cell, allowed_names):
    """Validate that the checks and the names in a check cell exist."""
    from workbook import checks  # reads the names of all checks
    from workbook.checks.course_checks import own_checks

    check_names = [
        *dir(checks),
        *(f"research.{name}" for name in dir(checks.research)),
        *own_checks(course_of(master.number)),
    ]
    for node in _nodes(cell, ast.Name):
        if node.id not in allowed_names:
            raise MasterError(
                master.path,
                cell.line + node.lineno - 1,
                f"{node.id} is neither an answer nor a name of a data cell{suggestion(node.id, allowed_names)}",
            )
    for node in _nodes(cell, ast.Attribute):
        called = ast.unparse(node)
        if called.startswith("checks.") and called != "checks.research":
            name = called.removeprefix("checks.")
            if name not in check_names:
                raise MasterError(
                    master.path,
                    cell.line + node.lineno - 1,
                    f"there is no check {name}{suggestion(name, check_names)}",
                )


def _nodes(cell, kind):
    return [node for node in ast.walk(ast.parse(cell.source)) if isinstance(node, kind)]


def suggestion(name, allowed_names):
    """Return the end of a message that suggests similar names, "" if there are none."""
    similar = get_close_matches(str(name), allowed_names)
    return f"; did you mean {' or '.join(similar)}?" if similar else ""
