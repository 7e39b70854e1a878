"""Downloads: the students' notebooks, the wheel of trajlib and workbook, the book as PDF, the whole site.

A notebook has the same path as in the repository, exercises/ch1/p15.ipynb; `make` puts the wheel
into wheels/, what `make pdf` printed into pdf/ and what `make bundle` packed into bundle/.
"""

import json
import posixpath
from datetime import datetime
from html import escape
from importlib.metadata import version
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective, SphinxRole

from workbook.notebooks import exercises
from workbook_site import catalogue


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


class BuiltFilesDirective(SphinxDirective):
    """Lists the book as PDF and the packed site, where they were made."""

    def run(self):
        # they are made after the page was read
        self.env.note_reread()
        build = Path(self.env.srcdir) / "_build"
        paths = [*sorted(build.glob("pdf/*.pdf")), *build.glob("bundle/*.zip")]
        if not paths:
            how = "This copy was built without them: `make pdf` prints the book, `make bundle` packs the site."
            return self.parse_text_to_nodes(how)
        items = [nodes.list_item("", nodes.paragraph("", "", *self.entry(path))) for path in paths]
        return [nodes.bullet_list("", *items)]

    def entry(self, path):
        name = path.stem.replace("-", " ").capitalize()
        site = "The site, with notebooks and the wheel"
        title = site if path.suffix == ".zip" else f"{name} (PDF)"
        date = datetime.fromtimestamp(path.stat().st_mtime).strftime("%d %B %Y").lstrip("0")
        address = str(path.relative_to(Path(self.env.srcdir) / "_build"))
        return [
            link(self.env.docname, address, escape(title)),
            nodes.Text(f", {path.stat().st_size / 1e6:.0f} MB, made on {date}"),
        ]


def wheel_name():
    return f"trajlib-{version('trajlib')}-py3-none-any.whl"


def link(page, address, inner):
    """Return a download link from a page to an address below the root; `inner` is its HTML."""
    relative = posixpath.relpath(address, posixpath.dirname(page) or ".")
    return nodes.raw(
        "", f'<a class="download" href="{escape(relative)}" download>{inner}</a>', format="html"
    )


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
    app.add_role("wheel", WheelRole())
    app.add_role("install-wheel", InstallWheelRole())
    app.add_directive("built-files", BuiltFilesDirective)
    app.connect("build-finished", _copy_notebooks)
