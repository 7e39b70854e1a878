"""Lectures: `{live}` holds what only the notebook before a class has, a cell that asks for a step
or a mistake."""

from sphinx.util.docutils import SphinxDirective


class Live(SphinxDirective):
    """Nothing on the page: it would ask a kernel that is not there."""

    has_content = True

    def run(self):
        return []


def setup(app):
    app.add_directive("live", Live)
