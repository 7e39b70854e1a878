"""Tiles of the front page: pages with their titles and a picture each.

Each line of `{tiles}` names a page, and where it has no picture of its own, the page to take one from:

    ch1 ch1/lyapunov
    lectures/basins

The picture is the first that the page's cells draw, but rather one that is not wide. Pages that are
not in the edition are left out, and with all of them the section.
"""

import re
from base64 import b64decode
from pathlib import Path

from docutils import nodes
from jupyter_cache import get_cache
from sphinx import addnodes
from sphinx.util.docutils import SphinxDirective

FOLDER = "_build/tiles"
STILL = re.compile(r'<img class="explorer-still"[^>]* src="data:image/svg\+xml;base64,([^"]+)"')
#: Black in the still of a figure, and the page's ink, as `book/kernel.py` has it for drawn pictures.
BLACK, INK = "#000000", "#1d2530"
#: Width and height of a picture.
SIZE = re.compile(r"""viewBox=["']\S+ \S+ ([\d.]+) ([\d.]+)""")
#: The left and the right end of a panel that Matplotlib drew, and room for half a number beside it.
PANEL = re.compile(r'<g id="axes_\d+">\s*<g id="patch_\d+">\s*<path d="M ([\d.]+) \S+\s+L ([\d.]+)')
BESIDE = 10


class Tiles(SphinxDirective):
    """Shows a section of tiles: its title, and a sentence about it if there is one."""

    has_content = True
    required_arguments = 1
    final_argument_whitespace = True
    option_spec = {"about": str}

    def run(self):
        tiles = nodes.container(classes=["tiles"])
        for line in self.content:
            page, *source = (f"book/{name}" for name in line.split())
            if page in self.env.found_docs:
                tiles += self._tile(page, *source or [page])
        if not tiles.children:
            return []
        title = self.arguments[0]
        section = nodes.section("", nodes.title("", title), ids=[nodes.make_id(title)])
        if "about" in self.options:
            section += nodes.paragraph("", self.options["about"])
        section += tiles
        return [section]

    def _tile(self, page, source):
        tile = nodes.container(classes=["tile"])
        if picture := picture_of(self.env, source):
            classes = ["wide"] if is_wide(Path(self.env.srcdir, picture).read_text("utf-8")) else []
            tile += nodes.image(uri=f"/{picture}", alt="", classes=classes)
        title = addnodes.pending_xref(
            "",
            nodes.inline("", page),
            refdomain="std",
            reftype="doc",
            reftarget=f"/{page}",
            refexplicit=False,
            refwarn=True,
            refdoc=self.env.docname,
        )
        tile += nodes.paragraph("", "", title)
        return tile


def picture_of(env, page):
    """Write the first picture of a page that was executed; return its path from the root, or None.

    Rather one that is not wide; of a problem the first, the drawing of its statement.
    """
    source = Path(env.srcdir, f"{page}.md")
    env.note_dependency(str(source))
    cache = get_cache(env.config.nb_execution_cache_path)
    for record in cache.list_cache_records():
        if record.uri == str(source):
            pictures = list(_pictures(cache.get_cache_bundle(record.pk).nb))
            if page.startswith("book/"):
                pictures.sort(key=is_wide)
            for picture in pictures:
                file = Path(env.srcdir, FOLDER, f"{page.replace('/', '-')}.svg")
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(_first_panel(picture), encoding="utf-8")
                return file.relative_to(env.srcdir).as_posix()
    return None


def _pictures(notebook):
    """Return the drawn pictures, or where there are none those of interactive figures."""
    outputs = [
        output.get("data", {}) for cell in notebook.cells for output in cell.get("outputs", ())
    ]
    drawn = [output["image/svg+xml"] for output in outputs if "image/svg+xml" in output]
    stills = [STILL.search(output.get("text/html", "")) for output in outputs]
    return list(filter(SIZE.search, drawn)) or [
        b64decode(still[1]).decode("utf-8").replace(BLACK, INK) for still in stills if still
    ]


def _first_panel(picture):
    """Return of panels side by side the first, with nothing of the second."""
    panels = [tuple(map(float, ends)) for ends in PANEL.findall(picture)]
    if not is_wide(picture) or len(panels) < 2 or panels[0][1] > panels[1][0]:
        return picture
    width, height = panels[0][1] + BESIDE, float(SIZE.search(picture)[2])
    sizes = f'width="{width}pt" height="{height}pt" viewBox="0 0 {width} {height}"'
    return re.sub(r'width="\S+" height="\S+" viewBox="[^"]+"', sizes, picture, count=1)


def is_wide(picture):
    width, height = map(float, SIZE.search(picture).groups())
    return width > 1.7 * height


def setup(app):
    app.add_directive("tiles", Tiles)
