"""Type stubs of the workbook's packages whose names load lazily.

`python -m workbook._stubs` writes an `__init__.pyi` beside each table; a test holds both equal. A check
stands there with its arguments, which its decorators change, and with the first line of its
docstring: an editor completes `checks.` and shows both. All other names are imported.
"""

import importlib
import inspect

from trajlib._lazy import home_of
from trajlib._stubs import WIDTH, imports, lazy_packages, stub_path

#: The packages whose names are checks, but for those of the contract.
OF_CHECKS = ("workbook.checks", "workbook.checks.research")


def stub_text(package):
    """Return the text of a package's stub."""
    head = "# Written by `python -m workbook._stubs`.\n"
    names = sorted(importlib.import_module(package)._lazy_home)
    if package not in OF_CHECKS:
        return head + imports(package, names)
    checks = [name for name in names if ".checks.contract." not in home_of(package, name)]
    others = imports(package, [name for name in names if name not in checks])
    if package == OF_CHECKS[0]:
        others = "from workbook.checks import research as research\n" + others
        others += (
            '\ndef is_of_workbook(name: str) -> bool:\n    """Return whether a name is taken."""\n'
        )
    else:
        others += "from workbook.checks.contract.verdict import Verdict\n"
    return "\n".join(
        [f"{head}from typing import Any\n", others, *(_definition(package, n) for n in checks)]
    )


def _definition(package, name):
    """Return a check with its arguments and the first line of its docstring."""
    check = getattr(importlib.import_module(package), name)
    arguments = [
        f"{argument.name}: Any" + (" = ..." if argument.default is not argument.empty else "")
        for argument in inspect.signature(check).parameters.values()
    ]
    head = f"def {name}({', '.join(arguments)}) -> Verdict:"
    if len(head) > WIDTH:
        lines = "".join(f"    {argument},\n" for argument in arguments)
        head = f"def {name}(\n{lines}) -> Verdict:"
    return f'{head}\n    """{inspect.getdoc(check).splitlines()[0]}"""\n'


if __name__ == "__main__":
    for package in lazy_packages("workbook"):
        stub_path(package).write_text(stub_text(package), encoding="utf-8")
