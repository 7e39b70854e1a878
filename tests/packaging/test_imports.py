"""Importing the library costs little: SciPy is loaded by the functions that compute with it."""

import ast
import itertools
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
#: What functions may import without a comment, as CONTRIBUTING.md says.
HEAVY = {
    *(
        "scipy",
        "matplotlib",
        "casadi",
        "control",
        "flint",
        "pandas",
        "z3",
        "numpy",
        "sympy",
        "mpmath",
    ),
    *("IPython", "ipykernel", "jupytext", "jupyterlab", "distributed"),
}

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


def unexplained_imports(source):
    """Return the lines of imports in functions that are neither heavy nor explained."""
    lines, found = source.splitlines(), []
    for function in ast.walk(ast.parse(source)):
        if not isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
            continue
        bodies = [getattr(node, "body", []) for node in ast.walk(function)]
        for body in filter(lambda body: isinstance(body, list), bodies):
            for is_import, group in itertools.groupby(
                body, lambda node: isinstance(node, (ast.Import, ast.ImportFrom))
            ):
                if not is_import:
                    continue
                block = list(group)
                names = {
                    (node.module if isinstance(node, ast.ImportFrom) else node.names[0].name)
                    for node in block
                }
                said = lines[block[0].lineno - 2 : block[-1].end_lineno]
                if not any("#" in line for line in said) and not any(
                    name.split(".")[0] in HEAVY for name in names
                ):
                    found.append(block[0].lineno)
    return found


def test_imports_in_functions_are_heavy_or_explained():
    unexplained = {
        str(path.relative_to(ROOT)): lines
        for package in ("trajlib", "workbook")
        for path in (ROOT / package).rglob("*.py")
        if path.name != "cli.py" and (lines := unexplained_imports(path.read_text("utf-8")))
    }
    assert unexplained == {}


@pytest.mark.parametrize(
    ("body", "lines"),
    [
        ("import json", [2]),
        ("import json  # rarely", []),
        ("# rarely\n    import json", []),
        ("import scipy.linalg\n    import json", []),
        ("if f:\n        from os import path", [3]),
    ],
)
def test_an_import_without_a_reason_is_found(body, lines):
    assert unexplained_imports(f"def f():\n    {body}\n") == lines
