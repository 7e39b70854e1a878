"""Pictures with a number, a caption and alternative text.

A master writes a picture's caption as a paragraph in emphasis under the cell that draws it; in a
student's notebook it is under the picture that replaces the cell. In the page both become one
<figure>: "Figure 5.9a" on a problem's page, "Figure 1" on any other. The alternative text is the
first sentence of the caption.
"""

import re
from pathlib import Path
from string import ascii_lowercase

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform

from workbook.authoring.drawing_cells import alt_text
from workbook.site import catalogue

SIZE = re.compile(r'viewBox="0 0 ([\d.]+) ([\d.]+)"')


class CaptionFigures(SphinxPostTransform):
    """Joins pictures and captions, after myst-nb chose the outputs and before it folds code."""

    default_priority = 150
    formats = ("html",)

    def run(self, **kwargs):
        sources = list(
            self.document.findall(lambda node: _makes_pictures(node) or _is_picture(node))
        )
        for k, cell in enumerate(sources):
            *others, last = cell.findall(nodes.image)
            caption = _caption_below(cell)
            number = self._number(k, len(sources))
            text = alt_text(_as_written(caption)) if caption is not None else ""
            for image in (*others, last):
                image["alt"] = f"{number}: {text}" if text else number
            if caption is not None:
                caption.parent.remove(caption)
                label = nodes.strong("", f"{number}. ")
                picture = last.deepcopy()
                if self._has_panels(last):
                    picture = nodes.container("", picture, classes=["panels"])
                figure = nodes.figure(
                    "",
                    picture,
                    nodes.caption("", "", label, *caption[0].children),
                    ids=[nodes.make_id(number)],
                )
                last.replace_self(figure)

    def _has_panels(self, image):
        """Return whether a picture is too wide to be read on a phone at once.

        That is two panels side by side, or a picture shown there at less than half its size (the
        sizes are in points).
        """
        file = Path(self.env.srcdir, image["uri"].lstrip("/"))
        size = SIZE.search(file.read_text(encoding="utf-8")) if file.suffix == ".svg" else None
        width, height = map(float, size.groups()) if size else (0, 1)
        return width > (500 if width > 1.7 * height else 540)

    def _number(self, k, count):
        problem = catalogue.of(self.env).get(self.env.docname)
        if problem is not None:
            return f"Figure {problem.number}{ascii_lowercase[k] if count > 1 else ''}"
        return f"Figure {k + 1}"


def _makes_pictures(node):
    """Return whether a node is a code cell that shows pictures."""
    is_cell = isinstance(node, nodes.container) and node.get("nb_element") == "cell_code"
    return is_cell and any(node.findall(nodes.image))


def _is_picture(node):
    """Return whether a node is a paragraph of nothing but a picture."""
    return isinstance(node, nodes.paragraph) and len(node) == 1 and isinstance(node[0], nodes.image)


def _caption_below(cell):
    """Return the paragraph under a cell or a picture if it consists of emphasis alone."""
    following = cell.next_node(siblings=True, descend=False)
    is_caption = (
        isinstance(following, nodes.paragraph)
        and len(following) == 1
        and isinstance(following[0], nodes.emphasis)
    )
    return following if is_caption else None


def _as_written(caption):
    """Return the text of a caption, its formulas between dollars."""
    return "".join(
        f"${part.astext()}$" if isinstance(part, nodes.math) else part.astext()
        for part in caption.findall(lambda node: isinstance(node, (nodes.math, nodes.Text)))
        if not isinstance(part.parent, nodes.math)
    )


def setup(app):
    app.add_post_transform(CaptionFigures)
