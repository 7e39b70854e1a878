"""Importing the library costs little: SciPy is loaded by the functions that compute with it."""

import subprocess
import sys

EVERYTHING = """
import importlib, pkgutil, sys
import trajlib, workbook
names = [module.name for package in (trajlib, workbook)
         for module in pkgutil.walk_packages(package.__path__, package.__name__ + ".")
         if not module.name.startswith("workbook.grading")]
for name in names:
    importlib.import_module(name)
print(len(names), *(name for name in sys.modules if name.split(".")[0] == "scipy"))
"""


def test_no_module_loads_scipy():
    shown = subprocess.run(
        [sys.executable, "-c", EVERYTHING], capture_output=True, text=True, check=True, timeout=120
    )
    count, *loaded = shown.stdout.split()
    assert int(count) > 100 and loaded == []
