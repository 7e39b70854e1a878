"""Lazy loading (PEP 562): modules and names of a package load on first use.

The tables are the only source; `python -m trajlib._stubs` writes the type stubs from them.
"""

import importlib
import sys
from collections.abc import Iterable, Mapping
from types import ModuleType


def lazy_modules(package: str, modules: Iterable[str]) -> tuple:
    """Return `__getattr__`, `__dir__`, `__all__` of a package whose sub-modules load lazily."""
    return _lazy(package, dict.fromkeys(modules))


def lazy_names(package: str, exports: Mapping[str, list[str]]) -> tuple:
    """Return `__getattr__`, `__dir__`, `__all__` of a package whose names load lazily.

    `exports` maps a module of the package to the names it gives, `{"regions": ["shift"]}`; a module
    outside the package stands with its full name.
    """
    return _lazy(package, {name: module for module, names in exports.items() for name in names})


def home_of(package: str, name: str) -> str | None:
    """Return the module that gives `package.name`, without importing it; None if it is not lazy."""
    table = getattr(importlib.import_module(package), "_lazy_home", {})
    if name not in table:
        return None
    return _full_name(package, name if table[name] is None else table[name])


def _full_name(package: str, module: str) -> str:
    """Return the full name of a module of a package, or of one that has it already."""
    return module if module.startswith(f"{package.split('.')[0]}.") else f"{package}.{module}"


def _lazy(package: str, home: Mapping[str, str | None]) -> tuple:
    sys.modules[package]._lazy_home = home  # type: ignore[attr-defined]

    def __getattr__(name):
        if name not in home:
            raise AttributeError(
                f"module {package!r} has no attribute {name!r}; it has {', '.join(sorted(home))}"
            )
        if home[name] is None:
            return importlib.import_module(f"{package}.{name}")
        value = getattr(importlib.import_module(_full_name(package, home[name])), name)
        setattr(sys.modules[package], name, value)
        return value

    # Pages of reference list functions and classes; constants are not among them.
    public = [name for name in sorted(home) if not name.isupper()]
    return __getattr__, lambda: sorted(home), public


class _OnFirstUse(ModuleType):
    """Stands for a module, which is imported when one of its names is first used."""

    def __getattr__(self, name):
        if name.startswith("__"):  # the import system and inspection ask for these
            raise AttributeError(name)
        value = getattr(importlib.import_module(self.__name__), name)
        setattr(self, name, value)
        return value

    @property
    def __dict__(self):  # sympy.lambdify takes the functions from here
        return vars(importlib.import_module(self.__name__))


#: CasADi, which takes long to load and which pages of the site do not have. Modules take it from here:
#: importing them does not need it.
casadi = _OnFirstUse("casadi")
