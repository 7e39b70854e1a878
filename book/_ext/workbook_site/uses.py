"""Which pages use which public names of the library, and the links of a page to them.

The uses are found in the code cells of the edition that is being built.
"""

import ast
import importlib
import inspect
import json
import re
from functools import cache
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workbook.notebooks import exercises
from workbook.notebooks.dependencies import PACKAGES
from workbook.site import catalogue
from workbook.site.problem_pages import to_label, to_page
from workbook_site.errata import is_cut

CELL = re.compile(r"^(`{3,})\{code-cell\}[^\n]*\n(?P<code>.*?)^\1[ \t]*$", re.M | re.S)
OPTION = re.compile(r"^:[\w-]+:.*$", re.M)
PAGES = "book/library/"
#: Pages of the library about modules of `workbook`; all others are about those of `trajlib`.
OF_WORKBOOK = ("display", "systems")
THEORY = re.compile(r"book/(?:errata/ch\d+|ch\d+/\w+)")


class LibraryUsed(SphinxDirective):
    """Links to the public names of the library that this page uses."""

    def run(self):
        used = [name for name, pages in self.env.workbook_uses.items() if self.env.docname in pages]
        if not used:
            return []
        line = nodes.paragraph("", "Of the library this page uses ", classes=["used-in"])
        for k, (module, name) in enumerate(used):
            line += [nodes.Text(", ")] if k else []
            line += to_label(self.env.docname, label_of(module, name), f"{_short(module)}.{name}")
        return [line]


def used_in(env, module, name):
    """Return the line that links a public name to the pages that use it, in a list, or []."""
    pages = env.workbook_uses.get((module, name))
    if not pages:
        return []
    line = nodes.paragraph("", "Used in ", classes=["used-in"])
    for k, page in enumerate(pages):
        line += [nodes.Text(", ")] if k else []
        line += to_page(env.docname, page, _short_title(page))
    return [line]


def _short(module):
    """Return a module's name without its package; each of these names is one page."""
    return module.split(".", 1)[1]


def module_of(page):
    """Return the module that a page of the library is about."""
    theme = page.removeprefix(PAGES)
    return f"workbook.{theme}" if theme in OF_WORKBOOK else f"trajlib.{theme}"


def label_of(module, name):
    """Return the label of a public name, such as library-stability-shift."""
    return f"library-{_short(module)}-{name}"


@cache
def public_names(module):
    """Return the names in `__all__` of a module, or those it defines without an underscore."""
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


def uses(code):
    """Return the pairs (module, name) of our modules that code uses by its imports.

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


def _code_of(path):
    """Return the code of a page as one text."""
    if path.suffix == ".ipynb":
        return "\n".join(source for _, source in exercises.read(path).code("data", "check"))
    return "\n".join(
        OPTION.sub("", cell["code"]) for cell in CELL.finditer(path.read_text(encoding="utf-8"))
    )


def _find_uses(app, env, added, changed, removed):
    """Find all uses before any page is read; return the library pages whose uses changed."""
    modules = [module_of(page) for page in sorted(env.found_docs) if page.startswith(PAGES)]
    pages = [
        page
        for page in env.found_docs
        if page in catalogue.of(env) or (THEORY.fullmatch(page) and not is_cut(env, page))
    ]
    found = {(module, name): [] for module in modules for name in public_names(module)}
    for page in sorted(pages, key=_order):
        for used in uses(_code_of(Path(env.doc2path(page)))) & found.keys():
            found[used].append(page)
    previous, env.workbook_uses = getattr(env, "workbook_uses", {}), found
    return [
        f"{PAGES}{_short(module)}"
        for module in modules
        if any(found[key] != previous.get(key) for key in found if key[0] == module)
    ]


def _order(page):
    """Order sections of chapters, then problems by number, then errata."""
    return (
        "errata" in page,
        not page.startswith("book/"),
        [int(n) for n in re.findall(r"\d+", page)],
        page,
    )


def _short_title(page):
    numbers = re.findall(r"\d+", page)
    if "errata" in page:
        return f"the errata of chapter {numbers[0]}"
    if page.startswith("book/"):
        return f"chapter {numbers[0]}, {page.rpartition('/')[2].replace('_', ' ')}"
    return f"{numbers[0]}.{int(numbers[1])}"


def _append_uses(app, page, source):
    """Append the directive `library-used` to a page that uses the library."""
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
    app.connect("source-read", _append_uses, priority=600)
    app.add_directive("library-used", LibraryUsed)
