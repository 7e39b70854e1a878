"""Downloads: notebooks of students and of tutorials, the wheel of trajlib and workbook, the book as
PDF, the whole site.

A student's notebook has the same path as in the repository, exercises/ch1/p15.ipynb, and the notebook of
a page lies beside it; `make` puts the wheel into wheels/, what `make pdf` printed into pdf/ and what
`make bundle` packed into bundle/.
"""

import json
import posixpath
import re
from datetime import datetime
from html import escape
from importlib.metadata import version
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective, SphinxRole

from workbook.authoring.plain_markdown import plain_markdown
from workbook.notebooks import exercises
from workbook.notebooks.new_cells import new_code_cell, new_markdown_cell, new_notebook
from workbook_site import catalogue

#: In lines to be copied, where the site has no address of its own.
EXAMPLE_SITE = "https://workbook.example"
#: The address of a site on GitHub Pages: its owner, its repository and a folder in it.
GITHUB_PAGES = re.compile(r"https://([\w-]+)\.github\.io(?:/([\w.-]+)((?:/[\w.-]+)*))?/?")


#: What is said where something was not made.
MISSING = {
    "pdf/*.pdf": "This copy was built without the book as PDF: `make pdf` prints it.",
    "bundle/*.zip": "This copy was built without a packed site: `make bundle` packs it.",
}


class WheelRole(SphinxRole):
    """Links to the wheel that the site serves: {wheel}`the wheel`."""

    def run(self):
        name = wheel_name()
        return [
            link(self.env.docname, f"wheels/{name}", f"{escape(self.text)} (<code>{name}</code>)")
        ], []


class InstallWheelRole(SphinxRole):
    """Shows the command that installs the downloaded wheel with an extra: {install-wheel}`live`."""

    def run(self):
        return [nodes.literal("", f'pip install "{wheel_name()}[{self.text}]"')], []


class PageNotebookRole(SphinxRole):
    """Links to the notebook of the page itself: The page {page-notebook}`as a notebook`."""

    def run(self):
        page = self.env.docname
        self.env.metadata[page]["notebook"] = True
        return [link(page, f"{page}.ipynb", escape(self.text))], []


class BuiltFilesDirective(SphinxDirective):
    """Lists the wheel, and the book as PDF and the packed site where they were made."""

    def run(self):
        # they are made after the page was read
        self.env.note_reread()
        build = Path(self.env.srcdir) / "_build"
        made = {
            form: sorted(build.glob(form)) for form in ("wheels/*.whl", "pdf/*.pdf", "bundle/*.zip")
        }
        paths = [path for found in made.values() for path in found]
        items = [nodes.list_item("", nodes.paragraph("", "", *self.entry(path))) for path in paths]
        missing = [how for form, how in MISSING.items() if not made[form]]
        return [
            nodes.bullet_list("", *items, classes=["downloads"]),
            *(node for how in missing for node in self.parse_text_to_nodes(how)),
        ]

    def entry(self, path):
        name = path.stem.replace("-", " ").capitalize()
        title = {
            ".whl": "trajlib and workbook, to be installed by pip (wheel)",
            ".zip": "The site, with notebooks and the wheel",
        }.get(path.suffix, f"{name} (PDF)")
        date = datetime.fromtimestamp(path.stat().st_mtime).strftime("%d %B %Y").lstrip("0")
        address = str(path.relative_to(Path(self.env.srcdir) / "_build"))
        return [
            link(self.env.docname, address, escape(title)),
            nodes.Text(f", {path.stat().st_size / 1e6:.1f} MB, made on {date}"),
        ]


def wheel_name():
    return f"trajlib-{version('trajlib')}-py3-none-any.whl"


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


def name_own_address(app, page, source):
    """Write the site's address, if it has one, for that of the example in lines to be copied."""
    if app.config.html_baseurl:
        source[0] = source[0].replace(EXAMPLE_SITE, app.config.html_baseurl.rstrip("/"))


def setup(app):
    app.add_role("wheel", WheelRole())
    app.add_role("install-wheel", InstallWheelRole())
    app.add_role("page-notebook", PageNotebookRole())
    app.add_directive("built-files", BuiltFilesDirective)
    app.connect("source-read", name_own_address)
    app.connect("build-finished", _copy_notebooks)
    app.connect("build-finished", _write_page_notebooks)
