"""Make the notebook that a class sees: slides of a lecture, or a problem without solution.

A problem's notebook is made of the student notebook, which holds no solution: magics stand where
the student would work. A lecture is a page of the book; what the site leaves out stands in it as

    ```{live}
    %mistake 1.15 a_region
    ```

and becomes a cell, below what it asks for. A heading begins a slide; below it are slides of at most
forty words, with the computation that follows them, and one for each long computation or picture. The
code of a picture is folded, its caption stands beside or below it. A cell that shows nothing (imports,
functions, data) is on no slide: it runs unseen before the next one.
"""

import ast
import itertools
import json
import re

from workbook.authoring.plain_markdown import plain_markdown
from workbook.checks.contract.check_cells import reported_names
from workbook.live.slide_texts import HEADING, slide_texts
from workbook.notebooks import exercises
from workbook.notebooks.new_cells import new_code_cell, new_markdown_cell, new_notebook

LIVE = re.compile(r"^(`{3,})\{live\}[ \t]*\n(.*?)^\1[ \t]*$\n?", re.M | re.S)
NEW_TITLE = re.compile(r"^(?=#{1,3} )", re.M)
CAPTION = re.compile(r"\*[^*].*?[^*]\*(?=\n\n|\Z)", re.S)
FOLDED = {"jupyter": {"source_hidden": True}}
UNSEEN = {"slideshow": {"slide_type": "skip"}, **FOLDED}
#: Lines of code that fit below a text of forty words.
MOST_LINES_BELOW_TEXT = 12
#: Settings of jupyterlab-rise: a theme that loads no fonts from another host.
SLIDES = {
    "theme": "white",
    "scroll": True,
    "center": False,
    "width": "100%",
    "height": "100%",
    "transition": "none",
    "auto_select": "none",
}


def lecture_notebook(presentation):
    """Return the notebook of a presentation as a dict in nbformat 4.5."""
    make_cells = _lecture_cells if presentation.is_lecture else _problem_cells
    return new_notebook(
        make_cells(presentation.path.read_text(encoding="utf-8")),
        live={"presentation": presentation.name},
        rise=SLIDES,
    )


def _problem_cells(text):
    """Return the cells of a student notebook with magics for its stubs, without its hints."""
    cells = []
    for cell in json.loads(text)["cells"][:-1]:  # the last one names the source
        source, tags = "".join(cell["source"]), cell["metadata"].get("tags", [])
        if {"instruction", "setup", "steps"} & set(tags):
            continue
        if "answer" in tags:
            stub = re.search(r"^(\w+) = \.\.\.", source, re.MULTILINE)
            cells.append(new_code_cell(f"%answer {stub[1]}"))
        elif "check" in tags:
            cells += [new_code_cell(f"%check {name}") for name in reported_names(source)]
        elif cell["cell_type"] == "code":
            cells.append(new_code_cell(source))
        elif not source.startswith("<details><summary>Hint "):
            cells.append(new_markdown_cell(source, cell.get("attachments")))
    return cells


def _lecture_cells(text):
    from jupytext.myst import myst_to_notebook  # takes 0.2 s, and problems do not need it

    cells = []
    for cell in myst_to_notebook(text).cells:
        if cell.cell_type == "code":
            cells += _code(cell.source, "figure" in cell.metadata.get("tags", []), cells)
            continue
        end = 0
        for live in (*LIVE.finditer(cell.source), None):
            cells += _slides(cell.source[end : live.start() if live else None], cells)
            if live:
                cells += _magic(live[2].strip(), cells)
                end = live.end()
    return cells


def _slides(text, before):
    """Yield the Markdown cells of a text; the caption of a picture stays on its slide."""
    text = plain_markdown(text)[0].strip()
    caption = CAPTION.match(text)
    if caption and before and before[-1]["cell_type"] == "code":
        yield new_markdown_cell(caption[0], **_slide("-"))
        text = text[caption.end() :]
    for part in filter(str.strip, NEW_TITLE.split(text)):
        for k, slide in enumerate(slide_texts(part.strip())):
            is_first = k == 0 and HEADING.match(part)
            yield new_markdown_cell(slide, **_slide("slide" if is_first else "subslide"))


def _code(source, is_figure, before):
    """Yield the cells of code: its imports, which run unseen, and the rest."""
    statements = ast.parse(source).body
    imports = itertools.takewhile(
        lambda statement: isinstance(statement, (ast.Import, ast.ImportFrom)), statements
    )
    end = max((statement.end_lineno for statement in imports), default=0)
    lines = source.split("\n")
    if not is_figure and not _shows_something(statements):
        end = len(lines)
    if end:
        yield new_code_cell("\n".join(lines[:end]), **UNSEEN)
    if end == len(lines):
        return
    rest = "\n".join(lines[end:]).strip("\n")
    below_text = _last_shown(before)["cell_type"] == "markdown"
    if not is_figure and below_text and rest.count("\n") < MOST_LINES_BELOW_TEXT:
        yield new_code_cell(rest, **_slide("-"))
    else:
        yield new_code_cell(rest, **_place_of_code(before), **(FOLDED if is_figure else {}))


def _shows_something(statements):
    """Return whether code ends with an expression, or calls a function by its name only."""
    calls = (
        node.value.func
        for statement in statements
        if not isinstance(statement, ast.FunctionDef)
        for node in ast.walk(statement)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)
    )
    return isinstance(statements[-1], ast.Expr) or any(isinstance(call, ast.Name) for call in calls)


def _magic(line, before):
    """Return the cell of a magic, below the answer that it is about."""
    magic, number, *rest = line.split()
    if magic == "%explore":
        return [new_code_cell(line, **_place_of_code(before))]
    answer = exercises.find(number).about["answers"][rest[0]]["text"]
    question = new_markdown_cell(f"**Problem {number}:** {answer}", **_place_of_code(before))
    return [question, new_code_cell(line, **_slide("-"))]


def _place_of_code(before):
    """Return where code goes: below a title that has no text, else to a slide of its own."""
    title_alone = not HEADING.sub("", _last_shown(before)["source"] + "\n", count=1)
    return _slide("-" if title_alone else "subslide")


def _last_shown(cells):
    return next(cell for cell in reversed(cells) if cell["metadata"] != UNSEEN)


def _slide(kind):
    return {"slideshow": {"slide_type": kind}}
