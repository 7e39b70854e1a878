"""All rows, by the problem that they are about."""

import pkgutil
from importlib import import_module

import adversarial

#: Of every chapter's module.
ROWS = [
    row
    for module in pkgutil.iter_modules(adversarial.__path__)
    if module.name.startswith("ch")
    for row in import_module(f"adversarial.{module.name}").ROWS
]


def rows_of(problem):
    return [row for row in ROWS if row.problem == problem]
