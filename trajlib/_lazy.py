"""Names that are imported when they are first used (PEP 562), so that importing a package costs
nothing."""

import importlib
import sys


def lazy_modules(package, modules):
    """`__getattr__`, `__dir__`, `__all__` of a package whose sub-modules load on first use."""
    return _lazy(package, dict.fromkeys(modules))


def lazy_names(package, exports):
    """The same for names: `exports` maps a module of the package to the names it gives,
    `{"regions": ["shift"]}`."""
    return _lazy(package, {name: module for module, names in exports.items() for name in names})


def home_of(package, name):
    """The module that gives `package.name`, without importing it; None if the package has no such
    lazy name."""
    table = getattr(importlib.import_module(package), "_lazy_home", {})
    if name not in table:
        return None
    return f"{package}.{name}" if table[name] is None else f"{package}.{table[name]}"


def _lazy(package, home):
    sys.modules[package]._lazy_home = home

    def __getattr__(name):
        if name not in home:
            raise AttributeError(
                f"module {package!r} has no attribute {name!r}; it has {', '.join(sorted(home))}"
            )
        if home[name] is None:
            return importlib.import_module(f"{package}.{name}")
        value = getattr(importlib.import_module(f"{package}.{home[name]}"), name)
        # Importing a module of the same name sets the package's attribute to the module: the name
        # asked for wins.
        setattr(sys.modules[package], name, value)
        return value

    return __getattr__, lambda: sorted(home), sorted(home)
