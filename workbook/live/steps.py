"""The worked solution of an answer, cut into steps as one would write them on a board.

A step is a paragraph with its formulas, a computation, a picture or its caption. What stands before
the cell that assigns an answer leads to it, what follows, up to the reasoning for the next answer,
belongs to it too.
"""

import ast
import re
from dataclasses import dataclass

IDEA, CODE, PICTURE = "idea", "code", "picture"
FENCE = re.compile(r"^(`{3,}|:{3,})\{solution-(start|end)\}.*?^\1[ \t]*$\n?", re.M | re.S)
#: A blank line, but not one inside a formula or a directive: these keep their blank lines
#: (`_paragraphs`).
BLANK = re.compile(r"\n{2,}")


@dataclass(frozen=True)
class Step:
    """`kind` is one of IDEA, CODE and PICTURE, `text` Markdown or the source of a cell."""

    kind: str
    text: str


def steps_of(master):
    """{answer: its steps}; answers that come out of one reasoning have the same."""
    from workbook.authoring.statements import assigned_names

    found = {}
    for solution in _solutions(master):
        group, names = [], []
        for k, (role, source) in enumerate(solution):
            if role == "" and names and _leads_to_more(solution[k:], master):
                group, names = [], []
            group += _steps(role, source)
            names += assigned_names(source, master.answers) if role == "answer" else []
            found |= dict.fromkeys(names, group)
    return {name: tuple(found[name]) for name in master.answers if name in found}


def _leads_to_more(rest, master):
    """Whether a text opens the reasoning for another answer: it is no caption, and an answer cell
    comes after it."""
    from workbook.authoring.statements import assigned_names

    return not _is_caption(rest[0][1]) and any(
        role == "answer" and assigned_names(source, master.answers) for role, source in rest
    )


def _solutions(master):
    """The cells inside each solution, as (role, text)."""
    solutions, inside = [], False
    for cell in master.cells:
        if cell.role:
            if inside:
                solutions[-1].append((cell.role, cell.source))
            continue
        end = 0
        for fence in (*FENCE.finditer(cell.source), None):
            text = cell.source[end : fence.start() if fence else None].strip()
            if inside and text:
                solutions[-1].append(("", text))
            if fence:
                end, inside = fence.end(), fence[2] == "start"
                if inside:
                    solutions.append([])
    return solutions


def _steps(role, source):
    if role == "figure":
        return [Step(PICTURE, source)]
    if role:
        return [Step(CODE, source)]
    return [Step(IDEA, text) for text in _paragraphs(source)]


def _paragraphs(text):
    """Paragraphs, each with the formulas, lists and boxes that follow it."""
    whole = []
    for part in BLANK.split(text):
        inside = whole and (
            whole[-1].count("$$") % 2 or len(re.findall(r"^(?:`{3,}|:{3,})", whole[-1], re.M)) % 2
        )
        if whole and (inside or re.match(r"\$\$|[-*] |\d+\. |`{3,}\{math\}|[a-z,;|]", part)):
            whole[-1] += "\n\n" + part
        else:
            whole.append(part)
    return whole


def _is_caption(text):
    from workbook.authoring.contract import caption_above

    return bool(caption_above(text))


def needed_imports(sources):
    """The import statements of cells, as one source."""
    return "\n".join(
        ast.unparse(node)
        for source in sources
        for node in ast.parse(source).body
        if isinstance(node, (ast.Import, ast.ImportFrom))
    )


def names_used(source):
    """Names that a cell reads and does not bind itself, as far as one can see."""
    nodes = list(ast.walk(ast.parse(source)))
    names = [node for node in nodes if isinstance(node, ast.Name)]
    bound = {node.id for node in names if isinstance(node.ctx, ast.Store)}
    bound |= {node.arg for node in nodes if isinstance(node, ast.arg)}
    bound |= {node.name for node in nodes if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    bound |= {
        (alias.asname or alias.name).partition(".")[0]
        for node in nodes
        if isinstance(node, (ast.Import, ast.ImportFrom))
        for alias in node.names
    }
    return {node.id for node in names if isinstance(node.ctx, ast.Load)} - bound
