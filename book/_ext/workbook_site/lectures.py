"""Lectures: `{live}` holds cells that only the notebook before a class has."""

from sphinx.util.docutils import SphinxDirective


class Live(SphinxDirective):
    """Shows nothing on the page: its cells need a kernel."""

    has_content = True

    def run(self):
        return []


def setup(app):
    app.add_directive("live", Live)
