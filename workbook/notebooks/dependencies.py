"""Static import closure of a notebook: which modules of trajlib and of workbook it uses.

A stored result or output is stale when one of these modules changes, and only then.
"""

import ast
import hashlib
import re
from functools import cache
from importlib.util import resolve_name
from pathlib import Path

from trajlib._lazy import home_of

#: The packages whose modules count, and the folder in which both lie.
OURS = ("trajlib", "workbook")
HOME = Path(__file__).resolve().parents[2]


def module_closure(source):
    """Our modules that code loads, directly or through each other, with the SHA-256 of their text.

    Found by reading imports, without running anything; packages whose names load lazily count by
    the names used.

    >>> closure = module_closure("from workbook import checks; checks.stability_region")
    >>> "workbook.checks.stability.regions" in closure, "workbook.checks.stability.cycles" in closure
    (True, False)
    """
    closure, waiting = {}, sorted(_loaded(source))
    while waiting:
        module = waiting.pop()
        if module not in closure:
            path = path_of(module)
            closure[module] = hashlib.sha256(path.read_bytes()).hexdigest()
            waiting += sorted(_loaded_by(module, path))
    return dict(sorted(closure.items()))


def _loaded(source, package=None):
    """Our modules that code names in its imports, or by attributes of what it imports.

    `package` is the package that relative imports start from, for the source of a module.
    """
    packages, found = {}, set()
    for node in _imports(ast.parse(source) if package is None else _quick(source)):
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
                    if path_of(module):
                        packages[alias.asname or alias.name] = module
                    else:
                        found.add(_home(start, alias.name) or start)
    for module in packages.values():
        # A package itself says nothing of what a notebook computes, but what it imports at once
        # may.
        found |= (
            _loaded_by(module, path_of(module)) - {"trajlib._lazy"}
            if _is_package(module)
            else {module}
        )
    for node in ast.walk(ast.parse(source)) if any(map(_is_package, packages.values())) else ():
        if isinstance(node, ast.Attribute) and (package := _package(node.value, packages)):
            home = _home(package, node.attr)
            if home is not None and not _is_package(home):
                found.add(home)
    return found


def _package(node, packages):
    """Return our package that a name or a dotted name stands for, None if it stands for none."""
    name = _dotted(node)
    if name in packages:
        return packages[name]
    if not isinstance(node, ast.Attribute) or not (above := _package(node.value, packages)):
        return None
    within = f"{above}.{node.attr}"
    return within if path_of(within) and _is_package(within) else None


def _imports(tree):
    """Only statements are looked at, which saves most of the time of `ast.walk`."""
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            yield node
        for field in ("body", "orelse", "handlers", "finalbody", "cases"):
            waiting += getattr(node, field, ())


#: An import on lines of its own, as all of ours are, to the end of its line or of its brackets.
_IMPORT = re.compile(
    r"^[ \t]*((?:from[ \t]+[\w.]+[ \t]+)?import[ \t]+(?:\([^)]*\)|[^\n]*))", re.MULTILINE
)


def _quick(source):
    """The tree of a module's imports, or of all of it where a line of prose looks like one. This is
    done for every module under a notebook, and takes a tenth of what whole modules do."""
    try:
        return ast.parse("\n".join(_IMPORT.findall(source)))
    except SyntaxError:
        return ast.parse(source)


def _dotted(node):
    """The text of names with dots, None for anything else."""
    if isinstance(node, ast.Attribute):
        before = _dotted(node.value)
        return before and f"{before}.{node.attr}"
    return node.id if isinstance(node, ast.Name) else None


@cache
def _loaded_by(module, path):
    package = module if _is_package(module) else module.rpartition(".")[0]
    return frozenset(_loaded(path.read_text(encoding="utf-8"), package))


def _is_ours(name):
    return name.split(".")[0] in OURS


def _home(module, name):
    return home_of(module, name) if _is_package(module) else None


def _is_package(module):
    return path_of(module).name == "__init__.py"


@cache
def path_of(name):
    """The file of a module of ours, None if the name is of something else; by its place, since
    `find_spec` imports what is above."""
    if not _is_ours(name):
        return None
    place = HOME.joinpath(*name.split("."))
    return next(
        (file for file in (place / "__init__.py", place.with_suffix(".py")) if file.is_file()), None
    )
