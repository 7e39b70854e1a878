"""Put the drawings of a master into the student notebook, as pictures.

Another release of Matplotlib draws the same picture with other bytes. So a picture carries a
fingerprint of the code that draws it, and is kept as long as the fingerprint is the same.
"""

import ast
import base64
import hashlib
import json
import re

from trajlib.typesetting import plain
from workbook.authoring.errors import MasterError
from workbook.notebooks.dependencies import module_path
from workbook.notebooks.new_cells import new_markdown_cell


class DrawingCells:
    """Make the cells of a student notebook that show the drawings of a master."""

    def __init__(self, master):
        self._master = master
        self._stored = _stored_pictures(master.exercise)

    def cell(self, drawing, caption):
        """Return the Markdown cell with the picture of a drawing cell and its text alternative."""
        mark = fingerprint(drawing.source)
        picture = self._stored.get(mark) or base64.b64encode(self._draw(drawing).png()).decode()
        return new_markdown_cell(
            f"![{alt_text(caption)}](attachment:drawing.png)",
            attachments={"drawing.png": {"image/png": picture}},
            drawn=mark,
        )

    def _draw(self, drawing):
        # for pages with a drawing only
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
    """Return a hash of the code that makes a drawing: its cell and the modules of shapes."""
    shapes = [
        _without_docstrings(module_path(f"workbook.display.{name}").read_text("utf-8"))
        for name in ("sheet", "drawings")
    ]
    return hashlib.sha256("\0".join([source, *shapes]).encode()).hexdigest()[:16]


def _without_docstrings(source):
    """Return the lines of a module without docstrings, comment lines and blank lines."""
    lines = source.splitlines()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(
            node
        ):
            docstring = node.body[0]
            for k in range(docstring.lineno - 1, docstring.end_lineno):
                lines[k] = ""
    return "\n".join(line for line in lines if line.strip() and not line.lstrip().startswith("#"))


def alt_text(caption):
    """Return the first sentences of a caption as the text alternative of its picture.

    A short first sentence ("Item b.") is followed by the next ones.

    >>> alt_text("Item $b$. The end; its [law](#law) is\\nknown: all $x_1$. More.")
    'Item b. The end; its law is known: all x1.'
    """
    text = plain(re.sub(r"\[([^]]*)\](\([^)]*\))?", r"\1", caption))
    first, *sentences = re.split(r"(?<=[.:;])\s+(?=\S)", " ".join(text.split()))
    while sentences and len(first) < 40:
        first += " " + sentences.pop(0)
    return first.rstrip(".:;") + "."


def _stored_pictures(notebook):
    """Return {fingerprint: picture in base64} of a student notebook on disk."""
    if not notebook.exists():
        return {}
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return {
        cell["metadata"]["drawn"]: cell["attachments"]["drawing.png"]["image/png"]
        for cell in cells
        if "drawn" in cell["metadata"]
    }
