"""Decides, without the check, whether a mutant is right after all: the same answer in another form.

The default compares with the reference answer by value (`sameness`). A check with room for several
answers has an oracle of its own: the oracles of the checks of
`workbook/checks/stability/stationary.py` stand in `stability/stationary.py` here, under the checks'
names in its `ORACLES`. What no oracle proves right, the check has to reject.
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
