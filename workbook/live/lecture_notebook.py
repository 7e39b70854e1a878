"""Make the notebook that a class sees: slides of a lecture, or a problem without solution.

A problem's notebook is made of the student notebook, which holds no solution: magics stand where
the student would work. A lecture is a page of the book; what the site leaves out stands in it as

    ```{live}
    %mistake 1.15 a_region
    ```

and becomes a cell. A heading begins a slide; each computation is a slide below it.
"""

import json
import re

from workbook.authoring.plain_markdown import plain_markdown
from workbook.checks.contract.check_cells import reported_names
from workbook.notebooks.new_cells import new_code_cell, new_markdown_cell, new_notebook

LIVE = re.compile(r"^(`{3,})\{live\}[ \t]*\n(.*?)^\1[ \t]*$\n?", re.M | re.S)
HEADING = re.compile(r"^(?=#{1,3} )", re.M)
#: Settings of jupyterlab-rise: a theme that loads no fonts from another host.
SLIDES = {"theme": "white", "scroll": True, "center": False, "width": "100%", "height": "100%"}


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
        if "instruction" in tags or "setup" in tags:
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
            cells.append(new_code_cell(cell.source, **_slide("subslide")))
            continue
        end = 0
        for live in (*LIVE.finditer(cell.source), None):
            cells += _slides(cell.source[end : live.start() if live else None])
            if live:
                cells.append(new_code_cell(live[2].strip(), **_slide("subslide")))
                end = live.end()
    return cells


def _slides(text):
    for part in HEADING.split(text):
        if markdown := plain_markdown(part)[0]:
            yield new_markdown_cell(markdown, **_slide("slide" if HEADING.match(part) else "-"))


def _slide(kind):
    return {"slideshow": {"slide_type": kind}}
