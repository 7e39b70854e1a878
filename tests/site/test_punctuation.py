"""Punctuation stays with the formula before it; a sentence begins with a capital."""

import sys
from pathlib import Path

from docutils import nodes
from docutils.utils import new_document

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "book" / "_ext"))
from workbook_site.punctuation import KeepWithFormula

from workbook.site.problem_pages import BeginWithCapital


def test_equal_texts_are_distinguished():
    document = new_document("page")
    a, b, c = (nodes.math("", letter) for letter in "abc")
    document += nodes.paragraph(
        "",
        "",
        a,
        nodes.Text(" is zero "),
        nodes.emphasis("", "always"),
        nodes.Text(". Where "),
        b,
        nodes.Text(". Where "),
        c,
    )
    KeepWithFormula(document).run()
    assert document.astext() == "a is zero always. Where b. Where c"
    (together,) = document.findall(nodes.inline)
    assert together.astext() == "b."


def test_a_sentence_begins_with_a_capital():
    document = new_document("page")

    def problem(number):
        return nodes.reference("", "", nodes.inline("", f"problem {number}"), problem=number)

    document += nodes.paragraph(
        "",
        "",
        problem("1.1"),
        nodes.Text(" and "),
        problem("1.2"),
        nodes.Text(". "),
        problem("1.3"),
        nodes.Text(", e.g. "),
        problem("1.4"),
    )
    document += nodes.bullet_list(
        "",
        nodes.list_item(
            "",
            nodes.paragraph(
                "", "", nodes.strong("", "", problem("1.5")), nodes.Text("; "), problem("1.6")
            ),
        ),
    )
    document += nodes.paragraph("", "", nodes.Text("by "), nodes.emphasis("", "", problem("1.7")))
    BeginWithCapital(document).apply()
    assert [p.astext() for p in document.findall(nodes.paragraph)] == [
        "Problem 1.1 and problem 1.2. Problem 1.3, e.g. problem 1.4",
        "Problem 1.5; problem 1.6",
        "by problem 1.7",
    ]
