"""What is kept from one build to the next, so that a changed page is not paid for by all others.

Titles: sphinx-exercise keeps its statements and solutions with the whole page that each stands in,
and asks of them only their kind and their title. So no more is kept. Outlines: Sphinx counts
figures, tables, theorems and statements through all pages, and for that reads every page anew from
the disk. What it looks at is kept of each page: its sections, its lists of pages, and what has a
number.
"""

from docutils import nodes
from sphinx import addnodes
from sphinx.environment.collectors.toctree import TocTreeCollector

#: Of what is counted, Sphinx asks whether it has a caption, and whether it is a listing.
ASKED = (nodes.caption, nodes.title, nodes.literal_block)


def outline(node, is_counted):
    """The parts of a page that Sphinx looks at as it counts, in their order; what stands around
    them falls away."""
    parts = [
        part
        for child in node.children
        if isinstance(child, nodes.Element)
        for part in outline(child, is_counted)
    ]
    if not isinstance(node, (nodes.document, nodes.section, addnodes.toctree)) and not is_counted(
        node
    ):
        return parts
    kept = nodes.Element() if isinstance(node, nodes.document) else _alone(node)
    asked = (
        []
        if isinstance(node, nodes.section)
        else [
            _alone(child, nodes.Text(child.astext()))
            for child in node.children
            if isinstance(child, ASKED)
        ]
    )
    kept += asked + parts
    return [kept]


def _alone(node, *content):
    """A copy that holds nothing but its attributes, and this content."""
    copy = node.copy()
    copy.document, copy.rawsource = None, ""
    copy += content
    return copy


def _keep_outline(app, document):
    env = app.env
    env.workbook_outlines = getattr(env, "workbook_outlines", {})
    (env.workbook_outlines[env.docname],) = outline(
        document,
        lambda node: any(domain.get_enumerable_node_type(node) for domain in env.domains.values()),
    )


def _forget_outline(app, env, page):
    getattr(env, "workbook_outlines", {}).pop(page, None)


def _count(self, env, assign=TocTreeCollector.assign_figure_numbers):
    read, kept = env.get_doctree, getattr(env, "workbook_outlines", {})
    env.get_doctree = lambda page: kept[page] if page in kept else read(page)
    try:
        return assign(self, env)
    finally:
        del env.get_doctree  # the method is seen again


def _keep_titles(app, env):
    for entry in getattr(env, "sphinx_exercise_registry", {}).values():
        title = entry["node"].children[0]
        entry["node"] = _alone(entry["node"], title.deepcopy())
        for node in entry["node"].findall():
            node.document = None


def setup(app):
    TocTreeCollector.assign_figure_numbers = _count
    app.connect("doctree-read", _keep_outline, priority=950)  # after all that gives labels
    app.connect("env-purge-doc", _forget_outline)
    app.connect("env-updated", _keep_titles)
