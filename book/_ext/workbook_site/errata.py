"""Errata of problems in the student edition: their places alone.

What is wrong with a printed problem, and why, often is its solution. The student edition has each
statement as corrected; the reasons stay in the edition with solutions. The sections stay, since
statements and theory refer to them.
"""

import re

from docutils import nodes
from sphinx.transforms import SphinxTransform

from workbook.site import catalogue

PAGE = re.compile(r"book/errata/ch\d+")
CORRECTED = "This edition has the statement as corrected."


def is_cut(env, page):
    """Return whether a page has errata of which this edition leaves out some."""
    return bool(PAGE.fullmatch(page)) and not any(
        problem.solved for problem in catalogue.of(env).values()
    )


class ErrataOfProblems(SphinxTransform):
    """Cuts the entries on problems to the place that is meant."""

    default_priority = 700  # after sections have their labels, before Sphinx notes their titles

    def apply(self, **kwargs):
        if not is_cut(self.env, self.env.docname):
            return
        for section in self.document.findall(nodes.section):
            place = section[0].astext().partition(",")[0]
            if re.match(r"Problems? \d", place):
                section.children = []
                section += [nodes.title("", place), nodes.paragraph("", CORRECTED)]


def setup(app):
    app.add_transform(ErrataOfProblems)
