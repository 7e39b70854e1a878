"""Oracles: decide, without the check, whether a mutant is the right answer in another form.

The default compares with the reference answer by value (`sameness`). A check that accepts several
answers has an oracle of its own: the oracles of `workbook/checks/stability/equilibria.py`
are in `stability/equilibria.py` here, by the names of the checks in `ORACLES`. A check has
to reject what no oracle proves right.
"""

import importlib
import pkgutil

from oracles.sameness import same_value

MODULES = [
    importlib.import_module(module.name) for module in pkgutil.walk_packages(__path__, "oracles.")
]
ORACLES = {
    check: oracle for module in MODULES for check, oracle in getattr(module, "ORACLES", {}).items()
}


def is_right(mutant, reference, check, arguments, options, kind):
    """True if the mutant is proved right."""
    oracle = ORACLES.get(check)
    return (
        oracle(mutant, reference, *arguments, **options)
        if oracle
        else same_value(mutant, reference, kind)
    )
