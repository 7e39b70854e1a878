"""Other numbers with which the pages ask problems again: the last rows of each problem that varies.

For each problem `_build/asked_again/ch2/p04.json` has row -> statement as HTML and student notebook. Cells
have the ids of the page's own notebook, so that the page's answer boxes belong to them. What is stale is
made anew.
"""

import json
from html import escape
from pathlib import Path

from markdown_it import MarkdownIt
from mdit_py_plugins.dollarmath import dollarmath_plugin

#: A right answer comes back three times.
ROWS = 3


def main(root, problems="ch*/p*"):
    """Write what is stale of some problems; return the exit code."""
    from workbook.authoring.links import Links

    links = None
    for trials in sorted(root.glob(f"solutions/{problems}.trials.py")):
        if "\n# %% numbers" not in trials.read_text(encoding="utf-8"):
            continue
        page = trials.with_name(trials.name.replace(".trials.py", ".md"))
        exercise = root / "exercises" / page.parent.name / f"{page.stem}.ipynb"
        target = root / "_build" / "asked_again" / page.parent.name / f"{page.stem}.json"
        newest = max(path.stat().st_mtime for path in (trials, page, exercise, Path(__file__)))
        if target.exists() and target.stat().st_mtime > newest:
            continue
        links = links or Links(root)
        rows = rows_of(page, json.loads(exercise.read_text(encoding="utf-8")), links)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(json.dumps(rows, ensure_ascii=False), encoding="utf-8")
    return 0


def rows_of(page, exercise, links):
    """Return row -> {"statement", "notebook"} for the last rows of a problem."""
    from workbook.authoring.master import read_master
    from workbook.authoring.student_notebook import student_notebook
    from workbook.authoring.variants import Variants

    variants, found = Variants(read_master(page)), {}
    last = len(variants.numbers.rows)
    for row in range(max(1, last - ROWS), last):
        notebook = student_notebook(variants.variant(row), links)
        for cell, own in zip(notebook["cells"], exercise["cells"], strict=True):
            cell["id"] = own["id"]
        found[str(row)] = {"statement": statement_of(notebook), "notebook": notebook}
    return found


def statement_of(notebook):
    """Return the statement of a notebook as HTML: its text and its data, up to the first answer."""
    markdown = MarkdownIt("commonmark").enable("table").use(dollarmath_plugin, renderer=_formula)
    parts = []
    for cell in notebook["cells"]:
        tags = cell["metadata"].get("tags", ())
        if "answer" in tags:
            break
        if "data" in tags:
            parts.append(f'<pre class="data">{escape(cell["source"])}</pre>')
        elif cell["cell_type"] == "markdown" and not tags:
            text = cell["source"]
            parts.append(
                markdown.render(text.partition("\n")[2] if text.startswith("# ") else text)
            )
    return "".join(parts)


def _formula(content, options):
    before, after = (r"\[", r"\]") if options["display_mode"] else (r"\(", r"\)")
    return before + escape(content) + after
