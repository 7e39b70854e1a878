"""What `make` builds beside the pages: the wheel of trajlib and workbook, the book as PDF, the whole site.

The wheel is put into wheels/, what `make pdf` printed into pdf/, and what `make bundle` packed into
bundle/.
"""

from datetime import datetime
from html import escape
from importlib.metadata import version
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective, SphinxRole

from workbook.site.downloads import link

#: In lines to be copied, where the site has no address of its own.
EXAMPLE_SITE = "https://workbook.example"
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


def name_own_address(app, page, source):
    """Write the site's address, if it has one, for that of the example in lines to be copied."""
    if app.config.html_baseurl:
        source[0] = source[0].replace(EXAMPLE_SITE, app.config.html_baseurl.rstrip("/"))


def setup(app):
    app.add_role("wheel", WheelRole())
    app.add_role("install-wheel", InstallWheelRole())
    app.add_directive("built-files", BuiltFilesDirective)
    app.connect("source-read", name_own_address)
