"""Reference pages of the library: public names with their docstrings and the pages that use them.

numpydoc reads the sections of a docstring. Their text is plain, as `help` prints it; here formulas
are typeset, and no markup is read into them. What uses a name is found in the code cells of the
edition that is being built.
"""

import ast
import importlib
import inspect
import json
import re
from functools import cache
from html import escape
from pathlib import Path
from textwrap import dedent, fill

from docutils import nodes
from numpydoc.docscrape import NumpyDocString
from sphinx.util.docutils import SphinxDirective

from trajlib.typesetting import typeset
from workbook.notebooks import exercises
from workbook.notebooks.dependencies import PACKAGES
from workbook_site import catalogue
from workbook_site.pages import to_label, to_page

CELL = re.compile(r"^(`{3,})\{code-cell\}[^\n]*\n(?P<code>.*?)^\1[ \t]*$", re.M | re.S)
OPTION = re.compile(r"^:[\w-]+:.*$", re.M)
PAGES = "book/library/"
#: Sections of a docstring in the order in which they are shown: lists of names, and texts.
LISTS = ("Parameters", "Attributes", "Methods", "Returns", "Yields", "Raises")
TEXTS = ("Notes", "Examples")
#: Pages of the library about modules of the workbook; all others are about themes of trajlib.
OF_WORKBOOK = ("display", "systems")
CHAPTER = re.compile(r"book/(?:errata/)?ch(\d+)")


class Library(SphinxDirective):
    """A summary of a module's public names, then a section for each, functions before classes."""

    required_arguments = 1

    def run(self):
        module = importlib.import_module(self.arguments[0])
        self.env.note_dependency(module.__file__)
        names = sorted(
            public_names(module.__name__), key=lambda name: inspect.isclass(getattr(module, name))
        )
        return [
            *described(inspect.getdoc(module)),
            self._summary(module, names),
            *(self._section(module, name) for name in names),
        ]

    def _summary(self, module, names):
        """Return a table with the first sentence about each name, as autosummary has it."""
        rows = []
        for name in names:
            link = to_label(self.env.docname, label_of(module.__name__, name), name)
            summary = " ".join(NumpyDocString(inspect.getdoc(getattr(module, name)))["Summary"])
            cells = (nodes.paragraph("", "", link), nodes.paragraph("", "", *spans(summary)))
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
        section += _code(signature(member, name))
        section += described(inspect.getdoc(member))
        if inspect.isclass(member):
            section += self._methods(member)
        if using := self.env.workbook_uses.get((module.__name__, name)):
            section += self._used_in(using)
        return section

    def _methods(self, kind):
        entries = nodes.definition_list()
        for name, method in vars(kind).items():
            said = inspect.getdoc(method) if not name.startswith("_") else None
            if said and (inspect.isfunction(method) or isinstance(method, property)):
                term = name if isinstance(method, property) else signature(method, name)
                entries += nodes.definition_list_item(
                    "",
                    nodes.term("", "", nodes.literal("", term)),
                    nodes.definition("", *described(said)),
                )
        return [entries] if entries.children else []

    def _used_in(self, using):
        line = nodes.paragraph("", "Used in ", classes=["used-in"])
        for k, page in enumerate(using):
            line += [nodes.Text(", ")] if k else []
            line += to_page(self.env.docname, page, _short_title(page))
        return line


class LibraryUsed(SphinxDirective):
    """What this page uses of the library: the way back from the pages above."""

    def run(self):
        used = [name for name, pages in self.env.workbook_uses.items() if self.env.docname in pages]
        if not used:
            return []
        line = nodes.paragraph("", "Of the library this page uses ", classes=["used-in"])
        for k, (module, name) in enumerate(used):
            line += [nodes.Text(", ")] if k else []
            line += to_label(self.env.docname, label_of(module, name), f"{_short(module)}.{name}")
        return [line]


def _short(module):
    """A module without its package: each of these names is one page."""
    return module.split(".", 1)[1]


def module_of(page):
    theme = page.removeprefix(PAGES)
    return f"workbook.{theme}" if theme in OF_WORKBOOK else f"trajlib.{theme}"


def label_of(module, name):
    return f"library-{_short(module)}-{name}"


@cache
def public_names(module):
    """The names of a module that are for use: those it declares, or those it defines without an
    underscore."""
    loaded = importlib.import_module(module)
    if hasattr(loaded, "__all__"):
        return sorted(loaded.__all__, key=str.casefold)
    return sorted(
        (
            name
            for name, member in vars(loaded).items()
            if not name.startswith("_")
            and (inspect.isfunction(member) or inspect.isclass(member))
            and member.__module__ == module
        ),
        key=str.casefold,
    )


def signature(member, name):
    """How it is called, without the types, which the docstring tells; a long one in several
    lines."""
    try:
        called = inspect.signature(member)
    except ValueError:  # an exception has none of its own
        return name
    plain = [
        p.replace(annotation=p.empty)
        for p in called.parameters.values()
        if p.name != "self" and not p.name.startswith("_")
    ]
    text = f"{name}{called.replace(parameters=plain, return_annotation=called.empty)}"
    return fill(
        text,
        79,
        subsequent_indent=" " * (len(name) + 1),
        break_long_words=False,
        break_on_hyphens=False,
    )


def described(docstring):
    """Return the nodes of a docstring with numpydoc sections."""
    sections = NumpyDocString(docstring)
    found = text_nodes([*sections["Summary"], "", *sections["Extended Summary"]])
    for title in LISTS:
        if sections[title]:
            found += [_heading(title), _fields(sections[title])]
    for title in TEXTS:
        if sections[title]:
            found += [_heading(title), *text_nodes(sections[title])]
    return found


def _heading(title):
    return nodes.paragraph("", title, classes=["docstring-section"])


def _fields(fields):
    """Return the entries of a section such as Parameters as a definition list."""
    entries = nodes.definition_list()
    for field in fields:
        name = [nodes.literal("", field.name)] if field.name else []
        kind = [nodes.Text(" : " if name else ""), *spans(field.type)] if field.type else []
        entries += nodes.definition_list_item(
            "", nodes.term("", "", *name, *kind), nodes.definition("", *text_nodes(field.desc))
        )
    return entries


def text_nodes(lines):
    """Return the nodes of plain text: paragraphs, lists, indented formulas and examples."""
    blocks = [block for block in re.split(r"\n{2,}", "\n".join(lines)) if block.strip()]
    found = []
    for block in blocks:
        lines = block.strip("\n").split("\n")
        if lines[0].startswith(">>>"):
            found.append(_code("\n".join(lines), "pycon"))
        elif all(line.startswith("  ") for line in lines):
            found.append(_code(dedent("\n".join(lines)), "text"))
        else:
            found += _prose(lines)
    return found


def _prose(lines):
    """A paragraph, and the list that it may end with."""
    first = next((k for k, line in enumerate(lines) if line.startswith("- ")), len(lines))
    found = [nodes.paragraph("", "", *spans(" ".join(lines[:first])))] if first else []
    if first < len(lines):
        items = re.split(r"\n- ", "\n" + "\n".join(lines[first:]))[1:]
        texts = [nodes.paragraph("", "", *spans(" ".join(item.split()))) for item in items]
        found.append(nodes.bullet_list("", *(nodes.list_item("", text) for text in texts)))
    return found


def spans(text):
    """Words, with their formulas set, and the `code` between them."""
    parts = re.split(r"`{1,2}([^`]+)`{1,2}", text)
    return [
        nodes.literal("", part) if k % 2 else _words(part) for k, part in enumerate(parts) if part
    ]


def _words(text):
    html = typeset(text)
    return nodes.Text(text) if html == escape(text) else nodes.raw("", html, format="html")


def _code(text, language="python"):
    return nodes.literal_block(text, text, language=language)


def uses(code):
    """(module, name) of what code uses of our modules, where it says so by its imports.

    >>> sorted(uses("from trajlib import structure\\nfrom trajlib.stability import shift\\nstructure.observability(A)"))
    [('trajlib.stability', 'shift'), ('trajlib.structure', 'observability')]
    """
    tree = list(ast.walk(ast.parse(code)))
    modules, found = {}, set()
    for node in tree:
        if isinstance(node, ast.ImportFrom) and _is_ours(node.module or ""):
            for alias in node.names:
                found.add((node.module, alias.name))
                modules[alias.asname or alias.name] = f"{node.module}.{alias.name}"
        elif isinstance(node, ast.Import):
            modules |= {
                alias.asname or alias.name: alias.name
                for alias in node.names
                if _is_ours(alias.name)
            }
    for node in tree:
        if isinstance(node, ast.Attribute) and (module := modules.get(ast.unparse(node.value))):
            found.add((module, node.attr))
    return {(module, name) for module, name in found if "." in module}


def _is_ours(module):
    return module.split(".")[0] in PACKAGES


def _cells(path):
    """The code of a page, as one text."""
    if path.suffix == ".ipynb":
        return "\n".join(source for _, source in exercises.read(path).code("data", "check"))
    return "\n".join(
        OPTION.sub("", cell["code"]) for cell in CELL.finditer(path.read_text(encoding="utf-8"))
    )


def _find_uses(app, env, added, changed, removed):
    """Who uses what, before any page is read; where that changed, the pages on both ends are read
    again."""
    modules = [module_of(page) for page in sorted(env.found_docs) if page.startswith(PAGES)]
    pages = [
        page for page in env.found_docs if CHAPTER.fullmatch(page) or page in catalogue.of(env)
    ]
    found = {(module, name): [] for module in modules for name in public_names(module)}
    for page in sorted(pages, key=_order):
        for used in uses(_cells(Path(env.doc2path(page)))) & found.keys():
            found[used].append(page)
    previous, env.workbook_uses = getattr(env, "workbook_uses", {}), found
    return [
        f"{PAGES}{_short(module)}"
        for module in modules
        if any(found[key] != previous.get(key) for key in found if key[0] == module)
    ]


def _order(page):
    """Chapters, then problems by number, then errata."""
    return (
        "errata" in page,
        not page.startswith("book/"),
        [int(n) for n in re.findall(r"\d+", page)],
    )


def _short_title(page):
    numbers = re.findall(r"\d+", page)
    if "errata" in page:
        return f"the errata of chapter {numbers[0]}"
    return (
        f"chapter {numbers[0]}" if page.startswith("book/") else f"{numbers[0]}.{int(numbers[1])}"
    )


def _end_with_uses(app, page, source):
    """The last line of a page that uses the library."""
    if not any(page in pages for pages in app.env.workbook_uses.values()):
        return
    line = "```{library-used}\n```\n"
    if Path(app.env.doc2path(page)).suffix == ".ipynb":
        notebook = json.loads(source[0])
        notebook["cells"].append(
            {"cell_type": "markdown", "id": "library-used", "metadata": {}, "source": line}
        )
        source[0] = json.dumps(notebook)
    else:
        source[0] = f"{source[0].rstrip()}\n\n{line}"


def setup(app):
    app.connect("env-get-outdated", _find_uses)  # after the catalogue
    # after a problem's page is complete
    app.connect("source-read", _end_with_uses, priority=600)
    app.add_directive("library", Library)
    app.add_directive("library-used", LibraryUsed)
