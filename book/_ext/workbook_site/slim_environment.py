"""Less is kept from one build to the next, so that one changed page costs little.

Titles: sphinx-exercise keeps each statement and solution with the whole document around it, but
uses only their kind and title; nothing else is kept here. Outlines: to number figures, tables,
theorems and statements, Sphinx reads every page again from the disk; here an outline of each page
is kept: its sections, its lists of pages, and all numbered nodes.
"""

from docutils import nodes
from sphinx import addnodes
from sphinx.environment.collectors.toctree import TocTreeCollector

#: Sphinx looks for these children of a numbered node: has it a caption, is it a listing?
INSPECTED = (nodes.caption, nodes.title, nodes.literal_block)


def outline(node, is_numbered):
    """Return the parts of a page that Sphinx looks at as it numbers nodes, in their order."""
    parts = [
        part
        for child in node.children
        if isinstance(child, nodes.Element)
        for part in outline(child, is_numbered)
    ]
    if not isinstance(node, (nodes.document, nodes.section, addnodes.toctree)) and not is_numbered(
        node
    ):
        return parts
    kept = nodes.Element() if isinstance(node, nodes.document) else _without_context(node)
    inspected = (
        []
        if isinstance(node, nodes.section)
        else [
            _without_context(child, nodes.Text(child.astext()))
            for child in node.children
            if isinstance(child, INSPECTED)
        ]
    )
    kept += inspected + parts
    return [kept]


def _without_context(node, *content):
    """Return a copy of a node that has its attributes and this content alone."""
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


def _assign_numbers(self, env, assign=TocTreeCollector.assign_figure_numbers):
    read, kept = env.get_doctree, getattr(env, "workbook_outlines", {})
    env.get_doctree = lambda page: kept[page] if page in kept else read(page)
    try:
        return assign(self, env)
    finally:
        del env.get_doctree  # so that the method is found again


def _keep_titles(app, env):
    for entry in getattr(env, "sphinx_exercise_registry", {}).values():
        title = entry["node"].children[0]
        entry["node"] = _without_context(entry["node"], title.deepcopy())
        for node in entry["node"].findall():
            node.document = None


def setup(app):
    TocTreeCollector.assign_figure_numbers = _assign_numbers
    app.connect("doctree-read", _keep_outline, priority=950)  # after all labels are given
    app.connect("env-purge-doc", _forget_outline)
    app.connect("env-updated", _keep_titles)
