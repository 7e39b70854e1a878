"""The drawings of a master as pictures inside the student's copy, which shows them when it is
opened, before it is run.

Another release of Matplotlib draws the same picture with other bytes. So a picture carries a
fingerprint of what it was drawn by, the cell and the module of shapes, and stays as it is while
this does not change.
"""

import base64
import hashlib
import json
import re

from trajlib.typesetting import plain
from workbook.authoring.errors import MasterError
from workbook.notebooks import dependencies


class Drawn:
    """Gives the cells of the student's copy that show the drawings of a master."""

    def __init__(self, master):
        self._master = master
        self._before = _pictures(master.exercise)

    def cell(self, drawing, caption):
        """The Markdown cell with the picture of a drawing cell; who cannot see it is told how its
        caption begins."""
        mark = fingerprint(drawing.source)
        picture = self._before.get(mark) or base64.b64encode(self._draw(drawing).png()).decode()
        return {
            "cell_type": "markdown",
            "id": "",
            "metadata": {"drawn": mark},
            "attachments": {"drawing.png": {"image/png": picture}},
            "source": f"![{beginning(caption)}](attachment:drawing.png)",
        }

    def _draw(self, drawing):
        from workbook.display.drawings import Drawing

        names = {}
        try:
            exec(compile(drawing.source, "<drawing cell>", "exec"), names)
        except Exception as error:
            raise MasterError(
                self._master.path,
                drawing.line,
                f"a drawing is drawn by its own cell alone; {type(error).__name__}: {error}",
            ) from error
        last = drawing.source.strip().split("\n")[-1]
        if not isinstance(names.get(last), Drawing):
            raise MasterError(
                self._master.path, drawing.line, "the last line of a drawing cell names its Drawing"
            )
        return names[last]


def fingerprint(source):
    """What tells whether a drawing is to be drawn anew."""
    shapes = dependencies.path_of("workbook.display.drawings").read_text(encoding="utf-8")
    return hashlib.sha256((source + "\0" + shapes).encode()).hexdigest()[:16]


def beginning(caption):
    """How a caption begins, for whoever cannot see its picture: as many sentences as say something
    ("Item b." alone does not).

    >>> beginning("Item $b$. The end; its [law](#law) is\\nknown: all $x_1$. More.")
    'Item b. The end; its law is known: all x1.'
    """
    said = plain(re.sub(r"\[([^]]*)\](\([^)]*\))?", r"\1", caption))
    words, *others = re.split(r"(?<=[.:;])\s+(?=\S)", " ".join(said.split()))
    while others and len(words) < 40:
        words += " " + others.pop(0)
    return words.rstrip(".:;") + "."


def _pictures(notebook):
    """{fingerprint: picture} of a student's copy on disk."""
    if not notebook.exists():
        return {}
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return {
        cell["metadata"]["drawn"]: cell["attachments"]["drawing.png"]["image/png"]
        for cell in cells
        if "drawn" in cell["metadata"]
    }
