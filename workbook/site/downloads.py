"""Downloads: the notebooks of students and of pages.

A student's notebook has the same path as in its course, exercises/ch1/p15.ipynb, and the notebook of a
page lies beside it.
"""

import json
import posixpath
import re
from html import escape
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxRole

from workbook.authoring.plain_markdown import plain_markdown
from workbook.notebooks import exercises
from workbook.notebooks.new_cells import new_code_cell, new_markdown_cell, new_notebook
from workbook.site import catalogue

#: The address of a site on GitHub Pages: its owner, its repository and a folder in it.
GITHUB_PAGES = re.compile(r"https://([\w-]+)\.github\.io(?:/([\w.-]+)((?:/[\w.-]+)*))?/?")


class PageNotebookRole(SphinxRole):
    """Links to the notebook of the page itself: The page {page-notebook}`as a notebook`."""

    def run(self):
        page = self.env.docname
        self.env.metadata[page]["notebook"] = True
        return [link(page, f"{page}.ipynb", escape(self.text))], []


def link(page, address, inner):
    """Return a download link from a page to an address below the root; `inner` is its HTML."""
    relative = posixpath.relpath(address, posixpath.dirname(page) or ".")
    return nodes.raw(
        "", f'<a class="download" href="{escape(relative)}" download>{inner}</a>', format="html"
    )


def colab_links(site, notebook):
    """Return a list with the link that opens a notebook of the site in Colab, if Colab can.

    It opens notebooks by their address only from GitHub, where the branch gh-pages holds a site.
    """
    match = GITHUB_PAGES.fullmatch(site)
    if match is None:
        return []
    owner, repository, folder = match.groups(default="")
    path = "/".join(filter(None, [folder.strip("/"), notebook]))
    address = "https://colab.research.google.com/github/" + "/".join(
        [owner, repository or f"{owner}.github.io", "blob", "gh-pages", path]
    )
    return [nodes.raw("", f' · <a href="{escape(address)}">Open in Colab</a>', format="html")]


def _copy_notebooks(app, exception):
    if exception is not None or app.builder.format != "html":
        return
    for problem in catalogue.of(app.env).values():
        copy = app.outdir / problem.notebook
        if (app.srcdir / problem.notebook).exists():
            copy.parent.mkdir(parents=True, exist_ok=True)
            notebook = served_notebook(app, problem)
            copy.write_text(
                json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8"
            )


def _write_page_notebooks(app, exception):
    if exception is not None or app.builder.format != "html":
        return
    for page in app.env.found_docs:
        if app.env.metadata[page].get("notebook"):
            text = Path(app.env.doc2path(page)).read_text(encoding="utf-8")
            copy = app.outdir / f"{page}.ipynb"
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(
                json.dumps(page_notebook(text), indent=1, ensure_ascii=False) + "\n",
                encoding="utf-8",
            )


def page_notebook(text):
    """Return the notebook of a page in MyST Markdown, without the line that links to it."""
    from jupytext.myst import myst_to_notebook

    text = re.sub(r"^.*\{page-notebook\}.*\n", "", text, flags=re.M)
    return new_notebook(
        [
            new_code_cell(cell.source)
            if cell.cell_type == "code"
            else new_markdown_cell(plain_markdown(cell.source)[0])
            for cell in myst_to_notebook(text).cells
        ]
    )


def served_notebook(app, problem):
    """Return a student notebook with links to this edition, if the site has an address."""
    source, base = app.srcdir / problem.notebook, app.config.html_baseurl
    notebook = json.loads(source.read_text(encoding="utf-8"))
    if base:
        to_site = exercises.site_urls(base)
        notebook = exercises.add_links(
            notebook,
            lambda path: to_site(
                path if problem.solved else path.replace("solutions/", "exercises/", 1)
            ),
        )
    return notebook


def setup(app):
    app.add_role("page-notebook", PageNotebookRole())
    app.connect("build-finished", _copy_notebooks)
    app.connect("build-finished", _write_page_notebooks)
