"""Signs and the formulas that they follow, in a text that says the same thing twice."""

import sys
from pathlib import Path

from docutils import nodes
from docutils.utils import new_document

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "book" / "_ext"))
from workbook.punctuation import KeepWithFormula  # noqa: E402


def test_equal_texts_are_told_apart():
    document = new_document("page")
    a, b, c = (nodes.math("", letter) for letter in "abc")
    document += nodes.paragraph("", "", a, nodes.Text(" is zero "), nodes.emphasis("", "always"),
                                nodes.Text(". Where "), b, nodes.Text(". Where "), c)
    KeepWithFormula(document).run()
    assert document.astext() == "a is zero always. Where b. Where c"
    (together,) = document.findall(nodes.inline)
    assert together.astext() == "b."
