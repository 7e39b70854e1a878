"""Remarks on the printed book: marks that a reader may switch on, and folds.

The role {printed}`err-1-margin` is a small mark that leads to an entry of the errata, and
{printed}`added` one that says what the printed book does not have; both are hidden until the switch
of workbook.js is on. The directive {fold} holds what is worth reading, under its title.
"""

from docutils import nodes
from sphinx.util.docutils import SphinxDirective, SphinxRole

from workbook.site.folding import details, summary
from workbook.site.problem_pages import to_label


class PrintedRole(SphinxRole):
    def run(self):
        mark = nodes.inline("", "", classes=["printed"])
        mark += (
            to_label(self.env.docname, self.text, "errata")
            if self.text.startswith("err-")
            else nodes.Text(self.text)
        )
        return [mark], []


class Fold(SphinxDirective):
    """Folds its content under its title."""

    required_arguments = 1
    final_argument_whitespace = True
    has_content = True

    def run(self):
        fold = details("", summary("", self.arguments[0]), classes=["fold"])
        fold += self.parse_content_to_nodes()
        return [fold]


def setup(app):
    app.add_role("printed", PrintedRole())
    app.add_directive("fold", Fold)
