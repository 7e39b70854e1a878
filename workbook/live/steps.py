"""Cut the worked solution of an answer into steps, as one would write them on a board.

A step is a paragraph with its formulas, a computation, a picture or its caption. The steps of an
answer are the text before the cell that assigns it, the cell, and what follows up to the reasoning
for the next answer.
"""

import ast
import re
from dataclasses import dataclass

from workbook.authoring.contract import caption_above
from workbook.authoring.statements import assigned_names

TEXT, CODE, FIGURE = "text", "code", "figure"
FENCE = re.compile(r"^(`{3,}|:{3,})\{solution-(start|end)\}.*?^\1[ \t]*$\n?", re.M | re.S)
BLANK_LINES = re.compile(r"\n{2,}")


@dataclass(frozen=True)
class Step:
    """A step of a solution.

    Attributes
    ----------
    kind : str
        One of `TEXT`, `CODE` and `FIGURE`.
    text : str
        Markdown, or the source of a cell.
    """

    kind: str
    text: str


def solution_steps(master):
    """Return {answer: tuple of steps} of a master; answers found together share their steps."""
    steps = {}
    for solution in _solutions(master):
        group, names = [], []
        for k, (role, source) in enumerate(solution):
            if role == "" and names and _leads_to_more(solution[k:], master):
                group, names = [], []
            group += _steps(role, source)
            names += assigned_names(source, master.answers) if role == "answer" else []
            steps |= dict.fromkeys(names, group)
    return {name: tuple(steps[name]) for name in master.answers if name in steps}


def _leads_to_more(following_cells, master):
    """Return whether a text begins the reasoning for another answer.

    It does if it is no caption and an answer cell follows.
    """
    return not caption_above(following_cells[0][1]) and any(
        role == "answer" and assigned_names(source, master.answers)
        for role, source in following_cells
    )


def _solutions(master):
    """Return a list of (role, text) for each solution: its cells and the texts between them."""
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
        return [Step(FIGURE, source)]
    if role:
        return [Step(CODE, source)]
    return [Step(TEXT, text) for text in paragraphs(source)]


def paragraphs(text):
    """Split a text into paragraphs, each with the formulas, lists and boxes that follow it."""
    paragraphs = []
    for part in BLANK_LINES.split(text):
        inside = paragraphs and (
            paragraphs[-1].count("$$") % 2
            or len(re.findall(r"^(?:`{3,}|:{3,})", paragraphs[-1], re.M)) % 2
        )
        if paragraphs and (inside or re.match(r"\$\$|[-*] |\d+\. |`{3,}\{math\}|[a-z,;|]", part)):
            paragraphs[-1] += "\n\n" + part
        else:
            paragraphs.append(part)
    return paragraphs


def needed_imports(sources):
    """Return the import statements of cells as one source."""
    return "\n".join(
        ast.unparse(node)
        for source in sources
        for node in ast.parse(source).body
        if isinstance(node, (ast.Import, ast.ImportFrom))
    )


def names_used(source):
    """Return the names that a cell reads and does not bind itself, by its syntax tree."""
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
