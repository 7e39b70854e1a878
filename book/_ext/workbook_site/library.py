"""The pages of the library: a section for each public name, by autodoc and numpydoc."""

import importlib
import inspect
import re

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workbook.site.problem_pages import to_label
from workbook_site.docstrings import parse, spans
from workbook_site.uses import label_of, public_names, used_in

LETTER = re.compile(r"^( *)([A-Za-z]\.(?: |$))")


class Library(SphinxDirective):
    """Shows a module: its docstring, its functions and classes, and the pages that use them."""

    required_arguments = 1

    def run(self):
        module = importlib.import_module(self.arguments[0])
        self.env.note_dependency(module.__file__)
        names = sorted(
            public_names(module.__name__), key=lambda name: inspect.isclass(getattr(module, name))
        )
        return [
            *self._autodoc("automodule", module.__name__),
            self._summary(module, names),
            *(self._section(module, name) for name in names),
        ]

    def _summary(self, module, names):
        """Return a table with the first sentence about each name."""
        rows = []
        for name in names:
            link = to_label(self.env.docname, label_of(module.__name__, name), name)
            first = inspect.getdoc(getattr(module, name)).partition("\n\n")[0].replace("\n", " ")
            cells = (nodes.paragraph("", "", link), nodes.paragraph("", "", *spans(first)))
            rows.append(nodes.row("", *(nodes.entry("", cell) for cell in cells)))
        columns = [nodes.colspec(colwidth=width) for width in (30, 70)]
        group = nodes.tgroup("", *columns, nodes.tbody("", *rows), cols=2)
        return nodes.table("", group, classes=["library-summary"])

    def _section(self, module, name):
        member = getattr(module, name)
        self.env.note_dependency(inspect.getsourcefile(member))
        label = label_of(module.__name__, name)
        # x' is no quotation
        section = nodes.section("", nodes.title("", name), ids=[label], support_smartquotes=False)
        self.env.get_domain("std").note_hyperlink_target(label, self.env.docname, label, name)
        directive = "autoclass" if inspect.isclass(member) else "autofunction"
        section += self._autodoc(directive, f"{module.__name__}.{name}")
        section += used_in(self.env, module.__name__, name)
        return section

    def _autodoc(self, directive, name):
        options = "   :members:\n   :member-order: bysource\n" if directive == "autoclass" else ""
        return parse(f".. {directive}:: {name}\n{options}", self.state.document)


def _escape_letters(app, what, name, member, options, lines):
    """Escape a letter with a full stop at the beginning of a line: it numbers no list."""
    lines[:] = [LETTER.sub(r"\1\\\2", line) for line in lines]


def _skip_fields(app, what, name, member, skip, options):
    """Skip members without a docstring of their own: the class describes its fields."""
    described = inspect.isfunction(member) or isinstance(member, property)
    return None if described and inspect.getdoc(member) else True


def _hide_private(app, what, name, member, options, arguments, result):
    """Leave out private arguments, which begin with an underscore, and the types."""
    if what not in ("function", "class", "method"):
        return None
    try:
        signature = inspect.signature(member)
    except (ValueError, TypeError):  # an exception has none of its own
        return "", None
    public = [
        parameter.replace(annotation=parameter.empty)
        for parameter in signature.parameters.values()
        if parameter.name != "self" and not parameter.name.startswith("_")
    ]
    return str(signature.replace(parameters=public, return_annotation=signature.empty)), None


def setup(app):
    app.setup_extension("sphinx.ext.autodoc")
    app.setup_extension("numpydoc")
    app.connect("autodoc-process-docstring", _escape_letters, priority=900)  # after numpydoc
    app.connect("autodoc-skip-member", _skip_fields)
    app.connect("autodoc-process-signature", _hide_private, priority=900)
    app.add_directive("library", Library)
