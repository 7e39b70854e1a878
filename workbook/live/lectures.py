"""A lecture of book/lectures/ as the notebook that is shown: its slides, and the cells that only a
lecture has.

A lecture is a page of the book. What the site leaves out stands in it as

    ```{live}
    %mistake 1.15 a_region
    ```

and becomes a cell. A heading begins a slide; each computation is a slide below it.
"""

import re

from workbook.live.prose import prose

LIVE = re.compile(r"^(`{3,})\{live\}[ \t]*\n(.*?)^\1[ \t]*$\n?", re.M | re.S)
HEADING = re.compile(r"^(?=#{1,3} )", re.M)


def cells_of(path):
    """The cells of the notebook made of the lecture at `path`."""
    from jupytext.myst import myst_to_notebook

    from workbook.live.copies import code

    cells = []
    for cell in myst_to_notebook(path.read_text(encoding="utf-8")).cells:
        if cell.cell_type == "code":
            cells.append(code(cell.source, **_slide("subslide")))
            continue
        end = 0
        for live in (*LIVE.finditer(cell.source), None):
            cells += _slides(cell.source[end : live.start() if live else None])
            if live:
                cells.append(code(live[2].strip(), **_slide("subslide")))
                end = live.end()
    return cells


def _slides(text):
    from workbook.live.copies import markdown

    for part in HEADING.split(text):
        if shown := prose(part):
            yield markdown(shown, **_slide("slide" if HEADING.match(part) else "-"))


def _slide(kind):
    return {"slideshow": {"slide_type": kind}}
