"""Type stubs of the packages whose names load lazily.

mypy and editors do not run `__getattr__`. The tables in the `__init__.py` files are the source.
`python -m trajlib._stubs` writes an `__init__.pyi` beside each; a test holds both equal.
"""

import importlib
import pkgutil
from pathlib import Path

from trajlib._lazy import home_of

#: A longer import is broken as the formatter breaks it.
WIDTH = 100


def lazy_packages(root="trajlib"):
    """Return the names of all packages of a distribution's package that have a table of lazy names."""
    names = [root] + [
        module.name
        for module in pkgutil.walk_packages(importlib.import_module(root).__path__, f"{root}.")
        if module.ispkg
    ]
    return [name for name in names if hasattr(importlib.import_module(name), "_lazy_home")]


def stub_path(package):
    """Return the path of a package's stub."""
    return Path(importlib.import_module(package).__file__).with_suffix(".pyi")


def stub_text(package):
    """Return the text of a package's stub."""
    text = "# Written by `python -m trajlib._stubs`.\n"
    text += imports(package, importlib.import_module(package)._lazy_home)
    if package == "trajlib":
        text += "\n__version__: str\n"
    return text


def imports(package, names):
    """Return the lines that import lazy names of a package, as the linter sorts them."""
    table = importlib.import_module(package)._lazy_home
    lines = sorted(
        (package if table[name] is None else home_of(package, name), _rank(name), name)
        for name in names
    )
    return "".join(_import_line(module, name) for module, _, name in lines)


def _rank(name):
    """The linter's order within a module: constants, classes, then functions."""
    return 0 if name.isupper() and len(name) > 1 else 1 if name[0].isupper() else 2


def _import_line(module, name):
    line = f"from {module} import {name} as {name}\n"
    if len(line) <= WIDTH:
        return line
    return f"from {module} import (\n    {name} as {name},\n)\n"


if __name__ == "__main__":
    for package in lazy_packages():
        stub_path(package).write_text(stub_text(package), encoding="utf-8")
