"""What a master promises: a front matter that says everything, every answer assigned and checked
once, real checks."""

import ast
import re
from collections import Counter
from difflib import get_close_matches
from pathlib import Path

from workbook.authoring.errors import MasterError
from workbook.authoring.statements import assigned_names
from workbook.checks.contract.check_cells import reported_names

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
#: A problem at the level core asks for no more answers; one with more than `FEW_ENOUGH` says which
#: items are its core.
A_DOZEN, FEW_ENOUGH = 12, 15
LISTED = re.compile(r"(?<=list of )((?:row )?[a-z]+)\b(?![/(])")
ITEM = re.compile(r"([a-z])_")
SOLUTION = re.compile(r"\{solution-(start|end)\}")
FORMS = {str: "a text", list: "a list", dict: "names with what belongs to each"}


def master_file(number):
    """The file of a problem below solutions/: 1.15 stands in ch1/p15.md."""
    chapter, _, problem = number.partition(".")
    return Path(f"ch{chapter}") / f"p{problem:0>2}.md"


def hold_front_matter(path, said, lines):
    """Raises `MasterError` at the line (`lines`, by place) of what is missing or has not the form
    it should have."""

    def hold(kept, expected, *place):
        if not kept:
            raise MasterError(path, lines.get(place, lines[()]), expected)

    hold(isinstance(said, dict), f"problem: needs {', '.join(FIELDS)}")
    for field in [*FIELDS, *said]:
        hold(
            field in said and field in FIELDS | OPTIONAL,
            f"problem: needs {', '.join(FIELDS)} and no more, but perhaps core; look at {field}",
            field,
        )
    number = said["number"]
    hold(
        isinstance(number, str) and re.fullmatch(r"\d+\.\d+", number),
        'problem.number is to be quoted, "1.15"',
        "number",
    )
    belongs = master_file(number)
    hold(
        Path(path.parent.name, path.name) == belongs,
        f"problem {number} belongs into {belongs}",
        "number",
    )
    for field, form in (
        FIELDS | {field: form for field, form in OPTIONAL.items() if field in said}
    ).items():
        hold(
            isinstance(said[field], form) and said[field],
            f"problem.{field} is {FORMS[form]}",
            field,
        )
    hold(said["level"] in LEVELS, f"problem.level is one of {', '.join(LEVELS)}", "level")
    for name, text in said["answers"].items():
        kind, colon, _ = str(text).partition(":")
        hold(
            colon and kind.strip().startswith(TYPES),
            f'answer {name} is to read "TYPE: what it is", TYPE one of {", ".join(TYPES)}',
            "answers",
            name,
        )
        hold(name in said["hints"], f"every answer needs hints; {name} has none", "answers", name)
    for name, texts in said["hints"].items():
        hold(
            name in said["answers"],
            f"hints are for answers; {name} is none{meant(name, said['answers'])}",
            "hints",
            name,
        )
        hold(
            isinstance(texts, list) and texts and all(isinstance(text, str) for text in texts),
            f"the hints for {name} are a list of texts",
            "hints",
            name,
        )
    _hold_core(hold, said)


def _hold_core(hold, said):
    """The core of a long problem: some of its items, with at most half of its answers."""
    items, core = Counter(item_of(name) for name in said["answers"]), said.get("core", [])
    asked = items.total()
    hold(
        said["level"] != "core" or asked <= A_DOZEN,
        f"with {asked} answers, more than a dozen, a problem is advanced at least",
        "level",
    )
    hold(
        core or asked <= FEW_ENOUGH or len(items) <= 3,
        f"with {asked} answers problem.core names the items that are enough at first, like [a, d]",
        "answers",
    )
    for item in core:
        hold(item in items, f"problem.core is a list of items; {item} is none", "core")
    hold(
        sum(items[item] for item in core) <= asked / 2,
        "the core of a problem is at most half of its answers",
        "core",
    )


def in_words(kind):
    """The TYPE of an answer as a reader is told it.

    >>> in_words("list of matrix"), in_words("list of row vector exact"), in_words("number")
    ('list of matrices', 'list of row vectors exact', 'number')
    """
    return LISTED.sub(lambda one: one[1].replace("matrix", "matrice") + "s", kind)


def item_of(name):
    """The item that an answer belongs to: a for a_region, "" where a problem has no items."""
    found = ITEM.match(name)
    return found[1] if found else ""


def hold_code(master, lines):
    """Raises `MasterError` at an answer not assigned once and checked once, and at a check of what
    is not there."""
    cells = {
        role: [cell for cell in master.cells if cell.role == role]
        for role in ("data", "answer", "check")
    }
    for cell in cells["data"]:
        for name in assigned_names(cell.source, master.answers):
            raise MasterError(master.path, cell.line, f"a data cell assigns the answer {name}")
    _hold_once(
        master,
        lines,
        "the answer cells assign every answer once",
        [
            (name, cell)
            for cell in cells["answer"]
            for name in assigned_names(cell.source, master.answers)
        ],
    )
    _hold_once(
        master,
        lines,
        "the check cells report every answer once",
        [(name, cell) for cell in cells["check"] for name in reported_names(cell.source)],
    )
    data = {node.id for cell in cells["data"] for node in _nodes(cell, ast.Name)}
    for cell in cells["check"]:
        _hold_names(master.path, cell, {"checks", *data, *master.answers})


def hold_drawings(master):
    """Raises `MasterError` at a drawing inside a solution, which students do not get, or without a
    caption."""
    within = ""
    for cell, following in zip(master.cells, (*master.cells[1:], None)):
        if cell.role == "":
            within = (SOLUTION.findall(cell.source) or [within])[-1]
        elif cell.role == "drawing":
            if within == "start":
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


def hold_blocks(master):
    """Raises `MasterError` at what the site cannot read: a heading below the title, a solution that
    begins otherwise than with the label of its exercise."""
    label = "ex-" + master.number.replace(".", "-")
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
            begun = re.match(r"`{3,}\{solution-start\}\s*(.*?)\s*$", text)
            if begun and begun[1] != label:
                raise MasterError(
                    master.path, cell.line + k, f"a solution begins with {{solution-start}} {label}"
                )


def caption_above(text):
    """The caption that a text begins with, "" if its first paragraph is none."""
    first = text.strip().split("\n\n")[0]
    return first[1:-1] if re.fullmatch(r"\*[^*\s].*[^*\s]\*", first, re.S) else ""


def _hold_once(master, lines, rule, done):
    names = [name for name, _ in done]
    for name, cell in done:
        if name not in master.answers:
            raise MasterError(
                master.path, cell.line, f"{rule}; {name} is none{meant(name, master.answers)}"
            )
        if names.count(name) > 1:
            raise MasterError(master.path, cell.line, f"{rule}; {name} stands here and elsewhere")
    for name in master.answers:
        if name not in names:
            raise MasterError(
                master.path, lines["answers", name], f"{rule}; none does so with {name}"
            )


def _hold_names(path, cell, known):
    """The checks that a check cell calls exist, and so do the names that it hands over."""
    from workbook import checks

    known_checks = [*checks.__all__, *(f"research.{name}" for name in checks.research.__all__)]
    for node in _nodes(cell, ast.Name):
        if node.id not in known:
            raise MasterError(
                path,
                cell.line + node.lineno - 1,
                f"{node.id} is neither an answer nor a name of a data cell{meant(node.id, known)}",
            )
    for node in _nodes(cell, ast.Attribute):
        called = ast.unparse(node)
        if called.startswith("checks.") and called != "checks.research":
            name = called.removeprefix("checks.")
            if name not in known_checks:
                raise MasterError(
                    path,
                    cell.line + node.lineno - 1,
                    f"there is no check {name}{meant(name, known_checks)}",
                )


def _nodes(cell, kind):
    return [node for node in ast.walk(ast.parse(cell.source)) if isinstance(node, kind)]


def meant(name, known):
    """The names that somebody may have meant, as the end of a message."""
    near = get_close_matches(str(name), known)
    return f"; did you mean {' or '.join(near)}?" if near else ""
