"""Static import closure of a notebook: the modules of trajlib and workbook that it uses.

A stored result or output is stale if and only if one of these modules has changed.
"""

import ast
import hashlib
import re
from functools import cache
from importlib.util import resolve_name
from pathlib import Path

from trajlib._lazy import home_of

#: Our packages, and the folder that holds them.
PACKAGES = ("trajlib", "workbook")
ROOT = Path(__file__).resolve().parents[2]
#: A module that calls a hook depends on what the package above has put into it.
HOOKS = "workbook.hooks"


def module_closure(source):
    """Return our modules that code loads, directly or not, with the hashes of their texts.

    Imports are read from the syntax trees; nothing is run. Of packages with lazy names only the
    modules of the names used are included.

    Parameters
    ----------
    source : str
        The code.

    Returns
    -------
    dict of str
        SHA-256 of the text of each module, by the module's name.

    Examples
    --------
    >>> closure = module_closure("from workbook import checks; checks.stability_region")
    >>> "workbook.checks.stability.regions" in closure, "workbook.checks.stability.cycles" in closure
    (True, False)
    """
    closure, queue = {}, sorted(_loaded(source))
    while queue:
        module = queue.pop()
        if module not in closure:
            path = module_path(module)
            closure[module] = hashlib.sha256(path.read_bytes()).hexdigest()
            queue += sorted(_loaded_by(module, path))
    return dict(sorted(closure.items()))


def _loaded(source, package=None):
    """Return our modules that code imports, or uses by attributes of imported packages.

    `package` is the package of the module with this source, for its relative imports.
    """
    packages, modules = {}, set()
    for node in _imports(ast.parse(source) if package is None else _parse_imports(source)):
        if isinstance(node, ast.Import):
            for alias in node.names:
                if _is_ours(alias.name):
                    packages[alias.asname or alias.name] = alias.name
        elif isinstance(node, ast.ImportFrom):
            start = (
                resolve_name("." * node.level + (node.module or ""), package)
                if node.level
                else node.module
            )
            if _is_ours(start):
                for alias in node.names:
                    module = f"{start}.{alias.name}"
                    if module_path(module):
                        packages[alias.asname or alias.name] = module
                    else:
                        modules.add(_home(start, alias.name) or start)
    for module in packages.values():
        # of a package, the modules that it imports at once
        modules |= (
            _loaded_by(module, module_path(module)) - {"trajlib._lazy"}
            if _is_package(module)
            else {module}
        )
    for node in ast.walk(ast.parse(source)) if any(map(_is_package, packages.values())) else ():
        if isinstance(node, ast.Attribute) and (package := _package(node.value, packages)):
            home = _home(package, node.attr)
            if home is not None and not _is_package(home):
                modules.add(home)
    return modules


def _package(node, packages):
    """Return our package that a name or a dotted name stands for, None if it stands for none."""
    name = _dotted(node)
    if name in packages:
        return packages[name]
    if not isinstance(node, ast.Attribute) or not (parent := _package(node.value, packages)):
        return None
    within = f"{parent}.{node.attr}"
    return within if module_path(within) and _is_package(within) else None


def _imports(tree):
    """Yield the import statements of a tree; expressions are skipped to save time."""
    queue = [tree]
    while queue:
        node = queue.pop()
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            yield node
        for field in ("body", "orelse", "handlers", "finalbody", "cases"):
            queue += getattr(node, field, ())


#: An import statement on lines of its own, to the end of its line or of its brackets.
_IMPORT = re.compile(
    r"^[ \t]*((?:from[ \t]+[\w.]+[ \t]+)?import[ \t]+(?:\([^)]*\)|[^\n]*))", re.MULTILINE
)


def _parse_imports(source):
    """Parse the import statements of a module, or all of it where prose looks like one.

    This takes a tenth of the time of parsing whole modules.
    """
    try:
        return ast.parse("\n".join(_IMPORT.findall(source)))
    except SyntaxError:
        return ast.parse(source)


def _dotted(node):
    """Return the text of a dotted name, None for another node."""
    if isinstance(node, ast.Attribute):
        owner = _dotted(node.value)
        return owner and f"{owner}.{node.attr}"
    return node.id if isinstance(node, ast.Name) else None


@cache
def _loaded_by(module, path):
    package = module if _is_package(module) else module.rpartition(".")[0]
    if module == HOOKS:
        path = module_path(package)
    return frozenset(_loaded(path.read_text(encoding="utf-8"), package))


def _is_ours(name):
    return name.split(".")[0] in PACKAGES


def _home(module, name):
    return home_of(module, name) if _is_package(module) else None


def _is_package(module):
    return module_path(module).name == "__init__.py"


@cache
def module_path(name):
    """Return the file of one of our modules, None for another name.

    It is found by its path, since `find_spec` imports the packages above a module.
    """
    if not _is_ours(name):
        return None
    base = ROOT.joinpath(*name.split("."))
    return next(
        (file for file in (base / "__init__.py", base.with_suffix(".py")) if file.is_file()), None
    )
